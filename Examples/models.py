# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for the examples: those of Debian's package libcgal-demo."""

from __future__ import annotations

import tarfile
from pathlib import Path

PACKED = ("/usr/share/doc/libcgal-dev/data.tar.gz", "/usr/share/doc/libcgal-demo/data.tar.gz")


def unpacked(name: str, folder: Path) -> Path:
    """A surface of the package, in the folder."""
    packed = next((archive for archive in PACKED if Path(archive).exists()), None)
    if packed is None:
        raise FileNotFoundError("no surface: give one, or apt-get install libcgal-demo")
    with tarfile.open(packed) as archive:
        (folder / name).write_bytes(archive.extractfile(f"data/meshes/{name}").read())
    return folder / name
