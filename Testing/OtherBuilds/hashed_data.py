# SPDX-License-Identifier: GPL-3.0-or-later
"""Data as lines of text: a name and its values, or their hash, for each array."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator

from vtkmodules.util.numpy_support import vtk_to_numpy

LEFT_OUT = re.compile(r"(Before)?(Seconds\w+|PeakMemory)$")
"""Statistics that differ from run to run."""


def lines_of(data) -> Iterator[tuple[str, str]]:
    """Name and text of each array of a data set."""
    if isinstance(data, bytes):
        yield "file", f"{len(data)} bytes, {hash_of(data)}"
        return
    if data.IsA("vtkImageStencilData"):
        x0, x1, y0, y1, z0, z1 = data.GetExtent()
        inside = [data.IsInside(x, y, z) for z in range(z0, z1 + 1) for y in range(y0, y1 + 1) for x in range(x0, x1 + 1)]
        yield "stencil", f"{data.GetExtent()} {hash_of(bytes(inside))}"
        return
    yield "type", f"{data.GetClassName()} of {data.GetNumberOfPoints()} points, {data.GetNumberOfCells()} cells"
    if data.IsA("vtkImageData"):
        yield "image", f"{data.GetExtent()} {data.GetOrigin()} {data.GetSpacing()}"
    elif data.GetPoints():
        yield "points", text_of(data.GetPoints().GetData())
    if data.IsA("vtkUnstructuredGrid") and data.GetNumberOfCells():
        yield "cell types", text_of(data.GetCellTypesArray())
    for name in ("Cells", "Verts", "Lines", "Polys", "Strips"):
        cells = getattr(data, "Get" + name)() if hasattr(data, "Get" + name) else None
        if cells and cells.GetNumberOfCells():
            yield name, f"{text_of(cells.GetOffsetsArray())}, {text_of(cells.GetConnectivityArray())}"
    for kind in ("point", "cell", "field"):
        yield from lines_of_arrays(kind, getattr(data, f"Get{kind.title()}Data")())


def lines_of_arrays(kind: str, attributes) -> Iterator[tuple[str, str]]:
    arrays = [attributes.GetAbstractArray(k) for k in range(attributes.GetNumberOfArrays())]
    kept = [(array.GetName() or "", array) for array in arrays]
    yield kind + " arrays", f"{len(kept)} in the order {hash_of(' '.join(name for name, _ in kept).encode())}"
    for name, array in kept:
        if name == "Statistics":
            names = attributes.GetAbstractArray("StatisticsNames")
            named = [(names.GetValue(k), array.GetValue(k)) for k in range(names.GetNumberOfValues())]
            yield from ((f"{kind}:{one}", repr(value)) for one, value in named if not LEFT_OUT.match(one))
        else:
            yield f"{kind}:{name}", text_of(array)
    if kind != "field":
        active = ((attributes.GetAttributeTypeAsString(k), attributes.GetAbstractAttribute(k)) for k in range(attributes.NUM_ATTRIBUTES))
        yield kind + " attributes", ", ".join(f"{use}={array.GetName()}" for use, array in active if array) or "none"


def text_of(array) -> str:
    """Type, shape and names of components, and all values where these are few, or their hash."""
    tuples, components = array.GetNumberOfTuples(), array.GetNumberOfComponents()
    names = [f" {array.GetComponentName(k) or ''}" for k in range(components)] if array.HasAComponentName() else []
    if array.IsA("vtkStringArray"):
        values = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
        content = repr(values).encode()
    else:
        values = vtk_to_numpy(array).ravel()
        content, values = values.tobytes(), values.tolist()
    few = len(values) <= 4
    return f"{array.GetDataTypeAsString()} {tuples}x{components}{','.join(names)} {values if few else hash_of(content)}"


def hash_of(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]
