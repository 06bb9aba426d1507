# SPDX-License-Identifier: GPL-3.0-or-later
"""Write GLB, the binary form of glTF 2.0: a node and a mesh for each group, on points that all of them share."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..errors import Error
from .groups import Groups

_MOST = 2**32 - 1  # bytes

_FLOAT, _UNSIGNED_INT = 5126, 5125
_VERTICES, _INDICES = 34962, 34963  # what buffer views are for


def write_glb(surface: vtkPolyData) -> tuple[bytes, list[str]]:
    """The content of a file, and what floats make worse. Raises `Error` without its name."""
    groups = Groups(surface, "GLB", in_floats=True)
    # "asset" first: its generator is the mark that files are told by.
    content: dict[str, Any] = {
        "asset": {"generator": "Written by InsideOut", "version": "2.0"},
        "scene": 0,
        "scenes": [{}],
    }
    parts: list[bytes] = []
    if len(groups.triangles):
        points = groups.points.astype("<f4")
        limits = {
            name: [float(x) for x in row] for name, row in (("min", points.min(axis=0)), ("max", points.max(axis=0)))
        }
        _add(
            content, parts, points, _VERTICES, {"componentType": _FLOAT, "type": "VEC3", "count": len(points), **limits}
        )
        for index, (name, triangles) in enumerate(zip(groups.names, groups.triangles_of_groups())):
            ids = triangles.astype("<u4").ravel()
            _add(content, parts, ids, _INDICES, {"componentType": _UNSIGNED_INT, "type": "SCALAR", "count": len(ids)})
            primitive = {"attributes": {"POSITION": 0}, "indices": index + 1}
            content.setdefault("meshes", []).append({"name": name, "primitives": [primitive]})
            content.setdefault("nodes", []).append({"name": name, "mesh": index})
        content["scenes"][0]["nodes"] = list(range(len(groups.names)))
        content["buffers"] = [{"byteLength": sum(map(len, parts))}]
    text = json.dumps(content, separators=(",", ":")).encode()
    chunks = [_chunk(b"JSON", text + b" " * (-len(text) % 4)), *(_chunk(b"BIN\0", b"".join(parts)) for _ in parts[:1])]
    length = 12 + sum(map(len, chunks))
    if length > _MOST:
        raise Error(f"would have {length} bytes, and GLB holds {_MOST}")
    return b"".join([struct.pack("<4sII", b"glTF", 2, length), *chunks]), groups.warnings


def _add(content: dict[str, Any], parts: list[bytes], numbers: NDArray, target: int, accessor: dict[str, Any]) -> None:
    """An accessor with a buffer view of its own."""
    views = content.setdefault("bufferViews", [])
    begin = sum(map(len, parts))
    parts.append(numbers.tobytes())
    views.append({"buffer": 0, "byteOffset": begin, "byteLength": len(parts[-1]), "target": target})
    content.setdefault("accessors", []).append({"bufferView": len(views) - 1, **accessor})


def _chunk(kind: bytes, content: bytes) -> bytes:
    if len(content) > _MOST:
        raise Error(f"would have {len(content)} bytes, and GLB holds {_MOST}")
    return struct.pack("<I4s", len(content), kind) + content
