# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces in files of objects, each in its place: GLB and 3MF. The other formats of surfaces are C++'s."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..errors import Error
from .read_3mf import read_3mf
from .read_glb import read_glb
from .write_3mf import write_3mf
from .write_glb import write_glb

_READERS = {".glb": read_glb, ".3mf": read_3mf}
_WRITERS = {".glb": write_glb, ".3mf": write_3mf}

OBJECTS = (*_READERS,)
"""The endings of their names."""

BEGINNINGS = {b"glTF": ".glb", b"PK\x03\x04": ".3mf"}


def read_objects(path: str, kind: str, most: float) -> tuple[vtkPolyData, list[str]]:
    """The surface in a file, which may take `most` bytes, and warnings. Raises `Error` without the file's name."""
    try:
        with np.errstate(all="ignore"):  # what is not finite is named later
            assembly = _READERS[kind](path, most)
            return assembly.surface(), assembly.warnings()
    except MemoryError:
        raise Error("not enough memory to read it") from None


def bytes_of_objects(surface: vtkPolyData, kind: str) -> tuple[bytes, list[str]]:
    """The content of a file, and what it does not keep. Raises `Error` without its name."""
    try:
        return _WRITERS[kind](surface)
    except MemoryError:
        raise Error("not enough memory to write it") from None
