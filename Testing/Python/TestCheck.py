# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout.check` and `python3 -m insideout --check`."""

import json
import os
import tempfile
import unittest

import insideout
import surfaces
from real_surfaces import unpack_cgal
from surfaces import cell_array, polydata
from command import CommandLine, run


# Vertices, facets, open edges, intersecting pairs, components, non-manifold edges: table 8.1's columns.
TABLE = ("Points", "Facets", "OpenEdges", "IntersectingPairs", "Components", "NonManifoldEdges")
MESHES = {
    "man.off": (17495, 34986, 0, 848, 1, 0),
    "mannequin-devil.off": (12977, 25888, 64, 1643, 1, 0),
    "cow.off": (2903, 5804, 0, 89, 1, 0),
}


def two_boxes_nearly_touching():
    second = [tuple(corner + 8 for corner in facet) for facet in surfaces.BOX_FACETS]
    points = surfaces.box_points() + surfaces.box_points((1 + 1e-9, 0, 0))
    return polydata(points, [*surfaces.BOX_FACETS, *second])


def one_facet_turned():
    return surfaces.box(facets=[surfaces.BOX_FACETS[0][::-1], *surfaces.BOX_FACETS[1:]])


class Check(unittest.TestCase):
    def test_a_box_has_nothing_wrong(self):
        found = insideout.check(surfaces.box())
        self.assertEqual((found.findings, found.warnings), ([], []))
        self.assertEqual(found.verdict, "bounds a solid of volume 1")
        self.assertEqual(found.lines.GetNumberOfCells(), 0)

    def test_findings_say_whether_they_matter(self):
        flat = polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        both_ways = [*surfaces.BOX_FACETS, *(facet[::-1] for facet in surfaces.BOX_FACETS)]
        for name, surface, matters, text, verdict in (
            ("crossing", surfaces.two_boxes(), False, "intersecting pairs", "bounds a solid of volume 1.875"),
            ("open", surfaces.open_box(), False, "4 open edges", "bounds a solid of volume about 1.00000 (95 %: 0.99990 to 1.00010), once its holes are closed"),
            ("twice", surfaces.box(facets=surfaces.BOX_FACETS * 2), False, "12 duplicate facets", "bounds a solid of volume 1"),
            ("both ways", surfaces.box(facets=both_ways), False, "1 two-sided component", "bounds a solid of volume 1"),
            ("turned", one_facet_turned(), False, "3 inconsistent edges", "bounds a solid of volume 1 after turning 1 facet over"),
            ("near", two_boxes_nearly_touching(), True, "8 near-coincident points", "bounds a solid of volume 2"),
            ("flat", flat, True, "lies in one plane", "bounds no solid: it lies in one plane"),
        ):
            with self.subTest(name):
                found = insideout.check(surface)
                finding = next(finding for finding in found.findings if text in finding.text)
                self.assertEqual(finding.matters, matters)
                self.assertTrue(finding.consequence)
                self.assertTrue(found.verdict.startswith(verdict), found.verdict)

    def test_findings_that_matter_come_first(self):
        second = [tuple(corner + 8 for corner in facet) for facet in surfaces.BOX_FACETS]
        points = surfaces.box_points() + surfaces.box_points((1 + 1e-9, 0, 0))
        matters = [finding.matters for finding in insideout.check(polydata(points, [*surfaces.BOX_FACETS[1:], *second])).findings]
        self.assertEqual(matters, [True, False])

    def test_the_advised_tolerance_mends_near_points(self):
        found = insideout.check(two_boxes_nearly_touching())
        self.assertEqual(found.statistics["NearPoints"], 8)
        tolerance = found.statistics["NearDistance"]
        self.assertIn(f"{tolerance:.2g}", found.findings[0].consequence)
        self.assertIn("set merge_tolerance to", found.warnings[0])
        merged = insideout.check(two_boxes_nearly_touching(), merge_tolerance=tolerance)
        self.assertEqual((merged.statistics["NearPoints"], merged.statistics["Points"]), (0, 12))

    def test_the_cells_are_marked(self):
        found = insideout.check(surfaces.two_boxes())
        self.assertEqual(list(cell_array(found.surface, "ComponentId")), [0] * 12 + [1] * 12)
        crossings = cell_array(found.surface, "SelfIntersections")
        self.assertEqual(crossings.sum(), 2 * found.statistics["IntersectingPairs"])
        self.assertEqual(set(cell_array(found.lines, "DefectType")), {insideout.vtkSurfaceDefects.INTERSECTION_CURVE})

    def test_it_counts_what_the_tetrahedralization_does(self):
        for surface in (surfaces.two_boxes(), surfaces.open_box(), surfaces.box(facets=surfaces.BOX_FACETS * 2)):
            checked = insideout.check(surface).statistics
            meshed = insideout.tetrahedralize(surface).statistics
            common = set(checked) & set(meshed)
            self.assertGreater(len(common), 10)
            self.assertAlmostEqual(checked.pop("OverlapVolume"), meshed.pop("OverlapVolume"), delta=1e-15)  # of facets, and of cells
            common.remove("OverlapVolume")
            self.assertEqual({name: checked[name] for name in common}, {name: meshed[name] for name in common})

    def test_inputs_other_than_surfaces_are_errors(self):
        with self.assertRaisesRegex(insideout.Error, "empty"):
            insideout.check(polydata([], []))
        with self.assertRaisesRegex(insideout.Error, "degenerate"):
            insideout.check(surfaces.box(facets=[(0, 0, 1)]))
        with self.assertRaisesRegex(insideout.Error, "it can be a vtkPolyData, a file"):
            insideout.check(7)
        with self.assertRaisesRegex(insideout.Error, "merge_tolerance"):
            insideout.check(surfaces.box(), merge_tolerance=-1)

    def test_real_meshes_have_the_known_counts(self):
        with tempfile.TemporaryDirectory() as folder:
            found = {}
            for path in unpack_cgal(folder, MESHES):
                statistics = insideout.check(path).statistics
                found[os.path.basename(path)] = tuple(statistics[column] for column in TABLE)
            self.assertEqual(found, MESHES)


class CheckCommand(CommandLine):
    def test_the_counts_are_printed_with_a_verdict(self):
        done = run("--check", self.file("turned.ply", one_facet_turned()))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(
            done.stdout.splitlines()[0], "Surface turned.ply: bounds a solid of volume 1 after turning 1 facet over"
        )
        for text in ("vertices in use", "non-manifold edges", "does not matter here", "3 inconsistent edges: "):
            self.assertIn(text, done.stdout)
        self.assertEqual(done.stdout.count("inconsistent edges"), 1, "told once")
        self.assertIn("  3 inconsistent edges: ", done.stdout)

    def test_the_report_holds_the_findings(self):
        report = self.path("report.json")
        done = run("--check", self.file("open.ply", surfaces.open_box()), "--report", report, "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        with open(report, encoding="utf-8") as file:
            found = json.load(file)
        self.assertEqual((found["exit_status"], found["error"], found["outputs"]), (0, None, {}))
        self.assertEqual(found["defects"], ["4 open edges"])
        self.assertEqual([finding["text"] for finding in found["findings"]], ["4 open edges"])
        self.assertIs(found["findings"][0]["matters"], False)
        self.assertEqual(found["verdict"], "bounds a solid of volume about 1.00000 (95 %: 0.99990 to 1.00010), once its holes are closed")
        self.assertEqual(found["statistics"]["OpenEdges"], 4)

    def test_a_merge_tolerance(self):
        source = self.file("near.ply", two_boxes_nearly_touching())
        self.assertIn("8 near-coincident points", run("--check", source).stdout)
        done = run("--check", source, "--merge-tolerance", "1e-6")
        self.assertRegex(done.stdout, r"near-coincident points +0\n")
        done = run(source, self.output, "--merge-tolerance", "1e-6", "--report", self.path("report.json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("report.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["statistics"]["Points"], 12)

    def test_options_of_meshing_are_refused(self):
        source = self.file("box.ply", surfaces.box())
        self.check_failure_of_check(run("--check", source, self.output), "it goes without OUTPUT.vtu")
        self.check_failure_of_check(run("--check", source, "--gamma", "1"), "it goes without --gamma")
        self.check_failure_of_check(run("--check", source, "--gamma", "0"), "it goes without --gamma")
        self.check_failure_of_check(run("--check", source, "--split-seams"), "it goes without --split-seams")
        self.check_failure_of_check(run("--check", source, "--time-budget", "1"), "it goes without --time-budget")
        self.check_failure_of_check(run("--check", source, "--merge-tolerance", "-1"), "--merge-tolerance is -1")
        self.check_failure_of_check(run("--check", self.path("missing.ply")), "no such file")
        self.check_failure_of_check(run("--check", self.file("empty.off", "OFF\n0 0 0\n")), "empty")

    def check_failure_of_check(self, done, expected):
        self.check_failure(done, expected)
        self.assertEqual(done.stdout, "")


if __name__ == "__main__":
    # Not the tests that this module imports with CommandLine.
    unittest.main(defaultTest=["Check", "CheckCommand"])
