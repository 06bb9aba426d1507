# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges whether bodies that touch but for the rounding of their coordinates become one interface.

    python3 judge-touching.py [--turns N] [--seed N] [--only NAME]

Ten assemblies are each turned and moved at random. Coordinates are rounded to floats and to 6, 7 and 9 digits, or left
in doubles, in a random order, and each face is triangulated at random. Each interface has to have the area that it has
unrounded, but for rounding ("touch"; "advised": with the tolerance that a warning advises, where it warns); no facet is
left out or lost; and bodies that are ten roundings apart stay so ("apart"). A line for each assembly and grid has the
number of turns in which this holds. The exit status is 0 if it holds in all.
"""

from __future__ import annotations

import argparse
import re
import sys
import warnings
from dataclasses import dataclass
from typing import Callable, Iterator

import insideout
import numpy as np

Surface = tuple[np.ndarray, np.ndarray]


@dataclass
class Assembly:
    """Bodies, and the area of each interface by its tag; along `apart` the last body can be moved away from all."""

    bodies: dict[str, tuple[np.ndarray, list[tuple[int, ...]]]]
    areas: dict[str, float]
    apart: tuple[float, float, float] | None = None
    priority: str | None = None


def box(low, high):
    """Points, and quadrilaterals that face outward."""
    corners = np.array([[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)], float)
    return corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def prism(outline, low: float, high: float):
    """Above an outline that runs counter-clockwise around its first point, from where all of it is seen."""
    count = len(outline)
    points = np.array([(x, y, z) for z in (low, high) for x, y in outline], float)
    sides = [(i, (i + 1) % count, count + (i + 1) % count, count + i) for i in range(count)]
    bottom = [(0, i + 1, i) for i in range(1, count - 1)]
    return points, [*sides, *bottom, *(tuple(count + p for p in reversed(t)) for t in bottom)]


def plate(low, high, across: int, along: int):
    """A box with top and bottom of as many quadrilaterals; the sides are fans."""
    xs, ys = np.linspace(low[0], high[0], across + 1), np.linspace(low[1], high[1], along + 1)
    points = np.array([(x, y, z) for z in (low[2], high[2]) for x in xs for y in ys])

    def at(i, j, k):
        return (k * (across + 1) + i) * (along + 1) + j

    quads = [(at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1)) for i in range(across) for j in range(along)]
    quads += [(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)) for i in range(across) for j in range(along)]
    for i in range(across):
        quads += [(at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1)), (at(i + 1, along, 0), at(i, along, 0), at(i, along, 1), at(i + 1, along, 1))]
    for j in range(along):
        quads += [(at(0, j + 1, 0), at(0, j, 0), at(0, j, 1), at(0, j + 1, 1)), (at(across, j, 0), at(across, j + 1, 0), at(across, j + 1, 1), at(across, j, 1))]
    return points, quads


def circle(count: int, radius: float, phase: float = 0.0) -> np.ndarray:
    angles = 2 * np.pi * (np.arange(count) + phase) / count
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def area_of_outline(outline: np.ndarray) -> float:
    x, y = outline.T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def block_and_stud(random) -> Assembly:
    x, y = random.uniform(1, 17, 2)
    bodies = {"a": box((0, 0, 0), (37, 37, 37)), "b": box((x, y, 37), (x + 18.5, y + 18.5, 50))}
    return Assembly(bodies, {"a|b": 18.5**2}, (0, 0, 1))


def stacked_plates(random) -> Assembly:
    bodies = {"a": plate((0, 0, 0), (40, 30, 2), 3, 4), "b": plate((0, 0, 2), (40, 30, 5), 5, 2)}
    return Assembly(bodies, {"a|b": 1200}, (0, 0, 1))


def cylinder_in_hole(random) -> Assembly:
    count = 24
    hole, rim = circle(count, 8), circle(count, 20, 0.5)
    points = np.array([(x, y, z) for outline in (hole, rim) for z in (0, 12) for x, y in outline])
    faces = []
    for i in range(count):
        j = (i + 1) % count
        faces += [(i, count + i, count + j, j), (2 * count + i, 2 * count + j, 3 * count + j, 3 * count + i)]
        faces += [(i, j, 2 * count + i), (j, 2 * count + j, 2 * count + i)]
        faces += [(count + i, 3 * count + i, count + j), (count + j, 3 * count + i, 3 * count + j)]
    side = float(np.linalg.norm(hole[1] - hole[0]))
    return Assembly({"ring": (points, faces), "pin": prism(hole, 0, 12)}, {"pin|ring": count * side * 12})


def tee(random) -> Assembly:
    bodies = {"bar": box((0, 0, 20), (40, 10, 28)), "leg": box((15, 0, 0), (25, 10, 20))}
    return Assembly(bodies, {"bar|leg": 100}, (0, 0, -1))


def corner(random) -> Assembly:
    bodies = {"floor": box((0, 0, 0), (30, 30, 3)), "wall": box((0, 0, 3), (4, 30, 25)), "crate": box((4, 6, 3), (16, 19, 14))}
    return Assembly(bodies, {"floor|wall": 120, "crate|floor": 156, "crate|wall": 143}, (1, 0, 1))


def angle_and_cube(random) -> Assembly:
    outline = [(6, 6), (6, 25), (0, 25), (0, 0), (20, 0), (20, 6)]
    bodies = {"angle": prism(outline, 0, 15), "cube": box((6, 6, 2), (15, 15, 11))}
    return Assembly(bodies, {"angle|cube": 162}, (1, 1, 0))


def cap_on_flat(random) -> Assembly:
    rings, count = 4, 16
    heights = np.linspace(0, np.pi / 2, rings, endpoint=False)
    points = [(*place, 8 + 9 * np.sin(h)) for h in heights for place in circle(count, 9 * np.cos(h)) + 15]
    faces = [(r * count + i, r * count + (i + 1) % count, (r + 1) * count + (i + 1) % count, (r + 1) * count + i) for r in range(rings - 1) for i in range(count)]
    top = len(points)
    points.append((15, 15, 17))
    faces += [((rings - 1) * count + i, (rings - 1) * count + (i + 1) % count, top) for i in range(count)]
    faces += [(0, i + 1, i) for i in range(1, count - 1)]
    bodies = {"flat": box((0, 0, 0), (30, 30, 8)), "cap": (np.array(points), faces)}
    return Assembly(bodies, {"cap|flat": area_of_outline(circle(count, 9))}, (0, 0, 1))


def nested(random) -> Assembly:
    bodies = {"inner": box((5, 6, 10), (14, 13, 20)), "outer": box((0, 0, 0), (20, 20, 20))}
    return Assembly(bodies, {"inner|outside": 63}, priority="inner")


def wall(random) -> Assembly:
    bodies, areas, course = {}, {}, {}
    for row in range(3):
        for k in range(3):
            low = 20 * k + 10 * (row % 2)
            bodies[f"{row}{k}"] = box((low, 0, 6 * row), (low + 20, 9, 6 * row + 6))
            course[row, k] = low
    for (row, k), low in course.items():
        for (other, n), beside in course.items():
            if other == row and n == k + 1:
                areas[f"{row}{k}|{other}{n}"] = 54.0
            elif other == row + 1 and abs(low - beside) == 10:
                areas[f"{row}{k}|{other}{n}"] = 90.0
    return Assembly(bodies, areas)


def hexagon_on_plate(random) -> Assembly:
    outline = circle(6, 7, random.uniform()) + 15
    bodies = {"plate": plate((0, 0, 0), (30, 30, 3), 4, 4), "bolt": prism(outline, 3, 9)}
    return Assembly(bodies, {"bolt|plate": area_of_outline(outline)}, (0, 0, 1))


ASSEMBLIES: dict[str, Callable[[np.random.Generator], Assembly]] = {
    function.__name__: function
    for function in (block_and_stud, stacked_plates, cylinder_in_hole, tee, corner, angle_and_cube, cap_on_flat, nested, wall, hexagon_on_plate)
}


def digits(count: int) -> Callable[[np.ndarray], np.ndarray]:
    return np.vectorize(lambda x: float(f"{x:.{count}g}"))


GRIDS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "floats": lambda points: points.astype(np.float32).astype(float),
    **{f"{count} digits": digits(count) for count in (6, 7, 9)},
    "doubles": lambda points: points,
}


def rounding_of(grid: str, size: float) -> float:
    """Half the spacing at a coordinate."""
    if grid == "doubles":
        return float(np.spacing(size)) / 2
    if grid == "floats":
        return float(np.spacing(np.float32(size))) / 2
    return 0.5 * 10.0 ** (np.floor(np.log10(size)) + 1 - int(grid.split()[0]))


def triangles(faces, random) -> np.ndarray:
    """Quadrilaterals are cut along either diagonal."""
    found = []
    for face in faces:
        if len(face) == 4 and random.integers(2):
            face = face[1:] + face[:1]
        found += [(face[0], face[k], face[k + 1]) for k in range(1, len(face) - 1)]
    return np.array(found)


@dataclass
class Turned:
    bodies: dict[str, Surface]
    assembly: Assembly
    rounding: float
    scale: float


def turned(assembly: Assembly, grid: str, random, gap: float = 0) -> Turned:
    """In a random order. With a gap, in roundings, beside the last body."""
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    scale = 10 ** random.uniform(-3, 3)
    middle = scale * random.uniform(-60, 60, 3)
    placed = {name: scale * points @ turn.T + middle for name, (points, _) in assembly.bodies.items()}
    rounding = rounding_of(grid, max(np.abs(points).max() for points in placed.values()))
    if gap:
        placed[list(placed)[-1]] += gap * rounding * turn @ np.array(assembly.apart)
    order = random.permutation(list(placed))
    bodies = {str(name): (GRIDS[grid](placed[name]), triangles(assembly.bodies[name][1], random)) for name in order}
    return Turned(bodies, assembly, rounding, scale)


def advised(bodies: dict[str, Surface], **options) -> float:
    """The largest tolerance that the warnings of bodies as they are advise; 0 where there is none."""
    lines = insideout.tetrahedralize(bodies, touch_tolerance=0, **options).warnings
    return max((float(found[1]) for line in lines if (found := re.search(r"touch_tolerance (\S+) makes", line))), default=0)


def areas_by_tag(boundary) -> dict[str, float]:
    a, b, c = boundary.points[boundary.triangles].transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    tags = boundary.cell_arrays["BoundaryTag"]
    names = boundary.GetFieldData().GetAbstractArray("BoundaryTagNames")
    found: dict[str, float] = {}
    for number in range(names.GetNumberOfValues()):
        key = "|".join(sorted(names.GetValue(number).split("|")))
        found[key] = found.get(key, 0) + float(areas[tags == number].sum())
    return found


def wrong(case: Turned, apart: bool, **options) -> str:
    """The first fault of the mesh of a case; empty if there is none."""
    result = insideout.tetrahedralize(case.bodies, priority=case.assembly.priority, **options)
    found = areas_by_tag(result.boundary)
    statistics = result.statistics
    if statistics["LeftOutFacets"] or len(result.lost_cells) :
        return f"{statistics['LeftOutFacets']:.0f} facets left out, {len(result.lost_cells)} lost"
    for tag, area in case.assembly.areas.items():
        tag = "|".join(sorted(tag.split("|")))
        allowed = 8 * case.rounding * 4 * np.sqrt(area) * case.scale + 1e-9 * area * case.scale**2
        expected = 0 if apart and list(case.assembly.bodies)[-1] in tag.split("|") else area * case.scale**2
        if abs(found.get(tag, 0) - expected) > allowed:
            return f"{tag} is {found.get(tag, 0) / case.scale**2:.6g} of {expected / case.scale**2:.6g} +- {allowed / case.scale**2:.2g}"
    return ""


def judged(name: str, grid: str, turns: int, seed: int) -> Iterator[tuple[str, int, str]]:
    """For each kind of case its turn and what is wrong."""
    for turn in range(turns):
        random = np.random.default_rng([seed, turn, list(ASSEMBLIES).index(name), list(GRIDS).index(grid)])
        assembly = ASSEMBLIES[name](random)
        touching = turned(assembly, grid, random)
        if grid != "doubles":
            yield "touch", turn, wrong(touching, False)
        tolerance = advised(touching.bodies, priority=assembly.priority)
        if tolerance > 0:
            yield "advised", turn, wrong(touching, False, touch_tolerance=tolerance)
        if assembly.apart and grid != "doubles":
            yield "apart", turn, wrong(turned(assembly, grid, random, gap=10), True)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--turns", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=ASSEMBLIES)
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    failures = 0
    for name in [options.only] if options.only else ASSEMBLIES:
        for grid in GRIDS:
            found: dict[str, list[str]] = {}
            for kind, turn, what in judged(name, grid, options.turns, options.seed):
                found.setdefault(kind, []).append(what and f"turn {turn}: {what}")
            for kind, cases in found.items():
                bad = [case for case in cases if case]
                failures += len(bad)
                print(f"{name:16} {grid:8} {kind}: {len(cases) - len(bad)} of {len(cases)}", *bad[:2], sep="  ", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
