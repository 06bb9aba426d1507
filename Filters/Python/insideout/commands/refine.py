# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout refine`: better tetrahedra of a solid."""

from __future__ import annotations

import os
import time
from typing import Any

from ..files import READABLE_SOLIDS
from ..interruption import work_on
from ..options import REFINING_OPTIONS
from ..refinement import refine
from ..solid_files import WRITABLE_GRIDS, write_solid
from ..stages import REFINE, WRITING
from ..summary import refinement_summary
from ..vtkFiltersInsideOut import vtkRefineTetrahedra
from .job import Job


class RefineJob(Job):
    """One run that refines a solid."""

    stages = REFINE
    readable = READABLE_SOLIDS

    def check_parameters(self) -> dict[str, Any]:
        return {**self.parameters_of(REFINING_OPTIONS, vtkRefineTetrahedra()), "sizes": self.options.sizes}

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"output": WRITABLE_GRIDS}

    def work(self) -> None:
        solid = self.read_solid()
        options = {name: getattr(self.settings, name) for name in REFINING_OPTIONS}
        result = refine(solid, sizes=self.options.sizes, progress=self.show_progress, **options)
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.statistics = dict(result.statistics)
        began = time.monotonic()
        self.bars.show(WRITING, 0)
        output = self.files.output or ""
        work_on(output)
        self.warnings = self.warnings + write_solid(result.solid, output, None, self.options.msh_version or "4.1", self.statistics)
        self.bars.finish()
        self.outputs["solid"] = output
        self.statistics["SecondsWrite"] = time.monotonic() - began
        self.measure()

    def success(self) -> str:
        return f"refined to {self.statistics['RefinedCells']:,} tetrahedra"

    def summary(self) -> list[str]:
        return refinement_summary(os.path.basename(self.files.name()), self.statistics)
