# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures and connectivity of triangles and tetrahedra, from arrays."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
Ids = NDArray[np.int64]

FACES = ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))
"""edges of a tetrahedron, in VTK's order"""


def enclosed_volume(points: Points, triangles: Ids) -> float:
    """The signed volume that triangles enclose. It does not depend on the origin if they are closed."""
    if len(triangles) == 0:
        return 0.0
    a, b, c = (points[corner] for corner in triangles.T)
    middle = points[triangles[0, 0]]
    return float(np.einsum("ij,ij->", a - middle, np.cross(b - middle, c - middle)) / 6)


def volume_of_cells(points: Points, cells: Ids) -> float:
    a, b, c, d = (points[corner] for corner in cells[:, :4].T)
    return float(np.einsum("ij,ij->", d - a, np.cross(b - a, c - a)) / 6)


def area(points: Points, triangles: Ids) -> float:
    a, b, c = (points[corner] for corner in triangles.T)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def joined_where_equal(points: Points, cells: Ids) -> Ids:
    """The cells, with one id for all coincident points."""
    first = np.unique(points + 0.0, axis=0, return_inverse=True)[1].ravel()  # -0 is 0
    joined: Ids = first[cells]
    return joined


def is_closed(triangles: Ids) -> bool:
    """Whether there are edges, and each has as many triangles in one direction as in the other."""
    balance, _ = triangles_at_edges(triangles)
    return len(balance) > 0 and not balance.any()


def triangles_at_edges(triangles: Ids) -> tuple[Ids, Ids]:
    """By how many more triangles each edge starts at its lower point than at its higher one, and how many have it; without
    edges of one point."""
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    differ = start != end
    start, end = start[differ].astype(np.uint64), end[differ].astype(np.uint64)
    count = np.uint64(triangles.max(initial=0) + 1)
    keys = (np.minimum(start, end) * count + np.maximum(start, end)) * np.uint64(2) + (start < end)
    keys.sort()  # faster than sorting rows, or their order
    first = np.flatnonzero(np.diff(keys >> np.uint64(1), prepend=~np.uint64(0)))
    there = np.diff(first, append=len(keys))
    forward = np.add.reduceat((keys & np.uint64(1)).astype(np.int64), first) if len(first) else there
    return 2 * forward - there, there


def labels_of_parts(cells: Ids) -> Ids:
    """The number of each cell's part, connected through sides. Parts are numbered by their first cells."""
    corners = cells.shape[1]
    sides = np.array([[k for k in range(corners) if k != left_out] for left_out in range(corners)])
    rows = np.sort(cells[:, sides].reshape(-1, corners - 1), axis=1)
    _, side = np.unique(rows, axis=0, return_inverse=True)
    order = np.argsort(side.ravel(), kind="stable")
    alike = np.flatnonzero(np.diff(side.ravel()[order]) == 0)
    labels = _joined(len(cells), order[alike] // corners, order[alike + 1] // corners)
    return np.unique(labels, return_inverse=True)[1].ravel()


def _joined(count: int, one: Ids, other: Ids) -> Ids:
    """For each number below `count` the smallest number connected with it through pairs."""
    labels = np.arange(count)
    while True:
        least = np.minimum(labels[one], labels[other])
        if (least == labels[one]).all() and (least == labels[other]).all():
            return labels
        for side in (labels[one], labels[other]):
            np.minimum.at(labels, side, least)
        while (labels[labels] != labels).any():
            labels = labels[labels]


def faces_of_one_cell(cells: Ids) -> Ids:
    """The faces of exactly one tetrahedron, turned outward."""
    faces = cells[:, np.array(FACES)].reshape(-1, 3)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    outer: Ids = faces[np.sort(first[count == 1])]
    return outer
