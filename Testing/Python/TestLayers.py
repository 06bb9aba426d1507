# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary layers: prisms at the walls of a solid, in Python, on the command line, and in files."""

import os
import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine, read_grid, run_here

BOX = "".join(f"v {x} {y} {z}\n" for z in (0, 4) for y in (0, 3) for x in (0, 2)) + (
    "g inlet\nf 1 3 4\nf 1 4 2\ng outlet\nf 5 6 8\nf 5 8 7\n"
    "g wall\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n"
)
REMESHED = {"edge_length": 0.5, "surface_treatment": "remeshed"}
LAYERS = {"layers": 3, "first_height": 0.02, "growth": 1.2, "layer_tags": ["wall"]}


class Layers(CommandLine):
    def setUp(self):
        super().setUp()
        self.box = self.file("box.obj", BOX)

    def layered(self, **more):
        with self.assertWarns(insideout.Warning):  # they end at inlet and outlet
            return insideout.tetrahedralize(self.box, **{**REMESHED, **LAYERS, **more})

    def test_prisms_behind_the_wall(self):
        result = self.layered()
        solid, statistics = result.solid, result.statistics
        self.assertIsInstance(solid, insideout.LayeredCells)
        prisms = solid.cells["wedge"]
        self.assertEqual(len(prisms), statistics["Prisms"])
        self.assertEqual(len(solid.cells["pyramid"]), statistics["Pyramids"])
        self.assertEqual(set(solid.layer), {0, 1, 2, 3})
        self.assertGreater(statistics["FullHeightShare"], 0.5)
        self.assertLess(statistics["FullHeightShare"], 1)
        heights = np.linalg.norm(solid.points[prisms[:, 3:]] - solid.points[prisms[:, :3]], axis=2)
        self.assertAlmostEqual(np.median(heights[solid.layer[-len(prisms) :] == 1]), 0.02, delta=0.002)
        # The wall is that of the solid without layers, bit by bit.
        plain = insideout.tetrahedralize(self.box, **REMESHED)
        np.testing.assert_array_equal(result.boundary.points, plain.boundary.points)
        np.testing.assert_array_equal(result.boundary.triangles, plain.boundary.triangles)
        places = {tuple(place) for place in solid.points}
        self.assertTrue(all(tuple(place) in places for place in result.boundary.points))

    def test_measures_of_tetrahedra_are_refused_or_those_of_the_boundary(self):
        result = self.layered()
        self.assertEqual(result.volume, result.boundary.volume)
        for asked in (result.split, result.to_meshio, result.solid.to_meshio, result.solid.split, lambda: result.components, lambda: result.solid.volume):
            with self.assertRaisesRegex(insideout.Error, "^a solid with boundary layers has prisms, and this takes tetrahedra: "):
                asked()

    def test_a_file_of_them_is_read_as_such(self):
        insideout.write(self.layered(), self.path("layered.vtu"))
        self.assertIn("wedge", insideout.read(self.path("layered.vtu")).cells)

    def test_a_boundary_given_twice_has_layers_once(self):
        made = insideout.tetrahedralize(self.box, **REMESHED)
        numbers = []
        for triangles in (made.boundary.triangles, np.concatenate([made.boundary.triangles] * 2)):
            layers = insideout.vtkBoundaryLayers()
            layers.SetInputData(made.solid)
            layers.SetBoundaryData(surfaces.polydata(made.boundary.points, triangles))
            layers.SetFirstHeight(0.01)
            insideout.pipeline.run(layers)
            numbers.append(layers.GetOutput().GetNumberOfCells())
        self.assertEqual(*numbers)

    def test_all_of_the_boundary_is_the_wall_by_default(self):
        result = insideout.tetrahedralize(self.box, **REMESHED, layers=2, first_height="1%")
        self.assertEqual(result.statistics["FullHeightShare"], 1)
        self.assertEqual(result.statistics["Prisms"], 2 * result.boundary.GetNumberOfCells())

    def test_what_is_wrong_is_named(self):
        for options, words in (
            ({"layers": 3}, "first_height is not"),
            ({**LAYERS, "first_height": 0.0}, "FirstHeight is 0"),
            ({**LAYERS, "first_height": -1.0}, "first_height is -1"),
            ({**LAYERS, "layers": 0}, "layers is 0"),
            ({**LAYERS, "layer_tags": "wall,Door"}, "Door, which is no tag of the boundary; its tags are inlet, outlet, wall"),
            ({**LAYERS, "quadratic_cells": True}, "quadratic_cells"),
            ({**LAYERS, "surface_only": True}, "surface_only"),
            ({**LAYERS, "refine": False}, "refine is False"),
            ({**LAYERS, "output": self.path("x.xdmf")}, "write layers as"),
        ):
            with self.subTest(words), self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(self.box, **options)
        square = ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        with self.assertRaisesRegex(insideout.Error, "plane"):
            insideout.tetrahedralize(square, layers=1, first_height=0.1)

    def test_the_command_has_them(self):
        options = ("--edge-length", "0.5", "--surface-treatment", "remeshed", "--layers", "3", "--first-height", "0.02", "--layer-tags", "wall")
        ran = run_here("mesh", self.box, self.output, *options)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertRegex(ran.stdout, r"  layers of [\d,]+ prisms, [\d,]+ pyramids and [\d,]+ tetrahedra")
        self.assertRegex(ran.stderr + ran.stdout, "% of the wall have layers of full height")
        self.assertIn(13, {read_grid(self.output).GetCellType(c) for c in range(read_grid(self.output).GetNumberOfCells())})
        self.assertNotEqual(run_here("mesh", self.box, self.path("a.stl"), *options).returncode, 0)

    def test_check_judges_them(self):
        result = self.layered()
        made = result.statistics
        checked = insideout.check_solid(result.solid)
        statistics = checked.statistics
        self.assertIsInstance(checked.solid, insideout.LayeredCells)
        for name in ("Prisms", "Pyramids", "RefusedCells", "PoorCells"):
            self.assertEqual(statistics[name], made[name], name)
        self.assertEqual(statistics["Cells"], result.solid.GetNumberOfCells())
        self.assertEqual(statistics["NegativeCells"] + statistics["FlatCells"] + statistics["ContactPairs"], 0)
        self.assertEqual(statistics["Conforms"], 1)
        self.assertEqual(statistics["BoundaryComponents"], 1)
        self.assertEqual(set(checked.solid.cell_arrays["Orientation"]), {1})
        self.assertRegex(checked.verdict, r"^[\d,]+ tetrahedra, [\d,]+ pyramids and [\d,]+ prisms in 1 part, conforming, the boundary watertight; all positive$")
        path = self.path("layered.vtu")
        insideout.write(result, path)
        ran = run_here("check", path)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn(checked.verdict, ran.stdout)

    def test_a_prism_that_is_turned_over_is_found(self):
        solid = self.layered().solid
        prism = int(np.flatnonzero([solid.GetCellType(c) == 13 for c in range(solid.GetNumberOfCells())])[0])
        nodes = solid.cells["wedge"][0]
        points = solid.points
        points[nodes[3]] = points[nodes[0]] + 3 * (points[nodes[0]] - points[nodes[3]])
        checked = insideout.check_solid(solid)
        self.assertGreater(checked.statistics["NegativeCells"], 0)
        self.assertGreater(checked.statistics["RefusedCells"], 0)
        self.assertEqual(checked.solid.cell_arrays["Orientation"][prism], -1)

    def test_files_of_solvers_hold_them(self):
        result = self.layered()
        counts = {name: len(cells) for name, cells in result.solid.cells.items()}
        for ending, words in (
            (".msh", ("\n3 1 6 ", "\n3 1 7 ")),
            (".mesh", (f"Prisms\n{counts['wedge']}\n", f"Pyramids\n{counts['pyramid']}\n")),
            (".inp", ("TYPE=C3D6",)),
        ):
            path = self.path("solid" + ending)
            insideout.write(result, path)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            for word in words:
                self.assertIn(word, text)
            with self.assertWarnsRegex(insideout.Warning, "prisms|Prisms|C3D6"):
                self.assertEqual(insideout.read(path).GetNumberOfPoints(), result.solid.GetNumberOfPoints())


if __name__ == "__main__":
    unittest.main()
