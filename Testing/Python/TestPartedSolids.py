# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that touch themselves or overlap: NonManifold and SeparateOverlaps, from Python and on real surfaces."""

import os
import subprocess
import sys
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from real_surfaces import unpack_cgal


def joined(*boxes):
    """Boxes of low corner and size as one surface."""
    points, polygons = [], []
    for low, size in boxes:
        polygons += [[len(points) + k for k in polygon] for polygon in surfaces.BOX_FACETS]
        points += surfaces.box_points(low, size)
    return surfaces.polydata(points, polygons)


def boxes_with_an_edge_in_common():
    return joined(((0, 0, 0), 1), ((1, 1, 0), 1))


def hollows_with_a_point_in_common():
    """A box with two cavities."""
    surface = joined(((0, 0, 0), 4), ((1, 1, 1), 1), ((2, 2, 2), 1))
    triangles = surfaces.triangles_of(surface)
    triangles[len(surfaces.BOX_FACETS) :] = triangles[len(surfaces.BOX_FACETS) :, ::-1]
    return surfaces.polydata(surfaces.points_of(surface), triangles.tolist())


def cells_by_places(solid):
    """Each cell as its corners' coordinates."""
    return solid.points[solid.cells].tolist()


def connections(cells):
    """How many cells have each face."""
    faces = np.sort(cells[:, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]].reshape(-1, 3), axis=1)
    return np.unique(faces, axis=0, return_counts=True)[1]


class Touching(unittest.TestCase):
    def test_boxes_with_an_edge_in_common_are_two(self):
        surface = boxes_with_an_edge_in_common()
        kept, split = (insideout.tetrahedralize(surface, non_manifold=how) for how in ("keep", "split"))
        self.assertNotEqual(surfaces.count_not_manifold(kept.boundary.triangles), (0, 0))
        self.assertEqual(surfaces.count_not_manifold(split.boundary.triangles), (0, 0))
        self.assertEqual(len(split.solid.points), len(kept.solid.points) + 2)
        self.assertEqual(split.statistics["SplitPoints"], 2)
        self.assertEqual(split.statistics["SharedPoints"], 0)
        self.assertEqual(cells_by_places(split.solid), cells_by_places(kept.solid))
        self.assertEqual(split.statistics["Volume"], kept.statistics["Volume"])
        self.assertEqual(split.warnings, kept.warnings)
        ids = surfaces.point_array(split.solid, "vtkOriginalPointIds")
        given = surfaces.points_of(surface)
        self.assertEqual(sorted(ids[ids >= 0])[:4], [0, 1, 2, 2])
        np.testing.assert_array_equal(given[ids[ids >= 0]], split.solid.points[ids >= 0])

    def test_hollows_with_a_point_in_common_have_two_surfaces_there(self):
        surface = hollows_with_a_point_in_common()
        kept, split = (insideout.tetrahedralize(surface, non_manifold=how) for how in ("keep", "split"))
        self.assertAlmostEqual(split.statistics["Volume"], 62, delta=1e-12)
        self.assertEqual(len(split.solid.points), len(kept.solid.points))
        self.assertEqual(split.statistics["SharedPoints"], 1)
        self.assertEqual(surfaces.count_not_manifold(split.boundary.triangles), (0, 0))
        self.assertIn("1 points of the boundary are copies that the solid's cells share", "\n".join(split.warnings))

    def test_squares_with_a_corner_in_common_have_two_outlines(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 1, 0), (2, 2, 0), (1, 2, 0)]
        curve = surfaces.polydata(points, [])
        curve.SetLines(surfaces.polydata([], [(0, 1, 2, 3, 0), (2, 4, 5, 6, 2)]).GetPolys())
        kept, split = (insideout.tetrahedralize(curve, non_manifold=how) for how in ("keep", "split"))
        self.assertEqual(len(kept.solid.points), 7)
        self.assertEqual(len(split.solid.points), 8)
        self.assertEqual(split.statistics["SplitPoints"], 1)
        self.assertEqual(len(split.boundary.points), 8)
        with self.assertRaisesRegex(insideout.Error, "separates tetrahedra"):
            insideout.tetrahedralize(curve, separate_overlaps=True)

    def test_the_graph_cut_alone_splits_too(self):
        hull = insideout.tetrahedralize(boxes_with_an_edge_in_common()).hull
        cut = insideout.vtkGraphCutSegmentation()
        cut.SetInputData(hull)
        cut.Update()
        points = cut.GetOutput().GetNumberOfPoints()
        cut.SetNonManifoldToSplit()
        cut.Update()
        self.assertEqual(cut.GetOutput().GetNumberOfPoints(), points + 2)

    def test_excluded_options_are_refused(self):
        surface = surfaces.two_boxes()
        for parting in ({"non_manifold": "split"}, {"separate_overlaps": True}):
            for option in ({"merge_coplanar_pieces": True}, {"split_seams": True}):
                with self.assertRaisesRegex(insideout.Error, "does not go together with"):
                    insideout.tetrahedralize(surface, **parting, **option)
            with self.assertRaisesRegex(insideout.Error, "takes a surface that is kept"):
                insideout.tetrahedralize(surface, surface_treatment="split", **parting)
        cut = insideout.vtkGraphCutSegmentation()
        cut.SetInputData(insideout.tetrahedralize(surface).hull)
        cut.ExtractInsideOff()
        cut.SetNonManifoldToSplit()
        with self.assertRaisesRegex(insideout.Error, "takes ExtractInside"):
            insideout.pipeline.run(cut)


class Overlapping(unittest.TestCase):
    def test_boxes_that_cross_are_two_with_all_of_their_volume(self):
        result = insideout.tetrahedralize(surfaces.two_boxes(), separate_overlaps=True)
        self.assertEqual([result.statistics[name] for name in ("Overlaps", "SeparatedOverlaps")], [1, 1])
        self.assertEqual([round(region.volume, 12) for region in result.regions], [1, 1])
        np.testing.assert_array_equal(connections(result.solid.cells) <= 2, True)
        self.assertTrue(surfaces.is_watertight(result.boundary))
        regions = result.solid.cell_arrays["RegionId"]
        self.assertEqual(len(set(result.solid.cells[regions == 0].ravel()) & set(result.solid.cells[regions == 1].ravel())), 0)
        self.assertEqual(result.statistics["CopiedCells"], len(result.solid.cells) - insideout.tetrahedralize(surfaces.two_boxes()).statistics["InsideCells"])

    def test_three_layers_stay_glued_with_a_warning(self):
        surface = joined(((0, 0, 0), 2), ((1, 1, 1), 2), ((0.5, 1.25, 0.75), 1))
        result = insideout.tetrahedralize(surface, separate_overlaps=True)
        self.assertEqual(result.statistics["SeparatedOverlaps"], 0)
        self.assertEqual(len(result.regions), 1)
        self.assertRegex("\n".join(result.warnings), "1 of 1 overlaps stay glued, the first at ")

    def test_an_overlap_part_of_which_is_outside_stays_glued(self):
        surface = surfaces.two_boxes()
        hull = insideout.tetrahedralize(surface).hull
        places = hull.points[hull.cells[hull.w == 2]].mean(axis=1)
        self.assertGreater(len(places), 1)
        result = insideout.tetrahedralize(surface, separate_overlaps=True, gamma=0, seeds=[(tuple(places[0]), False)])
        self.assertEqual([result.statistics[name] for name in ("Overlaps", "SeparatedOverlaps")], [1, 0])
        self.assertTrue(surfaces.is_watertight(result.boundary))
        self.assertRegex("\n".join(result.warnings), "1 of 1 overlaps stay glued, the first at ")

    def test_it_is_refined_as_it_is(self):
        result = insideout.tetrahedralize(surfaces.two_boxes(), separate_overlaps=True, edge_length=0.3)
        self.assertEqual(min(surfaces.exact_volumes(result.solid)) > 0, True)
        self.assertAlmostEqual(sum(map(float, surfaces.exact_volumes(result.solid))), 2, delta=1e-12)
        np.testing.assert_array_equal(connections(result.solid.cells) <= 2, True)

    def test_a_file_has_the_faces_that_are_outside(self):
        result = insideout.tetrahedralize(surfaces.two_boxes(), separate_overlaps=True)
        mesh = result.to_meshio()
        triangles = np.vstack([block.data for block in mesh.cells if block.type == "triangle"])
        cells = np.vstack([block.data for block in mesh.cells if block.type == "tetra"])
        faces = np.sort(cells[:, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]].reshape(-1, 3), axis=1)
        once, count = np.unique(faces, axis=0, return_counts=True)
        np.testing.assert_array_equal(np.unique(np.sort(triangles, axis=1), axis=0), once[count == 1])

    def test_the_command_says_what_was_copied(self):
        with tempfile.TemporaryDirectory() as folder:
            surface, solid = (os.path.join(folder, name) for name in ("boxes.ply", "solid.inp"))
            insideout.write(surfaces.two_boxes(), surface)
            command = [sys.executable, "-m", "insideout", surface, solid, "--separate-overlaps", "--non-manifold", "split"]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertIn("1 of 1 overlaps separated, by copies of", done.stdout)
            with open(solid, encoding="utf-8") as file:
                faces = [line for line in file if line.rstrip().endswith(("S1", "S2", "S3", "S4"))]
            self.assertEqual(len(set(faces)), len(faces))


class Real(unittest.TestCase):
    """A figure that overlaps itself: 848 pairs of its facets cross."""

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            [surface] = unpack_cgal(folder, ["man.off"])
            cls.result = insideout.tetrahedralize(surface, separate_overlaps=True, non_manifold="split")

    def test_overlaps_are_separated_and_the_others_counted(self):
        statistics = self.result.statistics
        self.assertGreater(statistics["SeparatedOverlaps"], 5)
        left = int(statistics["Overlaps"] - statistics["SeparatedOverlaps"])
        self.assertIn(f"{left} of {int(statistics['Overlaps'])} overlaps stay glued", "\n".join(self.result.warnings))

    def test_copied_cells_are_in_the_volume(self):
        hull, solid = self.result.hull, self.result.solid

        def volumes(grid):
            corner = grid.points[grid.cells]
            u, v, t = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
            return np.einsum("ij,ij->i", np.cross(u, v), t) / 6

        copied = len(solid.cells) - int(cells_inside(hull).sum())
        self.assertEqual(copied, self.result.statistics["CopiedCells"])
        w = solid.cell_arrays["w"]
        self.assertTrue((w[-copied:] == 2).all())
        self.assertAlmostEqual(volumes(solid).sum(), volumes(hull)[cells_inside(hull)].sum() + volumes(solid)[-copied:].sum(), delta=1e-15)

    def test_it_conforms_and_its_boundary_is_a_manifold(self):
        np.testing.assert_array_equal(connections(self.result.solid.cells) <= 2, True)
        self.assertTrue(surfaces.is_watertight(self.result.boundary))
        if self.result.statistics["NonManifoldEdges"] == 0:
            self.assertEqual(surfaces.count_not_manifold(self.result.boundary.triangles), (0, 0))


def cells_inside(hull):
    return hull.cell_arrays["Inside"] == 1


if __name__ == "__main__":
    unittest.main()
