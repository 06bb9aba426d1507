# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts in pictures: titles, counts next to the colors of the counted items, and labels of places."""

from __future__ import annotations

import textwrap
from typing import Mapping, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkBillboardTextActor3D, vtkCoordinate, vtkPolyDataMapper2D, vtkProp, vtkTextActor

from .actors import CROSSING, DUPLICATE, INCONSISTENT, INK, NON_MANIFOLD, OPEN, TURNED, Colour
from .defects import DEFECTS, PLANAR_DEFECTS
from .verdict import verdict
from .view import HEIGHT, PANEL_WIDTH
from .worst import Place

DRAWN = {
    "IntersectingPairs": CROSSING,
    "Crossings": CROSSING,
    "TurnedFacets": TURNED,
    "OpenEdges": OPEN,
    "NonManifoldEdges": NON_MANIFOLD,
    "InconsistentEdges": INCONSISTENT,
    "DuplicateFacets": DUPLICATE,
    "OpenEnds": OPEN,
    "TJunctions": NON_MANIFOLD,
}
"""The colors of defects."""

LEFT = 0.06
"""The left end of a legend's lines, as a share of the panel."""

COLUMNS = 56
"""The largest number of letters of the usual size in a line of a panel."""

MOST_ROWS = 3
"""Layout of the lines beneath a drawing."""

TOP, BOTTOM, LINE, SIZE = 0.88, 0.03, 0.04, 24
"""Layout of a whole legend: position and line height, as fractions of the panel, and font size; smaller for long
legends.
"""

LETTERS = "ABCDEFGHIJ"


class Row(NamedTuple):
    """A line of a legend."""

    text: str
    colour: Optional[Colour] = None  # of its swatch


def counts(statistics: Mapping[str, float]) -> list[Row]:
    """The defects, worded as in the command's summary, with colors: first those that are drawn, then all others."""
    kinds = PLANAR_DEFECTS if statistics.get("Dimension", 3) == 2 else DEFECTS
    found = [defect for defect in kinds if statistics.get(defect.statistic, 0) > 0]
    found.sort(key=lambda defect: defect.statistic not in DRAWN)
    rows = [Row(defect.counted(statistics[defect.statistic]), DRAWN.get(defect.statistic)) for defect in found]
    return rows or [Row("nothing wrong")]


def title(text: str) -> vtkTextActor:
    """The heading of a panel."""
    return words(text, 0.95, size=30, bold=True)


def words(text: str, height: float, size: int = 24, bold: bool = False, left: Optional[float] = None) -> vtkTextActor:
    """A line at this height of a panel (0 to 1), centered, or starting at a position."""
    line = vtkTextActor()
    line.SetInput(text)
    look = line.GetTextProperty()
    look.SetColor(*INK)
    look.SetFontSize(size)
    look.SetBold(bold)
    if left is None:
        look.SetJustificationToCentered()
    look.SetVerticalJustificationToCentered()
    line.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    line.SetPosition(0.5 if left is None else left, height)
    return line


def swatch(colour: Colour, left: float, height: float, size: float = 0.022) -> vtkActor2D:
    """A colored square."""
    width = size * HEIGHT / PANEL_WIDTH
    points = vtkPoints()
    for x, y in ((0, -1), (1, -1), (1, 1), (0, 1)):
        points.InsertNextPoint(left + width * x, height + size / 2 * y, 0)
    square = vtkPolyData()
    square.SetPoints(points)
    cells = vtkCellArray()
    cells.InsertNextCell(4, (0, 1, 2, 3))
    square.SetPolys(cells)
    place = vtkCoordinate()
    place.SetCoordinateSystemToNormalizedViewport()
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(square)
    mapper.SetTransformCoordinate(place)
    drawn = vtkActor2D()
    drawn.SetMapper(mapper)
    drawn.GetProperty().SetColor(*colour)
    return drawn


def beneath(statistics: Mapping[str, float]) -> list[vtkProp]:
    """The first counts, under a drawing."""
    drawn: list[vtkProp] = []
    for k, row in enumerate(counts(statistics)[:MOST_ROWS]):
        height = 0.095 - 0.036 * k
        drawn += [] if row.colour is None else [swatch(row.colour, 0.3, height)]
        drawn.append(words(row.text, height, left=0.345))
    return drawn


def whole_legend(statistics: Mapping[str, float], places: Sequence[Place] = ()) -> list[vtkProp]:
    """A panel with everything: the verdict, each count and the worst places."""
    lines = [*(_Line(text) for text in textwrap.wrap(verdict(statistics), COLUMNS)), _GAP]
    lines += [_Line(row.text, row.colour, indent=0.045) for row in counts(statistics)]
    lines += [_GAP, _Line("The worst places", bold=True)] if places else []
    for letter, place in zip(LETTERS, places):
        told = [*textwrap.wrap(place.text, COLUMNS - 6), f"at {place.where}"]
        lines.append(_Line(told[0], DRAWN[place.statistic], letter, 0.09))
        lines += [_Line(text, indent=0.09) for text in told[1:]]
    step = min(LINE, (TOP - BOTTOM) / len(lines))
    size = round(SIZE * step / LINE)
    drawn: list[vtkProp] = [title("What is wrong")]
    for k, line in enumerate(lines):
        drawn += line.drawn(TOP - k * step, size)
    return drawn


class _Line(NamedTuple):
    """The content of one line of a legend."""

    text: str
    colour: Optional[Colour] = None
    letter: str = ""
    indent: float = 0
    bold: bool = False

    def drawn(self, height: float, size: int) -> list[vtkProp]:
        letter = [words(self.letter, height, size, True, LEFT)] if self.letter else []
        square = [swatch(self.colour, LEFT + self.indent - 0.045, height)] if self.colour else []
        text = [words(self.text, height, size, self.bold, LEFT + self.indent)] if self.text else []
        return [*letter, *square, *text]


_GAP = _Line("")


def label(letter: str, point: NDArray[np.float64]) -> vtkBillboardTextActor3D:
    """A letter at a position in space."""
    drawn = vtkBillboardTextActor3D()
    drawn.SetInput(letter)
    drawn.SetPosition(*point)
    drawn.SetDisplayOffset(14, 14)
    look = drawn.GetTextProperty()
    look.SetColor(*INK)
    look.SetFontSize(26)
    look.SetBold(True)
    look.SetBackgroundColor(1, 1, 1)
    look.SetBackgroundOpacity(0.85)
    look.SetFrame(True)
    look.SetFrameColor(*INK)
    return drawn
