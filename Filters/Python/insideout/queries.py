# SPDX-License-Identifier: GPL-3.0-or-later
"""`winding_number`, `inside`, `distance` and `voxels`: where places are with respect to a surface, without meshing it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData

from .inputs import AnyPoints, as_points
from .options import Options, Orientation, describe_options, in_words_of_python
from .pipeline import Error, Progress, at_least, run
from .surfaces import AnySurface, as_surface
from .vtkFiltersInsideOut import vtkProbeWindingNumber

MOST_VOXELS = 2**34
"""16 GiB of them, and fewer than VTK counts."""


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
    return ask(surface, as_points(points), Options.among(locals()), progress).array("w")


@dataclass(frozen=True)
class Answer:
    """What a probe says, and what is worth knowing about it, one line each."""

    probe: vtkProbeWindingNumber
    warnings: list[str]

    def array(self, name: str) -> NDArray[Any]:
        return vtk_to_numpy(self.probe.GetOutput().GetPointData().GetArray(name))


def ask(
    surface: AnySurface, places: vtkDataSet, options: Options, progress: Optional[Progress], **properties: Any
) -> Answer:
    """Of the points of a data set; `properties` are further ones of vtkProbeWindingNumber."""
    probe = options.set_on(vtkProbeWindingNumber())
    for name, value in properties.items():
        getattr(probe, "Set" + name)(value)
    probe.SetInputData(places)
    polygons, warnings = as_surface(surface, options.scale)
    probe.SetSurfaceData(polygons)
    return Answer(probe, warnings + in_words_of_python(run(probe, progress)))


@describe_options
def distance(
    surface: AnySurface,
    points: AnyPoints,
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> NDArray[np.float64]:
    """How far each of some points is from a surface; negative inside, where the winding number is above 1/2.

    surface   what `insideout` takes for one: a vtkPolyData, a file's name, a pair (points, triangles) ...
    points    an array with three columns, or a VTK data set whose points are meant
    progress  called with the stage and the fraction that is done; what it raises stops the work

    {options}

    Returns an array of float64, one value per point, in the surface's units: NaN where a point is not finite.
    The sign is right where the surface is open and crosses itself, too. Raises `Error` with one line that
    names what is wrong.
    """
    return ask(surface, as_points(points), Options.among(locals()), progress, Distance=True).array("Distance")


@describe_options
def voxels(
    surface: AnySurface,
    spacing: Union[float, Sequence[float]],
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """The voxels whose centres are inside a surface, as an array, and where the first of them is.

    surface   what `insideout` takes for one: a vtkPolyData, a file's name, a pair (points, triangles) ...
    spacing   from one voxel to the next, above 0, in the surface's units: one number, or one for each axis
    progress  called with the stage and the fraction that is done; what it raises stops the work

    {options}

    Returns (inside, origin): an array of bool with an index for x, y and z each, and the centre of inside[0, 0, 0];
    that of inside[i, j, k] is origin + spacing * (i, j, k). The voxels cover the box around the surface, with
    nothing of it beyond them. Raises `Error` with one line that names what is wrong.
    """
    steps = np.array([at_least(0, "spacing", step) for step in np.ravel(np.asarray(spacing, object))])
    if len(steps) not in (1, 3):
        raise Error(f"spacing has {len(steps)} numbers; it must have one, or three")
    steps = np.broadcast_to(steps, 3)
    if not steps.min() > 0:
        raise Error(f"spacing is {spacing}; it must be above 0")
    options = Options.among(locals())
    polygons, _ = as_surface(surface, options.scale)
    if polygons.GetNumberOfPoints() == 0:
        raise Error("the surface has no points")
    low, high = np.array(polygons.GetPoints().GetBounds()).reshape(3, 2).T
    if not np.isfinite([low, high]).all():
        raise Error("the surface has a point that is not finite")
    sizes = np.maximum(np.ceil((high - low) / steps), 1)
    if not sizes.prod() < MOST_VOXELS:
        raise Error(f"spacing is {spacing}, which makes {sizes.prod():.3g} voxels; at most {MOST_VOXELS:.3g} are made")
    origin = low / 2 + high / 2 - steps * (sizes - 1) / 2
    image = vtkImageData()
    image.SetDimensions(*(int(size) for size in sizes))
    image.SetOrigin(origin)
    image.SetSpacing(steps)
    answer = ask(polygons, image, replace(options, scale=None), progress, OutputWindingNumber=False)
    found = answer.array("Inside").view(np.bool_).reshape([int(size) for size in sizes[::-1]])
    return found.transpose(), origin


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
