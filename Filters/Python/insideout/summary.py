# SPDX-License-Identifier: GPL-3.0-or-later
"""The result in words: the surface's defects, sizes and times."""

from __future__ import annotations

import math
from typing import Iterable, Mapping, Optional, Sequence

from . import stages
from .checking import Finding
from .defects import DEFECTS, PLANAR_DEFECTS
from .quality import quality_rows, solid_verdict, topology_rows
from .verdict import MOST_LINES, in_few_lines, verdict, volumes_of_shells, what_it_bounds
from .vtkFiltersInsideOut import vtkConstrainedDelaunay3D

OUTLIERS = (
    ("OutliersByEnergy", "segmented as outside"),
    ("OutliersLost", "lost by the mesh"),
    ("OutliersLeftOut", "left out by the resolver"),
    ("OutliersDegenerate", "degenerate"),
)

COUNTS = {
    **{defect.statistic: defect.several for defect in DEFECTS},
    "Points": "vertices in use",
    "Facets": "facets",
    "Components": "components",
    "InputTriangles": "triangles",
    "InsideCells": "tetrahedra",
    "Cells": "cells",
    "InsidePlaces": "inside",
    "SecondsTotal": "seconds",
}
"""The names of statistics in tables."""

MOST_LISTED = 8
"""The largest number of regions or tags in a line."""

CHECK_ROWS = ("Points", "Facets", "OpenEdges", "IntersectingPairs", "Components", "NonManifoldEdges", "InconsistentEdges", "NearPoints")
COLUMNS = ("InputTriangles", "OpenEdges", "IntersectingPairs", "InsideCells", "InsidePlaces", "Cells", "SecondsTotal")

TIMES = (
    ("SecondsRead", stages.READING),
    ("SecondsValidate", stages.VALIDATING),
    ("SecondsPre", stages.RESOLVING),
    ("SecondsCDT", stages.TETRAHEDRALIZING),
    ("SecondsW", stages.WINDING_NUMBERS),
    ("SecondsCut", stages.SEGMENTING),
    ("SecondsBoolean", "resolving and choosing"),
    ("SecondsRefine", stages.REFINING),
    ("SecondsLayers", stages.LAYERING),
    ("SecondsWrite", stages.WRITING),
    ("SecondsDraw", stages.DRAWING),
)


def defects(statistics: Mapping[str, float]) -> list[str]:
    """The defects of the surface, one line each; none if there are none."""
    kinds = PLANAR_DEFECTS if statistics.get("Dimension", 3) == 2 else DEFECTS
    counts = ((defect, statistics.get(defect.statistic, 0)) for defect in kinds)
    return [defect.counted(count) for defect, count in counts if count > 0]


def tetrahedralizer(statistics: Mapping[str, float]) -> Optional[str]:
    """The engine that made the tetrahedra, in words."""
    return vtkConstrainedDelaunay3D.GetRungName(int(statistics["Rung"])) if "Rung" in statistics else None


def _cells(statistics: Mapping[str, float]) -> list[str]:
    """The number of tetrahedra, if any were made."""
    if "InsideCells" not in statistics:
        return ["  the surface is closed: its boundary was found without tetrahedra"]
    return [f"  {_count(statistics['InsideCells'])} tetrahedra inside, of {_count(statistics['HullCells'])} in the convex hull"]


def _made_by(statistics: Mapping[str, float]) -> list[str]:
    """The engine of the tetrahedra, and the points that it added."""
    if "SteinerPoints" not in statistics:
        return []
    points, on_surface = (_count(statistics[key]) for key in ("SteinerPoints", "SurfaceSteinerPoints"))
    return [f"  by {tetrahedralizer(statistics)}", f"  {points} Steiner points, {on_surface} of them on the surface"]


def _mass(statistics: Mapping[str, float]) -> list[str]:
    """The solid's volume in words, if there is one, and its center of mass, which takes tetrahedra."""
    if not statistics["Volume"]:
        return []
    if "CenterOfMassX" not in statistics:
        return [f"  volume {statistics['Volume']:.6g}"]
    center = ", ".join(f"{statistics['CenterOfMass' + axis]:.6g}" for axis in "XYZ")
    return [f"  volume {statistics['Volume']:.6g}, center of mass ({center})"]


def _refined(statistics: Mapping[str, float]) -> list[str]:
    """The result of refinement, if the tetrahedra were refined."""
    if "RefinedCells" not in statistics:
        return []
    cells, added, removed = (_count(statistics[key]) for key in ("RefinedCells", "AddedPoints", "RemovedPoints"))
    angles = (f"{statistics[prefix + 'DihedralAngle1Percent']:.3g}" for prefix in ("Before", ""))
    lines = [f"  refined to {cells} tetrahedra: {added} points added, {removed} removed"]
    lines.append(f"  one of a hundred dihedral angles is below {' degrees before, '.join(angles)} after")
    sharp, thin = (_count(statistics[name + "Under10Degrees"]) for name in ("SurfaceEdges", "Cells"))
    if thin != "0":
        lines.append(f"  {thin} tetrahedra have an angle below 10 degrees; {sharp} edges of the boundary are as sharp")
    if "SurfaceDistance" in statistics:
        apart = max(statistics["SurfaceDistance"], statistics["InputDistance"])
        lines.append(f"  the boundary is within {apart:.3g} of the previous surface; the limit is {statistics['SurfaceTolerance']:.3g}")
    return lines


def _layers(statistics: Mapping[str, float]) -> list[str]:
    """The cells of boundary layers, if there are any."""
    if "Layers" not in statistics:
        return []
    kinds = {"Prisms": "prisms", "Pyramids": "pyramids", "Quads": "quads", "LayerTetrahedra": "tetrahedra", "LayerTriangles": "triangles"}
    *first, last = (f"{_count(statistics[name])} {words}" for name, words in kinds.items() if name in statistics)
    return [f"  layers of {', '.join(first)} and {last}; {math.floor(1000 * statistics['FullHeightShare']) / 10:g} % of the wall at full height"]


def _refined_triangles(statistics: Mapping[str, float]) -> list[str]:
    """The result of refinement of triangles in a plane."""
    if "RefinedCells" not in statistics:
        return []
    cells, added, cuts = (_count(statistics[key]) for key in ("RefinedCells", "AddedPoints", "SurfacePoints"))
    angles = (f"{statistics[prefix + 'Angle1Percent']:.3g}" for prefix in ("Before", ""))
    return [
        f"  refined to {cells} triangles: {added} points added, {cuts} of them on lines",
        f"  one of a hundred angles is below {' degrees before, '.join(angles)} after; the least is {statistics['MinAngle']:.3g}",
    ]


def _parted(statistics: Mapping[str, float]) -> list[str]:
    """The copied points or cells of the solid, if copying was requested."""
    lines = []
    if "Overlaps" in statistics:
        separated, overlaps, cells = (_count(statistics[key]) for key in ("SeparatedOverlaps", "Overlaps", "CopiedCells"))
        lines.append(f"  {separated} of {overlaps} overlaps separated, by copies of {cells} tetrahedra")
    if "SplitPoints" in statistics:
        shared = f", {_count(statistics['SharedPoints'])} more on the boundary alone" if statistics.get("SharedPoints") else ""
        lines.append(f"  {_count(statistics['SplitPoints'])} copies of points where it touches itself{shared}")
    return lines


def _topology(statistics: Mapping[str, float]) -> list[str]:
    """The dropped regions, filled cavities and joined regions, if any."""
    what = "area" if statistics.get("Dimension", 3) == 2 else "volume"
    lines = []
    for counted, one, many, size in (
        ("DroppedRegions", "region", "regions", "DroppedVolume"),
        ("FilledCavities", "cavity", "cavities", "FilledVolume"),
    ):
        count = int(statistics.get(counted, 0))
        if count > 0:
            done = "dropped" if counted == "DroppedRegions" else "filled"
            lines.append(f"  {count:,} {one if count == 1 else many} {done}, of {what} {statistics[size]:.6g} in all")
    joined = int(statistics.get("JoinedRegions", 0))
    if joined > 0:
        lines.append(f"  {joined:,} {'way' if joined == 1 else 'ways'} made between regions")
    if statistics.get("Energy") != statistics.get("EnergyBeforeTopology"):
        lines.append(f"  energy {statistics['EnergyBeforeTopology']:.6g} before the topology was made so, {statistics['Energy']:.6g} after")
    return lines


def _scaled(statistics: Mapping[str, float]) -> list[str]:
    """The factor of the coordinates, if any."""
    return [] if statistics["Scale"] == 1 else [f"  coordinates multiplied by {statistics['Scale']:g}"]


def _cavities(statistics: Mapping[str, float]) -> list[str]:
    """The number of cavities of the solid in words, if it has any."""
    count = int(statistics.get("SolidCavities", 0))
    return [f"  {count:,} {'cavity' if count == 1 else 'cavities'} within it"] if count > 0 else []


def _regions(volumes: Sequence[float], names: Sequence[str]) -> list[str]:
    """The volumes of the solid's parts in words, if it has several or they have names."""
    if names:
        return [f"  {len(volumes):,} regions, of volume {_first(f'{volume:.6g} ({name})' for volume, name in zip(volumes, names))}"]
    return [f"  {len(volumes):,} regions, of volume {_first(f'{volume:.6g}' for volume in volumes)}"] if len(volumes) > 1 else []


def _tags(tags: Mapping[str, int]) -> list[str]:
    """The number of boundary triangles with each tag, if the surface has tags."""
    return [] if set(tags) <= {"surface"} else [f"  tags {_first(f'{name} {count:,}' for name, count in tags.items())}"]


def _first(words: Iterable[str]) -> str:
    """A list, of which only the first items are printed."""
    every = list(words)
    return ", ".join(every[:MOST_LISTED]) + (f" and {len(every) - MOST_LISTED:,} more" if len(every) > MOST_LISTED else "")


def summary(
    name: str, statistics: Mapping[str, float], volumes: Sequence[float], tags: Mapping[str, int], regions: Sequence[str] = ()
) -> list[str]:
    """The last lines of the command's output: volumes of regions (with names if there are bodies), and triangles per
    tag."""
    if statistics.get("Dimension", 3) == 2:
        return _planar_summary(name, statistics, volumes, tags)
    count = {key: _count(value) for key, value in statistics.items() if isinstance(value, int)}
    merged = f" ({count['MergedPoints']} merged with others in their place)" if statistics["MergedPoints"] else ""
    components = _components(statistics)
    total = statistics["SecondsTotal"]
    surface = [
        f"Surface {name}: {verdict(statistics)}",
        f"  {count['InputPoints']} points{merged}, {count['InputTriangles']} triangles, {components}",
        *_scaled(statistics),
        *(f"  {line}" for line in what_it_bounds(statistics)),
        *(f"  {line}" for line in defects(statistics) or ["nothing wrong"]),
    ]
    return [
        *in_few_lines(surface),
        "Solid",
        *lines_about_solid(statistics, volumes, tags, regions),
        f"Time {total:.1f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
        *(f"  {words:30} {statistics[key]:8.2f} s" for key, words in TIMES if key in statistics),
    ]


def lines_about_solid(
    statistics: Mapping[str, float], volumes: Sequence[float] = (), tags: Mapping[str, int] = {}, regions: Sequence[str] = ()
) -> list[str]:
    """Lines about the solid, without times."""
    return [
        *_cells(statistics),
        *_topology(statistics),
        *_parted(statistics),
        *_refined(statistics),
        *_layers(statistics),
        *_mass(statistics),
        *_regions(volumes, regions),
        *_cavities(statistics),
        *_made_by(statistics),
        f"  {_count(statistics['BoundaryFaces'])} boundary triangles, {_count(statistics['OutlierFacets'])} outlier facets{_reasons(statistics)}",
        *_tags(tags),
        f"  w from {statistics['MinimumW']:.6g} to {statistics['MaximumW']:.6g}",
    ]


def _planar_summary(name: str, statistics: Mapping[str, float], areas: Sequence[float], tags: Mapping[str, int]) -> list[str]:
    """The same in two dimensions."""
    count = {key: _count(value) for key, value in statistics.items() if isinstance(value, int)}
    center = ", ".join(f"{statistics['CenterOfMass' + axis]:.6g}" for axis in "XYZ")
    return [
        f"Curve {name}: {verdict(statistics)}",
        f"  {count['InputPoints']} points, {count['InputSegments']} segments, {_components(statistics)}",
        *_scaled(statistics),
        *(f"  {line}" for line in defects(statistics) or ["nothing wrong"]),
        "Solid",
        f"  {count['InsideCells']} triangles inside, of {count['HullCells']} in the convex hull",
        *_topology(statistics),
        *_refined_triangles(statistics),
        *_layers(statistics),
        *([f"  area {statistics['Area']:.6g}, center of mass ({center})"] if statistics["Area"] else []),
        *([f"  {len(areas):,} regions, of area {_first(f'{area:.6g}' for area in areas)}"] if len(areas) > 1 else []),
        f"  {count['OutlierSegments']} outlier segments",
        *_tags(tags),
        f"  w from {statistics['MinimumW']:.6g} to {statistics['MaximumW']:.6g}",
        f"Time {statistics['SecondsTotal']:.1f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
        *(f"  {words:30} {statistics[key]:8.2f} s" for key, words in TIMES if key in statistics),
    ]


def seams(statistics: Mapping[str, float]) -> list[str]:
    """A note that the boundary merges points that the input copied along texture seams."""
    copies = int(statistics.get("SeamPoints", 0))
    merged = f"{copies:,} points, copies of others with other texture coordinates or normals, were merged with these"
    return [f"{merged}; --split-seams keeps them all"] if copies > 0 else []


def check_summary(name: str, statistics: Mapping[str, float], findings: Sequence[Finding], volumes: Sequence[float]) -> list[str]:
    """The lines that `check` prints: the columns of the thesis's table 8.1, with the meaning of each defect."""
    if statistics.get("Dimension", 3) == 2:
        return _planar_check_summary(name, statistics, findings)
    merged = f" ({_count(statistics['MergedPoints'])} merged with others in their place)" if statistics["MergedPoints"] else ""
    told = {defect.statistic for defect in DEFECTS if defect.consequence and statistics[defect.statistic] > 0}
    surface = [
        f"Surface {name}: {verdict(statistics)}",
        f"  {_count(statistics['InputPoints'])} points{merged}, {_count(statistics['InputTriangles'])} triangles",
        *_scaled(statistics),
        *(f"  {line}" for line in what_it_bounds(statistics)),
    ]
    return [
        *surface,
        *(f"  {line}" for line in volumes_of_shells(volumes, MOST_LINES - len(surface))),
        *(f"  {COUNTS[key]:30} {_count(statistics[key]):>10}" for key in CHECK_ROWS if key not in told),
        *_listed("Wrong, and may matter here", [finding for finding in findings if finding.matters]),
        *_listed("Wrong, but does not matter here", [finding for finding in findings if not finding.matters]),
        f"Time {statistics['SecondsTotal']:.2f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
    ]


def _planar_check_summary(name: str, statistics: Mapping[str, float], findings: Sequence[Finding]) -> list[str]:
    """The same in two dimensions."""
    return [
        f"Curve {name}: {verdict(statistics)}",
        f"  {_count(statistics['InputPoints'])} points, {_count(statistics['InputSegments'])} segments, {_components(statistics)}",
        *_scaled(statistics),
        *_listed("Wrong, but does not matter here", findings),
        f"Time {statistics['SecondsTotal']:.2f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
    ]


def solid_summary(name: str, statistics: Mapping[str, float], findings: Sequence[Finding]) -> list[str]:
    """The lines that `check` prints of a solid."""
    return [
        f"Solid {name}: {solid_verdict(statistics)}",
        f"  {_count(statistics['BoundaryFaces'])} boundary triangles",
        *(f"  {what:20} {how_much}" for what, how_much in [*topology_rows(statistics), *quality_rows(statistics)]),
        *_listed("Wrong, and may matter", [finding for finding in findings if finding.matters]),
        *_listed("Worth knowing", [finding for finding in findings if not finding.matters]),
        f"Time {statistics['SecondsTotal']:.2f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
    ]


def refinement_summary(name: str, statistics: Mapping[str, float]) -> list[str]:
    """The last lines of `refine`."""
    return [
        f"Solid {name}",
        *_refined(statistics),
        f"Time {statistics['SecondsTotal']:.1f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
        *(f"  {words:30} {statistics[key]:8.2f} s" for key, words in TIMES if key in statistics),
    ]


def winding_summary(name: str, statistics: Mapping[str, float]) -> list[str]:
    """The lines that `query` prints."""
    lines = [f"Surface {name}", f"  {_count(statistics['InsidePlaces'])} of {_count(statistics['Places'])} places are inside"]
    if "MinimumW" in statistics:
        lines.append(f"  w from {statistics['MinimumW']:.6g} to {statistics['MaximumW']:.6g}")
    return [*lines, f"Time {statistics['SecondsTotal']:.2f} s, peak memory {statistics['PeakMemory']:.0f} MiB"]


def boolean_summary(names: Sequence[str], expression: str, statistics: Mapping[str, float]) -> list[str]:
    """The lines that `boolean` prints."""
    way = f"by {_count(statistics.get('HullCells', 0))} tetrahedra of all" if statistics["Tetrahedra"] else "without tetrahedra"
    return [
        f"Bodies {_first(names)}",
        *_scaled(statistics),
        f"  {_count(statistics['IntersectingPairs'])} pairs of facets meet",
        f"Solid {expression}",
        f"  {_count(statistics['BoundaryFaces'])} boundary triangles, {way}",
        f"  volume {statistics['Volume']:.6g}",
        f"Time {statistics['SecondsTotal']:.1f} s, peak memory {statistics['PeakMemory']:.0f} MiB",
        *(f"  {words:30} {statistics[key]:8.2f} s" for key, words in TIMES if key in statistics),
    ]


def table(jobs: Sequence[tuple[str, Mapping[str, float], str]], done: int, wanted: int) -> list[str]:
    """A line per surface with its file, statistics and result, and a line with the number of successes."""
    columns = [key for key in COLUMNS if any(key in statistics for _, statistics, _ in jobs)]
    widths = [max(11, len(COUNTS[key])) for key in columns]
    width = max(len(file) for file, _, _ in jobs)

    def line(first: str, cells: Iterable[str], last: str) -> str:
        return " ".join([f"{first:{width}}", *(f"{cell:>{wide}}" for cell, wide in zip(cells, widths)), f" {last}"])

    def cell(key: str, statistics: Mapping[str, float]) -> str:
        if key not in statistics:
            return "-"
        return f"{statistics[key]:,.1f}" if key == "SecondsTotal" else _count(statistics[key])

    lines = ["", line("surface", (COUNTS[key] for key in columns), "result")]
    lines += [line(file, (cell(key, statistics) for key in columns), result) for file, statistics, result in jobs]
    return [*lines, f"{done} of {wanted} surfaces done"]


def _reasons(statistics: Mapping[str, float]) -> str:
    """The reasons why facets are outliers, with counts; empty without outliers."""
    reasons = [f"{_count(statistics[key])} {words}" for key, words in OUTLIERS if statistics.get(key, 0) > 0]
    return f" ({', '.join(reasons)})" if reasons else ""


def _listed(title: str, findings: Sequence[Finding]) -> list[str]:
    return [title, *(f"  {finding.text}: {finding.consequence}" for finding in findings)] if findings else []


def _components(statistics: Mapping[str, float]) -> str:
    return "1 component" if statistics["Components"] == 1 else f"{_count(statistics['Components'])} components"


def _count(value: float) -> str:
    return f"{int(value):,}"
