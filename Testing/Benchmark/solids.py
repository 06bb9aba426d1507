# SPDX-License-Identifier: GPL-3.0-or-later
"""What measure-quality.py knows of tetrahedra: their volume, and the boundary of those inside, its shells and cavities."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])  # face k is opposite corner k, and faces outward
UNBOUNDED = -1


@dataclass
class Boundary:
    """The faces between inside and outside, by their own points."""

    points: np.ndarray
    triangles: np.ndarray
    """Counterclockwise seen from outside."""
    regions: np.ndarray
    """For each triangle which part of the solid it bounds."""
    beyond: np.ndarray
    """For each triangle which cavity it bounds, or UNBOUNDED."""
    cavities: np.ndarray
    """A point strictly inside each cavity."""

    def shells(self) -> list[tuple[int, int, np.ndarray]]:
        """Triangles by the part of the solid and the cavity that they bound."""
        pairs, which = np.unique(np.stack([self.regions, self.beyond]), axis=1, return_inverse=True)
        return [(int(pair[0]), int(pair[1]), np.flatnonzero(which.ravel() == k)) for k, pair in enumerate(pairs.T)]


def read_grid(path: str) -> vtkUnstructuredGrid:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points_and_cells(grid: vtkUnstructuredGrid) -> tuple[np.ndarray, np.ndarray]:
    """The points and the linear cells of a grid of tetrahedra, of first or second order."""
    size = grid.GetCells().GetMaxCellSize()
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, size)[:, :4]
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(float), cells


def boundary_of(points: np.ndarray, cells: np.ndarray, inside: np.ndarray) -> Boundary:
    """The boundary of the inside cells, given all cells of a conforming mesh of the convex hull."""
    faces = cells[:, FACES].reshape(-1, 3)
    owners = np.repeat(np.arange(len(cells)), 4)
    ordered = np.sort(faces, axis=1)
    order = np.lexsort(ordered.T)
    same = (ordered[order[1:]] == ordered[order[:-1]]).all(axis=1)
    first, second = order[:-1][same], order[1:][same]
    alone = np.setdiff1d(order, np.concatenate([first, second]))  # on the hull

    alike = inside[owners[first]] == inside[owners[second]]
    parts = _parts(len(cells), owners[first[alike]], owners[second[alike]])
    reached = np.zeros(len(cells), bool)
    reached[parts[owners[alone[~inside[owners[alone]]]]]] = True
    parts[~inside & reached[parts]] = UNBOUNDED

    one, other = first[~alike], second[~alike]
    turned = ~inside[owners[one]]
    one[turned], other[turned] = other[turned].copy(), one[turned].copy()
    hull = alone[inside[owners[alone]]]
    chosen = np.concatenate([one, hull])
    beyond = np.concatenate([parts[owners[other]], np.full(len(hull), UNBOUNDED)])

    used, triangles = np.unique(faces[chosen], return_inverse=True)
    numbers = np.unique(beyond[beyond != UNBOUNDED])
    cavities = [_middle_of_largest(points, cells[~inside & (parts == number)]) for number in numbers]
    regions = parts[owners[chosen]]
    return Boundary(points[used], triangles.reshape(-1, 3), regions, beyond, np.array(cavities).reshape(-1, 3))


def _parts(size: int, ones: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Per item the lowest one that it is connected with."""
    parts = np.arange(size)
    while True:
        lowest = np.minimum(parts[ones], parts[others])
        if (parts[ones] == parts[others]).all():
            return parts
        np.minimum.at(parts, parts[ones], lowest)
        np.minimum.at(parts, parts[others], lowest)
        while (parts[parts] != parts).any():
            parts = parts[parts]


def _middle_of_largest(points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    corners = points[cells]
    edges = corners[:, 1:] - corners[:, :1]
    return corners[np.argmax(np.abs(np.linalg.det(edges)))].mean(axis=0)


def volume_of(points: np.ndarray, cells: np.ndarray) -> float:
    corners = points[cells]
    return float(np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6)
