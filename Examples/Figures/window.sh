#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# window.sh PICTURE.png: ParaView's window with the demo's figure, its defects, its tetrahedra and a slice of w, on a display
# of its own (Debian: xvfb, imagemagick). After `. build/env.sh`.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
insideout demo "$folder/demo" --quiet

cat >"$folder/panel.qss" <<END
pqPropertiesPanel { min-width: 400px; }
pqPipelineBrowserWidget { max-height: 200px; }
END
cat >"$folder/look.py" <<END
from insideout.actors import SOLID, colours_of_w
from paraview.simple import *

view = GetActiveViewOrCreate("RenderView")
surface = OpenDataFile("$folder/demo/broken.ply")
RenameSource("broken.ply", surface)
defects, solid = SurfaceDefects(Input=surface), RobustTetrahedralize(Input=surface, GenerateHull=1)
cut = SliceWindingNumber(Input=OutputPort(solid, 3))
cut.SliceType.Normal = [0, 1, 0]
shown = [Show(port, view) for port in (OutputPort(defects, 0), OutputPort(defects, 1), OutputPort(solid, 0), cut)]
Hide(surface, view)
for one, x in zip(shown, (0, 0, 3.6, 7)):
    one.Position = [x, 0, 0]
shown[2].SetRepresentationType("Surface With Edges")
ColorBy(shown[2], None)
shown[2].DiffuseColor = SOLID
ColorBy(shown[3], ("CELLS", "w"))
LoadPalette("WhiteBackground")
w, node, points = GetColorTransferFunction("w"), [0.0] * 6, []
for k in range(colours_of_w().GetSize()):
    colours_of_w().GetNodeValue(k, node)
    points += node[:4]
w.ColorSpace, w.RGBPoints = "Lab", points
shown[3].SetScalarBarVisibility(view, True)
Render(view)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [3.5, -20, 0.45], [3.5, 0, 0.45], [0, 0, 1]
view.CameraParallelProjection, view.CameraParallelScale = 1, 4.2
SetActiveSource(solid)
Render(view)
print("ready", flush=True)
END
cat >"$folder/take.sh" <<END
paraview -qwindowgeometry 1280x860+0+0 -stylesheet "$folder/panel.qss" --dr --script="$folder/look.py" >"$folder/log" 2>&1 &
for second in \$(seq 300); do sleep 1; grep -q ready "$folder/log" && break; done
sleep 6
import -window root "$folder/window.png"
kill \$!
END
HOME=$folder XDG_RUNTIME_DIR=$folder xvfb-run -a -s "-noreset -screen 0 1280x860x24" sh "$folder/take.sh"
convert "$folder/window.png" +dither -colors 160 "PNG8:$1"
