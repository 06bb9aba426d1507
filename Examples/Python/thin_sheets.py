# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure with a cape and a hat, both mere sheets: what the hard constraints do.

    xvfb-run -a python3 thin_sheets.py PICTURE.png

The body and the head are closed; the hat is an open hemisphere and the cape an open sheet, without
thickness. Four times the solid's boundary: as the energy has it, with every facet kept
(ConstrainFacets), made a manifold (NonManifold), and both. Facets that are no part of the
solid are drawn red, edges of its boundary that are not manifold black.
"""

import sys

import insideout
import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

PANEL, HEIGHT = 560, 900
INK = (0.15, 0.15, 0.18)
BODY, HAT, CAPE, CLOSED = (222, 196, 168), (70, 96, 140), (176, 132, 60), (205, 205, 200)
LEFT_OUT = (0.85, 0.15, 0.12)
CHOICES = (
    ("The minimum of the energy", {}),
    ("constrain_facets", {"constrain_facets": True}),
    ("non_manifold", {"non_manifold": "fill"}),
    ("both", {"constrain_facets": True, "non_manifold": "fill"}),
)


def grid_surface(function, columns, rows):
    """Points of a function of (u, v) in [0, 1]^2 and the triangles between them."""
    u, v = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1))
    points = np.stack(function(u.ravel(), v.ravel()), axis=1)
    a = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    b, c, d = a + 1, a + columns + 1, a + columns + 2
    return points, np.concatenate([np.stack([a, b, d], axis=1), np.stack([a, d, c], axis=1)])


def ball(centre, radii, polar_end=1.0, columns=40, rows=24):
    """An ellipsoid, from its top to a part of the way down; outward."""

    def place(u, v):
        azimuth, polar = 2 * np.pi * (u % 1), np.pi * polar_end * v
        return (
            centre[0] + radii[0] * np.sin(polar) * np.sin(azimuth),
            centre[1] + radii[1] * np.sin(polar) * np.cos(azimuth),
            centre[2] + radii[2] * np.cos(polar),
        )

    points, triangles = grid_surface(place, columns, rows)
    points[: columns + 1] = points[0]  # exactly one point at the pole
    if polar_end == 1.0:
        points[-columns - 1 :] = points[-1]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    proper = np.any(a != b, axis=1) & np.any(b != c, axis=1) & np.any(c != a, axis=1)
    return points, triangles[proper]


def cape(columns=36, rows=26):
    """Around the back from the shoulders down, farther from the body below, with folds."""

    def place(u, v):
        angle, z = 1.35 * (2 * u - 1), 0.52 - 1.16 * v
        width = np.maximum(np.sqrt(1 - (z / 0.75) ** 2), np.where(z < 0, 0.86, 0))
        away = 0.035 + 0.14 * v**2 + 0.03 * v * np.cos(10 * np.pi * u)
        return (0.42 * width + away) * np.sin(angle), -(0.30 * width + away) * np.cos(angle), z

    points, triangles = grid_surface(place, columns, rows)
    return points, triangles[:, [0, 2, 1]]  # facing away from the body: between the two w is larger


def figure():
    """Body, head, hat and cape in one surface, with the cell array Part (0 body and head, 1 hat, 2 cape)."""
    parts = [
        (ball((0, 0, 0), (0.42, 0.30, 0.75)), 0),
        (ball((0, 0.02, 1.0), (0.27, 0.28, 0.33)), 0),
        (ball((0, 0.0, 1.12), (0.40, 0.40, 0.42), 0.52), 1),
        (cape(), 2),
    ]
    points, triangles, part = [], [], []
    for (its_points, its_triangles), number in parts:
        triangles.append(its_triangles + sum(len(p) for p in points))
        points.append(its_points)
        part += [number] * len(its_triangles)
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.concatenate(points), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.concatenate(triangles).ravel().astype(np.int64), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    array = numpy_to_vtk(np.array(part, np.uint8), deep=True)
    array.SetName("Part")
    surface.GetCellData().AddArray(array)
    return surface


def colored(boundary, surface):
    """Each face of the boundary in the color of the part that it lies on, or that of a closed hole."""
    part = vtk_to_numpy(surface.GetCellData().GetArray("Part"))
    ids = vtk_to_numpy(boundary.GetCellData().GetArray("vtkOriginalCellIds"))
    colors = np.array([BODY, HAT, CAPE, CLOSED], np.uint8)[np.where(ids < 0, 3, part[ids])]
    array = numpy_to_vtk(colors, deep=True)
    array.SetName("Color")
    drawn = vtkPolyData()
    drawn.ShallowCopy(boundary)
    drawn.GetCellData().SetScalars(array)
    return drawn


def edges_that_are_not_manifold(boundary):
    edges = vtkFeatureEdges()
    edges.SetInputData(boundary)
    edges.BoundaryEdgesOff()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOn()
    edges.ColoringOff()
    edges.Update()
    return edges.GetOutput()


def actor(data, color=None, opacity=1.0, width=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(color is None)
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    drawn = vtkActor()
    drawn.SetMapper(mapper)
    look = drawn.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.3)
    look.SetDiffuse(0.75)
    look.SetOpacity(opacity)
    look.SetLineWidth(width)
    if color is not None:
        look.SetColor(*color)
        if width > 1:
            look.LightingOff()
            look.RenderLinesAsTubesOn()
    return drawn


def words(renderer, text, size, height):
    label = vtkTextActor()
    label.SetInput(text)
    look = label.GetTextProperty()
    look.SetFontSize(size)
    look.SetColor(*INK)
    look.SetJustificationToCentered()
    label.SetPosition(PANEL / 2, height)
    renderer.AddViewProp(label)


def panel(surface, title, options):
    result = insideout.tetrahedralize(surface, **options)
    boundary = colored(result.boundary, surface)
    edges = edges_that_are_not_manifold(boundary)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor(boundary))
    if result.outliers.GetNumberOfCells() > 0:
        renderer.AddActor(actor(result.outliers, LEFT_OUT, opacity=0.35))
    if edges.GetNumberOfCells() > 0:
        renderer.AddActor(actor(edges, (0, 0, 0), width=4))
    figures = result.statistics
    words(renderer, title, 26, HEIGHT - 50)
    words(
        renderer,
        f"{figures['OutlierFacets']} facets left out, {edges.GetNumberOfCells()} edges not manifold\n"
        f"energy {figures['Energy']:.0f}, {figures['ChangedCells']} cells changed",
        19,
        24,
    )
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, -0.05, 0.40)
    camera.SetPosition(-4.2, -3.9, 1.7)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(27.5)
    renderer.ResetCameraClippingRange()
    return renderer, figures, edges.GetNumberOfCells()


def main(picture):
    surface = figure()
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(PANEL * len(CHOICES), HEIGHT)
    kept = True
    for i, (title, options) in enumerate(CHOICES):
        renderer, figures, bad_edges = panel(surface, title, options)
        renderer.SetViewport(i / len(CHOICES), 0, (i + 1) / len(CHOICES), 1)
        window.AddRenderer(renderer)
        print(f"{title}: {figures['OutlierFacets']} facets left out, {bad_edges} edges not manifold")
        kept = kept and (figures["OutlierFacets"] == 0 or "constrain_facets" not in options)
        kept = kept and (bad_edges == 0 or "non_manifold" not in options)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
    return kept


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if not main(sys.argv[1]):
        sys.exit("a constraint was not kept")
    print("every constraint was kept")
