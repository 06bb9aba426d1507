#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges with CalculiX whether solids are fit for a solver, and whether InsideOut says so.

    judge-fit.py SURFACE_OR_FOLDER... [--diagonal D] [--no-refine] [--quadratic-cells] [--surface-treatment T]
                 [--most-bytes N] [--analyses N] [--share K/N]

Makes an .inp file of each surface, and of those in each folder, in millimeters, as which they are taken or with
--diagonal made so large, and in meters: times 0.001. CalculiX gets it with all nodes fixed, so that it makes the matrix
of each element and has nothing to solve: it names those whose Jacobian determinant is not positive. Prints the number
of cells of each file, with the elements that are refused, and their number by `insideout check` if that is another;
those that were skipped, which have no inside or cannot be read; and the sums. The option --share 2/5 judges every fifth
surface, from the second on: five runs judge all. Gmsh gets each as a .msh file: it is to find nothing wrong with it,
and positive Jacobian determinants. The first N solids of --analyses that have 12 to 50,000 cells stand on their lowest
fifth as steel: CalculiX is to end *STATIC under their weight, which the supports bear to 1e-3, and *FREQUENCY with
positive frequencies. Exit status 0 if no element is refused, all counts agree and nothing else is wrong; with
--no-refine, if all counts agree.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import warnings
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Iterator

import gmsh
import insideout
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

ENDINGS = (".obj", ".off", ".ply", ".stl", ".vtp")
UNITS = {"mm": 1.0, "m": 0.001}

DECK = """\
*INCLUDE, INPUT=solid.inp
*MATERIAL, NAME=any
*ELASTIC
1, 0.3
*SOLID SECTION, ELSET=Eall, MATERIAL=any
*BOUNDARY
Nall, 1, 3
*STEP
*STATIC
*END STEP
"""


ANALYSES = """\
*INCLUDE, INPUT=solid.inp
*NSET, NSET=support
{support}
*MATERIAL, NAME=steel
*ELASTIC
{modulus}, 0.3
*DENSITY
{density}
*SOLID SECTION, ELSET=Eall, MATERIAL=steel
*BOUNDARY
support, 1, 3
*STEP
*STATIC
*DLOAD
Eall, GRAV, {gravity}, 0, 0, -1
*NODE PRINT, NSET=support, TOTALS=ONLY
RF
*END STEP
*STEP
*FREQUENCY
3
*END STEP
"""
FEWEST_CELLS, MOST_CELLS = 12, 50_000  # of a solid that is analysed: fewer have too few degrees of freedom for ARPACK


@dataclass
class Case:
    name: str
    unit: str
    cells: int
    refused: int  # by CalculiX
    told: int  # as refused
    poor: int
    flat: int  # exactly
    wrong: list[str]  # what gmsh and the analyses say


def surfaces_in(paths: list[Path], most: int) -> Iterator[Path]:
    for path in paths:
        found = sorted(file for file in path.rglob("*") if file.suffix in ENDINGS) if path.is_dir() else [path]
        yield from (file for file in found if file.stat().st_size <= most)


def refused_by_calculix(folder: Path) -> int:
    """The number of elements that it names. Raises `RuntimeError` where it ends without a word about these."""
    (folder / "deck.inp").write_text(DECK, encoding="ascii")
    done = subprocess.run(["ccx", "deck"], cwd=folder, capture_output=True, text=True, check=False)
    refused = set(re.findall(r"nonpositive jacobian\s+determinant in element\s+(\d+)", done.stdout))
    if not refused and "Job finished" not in done.stdout:
        raise RuntimeError(f"CalculiX ended with status {done.returncode}: {done.stdout[-300:]}")
    return len(refused)


def wrong_by_gmsh(msh: Path) -> list[str]:
    """What gmsh says of a mesh, its warnings too."""
    done = subprocess.run(["gmsh", msh.name, "-check"], cwd=msh.parent, capture_output=True, text=True, check=False)
    lines = (done.stdout + done.stderr).splitlines()
    found = [line for line in lines if line.startswith(("Warning", "Error"))]
    said = [f"gmsh: {found[0]} (the first of {len(found)} such lines)"] if found else []
    said += [f"gmsh ends with status {done.returncode}"] if done.returncode else []
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(msh))
        (kind,) = gmsh.model.mesh.getElementTypes(3)
        places, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss2")
        determinants = gmsh.model.mesh.getJacobians(kind, places)[1].reshape(-1, len(weights))
        refused = int((determinants <= 0).any(axis=1).sum())
    finally:
        gmsh.finalize()
    return said + ([f"gmsh finds {refused} cells whose Jacobian determinant is not positive"] if refused else [])


def are_in_line(points: np.ndarray) -> bool:
    """Whether points are as near to a line as a hundredth of their extent."""
    extents = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return len(extents) < 2 or extents[1] <= extents[0] / 100


def supports(solid: insideout.Tetrahedra) -> np.ndarray:
    """The lowest fifth of each part that faces connect: parts that touch in a point or an edge can turn about it. More
    points where these are on a line: a box that stands on an edge can turn about it."""
    cells, z = solid.cells[:, :4], solid.points[:, 2]
    faces = np.sort(cells[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), axis=1)
    _, numbers = np.unique(faces, axis=0, return_inverse=True)
    order = np.argsort(numbers.ravel(), kind="stable")
    same = np.flatnonzero(np.diff(numbers.ravel()[order]) == 0)
    pairs = order[same] // 4, order[same + 1] // 4
    neighbors = coo_matrix((np.ones(len(same)), pairs), shape=(len(cells), len(cells)))
    count, part = connected_components(neighbors, directed=False)
    held = []
    for k in range(count):
        points = np.unique(solid.cells[part == k])
        points = points[np.argsort(z[points], kind="stable")]
        low, high = z[points[[0, -1]]]
        number = int(np.sum(z[points] <= low + (high - low) / 5))
        while number < len(points) and are_in_line(solid.points[points[:number]]):
            number += 1
        held.append(points[:number])
    return np.unique(np.concatenate(held))


def wrong_in_analyses(folder: Path, solid: insideout.Tetrahedra) -> list[str]:
    """The faults of a static analysis under the weight, and of frequencies, in millimeters."""
    held = supports(solid)
    is_free = np.ones(len(solid.points), bool)
    is_free[held] = False
    corners = solid.points[solid.cells[:, :4]]
    volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    is_linear = solid.cells.shape[1] == 4
    shares = np.full(4, 1 / 4) if is_linear else np.repeat([-1 / 20, 1 / 5], [4, 6])  # of a cell's weight, at its nodes
    density, gravity, modulus = 7.85e-9, 9810, 2.1e5  # tonnes, millimeters and seconds
    text = ",\n".join(str(point + 1) for point in held.tolist())
    deck = ANALYSES.format(support=text, modulus=modulus, density=density, gravity=gravity)
    (folder / "analyses.inp").write_text(deck, encoding="ascii")
    done = subprocess.run(["ccx", "analyses"], cwd=folder, capture_output=True, text=True, check=False)
    if "Job finished" not in done.stdout or "*ERROR" in done.stdout:
        return [f"CalculiX ends its analyses with status {done.returncode}: {done.stdout.strip().splitlines()[-1:]}"]
    found = (folder / "analyses.dat").read_text(encoding="ascii")
    rows_of_three = [line.split() for line in found.splitlines() if len(line.split()) == 3]
    forces = next((row for row in rows_of_three if "." in row[0]), [])
    weight = density * gravity * float(volumes @ (is_free[solid.cells] @ shares))  # at supports themselves none is told
    said = []
    if len(forces) != 3 or abs(float(forces[2]) - weight) > 1e-3 * weight:
        said.append(f"the supports bear {forces}, and the weight is {weight:g}")
    rows = re.findall(r"^\s+[123]\s+(\S+)\s+(\S+)\s+(\S+)\s+\S+$", found, re.MULTILINE)
    if len(rows) != 3 or not all(float(row[2]) > 0 for row in rows):
        said.append(f"the frequencies are {[row[2] for row in rows]}")
    return said


def may_be_analysed(cells: float) -> bool:
    return FEWEST_CELLS <= cells < MOST_CELLS


def judged(path: Path, unit: str, options: argparse.Namespace, analyse: bool) -> Case | str:
    """A case, or why there is none."""
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        solid = Path(folder, "solid.inp")
        chosen = {"refine": False} if options.no_refine else {"quadratic_cells": options.quadratic_cells, "surface_treatment": options.surface_treatment}
        try:
            size = options.diagonal / np.linalg.norm(np.ptp(insideout.read(str(path)).points, axis=0)) if options.diagonal else 1
            made = insideout.tetrahedralize(str(path), scale=size * UNITS[unit], output=str(solid), **chosen)
        except insideout.Error as error:
            return str(error)
        if not solid.exists():
            return "nothing is inside"
        found = insideout.check_solid(str(solid)).statistics
        counts = (int(found[name]) for name in ("RefusedCells", "PoorCells", "FlatCells"))
        insideout.write(made, Path(folder, "solid.msh"))
        wrong = wrong_by_gmsh(Path(folder, "solid.msh"))
        wrong += wrong_in_analyses(Path(folder), made.solid) if analyse and may_be_analysed(found["Cells"]) else []
        return Case(path.name, unit, int(found["Cells"]), refused_by_calculix(Path(folder)), *counts, wrong)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", type=Path)
    parser.add_argument("--diagonal", type=float, help="of each surface, in millimeters")
    parser.add_argument("--no-refine", action="store_true", help="solids as they come")
    parser.add_argument("--quadratic-cells", action="store_true")
    parser.add_argument("--surface-treatment", default="automatic")
    parser.add_argument("--analyses", type=int, default=0, metavar="N", help="the number of solids to analyse")
    parser.add_argument("--share", default="1/1", metavar="K/N", help="judge every N-th surface, from the K-th on")
    parser.add_argument("--most-bytes", type=int, default=sys.maxsize, help="pass over larger surfaces")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        parser.error("there is no ccx: install calculix-ccx")
    first, step = map(int, options.share.split("/"))
    is_good = True
    cases: list[Case] = []
    for path in islice(surfaces_in(options.surfaces, options.most_bytes), first - 1, None, step):
        for unit in UNITS:
            analysed = sum(one.unit == unit and may_be_analysed(one.cells) for one in cases)
            analyse = unit == "mm" and analysed < options.analyses
            case = judged(path, unit, options, analyse)
            if isinstance(case, str):
                print(f"skipped {path.name}: {case}", flush=True)
                break
            cases.append(case)
            agrees = case.refused == case.told
            is_good = is_good and agrees and ((case.refused == 0 and not case.wrong) or options.no_refine)
            for words in case.wrong:
                print(f"{case.name} in {unit}: {words}", flush=True)
            told = "" if agrees else f", and InsideOut counts {case.told}"
            refused = f"CalculiX refuses {case.refused} of {case.cells} cells{told}"
            print(f"{case.name} in {unit}: {refused}; {case.flat} are flat exactly", flush=True)
    if not cases:
        parser.error("no solid was judged")
    for unit in UNITS:
        those = [case for case in cases if case.unit == unit]
        some = sum(case.refused > 0 for case in those)
        refused, all_cells, poor = (sum(getattr(case, name) for case in those) for name in ("refused", "cells", "poor"))
        print(f"{unit}: {len(those)} solids, {all_cells} cells; {refused} refused, in {some} solids; {poor} more are poor")
        wrong = sum(bool(case.wrong) for case in those)
        print(f"{unit}: gmsh and the analyses find something wrong with {wrong} solids")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
