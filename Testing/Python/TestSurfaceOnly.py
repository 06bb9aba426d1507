# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary of what a closed surface means, without tetrahedra: the same solid as by these."""

import os
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from insideout.bodies import join
from TestBoolean import dirty_surfaces
from vtkmodules.vtkCommonDataModel import vtkPolyData


def check_solid(test: unittest.TestCase, made: insideout.Tetrahedralization, volume: float):
    test.assertTrue(surfaces.is_watertight(made.boundary))
    test.assertEqual(insideout.check(made.boundary, orientation="as-given").statistics["IntersectingPairs"], 0)
    test.assertAlmostEqual(surfaces.enclosed_volume(made.boundary), volume, delta=1e-9 * volume)
    test.assertAlmostEqual(made.statistics["Volume"], volume, delta=1e-9 * volume)
    test.assertEqual((made.solid.GetNumberOfCells(), made.hull.GetNumberOfCells()), (0, 0))


def random_balls(seed: int) -> vtkPolyData:
    """Octahedra with bumps that overlap, each turned another way, some inside out."""
    random = np.random.default_rng(seed)
    corners = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    facets = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
    parts = []
    for _ in range(6):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        points = corners * random.uniform(0.5, 1.5, size=(6, 1)) @ turn + random.normal(size=3) / 2
        parts.append(surfaces.polydata(points, facets if random.random() < 0.7 else facets[:, ::-1]))
    return surfaces.joined(*parts)


class Laws(unittest.TestCase):
    def test_the_solid_is_that_of_the_tetrahedra(self):
        for index, surface in enumerate([*dirty_surfaces(), *map(random_balls, range(4))]):
            with self.subTest(surface=index):
                made = insideout.tetrahedralize(surface, surface_only=True)
                expected = insideout.tetrahedralize(surface)
                self.assertEqual(made.statistics["Tetrahedra"], 0)
                check_solid(self, made, expected.statistics["Volume"])
                self.assertEqual(made.statistics["MinimumW"], min(0, expected.statistics["MinimumW"]))  # beyond the hull w is 0
                for name in ("MaximumW", "OutlierFacets", "TurnedFacets", "LostShare"):
                    self.assertAlmostEqual(made.statistics[name], expected.statistics[name], 12, name)
                self.assertEqual((made.warnings, made.turned_cells), (expected.warnings, expected.turned_cells))

    def test_open_surfaces_and_options_of_cells_go_through_tetrahedra(self):
        closed = surfaces.two_boxes()
        self.assertEqual(insideout.tetrahedralize(closed, surface_only=True).statistics["Tetrahedra"], 0)
        seeds = [((0.1, 0.1, 0.1), True)]
        asked = ({"refine": True}, {"seeds": seeds}, {"constrain_facets": True}, {"non_manifold": "fill"}, {"non_manifold": "split"},
                 {"separate_overlaps": True}, {"largest_regions": 1}, {"fill_cavities": True}, {"topology": "one-component"},
                 {"gamma": 3}, {"sigma": 0.2}, {"data_term": "volume-weighted"})
        for options in asked:
            with self.subTest(options=options):
                made = insideout.tetrahedralize(closed, surface_only=True, **options)
                self.assertEqual(made.statistics["Tetrahedra"], 1)
                self.assertEqual((made.solid.GetNumberOfCells(), made.hull.GetNumberOfCells()), (0, 0))
                if "separate_overlaps" not in options:  # of which the boundary overlaps
                    check_solid(self, made, 15 / 8)
        made = insideout.tetrahedralize(surfaces.open_box(), surface_only=True)
        self.assertEqual(made.statistics["Tetrahedra"], 1)
        check_solid(self, made, 1)
        made = insideout.tetrahedralize({"a": surfaces.box(), "b": surfaces.box((0.5, 0, 0))}, surface_only=True)
        self.assertEqual((made.statistics["Tetrahedra"], made.statistics["Bodies"]), (1, 2))
        self.assertEqual({name: round(volume, 9) for name, volume in made.bodies.items()}, {"a": 1, "b": 1})

    def test_warning_says_why_nothing_is_inside(self):
        inward = surfaces.reversed_box()
        made, expected = (insideout.tetrahedralize(inward, orientation="as-given", surface_only=only) for only in (True, False))
        self.assertEqual(made.boundary.GetNumberOfCells(), 0)
        self.assertEqual(made.warnings, expected.warnings)
        self.assertIn("nothing is inside", made.warnings[-1])

    def test_in_a_plane_only_the_cells_are_left_away(self):
        square = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
        made = insideout.tetrahedralize(square, surface_only=True)
        self.assertTrue(made.is_planar())
        self.assertEqual((made.solid.GetNumberOfCells(), made.statistics["Area"], len(made.regions)), (0, 1, 1))
        self.assertGreater(made.boundary.GetNumberOfCells(), 0)


class Data(unittest.TestCase):
    def test_the_boundary_has_the_arrays_of_that_of_the_tetrahedra(self):
        box = surfaces.joined(surfaces.two_boxes(), surfaces.polydata([(9, 9, 9), (9.5, 9, 9), (9, 9.5, 9)], [(0, 1, 2), (0, 2, 1)]))
        surfaces.add_array(box.GetCellData(), "kind", np.arange(26) // 12)
        surfaces.add_array(box.GetPointData(), "heat", np.arange(19.0))
        self.assertEqual(insideout.tetrahedralize(surfaces.open_box(), surface_only=True).statistics["Tetrahedra"], 1)
        made, expected = (insideout.tetrahedralize(box, tag_array="kind", surface_only=only) for only in (True, False))
        self.assertEqual(made.statistics["Tetrahedra"], 0)
        for name in ("boundary", "outliers"):
            ours, theirs = getattr(made, name), getattr(expected, name)
            self.assertEqual(set(ours.cell_arrays), set(theirs.cell_arrays), name)
            self.assertEqual(set(ours.point_arrays), set(theirs.point_arrays), name)
        np.testing.assert_array_equal(made.boundary.cell_arrays["kind"], made.boundary.cell_arrays["vtkOriginalCellIds"] // 12)
        self.assertEqual(set(made.tags), set(expected.tags))
        self.assertEqual(made.outliers.GetNumberOfCells(), expected.outliers.GetNumberOfCells())
        self.assertEqual(set(made.outliers.cell_arrays["OutlierReason"]), {0})

    def test_pieces_are_put_together_and_seams_split_as_with_tetrahedra(self):
        surface = surfaces.joined(surfaces.box((0, 0, 0), 4), surfaces.box((1, 1, 0)))  # cuts the bottom from within
        surfaces.add_array(surface.GetPointData(), "heat", np.arange(16.0))
        for options in ({"merge_coplanar_pieces": True}, {"split_seams": True}):
            made = insideout.tetrahedralize(surface, surface_only=True, **options)
            self.assertEqual(made.statistics["Tetrahedra"], 0)
            self.assertAlmostEqual(surfaces.enclosed_volume(made.boundary), 64, 12)
        whole = insideout.tetrahedralize(surface, surface_only=True)
        merged = insideout.tetrahedralize(surface, surface_only=True, merge_coplanar_pieces=True)
        self.assertGreater(whole.boundary.GetNumberOfCells(), 12)
        self.assertEqual(merged.boundary.GetNumberOfCells(), 12)

    def test_the_resolved_surface_is_kept_for_when_cells_are_wanted(self):
        filter = insideout.vtkRobustTetrahedralize()
        filter.SetInputData(surfaces.two_boxes())
        filter.SurfaceOnlyOn()
        filter.Update()
        self.assertEqual(filter.GetOutput().GetNumberOfCells(), 0)
        resolved = insideout.pipeline.statistics_of(filter.GetOutput())["SecondsPre"]
        filter.SurfaceOnlyOff()
        filter.Update()
        self.assertGreater(filter.GetOutput().GetNumberOfCells(), 0)
        self.assertEqual(insideout.pipeline.statistics_of(filter.GetOutput())["SecondsPre"], resolved)

    def test_a_hull_has_the_same_statistics(self):
        filter = insideout.vtkRobustTetrahedralize()
        filter.SetInputData(surfaces.two_boxes())
        filter.SurfaceOnlyOn()
        filter.GenerateHullOn()
        filter.Update()
        self.assertGreater(filter.GetHull().GetNumberOfCells(), 0)
        solid, hull = (insideout.pipeline.statistics_of(data) for data in (filter.GetOutput(), filter.GetHull()))
        self.assertEqual(hull, solid)

    def test_files_of_cells_are_refused_for_the_boundary_alone(self):
        square = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
        for surface in (surfaces.two_boxes(), surfaces.open_box(), square):
            made = insideout.tetrahedralize(surface, surface_only=True)
            for ending in ("vtu", "msh", "xdmf"):
                with tempfile.TemporaryDirectory() as folder:
                    file = os.path.join(folder, f"solid.{ending}")
                    self.assertRaisesRegex(insideout.Error, f"{file}.*surface_only left these away", insideout.write, made, file)
                    self.assertEqual(os.listdir(folder), [])
            self.assertRaisesRegex(insideout.Error, "surface_only left these away", made.to_meshio)

    def test_results_can_be_shown_and_joined_bodies_too(self):
        made = insideout.tetrahedralize(surfaces.two_boxes(), surface_only=True)
        self.assertEqual(made.regions, [])
        self.assertNotIn("inside", repr(made))
        self.assertIn("boundary triangles", repr(made))
        bodies, _ = join({"a": surfaces.box(), "b": surfaces.box((2, 0, 0))})
        self.assertEqual(insideout.tetrahedralize(bodies, surface_only=True).statistics["Tetrahedra"], 0)


if __name__ == "__main__":
    unittest.main()
