# SPDX-License-Identifier: GPL-3.0-or-later
"""`winding_number`, `inside`, `distance` and `voxels`: queries of points relative to a surface, without a mesh."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet

from .calling import for_users, tell
from .errors import Error, brief, finite
from .images import bounds_of, image_of, in_space, sizes_of, spacing_of, steps_between
from .inputs import AnyPoints, points_and_shape
from .lengths import Length
from .options import Options, Orientation, describe_options, in_words_of_python
from .pipeline import Progress, run
from .surfaces import AnySurface, as_surface
from .vtkFiltersInsideOut import vtkProbeWindingNumber

@for_users
@describe_options
def winding_number(
    surface: AnySurface,
    points: AnyPoints,
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> NDArray[np.float64]:
    """The winding number of a surface at points.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...
    points    one point (3,) or an array of them (..., 3); or a VTK data set whose points are meant
    progress  called with the stage and the fraction that is done; an exception that it raises stops the work

    {options}

    Returns an array of float64 with the shape (...), one value per point: 1 inside a closed surface and 0
    outside it, a fraction between near holes. It is right to rounding; the surface may be open and cross itself.
    Raises `Error` with one line that names the culprit.
    """
    return _ask_at(points, "w", surface, Options.among(locals()), progress)


@for_users
def winding_number_of_pieces(
    pieces: Sequence[AnySurface], points: AnyPoints, *, scale: float = 1, progress: Optional[Progress] = None
) -> NDArray[np.float64]:
    """The winding number, at points, of a surface that need not fit in memory: its pieces are read one after the other.

    pieces    the names of their files, or other surfaces; each is let go before the next is read
    points    one point (3,) or an array of them (..., 3); or a VTK data set whose points are meant
    scale     factor on the surface's coordinates
    progress  called with the stage and the fraction that is done; an exception that it raises stops the work

    Returns an array of float64 with the shape (...), one value per point: the winding number of all polygons together,
    as they are given: copies add up, and two-sided parts cancel. It does not depend on how the surface is cut, bit by
    bit where the point is not on it. Memory is that of the largest piece and of the open edges of all. Raises `Error`
    with one line that names the culprit.
    """
    if not isinstance(pieces, (list, tuple)):
        raise Error(f"pieces is of type {type(pieces).__name__}; it has to be a list of surfaces")
    if len(pieces) == 0:
        raise Error("pieces is empty; it has to be a list of surfaces, at least one")
    from .pieces import Pieces  # of a module of VTK that nothing else needs

    places, shape = points_and_shape(points)
    source = Pieces(pieces, Options(scale=scale).factor())
    probe = Options(orientation="as-given", count_duplicates=True).set_on(vtkProbeWindingNumber())
    probe.SetSurfacePieces(max(len(pieces), 2))  # one alone would be the whole surface, with other counts of copies
    probe.SetInputData(places)
    probe.SetSurfaceConnection(source.GetOutputPort())
    try:
        warnings = run(probe, progress)
    finally:
        if source.failure is not None:
            raise source.failure
    tell(source.warnings + in_words_of_python(warnings))
    values: NDArray[Any] = Answer(probe, []).array("w").reshape(shape)[()]
    return values


def _ask_at(
    points: AnyPoints, name: str, surface: AnySurface, options: Options, progress: Optional[Progress], **properties: Any
) -> NDArray[Any]:
    """An array of the answer, in the shape of the points."""
    places, shape = points_and_shape(points)
    answer = ask(surface, places, options, progress, **properties)
    tell(answer.warnings)
    values: NDArray[Any] = answer.array(name).reshape(shape)[()]  # a number for a single point
    return values


@dataclass(frozen=True)
class Answer:
    """The answers of a probe, and warnings about them, one line each."""

    probe: vtkProbeWindingNumber
    warnings: list[str]

    def array(self, name: str) -> NDArray[Any]:
        return vtk_to_numpy(self.probe.GetOutput().GetPointData().GetArray(name))


def ask(
    surface: AnySurface, places: vtkDataSet, options: Options, progress: Optional[Progress], **properties: Any
) -> Answer:
    """Probe at the points of a data set; `properties` are further properties of vtkProbeWindingNumber."""
    polygons, warnings = as_surface(surface, options.factor())
    probe = options.measured_on(polygons).set_on(vtkProbeWindingNumber())
    for name, value in properties.items():
        getattr(probe, "Set" + name)(value)
    probe.SetInputData(places)
    probe.SetSurfaceData(polygons)
    return Answer(probe, warnings + in_words_of_python(run(probe, progress)))


@for_users
@describe_options
def distance(
    surface: AnySurface,
    points: AnyPoints,
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> NDArray[np.float64]:
    """The signed distance of points to a surface; negative inside, where the winding number is above 1/2.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...
    points    one point (3,) or an array of them (..., 3); or a VTK data set whose points are meant
    progress  called with the stage and the fraction that is done; an exception that it raises stops the work

    {options}

    Returns an array of float64 with the shape (...), one value per point, in the surface's units: NaN where a point is
    not finite. Inner walls of overlapping parts count, too; `sdf_grid` can give the distance to the solid instead. The
    sign is right also where the surface is open or crosses itself. Raises `Error` with one line that names the culprit.
    """
    return _ask_at(points, "Distance", surface, Options.among(locals()), progress, Distance=True)


@for_users
@describe_options
def voxels(
    surface: AnySurface,
    spacing: Union[float, Sequence[float]],
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """The voxels whose centers are inside a surface, as an array, and the position of the first.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...
    spacing   distance between neighboring voxels, above 0, in the surface's units: one number, or one for each axis
    progress  called with the stage and the fraction that is done; an exception that it raises stops the work

    {options}

    Returns (inside, origin): an array of bool with the indices of x, y and z, and the center of inside[0, 0, 0]. The
    center of inside[i, j, k] is origin + spacing * (i, j, k). The voxels cover the bounding box of the surface. Raises
    `Error` with one line that names the culprit.
    """
    steps = spacing_of(spacing)
    options = Options.among(locals())
    polygons, warnings = as_surface(surface, options.factor())
    low, high = bounds_of(polygons)
    sizes = sizes_of(np.maximum(np.ceil(steps_between(low, high, steps)), 1), f"spacing is {brief(spacing)}")
    origin = low / 2 + high / 2 - steps * (sizes - 1) / 2
    answer = ask(polygons, image_of(sizes, origin, steps), replace(options, scale=None), progress, OutputWindingNumber=False)
    tell(warnings + answer.warnings)
    return in_space(answer.array("Inside").view(np.bool_), sizes), origin


@for_users
def inside(
    surface: AnySurface,
    points: AnyPoints,
    *,
    threshold: float = 0.5,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> NDArray[np.bool_]:
    """Which points are inside a surface: those with a winding number above a threshold.

    threshold  of the winding number, which is 1 inside and 0 outside a closed surface

    The other arguments are those of `winding_number`. Returns an array of bool with the shape (...), one value per
    point.
    """
    least = finite("threshold", threshold)
    w = winding_number(
        surface,
        points,
        scale=scale,
        orientation=orientation,
        merge_tolerance=merge_tolerance,
        count_duplicates=count_duplicates,
        progress=progress,
    )
    inside: NDArray[np.bool_] = w > least
    return inside
