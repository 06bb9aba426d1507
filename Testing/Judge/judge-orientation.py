#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How often the solid that is meant is found when parts of a closed surface are turned over.

    judge-orientation.py [--seeds N] SURFACE...

Takes the closed ones of the surfaces. For each surface it turns shells, connected patches, or single facets (5, 30 and
50 %) over at random, with and without a large open sheet below. It compares the inside with that of the surface with
all shells outward. One line per kind of change: the share of runs that give the same solid with Orientation automatic,
with as-given, and for vtkPolyDataNormals' AutoOrientNormals; then every run that automatic fails, with its reason. Two
solids are the same if the facets face the same way (no difference at all, counted apart). They also are if less than
1 % of the solid's volume differs, by places in the boxes of the surface and its shells.
"""

from __future__ import annotations

import argparse
import sys
from collections import defaultdict

import insideout
import numpy as np
from insideout.data import corners_of
from insideout.surfaces import as_surface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter

PLACES = 4000  # in all boxes
CHANGES = ("shells", "patches", "5 %", "30 %", "50 %")


def surface_of(points, triangles) -> vtkPolyData:
    return as_surface((points, triangles))[0]


def turned_over(triangles, which):
    return np.where(which[:, None], triangles[:, ::-1], triangles)


class Model:
    """A closed surface with all its shells outward, and places at which to compare."""

    def __init__(self, points, triangles, shells):
        self.points, self.triangles, self.shells = points, triangles, shells
        random = np.random.default_rng(1)
        boxes = [points[triangles[shells == shell]].reshape(-1, 3) for shell in range(min(shells.max() + 1, 50))]
        places = []
        for corners in [points, *boxes]:
            low, high = corners.min(axis=0), corners.max(axis=0)
            places.append(low + (high - low) * random.random((PLACES // (1 + len(boxes)), 3)))
        self.places = np.concatenate(places)
        self.truth = insideout.inside(surface_of(points, triangles), self.places, orientation="as-given")
        self.nested = self.has_nested()

    def has_nested(self) -> bool:
        """Whether a shell lies within another, so that it may be a cavity."""
        w = insideout.winding_number(surface_of(self.points, self.triangles), self.places, orientation="as-given")
        return bool((w > 1.5).any())

    def differs(self, points, triangles, orientation) -> float:
        """What share of the solid differs, roughly; the places are as many for small shells as for large ones."""
        inside = insideout.inside(surface_of(points, triangles), self.places, orientation=orientation)
        return float((inside != self.truth).sum() / max(1, self.truth.sum()))


def outward(surface):
    """The surface with every shell outward as points, triangles and shells; None where it is open or flat."""
    found = insideout.check(surface, orientation="outward")
    s = found.statistics
    if s["UnbalancedEdges"] or s["Planar"] or s["HoledShells"] or s["SheetShells"] or s["SheetShare"] or s["DegenerateFacets"]:
        return None
    points = vtk_to_numpy(found.surface.GetPoints().GetData()).astype(float)
    triangles = corners_of(found.surface.GetPolys(), 3)
    _, first, merged = np.unique(points, axis=0, return_index=True, return_inverse=True)
    triangles = first[merged.ravel()][triangles]
    turned = vtk_to_numpy(found.surface.GetCellData().GetArray("Turned")) > 0
    return points, turned_over(triangles, turned), vtk_to_numpy(found.surface.GetCellData().GetArray("ComponentId"))


def changed(model, change, random):
    """Which facets are turned."""
    size = len(model.triangles)
    if change == "shells":
        return (random.random(model.shells.max() + 1) < 0.5)[model.shells]
    if change == "patches":
        which = np.zeros(size, bool)
        middles = model.points[model.triangles].mean(axis=1)
        for _ in range(3):  # what is nearest to a facet, of its own shell
            at = random.integers(size)
            distance = np.linalg.norm(middles - middles[at], axis=1)
            distance[model.shells != model.shells[at]] = np.inf
            which ^= distance <= np.sort(distance)[int(random.integers(1, max(2, size // 5)))]
        return which
    return random.random(size) < float(change.split()[0]) / 100


def with_ground(points, triangles):
    low, high = points.min(axis=0), points.max(axis=0)
    x, y = (low + high)[:2] / 2
    half, z = 5 * (high - low).max(), low[2] - 0.05 * (high - low).max()
    n = len(points)
    ground = [(x - half, y - half, z), (x + half, y - half, z), (x + half, y + half, z), (x - half, y + half, z)]
    return np.vstack([points, ground]), np.vstack([triangles, [(n, n + 1, n + 2), (n, n + 2, n + 3)]])


def by_vtk(points, triangles):
    """The triangles as vtkPolyDataNormals orients them; points are those it gives."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface_of(points, triangles))
    normals.SplittingOff()
    normals.ConsistencyOn()
    normals.AutoOrientNormalsOn()
    normals.Update()
    output = normals.GetOutput()
    return vtk_to_numpy(output.GetPoints().GetData()).astype(float), corners_of(output.GetPolys(), 3)


def is_same(model, points, triangles, which) -> tuple[bool, bool]:
    """Whether automatic orientation gives the outward surface: facet by facet, or by places."""
    marked = insideout.check(surface_of(points, triangles)).surface
    turned = vtk_to_numpy(marked.GetCellData().GetArray("Turned"))[: len(which)] > 0
    if (turned == which).all():
        return True, True
    return False, model.differs(points, triangles, "automatic") < 0.01


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--most", type=int, default=100_000, help="facets of a surface that is not passed over")
    parser.add_argument("--several", action="store_true", help="only surfaces of several shells")
    parser.add_argument("surfaces", nargs="+")
    options = parser.parse_args()
    right = defaultdict(lambda: np.zeros(5, int))
    models = several = nested = 0
    for path in options.surfaces:
        try:
            triangulate = vtkTriangleFilter()
            triangulate.SetInputData(as_surface(path)[0])
            triangulate.PassVertsOff()
            triangulate.PassLinesOff()
            triangulate.Update()
            if triangulate.GetOutput().GetNumberOfPolys() > options.most:
                continue
            found = outward(triangulate.GetOutput())
        except insideout.Error as error:
            print(f"{path}: {error}", file=sys.stderr)
            continue
        if found is None or (options.several and found[2].max() == 0):
            continue
        models += 1
        model = Model(*found)
        several += model.shells.max() > 0
        nested += model.nested
        for change in CHANGES:
            for seed in range(options.seeds):
                which = changed(model, change, np.random.default_rng(seed))
                for ground in (False, True):
                    points, triangles = model.points, turned_over(model.triangles, which)
                    if ground:
                        points, triangles = with_ground(points, triangles)
                    kind = f"{change}{' above ground' if ground else ''}"
                    exactly, automatic = is_same(model, points, triangles, which)
                    given = model.differs(points, triangles, "as-given") < 0.01
                    vtk = model.differs(*by_vtk(points, triangles), "as-given") < 0.01
                    right[kind] += (1, exactly, automatic, given, vtk)
                    if not automatic:
                        why = "shells within shells: a cavity may be meant" if model.nested else "another way was taken"
                        print(f"  {path.rsplit('/', 1)[-1]}, {kind}, seed {seed}: {why}", flush=True)
    print(f"{models} closed surfaces, {several} of several shells, {nested} with shells that overlap or lie within others")
    for kind, (runs, *counts) in right.items():
        shares = [f"{count / runs:7.1%}" for count in counts]
        print(f"{kind:22} of {runs:5} runs: automatic {shares[1]} ({shares[0]} facet by facet), ", end="")
        print(f"as given {shares[2]}, vtkPolyDataNormals {shares[3]}")


if __name__ == "__main__":
    main()
