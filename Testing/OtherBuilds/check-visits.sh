#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check-visits.sh FOLDER: after the tests of a build with --coverage, whether they have run something of
# every source file of the algorithms.
set -eu
objects=$(cd "$1" && pwd)/Filters/Core/CMakeFiles/InsideOutCore.dir
cd "$(dirname "$0")/../../Filters/Core"
failed=0
for source in *.cxx */*.cxx; do
  gcov --no-output --object-file "$objects/$source.gcda" "$source" 2>/dev/null |
    grep -A1 "/Core/$source'" | grep 'Lines executed' | grep -qv 'executed:0.00%' || {
    echo "no test under sanitizers runs Filters/Core/$source"
    failed=1
  }
done
exit $failed
