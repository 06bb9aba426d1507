# SPDX-License-Identifier: GPL-3.0-or-later
"""`refine`, and what refines in `tetrahedralize` and on the command line."""

import inspect
import json
import math
import os
import pickle
import subprocess
import sys
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from insideout.surfaces import make_surface
from insideout.options import DEFAULTS, REFINING_OPTIONS
from insideout.stages import REFINE, TETRAHEDRALIZE, UNNAMED
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, vtkImageData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def content(solid) -> tuple:
    arrays = [sorted(found.items()) for found in (solid.point_arrays, solid.cell_arrays)]
    return solid.points.tobytes(), solid.cells.tobytes(), [(name, values.tobytes()) for one in arrays for name, values in one]


def points_with_sizes():
    """A data set without cells, so that nothing is between its points."""
    points = surfaces.polydata([(0, 0, 0)], [])
    surfaces.add_array(points.GetPointData(), "Size", np.ones(1))
    return points


def faces_on_boundary(solid) -> set:
    """The coordinates of the faces that one cell has."""
    faces, numbers = surfaces.faces_of(solid)
    once = np.bincount(numbers)[numbers] == 1
    return {frozenset(map(tuple, solid.points[face].tolist())) for face in faces[once]}


def sphere(resolution: int):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(1)
    source.Update()
    return source.GetOutput()


def barycenters(solid) -> np.ndarray:
    return solid.points[solid.cells[:, :4]].mean(axis=1)


class Surface(unittest.TestCase):
    """What becomes of the boundary: beside the tetrahedra, the surface of its own and what is known of its triangles."""

    @staticmethod
    def tagged_boxes():
        surface = surfaces.two_boxes()
        places = np.array([surface.GetCell(k).GetBounds()[0] for k in range(surface.GetNumberOfCells())])
        surfaces.add_array(surface.GetCellData(), "Side", (places > 0.4).astype(np.int64))
        surfaces.add_array(surface.GetPointData(), "Height", surfaces.points_of(surface)[:, 2].copy())
        return surface

    def check(self, made, before) -> None:
        boundary = made.boundary
        self.assertTrue(surfaces.is_watertight(boundary))
        of_solid = faces_on_boundary(made.solid)
        self.assertEqual({frozenset(map(tuple, boundary.points[face].tolist())) for face in boundary.triangles}, of_solid)
        self.assertGreater(len(boundary.triangles), len(before.boundary.triangles))
        self.assertEqual(set(boundary.cell_arrays), set(before.boundary.cell_arrays))
        # Linear data stay linear, for the triangles are flat.
        np.testing.assert_allclose(boundary.point_arrays["Height"], boundary.points[:, 2], atol=1e-12)
        new = boundary.point_arrays["vtkOriginalPointIds"] < 0
        self.assertGreater(new.sum(), made.statistics["SurfacePoints"] / 2)
        # A piece is of the input's triangle in whose plane it lies, and has its tag.
        given = surfaces.triangles_of(self.tagged)
        corners = surfaces.points_of(self.tagged)[given[boundary.cell_arrays["vtkOriginalCellIds"]]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        places = boundary.points[boundary.triangles] - corners[:, :1]
        np.testing.assert_allclose(np.einsum("tpk,tk->tp", places, normals), 0, atol=1e-12)
        sides = surfaces.cell_array(self.tagged, "Side")[boundary.cell_arrays["vtkOriginalCellIds"]]
        np.testing.assert_array_equal(boundary.cell_arrays["Side"], sides)
        self.assertEqual(sorted(made.tags), ["0", "1"])
        for name, of_tag in made.tags.items():
            np.testing.assert_array_equal(of_tag, np.flatnonzero(sides == int(name)))
        self.assertAlmostEqual(float(sum(surfaces.exact_volumes(made.solid))), 15 / 8, delta=1e-12)
        self.assertEqual(made.statistics["BoundaryFaces"], len(boundary.triangles))

    def test_figures_of_a_remeshed_solid_are_those_of_its_cells(self):
        made = insideout.tetrahedralize(
            sphere(24), edge_length=0.5, surface_treatment="remeshed", surface_tolerance=0.1
        )
        volume = float(sum(surfaces.exact_volumes(made.solid)))
        self.assertAlmostEqual(made.statistics["Volume"], volume, delta=1e-12)
        self.assertAlmostEqual(made.regions[0].volume, volume, delta=1e-12)
        self.assertNotAlmostEqual(insideout.check(sphere(24)).statistics["EnclosedVolume"], volume, delta=1e-3)
        for figure in ("SurfaceDistance", "InputDistance"):
            self.assertGreater(made.statistics[figure], 0.01)
            self.assertLessEqual(made.statistics[figure], 0.1)
        self.assertGreater(made.statistics["DihedralAngle1Percent"], made.statistics["BeforeDihedralAngle1Percent"])
        quality = insideout.check_solid(made.solid).statistics
        for figure in ("MinDihedralAngle", "CellsUnder10Degrees", "SurfaceEdgesUnder10Degrees"):
            self.assertEqual(made.statistics[figure], quality[figure])

    def test_pieces_and_triangles_in_their_place_know_the_input(self):
        self.tagged = self.tagged_boxes()
        before = insideout.tetrahedralize(self.tagged, tag_array="Side")
        for treatment, length in (("split", 0.2), ("remeshed", 0.15)):
            with self.subTest(treatment):
                made = insideout.tetrahedralize(
                    self.tagged, tag_array="Side", edge_length=length, surface_treatment=treatment
                )
                self.assertEqual(made.warnings, before.warnings)
                self.check(made, before)
                self.assertEqual(made.statistics["KeptFacets"], 0)
                if treatment == "remeshed":
                    self.assertLessEqual(made.statistics["SurfaceDistance"], 1e-12)
                    self.assertLessEqual(made.statistics["InputDistance"], 1e-12)

    def test_facets_of_cells_are_those_of_the_pieces(self):
        solid = insideout.tetrahedralize(surfaces.two_boxes()).solid
        given = surfaces.two_boxes()
        split = insideout.refine(solid, edge_length=0.2, surface_treatment="split").solid
        faces, numbers = surfaces.faces_of(split)
        once = np.bincount(numbers)[numbers] == 1
        facets = split.cell_arrays["FacetIds"].ravel()
        np.testing.assert_array_equal(facets >= 0, once)
        corners = surfaces.points_of(given)[surfaces.triangles_of(given)[facets[once]]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        places = split.points[faces[once]] - corners[:, :1]
        np.testing.assert_allclose(np.einsum("tpk,tk->tp", places, normals), 0, atol=1e-12)

    def test_point_data_are_interpolated_at_the_limits_of_doubles(self):
        for size in (1e-300, 1e150, 1e300):
            with self.subTest(size):
                box = surfaces.box()
                places = surfaces.points_of(box)
                low, high = places.min(), places.max()
                surfaces.add_array(box.GetPointData(), "X", (places[:, 0] - low) / (high - low))
                triangles = np.array([[box.GetCell(k).GetPointId(i) for i in range(3)] for k in range(box.GetNumberOfCells())])
                huge = make_surface(places * size, triangles)
                huge.GetPointData().ShallowCopy(box.GetPointData())
                for length in ({"edge_length": 0.3 * size}, {"size_rules": f"point 0 0 0={0.2 * size!r}; gap=3; curvature=12"}):
                    made = insideout.tetrahedralize(huge, **length)
                    self.assertGreater(len(made.solid.cells), 12)
                    self.assertFalse(np.isnan(made.boundary.point_arrays["X"]).any())
                    for mesh in (made.boundary, made.solid):  # in the volume points may be without data
                        known = ~np.isnan(mesh.point_arrays["X"])
                        expected = (mesh.points[known, 0] / size - low) / (high - low)
                        np.testing.assert_allclose(mesh.point_arrays["X"][known], expected, atol=1e-9)

    def test_options_that_join_triangles_take_a_surface_that_is_kept(self):
        for option in ("merge_coplanar_pieces", "split_seams"):
            with self.assertRaisesRegex(insideout.Error, f"{option} takes a surface that is kept"):
                insideout.tetrahedralize(surfaces.two_boxes(), refine=True, surface_treatment="split", **{option: True})
            made = insideout.tetrahedralize(surfaces.two_boxes(), edge_length=0.3, **{option: True})
            self.assertIn(f"{option} takes a surface that is kept where the solid is refined, and so it is though edge_length is given", made.warnings)


class Lengths(unittest.TestCase):
    """The lengths wanted, and those that the surface has."""

    @staticmethod
    def edges_of(made) -> np.ndarray:
        corners = made.boundary.points[made.boundary.triangles]
        return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)

    def told(self, surface, **options):
        made = insideout.tetrahedralize(surface, **options)
        return made, [warning for warning in made.warnings if warning.startswith("edge_length is ")]

    def test_a_kept_surface_that_does_not_obey_is_told_and_one_that_is_split_does(self):
        cube = surfaces.box(size=10)
        _, told = self.told(cube, edge_length=2, surface_treatment="kept")
        self.assertEqual(
            told,
            ["edge_length is 2, and edges of the surface, which is kept, are up to 14.1 long: surface_treatment split or remeshed makes them as short"],
        )
        self.assertEqual(self.told(cube, edge_length=8, surface_treatment="kept")[1], [])
        _, told = self.told(cube, edge_length=2, merge_coplanar_pieces=True)  # no other treatment is possible
        self.assertEqual(told, ["edge_length is 2, and edges of the surface, which is kept, are up to 14.1 long"])
        for options in ({}, {"surface_treatment": "split"}, {"surface_treatment": "remeshed"}):
            made, told = self.told(cube, edge_length=2, **options)
            self.assertEqual(told, [])
            self.assertLess(self.edges_of(made).max(), 2 * 2)

    def test_lengths_that_would_make_too_many_cells_are_refused_before_any_work(self):
        cube = surfaces.box(size=10)
        refusal = r"edges as short as asked for would make about 6\.8e\+07 cells, more than maximum_cells, 10000000: they take some 27 GiB"
        with self.assertRaisesRegex(insideout.Error, refusal):
            insideout.tetrahedralize(cube, edge_length=0.05)
        with self.assertRaisesRegex(insideout.Error, "more than maximum_cells, 1000"):
            insideout.tetrahedralize(cube, edge_length=1, maximum_cells=1000)
        self.assertGreater(len(insideout.tetrahedralize(cube, edge_length=1, maximum_cells=0).solid.cells), 1000)

    def test_a_length_above_the_edges_makes_a_remeshed_surface_coarser_as_far_as_its_tolerance_permits(self):
        ball = surfaces.ball(1, 60, 40)
        triangles = ball.GetNumberOfPolys()
        made, told = self.told(ball, edge_length=0.7, surface_treatment="remeshed", surface_tolerance=0.2)
        self.assertEqual(told, [])
        self.assertLess(len(made.boundary.triangles), triangles / 10)
        made, (told,) = self.told(ball, edge_length=0.7, surface_treatment="remeshed")
        self.assertGreater(len(made.boundary.triangles), triangles / 10)
        shorter = np.median(self.edges_of(made))
        said = f"edge_length is 0.7, and half of the edges of the surface are shorter than {shorter:.3g}, because it stays within surface_tolerance, "
        self.assertTrue(told.startswith(said), told)


class Function(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = insideout.tetrahedralize(surfaces.two_boxes())
        cls.solid = cls.made.solid

    def test_better_cells_of_the_same_solid_come_back(self):
        result = insideout.refine(self.solid, edge_length=0.2, surface_treatment="kept")
        (warning,) = result.warnings
        self.assertRegex(warning, "^edge_length is 0.2, and edges of the surface, which is kept, are up to 1.41 long: surface_treatment split or remeshed")
        volumes = surfaces.exact_volumes(result.solid)
        self.assertGreater(min(volumes), 0)
        self.assertAlmostEqual(float(sum(volumes)), 15 / 8, delta=1e-12)
        self.assertEqual(faces_on_boundary(result.solid), faces_on_boundary(self.solid))
        self.assertEqual(result.statistics["RefinedCells"], len(result.solid.cells))
        new = result.solid.point_arrays["vtkOriginalPointIds"] < 0
        self.assertGreaterEqual(new.sum(), result.statistics["AddedPoints"])
        self.assertTrue(result.solid.inside.all())
        self.assertIn(f"tetrahedra {len(result.solid.cells):,}", repr(result))
        self.assertEqual(content(pickle.loads(pickle.dumps(result)).solid), content(result.solid))

    def test_the_same_bytes_on_any_number_of_threads(self):
        program = (
            "import hashlib, sys, insideout, surfaces\n"
            "insideout.pipeline.set_threads(int(sys.argv[1]))\n"
            "solid = insideout.tetrahedralize(surfaces.two_boxes(), edge_length=0.1, quadratic_cells=True).solid\n"
            "arrays = [solid.points, solid.cells, *solid.point_arrays.values(), *solid.cell_arrays.values()]\n"
            "print(len(solid.cells), hashlib.sha256(b''.join(one.tobytes() for one in arrays)).hexdigest())\n"
        )
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.path.dirname(__file__), os.environ.get("PYTHONPATH", "")])}
        said = {
            subprocess.run([sys.executable, "-c", program, threads], env=environment, check=True, capture_output=True).stdout
            for threads in ("1", "8")
        }
        self.assertEqual(len(said), 1)
        self.assertGreater(int(said.pop().split()[0]), 500)

    def test_quadratic_cells_have_ten_points(self):
        linear = insideout.refine(self.solid, edge_length=0.3).solid
        quadratic = insideout.refine(self.solid, edge_length=0.3, quadratic_cells=True).solid
        self.assertEqual(quadratic.GetCellType(0), VTK_QUADRATIC_TETRA)
        self.assertEqual(quadratic.cells.shape, (len(linear.cells), 10))
        np.testing.assert_array_equal(quadratic.cells[:, :4], linear.cells)
        ends = quadratic.points[quadratic.cells[:, [0, 1, 2, 0, 1, 2]]] + quadratic.points[quadratic.cells[:, [1, 2, 0, 3, 3, 3]]]
        np.testing.assert_array_equal(quadratic.points[quadratic.cells[:, 4:]], ends / 2)

    def test_meshio_knows_quadratic_cells(self):
        try:
            import meshio  # noqa: F401
        except ImportError:
            self.skipTest("meshio is not installed")
        quadratic = insideout.refine(self.solid, quadratic_cells=True).solid
        (block,) = quadratic.to_meshio().cells
        self.assertEqual((block.type, block.data.shape), ("tetra10", quadratic.cells.shape))

    def test_sizes_can_be_an_array_its_name_or_a_background(self):
        lengths = 0.1 + 0.1 * self.solid.points[:, 0]
        given = insideout.refine(self.solid, sizes=lengths).solid
        self.assertGreater(len(given.cells), 2 * len(insideout.refine(self.solid).solid.cells))
        self.assertNotIn("insideout.sizes", given.point_arrays)
        self.assertNotIn("insideout.sizes", self.solid.point_arrays)
        named = vtkUnstructuredGrid()
        named.ShallowCopy(self.solid)
        surfaces.add_array(named.GetPointData(), "Size", lengths)
        self.assertEqual(insideout.refine(named, sizes="Size").solid.cells.tobytes(), given.cells.tobytes())

        image = vtkImageData()
        image.SetOrigin(-1, -1, -1)
        image.SetSpacing(4, 4, 4)
        image.SetDimensions(2, 2, 2)
        surfaces.add_array(image.GetPointData(), "Size", np.full(8, 0.2))
        everywhere = insideout.refine(self.solid, sizes="Size", background=image).solid
        # As long, but not on the lattice of a length that is asked for everywhere.
        self.assertLess(abs(math.log(len(everywhere.cells) / len(insideout.refine(self.solid, edge_length=0.2).solid.cells))), math.log(2))

    def test_points_and_cells_can_be_arrays(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        result = insideout.refine((points, [(0, 2, 1, 3)]), maximum_volume=1)  # turned over
        self.assertAlmostEqual(float(sum(surfaces.exact_volumes(result.solid))), 1 / 6, delta=1e-15)

    def test_warnings_name_the_argument(self):
        points = 6 * np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        (warning,) = insideout.refine((points, [(0, 1, 2, 3)]), maximum_volume=0.1).warnings
        self.assertIn("cells are larger than maximum_volume, 0.1:", warning)

    def test_errors_name_the_culprit(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        for words, solid, options in (
            ("the solid is of type int; it can be", 3, {}),
            ("the solid is of type vtkImageData; it can be", vtkImageData(), {}),
            ("cells has 3 columns; it must have 4", (points, [(0, 1, 2)]), {}),
            ("cell 0 has the point 9, which is not there", (points, [(0, 1, 2, 9)]), {}),
            ("cell 0 has no volume", (points, [(0, 1, 2, 2)]), {}),
            ("the grid has no cells", (points, []), {}),
            ("edge_length is -1; it must be finite and at least 0", self.solid, {"edge_length": -1}),
            ("grading is 0; it must be finite and at least 1e-06", self.solid, {"grading": 0}),
            (r"sizes has the shape \(2,\); it must have one value", self.solid, {"sizes": [1, 2]}),
            ("sizes is not a table of numbers", self.solid, {"sizes": object()}),
            ("the grid has no point array Size", self.solid, {"sizes": "Size"}),
            ("the background has no cells, between", self.solid, {"sizes": "Size", "background": points_with_sizes()}),
            ("background is of type int; it must be a vtkDataSet", self.solid, {"sizes": "Size", "background": 3}),
            ("sizes has to be the name", self.solid, {"background": vtkImageData()}),
        ):
            with self.subTest(words), self.assertRaisesRegex(insideout.Error, f"^{words}"):
                insideout.refine(solid, **options)

    def test_progress_can_stop_it(self):
        class Stop(Exception):
            pass

        def stop(stage, fraction):
            if (stage, fraction > 0.2) == ("refining", True):
                raise Stop

        with self.assertRaises(Stop):
            insideout.refine(self.solid, edge_length=0.1, progress=stop)

    def test_its_options_are_those_of_tetrahedralize(self):
        parameters = inspect.signature(insideout.refine).parameters
        others = inspect.signature(insideout.tetrahedralize).parameters
        for name in REFINING_OPTIONS:
            self.assertEqual(parameters[name].default, DEFAULTS[name])
            self.assertEqual(parameters[name].annotation, others[name].annotation)
        self.assertNotIn("{", insideout.refine.__doc__)


class Tetrahedralize(unittest.TestCase):
    def test_it_refines_its_solid_alone(self):
        surface = surfaces.two_boxes()
        plain, refined = insideout.tetrahedralize(surface), insideout.tetrahedralize(surface, refine=True)
        self.assertEqual(content(refined.solid), content(insideout.refine(plain.solid).solid))
        self.assertNotEqual(content(refined.solid), content(plain.solid))
        self.assertEqual(refined.hull.cells.tobytes(), plain.hull.cells.tobytes())
        self.assertEqual(refined.boundary.triangles.tobytes(), plain.boundary.triangles.tobytes())
        self.assertEqual(refined.statistics["RefinedCells"], len(refined.solid.cells))
        self.assertEqual(refined.statistics["InsideCells"], len(plain.solid.cells))

    def test_w_of_refined_cells_of_an_open_surface_is_that_at_their_own_barycenters(self):
        for treatment in ("kept", "split", "remeshed"):
            with self.subTest(treatment):
                self.expect_w(surfaces.open_box(), surface_treatment=treatment)
        self.expect_w(surfaces.open_box(), quadratic_cells=True)

    def expect_w(self, surface, **options):
        solid = insideout.tetrahedralize(surface, refine=True, **options).solid
        expected = insideout.winding_number(surface, barycenters(solid))
        np.testing.assert_allclose(solid.w, expected, rtol=0, atol=1e-13)

    def test_w_of_refined_cells_is_the_sum_over_bodies_of_which_one_is_open(self):
        bodies = {"open": surfaces.open_box(), "closed": surfaces.box((0.5, 0.5, 0.5))}
        solid = insideout.tetrahedralize(bodies, refine=True).solid
        places = barycenters(solid)
        each = np.transpose([insideout.winding_number(body, places) for body in bodies.values()])
        np.testing.assert_allclose(solid.cell_arrays["BodyW"], each, rtol=0, atol=1e-13)
        np.testing.assert_allclose(solid.w, each.sum(axis=1), rtol=0, atol=1e-13)

    def test_each_option_implies_it(self):
        for options in ({"edge_length": 0.3}, {"grading": 0.1}, {"maximum_volume": 0.01}, {"quadratic_cells": True}):
            with self.subTest(options):
                made = insideout.tetrahedralize(surfaces.two_boxes(), **options)
                expected = insideout.tetrahedralize(surfaces.two_boxes(), refine=True, **options)
                self.assertIn("RefinedCells", made.statistics)
                self.assertEqual(content(made.solid), content(expected.solid))

    def test_progress_goes_through_all_stages_and_never_back(self):
        heard = []
        insideout.tetrahedralize(surfaces.two_boxes(), refine=True, progress=lambda *told: heard.append(told))
        stages = [stage for stage, _ in heard if stage != UNNAMED]
        self.assertEqual(list(dict.fromkeys(stages)), [*TETRAHEDRALIZE, *REFINE])
        fractions = [fraction for stage, fraction in heard if stage != UNNAMED]
        self.assertEqual(fractions, sorted(fractions))
        self.assertGreater(fractions[-1], 0.95)

    def test_nothing_inside_is_nothing_to_refine(self):
        sheets = make_surface([(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 5, 5), (6, 5, 5), (5, 6, 6)], [(0, 1, 2), (3, 4, 5)])
        made = insideout.tetrahedralize(sheets, refine=True)
        self.assertEqual(made.solid.GetNumberOfCells(), 0)
        self.assertNotIn("RefinedCells", made.statistics)


class CommandLine(unittest.TestCase):
    def test_it_writes_what_the_function_gives(self):
        with tempfile.TemporaryDirectory() as folder:
            surface, output, report = (os.path.join(folder, name) for name in ("boxes.vtp", "solid.vtu", "report.json"))
            insideout.write(surfaces.two_boxes(), surface)
            done = subprocess.run(
                [sys.executable, "-m", "insideout", surface, output, "--edge-length", "0.3", "--quadratic-cells", "--report", report],
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual((done.returncode, done.stdout.count("refined to")), (0, 1), done.stderr)
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(output)
            reader.Update()
            with open(report, encoding="utf-8") as file:
                told = json.load(file)
        expected = insideout.tetrahedralize(surfaces.two_boxes(), edge_length=0.3, quadratic_cells=True).solid
        written = insideout.data.as_type(insideout.Tetrahedra, reader.GetOutput())
        self.assertEqual(content(written)[:2], content(expected)[:2])
        self.assertEqual(told["statistics"]["RefinedCells"], len(expected.cells))
        self.assertEqual([told["parameters"][name] for name in ("refine", "edge_length", "quadratic_cells")], [True, 0.3, True])


if __name__ == "__main__":
    unittest.main()
