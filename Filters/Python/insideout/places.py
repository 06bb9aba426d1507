# SPDX-License-Identifier: GPL-3.0-or-later
"""Query points of winding numbers as files: tables of coordinates and images."""

from __future__ import annotations

import csv
import io
from typing import Optional, Protocol

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkDataSet
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from .files import check_input, check_xml, ending
from .inputs import as_points
from .pipeline import Error, run, write_bytes, write_data

QUERIES = (".csv", ".vti")

FOUND = ("w", "inside", "distance")
"""New columns of a table, the last on request; existing columns of these names (upper or lower case) get new values."""


class Places(Protocol):
    """Query points that were read, and can be written again with results."""

    data: vtkDataSet
    """The query points."""

    def write(self, w: NDArray[np.float64], path: str, distance: Optional[NDArray[np.float64]] = None) -> None:
        """Write the query points with their winding numbers w, 1 for those inside (w above 1/2), and their
        distances."""


def read_places(path: str) -> Places:
    """Read the query points in a .csv or .vti file. Raises `Error` that names the file, and the line in a table."""
    check_input(path, QUERIES)
    if ending(path) == ".csv":
        return _Table(path)
    return _Image(path)


def read_seeds(path: str) -> list[tuple[tuple[float, float, float], bool, str]]:
    """Read seeds from a .csv file: points, and 1 (inside) or 0 (outside) in the fourth column. A fifth column, if it is
    called body or has no name, is the seed's body.
    """
    check_input(path, (".csv",))
    table = _Table(path)
    has_bodies = len(table.names) < 5 or table.names[4].strip().lower() == "body"
    seeds = []
    for row in table.rows:
        if len(row) < 4 or row[3].strip() not in ("0", "1"):
            raise Error(f"{path}: a seed is x, y, z and 1 (inside) or 0 (outside), not {', '.join(row)}")
        seeds.append(((float(row[0]), float(row[1]), float(row[2])), row[3].strip() == "1", row[4].strip() if has_bodies and len(row) > 4 else ""))
    return seeds


class _Table:
    """A table with an optional line of names that begin with x, y, z, then a line of numbers per query point. Further
    columns are kept unchanged, except for those named w, inside and, if requested, distance, which get the new values.
    """

    def __init__(self, path: str):
        with open(path, newline="", encoding="utf-8-sig", errors="surrogateescape") as file:
            numbered = [(number, row) for number, row in enumerate(csv.reader(file), start=1) if row]
        self.rows = [row for _, row in numbered]
        self.names = ["x", "y", "z"]
        if self.rows and not _is_number(self.rows[0][0]):
            self.names = self.rows[0]
            columns = [name.strip().lower() for name in self.names]
            if columns[:3] != ["x", "y", "z"]:
                raise Error(f"{path}: the first three columns are {', '.join(self.names[:3])}; they must be x, y, z")
            del self.rows[0], numbered[0]
        for number, row in numbered:
            if len(row) < 3 or not all(map(_is_number, row[:3])):
                raise Error(f"{path}, line {number}: it does not begin with three numbers")
        self.data: vtkDataSet = as_points(np.array([row[:3] for row in self.rows], float).reshape(-1, 3))

    def write(self, w: NDArray[np.float64], path: str, distance: Optional[NDArray[np.float64]] = None) -> None:
        columns = [w.tolist(), (w > 0.5).astype(int).tolist()] + ([] if distance is None else [distance.tolist()])
        wanted = FOUND[: len(columns)]
        given = [name.strip().lower() for name in self.names]
        nameless = [""] * (max(map(len, [self.names, *self.rows])) - len(self.names))
        names = [*self.names, *nameless, *(name for name in wanted if name not in given)]
        text = io.StringIO(newline="")
        writer = csv.writer(text)
        writer.writerow(names)
        for row, *values in zip(self.rows, *columns):
            found = dict(zip(wanted, map(repr, values)))
            kept = dict(enumerate(row))
            writer.writerow(found.get(name.strip().lower(), kept.get(column, "")) for column, name in enumerate(names))
        write_bytes(text.getvalue().encode(errors="surrogateescape"), path)


class _Image:
    """VTK's XML format of images."""

    def __init__(self, path: str):
        check_xml(path, "ImageData", "an image")
        reader = vtkXMLImageDataReader()
        reader.SetFileName(path)
        run(reader)
        self.data: vtkDataSet = reader.GetOutput()

    def write(self, w: NDArray[np.float64], path: str, distance: Optional[NDArray[np.float64]] = None) -> None:
        arrays = [("w", w), ("Inside", (w > 0.5).astype(np.uint8))]
        for name, values in arrays if distance is None else [*arrays, ("Distance", distance)]:
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            self.data.GetPointData().AddArray(array)
        write_data(self.data, path)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
