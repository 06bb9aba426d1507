# SPDX-License-Identifier: GPL-3.0-or-later
"""The winding number of raw surfaces: as a probe on any data set, and as an implicit function."""

import random
import unittest

import insideout
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkCutter, vtkImplicitPolyDataDistance, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet
from vtkmodules.vtkFiltersModeling import vtkSelectEnclosedPoints
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkImagingHybrid import vtkSampleFunction

import numpy as np


def sphere(hole_facets=0, resolution=24):
    """A ball of radius 1/2, less some facets."""
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    whole = source.GetOutput()
    surface = vtkPolyData()
    surface.SetPoints(whole.GetPoints())
    polygons = vtkCellArray()
    for i in range(hole_facets, whole.GetNumberOfCells()):
        polygons.InsertNextCell(whole.GetCell(i).GetPointIds())
    surface.SetPolys(polygons)
    return surface


def grid(size=9):
    """An image over about [-1, 1] cubed, whose points keep off the surfaces' symmetry planes."""
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetOrigin(-1.01, -1.02, -1.03)
    image.SetSpacing(*[2 / (size - 1)] * 3)
    return image


def rectilinear(image):
    """The same points as an image has."""
    grid_ = vtkRectilinearGrid()
    grid_.SetDimensions(image.GetDimensions())
    for axis, name in enumerate("XYZ"):
        steps = np.arange(image.GetDimensions()[axis]) * image.GetSpacing()[axis] + image.GetOrigin()[axis]
        getattr(grid_, f"Set{name}Coordinates")(numpy_to_vtk(steps, deep=1))
    return grid_


def outline():
    """Lines around a triangle, without polygons."""
    lines = vtkPolyData()
    points, cells = vtkPoints(), vtkCellArray()
    for x, y in ((0, 0), (1, 0), (0, 1), (0, 0)):
        points.InsertNextPoint(x, y, 0)
    cells.InsertNextCell(4, [0, 1, 2, 3])
    lines.SetPoints(points)
    lines.SetLines(cells)
    return lines


def scaled(surface, factor):
    copy = vtkPolyData()
    copy.DeepCopy(surface)
    copy.GetPoints().SetData(numpy_to_vtk(vtk_to_numpy(surface.GetPoints().GetData()) * factor, deep=1))
    return copy


def radii(data):
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return np.linalg.norm(points, axis=1)


def probe(data, surface, **properties):
    filter_ = insideout.vtkProbeWindingNumber()
    filter_.SetInputData(data)
    filter_.SetSurfaceData(surface)
    for name, value in properties.items():
        getattr(filter_, "Set" + name)(value)
    filter_.Update()
    return filter_


class TestProbe(unittest.TestCase):
    def test_w_is_an_exact_integer_on_a_closed_surface(self):
        image = grid()
        output = probe(image, sphere()).GetOutput()
        self.assertEqual(output.GetClassName(), "vtkImageData")
        w = vtk_to_numpy(output.GetPointData().GetArray("w"))
        self.assertEqual(set(w), {0.0, 1.0})
        np.testing.assert_array_equal(w, vtk_to_numpy(output.GetPointData().GetArray("Inside")))
        r = radii(image)
        self.assertTrue(np.all(w[r < 0.48] == 1) and np.all(w[r > 0.5] == 0))

    def test_inside_is_right_on_an_open_surface(self):
        image = grid(20)
        inside = vtk_to_numpy(probe(image, sphere(6)).GetOutput().GetPointData().GetArray("Inside"))
        r = radii(image)
        self.assertTrue(np.all(inside[r < 0.4] == 1) and np.all(inside[r > 0.52] == 0))

    def test_it_takes_the_place_of_select_enclosed_points(self):
        for surface in (sphere(), sphere(resolution=5)):
            old = vtkSelectEnclosedPoints()
            new = insideout.vtkProbeWindingNumber()
            for selector in (old, new):
                selector.SetInputData(grid(10))
                selector.SetSurfaceData(surface)
                selector.Update()
            for i in range(1000):
                self.assertEqual(old.IsInside(i), new.IsInside(i))
            self.assertEqual(new.IsInsideSurface(0, 0, 0), 1)
            self.assertEqual(new.IsInsideSurface([2, 0, 0]), 0)
            new.InsideOutOn()
            new.Update()
            self.assertEqual(new.IsInsideSurface(0, 0, 0), 0)
            self.assertEqual(new.IsInside(0), 1)
            self.assertEqual(new.IsInside(1000), 0)

    def test_cells_are_probed_at_their_centres(self):
        image = grid()
        output = probe(image, sphere(), Association=1).GetOutput()
        self.assertIsNone(output.GetPointData().GetArray("w"))
        w = vtk_to_numpy(output.GetCellData().GetArray("w"))
        for i in range(image.GetNumberOfCells()):
            bounds = image.GetCell(i).GetBounds()
            centre = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
            r = np.linalg.norm(centre)
            if r < 0.48 or r > 0.5:
                self.assertEqual(w[i], r < 0.5)

    def test_all_methods_agree(self):
        exact, naive, hierarchical, approximate = (
            vtk_to_numpy(probe(grid(), sphere(5), Method=m).GetOutput().GetPointData().GetArray("w"))
            for m in range(4))
        np.testing.assert_allclose(naive, exact, atol=1e-13)
        np.testing.assert_allclose(hierarchical, exact, atol=1e-13)
        self.assertLess(abs(approximate - exact).mean(), 0.02)
        better = probe(grid(), sphere(5), Method=3, ApproximationOrder=3, Accuracy=10).GetOutput()
        np.testing.assert_allclose(vtk_to_numpy(better.GetPointData().GetArray("w")), exact, atol=1e-4)

    def test_reverse_negates(self):
        given = vtk_to_numpy(probe(grid(), sphere(5)).GetOutput().GetPointData().GetArray("w"))
        turned = vtk_to_numpy(probe(grid(), sphere(5), Orientation=2).GetOutput().GetPointData().GetArray("w"))
        np.testing.assert_allclose(turned, -given, atol=1e-15)

    def test_duplicates_count_once_unless_asked_for(self):
        surface = sphere()
        for i in range(surface.GetNumberOfCells()):
            surface.GetPolys().InsertNextCell(surface.GetCell(i).GetPointIds())
        self.assertEqual(probe(grid(), surface).GetOutput().GetPointData().GetArray("w").GetRange()[1], 1)
        twice = probe(grid(), surface, CountDuplicates=True)
        self.assertEqual(twice.GetOutput().GetPointData().GetArray("w").GetRange()[1], 2)

    def test_merging_closes_gaps(self):
        surface = sphere()
        torn = vtkPolyData()
        points, polygons = vtkPoints(), vtkCellArray()
        points.SetDataTypeToDouble()
        shake = random.Random(1)
        for i in range(surface.GetNumberOfCells()):
            polygons.InsertNextCell(3)
            for k in range(3):
                x = surface.GetPoint(surface.GetCell(i).GetPointId(k))
                polygons.InsertCellPoint(points.InsertNextPoint([c + 1e-6 * shake.random() for c in x]))
        torn.SetPoints(points)
        torn.SetPolys(polygons)
        w = vtk_to_numpy(probe(grid(), torn, MergeTolerance=1e-5).GetOutput().GetPointData().GetArray("w"))
        self.assertEqual(set(w), {0.0, 1.0})

    def test_an_image_has_what_its_points_and_cells_have(self):
        points = vtkPoints()
        points.SetDataTypeToDouble()
        for surface in (sphere(), sphere(6)):
            image = grid(20)
            for association in (0, 1):
                for data in (image, rectilinear(image)):
                    places = vtkPolyData()
                    points = vtkPoints()
                    points.SetDataTypeToDouble()
                    if association == 0:
                        for i in range(data.GetNumberOfPoints()):
                            points.InsertNextPoint(data.GetPoint(i))
                    else:
                        for i in range(data.GetNumberOfCells()):
                            b = data.GetCell(i).GetBounds()
                            points.InsertNextPoint([b[2 * k] + 0.5 * (b[2 * k + 1] - b[2 * k]) for k in range(3)])
                    places.SetPoints(points)
                    expected = probe(places, surface).GetOutput().GetPointData()
                    output = probe(data, surface, Association=association).GetOutput()
                    found = output.GetCellData() if association else output.GetPointData()
                    for name in ("w", "Inside"):
                        np.testing.assert_allclose(
                            vtk_to_numpy(found.GetArray(name)), vtk_to_numpy(expected.GetArray(name)), atol=1e-14)

    def test_the_pieces_of_an_image_are_those_of_the_whole(self):
        source = vtkRTAnalyticSource()
        source.SetWholeExtent(-8, 9, -7, 7, -6, 5)
        filters = [insideout.vtkProbeWindingNumber() for _ in range(2)]
        for filter_ in filters:
            filter_.SetInputConnection(source.GetOutputPort())
            filter_.SetSurfaceData(scaled(sphere(6), 12))
        filters[0].UpdateExtent((-3, 4, -7, 0, 2, 5))
        part = filters[0].GetOutput()
        filters[1].Update()
        whole = filters[1].GetOutput()
        self.assertEqual(part.GetExtent(), (-3, 4, -7, 0, 2, 5))
        w = part.GetPointData().GetArray("w")
        for i in range(part.GetNumberOfPoints()):
            same = whole.FindPoint(part.GetPoint(i))
            self.assertAlmostEqual(w.GetValue(i), whole.GetPointData().GetArray("w").GetValue(same), delta=1e-14)

    def test_the_mask_alone_is_that_beside_w(self):
        for surface in (sphere(), sphere(40)):
            for threshold in (0.5, 0.3, 1.0):
                both = probe(grid(30), surface, Threshold=threshold).GetOutput().GetPointData()
                mask = probe(grid(30), surface, Threshold=threshold, OutputWindingNumber=False).GetOutput().GetPointData()
                self.assertIsNone(mask.GetArray("w"))
                self.assertEqual(mask.GetScalars().GetName(), "Inside")
                np.testing.assert_array_equal(vtk_to_numpy(mask.GetArray("Inside")), vtk_to_numpy(both.GetArray("Inside")))

    def test_distances_are_those_of_vtk_where_its_sign_is_right(self):
        image = grid(12)
        output = probe(image, sphere(), Distance=True, ClosestPoints=True).GetOutput().GetPointData()
        vtks = vtkImplicitPolyDataDistance()
        surface = sphere()
        vtks.SetInput(surface)
        distance = vtk_to_numpy(output.GetArray("Distance"))
        closest = vtk_to_numpy(output.GetArray("ClosestPoint"))
        cells = vtk_to_numpy(output.GetArray("ClosestCellId"))
        for i in range(image.GetNumberOfPoints()):
            place = np.array(image.GetPoint(i))
            self.assertAlmostEqual(distance[i], vtks.EvaluateFunction(place), delta=1e-7)
            self.assertAlmostEqual(abs(distance[i]), np.linalg.norm(place - closest[i]), delta=1e-14)
            bounds = np.array(surface.GetCell(int(cells[i])).GetBounds()).reshape(3, 2).T
            self.assertTrue(np.all(bounds[0] - 1e-7 <= closest[i]) and np.all(closest[i] <= bounds[1] + 1e-7))

    def test_the_sign_of_distances_is_right_where_the_surface_is_open(self):
        image = grid(20)
        surface = sphere(40)
        r = radii(image)
        certain = (r < 0.4) | (r > 0.52)
        distance = vtk_to_numpy(probe(image, surface, Distance=True).GetOutput().GetPointData().GetArray("Distance"))
        turned = vtk_to_numpy(
            probe(image, surface, Distance=True, InsideOut=True).GetOutput().GetPointData().GetArray("Distance"))
        np.testing.assert_array_equal(distance, turned)
        np.testing.assert_array_equal(distance[certain] < 0, r[certain] < 0.5)
        vtks = vtkImplicitPolyDataDistance()
        vtks.SetInput(surface)
        theirs = np.array([vtks.EvaluateFunction(image.GetPoint(i)) for i in range(image.GetNumberOfPoints())])
        self.assertGreater(np.count_nonzero((theirs < 0) != (r < 0.5)), 0)  # why this class has its own sign

    def test_data_are_passed_on_and_clashing_arrays_renamed(self):
        image = grid()
        for name in ("w", "other"):
            array = numpy_to_vtk(np.arange(image.GetNumberOfPoints(), dtype=float), deep=1)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        warned = []
        filter_ = insideout.vtkProbeWindingNumber()
        filter_.AddObserver("WarningEvent", lambda *_: warned.append(1))
        filter_.SetInputData(image)
        filter_.SetSurfaceData(sphere())
        filter_.Update()
        data = filter_.GetOutput().GetPointData()
        self.assertEqual(data.GetArray("Input_w").GetValue(7), 7)
        self.assertEqual(data.GetArray("other").GetValue(7), 7)
        self.assertTrue(warned)
        self.assertEqual(image.GetPointData().GetNumberOfArrays(), 2)

    def test_errors_name_the_culprit(self):
        bad = sphere()
        points = vtkPoints()
        points.DeepCopy(bad.GetPoints())
        points.SetPoint(17, 0, float("nan"), 0)
        bad.SetPoints(points)
        with self.assertRaisesRegex(insideout.Error, "point 17"):
            filter_ = insideout.vtkProbeWindingNumber()
            filter_.SetInputData(grid())
            filter_.SetSurfaceData(bad)
            insideout.pipeline.run(filter_)


class TestVoxels(unittest.TestCase):
    def test_a_stencil_has_the_voxels_that_the_probe_has(self):
        for surface in (sphere(), sphere(40)):
            image = grid(30)
            stencil = insideout.vtkWindingNumberToImageStencil()
            stencil.SetInputData(surface)
            stencil.SetInformationInput(image)
            painted = painted_by(stencil, image)
            np.testing.assert_array_equal(
                painted, vtk_to_numpy(probe(image, surface).GetOutput().GetPointData().GetArray("Inside")))
            self.assertGreater(painted.sum(), 500)

    def test_a_stencil_of_no_surface_is_an_error_and_empty(self):
        stencil = insideout.vtkWindingNumberToImageStencil()
        stencil.SetInputData(vtkPolyData())
        stencil.SetInformationInput(grid())
        with self.assertRaises(insideout.Error):
            insideout.pipeline.run(stencil)
        self.assertEqual(stencil.GetOutput().IsInside(4, 4, 4), 0)
        self.assertEqual(stencil.GetOutput().GetExtent(), (0, -1, 0, -1, 0, -1))

    def test_a_stencil_of_lines_alone_is_an_error_and_empty(self):
        image = vtkImageData()
        image.SetDimensions(200, 200, 3)  # more places than winding numbers of lines are calculated for at once
        image.SetOrigin(-1, -1, -1)
        image.SetSpacing(0.01, 0.01, 1)
        stencil = insideout.vtkWindingNumberToImageStencil()
        stencil.SetInputData(outline())
        stencil.SetInformationInput(image)
        with self.assertRaisesRegex(insideout.Error, "lines but no polygons"):
            insideout.pipeline.run(stencil)
        self.assertEqual(stencil.GetOutput().GetExtent(), (0, -1, 0, -1, 0, -1))

    def test_a_stencil_of_an_image_that_is_turned_is_an_error(self):
        image = grid()
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        stencil = insideout.vtkWindingNumberToImageStencil()
        stencil.SetInputData(sphere())
        stencil.SetInformationInput(image)
        with self.assertRaisesRegex(insideout.Error, "axes are not x, y and z"):
            insideout.pipeline.run(stencil)
        self.assertEqual(stencil.GetOutput().IsInside(4, 4, 4), 0)

    def test_fractions_sum_to_the_volume(self):
        result = insideout.tetrahedralize(sphere(4))
        for data in (grid(9), rectilinear(grid(9))):
            fractions = insideout.vtkVoxelFractions()
            fractions.SetInputData(data)
            for solid in (result.solid, result.hull):
                fractions.SetSolidData(solid.GetOutput() if hasattr(solid, "GetOutput") else solid)
                fractions.Update()
                values = vtk_to_numpy(fractions.GetOutput().GetCellData().GetArray("VolumeFraction"))
                self.assertTrue(values.min() >= -1e-14 and values.max() <= 1 + 1e-14)
                self.assertAlmostEqual(values.sum() * np.prod(grid(9).GetSpacing()), result.statistics["Volume"], 13)

    def test_fractions_of_a_flat_image_are_an_error(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 1)
        fractions = insideout.vtkVoxelFractions()
        fractions.SetInputData(image)
        fractions.SetSolidData(insideout.tetrahedralize(sphere()).solid)
        with self.assertRaisesRegex(insideout.Error, "along z"):
            insideout.pipeline.run(fractions)

    def test_fractions_of_voxels_without_a_volume_in_double_precision_are_an_error(self):
        for spacing, culprit in ((1e-200, "too small"), (1e200, "too large")):
            image = grid()
            image.SetOrigin(0, 0, 0)
            image.SetSpacing(spacing, spacing, spacing)
            fractions = insideout.vtkVoxelFractions()
            fractions.SetInputData(image)
            fractions.SetSolidData(insideout.tetrahedralize(sphere(resolution=5)).solid)
            with self.assertRaisesRegex(insideout.Error, culprit):
                insideout.pipeline.run(fractions)

    def test_fractions_of_a_solid_whose_array_is_too_short_are_an_error(self):
        solid = insideout.tetrahedralize(sphere(resolution=5)).solid
        inside = vtkDoubleArray()
        inside.SetName("Inside")
        inside.InsertNextValue(1)
        solid.GetCellData().AddArray(inside)
        fractions = insideout.vtkVoxelFractions()
        fractions.SetInputData(grid())
        fractions.SetSolidData(solid)
        with self.assertRaisesRegex(insideout.Error, f"Inside has 1 tuples for {solid.GetNumberOfCells()} cells"):
            insideout.pipeline.run(fractions)


def painted_by(stencil, image):
    """1 for each point of the image that the stencil has."""
    stencil.Update()
    data = stencil.GetOutput()
    dimensions = image.GetDimensions()
    return np.array([data.IsInside(i, j, k) for k in range(dimensions[2]) for j in range(dimensions[1]) for i in range(dimensions[0])])


def function(surface):
    implicit = insideout.vtkImplicitWindingNumber()
    implicit.SetInput(surface)
    return implicit


class TestImplicitFunction(unittest.TestCase):
    def test_it_clips(self):
        clip = vtkClipDataSet()
        clip.SetInputData(grid(20))
        clip.SetClipFunction(function(sphere(4)))
        clip.InsideOutOn()
        clip.Update()
        output = clip.GetOutput()
        self.assertGreater(output.GetNumberOfCells(), 100)
        self.assertLess(radii(output).max(), 0.6)

    def test_it_cuts(self):
        cut = vtkCutter()
        cut.SetInputData(grid(20))
        cut.SetCutFunction(function(sphere(4)))
        cut.Update()
        r = radii(cut.GetOutput())
        self.assertGreater(len(r), 100)
        self.assertTrue(r.min() > 0.3 and r.max() < 0.6)

    def test_it_is_sampled_and_contoured(self):
        sample = vtkSampleFunction()
        sample.SetImplicitFunction(function(sphere()))
        sample.SetModelBounds(-1, 1, -1, 1, -1, 1)
        sample.SetSampleDimensions(40, 40, 40)
        sample.ComputeNormalsOff()
        contour = vtkContourFilter()
        contour.SetInputConnection(sample.GetOutputPort())
        contour.SetValue(0, 0)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(contour.GetOutputPort())
        mass = vtkMassProperties()
        mass.SetInputConnection(triangles.GetOutputPort())
        mass.Update()
        ball = 4 / 3 * np.pi * 0.5**3
        self.assertAlmostEqual(mass.GetVolume(), ball, delta=0.1 * ball)
        values = vtk_to_numpy(sample.GetOutput().GetPointData().GetScalars())
        self.assertEqual(set(values), {-0.5, 0.5})

    def test_it_extracts(self):
        extract = vtkExtractGeometry()
        extract.SetInputData(grid(20))
        extract.SetImplicitFunction(function(sphere(4)))
        extract.Update()
        self.assertGreater(extract.GetOutput().GetNumberOfCells(), 100)
        self.assertLess(radii(extract.GetOutput()).max(), 0.55)

    def test_arrays_and_single_points_agree(self):
        implicit = function(sphere(4))
        image = grid(6)
        points = vtkDoubleArray()
        points.SetNumberOfComponents(3)
        for i in range(image.GetNumberOfPoints()):
            points.InsertNextTuple(image.GetPoint(i))
        values = vtkDoubleArray()
        implicit.FunctionValue(points, values)
        for i in range(image.GetNumberOfPoints()):
            self.assertAlmostEqual(values.GetValue(i), implicit.FunctionValue(points.GetTuple(i)), 14)

    def test_the_gradient_is_that_of_differences(self):
        implicit = function(sphere(4))
        chance = random.Random(2)
        for _ in range(50):
            x = [chance.uniform(-1, 1) for _ in range(3)]
            gradient = [0, 0, 0]
            implicit.FunctionGradient(x, gradient)
            for k in range(3):
                h = 1e-5
                above, below = list(x), list(x)
                above[k] += h
                below[k] -= h
                difference = implicit.FunctionValue(above) - implicit.FunctionValue(below)
                difference -= round(difference)
                self.assertAlmostEqual(gradient[k], difference / (2 * h), delta=1e-3 * max(1, abs(gradient[k])))
        closed = function(sphere())
        gradient = [1, 1, 1]
        closed.FunctionGradient([0.1, 0.2, 0.3], gradient)
        self.assertEqual(gradient, [0, 0, 0])

    def test_a_signed_distance_has_the_gradient_of_differences(self):
        for surface in (sphere(), sphere(4)):
            implicit = function(surface)
            implicit.SignedDistanceOn()
            chance = random.Random(2)
            for _ in range(50):
                x = [chance.uniform(-1, 1) for _ in range(3)]
                value = implicit.FunctionValue(x)
                self.assertEqual(value < 0, function(surface).FunctionValue(x) < 0)
                gradient = [0, 0, 0]
                implicit.FunctionGradient(x, gradient)
                self.assertAlmostEqual(np.linalg.norm(gradient), 1, delta=1e-12)
                step = 1e-6
                ahead = implicit.FunctionValue([c + step * g for c, g in zip(x, gradient)])
                if abs(value) > 2 * step and (ahead < 0) == (value < 0):
                    self.assertAlmostEqual((ahead - value) / step, 1, delta=1e-6)
            self.assertLess(implicit.FunctionValue(0, 0, 0), -0.4)

    def test_distances_of_lines_are_an_error(self):
        with self.assertRaisesRegex(insideout.Error, "distances are of polygons only"):
            insideout.distance(outline(), [(0, 0, 0)])

    def test_it_follows_the_surface_and_the_properties(self):
        surface = sphere()
        implicit = function(surface)
        self.assertEqual(implicit.FunctionValue(0, 0, 0), -0.5)
        implicit.SetOrientation(2)
        self.assertEqual(implicit.FunctionValue(0, 0, 0), 1.5)
        implicit.SetOrientation(1)
        for i in range(surface.GetNumberOfPoints()):
            x = surface.GetPoint(i)
            surface.GetPoints().SetPoint(i, x[0] + 5, x[1], x[2])
        surface.GetPoints().Modified()
        self.assertEqual(implicit.FunctionValue(0, 0, 0), 0.5)
        self.assertEqual(implicit.FunctionValue(5, 0, 0), -0.5)
        implicit.SetInput(None)
        self.assertEqual(implicit.FunctionValue(5, 0, 0), 0.5)

    def test_a_surface_of_no_use_is_an_error_and_all_is_outside(self):
        implicit = function(vtkPolyData())
        errors = []
        implicit.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        self.assertEqual(implicit.FunctionValue(0, 0, 0), 0.5)
        self.assertEqual(implicit.FunctionValue(1, 0, 0), 0.5)
        self.assertEqual(len(errors), 1)

    def test_quadrature_changes_open_cells_only(self):
        for surface, changes in ((sphere(0, 12), False), (sphere(4, 12), True)):
            values = []
            for order in (1, 5):
                filter_ = insideout.vtkGeneralizedWindingNumber()
                filter_.SetInputData(surface)
                filter_.SetQuadratureOrder(order)
                filter_.Update()
                values.append(vtk_to_numpy(filter_.GetOutput().GetCellData().GetArray("w")))
            self.assertEqual(np.any(values[0] != values[1]), changes)
            self.assertLess(abs(values[0] - values[1]).max(), 0.5)


if __name__ == "__main__":
    unittest.main()
