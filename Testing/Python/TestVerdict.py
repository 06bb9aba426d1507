# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdict: its volume is exact, or it says how sure it is; one number and one wording everywhere; at most ten lines."""

import importlib
import json
import os
import sys
import tempfile
import unittest
from pathlib import Path

import insideout
import numpy as np
import surfaces
from command import CommandLine, run
from insideout.verdict import MOST_LINES, in_few_lines, verdict, volumes_of_shells
from real_surfaces import unpack_cgal
from surfaces import BOX_FACETS, box_points, polydata

sys.path.append(os.fspath(Path(__file__).resolve().parents[1] / "Judge"))
judge = importlib.import_module("judge-verdict")

OPEN = "bounds a solid of volume about 1.00000 (95 %: 0.99990 to 1.00010), once its holes are closed"


def joined(boxes, rotation=None):
    """Boxes by their lower corners, sizes, and facets that are left away."""
    points, facets = [], []
    for low, sizes, away in boxes:
        facets += [tuple(len(points) + p for p in facet) for facet in BOX_FACETS[away:]]
        points += [tuple(np.array(low) + np.array(sizes) * unit) for unit in box_points()]
    return polydata(points if rotation is None else np.array(points) @ rotation, facets)


def random_rotation(random):
    rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return rotation * np.sign(np.linalg.det(rotation))


def everything_wrong():
    """Many shells, of which some overlap, one is a cavity, and some are open, doubled, sheets, membranes or inside out."""
    points, facets = [], []

    def add(low, size, own):
        facets.extend(tuple(len(points) + p for p in facet) for facet in own)
        points.extend(box_points(low, size))

    add((0, 0, 0), 6, BOX_FACETS)
    add((1, 1, 1), 1, [facet[::-1] for facet in BOX_FACETS])
    add((5, 5, 5), 3, BOX_FACETS)
    add((2, 2, 2), 1, BOX_FACETS[:2])
    for k in range(20):
        add((10 + 2 * k, 0, 0), 1, BOX_FACETS[k % 3 :])
        add((10 + 2 * k, 3, 0), 1, BOX_FACETS[:2])
    add((0, 10, 0), 1, [facet[::-1] for facet in BOX_FACETS])
    add((0, 14, 0), 1, BOX_FACETS * 2)
    add((0, 18, 0), 1, [(0, 0, 1), *BOX_FACETS])
    add((0, 22, 0), 1, [BOX_FACETS[0][::-1], *BOX_FACETS[1:]])
    add((0, 26, 0), 1, [(0, 1, 2), (2, 1, 0)])
    add((0, 30, 0), 1, BOX_FACETS)
    add((1 + 1e-7, 30, 0), 1, BOX_FACETS)
    return polydata(points, facets)


class Volumes(unittest.TestCase):
    def check_case(self, surface, **options):
        found, made = insideout.check(surface, **options), insideout.tetrahedralize(surface, **options)
        ends = (found.statistics[f"EnclosedVolume{end}"] for end in ("Low", "High"))
        return judge.Case("surface", found.verdict, *ends, made.statistics["Volume"], made.verdict)

    def test_closed_surfaces_that_cross_have_exact_volumes(self):
        random = np.random.default_rng(45)
        for trial in range(20):
            boxes = [(random.random(3), 0.2 + random.random(3), 0) for _ in range(1 + trial % 5)]
            case = self.check_case(joined(boxes, random_rotation(random)))
            self.assertTrue(case.is_exact(), trial)
            self.assertAlmostEqual(case.low, case.volume, delta=1e-12)
            self.assertTrue(case.tells_of_mesh(), case.meshed)
            self.assertEqual(case.told, case.meshed)

    def test_volumes_of_open_surfaces_are_between_their_bounds(self):
        random = np.random.default_rng(46)
        cases = []
        for _ in range(60):
            boxes = [(2 * random.random(3), 0.5 + random.random(3), int(random.integers(3))) for _ in range(3)]
            cases.append(self.check_case(joined([*boxes, ((5, 5, 5), (1, 1, 1), 1)], random_rotation(random))))
        self.assertFalse(any(case.is_exact() for case in cases))
        self.assertTrue(all("about" in case.told and case.tells_of_mesh() for case in cases))
        self.assertGreaterEqual(sum(case.holds() for case in cases), 57)
        self.assertLess(np.median([case.width() for case in cases]), 0.2)

    def test_volumes_of_real_surfaces_are_between_their_bounds(self):
        with tempfile.TemporaryDirectory() as folder:
            cases = {Path(path).name: judge.judged(Path(path)) for path in unpack_cgal(folder, {"cow.off", "camel.off", "man.off", "bones.off", "b9_mesh.off"})}
        self.assertEqual({name: case.is_exact() for name, case in cases.items()}, {"cow.off": True, "camel.off": True, "man.off": False, "bones.off": False, "b9_mesh.off": False})
        for name, case in cases.items():
            self.assertTrue(case.holds() and case.tells_of_mesh(), f"{name}: {case}")

    def test_solids_bounded_by_the_winding_number_alone_have_a_volume(self):
        sides = [polydata(box_points(), BOX_FACETS[2 * k : 2 * k + 2]) for k in range(6)]
        apart = joined([((0, 0, 0), (1, 1, 1), 0)])
        points = [p for side in sides for p in surfaces.points_of(side).tolist()]
        shrunk = [tuple(0.5 + 0.999 * (np.array(p) - 0.5) + 1e-3 * (i // 8)) for i, p in enumerate(points)]
        sheets = polydata(shrunk, [tuple(8 * k + p for p in facet) for k in range(6) for facet in BOX_FACETS[2 * k : 2 * k + 2]])
        self.assertEqual(insideout.check(apart).verdict, "bounds a solid of volume 1")
        self.assertRegex(insideout.check(sheets).verdict, r"^means a solid of volume about \S+ \(95 %: .*\) by its winding number; its shells alone bound none: 6 sheets$")
        case = self.check_case(sheets)
        self.assertTrue(case.holds() and case.tells_of_mesh(), case)


class Lines(CommandLine):
    def test_all_tell_the_same_once_there_is_a_mesh(self):
        source = self.file("open.ply", surfaces.open_box())
        checked, dry = run("--check", source), run(source, self.output, "--dry-run")
        self.assertEqual(checked.stdout.splitlines()[0], f"Surface open.ply: {OPEN}")
        self.assertEqual(dry.stdout.splitlines()[0], f"Surface open.ply: {OPEN}")
        done = run(source, self.output, "--report", self.path("report.json"))
        report = json.loads(Path(self.path("report.json")).read_text(encoding="utf-8"))
        meshed = "bounds a solid of volume 1, once its holes are closed"
        self.assertEqual(report["verdict"], meshed)
        self.assertEqual(done.stdout.splitlines()[0], f"Surface open.ply: {meshed}")
        self.assertNotIn("EnclosedVolume", report["statistics"])
        self.assertEqual(insideout.tetrahedralize(surfaces.open_box()).verdict, meshed)
        filter_ = insideout.vtkRobustTetrahedralize()
        filter_.SetInputData(surfaces.open_box())
        filter_.Update()
        self.assertEqual(filter_.GetSummary().splitlines()[-1], meshed)
        marker = insideout.vtkSurfaceDefects()
        marker.SetInputData(surfaces.open_box())
        marker.Update()
        self.assertEqual(marker.GetVerdict(), OPEN)

    def test_are_at_most_ten_and_nothing_is_lost(self):
        source = self.file("wrong.ply", everything_wrong())
        checked, meshed = run("--check", source), run(source, self.output, "--report", self.path("report.json"))
        for done, end in ((checked, "vertices in use"), (meshed, "Solid")):
            lines = done.stdout.splitlines()
            about = lines[: next(k for k, line in enumerate(lines) if end in line)]
            self.assertEqual(len(about), MOST_LINES, done.stdout + done.stderr)
        report = json.loads(Path(self.path("report.json")).read_text(encoding="utf-8"))
        self.assertGreater(len(report["defects"]), 5)
        for defect in report["defects"]:
            self.assertIn(defect, meshed.stdout)
        self.assertIn(" smaller ones", checked.stdout)
        self.assertIn(verdict(report["statistics"]), meshed.stdout)

    def test_cavities_of_the_mesh_are_counted(self):
        hollow = joined([((0, 0, 0), (3, 3, 3), 0)])
        inner = [tuple(8 + p for p in facet[::-1]) for facet in BOX_FACETS]
        source = self.file("hollow.ply", polydata([*map(tuple, surfaces.points_of(hollow)), *box_points((1, 1, 1))], [*BOX_FACETS, *inner]))
        self.assertIn("\n  1 cavity within it\n", run(source, self.output).stdout)

    def test_too_many_lines_are_joined(self):
        self.assertEqual(in_few_lines(["a", "  b"], 2), ["a", "  b"])
        self.assertEqual(in_few_lines(["a", "  b", "  c", "  d"], 2), ["a", "  b; c; d"])
        self.assertEqual(volumes_of_shells([1, 3, -2, 0], 4)[0], "shell 1: volume 3")
        self.assertEqual(volumes_of_shells([1, 3, -2, 0], 3), ["shell 1: volume 3", "shell 2: volume -2 (a cavity)", "and 2 smaller ones"])


if __name__ == "__main__":
    unittest.main()
