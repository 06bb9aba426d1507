# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimates of the number of cells made from a surface, and of the time and memory.

The constants are rounded from nine surfaces of 440 to 65,000 facets, with and without crossings, on two processors;
estimates for these were within a factor of 2.5 in the number of cells, and of 4 in time. Those of refined cells are from 40
surfaces of 140 to 48,000 facets: 32 estimates within a factor of 2. Long thin triangles need up to four times as many cells.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Mapping

from .options import OPTIONS, Options
from .vtkFiltersInsideOut import vtkBoundaryLayers, vtkRefineTetrahedra

PIECES_OF_PAIR = 1.5  # additional facets per intersecting pair
CELLS_OF_FACET = 2.0
REFINED_CELLS_OF_FACET = 4.5
REFINED_CELLS_OF_CUBE = 6.0  # whose edges have the requested length
TRIANGLES_OF_SQUARE = 2.3  # regular ones, whose edges have this length
SIDES_OF_CUBE = 6.0  # the wall's area is estimated as that of a cube of the same volume

SECONDS_OF_FACET, SECONDS_OF_PAIR, SECONDS_OF_REFINED_CELL = 20e-6, 300e-6, 15e-6
MEBIBYTES_ANYWAY, MEBIBYTES_OF_CELL, MEBIBYTES_OF_REFINED_CELL = 100.0, 1e-3, 4e-4


@dataclass
class Estimate:
    """The estimated work on a surface, or on several."""

    cells: float = 0
    seconds: float = 0
    mebibytes: float = MEBIBYTES_ANYWAY
    layer_cells: float = 0
    """The cells in layers, which `cells` include."""

    def __add__(self, other: Estimate) -> Estimate:
        both = self.mebibytes + other.mebibytes - MEBIBYTES_ANYWAY
        layer_cells = self.layer_cells + other.layer_cells
        return Estimate(self.cells + other.cells, self.seconds + other.seconds, both, layer_cells)

    def words(self) -> str:
        if not math.isfinite(self.cells):
            return "more tetrahedra than can be counted"
        seconds = "a second at most" if self.seconds <= 1 else f"{_rounded(self.seconds)} s"
        cells = f"cells, {_rounded(self.layer_cells)} of them in layers" if self.layer_cells else "tetrahedra"
        return f"about {_rounded(self.cells)} {cells}, in {seconds} with {_rounded(self.mebibytes)} MiB"


def estimate(statistics: Mapping[str, float], options: Options) -> Estimate:
    """Estimate the work on the solid in a surface from the statistics of its check. Lengths in the options are
    numbers."""
    pieces = statistics["Facets"] + PIECES_OF_PAIR * statistics["IntersectingPairs"]
    cells = CELLS_OF_FACET * pieces
    seconds = SECONDS_OF_FACET * statistics["Facets"] + SECONDS_OF_PAIR * statistics["IntersectingPairs"]
    mebibytes = MEBIBYTES_ANYWAY + MEBIBYTES_OF_CELL * cells
    layer_cells = 0.0
    if options.refines():
        cells = REFINED_CELLS_OF_FACET * pieces
        if options.edge_length:
            length = float(options.edge_length)
            # Divide one by one: the cube of a length may exceed all doubles.
            cells += REFINED_CELLS_OF_CUBE * max(statistics["EnclosedVolume"], 0) / length / length / length
        layer_cells = _cells_in_layers(statistics, options, pieces) if options.makes_layers() else 0
        cells += layer_cells
        seconds += SECONDS_OF_REFINED_CELL * cells
        mebibytes += MEBIBYTES_OF_REFINED_CELL * cells
    return Estimate(cells, seconds, mebibytes, layer_cells)


def _cells_in_layers(statistics: Mapping[str, float], options: Options, pieces: float) -> float:
    """One prism per layer and boundary triangle."""
    triangles = pieces
    if options.edge_length:
        sides = max(statistics["EnclosedVolume"], 0) ** (1 / 3) / float(options.edge_length)
        triangles = TRIANGLES_OF_SQUARE * SIDES_OF_CUBE * sides * sides
    return layers_of(options) * triangles


def layers_of(options: Options) -> int:
    """The number of layers that the options request."""
    return int(OPTIONS["layers"].used_by(options.set_on(vtkBoundaryLayers(), ["layers"]), options.layers))


def is_beyond_limit(estimate: Estimate, options: Options) -> bool:
    """Whether the lengths would make more than `maximum_cells` cells: the work stops before refining."""
    name = "maximum_cells"
    limit = OPTIONS[name].used_by(options.set_on(vtkRefineTetrahedra(), [name]), options.maximum_cells)
    return bool(options.edge_length and limit and estimate.cells - estimate.layer_cells > limit)


def _rounded(number: float) -> str:
    """Rounded to one significant digit."""
    return f"{float(f'{number:.0e}'):,.0f}"
