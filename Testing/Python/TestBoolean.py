# SPDX-License-Identifier: GPL-3.0-or-later
"""Set operations of bodies whose surfaces are broken: laws of volumes, both ways, data and errors."""

import unittest

import insideout
import numpy as np
import surfaces
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource


def moved(surface: vtkPolyData, random: np.random.Generator, in_a_plane: bool) -> vtkPolyData:
    """Along an axis, so that faces stay in their planes, or turned in any way."""
    points = surfaces.points_of(surface)
    if in_a_plane:
        return surfaces.polydata(points + [random.uniform(0.1, 0.9), 0, 0], surfaces.triangles_of(surface))
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    flip = np.linalg.det(turn) < 0
    return surfaces.polydata(points @ (-turn if flip else turn).T + random.normal(size=3) / 5, surfaces.triangles_of(surface))


def dirty_surfaces() -> list[vtkPolyData]:
    """Closed, with what real ones have: parts that overlap, duplicates, a part that is inside out, both sides drawn."""
    small = surfaces.box((0.2, 0.3, 0.4), 0.3)
    return [
        surfaces.two_boxes(),
        surfaces.joined(surfaces.box(), surfaces.box()),
        surfaces.joined(surfaces.box(), surfaces.polydata(surfaces.points_of(small) + 0.9, surfaces.triangles_of(small)[:, ::-1])),
        surfaces.joined(surfaces.box(), surfaces.reversed_box()),
        surfaces.joined(surfaces.box(), surfaces.polydata(surfaces.points_of(small), surfaces.triangles_of(small)[:, ::-1])),
    ]


def volume(bodies, expression: str, **options) -> float:
    made = insideout.boolean(bodies, expression, **options)
    if made.surface.GetNumberOfCells() == 0:
        return 0.0
    assert surfaces.is_watertight(made.surface), expression
    assert insideout.check(made.surface, orientation="as-given").statistics["IntersectingPairs"] == 0, expression
    np.testing.assert_allclose(made.statistics["Volume"], surfaces.enclosed_volume(made.surface), rtol=1e-9)
    return made.statistics["Volume"]


class Laws(unittest.TestCase):
    def test_volumes_add_up_and_both_ways_agree(self):
        random = np.random.default_rng(3)
        for index, first in enumerate(dirty_surfaces()):
            second = moved(dirty_surfaces()[random.integers(5)], random, in_a_plane=index % 2 == 0)
            bodies = [first, second]
            with self.subTest(first=index):
                a, b, either, both, less = (volume(bodies, text) for text in ("A", "B", "A | B", "A & B", "A - B"))
                self.assertAlmostEqual(a + b, either + both, delta=1e-9 * (a + b))
                self.assertAlmostEqual(less, a - both, delta=1e-9 * (a + b))
                for text, expected in (("A | B", either), ("A & B", both), ("A - B", less)):
                    self.assertAlmostEqual(volume(bodies, text, tetrahedra=True), expected, delta=1e-9 * (a + b))

    def test_the_tetrahedra_fill_what_the_surface_bounds(self):
        made = insideout.boolean([surfaces.two_boxes(), surfaces.box((0.2, 0.2, 0.2))], "A ^ B", tetrahedra=True)
        self.assertEqual(made.statistics["Tetrahedra"], 1)
        self.assertAlmostEqual(float(sum(surfaces.exact_volumes(made.solid))), made.statistics["Volume"], 12)
        self.assertEqual(insideout.boolean([surfaces.two_boxes()]).solid.GetNumberOfCells(), 0)

    def test_one_surface_is_repaired(self):
        made = insideout.boolean([surfaces.two_boxes()])
        self.assertAlmostEqual(made.statistics["Volume"], 15 / 8, 12)
        self.assertTrue(surfaces.is_watertight(made.surface))

    def test_an_open_body_goes_through_tetrahedra(self):
        made = insideout.boolean({"box": surfaces.open_box(), "hole": surfaces.box((0.25, 0.25, -1), 0.5)}, "box - hole")
        self.assertEqual(made.statistics["Tetrahedra"], 1)
        self.assertAlmostEqual(made.statistics["Volume"], 1, 9)  # they do not meet
        made = insideout.boolean({"box": surfaces.open_box(), "hole": surfaces.box((0.25, 0.25, -0.25), 0.5)}, "box - hole")
        self.assertTrue(surfaces.is_watertight(made.surface))
        self.assertAlmostEqual(made.statistics["Volume"], 1 - 1 / 16, 9)
        self.assertIn(-1, made.bodies)  # the lid

    def test_planar_bodies_are_empty(self):
        flat = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        made = insideout.boolean([flat, flat])
        self.assertEqual((made.surface.GetNumberOfCells(), made.statistics["Volume"]), (0, 0))
        self.assertIn("all facets lie in one plane: nothing is inside", made.warnings)

    def test_operations_without_an_expression(self):
        bodies = [surfaces.box(), surfaces.box((0.5, 0, 0)), surfaces.box((0.75, 0, 0))]
        expected = {"union": 1.75, "intersection": 0.25, "difference": 0.5, "symmetric-difference": 1.0}
        for operation, size in expected.items():
            self.assertAlmostEqual(insideout.boolean(bodies, operation=operation).statistics["Volume"], size, 12)


class Gaps(unittest.TestCase):
    def test_close_below_the_tolerance_by_way_of_tetrahedra(self):
        bodies = ball, _ = surfaces.ball_in_a_socket(gap=0.006)
        whole, room = surfaces.enclosed_volume(surfaces.ball(2, 8, 9)), surfaces.enclosed_volume(ball)
        for expression, expected in (("A | B", whole), ("A - B", room), ("B - A", whole - room), ("A & B", 0)):
            made = insideout.boolean(bodies, expression, merge_tolerance=0.011)
            self.assertEqual(made.statistics["Tetrahedra"], 1)
            # Where points of both became one the socket's facets come into the ball.
            self.assertAlmostEqual(made.statistics["Volume"], expected, 9 if expression == "A | B" else 3)
            self.assertTrue(surfaces.is_watertight(made.surface) or expected == 0)
            self.assertIn("gaps between bodies that are narrower than the merge tolerance were closed by", "".join(made.warnings))

    def test_a_hairs_breadth_is_told_of(self):
        told = 0
        for seed in range(12):
            made = insideout.boolean(surfaces.turned_boxes(seed))
            lines = [line for line in made.warnings if line.startswith("bodies A and B nearly touch")]
            self.assertEqual(len(lines), made.statistics["NearTriangles"] > 0)
            told += len(lines)
        self.assertGreater(told, 0)

    def test_stay_above_it_without_tetrahedra(self):
        bodies = surfaces.ball_in_a_socket(gap=0.006)
        for expression in ("A | B", "B - A"):
            apart, below = (insideout.boolean(bodies, expression, merge_tolerance=tolerance) for tolerance in (0, 0.0015))
            self.assertEqual(below.statistics["Tetrahedra"], 0)
            self.assertEqual(below.surface.points.tobytes(), apart.surface.points.tobytes())
            self.assertEqual(below.surface.triangles.tobytes(), apart.surface.triangles.tobytes())


class Data(unittest.TestCase):
    def test_each_triangle_and_point_knows_its_body_and_cell(self):
        first, second = surfaces.box((0, 0, 0), 4), surfaces.box((1, 1, 1), 2)
        surfaces.add_array(first.GetCellData(), "kind", np.arange(12))
        surfaces.add_array(second.GetCellData(), "kind", np.arange(12) + 100)
        surfaces.add_array(second.GetPointData(), "heat", np.arange(8.0))
        made = insideout.boolean({"out": first, "in": second}, "out - in")
        self.assertEqual(made.names, ["out", "in"])
        cells = surfaces.cell_array(made.surface, "vtkOriginalCellIds")
        np.testing.assert_array_equal(surfaces.cell_array(made.surface, "kind"), cells + 100 * made.bodies)
        self.assertEqual(sorted(zip(made.bodies.tolist(), cells.tolist())), [(b, c) for b in (0, 1) for c in range(12)])
        bodies, points = (surfaces.point_array(made.surface, name) for name in ("BodyId", "vtkOriginalPointIds"))
        heat = surfaces.point_array(made.surface, "heat")
        np.testing.assert_array_equal(np.isnan(heat), bodies == 0)
        np.testing.assert_array_equal(heat[bodies == 1], points[bodies == 1])

    def test_arrays_of_the_input_whose_names_are_taken_stay(self):
        box = surfaces.box()
        for data, names in ((box.GetCellData(), ("BodyId", "BoundaryTag", "RegionIds")), (box.GetPointData(), ("BodyId",))):
            for name in names:
                surfaces.add_array(data, name, np.full(12 if data is box.GetCellData() else 8, 7))
        made = insideout.boolean([box])
        self.assertEqual(made.warnings, ["the input's array BodyId is passed on as Input_BodyId, because the output has its own"])
        for name in ("Input_BodyId", "BoundaryTag", "RegionIds"):
            self.assertEqual(set(surfaces.cell_array(made.surface, name)), {7})
        self.assertEqual(set(surfaces.point_array(made.surface, "Input_BodyId")), {7})
        self.assertEqual(set(made.bodies), {0})

    def test_blocks_are_bodies_and_inputs_are_called_by_letters(self):
        blocks = vtkMultiBlockDataSet()
        for index, (name, surface) in enumerate({"liver": surfaces.box(), "left lung": surfaces.box((0.5, 0, 0))}.items()):
            blocks.SetBlock(index, surface)
            blocks.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name)
        boolean = insideout.vtkWindingBoolean()
        boolean.AddInputDataObject(0, blocks)
        boolean.AddInputDataObject(0, surfaces.box((0, 0.5, 0)))
        boolean.SetExpression("liver - 'left lung' - C")
        self.assertEqual(insideout.pipeline.run(boolean), [])
        self.assertAlmostEqual(insideout.pipeline.statistics_of(boolean.GetOutput())["Volume"], 0.25, 12)

    def test_the_pipeline_runs_again_when_an_input_changes(self):
        cube, sphere = vtkCubeSource(), vtkSphereSource()
        boolean = insideout.vtkWindingBoolean()
        boolean.AddInputConnection(cube.GetOutputPort())
        boolean.AddInputConnection(sphere.GetOutputPort())
        boolean.SetOperation(boolean.INTERSECTION)
        boolean.Update()
        before = insideout.pipeline.statistics_of(boolean.GetOutput())["Volume"]
        sphere.SetRadius(0.25)
        boolean.Update()
        self.assertLess(insideout.pipeline.statistics_of(boolean.GetOutput())["Volume"], before / 4)


    def test_a_piece_is_of_whole_bodies(self):
        cube, sphere = vtkCubeSource(), vtkSphereSource()
        boolean = insideout.vtkWindingBoolean()
        boolean.AddInputConnection(cube.GetOutputPort())
        boolean.AddInputConnection(sphere.GetOutputPort())
        boolean.SetOperation(boolean.DIFFERENCE)
        boolean.Update()
        whole = insideout.pipeline.statistics_of(boolean.GetOutput())["Volume"]
        boolean.Modified()
        boolean.UpdatePiece(0, 2, 0)  # of a sphere's source that would be half of it
        self.assertEqual(insideout.pipeline.statistics_of(boolean.GetOutput())["Volume"], whole)

    def test_a_name_that_is_not_there_is_none(self):
        boolean = insideout.vtkWindingBoolean()
        boolean.AddBodyName("liver")
        self.assertEqual([boolean.GetBodyName(body) for body in (-1, 0, 1, 3)], [None, "liver", None, None])


class Errors(unittest.TestCase):
    def test_an_expression_names_its_column(self):
        with self.assertRaisesRegex(insideout.Error, r'"A - \(B", column 5: this parenthesis is never closed'):
            insideout.boolean([surfaces.box(), surfaces.box()], "A - (B")
        with self.assertRaisesRegex(insideout.Error, "column 5: no body is called C; there are A, B"):
            insideout.boolean([surfaces.box(), surfaces.box()], "A - C")

    def test_a_body_is_named(self):
        bad = surfaces.box()
        bad.GetPoints().SetPoint(3, float("nan"), 0, 0)
        with self.assertRaisesRegex(insideout.Error, "body B: point 3 is not finite"):
            insideout.boolean([surfaces.box(), bad])

    def test_empty_and_unnamed_bodies_are_told(self):
        made = insideout.boolean([surfaces.box(), vtkPolyData()])
        self.assertTrue(any("body B: the surface has no polygons: the body is empty" in line for line in made.warnings), made.warnings)
        self.assertAlmostEqual(made.statistics["Volume"], 1, 12)
        made = insideout.boolean([surfaces.box(), surfaces.box()], "A")
        self.assertIn("body B is not in the expression", made.warnings)
        with self.assertRaisesRegex(insideout.Error, "there are no surfaces"):
            insideout.boolean([])

    def test_operands_other_than_several_surfaces_are_errors(self):
        for one in ("nofile.stl", surfaces.box(), 3):
            with self.assertRaisesRegex(insideout.Error, f"surfaces is of type {type(one).__name__}; a boolean takes several"):
                insideout.boolean(one)
        for several, words in (({"tumour": 3}, "body tumour: the surface is of type int"), ([surfaces.box(), 3], "body B: the surface is of type int")):
            with self.assertRaisesRegex(insideout.Error, words):
                insideout.boolean(several)


if __name__ == "__main__":
    unittest.main()
