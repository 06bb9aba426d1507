# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets within a solid that make regions of it: MembranesSeparateRegions."""

import unittest

import insideout
import numpy as np
import surfaces

HEIGHTS = (0.2, 0.35, 0.6, 0.8)


def horizon(height: float, low: float = 0, high: float = 1):
    """A level square across the unit box, bent where it has a middle."""
    points = [(low, low, height), (high, low, height), (high, high, height), (low, high, height), ((low + high) / 2, (low + high) / 2, height + 0.02)]
    return surfaces.polydata(points, [(k, (k + 1) % 4, 4) for k in range(4)])


def block(*sheets, facets=surfaces.BOX_FACETS):
    """The unit box with sheets; the cell array Horizon is the number of a sheet, from 1, and 0 on the box."""
    parts = [surfaces.box(facets=facets), *sheets]
    surface = surfaces.joined(*parts)
    surfaces.add_array(surface.GetCellData(), "Horizon", np.repeat(np.arange(len(parts), dtype=np.int32), [part.GetNumberOfCells() for part in parts]))
    return surface


class TestMembranes(unittest.TestCase):
    def setUp(self):
        self.layers = block(*map(horizon, HEIGHTS))
        self.volumes = np.diff((0, *HEIGHTS, 1))
        self.volumes[0] += 0.02 / 3
        self.volumes[-1] -= 0.02 / 3

    def test_horizons_make_five_layers_of_a_block(self):
        for more in ({}, {"edge_length": 0.3}, {"surface_treatment": "split"}, {"edge_length": 0.2, "surface_treatment": "remeshed"}):
            with self.subTest(more):
                result = insideout.tetrahedralize(self.layers, membranes_separate_regions=True, **more)
                by_height = sorted(result.regions, key=lambda region: region.center_of_mass[2])
                np.testing.assert_allclose([region.volume for region in by_height], self.volumes, atol=2e-3 if "edge_length" in more else 1e-12)
                self.assertEqual(result.statistics["Membranes"], len(HEIGHTS))
                self.assertEqual(sorted(set(result.solid.cell_arrays["RegionId"].tolist())), [0, 1, 2, 3, 4])

    def test_interfaces_are_behind_the_boundary_each_face_once(self):
        result = insideout.tetrahedralize(self.layers, membranes_separate_regions=True, tag_array="Horizon")
        boundary = result.boundary
        regions = boundary.cell_arrays["RegionIds"]
        is_interface = (regions >= 0).all(axis=1)
        self.assertEqual(np.flatnonzero(is_interface).tolist(), list(range(np.argmax(is_interface), len(regions))))
        self.assertEqual(len(set(map(tuple, np.sort(boundary.triangles, axis=1)))), len(boundary.triangles))
        a, b, c = boundary.points[boundary.triangles].transpose(1, 0, 2)
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
        tags = boundary.cell_arrays["BoundaryTag"]
        for number in range(1, len(HEIGHTS) + 1):
            self.assertTrue(is_interface[tags == number].all())
            self.assertAlmostEqual(areas[tags == number].sum(), 4 * 0.25 * np.hypot(1, 0.04), delta=1e-12)
        self.assertAlmostEqual(areas[~is_interface].sum(), 6, delta=1e-12)

    def test_without_the_option_the_block_is_one_region(self):
        result = insideout.tetrahedralize(self.layers)
        self.assertEqual([round(region.volume, 12) for region in result.regions], [1])
        self.assertNotIn("RegionIds", result.boundary.cell_arrays)

    def test_a_horizon_that_ends_within_separates_nothing_and_is_told(self):
        result = insideout.tetrahedralize(block(horizon(0.5), horizon(0.75, 0.25, 0.75)), membranes_separate_regions=True)
        self.assertEqual(len(result.regions), 2)
        self.assertTrue(any("4 facets that count 0 have one region on both sides" in line for line in result.warnings), result.warnings)

    def test_facets_that_do_not_participate_separate_regions(self):
        surface = block(horizon(0.4))
        result = insideout.tetrahedralize(surface, non_participating_array="Horizon", membranes_separate_regions=True)
        self.assertEqual(len(result.regions), 2)
        self.assertFalse(any("have one region" in line for line in result.warnings))

    def test_an_open_block_has_layers_too(self):
        """Its volume is what it is without horizons."""
        open_block = [facet for facet in surfaces.BOX_FACETS if not all(surfaces.box_points()[p][2] == 1 for p in facet)]
        alone = insideout.tetrahedralize(block(facets=open_block)).volume
        for count in range(1, len(HEIGHTS) + 1):
            result = insideout.tetrahedralize(block(*map(horizon, HEIGHTS[:count]), facets=open_block), membranes_separate_regions=True)
            self.assertEqual(result.statistics["Membranes"], count)
            self.assertAlmostEqual(result.volume, alone, delta=1e-2)
            self.assertEqual(len(result.regions), count + 1)

    def test_excluded_options_are_refused(self):
        for wrong, words in (
            ({"split_seams": True}, "split_seams excludes membranes_separate_regions: it would part interfaces from their cells"),
            ({"separate_overlaps": True}, "separate_overlaps excludes membranes_separate_regions"),
            ({"body_array": "Horizon"}, "membranes_separate_regions takes one body, and body_array makes regions of several"),
        ):
            with self.subTest(wrong), self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(self.layers, membranes_separate_regions=True, **wrong)


if __name__ == "__main__":
    unittest.main()
