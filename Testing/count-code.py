#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much code there is: lines without comments and blank ones of rooms, and the types that one has to know.

    python3 count-code.py [ROOM...]

Counts rooms of Filters/Core, all where none is named; types, those in .cxx files too, by Universal Ctags.
"""

import re
import subprocess
import sys
from pathlib import Path

CORE = Path(__file__).resolve().parent.parent / "Filters/Core"
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)


def lines_of(file: Path) -> int:
    """Lines that hold something else than a comment. No string of the algorithms holds the beginning of one."""
    return sum(1 for line in COMMENT.sub("", file.read_text(encoding="utf-8")).splitlines() if line.strip())


def types_in(files: list[Path]) -> int:
    """Classes, structs and enumerations, with those inside of others."""
    command = ["ctags", "--languages=C++", "--langmap=C++:.h.cxx", "--c++-kinds=csg", "-x", *map(str, files)]
    return len(subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines())


def main() -> None:
    rooms = sys.argv[1:] or sorted(folder.name for folder in CORE.iterdir() if folder.is_dir())
    total = [0, 0]
    for room in rooms:
        files = sorted(file for file in (CORE / room).rglob("*") if file.suffix in (".h", ".cxx"))
        if not files:
            sys.exit(f"{room} is no room of {CORE}")
        counts = sum(map(lines_of, files)), types_in(files)
        total = [sum(pair) for pair in zip(total, counts)]
        print(f"{room:16}{counts[0]:7} lines{counts[1]:5} types")
    print(f"{'together':16}{total[0]:7} lines{total[1]:5} types")


if __name__ == "__main__":
    main()
