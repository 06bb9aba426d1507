# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture that `insideout.draw` draws, as a program, for it needs a display.

    python3 -m insideout.picture SURFACE.vtp HULL.vtu PICTURE.png

Side by side, seen from the same place: the surface with its defects, a slice of the winding number w
through the hull, and the tetrahedra inside, cut open.
"""

from __future__ import annotations

import sys
from typing import Optional, Tuple

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPlane, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkCutter, vtkThreshold, vtkTriangleFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkProp,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

from .data import as_surface, corners_of, make_cells
from .pipeline import Error, run, statistics_of
from .tetrahedralization import inside_cells
from .vtkFiltersInsideOut import vtkSurfaceDefects

PANEL_WIDTH, HEIGHT = 800, 900
WIDTH_USED, HEIGHT_USED = 0.92, 0.77  # of a panel; the rest is for words
Colour = Tuple[float, float, float]
BACKGROUND: Colour = (1.0, 1.0, 1.0)
INK: Colour = (0.15, 0.15, 0.18)
SOUND: Colour = (0.86, 0.86, 0.83)
CROSSING: Colour = (0.90, 0.20, 0.15)
TURNED: Colour = (0.10, 0.30, 0.85)
OPEN: Colour = (0.50, 0.05, 0.05)
NON_MANIFOLD: Colour = (0.50, 0.15, 0.65)
SOLID: Colour = (0.45, 0.66, 0.80)


# --- What is seen ---


def some_triangles(surface: vtkPolyData, chosen: NDArray[np.bool_]) -> vtkPolyData:
    part = vtkPolyData()
    part.SetPoints(surface.GetPoints())
    part.SetPolys(make_cells(corners_of(surface.GetPolys(), 3)[chosen]))
    return part


def lines_of(lines: vtkPolyData, kind: int) -> vtkPolyData:
    """Those of one DefectType."""
    threshold = vtkThreshold()
    threshold.SetInputData(lines)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "DefectType")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    threshold.SetLowerThreshold(kind)
    threshold.SetUpperThreshold(kind)
    polylines = vtkGeometryFilter()
    polylines.SetInputConnection(threshold.GetOutputPort())
    polylines.Update()
    return polylines.GetOutput()


def slice_of(hull: vtkUnstructuredGrid, plane: vtkPlane) -> vtkPolyData:
    cutter = vtkCutter()
    cutter.SetInputData(hull)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.Update()
    return cutter.GetOutput()


def behind(grid: vtkUnstructuredGrid, plane: vtkPlane) -> vtkPolyData:
    """The faces of the cells that reach behind the plane: all that lie wholly before it are taken away."""
    extract = vtkExtractGeometry()
    extract.SetInputData(grid)
    extract.SetImplicitFunction(plane)
    extract.ExtractInsideOn()
    extract.ExtractBoundaryCellsOn()
    faces = vtkGeometryFilter()
    faces.SetInputConnection(extract.GetOutputPort())
    faces.Update()
    return faces.GetOutput()


# --- From where ---


class View:
    """Where a surface is seen from: its shortest extent runs to the eye; z is up, or y where z is shortest."""

    def __init__(self, surface: vtkPolyData):
        bounds = np.array(surface.GetBounds()).reshape(3, 2)
        size = bounds[:, 1] - bounds[:, 0]
        self.centre = bounds.mean(axis=1)
        axes = np.eye(3)
        shortest = int(np.argmin(size))
        self.slice_normal = axes[shortest] * (-1 if shortest == 1 else 1)  # x runs to the right then
        self.up = axes[1 if shortest == 2 else 2]
        self.right = np.cross(self.up, self.slice_normal)
        # A little from the side and from above, so that depth is seen.
        eye = self.slice_normal + 0.35 * self.right + 0.25 * self.up
        self.eye = eye / np.linalg.norm(eye)
        self.distance = 4 * float(np.linalg.norm(size))
        self.size = self._size_on_screen(bounds)

    def _size_on_screen(self, bounds: NDArray[np.float64]) -> tuple[float, float]:
        across = np.cross(self.up, self.eye)
        across /= np.linalg.norm(across)
        down = np.cross(across, self.eye)
        corners = np.array([[bounds[i, b] for i, b in enumerate(pick)] for pick in np.ndindex(2, 2, 2)])
        return float(np.ptp(corners @ across)), float(np.ptp(corners @ down))

    def slice_plane(self) -> vtkPlane:
        plane = vtkPlane()
        plane.SetOrigin(*self.centre)
        plane.SetNormal(*self.slice_normal)
        return plane

    def apply(self, renderer: vtkRenderer) -> None:
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*self.centre)
        camera.SetPosition(*(self.centre + self.distance * self.eye))
        camera.SetViewUp(*self.up)
        width, height = self.size
        camera.SetParallelScale(0.5 * max(width * HEIGHT / PANEL_WIDTH / WIDTH_USED, height / HEIGHT_USED))
        renderer.ResetCameraClippingRange()


# --- How it is drawn ---


def actor(
    data: vtkPolyData, colour: Colour, edge_colour: Optional[Colour] = None, width: float = 1.0
) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    drawn = vtkActor()
    drawn.SetMapper(mapper)
    look = drawn.GetProperty()
    look.SetColor(*colour)
    look.SetAmbient(0.32)
    look.SetDiffuse(0.70)
    look.SetInterpolationToFlat()
    look.SetLineWidth(width)
    if edge_colour:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(*edge_colour)
    return drawn


def line_actor(data: vtkPolyData, colour: Colour, width: float) -> vtkActor:
    drawn = actor(data, colour, width=width)
    drawn.GetProperty().LightingOff()
    drawn.GetProperty().RenderLinesAsTubesOn()
    return drawn


def slice_actor(data: vtkPolyData) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("w")
    mapper.SetLookupTable(colours_of_w())
    mapper.InterpolateScalarsBeforeMappingOff()
    drawn = vtkActor()
    drawn.SetMapper(mapper)
    drawn.GetProperty().LightingOff()
    return drawn


def colours_of_w() -> vtkColorTransferFunction:
    """Blue outside, white where w is 1/2, red inside; beyond -1 and 2 nothing changes any more."""
    colours = vtkColorTransferFunction()
    colours.SetColorSpaceToLab()
    for w, colour in (
        (-1.0, (0.09, 0.17, 0.36)),
        (0.0, (0.38, 0.58, 0.80)),
        (0.5, (0.97, 0.97, 0.95)),
        (1.0, (0.85, 0.44, 0.32)),
        (2.0, (0.40, 0.02, 0.10)),
    ):
        colours.AddRGBPoint(w, *colour)
    return colours


def colour_bar() -> vtkScalarBarActor:
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours_of_w())
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(7)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    bar.GetLabelTextProperty().SetColor(*INK)
    bar.GetLabelTextProperty().SetFontSize(20)
    bar.GetLabelTextProperty().ShadowOff()
    bar.GetLabelTextProperty().ItalicOff()
    bar.GetLabelTextProperty().BoldOff()
    bar.SetPosition(0.2, 0.015)
    bar.SetWidth(0.6)
    bar.SetHeight(0.07)
    return bar


def words(text: str, height: float, colour: Colour = INK, size: int = 24, bold: bool = False) -> vtkTextActor:
    """A line in the middle of a panel, at this height of it (0 to 1)."""
    line = vtkTextActor()
    line.SetInput(text)
    look = line.GetTextProperty()
    look.SetColor(*colour)
    look.SetFontSize(size)
    look.SetBold(bold)
    look.SetJustificationToCentered()
    look.SetVerticalJustificationToCentered()
    line.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    line.SetPosition(0.5, height)
    return line


# --- The panels ---


def surface_panel(surface: vtkPolyData) -> list[vtkProp]:
    marker = vtkSurfaceDefects()
    marker.SetInputData(surface)
    run(marker)
    triangles = vtkTriangleFilter()
    triangles.SetInputData(marker.GetOutput())
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    marked = triangles.GetOutput()
    crossing = vtk_to_numpy(marked.GetCellData().GetArray("SelfIntersections")) > 0
    turned = (vtk_to_numpy(marked.GetCellData().GetArray("Turned")) > 0) & ~crossing
    drawn: list[vtkProp] = [
        actor(some_triangles(marked, ~crossing & ~turned), SOUND),
        actor(some_triangles(marked, crossing), CROSSING),
        actor(some_triangles(marked, turned), TURNED),
    ]
    for kind, colour in ((marker.OPEN_BOUNDARY, OPEN), (marker.NON_MANIFOLD_EDGE, NON_MANIFOLD)):
        drawn.append(line_actor(lines_of(marker.GetLines(), kind), colour, 4))
    statistics = statistics_of(marker.GetOutput())
    found = [
        (f"{int(statistics[count]):,} {what}", colour)
        for count, what, colour in (
            ("IntersectingFacets", "facets that cross others", CROSSING),
            ("TurnedFacets", "facets that face the wrong way", TURNED),
            ("OpenEdges", "open edges", OPEN),
            ("NonManifoldEdges", "non-manifold edges", NON_MANIFOLD),
        )
        if statistics[count] > 0
    ] or [("nothing wrong", INK)]
    lines = [words(text, 0.105 - 0.03 * k, colour) for k, (text, colour) in enumerate(found)]
    return [*drawn, words("The surface and its defects", 0.95, size=30, bold=True), *lines]


def slice_panel(hull: vtkUnstructuredGrid, view: View) -> list[vtkProp]:
    title = words("Winding number w, a slice of the hull", 0.95, size=30, bold=True)
    return [slice_actor(slice_of(hull, view.slice_plane())), title, colour_bar()]


def solid_panel(hull: vtkUnstructuredGrid, view: View) -> list[vtkProp]:
    solid = inside_cells(hull)
    count = f"{solid.GetNumberOfCells():,} tetrahedra"
    title = words("The tetrahedra inside, cut open", 0.95, size=30, bold=True)
    return [actor(behind(solid, view.slice_plane()), SOLID, edge_colour=(0.12, 0.25, 0.36)), title, words(count, 0.085)]


def render(panels: list[list[vtkProp]], view: View, file: str) -> None:
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(PANEL_WIDTH * len(panels), HEIGHT)
    for k, panel in enumerate(panels):
        renderer = vtkRenderer()
        renderer.SetBackground(*BACKGROUND)
        renderer.SetViewport(k / len(panels), 0, (k + 1) / len(panels), 1)
        for prop in panel:
            renderer.AddViewProp(prop)
        view.apply(renderer)
        window.AddRenderer(renderer)
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()
    if writer.GetErrorCode() != 0:
        raise Error(f"cannot write {file}")


def main(surface_file: str, hull_file: str, picture_file: str) -> None:
    surface, _ = as_surface(surface_file)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(hull_file)
    run(reader)
    hull = reader.GetOutput()
    view = View(surface)
    render([surface_panel(surface), slice_panel(hull, view), solid_panel(hull, view)], view, picture_file)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except Error as error:
        sys.exit(str(error))
