# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture that `insideout.draw` draws, as a program, for it needs a display.

    python3 -m insideout.picture PICTURE.png [--surface CHECKED.vtp LINES.vtp] [--hull HULL.vtu] [--solid SOLID.vtu]
        [--curve CURVE.vtp] [--marks POINTS.vtp] [--up z] [--row] [--quality FIGURES.vtu]

Side by side, seen from the same place: the surface with its defects, as `check` marks and draws them, a
slice of the winding number w through the hull, and the tetrahedra inside, cut open; in a whole row the solid's boundary and
its tetrahedra in slices, too. What is inside is cells of the hull, or a solid that was made of them. Without one of the two its panels are left out. What is up is told (x, y or z) or found (`View`). The last panel is the histogram
of dihedral angles that `check_solid` puts into the field data of a solid. Where the hull is triangles in a plane:
the curve with its defects, w in all of them, and those inside.
"""

from __future__ import annotations

import argparse
import sys
from typing import Any, Mapping, Optional, Tuple, Union

import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkRectf, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkProp, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from .actors import (
    BACKGROUND,
    CROSSING,
    EDGES,
    INK,
    NON_MANIFOLD,
    OPEN,
    SLICES,
    SOLID,
    SOUND,
    TURNED,
    Colour,
    actor,
    behind,
    colour_bar,
    line_actor,
    lines_of,
    outside_of,
    slice_actor,
    slice_of,
    some_slices,
    some_triangles,
    surface_of,
    triangles_of,
    words,
)
from .data import is_flat
from .defects import DEFECTS, PLANAR_DEFECTS
from .files import HARMLESS_WHEN_READING
from .pipeline import Error, run, statistics_of
from .quality import quality_rows, solid_verdict
from .serializing import vtk_array
from .tetrahedralization import inside_cells
from .view import HEIGHT, PANEL_WIDTH, View, ViewFromAbove
from .vtkFiltersInsideOut import vtkSurfaceDefects

DRAWN = {
    "IntersectingPairs": CROSSING,
    "TurnedFacets": TURNED,
    "OpenEdges": OPEN,
    "NonManifoldEdges": NON_MANIFOLD,
    "OpenEnds": OPEN,
    "TJunctions": NON_MANIFOLD,
}
MOST_LINES = 4


def counts(statistics: Mapping[str, float]) -> list[Tuple[str, Colour]]:
    """What was wrong, in the words of the command's summary, and in which colour: what is drawn, then what else fits."""
    kinds = PLANAR_DEFECTS if statistics.get("Dimension", 3) == 2 else DEFECTS
    found = [defect for defect in kinds if statistics.get(defect.statistic, 0) > 0]
    found.sort(key=lambda defect: defect.statistic not in DRAWN)
    lines = [(defect.counted(statistics[defect.statistic]), DRAWN.get(defect.statistic, INK)) for defect in found]
    return lines[:MOST_LINES] or [("nothing wrong", INK)]


def surface_panel(marked: vtkPolyData, edges: vtkPolyData, statistics: Mapping[str, float]) -> list[vtkProp]:
    crossing = vtk_to_numpy(marked.GetCellData().GetArray("SelfIntersections")) > 0
    turned = (vtk_to_numpy(marked.GetCellData().GetArray("Turned")) > 0) & ~crossing
    drawn: list[vtkProp] = [
        actor(some_triangles(marked, ~crossing & ~turned), SOUND),
        actor(some_triangles(marked, crossing), CROSSING),
        actor(some_triangles(marked, turned), TURNED),
    ]
    kinds = ((vtkSurfaceDefects.OPEN_BOUNDARY, OPEN), (vtkSurfaceDefects.NON_MANIFOLD_EDGE, NON_MANIFOLD))
    for kind, colour in kinds:
        drawn.append(line_actor(lines_of(edges, kind), colour, 4))
    lines = [words(text, 0.105 - 0.03 * k, colour) for k, (text, colour) in enumerate(counts(statistics))]
    return [*drawn, words("The surface and its defects", 0.95, size=30, bold=True), *lines]


def slice_panel(hull: vtkUnstructuredGrid, view: View) -> list[vtkProp]:
    title = words("Winding number w, a slice of the hull", 0.95, size=30, bold=True)
    return [slice_actor(slice_of(hull, view.slice_plane())), title, colour_bar()]


def solid_panel(solid: vtkUnstructuredGrid, view: View) -> list[vtkProp]:
    count = f"{solid.GetNumberOfCells():,} tetrahedra"
    title = words("The tetrahedra inside, cut open", 0.95, size=30, bold=True)
    return [actor(behind(solid, view.slice_plane()), SOLID, edge_colour=EDGES), title, words(count, 0.085)]


def boundary_panel(solid: vtkUnstructuredGrid) -> list[vtkProp]:
    boundary = surface_of(solid)
    count = f"{boundary.GetNumberOfCells():,} triangles"
    return [actor(boundary, SOLID), words("The solid's boundary", 0.95, size=30, bold=True), words(count, 0.085)]


def slices_panel(solid: vtkUnstructuredGrid, view: View) -> list[vtkProp]:
    """As a hot dog is cut: every other of equal slices, from left to right."""
    count = f"every other of {2 * SLICES - 1} slices"
    title = words("Its tetrahedra, in slices", 0.95, size=30, bold=True)
    return [actor(some_slices(solid, view.right), SOLID, edge_colour=EDGES), title, words(count, 0.085)]


def curve_panel(curve: vtkPolyData, marks: Optional[vtkPolyData], statistics: Mapping[str, float]) -> list[vtkProp]:
    given = actor(triangles_of(curve), SOUND, edge_colour=INK) if curve.GetNumberOfPolys() else line_actor(curve, INK, 3)
    drawn: list[vtkProp] = [given]
    kinds = (
        (vtkSurfaceDefects.OPEN_END, OPEN),
        (vtkSurfaceDefects.CROSSING, CROSSING),
        (vtkSurfaceDefects.T_JUNCTION, NON_MANIFOLD),
    )
    for kind, colour in kinds if marks else ():
        points = line_actor(lines_of(marks, kind), colour, 1)
        points.GetProperty().SetPointSize(14)
        points.GetProperty().RenderPointsAsSpheresOn()
        drawn.append(points)
    lines = [words(text, 0.105 - 0.03 * k, colour) for k, (text, colour) in enumerate(counts(statistics))]
    return [*drawn, words("The curve and its defects", 0.95, size=30, bold=True), *lines]


def flat_panels(hull: vtkUnstructuredGrid, solid: vtkUnstructuredGrid) -> list[list[vtkProp]]:
    """w and the solid in a plane."""
    return [
        [slice_actor(surface_of(hull)), words("Winding number w", 0.95, size=30, bold=True), colour_bar()],
        [
            actor(surface_of(solid), SOLID, edge_colour=EDGES),
            words("The triangles inside", 0.95, size=30, bold=True),
            words(f"{solid.GetNumberOfCells():,} triangles", 0.085),
        ],
    ]


SHARP_BINS = 2  # of the histogram: up to 10 degrees


def histogram_panel(figures: vtkUnstructuredGrid) -> list[vtkProp]:
    counts = vtk_to_numpy(figures.GetFieldData().GetArray("DihedralAngleHistogram"))
    width = 180 / len(counts)
    chart = vtkChartXY()
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(0.05 * PANEL_WIDTH, 0.27 * HEIGHT, 0.9 * PANEL_WIDTH, 0.62 * HEIGHT))
    chart.SetBarWidthFraction(0.95)
    shares = 100 * counts / max(counts.sum(), 1)
    bins = np.arange(len(counts))
    table, colours = vtkTable(), vtkLookupTable()
    for name, values in (("angle", (bins + 0.5) * width), ("share", shares), ("sharp", 1.0 * (bins < SHARP_BINS))):
        column = vtk_array(values)
        column.SetName(name)
        table.AddColumn(column)
    colours.SetNumberOfTableValues(2)
    colours.SetTableRange(0, 1)
    for k, colour in enumerate((SOLID, CROSSING)):
        colours.SetTableValue(k, *colour)
    bars = chart.AddPlot(vtkChart.BAR)
    bars.SetInputData(table, "angle", "share")
    bars.SelectColorArray("sharp")
    bars.SetLookupTable(colours)
    bars.ScalarVisibilityOn()
    for side, title, least, most in ((vtkAxis.BOTTOM, "degrees", 0, 180), (vtkAxis.LEFT, "% of all angles", 0, 1.1 * shares.max())):
        axis = chart.GetAxis(side)
        axis.SetTitle(title)
        axis.SetBehavior(vtkAxis.FIXED)
        axis.SetRange(least, most)
        axis.GetTitleProperties().SetFontSize(22)
        axis.GetTitleProperties().SetBold(False)
        axis.GetLabelProperties().SetFontSize(18)
    drawn = vtkContextActor()
    drawn.GetScene().AddItem(chart)
    lines = [words(text, 0.2 - 0.033 * k, size=20) for k, text in enumerate(texts_of(figures))]
    return [drawn, words("Dihedral angles of the tetrahedra", 0.95, size=30, bold=True), *lines]


def texts_of(figures: vtkUnstructuredGrid) -> list[str]:
    """How good a solid is, as the command's summary says it."""
    statistics = statistics_of(figures)
    return [solid_verdict(statistics), *(f"{what}: {how_much}" for what, how_much in quality_rows(statistics))]


def render(panels: list[list[vtkProp]], view: Union[View, ViewFromAbove, None], file: str, description: str) -> None:
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
        if view:
            view.apply(renderer)
        window.AddRenderer(renderer)
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(file)
    writer.AddText("Description", description)
    writer.Write()
    if writer.GetErrorCode() != 0:
        raise Error(f"cannot write {file}")


def read(reader: Any, file: str) -> Any:
    reader.SetFileName(file)
    run(reader, harmless=HARMLESS_WHEN_READING)  # figures alone have no points
    return reader.GetOutput()


def solid_of(hull: vtkUnstructuredGrid, options: argparse.Namespace) -> vtkUnstructuredGrid:
    return read(vtkXMLUnstructuredGridReader(), options.solid) if options.solid else inside_cells(hull)


def draw_flat(hull: vtkUnstructuredGrid, options: argparse.Namespace) -> None:
    statistics = statistics_of(hull)
    panels = flat_panels(hull, solid_of(hull, options))
    if options.curve:
        marks = read(vtkXMLPolyDataReader(), options.marks) if options.marks else None
        panels.insert(0, curve_panel(read(vtkXMLPolyDataReader(), options.curve), marks, statistics))
    description = "; ".join(text for text, _ in counts(statistics))
    render(panels, ViewFromAbove(surface_of(hull), options.up), options.picture, description)


def main(options: argparse.Namespace) -> None:
    surface, quality, up = options.surface, options.quality, options.up
    hull = read(vtkXMLUnstructuredGridReader(), options.hull) if options.hull else None
    if hull and is_flat(hull):
        draw_flat(hull, options)
        return
    panels, description = [], ""
    view: Optional[View] = None
    if surface:
        checked, edges = (read(vtkXMLPolyDataReader(), file) for file in surface)
        marked = triangles_of(checked)
        view = View(marked, up)
        # The hull's are those of the run that made it, which may have had options that the check has not.
        statistics = {**statistics_of(checked), **(dict(statistics_of(hull)) if hull else {})}
        panels.append(surface_panel(marked, edges, statistics))
        description = "; ".join(text for text, _ in counts(statistics))
    if hull:
        view = view or View(triangles_of(outside_of(hull)), up)
        solid = solid_of(hull, options)
        panels += [slice_panel(hull, view), solid_panel(solid, view)]
        if options.row:
            panels += [boundary_panel(solid), slices_panel(solid, view)]
    if quality:
        figures = read(vtkXMLUnstructuredGridReader(), quality)
        panels.append(histogram_panel(figures))
        description = "; ".join(([description] if description else []) + texts_of(figures))
    if panels:
        render(panels, view, options.picture, description)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("picture")
    parser.add_argument("--surface", nargs=2)
    parser.add_argument("--hull")
    parser.add_argument("--solid")
    parser.add_argument("--curve")
    parser.add_argument("--marks")
    parser.add_argument("--up", choices="xyz")
    parser.add_argument("--row", action="store_true")
    parser.add_argument("--quality")
    options = parser.parse_args()
    try:
        main(options)
    except Error as error:
        sys.exit(str(error))
