# SPDX-License-Identifier: GPL-3.0-or-later
"""Run `python3 -m insideout`, in a folder for each test."""

import contextlib
import io
import os
import re
import subprocess
import sys
import tempfile
import unittest

import insideout
import insideout.command_line
from insideout.files import write_surface
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


USAGE_ERRORS = r"\(see .*--help\)$|: unknown ending, it must be|named twice|; it must be |the boundary is lines|such a file has tetrahedra here"
"""The error message for senseless arguments, whatever the files contain."""


def run(*arguments: str, **options) -> subprocess.CompletedProcess:
    """As a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "insideout", *arguments], capture_output=True, text=True, check=False, **options
    )


def run_here(*arguments: str) -> subprocess.CompletedProcess:
    """The same in this process, which takes less time."""
    with contextlib.redirect_stdout(io.StringIO()) as output, contextlib.redirect_stderr(io.StringIO()) as errors:
        try:
            status = insideout.command_line.main(arguments)
        except SystemExit as end:
            status = end.code or 0
    return subprocess.CompletedProcess(arguments, status, output.getvalue(), errors.getvalue())


def read_grid(path: str):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    insideout.pipeline.run(reader)
    return reader.GetOutput()


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.output = self.path("solid.vtu")

    def path(self, name: str) -> str:
        return os.path.join(self.folder, name)

    def file(self, name: str, content) -> str:
        """Write a file: text, bytes, or a surface in the format of the name's ending."""
        if isinstance(content, (str, bytes)):
            with open(self.path(name), "wb") as file:
                file.write(content.encode() if isinstance(content, str) else content)
        else:
            write_surface(content, self.path(name))
        return self.path(name)

    def check_failure(self, done: subprocess.CompletedProcess, *expected: str):
        """One line that says what, no traceback, no file; and status 2 where the arguments make no sense, else 1."""
        self.assertEqual(done.returncode, 2 if re.search(USAGE_ERRORS, done.stderr) else 1, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertNotIn("ERR|", done.stderr)
        errors = [line for line in done.stderr.splitlines() if line.startswith("insideout: ")]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertEqual(done.stderr.splitlines()[-1], errors[0])
        for text in expected:
            self.assertIn(text, errors[0])
        self.assertFalse(os.path.exists(self.output))
