# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of sizes: in `tetrahedralize`, `refine` and on the command line."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
import warnings

import insideout
import numpy as np
import surfaces
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

LID = {"lid": "normal 0 0 1"}


def edges_of(triangles: np.ndarray, points: np.ndarray) -> np.ndarray:
    """The lengths of edges, each once."""
    ends = np.unique(np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1), axis=0)
    return np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)


def lengths_on(result, tag: str) -> np.ndarray:
    return edges_of(result.boundary.triangles[result.tags[tag]], result.boundary.points)


def told(surface, **options) -> tuple:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        result = insideout.tetrahedralize(surface, **options)
    return result, result.warnings


def image(low: float, high: float) -> vtkImageData:
    """Over the box from -1 to 2: lengths that grow with x."""
    data = vtkImageData()
    data.SetDimensions(2, 2, 2)
    data.SetOrigin(-1, -1, -1)
    data.SetSpacing(3, 3, 3)
    surfaces.add_array(data.GetPointData(), "Length", np.tile([low, high], 4).astype(float))
    return data


class Rules(unittest.TestCase):
    def test_a_tag_has_its_length_and_sizes_grow_from_there(self):
        result, _ = told(surfaces.box(), tag_rules=LID, size_rules={"tag lid": 0.1})
        lengths = lengths_on(result, "lid")
        self.assertGreater(np.mean((lengths > 0.05) & (lengths < 0.2)), 0.95)
        self.assertGreater(lengths_on(result, "surface").max(), 0.25)
        self.assertAlmostEqual(result.volume, 1, 2)

    def test_text_a_list_and_a_dict_say_the_same_also_in_percent(self):
        diagonal = 3**0.5
        given = [f"tag lid={0.1 * diagonal!r}; gap=2", ["tag lid=10%", "gap=2"], {"tag lid": "10%", "gap": 2}]
        made = [told(surfaces.box(), tag_rules=LID, size_rules=rules)[0].solid for rules in given]
        self.assertGreater(len(made[0].cells), 300)
        for other in made[1:]:
            np.testing.assert_allclose(other.points, made[0].points, rtol=1e-12, atol=1e-12)

    def test_regions_are_named_or_numbered(self):
        bodies = {"low": surfaces.box(), "high": surfaces.box(low=(0, 0, 1))}
        by_name, _ = told(bodies, size_rules={"region low": 0.1})
        by_number, _ = told(bodies, size_rules={"region 0": 0.1})
        np.testing.assert_array_equal(by_name.solid.cells, by_number.solid.cells)
        regions = by_name.solid.cell_arrays["RegionId"]
        self.assertGreater(np.mean(regions == 0), 0.8)

    def test_curvature_gives_edges_per_turn_and_coarsens(self):
        ball = surfaces.ball(1, 60, 40)
        result, _ = told(ball, size_rules="curvature=24", surface_tolerance=0.1)
        mean = edges_of(result.boundary.triangles, result.boundary.points).mean()
        self.assertAlmostEqual(mean / (2 * np.pi / 24), 1, delta=0.15)
        _, words = told(ball, size_rules="curvature=12")
        self.assertIn("shorter than", " ".join(words))
        self.assertIn("size_rules", " ".join(words))

    def test_a_background_is_obeyed_from_memory_and_from_a_file(self):
        result, _ = told(surfaces.box(), size_rules={"background": image(0.02, 0.5)})
        solid = result.solid
        ends = np.unique(np.sort(np.concatenate([solid.cells[:, pair] for pair in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))]), axis=1), axis=0)
        middles = solid.points[ends].mean(axis=1)
        lengths = np.linalg.norm(solid.points[ends[:, 0]] - solid.points[ends[:, 1]], axis=1)
        wanted = 0.02 + (middles[:, 0] + 1) / 3 * 0.48
        self.assertGreater(np.mean((lengths / wanted > 0.5) & (lengths / wanted < 1.7)), 0.9)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a=b.vti")
            writer = vtkXMLImageDataWriter()
            writer.SetInputData(image(0.02, 0.5))
            writer.SetFileName(path)
            writer.Write()
            again, _ = told(surfaces.box(), size_rules=f"background Length={path}")
            np.testing.assert_array_equal(again.solid.points, solid.points)
            refined = insideout.refine(told(surfaces.box())[0].solid, size_rules=[f"background={path}"])
            self.assertGreater(len(refined.solid.cells), 100)

    def test_a_kept_surface_says_how_far_it_is_from_the_rules(self):
        _, words = told(surfaces.box(), size_rules={"point 0 0 0": 0.1}, surface_treatment="kept")
        self.assertRegex(" ".join(words), "edges of the surface, which is kept, are up to .* times as long as size_rules asks for: surface_treatment split")
        _, words = told(surfaces.box(), size_rules={"point 0 0 0": 0.1}, merge_coplanar_pieces=True)
        self.assertIn("though size_rules are given", " ".join(words))

    def test_bad_rules_are_named(self):
        square = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        box = surfaces.box()
        cases = [
            (box, {"size_rules": "walls=3"}, "the rule walls=3 is none of curvature=EDGES"),
            (box, {"size_rules": {"gap": "x"}}, 'the rule gap=x has "x" in place of a number'),
            (box, {"size_rules": {"gap": [1]}}, r"size_rules has \[1\] for gap; it must be a number"),
            (box, {"size_rules": 3}, "size_rules is 3; it must be WHAT=NUMBER, a list"),
            (box, {"size_rules": {"tag door": 1}}, "the rule tag door=1 names no tag; these are surface"),
            (box, {"size_rules": {"region 7": 1}}, "the rule region 7=1 names no region; these are 0"),
            (box, {"size_rules": {"tag surface": 1}, "split_seams": True}, "size_rules of tags"),
            (box, {"size_rules": {"background": "nowhere.vti"}}, "nowhere.vti"),
            (box, {"size_rules": {"background": "a.txt"}}, "a.txt: a background is a file of VTK"),
            (box, {"size_rules": {"background Other": image(1, 1)}}, "the background has no point array Other"),
            (box, {"size_rules": {"gap": 3}, "refine": False}, "size_rules is given, which refines, and refine is False"),
            (square, {"size_rules": {"gap": 3}}, "the input lies in a plane: set edge_length"),
        ]
        for surface, options, words in cases:
            with self.subTest(options), self.assertRaisesRegex(insideout.Error, words):
                told(surface, **options)
        solid = told(box)[0].solid
        with self.assertRaisesRegex(insideout.Error, "names a tag, and there is no boundary with tags"):
            insideout.refine(solid, size_rules={"tag surface": 1})
        with self.assertRaisesRegex(insideout.Error, "background is given, and so is one of size_rules"):
            insideout.refine(solid, size_rules={"background": image(1, 1)}, sizes="Length", background=image(1, 1))


class Command(unittest.TestCase):
    def test_it_takes_rules_one_by_one_and_tells_that_the_estimate_leaves_them_out(self):
        with tempfile.TemporaryDirectory() as folder:
            surface, output, report = (os.path.join(folder, name) for name in ("box.ply", "solid.vtu", "report.json"))
            insideout.write(told(surfaces.box())[0].boundary, surface)
            command = [sys.executable, "-m", "insideout", "mesh", surface, output, "--tag", "lid=normal 0 0 1", "--size", "tag lid=10%", "--size", "gap=2"]
            planned = subprocess.run([*command, "--dry-run"], capture_output=True, text=True, check=True)
            self.assertIn("--size-rules", planned.stdout + planned.stderr)
            subprocess.run([*command, "--report", report], capture_output=True, text=True, check=True)
            with open(report, encoding="utf-8") as file:
                found = json.load(file)
            self.assertRegex(found["parameters"]["size_rules"], r"^tag lid=0\.173.*;gap=2$")
            self.assertGreater(found["statistics"]["RefinedCells"], 300)

    def test_errors_name_options_as_they_are_given(self):
        with tempfile.TemporaryDirectory() as folder:
            surface = os.path.join(folder, "box.ply")
            insideout.write(told(surfaces.box())[0].boundary, surface)
            command = [sys.executable, "-m", "insideout", "mesh", surface, os.path.join(folder, "solid.vtu"), "--edge-length", "0.008"]
            refused = subprocess.run(command, capture_output=True, text=True, check=False)
            self.assertRegex(refused.stderr, "more than --maximum-cells, 10000000")


if __name__ == "__main__":
    unittest.main()
