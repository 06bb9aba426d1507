# SPDX-License-Identifier: GPL-3.0-or-later
"""Testing/Benchmark/write-targets.py enters what benchmarks print in a table, and loses nothing of it."""

import csv
import datetime
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent.parent / "Benchmark" / "write-targets.py"
HEADER = "target,reached,missed,date,remark\n"
PRINTED = """man   stage 1.0 s   reference 2.0 s
ratio total/Beast 1.310 at most 1
ratio threads/whole 1.600 at least 1.5
"""


class TestTargets(unittest.TestCase):
    def run_on(self, table: str, lines: str) -> tuple[list[dict[str, str]], subprocess.CompletedProcess]:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "targets.csv")
            path.write_text(table)
            done = subprocess.run([sys.executable, SCRIPT, path], input=lines, capture_output=True, text=True)
            return list(csv.DictReader(path.read_text().splitlines())), done

    def test_measured_targets_are_entered_and_lines_pass_on(self):
        lines = PRINTED + "All is measured.\n"
        rows, done = self.run_on(HEADER, lines)
        today = datetime.date.today().isoformat()
        self.assertEqual((done.stdout, done.returncode), (lines, 0), done.stderr)
        expected = [("total/Beast at most 1", "1.310", "missed", today, ""), ("threads/whole at least 1.5", "1.600", "", today, "")]
        self.assertEqual([tuple(row.values()) for row in rows], expected)

    def test_other_rows_and_remarks_stay(self):
        table = HEADER + 'limit/median at most 3,2.87,,2026-11-28,\n' + 'total/Beast at most 1,1.09,missed,2026-11-28,"idle, cold"\n'
        rows, _ = self.run_on(table, PRINTED)
        self.assertEqual([row["target"].split()[0] for row in rows], ["limit/median", "total/Beast", "threads/whole"])
        self.assertEqual([row["reached"] for row in rows], ["2.87", "1.310", "1.600"])
        self.assertEqual(rows[1]["remark"], "idle, cold")

    def test_a_run_that_stopped_is_told(self):
        self.assertEqual(self.run_on(HEADER, PRINTED)[1].returncode, 1)

    def test_the_table_that_is_there_can_be_continued(self):
        given = SCRIPT.with_name("targets.csv").read_text()
        rows, done = self.run_on(given, "All is measured.\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(rows, list(csv.DictReader(given.splitlines())))
        self.assertEqual(list(rows[0]), HEADER.strip().split(","))


if __name__ == "__main__":
    unittest.main()
