#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Install what is needed, build with warnings as errors, and run every test. About 15 minutes on two
# cores. Builds in build-test/.
set -eu
cd "$(dirname "$0")/.."

Testing/install-packages.sh
cmake -S . -B build-test -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  -DINSIDEOUT_WARNINGS_AS_ERRORS=ON -DPython3_EXECUTABLE=/usr/bin/python3 >build-test.log 2>&1 ||
  { cat build-test.log; exit 1; }
mv build-test.log build-test/configure.log
cmake --build build-test
exec ctest --test-dir build-test --output-on-failure
