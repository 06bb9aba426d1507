# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces and solids as objects of other packages: meshio, trimesh, Open3D, numpy-stl and PyVista."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .measures import FACES
from .packages import import_package
from .pipeline import Error

if TYPE_CHECKING:
    from .data import Tetrahedra, TriangleSurface

PHYSICAL, GEOMETRICAL, ENTITIES = "gmsh:physical", "gmsh:geometrical", "gmsh:dim_tags"
"""Meshio's names of the groups of elements in gmsh's files, and of the entity (dimension and number) of each point."""

EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
"""edges of a tetrahedron, in the order of its mid-edge nodes"""


def mesh_of(data: Any, kind: str, corners: NDArray[np.int64]) -> Any:
    """A surface or tetrahedra as a meshio.Mesh, with all arrays."""
    cell_data = {name: [values] for name, values in data.cell_arrays.items()}
    return import_package("meshio").Mesh(data.points, [(kind, corners)], point_data=data.point_arrays, cell_data=cell_data)


def pyvista_of(data: Any) -> Any:
    """The same as a pyvista.PolyData or pyvista.UnstructuredGrid, which shares the arrays."""
    plain = vtkPolyData() if isinstance(data, vtkPolyData) else vtkUnstructuredGrid()
    plain.ShallowCopy(data)
    return import_package("pyvista").wrap(plain)


def trimesh_of(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> Any:
    """A trimesh.Trimesh with unmerged points."""
    return import_package("trimesh").Trimesh(vertices=points, faces=triangles, process=False)


def open3d_of(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> Any:
    """An open3d.geometry.TriangleMesh."""
    open3d = import_package("open3d")
    vectors = open3d.utility
    return open3d.geometry.TriangleMesh(vectors.Vector3dVector(points), vectors.Vector3iVector(triangles.astype(np.int32)))


def stl_of(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> Any:
    """A stl.mesh.Mesh of numpy-stl, with coordinates in single precision."""
    mesh = import_package("stl").Mesh
    data = np.zeros(len(triangles), mesh.dtype)
    data["vectors"] = points[triangles]
    return mesh(data)


def is_boundary_alone(solid: vtkUnstructuredGrid, boundary: Optional[vtkPolyData]) -> bool:
    """Whether the result has a boundary but no cells, because of `surface_only`."""
    return solid.GetNumberOfCells() == 0 and boundary is not None and boundary.GetNumberOfCells() > 0


def scalars_and_vectors(arrays: Mapping[str, NDArray]) -> dict[str, NDArray]:
    """Arrays as most formats support them: arrays of other than one or three components are split into NAME_0, NAME_1
    ...
    """
    found: dict[str, NDArray] = {}
    for name, values in arrays.items():
        if values.ndim == 1 or values.shape[1] == 3:
            found[name] = values
        else:
            found.update((f"{name}_{k}", column) for k, column in enumerate(values.T))
    return found


def mesh_of_solid(solid: Tetrahedra, boundary: TriangleSurface) -> Any:
    """Tetrahedra and the triangles of their boundary as one meshio.Mesh: see Tetrahedralization.to_meshio."""
    meshio = import_package("meshio")
    kind, nodes = solid.kind(), solid.cells
    triangles = nodes_of_boundary(solid, boundary)
    groups = (
        _Groups(3, kind, nodes, _numbers(solid.cell_arrays.get("RegionId"), len(nodes))),
        _Groups(2, "triangle" if kind == "tetra" else "triangle6", triangles, _numbers(boundary.cell_arrays.get("BoundaryTag"), len(triangles))),
    )
    cells = [(one.kind, one.nodes[chosen]) for one in groups for chosen in one.parts()]
    cell_data: dict[str, list[NDArray]] = {}
    joined = _joined(scalars_and_vectors(solid.cell_arrays), scalars_and_vectors(boundary.cell_arrays), groups)
    for name, blocks in joined.items():
        cell_data[name] = [values[chosen] for one, values in zip(groups, blocks) for chosen in one.parts()]
    for name in (PHYSICAL, GEOMETRICAL):
        cell_data[name] = [one.numbers[chosen] + 1 for one in groups for chosen in one.parts()]
    point_data = {**scalars_and_vectors(solid.point_arrays), ENTITIES: _entities(len(solid.points), groups)}
    field_data = _field_data(groups, boundary.tag_names)
    return meshio.Mesh(solid.points, cells, point_data=point_data, cell_data=cell_data, field_data=field_data)


def nodes_of_boundary(solid: Tetrahedra, boundary: TriangleSurface) -> NDArray[np.int64]:
    """The triangles of a boundary by the points of the tetrahedra, with the mid-edge nodes of quadratic ones."""
    triangles = _triangles_there(solid, boundary)
    faces = np.sort(np.vstack([solid.cells[:, np.array(FACES)].reshape(-1, 3), triangles]), axis=1)
    _, ids = np.unique(faces, axis=0, return_inverse=True)
    alone = ~np.isin(ids.ravel()[-len(triangles) :], ids.ravel()[: -len(triangles)]) if len(triangles) else np.zeros(0, bool)
    if alone.any():
        raise Error(f"triangle {int(np.argmax(alone))} of the boundary is not a face of a tetrahedron")
    return np.hstack([triangles, _midpoints(solid.cells, triangles)]) if solid.kind() == "tetra10" else triangles


class _Groups(NamedTuple):
    """Cells of one type, and the group number of each, from 0."""

    dimension: int
    kind: str
    nodes: NDArray[np.int64]
    numbers: NDArray[np.int32]

    def present(self) -> list[int]:
        return np.unique(self.numbers).tolist()

    def parts(self) -> list[NDArray[np.int64]]:
        """The cells of each group: meshio requires a block for each."""
        return [np.flatnonzero(self.numbers == number) for number in self.present()]


def _numbers(values: Any, count: int) -> NDArray[np.int32]:
    return np.zeros(count, np.int32) if values is None else values.astype(np.int32)


def _entities(points: int, groups: Sequence[_Groups]) -> NDArray[np.int64]:
    """The dimension and number of the entity that each point lies on: its first tag, else its region."""
    entities = np.tile([3, 1], (points, 1))
    for one in groups:
        first = np.full(points, np.iinfo(np.int64).max)
        np.minimum.at(first, one.nodes.ravel(), np.repeat(one.numbers.astype(np.int64) + 1, one.nodes.shape[1]))
        there = np.unique(one.nodes)
        entities[there, 0], entities[there, 1] = one.dimension, first[there]
    return entities


def _points_there(points: NDArray[np.float64], others: NDArray[np.float64]) -> NDArray[np.int64]:
    """The index of the coincident point for each of the others. Raises `Error` if there is none."""
    places, ids = np.unique(np.vstack([points, others]) + 0.0, axis=0, return_inverse=True)  # -0 is 0
    there = np.full(len(places), -1, np.int64)
    first = ids.ravel()[: len(points)][::-1]
    there[first] = np.arange(len(points))[::-1]
    found = there[ids.ravel()[len(points) :]]
    if (found < 0).any():
        raise Error(f"point {int(np.argmax(found < 0))} of the boundary is not a point of the solid")
    return found


def _triangles_there(solid: Tetrahedra, boundary: TriangleSurface) -> NDArray[np.int64]:
    """The boundary's triangles by points of the solid. Among coincident points those of a boundary face are chosen."""
    triangles = _points_there(solid.points, boundary.points)[boundary.triangles]
    lowest = _points_there(solid.points, solid.points)
    if (lowest == np.arange(len(lowest))).all():
        return triangles
    faces = solid.cells[:, np.array(FACES)].reshape(-1, 3)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    alone = faces[first[count == 1]]
    outer = {tuple(sorted(places)): dict(zip(places, face)) for places, face in zip(lowest[alone].tolist(), alone.tolist())}
    for triangle in triangles:
        points = outer.get(tuple(sorted(triangle.tolist())))
        if points is not None:
            triangle[:] = [points[place] for place in triangle.tolist()]
    return triangles


def _midpoints(nodes: NDArray[np.int64], triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """The mid-edge nodes of the triangles, whose edges are edges of quadratic tetrahedra."""
    ends = np.sort(nodes[:, np.array(EDGES)].reshape(-1, 2), axis=1)
    keys = ends[:, 0] * (int(nodes.max()) + 1) + ends[:, 1]
    order = np.argsort(keys, kind="stable")
    wanted = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2), axis=2)
    wanted_keys = wanted[..., 0] * (int(nodes.max()) + 1) + wanted[..., 1]
    found = order[np.minimum(np.searchsorted(keys, wanted_keys, sorter=order), len(keys) - 1)]
    wrong = (keys[found] != wanted_keys).any(axis=1)
    if wrong.any():
        raise Error(f"triangle {int(np.argmax(wrong))} of the boundary is not a face of the solid's cells")
    return nodes[:, 4:].reshape(-1)[found]


def _joined(
    ours: Mapping[str, NDArray], theirs: Mapping[str, NDArray], groups: Sequence[_Groups]
) -> dict[str, list[NDArray]]:
    """Arrays of two blocks of cells, each array with values for both."""
    joined = {}
    for name in (*ours, *(name for name in theirs if name not in ours)):
        given = [arrays.get(name) for arrays in (ours, theirs)]
        like = next(values for values in given if values is not None)
        blocks = [_nothing_like(like, len(one.nodes)) if values is None else values for values, one in zip(given, groups)]
        if blocks[0].shape[1:] == blocks[1].shape[1:]:
            joined[name] = blocks
    return joined


def _nothing_like(values: NDArray, count: int) -> NDArray:
    nothing = {"f": np.nan, "i": -1}.get(values.dtype.kind, 0)
    return np.full((count, *values.shape[1:]), nothing, values.dtype)


def _field_data(groups: Sequence[_Groups], names_of_tags: Sequence[str]) -> dict[str, NDArray]:
    """The number and dimension of each group by name, as vtkSolidWriter writes them."""
    field_data: dict[str, NDArray] = {}
    for one, alone, several, given in zip(groups, ("solid", "surface"), ("region_", "tag_"), ((), names_of_tags)):
        for number in one.present():
            default = alone if one.present() == [0] else f"{several}{number}"
            name = wanted = (given[number] if number < len(given) else "") or default
            count = 2
            while name in field_data:
                name, count = f"{wanted}_{count}", count + 1
            field_data[name] = np.array([number + 1, one.dimension])
    return field_data
