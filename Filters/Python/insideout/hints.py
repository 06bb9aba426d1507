# SPDX-License-Identifier: GPL-3.0-or-later
"""Advice of the command line on options that improve a result for a printer, one line each."""

from __future__ import annotations

import os

from .data import TriangleSurface, as_type
from .files import ending, read_surface
from .measures import joined_where_equal, triangles_at_edges
from .options import Options, flag_of

STL = ".stl"


def hints_for_printing(surface: TriangleSurface, path: str, settings: Options) -> list[str]:
    """Whether a slicer accepts a surface that was written to a file. Points of a .stl file are distinguished by floats
    alone."""
    triangles = surface.triangles
    if ending(path) == STL and os.path.isfile(path):
        written = as_type(TriangleSurface, read_surface(path)[0])
        triangles = joined_where_equal(written.points, written.triangles)
    balance, there = triangles_at_edges(triangles)
    is_open = bool(balance.any()) or len(balance) == 0
    closed = "the surface has open edges" if is_open else "the surface is watertight"
    crowded = int((there > 2).sum())
    if crowded == 0:
        return [closed if is_open else f"{closed}, and each edge has two triangles"]
    edges = "1 edge has" if crowded == 1 else f"{crowded:,} edges have"
    told = f"{closed}, and {edges} more than two triangles, which some slicers refuse"
    return [told if settings.non_manifold == "fill" else f"{told}: {flag_of('non_manifold')} fill adds to the solid there"]
