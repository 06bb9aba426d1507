# SPDX-License-Identifier: GPL-3.0-or-later
"""The inside of a scan (points with normals, without triangles), and a surface of it.

    xvfb-run python3 point_cloud.py PICTURE.png [CLOUD]

asks a cloud of Debian's package libcgal-demo for its winding number in an image, by vtkProbeWindingNumber, and draws
the isosurface at 1/2 by vtkFlyingEdges3D. It prints the volume inside, the distances of the cloud's points from the
isosurface, and whether that is closed. CLOUD is a text file of lines x y z nx ny nz (.xyz, .pwn), or a file that
insideout reads. The picture is the points, a slice of the winding number, and the isosurface.
"""

import sys
import tempfile
from pathlib import Path

import insideout
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkImagingCore import vtkExtractVOI

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import drawing  # noqa: E402  of the folder above
import models  # noqa: E402

MODEL = "kitten.xyz"
VOXELS = 100  # along the longest side


def read(path):
    if Path(path).suffix not in (".xyz", ".pwn"):
        return insideout.surfaces.as_surface(path)[0]
    table = np.loadtxt(path)
    return insideout.point_cloud(table[:, :3], table[:, 3:6])


def image_around(cloud):
    low, high = np.array(cloud.GetBounds()).reshape(3, 2).T
    spacing = (high - low).max() / VOXELS
    image = vtkImageData()
    image.SetDimensions(*(int(size) + 8 for size in np.ceil((high - low) / spacing)))
    image.SetOrigin(low - 3.5 * spacing)
    image.SetSpacing(spacing, spacing, spacing)
    return image


def dots(cloud):
    vertices = vtkVertexGlyphFilter()
    vertices.SetInputData(cloud)
    vertices.Update()
    drawn = drawing.actor(vertices.GetOutput(), drawing.EDGE)
    drawn.GetProperty().SetPointSize(4)
    return drawn


def main(picture, path):
    cloud = read(path)
    probe = insideout.vtkProbeWindingNumber()
    probe.SetInputData(image_around(cloud))
    probe.SetSurfaceData(cloud)
    for warning in insideout.pipeline.run(probe):
        print(warning)
    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(probe.GetOutputPort())
    contour.SetInputArrayToProcess(0, 0, 0, 0, "w")
    contour.SetValue(0, 0.5)
    contour.Update()
    surface = contour.GetOutput()
    checked = insideout.check(surface)

    image = probe.GetOutput()
    spacing = image.GetSpacing()[0]
    volume = vtk_to_numpy(image.GetPointData().GetArray("Inside")).sum() * spacing**3
    away = abs(insideout.distance(surface, cloud))
    print(
        f"{cloud.GetNumberOfPoints()} points; volume inside {volume:.4g}; isosurface of {surface.GetNumberOfPolys()} triangles with "
        f"{checked.statistics['OpenEdges']:g} open edges; points are {np.median(away) / spacing:.2f} voxels from it, at most {away.max() / spacing:.2f}"
    )

    cut = vtkExtractVOI()
    cut.SetInputData(image)
    middle = image.GetDimensions()[2] // 2
    cut.SetVOI(*image.GetExtent()[:4], middle, middle)
    cut.Update()
    drawing.save(
        [
            drawing.Panel("a scan", f"{cloud.GetNumberOfPoints()} points with normals", [dots(cloud)]),
            drawing.Panel("its winding number", "on a slice, from -0.1 to 1.1", [drawing.coloured(cut.GetOutput(), "w", (-0.1, 1.1))]),
            drawing.Panel("where it is 1/2", f"{surface.GetNumberOfPolys()} triangles", [drawing.actor(surface, drawing.BLUE)]),
        ],
        picture,
        seen_from=(0.4, 0.3, 1),
        up=(0, 1, 0),
    )


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    try:
        with tempfile.TemporaryDirectory() as folder:
            main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else models.unpacked(MODEL, Path(folder), "points_3"))
    except (insideout.Error, OSError) as error:
        sys.exit(f"point_cloud.py: {error}")
