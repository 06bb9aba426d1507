# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels side by side in a .png file, for the examples: plain VTK. It needs a display, as xvfb-run's."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple, Optional, Sequence

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPlane, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter

WIDTH, HEIGHT = 800, 900
INK = (0.15, 0.15, 0.18)
BLUE, GREY, RED = (0.45, 0.66, 0.80), (0.86, 0.86, 0.83), (0.85, 0.15, 0.12)
EDGE = (0.12, 0.25, 0.36)


class Panel(NamedTuple):
    title: str
    words: str
    actors: Sequence[vtkActor]
    seen_from: Optional[Sequence[float]] = None
    """A place of its own, from which to see all of its actors; none for the place and the box of the whole picture."""
    up: Optional[Sequence[float]] = None
    """The direction that is up from there; None for the picture's"""


def actor(data: vtkDataSet, colour=GREY, edges: bool = False, width: float = 1.0, opacity: float = 1.0) -> vtkActor:
    """A data set's faces, or its lines, in one color."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(faces_of(data))
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    drawn = vtkActor()
    drawn.SetMapper(mapper)
    look = drawn.GetProperty()
    look.SetColor(*colour)
    look.SetAmbient(0.3)
    look.SetDiffuse(0.7)
    look.SetInterpolationToFlat()
    look.SetOpacity(opacity)
    look.SetLineWidth(width)
    look.SetRenderLinesAsTubes(width > 1)
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(*EDGE)
    return drawn


def coloured(data: vtkDataSet, name: str, values: tuple[float, float], edges: bool = False, of_cells: bool = False) -> vtkActor:
    """By an array of its points, or cells, from blue to red."""
    drawn = actor(data, edges=edges)
    mapper = drawn.GetMapper()
    table = vtkLookupTable()
    table.SetHueRange(2 / 3, 0)
    table.SetSaturationRange(0.75, 0.75)
    table.Build()
    mapper.ScalarVisibilityOn()
    (mapper.SetScalarModeToUseCellFieldData if of_cells else mapper.SetScalarModeToUsePointFieldData)()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(*values)
    mapper.SetInterpolateScalarsBeforeMapping(not of_cells)
    return drawn


def painted(data: vtkDataSet, colours: np.ndarray, of_cells: bool = False) -> vtkActor:
    """Each point, or cell, in a color of its own: red, green and blue from 0 to 255."""
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    array = numpy_to_vtk(np.ascontiguousarray(colours, np.uint8), deep=True)
    array.SetName("Colours")
    (copy.GetCellData() if of_cells else copy.GetPointData()).AddArray(array)
    drawn = actor(copy)
    drawn.GetMapper().ScalarVisibilityOn()
    if of_cells:
        drawn.GetMapper().SetScalarModeToUseCellFieldData()
    else:
        drawn.GetMapper().SetScalarModeToUsePointFieldData()
    drawn.GetMapper().SelectColorArray("Colours")
    return drawn


def faces_of(data: vtkDataSet) -> vtkPolyData:
    if isinstance(data, vtkPolyData):
        return data
    faces = vtkGeometryFilter()
    faces.SetInputData(data)
    faces.Update()
    return faces.GetOutput()


def cut_open(grid: vtkUnstructuredGrid, origin, normal) -> vtkPolyData:
    """The faces of the whole cells that reach behind a plane."""
    plane = vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    extract = vtkExtractGeometry()
    extract.SetInputData(grid)
    extract.SetImplicitFunction(plane)
    extract.ExtractInsideOn()
    extract.ExtractBoundaryCellsOn()
    extract.Update()
    return faces_of(extract.GetOutput())


def warped(grid: vtkUnstructuredGrid, name: str, factor: float) -> vtkDataSet:
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(grid)
    copy.GetPointData().SetActiveVectors(name)
    warp = vtkWarpVector()
    warp.SetInputData(copy)
    warp.SetScaleFactor(factor)
    warp.Update()
    return warp.GetOutput()


def point_array(data: vtkDataSet, name: str) -> np.ndarray:
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def _line(text: str, height: float, size: int, bold: bool) -> vtkTextActor:
    line = vtkTextActor()
    line.SetInput(text)
    look = line.GetTextProperty()
    look.SetColor(*INK)
    look.SetFontSize(size)
    look.SetBold(bold)
    look.SetJustificationToCentered()
    line.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    line.SetPosition(0.5, height)
    return line


def _look_at(renderer: vtkRenderer, bounds: np.ndarray, seen_from, up) -> None:
    """All of a box of points, from this direction, without perspective."""
    toward = np.asarray(seen_from, float) / np.linalg.norm(seen_from)
    across = np.cross(up, toward)
    across /= np.linalg.norm(across)
    upward = np.cross(toward, across)
    corners = np.array([[bounds[k][pick[k]] for k in range(3)] for pick in np.ndindex(2, 2, 2)])
    centre = bounds.mean(axis=1)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + 4 * np.linalg.norm(np.ptp(bounds, axis=1)) * toward))
    camera.SetViewUp(*up)
    camera.SetParallelScale(0.5 * max(np.ptp(corners @ across) * HEIGHT / WIDTH / 0.92, np.ptp(corners @ upward) / 0.78))
    renderer.ResetCameraClippingRange()


def box_of(actors: Sequence[vtkActor]) -> np.ndarray:
    """Low and high of x, y and z."""
    boxes = np.array([one.GetBounds() for one in actors]).reshape(-1, 3, 2)
    return np.stack([boxes[..., 0].min(axis=0), boxes[..., 1].max(axis=0)], axis=1)


def save(panels: Sequence[Panel], picture: Path, seen_from=(1, 0, 0), up=(0, 0, 1), bounds=None, columns: int = 0) -> None:
    """Panels in rows with a number of columns, or in one row, with a common camera unless a panel has its own.

    Bounds, low and high of x, y and z, limit the view; by default everything is shown.
    """
    columns = columns or len(panels)
    rows = -(-len(panels) // columns)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH * columns, HEIGHT * rows)
    bounds = box_of([one for panel in panels for one in panel.actors]) if bounds is None else np.asarray(bounds)
    for k, panel in enumerate(panels):
        row, column = divmod(k, columns)
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.SetViewport(column / columns, 1 - (row + 1) / rows, (column + 1) / columns, 1 - row / rows)
        for one in panel.actors:
            renderer.AddViewProp(one)
        renderer.AddViewProp(_line(panel.title, 0.93, 30, True))
        renderer.AddViewProp(_line(panel.words, 0.04, 22, False))
        if panel.seen_from is not None:
            _look_at(renderer, box_of(panel.actors), panel.seen_from, up if panel.up is None else panel.up)
        else:
            _look_at(renderer, bounds, seen_from, up)
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(picture))
    writer.Write()
