# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions, cavities and the topology of a solid, from Python and on a real surface; all counted anew from cells alone."""

import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from itertools import combinations
from pathlib import Path

import insideout
import numpy as np
import surfaces
from real_surfaces import unpack_cgal
from TestPartedSolids import joined
from vtkmodules.vtkCommonDataModel import vtkCellArray


def simplices(cells, size):
    """The different points, edges or faces of cells."""
    return {tuple(part) for cell in np.sort(cells, axis=1).tolist() for part in combinations(cell, size)}


def euler(cells):
    return sum((-1) ** (size + 1) * len(simplices(cells, size)) for size in range(1, cells.shape[1] + 1))


def count_parts(cells):
    """How many parts of the cells sides connect, by union-find."""
    parents = list(range(len(cells)))

    def find(i):
        while parents[i] != i:
            parents[i] = parents[parents[i]]
            i = parents[i]
        return i

    first = {}
    for number, cell in enumerate(np.sort(cells, axis=1).tolist()):
        for side in combinations(cell, len(cell) - 1):
            parents[find(number)] = find(first.setdefault(side, number))
    return sum(find(i) == i for i in range(len(cells)))


def count_shells(cells):
    """How many surfaces the boundary of cells is made of, where it is a manifold."""
    sides = Counter(side for cell in np.sort(cells, axis=1).tolist() for side in combinations(cell, 3))
    return count_parts(np.array([side for side, count in sides.items() if count == 1]))


def apart():
    """Boxes of volume 1, 8 and 27, each 1 from the next."""
    return joined(((0, 0, 0), 1), ((2, 0, 0), 2), ((5, 0, 0), 3))


def hollow():
    surface = joined(((0, 0, 0), 3), ((1, 1, 1), 1))
    triangles = surfaces.triangles_of(surface)
    triangles[len(surfaces.BOX_FACETS) :] = triangles[len(surfaces.BOX_FACETS) :, ::-1]
    return surfaces.polydata(surfaces.points_of(surface), triangles.tolist())


def ring():
    """Eight boxes around a hole, which overlap."""
    return joined(*(((i, j, 0), 1.1) for i in range(3) for j in range(3) if (i, j) != (1, 1)))


def volumes(result):
    return sorted(round(region.volume, 9) for region in result.regions)


class Regions(unittest.TestCase):
    def test_the_largest_the_large_and_the_seeded(self):
        seeds = [((0.5, 0.5, 0.5), True), ((6, 1, 1), False)]
        for options, left in (
            ({"largest_regions": 2}, [8, 27]),
            ({"largest_regions": 5}, [1, 8, 27]),
            ({"minimum_region_volume": 9}, [27]),
            ({"minimum_region_volume": 2, "largest_regions": 1}, [27]),
            ({"seeded_regions": True, "seeds": seeds[:1]}, [1]),
        ):
            with self.subTest(**options):
                result = insideout.tetrahedralize(apart(), **options)
                self.assertEqual(volumes(result), left)
                self.assertEqual(count_parts(result.solid.cells), len(left))
                self.assertEqual(result.statistics["DroppedRegions"], 3 - len(left))
                self.assertAlmostEqual(result.statistics["DroppedVolume"], 36 - sum(left), delta=1e-9)
                self.assertEqual(result.statistics["OutlierFacets"], len(surfaces.BOX_FACETS) * (3 - len(left)))
                self.assertEqual(result.statistics["EnergyBeforeTopology"], result.statistics["Energy"])

    def test_seeds_that_are_dropped_with_their_region_are_told_of(self):
        seeds = [((6, 1, 1), True), ((0.5, 0.5, 0.5), True)]
        result = insideout.tetrahedralize(apart(), largest_regions=1, seeds=seeds)
        self.assertEqual(volumes(result), [27])
        self.assertEqual(result.statistics["SeedConflicts"], 1)
        self.assertIn("1 seeds that are to be inside are outside, because their regions were dropped: seed 1", " ".join(result.warnings))
        self.assertEqual(insideout.tetrahedralize(apart(), largest_regions=3, seeds=seeds).statistics["SeedConflicts"], 0)

    def test_dropping_all_regions_is_told_once(self):
        result = insideout.tetrahedralize(apart(), minimum_region_volume=30)
        self.assertEqual(len(result.solid.cells), 0)
        self.assertEqual(len(result.warnings), 1)
        self.assertIn("all 3 regions of the solid were dropped", result.warnings[0])

    def test_cavities_are_filled(self):
        kept, filled = (insideout.tetrahedralize(hollow(), fill_cavities=fill) for fill in (False, True))
        self.assertAlmostEqual(kept.statistics["Volume"], 26)
        self.assertEqual(kept.statistics["SolidCavities"], 1)
        self.assertAlmostEqual(filled.statistics["Volume"], 27)
        self.assertEqual(filled.statistics["SolidCavities"], 0)
        self.assertEqual(filled.statistics["FilledCavities"], 1)
        self.assertAlmostEqual(filled.statistics["FilledVolume"], 1)
        self.assertEqual(filled.statistics["OutlierFacets"], 0)  # those of the cavity are within

    def test_each_body_keeps_its_largest(self):
        bodies = {"left": joined(((0, 0, 0), 1), ((2, 0, 0), 2)), "right": joined(((10, 0, 0), 1), ((12, 0, 0), 2))}
        result = insideout.tetrahedralize(bodies, largest_regions=1)
        self.assertEqual(volumes(result), [8, 8])
        self.assertEqual(result.statistics["DroppedRegions"], 2)

    def test_facets_that_are_to_be_kept_are_told_of_where_their_region_was_dropped(self):
        result = insideout.tetrahedralize(apart(), largest_regions=1, constrain_facets=True)
        self.assertEqual(volumes(result), [27])
        self.assertGreater(result.statistics["UnsatisfiedFacets"], 0)
        self.assertIn("their regions were dropped", " ".join(result.warnings))

    def test_other_numbers_are_refused(self):
        for value, words in ((1.5, "largest_regions is 1.5; it must be a whole number"), (-1, "at least 0")):
            with self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(apart(), largest_regions=value)

    def test_holes_in_a_plane(self):
        places = [(0, 0), (3, 0), (3, 3), (0, 3), (1, 1), (2, 1), (2, 2), (1, 2), (4, 0), (5, 0), (4, 1)]
        curve = surfaces.polydata([(x, y, 0) for x, y in places], [])
        lines = vtkCellArray()
        for line in ((0, 1, 2, 3, 0), (4, 7, 6, 5, 4), (8, 9, 10, 8)):
            lines.InsertNextCell(len(line), line)
        curve.SetLines(lines)
        for options, area, parts, holes in (
            ({}, 8.5, 2, 1),
            ({"largest_regions": 1}, 8, 1, 1),
            ({"fill_cavities": True}, 9.5, 2, 0),
            ({"fill_cavities": True, "minimum_region_volume": 1}, 9, 1, 0),
            ({"topology": "one-component"}, None, 1, 1),
            ({"topology": "simply-connected"}, None, 1, 0),
        ):
            with self.subTest(**options):
                result = insideout.tetrahedralize(curve, **options)
                self.assertEqual(count_parts(result.solid.cells), parts)
                self.assertEqual(parts - euler(result.solid.cells), holes)
                if area:
                    self.assertAlmostEqual(result.statistics["Area"], area)


class Topology(unittest.TestCase):
    def test_one_component_by_what_adds_least(self):
        result = insideout.tetrahedralize(joined(((0, 0, 0), 1), ((1.1, 0, 0), 1)), topology="one-component")
        self.assertEqual(count_parts(result.solid.cells), 1)
        self.assertEqual((result.statistics["JoinedRegions"], result.statistics["DroppedRegions"]), (1, 0))
        self.assertEqual(result.statistics["SolidComponents"], 1)
        self.assertGreater(result.statistics["Energy"], result.statistics["EnergyOfCut"])
        self.assertEqual(result.statistics["EnergyBeforeTopology"], result.statistics["EnergyOfCut"])

    def test_simply_connected(self):
        for surface in (ring(), hollow()):
            before = insideout.tetrahedralize(surface).solid.cells
            self.assertNotEqual(euler(before), 1)
            result = insideout.tetrahedralize(surface, topology="simply-connected")
            self.assertEqual(euler(result.solid.cells), 1)
            self.assertEqual(count_parts(result.solid.cells), 1)
            self.assertEqual([result.statistics["Solid" + name] for name in ("Components", "Tunnels", "Cavities")], [1, 0, 0])
            self.assertGreater(result.statistics["Energy"], result.statistics["EnergyOfCut"])

    def test_seeds_that_forbid_it_are_told_of(self):
        hull = insideout.tetrahedralize(joined(((0, 0, 0), 1), ((1.1, 0, 0), 1))).hull
        middles = hull.points[hull.cells].mean(axis=1)
        seeds = [(tuple(middle), bool(w > 0.5)) for middle, w in zip(middles, hull.w)]
        result = insideout.tetrahedralize(joined(((0, 0, 0), 1), ((1.1, 0, 0), 1)), topology="one-component", seeds=seeds)
        self.assertEqual(count_parts(result.solid.cells), 2)
        self.assertIn("not one component but 2", " ".join(result.warnings))

    def test_the_stage_alone_makes_the_same(self):
        result = insideout.tetrahedralize(apart(), topology="one-component", minimum_region_volume=2)
        stage = insideout.vtkGraphCutSegmentation()
        stage.SetInputData(result.hull)
        stage.SetTopologyToOneComponent()
        stage.SetMinimumRegionVolume(2)
        insideout.pipeline.run(stage)
        self.assertEqual(surfaces.tetrahedra_of(stage.GetOutput()).tolist(), result.solid.cells.tolist())

    def test_a_real_surface_of_many_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            (surface,) = unpack_cgal(folder, ["b9_mesh.off"])
            cut = insideout.tetrahedralize(surface)
            parts = count_parts(cut.solid.cells)
            self.assertGreater(parts, 10)
            largest = insideout.tetrahedralize(surface, largest_regions=3)
            self.assertEqual(volumes(largest), sorted(sorted(volumes(cut))[-3:]))
            dropped = sum(region.volume for region in cut.regions) - sum(region.volume for region in largest.regions)
            self.assertAlmostEqual(largest.statistics["DroppedVolume"], dropped, delta=1e-9 * cut.statistics["Volume"])
            one = insideout.tetrahedralize(surface, topology="one-component")
            self.assertEqual(count_parts(one.solid.cells), 1)
            self.assertEqual(one.statistics["JoinedRegions"] + one.statistics["DroppedRegions"], parts - 1)
            self.assertGreater(one.statistics["Energy"], one.statistics["EnergyOfCut"])
            self.assertEqual(one.statistics["EnergyOfCut"], cut.statistics["Energy"])


class Check(unittest.TestCase):
    def test_the_numbers_of_tetrahedra_alone(self):
        for surface, betti, genus in ((ring(), (1, 1, 0), 1), (hollow(), (1, 0, 1), 0), (apart(), (3, 0, 0), 0)):
            solid = insideout.tetrahedralize(surface).solid
            statistics = insideout.check_solid((solid.points, solid.cells)).statistics
            self.assertEqual(tuple(statistics["Solid" + name] for name in ("Components", "Tunnels", "Cavities")), betti)
            self.assertEqual(statistics["SolidEulerCharacteristic"], euler(solid.cells))
            self.assertEqual(statistics["SolidComponents"], count_parts(solid.cells))
            self.assertEqual(statistics["SolidCavities"], count_shells(solid.cells) - count_parts(solid.cells))
            self.assertEqual(statistics["Genus"], genus)

    def test_nothing_is_said_of_cells_that_do_not_fit_together(self):
        solid = insideout.tetrahedralize(surfaces.box()).solid
        cells = np.concatenate([solid.cells, solid.cells[:1]])
        check = insideout.check_solid((solid.points, cells))
        self.assertNotIn("SolidComponents", check.statistics)
        self.assertNotIn("topology", str(check))

    def test_the_command_tells_it(self):
        with tempfile.TemporaryDirectory() as folder:
            surface, solid = (str(Path(folder) / name) for name in ("ring.ply", "ring.vtu"))
            insideout.write(ring(), surface)
            command = [sys.executable, "-m", "insideout"]
            made = subprocess.run([*command, surface, solid, "--topology", "simply-connected"], capture_output=True, text=True, check=True)
            self.assertRegex(made.stdout, r"energy \S+ before the topology was made so, \S+ after")
            told = subprocess.run([*command, "--check", solid], capture_output=True, text=True, check=True).stdout
            self.assertRegex(told, r"topology +1 component, 0 tunnels, 0 cavities; Euler characteristic 1, genus of the boundary 0")


if __name__ == "__main__":
    unittest.main()
