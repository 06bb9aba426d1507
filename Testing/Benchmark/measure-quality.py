# SPDX-License-Identifier: GPL-3.0-or-later
"""How good tetrahedra are, ours and those that TetGen, gmsh and Netgen make of the boundary of our solid.

    measure-quality.py [SURFACE...] [--table TABLE.csv] [--inputs FOLDER] [--limit SECONDS] [--set NAME=VALUE]... [--only WORDS]

Without a surface it takes 30 dirty and 10 clean ones of Debian's packages libcgal-demo and openfoam-examples. Each
surface is meshed by the command line as it comes, without refinement. Every other mesher gets the boundary of that
solid, watertight and without crossings, with a point in each cavity: vtkRefineTetrahedra gets the solid itself. Each
runs in a process of its own, with a limit of processor time (120 s) and memory, with its defaults for sizes; its
seconds are its own, without files. If our 1 % angle is below another's that has more cells, ours is meshed again with a
Grading that gives about as many cells; if it is remeshed and has more cells than 1.2 times the other's, with an
EdgeLength, within 1 % of the diagonal, that gives 0.9 to 1.2 times as many. The option --set sets a property of
vtkRefineTetrahedra: `--set EdgeLength=0.1`. The option --only runs those meshers whose names match a regular expression. --table writes all
figures, --inputs keeps the files that the meshers were given.

Prints lines as Measure.h does: of the 1 % quantiles of dihedral angles where both made a mesh, and of the seconds. The
summary before them is the table of README.md.
"""

from __future__ import annotations

import argparse
import csv
import math
import re
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

import insideout
import numpy as np
from meshers import Mesher, Outcome, mesh_as_it_comes, meshers, outcome_of, write_inputs
from solids import Boundary, boundary_of, points_and_cells, read_grid, volume_of
from vtkmodules.util.numpy_support import vtk_to_numpy

DIRTY = (
    *("ChineseDragon-10kv.off", "b9_mesh.off", "blade.off", "blobby-shuffled.off", "blobby_3cc.off", "bones.off"),
    *("bull.off", "camel.off", "cow.off", "diplodocus.off", "elephant-with-holes.off", "elk.off", "head.off"),
    *("lion-head.off", "lion.off", "man.off", "mannequin-devil.off", "mech-holes-shark.off", "mushroom.off"),
    *("pig.off", "pig.stl", "three_peaks.off", "cyclone.stl", "desk.stl", "fan.stl", "propellerTip.obj"),
    *("simpleCar.stl", "sloshingCylinder.obj", "stirrer.stl", "vessel.stl"),
)
CLEAN = (
    *("anchor.off", "couplingdown.off", "dino.off", "elephant.off", "fandisk.off", "hand.off", "joint.off"),
    *("rotor.off", "turbine.off", "flange.stl"),
)

PAIRS = {
    "": ("ours, kept", "TetGen -pq1.2/18O9Y"),
    "split/": ("ours, split", "TetGen -pq1.2O9"),
    "remeshed/": ("ours, remeshed", "Netgen"),
}
"""Those that do the same to the triangles of the boundary, as far as they can: our 1 % angle is to be at least the other's."""

MOST_SECONDS = 1.5
"""Times what the other takes, in the median."""

MOST_TRIES = 8
"""Values of a property at most."""


@dataclass(frozen=True)
class Way:
    """To come near another's number of cells: a property to bisect."""

    name: str
    fine: float
    coarse: float
    number: tuple[float, float]
    """Our number of cells that is looked for, relative to the other's."""
    others: tuple[tuple[str, float], ...] = ()
    """Properties beside it."""

    def settings(self, value: float, diagonal: float) -> list[str]:
        """Lengths are shares of the diagonal."""
        all_values = ((self.name, value), *self.others)
        return [f"{name}={one if name == 'Grading' else one * diagonal:.4g}" for name, one in all_values]


MORE_CELLS = Way("Grading", 0.001, 0.5, (0.8, 1.0))
FEWER_CELLS = Way("EdgeLength", 0.01, 0.6, (0.9, 1.2), (("SurfaceTolerance", 0.01),))

OF_SURFACE = ("surface", "triangles", "edges under 10 degrees", "cavities")
OF_MESH = ("mesher", "cells", "least angle", "1 %", "largest angle", "radius-edge 99 %", "radius-edge largest", "seconds", "trouble")
FIGURES = ("MinDihedralAngle", "DihedralAngle1Percent", "MaxDihedralAngle", "RadiusEdgeRatio99Percent", "MaxRadiusEdgeRatio")


@dataclass
class Row:
    """What became of a surface."""

    name: str
    triangles: int = 0
    sharp: int = 0
    """Edges of the surface itself under 10 degrees."""
    cavities: int = 0
    outcomes: dict[str, Outcome] = field(default_factory=dict)
    trouble: str = ""

    def one_percent(self, mesher: str) -> Optional[float]:
        outcome = self.outcomes.get(mesher)
        return outcome.figures["DihedralAngle1Percent"] if outcome and outcome.figures else None

    def cells(self, mesher: str) -> int:
        return int(self.outcomes[mesher].figures["Cells"])

    def is_below(self, ours: str, peer: str) -> bool:
        """Whether our 1 % angle is smaller, of two that both meshed."""
        own, other = self.one_percent(ours), self.one_percent(peer)
        return own is not None and other is not None and own < other

    def way_to_cells_of(self, ours: str, peer: str) -> Optional[Way]:
        """How to compare two that both meshed with very different numbers of cells; none if that is fair already."""
        if self.one_percent(ours) is None or self.one_percent(peer) is None:
            return None
        if self.is_below(ours, peer) and self.cells(ours) < MORE_CELLS.number[0] * self.cells(peer):
            return MORE_CELLS
        return FEWER_CELLS if peer == "Netgen" and self.cells(ours) > FEWER_CELLS.number[1] * self.cells(peer) else None

    def lines(self) -> list[list[str]]:
        """A row of the table."""
        if self.trouble:
            return [[self.name, "", "", "", "ours, as it comes", *[""] * 7, self.trouble]]
        surface = [self.name, str(self.triangles), str(self.sharp), str(self.cavities)]
        return [[*surface, *_figures(mesher, outcome)] for mesher, outcome in self.outcomes.items()]


def _figures(mesher: str, outcome: Outcome) -> list[str]:
    if outcome.figures is None:
        return [mesher, *[""] * 7, outcome.trouble]
    figures = (f"{outcome.figures[figure]:.3g}" for figure in FIGURES)
    return [mesher, str(outcome.figures["Cells"]), *figures, f"{outcome.seconds:.2f}", outcome.trouble]


def _cells(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def chosen(options: argparse.Namespace) -> list[Mesher]:
    return [mesher for mesher in meshers(options.set) if re.search(options.only, mesher.name)]


def measure(surface: str, folder: Path, options: argparse.Namespace) -> Row:
    row = Row(Path(surface).name)
    row.trouble = mesh_as_it_comes(surface, folder, options.limit)
    if row.trouble:
        return row
    hull = read_grid(str(folder / "hull.vtu"))
    points, cells = points_and_cells(hull)
    inside = vtk_to_numpy(hull.GetCellData().GetArray("Inside")) > 0
    boundary = boundary_of(points, cells, inside)
    write_inputs(boundary, folder)
    seconds = seconds_to_tetrahedralize(boundary)
    ours = row.outcomes["ours, as it comes"] = outcome_of(points, cells[inside], seconds)
    row.triangles, row.cavities = len(boundary.triangles), len(boundary.cavities)
    row.sharp = ours.figures["SurfaceEdgesUnder10Degrees"]
    volume = volume_of(points, cells[inside])
    for mesher in chosen(options):
        if mesher.exists():
            outcome = row.outcomes[mesher.name] = mesher.run(folder, volume, options.limit)
            if mesher.package is None and outcome.seconds is not None:
                outcome.seconds += seconds  # TetGen's, too, begin with the boundary
    diagonal = float(np.linalg.norm(np.ptp(boundary.points, axis=0)))
    for ours, peer in PAIRS.values():
        way = row.way_to_cells_of(ours, peer)
        like = way and with_cells_like(row, ours, peer, way, diagonal, folder, volume, options)
        if like is not None:
            row.outcomes[like_name(ours)] = like
            like.seconds += seconds
    return row


def like_name(ours: str) -> str:
    return f"{ours}, about as many cells"


def with_cells_like(
    row: Row, ours: str, peer: str, way: Way, diagonal: float, folder: Path, volume: float, options: argparse.Namespace
) -> Optional[Outcome]:
    """Ours with the value, found by bisection, that gives about as many cells as the other has."""
    fine, coarse = way.fine, way.coarse
    for _ in range(MOST_TRIES):
        value = math.sqrt(fine * coarse)
        settings = way.settings(value, diagonal)
        mesher = next(one for one in meshers([*options.set, *settings]) if one.name == ours)
        outcome = mesher.run(folder, volume, options.limit)
        without = math.inf if way is MORE_CELLS else 0  # it is over the limit, or lacks too much of the volume
        number = outcome.figures["Cells"] / row.cells(peer) if outcome.figures else without
        if way.number[0] <= number <= way.number[1]:
            outcome.trouble = " ".join(settings)
            return outcome
        fine, coarse = (value, coarse) if number > 1 else (fine, value)
    return None


def seconds_to_tetrahedralize(boundary: Boundary) -> float:
    """Processor time of our own first step, given what the other meshers are given."""
    tetrahedralize = insideout.vtkConstrainedDelaunay3D()
    tetrahedralize.SetInputData(insideout.surfaces.make_surface(boundary.points, boundary.triangles))
    began = time.process_time()
    insideout.pipeline.run(tetrahedralize)
    return time.process_time() - began


def ratio_lines(row: Row) -> list[str]:
    lines = []
    for prefix, (ours, peer) in PAIRS.items():
        own, other = row.one_percent(ours), row.one_percent(peer)
        if own is not None and other:
            lines.append(f"ratio quality/{prefix}{row.name} {own / other:.3f} at least 1.0")
            like = row.one_percent(like_name(ours))
            if like is not None:
                lines.append(f"ratio quality/{prefix}{row.name}/like-number {like / other:.3f} at least 1.0")
                if ours == "ours, remeshed":
                    seconds = row.outcomes[like_name(ours)].seconds / row.outcomes[peer].seconds
                    lines.append(f"ratio quality/{prefix}{row.name}/like-number/seconds {seconds:.3f} at most {MOST_SECONDS}")
    return lines


def median_lines(rows: list[Row]) -> list[str]:
    """Ratios of the angles and of the seconds of all surfaces that both meshed."""
    lines = []
    for prefix, (ours, peer) in PAIRS.items():
        both = [(row.outcomes[ours], row.outcomes[peer]) for row in rows if row.one_percent(ours) and row.one_percent(peer)]
        if both:
            angles = (row[0].figures["DihedralAngle1Percent"] / row[1].figures["DihedralAngle1Percent"] for row in both)
            lines.append(f"ratio quality/{prefix}median {statistics.median(angles):.3f} at least 1.0")
        pairs = [(own.seconds, other.seconds) for own, other in both]
        ratios = [own / other for own, other in pairs if own is not None and other]
        if ratios:
            lines.append(f"ratio quality/{prefix}seconds {statistics.median(ratios):.3f} at most {MOST_SECONDS}")
    return lines


def overview(rows: list[Row]) -> list[str]:
    """What each mesher did with all surfaces, as a table."""
    columns = ("mesher", "meshed", "cells, median", "1 %, median", "least angle, median", "seconds, median")
    lines = ["", _cells(*columns), _cells(*["---"] * len(columns))]
    for name in dict.fromkeys(name for row in rows for name in row.outcomes):
        done = [row.outcomes[name] for row in rows if name in row.outcomes and row.outcomes[name].figures]
        medians = [""] * 4
        if done:
            values = ([one.figures[figure] for one in done] for figure in ("Cells", "DihedralAngle1Percent", "MinDihedralAngle"))
            cells, one_percent, least = map(statistics.median, values)
            seconds = statistics.median(one.seconds for one in done)
            medians = [f"{cells:,.0f}", f"{one_percent:.3g}", f"{least:.3g}", f"{seconds:.2f}"]
        lines.append(_cells(name, f"{len(done)} of {len(rows)}", *medians))
    return lines


def write_table(rows: list[Row], path: str) -> None:
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([[*OF_SURFACE, *OF_MESH], *(line for row in rows for line in row.lines())])


def main(options: argparse.Namespace) -> None:
    rows = []
    for mesher in chosen(options):
        if not mesher.exists():
            where = f"of the Debian package {mesher.package}" if mesher.package else "which this build has not"
            print(f"missing: {mesher.name}, {where}")
    with tempfile.TemporaryDirectory() as temporary:
        surfaces = options.surfaces
        if not surfaces:
            unpack = Path(__file__).with_name("unpack-surfaces.sh")
            subprocess.run([unpack, temporary, *DIRTY, *CLEAN], check=True)
            surfaces = [str(Path(temporary, name)) for name in (*DIRTY, *CLEAN) if Path(temporary, name).exists()]
        for surface in surfaces:
            folder = Path(options.inputs or temporary, re.sub(r"\W", "-", Path(surface).name)).resolve()
            folder.mkdir(parents=True, exist_ok=True)
            rows.append(measure(surface, folder, options))
            print("\n".join([*(_cells(*line) for line in rows[-1].lines()), *ratio_lines(rows[-1])]), flush=True)
            if options.table:
                write_table(rows, options.table)
    print("\n".join([*overview(rows), *median_lines(rows)]))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="*", metavar="SURFACE")
    parser.add_argument("--table", metavar="TABLE.csv")
    parser.add_argument("--inputs", metavar="FOLDER")
    parser.add_argument("--limit", type=float, default=120, metavar="SECONDS")
    parser.add_argument("--only", default="", metavar="WORDS")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    main(parser.parse_args())
