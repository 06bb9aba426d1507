# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds for the voxels inside a surface, and for distances, against VTK's own classes.

    measure-voxels.py VTK SURFACE...

VTK is the folder in which Debian's packages libvtk9.1 and python3-vtk9 are unpacked (dpkg -x), for ParaView's own
VTK has no stencils.

image/NAME: a mask of 300 x 300 x 300 points by vtkProbeWindingNumber (Inside alone) against vtkPolyDataToImageStencil
and vtkImageStencilToImage. These make the same mask of a closed surface, in a process of their own; image/NAME-open: the
same of the surface with 20 holes, against VTK's time for the whole one.
distance/NAME: signed distances at 20,000 places by vtkProbeWindingNumber and by vtkImplicitWindingNumber against
vtkImplicitPolyDataDistance, and how often the signs differ; all that is built for it is in each time.
Prints lines as Measure.h does, medians of five by turns.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

REPETITIONS = 5
VOXELS = 300
PLACES = 20_000
HOLES = 20
EDGES_PER_HOLE = 60
IMAGE_LIMIT, OPEN_IMAGE_LIMIT, DISTANCE_LIMIT = 1, 5, 1


def seconds_of(run: Callable[[], object]) -> Callable[[], float]:
    def measured() -> float:
        began = time.perf_counter()
        run()
        return time.perf_counter() - began

    return measured


def medians(*seconds: Callable[[], float]) -> list[float]:
    """The median seconds of each, in turns, after one round for warming up."""
    rounds = [[each() for each in seconds] for _ in range(REPETITIONS + 1)]
    return [statistics.median(column) for column in zip(*rounds[1:])]


def triangles_of(surface: Any) -> tuple[np.ndarray, np.ndarray]:
    points = vtk_to_numpy(surface.GetPoints().GetData())
    return points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def with_holes(surface: vtkPolyData) -> vtkPolyData:
    """Remove some facets around each of some places, up to holes of this number of edges."""
    points, triangles = triangles_of(surface)
    centres = points[triangles].mean(axis=1)
    kept = np.ones(len(triangles), bool)
    random = np.random.default_rng(1)
    facets_per_hole = EDGES_PER_HOLE**2 // 16  # of a disk of triangles
    for seed in random.choice(len(triangles), HOLES, replace=False):
        near = np.argsort(((centres - centres[seed]) ** 2).sum(axis=1))
        kept[near[:facets_per_hole]] = False
    return insideout.surfaces.as_surface((points, triangles[kept]))[0]


def image_around(surface: vtkPolyData, voxels: int) -> vtkImageData:
    low, high = np.array(surface.GetBounds()).reshape(3, 2).T
    middle, half = (low + high) / 2, 0.525 * (high - low)
    image = vtkImageData()
    image.SetDimensions(voxels, voxels, voxels)
    image.SetOrigin(middle - half)
    image.SetSpacing(2 * half / (voxels - 1))
    return image


def mask(surface: vtkPolyData, image: vtkImageData) -> np.ndarray:
    probe = insideout.vtkProbeWindingNumber()
    probe.SetInputData(image)
    probe.SetSurfaceData(surface)
    probe.OutputWindingNumberOff()
    probe.Update()
    return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("Inside"))


class Stencil:
    """VTK's stencils, in a process of another VTK; __call__ makes a mask and returns its bytes."""

    def __init__(self, vtk: str, surface: vtkPolyData, image: vtkImageData):
        self.folder = tempfile.TemporaryDirectory()
        self.file = str(Path(self.folder.name) / "surface.npz")
        points, triangles = triangles_of(surface)
        grid = {"origin": image.GetOrigin(), "spacing": image.GetSpacing(), "extent": image.GetExtent()}
        np.savez(self.file, points=points, triangles=triangles, **grid)
        environment = {
            **os.environ,
            "PYTHONPATH": f"{vtk}/usr/lib/python3/dist-packages",
            "LD_LIBRARY_PATH": f"{vtk}/usr/lib/x86_64-linux-gnu",
        }
        command = [sys.executable, __file__, "--stencil", self.file]
        self.process = subprocess.Popen(command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def __call__(self) -> float:
        """Seconds, as that process measures them."""
        assert self.process.stdin and self.process.stdout
        self.process.stdin.write(b"go\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline())

    def mask(self) -> np.ndarray:
        self.process.communicate()
        return np.load(self.file + ".npy")


def serve_stencils(file: str) -> None:
    """For each line that comes in a mask is made, and its seconds go out; the last is left in a file."""
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    from vtkmodules.vtkImagingStencil import vtkImageStencilToImage, vtkPolyDataToImageStencil

    given = np.load(file)
    points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(given["points"], deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(given["triangles"].ravel().astype(np.int64), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(cells)
    for _ in sys.stdin:
        began = time.perf_counter()
        stencil = vtkPolyDataToImageStencil()
        stencil.SetInputData(surface)
        stencil.SetOutputOrigin(given["origin"])
        stencil.SetOutputSpacing(given["spacing"])
        stencil.SetOutputWholeExtent([int(n) for n in given["extent"]])
        to_image = vtkImageStencilToImage()
        to_image.SetInputConnection(stencil.GetOutputPort())
        to_image.SetOutputScalarTypeToUnsignedChar()
        to_image.Update()
        print(time.perf_counter() - began, flush=True)
    np.save(file + ".npy", vtk_to_numpy(to_image.GetOutput().GetPointData().GetScalars()))


def measure_image(name: str, surface: vtkPolyData, vtk: str) -> None:
    image, opened = image_around(surface, VOXELS), with_holes(surface)
    stencil = Stencil(vtk, surface, image)
    ours, vtks, with_20_holes = medians(
        seconds_of(lambda: mask(surface, image)), stencil, seconds_of(lambda: mask(opened, image))
    )
    differ = np.count_nonzero(mask(surface, image) != (stencil.mask() != 0))
    print(
        f"{'image/' + name:28}   probe {ours:8.4f} s   stencil {vtks:8.4f} s   "
        f"probe with {HOLES} holes {with_20_holes:8.4f} s   {differ} of {VOXELS**3} differ"
    )
    print(f"ratio image/{name} {ours / vtks:.3f} at most {IMAGE_LIMIT:g}")
    print(f"ratio image/{name}-open {with_20_holes / vtks:.3f} at most {OPEN_IMAGE_LIMIT:g}")


def distances(surface: vtkPolyData, places: np.ndarray) -> np.ndarray:
    probe = insideout.vtkProbeWindingNumber()
    probe.SetInputData(insideout.inputs.as_points(places))
    probe.SetSurfaceData(surface)
    probe.DistanceOn()
    probe.Update()
    return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("Distance"))


def function_values(function: Any, places: np.ndarray) -> np.ndarray:
    values = vtkDoubleArray()
    function.FunctionValue(numpy_to_vtk(places), values)
    return vtk_to_numpy(values)


def distances_by_function(surface: vtkPolyData, places: np.ndarray) -> np.ndarray:
    function = insideout.vtkImplicitWindingNumber()
    function.SetInput(surface)
    function.SignedDistanceOn()
    return function_values(function, places)


def distances_by_vtk(surface: vtkPolyData, places: np.ndarray) -> np.ndarray:
    function = vtkImplicitPolyDataDistance()
    function.SetInput(surface)
    return function_values(function, places)


def measure_distance(name: str, surface: vtkPolyData) -> None:
    low, high = np.array(surface.GetBounds()).reshape(3, 2).T
    places = np.random.default_rng(1).uniform(low, high, (PLACES, 3))
    probe, function, vtks = medians(
        seconds_of(lambda: distances(surface, places)),
        seconds_of(lambda: distances_by_function(surface, places)),
        seconds_of(lambda: distances_by_vtk(surface, places)),
    )
    ours, theirs = distances(surface, places), distances_by_vtk(surface, places)
    signs = np.count_nonzero((ours < 0) != (theirs < 0))
    most = np.abs(np.abs(ours) - np.abs(theirs)).max() / np.linalg.norm(high - low)
    print(
        f"{'distance/' + name:28}   probe {probe:8.4f} s   function {function:8.4f} s   VTK {vtks:8.4f} s   "
        f"{signs} of {PLACES} signs differ, distances by {most:.1e} of the diagonal"
    )
    print(f"ratio distance/{name} {max(probe, function) / vtks:.3f} at most {DISTANCE_LIMIT:g}")


if __name__ == "__main__":
    if sys.argv[1] == "--stencil":
        serve_stencils(sys.argv[2])
    else:
        import insideout

        for given in sys.argv[2:]:
            read = insideout.surfaces.as_surface(given)[0]
            measure_image(Path(given).stem, read, sys.argv[1])
            measure_distance(Path(given).stem, read)
