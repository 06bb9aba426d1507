# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 8.1 of the thesis, made again: sizes, defects and seconds of surfaces as they come, and what other meshers do with them.

    table.py [SURFACE...] [--only] [--output FOLDER] [--limit SECONDS] [--most-bytes BYTES]

Takes the surfaces given, and the real ones of Debian's packages libcgal-demo and openfoam-examples unless --only is said. Each
goes through the command line, and raw to the peers: TetGen (-p), on the resolved surface too, vtkDelaunay3D with
vtkSelectEnclosedPoints, gmsh, Netgen, and fTetWild if FloatTetwild_bin is there; each in a process of its own, with a limit
of processor time and memory. A
model of the thesis, by its name and size, has the thesis's row beneath. Writes table.csv and
peers.csv, and prints the summary of README.md.

An answer is right where its cells are positive and fit together, exactly, and its volume is ours to a hundredth. It keeps the
facets where as many places on them as in ours lie on faces of cells. The farthest of those that ours keeps tells, in
diagonals, how far facets move.
"""

from __future__ import annotations

import argparse
import csv
import json
import re
import statistics
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

import insideout
import numpy as np
from insideout.surfaces import make_surface
from meshers import Answer, mesh_as_it_comes, meshers_of_any_surface, tetgen, write_inputs
from solids import FACES, UNBOUNDED, Boundary, points_and_cells, read_grid, volume_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Python"))
from real_surfaces import unpack_cgal, unpack_openfoam  # noqa: E402  of the tests

LEAST_FACETS = 500  # of a real model
MOST_PLACES = 1000  # on facets, where it is asked whether they are kept
NEAR = 1e-9  # of the diagonal: on a face, up to rounding
VOLUME_APART, KEPT_APART = 0.01, 0.001

COLUMNS = {
    "|V|": "Points",
    "|F|": "Facets",
    "|dF|": "OpenEdges",
    "#self-int.": "IntersectingPairs",
    "#CC": "Components",
    "#nme.": "NonManifoldEdges",
    "pre": "SecondsPre",
    "CDT": "SecondsCDT",
    "w": "SecondsW",
    "cut": "SecondsCut",
    "|E|": "InsideCells",
    "in the hull": "HullCells",
    "Steiner": "SteinerPoints",
    "MiB": "PeakMemory",
}
"""Those of the thesis, and more: the statistic of each."""

OF_THESIS = ("V", "F", "boundary_edges", "selfint_pairs", "components", "nonmanifold_edges", "pre_s", "cdt_s", "w_s", "cut_s", "tets")
OURS = "ours"


@dataclass
class Verdict:
    """What a mesher made of a surface."""

    cells: int = 0
    volume: float = 0.0
    """Relative to ours."""
    kept: float = 0.0
    """The fraction of all places on facets that lie on faces."""
    farthest: float = 0.0
    """From its faces, of the diagonal: a place on facets that ours keeps."""
    seconds: Optional[float] = None
    trouble: str = ""
    is_right: bool = False
    keeps_facets: bool = False


@dataclass
class Row:
    name: str
    figures: dict[str, float] = field(default_factory=dict)
    rung: str = ""
    trouble: str = ""
    verdicts: dict[str, Verdict] = field(default_factory=dict)

    def cells(self) -> list[str]:
        """A row of the table."""
        if self.trouble:
            return [self.name, *[""] * len(COLUMNS), "", self.trouble]
        return [self.name, *(number(self.figures[statistic], column) for column, statistic in COLUMNS.items()), self.rung, ""]


def number(value: float, column: str) -> str:
    return f"{value:.2f}" if column in ("pre", "CDT", "w", "cut") else f"{value:.0f}"


def thesis_row(name: str, facets: float) -> Optional[list[str]]:
    """The row of the model with the file's name, if it is one of the thesis's and has as many facets."""
    lines = Path(__file__).with_name("thesis-table.csv").read_text().splitlines()[1:]
    for model in csv.DictReader(lines):
        if _letters(model["model"]) == _letters(Path(name).stem) and int(model["F"]) == facets:
            return ["(thesis, 2013)", *(model[column] for column in OF_THESIS), "", "", "", "", ""]
    return None


def _letters(text: str) -> str:
    return re.sub(r"\W", "", text).lower()


# How many facets are kept


def places_on(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Three within each triangle, of triangles taken evenly."""
    chosen = triangles[np.linspace(0, len(triangles) - 1, min(len(triangles), MOST_PLACES // 3)).astype(int)]
    weights = np.array([[0.61, 0.23, 0.16], [0.17, 0.55, 0.28], [0.24, 0.19, 0.57]])
    return np.einsum("wc,tcx->twx", weights, points[chosen]).reshape(-1, 3)


def distances_from_faces(places: np.ndarray, points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """From faces of cells, within or on the boundary, of the diagonal."""
    used, faces = np.unique(np.unique(np.sort(cells[:, FACES].reshape(-1, 3), axis=1), axis=0), return_inverse=True)
    locator = vtkStaticCellLocator()
    surface = make_surface(points[used], faces.reshape(-1, 3))
    locator.SetDataSet(surface)
    locator.BuildLocator()
    there, cell, which, part, squared = [0.0] * 3, vtkGenericCell(), mutable(0), mutable(0), mutable(0.0)
    found = []
    for place in places.tolist():
        locator.FindClosestPoint(place, there, cell, which, part, squared)
        found.append(float(squared) ** 0.5)
    return np.array(found) / np.linalg.norm(np.ptp(places, axis=0))


def verdict_of(answer: Answer, places: np.ndarray, are_kept: np.ndarray, volume: float) -> Verdict:
    """Given which places ours keeps: facets that bound nothing are on no face of anybody's."""
    if answer.points is None or len(answer.cells) == 0:
        return Verdict(seconds=answer.seconds, trouble=answer.trouble or "no cells")
    found = insideout.check_solid((answer.points, answer.cells)).findings
    trouble = "; ".join(finding.text for finding in found if finding.matters)
    distances = distances_from_faces(places, answer.points, answer.cells)
    near = distances <= NEAR
    farthest = float(distances[are_kept].max(initial=0))
    volume = volume_of(answer.points, answer.cells) / volume
    made = Verdict(len(answer.cells), volume, float(near.mean()), farthest, answer.seconds, trouble)
    made.is_right = not trouble and abs(made.volume - 1) <= VOLUME_APART
    made.keeps_facets = bool(near.mean() >= are_kept.mean() - KEPT_APART)
    return made


# All of a surface


def inputs(surface, folder: Path) -> Path:
    """The folder of what the meshers read."""
    folder.mkdir()
    triangles = surface.triangles
    one_shell = (np.zeros(len(triangles), int), np.full(len(triangles), UNBOUNDED), np.zeros((0, 3)))
    write_inputs(Boundary(surface.points, triangles, *one_shell), folder)
    insideout.write(surface, folder / "surface.vtp")
    return folder


def measure(path: str, limit: float) -> Row:
    row = Row(Path(path).name)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        row.trouble = mesh_as_it_comes(path, folder, 20 * limit)
        if row.trouble:
            return row
        row.figures = json.loads((folder / "report.json").read_text())["statistics"]
        row.rung = insideout.vtkConstrainedDelaunay3D.GetRungName(int(row.figures["Rung"]))
        volume = row.figures["Volume"]
        if volume <= 0:
            row.trouble = "bounds no solid"
            return row
        resolved = insideout.resolve(path).surface
        raw = triangles_as_they_come(path)
        places = places_on(raw.points, raw.triangles)
        seconds = sum(row.figures[key] for key in ("SecondsValidate", "SecondsPre", "SecondsCDT", "SecondsW", "SecondsCut"))
        ours = Answer(*points_and_cells(read_grid(str(folder / "solid.vtu"))), seconds)
        are_kept = distances_from_faces(places, ours.points, ours.cells) <= NEAR
        row.verdicts[OURS] = verdict_of(ours, places, are_kept, volume)
        peers = [("", mesher) for mesher in meshers_of_any_surface()] + [(", resolved", tetgen("p"))]
        folders = {"": inputs(raw, folder / "raw"), ", resolved": inputs(resolved, folder / "resolved")}
        for what, mesher in peers:
            if mesher.exists():
                answer = mesher.answer(folders[what], limit)
                row.verdicts[mesher.name + what] = verdict_of(answer, places, are_kept, volume)
    return row


def triangles_as_they_come(path: str) -> insideout.TriangleSurface:
    """As a user would hand them over: points of equal coordinates are one, and what they make degenerate is left out."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(insideout.check(path).surface)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    found = triangles.GetOutput()
    corners = vtk_to_numpy(found.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points, same = np.unique(vtk_to_numpy(found.GetPoints().GetData()) + 0.0, axis=0, return_inverse=True)  # -0 is 0
    corners = same.ravel()[corners]
    return make_surface(points, corners[(corners != np.roll(corners, 1, axis=1)).all(axis=1)])


# output


def overview(rows: list[Row]) -> list[list[str]]:
    """What each mesher did with all surfaces."""
    lines = [["mesher", "answers", "right", "and keeps facets", "seconds, median", "farthest, median"], ["---"] * 6]
    meshed = [row for row in rows if row.verdicts]
    for name in dict.fromkeys(name for row in meshed for name in row.verdicts):
        made = [row.verdicts[name] for row in meshed if name in row.verdicts]
        answers = [one for one in made if one.cells]
        seconds = f"{statistics.median(one.seconds for one in answers):.2f}" if answers else ""
        right = [one for one in made if one.is_right]
        kept = sum(one.keeps_facets for one in right)
        moved = f"{statistics.median(one.farthest for one in answers):.2g}" if answers else ""
        lines.append([name, f"{len(answers)} of {len(made)}", str(len(right)), str(kept), seconds, moved])
    return lines


def write(rows: list[Row], folder: Path) -> None:
    both = [line for row in rows for line in (row.cells(), thesis_row(row.name, row.figures.get("Facets", 0))) if line]
    with (folder / "table.csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["model", *COLUMNS, "rung", "trouble"], *both])
    with (folder / "peers.csv").open("w", newline="") as file:
        lines = [[row.name, name, *vars(made).values()] for row in rows for name, made in row.verdicts.items()]
        csv.writer(file, lineterminator="\n").writerows([["model", "mesher", *vars(Verdict())], *lines])


def main(options: argparse.Namespace) -> None:
    rows = []
    folder = Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    for mesher in meshers_of_any_surface():
        if not mesher.exists():
            print(f"missing: {mesher.name}, of the Debian package {mesher.package}")
    with tempfile.TemporaryDirectory() as temporary:
        surfaces = list(options.surfaces)
        if not options.only:
            surfaces += [*unpack_cgal(temporary, most_bytes=options.most_bytes), *unpack_openfoam(temporary, options.most_bytes)]
        for k, surface in enumerate(surfaces, 1):
            if surface not in options.surfaces and not is_large(surface):
                continue
            rows.append(measure(surface, options.limit))
            right = [name for name, made in rows[-1].verdicts.items() if made.is_right]
            print(f"{k} of {len(surfaces)}: {rows[-1].name}: {rows[-1].trouble or 'right: ' + ', '.join(right)}", flush=True)
            write(rows, folder)
    print("\n".join("| " + " | ".join(line) + " |" for line in overview(rows)))
    print(f"written to {folder}: table.csv and peers.csv")


def is_large(path: str) -> bool:
    try:
        return insideout.check(path).statistics["Facets"] >= LEAST_FACETS
    except insideout.Error:
        return False


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="*", metavar="SURFACE")
    parser.add_argument("--only", action="store_true")
    parser.add_argument("--output", default="table", metavar="FOLDER")
    parser.add_argument("--limit", type=float, default=5, metavar="SECONDS")
    parser.add_argument("--most-bytes", type=int, default=30_000_000, metavar="BYTES")
    main(parser.parse_args())
