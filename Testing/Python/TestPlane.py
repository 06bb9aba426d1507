# SPDX-License-Identifier: GPL-3.0-or-later
"""Two dimensions in Python and on the command line: curves and flat meshes become triangles."""

import json
import os
import pickle
import subprocess
import sys
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from insideout.stages import TETRAHEDRALIZE
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

SQUARE = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)]
SECOND = [(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0)]
OBJ = "\n".join([*(f"v {x} {y} {z}" for x, y, z in SQUARE + SECOND), "g first", "l 1 2 3 4 1", "g second", "l 5/1 6 7 8 -4", ""])
CSV = "\n".join(["x,y,path", *(f"{x},{y},a" for x, y, _ in [*SQUARE, SQUARE[0]]), *(f"{x},{y},b" for x, y, _ in [*SECOND, SECOND[0]]), ""])


def two_squares() -> vtkPolyData:
    """Two closed polylines, whose squares have a unit square in common."""
    curve = surfaces.polydata(SQUARE + SECOND, [])
    curve.SetLines(surfaces.polydata([], [(0, 1, 2, 3, 0), (4, 5, 6, 7, 4)]).GetPolys())
    return curve


def area_of(points, triangles) -> float:
    a, b, c = (np.asarray(points)[np.asarray(triangles)[:, k]] for k in range(3))
    return float(np.cross(b - a, c - a)[:, 2].sum() / 2)


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def grid_in(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def hole_across_outline() -> vtkPolyData:
    """A rectangle of 100 by 80, and a hole of 40 by 30 of which 40 by 8.8 are outside of it."""
    points = [(0, 0, 0), (100, 0, 0), (100, 80, 0), (0, 80, 0), (30, 58.8, 0), (30, 88.8, 0), (70, 88.8, 0), (70, 58.8, 0)]
    curve = surfaces.polydata(points, [])
    curve.SetLines(surfaces.polydata([], [(0, 1, 2, 3, 0), (4, 5, 6, 7, 4)]).GetPolys())
    return curve


class Function(unittest.TestCase):
    def test_a_hole_across_its_outline_is_told_of_by_three_rules(self):
        rules = "8352 by the winding number, 7504 by even-odd"
        found = insideout.check(hole_across_outline())
        self.assertEqual(found.verdict, f"bounds an area of 8352 in a plane after turning 4 of 8 segments over: {rules}, 7152 as given")
        self.assertTrue(any(f"{rules} and 7152 as given" in line for line in found.warnings))
        made = insideout.tetrahedralize(hole_across_outline())
        self.assertAlmostEqual(made.statistics["Area"], 8352)
        self.assertAlmostEqual(made.statistics["AreaByEvenOdd"], 7504)
        self.assertAlmostEqual(made.statistics["AreaAsGiven"], 7152)
        self.assertTrue(any(f"{rules} and 7152 as given" in line for line in made.warnings))
        self.assertAlmostEqual(insideout.tetrahedralize(hole_across_outline(), orientation="as-given").statistics["Area"], 7152)
        self.assertNotIn("AreaByEvenOdd", insideout.check(two_squares()).statistics)

    def test_lines_become_triangles_with_views(self):
        result = insideout.tetrahedralize(two_squares())
        self.assertEqual(len(result.warnings), 1)
        self.assertIn("two dimensions", result.warnings[0])
        self.assertIsInstance(result.solid, insideout.Triangles)
        self.assertAlmostEqual(area_of(result.solid.points, result.solid.cells), 7)
        self.assertEqual(set(result.hull.w), {0, 1, 2})
        self.assertEqual(result.solid.cell_arrays["FacetIds"].shape[1], 3)
        self.assertEqual([round(region.volume, 12) for region in result.regions], [7])
        self.assertEqual(result.statistics["Area"], 7)
        self.assertEqual(result.statistics["Dimension"], 2)
        lines = result.boundary.lines
        self.assertEqual(len(lines), 2)
        turned = sum(
            (np.cross(result.boundary.points[line[:-1]], result.boundary.points[line[1:]])[:, 2]).sum() / 2 for line in lines
        )
        self.assertAlmostEqual(turned, 7)  # the inside is on the left
        self.assertEqual(insideout.tetrahedralize(two_squares(), dimension=2).warnings, [])
        copy = pickle.loads(pickle.dumps(result))
        self.assertEqual(copy.solid.cells.tobytes(), result.solid.cells.tobytes())
        self.assertIn("triangles inside", repr(result))

    def test_triangles_are_refined(self):
        result = insideout.tetrahedralize(two_squares(), refine=True, surface_treatment="split", edge_length=0.2)
        self.assertIsInstance(result.solid, insideout.Triangles)
        self.assertGreater(len(result.solid.cells), 300)
        self.assertGreater(result.statistics["MinAngle"], 20.7)
        self.assertIsInstance(result.statistics["BeforeMinAngle"], float)
        self.assertAlmostEqual(area_of(result.solid.points, result.solid.cells), 7)
        self.assertEqual(set(result.solid.w), {1, 2})
        with self.assertRaisesRegex(insideout.Error, "vtkTriangle; only tetrahedra"):
            insideout.refine(result.solid)

    def test_w_of_refined_triangles_of_open_lines_is_that_at_their_own_barycenters(self):
        curve = surfaces.polydata([*SQUARE, (0, 0.2, 0), (0.5, 0.5, 0), (1.2, 0.9, 0)], [])
        curve.SetLines(surfaces.polydata([], [(0, 1, 2, 3, 4), (5, 6)]).GetPolys())
        for treatment in ("kept", "split"):
            for topology in ("keep", "split"):
                with self.subTest(treatment, topology=topology):
                    options = {"surface_treatment": treatment, "non_manifold": topology, "edge_length": 0.3}
                    solid = insideout.tetrahedralize(curve, refine=True, **options).solid
                    places = solid.points[solid.cells].mean(axis=1)
                    self.assertGreater(len(places), 50)
                    np.testing.assert_allclose(solid.w, insideout.winding_number(curve, places), rtol=0, atol=1e-13)

    def test_duplicates_that_do_not_cancel_count(self):
        ring = (0, 1, 2, 3, 0)
        for forth, back, w in ((3, 1, 2), (4, 1, 3), (2, 2, 1)):
            curve = surfaces.polydata(SQUARE, [])
            curve.SetLines(surfaces.polydata([], [ring] * forth + [ring[::-1]] * back).GetPolys())
            result = insideout.tetrahedralize(curve, count_duplicates=True, orientation="as-given")
            self.assertEqual(set(result.hull.w), {w})

    def test_a_flat_mesh_gives_its_triangles(self):
        triangles = [(0, 1, 2), (0, 2, 3)]
        result = insideout.tetrahedralize((SQUARE, triangles))
        # In VTK 9.1 vtkThreshold, which takes out what is inside, numbers points as cells come.
        cells = result.solid.point_arrays["vtkOriginalPointIds"][result.solid.cells]
        self.assertEqual({frozenset(cell) for cell in cells.tolist()}, {frozenset(cell) for cell in triangles})
        with self.assertRaisesRegex(insideout.Error, "plane"):
            insideout.tetrahedralize((SQUARE, triangles), dimension="3")

    def test_options_impossible_in_a_plane_are_errors(self):
        for options, words in (({"refine": True, "surface_treatment": "remeshed"}, "not remeshed"), ({"dimension": 4}, "dimension is '4'")):
            with self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(two_squares(), **options)
        with self.assertRaisesRegex(insideout.Error, "does not lie in a plane"):
            insideout.tetrahedralize(surfaces.box(), dimension=2)
        result = insideout.tetrahedralize(two_squares())
        with tempfile.TemporaryDirectory() as folder:
            for name, words in (("a.stl", "lines"), ("a.msh", "triangles in a plane as .vtu")):
                with self.assertRaisesRegex(insideout.Error, words):
                    insideout.write(result, os.path.join(folder, name))
            self.assertEqual(os.listdir(folder), [])

    def test_options_of_tetrahedra_alone_are_refused_before_the_work(self):
        stages = []
        for options, words in (
            ({"separate_overlaps": True}, "separates tetrahedra"),
            ({"quadratic_cells": True}, "makes tetrahedra only"),
            ({"edge_length": 0.5, "surface_treatment": "remeshed"}, "not remeshed"),
        ):
            with self.subTest(options), self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(two_squares(), **options, progress=lambda stage, _: stages.append(stage))
        self.assertEqual(set(stages) & set(TETRAHEDRALIZE), set())

    def test_a_picture_says_what_was_wrong(self):
        result = insideout.tetrahedralize(two_squares())
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "picture.png")
            insideout.draw(two_squares(), result.hull, picture)
            with open(picture, "rb") as file:
                content = file.read()
        self.assertTrue(content.startswith(b"\x89PNG"))
        self.assertIn(b"2 intersecting pairs", content)

    def test_lines_without_crossings_are_lines(self):
        resolved = insideout.resolve(two_squares())
        self.assertIsInstance(resolved.surface, insideout.Polylines)
        self.assertEqual(len(np.concatenate(resolved.surface.lines)), 12 + len(resolved.surface.lines))
        self.assertIn("lines", repr(resolved))


    def test_a_picture_shows_the_refined_solid_where_that_is_given(self):
        result = insideout.tetrahedralize(two_squares(), edge_length=0.2, surface_treatment="split")
        with tempfile.TemporaryDirectory() as folder:
            seen = []
            for solid in (None, result.solid):
                insideout.draw(two_squares(), result.hull, os.path.join(folder, "picture.png"), solid=solid)
                seen.append(pixels_of(os.path.join(folder, "picture.png")))
        panel = seen[0].shape[1] // 3
        np.testing.assert_array_equal(seen[0][:, : 2 * panel], seen[1][:, : 2 * panel])
        self.assertGreater(np.count_nonzero(seen[0] != seen[1]), 10000)


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name, content=None):
        path = os.path.join(self.folder, name)
        if content is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(content)
        return path

    def run_on(self, source, *options):
        command = [sys.executable, "-m", "insideout", source, self.path("out.vtu"), *options]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def test_each_kind_of_file(self):
        insideout.write(two_squares(), self.path("curve.vtp"))
        for source in (self.path("curve.vtp"), self.path("curve.obj", OBJ), self.path("curve.csv", CSV)):
            with self.subTest(source):
                report = self.path("report.json")
                done = self.run_on(source, "--boundary", self.path("boundary.vtp"), "--report", report)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("bounds an area of 7 in a plane", done.stdout)
                self.assertEqual(grid_in(self.path("out.vtu")).GetCellData().GetArray("FacetIds").GetNumberOfComponents(), 3)
                with open(report, encoding="utf-8") as file:
                    self.assertEqual(json.load(file)["statistics"]["Area"], 7)
                reader = vtkXMLPolyDataReader()
                reader.SetFileName(self.path("boundary.vtp"))
                reader.Update()
                self.assertEqual(reader.GetOutput().GetNumberOfLines(), 2)

    def test_files_that_cannot_hold_it_are_refused_before_the_work(self):
        curve, mesh = self.path("curve.csv", CSV), self.path("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        stl, solver = self.path("fixed.stl"), self.path("solid.msh")
        for arguments, words in (
            ([curve, stl], f"{stl}: the boundary is lines"),
            ([curve, solver], f"{solver}: such a file has tetrahedra"),
            ([curve, self.path("out.vtu"), "--boundary", stl], f"{stl}: the boundary is lines"),
            ([mesh, stl, "--dimension", "2"], f"{stl}: the boundary is lines"),
        ):
            command = [sys.executable, "-m", "insideout", *arguments]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            with self.subTest(arguments):
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(words, done.stderr)
                self.assertNotIn("validating", done.stderr)
        self.assertEqual(sorted(os.listdir(os.path.dirname(curve))), ["curve.csv", "mesh.obj"])

    def test_the_picture_is_of_what_is_written(self):
        source = self.path("curve.csv", CSV)
        done = self.run_on(source, "--edge-length", "0.5", "--surface-treatment", "split", "--plot", self.path("out.png"))
        self.assertEqual(done.returncode, 0, done.stderr)
        hull = insideout.tetrahedralize(source).hull
        insideout.draw(source, hull, self.path("expected.png"), solid=grid_in(self.path("out.vtu")))
        np.testing.assert_array_equal(pixels_of(self.path("out.png")), pixels_of(self.path("expected.png")))

    def test_checking_lines_says_what_they_enclose_and_what_is_wrong(self):
        report = self.path("check.json")
        command = [sys.executable, "-m", "insideout", "--check", self.path("curve.csv", CSV + "0.5,0.5,c\n0.5,2,c\n"), "--report", report]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("Curve curve.csv: bounds an area of 7 in a plane, once its gaps are closed\n"), done.stdout)
        for words in ("2 open ends", "3 intersecting pairs", "2 crossings", "1 T-junction"):
            self.assertIn(words, done.stdout)
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["statistics"]["Area"], 7)
        found = insideout.check(([*SQUARE], [(0, 1, 2), (0, 2, 3)]))
        self.assertEqual(found.verdict, "bounds no solid: it lies in one plane, where it covers an area of 4")
        open_line = surfaces.polydata(SQUARE[:3], [])
        open_line.SetLines(surfaces.polydata([], [(0, 1)]).GetPolys())
        open_line.GetLines().InsertNextCell(2, (1, 2))
        self.assertEqual(insideout.check(two_squares()).shell_volumes, [])
        self.assertEqual(insideout.check(open_line).findings[0].text, "2 open ends")

    def test_groups_of_an_obj_file_tag_the_boundary(self):
        result = insideout.tetrahedralize(self.path("curve.obj", OBJ))
        self.assertEqual({name: len(lines) for name, lines in result.tags.items()}, {"first": 1, "second": 1})

    def test_lines_beside_faces_are_passed_over(self):
        faces = OBJ + "f 1 2 3 4\n"
        result = insideout.tetrahedralize(self.path("both.obj", faces))
        self.assertEqual(result.statistics["Area"], 4)
        self.assertTrue(any("2 lines and points were skipped" in warning for warning in result.warnings))

    def test_bad_tables_and_lines_are_named(self):
        for name, content, words in (
            ("a.csv", "x,y\n0,0\n1,one\n", "line 3"),
            ("b.csv", "a,b\n0,0\n", "there must be x and y"),
            ("c.csv", "0,0\n1\n", "line 2"),
            ("d.csv", "0,0\n1,1\n2,2\n", "one line"),
            ("e.obj", "v 0 0 0\nv 1 0 0\nl 1 3\n", "line 3: line refers to point '3' of 2"),
            ("f.obj", "v 0 0 0\nv 1 0 0\nl 1 x\n", "line 3"),
        ):
            with self.subTest(name):
                done = self.run_on(self.path(name, content))
                self.assertEqual(done.returncode, 1)
                self.assertIn(words, done.stderr)

    def test_a_table_without_names_is_one_line_and_may_have_heights(self):
        square = "\n".join(f"{x},{y},5" for x, y, _ in [*SQUARE, SQUARE[0]])
        result = insideout.tetrahedralize(self.path("square.csv", square))
        self.assertEqual(set(result.solid.points[:, 2]), {5})
        self.assertEqual(result.statistics["Area"], 4)


if __name__ == "__main__":
    unittest.main()
