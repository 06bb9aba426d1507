# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout boolean`: a set operation of several surfaces."""

from __future__ import annotations

import time
from typing import Any, Sequence

from ..booleans import Boolean, boolean
from ..files import WRITABLE_SURFACES, ending, write_surface
from ..interruption import work_on
from ..pipeline import Error
from ..solid_files import WRITABLE_GRIDS, write_solid, written_beside
from ..stages import TETRAHEDRALIZE, WRITING
from ..summary import boolean_summary
from ..usage import SET_OPTIONS
from ..vtkFiltersInsideOut import vtkWindingBoolean
from .job import Job


class BooleanJob(Job):
    """One run that makes a set operation of several surfaces."""

    stages: Sequence[str] = TETRAHEDRALIZE
    names: list[str] = []

    def check_parameters(self) -> dict[str, Any]:
        if not self.options.expression.strip():
            raise Error(f"{self.options.called} is given no expression; A | B is the union of two surfaces")
        return {"expression": self.options.expression, **self.parameters_of(SET_OPTIONS, vtkWindingBoolean())}

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"output": WRITABLE_GRIDS + WRITABLE_SURFACES, "boundary": WRITABLE_SURFACES}

    def check(self) -> None:
        super().check()
        self.check_merging()
        self.check_name_beside()

    def goes_without_cells(self) -> bool:
        """Whether only the result's surface is written."""
        return ending(self.files.output or "") in WRITABLE_SURFACES

    def work(self) -> None:
        with self.reading():
            surfaces = self.read_bodies()
        takes_cells = not self.goes_without_cells()
        options = {name: getattr(self.settings, name) for name in SET_OPTIONS}
        result = boolean(surfaces, self.options.expression, tetrahedra=takes_cells, progress=self.show_progress, **options)
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
            raise Error(f"{self.files.name()}: nothing is left of {self.options.expression}")

    def write(self, result: Boolean, takes_cells: bool) -> None:
        began = time.monotonic()
        self.bars.show(WRITING, 0)
        output, boundary = self.files.output or "", self.files.boundary
        work_on(output)
        if takes_cells:
            told = write_solid(result.solid, output, result.surface, self.options.msh_version or "4.1", self.statistics, replaces_beside=self.is_replacing())
            # This command does not refine.
            self.warnings = self.warnings + [words.replace("(refine)", "(insideout refine)") for words in told]
        else:
            self.warnings = self.warnings + write_surface(result.surface, output)
        self.outputs["solid" if takes_cells else "surface"] = output
        self.outputs.update(written_beside(output, result.solid, result.surface) if takes_cells else {})
        if boundary is not None:
            work_on(boundary)
            self.warnings = self.warnings + write_surface(result.surface, boundary)
            self.outputs["boundary"] = boundary
        self.bars.finish()
        self.statistics["SecondsWrite"] = time.monotonic() - began

    def success(self) -> str:
        return "made"

    def more_for_the_report(self) -> dict[str, object]:
        return {"bodies": self.names}

    def summary(self) -> list[str]:
        return boolean_summary(self.names, self.options.expression, self.statistics)
