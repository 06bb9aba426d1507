# SPDX-License-Identifier: GPL-3.0-or-later
"""A cantilever of five boxes that overlap, bent by pressure on its top, against beam theory.

    python3 cantilever.py FOLDER [EDGE_LENGTH]...

Each length of edges is a row of a table of Markdown, which goes to standard output: how far the tip goes down, and that
divided by what Timoshenko's theory says. The cells are of second order. Lengths are in units of the beam's height.
"""

from __future__ import annotations

import sys
from pathlib import Path

import insideout
import numpy as np
from calculix import CalculiXError, point_results, solve
from shapes import box, write_obj

LENGTH, PRESSURE, STIFFNESS, POISSON = 10.0, 1.0, 1e5, 0.3
SIZES = (0.8, 0.4, 0.2)
ENDS = ((0.0, 2.4), (2.0, 4.7), (4.3, 6.1), (5.8, 8.3), (8.0, LENGTH))  # of each box along the beam

JOB = f"""*INCLUDE, INPUT=cantilever.inp
*MATERIAL, NAME=some
*ELASTIC
{STIFFNESS}, {POISSON}
*SOLID SECTION, ELSET=Eall, MATERIAL=some
*BOUNDARY
clamp, 1, 3
*STEP
*STATIC
*DSLOAD
top, P, {PRESSURE}
*NODE FILE
U
*END STEP
"""


def theory() -> tuple[float, float]:
    """How far the tip goes down: by bending alone, and with shear (Timoshenko). Width and height are 1."""
    bending = PRESSURE * LENGTH**4 / (8 * STIFFNESS / 12)
    shear_modulus = STIFFNESS / (2 * (1 + POISSON))
    factor = 10 * (1 + POISSON) / (12 + 11 * POISSON)  # Cowper's, of a rectangle
    return bending, bending + PRESSURE * LENGTH**2 / (2 * factor * shear_modulus)


def tip_deflection(edge: float, folder: Path) -> tuple[int, int, float]:
    """Numbers of cells and points, and the mean over the end's points."""
    parts = []
    for low, high in ENDS:
        groups = {"z_high": "top", "x_low": "clamp" if low == 0 else "within"}
        parts += box((low, 0, 0), (high, 1, 1), edge, groups=groups)
    write_obj(parts, folder / "cantilever.obj")
    result = insideout.tetrahedralize(folder / "cantilever.obj", edge_length=edge, surface_treatment="kept", quadratic_cells=True)
    if abs(result.statistics["Volume"] - LENGTH) > 1e-9:
        raise insideout.Error(f"the beam's volume is {result.statistics['Volume']}, not {LENGTH}")
    insideout.write(result, folder / "cantilever.inp")
    solve(JOB, folder)
    points = result.solid.points
    moved = point_results(folder, "DISP", len(points))
    return len(result.solid.cells), len(points), -float(moved[points[:, 0] == LENGTH, 2].mean())


def main(folder: Path, sizes: tuple[float, ...]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    bending, timoshenko = theory()
    print(f"By bending alone the tip goes down {bending:.6g}, with shear {timoshenko:.6g}.\n")
    print("| edge length | cells | points | tip goes down | of theory |\n|---|---|---|---|---|")
    for edge in sizes:
        cells, points, found = tip_deflection(edge, folder)
        print(f"| {edge:g} | {cells:,} | {points:,} | {found:.6g} | {found / timoshenko:.5f} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    try:
        main(Path(sys.argv[1]), tuple(map(float, sys.argv[2:])) or SIZES)
    except (insideout.Error, CalculiXError) as error:
        sys.exit(f"cantilever.py: {error}")
