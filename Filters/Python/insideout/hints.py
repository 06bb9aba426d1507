# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line says of tetrahedra for a solver that another option would make better, one line each."""

from __future__ import annotations

import numpy as np

from .data import Tetrahedra, TriangleSurface
from .files import ending
from .options import Options, flag_of
from .quality import check_solid
from .tetrahedralization import Tetrahedralization
from .writing import WRITABLE_SOLIDS

TOO_LONG = 2.0
"""Edges this many times as long as asked for are told of: refined boundaries have some that are a little longer."""

TOO_THIN = 1.0
"""Degrees; with less solvers err or stop, and take longer with 5."""


def hints_for(result: Tetrahedralization, path: str, settings: Options) -> list[str]:
    """The lines for a solid that is written to a file."""
    if ending(path) not in WRITABLE_SOLIDS or not isinstance(result.solid, Tetrahedra):
        return []
    return [*_of_long_edges(result.boundary, settings), *_of_thin_cells(result, settings)]


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
