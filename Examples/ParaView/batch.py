# SPDX-License-Identifier: GPL-3.0-or-later
"""InsideOut in ParaView without its window.

    pvbatch batch.py SURFACE FOLDER
    mpirun --allow-run-as-root --oversubscribe -np 2 pvbatch batch.py SURFACE FOLDER

writes solid.vtu, boundary.vtp and outliers.vtp (with mpirun .pvtu and .pvtp with their pieces) into
the folder, which has to be there; mpirun takes the first option for root, the second for more ranks than
cores. ParaView loads the plugin itself from a folder of PV_PLUGIN_PATH. Where it is installed
among ParaView's own plugins it is loaded by name; otherwise INSIDEOUT_PLUGIN names its file.
"""

import os
import sys

from paraview.servermanager import vtkProcessModule
from paraview.simple import LoadDistributedPlugin, LoadPlugin, OpenDataFile, OutputPort, SaveData
import paraview.simple


def load_plugin():
    file = os.environ.get("INSIDEOUT_PLUGIN")
    if hasattr(paraview.simple, "RobustTetrahedralize"):
        return
    if file:
        LoadPlugin(file, ns=vars(paraview.simple))
    else:
        LoadDistributedPlugin("InsideOut", ns=vars(paraview.simple))


def open_surface(file):
    # ParaView has readers of its own for the usual formats, in single precision. This one keeps all digits.
    if file.lower().endswith((".ply", ".obj", ".off", ".stl")):
        return paraview.simple.SurfaceReader(FileName=file)
    return OpenDataFile(file)


def main(surface_file, folder):
    load_plugin()
    tetrahedralizer = paraview.simple.RobustTetrahedralize(Input=open_surface(surface_file))
    tetrahedralizer.Gamma = 1.0
    tetrahedralizer.UpdatePipeline()
    cells = tetrahedralizer.GetDataInformation().GetNumberOfCells()

    is_parallel = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() > 1
    for port, name in enumerate(("solid.vtu", "boundary.vtp", "outliers.vtp")):
        stem, ending = os.path.splitext(name)
        file = os.path.join(folder, stem + (".p" + ending[1:] if is_parallel else ending))
        # Binary: ParaView's default, appended, cannot be read back on every system.
        SaveData(file, proxy=OutputPort(tetrahedralizer, port), DataMode="Binary")
    print(f"{cells} tetrahedra")
    return cells > 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if not os.path.isdir(sys.argv[2]):
        sys.exit(f"{sys.argv[2]} is not a folder that exists")
    if not main(*sys.argv[1:]):
        sys.exit("no tetrahedra")
