#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [--long]: install what is needed, build with warnings as errors, and run the tests. Builds in
# build-test/. About half an hour on two cores. With --long it takes hours (README.md beside this file).
set -eu
cd "$(dirname "$0")/.."
case "${1-}" in
  '') long=OFF ;;
  --long) long=ON ;;
  *)
    echo "usage: Testing/run.sh [--long]" >&2
    exit 2
    ;;
esac

Testing/install-packages.sh
cmake -S . -B build-test -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  -DINSIDEOUT_WARNINGS_AS_ERRORS=ON -DINSIDEOUT_LONG_TESTS=$long \
  -DPython3_EXECUTABLE=/usr/bin/python3 >build-test.log 2>&1 ||
  { cat build-test.log; exit 1; }
mv build-test.log build-test/configure.log
cmake --build build-test
# The limit is for what hangs: a build of the other compilers takes some minutes, all else less.
limit=2400
[ $long = OFF ] || limit=14400
exec ctest --test-dir build-test --output-on-failure --parallel "$(nproc)" --timeout $limit
