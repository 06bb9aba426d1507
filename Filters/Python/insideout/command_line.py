# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `python3 -m insideout`.

Everything that can be known to fail is checked before the work begins: names, endings, folders and
parameters. Files are written before anything is printed about them. Several surfaces are worked on one
after the other; one that fails does not keep the others from it.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import sys
import time
from typing import Any, Iterator, Optional, Sequence

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arguments import CHECK_OPTIONS, WINDING_OPTIONS, Files, parse
from .checking import Finding, check
from .drawing import PICTURES, display_command, draw
from .files import WRITABLE_GRIDS, WRITABLE_SURFACES, check_input, check_output, ending, read_surface, write_grid, write_surface
from .options import OPTIONS, Options, in_words_of_command
from .pipeline import Error, set_threads
from .places import QUERIES, Places, read_places
from .progress import StageBars
from .queries import winding_number
from .stages import CHECK, DRAWING, READING, TETRAHEDRALIZE, WINDING, WRITING
from .summary import check_summary, defects, summary, table, tetrahedralizer, winding_summary
from .tetrahedralization import Tetrahedralization, tetrahedralize
from .verdict import verdict
from .version import __version__
from .vtkFiltersInsideOut import vtkProbeWindingNumber, vtkRobustTetrahedralize, vtkSurfaceDefects

SUCCESS, FAILURE, INTERRUPTED = 0, 1, 130


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Do what the arguments say. Returns the exit status: 0 when that was done for every surface."""
    options, all_files = parse(arguments)
    if options.threads is not None:
        set_threads(options.threads)
    kind = CheckJob if options.check else WindingJob if options.winding else MeshJob
    jobs = []
    for files in all_files:
        jobs.append(kind(options, files))
        if jobs[-1].run() == INTERRUPTED:
            return INTERRUPTED
    if len(jobs) > 1 and not options.quiet:
        _print(table([(job.files.surface, job.statistics, job.error) for job in jobs]))
    return max(job.status for job in jobs)


class Job:
    """What the command does with one surface, and what is known of it so far."""

    stages: Sequence[str] = ()

    def __init__(self, options: argparse.Namespace, files: Files):
        self.options = options
        self.files = files
        self.settings = Options.among(vars(options))
        self.bars = StageBars(None if options.quiet else sys.stderr)
        self.report_is_writable = False
        self.parameters: dict[str, Any] = {}
        self.outputs: dict[str, str] = {}
        self.statistics: dict[str, float] = {}
        self.warnings: list[str] = []
        self.error: Optional[str] = None
        self.status = FAILURE
        self.begin = time.monotonic()

    def run(self) -> int:
        """Returns the exit status."""
        try:
            self.check()
            self.work()
            self.status = SUCCESS
        except Error as error:
            self.error = str(error)
        except OSError as error:
            self.error = f"{error.filename or 'system'}: {(error.strerror or str(error)).lower()}"
        except MemoryError:
            self.error = "out of memory"
        except KeyboardInterrupt:
            self.error, self.status = "interrupted", INTERRUPTED
        self.bars.abandon()
        self.write_report()
        if self.statistics and not self.options.quiet:
            self.print_summary()
        if self.error is not None:
            _print_error(self.error)
        return self.status

    def check(self) -> None:
        """Raise `Error` for whatever can be known to fail before the work begins."""
        files = self.files
        if files.report is not None:
            check_output(files.report, (".json",))
            self.report_is_writable = True
        self.parameters = self.check_parameters()
        check_input(files.surface)
        for name, endings in self.endings().items():
            path = getattr(files, name)
            if path is not None:
                check_output(path, endings)
        seen = set()
        for path in files.all():
            real = os.path.realpath(path)
            if real in seen:
                raise Error(f"{path} is named twice: a file cannot be two things")
            seen.add(real)

    def check_parameters(self) -> dict[str, Any]:
        """The parameters that the work will use. Raises `Error` for one out of range."""
        raise NotImplementedError

    def parameters_of(self, names: Sequence[str], algorithm: Any) -> dict[str, Any]:
        """Those of some names, which the algorithm has."""
        self.settings.set_on(algorithm)
        return {name: OPTIONS[name].used_by(algorithm, getattr(self.settings, name)) for name in names}

    def endings(self) -> dict[str, tuple[str, ...]]:
        """The endings that the file of each option may have."""
        return {}

    def work(self) -> None:
        raise NotImplementedError

    def summary(self) -> list[str]:
        raise NotImplementedError

    def read(self) -> vtkPolyData:
        began = time.monotonic()
        self.bars.show(READING, 0)
        surface, self.warnings = read_surface(
            self.files.surface, lambda _, fraction: self.show((READING,), READING, fraction)
        )
        self.bars.finish()
        self.seconds_read = time.monotonic() - began
        return surface

    def show_progress(self, stage: str, fraction: float) -> None:
        self.show(self.stages, stage, fraction)

    def show(self, stages: Sequence[str], stage: str, fraction: float) -> None:
        timeout = self.options.timeout
        if timeout is not None and time.monotonic() - self.begin > timeout:
            raise Error(f"{self.files.surface}: stopped while {stage}, after the {timeout:g} s of --timeout")
        self.bars.show_part(stages, stage, fraction)

    def measure(self) -> None:
        self.statistics["SecondsRead"] = self.seconds_read
        self.statistics["SecondsTotal"] = time.monotonic() - self.begin
        self.statistics["PeakMemory"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

    def write_report(self) -> None:
        """Write the report, if asked to and possible."""
        if not self.report_is_writable or self.files.report is None:
            return
        report = {
            "version": __version__,
            "input": self.files.surface,
            "outputs": self.outputs,
            "parameters": self.parameters,
            "exit_status": self.status,
            "error": self.error,
            "warnings": self.warnings,
            "statistics": self.statistics,
            **self.more_for_the_report(),
        }
        try:
            with open(self.files.report, "w", encoding="utf-8", errors="backslashreplace") as file:
                json.dump(report, file, indent=2)
                file.write("\n")
        except OSError as error:
            self.error = self.error or f"cannot write {self.files.report}: {(error.strerror or str(error)).lower()}"
            self.status = self.status or FAILURE

    def more_for_the_report(self) -> dict[str, object]:
        return {}

    def print_summary(self) -> None:
        lines = self.summary()
        lines += [f"Warning: {warning}" for warning in in_words_of_command(self.warnings)]
        lines += [f"Wrote {kind:10} {path}" for kind, path in self.outputs.items()]
        _print(lines)


class MeshJob(Job):
    """One run that makes tetrahedra."""

    stages = TETRAHEDRALIZE
    left_out_cells: list[int] = []
    lost_cells: list[int] = []

    def check_parameters(self) -> dict[str, Any]:
        if self.files.plot is not None:
            display_command()
        return self.parameters_of(tuple(OPTIONS), vtkRobustTetrahedralize())

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {
            "output": WRITABLE_GRIDS,
            "hull": WRITABLE_GRIDS,
            "boundary": WRITABLE_SURFACES,
            "outliers": WRITABLE_SURFACES,
            "plot": PICTURES,
        }

    def work(self) -> None:
        surface = self.read()
        result = tetrahedralize(surface, progress=self.show_progress, **vars(self.settings))
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.statistics = dict(result.statistics)
        self.left_out_cells = result.left_out_cells
        self.lost_cells = result.lost_cells
        try:
            self.write(surface, result)
        finally:
            self.measure()
        if "solid" not in self.outputs:
            least, most = self.statistics["MinimumW"], self.statistics["MaximumW"]
            raise Error(f"{self.files.surface}: nothing is inside, w ranges from {least:.6g} to {most:.6g}")

    def write(self, surface: vtkPolyData, result: Tetrahedralization) -> None:
        """Write what was asked for; when nothing is inside, the hull and the picture alone."""
        began = time.monotonic()
        self.bars.show(WRITING, 0)
        for kind, data, path, write in self.files_to_write(result):
            write(data, path)
            self.outputs[kind] = path
        self.bars.finish()
        self.statistics["SecondsWrite"] = time.monotonic() - began
        if self.files.plot is not None:
            self.bars.show(DRAWING, 0)
            draw(surface, result.hull, self.files.plot)
            self.bars.finish()
            self.outputs["picture"] = self.files.plot
            self.statistics["SecondsDraw"] = time.monotonic() - began - self.statistics["SecondsWrite"]

    def files_to_write(self, result: Tetrahedralization) -> Iterator[tuple]:
        files = self.files
        if files.hull is not None:
            yield "hull", result.hull, files.hull, write_grid
        if len(result.solid.cells) > 0:
            yield "solid", result.solid, files.output, write_grid
            if files.boundary is not None:
                yield "boundary", result.boundary, files.boundary, write_surface
            if files.outliers is not None:
                yield "outliers", result.outliers, files.outliers, write_surface

    def more_for_the_report(self) -> dict[str, object]:
        return {
            "tetrahedralizer": tetrahedralizer(self.statistics),
            "defects": defects(self.statistics),
            "verdict": verdict(self.statistics) if self.statistics else None,
            "left_out_cells": self.left_out_cells,
            "lost_cells": self.lost_cells,
        }

    def summary(self) -> list[str]:
        return summary(os.path.basename(self.files.surface), self.statistics)


class CheckJob(Job):
    """One run with --check, which reads a surface and looks at it."""

    stages = CHECK
    findings: list[Finding] = []
    shell_volumes: list[float] = []
    verdict: Optional[str] = None

    def check_parameters(self) -> dict[str, Any]:
        return self.parameters_of(CHECK_OPTIONS, vtkSurfaceDefects())

    def work(self) -> None:
        options = {name: getattr(self.settings, name) for name in CHECK_OPTIONS}
        result = check(self.read(), progress=self.show_progress, **options)
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.findings, self.verdict = result.findings, result.verdict
        self.shell_volumes = result.shell_volumes
        self.statistics = dict(result.statistics)
        self.measure()

    def more_for_the_report(self) -> dict[str, object]:
        findings = [vars(finding) for finding in self.findings]
        return {"defects": defects(self.statistics), "findings": findings, "verdict": self.verdict, "shell_volumes": self.shell_volumes}

    def summary(self) -> list[str]:
        return check_summary(os.path.basename(self.files.surface), self.statistics, self.findings, self.shell_volumes)


class WindingJob(Job):
    """One run with --winding, which evaluates winding numbers at places of the user's."""

    stages = WINDING

    def check_parameters(self) -> dict[str, Any]:
        check_input(self.options.winding, QUERIES)
        return self.parameters_of(WINDING_OPTIONS, vtkProbeWindingNumber())

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"output": (ending(self.options.winding),)}

    def work(self) -> None:
        surface = self.read()
        places: Places = read_places(self.options.winding)
        options = {name: getattr(self.settings, name) for name in WINDING_OPTIONS}
        w = winding_number(surface, places.data, progress=self.show_progress, **options)
        self.bars.finish()
        self.bars.show(WRITING, 0)
        output = self.files.output or ""
        places.write(w, output)
        self.bars.finish()
        self.outputs["winding"] = output
        self.statistics = {"Places": len(w), "InsidePlaces": int((w > 0.5).sum())}
        if len(w):
            self.statistics.update(MinimumW=float(w.min()), MaximumW=float(w.max()))
        self.measure()

    def summary(self) -> list[str]:
        return winding_summary(os.path.basename(self.files.surface), self.statistics)


def _print(lines: Sequence[str]) -> None:
    try:
        print("\n".join(lines), flush=True)
    except OSError:
        # Nobody reads on (`| head`). The files are written, and Python is not to complain on exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _print_error(message: str) -> None:
    try:
        print(f"insideout: {message}", file=sys.stderr, flush=True)
    except OSError:
        pass  # the exit status says it
