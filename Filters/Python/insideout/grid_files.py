# SPDX-License-Identifier: GPL-3.0-or-later
"""Grids of distances as files of numpy, of medical images and of VTK."""

from __future__ import annotations

import io
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .files import check_output, ending
from .grids import DistanceGrid
from .images import image_of
from .pipeline import write_bytes, write_data
from .serializing import vtk_array

WRITABLE_DISTANCES = (".npz", ".nrrd", ".vti")


def write_distances(grid: DistanceGrid, path: str) -> None:
    """Write a grid of distances. Raises `Error` that names the file."""
    check_output(path, WRITABLE_DISTANCES)
    if ending(path) == ".npz":
        write_bytes(_npz(grid), path)
    elif ending(path) == ".nrrd":
        write_bytes(_nrrd(grid), path)
    else:
        image = image_of(np.array(grid.distance.shape), grid.origin, grid.spacing)
        arrays: dict[str, NDArray[Any]] = {"Distance": grid.distance, "Inside": grid.inside.view(np.uint8)}
        for name, values in arrays.items():
            array = vtk_array(values.ravel(order="F"))
            array.SetName(name)
            image.GetPointData().AddArray(array)
        image.GetPointData().SetActiveScalars("Distance")
        write_data(image, path)


def _npz(grid: DistanceGrid) -> bytes:
    file = io.BytesIO()
    np.savez_compressed(file, distance=grid.distance, inside=grid.inside, origin=grid.origin, spacing=grid.spacing, to=np.array(grid.to))
    return file.getvalue()


def _nrrd(grid: DistanceGrid) -> bytes:
    """A header of fields, an empty line, and the numbers, x running fastest. VTK's own reader ignores the header and
    takes fewer than ten numbers along x for components of vectors.
    """
    vectors = (f"({','.join(repr(float(x)) for x in row)})" for row in np.diag(grid.spacing))
    header = [
        "NRRD0004",
        f"content: signed distance to the {grid.to}, negative inside",
        "type: double",
        "dimension: 3",
        "space dimension: 3",
        f"sizes: {' '.join(map(str, grid.distance.shape))}",
        f"space directions: {' '.join(vectors)}",
        "kinds: domain domain domain",
        f"endian: {sys.byteorder}",
        "encoding: raw",
        f"space origin: ({','.join(repr(float(x)) for x in grid.origin)})",
    ]
    return "\n".join([*header, "", ""]).encode("ascii") + grid.distance.tobytes(order="F")
