# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout.check_solid`, `insideout.draw_quality` and `python3 -m insideout --check SOLID.vtu`."""

import json
import math
import os
import unittest

import insideout
import numpy as np
import surfaces
from insideout.solids import make_solid
from surfaces import cell_array
from command import CommandLine, run, run_here
from TestPicture import description_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    VTK_TRIANGLE,
    vtkMultiBlockDataSet,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOImage import vtkPNGReader

CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1)]
ONE = ([0, 1, 2, 3],)
TWO = ([0, 1, 2, 3], [0, 2, 1, 4])


def solid_of(*cells, points=CORNERS):
    return make_solid(np.array(points, float), np.array(cells))


def apart(count):
    """The places of this number of cells, for their points one after the other."""
    places = 2 * np.stack(np.unravel_index(np.arange(count), (10, 10, 10)), axis=1)
    return np.repeat(places, 4, axis=0)


def random_cells(count, seed=3):
    """Each with points of its own, and away from the others."""
    points = np.random.default_rng(seed).random((4 * count, 3))
    cells = np.arange(4 * count).reshape(-1, 4)
    points += apart(count)
    edges = points[cells[:, 1:]] - points[cells[:, :1]]
    inverted = np.linalg.det(edges) < 0
    cells[inverted] = cells[inverted][:, [0, 2, 1, 3]]
    return points, cells


def by_vtk(solid, measure):
    quality = vtkMeshQuality()
    quality.SetInputData(solid)
    getattr(quality, "SetTetQualityMeasureTo" + measure)()
    quality.Update()
    return cell_array(quality.GetOutput(), "Quality")


# MeanRatio came with VTK 9.2 (its release notes, vtkMeshQuality).
with_mean_ratio = unittest.skipUnless(hasattr(vtkMeshQuality, "SetTetQualityMeasureToMeanRatio"), "this VTK has no MeanRatio")


class ComparedWithVtk(unittest.TestCase):
    """Cells at random, and the same ten times thinner, where Verdict is still exact to the digits compared."""

    @classmethod
    def setUpClass(cls):
        points, cls.cells = random_cells(1000)
        cls.cases = [(scaled, make_solid(scaled, cls.cells)) for scaled in (points, points * (1, 1, 0.1))]
        cls.found = [insideout.check_solid(solid).solid for _, solid in cls.cases]

    def test_the_least_angle(self):
        # Verdict takes the angles at edges 0-2 and 1-3 for their supplements. In acute cells these are not the least, so
        # that the least is that of some order of the points.
        regular = np.array([(1, 1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, 1)], float)
        shaken = (regular + 0.3 * np.random.default_rng(1).standard_normal((1000, 4, 3))).reshape(-1, 3)
        points, cells = shaken / 4 + apart(1000), np.arange(4000).reshape(-1, 4)
        found = insideout.check_solid((points, cells)).solid
        acute = cell_array(found, "MaxDihedralAngle") < 90
        self.assertGreater(acute.sum(), 300)
        orders = ((0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2))
        expected = [by_vtk(make_solid(points, cells[:, order]), "MinAngle") for order in orders]
        np.testing.assert_allclose(cell_array(found, "MinDihedralAngle")[acute], np.min(expected, axis=0)[acute], rtol=1e-9)

    @with_mean_ratio
    def test_the_mean_ratio(self):
        for (_, solid), found in zip(self.cases, self.found):
            np.testing.assert_allclose(cell_array(found, "MeanRatio"), by_vtk(solid, "MeanRatio"), rtol=1e-9)

    @with_mean_ratio
    def test_an_inverted_cell_has_a_negative_mean_ratio_as_there(self):
        turned = make_solid(self.cases[0][0], self.cells[:, [0, 2, 1, 3]])
        found = cell_array(insideout.check_solid(turned).solid, "MeanRatio")
        np.testing.assert_allclose(found, by_vtk(turned, "MeanRatio"), rtol=1e-9)
        self.assertLess(found.max(), 0)

    def test_the_radius_edge_ratio_by_its_ratio_of_radii(self):
        for (points, solid), found in zip(self.cases, self.found):
            corners = points[self.cells]
            pairs = [(i, j) for i in range(4) for j in range(i)]
            shortest = np.min([np.linalg.norm(corners[:, i] - corners[:, j], axis=1) for i, j in pairs], axis=0)
            volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
            faces = [np.delete(corners, k, axis=1) for k in range(4)]
            area = sum(np.linalg.norm(np.cross(f[:, 1] - f[:, 0], f[:, 2] - f[:, 0]), axis=1) / 2 for f in faces)
            circumradius = by_vtk(solid, "RadiusRatio") * 3 * (3 * volumes / area)
            np.testing.assert_allclose(cell_array(found, "RadiusEdgeRatio"), circumradius / shortest, rtol=1e-6)


class Figures(unittest.TestCase):
    def test_they_are_those_of_the_cells(self):
        found = insideout.check_solid(insideout.tetrahedralize(surfaces.two_boxes()).solid)
        cells = found.solid.GetNumberOfCells()
        least, largest, ratio, mean = (
            cell_array(found.solid, name) for name in ("MinDihedralAngle", "MaxDihedralAngle", "RadiusEdgeRatio", "MeanRatio")
        )
        figures = found.statistics
        self.assertEqual(figures["Cells"], cells)
        self.assertEqual((figures["MinDihedralAngle"], figures["MaxDihedralAngle"]), (least.min(), largest.max()))
        self.assertEqual(figures["RadiusEdgeRatio99Percent"], np.percentile(ratio, 99, method="inverted_cdf"))
        self.assertEqual((figures["MaxRadiusEdgeRatio"], figures["MinMeanRatio"]), (ratio.max(), mean.min()))
        self.assertAlmostEqual(figures["AverageMeanRatio"], mean.mean(), delta=1e-12)
        self.assertEqual(figures["CellsUnder10Degrees"], (least < 10).sum())
        self.assertEqual(sum(found.histogram), 6 * cells)
        self.assertEqual(len(found.histogram), 36)

    def test_the_quantile_is_that_of_all_angles(self):
        points, cells = random_cells(50)
        angles = []
        for cell in cells:
            corners = points[cell]
            for i in range(4):
                for j in range(i):
                    k, m = (corner for corner in range(4) if corner not in (i, j))
                    along = corners[j] - corners[i]
                    sides = [corners[other] - corners[i] for other in (k, m)]
                    across = [side - along * (side @ along) / (along @ along) for side in sides]
                    cosine = across[0] @ across[1] / (np.linalg.norm(across[0]) * np.linalg.norm(across[1]))
                    angles.append(math.degrees(math.acos(cosine)))
        found = insideout.check_solid((points, cells))
        self.assertEqual(len(angles), 300)
        self.assertAlmostEqual(found.statistics["DihedralAngle1Percent"], sorted(angles)[2], delta=1e-9)
        self.assertEqual(found.histogram, np.histogram(angles, np.arange(0, 181, 5))[0].tolist())

    def test_they_are_not_mixed_with_those_of_the_run_that_made_the_solid(self):
        meshed = insideout.tetrahedralize(surfaces.two_boxes())
        found = insideout.check_solid(meshed.solid)
        self.assertEqual(found.statistics.keys(), insideout.check_solid(solid_of(*TWO)).statistics.keys())
        self.assertNotIn("MinDihedralAngle", insideout.pipeline.statistics_of(meshed.solid), "the input stays as it is")

    def test_sharp_edges_of_the_surface_are_counted(self):
        sharp = [(0, 0, 0), (0, 0, 1), (10, 0, 0), (10, 1, 0)]
        found = insideout.check_solid(solid_of([0, 2, 3, 1], points=sharp))
        # At the z axis, and at the edge over against it: atan(1 / 10) is 5.7 degrees.
        self.assertEqual([found.statistics[f"SurfaceEdgesUnder{k}Degrees"] for k in (10, 5)], [2, 0])
        self.assertEqual(found.findings, [])


class Defects(unittest.TestCase):
    def test_a_solid_of_ours_has_none_that_matter(self):
        for surface in (surfaces.box(), surfaces.two_boxes(), surfaces.open_box()):
            found = insideout.check_solid(insideout.tetrahedralize(surface).solid)
            self.assertEqual([finding for finding in found.findings if finding.matters], [])
            self.assertRegex(found.verdict, r"^\d+ tetrahedra in 1 part, conforming, the boundary watertight; all positive$")
            self.assertEqual(found.warnings, [])

    def test_each_is_found_and_named(self):
        flat = [*CORNERS, (1, 1, 0)]
        above = [*CORNERS, (0.2, 0.2, 3)]
        apart = [*CORNERS, *CORNERS[:3]]
        for name, solid, statistic, words in (
            ("negative", solid_of([0, 2, 1, 3]), "NegativeCells", "conforming, the boundary watertight; 1 negative cell"),
            ("flat", solid_of([0, 1, 2, 5], points=flat), "FlatCells", "1 flat cell"),
            ("overlap", solid_of([0, 1, 2, 3], [0, 1, 2, 5], points=above), "OverlappingFaces", "do not conform; all positive"),
            ("three", solid_of(*TWO, [0, 1, 2, 5], points=above), "CrowdedFaces", "do not conform"),
            ("torn", solid_of([0, 1, 2, 3], [5, 7, 6, 4], points=apart), "ContactPairs", "in 2 parts that do not conform"),
        ):
            with self.subTest(name):
                found = insideout.check_solid(solid)
                self.assertGreater(found.statistics[statistic], 0)
                self.assertTrue(found.findings[0].matters)
                self.assertIn(words, found.verdict)
        self.assertEqual(insideout.check_solid(solid_of(*TWO)).statistics["Conforms"], 1)

    def test_parts_that_a_solver_lets_turn_are_told(self):
        points = [*CORNERS, (0, -1, -1), (5, 5, 5), (6, 5, 5), (5, 6, 5), (5, 5, 6)]
        for cells, told in (
            (TWO, []),
            (([0, 1, 2, 3], [6, 7, 8, 9]), []),
            (([0, 1, 2, 3], [0, 4, 1, 5]), ["1 part held by points or edges alone"]),
            (([0, 1, 2, 3], [0, 4, 1, 5], [3, 7, 8, 9]), ["2 parts held by points or edges alone"]),
        ):
            with self.subTest(cells=cells):
                found = insideout.check_solid(solid_of(*cells, points=points))
                self.assertEqual(found.statistics["Conforms"], 1)
                self.assertEqual([finding.text for finding in found.findings if "held" in finding.text], told)

    def test_infinite_ratios_are_told(self):
        found = insideout.check_solid(solid_of([0, 1, 2, 3], [0, 1, 2, 5], points=[*CORNERS, (1, 1, 0)]))
        self.assertEqual(found.statistics["MaxRadiusEdgeRatio"], math.inf)
        self.assertIn("up to inf", repr(found))


class Inputs(unittest.TestCase):
    def test_all_types_of_solids_are_taken(self):
        import meshio

        points, cells = np.array(CORNERS, float), np.array(TWO)
        grid = make_solid(points, cells)
        source = vtkMeshQuality()
        source.SetInputData(grid)
        expected = insideout.check_solid(grid).statistics
        mesh = meshio.Mesh(points, [("triangle", [[0, 1, 2]]), ("tetra", cells[:1]), ("tetra", cells[1:])])
        for solid in ((points, cells), [CORNERS, list(TWO)], mesh, source.GetOutputPort()):
            found = insideout.check_solid(solid)
            self.assertEqual(found.statistics, expected)
        self.assertIn("1 cells of the meshio.Mesh are ignored", insideout.check_solid(mesh).warnings[0])

    def test_cells_of_second_order_count_by_their_corners(self):
        middles = [tuple((np.array(CORNERS[i]) + CORNERS[j]) / 2) for i, j in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
        grid = make_solid(np.array(CORNERS[:4] + middles, float), np.zeros((0, 4), int))
        grid.Allocate(1)
        grid.InsertNextCell(VTK_QUADRATIC_TETRA, 10, list(range(10)))
        self.assertEqual(insideout.check_solid(grid).statistics, insideout.check_solid(solid_of(*ONE)).statistics)

    def test_cells_of_fewer_dimensions_are_ignored_with_a_warning(self):
        grid = solid_of(*ONE)
        grid.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
        surfaces.add_array(grid.GetCellData(), "Colour", [7, 8])
        found = insideout.check_solid(grid)
        self.assertEqual(found.warnings, ["1 cells are ignored: they are not tetrahedra"])
        self.assertEqual(found.statistics["Cells"], 1)
        self.assertEqual(cell_array(found.solid, "Colour").tolist(), [7, 8])
        self.assertEqual(cell_array(found.solid, "Orientation").tolist(), [1, 0])

    def test_inputs_other_than_solids_are_named(self):
        hexahedron = solid_of(*ONE, points=CORNERS + CORNERS)
        hexahedron.InsertNextCell(VTK_HEXAHEDRON, 8, list(range(8)))
        far = solid_of(*ONE)
        far.InsertNextCell(VTK_TETRA, 4, [0, 1, 2, 99])
        nowhere = solid_of(*ONE, points=[*CORNERS[:3], (0, 0, math.nan)])
        for solid, words in (
            (hexahedron, "cell 1 is a vtkHexahedron; volumes must be tetrahedra"),
            (far, "cell 1 has the point 99, but there are only points 0 to 4"),
            (solid_of([0, 1, 2, 2]), "cell 0 has the point 2 twice"),
            (nowhere, "point 3 is not finite"),
            (vtkUnstructuredGrid(), "the grid has no tetrahedra"),
            (vtkMultiBlockDataSet(), "has blocks"),
            (surfaces.box(), "it can be a vtkUnstructuredGrid"),
            (([(0, 0, 0)], [(0, 1, 2)]), "cells has 3 columns; it must have 4"),
            ("missing.vtu", "cannot read missing.vtu: no such file"),
            ("solid.ply", "it must be .vtu"),
        ):
            with self.subTest(words), self.assertRaisesRegex(insideout.Error, words):
                insideout.check_solid(solid)

    def test_arrays_that_clash_are_renamed(self):
        grid = solid_of(*ONE)
        surfaces.add_array(grid.GetCellData(), "MeanRatio", [7.0])
        found = insideout.check_solid(grid)
        self.assertIn("Input_MeanRatio", found.warnings[0])
        self.assertEqual(cell_array(found.solid, "Input_MeanRatio").tolist(), [7])


class Command(CommandLine):
    def solid(self, name, *cells, points=CORNERS):
        insideout.write(solid_of(*cells, points=points), self.path(name))
        return self.path(name)

    def test_the_figures_are_printed_with_a_verdict(self):
        self.assertEqual(run(self.file("boxes.ply", surfaces.two_boxes()), self.output).returncode, 0)
        done = run("--check", self.output)
        self.assertEqual((done.returncode, done.stderr.count("insideout:")), (0, 0), done.stderr)
        first = done.stdout.splitlines()[0]
        self.assertRegex(first, r"^Solid solid.vtu: \d+ tetrahedra in 1 part, conforming, the boundary watertight; all positive$")
        found = insideout.check_solid(self.output)
        self.assertEqual(first, f"Solid solid.vtu: {found.verdict}")
        for name in ("MinDihedralAngle", "DihedralAngle1Percent", "RadiusEdgeRatio99Percent", "AverageMeanRatio"):
            self.assertIn(f"{found.statistics[name]:.3g}", done.stdout)
        self.assertRegex(done.stdout, r"under 10 degrees +\d+ cells; \d+ edges of the surface itself\n")

    def test_defects_are_told_and_in_the_report(self):
        report = self.path("report.json")
        done = run("--check", self.solid("turned.vtu", [0, 2, 1, 3]), "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Wrong, and may matter\n  1 negative cell: ", done.stdout)
        with open(report, encoding="utf-8") as file:
            found = json.load(file)
        self.assertEqual((found["exit_status"], found["statistics"]["NegativeCells"]), (0, 1))
        self.assertEqual([finding["text"] for finding in found["findings"]], ["1 negative cell", "1 cell that a solver refuses"])
        self.assertIn("1 negative cell", found["verdict"])
        self.assertEqual((len(found["dihedral_angle_histogram"]), sum(found["dihedral_angle_histogram"])), (36, 6))

    def test_surfaces_and_solids_are_checked_one_after_the_other(self):
        done = run("--check", self.solid("a.vtu", *TWO), self.file("b.ply", surfaces.box()), self.path("missing.ply"), self.solid("c.vtu", *ONE))
        self.assertEqual(done.returncode, 1)
        table = done.stdout.splitlines()[-5:]
        self.assertIn("2 tetrahedra in 1 part", table[0])
        self.assertIn("bounds a solid of volume 1", table[1])
        self.assertIn("1 tetrahedra in 1 part", table[3])
        self.assertEqual(table[4], "3 of 4 surfaces done")

    def test_the_histogram_is_drawn_without_a_window(self):
        picture = self.path("angles.png")
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        done = run("--check", self.solid("two.vtu", *TWO), "--plot", picture, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"Wrote picture    {picture}", done.stdout)
        [description] = description_of(picture)
        for line in description.split("; ")[:2]:
            self.assertIn(line, done.stdout)
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
        bars = np.abs(pixels - (0.45 * 255, 0.66 * 255, 0.80 * 255)).max(axis=1) < 3
        self.assertGreater(bars.sum(), 5000, "no bars")

    def test_options_of_surfaces_are_refused(self):
        solid, box = self.solid("a.vtu", *ONE), self.file("box.ply", surfaces.box())
        for arguments, words, status in (
            (("--check", solid, "--orientation", "as-given"), "--orientation is about surfaces", 2),
            (("--check", solid, "--merge-tolerance", "1"), "--merge-tolerance is about surfaces", 2),
            (("--check", solid, "--hull", self.path("hull.vtu")), "it goes without --hull", 2),
            (("--check", solid, box, "--plot", self.path("a.png")), "it goes without --plot", 2),
            (("--check", box, self.output), "it goes without OUTPUT.vtu", 2),
            (("--check", self.path("missing.vtu")), "no such file", 1),
            (("--check", solid, "--plot", solid), "named twice", 2),
            (("--check", solid, "--plot", self.path("angles.jpg")), "it must be .png", 2),
            (("--check", self.file("text.vtu", "hello")), "cannot read", 1),
        ):
            with self.subTest(arguments):
                done = run_here(*arguments)
                self.assertEqual(done.returncode, status)
                self.assertIn(words, done.stderr.splitlines()[-1])

    def test_a_surface_in_a_file_of_solids_is_told(self):
        insideout.write(surfaces.box(), self.path("box.vtp"))
        os.rename(self.path("box.vtp"), self.path("box.vtu"))
        self.check_failure(run("--check", self.path("box.vtu")), "it is not a VTK XML file of cells (UnstructuredGrid)")


if __name__ == "__main__":
    # Not the tests that this module imports with CommandLine.
    unittest.main(defaultTest=["ComparedWithVtk", "Figures", "Defects", "Inputs", "Command"])
