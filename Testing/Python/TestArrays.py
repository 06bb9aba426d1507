# SPDX-License-Identifier: GPL-3.0-or-later
"""All arrays that the classes make are of VTK's named classes: Python reads values of these alone, and SafeDownCast knows them."""

import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkDoubleArray, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

OBJ = """o one
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 0 1 0 0 0 1
vt 0 0
vn 0 0 1
usemtl steel
f 1/1/1 2/1/1 3/1/1
g two
usemtl wood
f 3/1/1 2/1/1 1/1/1
"""

PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float nx
property float ny
property float nz
property double pressure
property short number
element face 1
property list uchar int vertex_indices
property uchar red
property uchar green
property uchar blue
property float area
end_header
0 0 0 0 0 1 5 1
1 0 0 0 0 1 6 2
0 1 0 0 0 1 7 3
3 0 1 2 255 0 0 0.5
"""

STL = "\n".join(
    f"solid {name}\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid"
    for name in ("one", "two")
)

FILES = {"all.obj": OBJ, "all.ply": PLY, "two.stl": STL}

WITHOUT_OUTPUT = ("vtkSolidWriter", "vtkSurfaceWriter", "vtkWindingNumberToImageStencil")
"""They write files, or make no arrays."""


def data_sets(data) -> list:
    """The data set, or all within a composite one."""
    if isinstance(data, vtkMultiBlockDataSet):
        return [leaf for k in range(data.GetNumberOfBlocks()) for leaf in data_sets(data.GetBlock(k))]
    if isinstance(data, vtkPartitionedDataSetCollection):
        parts = [data.GetPartitionedDataSet(k) for k in range(data.GetNumberOfPartitionedDataSets())]
        return [part.GetPartition(k) for part in parts for k in range(part.GetNumberOfPartitions())]
    return [data] if data is not None else []


def arrays_of(data: vtkDataSet) -> list[vtkAbstractArray]:
    """Arrays of points, cells and field data; and the arrays that points and cells consist of."""
    kinds = (data.GetPointData(), data.GetCellData(), data.GetFieldData())
    found = [kind.GetAbstractArray(k) for kind in kinds for k in range(kind.GetNumberOfArrays())]
    if hasattr(data, "GetPoints") and data.GetPoints():
        found.append(data.GetPoints().GetData())
    return found


def blocks(*parts: vtkPolyData) -> vtkMultiBlockDataSet:
    made = vtkMultiBlockDataSet()
    for number, part in enumerate(parts):
        made.SetBlock(number, part)
    return made


def image() -> vtkImageData:
    made = vtkImageData()
    made.SetDimensions(4, 4, 4)
    made.SetSpacing(0.5, 0.5, 0.5)
    return made


class Arrays(CommandLine):
    def check(self, data) -> int:
        """The number of arrays, each of which has a class with a name and values that Python reads."""
        arrays = [array for one in data_sets(data) for array in arrays_of(one)]
        for array in arrays:
            with self.subTest(array=array.GetName()):
                self.assertNotIn("Template", array.GetClassName())
                self.assertTrue(hasattr(array, "GetValue"), type(array))
        return len(arrays)

    def algorithms(self):
        """An algorithm of each public class with outputs, set so that it makes all arrays it knows."""
        boxes = surfaces.two_boxes_and_a_stray_facet()
        surfaces.add_array(boxes.GetCellData(), "Part", np.arange(25) // 12)
        solid = insideout.tetrahedralize(boxes, body_array="Part").solid
        for name in sorted(vars(insideout)):
            kind = getattr(insideout, name)
            if not (name.startswith("vtk") and isinstance(kind, type) and issubclass(kind, vtkAlgorithm)) or name in WITHOUT_OUTPUT:
                continue
            made = kind()
            if name in ("vtkBoundaryLayers", "vtkRefineTetrahedra", "vtkSolidQuality"):
                made.SetInputData(solid)
            elif name == "vtkGraphCutSegmentation":
                made.SetInputData(insideout.tetrahedralize(boxes).hull)
            elif name == "vtkRobustTriangulate":
                made.SetInputData(surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
            elif name == "vtkConstrainedDelaunay3D":
                made.SetInputData(surfaces.box())
            elif name == "vtkVoxelFractions":
                made.SetInputData(image())
                made.SetSolidData(solid)
            elif name == "vtkProbeWindingNumber":
                made.SetInputData(image())
                made.SetSurfaceData(boxes)
                made.SetDistance(True)
                made.SetClosestPoints(True)
            elif name == "vtkWindingBoolean":
                made.AddInputData(surfaces.box())
                made.AddInputData(surfaces.box((0.5, 0.5, 0.5)))
                made.SetTetrahedra(True)
            elif name == "vtkDistributeParts":
                made.SetInputData(blocks(boxes, surfaces.box()))
            elif name == "vtkSurfaceReader":
                made.SetFileName(self.file("all.ply", PLY))
            elif name == "vtkSolidReader":
                insideout.write(solid, self.path("solid.msh"))
                made.SetFileName(self.path("solid.msh"))
            else:
                made.SetInputData(boxes)
            if name == "vtkRobustTetrahedralize":
                made.SetBodyArrayName("Part")
            if name == "vtkBoundaryLayers":
                made.SetFirstHeight(0.01)
            if hasattr(made, "SetGenerateHull"):
                made.SetGenerateHull(True)
            yield name, made

    def test_every_class_makes_named_ones(self):
        for name, algorithm in self.algorithms():
            with self.subTest(name):
                insideout.pipeline.run(algorithm)
                ports = range(algorithm.GetNumberOfOutputPorts())
                self.assertGreater(sum(self.check(algorithm.GetOutputDataObject(port)) for port in ports), 0)

    def test_the_reader_makes_named_ones_of_every_format(self):
        for name, content in FILES.items():
            with self.subTest(name):
                reader = insideout.vtkSurfaceReader()
                reader.SetFileName(self.file(name, content))
                insideout.pipeline.run(reader)
                self.check(reader.GetOutput())

    def test_groups_are_ints_that_python_reads(self):
        reader = insideout.vtkSurfaceReader()
        reader.SetFileName(self.file("all.obj", OBJ))
        insideout.pipeline.run(reader)
        for name in ("GroupIds", "MaterialIds"):
            array = reader.GetOutput().GetCellData().GetArray(name)
            self.assertIsInstance(array, vtkIntArray)
            self.assertEqual([array.GetValue(0), array.GetValue(1)], [0, 1])
        self.assertIsInstance(reader.GetOutput().GetPointData().GetArray("TCoords"), vtkDoubleArray)


if __name__ == "__main__":
    unittest.main()
