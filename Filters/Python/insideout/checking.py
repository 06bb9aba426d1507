# SPDX-License-Identifier: GPL-3.0-or-later
"""`check`: what is wrong with a surface, and whether it matters here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping, Optional

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .data import AnySurface, as_surface
from .pipeline import Progress, at_least, run, statistics_of
from .vtkFiltersInsideOut import vtkSurfaceDefects

CHECK_STAGES = ("validating", "finding self-intersections", "tracing intersections")
"""What the filter does, in this order, with an equal share of its progress each."""


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong with a surface."""

    text: str
    """What and how often, for example "64 open edges"."""
    matters: bool
    """Whether the solid may not be the one that is meant, or there may be none."""
    consequence: str
    """What InsideOut makes of it."""


@dataclass(frozen=True)
class Check:
    """What `check` found. The VTK class vtkSurfaceDefects describes the arrays."""

    surface: vtkPolyData
    """The surface with what is wrong marked per cell."""
    lines: vtkPolyData
    """Open, non-manifold and inconsistent edges and intersection curves, told apart by DefectType."""
    statistics: dict[str, float]
    """Counts by name."""
    findings: list[Finding]
    """What is wrong, with what matters first; empty when nothing is."""
    verdict: str
    """All of it in one sentence."""
    warnings: list[str]
    """What is worth knowing about the input, one line each."""


def check(
    surface: AnySurface,
    *,
    merge_tolerance: Optional[float] = None,
    progress: Optional[Progress] = None,
) -> Check:
    """What is wrong with a surface. Nothing is changed or cut.

    surface          a vtkPolyData, a file's name, a pair (points, triangles) of arrays or a meshio.Mesh
    merge_tolerance  points at most this far apart become one, in units of the surface, at least 0
    progress         called with the stage and the fraction of all the work that is done

    Returns a `Check`. Raises `Error` with one line that names what is wrong where the surface is no
    surface at all.
    """
    marker = make_marker(merge_tolerance)
    polygons, warnings = as_surface(surface)
    marker.SetInputData(polygons)
    warnings = warnings + run(marker, progress)
    statistics = statistics_of(marker.GetOutput())
    findings = find(statistics)
    return Check(
        surface=marker.GetOutput(),
        lines=marker.GetLines(),
        statistics=statistics,
        findings=findings,
        verdict=verdict(statistics, findings),
        warnings=warnings,
    )


def make_marker(merge_tolerance: Optional[float] = None) -> vtkSurfaceDefects:
    """The filter with this parameter."""
    marker = vtkSurfaceDefects()
    if merge_tolerance is not None:
        marker.SetMergeTolerance(at_least(0, "merge_tolerance", merge_tolerance))
    return marker


KINDS = (
    # statistic, one, several, whether it matters, what InsideOut makes of it
    (
        *("InconsistentEdges", "edge whose two facets face opposite ways"),
        *("edges whose two facets face opposite ways", True),
        "winding numbers count by orientation, and are wrong near there: orient the facets alike first",
    ),
    (
        *("NearPoints", "point that nearly coincides with another", "points that nearly coincide with others", True),
        "what is meant to be joined there may be torn: if so, set the merge tolerance to {NearDistance:.2g}",
    ),
    (
        *("TwoSidedSheets", "two-sided sheet", "two-sided sheets", True),
        "sheets shape the mesh but bound nothing: give them a thickness where they are meant to be solid",
    ),
    (
        *("OpenEdges", "open edge", "open edges", False),
        "holes are closed where the winding number passes 1/2; look at the result where they are large",
    ),
    (
        *("IntersectingPairs", "pair of facets that intersect", "pairs of facets that intersect", False),
        "facets are cut where they meet, exactly",
    ),
    ("NonManifoldEdges", "non-manifold edge", "non-manifold edges", False, "edges may have any number of facets"),
    ("DuplicateFacets", "duplicate facet", "duplicate facets", False, "facets count once per orientation"),
    (
        *("CancelledFacets", "facet cancelled by its opposite", "facets cancelled by their opposites", False),
        "such facets shape the mesh but bound nothing, like walls within a solid",
    ),
    ("TwoSidedSolids", "two-sided component", "two-sided components", False, "solids are kept once, turned outward"),
    ("DegenerateFacets", "degenerate facet", "degenerate facets", False, "without area, and left out"),
)


def find(statistics: Mapping[str, float]) -> list[Finding]:
    """What is wrong by the counts of vtkSurfaceDefects, with what matters first."""
    findings = []
    if statistics["Planar"]:
        findings.append(Finding("the surface lies in one plane", True, "it bounds no volume: there is nothing to mesh"))
    for name, one, several, matters, consequence in KINDS:
        count = statistics[name]
        if count > 0:
            text = f"{count:,} {one if count == 1 else several}"
            findings.append(Finding(text, matters, consequence.format_map(statistics)))
    return findings


def verdict(statistics: Mapping[str, float], findings: list[Finding]) -> str:
    """The findings in one sentence."""
    if not findings:
        return "nothing is wrong: the surface is closed and bounds a solid"
    serious = [finding.text for finding in findings if finding.matters]
    if serious:
        return "this may matter: " + "; ".join(serious)
    if statistics["UnbalancedEdges"] == 0:
        return "nothing here matters: the surface is closed, and what it encloses is the solid"
    return "nothing here needs mending; the surface is open, so that the solid is a best guess near its holes"
