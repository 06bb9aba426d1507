# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of surfaces and solids as data sets of their own."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData

from .pipeline import STATISTICS_NAMES
from .serializing import make_cells, vtk_array

NAMES = "Names"
"""The endings of field arrays to which numbers of cells refer."""


def part_of(data: Any, cells: NDArray[np.int64], chosen: NDArray[np.int64]) -> Any:
    """Some cells of a data set with one type of cell, with their points, all data and the names that these refer to."""
    used, corners = np.unique(cells[chosen], return_inverse=True)
    part = type(data)()
    part.SetPoints(points_as(data, data.points[used]))
    made = make_cells(corners.reshape(-1, cells.shape[1]))
    if isinstance(data, vtkPolyData):
        part.SetPolys(made)
    else:
        part.SetCells(data.GetCellType(0), made)
    _copy_some(data.GetPointData(), used, part.GetPointData())
    _copy_some(data.GetCellData(), chosen, part.GetCellData())
    fields = data.GetFieldData()
    for array in (fields.GetAbstractArray(index) for index in range(fields.GetNumberOfArrays())):
        if (array.GetName() or "").endswith(NAMES) and array.GetName() != STATISTICS_NAMES:
            part.GetFieldData().AddArray(array)
    return part


def points_as(data: Any, coordinates: NDArray) -> vtkPoints:
    """Points with the precision of a data set's points."""
    points = vtkPoints()
    if data.GetPoints() is not None:
        points.SetDataType(data.GetPoints().GetDataType())
    points.SetData(vtk_array(coordinates))
    return points


def _copy_some(given: vtkDataSetAttributes, chosen: NDArray[np.int64], made: vtkDataSetAttributes) -> None:
    ids = vtkIdList()
    ids.SetNumberOfIds(len(chosen))
    for place, one in enumerate(chosen.tolist()):
        ids.SetId(place, one)
    for array in (given.GetAbstractArray(index) for index in range(given.GetNumberOfArrays())):
        some = array.NewInstance()
        some.SetName(array.GetName())
        some.SetNumberOfComponents(array.GetNumberOfComponents())
        some.SetNumberOfTuples(len(chosen))
        array.GetTuples(ids, some)
        made.AddArray(some)
