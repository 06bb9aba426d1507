#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measure whether solvers take the cells of surfaces, and whether there are as many as gmsh makes.

    measure-fit.py SURFACE...

Lines for machines: `ratio fit/refused N at most 0`, the cells that CalculiX refuses, and `ratio fit/wrong N at most 0`, the
solids that gmsh's check, *STATIC or *FREQUENCY find something wrong with, both by ../Judge/judge-fit.py; `ratio size/cells R
at most 1.3`, cells of the unit cube at edges of 0.05, against gmsh's.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import gmsh
import insideout

JUDGE = Path(__file__).resolve().parent.parent / "Judge" / "judge-fit.py"
LENGTH, MOST_CELLS = 0.05, 1.3
ANALYSES = 20


def cells_of_gmsh() -> int:
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.MeshSizeMin", LENGTH)
        gmsh.option.setNumber("Mesh.MeshSizeMax", LENGTH)
        gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(3)
        return sum(map(len, gmsh.model.mesh.getElements(3)[1]))
    finally:
        gmsh.finalize()


def own_cells() -> int:
    points = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    return len(insideout.tetrahedralize((points, triangles), edge_length=LENGTH).solid.cells)


def main(surfaces: list[str]) -> None:
    print(f"ratio size/cells {own_cells() / cells_of_gmsh():.3f} at most {MOST_CELLS}", flush=True)
    if not surfaces:
        return
    command = [sys.executable, JUDGE, *surfaces, "--diagonal", "100", "--analyses", str(ANALYSES)]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    print(done.stdout, end="")
    for name, pattern in (("refused", r"cells; (\d+) refused"), ("wrong", r"something wrong with (\d+) solids")):
        counts = re.findall(pattern, done.stdout)
        if not counts:
            sys.exit(f"measure-fit.py: the judge ended with status {done.returncode}")
        print(f"ratio fit/{name} {sum(map(int, counts))} at most 0", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
