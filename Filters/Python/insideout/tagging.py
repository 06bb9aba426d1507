# SPDX-License-Identifier: GPL-3.0-or-later
"""Tags by functions of centers and normals: their values become cell arrays of the surface, which rules name."""

from __future__ import annotations

from dataclasses import replace
from typing import Mapping

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from .errors import ArgumentError, brief
from .options import Options
from .pipeline import Error
from .serializing import vtk_array

_PREFIX = "InsideOutTag_"
"""The prefix of the arrays' names: no output keeps arrays with it."""


def with_functions_as_arrays(surface: vtkPolyData, options: Options) -> tuple[vtkPolyData, Options]:
    """The surface with an array for each function among the rules, and rules that name these."""
    rules = options.tag_rules
    if not isinstance(rules, Mapping) or not any(callable(rule) for rule in rules.values()):
        return surface, options
    copy = vtkPolyData()
    copy.ShallowCopy(surface)
    centers, normals = _centers_and_normals(surface)
    first = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
    named: dict[str, str] = {}
    for number, (tag, rule) in enumerate(rules.items()):
        if not callable(rule):
            named[tag] = rule
            continue
        chosen = np.asarray(rule(centers, normals))
        if chosen.shape != (len(centers),) or chosen.dtype.kind not in "biu":
            wanted = f"{len(centers)} bools, one for each polygon"
            raise ArgumentError(f"the function of the tag {tag} gives {brief(chosen)}; it must give {wanted}")
        values = np.zeros(surface.GetNumberOfCells(), np.uint8)
        values[first:] = chosen != 0
        array = vtk_array(values)
        array.SetName(f"{_PREFIX}{number}")
        copy.GetCellData().AddArray(array)
        named[tag] = f"array {array.GetName()}"
    return copy, replace(options, tag_rules=named)


def without_arrays_of_functions(output: vtkDataObject) -> None:
    """Remove these arrays from an output."""
    data = output.GetCellData()
    for name in [data.GetArrayName(index) for index in range(data.GetNumberOfArrays())]:
        if name and name.startswith(_PREFIX):
            data.RemoveArray(name)


def _centers_and_normals(surface: vtkPolyData) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The mean of each polygon's corners and its unit normal, which is 0 where it has no area."""
    if surface.GetNumberOfStrips() > 0:
        raise Error("functions of tags take polygons, and the surface has strips: go through vtkTriangleFilter first")
    polygons = surface.GetPolys()
    if polygons.GetNumberOfCells() == 0:
        return np.empty((0, 3)), np.empty((0, 3))
    corners, offsets = (vtk_to_numpy(some) for some in (polygons.GetConnectivityArray(), polygons.GetOffsetsArray()))
    counts = np.diff(offsets)
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    if (counts < 3).any() or corners.min() < 0 or corners.max() >= len(places):
        raise Error("functions of tags take polygons of three corners or more, which the points have")
    starts = offsets[:-1]
    following = np.arange(len(corners)) + 1
    following[offsets[1:] - 1] = starts
    at = places[corners]
    centers = np.add.reduceat(at, starts) / counts[:, None]
    from_center = at - np.repeat(centers, counts, axis=0)
    areas = np.add.reduceat(np.cross(from_center, from_center[following]), starts)
    lengths = np.linalg.norm(areas, axis=1, keepdims=True)
    return centers, np.divide(areas, lengths, out=np.zeros_like(areas), where=lengths > 0)
