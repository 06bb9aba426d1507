# SPDX-License-Identifier: GPL-3.0-or-later
"""Points with normals, without triangles, as the surface of a probe, of an implicit function and of the command line."""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import insideout
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

RADIUS = 2.0


def sphere(count=3000):
    """Points all over a sphere, along a spiral, and their normals."""
    z = -1 + (2 * np.arange(count) + 1) / count
    across = np.sqrt(1 - z**2)
    longitude = np.cumsum(3.6 / np.sqrt(count) / across)
    normals = np.stack([across * np.cos(longitude), across * np.sin(longitude), z], axis=1)
    return RADIUS * normals, normals


def places(count=2000):
    return np.random.default_rng(1).uniform(-1.5 * RADIUS, 1.5 * RADIUS, (count, 3))


def dipoles(points, normals, areas, where):
    """The sum as it is written."""
    r = points[None] - where[:, None]
    distance = np.maximum(np.linalg.norm(r, axis=2), np.sqrt(areas / np.pi))
    return (areas * (r * normals).sum(axis=2) / (4 * np.pi * distance**3)).sum(axis=1)


class TestClouds(unittest.TestCase):
    def test_w_is_the_sum_of_dipoles(self):
        points, normals = sphere(500)
        areas = np.random.default_rng(2).uniform(0, 0.2, len(points))
        where = np.concatenate([places(500), points[:10]])
        expected = dipoles(points, normals, areas, where)
        cloud = insideout.point_cloud(points, 7 * normals, areas)
        np.testing.assert_allclose(insideout.winding_number(cloud, where), expected, atol=2e-3)
        naive = insideout.vtkProbeWindingNumber()
        naive.SetInputData(insideout.inputs.as_points(where))
        naive.SetSurfaceData(cloud)
        naive.SetMethod(insideout.vtkProbeWindingNumber.NAIVE)
        naive.Update()
        np.testing.assert_allclose(vtk_to_numpy(naive.GetOutput().GetPointData().GetArray("w")), expected, atol=1e-12)

    def test_inside_is_right_without_areas(self):
        where = places()
        radius = np.linalg.norm(where, axis=1)
        clear = abs(radius - RADIUS) > 0.1  # points are as far apart
        inside = insideout.inside(insideout.point_cloud(*sphere()), where)
        np.testing.assert_array_equal(inside[clear], radius[clear] < RADIUS)

    def test_voxels_and_stencils_take_clouds(self):
        cloud = insideout.point_cloud(*sphere())
        inside, _ = insideout.voxels(cloud, 0.1)
        self.assertAlmostEqual(inside.sum() * 1e-3 / (4 / 3 * np.pi * RADIUS**3), 1, delta=0.02)
        image = image_of(20)
        stencil = insideout.vtkWindingNumberToImageStencil()
        stencil.SetInputData(cloud)
        stencil.SetInformationInput(image)
        stencil.Update()
        found = [stencil.GetOutput().IsInside(*np.unravel_index(i, (20, 20, 20), "F")) for i in range(8000)]
        where = np.array([image.GetPoint(i) for i in range(8000)])
        np.testing.assert_array_equal(np.array(found, bool), insideout.inside(cloud, where))

    def test_the_implicit_function_has_a_contour_at_the_surface(self):
        function = insideout.vtkImplicitWindingNumber()
        function.SetInput(insideout.point_cloud(*sphere()))
        image = image_of(40)
        values = [function.EvaluateFunction(image.GetPoint(i)) for i in range(image.GetNumberOfPoints())]
        image.GetPointData().SetScalars(insideout.serializing.vtk_array(np.array(values)))
        contour = vtkFlyingEdges3D()
        contour.SetInputData(image)
        contour.SetValue(0, 0)
        contour.Update()
        radii = np.linalg.norm(vtk_to_numpy(contour.GetOutput().GetPoints().GetData()), axis=1)
        self.assertGreater(len(radii), 1000)
        self.assertLess(abs(radii - RADIUS).max(), 0.05)

    def test_the_gradient_is_that_of_differences(self):
        function = insideout.vtkImplicitWindingNumber()
        points, normals = sphere(300)
        function.SetInput(insideout.point_cloud(points[:200], normals[:200]))  # open
        where, step = np.array([0.3, 1.1, 1.2]), 1e-6
        gradient = [0, 0, 0]
        function.EvaluateGradient(where, gradient)
        for axis, shift in enumerate(step * np.eye(3)):
            rise = function.EvaluateFunction(where + shift) - function.EvaluateFunction(where - shift)
            self.assertAlmostEqual(gradient[axis], rise / (2 * step), delta=0.02)
        self.assertGreater(np.linalg.norm(gradient), 0.1)

    def test_normals_may_point_inward(self):
        points, normals = sphere()
        for vtk_orientation, expected, warned in ((0, 0, True), (1, 0, True), (2, 1, False)):
            probe = insideout.vtkProbeWindingNumber()
            probe.SetInputData(insideout.inputs.as_points([[0, 0, 0.0]]))
            probe.SetSurfaceData(insideout.point_cloud(points, -normals))
            probe.SetOrientation(vtk_orientation)
            warnings = insideout.pipeline.run(probe)
            self.assertEqual(probe.IsInside(0), expected)
            self.assertEqual(any("seem to point inward" in warning for warning in warnings), warned)

    def test_vertices_do_not_matter_and_polygons_do(self):
        points, normals = sphere(300)
        cloud = insideout.point_cloud(points, normals)
        w = insideout.winding_number(cloud, places(50))
        vertices = vtkCellArray()
        vertices.InsertNextCell(1, [3])
        cloud.SetVerts(vertices)
        np.testing.assert_array_equal(insideout.winding_number(cloud, places(50)), w)
        triangle = vtkCellArray()
        triangle.InsertNextCell(3, [0, 100, 200])
        cloud.SetPolys(triangle)
        self.assertLess(abs(insideout.winding_number(cloud, places(50))).max(), 0.5)

    def test_an_array_of_another_name_has_the_areas(self):
        points, normals = sphere(300)
        cloud = insideout.point_cloud(points, normals, np.ones(300))
        probe = insideout.vtkProbeWindingNumber()
        probe.SetInputData(insideout.inputs.as_points([[0, 0, 0.0]]))
        probe.SetSurfaceData(cloud)
        means = []
        for name, area in (("Area", 1), ("Doubled", 2)):
            cloud.GetPointData().GetArray("Area").FillComponent(0, area)
            cloud.GetPointData().GetArray("Area").SetName(name)
            cloud.Modified()
            probe.SetAreaArrayName(name)
            probe.Update()
            means.append(probe.GetOutput().GetPointData().GetArray("w").GetValue(0))
        self.assertAlmostEqual(means[1], 2 * means[0], places=12)

    def test_errors_name_the_culprit(self):
        points, normals = sphere(20)
        bad = {}
        bad["point 3 of the cloud is not finite"] = (points.copy(), normals, None)
        bad["point 3 of the cloud is not finite"][0][3, 1] = np.nan
        bad["point 4 of the cloud has a normal of length 0"] = (points, normals.copy(), None)
        bad["point 4 of the cloud has a normal of length 0"][1][4] = 0
        bad["point 5 of the cloud has a normal that is not finite"] = (points, normals.copy(), None)
        bad["point 5 of the cloud has a normal that is not finite"][1][5, 2] = np.inf
        bad["point 6 of the cloud has the area -1"] = (points, normals, np.ones(20))
        bad["point 6 of the cloud has the area -1"][2][6] = -1
        for words, cloud in bad.items():
            with self.assertRaisesRegex(insideout.Error, words):
                insideout.winding_number(insideout.point_cloud(*cloud), places(3))
        bare = vtkPolyData()
        bare.SetPoints(vtkPoints())
        bare.GetPoints().InsertNextPoint(1, 2, 3)
        with self.assertRaisesRegex(insideout.Error, "no polygons, and its points have no normals"):
            insideout.winding_number(bare, places(3))
        with self.assertRaisesRegex(insideout.Error, "points but no polygons; distances are of polygons only"):
            insideout.distance(insideout.point_cloud(points, normals), places(3))
        with self.assertRaisesRegex(insideout.Error, r"normals has the shape \(19, 3\); with 20 points it must be \(20, 3\)"):
            insideout.point_cloud(points, normals[1:])
        with self.assertRaisesRegex(insideout.Error, "normals has the shape"):
            insideout.point_cloud(points, None)
        with self.assertRaisesRegex(insideout.Error, r"areas has the shape \(20, 3\)"):
            insideout.point_cloud(points, normals, normals)

    def test_arrays_of_another_length_are_refused(self):
        for name, words in (("Normals", "the cloud has 3 normals for 20 points"), ("Area", "the cloud has 3 areas for 20 points")):
            cloud = insideout.point_cloud(*sphere(20), np.ones(20))
            cloud.GetPointData().GetArray(name).SetNumberOfTuples(3)
            with self.assertRaisesRegex(insideout.Error, words):
                insideout.winding_number(cloud, places(3))

    def test_the_command_takes_a_cloud_in_a_file(self):
        points, normals = sphere()
        header = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
        header += [f"property double {name}" for name in ("x", "y", "z", "nx", "ny", "nz")] + ["end_header"]
        rows = [" ".join(map(repr, map(float, row))) for row in np.hstack([points, normals])]
        with tempfile.TemporaryDirectory() as folder:
            at = Path(folder)
            (at / "cloud.ply").write_text("\n".join(header + rows) + "\n")
            (at / "places.csv").write_text("x,y,z\n0,0,0\n0,0,3\n")
            done = subprocess.run(
                [sys.executable, "-m", "insideout", "--winding", "places.csv", "cloud.ply", "w.csv"],
                cwd=at, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
            )
            self.assertEqual(done.returncode, 0, done.stdout)
            with open(at / "w.csv", newline="") as file:
                found = list(csv.DictReader(file))
        self.assertEqual([row["inside"] for row in found], ["1", "0"])
        self.assertAlmostEqual(float(found[0]["w"]), 1, delta=0.01)


def image_of(size):
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetOrigin(*[-1.2 * RADIUS] * 3)
    image.SetSpacing(*[2.4 * RADIUS / (size - 1)] * 3)
    return image


if __name__ == "__main__":
    unittest.main()
