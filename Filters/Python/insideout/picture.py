# SPDX-License-Identifier: GPL-3.0-or-later
"""The program that draws the pictures of `insideout.draw`; it needs a display.

    python3 -m insideout.picture PICTURE.png [--surface CHECKED.vtp LINES.vtp] [--hull HULL.vtu] [--solid SOLID.vtu]
        [--curve CURVE.vtp] [--marks POINTS.vtp] [--up z] [--row] [--quality FIGURES.vtu]

Side by side, seen from the same place: the surface with its defects, as `check` marks and draws them, a slice of the
winding number w through the hull, and the tetrahedra inside, cut open; in a whole row the solid's boundary and its
tetrahedra in slices, too. The inside is cells of the hull, or a solid made of these. Without a hull: the surface from
two sides, and a legend of all that is wrong. The up direction is given (x, y or z) or found (`View`). The last panel is
the histogram of dihedral angles that `check_solid` puts into the field data of a solid. Where the hull is triangles in
a plane: the curve with its defects, w in all of them, and those inside.
"""

from __future__ import annotations

import argparse
import sys
from typing import Any, Optional

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkLightKit, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from .actors import BACKGROUND, outside_of, surface_of, triangles_of
from .data import is_flat
from .files import HARMLESS_WHEN_READING, are_lines
from .histogram import histogram_panel, texts_of
from .legend import beneath, counts, whole_legend
from .pipeline import Error, run, statistics_of
from .scenes import AnyView, Panel, boundary_panel, curve_panel, defect_panels, flat_panels, slice_panel, slices_panel, solid_panel, surface_panel
from .tetrahedralization import inside_cells
from .view import HEIGHT, PANEL_WIDTH, View, ViewFromAbove


def lights() -> vtkLightKit:
    """White lights from several sides, so that no side is dark."""
    kit = vtkLightKit()
    kit.SetKeyLightWarmth(0.5)
    kit.SetFillLightWarmth(0.5)
    kit.SetBackLightWarmth(0.5)
    kit.SetHeadLightWarmth(0.5)
    kit.SetKeyLightIntensity(0.9)
    kit.SetKeyLightAngle(40, 30)  # from above and from the right
    return kit


def render(panels: list[Panel], view: Optional[AnyView], file: str, description: str) -> None:
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetNumberOfLayers(2)
    window.SetSize(PANEL_WIDTH * len(panels), HEIGHT)
    for k, panel in enumerate(panels):
        renderer, above = vtkRenderer(), vtkRenderer()
        renderer.SetBackground(*BACKGROUND)
        above.SetLayer(1)
        for each, props in ((renderer, panel.props), (above, panel.over)):
            each.SetViewport(k / len(panels), 0, (k + 1) / len(panels), 1)
            for prop in props:
                each.AddViewProp(prop)
            window.AddRenderer(each)
        lights().AddLightsToRenderer(renderer)
        seen_from = panel.view or view
        if seen_from:
            seen_from.apply(renderer)
        above.SetActiveCamera(renderer.GetActiveCamera())
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
    run(reader, harmless=HARMLESS_WHEN_READING)  # a histogram alone has no points
    return reader.GetOutput()


def solid_of(hull: vtkUnstructuredGrid, options: argparse.Namespace) -> vtkUnstructuredGrid:
    return read(vtkXMLUnstructuredGridReader(), options.solid) if options.solid else inside_cells(hull)


def told(statistics: dict[str, float]) -> str:
    """The defects, for the file's description."""
    return "; ".join(row.text for row in counts(statistics))


def draw_curve(curve: vtkPolyData, marks: vtkPolyData, options: argparse.Namespace) -> None:
    """The defects of lines in a plane."""
    statistics = statistics_of(curve)
    panels = [curve_panel(curve, marks), Panel(whole_legend(statistics))]
    render(panels, ViewFromAbove(curve, options.up), options.picture, told(statistics))


def draw_flat(hull: vtkUnstructuredGrid, options: argparse.Namespace) -> None:
    statistics = statistics_of(hull)
    panels = flat_panels(hull, solid_of(hull, options))
    if options.curve:
        marks = read(vtkXMLPolyDataReader(), options.marks) if options.marks else None
        panels.insert(0, curve_panel(read(vtkXMLPolyDataReader(), options.curve), marks, beneath(statistics)))
    description = told(statistics)
    render(panels, ViewFromAbove(surface_of(hull), options.up), options.picture, description)


def main(options: argparse.Namespace) -> None:
    surface, quality, up = options.surface, options.quality, options.up
    hull = read(vtkXMLUnstructuredGridReader(), options.hull) if options.hull else None
    if hull and is_flat(hull):
        draw_flat(hull, options)
        return
    panels: list[Panel] = []
    description = ""
    view: Optional[View] = None
    if surface:
        checked, lines = (read(vtkXMLPolyDataReader(), file) for file in surface)
        if are_lines(checked):
            draw_curve(checked, lines, options)
            return
        marked = triangles_of(checked)
        view = View(marked, up)
        # The hull's statistics are those of the run that made it, whose options the check may lack.
        statistics = {**statistics_of(checked), **(dict(statistics_of(hull)) if hull else {})}
        panels += [surface_panel(marked, lines, statistics)] if hull else defect_panels(marked, lines, statistics, view)
        description = told(statistics)
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
