# SPDX-License-Identifier: GPL-3.0-or-later
"""Voxels and signed distances of a surface with holes that crosses itself, without a mesh.

    python3 voxels.py PICTURE.png [SURFACE]

fills a head of Debian's package libcgal-demo with voxels, and says their volume beside that of the solid's tetrahedra. The
picture is a slice: the voxels, how far the surface is, negative inside, and the same by vtkImplicitPolyDataDistance, which
decides by normals. Places where the signs differ are counted, and marked.
"""

import sys
import tempfile
from pathlib import Path

import insideout
import matplotlib
import numpy as np
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend has to be chosen first

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import models  # noqa: E402  of the folder above

MODEL = "mannequin-devil.off"
VOXELS = 100  # along the longest side


def distances_by_vtk(surface, places):
    function = vtkImplicitPolyDataDistance()
    function.SetInput(surface)
    return np.array([function.EvaluateFunction(place) for place in places])


def main(picture, path):
    surface = insideout.check(path).surface  # as VTK holds it
    bounds = np.array(surface.GetBounds()).reshape(3, 2)
    spacing = (bounds[:, 1] - bounds[:, 0]).max() / VOXELS
    inside, origin = insideout.voxels(surface, spacing)
    volume = insideout.tetrahedralize(surface).statistics["Volume"]
    print(f"{np.count_nonzero(inside)} of {inside.size} voxels are inside: {inside.sum() * spacing**3 / volume:.3f} of the solid's volume")

    middle = inside.shape[0] // 2
    rows, columns = np.meshgrid(*(np.arange(size) for size in inside.shape[1:]), indexing="ij")
    places = origin + spacing * np.stack([np.full(rows.shape, middle), rows, columns], axis=-1).reshape(-1, 3)
    distance = insideout.distance(surface, places)
    by_normals = distances_by_vtk(surface, places)
    differ = (distance < 0) != (by_normals < 0)
    print(f"vtkImplicitPolyDataDistance has another sign at {np.count_nonzero(differ)} of {len(places)} places")

    figure, axes = pyplot.subplots(1, 3, figsize=(12, 4.5), constrained_layout=True)
    most = np.abs(distance).max()
    for axis, title, values, colours in (
        (axes[0], "voxels inside", inside[middle], {"cmap": "Blues"}),
        (axes[1], "distance, signed by the winding number", distance, {"cmap": "RdBu", "vmin": -most, "vmax": most}),
        (axes[2], "vtkImplicitPolyDataDistance", by_normals, {"cmap": "RdBu", "vmin": -most, "vmax": most}),
    ):
        axis.imshow(values.reshape(rows.shape).T, origin="lower", **colours)
        axis.set_title(title)
        axis.set_axis_off()
    wrong = differ.reshape(rows.shape)
    axes[2].plot(rows[wrong], columns[wrong], ".", color="black", markersize=2)
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as folder:
            main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else models.unpacked(MODEL, Path(folder)))
    except (insideout.Error, OSError) as error:
        sys.exit(f"voxels.py: {error}")
