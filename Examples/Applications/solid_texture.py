# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid texture (the thesis's figure 8.18): year's rings that follow a broken model's surface, seen where it is cut open.

    xvfb-run -a python3 solid_texture.py PICTURE.png [SURFACE [UP]]

Depth is what solves the Poisson equation in the solid, with 0 on its boundary: rings of its root run along the
surface. The solid keeps each vertex of the surface, so the surface itself is drawn outside, as it came, and the solid only
where the cut is. Without a surface it takes pig.stl of Debian's package libcgal-demo, which is open. Plain VTK, numpy, scipy.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np
from fem import same_places, stiffness
from insideout.scenes import defect_lines
from scipy.sparse.linalg import splu
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkCutter, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

RINGS = 9
BARK, EARLY, LATE = np.array([92, 60, 40]), np.array([222, 184, 135]), np.array([150, 98, 58])
CELLS_ACROSS = 45  # along the longest side
FINE = 3  # times each triangle of the cut is divided in four


def depth_in(points: np.ndarray, cells: np.ndarray, boundary: np.ndarray) -> np.ndarray:
    """From 0 on the boundary to 1 at the deepest point: the root of what solves the Poisson equation."""
    matrix, volumes = stiffness(points, cells)
    inside = np.setdiff1d(np.flatnonzero(volumes > 0), boundary)
    depth = np.zeros(len(points))
    depth[inside] = splu(matrix[inside][:, inside].tocsc()).solve(volumes[inside])
    return np.sqrt(np.maximum(depth, 0) / depth.max())


def texture(places: np.ndarray, depth: np.ndarray, size: float) -> np.ndarray:
    """Wood: bark, then rings, which waves bend and make uneven; a color for each place."""
    x, y, z = (places / size * 2 * np.pi * 3).T
    uneven = 0.015 * (np.sin(2 * x + np.cos(3 * y)) + np.sin(3 * z + np.cos(2 * x)) + np.sin(5 * y + z))
    ring = (depth + uneven) * RINGS % 1
    late = (ring**4)[:, None]
    wood = (1 - late) * EARLY + late * LATE
    return np.where((depth < 0.12)[:, None], BARK, wood).clip(0, 255)


def cut_through(solid, plane: vtkPlane) -> vtkPolyData:
    """The solid where the plane cuts it, in small triangles, with the depth at their points."""
    cutter, triangles, fine = vtkCutter(), vtkTriangleFilter(), vtkLinearSubdivisionFilter()
    cutter.SetInputData(solid)
    cutter.SetCutFunction(plane)
    triangles.SetInputConnection(cutter.GetOutputPort())
    fine.SetInputConnection(triangles.GetOutputPort())
    fine.SetNumberOfSubdivisions(FINE)
    fine.Update()
    return fine.GetOutput()


def half_of(surface: vtkPolyData, plane: vtkPlane) -> vtkPolyData:
    clip = vtkClipPolyData()
    clip.SetInputData(surface)
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    clip.Update()
    return clip.GetOutput()


def main(picture: Path, surface: Path, up: int) -> None:
    checked = insideout.check(surface)
    raw = checked.surface
    bounds = np.array(raw.GetBounds()).reshape(3, 2)
    size = np.ptp(bounds, axis=1)
    result = insideout.tetrahedralize(surface, edge_length=size.max() / CELLS_ACROSS, surface_treatment="kept")
    solid = result.solid
    boundary = same_places(solid.points, result.boundary.points)
    depth = depth_in(solid.points, solid.cells, boundary)
    vertices = vtk_to_numpy(raw.GetPoints().GetData()).astype(float)
    missing = vertices[same_places(solid.points, vertices) < 0]
    beyond = (same_places(result.outliers.points, missing) >= 0).sum()
    print(f"{len(vertices) - len(missing)} of {len(vertices)} vertices are points of the solid, {beyond} only of facets beyond it")
    print(f"depth {depth[boundary].max():g} on the boundary, {depth.max():g} at most, {(depth > 0).sum()} points inside")

    across = min((axis for axis in range(3) if axis != up), key=lambda axis: size[axis])
    plane = vtkPlane()
    plane.SetOrigin(*bounds.mean(axis=1))
    plane.SetNormal(*np.eye(3)[across])
    values = numpy_to_vtk(depth, deep=True)
    values.SetName("Depth")
    solid.GetPointData().AddArray(values)
    cut = cut_through(solid, plane)
    colours = texture(vtk_to_numpy(cut.GetPoints().GetData()), drawing.point_array(cut, "Depth"), size.max())
    wood = drawing.painted(cut, colours)
    wood.GetProperty().LightingOff()
    bark = tuple(BARK / 255)
    toward = np.eye(3)[across] + 0.25 * np.eye(3)[up] + 0.45 * np.eye(3)[3 - up - across]
    counts = checked.statistics
    words = f"{counts['OpenEdges']} open edges, {counts['IntersectingPairs']} pairs of facets cross"
    drawing.save(
        [
            drawing.Panel("The surface as it came", words, [drawing.actor(raw, bark), *defect_lines(checked.lines)]),
            drawing.Panel("Cut open", "the surface, and the solid's texture in the cut", [drawing.actor(half_of(raw, plane), bark), wood]),
        ],
        picture,
        seen_from=toward,
        up=np.eye(3)[up],
        bounds=bounds,
    )


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as folder:
            given = Path(sys.argv[2]) if len(sys.argv) > 2 else models.unpacked("pig.stl", Path(folder))
            main(Path(sys.argv[1]), given, "xyz".index(sys.argv[3] if len(sys.argv) > 3 else "z"))
    except (insideout.Error, OSError) as error:
        sys.exit(f"solid_texture.py: {error}")
