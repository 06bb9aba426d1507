#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether set operations of real, dirty surfaces hold their laws, and what others make of the same pairs.

    judge-boolean.py [--pairs N] [--seed N] [--most-triangles N] [--tetrahedra-up-to N] [--peer PROGRAM] [--limit SECONDS]
        SURFACE...

Takes pairs of the surfaces at random, each scaled to one size, and turned and moved so that they cross: a third of two
surfaces, a third of a surface and its own moved copy, and a third that touch in a plane: the copy is moved within the
plane of its largest facet, or the largest facet of another is laid upon it. For each pair A, B it makes the union, the
intersection and the difference separately, and judges them:

    failed      no result, an error
    crossing    triangles of a result cross, or an edge is not run through as often one way as the other
    volumes     of two closed bodies |A| + |B| = |A or B| + |A and B| and |A - B| = |A| - |A and B|, to 1e-9 of |A| + |B|
    ways        with tetrahedra all three have the same volumes, to 1e-9 (surfaces of few triangles)

With --peer (JudgeBooleanPeers) CGAL's corefinement and Nef polyhedra, and always vtkBooleanOperationPolyDataFilter, make
the union, intersection and difference too, each in a process of its own, with a limit of time: how many complete, and
how often all three volumes are ours, to 1e-6. Exit status 1 where a law is broken.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Optional

import insideout
import numpy as np
from insideout.data import corners_of
from insideout.surfaces import as_surface, make_surface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

EXPRESSIONS = ("A | B", "A & B", "A - B")
OURS, THEIRS = 1e-9, 1e-6  # how exact volumes are to be, of |A| + |B|


def read(path: str) -> tuple[np.ndarray, np.ndarray]:
    """Points and triangles, in a box around the origin whose diagonal is 1."""
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(as_surface(path)[0])
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.Update()
    surface = triangulate.GetOutput()
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = corners_of(surface.GetPolys(), 3)
    used = points[triangles].reshape(-1, 3)
    low, high = used.min(axis=0), used.max(axis=0)
    return (points - (low + high) / 2) / np.linalg.norm(high - low), triangles


def turn(random: np.random.Generator) -> np.ndarray:
    """A random rotation."""
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def frame(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The middle of the largest triangle, and axes of which the third is its normal."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    largest = int(np.argmax(np.linalg.norm(np.cross(b - a, c - a), axis=1)))
    x = (b - a)[largest] / np.linalg.norm((b - a)[largest])
    z = np.cross(b - a, c - a)[largest]
    z = z / np.linalg.norm(z)
    return (a + b + c)[largest] / 3, np.array([x, np.cross(z, x), z])


def pair(kind: int, models: list, random: np.random.Generator) -> tuple[str, tuple, tuple]:
    """A description and two surfaces."""
    first, second = (models[int(random.integers(len(models)))] for _ in range(2))
    name, points, triangles = first
    if kind == 0:
        other, others, cells = second
        scale = float(random.uniform(0.5, 1.5))
        return f"{name} and {other}", (points, triangles), (scale * others @ turn(random).T + random.normal(size=3) / 8, cells)
    if kind == 1:
        moved = points @ turn(random).T if random.random() < 0.5 else points
        return f"{name} and its copy", (points, triangles), (moved + random.normal(size=3) / 10, triangles)
    middle, axes = frame(points, triangles)
    if random.random() < 0.5:
        return f"{name} and its copy in a plane", (points, triangles), (points + axes[0] * random.uniform(0.05, 0.3), triangles)
    other, others, cells = second
    center, own = frame(others, cells)
    upside = np.diag([1.0, -1.0, -1.0]) if random.random() < 0.5 else np.eye(3)
    return f"{name} and {other} in a plane", (points, triangles), ((others - center) @ own.T @ upside @ axes + middle, cells)


class Judge:
    def __init__(self, options: argparse.Namespace):
        self.options = options
        self.broken: list[str] = []
        self.counts: Counter = Counter()
        self.complete: Counter = Counter()
        self.right: Counter = Counter()

    def make(self, surfaces: list[vtkPolyData], expression: str, tetrahedra: bool = False) -> insideout.Boolean:
        made = insideout.boolean(surfaces, expression, tetrahedra=tetrahedra)
        if made.surface.GetNumberOfCells() > 0:
            found = insideout.check(made.surface, orientation="as-given").statistics
            if found["IntersectingPairs"] or found["UnbalancedEdges"]:
                raise ValueError(f"{expression}: {found['IntersectingPairs']} crossings, {found['UnbalancedEdges']} unbalanced edges")
        return made

    def judge(self, what: str, first: tuple, second: tuple) -> None:
        surfaces = [make_surface(*first), make_surface(*second)]
        size = len(first[1]) + len(second[1])
        try:
            alone = [self.make(surfaces, name) for name in "AB"]
            made = [self.make(surfaces, expression) for expression in EXPRESSIONS]
        except ValueError as error:
            self.broken.append(f"{what}: {error}")
            return
        except insideout.Error as error:
            self.broken.append(f"{what}: failed, {error}")
            return
        a, b = (one.statistics["Volume"] for one in alone)
        volumes = [one.statistics["Volume"] for one in made]
        closed = not any(one.statistics["Tetrahedra"] for one in (*alone, *made))
        self.counts["closed" if closed else "open"] += 1
        if closed:
            wrong = [a + b - volumes[0] - volumes[1], a - volumes[1] - volumes[2]]
            if max(map(abs, wrong)) > OURS * (a + b):
                self.broken.append(f"{what}: volumes are wrong by {wrong} of {a + b}")
            if size <= self.options.tetrahedra_up_to:
                self.compare_ways(what, surfaces, volumes, a + b)
        self.ask_peers(first, second, volumes, a + b)

    def compare_ways(self, what: str, surfaces: list[vtkPolyData], volumes: list[float], whole: float) -> None:
        self.counts["both ways"] += 1
        for expression, volume in zip(EXPRESSIONS, volumes):
            try:
                other = self.make(surfaces, expression, tetrahedra=True).statistics["Volume"]
            except (ValueError, insideout.Error) as error:
                self.broken.append(f"{what}: by tetrahedra, {error}")
                continue
            if abs(other - volume) > OURS * whole:
                self.broken.append(f"{what}: {expression} is {volume}, and {other} by tetrahedra")

    def ask_peers(self, first: tuple, second: tuple, volumes: list[float], whole: float) -> None:
        with tempfile.TemporaryDirectory() as folder:
            paths = [str(Path(folder, name + ".off")) for name in "AB"]
            for path, (points, triangles) in zip(paths, (first, second)):
                insideout.files.write_surface(make_surface(points, triangles), path)
            commands = {"vtkBooleanOperationPolyDataFilter": [sys.executable, __file__, "--vtk", *paths]}
            if self.options.peer:
                commands.update({name: [self.options.peer, name, *paths] for name in ("corefinement", "nef")})
            for name, command in commands.items():
                found = answer(command, self.options.limit)
                self.complete[name] += found is not None
                self.right[name] += found is not None and bool(np.allclose(found, volumes, rtol=0, atol=THEIRS * whole))


def answer(command: list[str], limit: float) -> Optional[list[float]]:
    """The three volumes, in the order of EXPRESSIONS; None where it does not come to its end."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=True)
        volumes = [float(word) for word in done.stdout.split()]
        return volumes if len(volumes) == 3 else None
    except (subprocess.SubprocessError, ValueError):
        return None  # it died, took too long or gave up


def by_vtk(paths: list[str]) -> None:
    """What vtkBooleanOperationPolyDataFilter makes: three volumes. Nothing where a result is open."""
    from vtkmodules.vtkFiltersGeneral import vtkBooleanOperationPolyDataFilter

    surfaces = [as_surface(path)[0] for path in paths]
    for operation in range(3):
        boolean = vtkBooleanOperationPolyDataFilter()
        for port, surface in enumerate(surfaces):
            boolean.SetInputData(port, surface)
        boolean.SetOperation(operation)
        boolean.Update()
        made = boolean.GetOutput()
        points = vtk_to_numpy(made.GetPoints().GetData()).astype(float)
        triangles = corners_of(made.GetPolys(), 3)
        a, b, c = (points[triangles[:, k]] for k in range(3))
        print(float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", metavar="SURFACE")
    parser.add_argument("--pairs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most-triangles", type=int, default=20000, help="larger surfaces are passed over")
    parser.add_argument("--tetrahedra-up-to", type=int, default=3000, help="both ways for pairs of at most so many triangles")
    parser.add_argument("--peer", help="the program JudgeBooleanPeers")
    parser.add_argument("--limit", type=float, default=20, help="seconds that a peer has for the three of a pair")
    parser.add_argument("--vtk", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.vtk:
        by_vtk(options.surfaces)
        return 0
    if options.peer and not Path(options.peer).exists():
        parser.error(f"there is no {options.peer}: build JudgeBooleanPeers")
    models = []
    for path in options.surfaces:
        try:
            points, triangles = read(path)
        except (insideout.Error, ValueError) as error:
            print(f"{path} is passed over: {error}")
            continue
        if 4 <= len(triangles) <= options.most_triangles:
            models.append((Path(path).name, points, triangles))
    random = np.random.default_rng(options.seed)
    judge = Judge(options)
    for index in range(options.pairs):
        judge.judge(*pair(index % 3, models, random))
        if (index + 1) % 20 == 0:
            print(f"{index + 1} pairs, {len(judge.broken)} laws broken", file=sys.stderr, flush=True)
    print(f"{options.pairs} pairs of {len(models)} surfaces: {dict(judge.counts)}")
    for name in judge.complete:
        print(f"{name}: completes {judge.complete[name]}, is right on {judge.right[name]}")
    print("\n".join(judge.broken) or "all laws hold")
    return int(bool(judge.broken))


if __name__ == "__main__":
    sys.exit(main())
