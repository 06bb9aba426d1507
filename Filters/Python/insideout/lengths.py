# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths in percent of the input's diagonal, and units of files."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Iterable, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPointSet, vtkPolyData, vtkUnstructuredGrid

from .errors import ArgumentError, brief

Length = Union[float, str]
"""A number in the unit of the input, or a share like "2%" of the diagonal of its bounding box."""

UNITS = {
    "um": Fraction(1, 10**6),
    "mm": Fraction(1, 1000),
    "cm": Fraction(1, 100),
    "m": Fraction(1),
    "km": Fraction(1000),
    "in": Fraction(254, 10000),
    "ft": Fraction(3048, 10000),
}
"""The command's units, in meters."""


def scale_between(unit: str, other: str) -> float:
    """The conversion factor between two units: 0.001 from mm to m."""
    return float(UNITS[unit] / UNITS[other])


def share_of(name: str, value: Any) -> Optional[float]:
    """The length as a share of the diagonal, 0.02 for "2%"; None for a number. Raises `ArgumentError` for other text."""
    if not isinstance(value, str):
        return None
    try:
        percent = float(value.strip().removesuffix("%")) if value.strip().endswith("%") else np.nan
    except ValueError:
        percent = np.nan
    if not 0 <= percent < np.inf:
        raise ArgumentError(f'{name} is {brief(value)}; it must be a number of at least 0, or percent of the diagonal, as "2%"')
    return percent / 100


def diagonal_of(all_data: Iterable[vtkPointSet]) -> float:
    """The diagonal of the box around the cells of some data sets, or around all points of those without cells; 0 of nothing."""
    boxes = [box for data in all_data if len(box := _points_in_use(data))]
    if not boxes:
        return 0.0
    low, high = np.min([box.min(axis=0) for box in boxes], axis=0), np.max([box.max(axis=0) for box in boxes], axis=0)
    return math.dist(low, high)


def _points_in_use(data: vtkPointSet) -> NDArray[np.float64]:
    """The finite points of cells. Filters report the others."""
    if data.GetNumberOfPoints() == 0:
        return np.empty((0, 3))
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float, copy=False)
    cells = [data.GetCells()] if isinstance(data, vtkUnstructuredGrid) else []
    if isinstance(data, vtkPolyData):
        cells = [data.GetPolys(), data.GetStrips(), data.GetLines()]
    ids = [vtk_to_numpy(some.GetConnectivityArray()) for some in cells if some.GetNumberOfCells() > 0]
    if ids:
        used = np.concatenate(ids)
        points = points[np.unique(used[(used >= 0) & (used < len(points))])]
    return points[np.isfinite(points).all(axis=1)]
