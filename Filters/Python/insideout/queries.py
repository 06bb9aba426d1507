# SPDX-License-Identifier: GPL-3.0-or-later
"""`winding_number` and `inside`: where places are with respect to a surface, without meshing it."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy

from .data import AnyPoints, AnySurface, as_points, as_surface
from .options import Options, Orientation, describe_options, in_words_of_python
from .pipeline import Error, Progress, run
from .vtkFiltersInsideOut import vtkProbeWindingNumber


@describe_options
def winding_number(
    surface: AnySurface,
    points: AnyPoints,
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> NDArray[np.float64]:
    """How often a surface winds around each of some points.

    surface   what `insideout` takes for one: a vtkPolyData, a file's name, a pair (points, triangles) ...
    points    an array with three columns, or a VTK data set whose points are meant
    progress  called with the stage and the fraction that is done; what it raises stops the work

    {options}

    Returns an array of float64, one value per point: 1 inside a closed surface and 0 outside it, a
    fraction between near holes. It is right to rounding; the surface may be open and cross itself.
    Raises `Error` with one line that names what is wrong.
    """
    return winding_number_and_warnings(surface, points, Options.among(locals()), progress)[0]


def winding_number_and_warnings(
    surface: AnySurface, points: AnyPoints, options: Options, progress: Optional[Progress]
) -> tuple[NDArray[np.float64], list[str]]:
    """The same, and what is worth knowing about it, one line each."""
    probe = options.set_on(vtkProbeWindingNumber())
    probe.SetInputData(as_points(points))
    polygons, warnings = as_surface(surface, options.scale)
    probe.SetSurfaceData(polygons)
    warnings = warnings + in_words_of_python(run(probe, progress))
    return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("w")), warnings


def inside(
    surface: AnySurface,
    points: AnyPoints,
    *,
    threshold: float = 0.5,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> NDArray[np.bool_]:
    """Which of some points are inside a surface: those whose winding number is above a threshold.

    threshold  of the winding number, which is 1 inside and 0 outside a closed surface

    All else is as with `winding_number`. Returns an array of bool, one value per point.
    """
    if not np.isfinite(threshold):
        raise Error(f"threshold is {threshold}; it must be finite")
    w = winding_number(
        surface,
        points,
        scale=scale,
        orientation=orientation,
        merge_tolerance=merge_tolerance,
        count_duplicates=count_duplicates,
        progress=progress,
    )
    return w > threshold
