# SPDX-License-Identifier: GPL-3.0-or-later
"""`read`: the content of a file, in the format that the ending of its name says."""

from __future__ import annotations

from typing import Optional, Union

from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, VTK_TETRA, VTK_TRIANGLE, vtkUnstructuredGrid

from .calling import for_users, tell
from .data import LayeredCells, Polylines, Tetrahedra, Triangles, TriangleSurface, as_type, has_layers
from .errors import Error
from .files import READABLE_SOLIDS, READABLE_SURFACES, Path, are_lines, ending, input_ending, read_solid, read_surface
from .inputs import path_of
from .pipeline import Progress

_TYPES = {VTK_TETRA: Tetrahedra, VTK_QUADRATIC_TETRA: Tetrahedra, VTK_TRIANGLE: Triangles}
"""The class by the type of the first cell, for solids without layers."""


@for_users
def read(path: Path, *, progress: Optional[Progress] = None) -> Union[TriangleSurface, Polylines, Tetrahedra, LayeredCells, Triangles, vtkUnstructuredGrid]:
    """The content of a file: a surface as a vtkPolyData, or a solid as a vtkUnstructuredGrid, with all arrays.

    path      a surface: .ply, .obj, .off, .stl, .vtp, .glb or .3mf, also compressed with .gz appended; or lines in a
              plane: .csv; or a solid: .vtu, .msh (gmsh), .inp (Abaqus and CalculiX) or .mesh (Medit)
    progress  called with what is being done and the fraction that is done; an exception that it raises stops the reading

    A solid from a file with groups has the cell array RegionId, and the names of groups in the field array RegionNames.
    A file of triangles alone is a solid in a plane. (The VTK class vtkSolidReader gives the triangles of the boundary
    with their tags, too.) Coordinates keep all digits of the file. Warns of skipped content. Raises `Error` that names
    the file, the line and the reason.
    """
    path = path_of("path", path)
    if ending(path) in READABLE_SOLIDS:
        grid, warnings = read_solid(path, progress)
        tell(warnings)
        if has_layers(grid):
            return as_type(LayeredCells, grid)
        kind = _TYPES.get(grid.GetCellType(0)) if grid.GetNumberOfCells() > 0 else Tetrahedra
        return grid if kind is None else as_type(kind, grid)
    if input_ending(path) not in READABLE_SURFACES:
        raise Error(f"{path}: unknown ending, it must be {' '.join((*READABLE_SURFACES, *READABLE_SOLIDS))}")
    surface, warnings = read_surface(path, progress)
    tell(warnings)
    return as_type(Polylines if are_lines(surface) else TriangleSurface, surface)
