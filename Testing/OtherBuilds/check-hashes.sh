#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check-hashes.sh EXPECTED PROGRAM [--small] SURFACE...: whether a build of HashOutputs writes what the
# file says; with --small, only lines that stand there.
set -eu
expected=$1
program=$2
shift 2
written=$(mktemp)
trap 'rm "$written"' EXIT

"$program" "$written" "$@"

case $1 in
  --small) [ -s "$written" ] && ! grep -vxFf "$expected" "$written" ;;
  *) diff "$expected" "$written" ;;
esac
