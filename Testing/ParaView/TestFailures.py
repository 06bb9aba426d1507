# SPDX-License-Identifier: GPL-3.0-or-later
"""What fails on one rank, at whatever stage, leaves no other waiting: parts of an assembly, and whole inputs.

    mpirun -np 3 pvbatch --symmetric TestFailures.py
"""

import os
import sys

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from insideout import vtkDistributeParts, vtkProbeWindingNumber, vtkRobustTetrahedralize

controller = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
PARTS = 2 * RANKS


def box():
    cube = vtkCubeSource()
    cube.Update()
    data = vtkPolyData()
    data.DeepCopy(cube.GetOutput())
    set_chosen(data, vtkIntArray(), 0)
    return data


def set_chosen(data, array, value):
    array.SetName("Chosen")
    for _ in range(data.GetNumberOfCells()):
        array.InsertNextValue(value)
    data.GetCellData().AddArray(array)


def nothing(*_):
    pass


def blocks(change=nothing):
    """Parts that the first rank has read; the last part, which becomes the last rank's, is changed."""
    assembly = vtkMultiBlockDataSet()
    for number in range(PARTS):
        data = box() if RANK == 0 else None
        if data and number == PARTS - 1:
            change(data)
        assembly.SetBlock(number, data)
    return assembly


class Source(VTKPythonAlgorithmBase):
    """Gives data, and fails in one of the passes on the last rank until it is mended."""

    def __init__(self, data, fails_in):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=data.GetClassName())
        self.data, self.fails_in = data, fails_in if RANK == RANKS - 1 else None

    def mend(self):
        self.fails_in = None
        self.Modified()

    def RequestDataObject(self, _request, _inputs, outputs):
        if self.fails_in != "object":
            outputs.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), self.data.NewInstance())
        return self.fails_in != "object"

    def RequestInformation(self, _request, _inputs, outputs):
        outputs.GetInformationObject(0).Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
        if isinstance(self.data, vtkImageData) and self.fails_in != "information":
            outputs.GetInformationObject(0).Set(self.GetExecutive().WHOLE_EXTENT(), self.data.GetExtent(), 6)
        return self.fails_in != "information"

    def RequestData(self, _request, _inputs, outputs):
        outputs.GetInformationObject(0).Get(vtkPolyData.DATA_OBJECT()).ShallowCopy(self.data)
        return self.fails_in != "data"


def update(algorithm):
    """Its errors and warnings."""
    complaints = []

    def listen(_object, _event, text):
        complaints.append(text)

    listen.CallDataType = "string0"
    for event in ("ErrorEvent", "WarningEvent"):
        algorithm.RemoveObservers(event)
        algorithm.AddObserver(event, listen)
        algorithm.GetExecutive().AddObserver(event, nothing)
    algorithm.UpdatePiece(RANK, RANKS, 0)
    return complaints


def made(solids):
    """How many parts on all ranks have a solid."""
    output = solids.GetOutputDataObject(0)
    own = [output.GetBlock(i) for i in range(output.GetNumberOfBlocks())]
    count, all_counts = vtkIntArray(), vtkIntArray()
    count.InsertNextValue(sum(1 for solid in own if solid and solid.GetNumberOfCells() > 0))
    controller.AllReduce(count, all_counts, 2)  # vtkCommunicator.SUM_OP
    return all_counts.GetValue(0)


# --- A part fails at a stage ----------------------------------------------------------------------

def not_finite(data):
    data.GetPoints().SetPoint(3, float("nan"), 0, 0)


def on_a_line(data):
    for point in range(data.GetNumberOfPoints()):
        data.GetPoints().SetPoint(point, point, 0, 0)


def choose_by_words(data):
    set_chosen(data, vtkStringArray(), "none")


def no_tetgen(solid):
    stage = solid.GetWindingNumber()
    stage.SetEngine(stage.ENGINE_TETGEN)
    if RANK == RANKS - 1:
        os.environ["INSIDEOUT_TETGEN"] = "/nowhere"


# While it is read (twice), counted, tetrahedralized and cut.
for change, set_up, words in (
    (not_finite, nothing, "is not finite"),
    (choose_by_words, lambda solids: solids.SetNonParticipatingArrayName("Chosen"), "no cell array Chosen"),
    (on_a_line, nothing, "degenerate"),
    (nothing, no_tetgen, "insideout-tetgen"),
    (choose_by_words, lambda solids: solids.SetConstrainedFacetsArrayName("Chosen"), "no cell array Chosen"),
):
    parts, solids = vtkDistributeParts(), vtkRobustTetrahedralize()
    parts.SetInputDataObject(blocks(change))
    solids.SetInputConnection(parts.GetOutputPort())
    set_up(solids)
    complaints = update(solids)
    os.environ.pop("INSIDEOUT_TETGEN", None)
    assert any(words in each for each in complaints) == (RANK == RANKS - 1), (words, RANK, complaints)
    assert RANK == RANKS - 1 or not complaints, (words, RANK, complaints)
    # Without TetGen there are Delaunay tetrahedra, which happen to fit boxes.
    assert made(solids) == PARTS - (0 if set_up is no_tetgen else 1), (words, made(solids))

# --- The input of a rank fails in a pass of the pipeline ------------------------------------------

def image():
    places = vtkImageData()
    places.SetExtent(0, 4, 0, 4, 0, 4)
    return places


def parts_of(fails_in):
    source, parts = Source(blocks(), fails_in), vtkDistributeParts()
    parts.SetInputConnection(source.GetOutputPort())
    return source, parts


def surface_of(fails_in):
    source, probe = Source(box(), fails_in), vtkProbeWindingNumber()
    probe.SetInputData(image())
    probe.SetSurfaceConnection(source.GetOutputPort())
    return source, probe


def places_of(fails_in):
    source, probe = Source(image(), fails_in), vtkProbeWindingNumber()
    probe.SetInputConnection(source.GetOutputPort())
    probe.SetSurfaceData(box())
    return source, probe


def size(output):
    if output is None:  # of a process that works alone VTK runs no filter behind what has no data object
        return 0
    return output.GetNumberOfBlocks() if output.IsA("vtkMultiBlockDataSet") else output.GetNumberOfPoints()


for make in (parts_of, surface_of, places_of):
    for fails_in in ("object", "information", "data"):
        source, last = make(fails_in)
        found = update(last)
        if RANKS > 1:
            assert len(found) == 1 and f"input of process {RANKS - 1} fails" in found[0], (make.__name__, fails_in, RANK, found)
        assert size(last.GetOutputDataObject(0)) == 0, (make.__name__, fails_in)
        source.mend()
        assert not update(last), (make.__name__, fails_in)
        assert size(last.GetOutputDataObject(0)) == (PARTS if make is parts_of else 125), (make.__name__, fails_in)

# --- The surface fails, or one rank is stopped, where all ranks have its pieces in turn -----------

def in_turn(surface, distance=True):
    """A probe of a surface of which each rank has a copy, 5 facets at once."""
    probe = vtkProbeWindingNumber()
    probe.SetInputData(image())
    probe.SetSurfaceData(surface)
    probe.SetFacetsAtOnce(5)
    probe.SetDistance(distance)
    return probe


broken = box()
if RANK == RANKS - 1:
    not_finite(broken)
found = update(in_turn(broken))
assert len(found) == 1, (RANK, found)
assert ("is not finite" if RANK == 0 else "process 0 fails") in found[0], (RANK, found)

for stopped_at in (0.05, 0.4, 0.6):  # soon, and in different turns

    def stop(probe, _event):
        if RANK == RANKS - 1 and probe.GetProgress() >= stopped_at:
            probe.SetAbortExecute(1)

    probe = in_turn(box())
    observer = probe.AddObserver("ProgressEvent", stop)
    assert not update(probe), RANK
    assert probe.GetOutputDataObject(0).GetNumberOfPoints() == 0, (RANK, stopped_at)
    probe.RemoveObserver(observer)
    probe.SetAbortExecute(0)
    probe.Modified()
    assert not update(probe), RANK
    assert probe.GetOutputDataObject(0).GetNumberOfPoints() == 125, (RANK, stopped_at)

# --- A block of the surface is none ---------------------------------------------------------------

several = vtkMultiBlockDataSet()
several.SetBlock(0, box())
several.SetBlock(1, image())
probe = vtkProbeWindingNumber()
probe.SetInputData(image())
probe.SetInputDataObject(1, several)
found = update(probe)
assert found and all("block" in each for each in found), (RANK, found)

controller.Barrier()
if RANK == 0:
    print("nobody waits for ever")
sys.stdout.flush()
