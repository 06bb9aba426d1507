# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout query`: winding numbers and distances at points."""

from __future__ import annotations

import os
from typing import Any, Sequence

from ..errors import ArgumentError
from ..files import check_input, ending
from ..grid_files import WRITABLE_DISTANCES
from ..interruption import work_on
from ..options import Options
from ..places import QUERIES, Places, read_places
from ..queries import ask
from ..stages import DISTANCES, WINDING, WRITING
from ..summary import winding_summary
from ..usage import WINDING_OPTIONS
from ..vtkFiltersInsideOut import vtkProbeWindingNumber
from .job import Job


class QueryJob(Job):
    """One run that evaluates winding numbers at the user's points."""

    stages: Sequence[str] = WINDING

    def check_parameters(self) -> dict[str, Any]:
        if self.options.distance:
            self.stages = (*WINDING, DISTANCES)
        check_input(self.options.points, QUERIES)
        return self.parameters_of(WINDING_OPTIONS, vtkProbeWindingNumber())

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"output": (ending(self.options.points),)}

    def check(self) -> None:
        output = self.files.output or ""
        if ending(output) in WRITABLE_DISTANCES and ending(output) not in QUERIES:
            wrong = f"unknown ending, it must be {ending(self.options.points)}, as of {self.options.points}"
            raise ArgumentError(f"{output}: {wrong}; in Python insideout.sdf_grid makes grids that insideout.write puts there")
        super().check()

    def work(self) -> None:
        surface = self.read()
        places: Places = read_places(self.options.points)
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
