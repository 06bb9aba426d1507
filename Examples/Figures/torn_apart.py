# SPDX-License-Identifier: GPL-3.0-or-later
"""A model torn apart (the thesis's figure 8.14): each triangle turns about an axis of its own, by 0 to 180 degrees.

    xvfb-run -a python3 torn_apart.py PICTURE.png PLOT.png [ANGLES]

The model is a head that is open at its base, of Debian's package libcgal-demo, with fewer facets
(vtkQuadricDecimation). For each angle the picture has a slice of the winding number w, which degrades gracefully, and
the solid. The plot shows the error of the volume, and the energy of the cut. Orientation is as given; otherwise
triangles that turned over would be turned back.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import insideout
import matplotlib
import numpy as np
from insideout.actors import slice_actor, slice_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation, vtkTriangleFilter

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend has to be chosen first

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

MODEL, FACETS = "mannequin-devil.off", 1500
SHOWN = 6  # of the angles


def corners_of(surface: Path, facets: int = FACETS) -> np.ndarray:
    """The three places of each triangle of a copy with about this number of facets."""
    raw = insideout.check(surface).surface
    triangles, coarse = vtkTriangleFilter(), vtkQuadricDecimation()
    triangles.SetInputData(raw)
    coarse.SetInputConnection(triangles.GetOutputPort())
    coarse.SetTargetReduction(1 - facets / raw.GetNumberOfCells())
    coarse.Update()
    found = coarse.GetOutput()
    points = vtk_to_numpy(found.GetPoints().GetData()).astype(float)
    return points[vtk_to_numpy(found.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


def turned(corners: np.ndarray, axes: np.ndarray, angle: float) -> np.ndarray:
    """Each triangle about its own axis through its own middle."""
    middle = corners.mean(axis=1, keepdims=True)
    away, axes = corners - middle, axes[:, None]
    along = (away * axes).sum(axis=2, keepdims=True) * axes
    return middle + along + np.cos(angle) * (away - along) + np.sin(angle) * np.cross(np.broadcast_to(axes, away.shape), away)


def plot(degrees: np.ndarray, volumes: np.ndarray, energies: list[float], file: Path) -> None:
    figure, axes = pyplot.subplots(figsize=(6, 4), constrained_layout=True)
    axes.plot(degrees, 100 * (volumes / volumes[0] - 1), "o-", color="tab:blue")
    axes.set_xlabel("degrees by which each triangle turned")
    axes.set_ylabel("volume, change in %", color="tab:blue")
    other = axes.twinx()
    other.plot(degrees, energies, "s--", color="tab:red")
    other.set_ylabel("energy of the cut", color="tab:red")
    axes.grid(True, alpha=0.3)
    figure.savefig(file, dpi=150)


def main(picture: Path, plotted: Path, angles: int, folder: Path) -> None:
    corners = corners_of(models.unpacked(MODEL, folder))
    axes = np.random.default_rng(8).normal(size=(len(corners), 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    degrees = np.linspace(0, 180, angles)
    plane = vtkPlane()
    plane.SetNormal(1, 0, 0)
    volumes, energies, slices, solids = [], [], [], []
    for angle in degrees:
        places = turned(corners, axes, np.radians(angle)).reshape(-1, 3)
        result = insideout.tetrahedralize((places, np.arange(len(places)).reshape(-1, 3)), orientation="as-given")
        volumes.append(result.statistics["Volume"])
        energies.append(result.statistics["Energy"])
        crossing = result.statistics["IntersectingPairs"]
        change = 100 * (volumes[-1] / volumes[0] - 1)
        print(f"{angle:.0f} degrees: {crossing} pairs cross, volume {change:+.2f} %, energy {energies[-1]:.1f}", flush=True)
        if np.isclose(angle, np.linspace(0, 180, SHOWN)).any():
            plane.SetOrigin(*result.hull.points.mean(axis=0))
            seen = slice_actor(slice_of(result.hull, plane))
            words = f"w from {result.hull.w.min():.2f} to {result.hull.w.max():.2f}"
            slices.append(drawing.Panel(f"{angle:.0f} degrees", words, [seen]))
            solid = [drawing.actor(result.boundary, drawing.BLUE)] if len(result.solid.cells) else []
            solids.append(drawing.Panel("", f"{len(result.solid.cells):,} tetrahedra inside", solid))
    plot(degrees, np.array(volumes), energies, plotted)
    drawing.save([*slices, *solids], picture, seen_from=(1, -0.3, 0.1), columns=len(slices))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 11, Path(temporary))
    except (insideout.Error, OSError) as error:
        sys.exit(f"torn_apart.py: {error}")
