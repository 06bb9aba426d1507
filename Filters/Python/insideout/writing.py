# SPDX-License-Identifier: GPL-3.0-or-later
"""`write`: results as files, for VTK, solvers and other programs. The ending of a file's name decides its format."""

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
    """Write a result, a surface, tetrahedra or a grid of distances, whole or not at all. The file name's ending decides
    the format.

    data         a result of `tetrahedralize` or `sdf_grid`, or a surface or tetrahedra of VTK
    path         the file's name
    boundary     for tetrahedra alone, for solvers: the triangles of their boundary, with tags; without it the faces of
                 one cell are a group. A result has its own
    msh_version  of .msh files: "4.1", or "2.2" for programs that know no other
    cells_only   omit boundary and regions: one block of nodes and one of elements

    .vtu               VTK's own: tetrahedra with all arrays. Names in field data become names of components, because
                       meshio reads no strings there
    .msh, .inp, .mesh  for gmsh, for CalculiX and Abaqus, and for Medit: tetrahedra by regions and the boundary's
                       triangles by tags, with their names (see the VTK class vtkSolidWriter)
    .xdmf              tetrahedra with all arrays, for FEniCS; FacetIds and the like as FacetIds_0 to _3.
                       NAME_boundary.xdmf gets the boundary's triangles, with the same points and BoundaryTag as the
                       first array
    .vtp, .ply, .stl, .obj, .off, .glb, .3mf
                       a surface; for a result the solid's watertight boundary, without interfaces between bodies

    .npz               a result of `sdf_grid`, for numpy: distance, inside, origin, spacing and to, by these names
    .nrrd              the same distances with their position in space, as medical images have it
    .vti               VTK's own: an image with the arrays Distance and Inside

    Triangles in a plane are written as .vtu or .xdmf, and their boundary, which is polylines, as .vtp.

    An earlier file stays until the new one is on the disk. No cell is changed. For files of solvers (.msh, .inp, .mesh,
    .xdmf) a warning counts refused and poor cells, and names the option that helps. Another warning says that the
    floats of a .stl or .glb file make triangles meet, or points nearly meet. Raises `Error` that names the file.
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
            f"the data to be written are of type {type(data).__name__}; it can be a result of tetrahedralize or sdf_grid, "
            "a vtkPolyData or a vtkUnstructuredGrid"
        )
