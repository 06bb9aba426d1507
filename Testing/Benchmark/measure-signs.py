# SPDX-License-Identifier: GPL-3.0-or-later
"""How often VTK's classes take places for the wrong side of surfaces that are open, cross themselves or are not manifold.

    measure-signs.py SURFACE...

asks at 20,000 random places of each surface's box vtkImplicitPolyDataDistance, which decides by normals, vtkSelectEnclosedPoints, which
sends a random ray, and vtkProbeWindingNumber. Two rows for a surface that is closed, else one:

    as it is     wrong is what has another side than w, the sum over all facets (Method NAIVE), above 1/2
    20 holes     the same without the facets in 20 places; wrong is what has another side than the whole surface's w

So in the second row the probe, too, is compared with what it is not asked. Orientation is as given: nothing is turned over. Prints
a table in Markdown, percent of the places.
"""

import sys
from pathlib import Path

import insideout
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkSelectEnclosedPoints

PLACES = 20_000
HOLES = 20
SHARE_OF_HOLES = 0.02  # of all facets


def triangles_of(surface: vtkPolyData) -> tuple[np.ndarray, np.ndarray]:
    to_triangles = vtkTriangleFilter()
    to_triangles.SetInputData(surface)
    to_triangles.PassVertsOff()
    to_triangles.PassLinesOff()
    to_triangles.Update()
    made = to_triangles.GetOutput()
    return vtk_to_numpy(made.GetPoints().GetData()), vtk_to_numpy(made.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def with_holes(points: np.ndarray, triangles: np.ndarray) -> vtkPolyData:
    """Without the facets nearest to some of them."""
    centres = points[triangles].mean(axis=1)
    kept = np.ones(len(triangles), bool)
    each = max(int(SHARE_OF_HOLES * len(triangles) / HOLES), 1)
    for seed in np.random.default_rng(1).choice(len(triangles), HOLES, replace=False):
        kept[np.argsort(((centres - centres[seed]) ** 2).sum(axis=1))[:each]] = False
    return insideout.surfaces.as_surface((points, triangles[kept]))[0]


def by_w(surface: vtkPolyData, places: np.ndarray, method: int) -> np.ndarray:
    probe = insideout.vtkProbeWindingNumber()
    probe.SetInputData(insideout.inputs.as_points(places))
    probe.SetSurfaceData(surface)
    probe.SetOrientation(probe.AS_GIVEN)
    probe.SetMethod(method)
    insideout.pipeline.run(probe)
    return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("Inside")) != 0


def by_normals(surface: vtkPolyData, places: np.ndarray) -> np.ndarray:
    function, values = vtkImplicitPolyDataDistance(), vtkDoubleArray()
    function.SetInput(surface)
    function.FunctionValue(numpy_to_vtk(places), values)
    return vtk_to_numpy(values) < 0


def by_rays(surface: vtkPolyData, places: np.ndarray) -> np.ndarray:
    select = vtkSelectEnclosedPoints()
    select.SetInputData(insideout.inputs.as_points(places))
    select.SetSurfaceData(surface)
    select.Update()
    return vtk_to_numpy(select.GetOutput().GetPointData().GetArray("SelectedPoints")) != 0


def row(name: str, surface: vtkPolyData, places: np.ndarray, truth: np.ndarray) -> None:
    found = insideout.check(surface, orientation="as-given").statistics
    counts = [int(found[each]) for each in ("OpenEdges", "NonManifoldEdges", "IntersectingPairs")]
    exact = by_w(surface, places, insideout.vtkProbeWindingNumber.EXACT)
    wrong = [100 * np.mean(each != truth) for each in (by_normals(surface, places), by_rays(surface, places), exact)]
    print(f"| {name} | " + " | ".join([*map(str, counts), *(f"{percent:.2f}" for percent in wrong)]) + " |", flush=True)


def measure(path: str) -> None:
    points, triangles = triangles_of(insideout.surfaces.as_surface(path)[0])
    surface = insideout.surfaces.as_surface((points, triangles))[0]
    low, high = points.min(axis=0), points.max(axis=0)
    places = np.random.default_rng(2).uniform(low, high, (PLACES, 3))
    truth = by_w(surface, places, insideout.vtkProbeWindingNumber.NAIVE)
    name = Path(path).stem
    row(name, surface, places, truth)
    if insideout.check(surface).statistics["OpenEdges"] == 0:
        row(f"{name}, {HOLES} holes", with_holes(points, triangles), places, truth)


if __name__ == "__main__":
    print("| surface | open edges | non-manifold edges | pairs that cross | vtkImplicitPolyDataDistance | vtkSelectEnclosedPoints | vtkProbeWindingNumber |")
    print("|---|---|---|---|---|---|---|")
    for given in sys.argv[1:]:
        measure(given)
