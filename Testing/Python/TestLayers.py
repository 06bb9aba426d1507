# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary layers: prisms at the walls of a solid, in Python, on the command line, and in files."""

import os
import subprocess
import unittest
import warnings
from pathlib import Path

import gmsh
import insideout
import meshio
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
        return insideout.tetrahedralize(self.box, **{**REMESHED, **LAYERS, **more})

    def test_prisms_behind_the_wall(self):
        result = self.layered()
        solid, statistics = result.solid, result.statistics
        self.assertIsInstance(solid, insideout.LayeredCells)
        prisms = solid.cells["wedge"]
        self.assertEqual(len(prisms), statistics["Prisms"])
        self.assertNotIn("pyramid", solid.cells)
        self.assertEqual(set(solid.layer), {0, 1, 2, 3})
        self.assertEqual((statistics["FullHeightShare"], statistics["Pyramids"], statistics["BarePoints"]), (1, 0, 0))
        heights = np.linalg.norm(solid.points[prisms[:, 3:]] - solid.points[prisms[:, :3]], axis=2)
        self.assertAlmostEqual(np.median(heights[solid.layer[-len(prisms) :] == 1]), 0.02, delta=0.002)
        # The wall is that of the solid without layers, bit by bit.
        plain = insideout.tetrahedralize(self.box, **REMESHED)
        np.testing.assert_array_equal(self.places_of(result, "wall"), self.places_of(plain, "wall"))

    def places_of(self, result, tag):
        chosen = result.boundary.cell_arrays["BoundaryTag"] == ("inlet", "outlet", "wall").index(tag)
        return result.boundary.points[result.boundary.triangles[chosen]]

    def test_facets_of_a_kept_surface_stay_bit_by_bit(self):
        ball = surfaces.ball(0.7, 16, 8)
        places, triangles = surfaces.points_of(ball), surfaces.triangles_of(ball)
        facets = {frozenset(map(tuple, places[triangle])) for triangle in triangles}
        result = insideout.tetrahedralize(ball, surface_treatment="kept", layers=2, first_height="1%")
        solid, boundary = result.solid, result.boundary
        self.assertEqual({frozenset(map(tuple, boundary.points[triangle])) for triangle in boundary.triangles}, facets)
        outer = solid.cells["wedge"][solid.layer[-len(solid.cells["wedge"]) :] == 1][:, :3]
        self.assertEqual({frozenset(map(tuple, solid.points[triangle])) for triangle in outer}, facets)

    def test_they_go_on_along_inlet_and_outlet(self):
        result = self.layered()
        boundary = result.boundary
        self.assertTrue(boundary.is_watertight)
        self.assertAlmostEqual(boundary.volume, 24, places=9)
        for tag, height in (("inlet", 0), ("outlet", 4)):
            places = self.places_of(result, tag)
            self.assertEqual(set(places[:, :, 2].flat), {height})
            areas = np.linalg.norm(np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]), axis=1) / 2
            self.assertAlmostEqual(areas.sum(), 6, places=9)
            inner = places[(np.abs(places[:, :, 0] - 1) < 1 - 0.05).all(axis=1)]
            self.assertGreater(len(inner), 0)
        # Every triangle of the boundary is a face of the grid, or half of one.
        grid = {frozenset(map(tuple, result.solid.points[list(face)])) for face in self.faces_of_one_cell(result.solid)}
        halves = [set(map(tuple, boundary.points[triangle])) for triangle in boundary.triangles]
        self.assertTrue(all(any(half <= face for face in grid) for half in halves[:: max(1, len(halves) // 50)]))
        self.assertEqual(sum(len(face) - 2 for face in grid), len(halves))

    def faces_of_one_cell(self, solid):
        sides = {
            "tetra": ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)),
            "pyramid": ((0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
            "wedge": ((0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
        }
        faces = {}
        for kind, cells in solid.cells.items():
            for cell in cells:
                for side in sides[kind]:
                    face = frozenset(int(cell[k]) for k in side)
                    faces[face] = faces.get(face, 0) + 1
        self.assertLessEqual(max(faces.values()), 2)
        return [face for face, count in faces.items() if count == 1]

    def test_measures_of_tetrahedra_are_refused_or_those_of_the_boundary(self):
        result = self.layered()
        self.assertEqual(result.volume, result.boundary.volume)
        for asked in (result.split, result.to_meshio, result.solid.to_meshio, result.solid.split, lambda: result.components, lambda: result.solid.volume):
            with self.assertRaisesRegex(insideout.Error, "^a solid with boundary layers has prisms or quads, and this takes tetrahedra or triangles: "):
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

    def test_it_is_told_why_layers_end(self):
        rest = "g rest\nf 1 3 4\nf 5 6 8\n"  # with one half of a plane, of which the other half is no wall
        half = self.file("half.obj", BOX[: BOX.index("g inlet")] + "g half\nf 1 4 2\n" + rest + BOX[BOX.index("f 5 8 7") :])
        result = insideout.tetrahedralize(half, surface_treatment="kept", **{**LAYERS, "layer_tags": "half"})
        self.assertEqual(result.statistics["Prisms"], 0)
        self.assertTrue(any("2 have none; at 2 points no direction leads inward" in told for told in result.warnings))

    def test_wrong_options_are_named(self):
        for options, words in (
            ({"layers": 3}, "first_height is not"),
            ({**LAYERS, "first_height": 0.0}, "first_height is 0"),
            ({**LAYERS, "first_height": -1.0}, "first_height is -1"),
            ({**LAYERS, "layers": 0}, "layers is 0"),
            ({**LAYERS, "layers": 1}, "growth is given, and layers is 1"),
            ({**LAYERS, "layer_tags": "wall,Door"}, "Door, which is not a tag of the boundary; its tags are inlet, outlet, wall"),
            ({**LAYERS, "quadratic_cells": True}, "quadratic_cells"),
            ({**LAYERS, "surface_only": True}, "surface_only"),
            ({**LAYERS, "refine": False}, "refine is False"),
            ({**LAYERS, "output": self.path("x.xdmf")}, "write layers as"),
        ):
            with self.subTest(words), self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(self.box, **options)

    def test_the_command_has_them(self):
        options = ("--edge-length", "0.5", "--surface-treatment", "remeshed", "--layers", "3", "--first-height", "0.02", "--layer-tags", "wall")
        ran = run_here("mesh", self.box, self.output, *options)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertRegex(ran.stdout, r"  layers of [\d,]+ prisms, [\d,]+ pyramids and [\d,]+ tetrahedra")
        self.assertIn("100 % of the wall at full height", ran.stdout)
        self.assertIn(13, {read_grid(self.output).GetCellType(c) for c in range(read_grid(self.output).GetNumberOfCells())})
        self.assertNotEqual(run_here("mesh", self.box, self.path("a.stl"), *options).returncode, 0)

    def channel(self):
        """A channel in a plane, 4 long and 1 wide, as lines with tags."""
        places = [(0, 0, 0), (4, 0, 0), (4, 1, 0), (0, 1, 0)]
        lines = "".join(f"v {x} {y} {z}\n" for x, y, z in places)
        return self.file("channel.obj", lines + "g wall\nl 1 2\ng outlet\nl 2 3\ng wall\nl 3 4\ng inlet\nl 4 1\n")

    def test_quads_in_a_plane_go_on_along_inlet_and_outlet(self):
        with self.assertWarnsRegex(insideout.Warning, "two dimensions"):
            result = insideout.tetrahedralize(self.channel(), edge_length=0.1, **LAYERS, output=self.output)
        solid, statistics = result.solid, result.statistics
        quads = solid.cells["quad"]
        self.assertEqual((len(quads), statistics["FullHeightShare"], statistics["LayerTriangles"]), (statistics["Quads"], 1, 0))
        self.assertEqual(len(quads), 3 * statistics["WallEdges"])
        self.assertEqual((len(result.warnings), set(solid.layer)), (1, {0, 1, 2, 3}))
        self.assertAlmostEqual(result.volume, 4, places=12)
        heights = np.abs(solid.points[quads[:, 3], 1] - solid.points[quads[:, 0], 1])
        np.testing.assert_allclose(heights, 0.02 * 1.2 ** (solid.layer[-len(quads) :] - 1), rtol=1e-9)
        # The boundary's lines are edges of one cell, and keep their tags.
        edges = [frozenset((cell[k], cell[k - 1])) for cells in solid.cells.values() for cell in cells.tolist() for k in range(len(cell))]
        outer = {frozenset(map(tuple, solid.points[list(edge)])) for edge in set(edges) if edges.count(edge) == 1}
        found = {}
        for line, tag in zip(result.boundary.lines, result.boundary.cell_arrays["BoundaryTag"]):
            places = result.boundary.points[line]
            found.setdefault(tag, []).extend(frozenset(map(tuple, places[k : k + 2])) for k in range(len(line) - 1))
        self.assertEqual({edge for edges in found.values() for edge in edges}, outer)
        for number, tag in enumerate(sorted(found)):
            along = np.array([sorted(edge) for edge in found[tag]])
            lengths = np.linalg.norm(along[:, 1] - along[:, 0], axis=1)
            self.assertAlmostEqual(lengths.sum(), 8 if number == 0 else 1, places=12)
        self.assertEqual(insideout.read(self.output).cells["quad"].tolist(), quads.tolist())
        with self.assertRaisesRegex(insideout.Error, "write layers as"), warnings.catch_warnings():
            warnings.simplefilter("ignore", insideout.Warning)
            insideout.tetrahedralize(self.channel(), edge_length=0.1, **LAYERS, output=self.path("a.xdmf"))
        self.assertGreater(len(result.png()), 1000)

    def test_the_command_makes_quads_of_outlines(self):
        options = ("--edge-length", "0.1", "--layers", "2", "--first-height", "0.02", "--layer-tags", "wall")
        ran = run_here("mesh", self.channel(), self.output, *options)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertRegex(ran.stdout, r"  layers of [\d,]+ quads and 0 triangles; 100 % of the wall at full height")

    def test_check_judges_them(self):
        result = self.layered()
        made = result.statistics
        checked = insideout.check_solid(result.solid)
        statistics = checked.statistics
        self.assertIsInstance(checked.solid, insideout.LayeredCells)
        for name in ("Prisms", "RefusedCells", "PoorCells"):
            self.assertEqual(statistics[name], made[name], name)
        self.assertEqual(statistics["Cells"], result.solid.GetNumberOfCells())
        self.assertEqual(statistics["NegativeCells"] + statistics["FlatCells"] + statistics["ContactPairs"], 0)
        self.assertEqual(statistics["Conforms"], 1)
        self.assertEqual(statistics["BoundaryComponents"], 1)
        self.assertEqual(set(checked.solid.cell_arrays["Orientation"]), {1})
        self.assertRegex(checked.verdict, r"^[\d,]+ tetrahedra and [\d,]+ prisms in 1 part, conforming, the boundary watertight; all positive$")
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
        insideout.write(solid, self.path("turned.vtu"))
        told = run_here("check", self.path("turned.vtu")).stdout
        self.assertRegex(told, r"prisms in 1 part that do not conform; [\d,]+ negative cells")

    def test_files_of_solvers_hold_them(self):
        result = self.layered()
        counts = {name: len(cells) for name, cells in result.solid.cells.items()}
        quads = sum(len(face) == 4 for face in self.faces_of_one_cell(result.solid))
        self.assertGreater(quads, 0)
        for ending, words in (
            (".msh", ("\n3 1 6 ", "\n2 1 3 ")),
            (".mesh", (f"Prisms\n{counts['wedge']}\n", f"Quadrilaterals\n{quads}\n")),
            (".inp", ("TYPE=C3D6", ", S3\n")),
        ):
            path = self.path("solid" + ending)
            insideout.write(result, path)
            with open(path, encoding="utf-8") as file:
                text = file.read()
            for word in words:
                self.assertIn(word, text)
            with self.assertWarnsRegex(insideout.Warning, "prisms|Prisms|C3D6"):
                self.assertEqual(insideout.read(path).GetNumberOfPoints(), result.solid.GetNumberOfPoints())

    def with_all_kinds_of_cells(self):
        """Layers at one of two triangles of a plane, where they end in pyramids and tetrahedra."""
        halves = self.file("halves.obj", BOX.replace("f 1 3 4\n", "f 1 3 4\ng other\n"))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", insideout.Warning)  # of the wall's share
            return insideout.tetrahedralize(halves, **REMESHED, **{**LAYERS, "layer_tags": "inlet"})

    def test_meshio_reads_their_files(self):
        for result in (self.layered(), self.with_all_kinds_of_cells()):
            for ending in (".msh", ".mesh", ".inp"):
                insideout.write(result, self.path("solid" + ending))
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # meshio's own, of numpy
                    mesh = meshio.read(self.path("solid" + ending))
                cells = dict(result.solid.cells)
                if ending == ".inp" and "pyramid" in cells:  # as prisms whose two triangles share a corner
                    cells["wedge"] = [*cells["wedge"], *cells.pop("pyramid")]
                with self.subTest(ending, kinds=list(cells)):
                    for kind, corners in cells.items():
                        blocks = [block.data for block in mesh.cells if block.type == kind]
                        read = [mesh.points[cell] for data in blocks for cell in data]
                        made = [result.solid.points[list(cell)] for cell in corners]
                        self.assertEqual(self.by_places(read), self.by_places(made))

    def by_places(self, cells):
        return sorted(sorted(set(map(tuple, cell))) for cell in cells)

    def test_gmsh_reads_their_files_and_finds_each_cell_positive(self):
        gmsh.initialize()
        self.addCleanup(gmsh.finalize)
        gmsh.option.setNumber("General.Terminal", 0)
        for result in (self.layered(), self.with_all_kinds_of_cells()):
            insideout.write(result, self.path("solid.msh"))
            gmsh.clear()
            gmsh.merge(self.path("solid.msh"))
            volume = 0
            for kind, name in ((4, "tetra"), (6, "wedge"), (7, "pyramid")):
                count = len(gmsh.model.mesh.getElementsByType(kind)[0])
                self.assertEqual(count, len(result.solid.cells.get(name, ())))
                if count:
                    places, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss3")
                    determinants = gmsh.model.mesh.getJacobians(kind, places)[1].reshape(count, -1)
                    self.assertGreater(determinants.min(), 0)
                    volume += (determinants @ weights).sum()
            # The rule for pyramids is not exact.
            self.assertAlmostEqual(volume, 24, places=1 if "pyramid" in result.solid.cells else 9)

    def test_calculix_presses_on_their_sides(self):
        layers = ("--edge-length", "0.5", "--layers", "3", "--first-height", "0.02", "--layer-tags", "wall")
        loads = ("--material", "steel", "--fix", "inlet", "--pressure", "outlet", "1")
        ran = run_here("mesh", self.box, self.path("solid.inp"), *layers, *loads)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        ran = subprocess.run(["ccx", "solid"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertIn("Job finished", ran.stdout)
        self.assertNotIn("*ERROR", ran.stdout)
        lines = Path(self.folder, "solid.dat").read_text(encoding="ascii").split("\n")
        force = next(line.split() for line in lines if len(line.split()) == 3 and "total" not in line)
        np.testing.assert_allclose(np.array(force, float), (0, 0, 6), atol=1e-6)  # area times pressure


if __name__ == "__main__":
    unittest.main()
