# SPDX-License-Identifier: GPL-3.0-or-later
"""Read 3MF (3MF Consortium, 3D Manufacturing Format, Core Specification 1.3, and Production Extension 1.1).

A ZIP archive of XML, of which the meshes and places of objects are taken. No document type declaration is, and
so no entity that grows: the specification forbids them.
"""

from __future__ import annotations

import struct
import zipfile
import zlib
from array import array
from dataclasses import dataclass, field
from typing import Any, Callable, Optional
from xml.parsers import expat

import numpy as np
from numpy.typing import NDArray

from ..errors import Error, brief
from .assembly import Assembly

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
_MATERIALS = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
_RELATIONSHIPS = "http://schemas.openxmlformats.org/package/2006/relationships"

MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
RELATIONSHIPS_PART = "_rels/.rels"

_HARMLESS = (_PRODUCTION, _MATERIALS)
"""Extensions that do not change the shape, and the one that is read."""

_PATH = f"{_PRODUCTION} path"

_MILLIMETER = "millimeter"

_PIECE = 1 << 20  # bytes, decompressed at once


def read_3mf(path: str, most: float) -> Assembly:
    """The triangles that the file says to build, each object in its places. Raises `Error` without the file's name.

    Coordinates are taken as they are; a warning says their unit where it is not millimeters.
    """
    assembly = Assembly(most)
    try:
        with zipfile.ZipFile(path) as archive:
            _Package(archive, assembly, most).read()
    except zipfile.BadZipFile as error:
        raise Error(f"is not a ZIP archive, or is damaged: {error}") from None
    except Error:
        raise
    except (EOFError, OSError, RuntimeError, ValueError, struct.error, zlib.error) as error:
        raise Error(f"its ZIP archive cannot be read: {error}") from None
    return assembly


@dataclass
class _Placement:
    """Where an object is used: by the build, or as a component of another object."""

    part: str
    number: str
    matrix: NDArray[np.float64]


@dataclass
class _Object:
    name: str
    points: array = field(default_factory=lambda: array("d"))
    corners: array = field(default_factory=lambda: array("q"))
    materials: array = field(default_factory=lambda: array("q"))
    """Numbers of `_Model.materials`."""
    components: list[_Placement] = field(default_factory=list)
    property: tuple[Optional[str], str] = (None, "0")
    """The material of triangles that name none: its group and its number there."""


class _Model:
    """What one part of the archive says."""

    def __init__(self, part: str, assembly: Assembly):
        self.part, self.assembly = part, assembly
        self.unit = _MILLIMETER
        self.objects: dict[str, _Object] = {}
        self.build: list[_Placement] = []
        self.materials: dict[tuple[Optional[str], int], int] = {}
        self.bases: dict[str, list[str]] = {}
        self.numbers = np.zeros(0, np.int32)
        """The assembly's numbers for each of `materials`, when all is read."""
        self._current = _Object("")
        self._base: list[str] = []
        self._spaces: dict[Optional[str], str] = {}

    def begin_space(self, prefix: Optional[str], uri: str) -> None:
        self._spaces[prefix] = uri

    def begin(self, tag: str, said: dict[str, str]) -> None:
        handler = _HANDLERS.get(tag)
        if handler is not None:
            handler(self, said)
        elif tag == f"{_MATERIALS} texture2d":
            self.assembly.passed_over["textures"] += 1
        elif tag.endswith(" beam"):
            self.assembly.passed_over["beams"] += 1

    def begin_model(self, said: dict[str, str]) -> None:
        self.unit = said.get("unit", _MILLIMETER)
        for prefix in said.get("requiredextensions", "").split():
            uri = self._spaces.get(prefix, "")
            if uri not in _HARMLESS:
                raise Error(f"needs the extension {uri or prefix}, which is not read")

    def begin_object(self, said: dict[str, str]) -> None:
        self._current = _Object(said.get("name", ""), property=(said.get("pid"), said.get("pindex", "0")))
        self.objects[said["id"]] = self._current

    def begin_vertex(self, said: dict[str, str]) -> None:
        self._current.points.extend((float(said["x"]), float(said["y"]), float(said["z"])))

    def begin_triangle(self, said: dict[str, str]) -> None:
        of_object = self._current.property
        self._current.corners.extend((int(said["v1"]), int(said["v2"]), int(said["v3"])))
        key = (said.get("pid", of_object[0]), int(said.get("p1", of_object[1])))
        self._current.materials.append(self.materials.setdefault(key, len(self.materials)))

    def begin_component(self, said: dict[str, str]) -> None:
        self._current.components.append(self.placement(said))

    def begin_item(self, said: dict[str, str]) -> None:
        self.build.append(self.placement(said))

    def begin_bases(self, said: dict[str, str]) -> None:
        self._base = self.bases[said["id"]] = []

    def begin_base(self, said: dict[str, str]) -> None:
        self._base.append(said["name"])

    def placement(self, said: dict[str, str]) -> _Placement:
        return _Placement(
            _name_of_part(said.get(_PATH, self.part)), said["objectid"], _matrix_of(said.get("transform"))
        )

    def end(self) -> None:
        self.numbers = np.array([self.number_of(*key) for key in self.materials], np.int32)

    def number_of(self, group: Optional[str], index: int) -> int:
        """Only base materials have names: colors and the like count as none."""
        names = self.bases.get(group or "", [])
        if not 0 <= index < len(names):
            return self.assembly.material()
        return self.assembly.material((self.part, group, index), names[index])


_HANDLERS: dict[str, Callable[[_Model, dict[str, str]], None]] = {
    f"{CORE} model": _Model.begin_model,
    f"{CORE} object": _Model.begin_object,
    f"{CORE} vertex": _Model.begin_vertex,
    f"{CORE} triangle": _Model.begin_triangle,
    f"{CORE} component": _Model.begin_component,
    f"{CORE} item": _Model.begin_item,
    f"{CORE} basematerials": _Model.begin_bases,
    f"{CORE} base": _Model.begin_base,
}


class _Package:
    """The archive, of which no more than `most` bytes are taken out."""

    def __init__(self, archive: zipfile.ZipFile, assembly: Assembly, most: float):
        self.archive, self.assembly, self.most = archive, assembly, most
        self.taken = 0
        self.models: dict[str, _Model] = {}

    def read(self) -> None:
        root = self.model(self.name_of_root())
        if root.unit != _MILLIMETER:
            self.assembly.notes.append(f"its unit is {brief(root.unit)}; coordinates are taken as they are")
        waiting = [(placement, "", 0) for placement in reversed(root.build)]
        while waiting:
            placement, above, depth = waiting.pop()
            model = self.model(placement.part)
            if placement.number not in model.objects:
                raise Error(f"is damaged: {placement.part} has no object {brief(placement.number)}, which is placed")
            if depth > sum(len(known.objects) for known in self.models.values()):
                raise Error(f"is damaged: the object {brief(placement.number)} is a component of itself")
            placed = model.objects[placement.number]
            name = placed.name or above
            waiting += [
                (_Placement(component.part, component.number, placement.matrix @ component.matrix), name, depth + 1)
                for component in reversed(placed.components)
            ]
            self.assembly.begin_object(name)
            if placed.corners:
                self.place(placed, placement, model)

    def place(self, placed: _Object, placement: _Placement, model: _Model) -> None:
        points, corners = (np.array(numbers).reshape(-1, 3) for numbers in (placed.points, placed.corners))
        if not 0 <= corners.min() <= corners.max() < len(points):
            raise Error(
                f"is damaged: the object {brief(placement.number)} has ids of vertices "
                f"outside 0 to {len(points) - 1}"
            )
        first = self.assembly.add_points((placement.part, placement.number), points, placement.matrix)
        self.assembly.add_triangles(corners, first, placement.matrix, model.numbers[np.array(placed.materials)])

    def name_of_root(self) -> str:
        targets = []

        def begin(tag: str, said: dict[str, str]) -> None:
            if tag == f"{_RELATIONSHIPS} Relationship" and said.get("Type") == MODEL_TYPE:
                targets.append(said["Target"])

        self.parse(RELATIONSHIPS_PART, begin)
        if not targets:
            raise Error(f"is not a 3MF file: {RELATIONSHIPS_PART} names no model")
        return _name_of_part(targets[0])

    def model(self, part: str) -> _Model:
        if part not in self.models:
            model = self.models[part] = _Model(part, self.assembly)
            self.parse(part, model.begin, model.begin_space)
            model.end()
        return self.models[part]

    def parse(
        self,
        part: str,
        begin: Callable[[str, dict[str, str]], None],
        begin_space: Optional[Callable[[Optional[str], str], None]] = None,
    ) -> None:
        """Tell a part's elements, as `NAMESPACE NAME`."""
        try:
            compression = self.archive.getinfo(part).compress_type
        except KeyError:
            raise Error(f"is not a 3MF file: its archive has no {part}") from None
        if compression not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise Error(f"is damaged: {part} is compressed by method {compression}")
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.StartElementHandler = begin
        parser.StartNamespaceDeclHandler = begin_space
        parser.StartDoctypeDeclHandler = _refuse
        try:
            with self.archive.open(part) as file:
                while piece := file.read(_PIECE):
                    self.taken += len(piece)
                    if self.taken > self.most:
                        raise Error(f"holds more than {self.most:.0f} bytes, too many for this machine")
                    parser.Parse(piece)
            parser.Parse(b"", True)
        except expat.ExpatError as error:
            raise Error(f"is damaged: {part}, {error}") from None
        except KeyError as error:
            raise Error(f"is damaged: {part}, line {parser.CurrentLineNumber}: {error} is missing") from None
        except (OverflowError, ValueError) as error:
            raise Error(f"is damaged: {part}, line {parser.CurrentLineNumber}: {error}") from None


def _refuse(*_: Any) -> None:
    raise ValueError("a document type declaration, which 3MF forbids")


def _name_of_part(path: str) -> str:
    return path.removeprefix("/")


def _matrix_of(transform: Optional[str]) -> NDArray[np.float64]:
    """To multiply columns with; the file's numbers are those of a matrix that rows are multiplied with."""
    matrix = np.eye(4)
    if transform is not None:
        numbers = np.array([float(word) for word in transform.split()])
        if numbers.shape != (12,) or not np.isfinite(numbers).all():
            raise ValueError(f"the transform {brief(transform)} is not of 12 numbers")
        matrix[:3] = numbers.reshape(4, 3).T
    return matrix
