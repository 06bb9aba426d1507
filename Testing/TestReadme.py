# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every block of code on README.md and the pages beside the code as printed, twice in the same folder, and compares its
output with the page's.

    python3 TestReadme.py BUILD_FOLDER [PAGE...]

A page's blocks of `sh` run in one shell, in a folder that has `build`, `Examples` and `Testing`, as a clone has; its blocks of
`python` in one program, where the shell ended; those that import paraview.simple in pvbatch; the `cpp` in a program that is built with
the lines of `cmake` beside it, against the package as installed. A block of `output` is what the block before it prints on standard
output: `...` alone in a line stands for any lines, and MASKS say which figures may differ. A block of ```sh untested: REASON does not
run; REASONS are few.
"""

import csv
import difflib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import NamedTuple

BUILD = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parent.parent

DECISIONS = "Filters/Decisions.md"
MESSAGES = "Filters/messages.csv"
PAGES = (
    *("README.md", "Filters/Python/README.md", "Plugin/README.md", DECISIONS, "Filters/README.md", "Examples/README.md"),
    "Filters/CMake/README.md",
)
LARGEST = 8192  # bytes of the first

REASONS = ("installs packages", "opens a window", "takes minutes")
MOST_UNTESTED = 8

MASKS = (
    (r"\b\d[\d,]*(\.\d+)? s\b", "# s"),  # seconds depend on the machine
    (r"\b\d[\d,]* MiB\b", "# MiB"),  # and so does memory
)

ENVIRONMENT = f". '{BUILD}/env.sh'\n"
MARK = "@@ block"

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


class Block(NamedTuple):
    language: str
    reason: str  # why it is not tested; empty for those that are
    code: str


def blocks_of(page: str) -> list[Block]:
    text = (ROOT / page).read_text(encoding="utf-8")
    return [Block(*found) for found in re.findall(r"^```(\w*)(?: untested: ([^\n]*))?\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)]


def tested(page: str, language: str) -> list[tuple[str, str | None]]:
    """The blocks of a language that run, each with what it is to print, where the page says so."""
    blocks = blocks_of(page)
    following = [*blocks[1:], Block("", "", "")]
    return [
        (block.code, after.code if after.language == "output" else None)
        for block, after in zip(blocks, following)
        if block.language == language and not block.reason
    ]


def masked(text: str) -> list[str]:
    for pattern, mask in MASKS:
        text = re.sub(pattern, mask, text)
    return [line.rstrip() for line in text.strip("\n").split("\n")]


def are_alike(expected: list[str], printed: list[str]) -> bool:
    """Whether the lines are the same, `...` standing for any."""
    if not expected:
        return not printed
    if expected[0] == "...":
        return any(are_alike(expected[1:], printed[k:]) for k in range(len(printed) + 1))
    return bool(printed) and expected[0] == printed[0] and are_alike(expected[1:], printed[1:])


class TestPages(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in ("Examples", "Testing"):
            (self.folder / name).symlink_to(ROOT / name)
        (self.folder / "build").symlink_to(BUILD)

    def run_shell(self, script: str, folder: Path | None = None) -> str:
        """What it prints on standard output."""
        done = subprocess.run(["sh", "-eu", "-c", script], cwd=folder or self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, f"{done.stdout}\n{done.stderr}\n{script}")
        self.assertNotIn("Traceback", done.stdout + done.stderr)
        return done.stdout

    def check_printed(self, page: str, output: str, blocks: list[tuple[str, str | None]]) -> None:
        parts = re.split(rf"^{MARK} \d+\n", output, flags=re.MULTILINE)[1:]
        self.assertEqual(len(parts), len(blocks))
        for (code, expected), printed in zip(blocks, parts):
            if expected is not None and not are_alike(masked(expected), masked(printed)):
                difference = "\n".join(difflib.unified_diff(masked(expected), masked(printed), "page", "printed", lineterm=""))
                self.fail(f"{page}:\n{code}\n{difference}")

    def run_page(self, page: str) -> None:
        """Its shell, then its Python where the shell ended."""
        shell, python = tested(page, "sh"), tested(page, "python")
        script = "".join(f"echo '{MARK} {k}'\n{code}" for k, (code, _) in enumerate(shell))
        output = self.run_shell(f"{script}pwd > '{self.folder}/where'\n")
        self.check_printed(page, output, shell)
        where = Path((self.folder / "where").read_text(encoding="utf-8").strip())
        program = [block for block in python if "paraview.simple" not in block[0]]
        if program:
            text = "".join(f"print('{MARK} {k}')\n{code}\n" for k, (code, _) in enumerate(program))
            (self.folder / "program.py").write_text(text, encoding="utf-8")
            self.check_printed(page, self.run_shell(f"{ENVIRONMENT}python3 '{self.folder}/program.py'", where), program)
        for code, _ in (block for block in python if block not in program):
            (self.folder / "batch.py").write_text(code, encoding="utf-8")
            self.run_shell(f"{ENVIRONMENT}pvbatch --force-offscreen-rendering '{self.folder}/batch.py'", where)

    def test_every_block_runs_twice_and_prints_what_the_page_says(self):
        for page in sys.argv[2:] or PAGES:
            with self.subTest(page):
                self.setUp()
                for _ in range(2):
                    self.run_page(page)

    def test_blocks_are_of_a_known_kind_and_few_do_not_run(self):
        untested = []
        for page in PAGES:
            blocks = blocks_of(page)
            self.assertGreaterEqual(len(blocks), 1, page)
            self.assertIn("sh", [block.language for block in blocks[:1]], f"{page} begins with a task")
            for before, block in zip([Block("", "", ""), *blocks], blocks):
                self.assertIn(block.language, ("sh", "python", "cpp", "cmake", "output"), block.code)
                if block.language == "output":
                    self.assertIn(before.language, ("sh", "python"), block.code)
                if block.reason:
                    self.assertIn(block.reason, REASONS, block.code)
                    untested.append((page, block.code))
        self.assertLessEqual(len(untested), MOST_UNTESTED, untested)

    def test_the_first_page_is_short(self):
        self.assertLessEqual((ROOT / PAGES[0]).stat().st_size, LARGEST)

    def test_the_commands_in_its_table_are_those_that_the_demo_prints(self):
        """Which another test runs, twice too."""
        printed = self.run_shell(f"{ENVIRONMENT}insideout demo\n")
        text = (ROOT / PAGES[0]).read_text(encoding="utf-8")
        commands = re.findall(r"^\| .* \| `((?:insideout|ccx) [^`]+)`", text, re.MULTILINE)
        self.assertEqual(len(commands), 7)
        for command in commands:
            self.assertRegex(printed, rf"(?m)^{re.escape(command)} +#")

    def test_outputs_are_alike_but_for_omitted_lines_and_masked_figures(self):
        for expected, printed, alike in (
            ("a\n...\nd", "a\nb\nc\nd", True),
            ("a\n...\nd", "a\nd", True),
            ("a\n...\nd", "a\nb\nc", False),
            ("a\nb", "a\nb\nc", False),
            ("Time 0.04 s, peak memory 96 MiB", "Time 12.5 s, peak memory 1,024 MiB", True),
            ("volume 1.5", "volume 1.6", False),
        ):
            self.assertEqual(are_alike(masked(expected), masked(printed)), alike, (expected, printed))

    def test_the_batch_script_says_that_its_folder_is_missing(self):
        shutil.copy(ROOT / "Testing/Data/two-boxes.off", self.folder / "boxes.off")
        for mpirun in ("", "mpirun --allow-run-as-root --oversubscribe -np 2 "):
            said = self.run_shell(
                f"{ENVIRONMENT}status=0\n"
                f"{mpirun}pvbatch '{ROOT}/Examples/ParaView/batch.py' boxes.off missing 2>&1 || status=$?\necho status $status\n"
            )
            self.assertIn("missing is not a folder that exists\n", said)
            self.assertIn("status 1\n", said)
            self.assertNotIn("tetrahedra", said)
            self.assertFalse((self.folder / "missing").exists())

    def test_the_cpp_block(self):
        page = "Filters/README.md"
        ((cpp, _),), ((cmake, _),) = tested(page, "cpp"), tested(page, "cmake")
        source = self.folder / "source"
        source.mkdir()
        (source / "tetrahedralize.cxx").write_text(CPP.format(block=cpp), encoding="utf-8")
        package, link = cmake.strip().split("\n")
        lines = ["cmake_minimum_required(VERSION 3.18)", "project(Readme C CXX)", package]
        lines += ["add_executable(tetrahedralize tetrahedralize.cxx)", link]
        (source / "CMakeLists.txt").write_text("\n".join(lines), encoding="utf-8")
        self.run_shell(
            f"{ENVIRONMENT}insideout demo >/dev/null; cd demo\n"
            f"cmake --install '{BUILD}' --prefix prefix >/dev/null\n"
            "cmake -S ../source -B made -G Ninja -DCMAKE_PREFIX_PATH=$PWD/prefix\ncmake --build made\nmade/tetrahedralize\n"
        )

    def test_the_messages_explained_are_in_the_code(self):
        with open(ROOT / MESSAGES, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertTrue(all(row["why"] for row in rows))
        messages = [words for row in rows for words in row["words of the message"].split(" | ")]
        sources = [file.read_text(encoding="utf-8") for file in (ROOT / "Filters").rglob("*") if file.suffix in (".cxx", ".py")]
        code = re.sub(r'"\s*\n\s*"', "", "\n".join(sources))  # strings that go on in the next line
        self.assertGreater(len(messages), 30)
        self.assertEqual([message for message in messages if message not in code], [])

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
