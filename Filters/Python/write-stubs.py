# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the stub file of the wrapped classes, for type checkers and editors.

    write-stubs.py FOLDER

VTK's generator names classes of VTK's other modules without importing them, which this adds.
"""

import re
import sys
from importlib import import_module
from pathlib import Path

from vtkmodules import generate_pyi

MODULE = "vtkFiltersInsideOut"


def main(folder: str) -> None:
    del sys.path[0]  # the package's sources stand beside this file, and have no wrapped module
    generate_pyi.main(["generate_pyi", "-p", "insideout", "-o", folder, MODULE])
    stub = Path(folder, MODULE + ".pyi")
    text = stub.read_text(encoding="utf-8")
    # Those of the base classes; the controller's is of no base class.
    modules = [*re.findall(r"^import (vtkmodules\.\w+)$", text, re.MULTILINE), "vtkmodules.vtkParallelCore"]
    foreign = set(re.findall(r"'(vtk\w+)'", text)) - set(re.findall(r"^class (\w+)", text, re.MULTILINE))
    imports = [
        f"from {module} import {name}" for name in sorted(foreign) for module in modules if hasattr(import_module(module), name)
    ]
    stub.write_text("\n".join(["# SPDX-License-Identifier: GPL-3.0-or-later", *imports, text]), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
