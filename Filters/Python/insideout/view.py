# SPDX-License-Identifier: GPL-3.0-or-later
"""The cameras of pictures of a surface."""

from __future__ import annotations

import copy
from typing import Optional

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkRenderer

from .data import corners_of

PANEL_WIDTH, HEIGHT = 800, 900
WIDTH_USED, HEIGHT_USED = 0.92, 0.77  # share of a panel; the rest is for text
FLAT_HEIGHT_USED = 0.7

PLACES, SQUARES = 20000, 48  # squares per direction that rasterize the outline of sample points
EVEN_STEPS = (0.7548776662466927, 0.5698402909980532)  # their multiples, modulo 1, fill a square evenly
VERY_FLAT = 1 / 3  # of its lesser width
MUCH_LONGER = 1.1
STEEP = 0.9  # an axis with a larger component along a plane's normal is not up in it


def places_on(points: NDArray[np.float64], corners: NDArray[np.int64]) -> NDArray[np.float64]:
    """Points spread evenly over triangles, the same at each call."""
    a, b, c = (points[corner] for corner in corners.T)
    summed = np.cumsum(np.linalg.norm(np.cross(b - a, c - a), axis=1))
    k = np.arange(PLACES)
    chosen = np.searchsorted(summed, (k + 0.5) / PLACES * summed[-1]).clip(max=len(summed) - 1)
    a, b, c = a[chosen], b[chosen], c[chosen]
    s, t = (k * step % 1 for step in EVEN_STEPS)
    s, t = np.where(s + t > 1, (1 - s, 1 - t), (s, t))[:, :, np.newaxis]
    return a + s * (b - a) + t * (c - a)


def shown(places: NDArray[np.float64], size: NDArray[np.float64], axis: int) -> float:
    """The area of the outline seen along an axis."""
    across = np.delete(size, axis)
    squares = np.floor(np.delete(places, axis, axis=1) / np.where(across > 0, across, 1) * SQUARES)
    return len(np.unique(squares, axis=0)) / SQUARES**2 * float(np.prod(across))


class View:
    """The camera of a surface: at the side that shows most, a little to the right and above. Up is as given, or else y,
    as in most formats but STL, or z if the surface is longer along z by a tenth. The chosen side has the largest
    outline of the four sides, and of the top if the surface is very flat. The one of two opposite sides with more
    points in front of the center is chosen, because it has more detail."""

    def __init__(self, surface: vtkPolyData, up: Optional[str] = None):
        bounds = np.array(surface.GetBounds()).reshape(3, 2)
        size = bounds[:, 1] - bounds[:, 0]
        self.centre = bounds.mean(axis=1)
        upward = "xyz".index(up) if up else 2 if size[2] > MUCH_LONGER * size[1] else 1
        sides = [axis for axis in (1, 2, 0) if axis != upward]  # the usual front comes first
        tops = [upward] if size[upward] < VERY_FLAT * min(size[sides]) else []

        unit = size.max() or 1.0
        corners = corners_of(surface.GetPolys(), 3)
        points = (vtk_to_numpy(surface.GetPoints().GetData()) - bounds[:, 0]) / unit
        places = places_on(points, corners)
        nearest = max(sides + tops, key=lambda axis: shown(places, size / unit, axis))
        lean = np.sign(points[np.unique(corners), nearest] - size[nearest] / unit / 2).sum()
        from_behind = nearest != upward and (lean < 0 or (lean == 0 and nearest == 1))

        axes = np.eye(3)
        self.slice_normal = axes[nearest] * (-1 if from_behind else 1)
        self.up = axes[upward] if nearest != upward else axes[min(sides, key=lambda axis: size[axis])]
        self.right = np.cross(self.up, self.slice_normal)
        self.distance = 4 * float(np.linalg.norm(size))
        self._bounds = bounds
        self._look_from(1)

    def from_behind(self) -> View:
        """The opposite camera, also from above."""
        other = copy.copy(self)
        other._look_from(-1)
        return other

    def _look_from(self, side: int) -> None:
        # A camera a little from the side and from above, so that depth is visible.
        eye = side * (self.slice_normal + 0.35 * self.right) + 0.25 * self.up
        self.eye = eye / np.linalg.norm(eye)
        self.size = self._size_on_screen(self._bounds)

    def _size_on_screen(self, bounds: NDArray[np.float64]) -> tuple[float, float]:
        across = np.cross(self.up, self.eye)
        across /= np.linalg.norm(across)
        down = np.cross(across, self.eye)
        corners = np.array([[bounds[i, b] for i, b in enumerate(pick)] for pick in np.ndindex(2, 2, 2)])
        return float(np.ptp(corners @ across)), float(np.ptp(corners @ down))

    def slice_plane(self) -> vtkPlane:
        plane = vtkPlane()
        plane.SetOrigin(*self.centre)
        plane.SetNormal(*self.slice_normal)
        return plane

    def apply(self, renderer: vtkRenderer) -> None:
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*self.centre)
        camera.SetPosition(*(self.centre + self.distance * self.eye))
        camera.SetViewUp(*self.up)
        width, height = self.size
        camera.SetParallelScale(0.5 * max(width * HEIGHT / PANEL_WIDTH / WIDTH_USED, height / HEIGHT_USED))
        renderer.ResetCameraClippingRange()


class ViewFromAbove:
    """The camera of planar data: perpendicular, so that triangles run counter-clockwise. Up is as given, or else y, or
    z in a plane perpendicular to y; in any case as near as the plane allows.
    """

    def __init__(self, flat: vtkPolyData, up: Optional[str] = None):
        points = vtk_to_numpy(flat.GetPoints().GetData()).astype(float)
        self.eye = _normal(points, corners_of(flat.GetPolys(), 3))
        upward = "xyz".index(up) if up else 1
        upward = upward if abs(self.eye[upward]) < STEEP else 2 if upward != 2 else 1
        self.up = np.eye(3)[upward] - self.eye[upward] * self.eye
        self.up /= np.linalg.norm(self.up)
        places = points @ np.transpose([np.cross(self.up, self.eye), self.up, self.eye])
        low, high = places.min(axis=0), places.max(axis=0)
        self.size = high - low
        self.centre = (low + high) / 2 @ [np.cross(self.up, self.eye), self.up, self.eye]

    def apply(self, renderer: vtkRenderer) -> None:
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*self.centre)
        camera.SetPosition(*(self.centre + 2 * float(np.linalg.norm(self.size)) * self.eye))
        camera.SetViewUp(*self.up)
        width, height = self.size[:2]
        camera.SetParallelScale(0.5 * max(width * HEIGHT / PANEL_WIDTH / WIDTH_USED, height / FLAT_HEIGHT_USED))
        renderer.ResetCameraClippingRange()


def _normal(points: NDArray[np.float64], corners: NDArray[np.int64]) -> NDArray[np.float64]:
    """The normal of triangles, or of the plane of points, oriented along the nearest axis."""
    if len(corners):
        a, b, c = (points[corner] for corner in corners.T)
        normal = np.cross(b - a, c - a).sum(axis=0)
        return normal / np.linalg.norm(normal)
    normal = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][-1]
    return normal * np.sign(normal[np.argmax(np.abs(normal))])
