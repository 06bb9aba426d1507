# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distances on grids: their laws, what overlapping spheres have, and the files that others read."""

import os
import tempfile
import unittest
import warnings

import insideout
import numpy as np
import surfaces
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkNrrdReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

RADIUS, APART = 1.0, 1.2
FLAT = 0.004  # how far triangles of the spheres below are from these, at most


def two_spheres():
    """Spheres around (-0.6, 0, 0) and (0.6, 0, 0) that overlap."""
    made = []
    for side in (-1, 1):
        ball = surfaces.ball(RADIUS, 80, 81)
        made.append(surfaces.polydata(surfaces.points_of(ball) + [side * APART / 2, 0, 0], surfaces.triangles_of(ball)))
    return surfaces.joined(*made)


def distance_to_union(points: np.ndarray) -> np.ndarray:
    """From the boundary of both balls together, negative inside, in closed form."""
    x, r = np.abs(points[..., 0]), np.hypot(points[..., 1], points[..., 2])
    outward, rim = x - APART / 2, np.sqrt(RADIUS**2 - (APART / 2) ** 2)
    to_sphere = np.hypot(outward, r) - RADIUS
    # For the part of a sphere that is not on the boundary the nearest point is on the rim where both meet.
    nearest_is_hidden = outward * rim < -APART / 2 * r
    to_rim = np.hypot(x, r - rim)
    inside = to_sphere < 0
    return np.where(nearest_is_hidden, np.where(inside, -to_rim, to_rim), to_sphere)


def points_of(grid: insideout.DistanceGrid) -> np.ndarray:
    return grid.origin + grid.spacing * np.stack(np.indices(grid.distance.shape), axis=-1)


class Laws(unittest.TestCase):
    def test_the_distance_to_the_solid_is_that_from_the_boundary_of_the_union(self):
        grid = insideout.sdf_grid(two_spheres(), shape=(60, 48, 48))
        expected = distance_to_union(points_of(grid))
        np.testing.assert_allclose(grid.distance, expected, atol=FLAT)
        certain = np.abs(expected) > FLAT
        np.testing.assert_array_equal(grid.inside[certain], expected[certain] < 0)

    def test_the_distance_to_the_surface_knows_the_walls_within(self):
        solid, surface = (insideout.sdf_grid(two_spheres(), shape=40, to=to) for to in ("solid", "surface"))
        np.testing.assert_array_equal(solid.inside, surface.inside)
        points = points_of(surface)
        nearest = np.min([np.abs(np.linalg.norm(points - [side * APART / 2, 0, 0], axis=-1) - RADIUS) for side in (-1, 1)], axis=0)
        np.testing.assert_allclose(np.abs(surface.distance), nearest, atol=FLAT)
        self.assertGreater((np.abs(solid.distance) - np.abs(surface.distance)).max(), 0.3)

    def test_the_sign_agrees_with_the_solid(self):
        for name, surface in (("boxes", surfaces.two_boxes()), ("open", surfaces.open_box()), ("turned", surfaces.reversed_box())):
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("ignore", insideout.Warning)
                grid = insideout.sdf_grid(surface, shape=23, padding=0.3)
                solid = insideout.tetrahedralize(surface).solid
                corners = solid.points[solid.cells]
                edges = corners[:, 1:] - corners[:, :1]
                weights = np.einsum("cji,pcj->pci", np.linalg.inv(edges), points_of(grid).reshape(-1, 1, 3) - corners[:, 0])
                held = ((weights > -1e-9).all(-1) & (weights.sum(-1) < 1 + 1e-9)).any(-1).reshape(grid.inside.shape)
                clear = np.abs(grid.distance) > 1e-7
                np.testing.assert_array_equal(grid.inside[clear], held[clear])
                np.testing.assert_array_equal(grid.distance[clear] < 0, held[clear])
                self.assertTrue(0 < held.sum() < held.size)

    def test_neighbors_never_differ_by_more_than_they_are_apart(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", insideout.Warning)
            for surface in (two_spheres(), surfaces.open_box(), surfaces.two_boxes()):
                grid = insideout.sdf_grid(surface, spacing=(0.11, 0.13, 0.17))
                for axis, step in enumerate(grid.spacing):
                    self.assertLessEqual(np.abs(np.diff(grid.distance, axis=axis)).max(), step * (1 + 1e-12))

    def test_values_are_those_at_points_one_by_one(self):
        """Enough points for shared searches, and for more than one box of them, with padding on all sides."""
        surface = two_spheres()
        grid = insideout.sdf_grid(surface, shape=(70, 36, 35), to="surface")
        self.assertEqual(grid.distance.shape, (70, 36, 35))
        points = points_of(grid)
        chosen = tuple(np.random.default_rng(3).integers(0, grid.distance.shape, (500, 3)).T)
        np.testing.assert_allclose(grid.distance[chosen], insideout.distance(surface, points[chosen]), rtol=0, atol=1e-14)
        self.assertEqual(insideout.inside(surface, points).tolist(), grid.inside.tolist())


class Shape(unittest.TestCase):
    def test_a_shape_covers_the_padded_box_with_one_spacing(self):
        grid = insideout.sdf_grid(surfaces.box(size=2), shape=(11, 21, 9), padding=0.5)
        self.assertEqual(grid.distance.shape, (11, 21, 9))
        self.assertEqual(grid.inside.shape, (11, 21, 9))
        np.testing.assert_allclose(grid.spacing, 3 / 8)
        np.testing.assert_allclose(grid.origin + grid.spacing * (np.array(grid.distance.shape) - 1) / 2, 1)
        self.assertEqual(insideout.sdf_grid(surfaces.box(), shape=7).distance.shape, (7, 7, 7))

    def test_a_spacing_covers_the_padded_box(self):
        grid = insideout.sdf_grid(surfaces.box(), spacing=(0.1, 0.2, 0.3), padding=0.1)
        self.assertEqual(grid.distance.shape, (13, 7, 5))
        np.testing.assert_array_equal(grid.spacing, [0.1, 0.2, 0.3])
        np.testing.assert_allclose(grid.origin, [-0.1, -0.1, -0.1])
        self.assertLessEqual(grid.origin.max(), -0.1 + 1e-12)

    def test_a_scale_and_an_orientation_hold_for_it(self):
        one, other = insideout.sdf_grid(surfaces.box(size=3), shape=9), insideout.sdf_grid(surfaces.box(), shape=9, scale=3)
        np.testing.assert_array_equal(one.distance, other.distance)
        reversed_ = insideout.sdf_grid(surfaces.reversed_box(), shape=9, orientation="reverse", scale=3)
        np.testing.assert_array_equal(one.distance, reversed_.distance)

    def test_progress_runs_from_the_solid_to_the_distances(self):
        heard = []
        insideout.sdf_grid(surfaces.two_boxes(), shape=5, progress=lambda stage, fraction: heard.append((fraction, stage)))
        self.assertEqual([fraction for fraction, _ in heard], sorted(fraction for fraction, _ in heard))
        self.assertIn("distances", {stage for _, stage in heard})

    def test_wrong_shapes_and_spacings_are_errors(self):
        flat = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        for arguments, words in (
            ({}, "either shape or spacing"),
            ({"shape": 3, "spacing": 1}, "either shape or spacing"),
            ({"shape": 1}, "shape is 1; it must be finite and at least 2"),
            ({"shape": (3, 4)}, "shape has 2 numbers"),
            ({"shape": 2.5}, "shape is 2.5; it must be whole numbers"),
            ({"shape": 10**5}, "which makes 1e.15 points"),
            ({"spacing": 0}, "spacing is 0; it must be above 0"),
            ({"shape": 3, "padding": -1}, "padding is -1"),
            ({"shape": 3, "to": "walls"}, "to is 'walls'; it can be 'solid', 'surface'"),
            ({"surface": flat, "shape": 3}, "lies in a plane"),
        ):
            with self.subTest(words), self.assertRaisesRegex(insideout.Error, words):
                insideout.sdf_grid(**{"surface": surfaces.box(), **arguments})


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.grid = insideout.sdf_grid(surfaces.two_boxes(), shape=(12, 8, 7))

    def written(self, name: str) -> str:
        path = os.path.join(self.folder, name)
        insideout.write(self.grid, path)
        return path

    def expect_image(self, image, name) -> None:
        self.assertEqual(image.GetDimensions(), self.grid.distance.shape)
        np.testing.assert_allclose(image.GetOrigin(), self.grid.origin, rtol=1e-15)
        np.testing.assert_allclose(image.GetSpacing(), self.grid.spacing, rtol=1e-15)
        array = image.GetPointData().GetArray(name) if name else image.GetPointData().GetScalars()
        np.testing.assert_array_equal(vtk_to_numpy(array), self.grid.distance.ravel(order="F"))

    def test_numpy(self):
        read = np.load(self.written("grid.npz"))
        for name in ("distance", "inside", "origin", "spacing"):
            np.testing.assert_array_equal(read[name], getattr(self.grid, name))
        self.assertEqual(str(read["to"]), "solid")

    def test_nrrd_by_vtks_reader(self):
        reader = vtkNrrdReader()
        path = self.written("grid.nrrd")
        self.assertTrue(reader.CanReadFile(path))
        reader.SetFileName(path)
        reader.Update()
        self.expect_image(reader.GetOutput(), None)

    def test_vti(self):
        reader = vtkXMLImageDataReader()
        reader.SetFileName(self.written("grid.vti"))
        reader.Update()
        self.expect_image(reader.GetOutput(), "Distance")
        inside = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("Inside"))
        np.testing.assert_array_equal(inside, self.grid.inside.ravel(order="F"))

    def test_other_endings_are_refused(self):
        with self.assertRaisesRegex(insideout.Error, r"must be \.npz \.nrrd \.vti"):
            self.written("grid.vtu")

    def test_a_picture_of_it_needs_no_display(self):
        self.assertTrue(self.grid.png().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
