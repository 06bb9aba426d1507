# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples in Examples/Applications: what they say of their dirty models holds, and each draws its picture."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "Examples" / "Applications"
NUMBER = r"([-+]?\d[\d,]*\.?\d*(?:e[-+]?\d+)?)"


class TestApplications(unittest.TestCase):
    def run_example(self, name: str, *arguments: str) -> str:
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder, "picture.png")
            done = subprocess.run(
                [sys.executable, EXAMPLES / name, picture, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                check=False,
            )
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertGreater(picture.stat().st_size, 10000)
        return done.stdout

    def numbers(self, pattern: str, text: str) -> list[float]:
        found = re.search(pattern.replace("#", NUMBER), text)
        self.assertIsNotNone(found, f"{pattern} is not in\n{text}")
        return [float(number.replace(",", "")) for number in found.groups()]

    def test_a_solid_texture_meets_the_surface_as_it_came(self):
        said = self.run_example("solid_texture.py")
        kept, all_of_them, beyond = self.numbers("# of # vertices are points of the solid, # only of facets beyond it", said)
        self.assertEqual(kept + beyond, all_of_them)
        self.assertGreater(kept, 0.99 * all_of_them)
        on_boundary, most, inside = self.numbers("depth # on the boundary, # at most, # points inside", said)
        self.assertEqual((on_boundary, most), (0, 1))
        self.assertGreater(inside, 1000)

    def test_bent_solid_keeps_more_of_its_volume_than_bent_surface(self):
        said = self.run_example("deformation.py")
        changes = []
        for way in ("In the volume", "On the surface alone"):
            missed, change = self.numbers(f"{way}: .* missed by #, volume # %", said)
            self.assertEqual(missed, 0)
            changes.append(abs(change))
        self.assertLess(changes[0], 0.5)
        self.assertLess(changes[0], changes[1] / 3)

    def test_skinning_weights_are_local_and_add_up_to_one_on_the_surface(self):
        said = self.run_example("skinning.py")
        kept, vertices = self.numbers("# of # vertices of the surface are points", said)
        least, apart = self.numbers("weights are # at least, and their sums less 1 # at most", said)
        self.assertGreater(kept, 0.8 * vertices)
        self.assertGreaterEqual(least, 0)
        self.assertLess(apart, 1e-9)
        for bone in ("left hand", "right shin", "head"):
            self.assertLess(self.numbers(f"{bone}: at most # on the far side", said)[0], 1e-6)

    def test_a_dirty_figure_hangs_together_under_gravity(self):
        said = self.run_example("sagging.py", "linear")
        (regions,) = self.numbers("The solid: # region", said)
        sinks, most = self.numbers("the hands sink by # m, nothing moves more than # m", said)
        self.assertEqual(regions, 1)
        self.assertGreater(sinks, 0.05)
        self.assertLess(most, 0.5)
        pieces, shared = self.numbers("# pieces; the trunk shares # points", said)
        self.assertEqual((pieces, shared), (14, 0))
        self.assertGreater(self.numbers("all have # %", said)[0], 101)


if __name__ == "__main__":
    unittest.main()
