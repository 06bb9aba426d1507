# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout check`: the defects of a surface or a solid."""

from __future__ import annotations

import os
from typing import Any, Optional

from ..checking import Check, Finding, check
from ..drawing import draw_quality
from ..files import READABLE_SOLIDS
from ..interruption import work_on
from ..panels import PICTURES, display_command
from ..quality import check_solid, solid_verdict
from ..stages import CHECK, CHECK_SOLID, DRAWING
from ..summary import check_summary, defects, solid_summary
from ..usage import CHECK_OPTIONS
from ..vtkFiltersInsideOut import vtkSurfaceDefects
from .job import Job


class CheckJob(Job):
    """One run that checks a surface."""

    stages = CHECK
    checked: Check
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
        self.checked, self.findings, self.verdict = result, result.findings, result.verdict
        self.shell_volumes = result.shell_volumes
        self.statistics = dict(result.statistics)
        self.measure()

    def more_for_the_report(self) -> dict[str, object]:
        findings = [vars(finding) for finding in self.findings]
        return {"defects": defects(self.statistics), "findings": findings, "verdict": self.verdict, "shell_volumes": self.shell_volumes}

    def summary(self) -> list[str]:
        return check_summary(os.path.basename(self.files.name()), self.statistics, self.findings, self.shell_volumes)


class SolidCheckJob(Job):
    """One run that checks a solid, and on request draws it."""

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
        result = check_solid(self.read_solid(), progress=self.show_progress)
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
