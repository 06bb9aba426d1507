# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that Debian's packages libcgal-demo and openfoam-examples bring, unpacked one by one."""

import gzip
import os
import tarfile
from pathlib import Path

CGAL = "/usr/share/doc/libcgal-dev/data.tar.gz"
OPENFOAM = "/usr/share/doc/openfoam-examples"
ENDINGS = (".off", ".obj", ".stl")


def unpack_cgal(folder, names=None, most_bytes=None):
    """Give the path of each surface of these names, or else of each that is small enough."""
    with tarfile.open(CGAL) as archive:
        for member in archive.getmembers():
            kept = os.path.basename(member.name)
            if not member.name.startswith("data/meshes/") or not kept.endswith(ENDINGS):
                continue
            if kept in names if names is not None else member.size <= most_bytes:
                member.name = kept
                archive.extract(member, folder)
                yield os.path.join(folder, kept)


def unpack_openfoam(folder, most_bytes):
    """Give the path of each surface whose packed file is small enough; of those that are the same, one."""
    seen = set()
    for packed in sorted(Path(OPENFOAM).rglob("*.gz")):
        content = packed.read_bytes() if packed.stem.endswith(ENDINGS) else b""
        if content and len(content) <= most_bytes and content not in seen:
            seen.add(content)
            path = Path(folder, f"{len(seen)}-{packed.stem}")
            path.write_bytes(gzip.decompress(content))
            yield str(path)
