#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# make-all.sh [FOLDER]: draw the thesis's figures again, after Examples/quickstart.sh; about eight minutes. Without a folder
# they go to figures/. Figures 8.10 and 8.11 are times: Testing/Benchmark/run.sh draws them.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
/usr/bin/python3 -c "import insideout" 2>/dev/null || . "$here/../../build/env.sh"
folder=${1:-figures}
mkdir -p "$folder"

draw() {
  echo "$1: $2"
  shift 2
  xvfb-run -a -s "-noreset -screen 0 1280x1024x24" python3 "$@"
}
draw 8.13 "outliers" "$here/outliers.py" "$folder/outliers.png"
draw 8.14 "torn apart" "$here/torn_apart.py" "$folder/torn-apart.png" "$folder/torn-apart-plot.png"
draw 8.15 "surface repair, whose program is compiled first" "$here/repair.py" "$folder/repair.png" "$folder/repair.csv"
draw 8.16 "elasticity" "$here/../Applications/sagging.py" "$folder/sagging.png"
draw 8.17 "overlap" "$here/overlap.py" "$folder/overlap.png"
draw 8.18 "solid texture" "$here/../Applications/solid_texture.py" "$folder/solid-texture.png"
draw 8.19 "deformation" "$here/../Applications/deformation.py" "$folder/deformation.png"
draw 8.20 "skinning weights" "$here/../Applications/skinning.py" "$folder/skinning.png"
draw 8.21 "ski mask" "$here/../Python/ski_mask.py" "$folder/ski-mask.png"
draw soups "triangles turned over and torn apart" "$here/soups.py" "$folder/soups.png"
draw tasks "the first page's tasks" "$here/tasks.py" "$folder"
draw "8.22 to 8.25" "contact sheets" "$here/contact_sheets.py" "$folder"
echo "written to $folder:"
ls "$folder"/*.png "$folder"/*.csv
