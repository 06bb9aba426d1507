# SPDX-License-Identifier: GPL-3.0-or-later
"""Type checkers accept every line that the documentation has, and refuse what cannot work."""

import os
import re
import shutil
import subprocess
import tempfile
import textwrap
import unittest
from importlib.util import find_spec
from pathlib import Path

import insideout

ROOT = Path(__file__).resolve().parents[2]

GOOD = """
import pathlib
import numpy as np
import insideout
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

class Mesh:
    vertices = np.zeros((3, 3))
    faces = np.zeros((1, 3), int)

insideout.check(pathlib.Path("broken.ply"), orientation="as-given")
insideout.check(vtkPolyData())
insideout.check(vtkSphereSource())
insideout.check(vtkSphereSource().GetOutputPort())
insideout.check(([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
insideout.check(Mesh())
meshed = insideout.tetrahedralize(Mesh(), engine="exact", data_term="volume-weighted", quadrature_order=3, gamma=1)
insideout.draw_quality(insideout.check_solid(meshed.solid), "angles.png")
insideout.check_solid("solid.vtu", progress=print).statistics["Cells"] + 1
insideout.check_solid((np.zeros((4, 3)), [(0, 1, 2, 3)])).histogram[35]
insideout.tetrahedralize(meshed.boundary, seeds=[((0, 0, 0), True)], constrained_facets_array="Chosen")
insideout.tetrahedralize(meshed.boundary, seeds="seeds.csv", progress=lambda stage, fraction: print(stage, fraction))
insideout.tetrahedralize(meshed.boundary.to_meshio())
insideout.winding_number(meshed.boundary, vtkImageData()).max()
refined = insideout.refine(meshed.solid, edge_length=0.1, sizes=np.ones(9), quadratic_cells=True)
insideout.refine(([(0, 0, 0)], [(0, 0, 0, 0)]), sizes="Size", background=vtkImageData()).solid.to_meshio()
insideout.tetrahedralize("broken.ply", refine=True, maximum_volume=0.1, grading=0.3).solid.cells[0, 9]
insideout.write(insideout.resolve(meshed.boundary, merge_tolerance=1e-6).surface, pathlib.Path("resolved.vtp"))
insideout.write(meshed, "solid.msh", msh_version="2.2")
insideout.write(meshed.solid, "solid.inp", boundary=meshed.boundary)
insideout.check("broken.stl", scale=0.001)
insideout.tetrahedralize(meshed.to_meshio(), scale=2)
print(meshed.boundary.tag_names[0])
print(meshed.regions[0].volume + 1, meshed.regions[0].center_of_mass[2], meshed.tags["inlet"].max())
insideout.tetrahedralize(meshed.boundary, tag_array="Part", tag_rules={"lid": "normal 0 0 1", "odd": lambda centers, normals: centers[:, 2] > 0})
grid = insideout.sdf_grid("broken.ply", shape=(64, 32, 32), to="surface", padding=0.1)
insideout.write(grid, "grid.nrrd")
print(grid.distance.max() + grid.origin[0], grid.inside.sum(), insideout.sdf_grid("broken.ply", spacing=0.1).png())
print(meshed.volume + meshed.solid.volume, meshed.is_watertight, len(meshed.solid.split()) + meshed.components)
print(meshed.statistics.groups["solid"]["Volume"] + 1, meshed.statistics.to_pandas())
print(insideout.inside(meshed.boundary, (0, 0, 0)), insideout.check("broken.ply").surface.triangles.shape)
meshed.plot()
print(meshed.hull.w[meshed.hull.inside], meshed.statistics["OpenEdges"] + 1, meshed.solid.cells[0, 3])
"""

BAD = """
insideout.tetrahedralize(3)
insideout.tetrahedralize(None)
insideout.tetrahedralize(object())
insideout.tetrahedralize("broken.ply", 1.0)
insideout.tetrahedralize("broken.ply", engine="foo")
insideout.tetrahedralize("broken.ply", orientation="sideways")
insideout.tetrahedralize("broken.ply", data_term="none")
insideout.tetrahedralize("broken.ply", quadrature_order=6)
insideout.tetrahedralize("broken.ply", gamma="much")
insideout.tetrahedralize("broken.ply", seeds=[(0, 0, 0)])
insideout.tetrahedralize("broken.ply", progress=3)
insideout.tetrahedralize("broken.ply", gama=1)
insideout.tetrahedralize("broken.ply", tag_array=3)
insideout.tetrahedralize("broken.ply").tags[0]
insideout.tetrahedralize("broken.ply").solids
insideout.check(3)
insideout.check("broken.ply", orientation="up")
insideout.check("broken.ply").verdict + 1
insideout.check_solid(3)
insideout.check_solid(meshed.solid).verdict + 1
insideout.draw_quality(meshed.solid)
insideout.resolve([1, 2])
insideout.resolve("broken.ply", orientation="automatic")
insideout.winding_number("broken.ply")
insideout.winding_number(3, [(0, 0, 0)])
insideout.inside("broken.ply", [(0, 0, 0)], orientation="foo")
insideout.inside("broken.ply", [(0, 0, 0)], threshold="half")
insideout.sdf_grid("broken.ply", 32)
insideout.sdf_grid("broken.ply", shape=32, to="walls")
insideout.sdf_grid("broken.ply", shape="large")
insideout.sdf_grid("broken.ply", spacing=1).distances
insideout.refine(3)
insideout.refine(insideout.tetrahedralize("broken.ply").solid, grading="short")
insideout.refine(insideout.tetrahedralize("broken.ply").solid, 0.1)
insideout.draw(3, None, "picture.png")
insideout.write(3, 4)
insideout.write(insideout.tetrahedralize("broken.ply"), "solid.msh", msh_version="3")
insideout.tetrahedralize("broken.ply", scale="mm")
"""


def documented() -> str:
    """The Python of the pages and of the package's help, in a row."""
    text = "\n".join((ROOT / page).read_text(encoding="utf-8") for page in ("README.md", "Filters/Python/README.md"))
    blocks = [block for block in re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL) if "paraview" not in block]
    help_blocks = re.findall(r"::\n\n((?:(?: {4}.*)?\n)+)", insideout.__doc__)
    assert len(blocks) >= 5 and len(help_blocks) >= 4
    functions = [f"def help_{k}() -> None:\n{textwrap.indent(preamble(k) + textwrap.dedent(block), '    ')}" for k, block in enumerate(help_blocks)]
    return "\n".join([*blocks, *functions])


def preamble(block: int) -> str:
    """What the help's blocks take for granted."""
    return "import insideout\nimport numpy as np\npoints = np.zeros((1, 3))\n"


@unittest.skipIf(shutil.which("mypy") is None, "mypy is not installed")
@unittest.skipUnless(find_spec("vtkmodules.generate_pyi"), "up to VTK 9.1 nothing tells the types of wrapped classes")
class Types(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        """What mypy has found out of NumPy and of the package, for all tests."""
        cache = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cache.cleanup)
        cls.cache = cache.name

    def refused_lines(self, program: str) -> dict[int, str]:
        """What mypy says, by line."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = os.path.join(folder.name, "program.py")
        with open(file, "w", encoding="utf-8") as opened:
            opened.write(program)
        done = subprocess.run(
            ["mypy", "--cache-dir", self.cache, "--ignore-missing-imports", "--check-untyped-defs", file],
            capture_output=True,
            text=True,
            check=False,
            env={**os.environ, "MYPYPATH": str(Path(insideout.__file__).parents[1])},
        )
        self.assertIn(done.returncode, (0, 1), done.stdout + done.stderr)
        self.assertRegex(done.stdout, "Success|Found")
        found = re.findall(r"program\.py:(\d+): error: (.*)", done.stdout)
        return {int(line): words for line, words in found}

    def test_documented_calls_are_accepted(self):
        program = documented()
        lines = program.splitlines()
        self.assertEqual({lines[line - 1]: words for line, words in self.refused_lines(program).items()}, {})

    def test_working_calls_are_accepted(self):
        self.assertEqual(self.refused_lines(GOOD), {})

    def test_calls_that_cannot_work_are_refused_line_by_line(self):
        lines = BAD.strip().splitlines()
        refused = self.refused_lines("import insideout\n" + "\n".join(lines))
        self.assertEqual([line for number, line in enumerate(lines, 2) if number not in refused], [])


if __name__ == "__main__":
    unittest.main()
