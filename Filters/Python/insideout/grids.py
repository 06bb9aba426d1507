# SPDX-License-Identifier: GPL-3.0-or-later
"""`sdf_grid`: signed distances on a regular grid, for machine learning."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, Optional, Sequence, Union, get_args

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .calling import for_users
from .errors import Error, at_least, brief, one_of
from .images import Vector, bounds_of, image_of, in_space, sizes_of, spacing_of, steps_between, three_of
from .lengths import Length
from .options import Options, Orientation, describe_options
from .pipeline import Progress
from .pixels import picture_of_slice
from .queries import ask
from .results import Result, counted
from .surfaces import AnySurface, as_surface
from .tetrahedralization import tetrahedralize

DistanceTo = Literal["solid", "surface"]

PADDING = 0.1
"""Padding around the surface, as a share of its longest side."""

ROUNDING = 1e-12
"""Relative excess of the box over a whole number of steps that needs no further point."""


@dataclass(frozen=True, repr=False, eq=False)
class DistanceGrid(Result):
    """The result of `sdf_grid`: values at the points origin + spacing * (i, j, k)."""

    distance: NDArray[np.float64]
    """The signed distance of each point, negative inside, in the surface's units, by the indices of x, y and z."""
    inside: NDArray[np.bool_]
    """Which points are inside, by the same indices."""
    origin: Vector
    """The position of distance[0, 0, 0]."""
    spacing: Vector
    """The distance between neighboring points, by axis."""
    to: DistanceTo
    """The surface from which the distance is measured."""
    warnings: list[str]
    """Warnings about the input, one line each."""

    def figures(self) -> list[tuple[str, str]]:
        return [
            ("points", " x ".join(map(counted, self.distance.shape))),
            ("spacing", ", ".join(f"{step:.6g}" for step in dict.fromkeys(self.spacing.tolist()))),
            ("origin", ", ".join(f"{x:.6g}" for x in self.origin)),
            (f"distance to the {self.to}", f"{self.distance.min():.6g} to {self.distance.max():.6g}"),
            ("inside", counted(int(self.inside.sum()))),
            *(("", warning) for warning in self.warnings),
        ]

    def png(self) -> bytes:
        """A picture of the middle slice across z: blue inside, red outside."""
        return picture_of_slice(self.distance[:, :, self.distance.shape[2] // 2])


@for_users
@describe_options
def sdf_grid(
    surface: AnySurface,
    *,
    shape: Union[int, Sequence[int], None] = None,
    spacing: Union[float, Sequence[float], None] = None,
    padding: Optional[float] = None,
    to: DistanceTo = "solid",
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> DistanceGrid:
    """Signed distances, negative inside, and which points are inside, on a regular grid around a surface.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...
    shape     the number of points along each axis: one number, or three. The grid is centered in the padded box of the
              surface, with the smallest spacing, the same along all axes, that covers it
    spacing   the distance between neighboring points, instead of shape: above 0, in the surface's units, one number or
              three
    padding   width around the surface's box, in the surface's units; by default a tenth of its longest side
    to        "solid": the distance to the boundary of the solid that `tetrahedralize` makes of the surface. It has no
              inner walls, as overlapping parts have, and its holes are closed. Values of two points differ by at most
              their distance. "surface": the distance to the nearest triangle of the given surface, inner walls
              included; the sign is that of 1/2 - w, and may change in an open hole
    progress  called with the stage and the fraction that is done; an exception that it raises stops the work

    {options}

    Returns a `DistanceGrid`, which `write` writes as .npz, .nrrd or .vti. Raises `Error` with one line that names the
    culprit. For further options of the solid, give the boundary that `tetrahedralize` made with them.
    """
    one_of(get_args(DistanceTo), "to", to)
    if (shape is None) == (spacing is None):
        raise Error("sdf_grid takes either shape or spacing")
    options = Options.among(locals())
    polygons, warnings = as_surface(surface, options.factor())
    options = replace(options, scale=None)
    if to == "solid":
        polygons, more = _boundary_of(polygons, options, _share(progress, 0))
        warnings, options = warnings + more, Options(orientation="as-given")
    low, high = _padded(polygons, padding)
    sizes, steps = _fitted(low, high, shape, spacing)
    origin = low / 2 + high / 2 - steps * (sizes - 1) / 2
    asked = _share(progress, 0.5) if to == "solid" else progress
    answer = ask(polygons, image_of(sizes, origin, steps), options, asked, OutputWindingNumber=False, Distance=True)
    return DistanceGrid(
        distance=in_space(answer.array("Distance"), sizes),
        inside=in_space(answer.array("Inside").view(np.bool_), sizes),
        origin=origin,
        spacing=np.array(steps),
        to=to,
        warnings=warnings + answer.warnings,
    )


def _boundary_of(polygons: vtkPolyData, options: Options, progress: Optional[Progress]) -> tuple[vtkPolyData, list[str]]:
    """The boundary of the solid, and warnings."""
    made = tetrahedralize(
        polygons,
        orientation=options.orientation,
        merge_tolerance=options.merge_tolerance,
        count_duplicates=options.count_duplicates,
        surface_only=True,
        progress=progress,
    )
    if made.is_planar():
        raise Error("the surface lies in a plane, where it bounds no solid to be distant from")
    if made.boundary.GetNumberOfCells() == 0:
        raise Error("nothing is inside: there is no solid to be distant from")
    return made.boundary, made.warnings


def _share(progress: Optional[Progress], begin: float) -> Optional[Progress]:
    """The progress of half of the work."""
    if progress is None:
        return None
    whole = progress
    return lambda stage, fraction: whole(stage, begin + fraction / 2)


def _padded(polygons: vtkPolyData, padding: Optional[float]) -> tuple[Vector, Vector]:
    low, high = bounds_of(polygons)
    with np.errstate(over="ignore"):
        around = PADDING * (high - low).max() if padding is None else at_least(0, "padding", padding)
        if not np.isfinite(high - low + 2 * around).all():
            raise Error("the box around the surface, and the padding, is larger than doubles can say")
    return low - around, high + around


def _fitted(low: Vector, high: Vector, shape: object, spacing: object) -> tuple[NDArray[np.int64], Vector]:
    """The number of points that cover a box, and their spacing."""
    if spacing is not None:
        steps = spacing_of(spacing)
        return sizes_of(np.ceil(steps_between(low, high, steps) * (1 - ROUNDING)) + 1, f"spacing is {brief(spacing)}"), steps
    counts = np.array([at_least(2, "shape", count) for count in three_of("shape", shape)])
    if (counts != np.floor(counts)).any():
        raise Error(f"shape is {brief(shape)}; it must be whole numbers")
    step = steps_between(low, high, counts - 1).max()
    if not step > 0:
        raise Error("the surface's box is one point: there is nothing to make a grid around")
    return sizes_of(counts, f"shape is {brief(shape)}"), np.full(3, step)
