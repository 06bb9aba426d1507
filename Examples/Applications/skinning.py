# SPDX-License-Identifier: GPL-3.0-or-later
"""Skinning weights of a skeleton in the solid of a dirty figure (the thesis's figure 8.20), and the figure bent by them.

    xvfb-run -a python3 skinning.py PICTURE.png

The weight of a bone is harmonic in the solid: 1 near the bone, 0 near the others. It flows through the overlaps of limbs,
and not through the air from a hand to a hip. The solid keeps the surface's own vertices, so that their weights are read off; those
that other limbs hide are within cells. So the surface is bent as it came, with its open ends and overlaps. Plain VTK, numpy
and scipy; the figure is figure.py's.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np
from fem import monotone, same_places, stiffness
from figure import SKELETON, Bone, write_figure
from insideout.scenes import defect_lines
from scipy.sparse.linalg import splu
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkProbeFilter

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above

EDGE_LENGTH = 0.025
CORE = 0.5  # of a limb's radius: nearer to the bone all is the bone's
SHORT = 0.12  # of a bone's length at each end belongs to no bone

POSE = {  # the axis and degrees by which a bone turns about its start, and all that hang on it
    "left upper arm": ((0, 1, 0), 40),
    "left forearm": ((0, 1, 0), -100),
    "right upper arm": ((0, 1, 0), -60),
    "right forearm": ((0, 0, 1), -60),
    "right thigh": ((1, 0, 0), -70),
    "right shin": ((1, 0, 0), 85),
    "head": ((0, 0, 1), 25),
}


def distance(points: np.ndarray, bone: Bone) -> np.ndarray:
    """From a bone without its ends."""
    start, end = np.array(bone.start), np.array(bone.end)
    start, end = start + SHORT * (end - start), end + SHORT * (start - end)
    t = ((points - start) @ (end - start) / ((end - start) @ (end - start))).clip(0, 1)
    return np.linalg.norm(points - start - t[:, None] * (end - start), axis=1)


def weights_of(points: np.ndarray, cells: np.ndarray, skeleton: dict[str, Bone]) -> np.ndarray:
    """A column for each bone: at least 0, and each row adds up to 1, for the matrix lets no extremum be inside."""
    apart = np.stack([distance(points, bone) / (CORE * max(bone.radii)) for bone in skeleton.values()], axis=1)
    held = np.flatnonzero(apart.min(axis=1) <= 1)
    if len(np.unique(apart[held].argmin(axis=1))) < len(skeleton):
        raise ValueError("a bone has no point of the solid near it: take smaller cells")
    matrix = monotone(stiffness(points, cells)[0])
    weights = np.zeros(apart.shape)
    weights[held, apart[held].argmin(axis=1)] = 1
    free = np.setdiff1d(np.arange(len(points)), held)
    weights[free] = splu(matrix[free][:, free].tocsc()).solve(-(matrix[free][:, held] @ weights[held]))
    return weights


def on_vertices(vertices: np.ndarray, solid, weights: np.ndarray) -> tuple[np.ndarray, int]:
    """The weights of the surface's vertices, and how many of these are points of the solid, bit by bit; others are in cells."""
    there = same_places(solid.points, vertices)
    array = numpy_to_vtk(weights, deep=True)
    array.SetName("Weights")
    solid.GetPointData().AddArray(array)
    places, probe = vtkPolyData(), vtkProbeFilter()
    places.SetPoints(vtkPoints())
    places.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(vertices[there < 0]), deep=True))
    probe.SetInputData(places)
    probe.SetSourceData(solid)
    probe.SetCellLocatorPrototype(vtkStaticCellLocator())  # without one a place in small cells may not be found
    probe.Update()
    found = weights[there]
    found[there < 0] = drawing.point_array(probe.GetOutput(), "Weights")
    return found, int((there >= 0).sum())


def motions(skeleton: dict[str, Bone], pose: dict) -> list[np.ndarray]:
    """For each bone how it moves, as a matrix of 4 by 4; parents come before their children."""
    found: dict[str, np.ndarray] = {}
    for name, bone in skeleton.items():
        axis, degrees = pose.get(name, ((0, 0, 1), 0))
        cross = np.cross(np.eye(3), -np.array(axis, float))
        angle = np.radians(degrees)
        turn = np.eye(4)
        turn[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
        turn[:3, 3] = bone.start - turn[:3, :3] @ bone.start
        found[name] = found.get(bone.parent, np.eye(4)) @ turn
    return list(found.values())


def bent(points: np.ndarray, weights: np.ndarray, moves: list[np.ndarray]) -> np.ndarray:
    """Each point by the mixture of the bones' motions."""
    mixed = np.einsum("pb,bij->pij", weights, np.array(moves))
    return np.einsum("pij,pj->pi", mixed[:, :3], np.column_stack([points, np.ones(len(points))]))


def with_points(surface: vtkPolyData, points: np.ndarray) -> vtkPolyData:
    copy = vtkPolyData()
    copy.DeepCopy(surface)
    copy.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    return copy


def colours_of(weights: np.ndarray) -> np.ndarray:
    """A mixture of a color for each bone."""
    hues = np.random.default_rng(4).permutation(weights.shape[1]) / weights.shape[1]
    palette = 155 + 85 * np.cos(2 * np.pi * (hues[:, None] + np.array([0, 1 / 3, 2 / 3])))
    return weights @ palette


def main(picture: Path, folder: Path) -> None:
    write_figure(folder / "figure.obj")
    checked = insideout.check(folder / "figure.obj")
    surface = checked.surface
    result = insideout.tetrahedralize(folder / "figure.obj", edge_length=EDGE_LENGTH, surface_treatment="kept")
    weights = weights_of(result.solid.points, result.solid.cells, SKELETON)

    vertices = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    on_surface, kept = on_vertices(vertices, result.solid, weights)
    least, apart = on_surface.min(), np.abs(on_surface.sum(axis=1) - 1).max()
    print(f"{kept} of {len(vertices)} vertices of the surface are points of the solid, which has {len(result.solid.points):,}")
    print(f"on the surface weights are {least:g} at least, and their sums less 1 {apart:.1e} at most")
    names = list(SKELETON)
    for name, far in (("left hand", vertices[:, 0] < 0), ("right shin", vertices[:, 2] > 1.2), ("head", vertices[:, 2] < 0.5)):
        print(f"{name}: at most {on_surface[far, names.index(name)].max():.1e} on the far side")

    places = bent(vertices, on_surface, motions(SKELETON, POSE))
    one = names.index("left forearm")
    shown = vtkPolyData()
    shown.DeepCopy(surface)
    array = numpy_to_vtk(np.ascontiguousarray(on_surface[:, one]), deep=True)
    array.SetName("Weight")
    shown.GetPointData().AddArray(array)
    statistics = checked.statistics
    figure = drawing.painted(with_points(surface, places), colours_of(on_surface))
    words = f"{statistics['IntersectingPairs']} pairs of facets cross, {statistics['OpenEdges']} open edges"
    drawing.save(
        [
            drawing.Panel("A dirty figure", words, [drawing.actor(surface), *defect_lines(checked.lines)]),
            drawing.Panel("The weight of a forearm", "blue 0, red 1", [drawing.coloured(shown, "Weight", (0, 1))]),
            drawing.Panel("Bent", "a color for each bone, mixed by weights", [figure]),
        ],
        picture,
        seen_from=(-0.6, -1, 0.2),
    )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(sys.argv[1]), Path(temporary))
    except (insideout.Error, OSError, ValueError) as error:
        sys.exit(f"skinning.py: {error}")
