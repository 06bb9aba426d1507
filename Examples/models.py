# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for the examples: those of Debian's packages libcgal-demo and openfoam-examples."""

from __future__ import annotations

import gzip
import tarfile
from pathlib import Path

OPENFOAM = Path("/usr/share/doc/openfoam-examples")
PACKED = ("/usr/share/doc/libcgal-dev/data.tar.gz", "/usr/share/doc/libcgal-demo/data.tar.gz")


def unpacked(name: str, folder: Path, kind: str = "meshes") -> Path:
    """A surface of one of the packages, in the folder; or what stands in another of CGAL's folders, as points_3."""
    path = folder / name
    for packed in sorted(OPENFOAM.rglob(f"{name}.gz"))[:1]:
        path.write_bytes(gzip.decompress(packed.read_bytes()))
        return path
    for archive in filter(Path.exists, map(Path, PACKED)):
        with tarfile.open(archive) as members:
            path.write_bytes(members.extractfile(f"data/{kind}/{name}").read())
            return path
    raise FileNotFoundError(f"{name} is not there: apt-get install libcgal-demo openfoam-examples")
