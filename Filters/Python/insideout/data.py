# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's data sets with numpy views of their contents."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_PYRAMID,
    VTK_QUAD,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    VTK_TRIANGLE,
    VTK_WEDGE,
    vtkCellArray,
    vtkDataSet,
    vtkDataSetAttributes,
    vtkPolyData,
    vtkUnstructuredGrid,
)

from .exporting import mesh_of, open3d_of, pyvista_of, stl_of, trimesh_of
from .measures import area, enclosed_volume, faces_of_one_cell, is_closed, joined_where_equal, labels_of_parts, volume_of_cells
from .parts import part_of, points_as
from .pipeline import Error, strings_of
from .serializing import make_cells, packed, types_of_cells, unpacked

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPointSet as _PointSet
else:
    _PointSet = object  # only one VTK class can be a base: that of the class with the views

DataSet = TypeVar("DataSet", bound=vtkDataSet)


class _Views(_PointSet):
    """Arrays of a vtkPointSet as numpy views of VTK's memory, without copies."""

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

    def to_pyvista(self) -> Any:
        """The same as a data set of PyVista, with all arrays, which are shared."""
        return pyvista_of(self)


class TriangleSurface(_Views, vtkPolyData):
    """A vtkPolyData of triangles. Its arrays are views of VTK's memory, without copies."""

    @property
    def triangles(self) -> NDArray[np.int64]:
        """The three points of each triangle, counterclockwise seen from outside."""
        if self.GetNumberOfStrips() > 0:
            raise Error("the surface has strips: go through vtkTriangleFilter first")
        return corners_of(self.GetPolys(), 3)

    @property
    def volume(self) -> float:
        """The volume enclosed by the triangles, in cubed units; negative if they face inward. It is meaningful if they
        are closed.
        """
        return enclosed_volume(self.points, self.triangles)

    @property
    def is_watertight(self) -> bool:
        """Whether each edge has equally many triangles in both directions. Coincident points count as one."""
        return is_closed(self._joined())

    @property
    def components(self) -> int:
        """The number of parts connected through edges. Coincident points count as one."""
        return _number_of(labels_of_parts(self._joined()))

    def split(self) -> list[TriangleSurface]:
        """These parts, as separate surfaces with all arrays."""
        return _split(self, self.triangles, labels_of_parts(self._joined()))

    def _joined(self) -> NDArray[np.int64]:
        return joined_where_equal(self.points, self.triangles)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh, with all arrays."""
        return mesh_of(self, "triangle", self.triangles)

    def to_trimesh(self) -> Any:
        """The same as a trimesh.Trimesh, without arrays."""
        return trimesh_of(self.points, self.triangles)

    def to_open3d(self) -> Any:
        """The same as an open3d.geometry.TriangleMesh, without arrays."""
        return open3d_of(self.points, self.triangles)

    def to_stl(self) -> Any:
        """The same as a mesh.Mesh of numpy-stl, with coordinates in single precision."""
        return stl_of(self.points, self.triangles)

    @property
    def tag_names(self) -> list[str]:
        """The names of the tags in the cell array BoundaryTag, if there are any."""
        return strings_of(self.GetFieldData().GetAbstractArray("BoundaryTagNames"))


class Tetrahedra(_Views, vtkUnstructuredGrid):
    """A vtkUnstructuredGrid of tetrahedra. Its arrays are views of VTK's memory, without copies."""

    @property
    def cells(self) -> NDArray[np.int64]:
        """The four points of each tetrahedron, positively oriented; all ten if they are quadratic."""
        return corners_of(self.GetCells(), 10 if self._is_quadratic() else 4)

    @property
    def volume(self) -> float:
        """The volume of all tetrahedra, in cubed units."""
        return volume_of_cells(self.points, self.cells)

    @property
    def boundary(self) -> TriangleSurface:
        """The faces of exactly one tetrahedron, oriented outward, without data. The boundary of a result has the
        input's attributes, too."""
        used, corners = np.unique(faces_of_one_cell(self.cells), return_inverse=True)
        surface = TriangleSurface()
        surface.SetPoints(points_as(self, self.points[used]))
        surface.SetPolys(make_cells(corners.reshape(-1, 3)))
        return surface

    @property
    def is_watertight(self) -> bool:
        """Whether the boundary is watertight: no face has more than two tetrahedra."""
        return self.boundary.is_watertight

    @property
    def components(self) -> int:
        """The number of parts connected through faces."""
        return _number_of(labels_of_parts(self.cells[:, :4]))

    def split(self) -> list[Tetrahedra]:
        """These parts, as separate solids with all arrays."""
        return _split(self, self.cells, labels_of_parts(self.cells[:, :4]))

    @property
    def w(self) -> NDArray[np.float64]:
        """The winding number of each tetrahedron."""
        return self.cell_arrays["w"]

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Whether each tetrahedron is inside."""
        return self.cell_arrays["Inside"].astype(bool)

    def to_meshio(self) -> Any:
        """The same as a meshio.Mesh, with all arrays. The meshio.Mesh of the whole result has the boundary and groups,
        too."""
        return mesh_of(self, self.kind(), self.cells)

    def kind(self) -> str:
        """Meshio's name of the cell type."""
        return "tetra10" if self._is_quadratic() else "tetra"

    def _is_quadratic(self) -> bool:
        return self.GetNumberOfCells() > 0 and self.GetCellType(0) == VTK_QUADRATIC_TETRA


class LayeredCells(_Views, vtkUnstructuredGrid):
    """A vtkUnstructuredGrid of tetrahedra, and of pyramids and prisms in boundary layers; in a plane of triangles, and of quads in layers.
    Its arrays are views."""

    @property
    def cells(self) -> dict[str, NDArray[np.int64]]:
        """The points of the cells of each type, in VTK's order: "tetra", "pyramid" and "wedge", in a plane "triangle" and "quad", as meshio
        calls them."""
        types = types_of_cells(self)
        nodes = vtk_to_numpy(self.GetCells().GetConnectivityArray())
        begins = vtk_to_numpy(self.GetCells().GetOffsetsArray())
        found = {name: begins[:-1][types == kind] for name, (kind, _) in _LAYERED_TYPES.items()}
        return {name: nodes[begin[:, None] + np.arange(_LAYERED_TYPES[name][1])].astype(np.int64) for name, begin in found.items() if len(begin)}

    @property
    def layer(self) -> NDArray[np.int64]:
        """The layer of each cell, from 1 at the wall; 0 behind."""
        return self.cell_arrays["Layer"]

    @property
    def volume(self) -> float:
        """In a plane the area. Raises `Error` in space."""
        if not is_flat(self):
            raise self._unfit("the boundary has the volume")
        quads = self.cells.get("quad", np.zeros((0, 4), np.int64))
        return area(self.points, np.concatenate([self.cells.get("triangle", quads[:, :3]), quads[:, :3], quads[:, [0, 2, 3]]]))

    @property
    def components(self) -> int:
        raise self._unfit("RegionId tells its parts")

    def split(self) -> list[LayeredCells]:
        raise self._unfit("RegionId tells its parts")

    def to_meshio(self) -> Any:
        raise self._unfit("write it as .vtu, .msh, .inp or .mesh")

    @staticmethod
    def _unfit(remedy: str) -> Error:
        return Error(f"a solid with boundary layers has prisms or quads, and this takes tetrahedra or triangles: {remedy}")


_LAYERED_TYPES = {"triangle": (VTK_TRIANGLE, 3), "quad": (VTK_QUAD, 4), "tetra": (VTK_TETRA, 4), "pyramid": (VTK_PYRAMID, 5), "wedge": (VTK_WEDGE, 6)}
"""VTK's types of their cells, and the number of points of each."""


class Triangles(_Views, vtkUnstructuredGrid):
    """A vtkUnstructuredGrid of triangles in a plane. Its arrays are views of VTK's memory, without copies."""

    @property
    def cells(self) -> NDArray[np.int64]:
        """The three points of each triangle, all in one direction."""
        return corners_of(self.GetCells(), 3)

    @property
    def volume(self) -> float:
        """The area."""
        return area(self.points, self.cells)

    @property
    def components(self) -> int:
        """The number of parts connected through edges."""
        return _number_of(labels_of_parts(self.cells))

    def split(self) -> list[Triangles]:
        """These parts, as separate data sets with all arrays."""
        return _split(self, self.cells, labels_of_parts(self.cells))

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
        """Meshio's name of the cell type."""
        return "triangle"


class Polylines(_Views, vtkPolyData):
    """A vtkPolyData of polylines. Its arrays are views of VTK's memory, without copies."""

    @property
    def lines(self) -> list[NDArray[np.int64]]:
        """The points of each polyline in sequence; a closed one repeats its first at its end."""
        lines = self.GetLines()
        if lines.GetNumberOfCells() == 0:
            return []
        offsets = vtk_to_numpy(lines.GetOffsetsArray())
        return np.split(vtk_to_numpy(lines.GetConnectivityArray()), offsets[1:-1])


def _number_of(labels: NDArray[np.int64]) -> int:
    return int(labels.max(initial=-1)) + 1


def _split(data: Any, cells: NDArray[np.int64], labels: NDArray[np.int64]) -> list[Any]:
    order = np.argsort(labels, kind="stable")
    begins = np.flatnonzero(np.diff(labels[order])) + 1
    return [part_of(data, cells, chosen) for chosen in np.split(order, begins) if len(chosen)]


def is_flat(grid: vtkUnstructuredGrid) -> bool:
    """Whether its cells are triangles and quads."""
    return bool(grid.GetNumberOfCells() > 0 and grid.GetCellType(0) in (VTK_TRIANGLE, VTK_QUAD))


def has_layers(grid: vtkUnstructuredGrid) -> bool:
    """Whether some of its cells are pyramids, prisms or quads."""
    return bool(grid.GetNumberOfCells() > 0 and np.isin(types_of_cells(grid), (VTK_PYRAMID, VTK_WEDGE, VTK_QUAD)).any())


def as_type(data_type: type[DataSet], data: vtkDataSet) -> DataSet:
    """The same data, not copied, as another of these types."""
    typed = data_type()
    typed.ShallowCopy(data)
    return typed


def _points_of(data: Union[vtkPolyData, vtkUnstructuredGrid]) -> NDArray[np.float64]:
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))


def corners_of(cells: vtkCellArray, size: int) -> NDArray[np.int64]:
    """The points of each cell, if all cells have the same number of points."""
    if cells.GetNumberOfConnectivityIds() != size * cells.GetNumberOfCells():
        raise Error(f"some cells have not {size} points: go through vtkTriangleFilter first")
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)


def _arrays_of(data: vtkDataSetAttributes) -> dict[str, NDArray]:
    arrays = [data.GetArray(index) for index in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in arrays if array is not None and array.GetName()}
