# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line says of a result that another option would make better for a solver or a printer, one line each."""

from __future__ import annotations

import os

import numpy as np

from .data import Tetrahedra, TriangleSurface, as_type
from .files import ending, read_surface
from .measures import count_crowded_edges, is_closed, joined_where_equal
from .options import Options, flag_of
from .quality import check_solid
from .tetrahedralization import Tetrahedralization
from .writing import WRITABLE_SOLIDS

STL = ".stl"

TOO_LONG = 2.0
"""Edges this many times as long as asked for are told of: refined boundaries have some that are a little longer."""

TOO_THIN = 1.0
"""Degrees; with less solvers err or stop, and take longer with 5."""


def hints_for_solver(result: Tetrahedralization, path: str, settings: Options) -> list[str]:
    """The lines for a solid that is written to a file."""
    if ending(path) not in WRITABLE_SOLIDS or not isinstance(result.solid, Tetrahedra):
        return []
    return [*_of_long_edges(result.boundary, settings), *_of_thin_cells(result, settings)]


def hints_for_printing(surface: TriangleSurface, path: str, settings: Options) -> list[str]:
    """Whether a slicer takes a surface that was written to a file. Points of a .stl file are told apart by floats alone."""
    triangles = surface.triangles
    if ending(path) == STL and os.path.isfile(path):
        written = as_type(TriangleSurface, read_surface(path)[0])
        triangles = joined_where_equal(written.points, written.triangles)
    closed = "the surface is watertight" if is_closed(triangles) else "the surface has open edges"
    crowded = count_crowded_edges(triangles)
    if crowded == 0:
        return [f"{closed}, and each edge has two triangles"]
    edges = "1 edge has" if crowded == 1 else f"{crowded:,} edges have"
    told = f"{closed}, and {edges} more than two triangles, which some slicers refuse"
    return [told if settings.non_manifold == "fill" else f"{told}: {flag_of('non_manifold')} fill adds to the solid there"]


def _of_long_edges(boundary: TriangleSurface, settings: Options) -> list[str]:
    """The triangles of the surface stay by default, which makes long cells beside large triangles, too stiff for a solver."""
    asked = float(settings.edge_length or 0)
    if asked <= 0 or settings.surface_treatment != "kept":
        return []
    corners = boundary.points[boundary.triangles]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max()
    if longest <= TOO_LONG * asked:
        return []
    kept = f"{flag_of('edge_length')} is {asked:g}, and edges of the boundary, whose triangles are kept, are up to {longest:.3g} long"
    return [f"{kept}: {flag_of('surface_treatment')} split makes them short, too"]


def _of_thin_cells(result: Tetrahedralization, settings: Options) -> list[str]:
    """Cells of the unrefined solid are as thin as the surface makes them; those of a refined one, where its points nearly meet."""
    refined = settings.refines()
    statistics = result.statistics if refined else check_solid(result.solid).statistics
    least, thin, cells = statistics["MinDihedralAngle"], int(statistics["CellsUnder5Degrees"]), len(result.solid.cells)
    if least >= TOO_THIN:
        return []
    told = f"tetrahedra have angles down to {least:.3g} degrees, {thin:,} of {cells:,} below 5: solvers may stop or err"
    if not refined:
        return [f"{told}; {flag_of('refine')} makes better ones"]
    ways = [] if settings.merge_tolerance else [f"{flag_of('merge_tolerance')} 0.001% joins points that nearly meet"]
    ways += [] if settings.surface_treatment == "remeshed" else [f"{flag_of('surface_treatment')} remeshed gives the boundary better triangles"]
    return ["; ".join(filter(None, (told, " and ".join(ways))))]
