# SPDX-License-Identifier: GPL-3.0-or-later
"""`resolve`: a surface cut where it crosses itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Union

from .calling import for_users
from .checking import check
from .data import Polylines, TriangleSurface, as_type
from .lengths import Length
from .options import Options, describe_options, in_words_of_python
from .pipeline import Progress, add_statistic, cells_of, run, statistics_of
from .results import MeshResult, counted
from .statistics import Statistics
from .surfaces import AnySurface, as_surface
from .vtkFiltersInsideOut import vtkResolveSelfIntersections, vtkRobustTriangulate


@dataclass(frozen=True, repr=False)
class Resolution(MeshResult):
    """The result of `resolve`. The VTK class vtkResolveSelfIntersections describes the arrays."""

    surface: Union[TriangleSurface, Polylines]
    """The same surface in triangles that meet only in shared points and edges; for lines, the same in lines."""
    statistics: Statistics
    """Counts and seconds, by name."""
    left_out_cells: list[int]
    """The cells of the surface with facets that could not be resolved; hardly ever any."""
    warnings: list[str]
    """Warnings about the input, one line each."""

    def figures(self) -> list[tuple[str, str]]:
        return [
            ("lines" if isinstance(self.surface, Polylines) else "triangles", counted(self.surface.GetNumberOfCells())),
            ("points", counted(self.surface.GetNumberOfPoints())),
            ("cells left out", counted(len(self.left_out_cells))),
            *(("", warning) for warning in self.warnings),
        ]

    def seen(self) -> dict[str, Any]:
        return check(self.surface).seen()


@for_users
@describe_options
def resolve(
    surface: AnySurface,
    *,
    scale: Optional[float] = None,
    merge_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> Resolution:
    """Cut a surface where it crosses itself, exactly. Nothing else changes.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...
    progress  called with the stage and the fraction of all the work that is done; an exception that it
              raises stops the work and is raised

    {options}

    Returns a `Resolution`. Raises `Error` with one line that names the culprit.
    """
    options = Options.among(locals())
    polygons, warnings = as_surface(surface, options.factor())
    options = options.measured_on(polygons)
    resolver: Any = options.set_on(vtkResolveSelfIntersections())
    are_lines = polygons.GetNumberOfPolys() + polygons.GetNumberOfStrips() == 0 < polygons.GetNumberOfLines()
    if are_lines:  # lines are cut by the filter for triangles, whatever region they enclose
        resolver = options.set_on(vtkRobustTriangulate())
        resolver.SetOrientation(resolver.AS_GIVEN)
        resolver.GenerateHullOn()
    resolver.SetInputData(polygons)
    told = in_words_of_python(run(resolver, progress))
    resolved = resolver.GetOutputDataObject(4 if are_lines else 0)
    add_statistic("Scale", options.factor(), resolved)
    return Resolution(
        surface=as_type(Polylines if are_lines else TriangleSurface, resolved),
        statistics=statistics_of(resolved),
        left_out_cells=cells_of(resolved, "LeftOutCellIds"),
        warnings=warnings + [warning for warning in told if not warning.startswith("no triangle is inside")],
    )
