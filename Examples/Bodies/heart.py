# SPDX-License-Identifier: GPL-3.0-or-later
"""A heart-like assembly of shells that overlap and are open, as one mesh of two materials that conducts heat.

    xvfb-run -a python3 heart.py FOLDER [EDGE_LENGTH]

Writes into the folder: NAME.ply, the shells; heart.inp, the mesh of six bodies; job.inp and what CalculiX makes of it;
heart.vtu, the mesh with its temperatures; heart.png. Lengths are in cm, heat in mW, temperatures in degrees above that
of the skin all around. EDGE_LENGTH is 0.45 unless it is given.
"""

from __future__ import annotations

import sys
from pathlib import Path

import insideout
import numpy as np
from insideout.scenes import defect_lines
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

EXAMPLES = Path(__file__).resolve().parent.parent
sys.path[1:1] = [str(EXAMPLES), str(EXAMPLES / "Mechanics")]
import drawing  # noqa: E402  of the folder above
from calculix import CalculiXError, point_results, solve, total_heat  # noqa: E402

BLOOD, TISSUE = ("left", "right", "vessel"), ("left_wall", "right_wall", "vessel_wall")
HEAT = 20.0  # mW in a cm3 of blood
DECIMALS = 6  # as files of surfaces have them: the cosine of 90 degrees, 6e-17, would put points 1e-16 beside each other
CONDUCTS = {"blood": 5.2, "tissue": 5.6}  # mW / (cm K)

JOB = f"""*INCLUDE, INPUT=heart.inp
*MATERIAL, NAME=blood
*CONDUCTIVITY
{CONDUCTS["blood"]}
*MATERIAL, NAME=tissue
*CONDUCTIVITY
{CONDUCTS["tissue"]}
""" + "".join(f"*SOLID SECTION, ELSET={name}, MATERIAL={material}\n" for material, names in (("blood", BLOOD), ("tissue", TISSUE)) for name in names)

STEP = f"""*STEP
*HEAT TRANSFER, STEADY STATE
*BOUNDARY
skin, 11, 11, 0
*DFLUX
""" + "".join(f"{name}, BF, {HEAT}\n" for name in BLOOD) + """*NODE PRINT, NSET=skin, TOTALS=ONLY
RFL
*NODE FILE
NT
*END STEP
"""


def shell(center, radii, edge: float, open_above: float) -> tuple[np.ndarray, np.ndarray]:
    """An ellipsoid without the triangles that reach above this height of the unit sphere: points and triangles."""
    rings = max(8, int(np.pi * max(radii) / edge))
    around = 2 * rings
    angles = [(i * np.pi / rings, j * 2 * np.pi / around) for i in range(1, rings) for j in range(around)]
    points = [(0, 0, 1), *((np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)) for a, b in angles), (0, 0, -1)]
    triangles = []
    for j in range(around):
        k = (j + 1) % around
        triangles.append((0, 1 + j, 1 + k))
        for i in range(rings - 2):
            a, b = 1 + i * around, 1 + (i + 1) * around
            triangles += [(a + j, b + j, b + k), (a + j, b + k, a + k)]
        last = 1 + (rings - 2) * around
        triangles.append((last + j, len(points) - 1, last + k))
    unit, triangles = np.array(points, float), np.array(triangles)
    return np.round(unit * radii + center, DECIMALS), triangles[unit[triangles, 2].max(axis=1) <= open_above]


def tube(low, high, radius: float, edge: float) -> tuple[np.ndarray, np.ndarray]:
    """A cylinder that is open at both ends."""
    axis = np.subtract(high, low)
    side = np.cross(axis, (0, 1, 0)) / np.linalg.norm(np.cross(axis, (0, 1, 0)))
    other = np.cross(axis, side) / np.linalg.norm(axis)
    around, steps = max(12, int(2 * np.pi * radius / edge)), max(2, int(np.linalg.norm(axis) / edge))
    angles = 2 * np.pi * np.arange(around) / around
    ring = radius * (np.cos(angles)[:, None] * side + np.sin(angles)[:, None] * other)
    points = np.vstack([low + axis * i / steps + ring for i in range(steps + 1)])
    triangles = []
    for i in range(steps):
        for j in range(around):
            a, b, c, d = i * around + j, i * around + (j + 1) % around, (i + 1) * around + j, (i + 1) * around + (j + 1) % around
            triangles += [(a, b, d), (a, d, c)]
    return np.round(points, DECIMALS), np.array(triangles)


def heart(edge: float) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Two chambers in walls of their own that overlap, and a vessel through both; all of them open above."""
    return {
        "left": shell((0, 0, 0), (1.5, 1.5, 3.0), edge, 0.92),
        "right": shell((2.3, 0, 0.6), (1.4, 1.7, 2.2), edge, 0.90),
        "vessel": tube((0.2, 0, 1.9), (0.9, 0, 5.2), 0.55, edge),
        "left_wall": shell((0, 0, -0.1), (2.5, 2.5, 3.9), edge, 0.95),
        "right_wall": shell((2.3, 0, 0.6), (1.8, 2.1, 2.6), edge, 0.93),
        "vessel_wall": tube((0.2, 0, 2.0), (0.9, 0, 5.2), 0.8, edge),
    }


def points_of_skin(result: insideout.Tetrahedralization) -> np.ndarray:
    """The ids of the points around it all: those of triangles beyond which nothing is."""
    ids = {tuple(point): number for number, point in enumerate(result.solid.points.tolist())}
    outer = insideout.bodies.outer_boundary(result.boundary).points
    return np.array([ids[tuple(point)] for point in outer.tolist()])


def heat_within(result: insideout.Tetrahedralization, skin: np.ndarray) -> float:
    """Heat from the blood to points that are not held at the skin's temperature: a quarter of a cell's heat to each
    corner.
    """
    cells, points = result.solid.cells, result.solid.points
    a, b, c, d = (points[cells[:, k]] for k in range(4))
    volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
    is_blood = result.solid.cell_arrays["RegionId"] < len(BLOOD)
    is_held = np.zeros(len(points), bool)
    is_held[skin] = True
    return HEAT * float((volumes * is_blood * (~is_held[cells]).sum(axis=1)).sum()) / 4


def with_temperatures(grid: vtkUnstructuredGrid, folder: Path) -> vtkUnstructuredGrid:
    solved = vtkUnstructuredGrid()
    solved.ShallowCopy(grid)
    array = numpy_to_vtk(np.ascontiguousarray(point_results(folder, "NDTEMP", grid.GetNumberOfPoints())[:, 0]), deep=True)
    array.SetName("Temperature")
    solved.GetPointData().AddArray(array)
    return solved


def draw(shells, solved: vtkUnstructuredGrid, picture: Path) -> None:
    surface, _ = insideout.bodies.join(shells)
    checked = insideout.check(surface)
    counts = checked.statistics
    cut = drawing.cut_open(solved, (0, 0, 0), (0, -1, 0))
    hottest = drawing.point_array(solved, "Temperature").max()
    drawing.save(
        [
            drawing.Panel(
                "Six open shells",
                f"{counts['IntersectingPairs']:,} pairs of facets cross, {counts['OpenEdges']} open edges",
                [drawing.actor(checked.surface, opacity=0.35), *defect_lines(checked.lines)],
            ),
            drawing.Panel(
                "One mesh, a region for each body",
                f"{solved.GetNumberOfCells():,} cells, cut open; faces between regions are shared",
                [drawing.coloured(cut, "RegionId", (0, len(shells) - 1), edges=True, of_cells=True)],
            ),
            drawing.Panel(
                "Temperature, by CalculiX",
                f"blue 0 to red {hottest:.2f} degrees; heat comes from the blood",
                [drawing.coloured(cut, "Temperature", (0, hottest))],
            ),
        ],
        picture,
        seen_from=(0.3, -2, 0.5),
    )


def main(folder: Path, edge: float) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    shells = heart(edge)
    for name, (points, triangles) in shells.items():
        insideout.write(insideout.resolve((points, triangles)).surface, folder / f"{name}.ply")
    result = insideout.tetrahedralize(shells, priority=list(shells), edge_length=edge, surface_treatment="remeshed", surface_tolerance=edge / 20)
    insideout.write(result, folder / "heart.inp")
    volumes = {"+".join(region.bodies): region.volume for region in result.regions}
    print(f"{len(result.solid.cells):,} cells; volumes in cm3:", ", ".join(f"{name} {volume:.3f}" for name, volume in volumes.items()))

    skin = points_of_skin(result)
    solve(JOB + "*NSET, NSET=skin\n" + "".join(f"{point + 1},\n" for point in skin) + STEP, folder)
    solved = with_temperatures(result.solid, folder)
    insideout.write(solved, folder / "heart.vtu")
    made, left = heat_within(result, skin), -total_heat(folder)
    print(f"heat made within {made:.6g} mW, heat that leaves {left:.6g} mW: {left / made - 1:+.1e}")
    regions = vtk_to_numpy(solved.GetCellData().GetArray("RegionId"))
    temperatures = drawing.point_array(solved, "Temperature")[result.solid.cells].mean(axis=1)
    print(f"mean of the left chamber {temperatures[regions == 0].mean():.2f}, of its wall {temperatures[regions == 3].mean():.2f} degrees")
    draw(shells, solved, folder / "heart.png")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    try:
        main(Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.45)
    except (insideout.Error, CalculiXError) as error:
        sys.exit(f"heart.py: {error}")
