# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes, cylinders and struts as surfaces in named groups, and an .obj file of them: what the examples here are built of.

A part is a group's name, its points and its polygons, counterclockwise seen from outside. Parts may overlap and lack
polygons: nothing here cuts or joins them.
"""

from __future__ import annotations

from pathlib import Path
from typing import Iterable, NamedTuple

import numpy as np

SIDES = ("x_low", "x_high", "y_low", "y_high", "z_low", "z_high")


class Part(NamedTuple):
    group: str
    points: np.ndarray
    polygons: list[list[int]]


def box(low, high, edge: float, groups: dict[str, str] | None = None, left_out: Iterable[str] = ()) -> list[Part]:
    """A box in squares of about this edge, of group body; sides may have groups of their own, or be left out."""
    axes = [np.linspace(a, b, max(1, round((b - a) / edge)) + 1) for a, b in zip(low, high)]
    parts = []
    for k, side in enumerate(SIDES):
        if side in left_out:
            continue
        axis, is_high = k // 2, k % 2
        u, v = ((axis + 1) % 3, (axis + 2) % 3) if is_high else ((axis + 2) % 3, (axis + 1) % 3)
        points = np.empty((len(axes[u]), len(axes[v]), 3))
        points[..., axis] = axes[axis][-1 if is_high else 0]
        points[..., u], points[..., v] = np.meshgrid(axes[u], axes[v], indexing="ij")
        parts.append(Part((groups or {}).get(side, "body"), points.reshape(-1, 3), _squares(len(axes[u]), len(axes[v]))))
    return parts


def _squares(rows: int, columns: int) -> list[list[int]]:
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    return np.stack([corner, corner + columns, corner + columns + 1, corner + 1], axis=1).tolist()


def cylinder(start, end, radius: float, edge: float, caps: tuple[str | None, str | None] = ("body", "body")) -> list[Part]:
    """A cylinder between two points, of group body; its caps have groups of their own, or are left out (None)."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    around = max(12, round(2 * np.pi * radius / edge))
    along = max(1, round(np.linalg.norm(end - start) / edge)) + 1
    angles = 2 * np.pi * np.arange(around) / around
    u, v, _ = _frame(end - start)
    ring = radius * (np.cos(angles)[:, None] * u + np.sin(angles)[:, None] * v)
    rings = [start + (end - start) * t + ring for t in np.linspace(0, 1, along)]
    k = np.arange(around)
    wall = [np.stack([k, (k + 1) % around, (k + 1) % around + around, k + around], axis=1) + r * around for r in range(along - 1)]
    parts = [Part("body", np.concatenate(rings), np.concatenate(wall).tolist())]
    for group, middle, points, turn in ((caps[0], start, rings[0], -1), (caps[1], end, rings[-1], 1)):
        if group is not None:
            fan = np.stack([k, (k + 1) % around, np.full(around, around)], axis=1)[:, ::turn]
            parts.append(Part(group, np.vstack([points, middle]), fan.tolist()))
    return parts


def strut(start, end, thickness: float, width: float, edge: float, left_out: Iterable[str] = ()) -> list[Part]:
    """A box between two points; its z is along these, and the ends are its sides z_low and z_high."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    length = float(np.linalg.norm(end - start))
    upright = box((-thickness / 2, -width / 2, 0), (thickness / 2, width / 2, length), edge, left_out=left_out)
    return [Part(part.group, start + part.points @ np.stack(_frame(end - start)), part.polygons) for part in upright]


def _frame(direction) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Two directions across this one, the second as level as can be, and this one; a right-handed frame."""
    along = direction / np.linalg.norm(direction)
    level = np.cross((0, 0, 1) if abs(along[2]) < 0.9 else (1, 0, 0), along)
    level /= np.linalg.norm(level)
    return np.cross(level, along), level, along


def without(part: Part, *numbers: int) -> Part:
    """The part with some of its polygons left out: a hole."""
    return part._replace(polygons=[polygon for k, polygon in enumerate(part.polygons) if k not in numbers])


def write_obj(parts: list[Part], path: Path) -> None:
    """With six decimals, as most programs write it. Each group is what the mesh's boundary has as a tag."""
    first = 1
    with path.open("w") as file:
        for part in parts:
            file.write(f"g {part.group}\n")
            file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in part.points.tolist())
            file.writelines("f " + " ".join(str(first + corner) for corner in polygon) + "\n" for polygon in part.polygons)
            first += len(part.points)
