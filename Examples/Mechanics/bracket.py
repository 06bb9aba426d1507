# SPDX-License-Identifier: GPL-3.0-or-later
"""A bracket of boxes and cylinders that overlap, with holes left open, under a load: from a dirty surface to stresses.

    xvfb-run -a python3 bracket.py FOLDER [EDGE_LENGTH]

Writes into the folder: bracket.obj, the surface with the groups body, clamp and load; bracket.inp, the mesh of cells of
second order; job.inp and what CalculiX makes of it; bracket.vtu, the mesh with displacements and stresses; bracket.png.
Lengths are in mm, forces in N, stresses in MPa.
"""

from __future__ import annotations

import sys
from pathlib import Path

import insideout
import numpy as np
from calculix import CalculiXError, solve, total_force, with_results
from insideout.scenes import defect_lines
from shapes import Part, box, cylinder, strut, without, write_obj

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above

PRESSURE, BOSS = 4.0, 14.0
AROUND_BOSS = 24
LOAD = PRESSURE * AROUND_BOSS / 2 * BOSS**2 * np.sin(2 * np.pi / AROUND_BOSS)  # on a polygon, not on a circle

JOB = f"""*INCLUDE, INPUT=bracket.inp
*MATERIAL, NAME=steel
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=Eall, MATERIAL=steel
*BOUNDARY
clamp, 1, 3
*STEP
*STATIC
*DSLOAD
load, P, {PRESSURE}
*NODE PRINT, NSET=clamp, TOTALS=ONLY
RF
*NODE FILE
U
*EL FILE
S
*END STEP
"""


def bracket(edge: float, is_closed: bool = False) -> list[Part]:
    """A wall, bolted, with a shelf on struts, and a boss on that. Without holes if it is to be closed."""
    left_out = (lambda *sides: ()) if is_closed else (lambda *sides: sides)
    wall = box((0, -40, 0), (10, 40, 100), edge)
    shelf = box((4, -35, 60), (90, 35, 70), edge, left_out=left_out("x_low"))
    parts = [*wall, *shelf]
    for y in (-26.0, 26.0):
        parts += strut((5, y, 18), (52, y, 65), 8, 8, edge, left_out=left_out("z_low", "z_high"))
        for z in (13.1, 86.3):
            parts += cylinder((-6, y + np.sign(y) * 4.2, z), (15, y + np.sign(y) * 4.2, z), 6, edge, caps=("clamp", "body"))
    around = 2 * np.pi * BOSS / AROUND_BOSS
    parts += cylinder((68, 0, 63), (68, 0, 82), BOSS, around, caps=("body" if is_closed else None, "load"))
    return parts if is_closed else [without(part, 3) if part is wall[1] or part is shelf[-1] else part for part in parts]


def draw(surface: Path, solved, picture: Path) -> None:
    checked = insideout.check(surface)
    counts = checked.statistics
    given = [drawing.actor(checked.surface, edges=True), *defect_lines(checked.lines)]
    largest = np.linalg.norm(drawing.point_array(solved, "Displacement"), axis=1).max()
    stress = drawing.point_array(solved, "MisesStress")
    drawing.save(
        [
            drawing.Panel(
                "A dirty bracket",
                f"{counts['IntersectingPairs']:,} pairs of facets cross, {counts['OpenEdges']} open edges",
                given,
            ),
            drawing.Panel(
                "Its cells, of second order",
                f"{solved.GetNumberOfCells():,} cells, {solved.GetNumberOfPoints():,} points, cut open",
                [drawing.actor(drawing.cut_open(solved, (0, 0, 0), (0, -1, 0)), drawing.BLUE, edges=True)],
            ),
            drawing.Panel(
                "Stress under load, by CalculiX",
                f"blue 0 to red {np.percentile(stress, 99.5):.0f} MPa; moves {largest:.3f} mm, drawn 100 times",
                [drawing.coloured(drawing.warped(solved, "Displacement", 100), "MisesStress", (0, np.percentile(stress, 99.5)))],
            ),
        ],
        picture,
        seen_from=(1.2, -1.6, 0.7),
    )


def main(folder: Path, edge: float) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    write_obj(bracket(edge), folder / "bracket.obj")
    result = insideout.tetrahedralize(folder / "bracket.obj", edge_length=edge, surface_treatment="kept", quadratic_cells=True)
    insideout.write(result, folder / "bracket.inp")
    write_obj(bracket(edge, is_closed=True), folder / "closed.obj")
    closed = insideout.tetrahedralize(folder / "closed.obj").statistics["Volume"]
    volume = result.statistics["Volume"]
    print(f"{len(result.solid.cells):,} cells, volume {volume:.1f} mm3; with its holes closed by hand {closed / volume - 1:+.1e}")

    solve(JOB, folder)
    solved = with_results(result.solid, folder)
    insideout.write(solved, folder / "bracket.vtu")
    reaction = total_force(folder)
    apart, across = reaction[2] / LOAD - 1, np.abs(reaction[:2]).max()
    print(f"load {LOAD:.6g} N downward, reaction {reaction[2]:.6g} N: {apart:+.1e}; across {across:.1e} N")
    draw(folder / "bracket.obj", solved, folder / "bracket.png")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    try:
        main(Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 5.0)
    except (insideout.Error, CalculiXError) as error:
        sys.exit(f"bracket.py: {error}")
