# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the page of all options, by the headers of the classes.

    write-reference.py FILTERS OPTIONS.md
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.dont_write_bytecode = True

from declared_options import Declared, options_of

HEAD = """\
# Options of the classes

In Python and on the command line an option of `tetrahedralize` has its name in their manner: `SurfaceTolerance` is
`surface_tolerance` and `--surface-tolerance`; names of arrays lose their `Name`, as in `tag_array` and `--tag-array`.
"""


def values_of(option: Declared) -> str:
    """What an option can be."""
    if option.constants:
        return ", ".join(f"`{constant}`" for constant in option.constants)
    if option.least or option.most:
        return f"{option.kind}, {option.least or 'any'} to {option.most or 'infinity'}"
    return option.kind


def section(name: str, options: dict[str, Declared]) -> str:
    rows = [f"| `{option.name}` | {values_of(option)} | {option.words.replace('|', chr(92) + '|')} |" for option in options.values()]
    return "\n".join([f"## {name}", "", "| option | values | meaning |", "|---|---|---|", *rows, ""])


if __name__ == "__main__":
    filters, target = map(Path, sys.argv[1:])
    classes = {header.stem: options_of(header) for header in sorted(filters.glob("vtk*.h"))}
    target.write_text("\n".join([HEAD, *(section(name, options) for name, options in classes.items() if options)]), encoding="utf-8")
