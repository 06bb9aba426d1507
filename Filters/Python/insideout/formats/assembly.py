# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles of objects, each in its place, become one surface with groups."""

from __future__ import annotations

from collections import Counter
from typing import Hashable, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ..errors import Error
from ..serializing import vtk_array

BYTES_OF_POINT = 24
BYTES_OF_TRIANGLE = 32
BYTES_OF_PLACEMENT = 1000
"""Least memory of each item during assembly, including objects wherever they are placed."""

NO_MATERIAL = "default"
"""What OBJ calls it."""


class Assembly:
    """Takes the objects of a file one after the other. `most` is how many bytes they may take."""

    def __init__(self, most: float):
        self.notes: list[str] = []
        self.passed_over: Counter[str] = Counter()
        self._most = self._left = most
        self._points: list[NDArray[np.float64]] = [np.zeros((0, 3))]
        self._number_of_points = 0
        self._first_of: dict[Hashable, int] = {}
        self._triangles: list[NDArray[np.int64]] = [np.zeros((0, 3), np.int64)]
        self._objects: list[str] = []
        self._object_of: list[NDArray[np.int32]] = [np.zeros(0, np.int32)]
        self._materials: dict[Hashable, int] = {}
        self._material_names: list[str] = []
        self._material_of: list[NDArray[np.int32]] = [np.zeros(0, np.int32)]

    def begin_object(self, name: str) -> None:
        """Set the names of the next triangles."""
        self.charge(BYTES_OF_PLACEMENT)
        self._objects.append(_valid(name))

    def charge(self, count: int) -> None:
        """Raise `Error` where objects that are placed again and again take too many bytes."""
        self._left -= count
        if self._left < 0:
            raise Error(f"its objects, placed, take more than {self._most:.0f} bytes, too many for this machine")

    def material(self, key: Hashable = None, name: str = NO_MATERIAL) -> int:
        """The number of a material, which may have the name of another one."""
        if key not in self._materials:
            self._materials[key] = len(self._material_names)
            self._material_names.append(_valid(name))
        return self._materials[key]

    def add_points(self, key: Hashable, points: NDArray, matrix: NDArray[np.float64]) -> int:
        """Points where `matrix` (4 by 4) places them, once for each key and place. Returns the id of the first."""
        placement = (key, matrix.tobytes())
        if placement not in self._first_of:
            self.charge(BYTES_OF_POINT * len(points))
            placed = points.astype(float)
            if not np.array_equal(matrix, np.eye(4)):
                placed = placed @ matrix[:3, :3].T + matrix[:3, 3]
            self._first_of[placement] = self._number_of_points
            self._points.append(placed)
            self._number_of_points += len(points)
        return self._first_of[placement]

    def add_triangles(
        self, triangles: NDArray, first: int, matrix: NDArray[np.float64], material: Union[int, NDArray]
    ) -> None:
        """Triangles of the object, whose points begin at `first`; one material, or one for each."""
        self.charge(BYTES_OF_PLACEMENT + BYTES_OF_TRIANGLE * len(triangles))
        if np.linalg.det(matrix[:3, :3]) < 0:  # a mirror turns them over
            triangles = triangles[:, [0, 2, 1]]
        self._triangles.append(triangles.astype(np.int64) + first)
        self._object_of.append(np.full(len(triangles), len(self._objects) - 1, np.int32))
        self._material_of.append(np.full(len(triangles), material, np.int32))

    def surface(self) -> vtkPolyData:
        """All of them. GroupIds tells several objects apart, and MaterialIds several materials, as of OBJ files."""
        points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetDataTypeToDouble()
        points.SetData(vtk_array(np.concatenate(self._points)))
        cells.SetData(3, vtk_array(np.concatenate(self._triangles).ravel(), VTK_ID_TYPE))
        surface.SetPoints(points)
        surface.SetPolys(cells)
        _tell_apart(surface, "Group", np.concatenate(self._object_of), self._objects)
        _tell_apart(surface, "Material", np.concatenate(self._material_of), self._material_names)
        return surface

    def warnings(self) -> list[str]:
        """Remarks, and one line about all that was skipped."""
        counts = ", ".join(f"{count} {what}" for what, count in self.passed_over.items())
        return [*self.notes, *([f"skipped: {counts}"] if counts else [])]


def _tell_apart(surface: vtkPolyData, kind: str, numbers: NDArray[np.int32], names: list[str]) -> None:
    """Add the numbers, in the order of their first triangles, and their names, unless all are one."""
    used, first, ids = np.unique(numbers, return_index=True, return_inverse=True)
    if len(used) < 2:
        return
    order = np.argsort(first)
    array, strings = vtk_array(np.argsort(order)[ids].astype(np.int32)), vtkStringArray()
    array.SetName(kind + "Ids")
    surface.GetCellData().AddArray(array)
    strings.SetName(kind + "Names")
    for number in used[order]:
        strings.InsertNextValue(names[number])
    surface.GetFieldData().AddArray(strings)


def _valid(name: str) -> str:
    """As VTK can hold it: JSON may have halves of characters, and zeros."""
    return name.encode(errors="replace").decode().replace("\0", "?")
