# SPDX-License-Identifier: GPL-3.0-or-later
"""An .html page that shows a surface, its defects and its solid: one file for any browser, without further requests. It
contains the compressed bytes of all arrays, column by column, which `viewer.js` unpacks and draws.
"""

from __future__ import annotations

import base64
import html
import json
import os
import zlib
from string import Template
from typing import Any, Mapping, Optional, Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .actors import CROSSING_FACETS, EDGES, FACET_EDGES, INK, SOLID, SOUND, WITHIN, Colour, colours_of_w, lines_of, triangles_of
from .checking import Check
from .data import corners_of
from .legend import counts
from .pipeline import statistics_of
from .scenes import FACETS, LINES, MANY_LINES, THIN, WIDTH, kinds_of_facets
from .summary import lines_about_solid
from .tetrahedralization import inside_cells
from .verdict import verdict, what_it_bounds
from .version import __version__
from .view import View
from .worst import Place, segments_of, worst_places

LEVEL = 6
"""The level of compression."""

SMALLER = 0.6
"""Sizes of a panel and its lines, relative to those of pictures."""

COLOURS_OF_W = 256
"""The colors of w, from the smallest to the largest value with its own color."""


def page_of(checked: Check, hull: Optional[vtkUnstructuredGrid], solid: Optional[vtkUnstructuredGrid], title: str, up: Optional[str]) -> bytes:
    """The content of an .html file that shows a surface, its defects and, if there is a hull, its w and the solid in it.

    solid  the solid, if its cells are not those of the hull
    up     which axis is up
    """
    scene = Scene(triangles_of(checked.surface), checked.lines, up)
    # The hull's statistics are those of the run that made it, whose options the check may lack.
    statistics: dict[str, float] = {**statistics_of(checked.surface)}
    if hull is not None:
        statistics.update(statistics_of(hull))
    panels = [_panel("surface", "The surface and its defects", "".join(f"<span>{_row(*row)}</span>" for row in counts(statistics)))]
    if hull is not None:
        scene.add_hull(hull, solid)
        panels += [
            _panel("slice", "Winding number w, a slice of the hull", _scale()),
            _panel("solid", "The tetrahedra inside, cut open", f"{(solid or inside_cells(hull)).GetNumberOfCells():,} tetrahedra"),
        ]
    return _fill(
        "page.html",
        version=html.escape(__version__),
        title=html.escape(title),
        verdict=html.escape(_sentence(verdict(statistics))),
        panels="\n".join(panels),
        cut="" if hull is None else _cut(scene.view),
        report=_report(checked, statistics, scene.places_to_see(), hull is not None),
        scene=json.dumps(scene.described()).replace("<", r"\u003c"),
        data=base64.b64encode(scene.packed()).decode("ascii"),
        viewer=_text_of("viewer.js"),
    ).encode()


class Scene:
    """The arrays that are drawn, and how the viewer shows them."""

    def __init__(self, marked: vtkPolyData, lines: vtkPolyData, up: Optional[str]):
        self.marked, self.lines = marked, lines
        self.view = View(marked, up)
        bounds = np.array(marked.GetBounds()).reshape(3, 2)
        self.center = bounds.mean(axis=1)
        self.extent = (bounds[:, 1] - bounds[:, 0]) / 2
        self.radius = float(np.linalg.norm(self.extent)) or 1.0
        self.arrays: list[tuple[dict[str, Any], bytes]] = []
        self._add_surface()

    def _add_surface(self) -> None:
        kinds = kinds_of_facets(self.marked)
        # The first of several coincident facets is visible, so duplicates come before the facets that they repeat.
        triangles, order = rows_by_least(corners_of(self.marked.GetPolys(), 3), len(FACETS) - kinds)
        self.add("surfacePoints", "floats", self._places(self.marked))
        self.add("surface", "ids", relative(triangles))
        self.add("kinds", "bytes", kinds[order])
        parts = [lines_of(self.lines, kind) for kind, _ in LINES]
        ends = [self._places(part)[segments_of(part)].reshape(-1, 6) for part in parts]
        self.add("lines", "floats", np.concatenate(ends))
        self.add("lineKinds", "bytes", np.repeat(np.arange(len(parts), dtype=np.uint8), [len(rows) for rows in ends]))
        self.line_width = (WIDTH if sum(map(len, ends)) <= MANY_LINES else THIN) * SMALLER

    def add_hull(self, hull: vtkUnstructuredGrid, solid: Optional[vtkUnstructuredGrid]) -> None:
        """All cells, those inside first, and a separate solid if there is one."""
        cells, w = corners_of(hull.GetCells(), 4), vtk_to_numpy(hull.GetCellData().GetArray("w"))
        outside = vtk_to_numpy(hull.GetCellData().GetArray("Inside")) == 0
        cells, order = rows_by_least(np.sort(cells, axis=1), outside if solid is None else np.zeros(len(cells)))
        self.add("points", "floats", self._places(hull))
        self.add("cells", "ids", relative(cells))
        least, most = colours_of_w().GetRange()
        self.add("w", "bytes", np.rint((w[order].clip(least, most) - least) / (most - least) * (COLOURS_OF_W - 1)).astype(np.uint8))
        if solid is None:
            cells = cells[: np.count_nonzero(~outside)]
        else:
            cells = corners_of(solid.GetCells(), solid.GetCells().GetMaxCellSize())[:, :4] if solid.GetNumberOfCells() else cells[:0]
            cells, _ = rows_by_least(np.sort(cells, axis=1), np.zeros(len(cells)))
            self.add("solidPoints", "floats", self._places(solid))
            self.add("solid", "ids", relative(cells))
        self.add("outer", "bytes", outer_faces(cells))

    def add(self, name: str, kind: str, values: NDArray[Any]) -> None:
        """An array of "bytes", or of four-byte "floats" or "ids"."""
        rows = np.ascontiguousarray(values.reshape(len(values), *values.shape[1:2] or (1,)), {"bytes": np.uint8, "floats": np.float32, "ids": np.uint32}[kind])
        self.arrays.append(({"name": name, "kind": kind, "rows": len(rows), "columns": rows.shape[1]}, rows.view(np.uint8).T.tobytes()))

    def packed(self) -> bytes:
        return zlib.compress(b"".join(content for _, content in self.arrays), LEVEL)

    def described(self) -> dict[str, Any]:
        return {
            "arrays": [described for described, _ in self.arrays],
            "center": self.center.tolist(),
            "radius": self.radius,
            "extent": (self.extent / self.radius).tolist(),
            "view": {
                "eye": self.view.eye.tolist(),
                "up": self.view.up.tolist(),
                "size": [length / self.radius for length in self.view.size],
            },
            "lineWidth": self.line_width,
            "colors": {
                "facets": [_bytes_of(colour, colour in (SOUND, CROSSING_FACETS)) for colour in FACETS],
                "lines": [_bytes_of(colour) for _, colour in LINES],
                "facetEdges": _bytes_of(FACET_EDGES),
                "within": WITHIN,
                "solid": _bytes_of(SOLID),
                "edges": _bytes_of(EDGES),
                "ink": _bytes_of(INK),
                "w": [_bytes_of(colour) for colour in _colours_of_w(COLOURS_OF_W)],
            },
        }

    def places_to_see(self) -> list[tuple[Place, list[float]]]:
        """The worst places, and the points where they are drawn."""
        return [(place, ((place.point - self.center) / self.radius).round(5).tolist()) for place in worst_places(self.marked, self.lines)]

    def _places(self, data: Any) -> NDArray[np.float32]:
        """Points scaled for drawing, within a ball of radius 1."""
        if data.GetNumberOfPoints() == 0:
            return np.zeros((0, 3), np.float32)
        places = (vtk_to_numpy(data.GetPoints().GetData()).astype(float) - self.center) / self.radius
        return places.astype(np.float32)


def rows_by_least(rows: NDArray[np.int64], groups: NDArray[Any]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The rows, each rotated to begin with its smallest id, sorted by group and that id; and their original indices."""
    first = rows.argmin(axis=1)
    turned = np.take_along_axis(rows, (first[:, np.newaxis] + np.arange(rows.shape[1])) % rows.shape[1], axis=1)
    order = np.lexsort((turned[:, 0], groups))
    return turned[order], order


def relative(rows: NDArray[np.int64]) -> NDArray[np.uint32]:
    """Differences modulo 2^32: the first column to the row before, the others to the first column."""
    least = rows[:, :1]
    return np.hstack([np.diff(least, axis=0, prepend=0), rows[:, 1:] - least]).astype(np.uint32)


def outer_faces(cells: NDArray[np.int64]) -> NDArray[np.uint8]:
    """A bit for each corner of tetrahedra with ascending corners: whether the opposite face belongs to no other one."""
    if len(cells) == 0:
        return np.zeros(0, np.uint8)
    faces = np.concatenate([np.delete(cells, k, axis=1) for k in range(4)])
    count = int(cells.max()) + 1
    edges = faces[:, 0] * count + faces[:, 1]
    if count > 2**21:
        edges = np.unique(edges, return_inverse=True)[1].ravel()
    key = edges * count + faces[:, 2]
    order = np.argsort(key)
    same = np.flatnonzero(np.diff(key[order]) == 0)
    alone = np.ones(len(faces), bool)
    alone[order[same]] = alone[order[same + 1]] = False
    return np.packbits(alone.reshape(4, -1), axis=0, bitorder="little")[0]


def _colours_of_w(count: int) -> list[Colour]:
    colours = colours_of_w()
    least, most = colours.GetRange()
    return [colours.GetColor(w) for w in np.linspace(least, most, count)]


def _bytes_of(colour: Colour, is_darker_within: bool = False) -> list[int]:
    return [*(round(255 * part) for part in colour), 255 * is_darker_within]


def _css(colour: Colour) -> str:
    return "#" + "".join(f"{round(255 * part):02x}" for part in colour)


def _panel(name: str, heading: str, beneath: str) -> str:
    """One drawing, with markup beneath it."""
    return (
        f'<figure id="{name}"><figcaption>{heading}<button class="enlarge" aria-label="enlarge, or make small again">&#x2922;</button></figcaption>'
        f'<canvas tabindex="0" aria-label="{heading}"></canvas><div class="beneath">{beneath}</div></figure>'
    )


def _scale() -> str:
    """The scale of colors for w."""
    least, most = colours_of_w().GetRange()
    colours = ", ".join(map(_css, _colours_of_w(25)))
    numbers = "".join(f"<span>{w:g}</span>" for w in np.arange(least, most + 0.25, 0.5))
    return f'<div class="scale"><div class="bar" style="background: linear-gradient(to right, {colours})"></div><div class="numbers">{numbers}</div></div>'


def _cut(view: View) -> str:
    """The controls of the cutting plane, which starts in the middle, across the view's axis."""
    first = int(np.abs(view.slice_normal).argmax())
    axes = "".join(
        f'<label><input type="radio" name="axis" value="{k}"{" checked" * (k == first)}> {name}</label>' for k, name in enumerate("xyz")
    )
    return (
        '<form id="cut"><strong>Cut across</strong>'
        f'{axes}<input type="range" id="position" min="-1" max="1" value="0" step="0.002" aria-label="position of the cut"><output id="place"></output>'
        '<label><input type="checkbox" id="other"> the other half</label></form>'
    )


def _row(text: str, colour: Optional[Colour] = None) -> str:
    swatch = f'<span class="swatch" style="background: {_css(colour)}"></span>' if colour else ""
    return swatch + html.escape(text)


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + "."


def _report(checked: Check, statistics: Mapping[str, float], places: Sequence[tuple[Place, list[float]]], has_hull: bool) -> str:
    consequences = {finding.text: finding.consequence for finding in checked.findings}
    wrong = []
    for row in counts(statistics):
        consequence = consequences.get(row.text, "")
        wrong.append(_row(*row) + (f'<span class="more">{html.escape(consequence)}</span>' if consequence else ""))
    seen = [
        f'{_row(place.text)} <button data-place="{point}">look</button><span class="more">at {html.escape(place.where)}</span>'
        for place, point in places
    ]
    sections: list[tuple[str, list[str]]] = [("What is wrong", wrong), ("The worst places", seen), ("The surface", [html.escape(line) for line in what_it_bounds(statistics)])]
    if has_hull:
        sections.append(("The solid", [html.escape(line.strip()) for line in lines_about_solid(statistics)]))
    sections.append(("Worth knowing", [html.escape(line) for line in checked.warnings]))
    return "\n".join(
        f"<section><h2>{heading}</h2><ul>{''.join(f'<li>{line}</li>' for line in lines)}</ul></section>" for heading, lines in sections if lines
    )


def _text_of(name: str) -> str:
    """A file beside this one."""
    with open(os.path.join(os.path.dirname(__file__), name), encoding="utf-8") as file:
        return file.read()


def _fill(name: str, **values: str) -> str:
    return Template(_text_of(name)).substitute(values)
