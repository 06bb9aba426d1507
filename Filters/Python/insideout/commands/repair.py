# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout repair`: the watertight boundary of the solid that a surface means."""

from __future__ import annotations

import argparse
from dataclasses import replace

from ..arguments import Files
from ..files import WRITABLE_SURFACES
from .mesh import MeshJob


class RepairJob(MeshJob):
    """One run, with tetrahedra only if the boundary requires them."""

    def __init__(self, options: argparse.Namespace, files: Files):
        super().__init__(options, files)
        self.settings = replace(self.settings, surface_only=True)

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {**super().endings(), "output": WRITABLE_SURFACES}
