# SPDX-License-Identifier: GPL-3.0-or-later
"""Images around surfaces: their number of points and positions; and arrays with an index for each axis."""

from __future__ import annotations

from typing import Any, Tuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from .errors import Error, at_least, brief

MOST_POINTS = 2**34
"""16 GiB of bytes, and fewer than VTK counts."""

Vector = NDArray[np.float64]


def three_of(name: str, values: Any) -> list[Any]:
    """One value for each axis, from one or three values."""
    try:
        given = np.ravel(np.asarray(values, object)).tolist()
    except Exception:  # noqa: BLE001 - whatever an object's __array__ raises
        given = [values]
    if len(given) not in (1, 3):
        raise Error(f"{name} has {len(given)} numbers; it must have one, or three")
    return given if len(given) == 3 else given * 3


def spacing_of(spacing: Any) -> Vector:
    """The spacing by axis. Raises `Error` unless it is above 0."""
    steps = np.array([at_least(0, "spacing", step) for step in three_of("spacing", spacing)])
    if not steps.min() > 0:
        raise Error(f"spacing is {brief(spacing)}; it must be above 0")
    return steps


def bounds_of(surface: vtkPolyData) -> Tuple[Vector, Vector]:
    """The lowest and the highest coordinates of a surface's points."""
    if surface.GetNumberOfPoints() == 0:
        raise Error("the surface has no points")
    low, high = np.array(surface.GetPoints().GetBounds()).reshape(3, 2).T
    if not np.isfinite([low, high]).all():
        raise Error("the surface has a point that is not finite")
    return low, high


def steps_between(low: Vector, high: Vector, steps: NDArray[Any]) -> Vector:
    """The number of steps along each axis, as a fraction; infinity beyond doubles."""
    with np.errstate(over="ignore"):
        between: Vector = (high - low) / steps
    return between


def sizes_of(sizes: Vector, reason: str) -> NDArray[np.int64]:
    """The number of points along each axis. Raises `Error` with the reason if there are too many."""
    with np.errstate(over="ignore"):
        number = sizes.prod()
    if not number < MOST_POINTS:
        raise Error(f"{reason}, which makes {number:.3g} points; at most {MOST_POINTS:.3g} are made")
    return sizes.astype(np.int64)


def image_of(sizes: NDArray[np.int64], origin: Vector, spacing: Vector) -> vtkImageData:
    image = vtkImageData()
    image.SetDimensions(*sizes.tolist())
    image.SetOrigin(*origin.tolist())
    image.SetSpacing(*spacing.tolist())
    return image


def in_space(values: NDArray[Any], sizes: NDArray[np.int64]) -> NDArray[Any]:
    """Values per point, x running fastest, as an array with the indices of x, y and z."""
    return values.reshape(sizes[::-1].tolist()).transpose()
