# SPDX-License-Identifier: GPL-3.0-or-later
"""Small broken surfaces to try the commands on."""

from __future__ import annotations

import os
import shlex
from typing import Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .files import Path, is_of_others, write_surface
from .pipeline import Error
from .surfaces import as_surface

Triangles = NDArray[np.float64]
"""Their corners: an index for the triangle, the corner and the coordinate."""

COMMANDS = """\
insideout check broken.ply
insideout repair broken.ply fixed.stl
insideout mesh inverted.ply inverted.vtu
insideout mesh bracket.obj bracket.inp --edge-length 6 --quadratic-cells
insideout mesh --together tumor.ply organ.ply organs.msh --priority tumor
insideout boolean "organ - tumor" organ.ply tumor.ply rest.ply
insideout mesh outline.vtp area.vtu
insideout draw broken.ply broken.png
"""
"""What can be done with them, in their folder."""


def demo(folder: str, quiet: bool) -> None:
    """Do what `insideout demo` does. Raises `Error`."""
    written = write_demo(folder)
    if not quiet:
        print(*(f"Wrote surface    {path}" for path in written), "", "Try:", sep="\n")
        print(*([f"cd {shlex.quote(folder)}"] if folder != "." else []), COMMANDS, sep="\n", end="")


def write_demo(folder: Path) -> list[str]:
    """Write the surfaces into a folder, which is made. Returns the files. Raises `Error` for a file of another program."""
    folder = os.fspath(folder)
    made = {
        "broken.ply": _broken(),
        "inverted.ply": as_surface(_soup(np.concatenate([_box((0, 0, 0), (2, 2, 2)), _box((1, 1, 1), (3, 3, 3))[:, ::-1]])))[0],
        "organ.ply": as_surface(_soup(_ellipsoid((0, 0, 0), (30, 20, 15), 16)))[0],
        "tumor.ply": as_surface(_soup(_ellipsoid((8, 2, 1), (7, 6, 5), 10)))[0],
        "bracket.obj": _bracket(),
        "outline.vtp": _outline(),
    }
    paths = {os.path.join(folder, name): surface for name, surface in made.items()}
    for path in paths:
        if is_of_others(path):
            raise Error(f"{path} is a file of another program, which stays: choose another folder")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise Error(f"cannot make the folder {folder}: {error.strerror}") from None
    for path, surface in paths.items():
        write_surface(surface, path)
    return list(paths)


def _broken() -> vtkPolyData:
    """Two balls that overlap, each with a hole, and the cap of one faces inward."""
    first, second = _ellipsoid((0, 0, 0), (1, 1, 1), 14), _ellipsoid((0.9, 0.3, 0.2), (0.7, 0.7, 0.7), 12)
    pieces = [first[14:], second[24:-72], second[:24, ::-1]]
    return as_surface(_soup(np.concatenate(pieces)))[0]


def _bracket() -> vtkPolyData:
    """A wall with a shelf that goes into it; its back is clamped, and the shelf's top carries a load."""
    groups: dict[str, list[Triangles]] = {"clamp": [], "load": [], "body": []}
    for low, high, special in (((0, 0, 0), (6, 60, 50), {"clamp": (0, 0)}), ((4, 5, 30), (60, 55, 36), {"load": (2, 36)})):
        for facet in _box(low, high):
            (name,) = [name for name, (axis, value) in special.items() if (facet[:, axis] == value).all()] or ["body"]
            groups[name].append(facet)
    triangles = np.array([facet for facets in groups.values() for facet in facets])
    surface = as_surface(_soup(triangles))[0]
    ids, names = vtkIntArray(), vtkStringArray()
    ids.SetName("GroupIds")
    names.SetName("GroupNames")
    for number, (name, facets) in enumerate(groups.items()):
        names.InsertNextValue(name)
        for _ in facets:
            ids.InsertNextValue(number)
    surface.GetCellData().AddArray(ids)
    surface.GetFieldData().AddArray(names)
    return surface


def _outline() -> vtkPolyData:
    """A square and a circle that cross, and a small circle with a gap, which is a hole."""
    def circle(center: Sequence[float], radius: float, count: int, turn: int = 1) -> NDArray[np.float64]:
        angles = turn * 2 * np.pi * np.arange(count + 1) / 48
        return np.column_stack([center[0] + radius * np.cos(angles), center[1] + radius * np.sin(angles), np.zeros(count + 1)])

    square = np.array([(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (0, 0, 0)], float)
    curves = [square, circle((4, 3), 1.2, 48), circle((1.2, 1.5), 0.6, 45, -1)]
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for curve in curves:
        lines.InsertNextCell(len(curve))
        for place in curve:
            lines.InsertCellPoint(points.InsertNextPoint(place))
    outline = vtkPolyData()
    outline.SetPoints(points)
    outline.SetLines(lines)
    return outline


def _box(low: Sequence[float], high: Sequence[float]) -> Triangles:
    """Its twelve triangles, facing outward."""
    corners = np.array([[(low, high)[x][0], (low, high)[y][1], (low, high)[z][2]] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners[[corner for a, b, c, d in sides for corner in ((a, b, c), (a, c, d))]]


def _ellipsoid(center: Sequence[float], radii: Sequence[float], rings: int) -> Triangles:
    """Facets between circles of latitude, facing outward: those at the north pole come first."""
    polar, around = np.linspace(0, np.pi, rings + 1), 2 * np.pi * np.arange(2 * rings) / (2 * rings)
    z, r = np.cos(polar), np.sin(polar)
    r[[0, -1]] = 0
    grid = np.stack([r[:, None] * np.cos(around), r[:, None] * np.sin(around), np.broadcast_to(z[:, None], (rings + 1, 2 * rings))], axis=2)
    grid = np.array(center) + grid * np.array(radii)
    upper, lower = grid[:-1], grid[1:]
    next_upper, next_lower = np.roll(upper, -1, axis=1), np.roll(lower, -1, axis=1)
    southward = np.stack([upper, lower, next_lower], axis=2)
    northward = np.stack([upper, next_lower, next_upper], axis=2)[1:]
    return np.concatenate([southward.reshape(-1, 3, 3)[: 2 * rings], np.concatenate([southward[1:-1], northward[:-1]], axis=1).reshape(-1, 3, 3), northward[-1]])


def _soup(triangles: Triangles) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Points and triangles: equal corners are one point."""
    points, ids = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    return points, ids.reshape(-1, 3)

