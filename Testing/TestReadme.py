# SPDX-License-Identifier: GPL-3.0-or-later
"""Every block of code on the first page and on the pages beside the code runs as it stands there.

    python3 TestReadme.py BUILD_FOLDER

The first page runs in an empty folder, with the surfaces of the demo that it writes, and each line of its blocks of output is
printed. The other pages run in a folder with broken surfaces. Blocks of sh run one after the other, those of Python one after the
other in one program, those of ParaView in pvbatch; the C++ is built with the CMake lines beside it, against the package as installed.
"""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parent.parent

# What a test cannot do: these install packages or open a window. Other tests do what they do.
LEFT_OUT = ("Examples/quickstart.sh", "Testing/run.sh", "apt-get install", "paraview\n", ". build/env.sh\n")
PAGES = ("Filters/Python/README.md", "Plugin/README.md", "Filters/README.md", "Filters/CMake/README.md")
MOST_BYTES = 8192  # of the first page
ENVIRONMENT = f". '{BUILD}/env.sh'\n"

CPP = """#include <vtkNew.h>
#include <vtkRobustTetrahedralize.h>
#include <vtkSurfaceReader.h>
#include <vtkUnstructuredGrid.h>
int main()
{{
{block}
return tetrahedra->GetNumberOfCells() > 0 ? 0 : 1;
}}
"""


def blocks(language: str, pages: tuple[str, ...] = PAGES) -> list[str]:
    text = "\n".join((ROOT / page).read_text(encoding="utf-8") for page in pages)
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def is_run(block: str) -> bool:
    return not any(words in block for words in LEFT_OUT)


class TestReadme(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.run_shell(
            f"{ENVIRONMENT}python3 - <<'END'\n"
            "from insideout.files import read_surface, write_surface\n"
            f"surface, _ = read_surface('{ROOT}/Testing/Data/two-boxes.off')\n"
            "for name in ('broken.ply', 'mine.ply'):\n    write_surface(surface, name)\n"
            "open('places.csv', 'w').write('x,y,z\\n0.7,0.7,0.5\\n')\nEND\n"
        )

    def run_shell(self, script: str) -> str:
        done = subprocess.run(
            ["sh", "-eu", "-c", script], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 0, f"{script}\n{done.stdout}")
        self.assertNotIn("Traceback", done.stdout)
        return done.stdout

    def test_the_shell_blocks(self):
        ran = 0
        (self.folder / "Examples").symlink_to(ROOT / "Examples")
        (self.folder / "build").symlink_to(BUILD)
        for block in blocks("sh"):
            if not is_run(block):
                continue
            with self.subTest(block):
                self.run_shell(ENVIRONMENT + block.replace("/where/you/like", str(self.folder / "prefix")))
                ran += 1
        self.assertGreaterEqual(ran, 5)
        for name in ("solid.vtu", "boundary.ply", "solids/mine.png", "w.csv", "results/solid.pvtu", "finer.msh", "rings.dat"):
            self.assertTrue((self.folder / name).exists(), name)

    def test_the_first_page_is_short_and_its_blocks_print_what_it_says(self):
        page = ROOT / "README.md"
        self.assertLessEqual(page.stat().st_size, MOST_BYTES)
        empty = self.folder / "empty"
        empty.mkdir()
        commands = "".join(block for block in blocks("sh", ("README.md",)) if is_run(block))
        program = "\n".join(blocks("python", ("README.md",)))
        printed = self.run_shell(f"{ENVIRONMENT}cd empty\n{commands}python3 - <<'END'\n{program}\nEND\n").splitlines()
        told = [line for block in blocks("output", ("README.md",)) for line in block.splitlines()]
        self.assertGreaterEqual(len(told), 10)
        for line in told:
            self.assertIn(line, printed)
        for command in re.findall(r"`(insideout (?:mesh|repair|boolean) [^`]+)`", page.read_text(encoding="utf-8")):
            self.run_shell(f"{ENVIRONMENT}cd empty/tryout\n{command}\n{command}\n")

    def test_the_python_blocks(self):
        program, batch = [], []
        for block in blocks("python"):
            (batch if "paraview.simple" in block else program).append(block)
        self.assertGreaterEqual(len(program), 5)
        self.assertEqual(len(batch), 1)
        for name, runner, code in (("program.py", "python3", program), ("batch.py", "pvbatch --force-offscreen-rendering", batch)):
            (self.folder / name).write_text("\n".join(code), encoding="utf-8")
            self.run_shell(f"{ENVIRONMENT}{runner} {name}")
        for name in ("boundary.stl", "solid.vtu", "boundary.vtp", "solid.msh", "solid.inp"):
            self.assertTrue((self.folder / name).exists(), name)

    def test_the_batch_script_says_that_its_folder_is_missing(self):
        for mpirun in ("", "mpirun --allow-run-as-root --oversubscribe -np 2 "):
            said = self.run_shell(
                f"{ENVIRONMENT}status=0\n"
                f"{mpirun}pvbatch '{ROOT}/Examples/ParaView/batch.py' broken.ply missing || status=$?\necho status $status\n"
            )
            self.assertIn("missing is not a folder that exists\n", said)
            self.assertIn("status 1\n", said)
            self.assertNotIn("tetrahedra", said)
            self.assertFalse((self.folder / "missing").exists())

    def test_the_cpp_block(self):
        (cpp,), (cmake,) = blocks("cpp"), blocks("cmake")
        source = self.folder / "source"
        source.mkdir()
        (source / "tetrahedralize.cxx").write_text(CPP.format(block=cpp), encoding="utf-8")
        package, link = cmake.strip().split("\n")
        lines = ["cmake_minimum_required(VERSION 3.18)", "project(Readme C CXX)", package]
        lines += ["add_executable(tetrahedralize tetrahedralize.cxx)", link]
        (source / "CMakeLists.txt").write_text("\n".join(lines), encoding="utf-8")
        self.run_shell(
            f"cmake --install '{BUILD}' --prefix prefix >/dev/null\n"
            "cmake -S source -B made -G Ninja -DCMAKE_PREFIX_PATH=$PWD/prefix\ncmake --build made\nmade/tetrahedralize\n"
        )

    def test_every_link_leads_somewhere(self):
        pages = [ROOT / name / "README.md" for name in (".", "Testing", "Testing/Benchmark", "Plugin", "Filters", "Filters/Python", "Filters/CMake")]
        for page in (*pages, *(ROOT / "Examples").rglob("README.md")):
            for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
                self.assertTrue((page.parent / link).exists(), f"{page}: {link}")

    def test_every_example_is_listed(self):
        """On the page of its folder, which the page of all links, or else on that itself."""
        examples = ROOT / "Examples"
        for file in examples.rglob("*"):
            if file.suffix in (".py", ".sh", ".cxx"):
                of_folder = file.parent / "README.md"
                page = of_folder if of_folder.exists() else examples / "README.md"
                self.assertIn(str(file.relative_to(page.parent)), page.read_text(encoding="utf-8"))
                if page.parent != examples:
                    link = str(page.relative_to(examples))
                    self.assertIn(f"]({link})", (examples / "README.md").read_text(encoding="utf-8"))


if __name__ == "__main__":
    if shutil.which("cmake") is None:
        sys.exit("cmake is not on PATH")
    unittest.main(argv=sys.argv[:1])
