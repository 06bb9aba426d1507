# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `python3 -m insideout`.

Everything that can be known to fail is checked before the work begins: names, endings, folders and
parameters. Files are written before anything is printed about them.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import sys
import time
from typing import Iterator, Optional, Sequence, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .checking import CHECK_STAGES, Finding, check, make_marker
from .files import WRITABLE_GRIDS, WRITABLE_SURFACES, check_input, check_output, read_surface, write_grid, write_surface
from .pipeline import Error
from .progress import StageBars
from .summary import check_summary, defects, summary, tetrahedralizer
from .tetrahedralization import DATA_TERMS, ENGINES, STAGES, Tetrahedralization, make_filter, tetrahedralize
from .version import __version__

SUCCESS, FAILURE, INTERRUPTED = 0, 1, 130


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Do what the arguments say. Returns the exit status: 0 when that was done."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if options.check:
        _refuse_what_makes_no_mesh(parser, options)
        return CheckJob(options).run()
    if options.output is None:
        parser.error("the following arguments are required: OUTPUT.vtu")
    return Job(options).run()


def _refuse_what_makes_no_mesh(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    names = ("output", "hull", "boundary", "outliers", "gamma", "sigma", "engine", "time_budget", "memory_budget")
    for name in names + ("data_term", "constrain_facets", "constrain_manifold"):
        if getattr(options, name) not in (None, False):
            words = "OUTPUT.vtu" if name == "output" else "--" + name.replace("_", "-")
            parser.error(f"--check meshes nothing: it goes without {words}")


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one line, like every other failure, and not with the usage before it."""

    def error(self, message: str) -> None:
        self.exit(FAILURE, f"{self.prog}: {message} (see --help)\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="insideout",
        allow_abbrev=False,
        description="From a broken surface to tetrahedra of the solid that it means.",
        epilog="Exit status 0 when tetrahedra were written (with --check: when the surface was checked), 1 when not.",
    )
    surface_endings = ", ".join(WRITABLE_SURFACES)
    parser.add_argument("surface", metavar="SURFACE", help="a .ply, .obj, .off, .stl or .vtp file")
    parser.add_argument("output", metavar="OUTPUT.vtu", nargs="?", help="where to write the tetrahedra inside")
    parser.add_argument(
        "--check", action="store_true", help="only say what is wrong with the surface, and whether it matters here"
    )
    parser.add_argument("--hull", metavar="HULL.vtu", help="write all tetrahedra of the convex hull, with w and Inside")
    parser.add_argument("--boundary", metavar="FILE", help=f"write the solid's boundary ({surface_endings})")
    parser.add_argument(
        "--outliers", metavar="FILE.vtp", help=f"write the facets that are no part of the solid ({surface_endings})"
    )
    parser.add_argument("--report", metavar="FILE.json", help="write what was found and done, also when it fails")
    parser.add_argument(
        "--gamma", metavar="G", type=float, help="weight of a smooth boundary, at least 0; 0 takes w above 1/2"
    )
    parser.add_argument("--sigma", metavar="S", type=float, help="how large a step of w may be noise, at least 1e-6")
    parser.add_argument(
        "--data-term", choices=list(DATA_TERMS), help="how much a cell's own w counts; uniform by default"
    )
    parser.add_argument(
        "--constrain-facets", action="store_true", help="keep every facet as faces of the solid, thin sheets too"
    )
    parser.add_argument("--constrain-manifold", action="store_true", help="make the solid's boundary a 2-manifold")
    parser.add_argument(
        "--merge-tolerance", metavar="T", type=float, help="points at most this far apart become one, at least 0"
    )
    parser.add_argument("--engine", choices=list(ENGINES), help="what makes the tetrahedra; automatic by default")
    parser.add_argument(
        "--time-budget", metavar="S", type=float, help="seconds that tetrahedralizing may take; 0 goes by size"
    )
    parser.add_argument(
        "--memory-budget", metavar="M", type=float, help="MiB that TetGen may hold; 0 goes by the surface's size"
    )
    parser.add_argument("--quiet", action="store_true", help="print nothing but errors")
    parser.add_argument("--version", action="version", version=f"insideout {__version__}")
    return parser


class Job:
    """One run of the command, and what is known of it so far."""

    def __init__(self, options: argparse.Namespace):
        self.options = options
        self.bars = StageBars(None if options.quiet else sys.stderr)
        self.report_is_writable = False
        self.parameters: dict[str, Union[float, str]] = {}
        self.outputs: dict[str, str] = {}
        self.statistics: dict[str, float] = {}
        self.left_out_cells: list[int] = []
        self.lost_cells: list[int] = []
        self.warnings: list[str] = []
        self.error: Optional[str] = None
        self.begin = time.monotonic()

    def run(self) -> int:
        status = FAILURE
        try:
            self.check()
            self.work()
            status = SUCCESS
        except Error as error:
            self.error = str(error)
        except OSError as error:
            self.error = f"{error.filename or 'system'}: {(error.strerror or str(error)).lower()}"
        except MemoryError:
            self.error = "out of memory"
        except KeyboardInterrupt:
            self.error, status = "interrupted", INTERRUPTED
        self.bars.abandon()
        status = self.write_report(status)
        if self.statistics and not self.options.quiet:
            self.print_summary()
        if self.error is not None:
            _print_error(self.error)
        return status

    def check(self) -> None:
        """Raise `Error` for whatever can be known to fail before the work begins."""
        options = self.options
        if options.report is not None:
            check_output(options.report, (".json",))
            self.report_is_writable = True
        solid = make_filter(
            options.gamma,
            options.sigma,
            merge_tolerance=options.merge_tolerance,
            time_budget=options.time_budget,
            memory_budget=options.memory_budget,
            engine=options.engine or "automatic",
            data_term=options.data_term or "uniform",
            constrain_facets=options.constrain_facets,
            constrain_manifold=options.constrain_manifold,
        )
        self.parameters = {
            "gamma": solid.GetGamma(),
            "sigma": solid.GetSigma(),
            "data_term": options.data_term or "uniform",
            "constrain_facets": options.constrain_facets,
            "constrain_manifold": options.constrain_manifold,
            "merge_tolerance": solid.GetMergeTolerance(),
            "time_budget": solid.GetTimeBudget(),
            "memory_budget": solid.GetMemoryBudget(),
        }
        check_input(options.surface)
        check_output(options.output, WRITABLE_GRIDS)
        for path, endings in (
            (options.hull, WRITABLE_GRIDS),
            (options.boundary, WRITABLE_SURFACES),
            (options.outliers, WRITABLE_SURFACES),
        ):
            if path is not None:
                check_output(path, endings)
        self.check_that_files_differ()

    def check_that_files_differ(self) -> None:
        options = self.options
        seen = set()
        for path in (options.surface, options.output, options.hull, options.boundary, options.outliers, options.report):
            if path is not None:
                real = os.path.realpath(path)
                if real in seen:
                    raise Error(f"{path} is named twice: a file cannot be two things")
                seen.add(real)

    def work(self) -> None:
        options = self.options
        began = time.monotonic()
        surface = self.read()
        seconds_read = time.monotonic() - began

        result = tetrahedralize(
            surface,
            gamma=options.gamma,
            sigma=options.sigma,
            merge_tolerance=options.merge_tolerance,
            time_budget=options.time_budget,
            memory_budget=options.memory_budget,
            engine=options.engine or "automatic",
            data_term=options.data_term or "uniform",
            constrain_facets=options.constrain_facets,
            constrain_manifold=options.constrain_manifold,
            progress=lambda stage, fraction: self.bars.show_part(STAGES, stage, fraction),
        )
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.statistics = dict(result.statistics, SecondsRead=seconds_read)
        self.left_out_cells = result.left_out_cells
        self.lost_cells = result.lost_cells
        try:
            self.write(result)
        finally:
            self.measure()
        if "solid" not in self.outputs:
            least, most = self.statistics["MinimumW"], self.statistics["MaximumW"]
            raise Error(f"{options.surface}: nothing is inside, w ranges from {least:.6g} to {most:.6g}")

    def read(self) -> vtkPolyData:
        self.bars.show("reading", 0)
        surface, self.warnings = read_surface(
            self.options.surface, lambda _, fraction: self.bars.show("reading", fraction)
        )
        self.bars.finish()
        return surface

    def write(self, result: Tetrahedralization) -> None:
        """Write what was asked for; when nothing is inside, the hull alone."""
        began = time.monotonic()
        self.bars.show("writing", 0)
        for kind, data, path, write in self.files_to_write(result):
            write(data, path)
            self.outputs[kind] = path
        self.bars.finish()
        self.statistics["SecondsWrite"] = time.monotonic() - began

    def measure(self) -> None:
        self.statistics["SecondsTotal"] = time.monotonic() - self.begin
        self.statistics["PeakMemory"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

    def files_to_write(self, result: Tetrahedralization) -> Iterator[tuple]:
        options = self.options
        if options.hull is not None:
            yield "hull", result.hull, options.hull, write_grid
        if result.solid.GetNumberOfCells() > 0:
            yield "solid", result.solid, options.output, write_grid
            if options.boundary is not None:
                yield "boundary", result.boundary, options.boundary, write_surface
            if options.outliers is not None:
                yield "outliers", result.outliers, options.outliers, write_surface

    def write_report(self, status: int) -> int:
        """Write the report, if asked to and possible. Returns the exit status with this in mind."""
        if not self.report_is_writable:
            return status
        report = {
            "version": __version__,
            "input": self.options.surface,
            "outputs": self.outputs,
            "parameters": self.parameters,
            "exit_status": status,
            "error": self.error,
            "tetrahedralizer": tetrahedralizer(self.statistics),
            "defects": defects(self.statistics),
            "warnings": self.warnings,
            "statistics": self.statistics,
            **self.more_for_the_report(),
        }
        try:
            with open(self.options.report, "w", encoding="utf-8", errors="backslashreplace") as file:
                json.dump(report, file, indent=2)
                file.write("\n")
        except OSError as error:
            self.error = self.error or f"cannot write {self.options.report}: {(error.strerror or str(error)).lower()}"
            return status or FAILURE
        return status

    def more_for_the_report(self) -> dict:
        return {"left_out_cells": self.left_out_cells, "lost_cells": self.lost_cells}

    def summary(self) -> list[str]:
        return summary(os.path.basename(self.options.surface), self.statistics)

    def print_summary(self) -> None:
        lines = self.summary()
        lines += [f"Warning: {warning}" for warning in self.warnings]
        lines += [f"Wrote {kind:10} {path}" for kind, path in self.outputs.items()]
        try:
            print("\n".join(lines), flush=True)
        except OSError:
            # Nobody reads on (`| head`). The files are written, and Python is not to complain on exit.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


class CheckJob(Job):
    """One run with --check, which reads a surface and looks at it."""

    findings: list[Finding] = []
    verdict: Optional[str] = None

    def check(self) -> None:
        if self.options.report is not None:
            check_output(self.options.report, (".json",))
            self.report_is_writable = True
        self.parameters = {"merge_tolerance": make_marker(self.options.merge_tolerance).GetMergeTolerance()}
        check_input(self.options.surface)
        self.check_that_files_differ()

    def work(self) -> None:
        began = time.monotonic()
        surface = self.read()
        seconds_read = time.monotonic() - began
        result = check(
            surface,
            merge_tolerance=self.options.merge_tolerance,
            progress=lambda stage, fraction: self.bars.show_part(CHECK_STAGES, stage, fraction),
        )
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.findings, self.verdict = result.findings, result.verdict
        self.statistics = dict(result.statistics, SecondsRead=seconds_read)
        self.measure()

    def more_for_the_report(self) -> dict:
        return {"findings": [vars(finding) for finding in self.findings], "verdict": self.verdict}

    def summary(self) -> list[str]:
        return check_summary(os.path.basename(self.options.surface), self.statistics, self.findings, self.verdict)


def _print_error(message: str) -> None:
    try:
        print(f"insideout: {message}", file=sys.stderr, flush=True)
    except OSError:
        pass  # the exit status says it
