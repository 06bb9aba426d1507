#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [SURFACE...]: build in Release and measure every stage that has a target, on real models
# that Debian packages and on the surfaces given. Prints seconds for people and, for machines, one
# line `ratio NAME VALUE at most|at least LIMIT` per target. Builds in build-benchmark/, and draws
# the thesis's figures 8.10 and 8.11 in build-benchmark/figures. The reference for winding numbers
# needs libembree-dev, drawing python3-matplotlib; the references for tetrahedra, in
# build-benchmark/quality.csv, need tetgen, gmsh, python3-netgen and python3-meshio; the solvers that
# judge them calculix-ccx, python3-gmsh and python3-scipy. The targets are entered in targets.csv.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if [ "${1-}" != --lines ]; then
  "$0" --lines "$@" | /usr/bin/python3 "$here/write-targets.py"
  exit
fi
shift
root=$here/../..
build=$root/build-benchmark

programs="BenchmarkResolve BenchmarkConstrainedDelaunay BenchmarkDelaunayLimit BenchmarkWhole BenchmarkGraphCut BenchmarkBusy BenchmarkDistance BenchmarkPlanar BenchmarkBoolean"
if [ -r /usr/include/embree3/rtcore.h ]; then
  programs="$programs BenchmarkWindingNumber"
else
  echo "missing: libembree-dev; winding numbers are not measured"
fi
# shellcheck disable=SC2086 # a list of words
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  -DINSIDEOUT_CORE_ONLY=ON >"$build.log" 2>&1 && cmake --build "$build" --target $programs \
  >>"$build.log" 2>&1 || { cat "$build.log"; exit 1; }
mv "$build.log" "$build/build.log"

surfaces=$build/surfaces
open_surfaces=$build/open-surfaces
figures=$build/figures
mkdir -p "$surfaces" "$open_surfaces" "$figures/surfaces"
"$here/unpack-surfaces.sh" "$surfaces" man.off propellerTip.obj motorBike.obj
"$here/unpack-surfaces.sh" "$open_surfaces" mannequin-devil.off pig.stl elephant-with-holes.off
"$here/unpack-surfaces.sh" "$figures/surfaces" dino.off armadillo.off bear.off blobby.off bones.off \
  bull.off camel.off cow.off diplodocus.off dragknob.off elephant.off elephant-with-holes.off elk.off \
  fandisk.off femur.off hand.off head.off homer.off knot.off man.off mannequin-devil.off pig.off

given=
for surface; do
  stem=$(basename "$surface")
  given="$given ${stem%.*}"
  [ -r "$surface" ] || echo "missing: $surface"
done
for name in Beast AlienSpaceObject; do
  case "$given " in
    *" $name "*) ;;
    *) echo "missing: $name, to be given as an argument; its targets are not measured" ;;
  esac
done

bin=$build/Testing/Benchmark
if [ -x "$bin/BenchmarkWindingNumber" ]; then
  "$bin/BenchmarkWindingNumber" --soups
  "$bin/BenchmarkWindingNumber" --open "$@" "$surfaces"/* "$open_surfaces"/*
  "$bin/BenchmarkWindingNumber" "$@" "$surfaces"/man.off "$open_surfaces"/*
  "$bin/BenchmarkWindingNumber" --figures "$figures" "$figures/surfaces"/*
  /usr/bin/python3 "$here/plot-figures.py" "$figures" || echo "missing: python3-matplotlib; nothing is drawn"
fi

# Running again after a change is the filters' own: they need VTK, and a build of their own.
filters=$build/filters
if cmake -S "$root" -B "$filters" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DPython3_EXECUTABLE=/usr/bin/python3 >"$build/filters.log" 2>&1 &&
  cmake --build "$filters" >>"$build/filters.log" 2>&1; then
  # VTK's stencils, which ParaView does not have, are measured by Debian's VTK.
  vtk=$build/vtk-9.1
  [ -d "$vtk" ] || (mkdir -p "$vtk/packages" && cd "$vtk/packages" && apt-get download libvtk9.1 python3-vtk9 >/dev/null &&
    for package in *.deb; do dpkg -x "$package" "$vtk"; done) || echo "missing: libvtk9.1; voxels are not measured"
  (. "$filters/env.sh" && /usr/bin/python3 "$here/measure-rerun.py" "$@" &&
    /usr/bin/python3 "$here/measure-voxels.py" "$vtk" "$@" "$open_surfaces"/* &&
    /usr/bin/python3 "$here/measure-total.py" "$bin/BenchmarkConstrainedDelaunay" "$@" &&
    /usr/bin/python3 "$here/measure-ranks.py" &&
    /usr/bin/python3 "$here/measure-fit.py" "$figures/surfaces"/* &&
    /usr/bin/python3 "$here/measure-layers.py" "$figures/surfaces"/* &&
    /usr/bin/python3 "$here/measure-quality.py" --table "$build/quality.csv" "$@")
else
  echo "missing: the filters cannot be built ($build/filters.log); rerun is not measured"
fi

for surface in "$@" "$surfaces/man.off" "$figures/surfaces/camel.off"; do
  "$bin/BenchmarkConstrainedDelaunay" "$surface"
  "$bin/BenchmarkConstrainedDelaunay" --memory "$surface"
done
"$bin/BenchmarkConstrainedDelaunay" --growth
"$bin/BenchmarkDelaunayLimit" "$@" "$surfaces"/* "$open_surfaces"/* "$figures/surfaces"/*
for surface; do
  case $surface in
    */Beast.*|Beast.*) "$bin/BenchmarkWhole" "$surface" ;;
  esac
done
"$bin/BenchmarkPlanar"
"$bin/BenchmarkBoolean"
"$bin/BenchmarkBusy" "$figures/surfaces/pig.off"
"$bin/BenchmarkDistance" "$@" "$surfaces"/*
"$bin/BenchmarkGraphCut" "$@" "$surfaces"/* "$open_surfaces"/*
set -- "$@" "$surfaces"/*
"$bin/BenchmarkResolve" "$@"
for surface; do
  "$bin/BenchmarkResolve" --memory "$surface"
done
echo "All is measured."
