# SPDX-License-Identifier: GPL-3.0-or-later
"""Every input of every filter is followed in time: one moves, the others stand still, and what comes out is that of its time."""

import unittest

import insideout
import numpy as np
import surfaces
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource

TIMES = (0.0, 1.0, 2.0)


def box(time: float, size: float = 4) -> vtkPolyData:
    source = vtkCubeSource()
    source.SetBounds(0, size, 0, size, 0, size + time)
    source.Update()
    return source.GetOutput()


def square(time: float) -> vtkPolyData:
    source = vtkPlaneSource()
    source.SetXResolution(3)
    source.SetOrigin(0, 0, 0)
    source.SetPoint1(3 + time, 0, 0)
    source.SetPoint2(0, 1, 0)
    source.Update()
    return source.GetOutput()


def grid(time: float) -> vtkUnstructuredGrid:
    """Tetrahedra with w."""
    filled = insideout.vtkGeneralizedWindingNumber()
    filled.SetInputData(box(time))
    filled.Update()
    return filled.GetOutput()


def lengths(time: float) -> vtkUnstructuredGrid:
    made = grid(0)
    surfaces.add_array(made.GetPointData(), "Length", np.full(made.GetNumberOfPoints(), 1.0 + time))
    return made


def refined(time: float) -> vtkUnstructuredGrid:
    """Tetrahedra of a box whose data tell the time."""
    made = insideout.tetrahedralize(box(0)).solid
    surfaces.add_array(made.GetCellData(), "Time", np.full(made.GetNumberOfCells(), time))
    return made


def wall(time: float) -> vtkPolyData:
    """The sides of the box but one, another one at each time."""
    boundary = insideout.tetrahedralize(box(0)).boundary
    corners = boundary.points[boundary.triangles][:, :, int(time)]
    is_open = (corners == boundary.points[:, int(time)].min()).all(axis=1)
    return surfaces.polydata(boundary.points, boundary.triangles[~is_open])


def image(time: float) -> vtkImageData:
    made = vtkImageData()
    made.SetDimensions(3, 3, 8)
    made.SetOrigin(0.5, 0.5, 0.5 + 2 * time)
    return made


def seed(time: float) -> vtkPolyData:
    """A point that is to be outside, in another cell of the grid at each time."""
    cell = grid(0).GetCell(int(time))
    return seed_at(np.mean([cell.GetPoints().GetPoint(k) for k in range(4)], axis=0))


def flat_seed(time: float) -> vtkPolyData:
    return seed_at((0.3 + time, 0.2, 0))


def seed_at(place) -> vtkPolyData:
    points = vtkPoints()
    points.InsertNextPoint(place)
    made = vtkPolyData()
    made.SetPoints(points)
    surfaces.add_array(made.GetPointData(), "Inside", np.zeros(1, np.uint8))
    return made


def blocks(time: float) -> vtkMultiBlockDataSet:
    made = vtkMultiBlockDataSet()
    made.SetBlock(0, box(time))
    return made


OF_TYPE = {
    "vtkPolyData": box,
    "vtkUnstructuredGrid": grid,
    "vtkImageData": image,
    "vtkDataSet": image,
    "vtkPointSet": seed,
    "vtkMultiBlockDataSet": blocks,
}
OF_PORT = {
    ("vtkRobustTriangulate", 0): square,
    ("vtkRobustTriangulate", 1): flat_seed,
    ("vtkRefineTetrahedra", 1): lengths,
    ("vtkBoundaryLayers", 0): refined,
    ("vtkBoundaryLayers", 1): wall,
}
WITHOUT_SMOOTHING = {"Gamma": 0}  # that leaves out more than the seed
SETTINGS = {name: WITHOUT_SMOOTHING for name in ("vtkRobustTetrahedralize", "vtkGraphCutSegmentation", "vtkRobustTriangulate")}
SETTINGS["vtkBoundaryLayers"] = {"FirstHeight": 0.1}


class Moving(VTKPythonAlgorithmBase):
    """Makes data of a time."""

    def __init__(self, make, times=TIMES):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=make(0).GetClassName())
        self.make, self.times = make, times

    def RequestInformation(self, _request, _inputs, outputs):
        information = outputs.GetInformationObject(0)
        made = self.make(0)
        if made.IsA("vtkImageData"):
            information.Set(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT(), made.GetExtent(), 6)
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), self.times, len(self.times))
        information.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), (self.times[0], self.times[-1]), 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        information = outputs.GetInformationObject(0)
        asked = information.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
        time = max(step for step in self.times if step <= asked)
        output = vtkDataObject.GetData(outputs)
        output.ShallowCopy(self.make(time))
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


def leaves(data) -> list[vtkDataSet]:
    if isinstance(data, vtkDataSet):
        return [data]
    found, iterator = [], data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def contents(algorithm: vtkAlgorithm) -> list:
    """Points, cells and all arrays of numbers, but statistics, of all outputs."""
    told = []
    for port in range(algorithm.GetNumberOfOutputPorts()):
        output = algorithm.GetOutputDataObject(port)
        if output.IsA("vtkImageStencilData"):
            extent = output.GetExtent()
            told.append([output.IsInside(x, y, z) for z in range(extent[4], extent[5] + 1) for y in range(extent[2], extent[3] + 1) for x in range(extent[0], extent[1] + 1)])
            continue
        for data in leaves(output):
            told.append([data.GetPoint(point) for point in range(data.GetNumberOfPoints())])
            told.append(data.GetNumberOfCells())
            for attributes in (data.GetPointData(), data.GetCellData()):
                arrays = [attributes.GetArray(k) for k in range(attributes.GetNumberOfArrays())]
                told += [(array.GetName(), vtk_to_numpy(array).tolist()) for array in arrays if array is not None]
    return repr(told)


def types_of(algorithm: vtkAlgorithm, port: int) -> str:
    return algorithm.GetInputPortInformation(port).Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), 0)


def filters() -> list[str]:
    """Those with inputs and outputs."""
    classes = [name for name in insideout.__all__ if name.startswith("vtk") and issubclass(getattr(insideout, name), vtkAlgorithm)]
    made = {name: getattr(insideout, name)() for name in classes}
    return [name for name, one in made.items() if one.GetNumberOfInputPorts() > 0 and one.GetNumberOfOutputPorts() > 0]


def made_of(name: str) -> vtkAlgorithm:
    made = getattr(insideout, name)()
    made.AddObserver("WarningEvent", lambda *_: None)  # that seeds leave facets without cells
    for option, value in SETTINGS.get(name, {}).items():
        getattr(made, "Set" + option)(value)
    if made.IsA("vtkRefineTetrahedra"):
        made.SetSizingArrayName("Length")
        made.SetSurfaceTreatment(made.SPLIT)
    if made.IsA("vtkWindingNumberToImageStencil"):
        made.SetOutputWholeExtent(0, 8, 0, 8, 0, 8)
    return made


def maker(name: str, port: int):
    return OF_PORT.get((name, port)) or OF_TYPE[types_of(made_of(name), port)]


def still(name: str, port: int, time: float) -> vtkAlgorithm:
    """With the data of a time on one port, those of the first on the others."""
    made = made_of(name)
    for other in range(made.GetNumberOfInputPorts()):
        made.SetInputDataObject(other, maker(name, other)(time if other == port else 0))
    made.Update()
    return made


class TestTime(unittest.TestCase):
    def expect_followed(self, algorithm: vtkAlgorithm, expected: dict[float, list], steps=TIMES):
        self.assertEqual(len({str(one) for one in expected.values()}), len(expected), "the output does not tell the times apart")
        algorithm.UpdateInformation()
        for port in range(algorithm.GetNumberOfOutputPorts()):
            information = algorithm.GetOutputInformation(port)
            self.assertEqual(information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()), steps)
            self.assertEqual(information.Get(vtkStreamingDemandDrivenPipeline.TIME_RANGE()), (steps[0], steps[-1]))
        for time in (*expected, *reversed(expected), *expected):
            algorithm.UpdateTimeStep(time)
            self.assertEqual(contents(algorithm), expected[time], time)

    def test_each_input_of_each_filter_is_followed(self):
        self.assertGreater(len(filters()), 12)
        for name in filters():
            for port in range(made_of(name).GetNumberOfInputPorts()):
                with self.subTest(filter=name, port=port):
                    moved = made_of(name)
                    sources = []
                    for other in range(moved.GetNumberOfInputPorts()):
                        if other == port:
                            sources.append(Moving(maker(name, other)))
                            moved.SetInputConnection(other, sources[-1].GetOutputPort())
                        else:
                            moved.SetInputDataObject(other, maker(name, other)(0))
                    self.expect_followed(moved, {time: contents(still(name, port, time)) for time in TIMES})

    def test_a_surface_of_a_probe_is_followed_where_its_input_is_composite(self):
        places = vtkMultiBlockDataSet()
        places.SetBlock(0, image(0))
        places.SetBlock(1, image(1))
        expected = {}
        for time in TIMES:
            probe = insideout.vtkProbeWindingNumber()
            probe.SetInputDataObject(0, places)
            probe.SetSurfaceData(box(time, 2))
            probe.Update()
            expected[time] = contents(probe)
        source = Moving(lambda time: box(time, 2))
        moved = insideout.vtkProbeWindingNumber()
        moved.SetInputDataObject(0, places)
        moved.SetSurfaceConnection(source.GetOutputPort())
        self.expect_followed(moved, expected)
        runs = []
        moved.AddObserver("EndEvent", lambda *_: runs.append(1))
        moved.UpdateTimeStep(TIMES[-1])
        self.assertEqual(runs, [], "the same time is no reason to run again")

    def test_a_body_other_than_the_first_is_followed(self):
        def difference(second) -> vtkAlgorithm:
            made = insideout.vtkWindingBoolean()
            made.SetOperation(made.DIFFERENCE)
            made.AddInputDataObject(0, box(3, 5))
            made.AddInputConnection(0, second.GetOutputPort()) if isinstance(second, Moving) else made.AddInputDataObject(0, second)
            return made

        expected = {}
        for time in TIMES:
            made = difference(box(time, 2))
            made.Update()
            expected[time] = contents(made)
        self.expect_followed(difference(Moving(lambda time: box(time, 2))), expected)

    def test_inputs_that_move_at_other_times_are_followed_both(self):
        places, surface = Moving(image, (0.0, 2.0)), Moving(lambda time: box(time, 2), (0.0, 1.0, 2.0, 3.0))
        moved = insideout.vtkProbeWindingNumber()
        moved.SetInputConnection(0, places.GetOutputPort())
        moved.SetSurfaceConnection(surface.GetOutputPort())
        expected = {}
        for time in surface.times:
            probe = insideout.vtkProbeWindingNumber()
            probe.SetInputDataObject(0, image(0 if time < 2 else 2))
            probe.SetSurfaceData(box(time, 2))
            probe.Update()
            expected[time] = contents(probe)
        self.assertNotEqual(expected[0], expected[1])
        moved.UpdateInformation()
        self.assertEqual(moved.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()), surface.times)
        for time in (0.0, 1.0, 0.0, 3.0, 2.0, 3.0, 1.0):  # a time that the first input has not is no reason to stay
            moved.UpdateTimeStep(time)
            self.assertEqual(contents(moved), expected[time], time)

    def test_an_implicit_function_follows_the_surface_that_it_was_given(self):
        source = Moving(box)
        source.UpdateTimeStep(0)
        function = insideout.vtkImplicitWindingNumber()
        function.SetInput(source.GetOutputDataObject(0))
        for time in (*TIMES, *reversed(TIMES)):
            source.UpdateTimeStep(time)
            self.assertEqual([function.EvaluateFunction(1, 1, z) < 0 for z in (3.5, 4.5, 5.5)], [True, time > 0, time > 1])


if __name__ == "__main__":
    unittest.main()
