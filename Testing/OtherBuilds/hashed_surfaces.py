# SPDX-License-Identifier: GPL-3.0-or-later
"""The surfaces that hash-classes.py runs the classes on, each with the arrays that options name."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Callable, NamedTuple

import insideout
import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData

TESTING = Path(__file__).resolve().parent.parent
sys.path.append(str(TESTING / "Python"))
import surfaces  # noqa: E402
from surfaces import add_array  # noqa: E402

FLAT_FILES = {"blunt-corner-of-a-needle", "near-sheets", "nearly-in-one-plane", "sheets-one-ulp-apart", "t-junctions"}
BOX_QUADS = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5), (3, 0, 4, 7))


class Surface(NamedTuple):
    make: Callable[[], vtkDataObject]
    group: str  # "space" or "plane"
    file: str = ""


def add_strings(data, name: str, values) -> None:
    array = vtkStringArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    data.AddArray(array)


def cells(polygons) -> vtkCellArray:
    return surfaces.polydata([], polygons).GetPolys()


def blocks(**parts: vtkPolyData) -> vtkMultiBlockDataSet:
    data = vtkMultiBlockDataSet()
    for k, (name, part) in enumerate(parts.items()):
        data.SetBlock(k, part)
        data.GetMetaData(k).Set(vtkMultiBlockDataSet.NAME(), name)
    return data


def turned_over(surface: vtkPolyData) -> vtkPolyData:
    return surfaces.polydata(surfaces.points_of(surface), surfaces.triangles_of(surface)[:, ::-1])


def tube(path, closed: bool) -> vtkPolyData:
    """A tube of square section along a path in the plane z = 0 that turns by right angles."""
    path, n = np.array(path, float), len(path)
    steps = np.sign(np.roll(path, -1, axis=0) - path)
    if not closed:
        steps[-1] = 0
    before = np.roll(steps, 1, axis=0)
    across = 0.5 * np.stack([-(steps + before)[:, 1], (steps + before)[:, 0]], axis=1)
    points = [(*(p + side * a), z) for p, a in zip(path, across) for side, z in ((1, -0.5), (1, 0.5), (-1, 0.5), (-1, -0.5))]
    polygons = []
    for i in range(n if closed else n - 1):
        for k in range(4):
            a, b, c, d = 4 * i + k, 4 * i + (k + 1) % 4, 4 * ((i + 1) % n) + k, 4 * ((i + 1) % n) + (k + 1) % 4
            polygons += [(a, b, c), (c, b, d)]
    if not closed:
        last = 4 * n - 4
        polygons += [(2, 1, 0), (3, 2, 0), (last, last + 1, last + 2), (last, last + 2, last + 3)]
    return surfaces.polydata(points, polygons)


def sheet(side: int, place=lambda x, y: (x, y, 0)) -> vtkPolyData:
    quads = [(i, i + 1, i + side + 1, i + side) for i in range(side * (side - 1)) if i % side < side - 1]
    triangles = [corners for a, b, c, d in quads for corners in ((a, b, c), (a, c, d))]
    return surfaces.polydata([place(i % side, i // side) for i in range(side * side)], triangles)


def walls() -> vtkPolyData:
    """A box that is inside out between two that share walls with it, a fourth apart, and a group for each."""
    middle = turned_over(surfaces.box((1, 0, 0)))
    surface = surfaces.joined(surfaces.box(), middle, surfaces.box((2, 0, 0)), surfaces.box((4, 0, 0)))
    add_array(surface.GetCellData(), "GroupIds", np.repeat(np.arange(4, dtype=np.int32), 12))
    add_strings(surface.GetFieldData(), "GroupNames", ["left", "middle", "right", "apart"])
    return surface


def hollows() -> vtkPolyData:
    """A box with two cavities that touch in a point, and two boxes beside it that touch in an edge."""
    cavities = [turned_over(surfaces.box((k, k, k))) for k in (1, 2)]
    return surfaces.joined(surfaces.box((0, 0, 0), 4), *cavities, surfaces.box((6, 0, 0)), surfaces.box((7, 1, 0), 2))


def seams() -> vtkPolyData:
    """A box each face of which has points, texture coordinates and normals of its own, and a scratch across it."""
    points, corners = surfaces.box_points(), [corner for quad in BOX_QUADS for corner in quad]
    surface = surfaces.polydata([points[k] for k in corners], np.arange(24).reshape(6, 4).tolist())
    data = surface.GetPointData()
    add_array(data, "TCoords", np.tile([(0, 0), (1, 0), (1, 1), (0, 1)], (6, 1)).astype(np.float32))
    normals = [(0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (1, 0, 0), (-1, 0, 0)]
    add_array(data, "Normals", np.repeat(normals, 4, axis=0).astype(np.float32))
    data.SetActiveTCoords("TCoords")
    data.SetActiveNormals("Normals")
    return surface


def open_balls() -> vtkPolyData:
    """Three balls that cross, each open at a pole."""
    balls = []
    for k in range(3):
        ball = surfaces.ball(1, 14, 12)
        triangles = [corners for corners in surfaces.triangles_of(ball).tolist() if 0 not in corners]
        balls.append(surfaces.polydata(surfaces.points_of(ball) + (0.75 * k, 0.125 * k, 0), triangles))
    return surfaces.joined(*balls)


def mixed_cells() -> vtkPolyData:
    """A box of quadrangles, a strip across it, and a line and a vertex, which are ignored."""
    surface = surfaces.polydata([*surfaces.box_points(), (0.5, -1, -1), (0.5, 2, -1), (0.5, -1, 2), (0.5, 2, 2)], BOX_QUADS)
    surface.SetStrips(cells([(8, 9, 10, 11)]))
    surface.SetLines(cells([(0, 6)]))
    surface.SetVerts(cells([(7,)]))
    return surface


def not_finite() -> vtkPolyData:
    return surfaces.polydata([*surfaces.box_points()[:7], (0, float("nan"), 1)], surfaces.BOX_FACETS)


def cloud() -> vtkPolyData:
    surface = vtkPolyData()
    surface.SetPoints(surfaces.ball(1, 16, 14).GetPoints())
    add_array(surface.GetPointData(), "Normals", surfaces.points_of(surface))
    surface.GetPointData().SetActiveNormals("Normals")
    add_array(surface.GetPointData(), "Weight", np.full(surface.GetNumberOfPoints(), 0.0625))
    return surface


def curves(points, lines) -> vtkPolyData:
    surface = surfaces.polydata([(*point, 0) for point in points], [])
    surface.SetLines(cells(lines))
    return surface


def square(x: float, y: float, size: float = 2) -> vtkPolyData:
    return curves([(x, y), (x + size, y), (x + size, y + size), (x, y + size)], [(0, 1, 2, 3, 0)])


def nested_squares() -> vtkPolyData:
    """An annulus, and two squares that touch in a corner, of which one is there twice."""
    rings = [(0, 0, 4), (1, 1, 2), (5, 0, 2), (7, 2, 1)]
    points = [(x + size * a, y + size * b) for x, y, size in rings for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return curves(points, [(0, 1, 2, 3, 0), (7, 6, 5, 4, 7), (8, 9, 10, 11, 8), (12, 13, 14, 15, 12), (12, 13, 14, 15, 12)])


def flat_polygons(turn) -> vtkPolyData:
    """Overlapping polygons in one plane."""
    points = [(0, 0), (4, 0), (4, 3), (1, 5), (2, 1), (6, 1), (6, 4), (2, 4)]
    return surfaces.polydata([turn(x, y) for x, y in points], [(0, 1, 2, 3), (4, 5, 6, 7)])


MADE = {
    "open-box": surfaces.open_box,
    "closed-both-ways": surfaces.closed_both_ways,
    "stray-facet": surfaces.two_boxes_and_a_stray_facet,
    "box-thrice": lambda: surfaces.joined(surfaces.box(), surfaces.box(), turned_over(surfaces.box())),
    "walls": walls,
    "hollows": hollows,
    "limbs": lambda: tube([(0, 0), (6, 0), (6, 3), (2, 3), (2, -3)], closed=False),
    "ring": lambda: tube([(0, 0), (4, 0), (4, 4), (0, 4)], closed=True),
    "seams": seams,
    "open-balls": open_balls,
    "cape": lambda: surfaces.joined(surfaces.ball(2, 12, 10), sheet(6, lambda x, y: (x - 2.5, 2 + y / 4, y / 2 - x * x / 8))),
    "flat-sheet": lambda: sheet(4),
    "mixed-cells": mixed_cells,
    "assembly": lambda: blocks(left=surfaces.box((0, 0, 0), 2), right=surfaces.box((1, 0, 0), 2), top=surfaces.open_box()),
    "turned-boxes": lambda: blocks(**dict(zip(("low", "high"), surfaces.turned_boxes(3)))),
    "not-finite": not_finite,
    "bad-id": lambda: surfaces.box(facets=[*surfaces.BOX_FACETS, (0, 1, 99)]),
    "empty": vtkPolyData,
    "cloud": cloud,
}
MADE_IN_A_PLANE = {
    "squares": lambda: curves([(0, 0), (2, 0), (2, 2), (0, 2), (1, 1), (3, 1), (3, 3), (1, 3)], [(0, 1, 2, 3, 0), (4, 5, 6, 7, 4)]),
    "nested-squares": nested_squares,
    "open-lines": lambda: curves([(0, 0), (4, 0), (4, 4), (0, 4), (0, 1), (2, -1), (2, 2)], [(0, 1, 2, 3, 4), (5, 6)]),
    "flat-polygons": lambda: flat_polygons(lambda x, y: (x, y, x + 2 * y)),
    "nearly-flat-polygons": lambda: flat_polygons(lambda x, y: (x / 3 + y / 7, x / 7 - y / 3, x / 11 + y / 13)),
    "blocks-of-squares": lambda: blocks(first=square(0, 0), second=square(1, 1), third=square(4, 0, 1)),
}


def read(path: Path) -> vtkPolyData:
    reader = insideout.vtkSurfaceReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def of_file(path: Path) -> Surface:
    return Surface(lambda: read(path), "plane" if path.stem in FLAT_FILES else "space", str(path.resolve()))


def all_surfaces(paths: list[str]) -> dict[str, Surface]:
    """Those of the repository and the files that are given, by name."""
    files = [TESTING / "Data/two-boxes.off", *sorted((TESTING / "Data/Corpus").glob("*.off")), *map(Path, paths)]
    found = {file.name: of_file(file) for file in files}
    found |= {name: Surface(make, "space") for name, make in MADE.items()}
    return found | {name: Surface(make, "plane") for name, make in MADE_IN_A_PLANE.items()}


def leaves_of(data: vtkDataObject) -> dict[str, vtkDataObject]:
    """The data sets in a composite one by the names of their blocks; any other is the only one."""
    if not isinstance(data, vtkMultiBlockDataSet):
        return {"": data}
    found = {}
    for k in range(data.GetNumberOfBlocks()):
        name = data.GetMetaData(k).Get(vtkMultiBlockDataSet.NAME()) if data.HasMetaData(k) else None
        if data.GetBlock(k) is not None:
            found |= {f"/{k}:{name}{below}": leaf for below, leaf in leaves_of(data.GetBlock(k)).items()}
    return found


def size_of(data: vtkDataObject) -> float:
    """The power of two next to the diagonal of the bounding box: exact when it is multiplied."""
    lengths = [leaf.GetLength() for leaf in leaves_of(data).values() if leaf.GetNumberOfPoints()]
    longest = max(lengths, default=1.0)
    return 2.0 ** round(np.log2(longest)) if 0 < longest < 1e300 else 1.0


def add_arrays(surface: vtkPolyData, size: float) -> None:
    """Arrays for the options that name one."""
    points, count = surfaces.points_of(surface), surface.GetNumberOfCells()
    position = add_array(surface.GetPointData(), "Position", points + 1.0)
    for k, name in enumerate("XYZ"):
        position.SetComponentName(k, name)
    add_array(surface.GetPointData(), "Size", size / 8 * (1 + np.arange(len(points)) % 3))
    add_strings(surface.GetCellData(), "Part", ["one" if 2 * k < count else "two" for k in range(count)])
    add_array(surface.GetCellData(), "Accessory", (np.arange(count) % 7 == 3).astype(np.int32))
    add_array(surface.GetCellData(), "Kept", (np.arange(count) % 2).astype(np.int32))


def inputs_of(surface: Surface) -> dict[str, object]:
    """The inputs of the classes, by the names in the tables of hash-classes.py."""
    data = surface.make()
    size = size_of(data)
    for leaf in leaves_of(data).values():
        add_arrays(leaf, size)
    first = next(iter(leaves_of(data).values()))
    low, high = np.array(first.GetBounds() if first.GetNumberOfPoints() else [0.0, 1.0] * 3).reshape(3, 2).T
    seeds = surfaces.polydata([low + 0.375 * (high - low), low + 0.0625 * (high - low)], [])
    add_array(seeds.GetPointData(), "Inside", np.array([1, 0], np.int32))
    add_strings(seeds.GetPointData(), "Body", ["one", ""])
    places = vtkImageData()
    places.SetDimensions(8, 8, 8)
    places.SetOrigin(low - size / 16)
    places.SetSpacing((high - low + size / 8) / 7)
    add_array(places.GetPointData(), "Size", size / 16 * (1 + np.arange(8**3) % 5))
    other = surfaces.box(low - size / 8, (high - low).max() / 2 + size / 8)
    given = {"surface": data, "seeds": seeds, "places": places, "other": other, "size": size}
    return given | ({"file": surface.file} if surface.file else {})
