# SPDX-License-Identifier: GPL-3.0-or-later
"""`--material`, `--fix`, `--pressure` and `--gravity`: an .inp file that CalculiX runs as it is."""

import re
import subprocess
import unittest
from pathlib import Path

import insideout
import numpy as np
from command import CommandLine, run_here
from insideout import demo
from insideout.deck import Deck

AREA_OF_CLAMP = 1080.0
"""In square millimeters, seen from where the load presses."""

STEEL, GRAVITY = 7850, 9.80665


class TestDeck(CommandLine):
    def setUp(self):
        super().setUp()
        self.bracket = self.file("bracket.obj", demo.bracket())
        self.solid = self.path("solid.inp")

    def mesh(self, *options: str):
        return run_here("mesh", self.bracket, self.solid, "--force", *options)

    def reaction(self, *options: str) -> np.ndarray:
        """The force in newtons that the clamp bears."""
        done = self.mesh("--fix", "clamp", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        ran = subprocess.run(["ccx", "solid"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertIn("Job finished", ran.stdout)
        self.assertNotIn("*ERROR", ran.stdout)
        lines = Path(self.folder, "solid.dat").read_text(encoding="ascii").split("\n")
        forces = next(line for line in lines if len(line.split()) == 3 and "total" not in line)
        return np.array(forces.split(), float)

    def test_pressure_and_reaction_are_in_equilibrium_in_any_unit(self):
        steel = ("--material", "steel")
        force = self.reaction(*steel, "--pressure", "load", "0.5")
        self.assertAlmostEqual(np.abs(force).max(), 0.5 * AREA_OF_CLAMP, delta=0.01)
        in_meters = self.reaction(*steel, "--from", "mm", "--to", "m", "--pressure", "load", "5e5")
        np.testing.assert_allclose(in_meters, force, atol=0.01)

    def borne_volume(self) -> float:
        """The volume that hangs on the clamp: a quarter of each cell for each corner that is not held."""
        text = Path(self.solid).read_text(encoding="ascii")
        held = re.search(r"^\*NSET, NSET=clamp\n([\d,\s]+)", text, re.MULTILINE)[1]
        is_held = np.zeros(len(insideout.read(self.solid).points), bool)
        is_held[np.array(re.findall(r"\d+", held), int) - 1] = True
        solid = insideout.read(self.solid)
        corners = solid.points[solid.cells]
        volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
        return float(volumes @ (~is_held[solid.cells]).sum(axis=1) / 4)

    def test_the_weight_is_that_of_the_volume(self):
        for options, meters in (([], 0.001), (["--from", "mm", "--to", "m"], 1)):
            x, y, z = self.reaction("--material", "steel", "--gravity", *options)
            self.assertAlmostEqual(z, STEEL * self.borne_volume() * meters**3 * GRAVITY, delta=1e-4)
            self.assertLess(abs(x) + abs(y), 1e-4)

    def test_tags_that_are_not_there_are_named_with_those_that_are(self):
        done = self.mesh("--material", "steel", "--fix", "clam")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"insideout: .*solid\.inp: there is no tag clam: the boundary has .*clamp.*load")
        self.assertFalse(Path(self.solid).exists())

    def test_a_tag_may_have_any_name(self):
        surface = self.path("walls.obj")
        Path(surface).write_text(Path(self.bracket).read_text(encoding="utf-8").replace("clamp", "Wände"), encoding="utf-8")
        done = run_here("mesh", surface, self.solid, "--material", "steel", "--fix", "Wände")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(Path(self.solid).read_text(encoding="utf-8"), r"\*BOUNDARY\nW\w+nde, 1, 3\n")

    def test_a_tag_goes_before_a_set_of_another_tag_with_its_name(self):
        deck = Deck("steel", ["A_b"], [], False)
        self.assertIn("*BOUNDARY\nA_b_2, 1, 3\n", deck.text_behind("** A_b: tag 1, A b\n** A_b_2: tag 2, A_b\n"))
        self.assertIn("*BOUNDARY\nA_b, 1, 3\n", deck.text_behind("** A_b: tag 1, A b\n"))
        with self.assertRaisesRegex(insideout.Error, "^2 tags are called A_b: give them different names$"):
            deck.text_behind("** A_b: tag 1, A_b\n** A_b_2: tag 2, A_b\n")

    def test_a_pressure_is_a_number(self):
        for value in ("much", "nan", "inf"):
            done = self.mesh("--material", "steel", "--fix", "clamp", "--pressure", "load", value)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"--pressure load is {value}; it must be a number", done.stderr)

    def test_the_file_is_read_as_the_mesh_that_it_is(self):
        self.assertEqual(self.mesh("--material", "aluminum", "--fix", "clamp").returncode, 0)
        found = insideout.check_solid(self.solid)
        self.assertEqual(found.warnings, [])
        self.assertEqual(found.statistics["RefusedCells"], 0)


if __name__ == "__main__":
    unittest.main()
