# SPDX-License-Identifier: GPL-3.0-or-later
"""Each rank holds a piece of the surface and of the places, and has the winding numbers of the whole there.

    mpirun -np 3 pvbatch --symmetric TestPieces.py
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from insideout import vtkProbeWindingNumber
from insideout.pipeline import statistics_of

controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
DUPLICATECELL = 1


def ball(steps, turned):
    """Triangles of a ball; of the southern half in the other direction where it is turned."""
    longitudes, latitudes = np.arange(2 * steps) * np.pi / steps, np.linspace(-np.pi / 2, np.pi / 2, steps + 1)
    points = [(np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)) for b in latitudes for a in longitudes]
    triangles = []
    for row in range(steps):
        for column in range(2 * steps):
            p, q = row * 2 * steps + column, row * 2 * steps + (column + 1) % (2 * steps)
            for triangle in ((p, q, q + 2 * steps), (p, q + 2 * steps, p + 2 * steps)):
                triangles.append(triangle[::-1] if turned and row < steps // 2 else triangle)
    return np.round(points, 9), np.array(triangles)  # so that all points of a pole are one


def polydata(points, triangles, is_ghost=None):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    data.SetPolys(vtkCellArray())
    for triangle in triangles:
        data.GetPolys().InsertNextCell(3, [int(p) for p in triangle])
    if is_ghost is not None:
        ghosts = numpy_to_vtk(np.where(is_ghost, DUPLICATECELL, 0).astype(np.uint8), deep=True, array_type=VTK_UNSIGNED_CHAR)
        ghosts.SetName("vtkGhostType")
        data.GetCellData().AddArray(ghosts)
    return data


def image(low, high):
    places = vtkImageData()
    places.SetExtent(0, 12, 0, 12, low, high)
    places.SetOrigin(-1.2, -1.2, -1.2)
    places.SetSpacing(0.2, 0.2, 0.2)
    return places


def probed(surface, places, pieces, **properties):
    """The arrays at the places, and how many pieces of the surface all ranks had in turn."""
    probe = vtkProbeWindingNumber()
    probe.SetInputData(places)
    probe.SetSurfaceData(surface)
    for name, value in properties.items():
        getattr(probe, "Set" + name)(value)
    probe.UpdatePiece(RANK if pieces > 1 else 0, pieces, 0)
    output = probe.GetOutput()
    data = output.GetPointData()
    arrays = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}
    return arrays, int(statistics_of(output).get("SurfacePieces", 1))


def winding_numbers(surface, places, pieces):
    return probed(surface, places, pieces)[0]["w"]


for name, steps, turned, hole in (("closed", 12, True, 0), ("open", 12, False, 9), ("sparse", 2, False, 0)):
    points, triangles = ball(steps, turned)
    triangles = triangles[hole:]
    # Every n-th triangle is a rank's own, and every third of the others is its ghost.
    owner = np.arange(len(triangles)) * 7 // 3 % RANKS
    held = (owner == RANK) | (np.arange(len(triangles)) % 3 == 0)
    piece = polydata(points, triangles[held], owner[held] != RANK)
    slabs = np.linspace(-1, 12, RANKS + 1).astype(int)
    places = image(slabs[RANK] + 1, slabs[RANK + 1])
    found = winding_numbers(piece, places, RANKS)
    serial = winding_numbers(polydata(points, triangles), places, 1)
    assert RANKS == 1 or piece.GetNumberOfCells() < len(triangles)
    assert len(found) == places.GetNumberOfPoints() > 0
    assert np.abs(found - serial).max() < 1e-12, (name, RANK, np.abs(found - serial).max())
    if not hole:
        away = (serial == 0) | (serial == 1) # on the surface itself it is the mean of both sides
        assert away.mean() > 0.9 and (found[away] == serial[away]).all(), (name, RANK)

    # The same of a surface that no rank but the first holds as a whole.
    nearest = {"Distance": True, "ClosestPoints": True}
    facets = sum(len({tuple(point) for point in points[triangle]}) == 3 for triangle in triangles)
    whole, turns = probed(piece, places, RANKS, **nearest)
    assert turns == 1, turns
    for facets_at_once in (1 + facets // 5, 7):
        in_turn, turns = probed(piece, places, RANKS, FacetsAtOnce=facets_at_once, **nearest)
        assert turns == (-(-facets // facets_at_once) if RANKS > 1 else 1), (name, turns)
        assert np.abs(in_turn["w"] - serial).max() < 1e-12, (name, RANK, np.abs(in_turn["w"] - serial).max())
        assert hole or (in_turn["w"][away] == serial[away]).all(), (name, RANK)
        assert np.array_equal(in_turn["ClosestCellId"], whole["ClosestCellId"]), (name, RANK)
        assert np.array_equal(in_turn["ClosestPoint"], whole["ClosestPoint"]), (name, RANK)
        assert np.abs(np.abs(in_turn["Distance"]) - np.abs(whole["Distance"])).max() < 1e-15, (name, RANK)

# Points with normals, of which some are ghosts.
def cloud(points, normals, is_ghost=None):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    data.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))
    areas = numpy_to_vtk(np.full(len(points), 0.05), deep=True)
    areas.SetName("Area")
    data.GetPointData().AddArray(areas)
    if is_ghost is not None:
        data.SetVerts(vtkCellArray())
        for point in range(len(points)):
            data.GetVerts().InsertNextCell(1, [point])
        ghosts = numpy_to_vtk(np.where(is_ghost, DUPLICATECELL, 0).astype(np.uint8), deep=True, array_type=VTK_UNSIGNED_CHAR)
        ghosts.SetName("vtkGhostType")
        data.GetCellData().AddArray(ghosts)
    return data


points = np.unique(ball(12, False)[0], axis=0)
owner = np.arange(len(points)) % RANKS
held = (owner == RANK) | (np.arange(len(points)) % 3 == 0)
found = winding_numbers(cloud(points[held], points[held], owner[held] != RANK), places, RANKS)
serial = winding_numbers(cloud(points, points), places, 1)
assert serial.max() > 0.5 and np.abs(found - serial).max() < 1e-3, (RANK, np.abs(found - serial).max())

# Where a script works on one rank alone nobody waits for the others.
if RANK == 0:
    points, triangles = ball(4, False)
    assert set(winding_numbers(polydata(points, triangles), image(6, 6), 1)) >= {0, 1}
controller.Barrier()
if RANK == 0:
    print("the same on all ranks")
