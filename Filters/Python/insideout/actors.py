# SPDX-License-Identifier: GPL-3.0-or-later
"""What pictures show: parts of data sets, and actors that draw them."""

from __future__ import annotations

from typing import Optional, Tuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPlane, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkCutter, vtkThreshold, vtkTriangleFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkProperty

from .data import corners_of
from .serializing import make_cells, vtk_array
from .tetrahedralization import inside_cells

Colour = Tuple[float, float, float]
BACKGROUND: Colour = (1.0, 1.0, 1.0)
INK: Colour = (0.15, 0.15, 0.18)
SOUND: Colour = (0.86, 0.86, 0.83)
FACET_EDGES: Colour = (0.68, 0.68, 0.66)

# Colors that color-blind readers can distinguish, by M. Okabe and K. Ito (2008).
CROSSING: Colour = (0.835, 0.369, 0.000)  # vermilion
TURNED: Colour = (0.337, 0.706, 0.914)  # sky blue
OPEN: Colour = (0.000, 0.447, 0.698)  # blue
NON_MANIFOLD: Colour = (0.800, 0.475, 0.655)  # reddish purple
INCONSISTENT: Colour = (0.000, 0.620, 0.451)  # bluish green
DUPLICATE: Colour = (0.902, 0.624, 0.000)  # orange

CROSSING_FACETS: Colour = (0.980, 0.800, 0.659)
"""A light shade, on which the curves stand out. All of these are the DefectColor of vtkSurfaceDefects, too."""

SOLID: Colour = (0.45, 0.66, 0.80)
EDGES: Colour = (0.12, 0.25, 0.36)
NEARER = (-4, -40)  # factor and units of the offset of lines, as of glPolygonOffset
WITHIN = 0.72  # brightness of the inner side of facets, relative to the outer one
SLICES = 6  # slices of a solid, with gaps of the same width between them


def some_triangles(surface: vtkPolyData, chosen: NDArray[np.bool_]) -> vtkPolyData:
    part = vtkPolyData()
    part.SetPoints(surface.GetPoints())
    part.SetPolys(make_cells(corners_of(surface.GetPolys(), 3)[chosen]))
    return part


def triangles_of(surface: vtkPolyData) -> vtkPolyData:
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    return triangles.GetOutput()


def surface_of(grid: vtkUnstructuredGrid) -> vtkPolyData:
    """The faces of tetrahedra (those of second order with straight edges), or cells in a plane as polygons."""
    faces = vtkGeometryFilter()
    faces.SetInputData(grid)
    faces.SetNonlinearSubdivisionLevel(0)
    faces.Update()
    return faces.GetOutput()


def outside_of(hull: vtkUnstructuredGrid) -> vtkPolyData:
    """The boundary of the tetrahedra inside, or of all if none is inside."""
    solid = inside_cells(hull)
    return surface_of(solid if solid.GetNumberOfCells() else hull)


def lines_of(lines: vtkPolyData, kind: int) -> vtkPolyData:
    """The lines of one DefectType."""
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
    """The faces of the cells that reach behind the plane: cells entirely in front of it are removed."""
    extract = vtkExtractGeometry()
    extract.SetInputData(grid)
    extract.SetImplicitFunction(plane)
    extract.ExtractInsideOn()
    extract.ExtractBoundaryCellsOn()
    extract.Update()
    return surface_of(extract.GetOutput())


def some_slices(solid: vtkUnstructuredGrid, along: NDArray[np.float64]) -> vtkPolyData:
    """The faces of the cells in every second slice along a direction."""
    if solid.GetNumberOfCells() == 0:
        return vtkPolyData()
    points = vtk_to_numpy(solid.GetPoints().GetData())
    places = points[corners_of(solid.GetCells(), solid.GetCells().GetMaxCellSize())].mean(axis=1) @ along
    share = (places - places.min()) / max(np.ptp(places), np.finfo(float).tiny)
    chosen = vtkUnstructuredGrid()
    chosen.CopyStructure(solid)
    kept = vtk_array((share * (2 * SLICES - 1)).astype(np.int32) % 2)
    kept.SetName("Slice")
    chosen.GetCellData().AddArray(kept)
    threshold = vtkThreshold()
    threshold.SetInputData(chosen)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Slice")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_LOWER)
    threshold.SetLowerThreshold(0.5)
    threshold.Update()
    return surface_of(threshold.GetOutput())


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


def darken_inside(drawn: vtkActor) -> None:
    """Distinguish the inner side of facets from the outer one, visible through holes."""
    inside = vtkProperty()
    inside.DeepCopy(drawn.GetProperty())
    inside.SetColor(*(WITHIN * part for part in drawn.GetProperty().GetColor()))
    drawn.SetBackfaceProperty(inside)


def nearer(drawn: vtkActor) -> None:
    """Draw it on top of facets at the same place."""
    drawn.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -1)


def dot(point: NDArray[np.float64], colour: Colour = INK) -> vtkActor:
    """A point."""
    points = vtkPoints()
    points.InsertNextPoint(*point)
    vertex = vtkCellArray()
    vertex.InsertNextCell(1, (0,))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(vertex)
    return line_actor(data, colour, 5)


def line_actor(data: vtkPolyData, colour: Colour, width: float, opacity: float = 1.0) -> vtkActor:
    """Lines, and vertices as dots, drawn on top of the faces that they lie on."""
    drawn = actor(data, colour, width=width)
    drawn.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(*NEARER)
    drawn.GetMapper().SetRelativeCoincidentTopologyPointOffsetParameter(NEARER[1])
    look = drawn.GetProperty()
    look.LightingOff()
    look.SetOpacity(opacity)
    look.SetPointSize(2 * width)
    look.RenderPointsAsSpheresOn()
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
    """Blue outside, white where w is 1/2, red inside; constant below -1 and above 2."""
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
