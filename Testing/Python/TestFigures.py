# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts in Examples/Figures: what they say of the models is so, and they write their pictures."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TESTING = Path(__file__).resolve().parent.parent
FIGURES = TESTING.parent / "Examples" / "Figures"


class TestFigures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_figure(self, name: str, *arguments: str) -> str:
        done = subprocess.run(
            [sys.executable, FIGURES / name, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stdout)
        for picture in (argument for argument in arguments if argument.endswith(".png")):
            self.assertGreater((self.folder / picture).stat().st_size, 10000, picture)
        return done.stdout

    def test_each_task_has_a_small_picture(self):
        said = self.run_figure("tasks.py", ".")
        counts = {name: int(count) for name, count in re.findall(r"(\w+): (\d+) triangles", said)}
        self.assertLess(counts["remeshed"], counts["kept"])
        self.assertLess(counts["kept"], counts["split"])
        stored = sorted(FIGURES.glob("task-*.png"))
        self.assertEqual([picture.name for picture in sorted(self.folder.glob("*.png"))], [picture.name for picture in stored])
        for picture in stored:
            self.assertIn(picture.stat().st_size, range(5000, 40000), picture.name)

    def test_the_sheets_of_a_stirrer_are_outliers(self):
        said = self.run_figure("outliers.py", "outliers.png")
        found = re.search(r"stirrer.stl: (\d+) of (\d+) facets are outliers, (\d+) segmented as outside", said)
        outliers, facets, segmented = map(int, found.groups())
        self.assertGreater(outliers, 0.1 * facets)
        self.assertLess(outliers, facets)
        self.assertEqual(outliers, segmented)

    def test_torn_surface_holds_its_volume_until_w_falls_below_a_half(self):
        said = self.run_figure("torn_apart.py", "torn.png", "plot.png", "6")
        rows = re.findall(r"(\d+) degrees: (\d+) pairs cross, volume (\S+) %, energy (\S+)", said)
        self.assertEqual([row[0] for row in rows], ["0", "36", "72", "108", "144", "180"])
        self.assertLess(abs(float(rows[1][2])), 5)
        self.assertGreater(float(rows[1][3]), float(rows[0][3]))
        for row in rows[3:]:  # behind 75 degrees
            self.assertLess(float(row[2]), -95)

    def test_soups_hold_their_volume_to_a_quarter_and_repaired_ones_beyond(self):
        said = self.run_figure("soups.py", "soups.png", "3", "300")
        rows = [list(map(float, row.split())) for row in re.findall(r"% turned over(.*)", said)]
        self.assertEqual(len(rows), 3)  # none, a quarter, a half
        for row in rows:
            self.assertLess(abs(row[1]), 0.1)  # whole, and repaired
        self.assertLess(max(map(abs, rows[0])), 2)
        self.assertLess(max(rows[2][0], *rows[2][2:]), -90)

    def test_a_hand_within_a_chest_swings_out_when_overlaps_are_separated(self):
        said = self.run_figure("overlap.py", "overlap.png")
        separated, overlaps, copied = map(int, re.search(r"(\d+) of (\d+) overlaps separated, (\d+) cells copied", said).groups())
        self.assertEqual(separated, overlaps)
        self.assertGreater(copied, 50)
        turned = {name: int(count) for name, count in re.findall(r"(\w+): (\d+) of \d+ cells turned inside out", said)}
        self.assertLess(10 * turned["separated"], turned["glued"])

    def test_a_sheet_of_a_surface_of_ones_own(self):
        said = self.run_figure("contact_sheets.py", "sheets", str(TESTING / "Data" / "two-boxes.off"))
        self.assertIn("sheet-1.png", said)
        self.assertGreater((self.folder / "sheets" / "sheet-1.png").stat().st_size, 10000)


if __name__ == "__main__":
    unittest.main()
