# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout draw`: a picture or a page of a surface and its solid, or only of its defects. Pictures of solids are
drawn by check.py.
"""

from __future__ import annotations

import os
import time
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..checking import Check, check
from ..drawing import DRAWINGS, check_display, draw, up_of
from ..interruption import work_on
from ..marked import MARKED_FILES, write_marked
from ..stages import DRAWING
from ..tetrahedralization import Tetrahedralization
from ..usage import CHECK_OPTIONS
from .check import CheckJob
from .job import Job
from .mesh import MeshJob


def write_marks(job: Job, checked: Check) -> None:
    """On request write the file with the defects."""
    if job.files.marked is not None:
        work_on(job.files.marked)
        write_marked(checked, job.files.marked)
        job.outputs["marked"] = job.files.marked


class DrawJob(MeshJob):
    """One run that makes tetrahedra for a picture, and writes only picture and defects."""

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {**super().endings(), "marked": MARKED_FILES}

    def write(self, surface: vtkPolyData, result: Tetrahedralization) -> None:
        super().write(surface, result)
        if self.files.marked is not None:
            write_marks(self, check(surface, **{name: getattr(self.settings, name) for name in CHECK_OPTIONS}))


class DefectsJob(CheckJob):
    """One run that draws the defects, without meshing."""

    def check_parameters(self) -> dict[str, Any]:
        check_display(self.files.plot)
        return super().check_parameters()

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {"plot": DRAWINGS, "marked": MARKED_FILES}

    def work(self) -> None:
        super().work()
        began = time.monotonic()
        self.bars.show(DRAWING, 0)
        write_marks(self, self.checked)
        picture = self.files.plot or ""
        work_on(picture)
        draw(self.checked, None, picture, title=os.path.basename(self.files.name()), up=up_of(self.files.surface))
        self.bars.finish()
        self.outputs["picture"] = picture
        self.statistics["SecondsDraw"] = time.monotonic() - began
        self.measure()
