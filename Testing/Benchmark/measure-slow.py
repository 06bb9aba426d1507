# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor seconds of the command line on surfaces that take long, on one thread, against what they should take.

    measure-slow.py [--limit SECONDS] [--sides N...] [SURFACE...]

Makes prisms of N sides, 64, 250, 1,000 and 4,000 unless others are named: 10 high, 100 wide, both caps fans from one corner, so
that all corners lie on one sphere. SURFACE... are files of one's own; those that have a target are known by their names. A run
that is not over after the limit, 120 s by the clock, is stopped. Prints a row per surface and, for machines, ratio lines as
Measure.h does: seconds where there is a target, and a prism's cells per side.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import resource
import tempfile
from pathlib import Path

from meshers import mesh_as_it_comes

SIDES = (64, 250, 1000, 4000)
MOST_CELLS_PER_SIDE = 4
LIMITS = {  # seconds, by the names of files
    "manifold_plate-7081-left": 30,
    "pt_gopher": 10,
    "baxter-common_basic_hard_tip": 60,
    "PX4-SITL_gazebo-classic_omnicopter": 10,
    "ROBOTIS-OP3-Common_op3_description_ll4": 3,
}


def write_prism(path: Path, sides: int) -> None:
    """Write a prism both caps of which are fans from a corner, as OFF."""
    angles = [2 * math.pi * i / sides for i in range(sides)]
    points = [(50 * math.cos(a), 50 * math.sin(a), z) for z in (0, 10) for a in angles]
    facets = []
    for i in range(sides):
        j = (i + 1) % sides
        facets += [(i, j, sides + j), (i, sides + j, sides + i)]
    for i in range(1, sides - 1):
        facets += [(0, i + 1, i), (sides, sides + i, sides + i + 1)]
    lines = ["OFF", f"{len(points)} {len(facets)} 0"]
    lines += [" ".join(map(repr, p)) for p in points]
    lines += [f"3 {a} {b} {c}" for a, b, c in facets]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def processor_seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measure(path: Path, limit: float) -> None:
    """Print the row of a surface, and its ratios."""
    name = path.stem
    with tempfile.TemporaryDirectory() as folder:
        before = processor_seconds()
        trouble = mesh_as_it_comes(str(path), Path(folder), limit)
        seconds = processor_seconds() - before
        if trouble:
            print(f"{name:40} {seconds:9.2f} s   {trouble}", flush=True)
            return
        figures = json.loads((Path(folder) / "report.json").read_text(encoding="utf-8"))["statistics"]
    lost = figures["LostFacets"]
    print(
        f"{name:40} {seconds:9.2f} s   {figures['InputTriangles']:.0f} facets, {figures['HullCells']:.0f} cells in the hull,"
        f" {lost:.0f} facets lost",
        flush=True,
    )
    if name in LIMITS:
        print(f"ratio slow/{name} {seconds:.2f} at most {LIMITS[name]}")
    if name.startswith("prism-"):
        print(f"ratio slow/{name} {figures['HullCells'] / int(name[6:]):.2f} at most {MOST_CELLS_PER_SIDE}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limit", type=float, default=120)
    parser.add_argument("--sides", type=int, nargs="*", default=SIDES)
    parser.add_argument("surfaces", nargs="*", type=Path)
    given = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    with tempfile.TemporaryDirectory() as folder:
        for sides in given.sides:
            prism = Path(folder) / f"prism-{sides}.off"
            write_prism(prism, sides)
            measure(prism, given.limit)
    for surface in given.surfaces:
        measure(surface, given.limit)


if __name__ == "__main__":
    main()
