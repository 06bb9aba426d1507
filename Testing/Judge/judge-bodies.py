# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges meshes of several bodies: real surfaces, made to overlap, become one mesh.

    python3 judge-bodies.py [--seed N] [--report FOLDER] SURFACE...

Each surface is scaled to size 1, turned at random and put at a random place of a cube of side 1.5, so that most of them cross
others. What has to hold: no cell is negative or flat and all fit together, exactly; each body that is closed has the volume
that it has alone, to 1e-9, and the regions of all combinations add up to it; each face between two regions is a face of two
cells, and is there once among the interfaces. Exit status 0 if all of it holds.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import insideout
import numpy as np

CUBE = 1.5


def scattered(paths: list[str], seed: int) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    random = np.random.default_rng(seed)
    surfaces = {}
    for number, path in enumerate(paths):
        surface = insideout.resolve(path).surface
        points = surface.points - surface.points.mean(axis=0)
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        turn[:, 0] *= np.sign(np.linalg.det(turn))
        placed = points / np.ptp(points, axis=0).max() @ turn.T + random.uniform(0, CUBE, 3)
        surfaces[f"{number}_{Path(path).name.split('.')[0]}"] = placed, surface.triangles
    return surfaces


def faces_beside(cells: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Each face of each cell by its points, ascending, and the cell; all sorted, so that those of two cells are in a row."""
    faces = np.vstack([np.sort(np.delete(cells, k, axis=1), axis=1) for k in range(4)])
    of_cell = np.tile(np.arange(len(cells)), 4)
    order = np.lexsort(faces.T[::-1])
    return faces[order], of_cell[order]


def interfaces_that_fail(result: insideout.Tetrahedralization) -> int:
    """How many faces between regions, or around them, are not there once, or more are there than there should be."""
    faces, of_cell = faces_beside(result.solid.cells)
    regions = result.solid.cell_arrays["RegionId"][of_cell]
    same = (faces[1:] == faces[:-1]).all(axis=1)
    more_than_two = int((same[1:] & same[:-1]).sum())
    first = np.flatnonzero(same)
    alone = ~np.append(same, False) & ~np.insert(same, 0, False)
    parting = first[regions[first] != regions[first + 1]]
    expected = np.vstack([faces[alone], faces[parting]])
    ids = {tuple(point): number for number, point in enumerate(result.solid.points.tolist())}
    at = np.array([ids[tuple(point)] for point in result.boundary.points.tolist()])
    found = np.sort(at[result.boundary.triangles], axis=1)
    unique, counts = np.unique(found, axis=0, return_counts=True)
    wrong = {tuple(face) for face in expected.tolist()} ^ {tuple(face) for face in unique.tolist()}
    return len(wrong) + int((counts > 1).sum()) + more_than_two


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("surfaces", nargs="+")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--report", type=Path)
    options = parser.parse_args()
    surfaces = scattered(options.surfaces, options.seed)
    result = insideout.tetrahedralize(surfaces, region_rule="all")
    if options.report:
        options.report.mkdir(parents=True, exist_ok=True)
        insideout.write(result.solid, options.report / "bodies.vtu")
        insideout.write(result.hull, options.report / "hull.vtu")
        insideout.write(insideout.bodies.join(surfaces)[0], options.report / "surface.vtp")
    print(f"{len(surfaces)} bodies, {len(result.regions)} regions, {len(result.solid.cells):,} cells")
    statistics = result.statistics
    print(f"{statistics['IntersectingPairs']:,.0f} pairs cross, {statistics['LeftOutFacets']:.0f} facets left out, {len(result.lost_cells)} lost")

    failures = 0
    solid = insideout.check_solid(result.solid).statistics
    bad = {name: solid[name] for name in ("NegativeCells", "FlatCells", "OverlappingFaces", "OpenFaces") if solid.get(name)}
    print("cells that are wrong:", bad or "none")
    failures += len(bad)
    wrong = interfaces_that_fail(result)
    print("faces between regions that are not there once:", wrong)
    failures += wrong
    for name, surface in surfaces.items():
        alone = insideout.tetrahedralize(surface)
        if not alone.statistics["Closed"] or alone.statistics["Volume"] == 0:
            print(f"  {name}: open, {result.bodies[name]:.6g} together, {alone.statistics['Volume']:.6g} alone")
            continue
        sums = sum(region.volume for region in result.regions if name in region.bodies)
        apart = max(abs(volume / alone.statistics["Volume"] - 1) for volume in (result.bodies[name], sums))
        print(f"  {name}: {result.bodies[name]:.9g}, apart {apart:.1e}")
        failures += apart > 1e-9
    print("ratio bodies/failures", failures, "at most 0")
    return int(failures > 0)


if __name__ == "__main__":
    sys.exit(main())
