#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# build.sh FOLDER TARGETS OPTION...: configure the algorithms alone in a folder, with options of
# CMake's, and build some targets (in one word). Files that are up to date stay.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$1
targets=$2
shift 2

cmake -S "$source" -B "$folder" -G Ninja -DINSIDEOUT_CORE_ONLY=ON -DBUILD_TESTING=ON \
  -DCMAKE_BUILD_TYPE=None "$@"
# shellcheck disable=SC2086 # a list of words
exec cmake --build "$folder" --target $targets
