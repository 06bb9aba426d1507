# SPDX-License-Identifier: GPL-3.0-or-later
"""`write`: results as files, for VTK, solvers and other programs. The ending of a file's name says what it holds."""

from __future__ import annotations

from typing import Optional, Union, get_args

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .calling import for_users, tell
from .errors import Error, one_of, switch
from .files import Path, write_surface
from .grid_files import write_distances
from .grids import DistanceGrid
from .inputs import path_of
from .solid_files import MshVersion, write_result, write_solid
from .tetrahedralization import Tetrahedralization


@for_users
def write(
    data: Union[Tetrahedralization, vtkPolyData, vtkUnstructuredGrid, DistanceGrid],
    path: Path,
    *,
    boundary: Optional[vtkPolyData] = None,
    msh_version: MshVersion = "4.1",
    cells_only: bool = False,
) -> None:
    """Write a result, a surface, tetrahedra or a grid of distances, whole or not at all; the ending of the file's name says how.

    data         what `tetrahedralize` or `sdf_grid` gave, or a surface or tetrahedra of VTK's
    path         the file's name
    boundary     of tetrahedra alone, for solvers: the triangles of their boundary, with tags; without them
                 the faces of one cell are a group. A result brings its own
    msh_version  of .msh files: "4.1", or "2.2" for programs that know no other
    cells_only   leave boundary and regions away: one block of nodes and one of elements

    .vtu               VTK's own: tetrahedra with all arrays. Names in field data become names of components, for
                       meshio reads no strings there
    .msh, .inp, .mesh  for gmsh, for CalculiX and Abaqus, and for Medit: tetrahedra by regions and the boundary's
                       triangles by tags, with their names (the VTK class vtkSolidWriter says how)
    .xdmf              tetrahedra with all arrays, for FEniCS; FacetIds and the like as FacetIds_0 to _3. NAME_boundary.xdmf
                       gets the boundary's triangles, with the same points and BoundaryTag as the first array
    .vtp, .ply, .stl, .obj, .off, .glb, .3mf
                       a surface; of a result the solid's watertight boundary, without interfaces between bodies

    .npz               of `sdf_grid`, for numpy: distance, inside, origin, spacing and to, by these names
    .nrrd              the same distances with their place in space, as medical images have it
    .vti               VTK's own: an image with the arrays Distance and Inside

    Triangles in a plane go to .vtu and .xdmf, and their boundary, which is polylines, to .vtp.

    An earlier file stays as it was until the new one is on the disk. No cell is changed: a warning counts those of a file for a
    solver (.msh, .inp, .mesh, .xdmf) that it would refuse or suffer from, and names what helps. Warns, too, where the floats of a .stl or .glb file make
    triangles meet that did not, or points nearly meet. Raises `Error` that names the file.
    """
    path = path_of("path", path)
    if boundary is not None and not isinstance(boundary, vtkPolyData):
        raise Error(f"boundary is of type {type(boundary).__name__}; it must be a vtkPolyData")
    one_of(get_args(MshVersion), "msh_version", msh_version)
    cells_only = switch("cells_only", cells_only)
    if isinstance(data, DistanceGrid):
        write_distances(data, path)
    elif isinstance(data, Tetrahedralization):
        tell(write_result(data.solid, boundary or data.boundary, path, msh_version, cells_only))
    elif isinstance(data, vtkUnstructuredGrid):
        tell(write_solid(data, path, boundary, msh_version, cells_only=cells_only))
    elif isinstance(data, vtkPolyData):
        tell(write_surface(data, path))
    else:
        raise Error(
            f"what is to be written is of type {type(data).__name__}; it can be a result of tetrahedralize or sdf_grid, "
            "a vtkPolyData or a vtkUnstructuredGrid"
        )
