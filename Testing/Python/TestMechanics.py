# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples in Examples/Mechanics, at small sizes: CalculiX takes the meshes, and its answers are what theory says."""

import importlib.util
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import insideout
import numpy as np
from insideout import demo
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "Examples" / "Mechanics"
NUMBER = r"([-+]?[\d,]*\.?\d+(?:e[-+]?\d+)?)"


class TestMechanics(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_example(self, name: str, *arguments: str) -> str:
        done = subprocess.run(
            [sys.executable, EXAMPLES / name, self.folder, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def numbers(self, pattern: str, text: str) -> list[float]:
        found = re.search(pattern.replace("#", NUMBER), text)
        self.assertIsNotNone(found, f"{pattern} is not in\n{text}")
        return [float(number.replace(",", "")) for number in found.groups()]

    def test_the_clamp_of_a_dirty_bracket_carries_the_load_on_its_boss(self):
        said = self.run_example("bracket.py", "8")
        load, reaction, apart = self.numbers("load # N downward, reaction # N: #", said)
        self.assertLess(abs(apart), 1e-6)
        self.assertAlmostEqual(load, reaction, delta=1e-5 * load)
        (holes,) = self.numbers("closed by hand #", said)
        self.assertLess(abs(holes), 1e-3)

    @unittest.skipIf(importlib.util.find_spec("dolfinx") is None, "python3-dolfinx-real is not installed")
    def test_fenics_bends_a_beam_by_its_tags(self):
        (share,) = self.numbers("goes down [0-9.]+, # of theory", self.run_example("beam.py", "0.5"))
        self.assertAlmostEqual(share, 1, delta=0.01)

    def test_the_results_on_a_bracket_are_read_back_as_a_grid(self):
        self.run_example("bracket.py", "8")
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.folder / "bracket.vtu"))
        reader.Update()
        solved = reader.GetOutput()
        self.assertEqual(insideout.check_solid(solved).statistics["NegativeCells"], 0)
        points = vtk_to_numpy(solved.GetPoints().GetData())
        moved, mises = (vtk_to_numpy(solved.GetPointData().GetArray(name)) for name in ("Displacement", "MisesStress"))
        np.testing.assert_array_equal(moved[points[:, 0] == -6], 0)  # the bolts' ends
        self.assertEqual(np.argmin(moved[:, 2]), np.argmin(np.where(points[:, 0] > 80, moved[:, 2], 0)))  # the shelf's end
        self.assertGreater(mises.max(), 10)
        self.assertGreater((self.folder / "bracket.png").stat().st_size, 0)

    def test_the_demo_moves_as_far_as_on_a_finer_mesh_and_a_file_of_another_mesh_is_named(self):
        (self.folder / "steel.inp").write_text(demo.STEEL, encoding="utf-8")
        moved = []
        for edge in (8, 4):
            result = insideout.tetrahedralize(demo.bracket(), edge_length=edge, surface_treatment="split", quadratic_cells=True)
            insideout.write(result, self.folder / "bracket.inp")
            subprocess.run(["ccx", "steel"], cwd=self.folder, stdout=subprocess.DEVNULL, check=True)
            done = self.show_results("bracket.inp")
            moved.append(self.numbers("moves by # at most", done.stdout)[0])
            self.assertAlmostEqual(np.linalg.norm(insideout.read(self.folder / "steel.vtu").point_arrays["Displacement"], axis=1).max(), moved[-1], 3)
        self.assertAlmostEqual(moved[0] / moved[1], 1, 1)
        insideout.write(insideout.tetrahedralize(demo.bracket()), self.folder / "other.inp")
        self.assertRegex(self.show_results("other.inp").stderr, r"^calculix.py: steel.frd has DISP of \d+ points, and the grid has \d+\n$")

    def show_results(self, solid: str) -> subprocess.CompletedProcess:
        command = [sys.executable, EXAMPLES / "calculix.py", solid, "steel.frd", "steel.vtu"]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)

    def test_a_cantilever_of_boxes_that_overlap_bends_as_a_beam_does(self):
        said = self.run_example("cantilever.py", "0.8", "0.4", "0.2")
        of_theory = [float(line.split("|")[5]) for line in said.splitlines() if re.match(r"\| \d", line)]
        self.assertEqual(len(of_theory), 3)
        for ratio in of_theory:
            self.assertLess(abs(ratio - 1), 0.02)
        coarse, fine = np.diff(of_theory)
        self.assertGreater(coarse, 0)  # a mesh is stiffer than what it stands for
        self.assertLess(abs(fine), coarse / 3)

    def test_supports_of_a_figure_carry_its_weight(self):
        said = self.run_example("weight.py")
        weight, reaction, apart = self.numbers("weight # N, reaction # N: #", said)
        self.assertGreater(weight, 0)
        self.assertAlmostEqual(weight, reaction, delta=1e-6 * weight)
        self.assertLess(abs(apart), 1e-6)
        self.assertLess(self.numbers("across # of it", said)[0], 1e-6)


if __name__ == "__main__":
    unittest.main()
