# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface for files of objects: triangles by their groups."""

from __future__ import annotations

import sys
from typing import Optional

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..errors import Error
from ..pipeline import plain_polygons, strings_of

_GROUPINGS = (("BoundaryTag", "BoundaryTagNames"), ("GroupIds", "GroupNames"))
"""Arrays of numbers and of their names: the first that is there counts, as for OBJ files."""

_ALONE = "surface"
"""How all triangles are called where no names tell them apart."""

_LARGEST_FLOAT = float(np.finfo(np.float32).max)


class Groups:
    """The points in use, the triangles, and for each triangle which of some names it has."""

    def __init__(self, surface: vtkPolyData, kind: str, in_floats: bool = False):
        """Raises `Error`, without a file's name, for what a file of this kind cannot hold."""
        plain, self.warnings = plain_polygons(surface, in_floats)
        triangles = _triangles_of(plain, kind)
        points = vtk_to_numpy(plain.GetPoints().GetData()) if len(triangles) else np.zeros((0, 3))
        used, ids = np.unique(triangles, return_inverse=True)
        self.points: NDArray[np.float64] = points[used].astype(float)
        self.triangles: NDArray[np.int64] = ids.reshape(-1, 3)
        _check(self.points, used, kind, _LARGEST_FLOAT if in_floats else sys.float_info.max)
        numbers, names = _grouping(plain)
        chosen, self.group_of = np.unique(
            np.zeros(len(triangles), int) if numbers is None else numbers, return_inverse=True
        )
        self.names = [names[k] if 0 <= k < len(names) and names[k] else str(k) for k in map(int, chosen)]

    def triangles_of_groups(self) -> list[NDArray[np.int64]]:
        return [self.triangles[self.group_of == k] for k in range(len(self.names))]


def _triangles_of(plain: vtkPolyData, kind: str) -> NDArray[np.int64]:
    cells = plain.GetPolys()
    sizes = np.diff(vtk_to_numpy(cells.GetOffsetsArray()))
    others = np.flatnonzero(sizes != 3)
    if len(others):
        raise Error(f"polygon {others[0]} has {sizes[others[0]]} corners, but {kind} holds triangles only")
    triangles: NDArray[np.int64] = vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)
    return triangles


def _check(points: NDArray[np.float64], ids: NDArray[np.int64], kind: str, largest: float) -> None:
    sizes = np.abs(points).max(axis=1, initial=0)
    bad = np.flatnonzero(~(sizes <= largest))
    if len(bad):
        why = (
            f"is beyond the floats that {kind} holds"
            if np.isfinite(sizes[bad[0]])
            else f"is not finite, which {kind} cannot say"
        )
        raise Error(f"point {ids[bad[0]]} {why}")


def _grouping(plain: vtkPolyData) -> tuple[Optional[NDArray], list[str]]:
    for ids, names in _GROUPINGS:
        array, strings = plain.GetCellData().GetArray(ids), strings_of(plain.GetFieldData().GetAbstractArray(names))
        if array is not None and array.GetNumberOfComponents() == 1 and strings:
            return vtk_to_numpy(array), strings
    return None, [_ALONE]
