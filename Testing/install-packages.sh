#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# install-packages.sh [--tests | --all]: install the Debian 12 packages that building and the quick start need;
# with --tests also those of Testing/run.sh, with --all those of Testing/run.sh --all. Root or sudo.
set -eu
case "${1-}" in
  '' | --tests | --all) ;;
  *)
    echo "usage: Testing/install-packages.sh [--tests | --all]" >&2
    exit 2
    ;;
esac

as_root=
[ "$(id -u)" = 0 ] || as_root=sudo

# The project itself, and Filters/CMake/package-deb.sh (dpkg-dev, file).
packages="g++ cmake ninja-build paraview paraview-dev python3-paraview python3-dev python3-numpy
  libcgal-dev libeigen3-dev libtet1.5-dev libmaxflow-dev zlib1g-dev dpkg-dev file"

# What find_package(ParaView) asks for beyond what paraview-dev brings.
packages="$packages qtbase5-dev libqt5svg5-dev qttools5-dev libqt5opengl5-dev libqt5x11extras5-dev
  libqt5xmlpatterns5-dev qtxmlpatterns5-dev-tools libutfcpp-dev libprotobuf-dev protobuf-compiler
  libhdf5-mpi-dev mpi-default-dev libxml2-dev libexpat1-dev liblz4-dev liblzma-dev libjsoncpp-dev
  libfreetype-dev libjpeg-dev libpng-dev libtiff-dev libdouble-conversion-dev libglew-dev libgl-dev
  libx11-dev libxcursor-dev libxt-dev libtheora-dev libogg-dev libnetcdf-dev libproj-dev libcgns-dev
  libpugixml-dev libxcb1-dev libgdal-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev
  libgl2ps-dev"

# The quick start: a broken head, and a display to draw pictures on.
packages="$packages libcgal-demo xvfb xauth"

# Tests: further meshes, clicks and screenshots, style and types, readers of solvers' files, what examples calculate with.
[ -z "${1-}" ] || packages="$packages libgtest-dev openfoam-examples libxtst6 imagemagick clang-format mypy
  python3-meshio python3-h5py python3-scipy python3-matplotlib python3-pandas python3-nbclient python3-ipykernel gmsh python3-gmsh calculix-ccx
  assimp-utils python3-stl python3-open3d python3-yaml"

# Other builds: a second compiler with its sanitizers, their symbolizer and its OpenMP; wheels. A browser that shows pages.
# FEniCS, which bends a beam.
[ "${1-}" != --all ] || packages="$packages clang-14 libclang-rt-14-dev libomp-14-dev llvm-14
  python3-pip python3-wheel chromium python3-dolfinx-real"

missing=
for package in $packages; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
    missing="$missing $package"
done
if [ -n "$missing" ]; then
  echo "Installing Debian packages (one to three minutes) ..."
  $as_root apt-get update -qq
  # shellcheck disable=SC2086 # a list of words
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    $missing >/dev/null
fi

# Another VTK, for a test that unpacks it.
[ "${1-}" != --all ] || "$(dirname "$0")/OtherBuilds/download-vtk.sh" >/dev/null ||
  echo "VTK 9.1 cannot be downloaded: the test OtherBuilds.PlainVtkHolds will fail" >&2
