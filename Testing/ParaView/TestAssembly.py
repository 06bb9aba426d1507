# SPDX-License-Identifier: GPL-3.0-or-later
"""An assembly of 200 parts of which 5 are broken gives the same solids, and the same complaints, on any number of ranks.

    mpirun -np 3 pvbatch --symmetric TestAssembly.py
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (vtkCellArray, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPartitionedDataSet,
                                           vtkPartitionedDataSetCollection, vtkPolyData)
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from insideout import vtkDistributeParts, vtkResolveSelfIntersections, vtkRobustTetrahedralize, vtkWindingBoolean
from insideout.pipeline import statistics_of

controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
CORNERS = np.array([(i & 1, i >> 1 & 1, i >> 2) for i in range(8)], float)
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def part(number):
    """Boxes that overlap, more of them in some; each with cells that only this rank has, and no others."""
    points, cells = [], []
    for box in range(1 + 5 * (number % 40 == 0)):
        first = 8 * box
        points.extend(CORNERS * (1 + number / 7) + 0.3 * box)
        cells.extend([tuple(first + p for p in quad) for quad in QUADS])
    points = np.array(points)
    if number in (3, 77):
        points[5] = np.nan  # refused where the surface is read
    if number in (40, 120):
        points[:, 1:] = number  # on one line: refused when facets are counted
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    data.SetPolys(vtkCellArray())
    for which, cell in enumerate(cells):
        if (which + number) % RANKS == RANK:
            data.GetPolys().InsertNextCell(4, [9999 if number == 150 else p for p in cell])  # refused, too
    return data


def add_array(data, title, values, kind):
    array = kind()
    array.SetName(title)
    for value in values:
        array.InsertNextValue(value)
    data.AddArray(array)


def name(number):
    return f"part {number:03}"


def assembly(kind, parts):
    if kind == "blocks":
        halves = vtkMultiBlockDataSet()
        for half in range(2):
            blocks = vtkMultiBlockDataSet()
            for i in range(parts // 2):
                number = half * parts // 2 + i
                blocks.SetBlock(i, part(number))
                blocks.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), name(number))
            halves.SetBlock(half, blocks)
            halves.GetMetaData(half).Set(vtkCompositeDataSet.NAME(), f"half {half}")
        return halves
    collection = vtkPartitionedDataSetCollection()
    for number in range(parts):
        pieces = vtkPartitionedDataSet()
        pieces.SetPartition(0, part(number))
        collection.SetPartitionedDataSet(number, pieces)
        collection.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name(number))
    return collection


def solids(data):
    """(name, solid or None) of all places, in order."""
    tree = data.NewTreeIterator()
    tree.SkipEmptyNodesOff()
    tree.InitTraversal()
    found = []
    if isinstance(data, vtkPartitionedDataSetCollection):
        for i in range(data.GetNumberOfPartitionedDataSets()):
            pieces = data.GetPartitionedDataSet(i)
            one = pieces.GetPartition(0) if pieces and pieces.GetNumberOfPartitions() else None
            found.append((data.GetMetaData(i).Get(vtkCompositeDataSet.NAME()), one))
        return found
    while not tree.IsDoneWithTraversal():
        found.append((tree.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME()), tree.GetCurrentDataObject()))
        tree.GoToNextItem()
    return found


def statistic(solid, which):
    return statistics_of(solid).get(which, 0)


def total(values):
    """The sum over all ranks."""
    sent = numpy_to_vtk(np.array(values, float))
    received = numpy_to_vtk(np.zeros(len(values)))
    controller.AllReduce(sent, received, 2)  # vtkCommunicator.SUM_OP
    return vtk_to_numpy(received)


def tetrahedralize(kind, stages, parts=200):
    """What this rank has of each part, by name, and how many errors it had."""
    last, errors = vtkDistributeParts(), []
    last.SetInputDataObject(assembly(kind, parts))
    for stage in stages:
        following = stage()
        following.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        following.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        following.SetInputConnection(last.GetOutputPort())
        last = following
    last.UpdatePiece(RANK, RANKS, 0)
    return solids(last.GetOutputDataObject(0)), len(errors)


for kind in ("blocks", "collection"):
    own, errors = tetrahedralize(kind, [vtkRobustTetrahedralize])
    assert [title for title, _ in own] == [name(number) for number in range(200)], (kind, RANK, own[:3])
    held = sum(solid is not None for _, solid in own)
    assert abs(held - 200 / RANKS) < 20, (RANK, held, "the work is spread")
    volume = total([statistic(solid, "Volume") if solid else 0 for _, solid in own])
    cells = total([solid.GetNumberOfCells() if solid else 0 for _, solid in own])
    (errors,) = total([errors])
    for number in range(200):
        edge = 1 + number / 7
        expected = edge**3
        if number in (3, 40, 77, 120, 150):
            expected = 0
        elif number % 40 == 0:
            expected = edge**3 + 5 * (edge**3 - (edge - 0.3) ** 3)
        assert abs(volume[number] - expected) < 1e-9 * max(expected, 1), (kind, number, volume[number], expected)
        assert (cells[number] > 0) == (expected > 0), (kind, number, cells[number])
    assert errors == 5, errors
    if RANK == 0:
        print(kind, "cells:", int(sum(cells)), "errors:", int(errors))

# A rank that stops in the midst of a part, at whatever stage, keeps none of the others from theirs.
reached = set()


def stop_last_rank(stage):
    def observe(solid, _event):
        reached.add(solid.GetProgressText())
        if RANK == RANKS - 1 and solid.GetProgressText() == stage:
            solid.SetAbortExecute(1)

    filters = []

    def make():
        filters.append(vtkRobustTetrahedralize())
        filters[0].AddObserver("ProgressEvent", observe)
        return filters[0]

    own, _ = tetrahedralize("blocks", [make], parts=8)
    return total([sum(solid is not None and solid.GetNumberOfCells() > 0 for _, solid in own)])[0]


assert stop_last_rank("no stage") == 7
stages = sorted(text for text in reached if text)
assert len(stages) == 8, stages
for stage in stages:
    made = stop_last_rank(stage)
    assert 7 - -(-8 // RANKS) <= made < 7, (stage, made)

# Through another filter, the parts are still those of each rank.
own, _ = tetrahedralize("blocks", [vtkResolveSelfIntersections, vtkRobustTetrahedralize], parts=2)
again = total([sum(statistic(solid, "Volume") for _, solid in own if solid)])
assert abs(again - volume[0] - volume[1]) < 1e-9, (again, volume[:2])


def errors_of(whole):
    """How many errors one mesh of all parts has here."""
    parts, errors = vtkDistributeParts(), []
    parts.SetInputDataObject(assembly("blocks", 2))
    whole.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    whole.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    whole.SetInputConnection(parts.GetOutputPort())
    whole.UpdatePiece(RANK, RANKS, 0)
    return len(errors)


# A rank has no mesh of what is but its own share of the parts.
bodies = vtkRobustTetrahedralize()
bodies.BlocksAreBodiesOn()
assert errors_of(bodies) == errors_of(vtkWindingBoolean()) == (1 if RANKS > 1 else 0)

# A side keeps its name, though each rank names only those that it has, in an order of its own.
both, warnings = vtkPartitionedDataSetCollection(), []
for number in range(2):
    data = part(1)
    own = [side for side in range(6) if (side + 1) % RANKS == RANK]
    names = [f"side {side}" for side in own[::-1]]
    if number == 0:
        names.insert(0, "no side")
    add_array(data.GetCellData(), "BoundaryTag", [names.index(f"side {side}") for side in own], vtkIntArray)
    add_array(data.GetFieldData(), "BoundaryTagNames", names, vtkStringArray)
    if RANK == 0:
        add_array(data.GetCellData(), "of the first", own, vtkIntArray)
    pieces = vtkPartitionedDataSet()
    pieces.SetPartition(0, data)
    both.SetPartitionedDataSet(number, pieces)
distribute = vtkDistributeParts()
distribute.AddObserver("WarningEvent", lambda *_: warnings.append(1))
distribute.SetInputDataObject(both)
distribute.UpdatePiece(RANK, RANKS, 0)
held = 0
for _, solid in solids(distribute.GetOutputDataObject(0)):
    if solid:
        held += 1
        tags, names = solid.GetCellData().GetArray("BoundaryTag"), solid.GetFieldData().GetAbstractArray("BoundaryTagNames")
        found = set()
        for cell in range(6):
            ids = solid.GetCell(cell).GetPointIds()
            centre = np.mean([solid.GetPoint(ids.GetId(k)) for k in range(4)], axis=0)
            side = [np.allclose(centre, CORNERS[list(quad)].mean(axis=0) * (1 + 1 / 7)) for quad in QUADS].index(True)
            assert names.GetValue(tags.GetValue(cell)) == f"side {side}", (RANK, cell)
            found.add(side)
        assert len(found) == solid.GetNumberOfCells() == 6
        assert solid.GetCellData().HasArray("of the first") == (RANKS == 1)
assert bool(warnings) == (RANKS > 1 and held > 0), (RANK, warnings)
assert total([held])[0] == 2
controller.Barrier()
if RANK == 0:
    print("the same on all ranks")
sys.stdout.flush()
