#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges whether the volume that the verdict tells before meshing is that of the mesh.

    judge-verdict.py SURFACE_OR_FOLDER...

Checks each surface, and those in each folder, then meshes it. An exact volume has to be the mesh's to six digits. The bounds of
one told as `about` have to hold the mesh's. After meshing, the verdict has to tell the mesh's own volume. Prints the number of
volumes of either kind that hold, the width of the bounds, each surface that fails, and those that were skipped: planar ones,
and those that cannot be read. Exit status 0 if 95 % of each kind hold, and all verdicts tell of their meshes.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator

import insideout

ENDINGS = (".obj", ".off", ".ply", ".stl", ".vtp")
SIX_DIGITS = 5e-6
LEAST_SHARE = 0.95


@dataclass
class Case:
    name: str
    told: str
    low: float
    high: float
    volume: float
    meshed: str

    def is_exact(self) -> bool:
        return self.low == self.high

    def holds(self) -> bool:
        rounding = SIX_DIGITS * self.volume
        return self.low - rounding <= self.volume <= self.high + rounding

    def tells_of_mesh(self) -> bool:
        return self.volume <= 0 or f" volume {self.volume:.6g}" in self.meshed and "about" not in self.meshed

    def width(self) -> float:
        """Half of the distance of the bounds, in shares of the mesh's volume."""
        return (self.high - self.low) / 2 / self.volume if self.volume > 0 else float("inf")


def surfaces_in(paths: list[Path]) -> Iterator[Path]:
    for path in paths:
        yield from sorted(file for file in path.rglob("*") if file.suffix in ENDINGS) if path.is_dir() else [path]


def judged(path: Path) -> Case | str:
    """A case, or why there is none."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = insideout.check(str(path))
            if found.statistics.get("Planar", 1):
                return "planar"
            made = insideout.tetrahedralize(str(path))
    except insideout.Error as error:
        return str(error)
    low, high = (found.statistics[f"EnclosedVolume{end}"] for end in ("Low", "High"))
    return Case(path.name, found.verdict, low, high, made.statistics["Volume"], made.verdict)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", type=Path)
    options = parser.parse_args()
    cases: list[Case] = []
    for path in surfaces_in(options.surfaces):
        case = judged(path)
        if isinstance(case, str):
            print(f"skipped {path.name}: {case}")
            continue
        cases.append(case)
        if not case.holds() or not case.tells_of_mesh():
            print(f"fails {case.name}: {case.told}; its mesh has a volume of {case.volume:.6g} and the verdict: {case.meshed}", flush=True)
    is_good = all(case.tells_of_mesh() for case in cases)
    for kind, exact in (("exact", True), ("about", False)):
        those = [case for case in cases if case.is_exact() == exact]
        held = sum(case.holds() for case in those)
        width = f", half the width {statistics.median(case.width() for case in those):.2g} of the volume in the median" if those and not exact else ""
        print(f"{kind}: {held} of {len(those)} hold ({100 * held / max(1, len(those)):.1f} %){width}")
        is_good = is_good and held >= LEAST_SHARE * len(those)
    print(f"{sum(case.tells_of_mesh() for case in cases)} of {len(cases)} verdicts tell of their meshes")
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
