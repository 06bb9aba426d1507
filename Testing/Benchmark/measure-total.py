# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds of the command line from a file to a .vtu, against TetGen's library alone on the resolved surface.

    measure-total.py BENCHMARK SURFACE...

BENCHMARK is BenchmarkConstrainedDelaunay, whose --tetgen says what TetGen takes. The command line's
seconds are those of its process: interpreter, reading and writing too. Prints lines as Measure.h
does, medians of five by turns. Surfaces without a target are passed over.
"""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

REPETITIONS = 5
LIMITS = {"Beast": 1}


def seconds_of_command_line(surface: str, solid: str) -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-m", "insideout", surface, solid], check=True, capture_output=True)
    return time.perf_counter() - began


def seconds_of_tetgen(benchmark: str, surface: str) -> float:
    return float(subprocess.run([benchmark, "--tetgen", surface], check=True, capture_output=True).stdout)


def measure(benchmark: str, surface: str) -> None:
    name = Path(surface).stem
    ours, tetgens = [], []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(REPETITIONS + 1):  # once for warming up
            ours.append(seconds_of_command_line(surface, str(Path(folder) / "solid.vtu")))
            tetgens.append(seconds_of_tetgen(benchmark, surface))
    medians = statistics.median(ours[1:]), statistics.median(tetgens[1:])
    print(f"{'total/' + name:28}   command line {medians[0]:8.4f} s   TetGen {medians[1]:8.4f} s")
    if name in LIMITS:
        print(f"ratio total/{name} {medians[0] / medians[1]:.3f} at most {LIMITS[name]:g}")


if __name__ == "__main__":
    for given in sys.argv[2:]:
        if Path(given).stem in LIMITS:
            measure(sys.argv[1], given)
