# SPDX-License-Identifier: GPL-3.0-or-later
"""Notebooks among the examples run from their first cell to their last in a real kernel, and show what they are to show."""

import os
import tempfile
import unittest
from pathlib import Path

import nbformat
from nbclient import NotebookClient

NOTEBOOKS = Path(__file__).resolve().parents[2] / "Examples"


def run(notebook):
    """With what its cells put out, in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": folder}}).execute()
        written = sorted(os.listdir(folder))
    return written


def shown(notebook) -> list[dict]:
    """What cells put out, by type."""
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    return [output.get("data") or {"text": output.get("text", "")} for output in outputs]


class Notebooks(unittest.TestCase):
    def test_they_are_kept_without_outputs(self):
        files = list(NOTEBOOKS.rglob("*.ipynb"))
        self.assertTrue(files)
        for file in files:
            notebook = nbformat.read(file, as_version=4)
            nbformat.validate(notebook)
            for cell in notebook.cells:
                if cell.cell_type == "code":
                    self.assertEqual((cell.outputs, cell.execution_count), ([], None))

    def test_a_scan_becomes_a_solid(self):
        notebook = nbformat.read(NOTEBOOKS / "Python/scan.ipynb", as_version=4)
        written = run(notebook)
        self.assertEqual(written, ["distances.npz", "solid.msh"])
        found = shown(notebook)
        self.assertEqual(sum("image/png" in data for data in found), 2)
        tables = [data["text/html"] for data in found if "text/html" in data]
        self.assertEqual(sum("data:image/png;base64," in table for table in tables), 2)
        self.assertEqual(sum('class="dataframe"' in table for table in tables), 2)
        text = "".join(data.get("text", "") for data in found)
        self.assertRegex(text, r"volume \d\.\d+, [+-][01]\.\d\d % of the truth\nwatertight: True   parts: 1\n")
        self.assertRegex(text, r"Warning: \d+ facets? ")
        self.assertIn("array([ True,  True, False])", [data.get("text/plain") for data in found])


if __name__ == "__main__":
    unittest.main()
