# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges surfaces that are repaired without tetrahedra: each is compared with the solid of tetrahedra.

    python3 judge-repair.py [--most FACETS] SURFACE...

The boundary of a closed surface has to bound the same volume to 1e-9. Its edges have equally many triangles in both
directions, and it does not cross itself. Open surfaces go through tetrahedra, and are counted. The processor time of
both ways is printed, too. The exit status is 0 if all holds.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import insideout
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData


def is_balanced(triangles: np.ndarray) -> bool:
    edges = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    ways = np.where(edges[:, 0] < edges[:, 1], 1, -1)
    _, edge = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    return not np.bincount(edge.ravel(), weights=ways).any()


def timed(surface: vtkPolyData, surface_only: bool) -> tuple[insideout.Tetrahedralization, float]:
    begin = time.process_time()
    made = insideout.tetrahedralize(surface, dimension=3, surface_only=surface_only)
    return made, time.process_time() - begin


def judge(path: str, most: int) -> str:
    """One word: what became of it."""
    surface, _ = insideout.files.read_surface(path)
    if surface.GetNumberOfCells() > most:
        return "larger"
    try:
        made, seconds = timed(surface, True)
    except insideout.Error as error:
        print(f"{Path(path).name}: {error}")
        return "refused"
    if made.statistics["Tetrahedra"]:
        return "open"
    expected, seconds_of_cells = timed(surface, False)
    volume = expected.statistics["Volume"]
    apart = abs(made.statistics["Volume"] - volume) / volume
    crossings = insideout.check(made.boundary, orientation="as-given").statistics["IntersectingPairs"]
    holds = apart <= 1e-9 and crossings == 0 and is_balanced(made.boundary.triangles)
    print(
        f"{Path(path).name:30} {surface.GetNumberOfCells():8} facets, {made.statistics['IntersectingPairs']:7} pairs that meet, "
        f"volumes apart by {apart:.1e}, {crossings} crossings, {seconds:.2f} and {seconds_of_cells:.2f} s{'' if holds else ' WRONG'}",
        flush=True,
    )
    return "holds" if holds else "wrong"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("surfaces", nargs="+", metavar="SURFACE")
    parser.add_argument("--most", type=int, default=100_000, help="facets; larger surfaces are passed over")
    options = parser.parse_args()
    words = [judge(path, options.most) for path in options.surfaces]
    print(", ".join(f"{words.count(word)} {word}" for word in ("holds", "wrong", "open", "larger", "refused")))
    return int("wrong" in words or "holds" not in words)


if __name__ == "__main__":
    sys.exit(main())
