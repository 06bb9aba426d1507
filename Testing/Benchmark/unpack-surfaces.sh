#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# unpack-surfaces.sh FOLDER NAME...: put surfaces of Debian's packages libcgal-demo and
# openfoam-examples into the folder; says which it cannot find.
set -eu
folder=$1
mkdir -p "$folder"
shift

find_archive() {
  for archive in /usr/share/doc/libcgal-dev/data.tar.gz /usr/share/doc/libcgal-demo/data.tar.gz; do
    [ -r "$archive" ] && echo "$archive" && return
  done
}
archive=$(find_archive)

for name; do
  [ -s "$folder/$name" ] && continue
  if [ -n "$archive" ] && tar -xzOf "$archive" "data/meshes/$name" >"$folder/$name" 2>/dev/null; then
    continue
  fi
  rm -f "$folder/$name"
  packed=$(find /usr/share/doc/openfoam-examples -name "$name.gz" 2>/dev/null | sort | head -n 1)
  if [ -n "$packed" ]; then
    gzip -dc "$packed" >"$folder/$name"
  else
    echo "missing: $name, of the Debian packages libcgal-demo and openfoam-examples"
  fi
done
