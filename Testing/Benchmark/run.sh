#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [SURFACE...]: build in Release and measure every stage that has a target, on real models
# that Debian packages and on the surfaces given. Prints seconds for people and, for machines, one
# line `ratio NAME VALUE at most|at least LIMIT` per target. Builds in build-benchmark/.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
build=$root/build-benchmark

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
  -DINSIDEOUT_CORE_ONLY=ON >"$build.log" 2>&1 && cmake --build "$build" --target BenchmarkResolve \
  >>"$build.log" 2>&1 || { cat "$build.log"; exit 1; }
mv "$build.log" "$build/build.log"

surfaces=$build/surfaces
mkdir -p "$surfaces"
"$here/unpack-surfaces.sh" "$surfaces" man.off propellerTip.obj motorBike.obj

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

program=$build/Testing/Benchmark/BenchmarkResolve
set -- "$@" "$surfaces"/*
"$program" "$@"
for surface; do
  "$program" --memory "$surface"
done
