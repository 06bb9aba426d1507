# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds that vtkRobustTetrahedralize takes at first and again after a change of Gamma.

    measure-rerun.py SURFACE...

Prints lines as Measure.h does, medians of five; the target is Beast's.
"""

import statistics
import sys
import time
from pathlib import Path

import insideout
from insideout.files import read_surface

REPETITIONS = 5
LIMITS = {"Beast": 0.15}


def seconds(algorithm) -> float:
    began = time.perf_counter()
    algorithm.Update()
    return time.perf_counter() - began


def measure(path: str) -> None:
    surface, _ = read_surface(path)
    first, again = [], []
    for _ in range(REPETITIONS + 1):  # once for warming up
        algorithm = insideout.vtkRobustTetrahedralize()
        algorithm.SetInputData(surface)
        first.append(seconds(algorithm))
        algorithm.SetGamma(algorithm.GetGamma() / 2)
        again.append(seconds(algorithm))
    name = Path(path).stem
    medians = statistics.median(again[1:]), statistics.median(first[1:])
    print(f"{'rerun/' + name:28} {surface.GetNumberOfCells():9} facets   again {medians[0]:8.4f} s   first {medians[1]:8.4f} s")
    if name in LIMITS:
        print(f"ratio rerun/{name} {medians[0] / medians[1]:.3f} at most {LIMITS[name]:g}")


if __name__ == "__main__":
    for given in sys.argv[1:]:
        measure(given)
