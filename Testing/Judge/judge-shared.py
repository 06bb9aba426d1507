# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges whether closed surfaces in one mean the union of what each means, whatever they share.

    python3 judge-shared.py [--pairs N] [--triples N] [--seed N] [--merged] [--case NAME] [--report FOLDER] SURFACE...

Closed surfaces that face outward, half of them made and half of those given, are moved so that facets, parts of facets,
edges or points coincide exactly: coordinates are snapped to 2^-20 of the size, and every move is exact on what is shared.
The appended surface is meshed. Its volume has to be that of the union of the single ones by vtkWindingBoolean, to 1e-6,
and its closed shells as many as those of the single ones together. An inward one within another is a cavity. A line for
each kind of move says in how many cases that holds, and a line for each failure how it is made again: `--case pair/17`
with the same seed and surfaces. `--merged` makes one of points that coincide before. `--report` writes the surfaces that fail. Exit status 0 if 98 % of both hold.
"""

from __future__ import annotations

import argparse
import itertools
import sys
import warnings
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Callable, NamedTuple, Optional

import insideout
import numpy as np
from insideout.pipeline import set_threads
from insideout.surfaces import as_surface
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

GRID = 2.0**20
FINE_GRID = 2.0**30  # of what has been moved
MOST_FACETS = 2000
MOST_DRAWS = 200
SAME_VOLUME = 1e-6
GOAL = 0.98


class Surface(NamedTuple):
    points: np.ndarray
    triangles: np.ndarray


class Case(NamedTuple):
    moves: list[str]
    names: list[str]
    surfaces: list[Surface]
    volume: float
    shells: int


# Closed surfaces that are made


def boxes_of(cells: np.ndarray, random) -> Surface:
    """The boundary of the cells of a grid that are set: two triangles for each square."""
    points: dict[tuple[int, ...], int] = {}
    triangles = []
    padded = np.pad(cells, 1)
    for axis in range(3):
        before, behind = np.moveaxis(padded, axis, 0)[:-1], np.moveaxis(padded, axis, 0)[1:]
        for at in np.argwhere(before != behind):
            outward = before[tuple(at)]
            corners = []
            for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                point = np.zeros(3, int)
                point[axis] = at[0]
                others = [k for k in range(3) if k != axis]
                point[others] = at[1:] - 1 + (u, v)
                corners.append(points.setdefault(tuple(point), len(points)))
            if (axis == 1) == bool(outward):  # the other two axes in order make a left-handed frame
                corners.reverse()
            turn = random.integers(2)
            corners = corners[turn:] + corners[:turn]
            triangles += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    return Surface(np.array(list(points), float), np.array(triangles))


def cells_together(random) -> Surface:
    """Some cells of a grid that hang together by their faces."""
    cells = np.zeros((4, 4, 4), bool)
    at = random.integers(0, 4, 3)
    for _ in range(random.integers(2, 12)):
        cells[tuple(at)] = True
        axis = random.integers(3)
        at = at.copy()
        at[axis] = np.clip(at[axis] + random.choice([-1, 1]), 0, 3)
    return boxes_of(cells, random)


def block(random) -> Surface:
    return boxes_of(np.ones(random.integers(1, 5, 3), bool), random)


def box(random) -> Surface:
    made = boxes_of(np.ones((1, 1, 1), bool), random)
    return Surface(made.points * random.integers(1, 5, 3), made.triangles)


def hollow(random) -> Surface:
    """A block with a cavity."""
    cells = np.ones((3, 3, random.integers(3, 5)), bool)
    cells[1, 1, 1] = False
    return boxes_of(cells, random)


def ring(random) -> Surface:
    cells = np.ones((3, 3, random.integers(1, 4)), bool)
    cells[1, 1] = False
    return boxes_of(cells, random)


def apart(random) -> Surface:
    """Two boxes."""
    cells = np.zeros((3, 2, 2), bool)
    cells[0] = cells[2] = True
    return boxes_of(cells, random)


def prism(outline, height: float) -> Surface:
    """Above an outline that runs counter-clockwise around its first point, from where all of it is seen."""
    count = len(outline)
    points = np.array([(x, y, z) for z in (0, height) for x, y in outline], float)
    triangles = []
    for i in range(count):
        j = (i + 1) % count
        triangles += [(i, j, count + j), (i, count + j, count + i)]
    for i in range(1, count - 1):
        triangles += [(0, i + 1, i), (count, count + i, count + i + 1)]
    return Surface(points, np.array(triangles))


OUTLINES = {
    "wedge": [(0, 0), (4, 0), (0, 3)],
    "angle": [(2, 2), (2, 5), (0, 5), (0, 0), (6, 0), (6, 2)],
    "hexagon": [(1, 0), (3, 0), (4, 2), (3, 4), (1, 4), (0, 2)],
    "trapezium": [(0, 0), (6, 0), (4, 2), (2, 2)],
    "arrow": [(2, 1), (4, 0), (2, 5), (0, 0)],
}


def outlined(random) -> Surface:
    outline = OUTLINES[random.choice(list(OUTLINES))]
    return prism(outline, int(random.integers(1, 5)))


def cylinder(random) -> Surface:
    count = int(random.integers(5, 40))
    angles = 2 * np.pi * np.arange(count) / count
    return prism(np.column_stack([np.cos(angles), np.sin(angles)]), float(random.uniform(0.2, 3)))


def simplex(random) -> Surface:
    points = random.integers(-8, 9, (4, 3)).astype(float)
    while abs(np.linalg.det(points[1:] - points[0])) < 8:
        points = random.integers(-8, 9, (4, 3)).astype(float)
    triangles = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    return Surface(points, triangles if np.linalg.det(points[1:] - points[0]) > 0 else triangles[:, ::-1])


def octahedron(random) -> Surface:
    points = np.array([sign * np.eye(3)[axis] for axis in range(3) for sign in (1, -1)])
    triangles = []
    for x, y, z in itertools.product((0, 1), repeat=3):
        corners = (x, 2 + y, 4 + z)
        triangles.append(corners if (x + y + z) % 2 == 0 else corners[::-1])
    return Surface(points * random.integers(1, 4, 3), np.array(triangles))


def torus(random) -> Surface:
    around, across = int(random.integers(4, 20)), int(random.integers(3, 12))
    points, triangles = [], []
    for i in range(around):
        for j in range(across):
            a, b = 2 * np.pi * i / around, 2 * np.pi * j / across
            radius = 3 + np.cos(b)
            points.append((radius * np.cos(a), radius * np.sin(a), np.sin(b)))
            p, q = i * across + j, (i + 1) % around * across + j
            r, s = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            triangles += [(p, q, r), (p, r, s)]
    return Surface(np.array(points), np.array(triangles))


MADE: list[Callable[[np.random.Generator], Surface]] = [box, block, cells_together, hollow, ring, apart, outlined, cylinder, simplex, octahedron, torus]


# Surfaces on a grid


def snapped(points: np.ndarray) -> np.ndarray:
    return np.round(points * GRID) / GRID


def cleaned(points: np.ndarray, triangles: np.ndarray) -> Surface:
    """Equal points are one, and triangles without area are left out."""
    unique, index = np.unique(points + 0.0, axis=0, return_inverse=True)
    triangles = index.ravel()[triangles]
    a, b, c = unique[triangles].transpose(1, 0, 2)
    return Surface(unique, triangles[(np.cross(b - a, c - a) != 0).any(axis=1)])


def normalized(surface: Surface) -> Surface:
    """In the unit cube, on the grid, with an even number of its steps between points, so that middles are on it."""
    low = surface.points.min(axis=0)
    size = np.ptp(surface.points, axis=0).max()
    integers = np.abs(surface.points).max() < 100 and (surface.points == np.round(surface.points)).all()
    scale = 2.0 ** -np.ceil(np.log2(size)) if integers else 1 / size
    return cleaned(4 * snapped((surface.points - low) * scale / 4), surface.triangles)


def reversed_surface(surface: Surface) -> Surface:
    return Surface(surface.points, surface.triangles[:, ::-1])


def joined(surfaces: list[Surface]) -> Surface:
    firsts = np.cumsum([0] + [len(surface.points) for surface in surfaces])
    return Surface(np.vstack([s.points for s in surfaces]), np.vstack([s.triangles + first for s, first in zip(surfaces, firsts)]))


def shells_alone(surface: Surface) -> Optional[list[frozenset]]:
    """The facets of each shell; None where the surface is open or does not face outward."""
    if len(surface.triangles) < 4:
        return None
    s = insideout.check(surface, orientation="as-given").statistics
    if s["UnbalancedEdges"] or s["Planar"] or s["ClosedShells"] != s["Shells"] or s["DegenerateFacets"] or s["DuplicateFacets"]:
        return None
    found = insideout.check(surface)
    wrong = ("TurnedFacets", "DisagreeingFacets", "UndecidedShells", "Membranes", "TwoSidedSolids", "TwoSidedSheets")
    if any(found.statistics[name] for name in wrong):
        return None
    shells: list[set] = [set() for _ in range(found.statistics["Shells"])]
    for shell, corners in zip(found.surface.cell_arrays["ShellId"], surface.points[surface.triangles].tolist()):
        shells[shell].add(tuple(sorted(map(tuple, corners))))
    return [frozenset(shell) for shell in shells]


# Moves. Each gives what is put beside, above or into a surface; None where it has no place there.


def height_above(surface: Surface, facet: int) -> tuple[np.ndarray, np.ndarray]:
    """Exact heights above a facet's plane, times the length of its normal, and that normal."""
    integers = (surface.points * FINE_GRID).astype(np.int64).astype(object)
    a, b, c = integers[surface.triangles[facet]]
    u, v = b - a, c - a
    normal = np.array([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], object)
    return (integers - a) @ normal, normal


def moved_from_plane(surface: Surface, facet: int, factor: float, slope: np.ndarray) -> np.ndarray:
    """Multiply heights above a facet's plane, and slide along it by a slope; what lies in the plane stays."""
    heights, normal = height_above(surface, facet)
    n = normal.astype(float) / FINE_GRID**2
    h = heights.astype(float) / FINE_GRID**3
    along = slope - n * (slope @ n) / (n @ n)
    moved = surface.points + np.outer(h / (n @ n), (factor - 1) * n) + np.outer(h / np.sqrt(n @ n), along)
    return np.where((heights == 0)[:, None], surface.points, snapped(moved))


def reflect(surface: Surface, random) -> Surface:
    """In the plane of a facet."""
    facet = random.integers(len(surface.triangles))
    return reversed_surface(Surface(moved_from_plane(surface, facet, -1, np.zeros(3)), surface.triangles))


def stretch(surface: Surface, random) -> Surface:
    """Away from the plane of a facet, or towards it."""
    facet = random.integers(len(surface.triangles))
    slope = random.choice([0, 0.5], 3) * random.integers(2)
    return Surface(moved_from_plane(surface, facet, random.choice([0.5, 2]), slope), surface.triangles)


def along_facet(surface: Surface, random) -> np.ndarray:
    """Part of an edge."""
    triangle = random.permutation(surface.triangles[random.integers(len(surface.triangles))])
    step = surface.points[triangle[1]] - surface.points[triangle[0]]
    return step * random.choice([0.25, 0.5, 0.75, 1])


def slide(surface: Surface, random) -> Surface:
    return Surface(surface.points + along_facet(surface, random), surface.triangles)


def reflect_and_slide(surface: Surface, random) -> Surface:
    facet = random.integers(len(surface.triangles))
    mirrored = moved_from_plane(surface, facet, -1, np.zeros(3))
    corners = surface.points[random.permutation(surface.triangles[facet])]
    step = (corners[1] - corners[0]) * random.choice([0.25, 0.5, 0.75, 1])
    return reversed_surface(Surface(mirrored + step, surface.triangles))


def point_on(surface: Surface, random) -> np.ndarray:
    """A corner, the middle of an edge, or a point within a facet."""
    corners = surface.points[random.permutation(surface.triangles[random.integers(len(surface.triangles))])]
    return np.array([(1, 0, 0), (0.5, 0.5, 0), (0.5, 0.25, 0.25)][random.integers(3)]) @ corners


def halve(surface: Surface, random) -> Surface:
    """About a point of the surface."""
    return Surface((surface.points + point_on(surface, random)) / 2, surface.triangles)


def point_reflect(surface: Surface, random) -> Surface:
    return reversed_surface(Surface(2 * point_on(surface, random) - surface.points, surface.triangles))


def turn(surface: Surface, random) -> Surface:
    """By right angles about a point of the surface, or mirrored."""
    at = point_on(surface, random)
    order = random.permutation(3)
    signs = random.choice([-1.0, 1.0], 3)
    moved = at + (surface.points - at)[:, order] * signs
    odd = (np.linalg.det(np.eye(3)[order]) * signs.prod()) < 0
    return Surface(moved, surface.triangles[:, ::-1] if odd else surface.triangles)


def onto(surface: Surface, other: Surface, random) -> Surface:
    """A side of the other's box in one of the surface's, outside of it or not; or a point at a point."""
    if random.integers(4) == 0:
        step = point_on(surface, random) - point_on(other, random)
    else:
        boxes = [(s.points.min(axis=0), s.points.max(axis=0)) for s in (surface, other)]
        axis = random.integers(3)
        step = random.integers(-2, 3, 3) / 4
        side, facing = random.integers(2), random.integers(3) > 0
        step += boxes[0][0] - boxes[1][0]
        step[axis] = boxes[0][side][axis] - boxes[1][1 - side if facing else side][axis]
    return Surface(other.points + step, other.triangles)


MOVES = {function.__name__: function for function in (reflect, stretch, slide, reflect_and_slide, halve, point_reflect, turn)}


# Cases


def drawn(reals: list[tuple[str, Surface]], random) -> tuple[str, Surface]:
    if reals and random.integers(2):
        return reals[random.integers(len(reals))]
    maker = MADE[random.integers(len(MADE))]
    return maker.__name__, normalized(maker(random))


def volume_of_union(surfaces: list[Surface]) -> float:
    return insideout.boolean([tuple(surface) for surface in surfaces], touch_tolerance=0).statistics["Volume"]


def placed_beside(surface: Surface, reals, random) -> tuple[str, str, Surface]:
    """The move, the name of another surface, and what becomes of it."""
    kind = [*MOVES, "onto"][random.integers(len(MOVES) + 1)]
    if kind == "onto":
        name, other = drawn(reals, random)
        return kind, name, cleaned(*onto(surface, other, random))
    return kind, "", cleaned(*MOVES[kind](surface, random))


def tried_case(count: int, reals, random) -> Optional[Case]:
    name, surface = drawn(reals, random)
    surfaces, names, moves = [surface], [name], []
    while len(surfaces) < count:
        move, other, placed = placed_beside(surfaces[random.integers(len(surfaces))], reals, random)
        moves.append(move)
        names += [other] if other else []
        surfaces.append(placed)
    alone = [shells_alone(s) for s in surfaces]
    if None in alone:
        return None
    shells = [shell for found in alone for shell in found]
    if len(set(shells)) < len(shells):  # one that is given twice is a duplicate
        return None
    volume = volume_of_union(surfaces)
    if count == 2 and moves[0] in ("halve", "stretch") and random.integers(2):
        outer, inner = (volume_of_union([s]) for s in surfaces)
        if abs(volume - outer) < 1e-9 * outer and inner < outer:
            return Case(["cavity"], names, [surfaces[0], reversed_surface(surfaces[1])], outer - inner, len(shells))
    order = random.permutation(count)
    return Case(moves, names, [surfaces[k] for k in order], volume, len(shells))


def case_of(name: str, seed: int, reals) -> Case:
    kind, _, number = name.partition("/")
    count = {"pair": 2, "triple": 3}[kind]
    for draw in range(MOST_DRAWS):
        case = tried_case(count, reals, np.random.default_rng([seed, count, int(number), draw]))
        if case is not None:
            return case
    raise SystemExit(f"{name}: no surfaces fit in {MOST_DRAWS} draws")


class Verdict(NamedTuple):
    case: str
    moves: list[str]
    names: list[str]
    volume: str  # what is wrong with it, or nothing
    shells: str


def judged(name: str, seed: int, merged: bool, reals, report: Optional[Path]) -> Verdict:
    case = case_of(name, seed, reals)
    together = joined(case.surfaces)
    if merged:
        together = cleaned(*together)
    result = insideout.tetrahedralize(tuple(together))
    s = result.statistics
    volume = shells = ""
    if abs(s["Volume"] - case.volume) > SAME_VOLUME * case.volume:
        volume = f"volume {s['Volume']:.9g} of {case.volume:.9g}"
    if s["Shells"] != case.shells or s["ClosedShells"] != case.shells:
        shells = f"{s['Shells']} shells, {s['ClosedShells']} closed, of {case.shells}"
    if report and (volume or shells):
        report.mkdir(parents=True, exist_ok=True)
        for number, surface in enumerate([*case.surfaces, together]):
            last = number == len(case.surfaces)
            insideout.write(as_surface(tuple(surface))[0], report / f"{name.replace('/', '-')}-{'all' if last else number}.ply")
    return Verdict(name, case.moves, case.names, volume, shells)


_reals: list[tuple[str, Surface]] = []
_options = argparse.Namespace()


def begin(reals, options) -> None:
    global _reals, _options
    _reals, _options = reals, options
    warnings.simplefilter("ignore")
    set_threads(1)


def judge(name: str) -> Verdict:
    return judged(name, _options.seed, _options.merged, _reals, _options.report)


def closed_ones(paths: list[str]) -> list[tuple[str, Surface]]:
    """The given surfaces that are closed, face outward, and have few facets."""
    found = []
    for path in paths:
        try:
            triangulate = vtkTriangleFilter()
            triangulate.SetInputData(as_surface(path)[0])
            triangulate.PassVertsOff()
            triangulate.PassLinesOff()
            triangulate.Update()
            surface = insideout.check(triangulate.GetOutput()).surface
            if not 4 <= len(surface.triangles) <= MOST_FACETS:
                continue
            real = normalized(Surface(surface.points.astype(float), surface.triangles))
            if shells_alone(real) is not None:
                found.append((Path(path).name.split(".")[0], real))
        except insideout.Error as error:
            print(f"{path}: {error}", file=sys.stderr)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pairs", type=int, default=2000)
    parser.add_argument("--triples", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--case", help="this one alone, as pair/17")
    parser.add_argument("--merged", action="store_true", help="points of the surfaces that coincide become one before")
    parser.add_argument("--report", type=Path)
    parser.add_argument("surfaces", nargs="*")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    reals = closed_ones(options.surfaces)
    cases = [options.case] if options.case else [f"pair/{k}" for k in range(options.pairs)] + [f"triple/{k}" for k in range(options.triples)]
    print(f"seed {options.seed}, {len(cases)} cases, {len(reals)} closed surfaces of {len(options.surfaces)} given, {len(MADE)} kinds of made ones", flush=True)
    right: dict[str, np.ndarray] = defaultdict(lambda: np.zeros(3, int))
    with ProcessPoolExecutor(options.processes, initializer=begin, initargs=(reals, options)) as pool:
        for found in pool.map(judge, cases, chunksize=8):
            kinds = ["all", found.case.split("/")[0], *sorted(set(found.moves))]
            for kind in kinds:
                right[kind] += (1, not found.volume, not found.shells)
            if found.volume or found.shells:
                wrong = ", ".join(filter(None, (found.volume, found.shells)))
                print(f"  --seed {options.seed} --case {found.case}: {' and '.join(found.moves)} of {', '.join(found.names)}: {wrong}", flush=True)
    for kind, (count, volumes, shells) in right.items():
        print(f"{kind:18} of {count:5}: volume {volumes / count:6.1%}, shells {shells / count:6.1%}")
    count, *holding = right["all"]
    return int(min(holding) < GOAL * count)


if __name__ == "__main__":
    sys.exit(main())
