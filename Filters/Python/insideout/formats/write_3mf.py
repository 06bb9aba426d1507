# SPDX-License-Identifier: GPL-3.0-or-later
"""Write 3MF, with all digits of coordinates, which are millimeters there.

Printers take each object for itself, and it has to be closed. So groups become objects where they share no points,
as bodies that are apart; else all is one object, whose triangles have the groups for materials.
"""

from __future__ import annotations

import io
import re
import zipfile
from typing import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..measures import is_closed, joined_where_equal
from .groups import Groups
from .read_3mf import CORE, MODEL_TYPE, RELATIONSHIPS_PART

_DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>\n'

_TYPES = (
    f"{_DECLARATION}<!-- Written by InsideOut -->\n"
    '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
    '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    '<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>\n'
)
"""Stands first, and is not compressed: the comment is the mark that files are told by."""

_RELATIONSHIPS = (
    f'{_DECLARATION}<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
    f'<Relationship Id="model" Target="/3D/3dmodel.model" Type="{MODEL_TYPE}"/></Relationships>\n'
)

_BASES = 1  # the id of all base materials, before those of objects
_COLOR = "#C0C0C0"

_MOST_IN_SHORT = 10_000_000  # triangles, of some 100 bytes each: more than 2 GiB need longer fields in the archive

_NO_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def write_3mf(surface: vtkPolyData) -> tuple[bytes, list[str]]:
    """The content of a file, and warnings of data that it cannot hold. Raises `Error` without its name."""
    groups = Groups(surface, "3MF")
    a, b, c = groups.triangles.T
    whole = (a != b) & (b != c) & (c != a)
    groups.triangles, groups.group_of = groups.triangles[whole], groups.group_of[whole]
    left_out = int(np.count_nonzero(~whole))
    warnings = [f"{left_out} triangles with a corner twice are left out, which 3MF does not hold"] if left_out else []
    file = io.BytesIO()
    # The fastest compression: the default takes twice as long to write a million triangles, for few bytes.
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        archive.writestr(zipfile.ZipInfo("[Content_Types].xml"), _TYPES)
        archive.writestr(zipfile.ZipInfo(RELATIONSHIPS_PART), _RELATIONSHIPS)
        with archive.open("3D/3dmodel.model", "w", force_zip64=len(groups.triangles) > _MOST_IN_SHORT) as stream:
            for text in _model(groups):
                stream.write(text.encode())
    return file.getvalue(), [*groups.warnings, *warnings]


def _model(groups: Groups) -> Iterator[str]:
    yield f'{_DECLARATION}<model unit="millimeter" xml:lang="en-US" xmlns="{CORE}">\n'
    yield '<metadata name="Application">InsideOut</metadata>\n<resources>\n'
    numbers: list[int] = []
    if _are_apart(groups):
        for name, triangles in zip(groups.names, groups.triangles_of_groups()):
            if len(triangles):
                numbers.append(_BASES + 1 + len(numbers))
                yield from _object(numbers[-1], name, groups.points, triangles)
    else:
        bases = (f'<base name={_quoted(name)} displaycolor="{_COLOR}"/>' for name in groups.names)
        yield f'<basematerials id="{_BASES}">{"".join(bases)}</basematerials>\n'
        numbers = [_BASES + 1]
        yield from _object(numbers[0], "surface", groups.points, groups.triangles, groups.group_of)
    items = "".join(f'<item objectid="{number}"/>' for number in numbers)
    yield f"</resources>\n<build>{items}</build>\n</model>\n"


def _are_apart(groups: Groups) -> bool:
    """Whether no two groups have a point in one place."""
    if len(groups.names) < 2:
        return True
    joined = joined_where_equal(groups.points, groups.triangles)
    pairs = joined * len(groups.names) + groups.group_of[:, np.newaxis]
    return len(np.unique(pairs)) == len(np.unique(joined))


def _object(
    number: int, name: str, points: NDArray[np.float64], triangles: NDArray[np.int64], materials: Sequence[int] = ()
) -> Iterator[str]:
    used, ids = np.unique(triangles, return_inverse=True)
    kind = "model" if is_closed(triangles) else "surface"
    property_ = f' pid="{_BASES}" pindex="0"' if len(materials) else ""
    yield f'<object id="{number}" type="{kind}" name={_quoted(name)}{property_}><mesh><vertices>\n'
    yield from _lines('<vertex x="%r" y="%r" z="%r"/>\n', points[used])
    yield "</vertices><triangles>\n"
    corners = ids.reshape(-1, 3)
    if len(materials):
        yield from _lines(
            f'<triangle v1="%r" v2="%r" v3="%r" pid="{_BASES}" p1="%r"/>\n', np.column_stack([corners, materials])
        )
    else:
        yield from _lines('<triangle v1="%r" v2="%r" v3="%r"/>\n', corners)
    yield "</triangles></mesh></object>\n"


def _lines(form: str, rows: NDArray) -> Iterator[str]:
    for begin in range(0, len(rows), 10000):
        yield "".join([form % tuple(row) for row in rows[begin : begin + 10000].tolist()])


def _quoted(name: str) -> str:
    from xml.sax.saxutils import quoteattr  # it imports urllib, a fifteenth of the time in which the package starts

    return quoteattr(_NO_XML.sub("?", name))
