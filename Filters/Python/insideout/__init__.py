# SPDX-License-Identifier: GPL-3.0-or-later
"""Tetrahedra of the solid that a broken triangle surface means.

One function for those who do not think in pipelines::

    import insideout
    result = insideout.tetrahedralize("broken.ply")
    print(result.solid.GetNumberOfCells(), "tetrahedra,", result.statistics["OpenEdges"], "open edges closed")

Another that says what is wrong with a surface, and whether it matters::

    print(insideout.check("broken.ply").verdict)

The VTK filters for those who do::

    from insideout import vtkSurfaceReader, vtkRobustTetrahedralize

And a command: ``python3 -m insideout broken.ply solid.vtu``.

Modules: `tetrahedralization` and `checking` have the functions, `pipeline` runs any VTK algorithm with its errors as
exceptions, `files` reads and writes, `command_line` is the command.
"""

# The wrapped classes derive from VTK's, which Python has to know first.
import vtkmodules.vtkCommonCore
import vtkmodules.vtkCommonDataModel
import vtkmodules.vtkCommonExecutionModel
import vtkmodules.vtkIOCore  # noqa: F401

from . import vtkFiltersInsideOut as _classes
from .checking import Check, Finding, check
from .pipeline import Error
from .tetrahedralization import Tetrahedralization, tetrahedralize
from .version import __version__

_class_names = [name for name in dir(_classes) if name.startswith("vtk")]
globals().update({name: getattr(_classes, name) for name in _class_names})

__all__ = [*_class_names, "Check", "Error", "Finding", "Tetrahedralization", "check", "tetrahedralize", "__version__"]
