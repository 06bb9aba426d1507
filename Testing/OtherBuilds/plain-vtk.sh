#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# plain-vtk.sh FOLDER CORE TESTS: build the module against Debian's VTK 9.1, without ParaView, and run the tests
# whose names fit a regular expression. Debian's packages of both cannot be installed side by side: VTK's
# are unpacked below the folder, whence they work. CORE is the algorithms' library of another build.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
core=$2
tests=$3

prefix=$folder/vtk/usr
libraries=$prefix/lib/$(gcc -print-multiarch)
if [ ! -e "$folder/vtk/complete" ]; then
  rm -rf "$folder/vtk"
  packages=$("$source/Testing/OtherBuilds/download-vtk.sh")
  for package in "$packages"/*.deb; do
    dpkg -x "$package" "$folder/vtk"
  done
  touch "$folder/vtk/complete"
fi

# Packages keep no paths to libraries of their own.
export LD_LIBRARY_PATH="$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export TBB_ROOT="$prefix"
cmake -S "$source" -B "$folder/build" -G Ninja -DINSIDEOUT_USE_PARAVIEW=OFF -DBUILD_TESTING=ON \
  -DINSIDEOUT_CORE_LIBRARY="$core" -DVTK_DIR="$libraries/cmake/vtk-9.1" -DCMAKE_BUILD_TYPE=None \
  -DINSIDEOUT_WARNINGS_AS_ERRORS=ON -DPython3_EXECUTABLE=/usr/bin/python3 >"$folder/configure.log" 2>&1 ||
  { cat "$folder/configure.log"; exit 1; }
cmake --build "$folder/build" --target InsideOutFilterTests InsideOutPythonFiles InsideOutFaults InsideOutReference insideout-tetgen
exec ctest --test-dir "$folder/build" --output-on-failure --no-tests=error --parallel "$(nproc)" --tests-regex "$tests"
