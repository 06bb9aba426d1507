# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that the tests use, and the laws that solids obey, each checked without InsideOut's own code."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPolyData, vtkUnstructuredGrid

BOX_FACETS = (
    *((0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7)),
    *((0, 1, 5), (0, 5, 4), (2, 3, 7), (2, 7, 6)),
    *((1, 2, 6), (1, 6, 5), (3, 0, 4), (3, 4, 7)),
)
"""Outward; 0 to 3 run around the bottom, 4 to 7 above them."""


def polydata(points, polygons) -> vtkPolyData:
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    for point in points:
        coordinates.InsertNextPoint(point)
    cells = vtkCellArray()
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    surface = vtkPolyData()
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    return surface


def box(low=(0, 0, 0), size=1, facets=BOX_FACETS) -> vtkPolyData:
    return polydata(box_points(low, size), facets)


def box_points(low=(0, 0, 0), size=1):
    x, y, z = low
    outline = ((0, 0), (1, 0), (1, 1), (0, 1))
    return [(x + size * a, y + size * b, z + size * c) for c in (0, 1) for a, b in outline]


def two_boxes() -> vtkPolyData:
    """Two unit boxes that share an eighth of each. Together they fill 15/8."""
    second = [tuple(corner + 8 for corner in facet) for facet in BOX_FACETS]
    return polydata(box_points() + box_points((0.5, 0.5, 0.5)), [*BOX_FACETS, *second])


def two_boxes_and_a_stray_facet() -> vtkPolyData:
    """The same, and a triangle far off that bounds nothing."""
    boxes = two_boxes()
    stray = [(3, 3, 3), (4, 3, 3), (3, 4, 3)]
    return polydata([*map(tuple, points_of(boxes)), *stray], [*triangles_of(boxes).tolist(), (16, 17, 18)])


def open_box() -> vtkPolyData:
    """A box without its lid."""
    return box(facets=[facet for facet in BOX_FACETS if facet not in ((4, 5, 6), (4, 6, 7))])


def reversed_box() -> vtkPolyData:
    return box(facets=[facet[::-1] for facet in BOX_FACETS])


def ball(radius, around, rings) -> vtkPolyData:
    from vtkmodules.vtkFiltersSources import vtkSphereSource  # a VTK of few modules has none

    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(around)
    source.SetPhiResolution(rings)
    source.SetOutputPointsPrecision(source.DOUBLE_PRECISION)
    source.Update()
    return source.GetOutput()


def turned_boxes(seed: int) -> list[vtkPolyData]:
    """Two boxes, one on top of the other, turned together: the faces between them coincide but for rounding."""
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    boxes = box((0, 0, 0), 2), box((0.5, 0.5, 2), 1)
    return [polydata(points_of(given) @ turn, triangles_of(given)) for given in boxes]


def ball_in_a_socket(gap) -> tuple[vtkPolyData, vtkPolyData]:
    """A ball of radius 1 in a larger ball of radius 2, with triangles of their own, which bring it nearer by up to
    0.004, and farther.
    """
    inner, outer = ball(1 + gap, 43, 38), ball(2, 8, 9)
    points = np.concatenate([points_of(outer), points_of(inner)[:, [1, 2, 0]]])
    triangles = np.concatenate([triangles_of(outer), triangles_of(inner)[:, ::-1] + outer.GetNumberOfPoints()])
    return ball(1, 40, 41), polydata(points, triangles)


def closed_both_ways() -> vtkPolyData:
    """A box one half of whose facets faces inward, so that w is small everywhere: as it is given nothing is inside."""
    return box(facets=[facet[::-1] if k % 2 else facet for k, facet in enumerate(BOX_FACETS)])


def add_array(data, name: str, values):
    array = numpy_to_vtk(np.asarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)
    return array


def strings(name: str, values) -> vtkStringArray:
    array = vtkStringArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


def points_of(data) -> np.ndarray:
    return vtk_to_numpy(data.GetPoints().GetData()) if data.GetNumberOfPoints() else np.zeros((0, 3))


def tetrahedra_of(grid: vtkUnstructuredGrid) -> np.ndarray:
    assert all(grid.GetCellType(cell) == VTK_TETRA for cell in range(grid.GetNumberOfCells()))
    return vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)


def triangles_of(surface: vtkPolyData) -> np.ndarray:
    cells = surface.GetPolys()
    assert cells.GetNumberOfConnectivityIds() == 3 * surface.GetNumberOfCells(), "not all cells are triangles"
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3)


def joined(*parts: vtkPolyData) -> vtkPolyData:
    """One surface of triangles, whose points stay apart."""
    points, triangles = [], []
    for part in parts:
        triangles += (triangles_of(part) + len(points)).tolist()
        points += points_of(part).tolist()
    return polydata(points, triangles)


def cell_array(data, name: str) -> np.ndarray:
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def point_array(data, name: str) -> np.ndarray:
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def exact_volumes(grid: vtkUnstructuredGrid) -> list[Fraction]:
    points = points_of(grid).tolist()
    return [exact_volume(*(points[corner] for corner in cell)) for cell in tetrahedra_of(grid).tolist()]


def exact_volume(a, b, c, d) -> Fraction:
    """The volume of a tetrahedron, positive when it is oriented as VTK wants it."""
    u, v, w = ([Fraction(p) - Fraction(q) for p, q in zip(point, a)] for point in (b, c, d))
    determinant = (
        u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])
    )
    return determinant / 6


def is_watertight(surface: vtkPolyData) -> bool:
    """Whether every edge is run along as often one way as the other."""
    edges = Counter()
    for triangle in triangles_of(surface).tolist():
        for k in range(3):
            edges[triangle[k], triangle[(k + 1) % 3]] += 1
    return all(edges[b, a] == count for (a, b), count in list(edges.items()))


def enclosed_volume(surface: vtkPolyData) -> float:
    corners = points_of(surface)[triangles_of(surface)]
    return float(np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6)


TETRAHEDRON_FACES = np.array([[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]])
"""Faces of vtkTetra, outward for a positive one"""


def faces_of(grid: vtkUnstructuredGrid) -> tuple[np.ndarray, np.ndarray]:
    """The corners of every cell's four faces, and for each a number that equal faces share."""
    faces = tetrahedra_of(grid)[:, TETRAHEDRON_FACES].reshape(-1, 3)
    return faces, _number_rows(np.sort(faces, axis=1))


def _number_rows(rows: np.ndarray) -> np.ndarray:
    """A number for each row of point ids; equal rows have equal ones."""
    key = np.zeros(len(rows), np.int64)
    for column in rows.T:
        key = np.unique(key * (int(rows.max()) + 1) + column, return_inverse=True)[1]
    return key


def count_not_manifold(triangles: np.ndarray) -> tuple[int, int]:
    """Edges that are not in exactly two of the triangles, and points whose triangles are several fans."""
    # A half-edge for each corner, to the next; those at the ends of one edge meet two by two.
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    next_corner = np.arange(triangles.size).reshape(-1, 3)[:, [1, 2, 0]].ravel().tolist()
    edge = _number_rows(np.sort(np.column_stack([start, end]), axis=1))
    order = np.argsort(edge, kind="stable")
    alike = np.flatnonzero(np.diff(edge[order]) == 0)
    starts, fans = start.tolist(), DisjointSets(triangles.size)
    for a, b in zip(order[alike].tolist(), order[alike + 1].tolist()):
        turned = starts[a] != starts[b]
        fans.join(a, next_corner[b] if turned else b)
        fans.join(next_corner[a], b if turned else next_corner[b])
    roots = {fans.find(corner) for corner in range(triangles.size)}
    return int((np.bincount(edge) != 2).sum()), len(roots) - len(np.unique(start))


class DisjointSets:
    def __init__(self, count: int):
        self.parents = list(range(count))

    def find(self, x: int) -> int:
        while self.parents[x] != x:
            self.parents[x] = x = self.parents[self.parents[x]]
        return x

    def join(self, x: int, y: int) -> None:
        self.parents[self.find(x)] = self.find(y)
