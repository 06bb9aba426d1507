# SPDX-License-Identifier: GPL-3.0-or-later
"""Common work of all commands: check names, show progress, write a report, and report an error in one line."""

from __future__ import annotations

import argparse
import json
import math
import os
import resource
import sys
import time
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Sequence

from vtkmodules.vtkCommonDataModel import vtkPointSet, vtkPolyData, vtkUnstructuredGrid

from ..arguments import USAGE_ERROR, Files
from ..bodies import BODY_IDS, join
from ..errors import ArgumentError
from ..files import MARKED, READABLE_SURFACES, check_input, check_output, ending, is_of_others, read_solid, read_standard_input, read_surface
from ..interruption import exit_status, message, told, work_on
from ..lengths import share_of
from ..options import LENGTHS, OPTIONS, Options, error_in_words_of_command, flag_of, in_words_of_command
from ..pipeline import Error, write_bytes
from ..places import QUERIES
from ..progress import StageBars
from ..solid_files import check_beside, is_for_solver
from ..stages import READING
from ..verdict import verdict
from ..version import __version__

SUCCESS, FAILURE = 0, 1
"""Exit statuses, besides USAGE_ERROR and those of signals."""


class Job:
    """The work of a command on one surface, and its results so far."""

    stages: Sequence[str] = ()
    readable: tuple[str, ...] = READABLE_SURFACES

    def __init__(self, options: argparse.Namespace, files: Files):
        self.options = options
        self.files = files
        self.settings = Options.among({**vars(options), **({"body_array": BODY_IDS} if options.together else {})})
        self.bars = StageBars(None if options.quiet else sys.stderr)
        self.report_is_writable = False
        self.is_working = False
        self.is_report_written = False
        self.parameters: dict[str, Any] = {}
        self.lengths: list[str] = []
        self.outputs: dict[str, str] = {}
        self.statistics: dict[str, float] = {}
        self.warnings: list[str] = []
        self.error: Optional[str] = None
        self.status = FAILURE
        self.begin = time.monotonic()
        self.seconds = 0.0

    def run(self) -> int:
        """Returns the exit status."""
        work_on(self.files.name())
        self.status = self.attempt(self.check, self.work)
        self.seconds = time.monotonic() - self.begin
        self.bars.abandon()
        self.status = max(self.status, self.attempt(self.write_report))
        if self.options.json:
            print_lines([json.dumps(self.report(), allow_nan=False)])
        elif "SecondsTotal" in self.statistics and not self.options.quiet:  # the work was completed
            self.print_summary()
        if self.error is not None:
            self.print_error(self.error)
        return self.status

    def attempt(self, *tasks: Callable[[], None]) -> int:
        """Call these functions. Returns the exit status; the first of several errors is kept."""
        try:
            for task in tasks:
                task()
            return SUCCESS
        except ArgumentError as failure:
            error, status = str(failure), USAGE_ERROR
        except Error as failure:
            error, status = self.naming(str(failure)) if self.is_working else str(failure), FAILURE
        except OSError as failure:
            error, status = f"{failure.filename or 'system'}: {(failure.strerror or str(failure)).lower()}", FAILURE
        except MemoryError:
            error, status = f"{self.files.name()}: not enough memory", FAILURE
        except KeyboardInterrupt as interrupt:
            error, status = message(interrupt), exit_status(interrupt)
        self.error = self.error or error
        return status

    def check(self) -> None:
        """Raise `Error` for failures that can be detected before the work begins."""
        files = self.files
        if files.report is not None:
            check_output(files.report, (".json",))
            self.report_is_writable = True
        self.parameters = self.check_parameters()
        for surface in files.surfaces():
            if surface != "-":
                check_input(surface, self.readable)
        for name, endings in self.endings().items():
            path = getattr(files, name)
            if path is not None:
                check_output(path, endings)
        self.check_last_name()
        self.is_working = True

    def check_merging(self) -> None:
        """Raise `Error` if the solid's file needs a boundary whose triangles are faces of its tetrahedra, and merging
        prevents that."""
        output = self.files.output or ""
        if self.settings.merge_coplanar_pieces and is_for_solver(output):
            raise Error(f"{output}: after --merge-coplanar-pieces the boundary's triangles are not faces of tetrahedra, which such a file needs")

    def naming(self, error: str) -> str:
        """The error of the work, prefixed with the surface's name if it names no file."""
        files = self.files
        paths = [path for path in (*files.surfaces(), self.options.points, *files.outputs()) if path not in (None, "-")]
        names = [files.name(), *paths, *map(os.path.basename, paths)]
        return error if any(name in error for name in names) else f"{files.name()}: {error}"

    def check_last_name(self) -> None:
        """Raise `Error` if OUTPUT was probably forgotten: the last file could be an input, and no option allows
        replacing it."""
        path = self.files.output or ""
        is_told = self.is_replacing()
        could_be_input = ending(path) in (*self.readable, *QUERIES) and ending(path) in MARKED
        if could_be_input and not is_told and is_of_others(path):
            raise Error(f"{path} was not written by insideout; to replace it, name it after -o or give --force")

    def check_name_beside(self) -> None:
        """Raise `Error` where a boundary beside the cells would replace a file that nobody named."""
        if not self.is_replacing() and self.settings.dimension != "2":
            check_beside(self.files.output or "")

    def is_replacing(self) -> bool:
        """Whether somebody says that what is at OUTPUT is to be replaced."""
        return bool(self.options.force or self.options.is_output_told)

    def check_parameters(self) -> dict[str, Any]:
        """The parameters of the work. Raises `Error` for one out of range."""
        raise NotImplementedError

    def parameters_of(self, names: Sequence[str], algorithm: Any) -> dict[str, Any]:
        """The parameters with some names, which the algorithm has."""
        self.settings.measured_on().set_on(algorithm)
        return {name: OPTIONS[name].used_by(algorithm, getattr(self.settings, name)) for name in names}

    def measure_lengths(self, *all_data: vtkPointSet) -> None:
        """Convert lengths in percent to numbers, after the input was read."""
        measured = self.settings.measured_on(*all_data, factor=self.settings.factor())
        for name in LENGTHS:
            length, given = getattr(measured, name), getattr(self.settings, name)
            if share_of(name, given) is not None:
                self.parameters[name] = length
                self.lengths.append(f"{flag_of(name)} {given} is {length:.6g}")
        if measured.size_rules != self.settings.size_rules:
            self.parameters["size_rules"] = ";".join(measured.size_rules or ())
        self.settings = measured

    def endings(self) -> dict[str, tuple[str, ...]]:
        """The possible endings of the file of each option."""
        return {}

    def work(self) -> None:
        raise NotImplementedError

    def summary(self) -> list[str]:
        raise NotImplementedError

    def result(self) -> str:
        """The result in a few words."""
        return self.error or self.success()

    def success(self) -> str:
        return verdict(self.statistics)

    @contextmanager
    def reading(self) -> Iterator[None]:
        """Show and time the reading within the block."""
        began = time.monotonic()
        self.bars.show(READING, 0)
        yield
        self.bars.finish()
        self.seconds_read = time.monotonic() - began

    def read(self) -> vtkPolyData:
        with self.reading():
            if self.options.together:
                surface, warnings = join(self.read_bodies())
                self.warnings = self.warnings + warnings
            else:
                surface = self.read_one(self.files.surface)
                self.measure_lengths(surface)
        return surface

    def read_bodies(self) -> dict[str, vtkPolyData]:
        """All surfaces by the names of bodies."""
        bodies = {name: self.read_one(path) for name, path in self.files.bodies().items()}
        self.measure_lengths(*bodies.values())
        return bodies

    def read_solid(self) -> vtkUnstructuredGrid:
        with self.reading():
            solid, self.warnings = read_solid(self.files.surface, self.show_reading)
            self.measure_lengths(solid)
        return solid

    def read_one(self, path: str) -> vtkPolyData:
        show = self.show_reading
        surface, warnings = read_standard_input(self.options.format, show) if path == "-" else read_surface(path, show)
        self.warnings = self.warnings + warnings
        return surface

    def show_reading(self, _: str, fraction: float) -> None:
        self.show((READING,), READING, fraction)

    def show_progress(self, stage: str, fraction: float) -> None:
        self.show(self.stages, stage, fraction)

    def show(self, stages: Sequence[str], stage: str, fraction: float) -> None:
        timeout = self.options.timeout
        if timeout is not None and time.monotonic() - self.begin > timeout:
            raise Error(f"{self.files.name()}: stopped while {stage}, after the {timeout:g} s of --timeout")
        self.bars.show_part(stages, stage, fraction)

    def measure(self) -> None:
        self.statistics["SecondsRead"] = self.seconds_read
        self.statistics["SecondsTotal"] = time.monotonic() - self.begin
        self.statistics["PeakMemory"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

    def write_report(self) -> None:
        """Write the report, if requested and possible."""
        if not self.report_is_writable or self.files.report is None:
            return
        work_on(self.files.report)
        text = json.dumps(self.report(), indent=2, allow_nan=False) + "\n"
        write_bytes(text.encode(errors="backslashreplace"), self.files.report)
        self.is_report_written = True

    def report(self) -> dict[str, Any]:
        """The results, in a form that JSON can represent."""
        report = {
            "version": __version__,
            "input": self.files.name(),
            "outputs": self.outputs,
            "parameters": self.parameters,
            "exit_status": self.status,
            "error": self.error,
            "warnings": self.warnings,
            "statistics": self.statistics,
            **self.more_for_the_report(),
        }
        held: dict[str, Any] = _without_infinities(report)
        return held

    def more_for_the_report(self) -> dict[str, object]:
        return {}

    def print_error(self, message: str) -> None:
        """Print one line, with the surface's name if there are several."""
        surface = self.files.surface
        message = error_in_words_of_command(message)
        print_error(f"{surface}: {message}" if self.options.several and surface not in message else message)

    def notes(self) -> list[str]:
        """Notes on the result that are not warnings, one line each."""
        return self.lengths

    def print_summary(self) -> None:
        lines = self.summary()
        lines += [f"Note: {note}" for note in self.notes()]
        lines += [f"Warning: {warning}" for warning in in_words_of_command(self.warnings)]
        lines += [f"Wrote {kind:10} {path}" for kind, path in self.outputs.items()]
        if self.is_report_written:
            lines.append(f"Wrote {'report':10} {self.files.report}")
        print_lines(lines)


def print_lines(lines: Sequence[str]) -> None:
    try:
        print("\n".join(lines), flush=True)
    except OSError:
        # The reader has closed the pipe (`| head`). The files are written, and Python must not complain on exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _without_infinities(value: Any) -> Any:
    """The values for JSON, which has no infinity and NaN: None in their place, as for the volume of a cube of side
    1e110."""
    if isinstance(value, dict):
        return {key: _without_infinities(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_without_infinities(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def print_error(error: str) -> None:
    try:
        print(f"insideout: {error}", file=sys.stderr, flush=True)
        told()
    except OSError:
        pass  # the exit status reports it
