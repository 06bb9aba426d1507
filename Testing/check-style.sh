#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Rules of the source tree, run from its root: formatting, no VTK in Core, a license line in each
# file, and those of its structure and of its texts.
set -u
failed=0
complain() {
  echo "$1"
  failed=1
}

sources=$(find Filters Plugin Testing Examples -name '*.h' -o -name '*.cxx')
[ -n "$sources" ] || complain "no sources found: run from the root of the tree"
# shellcheck disable=SC2086 # a list of words
clang-format --dry-run -Werror $sources || complain "run clang-format -i on these"

vtk_in_core=$(grep -rlE '#include *[<"]vtk' Filters/Core Filters/Tetgen Testing/Cxx/Core)
[ -z "$vtk_in_core" ] || complain "VTK headers in the algorithms: $vtk_in_core"

files=$(find Filters Plugin Testing Examples -type f \
  ! -name LICENSE ! -path '*/Data/*' ! -path '*/__pycache__/*' ! -name '*.plugin' ! -name '*.png' ! -name '*.md' ! -name '*.csv')
for file in $files; do
  head -n 3 "$file" | grep -q 'SPDX-License-Identifier: A\{0,1\}GPL-3.0-or-later' ||
    complain "$file: no SPDX line"
done

python3 Testing/check-structure.py || failed=1
python3 Testing/check-texts.py || failed=1

exit $failed
