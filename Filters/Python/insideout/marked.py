# SPDX-License-Identifier: GPL-3.0-or-later
"""A checked surface with its marks: its facets, and the lines of its defects."""

from __future__ import annotations

from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import get_vtk_array_type, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from .checking import Check
from .files import Path, check_output
from .pipeline import write_data
from .serializing import vtk_array

MARKED_FILES = (".vtp",)


def with_lines(checked: Check) -> vtkPolyData:
    """The checked surface with its lines among its cells. Each cell has the arrays of surface and lines. In an array of
    the other the value is empty, -1 for ids and types, NaN for real numbers, and otherwise 0. The array DefectColor has
    the color of each cell.
    """
    facets, lines = (_copy_of(data) for data in (checked.surface, checked.lines))
    for one, other in ((facets, lines), (lines, facets)):
        for of_one, of_other, count in (
            (one.GetPointData(), other.GetPointData(), one.GetNumberOfPoints()),
            (one.GetCellData(), other.GetCellData(), one.GetNumberOfCells()),
        ):
            _fill(of_one, of_other, count)
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(append.DOUBLE_PRECISION)
    for data in (facets, lines):
        append.AddInputData(data)
    append.Update()
    joined = append.GetOutput()
    joined.SetFieldData(checked.surface.GetFieldData())
    return joined


def write_marked(checked: Check, path: Path) -> None:
    """Write the marked surface as .vtp. Raises `Error` that names the file."""
    check_output(path, MARKED_FILES)
    write_data(with_lines(checked), str(path))


def _copy_of(data: vtkPolyData) -> vtkPolyData:
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    return copy


def _fill(data: vtkDataSetAttributes, other: vtkDataSetAttributes, count: int) -> None:
    """Add the arrays that only the other data set has."""
    for k in range(other.GetNumberOfArrays()):
        array = other.GetAbstractArray(k)
        if data.GetAbstractArray(array.GetName()) is None:
            data.AddArray(_nothing_like(array, count))


def _nothing_like(array: vtkAbstractArray, count: int) -> vtkAbstractArray:
    name, components = array.GetName(), array.GetNumberOfComponents()
    empty: Any
    if isinstance(array, vtkStringArray):
        empty = vtkStringArray()
        empty.SetNumberOfComponents(components)
        empty.SetNumberOfTuples(count)
    else:
        kind = vtk_to_numpy(array).dtype
        is_id = name.endswith(("Id", "Ids", "Type")) and kind.kind == "i"
        value = np.nan if kind.kind == "f" else -1 if is_id else 0
        empty = vtk_array(np.full((count, components) if components > 1 else count, value, kind), array.GetDataType())
    empty.SetName(name)
    return empty
