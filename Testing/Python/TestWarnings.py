# SPDX-License-Identifier: GPL-3.0-or-later
"""Circumstances that may change an answer are Python warnings of each function, given once, at the line of the call."""

import os
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import insideout
import surfaces
from vtkmodules.vtkCommonDataModel import vtkCellArray


def box_with_lines(turned: bool = False):
    surface = surfaces.reversed_box() if turned else surfaces.box()
    lines = vtkCellArray()
    lines.InsertNextCell(2, (0, 6))
    surface.SetLines(lines)
    return surface


POINT = (0.5, 0.5, 0.5)

FUNCTIONS = {
    "boolean": lambda surface: insideout.boolean([surface, surfaces.box((0.5, 0, 0))]),
    "check": insideout.check,
    "distance": lambda surface: insideout.distance(surface, POINT),
    "inside": lambda surface: insideout.inside(surface, POINT),
    "resolve": insideout.resolve,
    "sdf_grid": lambda surface: insideout.sdf_grid(surface, shape=4),
    "sdf_grid to the surface": lambda surface: insideout.sdf_grid(surface, shape=4, to="surface"),
    "tetrahedralize": insideout.tetrahedralize,
    "tetrahedralize bodies": lambda surface: insideout.tetrahedralize({"a": surface, "b": surfaces.box((3, 0, 0))}),
    "voxels": lambda surface: insideout.voxels(surface, 0.5),
    "winding_number": lambda surface: insideout.winding_number(surface, POINT),
}
TURNING = set(FUNCTIONS) - {"check", "resolve"}
"""Those whose answer depends on what is turned over, and say so."""


def heard_from(call) -> list[warnings.WarningMessage]:
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        call()
    return heard


class Warnings(unittest.TestCase):
    def test_each_function_that_takes_a_surface_warns_where_it_was_called(self):
        for name, function in FUNCTIONS.items():
            with self.subTest(name):
                heard = heard_from(lambda: function(box_with_lines()))
                self.assertEqual([warning.category for warning in heard], [insideout.Warning] * len(heard))
                self.assertEqual(sum("are ignored" in str(warning.message) for warning in heard), 1)
                self.assertEqual({Path(warning.filename).name for warning in heard}, {Path(__file__).name})

    def test_turned_facets_are_told_once(self):
        for name in TURNING:
            with self.subTest(name):
                texts = [str(warning.message) for warning in heard_from(lambda: FUNCTIONS[name](surfaces.reversed_box()))]
                self.assertEqual(sum("turned over" in text for text in texts), 1)

    def test_results_have_the_same_texts(self):
        results = []
        heard = heard_from(lambda: results.append(insideout.tetrahedralize(box_with_lines(turned=True))))
        self.assertEqual([str(warning.message) for warning in heard], results[0].warnings)
        self.assertEqual(len(heard), 2)

    def test_solids_warn(self):
        solid = insideout.tetrahedralize(surfaces.box()).solid
        blocks = [SimpleNamespace(type="tetra", data=solid.cells), SimpleNamespace(type="triangle", data=[(0, 1, 2)])]
        for function in (insideout.check_solid, insideout.refine):
            heard = heard_from(lambda: function(SimpleNamespace(points=solid.points, cells=blocks)))
            self.assertEqual([str(warning.message) for warning in heard], ["1 cells of the meshio.Mesh are ignored: they are not tetrahedra"])
            self.assertIs(heard[0].category, insideout.Warning)

    def test_a_category_can_be_silenced_and_raised(self):
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            warnings.simplefilter("ignore", insideout.Warning)
            insideout.winding_number(box_with_lines(), POINT)
        self.assertEqual(heard, [])
        with warnings.catch_warnings():
            warnings.simplefilter("error", insideout.Warning)
            with self.assertRaisesRegex(insideout.Warning, "ignored"):
                insideout.inside(box_with_lines(), POINT)

    def test_nothing_is_told_of_what_is_well(self):
        for name, function in FUNCTIONS.items():
            with self.subTest(name):
                self.assertEqual(heard_from(lambda: function(surfaces.box())), [])

    def test_showing_a_result_warns_of_nothing(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            result = insideout.resolve(surfaces.open_box())
        with mock.patch("insideout.results.draw_panels", return_value=b"png"):
            self.assertEqual(heard_from(lambda: (repr(result), result._repr_html_(), result.png())), [])

    def test_drawing_warns_of_the_surface(self):
        hull = insideout.tetrahedralize(surfaces.box()).hull
        with tempfile.TemporaryDirectory() as folder, mock.patch("insideout.drawing.draw_panels", return_value=b"png"):
            heard = heard_from(lambda: insideout.draw(box_with_lines(), hull, os.path.join(folder, "picture.png")))
        self.assertEqual(len(heard), 1)
        self.assertEqual(Path(heard[0].filename).name, Path(__file__).name)

    def test_an_error_comes_without_warnings_of_before(self):
        def fail():
            with self.assertRaises(insideout.Error):
                insideout.tetrahedralize({"a": box_with_lines(), "b": None})

        self.assertEqual(heard_from(fail), [])
        self.assertEqual(heard_from(lambda: insideout.check(surfaces.box())), [])

    def test_the_command_tells_each_once(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "box.off")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                insideout.write(surfaces.reversed_box(), file)
            done = subprocess.run(
                [sys.executable, "-W", "error", "-m", "insideout", "mesh", file, os.path.join(folder, "solid.vtu")],
                capture_output=True, text=True, check=False,
            )  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((done.stdout + done.stderr).count("turned over\n"), 1, done.stdout + done.stderr)


class Arguments(unittest.TestCase):
    def test_unknown_arguments_are_errors_that_name_the_nearest(self):
        for call, words in (
            (lambda: insideout.tetrahedralize(surfaces.box(), gama=1), "tetrahedralize has no argument gama; the nearest is gamma"),
            (lambda: insideout.inside(surfaces.box(), POINT, treshold=1), "inside has no argument treshold; the nearest is threshold"),
            (lambda: insideout.check(surfaces.box(), zzz=1), "check has no argument zzz; it has surface, scale, "),
            (lambda: insideout.winding_number(surfaces.box()), "winding_number: missing a required argument: 'points'"),
            (lambda: insideout.tetrahedralize(surfaces.box(), 1.0), "tetrahedralize: too many positional arguments"),
            (lambda: insideout.check(surfaces.box(), progress=3), "progress is 3; it must be a function"),
        ):
            with self.subTest(words), self.assertRaisesRegex(insideout.Error, words):
                call()


if __name__ == "__main__":
    unittest.main()
