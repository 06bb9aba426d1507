# SPDX-License-Identifier: GPL-3.0-or-later
"""check-texts.py complains of each habit in pages, comments and docstrings, and of nothing else."""

import runpy
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent / "check-texts.py"
check = runpy.run_path(str(SCRIPT))["check"]

THIRTY = " ".join(["word"] * 30)
PAGE, HEADER, SOURCE = "Filters/Core/Upper/README.md", "Filters/Core/Upper/Tower.h", "Testing/Cxx/TestTower.cxx"
MODULE, SCRIPT_OF_SHELL, LISTS = "Filters/Python/tower.py", "Testing/tower.sh", "Filters/CMakeLists.txt"

KEPT = (
    "A tower of stones.",
    "Often many are so large that few remain.",
    "What is a tower?",
    "What stands, falls.",
    f"{THIRTY}.",
    f"{THIRTY}; {THIRTY}: {THIRTY}. {THIRTY.capitalize()}.",
    f"A row of `{THIRTY} {THIRTY}` and - = words.",
    f"- {THIRTY}\n- {THIRTY}",
    f"1. {THIRTY}\n2. {THIRTY}",
    f"| {THIRTY} | {THIRTY} |",
    f"# A title\n{THIRTY}",
    f"a  b {THIRTY} in columns\n{THIRTY}  {THIRTY}",
    f"[{THIRTY}](Of/so_many/{'x/' * 40})",
)
BROKEN = (
    ("Of stones it is made.", 'begins with "Of"'),
    ("It stands. (Of stones.)", 'begins with "Of"'),
    ("High; Of stones.", 'begins with "Of"'),
    ("What stands on it is a flag.", 'begins with "What ... is"'),
    ("- What they were\n  is dust.", 'begins with "What ... is"'),
    ("Stairs of so many steps.", 'says "so many"'),
    ("It is counted So often.", 'says "so many" or "so often"'),
    ("Names parted by commas.", 'says "parted by"'),
    ("A node amid the edge.", 'says "parted by" or "amid"'),
    ("The centre of a tower.", "is not in American spelling"),
    ("Coloured stones.", "is not in American spelling"),
    (f"{THIRTY} word.", "has 31 words: at most 30"),
    (f"{THIRTY}\nword `code`.", "has 32 words"),
    (f"| tower | {THIRTY} word |", "has 31 words"),
)


class TestTextRules(unittest.TestCase):
    def complaints(self, name: str, text: str) -> list[str]:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, name)
            file.parent.mkdir(parents=True)
            file.write_text(text, encoding="utf-8")
            return check(Path(folder))

    def documents(self, text: str) -> list[tuple[str, str, int]]:
        """The text on a page and in comments, with the line that it begins in."""
        lines = "\n".join(f" * {line}" for line in text.split("\n"))
        slashes, hashes = ("\n".join(f"{mark} {line}" for line in text.split("\n")) for mark in ("//", "#"))
        found = [
            (PAGE, f"{text}\n", 1),
            (HEADER, f"#pragma once\n/**\n{lines}\n */\nint Height();\n", 3),
            (SOURCE, f'#include "//"\n{slashes}\nint Height();\n', 2),
            (MODULE, f'def height():\n    r"""{text}\n    """\n    return 1\n', 2),
        ]
        if text.startswith("#"):
            return found
        found += [
            (MODULE, f"HEIGHT = 1\n{hashes}\nWIDTH = 1\n", 2),
            (SCRIPT_OF_SHELL, f"#!/bin/sh\n{hashes}\nexit 0\n", 2),
            (LISTS, f"{hashes}\n", 1),
        ]
        if "\n" in text or text.startswith(("|", "-")):
            return found
        found += [(HEADER, f"int Height; ///< {text}\n", 1), (SOURCE, f"int Height; // {text}\n", 1)]
        return [*found, (MODULE, f"HEIGHT = 1  # {text}\n", 1)]

    def test_texts_that_keep_the_rules_are_left_in_peace(self):
        for text in KEPT:
            for name, document, _ in self.documents(text):
                self.assertEqual(self.complaints(name, document), [])

    def test_each_habit_is_found_once_with_its_line(self):
        for text, words in BROKEN:
            for name, document, line in self.documents(text):
                complaints = self.complaints(name, document)
                self.assertEqual(len(complaints), 1, (document, complaints))
                self.assertTrue(complaints[0].startswith(f"{name}:{line}: a sentence {words}"), complaints[0])

    def test_the_line_is_that_of_the_paragraph(self):
        text = "```sh\n# Of nothing\n```\n\nA tower.\n\nOf stones.\n"
        self.assertTrue(self.complaints(PAGE, text)[0].startswith(f"{PAGE}:7: "))

    def test_the_script_prints_complaints_and_fails(self):
        for text, status in (("A tower.", 0), ("Of stones.", 1)):
            with tempfile.TemporaryDirectory() as folder:
                Path(folder, "README.md").write_text(text, encoding="utf-8")
                found = check(Path(folder))
                run = subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True, check=False)
            self.assertEqual((len(found), run.returncode, run.stdout.splitlines()), (status, status, found))

    def test_code_is_no_text(self):
        self.assertEqual(self.complaints(PAGE, f"```sh\nOf {THIRTY} word\n```\n"), [])
        quotes = f'const char* Words = "// Of {THIRTY} word"; char Quote = \'"\'; // A tower.\n'
        self.assertEqual(self.complaints(SOURCE, quotes), [])
        self.assertEqual(self.complaints(SOURCE, 'const char* Words = R"(// so many)";\n'), [])
        self.assertEqual(self.complaints(MODULE, f'"""A tower::\n\n    Of {THIRTY} word\n"""\nWORDS = "# so many"\n'), [])
        self.assertEqual(self.complaints("Filters/Core/Upper/tower.csv", "# so many\n"), [])


if __name__ == "__main__":
    unittest.main()
