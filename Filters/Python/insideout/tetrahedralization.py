# SPDX-License-Identifier: GPL-3.0-or-later
"""`tetrahedralize`: from a surface to its solid in one call."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Optional, Union

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkThreshold

from .files import read_surface
from .pipeline import Error, Progress, at_least, cells_of, run, statistics_of
from .vtkFiltersInsideOut import vtkRobustTetrahedralize

STAGES = (
    "validating",
    "finding self-intersections",
    "resolving self-intersections",
    "tetrahedralizing",
    "winding numbers",
    "segmenting",
)
"""What the filter does, in this order, with an equal share of its progress each."""

ORIENTATIONS = {
    "automatic": vtkRobustTetrahedralize.AUTOMATIC,
    "as given": vtkRobustTetrahedralize.AS_GIVEN,
    "reverse": vtkRobustTetrahedralize.REVERSE,
}

ENGINES = {
    "automatic": vtkRobustTetrahedralize.ENGINE_AUTOMATIC,
    "exact": vtkRobustTetrahedralize.ENGINE_EXACT,
    "tetgen": vtkRobustTetrahedralize.ENGINE_TETGEN,
}


@dataclass(frozen=True)
class Tetrahedralization:
    """What `tetrahedralize` found. The VTK class vtkRobustTetrahedralize describes the arrays."""

    solid: vtkUnstructuredGrid
    """The tetrahedra inside, with `w` per cell. Empty, with a warning, when nothing is inside."""
    boundary: vtkPolyData
    """The solid's boundary: watertight, oriented outward, with the input's attributes."""
    outliers: vtkPolyData
    """The pieces of input facets that are no face of a cell inside."""
    hull: vtkUnstructuredGrid
    """All tetrahedra of the convex hull, with `w` and `Inside` per cell."""
    statistics: dict[str, float]
    """Counts, the range of w, seconds per stage and peak memory in MiB, by name."""
    left_out_cells: list[int]
    """The cells of the surface whose facets could not be resolved, all or in part; hardly ever any."""
    lost_cells: list[int]
    """The cells of the surface that the mesh does not follow, all or in part; hardly ever any."""
    warnings: list[str]
    """What is worth knowing about the input, one line each."""


def tetrahedralize(
    surface: Union[vtkPolyData, str, os.PathLike],
    *,
    gamma: Optional[float] = None,
    sigma: Optional[float] = None,
    orientation: str = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    time_budget: Optional[float] = None,
    memory_budget: Optional[float] = None,
    engine: str = "automatic",
    progress: Optional[Progress] = None,
) -> Tetrahedralization:
    """Tetrahedra of the solid that a surface most likely means.

    surface           a vtkPolyData of polygons or strips, or a .ply, .obj, .off, .stl or .vtp file
    gamma             weight of a smooth boundary against the winding number, at least 0; 0 takes
                      every cell with w above 1/2
    sigma             how large a step of w between neighbouring cells may be noise, at least 1e-6
    orientation       "automatic" turns an inside-out surface over, with a warning; "as given"
                      never does, "reverse" always
    merge_tolerance   points at most this far apart become one, in units of the surface, at least 0
    count_duplicates  count a facet as often as it is given
    engine            what makes the tetrahedra: "tetgen", "exact" flips and cuts, or "automatic",
                      which is exact flips, and TetGen where they fail
    time_budget       seconds that tetrahedralizing may take, all tries together; 0 goes by the surface's size
    memory_budget     MiB that TetGen's process may hold; 0 goes by the surface's size
    progress          called with the stage and the fraction of all the work that is done; what it
                      raises stops the work and is raised

    What is not given has the default of the class vtkRobustTetrahedralize. Raises `Error` with one
    line that names what is wrong.
    """
    tetrahedralizer = make_filter(
        gamma, sigma, orientation, merge_tolerance, count_duplicates, time_budget, memory_budget, engine
    )
    warnings: list[str] = []
    if not isinstance(surface, (vtkPolyData, str, os.PathLike)):
        raise Error(f"the surface is a {type(surface).__name__}; it can be a vtkPolyData or a file's name")
    if not isinstance(surface, vtkPolyData):
        surface, warnings = read_surface(surface)
    tetrahedralizer.SetInputData(surface)
    tetrahedralizer.ExtractInsideOff()
    warnings = warnings + run(tetrahedralizer, progress)

    hull = tetrahedralizer.GetOutput()
    if hull.GetNumberOfCells() == 0:
        raise Error("the filter gave no cells and no reason")
    return Tetrahedralization(
        solid=_inside_cells(hull),
        boundary=tetrahedralizer.GetBoundary(),
        outliers=tetrahedralizer.GetOutliers(),
        hull=hull,
        statistics=statistics_of(hull),
        left_out_cells=cells_of(hull, "LeftOutCellIds"),
        lost_cells=cells_of(hull, "LostCellIds"),
        warnings=warnings,
    )


def make_filter(
    gamma: Optional[float] = None,
    sigma: Optional[float] = None,
    orientation: str = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    time_budget: Optional[float] = None,
    memory_budget: Optional[float] = None,
    engine: str = "automatic",
) -> vtkRobustTetrahedralize:
    """The filter with these parameters. VTK would clamp a bad one without a word: here it is an `Error`."""
    tetrahedralizer = vtkRobustTetrahedralize()
    if gamma is not None:
        tetrahedralizer.SetGamma(at_least(0, "gamma", gamma))
    if sigma is not None:
        tetrahedralizer.SetSigma(at_least(1e-6, "sigma", sigma))
    if merge_tolerance is not None:
        tetrahedralizer.SetMergeTolerance(at_least(0, "merge_tolerance", merge_tolerance))
    if orientation not in ORIENTATIONS:
        raise Error(f"orientation is {orientation!r}; it can be {', '.join(map(repr, ORIENTATIONS))}")
    if engine not in ENGINES:
        raise Error(f"engine is {engine!r}; it can be {', '.join(map(repr, ENGINES))}")
    tetrahedralizer.SetEngine(ENGINES[engine])
    tetrahedralizer.SetOrientation(ORIENTATIONS[orientation])
    tetrahedralizer.SetCountDuplicates(bool(count_duplicates))
    if time_budget is not None:
        tetrahedralizer.SetTimeBudget(at_least(0, "time_budget", time_budget))
    if memory_budget is not None:
        tetrahedralizer.SetMemoryBudget(at_least(0, "memory_budget", memory_budget))
    return tetrahedralizer


def _inside_cells(hull: vtkUnstructuredGrid) -> vtkUnstructuredGrid:
    threshold = vtkThreshold()
    threshold.SetInputData(hull)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Inside")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(0.5)
    run(threshold)
    return threshold.GetOutput()
