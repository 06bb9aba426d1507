# SPDX-License-Identifier: GPL-3.0-or-later
"""A dirty figure of soft rubber under gravity (the thesis's figure 8.16), and what becomes of it if each limb is repaired alone.

    xvfb-run -a python3 sagging.py PICTURE.png [linear]

The figure's limbs (figure.py) overlap, and are open where they are hidden. In the solid they are one body: CalculiX finds
where it comes to rest, with large deformations, held in its spine; with cells of second order, or quicker and a little too
stiff, of first. The usual way repairs the surface first: it closes the holes of each limb (vtkFillHolesFilter), after which
each can be meshed; but none of these meshes shares a point with the trunk, and all but that falls down.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np
from fem import same_places
from figure import SKELETON, write_figure
from insideout.scenes import defect_lines
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter

sys.path[:0] = [str(Path(__file__).resolve().parent.parent), str(Path(__file__).resolve().parent.parent / "Mechanics")]
import drawing  # noqa: E402  of the folder above
from calculix import CalculiXError, solve, with_results  # noqa: E402  of the folder Mechanics

AROUND = 12
EDGE_LENGTH = 0.05
HELD = 0.09  # so far around the spine points are fixed

JOB = """*INCLUDE, INPUT=solid.inp
*NSET, NSET=held
{held}
*MATERIAL, NAME=rubber
*ELASTIC
{stiffness}, 0.4
*DENSITY
1000
*SOLID SECTION, ELSET=Eall, MATERIAL=rubber
*BOUNDARY
held, 1, 3
*STEP, NLGEOM, INC=200
*STATIC
0.2, 1
*DLOAD
Eall, GRAV, 9.81, 0, 0, -1
*NODE FILE, FREQUENCY=1000
U
*EL FILE, FREQUENCY=1000
S
*END STEP
"""
STIFFNESS = 6e5  # Pa


def is_held(points: np.ndarray) -> np.ndarray:
    low, high = SKELETON["spine"].start[2], SKELETON["spine"].end[2]
    return (np.linalg.norm(points[:, :2], axis=1) < HELD) & (points[:, 2] > low) & (points[:, 2] < high)


def deformed(folder: Path, quadratic: bool):
    """The figure's solid with the displacements under gravity, and its volume."""
    result = insideout.tetrahedralize(folder / "figure.obj", edge_length=EDGE_LENGTH, surface_treatment="kept", quadratic_cells=quadratic)
    insideout.write(result, folder / "solid.inp")
    held = np.flatnonzero(is_held(result.solid.points)) + 1
    solve(JOB.format(held=",\n".join(map(str, held)), stiffness=STIFFNESS), folder)
    return with_results(result.solid, folder), result


def repaired(folder: Path) -> dict:
    """Per limb the solid that it is, with its holes closed first."""
    solids = {}
    for name in SKELETON:
        write_figure(folder / "limb.obj", [name], AROUND)
        clean, triangles, fill = vtkCleanPolyData(), vtkTriangleFilter(), vtkFillHolesFilter()
        clean.SetInputData(insideout.check(folder / "limb.obj").surface)
        triangles.SetInputConnection(clean.GetOutputPort())
        fill.SetInputConnection(triangles.GetOutputPort())
        fill.SetHoleSize(1.0)
        fill.Update()
        solids[name] = insideout.tetrahedralize(fill.GetOutput())
    return solids


def main(picture: Path, folder: Path, quadratic: bool) -> None:
    write_figure(folder / "figure.obj", around=AROUND)
    checked = insideout.check(folder / "figure.obj")
    counts = checked.statistics
    solved, result = deformed(folder, quadratic)
    moved = drawing.point_array(solved, "Displacement")
    hands = np.abs(result.solid.points[:, 0]) > 0.8
    sinks = -moved[hands, 2].mean()
    most = np.linalg.norm(moved, axis=1).max()
    print(f"The solid: {len(result.regions)} region, {len(result.solid.cells):,} cells")
    print(f"the hands sink by {sinks:.3f} m, nothing moves more than {most:.3f} m")

    pieces = repaired(folder)
    whole, parts = result.statistics["Volume"], {name: piece.statistics["Volume"] for name, piece in pieces.items()}
    trunk = pieces["spine"].solid.points
    shared = sum(int((same_places(trunk, piece.solid.points) >= 0).sum()) for name, piece in pieces.items() if name != "spine")
    print(f"Repaired limb by limb: {len(pieces)} pieces; the trunk shares {shared} points with others")
    print(f"the trunk has {100 * parts['spine'] / whole:.1f} % of the volume, all have {100 * sum(parts.values()) / whole:.1f} %")

    words = f"{counts['IntersectingPairs']} pairs of facets cross, {counts['OpenEdges']} open edges"
    fallen = [drawing.actor(piece.solid, drawing.BLUE if name == "spine" else drawing.RED) for name, piece in pieces.items()]
    given = [drawing.actor(checked.surface), *defect_lines(checked.lines)]
    at_rest = drawing.actor(drawing.warped(solved, "Displacement", 1), drawing.BLUE)
    drawing.save(
        [
            drawing.Panel("A dirty figure", words, given),
            drawing.Panel("Its solid under gravity, at rest", f"one body; the hands sink by {100 * sinks:.0f} cm", [at_rest]),
            drawing.Panel("Each limb repaired alone", f"{len(pieces)} bodies; the {len(pieces) - 1} red ones fall down", fallen),
        ],
        picture,
        seen_from=(0.35, -1, 0.15),
    )


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(sys.argv[1]), Path(temporary), quadratic="linear" not in sys.argv[2:])
    except (insideout.Error, CalculiXError, OSError) as error:
        sys.exit(f"sagging.py: {error}")
