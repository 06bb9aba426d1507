# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the options of the classes for the package: the headers' declarations, and the signatures of functions.

    write-options.py declared FILTERS declared.py
    write-options.py signatures OPTIONS.py IN.py OUT.py

FILTERS is the folder of the headers. In IN.py a comment "# All fields of CLASS." among the parameters of a function
is replaced by the fields of this class of OPTIONS.py. These include the fields of its base classes, with their types
and defaults.
"""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path
from typing import Iterator

CLASSES = ("vtkGeneralizedWindingNumber", "vtkGraphCutSegmentation", "vtkRefineTetrahedra", "vtkRobustTetrahedralize", "vtkBoundaryLayers")
"""The facade, before it the stages that it hands out, and behind it what its solid goes through: of two that declare an option the first one
tells it."""

DECLARED = '''\
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the headers of the classes declare of the options. Written by the build."""

from typing import Dict, NamedTuple, Optional, Tuple


class Declared(NamedTuple):
    vtk_property: str
    kind: str
    least: Optional[float]
    most: Optional[float]
    choices: Tuple[str, ...]
    """By the values of their constants, from 0."""
    words: str


'''


def declared(filters: Path) -> str:
    """The module with all options by their names in Python: ConstrainedFacetsArrayName is constrained_facets_array."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(filters / "CMake"))
    from declared_options import options_of

    options: dict[str, tuple[object, ...]] = {}
    constants: dict[str, str] = {}
    for one in (option for name in CLASSES for option in options_of(filters / f"{name}.h").values()):
        choices = one.choices()
        constants.update({constant: choices[value] for constant, value in one.constants.items()})
        limits = [None if limit is None else float(limit) for limit in (one.least, one.most)]
        named = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", one.name.removesuffix("Name")).lower()
        options.setdefault(named, (one.name, one.kind, *limits, tuple(choices[value] for value in sorted(choices)), one.brief))
    rows = "".join(f"    {name!r}: Declared{values!r},\n" for name, values in options.items())
    return f"{DECLARED}DECLARED: Dict[str, Declared] = {{\n{rows}}}\n\nCONSTANTS: Dict[str, str] = {constants!r}\n"


def with_signatures(options: Path, source: Path) -> str:
    text = options.read_text(encoding="utf-8")
    classes = {one.name: one for one in ast.parse(text).body if isinstance(one, ast.ClassDef)}

    def fields(name: str) -> Iterator[str]:
        for base in classes[name].bases:
            if isinstance(base, ast.Name) and base.id in classes:
                yield from fields(base.id)
        for one in classes[name].body:
            if isinstance(one, ast.AnnAssign) and one.value is not None:
                yield ast.unparse(one).replace("'", '"')

    def parameters(found: re.Match[str]) -> str:
        return "\n".join(f"{found[1]}{one}," for one in fields(found[2]))

    return re.sub(r"^( +)# All fields of (\w+)\.$", parameters, source.read_text(encoding="utf-8"), flags=re.MULTILINE)


if __name__ == "__main__":
    what, *paths, target = sys.argv[1:]
    write = {"declared": declared, "signatures": with_signatures}[what]
    Path(target).write_text(write(*map(Path, paths)), encoding="utf-8")
