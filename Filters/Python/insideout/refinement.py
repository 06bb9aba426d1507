# SPDX-License-Identifier: GPL-3.0-or-later
"""`refine`: better tetrahedra of the same solid."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Union

from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkUnstructuredGrid

from .calling import for_users
from .data import Tetrahedra, as_type
from .errors import Error, text_of
from .inputs import DataSetOfPoints, numbers
from .lengths import Length
from .options import REFINING_OPTIONS, Options, SizeRules, SurfaceTreatment, describe_options, in_words_of_python
from .pipeline import Progress, run, statistics_of
from .results import MeshResult, counted
from .serializing import vtk_array
from .solids import AnySolid, as_solid
from .statistics import Statistics
from .vtkFiltersInsideOut import vtkRefineTetrahedra

Sizes = Union[str, ArrayLike]

SIZES = "insideout.sizes"
"""The name of a caller's array of lengths."""


@dataclass(frozen=True, repr=False)
class Refinement(MeshResult):
    """The result of `refine`. The VTK class vtkRefineTetrahedra describes the arrays."""

    solid: Tetrahedra
    """Other tetrahedra of the same solid, with data of the original ones."""
    statistics: Statistics
    """Counts and seconds by name, including statistics of the input."""
    warnings: list[str]
    """Warnings, one line each."""

    def figures(self) -> list[tuple[str, str]]:
        return [
            ("tetrahedra", counted(self.solid.GetNumberOfCells())),
            ("points", counted(self.solid.GetNumberOfPoints())),
            *(("", warning) for warning in self.warnings),
        ]


@for_users
@describe_options
def refine(
    solid: AnySolid,
    *,
    # All fields of RefinementOptions.
    sizes: Optional[Sizes] = None,
    background: Optional[DataSetOfPoints] = None,
    progress: Optional[Progress] = None,
) -> Refinement:
    """Better tetrahedra of the same solid. Without a length each triangle of its boundary, and between regions, stays as it is.

    solid       any type of solid that `check_solid` accepts, of first order; the integer cell array RegionId
                distinguishes regions
    sizes       the edge length at each point of the solid, or the name of its point array of edge lengths
    background  a vtkDataSet with a point array of that name, too: lengths are interpolated between its points
    progress    called with the stage and the fraction of all the work that is done; an exception that it
                raises stops the work and is raised

    {options}

    Omitted options have the defaults of the class vtkRefineTetrahedra. Returns a `Refinement`. Raises `Error` with one
    line that names the culprit.
    """
    options = Options.among(locals())
    grid, warnings = as_solid(solid)
    found, more = refined(grid, options, progress, sizes, background)
    return Refinement(solid=as_type(Tetrahedra, found), statistics=statistics_of(found), warnings=warnings + more)


def refined(
    grid: vtkUnstructuredGrid,
    options: Options,
    progress: Optional[Progress] = None,
    sizes: Optional[Sizes] = None,
    background: Any = None,
) -> tuple[vtkUnstructuredGrid, list[str]]:
    """The refined grid, and warnings."""
    refiner = options.measured_on(grid).set_on(vtkRefineTetrahedra(), REFINING_OPTIONS)
    if isinstance(sizes, str):
        refiner.SetSizingArrayName(text_of("sizes", sizes))
    elif sizes is not None:
        grid = _with_sizes(grid, sizes)
        refiner.SetSizingArrayName(SIZES)
    if background is not None:
        if not isinstance(background, vtkDataSet):
            raise Error(f"background is of type {type(background).__name__}; it must be a vtkDataSet")
        if refiner.GetNumberOfInputConnections(1) > 0:
            raise Error("background is given, and so is one of size_rules: there can be one")
        if not isinstance(sizes, str):
            raise Error("sizes has to be the name of the background's point array of edge lengths")
        refiner.SetBackgroundData(background)
    refiner.SetInputData(grid)
    warnings = in_words_of_python(run(refiner, progress))
    output = refiner.GetOutput()
    if not isinstance(sizes, str):
        output.GetPointData().RemoveArray(SIZES)
    return output, warnings


def _with_sizes(grid: vtkUnstructuredGrid, sizes: Any) -> vtkUnstructuredGrid:
    """The grid with a caller's array of lengths."""
    lengths = numbers("sizes", sizes)
    if lengths.shape != (grid.GetNumberOfPoints(),):
        raise Error(f"sizes has the shape {lengths.shape}; it must have one value for each of {grid.GetNumberOfPoints()} points")
    array = vtk_array(lengths)
    array.SetName(SIZES)
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(grid)
    copy.GetPointData().AddArray(array)
    return copy
