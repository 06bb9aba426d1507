# SPDX-License-Identifier: GPL-3.0-or-later
"""`check`: the defects of a surface, and whether they matter here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Sequence, Union

from .calling import for_users
from .data import Polylines, TriangleSurface, as_type
from .defects import DEFECTS, PLANAR_DEFECTS, Defect
from .files import are_lines
from .lengths import Length
from .options import Options, Orientation, describe_options, in_words_of_python
from .pipeline import Error, Progress, add_statistic, run, statistics_of
from .results import MeshResult
from .statistics import Statistics
from .surfaces import AnySurface, as_surface
from .verdict import verdict
from .vtkFiltersInsideOut import vtkSurfaceDefects


@dataclass(frozen=True)
class Finding:
    """One kind of defect of a surface."""

    text: str
    """Count and kind, for example "64 open edges"."""
    matters: bool
    """Whether the solid may differ from the intended one, or be missing."""
    consequence: str
    """How InsideOut treats it."""


@dataclass(frozen=True, repr=False)
class Check(MeshResult):
    """The result of `check`. The VTK class vtkSurfaceDefects describes the arrays."""

    surface: Union[TriangleSurface, Polylines]
    """The surface, or the lines, with the defects marked per cell."""
    lines: Polylines
    """Open, non-manifold and inconsistent edges and intersection curves, distinguished by DefectType; for lines their
    open ends, crossings and T-junctions, as vertices."""
    statistics: Statistics
    """Counts by name."""
    findings: list[Finding]
    """The defects, most important first; empty if there are none."""
    shell_volumes: list[float]
    """The volume of each shell of the surface, by the cell array ShellId: negative for a cavity, 0 for a sheet. Empty
    for lines."""
    verdict: str
    """One sentence: "bounds a solid of volume 2 after turning 1 of 2 shells over"."""
    warnings: list[str]
    """Warnings about the input, one line each."""

    def figures(self) -> list[tuple[str, str]]:
        return [
            ("", self.verdict),
            *((finding.text, finding.consequence) for finding in self.findings),
            *(("", warning) for warning in self.warnings),
        ]

    def seen(self) -> dict[str, Any]:
        return {"surface": self.surface, "lines": self.lines}


@for_users
@describe_options
def check(
    surface: AnySurface,
    *,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    progress: Optional[Progress] = None,
) -> Check:
    """Find the defects of a surface, or of lines in a plane. Nothing is changed; facets to be turned over are marked.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...
    progress  called with the stage and the fraction of all the work that is done

    {options}

    Returns a `Check`. Raises `Error` with one line that names the culprit if the input is not a
    surface.
    """
    options = Options.among(locals())
    polygons, warnings = as_surface(surface, options.factor())
    marker = options.measured_on(polygons).set_on(vtkSurfaceDefects())
    marker.SetInputData(polygons)
    warnings = warnings + in_words_of_python(run(marker, progress))
    add_statistic("Scale", options.factor(), marker.GetOutput())
    statistics = statistics_of(marker.GetOutput())
    volumes = marker.GetOutput().GetFieldData().GetArray("ShellVolumes")
    findings = find(statistics)
    return Check(
        surface=as_type(Polylines if are_lines(polygons) else TriangleSurface, marker.GetOutput()),
        lines=as_type(Polylines, marker.GetLines()),
        statistics=statistics,
        findings=findings,
        shell_volumes=[volumes.GetValue(shell) for shell in range(volumes.GetNumberOfValues())] if volumes else [],
        verdict=verdict(statistics),
        warnings=warnings,
    )


def find(statistics: Mapping[str, float]) -> list[Finding]:
    """The defects by the counts of vtkSurfaceDefects, most important first."""
    if statistics.get("Dimension", 3) == 2:
        return find_among(PLANAR_DEFECTS, statistics)
    planar = Finding("the surface lies in one plane", True, "it bounds no volume: it becomes triangles in two dimensions")
    return [*([planar] if statistics["Planar"] else []), *find_among(DEFECTS, statistics)]


def find_among(defects: Sequence[Defect], statistics: Mapping[str, float]) -> list[Finding]:
    """The findings of some kinds of defects whose counts are not 0, in the order of the kinds."""
    findings = []
    for defect in defects:
        if defect.consequence and statistics[defect.statistic] > 0:
            text = defect.counted(statistics[defect.statistic])
            findings.append(Finding(text, defect.matters, defect.consequence.format_map(statistics)))
    return findings
