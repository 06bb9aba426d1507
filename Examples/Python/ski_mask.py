# SPDX-License-Identifier: GPL-3.0-or-later
"""A snake with a ski mask: an accessory that is no part of the body (the thesis's figure 8.21).

    ski_mask.py [PICTURE.png]

The mask is a thin sheet around the head. When it counts in the winding number, the snake's mouth is
nearly enclosed, and becomes part of the solid. A cell array that says which facets do not count
leaves the body as it is, and the mesh still has a face on each of the mask.
"""

import sys
from pathlib import Path

import insideout
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

ARRAY = "Accessory"
AROUND = 24
LENGTH = 6.0

# Where along the snake each ring is, and how wide: up the body, over the lips, back into the mouth.
BODY = [(0.25, 0.12), (0.6, 0.22), *((s, 0.32) for s in np.arange(1.0, 4.6, 0.2)), (4.7, 0.33)]
HEAD = [(4.9, 0.42), (5.1, 0.54), (5.3, 0.60), (5.5, 0.61), (5.7, 0.57), (5.9, 0.49), (6.0, 0.43)]
MOUTH = [(6.0, 0.37), (5.8, 0.36), (5.6, 0.34), (5.4, 0.28), (5.3, 0.18)]
MASK = [(5.0, 0.56), (5.15, 0.64), (5.3, 0.68), (5.5, 0.69), (5.7, 0.65), (5.92, 0.56), (6.1, 0.40), (6.12, 0.22)]
EYES = [(4, k) for k in (3, 4, 7, 8)]  # ring and place around of the mask's quadrilaterals that are left out


def surface_of(points, polygons) -> vtkPolyData:
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.asarray(points, float), deep=True))
    cells = vtkCellArray()
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    surface = vtkPolyData()
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    return surface


def ring(s: float, radius: float) -> list:
    """Points around the snake's spine, which winds in the plane z = 0 and is straight in the head."""
    winding = 0.35 * max(0.0, 1 - s / 4.6) ** 1.5
    y, slope = winding * np.sin(3 * s), 3 * winding * np.cos(3 * s)
    along = np.array([1.0, slope, 0.0]) / np.hypot(1.0, slope)
    across = np.array([-along[1], along[0], 0.0])
    angles = 2 * np.pi * np.arange(AROUND) / AROUND
    return [np.array([s, y, 0]) + radius * (np.cos(a) * across + np.sin(a) * np.array([0, 0, 1])) for a in angles]


def tube(rings: int, left_out=()) -> list:
    """Quadrilaterals between rings, outward when these run up the snake."""
    quads = []
    for r in range(rings - 1):
        for k in range(AROUND):
            if (r, k) not in left_out:
                a, b = r * AROUND + k, r * AROUND + (k + 1) % AROUND
                quads.append((a, b, b + AROUND, a + AROUND))
    return quads


def snake() -> vtkPolyData:
    """Closed: its mouth is a bowl in the head."""
    rings = BODY + HEAD + MOUTH
    points = [point for s, radius in rings for point in ring(s, radius)]
    points += [np.array(ring(s, 0)[0]) for s in (0.0, MOUTH[-1][0] - 0.02)]
    tail, throat, last = len(points) - 2, len(points) - 1, (len(rings) - 1) * AROUND
    ends = [(tail, (k + 1) % AROUND, k) for k in range(AROUND)]
    ends += [(throat, last + k, last + (k + 1) % AROUND) for k in range(AROUND)]
    return surface_of(points, tube(len(rings)) + ends)


def mask() -> vtkPolyData:
    """Open at the neck, the mouth and the eyes."""
    return surface_of([p for s, radius in MASK for p in ring(s, radius)], tube(len(MASK), EYES))


def scene() -> vtkPolyData:
    """Both, with the cell array that is 1 on the mask."""
    both = vtkAppendPolyData()
    for is_accessory, part in enumerate((snake(), mask())):
        tag = numpy_to_vtk(np.full(part.GetNumberOfCells(), is_accessory, np.uint8), deep=True)
        tag.SetName(ARRAY)
        part.GetCellData().AddArray(tag)
        both.AddInputData(part)
    both.Update()
    return both.GetOutput()


def draw(results: dict, file: str) -> None:
    """The scene and the solids, cut open, seen at the head from above."""
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
    import drawing

    parts = [drawing.actor(snake()), drawing.actor(mask(), drawing.RED, opacity=0.45)]
    panels = [drawing.Panel("A snake with a ski mask", "", parts)]
    for name, result in results.items():
        solid = drawing.cut_open(result.solid, (0, 0, 0), (0, 0, 1))
        words = f"{result.statistics['InsideCells']:,} tetrahedra, cut open"
        panels.append(drawing.Panel(name, words, [drawing.actor(solid, drawing.BLUE, edges=True)]))
    head = ((4.2, 6.2), (-0.75, 0.75), (-0.65, 0.65))
    drawing.save(panels, file, seen_from=(0.25, -0.35, 1), up=(0, 1, 0), bounds=head)


def main(picture_file=None) -> None:
    results = {
        "The mask counts": insideout.tetrahedralize(scene()),
        "The mask does not count": insideout.tetrahedralize(scene(), non_participating_array=ARRAY),
    }
    for name, result in results.items():
        print(
            f"{name}: {result.statistics['InsideCells']} tetrahedra inside, "
            f"{result.statistics['OutliersByEnergy']} facets segmented as outside"
        )
    if picture_file is not None:
        draw(results, picture_file)


if __name__ == "__main__":
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except insideout.Error as error:
        sys.exit(f"ski_mask.py: {error}")
