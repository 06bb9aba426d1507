# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths in percent are shares of the diagonal of all that is given, and units are scales."""

import json
import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine, run_here
from insideout.lengths import UNITS, diagonal_of, scale_between, share_of
from insideout.options import LAYER_OPTIONS, LENGTHS, OPTIONS, Options
from insideout.surfaces import make_surface

DIAGONAL = 3**0.5  # of the unit box


class Lengths(unittest.TestCase):
    def test_text_that_is_no_share_names_the_option(self):
        self.assertEqual([share_of("edge_length", value) for value in ("2%", " 0.5 % ", 3, None)], [0.02, 0.005, None, None])
        for bad in ("2", "%", "-1%", "nan%", "inf%", "two%", ""):
            with self.assertRaisesRegex(insideout.Error, "^edge_length is .*; it must be"):
                share_of("edge_length", bad)

    def test_the_diagonal_is_that_of_points_in_use_that_are_finite(self):
        points = [(9, 9, 9), (0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, np.nan)]
        self.assertEqual(diagonal_of([make_surface(points, [(1, 2, 3)])]), 5**0.5)
        self.assertEqual(diagonal_of([make_surface(points, [(1, 2, 3), (4, 7, -1)])]), 5**0.5)
        self.assertEqual(diagonal_of([make_surface(points[:4], np.empty((0, 3), int))]), 243**0.5)
        self.assertEqual(diagonal_of([surfaces.box(), surfaces.box((2, 0, 0))]), 11**0.5)
        self.assertEqual(diagonal_of([]), 0)
        for scale in (1e-200, 1e200):  # squares of which are no doubles
            huge = make_surface(np.array(points[:4]) * scale, [(1, 2, 3)])
            self.assertAlmostEqual(diagonal_of([huge]) / scale, 5**0.5, 12)

    def test_each_function_takes_them_for_the_number(self):
        near = surfaces.joined(surfaces.box(), surfaces.box((1 + 1e-4, 0, 0)))
        percent, number = "1%", 0.01 * diagonal_of([near])
        points = [(0.5, 0.5, 0.5), (1.00005, 0.5, 0.5)]
        for call in (
            lambda length: insideout.tetrahedralize(near, merge_tolerance=length).statistics["MergedPoints"],
            lambda length: insideout.check(near, merge_tolerance=length).statistics["MergedPoints"],
            lambda length: insideout.resolve(near, merge_tolerance=length).statistics["MergedPoints"],
            lambda length: insideout.boolean([near], merge_tolerance=length).surface.GetNumberOfPoints(),
            lambda length: insideout.winding_number(near, points, merge_tolerance=length).tolist(),
            lambda length: insideout.inside(near, points, merge_tolerance=length).tolist(),
            lambda length: insideout.distance(near, points, merge_tolerance=length).tolist(),
            lambda length: insideout.sdf_grid(near, shape=9, merge_tolerance=length).distance.tolist(),
            lambda length: insideout.voxels(near, 0.3, merge_tolerance=length)[0].tolist(),
        ):
            self.assertEqual(call(percent), call(number))
            self.assertNotEqual(call(percent), call(None))

    def test_those_of_meshes_too(self):
        made = insideout.tetrahedralize(surfaces.box())
        for call in (
            lambda length: insideout.tetrahedralize(surfaces.box(), edge_length=length).solid,
            lambda length: insideout.tetrahedralize(surfaces.box(), surface_treatment="remeshed", edge_length=length).solid,
            lambda length: insideout.refine(made.solid, edge_length=length).solid,
            lambda length: insideout.tetrahedralize(surfaces.open_box(), thicken=length, thicken_all=True).solid,
        ):
            np.testing.assert_array_equal(call("20%").points, call(0.2 * DIAGONAL).points)
            self.assertNotEqual(len(call("20%").points), len(call(None).points))

    def test_they_are_of_all_bodies_and_after_the_scale(self):
        bodies = {"a": surfaces.box(), "b": surfaces.box((2, 0, 0))}
        found, expected = (insideout.tetrahedralize(bodies, scale=10, edge_length=length) for length in ("10%", 0.1 * 1100**0.5))
        np.testing.assert_array_equal(found.solid.points, expected.solid.points)

    def test_no_function_takes_one_for_a_number_that_is_not_known(self):
        for name in LENGTHS:
            with self.assertRaisesRegex(insideout.Error, f"^{name} is '2%'; it must be a number"):
                Options(**{name: "2%"}).set_on(insideout.vtkBoundaryLayers() if name in LAYER_OPTIONS else insideout.vtkRobustTetrahedralize())
            self.assertIn('"2%" of the diagonal', OPTIONS[name].words)


class Command(CommandLine):
    def test_it_tells_what_a_share_is(self):
        report = self.path("report.json")
        done = run_here("mesh", self.file("box.ply", surfaces.box()), self.output, "--edge-length", "25%", "--scale", "2", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"Note: --edge-length 25% is {DIAGONAL / 2:.6g}\n", done.stdout)
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["parameters"]["edge_length"], 0.25 * (2 * DIAGONAL))
        done = run_here("refine", self.output, self.path("fine.vtu"), "--edge-length", "5%", "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(insideout.check_solid(self.path("fine.vtu")).solid.GetNumberOfCells(), 2000)

    def test_texts_other_than_lengths_are_refused_before_the_work(self):
        for bad in ("much", "-1", "-1%", "nan%"):
            done = run_here("mesh", self.path("missing.ply"), self.output, "--edge-length", bad)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("edge", done.stderr)

    def test_units_are_a_scale(self):
        self.assertEqual([scale_between(*units) for units in (("mm", "m"), ("in", "mm"), ("ft", "in"), ("m", "um"))], [0.001, 25.4, 12.0, 1e6])
        source, report = self.file("box.ply", surfaces.box()), self.path("report.json")
        for command in (("mesh", source, self.output), ("check", source), ("repair", source, self.path("fixed.ply"))):
            done = run_here(*command, "--from", "in", "--to", "mm", "--report", report)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(report, encoding="utf-8") as file:
                found = json.load(file)
            volume = found["statistics"]["EnclosedVolume" if command[0] == "check" else "Volume"]
            self.assertEqual((found["parameters"]["scale"], round(volume, 6)), (25.4, 16387.064))
            self.assertIn("coordinates multiplied by 25.4", done.stdout)
        for unit in UNITS:
            self.assertEqual(scale_between(unit, unit), 1)


if __name__ == "__main__":
    unittest.main()
