# SPDX-License-Identifier: GPL-3.0-or-later
"""A broken figure under gravity: what the ground carries is what the solid weighs.

    python3 weight.py FOLDER [SURFACE [UP]]

SURFACE is any that InsideOut reads, such as the thesis's Beast; without one it is camel.off of Debian's package
libcgal-demo. Up is y if not x or z. It is scaled to a height of 1 m, made of rubber, and its lowest 3 percent stand on
springs, whose forces add up to the reaction. (For fixed points CalculiX reports the force without the loads at these
points.) Writes solid.inp and solid.vtu, with displacements and stresses, into the folder.
"""

from __future__ import annotations

import sys
from pathlib import Path

import insideout
import numpy as np
from calculix import CalculiXError, printed_displacements, solve, with_results
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import models  # noqa: E402  of the folder above

DENSITY, GRAVITY = 1100.0, 9.81
FOOT = 0.03  # of the height
SPRING = 1e6  # N/m, in each direction, at each point

JOB = f"""*INCLUDE, INPUT=solid.inp
*NSET, NSET=feet
{{feet}}
{{springs}}
*MATERIAL, NAME=rubber
*ELASTIC
5e7, 0.45
*DENSITY
{DENSITY}
*SOLID SECTION, ELSET=Eall, MATERIAL=rubber
*STEP
*STATIC
*DLOAD
Eall, GRAV, {GRAVITY}, {{down}}
*NODE PRINT, NSET=feet
U
*NODE FILE
U
*EL FILE
S
*END STEP
"""


def springs(points: np.ndarray, first: int) -> str:
    """Between each point and the ground; the elements' numbers begin with the first."""
    lines = []
    for direction in (1, 2, 3):
        lines.append(f"*ELEMENT, TYPE=SPRING1, ELSET=ground_{direction}")
        lines += [f"{number}, {point}" for number, point in enumerate(points, first)]
        lines += [f"*SPRING, ELSET=ground_{direction}", f"{direction}", f"{SPRING}"]
        first += len(points)
    return "\n".join(lines)


def main(folder: Path, surface: Path, up: str) -> None:
    axis = "xyz".index(up)
    low, high = np.array(insideout.check(surface).surface.GetBounds()).reshape(3, 2)[axis]
    result = insideout.tetrahedralize(surface, scale=1 / (high - low), refine=True)
    insideout.write(result, folder / "solid.inp")

    heights = result.solid.points[:, axis]
    feet = np.flatnonzero(heights < heights.min() + FOOT) + 1
    down = ", ".join("-1" if k == axis else "0" for k in range(3))
    ground = springs(feet, len(result.solid.cells) + 1)
    solve(JOB.format(feet=",\n".join(map(str, feet)), springs=ground, down=down), folder)

    solved = with_results(result.solid, folder)
    insideout.write(solved, folder / "solid.vtu")
    weight = result.statistics["Volume"] * DENSITY * GRAVITY
    reaction = -SPRING * printed_displacements(folder).sum(axis=0)
    sinks = np.linalg.norm(vtk_to_numpy(solved.GetPointData().GetArray("Displacement")), axis=1).max()
    print(f"{surface.name}: {result.statistics['IntersectingPairs']} pairs of facets cross, {result.statistics['OpenEdges']} open edges")
    print(f"{len(result.solid.cells):,} cells in {len(result.regions)} parts stand on {len(feet)} springs; the body gives way by up to {1000 * sinks:.3g} mm")
    print(f"weight {weight:.7g} N, reaction {reaction[axis]:.7g} N: {reaction[axis] / weight - 1:+.1e}")
    print(f"across {np.abs(np.delete(reaction, axis)).max() / weight:.1e} of it")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    try:
        to = Path(sys.argv[1])
        to.mkdir(parents=True, exist_ok=True)
        given = Path(sys.argv[2]) if len(sys.argv) > 2 else models.unpacked("camel.off", to)
        main(to, given, sys.argv[3] if len(sys.argv) > 3 else "y")
    except (insideout.Error, CalculiXError, OSError) as error:
        sys.exit(f"weight.py: {error}")
