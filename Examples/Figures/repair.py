# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid against surface repair (the thesis's figures 8.15 and 8.17): what each makes of six models, and what is lost.

    xvfb-run -a python3 repair.py PICTURE.png TABLE.csv [SURFACE...]

repair.cxx repairs a surface as a surface, by CGAL's functions: as CGAL's manual puts them together, and by the steps of
MeshFix (Attene 2010), which Debian has not. It is compiled first, in about half a minute. The table has for each result
its volume, its area, its open edges and its pairs of crossing triangles. It also has the number of vertices that equal
the input's bit for bit, and the lost area of the input: triangles with centers outside the result and farther from it
than a 200th of the size.
"""

from __future__ import annotations

import csv
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple, Optional

import insideout
import numpy as np
from insideout.drawing import up_of
from insideout.actors import some_triangles, triangles_of
from insideout.view import View
from matplotlib import image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402
import overlap  # noqa: E402  beside this file

OVERLAP = "hand-in-chest.off"  # what overlap.py makes
MODELS = ("man.off", "mannequin-devil.off", "pig.stl", "elephant-with-holes.off", "propellerTip.obj", OVERLAP)
WAYS = {"insideout": "The solid", "cgal": "Repaired, by CGAL's manual", "meshfix": "Repaired, by MeshFix's steps"}
LIMIT = 300  # seconds for one repair
LOST = 1 / 200  # of the size: farther away is lost
HEADS = ("model", "", "volume", "area", "open edges", "pairs that cross", "vertices kept", "area lost", "seconds")


class Repaired(NamedTuple):
    surface: vtkPolyData
    points: np.ndarray  # all that it has, of the solid those within too
    seconds: float


def compiled(folder: Path) -> Path:
    program = folder / "repair"
    source = Path(__file__).with_suffix(".cxx")
    command = ["c++", "-O2", "-std=c++17", "-frounding-math", "-I/usr/include/eigen3", source, "-o", program, "-lgmp", "-lmpfr"]
    subprocess.run(command, check=True)
    return program


def repaired(way: str, program: Path, surface: Path, folder: Path) -> tuple[Optional[Repaired], str]:
    """What a way makes of a surface, or nothing and the reason."""
    start = time.perf_counter()
    if way == "insideout":
        result = insideout.tetrahedralize(surface)
        return Repaired(result.boundary, result.solid.points, time.perf_counter() - start), ""
    given, made = folder / "given.off", folder / "made.off"
    insideout.write(insideout.check(surface).surface, given)
    start = time.perf_counter()
    try:
        done = subprocess.run([program, way, given, made], capture_output=True, text=True, timeout=LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return None, f"no answer in {LIMIT} s"
    if done.returncode != 0:
        return None, "an error within CGAL"
    seconds = time.perf_counter() - start
    mesh = triangles_of(insideout.check(made).surface)
    return Repaired(mesh, points_of(mesh), seconds), ""


def points_of(surface: vtkPolyData) -> np.ndarray:
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def corners_of(surface: vtkPolyData) -> np.ndarray:
    """Points of triangles."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def corners(surface: vtkPolyData) -> np.ndarray:
    """Places of triangles."""
    return points_of(surface)[corners_of(surface)]


def places(points: np.ndarray) -> set[bytes]:
    return set(map(bytes, np.ascontiguousarray(points + 0.0)))  # -0 is 0


def areas_of(triangles: np.ndarray) -> np.ndarray:
    return np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1) / 2


def volume_of(triangles: np.ndarray) -> float:
    return float(np.einsum("ij,ij->i", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum() / 6)


def lost_triangles(given: np.ndarray, made: vtkPolyData) -> np.ndarray:
    """Which triangles of the input are outside of the result, and not near it."""
    middles = given.mean(axis=1)
    limit = LOST * np.ptp(given.reshape(-1, 3), axis=0).max()
    locator, closest, cell, part, distance = vtkStaticCellLocator(), [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    locator.SetDataSet(made)
    locator.BuildLocator()
    lost = insideout.winding_number(made, middles) < 0.5
    for k in np.flatnonzero(lost):
        locator.FindClosestPoint(middles[k], closest, cell, part, distance)
        lost[k] = distance.get() > limit**2
    return lost


def row_of(name: str, way: str, made: Optional[Repaired], reason: str, given: vtkPolyData) -> tuple[list[str], np.ndarray]:
    """A row of the table, and the lost triangles."""
    triangles = corners(given)
    if made is None:
        return [name, way, reason, *[""] * 6], np.zeros(len(triangles), bool)
    lost = lost_triangles(triangles, made.surface)
    found = insideout.check(made.surface).statistics
    vertices = places(points_of(given)[np.unique(corners_of(given))])
    kept = len(vertices & places(made.points)) / len(vertices)
    area = areas_of(triangles)
    figures = (
        *(f"{volume_of(corners(made.surface)):.5g}", f"{areas_of(corners(made.surface)).sum():.5g}"),
        *(f"{int(found[what]):,}" for what in ("OpenEdges", "IntersectingPairs")),
        *(f"{100 * kept:.2f} %", f"{100 * area[lost].sum() / area.sum():.2f} %", f"{made.seconds:.1f}"),
    )
    return [name, way, *figures], lost


def model(name: str, folder: Path) -> Path:
    if name != OVERLAP:
        return models.unpacked(name, folder)
    insideout.write(overlap.dirty_figure(folder)[0], folder / name)
    return folder / name


def main(picture: Path, table: Path, names: list[str]) -> None:
    panels, rows = [], []
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        program = compiled(folder)
        for name in names or MODELS:
            surface = Path(name) if names else model(name, folder)
            given = triangles_of(insideout.check(surface).surface)
            view = View(given, up_of(surface))
            panels.append(drawing.Panel(surface.name, "the input", [drawing.actor(given)], view.eye, view.up))
            for way, title in WAYS.items():
                made, reason = repaired(way, program, surface, folder)
                row, lost = row_of(surface.name, title, made, reason, given)
                rows.append(row)
                print("  ".join(row), flush=True)
                actors = [drawing.actor(some_triangles(given, lost), drawing.RED)] if lost.any() else []
                if made is not None:
                    actors.append(drawing.actor(made.surface, drawing.BLUE))
                words = reason or f"volume {row[2]}, lost {row[7]} of the area"
                panels.append(drawing.Panel(title, words, actors or [drawing.actor(given, opacity=0)], view.eye, view.up))
        drawing.save(panels, folder / "large.png", columns=1 + len(WAYS))
        large = image.imread(folder / "large.png")[..., :3]
        image.imsave(picture, (large[::2, ::2] + large[1::2, ::2] + large[::2, 1::2] + large[1::2, 1::2]) / 4)
    with table.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADS, *rows])
    print(f"written: {picture} {table}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    try:
        main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:])
    except (insideout.Error, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"repair.py: {error}")
