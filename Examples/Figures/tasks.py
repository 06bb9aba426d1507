# SPDX-License-Identifier: GPL-3.0-or-later
"""Small pictures of the first page's six tasks, and of the treatments of a surface, by the demo's surfaces, in the colors of the
plugin and of `insideout draw`.

    xvfb-run -a python3 tasks.py FOLDER
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import insideout
import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from insideout import demo
from insideout.actors import BACKGROUND, CROSSING, EDGES, FACET_EDGES, OPEN, SOLID, SOUND, actor, behind, colours_of_w, nearer, some_triangles
from insideout.scenes import defect_lines, marked_facets
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

WIDTH, HEIGHT = 300, 240  # of a panel
FRONT, CORNER = (0.25, -1, 0.2), (-1, -0.9, 0.7)
STEP = 17
"""The distance between the colors of a picture: few colors make small files."""
LENGTH = 0.3
"""The edge length in the picture of the three treatments."""


def save(panels: Sequence[Sequence[vtkActor]], picture: Path, seen_from=FRONT, share: float = 1) -> None:
    """Panels side by side, of this share of the usual size."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(round(share * WIDTH) * len(panels), round(share * HEIGHT))
    for k, props in enumerate(panels):
        renderer = vtkRenderer()
        renderer.SetBackground(*BACKGROUND)
        renderer.SetViewport(k / len(panels), 0, (k + 1) / len(panels), 1)
        for prop in props:
            renderer.AddViewProp(prop)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(*seen_from)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCamera()
        camera.Zoom(1.45 if seen_from != CORNER else 1.1)
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.Update()
    pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
    pixels[:] = np.round(pixels / STEP) * STEP
    writer = vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetInputData(image.GetOutput())
    writer.SetFileName(str(picture))
    writer.Write()


def half(normal: Sequence[float], origin: Sequence[float] = (0, 0, 0)) -> vtkPlane:
    plane = vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    return plane


def cut_open(grid: vtkUnstructuredGrid, colour=SOLID, plane: vtkPlane = half((0, -1, 0))) -> vtkActor:
    return actor(behind(grid, plane), colour, edge_colour=EDGES)


def region_of(grid: vtkUnstructuredGrid, region: int) -> vtkUnstructuredGrid:
    cells = vtkThreshold()
    cells.SetInputData(grid)
    cells.SetInputArrayToProcess(0, 0, 0, 1, "RegionId")
    cells.SetLowerThreshold(region)
    cells.SetUpperThreshold(region)
    cells.Update()
    return cells.GetOutput()


def to_print() -> list[vtkActor]:
    return [actor(insideout.boolean([demo.figure()]).surface, SOUND, edge_colour=FACET_EDGES)]


def for_a_solver() -> list[vtkActor]:
    """A part with its clamp and its load."""
    made = insideout.tetrahedralize(demo.bracket(), edge_length=8, surface_treatment="split")
    drawn = [actor(made.boundary, SOLID, edge_colour=EDGES)]
    for tag, colour in (("clamp", OPEN), ("load", CROSSING)):
        chosen = np.zeros(made.boundary.GetNumberOfCells(), bool)
        chosen[made.tags[tag]] = True
        drawn.append(actor(some_triangles(made.boundary, chosen), colour, edge_colour=EDGES))
        nearer(drawn[-1])
    return drawn


def what_is_wrong() -> list[vtkActor]:
    check = insideout.check(demo.figure())
    return [*marked_facets(check.surface), *defect_lines(check.lines)]


def several_bodies() -> list[vtkActor]:
    made = insideout.tetrahedralize({"organ": demo.organ(), "tumor": demo.tumor()}, priority="tumor", refine=True)
    names = ["+".join(region.bodies) for region in made.regions]
    colours = {"organ": SOLID, "tumor": CROSSING}
    plane = half((0, -1, 0), (0, 1, 0))
    return [cut_open(region_of(made.solid, k), colours.get(name, CROSSING), plane) for k, name in enumerate(names)]


def a_difference() -> list[vtkActor]:
    made = insideout.boolean({"organ": demo.organ(), "tumor": demo.tumor()}, "organ - tumor", tetrahedra=True)
    return [cut_open(made.solid, plane=half((0, -1, 0), (0, 1, 0)))]


def distances() -> list[vtkActor]:
    """A slice of the signed distances around an open scan: 0 is white, the inside red."""
    grid = insideout.sdf_grid(demo.scan(), spacing=0.02, to="surface")
    depth = -np.asarray(grid.distance)
    middle = depth.shape[1] // 2
    values = 0.5 + 2 * np.clip(depth[:, middle], -0.7, 0.7)
    image = vtkImageData()
    image.SetDimensions(values.shape[0], 1, values.shape[1])
    image.SetSpacing(0.02, 1, 0.02)
    array = numpy_to_vtk(np.round(values, 1).ravel(order="F"), deep=True)
    array.SetName("w")
    image.GetPointData().SetScalars(array)
    faces = vtkGeometryFilter()
    faces.SetInputData(image)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(faces.GetOutputPort())
    mapper.SetLookupTable(colours_of_w())
    drawn = vtkActor()
    drawn.SetMapper(mapper)
    drawn.GetProperty().LightingOff()
    return [drawn]


def treated(treatment: str) -> list[vtkActor]:
    tolerance = 0.02 if treatment == "remeshed" else None
    made = insideout.tetrahedralize(demo.scan(), edge_length=LENGTH, surface_treatment=treatment, surface_tolerance=tolerance)
    print(f"{treatment}: {made.boundary.GetNumberOfCells()} triangles, {made.solid.GetNumberOfCells()} cells")
    return [actor(made.boundary, SOLID, edge_colour=EDGES)]


TASKS = {"print": to_print, "solver": for_a_solver, "wrong": what_is_wrong, "bodies": several_bodies, "boolean": a_difference, "distances": distances}

if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    for name, task in TASKS.items():
        save([task()], folder / f"task-{name}.png", (0, -1, 0) if name == "distances" else CORNER if name == "solver" else FRONT)
    save([treated(treatment) for treatment in ("kept", "split", "remeshed")], folder / "task-treatments.png", share=0.55)
