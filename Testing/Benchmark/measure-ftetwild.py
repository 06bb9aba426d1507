# SPDX-License-Identifier: GPL-3.0-or-later
"""Our remeshed solid beside fTetWild's, with its defaults: edges of 5 % of the diagonal, envelope of 0.1 %.

    measure-ftetwild.py TABLE.csv [SURFACE...] [--limit SECONDS]

Both get the surface as it comes, those of measure-quality.py if none is named, on one thread, within a limit of processor
time (600 s); FloatTetwild_bin is on PATH. Seconds and memory are those of the whole process, files included. Distance is
the largest one from points and triangles' centers of a solid's boundary to the surface, in units of the diagonal; volume
that of the solid. A row of the table is written as soon as it is known, and rows that are there are not measured again.

Prints lines as Measure.h does: of the sum of the seconds, and of the 1 % quantiles of dihedral angles.
"""

from __future__ import annotations

import argparse
import csv
import importlib
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Iterator

import insideout
import numpy as np
from meshers import read_mesh, set_limits
from solids import boundary_of, volume_of

LENGTH, ENVELOPE = 0.05, 0.001
COLUMNS = ("surface", "triangles", "mesher", "cells", "1 %", "mean ratio", "distance", "volume", "seconds", "MiB", "trouble")
MOST_SHARE = 1 / 20  # of fTetWild's seconds


def commands(surface: Path, folder: Path, diagonal: float) -> dict[str, tuple[list[str], Path]]:
    """The command of each mesher, and the mesh that it writes."""
    ours, theirs = folder / "ours.vtu", folder / "theirs"
    program = [sys.executable, "-m", "insideout", str(surface), str(ours), "--dimension", "3", "--quiet", "--force"]
    lengths = ["--edge-length", repr(LENGTH * diagonal), "--surface-tolerance", repr(ENVELOPE * diagonal)]
    return {
        "ours": ([*program, "--surface-treatment", "remeshed", *lengths], ours),
        "fTetWild": (
            ["FloatTetwild_bin", "-i", str(folder / "surface.obj"), "-o", str(theirs), "--max-threads", "1", "--level", "6"],
            folder / "theirs_.msh",
        ),
    }


def run(command: list[str], limit: float) -> tuple[int, str, float, float]:
    """Status, last line, processor seconds and peak MiB of a process."""
    with tempfile.TemporaryFile("w+", errors="replace") as said:
        # A process begins with the peak memory of the one that starts it: a shell's is small.
        shell = ["sh", "-c", '"$@"; exit $?', "sh", *command]
        child = subprocess.Popen(
            shell,
            stdout=said,
            stderr=subprocess.STDOUT,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
            preexec_fn=lambda: set_limits(limit),
        )
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        lines = said.read().strip().splitlines() or [""]
    return child.returncode, lines[-1], usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def figures_of(mesh: Path, surface: insideout.AnySurface, diagonal: float) -> dict[str, str]:
    points, cells = read_mesh(mesh)
    quality = insideout.check_solid((points, cells)).statistics
    boundary = boundary_of(points, cells, np.ones(len(cells), bool))
    centers = boundary.points[boundary.triangles].mean(axis=1)
    distances = np.abs(insideout.distance(surface, np.concatenate([boundary.points, centers])))
    return {
        "cells": str(len(cells)),
        "1 %": f"{quality['DihedralAngle1Percent']:.3g}",
        "mean ratio": f"{quality['AverageMeanRatio']:.3g}",
        "distance": f"{distances.max() / diagonal:.2e}",
        "volume": f"{volume_of(points, cells):.6g}",
    }


def measure(surface: Path, done: set[tuple[str, str]], limit: float) -> Iterator[dict[str, str]]:
    data = insideout.read(surface)
    diagonal = float(np.linalg.norm(np.ptp(data.points, axis=0)))
    with tempfile.TemporaryDirectory() as folder:
        insideout.write(data, str(Path(folder, "surface.obj")))
        for mesher, (command, mesh) in commands(surface, Path(folder), diagonal).items():
            if (surface.name, mesher) in done:
                continue
            row = {"surface": surface.name, "triangles": str(data.GetNumberOfPolys()), "mesher": mesher}
            status, last, seconds, memory = run(command, limit)
            row |= {"seconds": f"{seconds:.2f}", "MiB": f"{memory:.0f}"}
            if status == 0 and mesh.exists():
                row |= figures_of(mesh, data, diagonal)
            else:
                row["trouble"] = f"status {status}: {last}"[:100]
            yield row


def lines_of(rows: list[dict[str, str]]) -> Iterator[str]:
    of = {mesher: {row["surface"]: row for row in rows if row["mesher"] == mesher} for mesher in ("ours", "fTetWild")}
    both = sorted(of["ours"].keys() & of["fTetWild"].keys())
    for mesher, found in of.items():
        meshed = sum(bool(found[name]["cells"]) for name in both)
        yield f"{mesher}: {meshed} of {len(both)} meshed, {sum(float(found[name]['seconds']) for name in both):.1f} s"
    seconds = [sum(float(found[name]["seconds"]) for name in both) for found in of.values()]
    if both:
        yield f"ratio ftetwild/seconds {seconds[0] / seconds[1]:.4f} at most {MOST_SHARE:g}"
    pairs = [(of["ours"][name], of["fTetWild"][name]) for name in both]
    pairs = [(ours, theirs) for ours, theirs in pairs if ours["cells"] and theirs["cells"]]
    for column, line, bound in (("1 %", "quality", "at least 1.0"), ("cells", "cells", "at most 1.0")):
        ratios = [float(ours[column]) / float(theirs[column]) for ours, theirs in pairs if float(theirs[column])]
        if ratios:
            good = sum(ratio >= 1 if bound.startswith("at least") else ratio <= 1 for ratio in ratios)
            yield f"{column}: ours as good or better on {good} of {len(ratios)}"
            yield f"ratio ftetwild/{line} {statistics.median(ratios):.3f} {bound}"


def main(options: argparse.Namespace) -> None:
    table = Path(options.table)
    rows = list(csv.DictReader(table.open(newline="", encoding="utf-8"))) if table.exists() else []
    done = {(row["surface"], row["mesher"]) for row in rows}
    with tempfile.TemporaryDirectory() as folder, table.open("a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n")
        if not rows:
            writer.writeheader()
        for surface in map(Path, options.surfaces or unpacked(folder)):
            for row in measure(surface, done, options.limit):
                writer.writerow(row)
                file.flush()
                print(row, flush=True)
                rows.append({**dict.fromkeys(COLUMNS, ""), **row})
    print("\n".join(lines_of(rows)))


def unpacked(folder: str) -> list[str]:
    quality = importlib.import_module("measure-quality")
    names = (*quality.DIRTY, *quality.CLEAN)
    subprocess.run([Path(__file__).with_name("unpack-surfaces.sh"), folder, *names], check=True)
    return [str(Path(folder, name)) for name in names if Path(folder, name).exists()]


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", metavar="TABLE.csv")
    parser.add_argument("surfaces", nargs="*", metavar="SURFACE")
    parser.add_argument("--limit", type=float, default=600, metavar="SECONDS")
    main(parser.parse_args())
