# SPDX-License-Identifier: GPL-3.0-or-later
"""XDMF files as text, as FEniCS reads them: cells, and beside them the boundary, each with its tags as the first array."""

from __future__ import annotations

import os
import re
from typing import Mapping, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .data import Tetrahedra, Triangles, TriangleSurface, as_type
from .exporting import nodes_of_boundary, scalars_and_vectors
from .pipeline import Error, strings_of, write_bytes

XDMF = ".xdmf"

_TOPOLOGIES = {"tetra": "Tetrahedron", "tetra10": "Tetrahedron_10", "triangle": "Triangle", "triangle6": "Triangle_6"}
"""XDMF's names of meshio's cell types."""


def boundary_beside(path: str) -> str:
    """The file of the boundary that belongs to a file of cells."""
    return f"{os.path.splitext(path)[0]}_boundary{XDMF}"


def write_xdmf(grid: Union[Tetrahedra, Triangles], path: str, boundary: Optional[vtkPolyData] = None) -> None:
    """Write cells, and next to them a file with the boundary of tetrahedra, by the same points."""
    try:
        _write(path, grid.points, grid.kind(), grid.cells, grid.cell_arrays, "RegionId", grid.point_arrays)
        if boundary is None or not isinstance(grid, Tetrahedra):
            return
        triangles = as_type(TriangleSurface, boundary)
        names = strings_of(boundary.GetFieldData().GetAbstractArray("BoundaryTagNames"))
        nodes = nodes_of_boundary(grid, triangles)
        kind = "triangle" if nodes.shape[1] == 3 else "triangle6"
        _write(boundary_beside(path), grid.points, kind, nodes, triangles.cell_arrays, "BoundaryTag", {}, names)
    except MemoryError:
        raise Error(f"{path}: not enough memory to write it") from None


def _write(
    path: str,
    points: NDArray[np.float64],
    kind: str,
    nodes: NDArray[np.int64],
    cell_arrays: Mapping[str, NDArray],
    first: str,
    point_arrays: Mapping[str, NDArray],
    names: Optional[list[str]] = None,
) -> None:
    """One grid. `first` is the cell array to write first: FEniCS takes the first for tags."""
    cells = scalars_and_vectors(cell_arrays)
    ordered = {name: cells[name] for name in sorted(cells, key=lambda name: name != first)}
    arrays = [("Cell", name, values) for name, values in ordered.items()]
    arrays += [("Node", name, values) for name, values in scalars_and_vectors(point_arrays).items()]
    mapped = "".join(f'<map key={_quoted(name)} dim="2">{tag}</map>' for tag, name in enumerate(names or []))
    information = f'<Information Name="Information" Value="1"><![CDATA[<main>{mapped}</main>]]></Information>'  # meshio's name
    shape = f'NumberOfElements="{len(nodes)}" NodesPerElement="{nodes.shape[1]}"'
    lines = [
        '<Xdmf Version="3.0"><!-- Written by InsideOut --><Domain><Grid Name="Grid">',
        *([information] if mapped else []),
        f'<Geometry GeometryType="XYZ">{_item(points)}</Geometry>',
        f'<Topology TopologyType="{_TOPOLOGIES[kind]}" {shape}>{_item(nodes)}</Topology>',
        *(_attribute(*array) for array in arrays),
        "</Grid></Domain></Xdmf>",
    ]
    write_bytes("\n".join([*lines, ""]).encode(), path)


def _attribute(center: str, name: str, values: NDArray) -> str:
    kind = "Scalar" if values.ndim == 1 else "Vector"
    return f'<Attribute Name={_quoted(name)} AttributeType="{kind}" Center="{center}">{_item(values)}</Attribute>'


def _item(values: NDArray) -> str:
    """Numbers with all digits."""
    kind = {"f": "Float", "i": "Int", "u": "UInt"}[values.dtype.kind]
    wide = values.astype(float if kind == "Float" else values.dtype)
    precision = 8 if kind == "Float" else values.dtype.itemsize
    rows = wide.reshape(len(wide), -1).tolist()
    text = "\n".join(" ".join(map(repr, row)) for row in rows)
    shape = " ".join(map(str, values.shape))
    return f'<DataItem DataType="{kind}" Dimensions="{shape}" Format="XML" Precision="{precision}">\n{text}\n</DataItem>'


def _quoted(name: str) -> str:
    """A name as an attribute; characters that XML cannot have become spaces. > is escaped, so that nothing ends a CDATA
    section."""
    from xml.sax.saxutils import quoteattr  # it imports urllib, a fifteenth of the time in which the package starts

    return quoteattr(re.sub("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", " ", name))
