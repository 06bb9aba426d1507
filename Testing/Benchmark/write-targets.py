# SPDX-License-Identifier: GPL-3.0-or-later
"""Pass the lines of benchmarks on, and enter the targets among them in a table.

    run.sh --lines SURFACE... | write-targets.py [TABLE]

TABLE is targets.csv beside this script. A line `ratio NAME VALUE at most|at least LIMIT` makes the row
of its target, or replaces the value, the verdict and the date there; a row's remark stays, and so do
rows of targets that were not measured. The exit status is 1 unless the last line is run.sh's.
"""

import csv
import datetime
import re
import sys
from pathlib import Path

COLUMNS = ("target", "reached", "missed", "date", "remark")
LINE = re.compile(r"ratio (\S+) (\S+) (at most|at least) (\S+)$")
LAST = "All is measured."


def read(table: Path) -> dict[str, dict[str, str]]:
    """The rows by target, in their order."""
    with table.open(encoding="utf-8", newline="") as file:
        return {row["target"]: row for row in csv.DictReader(file)}


def enter(line: str, rows: dict[str, dict[str, str]]) -> None:
    found = LINE.match(line)
    if found:
        name, value, bound, limit = found.groups()
        holds = float(value) <= float(limit) if bound == "at most" else float(value) >= float(limit)
        target = f"{name} {bound} {limit}"
        row = rows.setdefault(target, dict.fromkeys(COLUMNS, ""))
        today = datetime.date.today().isoformat()
        row.update(target=target, reached=value, missed="" if holds else "missed", date=today)


def write(table: Path, rows: dict[str, dict[str, str]]) -> None:
    with table.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows.values())


if __name__ == "__main__":
    table = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).with_name("targets.csv")
    rows = read(table)
    line = ""
    for line in map(str.rstrip, sys.stdin):
        print(line, flush=True)
        enter(line, rows)
    write(table, rows)
    sys.exit(0 if line == LAST else 1)
