# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary layers of a solid."""

from __future__ import annotations

from typing import Optional

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .options import LAYER_OPTIONS, Options, in_words_of_python
from .pipeline import Progress, run
from .vtkFiltersInsideOut import vtkBoundaryLayers


def layered(
    solid: vtkUnstructuredGrid, boundary: vtkPolyData, options: Options, progress: Optional[Progress] = None
) -> tuple[vtkUnstructuredGrid, vtkPolyData, list[str]]:
    """The solid with layers of prisms, in a plane of quads, at its walls, its boundary, and warnings."""
    maker = options.set_on(vtkBoundaryLayers(), LAYER_OPTIONS)
    maker.SetInputData(solid)
    maker.SetBoundaryData(boundary)
    warnings = in_words_of_python(run(maker, progress))
    return maker.GetOutput(), maker.GetBoundary(), warnings
