# SPDX-License-Identifier: GPL-3.0-or-later
"""The worst place of each kind of defect that a check has marked."""

from __future__ import annotations

from typing import NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter

from .actors import lines_of
from .data import corners_of
from .vtkFiltersInsideOut import vtkSurfaceDefects

KINDS = (
    (vtkSurfaceDefects.OPEN_BOUNDARY, "OpenEdges", "longest open boundary: {count}, {length:.4g} long"),
    (vtkSurfaceDefects.INTERSECTION_CURVE, "IntersectingPairs", "longest intersection curve: {length:.4g} long"),
    (vtkSurfaceDefects.NON_MANIFOLD_EDGE, "NonManifoldEdges", "longest non-manifold line: {count}, {length:.4g} long"),
    (vtkSurfaceDefects.INCONSISTENT_EDGE, "InconsistentEdges", "longest inconsistent line: {count}, {length:.4g} long"),
)

DIGITS = 4
"""Digits of coordinates."""


class Place(NamedTuple):
    """The place of a defect."""

    statistic: str  # statistic with the count
    text: str
    point: NDArray[np.float64]
    where: str  # the point, with digits according to the surface's size


def worst_places(marked: vtkPolyData, lines: vtkPolyData) -> list[Place]:
    """For each kind of line the longest connected one, and the largest part that faces the wrong way."""
    found = [(statistic, _longest(lines_of(lines, kind), text)) for kind, statistic, text in KINDS]
    found.append(("TurnedFacets", _largest_turned(marked)))
    decimals = DIGITS - int(np.ceil(np.log10(max(marked.GetLength(), np.finfo(float).tiny))))
    return [Place(statistic, *told, _in_words(told[1], decimals)) for statistic, told in found if told is not None]


def _in_words(point: NDArray[np.float64], decimals: int) -> str:
    return f"({', '.join(f'{round(x, decimals) + 0.0:.{DIGITS}g}' for x in point.tolist())})"


def _longest(lines: vtkPolyData, text: str) -> Optional[tuple[str, NDArray[np.float64]]]:
    segments = segments_of(lines)
    if len(segments) == 0:
        return None
    joined = vtkPolyDataConnectivityFilter()
    joined.SetInputData(lines)
    joined.SetExtractionModeToAllRegions()
    joined.ColorRegionsOn()
    joined.Update()
    output = joined.GetOutput()
    segments = segments_of(output)
    points = vtk_to_numpy(output.GetPoints().GetData()).astype(float)
    region = vtk_to_numpy(output.GetPointData().GetArray("RegionId"))[segments[:, 0]]
    lengths = np.linalg.norm(points[segments[:, 1]] - points[segments[:, 0]], axis=1)
    longest = int(np.bincount(region, lengths).argmax())
    of_it = region == longest
    middles = points[segments[of_it]].mean(axis=1)
    nearest = np.linalg.norm(middles - middles.mean(axis=0), axis=1).argmin()
    count = int(of_it.sum())
    told = text.format(count=f"{count:,} edge{'' if count == 1 else 's'}", length=lengths[of_it].sum())
    return told, middles[nearest]


def _largest_turned(marked: vtkPolyData) -> Optional[tuple[str, NDArray[np.float64]]]:
    corners = corners_of(marked.GetPolys(), 3)
    turned = vtk_to_numpy(marked.GetCellData().GetArray("Turned")) > 0
    if not turned.any():
        return None
    a, b, c = (vtk_to_numpy(marked.GetPoints().GetData()).astype(float)[corner] for corner in corners[turned].T)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    component = vtk_to_numpy(marked.GetCellData().GetArray("ComponentId"))[turned]
    largest = np.bincount(component - component.min(), areas).argmax() + component.min()
    of_it = component == largest
    facet = np.flatnonzero(of_it)[areas[of_it].argmax()]
    return f"largest part that faces the wrong way: area {areas[of_it].sum():.4g}", (a[facet] + b[facet] + c[facet]) / 3


def segments_of(lines: vtkPolyData) -> NDArray[np.int64]:
    """The ends of the segments of polylines."""
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray()).astype(np.int64)
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray()).astype(np.int64)
    begins = np.ones(len(ids), bool)
    begins[offsets[1:] - 1] = False
    starts = np.flatnonzero(begins)
    return np.stack([ids[starts], ids[starts + 1]], axis=1)
