#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [--all | --long]: install packages, build in build-test/ with warnings as errors, and run the tests. 25 minutes
# on two cores; 45 with --all, which adds sanitizers, another compiler, another VTK and the wheel; hours with
# --long (README.md beside this file).
set -eu
cd "$(dirname "$0")/.."
# The limit, in seconds, is for tests that hang: on a busy machine others take minutes.
case "${1-}" in
  '') packages=--tests all=OFF long=OFF limit=2400 ;;
  --all) packages=--all all=ON long=OFF limit=2400 ;;
  --long) packages=--all all=ON long=ON limit=14400 ;;
  *)
    echo "usage: Testing/run.sh [--all | --long]" >&2
    exit 2
    ;;
esac

Testing/install-packages.sh $packages
cmake -S . -B build-test -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  -DINSIDEOUT_WARNINGS_AS_ERRORS=ON -DINSIDEOUT_ALL_TESTS=$all -DINSIDEOUT_LONG_TESTS=$long \
  -DPython3_EXECUTABLE=/usr/bin/python3 >build-test.log 2>&1 ||
  { cat build-test.log; exit 1; }
mv build-test.log build-test/configure.log
cmake --build build-test
exec ctest --test-dir build-test --output-on-failure --parallel "$(nproc)" --timeout $limit
