# SPDX-License-Identifier: GPL-3.0-or-later
"""Winding numbers beside a surface that is read in pieces: seconds of the processor, and memory, by the number of facets.

    . build/env.sh; python3 Testing/Benchmark/measure-pieces.py [FACETS...]

A bumpy ball of each number of FACETS (1 and 10 million; 100 million take 5 GB of the disk and some ten minutes) is written
to .stl files of at most `--piece` facets, bands between circles of latitude. `winding_number_of_pieces` reads them, one
thread, at 10,000 points, and of up to 10 million facets `winding_number` all at once (8 GiB). Prints a line for each and
whether all values are equal bit by bit.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile

import numpy as np

POINTS = 10_000
MOST_AT_ONCE = 10_000_000


def circle(row, rows, columns):
    """The points of a circle of latitude, as floats: those of neighboring bands are equal."""
    longitude = 2 * np.pi * np.arange(columns) / columns
    latitude = np.pi * row / rows
    if row in (0, rows):
        return np.repeat([[0, 0, 1.0 if row == 0 else -1.0]], columns, axis=0).astype(np.float32)
    radius = 1 + 0.1 * np.sin(8 * latitude) * np.sin(9 * longitude)
    ring = radius * np.sin(latitude)
    return np.column_stack([ring * np.cos(longitude), ring * np.sin(longitude), radius * np.cos(latitude)]).astype(np.float32)


def write_band(path, first, last, rows, columns):
    """Write the triangles between two circles to a binary .stl file, row by row."""
    triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    with open(path, "wb") as file:
        file.write(b" " * 80)
        file.write(np.uint32(2 * columns * (last - first)).tobytes())
        above = circle(first, rows, columns)
        for row in range(first, last):
            below = circle(row + 1, rows, columns)
            right, low_right = np.roll(above, -1, axis=0), np.roll(below, -1, axis=0)
            band = np.zeros(2 * columns, triangle)
            band["corners"][:columns] = np.stack([above, below, low_right], axis=1)
            band["corners"][columns:] = np.stack([above, low_right, right], axis=1)
            band.tofile(file)
            above = below


def write_ball(folder, facets, most):
    rows = max(3, int((facets / 4) ** 0.5))
    columns = 2 * rows
    bands = -(-4 * rows * rows // most)
    ends = [rows * k // bands for k in range(bands + 1)]
    paths = [os.path.join(folder, f"{k}.stl") for k in range(bands)]
    for path, first, last in zip(paths, ends, ends[1:]):
        write_band(path, first, last, rows, columns)
    return paths, 4 * rows * rows


def measure(way, paths):
    """In a process of its own: seconds of the processor, peak in MiB, and the values."""
    with tempfile.TemporaryDirectory() as folder:
        values = os.path.join(folder, "w.npy")
        code = f"import runpy; runpy.run_path({__file__!r})['query']({way!r}, {paths!r}, {values!r})"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return seconds, float(done.stdout), np.load(values)


def query(way, paths, values):
    import insideout

    points = np.random.default_rng(1).uniform(-1.2, 1.2, (POINTS, 3))
    if way == "pieces":
        w = insideout.winding_number_of_pieces(paths, points)
    else:
        surfaces = [insideout.read(path) for path in paths]
        corners = [surface.points[surface.triangles] for surface in surfaces]
        whole = np.concatenate(corners).reshape(-1, 3)
        w = insideout.winding_number((whole, np.arange(len(whole)).reshape(-1, 3)), points, orientation="as-given", count_duplicates=True)
    np.save(values, w)
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("facets", nargs="*", type=float, default=[1e6, 1e7])
    parser.add_argument("--piece", type=int, default=2_000_000, help="facets of a piece, at most")
    options = parser.parse_args()
    for facets in options.facets:
        with tempfile.TemporaryDirectory() as folder:
            paths, count = write_ball(folder, facets, options.piece)
            seconds, peak, w = measure("pieces", paths)
            line = f"{count} facets in {len(paths)} pieces: {seconds:.1f} s, {peak:.0f} MiB"
            line += f"; {int((w == 1).sum())} points inside, {int((w == 0).sum())} outside, {int(((w != 0) & (w != 1)).sum())} neither"
            if count <= MOST_AT_ONCE:
                seconds, peak, whole = measure("whole", paths)
                line += f"; at once {seconds:.1f} s, {peak:.0f} MiB, {int((whole != w).sum())} values differ"
            print(line, flush=True)


if __name__ == "__main__":
    main()
