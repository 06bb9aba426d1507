# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear finite elements on tetrahedra: numpy and scipy, no more."""

from __future__ import annotations

import numpy as np
from scipy import sparse

FLAT = 1e-9  # of the cube of its longest edge: a cell whose volume is less is left out, it is flat up to rounding


def stiffness(points: np.ndarray, cells: np.ndarray) -> tuple[sparse.csr_matrix, np.ndarray]:
    """The integrals of grad i . grad j, and of i, of the hat functions of the points."""
    corners = points[cells]
    edges = corners[:, 1:] - corners[:, :1]
    volumes = np.linalg.det(edges) / 6
    sound = volumes > FLAT * np.abs(edges).max(axis=(1, 2)) ** 3
    cells, edges, volumes = cells[sound], edges[sound], volumes[sound]
    gradients = np.empty((len(cells), 4, 3))
    gradients[:, 1:] = np.linalg.inv(edges).transpose(0, 2, 1)
    gradients[:, 0] = -gradients[:, 1:].sum(axis=1)
    local = volumes[:, None, None] * gradients @ gradients.transpose(0, 2, 1)
    rows, columns = np.repeat(cells, 4, axis=1).ravel(), np.tile(cells, 4).ravel()
    matrix = sparse.csr_matrix((local.ravel(), (rows, columns)), shape=(len(points), len(points)))
    return matrix, np.bincount(cells.ravel(), np.repeat(volumes / 4, 4), len(points))


def monotone(matrix: sparse.csr_matrix) -> sparse.csr_matrix:
    """The same with no positive entry beside the diagonal, and rows that add up to 0: what solves it has no extremum inside.

    Obtuse angles give positive ones; they become small negative ones, so that all points stay connected.
    """
    pairs = sparse.triu(matrix, 1).tocoo()
    weights = np.maximum(-pairs.data, 1e-4 * np.abs(pairs.data).mean())
    half = sparse.csr_matrix((-weights, (pairs.row, pairs.col)), shape=matrix.shape)
    off = half + half.T
    return (off - sparse.diags(np.asarray(off.sum(axis=1)).ravel())).tocsr()


def same_places(points: np.ndarray, others: np.ndarray) -> np.ndarray:
    """For each of the others which of the points has its coordinates, bit by bit; -1 for none."""
    number = {place.tobytes(): k for k, place in enumerate(points + 0.0)}  # -0 is 0
    return np.array([number.get(place.tobytes(), -1) for place in others + 0.0])
