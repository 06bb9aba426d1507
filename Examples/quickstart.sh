#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# From a fresh clone on Debian 12 to tetrahedra: install the packages, build in build/, and mesh a
# broken surface. Examples/quickstart.sh [SURFACE] takes .ply, .obj, .off, .stl or .vtp; without one,
# a head with holes and self-intersections from the package libcgal-demo.
set -eu
case ${1:-} in
  '' | /*) surface=${1:-} ;;
  *) surface=$(pwd)/$1 ;;
esac
cd "$(dirname "$0")/.."

Testing/install-packages.sh
echo "Building (a few minutes) ..."
mkdir -p build
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DPython3_EXECUTABLE=/usr/bin/python3 \
  >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
cmake --build build >build/build.log 2>&1 || { cat build/build.log; exit 1; }
. build/env.sh

mkdir -p build/quickstart
if [ -z "$surface" ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C build/quickstart --strip-components=2 \
    data/meshes/mannequin-devil.off
  surface=build/quickstart/mannequin-devil.off
fi
cd build/quickstart
case $surface in
  build/quickstart/*) surface=${surface#build/quickstart/} ;;
esac
python3 -m insideout "$surface" solid.vtu --hull hull.vtu --boundary boundary.vtp \
  --outliers outliers.vtp --report report.json --plot picture.png
cat <<EOF

Written to build/quickstart: solid.vtu, hull.vtu, boundary.vtp, outliers.vtp, report.json, picture.png
In this shell, after

  . build/env.sh

these work: insideout mesh SURFACE OUTPUT.vtu; from insideout import tetrahedralize; and
paraview, pvpython and pvbatch find the plugin InsideOut.
EOF
