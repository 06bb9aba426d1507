#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# package-deb.sh FOLDER [OPTION...]: make Debian's package insideout_*.deb in a build folder, with options of
# CMake's. It goes where Debian's ParaView and Python look: no environment has to be set to use it.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$1
shift
cmake -S "$source" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DINSIDEOUT_PYTHON_DESTINATION=lib/python3/dist-packages -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
cmake --build "$folder"
cd "$folder"
cpack
