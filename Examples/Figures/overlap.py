# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure with holes whose hand is within its chest, and the hand pulled out (the thesis's figure 8.17, the Holey Cow).

    xvfb-run -a python3 overlap.py PICTURE.png

The figure of Debian's package libcgal-demo stands clean, so one of its forearms is swung into its chest, and some of
its triangles are taken away. w is 2 where both overlap, and the solid has that place once: what moves the hand drags
the chest along. With SeparateOverlaps hand and chest have cells of their own there. The arm is the set of cells within
reach of the hand's tip through cells; it swings out again.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np
from insideout.data import Tetrahedra, TriangleSurface
from insideout.surfaces import as_surface, make_surface
from insideout.actors import slice_actor, slice_of
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

ARM, BEND = 0.22, 0.1  # how long the forearm is, on the way from its tip, and how long the part that bends
INWARD, OUTWARD = 80, -80  # degrees by which it swings into the body, and out again
HOLES = 12  # places where triangles are taken away
RADIUS = 0.012
SEEN_FROM = (0.15, 0.35, 1)


def ways_from(tip: int, points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """How far each point is from one of them, along edges of triangles or tetrahedra."""
    pairs = np.vstack([cells[:, [i, j]] for i in range(cells.shape[1]) for j in range(i)])
    pairs = np.unique(np.sort(pairs, axis=1), axis=0)  # each once: a matrix adds up what is there twice
    lengths = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    graph = coo_matrix((lengths, tuple(pairs.T)), (len(points), len(points)))
    return dijkstra(graph.tocsr(), directed=False, indices=tip)


def swung(points: np.ndarray, ways: np.ndarray, degrees: float) -> np.ndarray:
    """The arm turned about an upright axis in its elbow."""
    share = np.clip((ARM - ways) / BEND, 0, 1)
    elbow = points[np.abs(ways - ARM + BEND / 2) < BEND / 10].mean(axis=0)
    angle = np.radians(degrees) * share
    x, y, z = (points - elbow).T
    return elbow + np.column_stack([x * np.cos(angle) - z * np.sin(angle), y, x * np.sin(angle) + z * np.cos(angle)])


def dirty_figure(folder: Path) -> tuple[TriangleSurface, int]:
    """And which of its points is the tip of its hand, which is within its chest."""
    given = as_surface(models.unpacked("homer.off", folder))[0]
    points = vtk_to_numpy(given.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(given.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    tip = int(np.argmax(points[:, 0]))
    points = swung(points, ways_from(tip, points, triangles), INWARD)
    middles = points[triangles].mean(axis=1)
    torn = middles[np.random.default_rng(1).choice(len(middles), HOLES, replace=False)]
    kept = np.min(np.linalg.norm(middles[:, None] - torn, axis=2), axis=1) > RADIUS
    return make_surface(points, triangles[kept]), tip


def volumes_of(points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    u, v, t = (points[cells[:, k]] - points[cells[:, 0]] for k in (1, 2, 3))
    return np.einsum("ij,ij->i", np.cross(u, v), t) / 6


def pulled_out(solid: Tetrahedra, tip: int) -> tuple[Tetrahedra, int]:
    """The solid with its arm swung out, and how many cells turned inside out."""
    at = int(np.flatnonzero(solid.point_arrays["vtkOriginalPointIds"] == tip)[0])
    points = swung(solid.points, ways_from(at, solid.points, solid.cells), OUTWARD)
    moved = Tetrahedra()
    moved.DeepCopy(solid)
    vtk_to_numpy(moved.GetPoints().GetData())[:] = points
    return moved, int((volumes_of(points, solid.cells) <= 0).sum())


def main(picture: Path, folder: Path) -> None:
    surface, tip = dirty_figure(folder)
    glued = insideout.tetrahedralize(surface)
    apart = insideout.tetrahedralize(surface, separate_overlaps=True)
    found = apart.statistics
    panels = [
        drawing.Panel("A hand within a chest", f"{found['IntersectingPairs']} pairs of facets cross", [drawing.actor(surface)], SEEN_FROM),
        drawing.Panel("Winding number w, a slice of the hull", "dark red: 2", [slice_of_hand(surface, glued.hull, tip)], (0, 1, 0.01), (0, 0, -1)),
    ]
    for name, solid in (("glued", glued.solid), ("separated", apart.solid)):
        moved, turned = pulled_out(solid, tip)
        print(f"{name}: {turned} of {len(solid.cells)} cells turned inside out")
        words = f"{turned} tetrahedra turned inside out"
        panels.append(drawing.Panel(f"The arm swung out: {name}", words, [drawing.actor(moved, drawing.BLUE, edges=True)], SEEN_FROM))
    print(f"{found['OpenEdges']} open edges; {found['SeparatedOverlaps']} of {found['Overlaps']} overlaps separated, {found['CopiedCells']} cells copied")
    drawing.save(panels, picture, up=(0, 1, 0))


def slice_of_hand(surface: TriangleSurface, hull: Tetrahedra, tip: int) -> vtkActor:
    plane = vtkPlane()
    plane.SetOrigin(*surface.points[tip])
    plane.SetNormal(0, 1, 0)
    return slice_actor(slice_of(hull, plane))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(sys.argv[1]), Path(temporary))
    except (insideout.Error, OSError) as error:
        sys.exit(f"overlap.py: {error}")
