#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# download-vtk.sh: download Debian's packages of VTK 9.1, which cannot be installed beside ParaView's, unless they are
# there, and print the folder that they are in.
set -eu

folder=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/insideout/vtk-9.1
if [ ! -e "$folder/complete" ]; then
  as_root=
  [ "$(id -u)" = 0 ] || as_root=sudo
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder"
  # TBB is what it runs in parallel on; libvtk9.1-qt has what its CMake files insist on. A list of packages may be
  # older than what is to be had.
  packages="libvtk9.1 libvtk9.1-qt libvtk9-dev vtk9 python3-vtk9 libtbb-dev libtbb12 libtbbbind-2-5 libtbbmalloc2"
  download="apt-get download -qq -o APT::Sandbox::User=root $packages"
  $download >&2 || { $as_root apt-get update -qq >&2 && $download >&2; }
  touch complete
fi
echo "$folder"
