#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# wheel.sh FOLDER: make a wheel of what plain-vtk.sh has built in a folder, install it into a virtual
# environment, and mesh two-boxes.off with it.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(cd "$1" && pwd)
surface=$source/Testing/Data/two-boxes.off

prefix=$folder/vtk/usr
export LD_LIBRARY_PATH="$prefix/lib/$(gcc -print-multiarch)${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export PYTHONPATH="$prefix/lib/python3/dist-packages"
rm -rf "$folder/environment" "$folder/wheel"
/usr/bin/python3 -m venv --system-site-packages --without-pip "$folder/environment"
/usr/bin/python3 -m pip wheel -q --no-index --no-build-isolation --no-deps \
  --config-settings "build-dir=$folder/build" -w "$folder/wheel" "$source/Filters/Python"
/usr/bin/python3 -m pip --python "$folder/environment/bin/python" install -q --no-index --no-deps --no-warn-script-location "$folder"/wheel/*.whl

cd "$folder/environment"
if find . -name 'insideout-tetgen*' | grep .; then
  echo "there is a part of TetGen in the wheel"
  exit 1
fi
bin/insideout "$surface" solid.vtu
exec bin/python - "$surface" "$source/Filters/Python" <<'END'
import sys
from importlib.metadata import entry_points, version

import insideout
from vtkmodules.vtkCommonCore import vtkVersion

sys.path.append(sys.argv[2])  # behind the wheel's insideout
import wheel_by_cmake

assert insideout.__file__.startswith(sys.prefix), insideout.__file__
result = insideout.tetrahedralize(sys.argv[1])
assert abs(result.statistics["Volume"] - 1.75) < 1e-12, result.statistics
assert insideout.check_solid("solid.vtu").solid.GetNumberOfCells() == len(result.solid.cells)
assert [entry.value for entry in entry_points(group="pyvista.accessors")] == ["insideout.accessors"]
made = version("insideout")
assert made == f"{insideout.__version__}+vtk{vtkVersion().GetVTKMajorVersion()}.{vtkVersion().GetVTKMinorVersion()}", made
assert made == wheel_by_cmake.dynamic_metadata({}, {})["version"]
print("The wheel works with VTK", vtkVersion.GetVTKVersion())
END
