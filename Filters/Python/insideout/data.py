# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's data sets with numpy views of what is in them, and surfaces out of whatever holds triangles."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Mapping, Optional, Protocol, Tuple, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_QUADRATIC_TETRA,
    VTK_TRIANGLE,
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkDataSetAttributes,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .exporting import mesh_of
from .files import Path, read_surface
from .pipeline import Error, run_with_upstream
from .serializing import packed, unpacked, vtk_array

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPointSet as _PointSet
else:
    _PointSet = object  # of VTK's classes only one can be a base: that of the class with the views

# What type checkers know of classes that are not there to them: VTK brings no types, and the others need not be installed.


class PolyData(Protocol):
    """A vtkPolyData."""

    def GetPolys(self) -> Any: ...

    def GetStrips(self) -> Any: ...


class Algorithm(Protocol):
    """A vtkAlgorithm."""

    def GetOutputPort(self) -> Any: ...

    def GetOutputDataObject(self, port: int) -> Any: ...


class AlgorithmOutput(Protocol):
    """A vtkAlgorithmOutput, which GetOutputPort() of an algorithm gives."""

    def GetProducer(self) -> Any: ...

    def GetIndex(self) -> int: ...


class DataSetOfPoints(Protocol):
    """A vtkDataSet."""

    def GetPoint(self, index: int) -> Any: ...

    def GetNumberOfPoints(self) -> int: ...


class MeshioMesh(Protocol):
    """A meshio.Mesh."""

    @property
    def points(self) -> Any: ...

    @property
    def cells(self) -> Any: ...

    @property
    def point_data(self) -> Any: ...

    @property
    def cell_data(self) -> Any: ...


class Trimesh(Protocol):
    """A trimesh.Trimesh, or whatever else has `vertices` (n, 3) and `faces` (m, 3)."""

    @property
    def vertices(self) -> Any: ...

    @property
    def faces(self) -> Any: ...


PointsAndTriangles = Tuple[ArrayLike, ArrayLike]
AnySurface = Union[PolyData, Path, PointsAndTriangles, MeshioMesh, Trimesh, Algorithm, AlgorithmOutput]
"""What every function takes for a surface: a vtkPolyData of polygons or strips; the name of a .ply, .obj, .off,
.stl or .vtp file; a pair (points, triangles) of arrays with three columns; a meshio.Mesh; an object with
`vertices` and `faces`, as a trimesh.Trimesh; or a VTK algorithm, or an output port of one, which is updated."""

AnyPoints = Union[DataSetOfPoints, ArrayLike]
"""What every function takes for points: an array with three columns, or the points of a VTK data set."""

ARRAYS = ("points", "triangles")

_POLYGONS = {"triangle": 3, "quad": 4, "polygon": None}
"""How meshio's types of cells that are one begin, and how many corners they have; behind these are midpoints."""

DataSet = TypeVar("DataSet", bound=vtkDataSet)


class _Views(_PointSet):
    """Arrays of a vtkPointSet as numpy views: they show VTK's memory and cost nothing."""

    def __reduce__(self) -> tuple:
        return unpacked, (type(self), packed(self))

    def __copy__(self) -> Any:
        return as_type(type(self), self)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.GetNumberOfPoints():,} points, {self.GetNumberOfCells():,} cells>"

    @property
    def points(self) -> NDArray[np.float64]:
        """Coordinates, one row each."""
        return _points_of(self)

    @property
    def point_arrays(self) -> dict[str, NDArray]:
        """The numeric arrays with a value per point, by name."""
        return _arrays_of(self.GetPointData())

    @property
    def cell_arrays(self) -> dict[str, NDArray]:
        """The numeric arrays with a value per triangle or tetrahedron, by name."""
        return _arrays_of(self.GetCellData())


class TriangleSurface(_Views, vtkPolyData):
    """A vtkPolyData of triangles. Its arrays are views: they show VTK's memory and cost nothing."""

    @property
    def triangles(self) -> NDArray[np.int64]:
        """The three points of each triangle, counterclockwise seen from outside."""
        return corners_of(self.GetPolys(), 3)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh, with all arrays."""
        return mesh_of(self, "triangle", self.triangles)

    @property
    def tag_names(self) -> list[str]:
        """The names of the tags in the cell array BoundaryTag, if it has any."""
        names = self.GetFieldData().GetAbstractArray("BoundaryTagNames")
        return [] if names is None else [names.GetValue(tag) for tag in range(names.GetNumberOfValues())]


class Tetrahedra(_Views, vtkUnstructuredGrid):
    """A vtkUnstructuredGrid of tetrahedra. Its arrays are views: they show VTK's memory and cost nothing."""

    @property
    def cells(self) -> NDArray[np.int64]:
        """The four points of each tetrahedron, positively oriented; all ten of those that are quadratic."""
        return corners_of(self.GetCells(), 10 if self._is_quadratic() else 4)

    @property
    def w(self) -> NDArray[np.float64]:
        """The winding number of each tetrahedron."""
        return self.cell_arrays["w"]

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Whether each tetrahedron is inside."""
        return self.cell_arrays["Inside"].astype(bool)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh, with all arrays. That of the whole result has the boundary and groups, too."""
        return mesh_of(self, self.kind(), self.cells)

    def kind(self) -> str:
        """What meshio calls the type of its cells."""
        return "tetra10" if self._is_quadratic() else "tetra"

    def _is_quadratic(self) -> bool:
        return self.GetNumberOfCells() > 0 and self.GetCellType(0) == VTK_QUADRATIC_TETRA


class Triangles(_Views, vtkUnstructuredGrid):
    """A vtkUnstructuredGrid of triangles in a plane. Its arrays are views: they show VTK's memory and cost nothing."""

    @property
    def cells(self) -> NDArray[np.int64]:
        """The three points of each triangle, all in one direction."""
        return corners_of(self.GetCells(), 3)

    @property
    def w(self) -> NDArray[np.float64]:
        """The winding number of each triangle."""
        return self.cell_arrays["w"]

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Whether each triangle is inside."""
        return self.cell_arrays["Inside"].astype(bool)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh, with all arrays."""
        return mesh_of(self, self.kind(), self.cells)

    def kind(self) -> str:
        """What meshio calls the type of its cells."""
        return "triangle"


class Polylines(_Views, vtkPolyData):
    """A vtkPolyData of polylines. Its arrays are views: they show VTK's memory and cost nothing."""

    @property
    def lines(self) -> list[NDArray[np.int64]]:
        """The points of each polyline, one behind the other; a closed one has its first again at its end."""
        lines = self.GetLines()
        if lines.GetNumberOfCells() == 0:
            return []
        offsets = vtk_to_numpy(lines.GetOffsetsArray())
        return np.split(vtk_to_numpy(lines.GetConnectivityArray()), offsets[1:-1])


def is_flat(grid: vtkUnstructuredGrid) -> bool:
    """Whether its cells are triangles."""
    return bool(grid.GetNumberOfCells() > 0 and grid.GetCellType(0) == VTK_TRIANGLE)


def as_type(data_type: type[DataSet], data: vtkDataSet) -> DataSet:
    """The same data, not copied, as another of the types here."""
    typed = data_type()
    typed.ShallowCopy(data)
    return typed


def as_surface(surface: AnySurface, scale: Optional[float] = None) -> tuple[vtkPolyData, list[str]]:
    """The surface as VTK holds it, its coordinates multiplied, and what was passed over on the way. Raises `Error` for what is none."""
    try:
        polygons, warnings = _as_surface(surface)
        return (polygons if scale is None else _scaled(polygons, scale)), warnings
    except MemoryError:
        raise Error("not enough memory for this surface") from None


def _scaled(surface: vtkPolyData, scale: float) -> vtkPolyData:
    """A copy whose coordinates are multiplied, as doubles."""
    copy = vtkPolyData()
    copy.ShallowCopy(surface)
    if surface.GetNumberOfPoints() > 0:
        copy.SetPoints(make_points(vtk_to_numpy(surface.GetPoints().GetData()).astype(float) * scale, ARRAYS[0]))
    return copy


def _as_surface(surface: Any) -> tuple[vtkPolyData, list[str]]:
    if isinstance(surface, vtkPolyData):
        return surface, []
    if isinstance(surface, (str, os.PathLike)):
        return read_surface(surface)
    if isinstance(surface, (vtkAlgorithm, vtkAlgorithmOutput)):
        return output_of(surface, "surface", vtkPolyData)
    refuse_composite("surface", surface)
    if hasattr(surface, "points") and hasattr(surface, "cells"):
        return _surface_of_meshio(surface)
    if hasattr(surface, "vertices") and hasattr(surface, "faces"):
        return make_surface(surface.vertices, surface.faces, names=("vertices", "faces")), []
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        return make_surface(*surface), []
    raise Error(
        f"the surface is of type {type(surface).__name__}; it can be a vtkPolyData, a file's name, "
        "a pair (points, triangles) of arrays, a meshio.Mesh, an object with vertices and faces, or a VTK algorithm"
    )


def output_of(source: Union[vtkAlgorithm, vtkAlgorithmOutput], what: str, kind: type[DataSet]) -> tuple[DataSet, list[str]]:
    """The surface, or what it is to be, that an algorithm makes, which is updated, and its warnings."""
    algorithm, port = (source, 0) if isinstance(source, vtkAlgorithm) else (source.GetProducer(), source.GetIndex())
    name = algorithm.GetClassName()
    if algorithm.GetNumberOfOutputPorts() == 0:
        raise Error(f"the {what} is a {name}, which has no output")
    warnings = run_with_upstream(algorithm)
    output = algorithm.GetOutputDataObject(port)
    refuse_composite(f"output of the {name}", output)
    if not isinstance(output, kind):
        raise Error(f"the output of the {name} is a {output.GetClassName()}; it must be a {kind.__name__}")
    return output, warnings


def refuse_composite(what: str, data: Any) -> None:
    """Raise `Error` for what has blocks."""
    if isinstance(data, vtkCompositeDataSet):
        raise Error(
            f"the {what} is a {data.GetClassName()}, which has blocks: give one of them, "
            "or all as one by the filter vtkCompositeDataGeometryFilter"
        )


def make_surface(points: ArrayLike, *polygons: ArrayLike, names: tuple[str, str] = ARRAYS) -> TriangleSurface:
    """A surface of points and polygons: arrays of as many columns as the polygons have corners."""
    offsets, corners = [np.zeros(1, np.int64)], [np.zeros(0, np.int64)]
    for block in polygons:
        rows = table_of(names[1], block, np.int64)
        if len(rows) and rows.shape[1] < 3:
            raise Error(f"{names[1]} has {rows.shape[1]} columns; it must have 3: ids of points, from 0")
        offsets.append(offsets[-1][-1] + rows.shape[1] * np.arange(1, len(rows) + 1))
        corners.append(rows.ravel())
    cells = vtkCellArray()
    cells.SetData(*(vtk_array(np.concatenate(ids), VTK_ID_TYPE) for ids in (offsets, corners)))
    surface = TriangleSurface()
    surface.SetPoints(make_points(points, names[0]))
    surface.SetPolys(cells)
    return surface


def as_points(points: AnyPoints) -> vtkDataSet:
    """A VTK data set with these points. Raises `Error` for what is no table of them."""
    if isinstance(points, vtkDataSet):
        return points
    if isinstance(points, vtkDataObject):
        raise Error(f"points is a {points.GetClassName()}; it can be a vtkDataSet, or an array with three columns")
    data = vtkPolyData()
    try:
        data.SetPoints(make_points(points, ARRAYS[0]))
    except MemoryError:
        raise Error("not enough memory for these points") from None
    return data


def make_points(values: Any, name: str) -> vtkPoints:
    """VTK's points, in double precision, with a copy of the coordinates."""
    rows = table_of(name, values, float)
    if rows.shape[1] != 3:
        raise Error(f"{name} has {rows.shape[1]} columns; it must have 3: x, y and z")
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(vtk_array(rows))
    return points


def table_of(name: str, values: ArrayLike, kind: type) -> NDArray:
    """A table as one array of a type, whatever holds it."""
    if np.ma.is_masked(values):
        row = np.argwhere(np.ma.getmaskarray(values))[0][0]
        raise Error(f"{name} is masked in row {row}: a surface has no gaps, fill them or leave the rows out")
    try:
        table = np.asarray(values)
        if table.dtype.kind == "c":
            raise Error(f"{name} holds complex numbers; it must hold real ones")
        rows: NDArray = np.ascontiguousarray(table, dtype=kind)
    except (TypeError, ValueError):
        raise Error(f"{name} is no table of numbers") from None
    if rows.size == 0:
        return rows.reshape(0, 3)
    if rows.ndim != 2:
        raise Error(f"{name} has {rows.ndim} dimensions; it must have 2, a row for each")
    if kind is np.int64 and not np.array_equal(rows, table):
        raise Error(f"{name} holds what is no whole number")
    return rows


def make_cells(corners: NDArray[np.int64]) -> vtkCellArray:
    """VTK's cells of a table with the points of each."""
    cells = vtkCellArray()
    cells.SetData(corners.shape[1], vtk_array(corners.ravel(), VTK_ID_TYPE))
    return cells


def _points_of(data: Union[vtkPolyData, vtkUnstructuredGrid]) -> NDArray[np.float64]:
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))


def corners_of(cells: vtkCellArray, size: int) -> NDArray[np.int64]:
    """The points of cells that all have the same number of them."""
    if cells.GetNumberOfConnectivityIds() != size * cells.GetNumberOfCells():
        raise Error(f"some cells have not {size} points: go through vtkTriangleFilter first")
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)


def _arrays_of(data: vtkDataSetAttributes) -> dict[str, NDArray]:
    arrays = [data.GetArray(index) for index in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in arrays if array is not None and array.GetName()}


def _add_arrays(arrays: Mapping[str, ArrayLike], data: vtkDataSetAttributes) -> None:
    for name, values in arrays.items():
        rows = np.ascontiguousarray(values)
        if rows.dtype.kind in "iuf" and rows.ndim in (1, 2):
            array = vtk_array(rows)
            array.SetName(name)
            data.AddArray(array)


def _surface_of_meshio(mesh: Any) -> tuple[TriangleSurface, list[str]]:
    """The polygons of a meshio.Mesh with their data, and how many other cells there are."""
    chosen = [k for k, block in enumerate(mesh.cells) if block.type.startswith(tuple(_POLYGONS))]
    others = sum(len(block.data) for k, block in enumerate(mesh.cells) if k not in chosen)
    if not chosen:
        raise Error("the meshio.Mesh has no triangles, quads or polygons")
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 2:
        raise Error("the meshio.Mesh is flat: it bounds no volume")
    surface = make_surface(points, *(_corners_of_meshio(mesh.cells[k]) for k in chosen))
    _add_arrays(mesh.point_data, surface.GetPointData())
    joined = {name: np.concatenate([np.asarray(blocks[k]) for k in chosen]) for name, blocks in mesh.cell_data.items()}
    _add_arrays(joined, surface.GetCellData())
    return surface, [f"{others} cells of the meshio.Mesh are ignored: only polygons count"] if others else []


def _corners_of_meshio(block: Any) -> NDArray:
    """The corners of cells, without midpoints."""
    rows = np.asarray(block.data)
    corners = next(count for begin, count in _POLYGONS.items() if block.type.startswith(begin))
    return rows if rows.ndim != 2 else rows[:, :corners]
