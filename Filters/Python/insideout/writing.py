# SPDX-License-Identifier: GPL-3.0-or-later
"""`write`: results as files, for VTK, solvers and other programs. The ending of a file's name says what it holds."""

from __future__ import annotations

import os
from typing import Literal, Mapping, Optional, Union, get_args

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .bodies import outer_boundary
from .calling import for_users, tell
from .data import Tetrahedra, Triangles, as_type, is_flat
from .errors import ArgumentError, Error, one_of
from .exporting import is_boundary_alone, scalars_and_vectors
from .files import GRID, WRITABLE_SURFACES, Path, check_output, ending, run_writer, temporary_folder, write_grid, write_surface
from .grid_files import write_distances
from .grids import DistanceGrid
from .inputs import path_of
from .options import in_words_of_python
from .packages import import_package
from .pipeline import write_bytes
from .tetrahedralization import Tetrahedralization
from .vtkFiltersInsideOut import vtkSolidWriter

MshVersion = Literal["4.1", "2.2"]

XDMF = ".xdmf"
WRITABLE_SOLIDS = (".msh", ".inp", ".mesh")
"""What vtkSolidWriter writes: files for solvers, with regions and tags."""

WRITABLE_GRIDS = (GRID, *WRITABLE_SOLIDS, XDMF)


@for_users
def write(
    data: Union[Tetrahedralization, vtkPolyData, vtkUnstructuredGrid, DistanceGrid],
    path: Path,
    *,
    boundary: Optional[vtkPolyData] = None,
    msh_version: MshVersion = "4.1",
) -> None:
    """Write a result, a surface, tetrahedra or a grid of distances, whole or not at all; the ending of the file's name says how.

    data         what `tetrahedralize` or `sdf_grid` gave, or a surface or tetrahedra of VTK's
    path         the file's name
    boundary     of tetrahedra alone, for solvers: the triangles of their boundary, with tags; without them
                 the faces of one cell are a group. A result brings its own
    msh_version  of .msh files: "4.1", or "2.2" for programs that know no other

    .vtu               VTK's own: tetrahedra with all arrays. Names in field data become names of components, for
                       meshio reads no strings there
    .msh, .inp, .mesh  for gmsh, for CalculiX and Abaqus, and for Medit: tetrahedra by regions and the boundary's
                       triangles by tags, with their names (the VTK class vtkSolidWriter says how)
    .xdmf              tetrahedra with all arrays, by meshio; FacetIds and the like as FacetIds_0 to _3
    .vtp, .ply, .stl, .obj, .off, .glb, .3mf
                       a surface; of a result the solid's watertight boundary, without interfaces between bodies

    .npz               of `sdf_grid`, for numpy: distance, inside, origin, spacing and to, by these names
    .nrrd              the same distances with their place in space, as medical images have it
    .vti               VTK's own: an image with the arrays Distance and Inside

    Triangles in a plane go to .vtu and .xdmf, and their boundary, which is polylines, to .vtp.

    An earlier file stays as it was until the new one is on the disk. Warns where the floats of a .stl or .glb file make
    triangles meet that did not, or points nearly meet. Raises `Error` that names the file.
    """
    path = path_of("path", path)
    if boundary is not None and not isinstance(boundary, vtkPolyData):
        raise Error(f"boundary is of type {type(boundary).__name__}; it must be a vtkPolyData")
    one_of(get_args(MshVersion), "msh_version", msh_version)
    if isinstance(data, DistanceGrid):
        write_distances(data, path)
    elif isinstance(data, Tetrahedralization):
        if ending(path) in WRITABLE_SURFACES:
            tell(write_surface(outer_boundary(data.boundary), path))
        else:
            tell(write_solid(data.solid, path, boundary or data.boundary, msh_version))
    elif isinstance(data, vtkUnstructuredGrid):
        tell(write_solid(data, path, boundary, msh_version))
    elif isinstance(data, vtkPolyData):
        tell(write_surface(data, path))
    else:
        raise Error(
            f"what is to be written is of type {type(data).__name__}; it can be a result of tetrahedralize or sdf_grid, "
            "a vtkPolyData or a vtkUnstructuredGrid"
        )


def check_holds_triangles(path: str) -> None:
    """Raise `ArgumentError` unless a file of cells can have triangles in a plane."""
    if ending(path) in WRITABLE_SOLIDS:
        raise ArgumentError(f"{path}: such a file has tetrahedra here; write triangles in a plane as .vtu or .xdmf")


def write_solid(
    grid: vtkUnstructuredGrid, path: Path, boundary: Optional[vtkPolyData] = None, msh_version: MshVersion = "4.1"
) -> list[str]:
    """Write tetrahedra in any of the formats that have them. Returns what the format could not keep. Raises `Error` that names the file."""
    path = os.fspath(path)
    check_output(path, WRITABLE_GRIDS)
    check_format(path)
    if is_boundary_alone(grid, boundary):
        raise Error(f"{path}: such a file has the solid's cells, and surface_only left these away")
    if is_flat(grid):
        check_holds_triangles(path)
    if ending(path) in WRITABLE_SOLIDS:
        versions = get_args(MshVersion)
        writer = vtkSolidWriter()
        writer.SetInputData(grid)
        writer.SetBoundaryData(boundary)
        writer.SetMshVersion(versions.index(one_of(versions, "msh_version", msh_version)))
        return in_words_of_python(run_writer(writer, path))
    if ending(path) == XDMF:
        _write_xdmf(as_type(Triangles if is_flat(grid) else Tetrahedra, grid), path)
    else:
        write_grid(grid, path)
    return []


def check_format(path: Path) -> None:
    """Raise `Error` where what writes this format is not installed."""
    if ending(path) == XDMF:
        import_package("meshio")
        import_package("h5py", why=", which meshio takes for .xdmf,")


def _wide(arrays: Mapping[str, NDArray]) -> dict[str, NDArray]:
    """As meshio can write them as text: it takes no narrow integers, and has too few digits for floats."""
    widened = {"f": np.float64, "i": np.int64, "u": np.uint64}
    return {name: values.astype(widened[values.dtype.kind]) for name, values in scalars_and_vectors(arrays).items()}


def _write_xdmf(grid: Union[Tetrahedra, Triangles], path: str) -> None:
    """All in one file, as text: meshio puts numbers into a second one otherwise."""
    kind, nodes = grid.kind(), grid.cells
    cell_data = {name: [values] for name, values in _wide(grid.cell_arrays).items()}
    mesh = import_package("meshio").Mesh(grid.points, [(kind, nodes)], point_data=_wide(grid.point_arrays), cell_data=cell_data)
    with temporary_folder() as folder:
        whole = os.path.join(folder, "whole.xdmf")
        try:
            import_package("meshio").write(whole, mesh, data_format="XML")
            with open(whole, "rb") as file:
                content = file.read()
        except OSError as error:
            raise Error(f"{path}: {error.strerror or error} in {folder}, where meshio writes it first") from None
        except MemoryError:
            raise Error(f"{path}: not enough memory to write it") from None
    write_bytes(content, path)
