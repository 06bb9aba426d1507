# SPDX-License-Identifier: GPL-3.0-or-later
"""Small broken surfaces for trying the commands, computed without random numbers: the same at each call."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from .serializing import vtk_array
from .surfaces import make_surface

DECIMALS = 6
"""decimals of coordinates: the last digits of sine and cosine differ between processors"""


@dataclass(frozen=True)
class Mesh:
    """Points, and triangles that run counterclockwise seen from outside."""

    points: NDArray[np.float64]
    triangles: NDArray[np.int64]

    def without(self, chosen: Callable[[NDArray[np.float64]], NDArray[np.bool_]]) -> Mesh:
        """The same surface without the triangles whose centers are selected."""
        centers = self.points[self.triangles].mean(axis=1)
        return Mesh(self.points, self.triangles[~chosen(centers)])

    def inside_out(self) -> Mesh:
        return Mesh(self.points, self.triangles[:, ::-1])

    def surface(self) -> vtkPolyData:
        """The surface with coordinates rounded to the decimals on which all processors agree."""
        used, triangles = np.unique(self.triangles, return_inverse=True)
        return make_surface(np.round(self.points[used], DECIMALS) + 0.0, triangles.reshape(-1, 3))


def joined(meshes: Iterable[Mesh]) -> Mesh:
    """Several surfaces as one: nothing is cut where they overlap."""
    points, triangles, count = [], [], 0
    for mesh in meshes:
        points.append(mesh.points)
        triangles.append(mesh.triangles + count)
        count += len(mesh.points)
    return Mesh(np.concatenate(points), np.concatenate(triangles))


def ball(center: Sequence[float], radii: Sequence[float], around: int, rings: int, bumps: float = 0, turn: float = 0) -> Mesh:
    """An ellipsoid with poles on its z axis, with bumps of this height relative to its radii, rotated by an angle."""
    k = np.arange(around)
    azimuth, polar = 2 * np.pi * k / around + turn, np.pi * np.arange(1, rings) / rings
    u, v = np.meshgrid(azimuth, polar)
    unit = np.stack([np.sin(v) * np.cos(u), np.sin(v) * np.sin(u), np.cos(v)], axis=2).reshape(-1, 3)
    height = 1 + bumps * np.sin(3 * u) * np.sin(v) ** 2 * np.cos(2 * v)
    points = np.vstack([height.reshape(-1, 1) * unit, [(0, 0, 1), (0, 0, -1)]]) * radii + center
    top, bottom = len(points) - 2, len(points) - 1
    upper = np.concatenate([ring * around + k for ring in range(rings - 2)])
    upper_next = np.concatenate([ring * around + (k + 1) % around for ring in range(rings - 2)])
    last = (rings - 2) * around
    fans = [
        np.stack([np.full(around, top), k, (k + 1) % around], axis=1),
        np.stack([last + (k + 1) % around, last + k, np.full(around, bottom)], axis=1),
    ]
    bands = [
        np.stack([upper, upper + around, upper_next + around], axis=1),
        np.stack([upper, upper_next + around, upper_next], axis=1),
    ]
    return Mesh(points, np.concatenate([*fans, *bands]))


def rod(start: Sequence[float], end: Sequence[float], radius: float, around: int) -> Mesh:
    """A cylinder from one point to another, open at its start."""
    first, last = np.asarray(start, float), np.asarray(end, float)
    axis = (last - first) / np.linalg.norm(last - first)
    across = np.cross(axis, (0.0, 0.0, 1.0))
    across /= np.linalg.norm(across)
    angles = 2 * np.pi * np.arange(around)[:, None] / around
    ring = radius * (np.cos(angles) * across + np.sin(angles) * np.cross(axis, across))
    k = np.arange(around)
    following = (k + 1) % around
    triangles = [
        np.stack([k, following, following + around], axis=1),
        np.stack([k, following + around, k + around], axis=1),
        np.stack([k + around, following + around, np.full(around, 2 * around)], axis=1),
    ]
    return Mesh(np.vstack([first + ring, last + ring, last]), np.concatenate(triangles))


BOX_SIDES = {
    "x_low": (0, 4, 7, 3),
    "x_high": (1, 2, 6, 5),
    "y_low": (0, 1, 5, 4),
    "y_high": (3, 7, 6, 2),
    "z_low": (0, 3, 2, 1),
    "z_high": (4, 5, 6, 7),
}
"""Corners of the sides; 0 to 3 run around the bottom, 4 to 7 above them."""


def box_corners(low: Sequence[float], high: Sequence[float]) -> NDArray[np.float64]:
    outline = ((0, 0), (1, 0), (1, 1), (0, 1))
    return np.array([[(low, high)[a][0], (low, high)[b][1], (low, high)[c][2]] for c in (0, 1) for a, b in outline], float)


def figure() -> vtkPolyData:
    """A body, a head, arms and a nose that overlap. The arms are open within the body; body and head have holes. Each
    part is rotated a little, so that hardly any points nearly coincide.
    """
    body = ball((0, 0, 0), (1, 0.8, 1), 28, 18, turn=0.05).without(lambda at: np.linalg.norm(at - (0.5, -0.6, -0.35), axis=1) < 0.3)
    head = ball((0, 0, 1.4), (0.6, 0.6, 0.6), 24, 14, turn=0.11).without(lambda at: (at[:, 2] > 1.75) & (at[:, 1] < 0))
    arms = [rod((side * 0.6, 0, 0.3), (side * 1.7, -0.3, 0.9), 0.16, 12) for side in (-1, 1)]
    nose = ball((0.01, -0.6, 1.38), (0.12, 0.3, 0.12), 12, 8, turn=0.2)
    eye, twice = (ball((side * 0.3, -0.47, 1.57), (0.08, 0.08, 0.08), 8, 6, turn=0.3) for side in (-1, 1))
    return joined([body, head, *arms, nose, eye, twice, twice]).surface()


def inverted() -> vtkPolyData:
    """Two separate balls, one of them inverted."""
    return joined([ball((0, 0, 0), (1, 1, 1), 20, 12), ball((2.5, 0, 0), (0.8, 0.8, 0.8), 20, 12).inside_out()]).surface()


def organ() -> vtkPolyData:
    """An organ in centimeters, with a hole where the vessels enter."""
    return ball((0, 0, 0), (10, 7, 6), 36, 20, bumps=0.12).without(lambda at: (at[:, 2] < -5.0) & (abs(at[:, 0]) < 2.5)).surface()


def tumor() -> vtkPolyData:
    return ball((4, 1, 0.5), (2, 2, 2), 20, 12, bumps=0.1).surface()


def scan() -> vtkPolyData:
    """A lump as scanned from above: without a bottom, and with a hole."""
    lump = ball((0, 0, 0), (1, 0.9, 1.2), 40, 24, bumps=0.15)
    return lump.without(lambda at: (at[:, 2] < -0.6) | (np.linalg.norm(at - (0.75, -0.45, 0.4), axis=1) < 0.25)).surface()


def bracket() -> vtkPolyData:
    """A bracket in millimeters: a wall, a shelf and a rib that overlap and are not joined, with the groups body, clamp
    and load. The shelf is open within the wall.
    """
    wall, shelf = box_corners((0, -20, 0), (8, 20, 60)), box_corners((4, -18, 44), (70, 18, 52))
    rib = np.array([(4, y, z) for y in (-3, 3) for z in (8, 48)] + [(56, y, 48) for y in (-3, 3)], float)
    across = np.array([(40, -18, 52), (40, 18, 52)], float)  # position on the shelf from which on it is loaded
    quads = [*BOX_SIDES.values(), (9, 10, 14, 13), (8, 11, 10, 9), (12, 22, 23, 15), (22, 13, 14, 23)]
    quads += [(16, 17, 19, 18), (16, 18, 21, 20), (17, 20, 21, 19)]
    groups = ["clamp", *["body"] * 8, "load", *["body"] * 7]
    sides, ends = [(8, 9, 13, 22, 12), (11, 15, 23, 14, 10)], [(16, 20, 17), (18, 19, 21)]  # of the shelf and of the rib
    points = np.vstack([wall, shelf, rib, across])
    return with_groups(make_surface(points, np.array(quads), np.array(sides), np.array(ends)), groups)


def with_groups(surface: vtkPolyData, groups: Sequence[str]) -> vtkPolyData:
    names = sorted(set(groups))
    ids = vtk_array(np.array([names.index(group) for group in groups], np.int32))
    ids.SetName("GroupIds")
    surface.GetCellData().AddArray(ids)
    called = vtkStringArray()
    called.SetName("GroupNames")
    for name in names:
        called.InsertNextValue(name)
    surface.GetFieldData().AddArray(called)
    return surface


def grid_around(surface: vtkPolyData, points: int) -> vtkImageData:
    """An image around a surface, with this number of points along its longest side."""
    low, high = np.array(surface.GetBounds()).reshape(3, 2).T
    spacing = 1.1 * (high - low).max() / (points - 1)
    size = np.ceil(1.1 * (high - low) / spacing).astype(int) + 1
    image = vtkImageData()
    image.SetDimensions(*size.tolist())
    image.SetSpacing(spacing, spacing, spacing)
    image.SetOrigin(*((low + high) / 2 - spacing * (size - 1) / 2).tolist())
    return image


PLACES = """\
x,y,z,where
0,0,0,in the body
0,0,1.4,in the head
0,0,0.9,where both overlap
1.2,0,1.2,beside the head
"""

OUTLINE = """\
x,y,path
0,0,a
4,0,a
4,3,a
0,3,a
0,0.2,a
1,1,b
6,1,b
6,2,b
1,2,b
1,1,b
"""
"""A rectangle with a gap in a corner, and one that crosses it."""

STEEL = """\
** The bracket under a load, for CalculiX: millimeters, newtons, megapascals. Run: ccx steel
*INCLUDE, INPUT=bracket.inp
*MATERIAL, NAME=steel
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=Eall, MATERIAL=steel
*BOUNDARY
clamp, 1, 3
*STEP
*STATIC
*DSLOAD
load, P, 0.5
*NODE PRINT, NSET=clamp, TOTALS=ONLY
RF
*NODE FILE
U
*EL FILE
S
*END STEP
"""
