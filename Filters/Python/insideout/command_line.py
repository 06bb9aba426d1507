# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `python3 -m insideout`.

Everything that can be known to fail is checked before the work begins: names, endings, folders and
parameters. Files are written before anything is printed about them. Several surfaces are worked on one
after the other; one that fails does not keep the others from it.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import resource
import sys
import time
from contextlib import contextmanager
from dataclasses import replace
from typing import Any, Callable, Iterator, Optional, Sequence

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .arguments import CHECK_OPTIONS, WINDING_OPTIONS, Files, parse
from .bodies import BODY_IDS, join, outer_boundary
from .booleans import Boolean, boolean
from .checking import Finding, check
from .data import Tetrahedra
from .drawing import draw, draw_quality, up_of
from .files import (
    READABLE_SOLIDS,
    READABLE_SURFACES,
    WRITABLE_SURFACES,
    are_lines,
    check_holds_lines,
    check_input,
    check_output,
    ending,
    identity,
    read_solid,
    read_standard_input,
    read_surface,
    write_surface,
)
from .interruption import exit_status, message, told, work_on
from .options import OPTIONS, Options, in_words_of_command
from .pipeline import Error, set_threads, write_bytes
from .panels import PICTURES, display_command
from .places import QUERIES, Places, read_places
from .progress import StageBars
from .quality import check_solid, solid_verdict
from .queries import ask
from .stages import CHECK, CHECK_SOLID, DISTANCES, DRAWING, READING, REFINE, TETRAHEDRALIZE, WINDING, WRITING
from .summary import boolean_summary, check_summary, defects, seams, solid_summary, summary, table, tetrahedralizer, winding_summary
from .tetrahedralization import Region, Tetrahedralization, tetrahedralize
from .verdict import verdict
from .version import __version__
from .vtkFiltersInsideOut import vtkProbeWindingNumber, vtkRobustTetrahedralize, vtkSurfaceDefects, vtkWindingBoolean
from .writing import WRITABLE_GRIDS, WRITABLE_SOLIDS, MshVersion, check_format, check_holds_triangles, write_solid

SUCCESS, FAILURE = 0, 1
"""Of the exit status; above are those of signals."""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Do what the arguments say. Returns the exit status: 0 when that was done for every surface."""
    options, all_files = parse(arguments)
    try:
        check_names(options, all_files)
    except Error as error:
        _print_error(str(error))
        return FAILURE
    if options.threads is not None:
        set_threads(options.threads)
    jobs = []
    for files in all_files:
        jobs.append(job_of(options, files))
        if jobs[-1].run() > FAILURE:
            break  # interrupted
    if len(all_files) > 1 and not options.quiet:
        rows = [(job.files.name(), {"SecondsTotal": job.seconds, **job.statistics}, job.result()) for job in jobs]
        _print(table(rows, sum(job.status == SUCCESS for job in jobs), len(all_files)))
    return max(job.status for job in jobs)


def job_of(options: argparse.Namespace, files: Files) -> Job:
    """What to do with the files of one surface, or of one solid."""
    if options.check:
        return SolidCheckJob(options, files) if files.is_solid() else CheckJob(options, files)
    if options.boolean is not None:
        return BooleanJob(options, files)
    return WindingJob(options, files) if options.winding else MeshJob(options, files)


def check_names(options: argparse.Namespace, all_files: Sequence[Files]) -> None:
    """Raise `Error` where a file would be written that is read too, or written twice, under whatever names."""
    read = [*(surface for files in all_files for surface in files.surfaces()), options.winding, getattr(options, "seeds", None)]
    inputs = {identity(path): path for path in read if path not in (None, "-")}
    outputs: dict[object, str] = {}
    for path in (path for files in all_files for path in files.outputs()):
        which = identity(path)
        if which is not None and which in inputs:
            raise Error(f"{path} is named twice: it is read as {inputs[which]}, and no output may replace it")
        if which is not None and which in outputs:
            raise Error(f"{path} is named twice: it is {outputs[which]}, and a file cannot be two things")
        outputs[which] = path


class Job:
    """What the command does with one surface, and what is known of it so far."""

    stages: Sequence[str] = ()
    readable: tuple[str, ...] = READABLE_SURFACES

    def __init__(self, options: argparse.Namespace, files: Files):
        self.options = options
        self.files = files
        self.settings = Options.among({**vars(options), **({"bodies": BODY_IDS} if options.together else {})})
        self.bars = StageBars(None if options.quiet else sys.stderr)
        self.report_is_writable = False
        self.parameters: dict[str, Any] = {}
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
        if "SecondsTotal" in self.statistics and not self.options.quiet:  # the work came to its end
            self.print_summary()
        if self.error is not None:
            self.print_error(self.error)
        return self.status

    def attempt(self, *tasks: Callable[[], None]) -> int:
        """Do these. Returns the exit status; of several errors the first is kept."""
        try:
            for task in tasks:
                task()
            return SUCCESS
        except Error as failure:
            error, status = str(failure), FAILURE
        except OSError as failure:
            error, status = f"{failure.filename or 'system'}: {(failure.strerror or str(failure)).lower()}", FAILURE
        except MemoryError:
            error, status = f"{self.files.name()}: not enough memory", FAILURE
        except KeyboardInterrupt as interrupt:
            error, status = message(interrupt), exit_status(interrupt)
        self.error = self.error or error
        return status

    def check(self) -> None:
        """Raise `Error` for whatever can be known to fail before the work begins."""
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

    def result(self) -> str:
        """What came out, in a few words."""
        return self.error or self.success()

    def success(self) -> str:
        return verdict(self.statistics)

    @contextmanager
    def reading(self) -> Iterator[None]:
        """Shows and times what is read within it."""
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
        return surface

    def read_bodies(self) -> dict[str, vtkPolyData]:
        """All surfaces, by the names of bodies."""
        return {name: self.read_one(path) for name, path in self.files.bodies().items()}

    def read_one(self, path: str) -> vtkPolyData:
        def show(_: str, fraction: float) -> None:
            self.show((READING,), READING, fraction)

        surface, warnings = read_standard_input(self.options.format, show) if path == "-" else read_surface(path, show)
        self.warnings = self.warnings + warnings
        return surface

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
        """Write the report, if asked to and possible."""
        if not self.report_is_writable or self.files.report is None:
            return
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
        work_on(self.files.report)
        text = json.dumps(_without_infinities(report), indent=2, allow_nan=False) + "\n"
        write_bytes(text.encode(errors="backslashreplace"), self.files.report)

    def more_for_the_report(self) -> dict[str, object]:
        return {}

    def print_error(self, message: str) -> None:
        """One line, which says of which surface it is where there are several."""
        surface = self.files.surface
        several = len(self.options.files) > (1 if self.options.check else 2) and not self.files.others
        _print_error(f"{surface}: {message}" if several and surface not in message else message)

    def notes(self) -> list[str]:
        """What is as it should be, but good to know, one line each."""
        return []

    def print_summary(self) -> None:
        lines = self.summary()
        lines += [f"Note: {note}" for note in self.notes()]
        lines += [f"Warning: {warning}" for warning in in_words_of_command(self.warnings)]
        lines += [f"Wrote {kind:10} {path}" for kind, path in self.outputs.items()]
        _print(lines)


class MeshJob(Job):
    """One run that makes tetrahedra."""

    stages: Sequence[str] = TETRAHEDRALIZE
    left_out_cells: list[int] = []
    lost_cells: list[int] = []
    regions: list[Region] = []
    bodies: dict[str, float] = {}
    tags: dict[str, int] = {}

    def check_parameters(self) -> dict[str, Any]:
        if self.settings.refines():
            self.stages = (*TETRAHEDRALIZE, *REFINE)
        if self.files.plot is not None:
            display_command()
        return {**self.parameters_of(tuple(OPTIONS), vtkRobustTetrahedralize()), "refine": self.settings.refines()}

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {
            "output": WRITABLE_GRIDS + WRITABLE_SURFACES,
            "hull": WRITABLE_GRIDS,
            "boundary": WRITABLE_SURFACES,
            "outliers": WRITABLE_SURFACES,
            "plot": PICTURES,
        }

    def check(self) -> None:
        super().check()
        output = self.files.output or ""
        if self.settings.merge_coplanar_pieces and ending(output) in WRITABLE_SOLIDS:
            raise Error(f"{output}: after --merge-coplanar-pieces the boundary's triangles are no faces of tetrahedra, which such a file needs")
        for path in (output, self.files.hull or ""):
            check_format(path)
        for taking in (output, self.files.hull or "", self.files.plot or ""):
            if self.settings.surface_only and taking and ending(taking) not in WRITABLE_SURFACES:
                raise Error(f"{taking}: takes tetrahedra, which --surface-only goes without")

    def is_for_surface_only(self) -> bool:
        """Whether nothing is written that has tetrahedra, or tells of them."""
        files = self.files
        return ending(files.output or "") in WRITABLE_SURFACES and not (files.hull or files.plot or files.report)

    def check_plane(self, surface: vtkPolyData) -> None:
        """Raise `Error` for files that cannot hold what is in a plane, where it is known to be there."""
        if are_lines(surface) or str(self.settings.dimension) == "2":
            for path in filter(None, (self.files.output, self.files.hull, self.files.boundary, self.files.outliers)):
                (check_holds_lines if ending(path) in WRITABLE_SURFACES else check_holds_triangles)(path)

    def work(self) -> None:
        surface = self.read()
        self.check_plane(surface)
        if self.is_for_surface_only():
            self.settings = replace(self.settings, surface_only=True)
        result = tetrahedralize(surface, progress=self.show_progress, **vars(self.settings))
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.statistics = dict(result.statistics)
        self.left_out_cells = result.left_out_cells
        self.lost_cells = result.lost_cells
        self.regions = result.regions
        self.bodies = result.bodies
        self.tags = {name: len(triangles) for name, triangles in result.tags.items()}
        try:
            self.write(surface, result)
        finally:
            self.measure()
        if not {"solid", "surface"} & set(self.outputs):
            least, most = self.statistics["MinimumW"], self.statistics["MaximumW"]
            raise Error(f"{self.files.name()}: nothing is inside, w ranges from {least:.6g} to {most:.6g}")

    def write(self, surface: vtkPolyData, result: Tetrahedralization) -> None:
        """Write what was asked for; when nothing is inside, the hull and the picture alone."""
        began = time.monotonic()
        self.bars.show(WRITING, 0)
        for kind, data, path, write in self.files_to_write(result):
            work_on(path)
            write(data, path)
            self.outputs[kind] = path
        self.bars.finish()
        self.statistics["SecondsWrite"] = time.monotonic() - began
        if self.files.plot is not None:
            self.bars.show(DRAWING, 0)
            marks = {name: getattr(self.settings, name) for name in CHECK_OPTIONS}
            work_on(self.files.plot)
            # Where the solid is cells of the hull it need not be written twice.
            solid = result.solid if self.settings.refines() or self.settings.parts() else None
            draw(surface, result.hull, self.files.plot, solid=solid, up=up_of(self.files.surface), **marks)
            self.bars.finish()
            self.outputs["picture"] = self.files.plot
            self.statistics["SecondsDraw"] = time.monotonic() - began - self.statistics["SecondsWrite"]

    def files_to_write(self, result: Tetrahedralization) -> Iterator[tuple]:
        files = self.files
        version: MshVersion = self.options.msh_version or "4.1"

        def write_with_boundary(solid: Tetrahedra, path: str) -> None:
            write_solid(solid, path, result.boundary, version)

        if files.hull is not None:
            yield "hull", result.hull, files.hull, lambda hull, path: write_solid(hull, path, msh_version=version)
        if result.boundary.GetNumberOfCells() > 0:
            if ending(files.output or "") in WRITABLE_SURFACES:
                yield "surface", outer_boundary(result.boundary), files.output, write_surface
            else:
                yield "solid", result.solid, files.output, write_with_boundary
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
            "regions": [vars(region) for region in self.regions],
            "bodies": self.bodies,
            "tags": self.tags,
        }

    def summary(self) -> list[str]:
        volumes = [region.volume for region in self.regions]
        regions = ["+".join(region.bodies) for region in self.regions] if self.bodies else []
        return summary(os.path.basename(self.files.name()), self.statistics, volumes, self.tags, regions)

    def notes(self) -> list[str]:
        return [] if self.settings.split_seams else seams(self.statistics)


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
        return check_summary(os.path.basename(self.files.name()), self.statistics, self.findings, self.shell_volumes)


class SolidCheckJob(Job):
    """One run with --check, which reads a solid and looks at it."""

    stages = CHECK_SOLID
    readable = READABLE_SOLIDS
    findings: list[Finding] = []
    histogram: list[int] = []

    def check_parameters(self) -> dict[str, Any]:
        if self.files.plot is not None:
            display_command()
        return {}

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"plot": PICTURES}

    def work(self) -> None:
        with self.reading():
            solid, self.warnings = read_solid(self.files.surface, lambda _, fraction: self.show((READING,), READING, fraction))
        result = check_solid(solid, progress=self.show_progress)
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.findings, self.histogram = result.findings, result.histogram
        self.statistics = dict(result.statistics)
        try:
            if self.files.plot is not None:
                self.bars.show(DRAWING, 0)
                work_on(self.files.plot)
                draw_quality(result, self.files.plot)
                self.bars.finish()
                self.outputs["picture"] = self.files.plot
        finally:
            self.measure()

    def success(self) -> str:
        return solid_verdict(self.statistics)

    def more_for_the_report(self) -> dict[str, object]:
        return {
            "findings": [vars(finding) for finding in self.findings],
            "verdict": solid_verdict(self.statistics) if self.statistics else None,
            "dihedral_angle_histogram": self.histogram,
        }

    def summary(self) -> list[str]:
        return solid_summary(os.path.basename(self.files.name()), self.statistics, self.findings)


class WindingJob(Job):
    """One run with --winding, which evaluates winding numbers at places of the user's."""

    stages: Sequence[str] = WINDING

    def check_parameters(self) -> dict[str, Any]:
        if self.options.distance:
            self.stages = (*WINDING, DISTANCES)
        check_input(self.options.winding, QUERIES)
        return self.parameters_of(WINDING_OPTIONS, vtkProbeWindingNumber())

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"output": (ending(self.options.winding),)}

    def work(self) -> None:
        surface = self.read()
        places: Places = read_places(self.options.winding)
        options = {name: getattr(self.settings, name) for name in WINDING_OPTIONS}
        far = self.options.distance
        answer = ask(surface, places.data, Options(**options), self.show_progress, Distance=far)
        w = answer.array("w")
        self.warnings = self.warnings + answer.warnings
        self.bars.finish()
        self.bars.show(WRITING, 0)
        output = self.files.output or ""
        work_on(output)
        places.write(w, output, answer.array("Distance") if far else None)
        self.bars.finish()
        self.outputs["winding"] = output
        self.statistics = {"Places": len(w), "InsidePlaces": int((w > 0.5).sum())}
        if len(w):
            self.statistics.update(MinimumW=float(w.min()), MaximumW=float(w.max()))
        self.measure()

    def success(self) -> str:
        return "evaluated"

    def summary(self) -> list[str]:
        return winding_summary(os.path.basename(self.files.name()), self.statistics)


class BooleanJob(Job):
    """One run with --boolean, which makes a set operation of several surfaces."""

    stages: Sequence[str] = TETRAHEDRALIZE
    names: list[str] = []

    def check_parameters(self) -> dict[str, Any]:
        if not self.options.boolean.strip():
            raise Error("--boolean is given no expression; A | B is the union of two surfaces")
        return {"expression": self.options.boolean, **self.parameters_of(WINDING_OPTIONS, vtkWindingBoolean())}

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"output": WRITABLE_GRIDS + WRITABLE_SURFACES, "boundary": WRITABLE_SURFACES}

    def check(self) -> None:
        super().check()
        check_format(self.files.output or "")

    def work(self) -> None:
        with self.reading():
            surfaces = self.read_bodies()
        takes_cells = ending(self.files.output or "") not in WRITABLE_SURFACES
        options = {name: getattr(self.settings, name) for name in WINDING_OPTIONS}
        result = boolean(surfaces, self.options.boolean, tetrahedra=takes_cells, progress=self.show_progress, **options)
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.statistics = dict(result.statistics)
        self.names = result.names
        try:
            if result.surface.GetNumberOfCells() > 0:
                self.write(result, takes_cells)
        finally:
            self.measure()
        if not self.outputs:
            raise Error(f"{self.files.name()}: nothing is left of {self.options.boolean}")

    def write(self, result: Boolean, takes_cells: bool) -> None:
        began = time.monotonic()
        self.bars.show(WRITING, 0)
        output, boundary = self.files.output or "", self.files.boundary
        work_on(output)
        if takes_cells:
            write_solid(result.solid, output, result.surface, self.options.msh_version or "4.1")
        else:
            write_surface(result.surface, output)
        self.outputs["solid" if takes_cells else "surface"] = output
        if boundary is not None:
            work_on(boundary)
            write_surface(result.surface, boundary)
            self.outputs["boundary"] = boundary
        self.bars.finish()
        self.statistics["SecondsWrite"] = time.monotonic() - began

    def success(self) -> str:
        return "made"

    def more_for_the_report(self) -> dict[str, object]:
        return {"bodies": self.names}

    def summary(self) -> list[str]:
        return boolean_summary(self.names, self.options.boolean, self.statistics)


def _print(lines: Sequence[str]) -> None:
    try:
        print("\n".join(lines), flush=True)
    except OSError:
        # Nobody reads on (`| head`). The files are written, and Python is not to complain on exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _without_infinities(value: Any) -> Any:
    """The same for JSON, which has none: None in place of what is beyond all doubles, as the volume of 1e110 cubed."""
    if isinstance(value, dict):
        return {key: _without_infinities(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_without_infinities(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _print_error(error: str) -> None:
    try:
        print(f"insideout: {error}", file=sys.stderr, flush=True)
        told()
    except OSError:
        pass  # the exit status says it
