# SPDX-License-Identifier: GPL-3.0-or-later
"""Read GLB, the binary form of glTF 2.0 (Khronos Group, glTF 2.0 Specification, 2021).

VTK's own reader drops the names of nodes, ends the process where a file refers to what is not there, and reads
truncated files without a word.
"""

from __future__ import annotations

import json
import struct
from typing import Any, Iterator

import numpy as np
from numpy.typing import NDArray

from ..errors import Error, brief
from .assembly import Assembly

_HEADER, _CHUNK = struct.Struct("<4sII"), struct.Struct("<I4s")
_VERSION = 2

_NUMBERS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_COMPONENTS = {"SCALAR": 1, "VEC3": 3}

_TRIANGLES, _STRIP, _FAN = 4, 5, 6
_MODES = range(7)

_HARMLESS = ("KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_", "KHR_mesh_quantization")
"""How the names of extensions begin that do not change the shape, and the one that `_Gltf.numbers` reads."""


def read_glb(path: str, most: float) -> Assembly:
    """The triangles of a file's scene, each mesh wherever a node places it. Raises `Error` without the file's name.

    Coordinates are taken as they are: y is up, and meters are meant.
    """
    with open(path, "rb") as file:
        text, binary = _chunks(file.read())
    assembly = Assembly(most)
    try:
        content = json.loads(text.decode("utf-8-sig"))
        if not isinstance(content, dict):
            raise TypeError(f"it is {brief(content)}")
        _Gltf(content, binary, assembly).read()
    except RecursionError:
        raise Error("its JSON is nested too deeply") from None
    except KeyError as error:
        raise Error(f"its JSON is damaged: {error} is missing") from None
    except (AttributeError, OverflowError, TypeError, ValueError) as error:
        raise Error(f"its JSON is damaged: {error}") from None
    return assembly


def _chunks(content: bytes) -> tuple[bytes, memoryview]:
    """The JSON, and the numbers, which may be missing."""
    if len(content) < _HEADER.size:
        raise Error("its end is missing")
    _, version, length = _HEADER.unpack_from(content)
    if version != _VERSION:
        raise Error(f"is of version {version} of glTF; only version {_VERSION} is read")
    if length > len(content):
        raise Error(f"its end is missing: {length} bytes announced, {len(content)} present")
    chunks: dict[bytes, memoryview] = {}
    at = _HEADER.size
    while at + _CHUNK.size <= length:
        size, kind = _CHUNK.unpack_from(content, at)
        at += _CHUNK.size
        if at + size > length:
            raise Error(f"is damaged: {size} bytes announced for a chunk, {length - at} present")
        chunks.setdefault(kind, memoryview(content)[at : at + size])
        at += size
    if b"JSON" not in chunks:
        raise Error("is damaged: it has no JSON")
    return bytes(chunks[b"JSON"]), chunks.get(b"BIN\0", memoryview(b""))


class _Gltf:
    """What the JSON says. Nothing in it is trusted; what Python raises for it is caught above."""

    def __init__(self, content: dict[str, Any], binary: memoryview, assembly: Assembly):
        self.content, self.binary, self.assembly = content, binary, assembly

    def read(self) -> None:
        for name in self.content.get("extensionsRequired", []):
            if not name.startswith(_HARMLESS):
                raise Error(f"needs the extension {name}, which is not read")
        for name, matrix, node in self.placements():
            self.place_mesh(name, matrix, node)
        count = len(self.content.get("textures", []))
        if count:
            self.assembly.passed_over["textures"] = count

    def item(self, kind: str, index: Any) -> dict[str, Any]:
        items = self.content.get(kind, [])
        if _whole(index, kind) >= len(items):
            raise ValueError(f"it refers to number {index} of {len(items)} {kind}")
        return items[index]

    def placements(self) -> Iterator[tuple[str, NDArray[np.float64], dict[str, Any]]]:
        """The nodes of the scene that have a mesh: name, place in the scene and node."""
        nodes = self.content.get("nodes", [])
        if self.content.get("scenes"):
            roots = self.item("scenes", self.content.get("scene", 0)).get("nodes", [])
        else:  # everything
            children = {child for node in nodes for child in node.get("children", [])}
            roots = [index for index in range(len(nodes)) if index not in children]
        waiting = [(index, np.eye(4)) for index in reversed(roots)]
        seen = set()
        while waiting:
            index, above = waiting.pop()
            node = self.item("nodes", index)
            if index in seen:
                raise ValueError(f"node {index} has two parents")
            seen.add(index)
            matrix = above @ _matrix_of(node, f"node {index}")
            waiting += [(child, matrix) for child in reversed(node.get("children", []))]
            if "mesh" in node:
                yield node.get("name") or self.item("meshes", node["mesh"]).get("name") or "", matrix, node

    def place_mesh(self, name: str, matrix: NDArray[np.float64], node: dict[str, Any]) -> None:
        mesh, assembly = self.item("meshes", node["mesh"]), self.assembly
        assembly.begin_object(str(name))
        for words, is_there in (("skins", "skin" in node), ("morphs", "weights" in node or "weights" in mesh)):
            if is_there:
                assembly.passed_over[words] += 1
        for primitive in mesh["primitives"]:
            mode = primitive.get("mode", _TRIANGLES)
            if mode not in _MODES:
                raise ValueError(f"a primitive has the mode {brief(mode)}")
            if mode < _TRIANGLES:
                assembly.passed_over["primitives of points or lines"] += 1
            elif "POSITION" in primitive["attributes"]:
                self.place_primitive(primitive, mode, matrix)

    def place_primitive(self, primitive: dict[str, Any], mode: int, matrix: NDArray[np.float64]) -> None:
        accessor = primitive["attributes"]["POSITION"]
        points = self.numbers(accessor, "VEC3")
        if "indices" in primitive:
            ids = self.numbers(primitive["indices"], "SCALAR").ravel()
        else:
            ids = np.arange(len(points))
        if ids.dtype.kind not in "iu" or len(ids) > 0 and not 0 <= int(ids.min()) <= int(ids.max()) < len(points):
            raise ValueError(
                f"the accessor {primitive['indices']} has ids of points outside 0 to {len(points) - 1}"
            )
        key = primitive.get("material")
        material = self.assembly.material() if key is None else self.assembly.material(key, self.name_of_material(key))
        first = self.assembly.add_points(accessor, points, matrix)
        self.assembly.add_triangles(_triangles_of(ids, mode), first, matrix, material)

    def name_of_material(self, index: int) -> str:
        return str(self.item("materials", index).get("name") or f"material {index}")

    def numbers(self, index: int, kind: str) -> NDArray:
        """What an accessor gives, a row for each of its elements; integers that stand for fractions become these."""
        accessor, width = self.item("accessors", index), _COMPONENTS[kind]
        if accessor["type"] != kind or accessor["componentType"] not in _NUMBERS:
            raise ValueError(
                f"the accessor {index} is of {brief(accessor['type'])} of type {brief(accessor['componentType'])}"
            )
        if "sparse" in accessor or "bufferView" not in accessor:
            raise Error(f"has a sparse accessor ({index}), which is not read")
        data_type = np.dtype(_NUMBERS[accessor["componentType"]])
        count, begin = (_whole(accessor.get(name, 0), name) for name in ("count", "byteOffset"))
        view = self.item("bufferViews", accessor["bufferView"])
        data = self.bytes_of(view, accessor["bufferView"])
        stride = _whole(view.get("byteStride", width * data_type.itemsize), "byteStride")
        end = begin + stride * (count - 1) + width * data_type.itemsize
        if count > 0 and (stride < width * data_type.itemsize or end > len(data)):
            raise ValueError(f"the accessor {index} reaches beyond its buffer view")
        if count == 0:
            return np.zeros((0, width), data_type)
        rows: NDArray = np.ndarray((count, width), data_type, data, begin, (stride, data_type.itemsize))
        if not accessor.get("normalized") or data_type.kind == "f":
            return rows
        return np.maximum(rows / float(np.iinfo(data_type).max), -1.0)

    def bytes_of(self, view: dict[str, Any], index: int) -> memoryview:
        buffer = self.item("buffers", view["buffer"])
        if "uri" in buffer or view["buffer"] != 0:
            raise Error(f"has numbers outside of its own chunk for them (buffer {view['buffer']}), which are not read")
        begin, length = (_whole(view.get(name, 0), name) for name in ("byteOffset", "byteLength"))
        if begin + length > len(self.binary):
            raise ValueError(f"the buffer view {index} reaches beyond the {len(self.binary)} bytes of numbers")
        return self.binary[begin : begin + length]


def _whole(value: Any, name: str) -> int:
    if type(value) is not int or value < 0:
        raise ValueError(f"{name} is {brief(value)}; it must be an integer from 0 on")
    return value


def _triangles_of(ids: NDArray, mode: int) -> NDArray:
    if mode == _TRIANGLES:
        if len(ids) % 3:
            raise ValueError(f"a primitive of triangles has {len(ids)} corners, which 3 does not divide")
        return ids.reshape(-1, 3)
    if mode == _FAN:
        return np.column_stack([np.repeat(ids[:1], max(len(ids) - 2, 0)), ids[1:-1], ids[2:]])
    triangles = np.column_stack([ids[:-2], ids[1:-1], ids[2:]])
    triangles[1::2] = triangles[1::2, [0, 2, 1]]  # every other one runs the other way
    return triangles


def _matrix_of(node: dict[str, Any], name: str) -> NDArray[np.float64]:
    """From the coordinates of a node to those of its parent."""
    matrix = np.eye(4)
    if "matrix" in node:
        matrix = _vector(node["matrix"], 16, name).reshape(4, 4).T
    else:
        x, y, z, w = _vector(node.get("rotation", [0, 0, 0, 1]), 4, name)
        turn = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
        matrix[:3, :3] = np.array(turn) * _vector(node.get("scale", [1, 1, 1]), 3, name)
        matrix[:3, 3] = _vector(node.get("translation", [0, 0, 0]), 3, name)
    return matrix


def _vector(values: Any, length: int, name: str) -> NDArray[np.float64]:
    vector = np.array(values, float)
    if vector.shape != (length,) or not np.isfinite(vector).all():
        raise ValueError(f"{name} is placed by {brief(values)}")
    return vector
