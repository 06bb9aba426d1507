# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves in a plane as tables of their points."""

from __future__ import annotations

import csv
import math
from typing import Sequence

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .pipeline import Error
from .serializing import vtk_array

CURVE = ".csv"

COLUMNS = ("x", "y", "z", "path")
"""z and path may be missing"""


def read_curve(path: str) -> vtkPolyData:
    """Read polylines from a .csv file with a line per point: x, y and optionally z and path. Consecutive points of one
    path are joined; without paths all points are one polyline. A first line may name the columns, in any order; without
    it they are x, y, z, path. Raises `Error` that names the file and the line.
    """
    try:
        with open(path, newline="", encoding="utf-8-sig", errors="surrogateescape") as file:
            rows = [(number, [cell.strip() for cell in row]) for number, row in enumerate(csv.reader(file), start=1) if row]
    except csv.Error as error:
        raise Error(f"{path}: {error}") from None
    names: Sequence[str] = COLUMNS
    if rows and not _is_number(rows[0][1][0]):
        names = [name.lower() for name in rows.pop(0)[1]]
        if not {"x", "y"} <= set(names):
            raise Error(f"{path}: the columns are {', '.join(names)}; there must be x and y")
    place = {name: names.index(name) for name in COLUMNS if name in names}
    points: list[tuple[float, ...]] = []
    paths: dict[str, list[int]] = {}
    for number, row in rows:
        cells = {name: row[column] for name, column in place.items() if column < len(row)}
        coordinates = [cells.get("x", ""), cells.get("y", ""), cells.get("z", "0")]
        if not all(map(_is_number, coordinates)):
            raise Error(f"{path}, line {number}: x, y and z are not numbers: {', '.join(row)}")
        paths.setdefault(cells.get("path", ""), []).append(len(points))
        points.append(tuple(map(float, coordinates)))
    lines = vtkCellArray()
    for members in paths.values():
        lines.InsertNextCell(len(members), members)
    held = vtkPoints()
    held.SetDataTypeToDouble()
    held.SetData(vtk_array(np.array(points, float).reshape(-1, 3)))
    curve = vtkPolyData()
    curve.SetPoints(held)
    curve.SetLines(lines)
    return curve


def _is_number(text: str) -> bool:
    try:
        return not math.isnan(float(text))
    except ValueError:
        return False
