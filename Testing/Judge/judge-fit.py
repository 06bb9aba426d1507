#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges with CalculiX whether solids are fit for a solver, and whether InsideOut says so.

    judge-fit.py SURFACE_OR_FOLDER... [--diagonal D] [--no-refine] [--quadratic-cells] [--surface-treatment T] [--most-bytes N]

Makes an .inp file of each surface, and of those in each folder, in millimeters, as which they are taken or with --diagonal made so
large, and in meters: times 0.001. CalculiX gets
it with all nodes fixed, so that it makes the matrix of each element and has nothing to solve: it names those whose Jacobian
determinant is not positive. Prints each file with such elements, or with another number of them than `insideout check` counts;
those that were skipped, which have no inside or cannot be read; and the sums. Exit status 0 if no element is refused and all
counts agree; with --no-refine, if all counts agree.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import warnings
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Iterator

import insideout
import numpy as np

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


@dataclass
class Case:
    name: str
    unit: str
    cells: int
    refused: int  # by CalculiX
    told: int  # as refused
    poor: int
    flat: int  # exactly


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


def judged(path: Path, unit: str, options: argparse.Namespace) -> Case | str:
    """A case, or why there is none."""
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        solid = Path(folder, "solid.inp")
        chosen = {"refine": False} if options.no_refine else {"quadratic_cells": options.quadratic_cells, "surface_treatment": options.surface_treatment}
        try:
            size = options.diagonal / np.linalg.norm(np.ptp(insideout.read(str(path)).points, axis=0)) if options.diagonal else 1
            insideout.tetrahedralize(str(path), scale=size * UNITS[unit], output=str(solid), **chosen)
        except insideout.Error as error:
            return str(error)
        if not solid.exists():
            return "nothing is inside"
        found = insideout.check_solid(str(solid)).statistics
        counts = (int(found[name]) for name in ("RefusedCells", "PoorCells", "FlatCells"))
        return Case(path.name, unit, int(found["Cells"]), refused_by_calculix(Path(folder)), *counts)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", type=Path)
    parser.add_argument("--diagonal", type=float, help="of each surface, in millimeters")
    parser.add_argument("--no-refine", action="store_true", help="solids as they come")
    parser.add_argument("--quadratic-cells", action="store_true")
    parser.add_argument("--surface-treatment", default="kept")
    parser.add_argument("--most-bytes", type=int, default=sys.maxsize, help="pass over larger surfaces")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        parser.error("there is no ccx: install calculix-ccx")
    is_good = True
    cases: list[Case] = []
    for path in surfaces_in(options.surfaces, options.most_bytes):
        for unit in UNITS:
            case = judged(path, unit, options)
            if isinstance(case, str):
                print(f"skipped {path.name}: {case}", flush=True)
                break
            cases.append(case)
            agrees = case.refused == case.told
            is_good = is_good and agrees and (case.refused == 0 or options.no_refine)
            if case.refused > 0 or not agrees:
                told = "" if agrees else f", and InsideOut counts {case.told}"
                print(f"{case.name} in {unit}: CalculiX refuses {case.refused} of {case.cells} cells{told}; {case.flat} are flat exactly", flush=True)
    if not cases:
        parser.error("no solid was judged")
    for unit in UNITS:
        those = [case for case in cases if case.unit == unit]
        some = sum(case.refused > 0 for case in those)
        refused, all_cells, poor = (sum(getattr(case, name) for case in those) for name in ("refused", "cells", "poor"))
        print(f"{unit}: {len(those)} solids, {all_cells} cells; {refused} refused, in {some} solids; {poor} more are poor")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
