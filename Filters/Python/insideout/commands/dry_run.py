# SPDX-License-Identifier: GPL-3.0-or-later
"""`--dry-run`: a description of the input, an estimate of the work, and the files that would be written."""

from __future__ import annotations

import os

from ..arguments import FILE_OPTIONS
from ..checking import check
from ..estimates import Estimate, estimate, is_beyond_limit
from ..files import STANDARD_INPUT, WRITABLE_SURFACES, ending
from ..quality import check_solid, solid_verdict
from ..stages import CHECK, CHECK_SOLID
from ..usage import CHECK_OPTIONS
from .boolean import BooleanJob
from .job import Job
from .mesh import MeshJob


class DryRun(Job):
    """One run that checks the input and options of another run."""

    def __init__(self, planned: Job):
        super().__init__(planned.options, planned.files)
        self.planned = planned
        self.readable = planned.readable
        self.stages = CHECK_SOLID if self.files.is_solid() else CHECK
        self.verdicts: dict[str, str] = {}  # by files
        self.makes_cells = isinstance(planned, (MeshJob, BooleanJob)) and not planned.goes_without_cells()
        self.estimate = Estimate()

    def check(self) -> None:
        self.planned.check()
        self.parameters, self.settings = self.planned.parameters, self.planned.settings
        self.is_working = True

    def work(self) -> None:
        if self.files.is_solid():
            self.look_at_solid()
        else:
            self.look_at_surfaces()
        self.measure()

    def look_at_solid(self) -> None:
        result = check_solid(self.read_solid(), progress=self.show_progress)
        self.verdicts[self.files.surface] = solid_verdict(result.statistics)
        self.statistics = dict(result.statistics)

    def look_at_surfaces(self) -> None:
        with self.reading():
            surfaces = self.read_bodies()
        if self.makes_cells and self.settings.size_rules:
            self.warnings.append("size_rules may ask for more cells than the estimate, which leaves them out")
        options = {name: getattr(self.settings, name) for name in CHECK_OPTIONS}
        for path, surface in zip(self.files.surfaces(), surfaces.values()):
            result = check(surface, progress=self.show_progress, **options)
            self.warnings += result.warnings
            self.verdicts[STANDARD_INPUT if path == "-" else path] = result.verdict
            if self.makes_cells and "IntersectingPairs" in result.statistics:  # lines in a plane take no time
                one = estimate(result.statistics, self.settings)
                self.estimate += one
                self.tell_of_limit(path, one)
            self.statistics = dict(result.statistics)
        self.bars.finish()

    def tell_of_limit(self, path: str, found: Estimate) -> None:
        if is_beyond_limit(found, self.settings):
            words = "so short an edge_length asks for more cells than maximum_cells allows: the work would stop before refining"
            self.warnings.append(f"{path}: {words}")

    def to_be_written(self) -> dict[str, str]:
        """The files by their content."""
        output = "surface" if ending(self.files.output or "") in WRITABLE_SURFACES else "winding" if self.options.points else "solid"
        named = {"output": output, "plot": "picture"}
        paths = {name: getattr(self.files, name) for name in FILE_OPTIONS}
        return {named.get(name, name): path for name, path in paths.items() if path is not None}

    def success(self) -> str:
        return next(iter(self.verdicts.values()))

    def more_for_the_report(self) -> dict[str, object]:
        return {"verdicts": self.verdicts, "would_write": self.to_be_written(), "estimate": vars(self.estimate) if self.estimate.cells else None}

    def summary(self) -> list[str]:
        kind = "Solid" if self.files.is_solid() else "Surface"
        return [
            *(f"{kind} {os.path.basename(path)}: {sentence}" for path, sentence in self.verdicts.items()),
            *([f"  {self.estimate.words()}"] if self.estimate.cells else []),
            *(f"Would {'replace' if os.path.exists(path) else 'write'} {what:10} {path}" for what, path in self.to_be_written().items()),
        ]
