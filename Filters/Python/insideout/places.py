# SPDX-License-Identifier: GPL-3.0-or-later
"""Places at which a winding number is wanted, as files: tables of coordinates and images."""

from __future__ import annotations

import csv
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkDataSet
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

from .data import as_points
from .files import FASTEST_COMPRESSION, check_input, check_xml, ending
from .pipeline import Error, run

QUERIES = (".csv", ".vti")


class Places(Protocol):
    """Places that were read, which can be written again with what was found there."""

    data: vtkDataSet
    """Its points are the places."""

    def write(self, w: NDArray[np.float64], path: str) -> None:
        """Write the places with their winding numbers w, and 1 for those inside, where w is above 1/2."""


def read_places(path: str) -> Places:
    """The places in a .csv or .vti file. Raises `Error` that names the file, and the line in a table."""
    check_input(path, QUERIES)
    if ending(path) == ".csv":
        return _Table(path)
    return _Image(path)


def read_seeds(path: str) -> list[tuple[tuple[float, float, float], bool]]:
    """Points that have to be inside or outside, from a .csv file whose fourth column says which, by 1 or 0."""
    check_input(path, (".csv",))
    table = _Table(path)
    seeds = []
    for row in table.rows:
        if len(row) < 4 or row[3].strip() not in ("0", "1"):
            raise Error(f"{path}: a seed is x, y, z and 1 (inside) or 0 (outside), not {', '.join(row)}")
        seeds.append(((float(row[0]), float(row[1]), float(row[2])), row[3].strip() == "1"))
    return seeds


class _Table:
    """A line of names that begins with x, y, z, or none, then a line of numbers for each place; further columns are kept."""

    def __init__(self, path: str):
        with open(path, newline="", encoding="utf-8-sig", errors="replace") as file:
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

    def write(self, w: NDArray[np.float64], path: str) -> None:
        with open(path, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow([*self.names, "w", "inside"])
            for row, value in zip(self.rows, w.tolist()):
                writer.writerow([*row, repr(value), int(value > 0.5)])


class _Image:
    """VTK's XML format of images."""

    def __init__(self, path: str):
        check_xml(path, "ImageData", "an image")
        reader = vtkXMLImageDataReader()
        reader.SetFileName(path)
        run(reader)
        self.data: vtkDataSet = reader.GetOutput()

    def write(self, w: NDArray[np.float64], path: str) -> None:
        for name, values in (("w", w), ("Inside", (w > 0.5).astype(np.uint8))):
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            self.data.GetPointData().AddArray(array)
        writer = vtkXMLImageDataWriter()
        writer.SetDataModeToBinary()
        writer.SetCompressionLevel(FASTEST_COMPRESSION)
        writer.SetFileName(path)
        writer.SetInputData(self.data)
        run(writer)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
