# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever data an input has comes through every filter, active or not."""

import unittest

import insideout
import numpy as np
import surfaces
from insideout.pipeline import statistics_of, strings_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkSphereSource

KINDS = {
    # What SetActiveAttribute calls it: the number of components.
    "Scalars": 1,
    "Vectors": 3,
    "Normals": 3,
    "TCoords": 2,
    "Tensors": 9,
    "Tangents": 3,
    "RationalWeights": 1,
    "HigherOrderDegrees": 3,
}
"""Every kind of attribute but ids, which would be wrong of new points and cells."""

CARRIED_BY_POINTS, CARRIED_BY_BOTH, CARRIED_BY_CELLS = "points", "points and cells", "cells"


def with_attributes(data):
    """A copy with an active array of each kind, and one that is none, on points and cells."""
    made = data.NewInstance()
    made.DeepCopy(data)
    for where, attributes, count in (
        ("point", made.GetPointData(), made.GetNumberOfPoints()),
        ("cell", made.GetCellData(), made.GetNumberOfCells()),
    ):
        for kind, components in (*KINDS.items(), ("plain", 2)):
            values = np.tile([1.0, *[0.0] * (components - 1)], (count, 1))
            array = numpy_to_vtk(values if components > 1 else values.ravel(), deep=True)
            array.SetName(f"{kind} of {where}s")
            index = attributes.AddArray(array)
            if kind in KINDS:
                attributes.SetActiveAttribute(index, getattr(vtkDataSetAttributes, kind.upper()))
    return made


def image(size=4):
    made = vtkImageData()
    made.SetDimensions(size, size, size)
    made.SetSpacing(*[1.5 / (size - 1)] * 3)
    return made


def names_of(attributes):
    return {attributes.GetArrayName(index) for index in range(attributes.GetNumberOfArrays())}


class EveryFilter(unittest.TestCase):
    """Each filter by its outputs: what of the input's data is on each."""

    def check(self, filter, carried):
        insideout.pipeline.run(filter)
        for port, carries in carried.items():
            output = filter.GetOutputDataObject(port)
            self.assertGreater(output.GetNumberOfCells(), 0)
            for where, attributes in (("point", output.GetPointData()), ("cell", output.GetCellData())):
                if where in carries:
                    expected = {f"{kind} of {where}s" for kind in (*KINDS, "plain")}
                    with self.subTest(filter=filter.GetClassName(), port=port, where=where):
                        self.assertEqual(expected - names_of(attributes), set())

    def test_filters_of_surfaces(self):
        box = with_attributes(surfaces.open_box())
        for kind, carried in (
            ("vtkSurfaceDefects", {0: CARRIED_BY_BOTH}),
            ("vtkResolveSelfIntersections", {0: CARRIED_BY_BOTH}),
            ("vtkConstrainedDelaunay3D", {0: CARRIED_BY_POINTS}),
            ("vtkGeneralizedWindingNumber", {0: CARRIED_BY_POINTS}),
            ("vtkRobustTetrahedralize", {0: CARRIED_BY_POINTS, 1: CARRIED_BY_BOTH, 3: CARRIED_BY_POINTS}),
            ("vtkWindingBoolean", {0: CARRIED_BY_BOTH}),
        ):
            filter = getattr(insideout, kind)()
            filter.SetInputDataObject(box)
            if hasattr(filter, "GenerateHullOn"):
                filter.GenerateHullOn()
            self.check(filter, carried)

    def test_the_filter_of_outlines(self):
        square = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
        filter = insideout.vtkRobustTriangulate()
        filter.SetInputData(with_attributes(square))
        filter.GenerateHullOn()
        lines = {port: CARRIED_BY_BOTH for port in (1, 4)}
        self.check(filter, {0: CARRIED_BY_POINTS, 3: CARRIED_BY_POINTS, **lines})

    def test_filters_of_solids(self):
        solid = with_attributes(insideout.tetrahedralize(surfaces.two_boxes()).hull)
        for kind in ("vtkGraphCutSegmentation", "vtkRefineTetrahedra", "vtkSolidQuality"):
            filter = getattr(insideout, kind)()
            filter.SetInputData(solid)
            self.check(filter, {0: CARRIED_BY_BOTH})

    def test_filters_of_places(self):
        places, solid = with_attributes(image()), insideout.tetrahedralize(surfaces.box())
        for association in (insideout.vtkProbeWindingNumber.POINTS, insideout.vtkProbeWindingNumber.CELLS):
            probe = insideout.vtkProbeWindingNumber()
            probe.SetInputData(places)
            probe.SetSurfaceData(surfaces.box())
            probe.SetAssociation(association)
            probe.DistanceOn()
            self.check(probe, {0: CARRIED_BY_BOTH})
            kind = vtkDataObject.POINT if association == probe.POINTS else vtkDataObject.CELL
            self.assertEqual(probe.GetOutput().GetAttributes(kind).GetScalars().GetName(), "w")
        voxels = insideout.vtkVoxelFractions()
        voxels.SetInputData(places)
        voxels.SetSolidData(solid.solid)
        self.check(voxels, {0: CARRIED_BY_BOTH})
        self.assertEqual(voxels.GetOutput().GetCellData().GetScalars().GetName(), "VolumeFraction")


class NormalsAreUnitVectors(unittest.TestCase):
    """Else a renderer shows them dark, or black where they are NaN."""

    @staticmethod
    def sphere():
        source = vtkSphereSource()
        source.SetThetaResolution(12)
        source.SetPhiResolution(8)
        source.Update()
        return source.GetOutput()

    def check(self, surface):
        normals = vtk_to_numpy(surface.GetPointData().GetNormals())
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)

    def test_normals_have_length_1_where_facets_are_cut_and_remeshed(self):
        twice = vtkAppendPolyData()
        moved = vtkPolyData()
        moved.DeepCopy(self.sphere())
        points = vtk_to_numpy(moved.GetPoints().GetData())
        points += np.array([0.3, 0.2, 0.1], points.dtype)
        twice.AddInputData(self.sphere())
        twice.AddInputData(moved)
        twice.Update()
        result = insideout.tetrahedralize(twice.GetOutput())
        self.assertGreater((result.boundary.point_arrays["vtkOriginalPointIds"] < 0).sum(), 0)
        self.check(result.boundary)
        remeshed = insideout.tetrahedralize(self.sphere(), edge_length=0.1, surface_treatment="remeshed")
        self.assertGreater((remeshed.boundary.point_arrays["vtkOriginalPointIds"] < 0).sum(), 0)
        self.check(remeshed.boundary)

    def test_normals_that_one_of_two_bodies_has_are_left_out(self):
        cone = vtkConeSource()  # it has none
        cone.Update()
        result = insideout.boolean({"ball": self.sphere(), "cone": cone.GetOutput()}, "ball - cone")
        self.assertIsNone(result.surface.GetPointData().GetNormals())
        self.assertTrue(any("normals are left out, because input 2 has none" in warning for warning in result.warnings))
        both = insideout.boolean({"ball": self.sphere(), "other": self.sphere(), "nothing": vtkPolyData()}, "ball + other")
        self.check(both.surface)
        self.assertIsNotNone(both.surface.GetPointData().GetNormals())


class Statistics(unittest.TestCase):
    """Each stage adds its statistics to those that its input came with."""

    def test_those_of_the_input_stay_behind_the_stages_own(self):
        resolved = insideout.resolve(surfaces.two_boxes())
        delaunay = insideout.vtkConstrainedDelaunay3D()
        delaunay.SetInputData(resolved.surface)
        insideout.pipeline.run(delaunay)
        found = statistics_of(delaunay.GetOutput())
        self.assertEqual(found["IntersectingPairs"], resolved.statistics["IntersectingPairs"])
        self.assertEqual(found["HullCells"], delaunay.GetOutput().GetNumberOfCells())
        quality = insideout.vtkSolidQuality()
        solid = insideout.tetrahedralize(surfaces.two_boxes())
        quality.SetInputData(solid.solid)
        insideout.pipeline.run(quality)
        self.assertEqual(statistics_of(quality.GetOutput())["Volume"], solid.statistics["Volume"])

    def test_each_name_is_there_once_with_the_last_value(self):
        touching = surfaces.joined(surfaces.box(), surfaces.box((1, 1, 0)))
        split = insideout.tetrahedralize(touching, non_manifold="split")
        names = strings_of(split.solid.GetFieldData().GetAbstractArray("StatisticsNames"))
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(split.statistics["NonManifoldEdges"], 0, "those of the boundary that is split")


if __name__ == "__main__":
    unittest.main()
