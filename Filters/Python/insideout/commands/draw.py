# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout draw`: a picture of a surface and of what becomes of it. Solids are drawn when they are checked."""

from __future__ import annotations

from .mesh import MeshJob


class DrawJob(MeshJob):
    """One run that makes tetrahedra for a picture, and writes nothing else."""
