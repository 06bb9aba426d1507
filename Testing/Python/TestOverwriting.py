# SPDX-License-Identifier: GPL-3.0-or-later
"""No surface of the user's is lost by a forgotten name of an output, and scripts that run twice work twice."""

import os
import unittest

import insideout
import surfaces
from command import CommandLine, run_here
from insideout.files import WRITABLE_SURFACES, is_of_others
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

OFF = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
ASCII = {
    ".off": OFF,
    ".obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    ".stl": "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
    ".ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
}


class Overwriting(CommandLine):
    def of_others(self, name: str) -> str:
        """A surface that another program wrote."""
        kind = os.path.splitext(name)[1]
        if kind in ASCII:
            return self.file(name, ASCII[kind])
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(surfaces.box())
        writer.SetFileName(self.path(name))
        writer.Write()
        return self.path(name)

    def content(self, path: str) -> bytes:
        with open(path, "rb") as file:
            return file.read()

    def test_a_forgotten_output_destroys_no_surface(self):
        first, second, third = (self.of_others(f"{name}.off") for name in "abc")
        for arguments in (
            (first, second),
            ("mesh", first, second),
            ("repair", first, second),
            ("--together", first, second, third),
            ("--boolean", "A", first, third),
            ("boolean", "A - B", first, second, third),
        ):
            with self.subTest(arguments):
                done = run_here(*arguments, "--quiet")
                self.check_failure(done, f"{arguments[-1]} was not written by insideout", "--force")
                self.assertEqual([self.content(path) for path in (first, second, third)], [OFF.encode()] * 3)

    def test_nor_a_solid(self):
        solid = self.path("made.vtu")
        self.assertEqual(run_here(self.of_others("a.off"), solid, "--quiet").returncode, 0)
        other = self.file("other.vtu", self.content(solid).replace(b"Written by InsideOut", b"By somebody else"))
        before = self.content(other)
        self.check_failure(run_here("refine", solid, other, "--quiet"), f"{other} was not written by insideout")
        self.assertEqual(self.content(other), before)
        for told in (("--force",), ()):  # the second time it is insideout's
            self.assertEqual(run_here("refine", solid, other, *told, "--quiet").returncode, 0)

    def test_required_ending_of_an_output_is_told_first(self):
        points, first, second = self.file("points.csv", "x,y,z\n2,2,2\n"), self.of_others("a.off"), self.of_others("b.off")
        self.check_failure(run_here("query", points, first, second), f"{second}: unknown ending, it must be .csv")

    def test_an_empty_file_is_no_surface(self):
        for kind in WRITABLE_SURFACES:
            done = run_here("repair", self.of_others("a.off"), self.file("empty" + kind, ""), "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_name_is_no_mark(self):
        stl = self.file("joy.stl", ASCII[".stl"].replace("solid a", "solid InsideOut_Joy"))
        self.check_failure(run_here("repair", self.of_others("a.off"), stl, "--quiet"), f"{stl} was not written by insideout")

    def test_output_and_force_replace_files_of_others(self):
        first = self.of_others("a.off")
        for told in (lambda path: ("-o", path), lambda path: ("--output", path), lambda path: (path, "--force")):
            second = self.of_others("b.off")
            done = run_here("repair", first, *told(second), "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotEqual(self.content(second), OFF.encode())

    def test_no_input_is_replaced_whoever_says_so(self):
        first = self.of_others("a.off")
        for told in (("-o", first), (first, "--force")):
            self.check_failure(run_here("repair", first, *told, "--quiet"), "no output may replace it")
        self.assertEqual(self.content(first), OFF.encode())

    def test_scripts_that_run_twice_work_twice(self):
        source = self.of_others("a.off")
        for kind in WRITABLE_SURFACES:
            with self.subTest(kind):
                output = self.path("out" + kind)
                self.assertTrue(is_of_others(self.of_others("other" + kind)))
                for _ in range(2):
                    done = run_here("repair", source, output, "--quiet")
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertFalse(is_of_others(output))
                self.assertEqual(insideout.check(output).statistics["Facets"], 4)

    def test_other_files_are_replaced_as_ever(self):
        source = self.of_others("a.off")
        for name in ("solid.vtu", "solid.msh"):
            self.file(name, "anything")
            self.assertEqual(run_here(source, self.path(name), "--quiet").returncode, 0)

    def test_a_picture_is_an_output_too(self):
        source, picture = self.of_others("a.off"), self.path("picture.png")
        self.assertEqual(run_here("draw", source, "-o", picture, "--quiet").returncode, 0)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.off", "picture.png"])


if __name__ == "__main__":
    unittest.main()
