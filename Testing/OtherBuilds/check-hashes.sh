#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check-hashes.sh EXPECTED PROGRAM SURFACE...: whether a build of HashOutputs writes what the file says.
set -eu
expected=$1
program=$2
shift 2
written=$(mktemp)
trap 'rm "$written"' EXIT

"$program" "$written" "$@"
diff "$expected" "$written"
