# SPDX-License-Identifier: GPL-3.0-or-later
"""Which way facets face: mesh, probe, implicit function, check and command agree on it, and say what was turned over."""

import os
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from insideout.files import read_surface
from real_surfaces import unpack_cgal, unpack_openfoam
from surfaces import BOX_FACETS, box_points, cell_array, exact_volumes, polydata
from command import CommandLine, run
from vtkmodules.util.numpy_support import vtk_to_numpy

MESHES = ("b9_mesh.off", "mannequin-devil.off", "head.off", "boeing.off", "blobby-shuffled.off", "cow.off")


def boxes(*of):
    """Boxes of (low corner, size, whether outward) each, and a large open square below if there is a None."""
    points, facets = [], []
    for one in of:
        if one is None:
            corners = [(-10, -10, -1), (10, -10, -1), (10, 10, -1), (-10, 10, -1)]
            own = [(0, 1, 2), (0, 2, 3)]
        else:
            low, size, outward = one
            corners, own = box_points(low, size), [facet if outward else facet[::-1] for facet in BOX_FACETS]
        facets += [tuple(corner + len(points) for corner in facet) for facet in own]
        points += corners
    return polydata(points, facets)


def volume(result) -> float:
    return float(sum(exact_volumes(result.solid)))


SEPARATE = boxes(((0, 0, 0), 1, True), ((3, 0, 0), 2, False))
OVERLAPPING = boxes(((0, 0, 0), 2, True), ((1, 1, 1), 2, False))
HOLLOW = boxes(((0, 0, 0), 3, True), ((1, 1, 1), 1, False))
HOLLOW_INSIDE_OUT = boxes(((0, 0, 0), 3, False), ((1, 1, 1), 1, True))
ABOVE_GROUND = boxes(((0, 0, 0), 1, True), ((3, 0, 0), 1, True), None)


class Solid(unittest.TestCase):
    def test_only_what_is_inside_out_is_turned_over(self):
        for name, surface, expected, turned in (
            ("separate", SEPARATE, 9, 12),
            ("overlapping", OVERLAPPING, 15, 12),
            ("hollow", HOLLOW, 26, 0),
            ("hollow inside out", HOLLOW_INSIDE_OUT, 26, 24),
            ("above ground", ABOVE_GROUND, 2, 0),
        ):
            with self.subTest(name):
                result = insideout.tetrahedralize(surface)
                self.assertAlmostEqual(volume(result), expected, delta=1e-9)
                self.assertEqual(result.statistics["TurnedFacets"], turned)

    def test_turned_facets_are_listed_marked_and_warned_of(self):
        result = insideout.tetrahedralize(SEPARATE)
        self.assertEqual(list(result.turned_cells), list(range(12, 24)))
        turned = cell_array(result.boundary, "Turned")
        np.testing.assert_array_equal(turned == 1, cell_array(result.boundary, "vtkOriginalCellIds") >= 12)
        self.assertIn("1 of 2 shells are inside out and are turned over (12 facets, 80 % of the area)", result.warnings)
        marked = insideout.check(SEPARATE).surface
        np.testing.assert_array_equal(cell_array(marked, "Turned"), np.repeat([0, 1], 12))
        colours = cell_array(marked, "DefectColor")
        self.assertEqual(len({tuple(colour) for colour in colours[12:]} & {tuple(colour) for colour in colours[:12]}), 0)

    def test_other_orientations(self):
        for orientation, expected in (("as-given", 26), ("outward", 27), ("reverse", 0)):
            with self.subTest(orientation):
                self.assertAlmostEqual(volume(insideout.tetrahedralize(HOLLOW, orientation=orientation)), expected, delta=1e-9)
        self.assertEqual(insideout.tetrahedralize(SEPARATE, orientation="as-given").turned_cells, [])

    def test_lost_area_is_warned_of(self):
        result = insideout.tetrahedralize(ABOVE_GROUND)
        (warning,) = [warning for warning in result.warnings if "is not part of the solid" in warning]
        self.assertIn("97 % are sheets, which enclose nothing: thicken gives them a width, constrain_facets keeps them", warning)
        self.assertAlmostEqual(result.statistics["LostShare"], 400 / 412)


class Agreement(unittest.TestCase):
    def compare(self, surface, orientation):
        """Mesh, probe and implicit function at the middles of the mesh's cells, which no facet comes near."""
        hull = insideout.tetrahedralize(surface, orientation=orientation).hull
        corners = surfaces.points_of(hull)[surfaces.tetrahedra_of(hull)]
        six_volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1]))
        fat = six_volumes > 1e-9 * six_volumes.max()
        middles = corners.mean(axis=1)[fat]
        w = insideout.winding_number(surface, middles, orientation=orientation)
        np.testing.assert_allclose(w, cell_array(hull, "w")[fat], atol=1e-6)
        np.testing.assert_array_equal(insideout.inside(surface, middles, orientation=orientation), w > 0.5)
        function = insideout.vtkImplicitWindingNumber()
        function.SetInput(surface)
        function.SetOrientation(getattr(function, orientation.upper().replace("-", "_")))
        np.testing.assert_allclose([0.5 - function.EvaluateFunction(point) for point in middles[:50]], w[:50], atol=1e-12)

    def test_on_made_surfaces(self):
        for surface in (SEPARATE, OVERLAPPING, HOLLOW, HOLLOW_INSIDE_OUT, ABOVE_GROUND):
            for orientation in ("automatic", "as-given", "reverse", "outward"):
                self.compare(surface, orientation)

    def test_on_real_surfaces(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = list(unpack_cgal(folder, MESHES))
            self.assertEqual(len(paths), len(MESHES))
            for path in paths:
                with self.subTest(os.path.basename(path)):
                    surface = read_surface(path)[0]
                    found = insideout.check(surface)
                    self.compare(surface, "automatic")
                    np.testing.assert_array_equal(
                        np.flatnonzero(cell_array(found.surface, "Turned")), insideout.tetrahedralize(surface).turned_cells
                    )


class Lost(unittest.TestCase):
    """No real surface loses more than a tenth of its area without a word; by areas that are summed up here."""

    def area(self, surface):
        corners = surfaces.points_of(surface)[surfaces.triangles_of(surface)]
        return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2

    def judge(self, path):
        """Whether the surface was warned of, as it must be; None where it cannot be meshed."""
        try:
            result = insideout.tetrahedralize(path, dimension=3)
        except insideout.Error:
            return None  # no surface, or in one plane
        if result.solid.GetNumberOfCells() == 0:
            self.assertIn("nothing is inside", " ".join(result.warnings))
            return None
        lost = self.area(result.outliers) if result.outliers.GetNumberOfCells() else 0
        share = lost / self.area(insideout.resolve(path).surface)
        self.assertAlmostEqual(result.statistics["LostShare"], share, delta=1e-6)
        told = any("is not part of the solid" in warning for warning in result.warnings)
        self.assertEqual(told, share > 0.1)
        return told

    def judge_all(self, paths):
        told = []
        for path in paths:
            with self.subTest(os.path.basename(path)):
                told.append(self.judge(path))
        self.assertGreater(told.count(True) + told.count(False), 50)
        self.assertGreater(told.count(True), 0)

    def test_on_all_small_surfaces_of_cgal(self):
        with tempfile.TemporaryDirectory() as folder:
            self.judge_all(unpack_cgal(folder, most_bytes=60_000))

    def test_on_all_small_surfaces_of_openfoam(self):
        with tempfile.TemporaryDirectory() as folder:
            self.judge_all(unpack_openfoam(folder, most_bytes=400_000))


class Verdict(unittest.TestCase):
    def test_is_one_sentence_that_is_true(self):
        for surface, expected in (
            (SEPARATE, "bounds a solid of volume 9 after turning 1 of 2 shells over"),
            (OVERLAPPING, "bounds a solid of volume 15 after turning 1 of 2 shells over"),
            (HOLLOW, "bounds a solid of volume 26"),
            (HOLLOW_INSIDE_OUT, "bounds a solid of volume 26 after it is turned over as a whole"),
            (boxes(None), "bounds no solid: it lies in one plane, where it covers an area of 400"),
            (ABOVE_GROUND, "bounds a solid of volume 2; a sheet encloses nothing"),
            (boxes(((0, 0, 0), 1, False)), "bounds a solid of volume 1 after it is turned over as a whole"),
        ):
            self.assertEqual(insideout.check(surface).verdict, expected)

    def test_verdict_counts_sheets(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.1), (3, 0, 0), (4, 0, 0), (4, 1, 0)]
        terrain = polydata(points[:4], [(0, 1, 2), (0, 2, 3)])
        self.assertEqual(insideout.check(terrain).verdict, "bounds no solid: a sheet")
        two = polydata(points, [(0, 1, 2), (0, 2, 3), (4, 5, 6)])
        self.assertEqual(insideout.check(two).verdict, "bounds no solid: 2 sheets")
        both_sides = polydata(points[:4], [(0, 1, 2), (0, 2, 3), (0, 2, 1), (0, 3, 2)])
        self.assertEqual(insideout.check(both_sides).verdict, "bounds no solid: its facets cancel in pairs or do not count")

    def test_as_given_is_judged_as_given(self):
        inside_out = boxes(((0, 0, 0), 1, False))
        self.assertEqual(
            insideout.check(inside_out, orientation="as-given").verdict,
            "bounds no solid: it is inside out as oriented",
        )
        one_turned = polydata(box_points(), [BOX_FACETS[0][::-1], *BOX_FACETS[1:]])
        why = "1 facet against those around, as it is oriented"
        self.assertEqual(insideout.check(one_turned, orientation="reverse").verdict, f"bounds no solid: {why}")
        found = insideout.check(one_turned, orientation="as-given").verdict
        self.assertRegex(found, rf"^means a solid of volume about 0\.9\d? .* by its winding number; its shells alone bound none: {why}$")


    def test_each_shell_has_its_volume(self):
        found = insideout.check(boxes(((0, 0, 0), 3, True), ((1, 1, 1), 1, False), ((5, 0, 0), 2, False), None))
        np.testing.assert_allclose(found.shell_volumes, [27, -1, 8, 0], atol=1e-9)
        np.testing.assert_array_equal(cell_array(found.surface, "ShellId"), np.repeat([0, 1, 2, 3], [12, 12, 12, 2]))
        self.assertEqual(found.statistics["Cavities"], 1)


class Command(CommandLine):
    def test_orientation_is_an_option_of_all_it_does(self):
        source = self.file("hollow.ply", HOLLOW)
        places = self.path("places.csv")
        with open(places, "w", encoding="utf-8") as file:
            file.write("1.5,1.5,1.5\n")
        for orientation, w in (("automatic", 0), ("outward", 2), ("reverse", 0)):
            answers = self.path("w.csv")
            done = run("--winding", places, source, answers, "--orientation", orientation)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(answers, encoding="utf-8") as file:
                self.assertEqual(float(file.read().splitlines()[1].split(",")[3]), w)
        self.assertIn("shell 1: volume -1 (a cavity)", run("--check", source).stdout)
        done = run("--check", source, "--orientation", "outward")
        self.assertIn("after turning 1 of 2 shells over", done.stdout.splitlines()[0])
        done = run(source, self.output, "--orientation", "outward")
        self.assertIn("after turning 1 of 2 shells over", done.stdout.splitlines()[0])
        os.remove(self.output)
        self.check_failure(run(source, self.output, "--orientation", "sideways"), "--orientation")

    def test_its_warnings_name_its_options(self):
        done = run(self.file("ground.ply", ABOVE_GROUND), self.output)
        self.assertIn("--thicken gives them a width, --constrain-facets keeps them", done.stdout)

    def test_seeds_of_a_table(self):
        source, seeds = self.file("hollow.ply", HOLLOW), self.path("seeds.csv")
        with open(seeds, "w", encoding="utf-8") as file:
            file.write("x,y,z,inside\n0.5,0.5,0.5,0\n1.5,1.5,1.5,1\n")
        plain = run(source, self.output, "--quiet")
        self.assertEqual(plain.returncode, 0, plain.stderr)
        without = os.path.getsize(self.output)
        done = run(source, self.output, "--seeds", seeds, "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotEqual(os.path.getsize(self.output), without)
        os.remove(self.output)
        with open(seeds, "w", encoding="utf-8") as file:
            file.write("0.5,0.5,0.5,perhaps\n")
        self.check_failure(run(source, self.output, "--seeds", seeds), "seeds.csv", "perhaps")
        self.check_failure(run(source, self.output, "--seeds", self.path("missing.csv")), "no such file")

    def test_a_constrained_array_and_an_order(self):
        surface = surfaces.two_boxes_and_a_stray_facet()
        surfaces.add_array(surface.GetCellData(), "Keep", (np.arange(surface.GetNumberOfCells()) == surface.GetNumberOfCells() - 1).astype(np.uint8))
        source = self.path("figure.vtp")
        insideout.write(surface, source)
        done = run(source, self.output, "--constrained-facets-array", "Keep", "--quadrature-order", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("0 outlier facets", done.stdout)
        os.remove(self.output)
        self.check_failure(run(source, self.output, "--constrained-facets-array", "Absent"), "Absent")
        self.check_failure(run(source, self.output, "--quadrature-order", "6"), "--quadrature-order")


if __name__ == "__main__":
    unittest.main(defaultTest=["Solid", "Agreement", "Lost", "Verdict", "Command"])
