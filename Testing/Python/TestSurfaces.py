# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary and the outliers, and facets that do not count."""

import os
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import insideout
import surfaces
from insideout.files import read_surface
from insideout.pipeline import run, statistics_of
from real_surfaces import unpack_cgal
from surfaces import cell_array, enclosed_volume, is_watertight, point_array, points_of, polydata, triangles_of

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
import ski_mask  # noqa: E402

REAL = ("elephant-with-holes.off", "cow.off", "pig.stl")
BY_ENERGY, LOST, LEFT_OUT, DEGENERATE = (
    getattr(insideout.vtkRobustTetrahedralize, "OUTLIER_" + name)
    for name in ("BY_ENERGY", "LOST", "LEFT_OUT", "DEGENERATE")
)


def joined(*parts):
    """One surface of several (points, polygons)."""
    points, polygons = [], []
    for more_points, more_polygons in parts:
        polygons += [[len(points) + corner for corner in polygon] for polygon in more_polygons]
        points += list(more_points)
    return polydata(points, polygons)


def box_part(low=(0, 0, 0), size=1):
    return surfaces.box_points(low, size), surfaces.BOX_FACETS


def random_soup(seed, count):
    """Triangles that cross each other everywhere, a few with common points."""
    random = np.random.default_rng(seed)
    points = random.random((2 * count, 3))
    return polydata(points, [random.choice(2 * count, 3, replace=False) for _ in range(count)])


def bare(surface):
    copy = vtkPolyData()
    copy.SetPoints(surface.GetPoints())
    copy.SetPolys(surface.GetPolys())
    return copy


def places(surface):
    return {point.tobytes() for point in points_of(surface) + 0.0}


def is_watertight_in_space(surface):
    """Whether it is when points in one place are one."""
    _, index = np.unique(points_of(surface) + 0.0, axis=0, return_inverse=True)
    return is_watertight(polydata(points_of(surface), index.ravel()[triangles_of(surface)]))


def add(data, name, values, setter="AddArray"):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    getattr(data, setter)(array)


class Reentry(unittest.TestCase):
    """The boundary is clean input, and gives the same solid again."""

    def check(self, boundary):
        clean = bare(boundary)
        resolve = insideout.vtkResolveSelfIntersections()
        resolve.SetInputData(clean)
        run(resolve)
        found = statistics_of(resolve.GetOutput())
        for defect in ("IntersectingPairs", "OpenEdges", "DuplicateFacets", "DegenerateFacets", "MergedPoints"):
            self.assertEqual(found[defect], 0, defect)
        again = insideout.tetrahedralize(clean)
        self.assertEqual(set(np.unique(cell_array(again.hull, "w"))) - {0.0, 1.0}, set())
        self.assertEqual(again.statistics["Closed"], 1)
        self.assertEqual(again.statistics["OutlierFacets"], 0)
        self.assertEqual(places(again.boundary), places(boundary))
        self.assertAlmostEqual(enclosed_volume(again.boundary) / enclosed_volume(boundary), 1, 12)
        return found

    def test_real_meshes(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = list(unpack_cgal(folder, REAL))
            self.assertEqual(len(paths), len(REAL))
            for path in paths:
                with self.subTest(os.path.basename(path)):
                    surface, _ = read_surface(path)
                    boundary = insideout.tetrahedralize(surface).boundary
                    self.assertGreater(boundary.GetNumberOfCells(), 1000)
                    self.check(boundary)

    def test_soups_with_boundaries_that_are_no_manifolds(self):
        non_manifold = checked = 0
        for seed in range(20):
            result = insideout.tetrahedralize(random_soup(seed, 14), gamma=0, count_duplicates=True)
            if result.solid.GetNumberOfCells() > 0:
                with self.subTest(seed=seed):
                    checked += 1
                    non_manifold += self.check(result.boundary)["NonManifoldEdges"] > 0
        self.assertGreater(checked, 10)
        self.assertGreater(non_manifold, 3)

    def test_two_boxes_that_share_an_edge(self):
        result = insideout.tetrahedralize(joined(box_part(), box_part((1, 1, 0))))
        self.assertEqual(self.check(result.boundary)["NonManifoldEdges"], 1)
        self.assertAlmostEqual(enclosed_volume(result.boundary), 2, 12)

    def test_merged_pieces(self):
        result = insideout.tetrahedralize(box_with_partition(), merge_coplanar_pieces=True)
        self.check(result.boundary)


def box_with_partition():
    """A box with a sheet in it that cuts four of its sides and stays inside them, without volume."""
    sheet = [(0.5, 0, 0), (0.5, 1, 0), (0.5, 1, 1), (0.5, 0, 1)]
    return joined(box_part(), (sheet, [(0, 1, 2), (0, 2, 3), (2, 1, 0), (3, 2, 0)]))


class Merging(unittest.TestCase):
    def test_a_box_that_a_sheet_has_cut_becomes_whole_again(self):
        cut = insideout.tetrahedralize(box_with_partition())
        whole = insideout.tetrahedralize(box_with_partition(), merge_coplanar_pieces=True)
        self.assertGreater(cut.boundary.GetNumberOfCells(), 12)
        self.assertEqual(whole.boundary.GetNumberOfCells(), 12)
        self.assertEqual(whole.boundary.GetNumberOfPoints(), 8)
        self.assertEqual(sorted(cell_array(whole.boundary, "vtkOriginalCellIds")), list(range(12)))
        self.assertEqual(whole.statistics["BoundaryFaces"], 12)
        self.assertTrue(is_watertight(whole.boundary))
        self.assertAlmostEqual(enclosed_volume(whole.boundary), 1, 15)
        self.assertEqual(cut.hull.GetNumberOfCells(), whole.hull.GetNumberOfCells())

    def test_every_piece_names_the_cell_that_it_lies_in(self):
        result = insideout.tetrahedralize(box_with_partition())
        self.assertTrue((np.bincount(cell_array(result.boundary, "vtkOriginalCellIds"))[:12] > 0).all())
        given = box_with_partition()
        planes = points_of(given)[triangles_of(given)]
        normals = np.cross(planes[:, 1] - planes[:, 0], planes[:, 2] - planes[:, 0])
        for cell, corners in zip(
            cell_array(result.boundary, "vtkOriginalCellIds"), points_of(result.boundary)[triangles_of(result.boundary)]
        ):
            np.testing.assert_allclose((corners - planes[cell, 0]) @ normals[cell], 0, atol=1e-15)

    def test_nothing_is_merged_where_a_part_is_gone(self):
        with_second = insideout.tetrahedralize(surfaces.two_boxes())
        merged = insideout.tetrahedralize(surfaces.two_boxes(), merge_coplanar_pieces=True)
        self.assertEqual(merged.boundary.GetNumberOfCells(), with_second.boundary.GetNumberOfCells())


class Seams(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A box of squares with points of their own: texture coordinates and normals by square."""
        corners = np.array(surfaces.box_points())
        squares = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5), (3, 0, 4, 7))
        points = np.concatenate([corners[list(square)] for square in squares])
        box = polydata(points, np.arange(24).reshape(6, 4))
        texture = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (6, 1)) + np.repeat(np.arange(6), 4)[:, None]
        add(box.GetPointData(), "Texture", texture.astype(np.float32), "SetTCoords")
        normals = points.reshape(6, 4, 3).mean(axis=1) * 2 - 1
        add(box.GetPointData(), "Facing", np.repeat(normals, 4, axis=0), "SetNormals")
        add(box.GetPointData(), "Number", np.arange(24))
        add(box.GetCellData(), "Side", np.arange(6.0))
        cls.box, cls.texture = box, texture
        cls.merged = insideout.tetrahedralize(box)
        cls.split = insideout.tetrahedralize(box, split_seams=True)

    def test_texture_coordinates_and_normals_stay_active(self):
        for result in (self.merged, self.split):
            for surface in (result.boundary, result.outliers):
                self.assertEqual(surface.GetPointData().GetTCoords().GetName(), "Texture")
                self.assertEqual(surface.GetPointData().GetNormals().GetName(), "Facing")
            self.assertEqual(result.hull.GetPointData().GetNormals().GetName(), "Facing")

    def test_one_point_has_the_lowest_ids_data_and_the_others_are_counted(self):
        boundary = self.merged.boundary
        self.assertEqual(boundary.GetNumberOfPoints(), 8)
        self.assertTrue(is_watertight(boundary))
        ids = point_array(boundary, "vtkOriginalPointIds")
        self.assertEqual(point_array(boundary, "Number").tolist(), ids.tolist())
        given = points_of(self.box)
        for point, number in zip(points_of(boundary), ids):
            self.assertEqual(number, np.flatnonzero((given == point).all(axis=1)).min())
        self.assertEqual(point_array(boundary, "Texture").tolist(), self.texture[ids].tolist())
        self.assertEqual(self.merged.statistics["SeamPoints"], 16)
        self.assertEqual(self.merged.warnings, [])

    def test_split_seams_keep_every_corners_data(self):
        boundary = self.split.boundary
        self.assertEqual(boundary.GetNumberOfPoints(), 24)
        self.assertEqual(boundary.GetNumberOfCells(), 12)
        self.assertFalse(is_watertight(boundary))
        self.assertTrue(is_watertight_in_space(boundary))
        self.assertEqual(self.split.warnings, [])
        side = cell_array(boundary, "vtkOriginalCellIds")
        texture = point_array(boundary, "Texture")[triangles_of(boundary)]
        np.testing.assert_array_equal(np.floor(texture.mean(axis=1)), np.column_stack([side, side]))
        outward = np.cross(*np.diff(points_of(boundary)[triangles_of(boundary)], axis=1).swapaxes(0, 1))
        normals = point_array(boundary, "Facing")[triangles_of(boundary)]
        np.testing.assert_array_equal(normals, np.repeat(outward[:, None], 3, axis=1))
        self.assertEqual(sorted(point_array(boundary, "Number")), list(range(24)))

    def test_split_seams_change_the_boundary_alone(self):
        self.assertEqual(surfaces.tetrahedra_of(self.split.solid).tolist(), surfaces.tetrahedra_of(self.merged.solid).tolist())
        np.testing.assert_array_equal(
            cell_array(self.split.boundary, "Side"), cell_array(self.merged.boundary, "Side")
        )

    def test_equal_data_make_no_seam(self):
        plain = bare(self.box)
        result = insideout.tetrahedralize(plain, split_seams=True)
        self.assertEqual(result.statistics["SeamPoints"], 0)
        self.assertEqual(result.boundary.GetNumberOfPoints(), 8)
        add(plain.GetPointData(), "Texture", points_of(plain)[:, :2], "SetTCoords")
        result = insideout.tetrahedralize(plain, split_seams=True)
        self.assertEqual(result.statistics["SeamPoints"], 0)
        self.assertEqual(result.boundary.GetNumberOfPoints(), 8)

    def test_without_point_data_there_is_no_seam_where_surfaces_cross(self):
        result = insideout.tetrahedralize(surfaces.two_boxes(), split_seams=True)
        self.assertTrue(is_watertight(result.boundary))

    def test_new_points_interpolate_the_triangle_that_they_lie_in(self):
        """Where a box's side is cut by another box, each keeps its own texture."""
        boxes = [bare(self.box), bare(self.box)]
        points = np.concatenate([points_of(boxes[0]), points_of(boxes[1]) * 0.9 + (0.31, 0.32, 0.33)])
        both = polydata(points, np.arange(48).reshape(12, 4))
        gradients = np.random.default_rng(1).random((12, 3, 2))
        texture = np.concatenate([points[4 * k : 4 * k + 4] @ gradients[k] for k in range(12)])
        add(both.GetPointData(), "TCoords", texture, "SetTCoords")
        boundary = insideout.tetrahedralize(both, split_seams=True).boundary
        self.assertGreater((point_array(boundary, "vtkOriginalPointIds") == -1).sum(), 0)
        self.assertTrue(is_watertight_in_space(boundary))
        for cell, corners in zip(cell_array(boundary, "vtkOriginalCellIds"), triangles_of(boundary)):
            np.testing.assert_allclose(
                point_array(boundary, "TCoords")[corners], points_of(boundary)[corners] @ gradients[cell], atol=1e-14
            )


class Outliers(unittest.TestCase):
    def test_a_stray_facet_is_one_by_energy(self):
        result = insideout.tetrahedralize(surfaces.two_boxes_and_a_stray_facet())
        self.assertEqual(cell_array(result.outliers, "OutlierReason").tolist(), [BY_ENERGY])
        self.assertEqual(cell_array(result.outliers, "vtkOriginalCellIds").tolist(), [24])
        self.assertEqual(result.statistics["OutliersByEnergy"], 1)

    def test_degenerate_facets_are_listed_as_they_were_given(self):
        points = surfaces.box_points() + [(2, 2, 2), (3, 3, 3), (4, 4, 4)]
        flat = [(8, 9, 10), (0, 0, 5), (1, 9, 1)]
        box = polydata(points, [flat[0], *surfaces.BOX_FACETS[:6], flat[1], *surfaces.BOX_FACETS[6:], flat[2]])
        surfaces.add_array(box.GetPointData(), "Number", np.arange(11))
        surfaces.add_array(box.GetCellData(), "OutlierReason", np.arange(15) + 100)
        result = insideout.tetrahedralize(box)
        outliers = result.outliers
        self.assertEqual(cell_array(outliers, "OutlierReason").tolist(), [DEGENERATE] * 3)
        self.assertEqual(cell_array(outliers, "vtkOriginalCellIds").tolist(), [0, 7, 14])
        self.assertEqual(cell_array(outliers, "Input_OutlierReason").tolist(), [100, 107, 114])
        self.assertEqual(point_array(outliers, "Number")[triangles_of(outliers)].tolist(), [list(f) for f in flat])
        np.testing.assert_array_equal(points_of(outliers)[triangles_of(outliers)], np.array(points, float)[np.array(flat)])
        self.assertEqual(result.statistics["OutliersDegenerate"], 3)
        self.assertEqual(result.statistics["DegenerateFacets"], 3)
        self.assertEqual(result.solid.GetNumberOfCells(), insideout.tetrahedralize(surfaces.box()).solid.GetNumberOfCells())

    def test_the_reasons_have_names(self):
        names = insideout.tetrahedralize(surfaces.box()).outliers.GetFieldData().GetAbstractArray("OutlierReasonNames")
        words = [names.GetValue(k) for k in range(names.GetNumberOfValues())]
        self.assertEqual(len(words), 4)
        self.assertIn("resolver", words[LEFT_OUT])
        self.assertIn("lost", words[LOST])
        self.assertIn("degenerate", words[DEGENERATE])

    def test_the_counts_by_reason_sum_to_the_outliers(self):
        found = insideout.tetrahedralize(random_soup(3, 30)).statistics
        reasons = [found["Outliers" + name] for name in ("ByEnergy", "Lost", "LeftOut", "Degenerate")]
        self.assertEqual(sum(reasons), found["OutlierFacets"])
        self.assertGreater(found["OutlierFacets"], 0)


def prism_with_a_hole(height=1):
    """An L with a square hole through it, of polygons alone: a bridge leads to the hole in the top and the bottom."""
    outer = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
    hole = [(0.5, 0.5), (0.5, 1.5), (1.5, 1.5), (1.5, 0.5)]
    points = [(x, y, z) for z in (0, height) for x, y in outer + hole]
    top = [10, 11, 12, 13, 14, 15, 10, 16, 17, 18, 19, 16]
    bottom = [corner - 10 for corner in reversed(top)]
    rings = [list(range(6)), list(range(6, 10))]
    walls = [(a, b, b + 10, a + 10) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1])]
    return polydata(points, [bottom, *walls, top])


class Polygons(unittest.TestCase):
    """A polygon means what its outline encloses."""

    def test_a_prism_with_bridges_to_its_hole_has_the_right_volume(self):
        prism = prism_with_a_hole()
        result = insideout.tetrahedralize(prism)
        self.assertEqual(result.warnings, [])
        self.assertEqual(result.statistics["OpenEdges"], 0)
        self.assertEqual(result.statistics["IntersectingPairs"], 0)
        self.assertEqual(result.statistics["OutlierFacets"], 0)
        self.assertEqual(result.statistics["Closed"], 1)
        self.assertTrue(is_watertight(result.boundary))
        self.assertAlmostEqual(enclosed_volume(result.boundary), 11, 12)

    def test_every_triangle_names_the_polygon_that_it_is_of(self):
        boundary = insideout.tetrahedralize(prism_with_a_hole()).boundary
        corners = points_of(boundary)[triangles_of(boundary)]
        areas = np.linalg.norm(np.cross(*np.diff(corners, axis=1).swapaxes(0, 1)), axis=1) / 2
        by_polygon = np.bincount(cell_array(boundary, "vtkOriginalCellIds"), areas)
        np.testing.assert_allclose(by_polygon, [11, 4, 2, 2, 2, 2, 4, 1, 1, 1, 1, 11], rtol=1e-12)

    def test_the_winding_number_in_the_hole_and_beside_it(self):
        implicit = insideout.vtkImplicitWindingNumber()
        implicit.SetInput(prism_with_a_hole())
        self.assertAlmostEqual(implicit.EvaluateFunction(1, 1, 0.5), 0.5, 12, "in the hole")
        self.assertAlmostEqual(implicit.EvaluateFunction(3, 1, 0.5), -0.5, 12, "in the solid")
        self.assertAlmostEqual(implicit.EvaluateFunction(3, 3, 0.5), 0.5, 12, "in the corner of the L")

    def test_polygons_that_cross_themselves_are_counted_and_the_first_is_named(self):
        """A box, and a bow tie on each of two sides of it."""
        ties = [(0, 2, 1, 3), (4, 6, 5, 7)]
        result = insideout.tetrahedralize(polydata(surfaces.box_points(), [*surfaces.BOX_FACETS, *ties]))
        self.assertTrue(any("2 polygons, cell 12 the first, cross themselves" in w for w in result.warnings), result.warnings)

    def test_a_polygon_that_encloses_nothing_is_degenerate(self):
        result = insideout.tetrahedralize(polydata(surfaces.box_points(), [*surfaces.BOX_FACETS, (0, 1, 0, 1)]))
        self.assertEqual(result.statistics["DegenerateFacets"], 1)
        self.assertAlmostEqual(enclosed_volume(result.boundary), 1, 15)


class NothingInside(unittest.TestCase):
    """The likely cause is named in the one warning, and what to set."""

    def warning(self, surface, **options):
        result = insideout.tetrahedralize(surface, **options)
        self.assertEqual(result.solid.GetNumberOfCells(), 0)
        return next(warning for warning in result.warnings if "nothing is inside" in warning)

    def test_two_sided(self):
        sheets = [f for f in surfaces.BOX_FACETS[:4]]
        both = surfaces.box(facets=[*sheets, *(f[::-1] for f in sheets)])
        self.assertIn("two-sided", self.warning(both))

    def test_inside_out(self):
        self.assertIn("set orientation to automatic", self.warning(surfaces.reversed_box(), orientation="as-given"))

    def test_too_open(self):
        walls = surfaces.box(facets=[surfaces.BOX_FACETS[0], surfaces.BOX_FACETS[4]])
        self.assertIn("too open", self.warning(walls))

    def test_both_ways(self):
        self.assertIn("faces both ways", self.warning(surfaces.closed_both_ways(), orientation="as-given"))

    def test_smoothed_away(self):
        """An open box in a large hull, whose boundary costs more than it is worth."""
        low, high = (surfaces.box_points((place,) * 3, 0.1) for place in (-5, 5))
        box = joined((surfaces.box_points(), surfaces.BOX_FACETS[:10]), *((p, surfaces.BOX_FACETS) for p in (low, high)))
        surfaces.add_array(box.GetCellData(), "Frame", np.repeat([0, 1], [10, 24]))
        open_box = {"non_participating_array": "Frame", "sigma": 1}
        self.assertGreater(insideout.tetrahedralize(box, gamma=0, **open_box).solid.GetNumberOfCells(), 0)
        self.assertIn("set gamma lower", self.warning(box, gamma=1e3, **open_box))


class NonParticipating(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = ski_mask.scene()
        cls.alone = insideout.tetrahedralize(ski_mask.snake())
        cls.counting = insideout.tetrahedralize(cls.scene)
        cls.tagged = insideout.tetrahedralize(cls.scene, non_participating_array=ski_mask.ARRAY)

    def test_the_mask_does_not_change_the_snake(self):
        volume = enclosed_volume(self.alone.boundary)
        self.assertEqual(set(np.unique(cell_array(self.tagged.hull, "w"))), {0.0, 1.0})
        self.assertAlmostEqual(enclosed_volume(self.tagged.boundary) / volume, 1, 12)
        self.assertEqual(places(self.tagged.boundary), places(self.alone.boundary))
        self.assertGreater(enclosed_volume(self.counting.boundary), 1.2 * volume, "the mouth is not filled")
        self.assertEqual(self.tagged.statistics["NonParticipatingFacets"], 2 * ski_mask.mask().GetNumberOfCells())
        self.assertEqual(self.counting.statistics["NonParticipatingFacets"], 0)

    def test_the_mask_is_in_the_mesh_and_among_the_outliers(self):
        on_mask = set(np.flatnonzero(cell_array(self.scene, ski_mask.ARRAY)).tolist())
        faces = cell_array(self.tagged.hull, "FacetIds")
        self.assertTrue(on_mask <= set(faces.ravel().tolist()))
        multiplicity = cell_array(self.tagged.hull, "FacetMultiplicity")
        self.assertEqual(set(multiplicity[np.isin(faces, list(on_mask))]), {0})
        self.assertEqual(set(cell_array(self.tagged.outliers, "vtkOriginalCellIds").tolist()), on_mask)
        self.assertEqual(set(cell_array(self.tagged.outliers, "OutlierReason")), {BY_ENERGY})

    def test_it_passes_through_the_stages(self):
        resolve = insideout.vtkResolveSelfIntersections()
        resolve.SetInputData(self.scene)
        resolve.SetNonParticipatingArrayName(ski_mask.ARRAY)
        run(resolve)
        resolved = resolve.GetOutput()
        tag = cell_array(resolved, ski_mask.ARRAY)
        self.assertEqual(set(cell_array(resolved, "FacetMultiplicity")[tag == 1]), {0})
        self.assertEqual(set(cell_array(resolved, "FacetMultiplicity")[tag == 0]), {1})
        for made in (insideout.vtkGeneralizedWindingNumber(), insideout.vtkConstrainedDelaunay3D()):
            made.SetInputData(self.scene)
            made.SetNonParticipatingArrayName(ski_mask.ARRAY)
            run(made)
            faces, multiplicity = (cell_array(made.GetOutput(), name) for name in ("FacetIds", "FacetMultiplicity"))
            on_mask = np.isin(faces, np.flatnonzero(cell_array(self.scene, ski_mask.ARRAY)))
            self.assertEqual(set(multiplicity[on_mask]), {0})
            self.assertEqual(set(multiplicity[~on_mask & (faces >= 0)]), {-1, 1})
        w = insideout.vtkGeneralizedWindingNumber()
        w.SetInputData(resolved)
        run(w)
        self.assertEqual(set(np.unique(cell_array(w.GetOutput(), "w"))), {0.0, 1.0})

    def test_winding_numbers_anywhere_count_the_same(self):
        found = []
        for surface, name in ((ski_mask.scene(), ski_mask.ARRAY), (ski_mask.snake(), "")):
            probe = insideout.vtkProbeWindingNumber()
            probe.SetInputData(self.tagged.hull)
            probe.SetSurfaceData(surface)
            probe.SetAssociation(probe.CELLS)
            probe.SetNonParticipatingArrayName(name)
            run(probe)
            found.append(cell_array(probe.GetOutput(), "w"))
            implicit = insideout.vtkImplicitWindingNumber()
            implicit.SetInput(surface)
            implicit.SetNonParticipatingArrayName(name)
            self.assertEqual(implicit.EvaluateFunction(5.7, 0, 0), 0.5, "in the mouth")
            self.assertEqual(implicit.EvaluateFunction(4.5, 0, 0), -0.5, "in the neck")
        np.testing.assert_allclose(found[0], found[1], atol=1e-12)
        self.assertEqual(set(np.round(found[0], 12)), {0.0, 1.0})

    def test_an_array_that_is_not_there_is_an_error_that_names_it(self):
        for name in ("Nobody", "Three"):
            surface = surfaces.box()
            surfaces.add_array(surface.GetCellData(), "Three", np.zeros((12, 3)))
            with self.subTest(name), self.assertRaisesRegex(insideout.Error, f"no cell array {name} of one number"):
                insideout.tetrahedralize(surface, non_participating_array=name)


if __name__ == "__main__":
    unittest.main()
