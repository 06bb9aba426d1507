# SPDX-License-Identifier: GPL-3.0-or-later
"""The two ways to use InsideOut from Python.

    python3 tetrahedralize.py SURFACE SOLID.vtu BOUNDARY.vtp

writes the tetrahedra of the solid that a broken surface means, and the solid's boundary.
"""

import sys

import insideout
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter


def in_three_lines(surface_file):
    """One function, for those who do not think in pipelines."""
    result = insideout.tetrahedralize(surface_file, gamma=1.0)
    print(f"{result.solid.GetNumberOfCells()} tetrahedra, {result.statistics['OpenEdges']} open edges closed")
    return result


def as_a_pipeline(surface_file, solid_file, boundary_file):
    """VTK's filters, which work again when a parameter changes."""
    reader = insideout.vtkSurfaceReader()
    reader.SetFileName(surface_file)

    tetrahedralizer = insideout.vtkRobustTetrahedralize()
    tetrahedralizer.SetInputConnection(reader.GetOutputPort())
    tetrahedralizer.SetGamma(1.0)

    solid_writer = vtkXMLUnstructuredGridWriter()
    solid_writer.SetInputConnection(tetrahedralizer.GetOutputPort(0))
    solid_writer.SetFileName(solid_file)
    solid_writer.SetDataModeToBinary()  # VTK's default, appended, cannot be read back on every system
    solid_written = solid_writer.Write()

    boundary_writer = vtkXMLPolyDataWriter()
    boundary_writer.SetInputConnection(tetrahedralizer.GetOutputPort(1))
    boundary_writer.SetFileName(boundary_file)
    boundary_writer.SetDataModeToBinary()
    boundary_written = boundary_writer.Write()

    solid = tetrahedralizer.GetOutput()
    print(f"{solid.GetNumberOfCells()} tetrahedra, w from {solid.GetCellData().GetArray('w').GetRange()[0]:g} up")
    return bool(solid_written and boundary_written and solid.GetNumberOfCells() > 0)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    surface_name, solid_name, boundary_name = sys.argv[1:]
    by_function = in_three_lines(surface_name)
    if not as_a_pipeline(surface_name, solid_name, boundary_name):
        sys.exit("the pipeline gave no tetrahedra")
