# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of pictures that show surfaces, hulls and solids."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkProp

from .actors import (
    CROSSING,
    CROSSING_FACETS,
    DUPLICATE,
    EDGES,
    FACET_EDGES,
    INCONSISTENT,
    INK,
    NON_MANIFOLD,
    OPEN,
    SLICES,
    SOLID,
    SOUND,
    TURNED,
    Colour,
    actor,
    behind,
    colour_bar,
    darken_inside,
    dot,
    line_actor,
    lines_of,
    nearer,
    slice_actor,
    slice_of,
    some_slices,
    some_triangles,
    surface_of,
    triangles_of,
)
from .legend import LETTERS, beneath, label, title, whole_legend, words
from .view import View, ViewFromAbove
from .vtkFiltersInsideOut import vtkSurfaceDefects
from .worst import Place, segments_of, worst_places

AnyView = Union[View, ViewFromAbove]

FEW_FACETS = 5000
"""Up to this number of facets, each is drawn with its edges."""

LINES: Sequence[tuple[int, Colour]] = (
    (vtkSurfaceDefects.INTERSECTION_CURVE, CROSSING),
    (vtkSurfaceDefects.INCONSISTENT_EDGE, INCONSISTENT),
    (vtkSurfaceDefects.NON_MANIFOLD_EDGE, NON_MANIFOLD),
    (vtkSurfaceDefects.OPEN_BOUNDARY, OPEN),
)
"""The drawing order, the last on top."""

WIDTH, THIN, MANY_LINES = 5, 2.5, 2000
"""Widths of these lines, in pixels; thin if there are many, so that they do not hide the surface."""

FACETS: Sequence[Colour] = (SOUND, CROSSING_FACETS, TURNED, DUPLICATE)
"""The colors of facets; a facet of several kinds has the color of the last."""

FAINT = 0.3
"""The opacity of hidden lines."""


@dataclass
class Panel:
    """The content of one panel."""

    props: list[vtkProp]
    over: list[vtkProp] = field(default_factory=list)  # visible through everything
    view: Optional[AnyView] = None  # if it differs from the picture's


def kinds_of_facets(marked: vtkPolyData) -> NDArray[np.uint8]:
    """For each facet of a checked surface its kind in `FACETS`: sound, meeting others, facing the wrong way, or a
    duplicate.
    """
    kinds = np.zeros(marked.GetNumberOfCells(), np.uint8)
    for kind, name in enumerate(("SelfIntersections", "Turned", "Duplicate"), 1):
        kinds[vtk_to_numpy(marked.GetCellData().GetArray(name)) > 0] = kind
    return kinds


def marked_facets(marked: vtkPolyData) -> list[vtkProp]:
    """The facets of a checked surface, a color for each kind."""
    kinds = kinds_of_facets(marked)
    edges = FACET_EDGES if marked.GetNumberOfCells() <= FEW_FACETS else None
    drawn: list[vtkProp] = []
    for kind, colour in reversed(list(enumerate(FACETS))):
        if (kinds == kind).any():
            facets = actor(some_triangles(marked, kinds == kind), colour, edge_colour=edges)
            if colour in (SOUND, CROSSING_FACETS):
                darken_inside(facets)
            if colour == DUPLICATE:
                nearer(facets)  # darker than the facets that they repeat
            drawn.append(facets)
    return drawn


def defect_lines(lines: vtkPolyData, are_behind: bool = False) -> list[vtkProp]:
    """The lines of a checked surface, a color for each kind; thin and faint where the surface hides them."""
    width = WIDTH if len(segments_of(lines)) <= MANY_LINES else THIN
    width, opacity = (width / 2, FAINT) if are_behind else (width, 1)
    parts = [(lines_of(lines, kind), colour) for kind, colour in LINES]
    return [line_actor(part, colour, width, opacity) for part, colour in parts if part.GetNumberOfCells()]


def surface_panel(marked: vtkPolyData, lines: vtkPolyData, statistics: Mapping[str, float]) -> Panel:
    """One view, with the first counts beneath it."""
    props = [*marked_facets(marked), *defect_lines(lines), title("The surface and its defects"), *beneath(statistics)]
    return Panel(props, defect_lines(lines, are_behind=True))


def defect_panels(marked: vtkPolyData, lines: vtkPolyData, statistics: Mapping[str, float], view: View) -> list[Panel]:
    """The defects, from two sides, with labels at the worst places, and all counts."""
    places = worst_places(marked, lines)
    panels = []
    for name, side, other in (("front", view, view.from_behind()), ("behind", view.from_behind(), view)):
        props = [*marked_facets(marked), *defect_lines(lines), title(f"Seen from {'the front' if name == 'front' else name}")]
        labels = labels_seen(marked, places, side, other)
        panels.append(Panel(props, [*defect_lines(lines, are_behind=True), *labels], side))
    panels.append(Panel(whole_legend(statistics, places)))
    return panels


def labels_seen(marked: vtkPolyData, places: Sequence[Place], side: View, other: View) -> list[vtkProp]:
    """The letters of the places that are visible from one side, and of those visible from neither."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(marked)
    locator.BuildLocator()
    labels: list[vtkProp] = []
    for k, place in enumerate(places):
        if is_seen(locator, place.point, side) or not is_seen(locator, place.point, other):
            labels += [dot(place.point), label(LETTERS[k], place.point)]
    return labels


BEFORE_ITSELF = 1e-4
"""Distance from a place, as a share of the way to the eye, within which facets are its own and do not hide it."""


def is_seen(locator: vtkStaticCellLocator, point: NDArray[np.float64], view: View) -> bool:
    """Whether a point is visible: no facet is between it and the eye."""
    eye = point + view.distance * view.eye
    start = point + BEFORE_ITSELF * (eye - point)
    hit, cell = [0.0, 0.0, 0.0], mutable(0)
    return not locator.IntersectWithLine(start, eye, 0.0, mutable(0.0), hit, [0.0, 0.0, 0.0], mutable(0), cell)


def slice_panel(hull: vtkUnstructuredGrid, view: View) -> Panel:
    return Panel([slice_actor(slice_of(hull, view.slice_plane())), title("Winding number w, a slice of the hull"), colour_bar()])


def solid_panel(solid: vtkUnstructuredGrid, view: View) -> Panel:
    count = f"{solid.GetNumberOfCells():,} tetrahedra"
    cut_open = actor(behind(solid, view.slice_plane()), SOLID, edge_colour=EDGES)
    return Panel([cut_open, title("The tetrahedra inside, cut open"), words(count, 0.085)])


def boundary_panel(solid: vtkUnstructuredGrid) -> Panel:
    boundary = surface_of(solid)
    count = f"{boundary.GetNumberOfCells():,} triangles"
    return Panel([actor(boundary, SOLID), title("The solid's boundary"), words(count, 0.085)])


def slices_panel(solid: vtkUnstructuredGrid, view: View) -> Panel:
    """Every second of equal slices, from left to right."""
    count = f"every other of {2 * SLICES - 1} slices"
    slices = actor(some_slices(solid, view.right), SOLID, edge_colour=EDGES)
    return Panel([slices, title("Its tetrahedra, in slices"), words(count, 0.085)])


POINTS: Sequence[tuple[int, Colour]] = (
    (vtkSurfaceDefects.OPEN_END, OPEN),
    (vtkSurfaceDefects.CROSSING, CROSSING),
    (vtkSurfaceDefects.T_JUNCTION, NON_MANIFOLD),
)


def curve_panel(curve: vtkPolyData, marks: Optional[vtkPolyData], rows: Sequence[vtkProp] = ()) -> Panel:
    """A curve in a plane with its defects as points."""
    given = actor(triangles_of(curve), SOUND, edge_colour=INK) if curve.GetNumberOfPolys() else line_actor(curve, INK, 3)
    drawn: list[vtkProp] = [given]
    for kind, colour in POINTS if marks else ():
        points = line_actor(lines_of(marks, kind), colour, 7)
        drawn.append(points)
    return Panel([*drawn, title("The curve and its defects"), *rows])


def flat_panels(hull: vtkUnstructuredGrid, solid: vtkUnstructuredGrid) -> list[Panel]:
    """w and the solid in a plane."""
    inside = actor(surface_of(solid), SOLID, edge_colour=EDGES)
    return [
        Panel([slice_actor(surface_of(hull)), title("Winding number w"), colour_bar()]),
        Panel([inside, title("The triangles inside"), words(f"{solid.GetNumberOfCells():,} triangles", 0.085)]),
    ]
