# SPDX-License-Identifier: GPL-3.0-or-later
"""As-rigid-as-possible deformation in the volume and on the surface alone (the thesis's figure 8.19), of a broken model.

    xvfb-run -a python3 deformation.py PICTURE.png [SURFACE HANDLES.json]

The file of handles has a list "handles" of boxes, "low" and "high" in fractions of the model's own box, and how what is
within moves: by "angle" degrees about "axis" through "about", also in fractions. A handle of angle 0 stays where it is. Both methods are
that of Sorkine and Alexa (2007), with the same code: edges' weights are those of the tetrahedra, or of the boundary's
triangles, none below 0. Without a surface it is diplodocus.off of Debian's package libcgal-demo, and handles.json beside this script.
Plain numpy and scipy.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np
from fem import monotone, same_places, stiffness
from scipy import sparse
from scipy.sparse.linalg import splu

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

MOST_ROUNDS = 300
STILL = 2e-4  # of the model's size: ends when no point moves more in a round


class Deformation:
    """Points, a matrix of weights that is factorized once, and which of the points are held."""

    def __init__(self, points: np.ndarray, matrix: sparse.csr_matrix, held: np.ndarray):
        self.points = points
        pairs = sparse.triu(matrix, 1).tocoo()
        self.one, self.other, self.weights = pairs.row, pairs.col, -pairs.data
        self.edges = points[self.one] - points[self.other]
        self.held = held
        self.free = np.setdiff1d(np.flatnonzero(matrix.diagonal() > 0), held)
        rows = matrix[self.free]
        self.to_held = rows[:, held]
        self.factors = splu(rows[:, self.free].tocsc())

    def rotations(self, places: np.ndarray) -> np.ndarray:
        """For each point that which takes its edges best to where they are now."""
        products = self.weights[:, None, None] * self.edges[:, :, None] * (places[self.one] - places[self.other])[:, None, :]
        sums = self._at_both_ends(products.reshape(-1, 9), 1).reshape(-1, 3, 3)
        u, _, v = np.linalg.svd(sums)
        v[np.linalg.det(u @ v) < 0, 2] *= -1
        return (u @ v).transpose(0, 2, 1)

    def solve(self, rotations: np.ndarray, targets: np.ndarray) -> np.ndarray:
        """Where the edges agree best with the rotations, and the held points are at their targets."""
        turned = np.einsum("eij,ej->ei", rotations[self.one] + rotations[self.other], self.edges) * self.weights[:, None] / 2
        places = self.points.copy()
        places[self.held] = targets
        places[self.free] = self.factors.solve(self._at_both_ends(turned, -1)[self.free] - self.to_held @ targets)
        return places

    def _at_both_ends(self, values: np.ndarray, sign: int) -> np.ndarray:
        shape = (len(self.points), len(self.one))
        edges = np.arange(len(self.one))
        first, second = (sparse.csr_matrix((np.ones(len(edges)), (ends, edges)), shape=shape) for ends in (self.one, self.other))
        return (first + sign * second) @ values

    def run(self, targets: np.ndarray, start: np.ndarray) -> tuple[np.ndarray, int]:
        size = np.ptp(self.points, axis=0).max()
        places = start.copy()
        for step in range(1, MOST_ROUNDS + 1):
            before, places = places, self.solve(self.rotations(places), targets)
            if np.abs(places - before).max() < STILL * size:
                break
        return places, step


def cotangents(points: np.ndarray, triangles: np.ndarray) -> sparse.csr_matrix:
    """The matrix of a surface: half the cotangents of the angles opposite each edge."""
    total = sparse.csr_matrix((len(points), len(points)))
    for k in range(3):
        a, b, c = (triangles[:, (k + step) % 3] for step in range(3))
        u, v = points[a] - points[c], points[b] - points[c]
        area = np.maximum(np.linalg.norm(np.cross(u, v), axis=1), 1e-9 * (u * u + v * v).sum(axis=1))
        weights = sparse.csr_matrix((-(u * v).sum(axis=1) / area / 2, (a, b)), shape=total.shape)
        total = total + weights + weights.T
    return (total - sparse.diags(np.asarray(total.sum(axis=1)).ravel())).tocsr()


def turned(points: np.ndarray, handle: dict, low: np.ndarray, size: np.ndarray) -> np.ndarray:
    axis = np.array(handle["axis"], float) / np.linalg.norm(handle["axis"])
    about = low + size * handle["about"]
    angle = np.radians(handle["angle"])
    away = points - about
    along = np.outer(away @ axis, axis)
    return about + along + np.cos(angle) * (away - along) + np.sin(angle) * np.cross(axis, away)


def targets_of(points: np.ndarray, handles: list[dict]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Which points are held, where they go, and a start for all: a mixture of the handles' motions."""
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    owner = np.full(len(points), -1)
    nearness = np.zeros((len(handles), len(points)))
    moved = []
    for k, handle in enumerate(handles):
        least, most = low + size * handle["low"], low + size * handle["high"]
        outside = np.maximum(np.maximum(least - points, points - most), 0)
        owner[(outside == 0).all(axis=1)] = k
        nearness[k] = 1 / (np.linalg.norm(outside, axis=1) + 1e-6 * size.max()) ** 2
        moved.append(turned(points, handle, low, size))
    held = np.flatnonzero(owner >= 0)
    start = np.einsum("kp,kpx->px", nearness / nearness.sum(axis=0), np.array(moved))
    return held, np.array(moved)[owner[held], held], start


def volume(points: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", np.cross(a, b), c) / 6)


def main(picture: Path, surface: Path, handles: list[dict]) -> None:
    result = insideout.tetrahedralize(surface, refine=True)
    points, triangles = result.boundary.points, result.boundary.triangles
    there = same_places(result.solid.points, points)
    before = volume(points, triangles)
    ways = {
        "In the volume": (result.solid.points, monotone(stiffness(result.solid.points, result.solid.cells)[0]), there),
        "On the surface alone": (points, monotone(cotangents(points, triangles)), np.arange(len(points))),
    }
    panels = [drawing.Panel("The solid's boundary", f"volume {before:.4g}", [drawing.actor(result.boundary)])]
    for name, (all_points, matrix, boundary) in ways.items():
        held, targets, start = targets_of(all_points, handles)
        places, rounds = Deformation(all_points, matrix, held).run(targets, start)
        change = volume(places[boundary], triangles) / before - 1
        missed = np.abs(places[held] - targets).max()
        print(f"{name}: {len(all_points):,} points, {rounds} rounds, handles missed by {missed:g}, volume {100 * change:+.2f} %")
        seen = insideout.TriangleSurface()
        seen.DeepCopy(result.boundary)
        seen.points[:] = places[boundary]
        panels.append(drawing.Panel(name, f"volume {100 * change:+.2f} %", [drawing.actor(seen, drawing.BLUE)]))
    drawing.save(panels, picture, seen_from=(0.25, -0.1, 1), up=(0, 1, 0))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as folder:
            given = Path(sys.argv[2]) if len(sys.argv) > 2 else models.unpacked("diplodocus.off", Path(folder))
            file = Path(sys.argv[3]) if len(sys.argv) > 3 else Path(__file__).with_name("handles.json")
            main(Path(sys.argv[1]), given, json.loads(file.read_text())["handles"])
    except (insideout.Error, OSError, ValueError, KeyError) as error:
        sys.exit(f"deformation.py: {error}")
