# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of `insideout demo`, and the commands that it prints.

    python3 TestDemo.py
"""

import os
import re
import subprocess
import sys
import unittest

import insideout
import surfaces
from command import CommandLine, run, run_here
from insideout import demo
from insideout.commands.demo import COMMANDS, contents

LIKELY_WRONG = {
    "broken.ply": ("OpenEdges", "IntersectingPairs", "DuplicateFacets"),
    "inverted.stl": ("TurnedFacets",),
    "organ.ply": ("OpenEdges",),
    "scan.ply": ("OpenEdges",),
    "bracket.obj": ("OpenEdges", "IntersectingPairs"),
    "outline.csv": ("OpenEnds", "Crossings"),
}
"""The feature that each file demonstrates."""


class Demo(CommandLine):
    def in_folder(self, name: str) -> list[str]:
        return sorted(os.listdir(self.path(name)))

    def test_the_same_bytes_come_at_each_call(self):
        self.assertEqual(contents(), contents())

    def test_each_file_has_the_defects_that_it_is_there_for(self):
        self.assertEqual(run("demo", cwd=self.folder).returncode, 0)
        for name, wrong in LIKELY_WRONG.items():
            checked = insideout.check(self.path(f"demo/{name}"))
            for statistic in wrong:
                self.assertGreater(checked.statistics[statistic], 0, f"{name}: {statistic}")

    def test_printed_commands_work_as_they_stand_and_twice(self):
        done = run("demo", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        script = done.stdout[done.stdout.index("cd demo") :]
        self.assertEqual(len(script.splitlines()), 1 + len(COMMANDS))
        program = f'insideout() {{ "{sys.executable}" -m insideout "$@"; }}\n'
        for _ in range(2):
            ran = subprocess.run(["sh", "-eu", "-c", program + script], cwd=self.folder, capture_output=True, text=True, check=False)
            self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
            self.assertNotIn("Warning: ", re.sub("Warning: (1 of 2 shells are inside out|the input is lines)", "", ran.stdout))
        self.assertLess({"wrong.png", "fixed.stl", "solid.vtu", "steel.dat", "organs.msh", "mask.vti", "inside.csv"}, set(self.in_folder("demo")))

    def test_a_second_time_the_files_are_as_before(self):
        here = self.path("here")
        self.assertEqual(run_here("demo", here).returncode, 0)
        names = self.in_folder("here")
        self.assertEqual(run_here("demo", here).returncode, 0)
        self.assertEqual(self.in_folder("here"), names)
        for name, content in contents().items():
            with open(os.path.join(here, name), "rb") as file:
                self.assertEqual(file.read(), content, name)

    def test_nothing_is_written_where_a_file_of_another_program_is_in_the_way(self):
        os.mkdir(self.path("demo"))
        for name in ("scan.ply", "places.csv", "steel.inp"):
            with self.subTest(name):
                path = self.file(f"demo/{name}", "mine\n")
                done = run_here("demo", self.path("demo"))
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertEqual(done.stderr, f"insideout: {path} was not written by insideout, and stays; give the demo another folder: insideout demo FOLDER\n")
                self.assertEqual(self.in_folder("demo"), [name])
                os.remove(path)

    def test_files_in_the_place_of_folders_are_named(self):
        path = self.file("file", "mine\n")
        done = run_here("demo", path)
        self.assertEqual((done.returncode, done.stderr), (1, f"insideout: cannot make the folder {path}: file exists\n"))
        os.makedirs(self.path("demo/broken.ply"))
        self.assertIn("broken.ply is a folder", run_here("demo", self.path("demo")).stderr)

    def test_in_the_folder_itself_no_cd_is_printed(self):
        done = run("demo", ".", cwd=self.folder)
        self.assertNotIn("cd ", done.stdout)
        self.assertIn("bracket.obj", self.in_folder("."))

    def test_folders_with_spaces_are_quoted(self):
        self.assertIn("cd 'two words'\n", run("demo", "two words", cwd=self.folder).stdout)


class Surfaces(unittest.TestCase):
    def test_the_tumor_is_within_the_organ(self):
        self.assertTrue(insideout.inside(demo.organ(), surfaces.points_of(demo.tumor())).all())

    def test_the_groups_of_the_bracket_are_tags_of_known_area(self):
        result = insideout.tetrahedralize(demo.bracket())
        areas = {}
        for name, triangles in result.tags.items():
            a, b, c = (result.boundary.points[corner] for corner in result.boundary.triangles[triangles].T)
            areas[name] = surfaces.np.linalg.norm(surfaces.np.cross(b - a, c - a), axis=1).sum() / 2
        self.assertAlmostEqual(areas["clamp"], 40 * 60, 9)
        self.assertAlmostEqual(areas["load"], 30 * 36, 9)
        wall, shelf, both = 8 * 40 * 60, 66 * 36 * 8, 4 * 36 * 8
        self.assertGreater(result.statistics["Volume"], wall + shelf - both)

    def test_balls_are_closed_and_face_outward(self):
        checked = insideout.check(demo.ball((0, 0, 0), (1, 2, 3), 40, 30).surface())
        self.assertEqual((checked.statistics["OpenEdges"], checked.statistics["TurnedFacets"]), (0, 0))
        self.assertAlmostEqual(checked.shell_volumes[0] / (4 / 3 * surfaces.np.pi * 6), 1, 1)


if __name__ == "__main__":
    unittest.main()
