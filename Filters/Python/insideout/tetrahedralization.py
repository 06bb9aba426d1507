# SPDX-License-Identifier: GPL-3.0-or-later
"""`tetrahedralize`: from a surface to its solid in one call."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable, Optional, Union

from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPointSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkThreshold

from .data import AnySurface, Tetrahedra, TriangleSurface, as_surface, as_type
from .pipeline import Error, Progress, at_least, cells_of, run, statistics_of
from .vtkFiltersInsideOut import vtkRobustTetrahedralize

STAGES = (
    "validating",
    "finding self-intersections",
    "resolving self-intersections",
    "tetrahedralizing",
    "winding numbers",
    "segmenting",
    "extracting",
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

DATA_TERMS = {
    "uniform": vtkRobustTetrahedralize.UNIFORM,
    "volume weighted": vtkRobustTetrahedralize.VOLUME_WEIGHTED,
}

Seeds = Union[vtkPointSet, Iterable[tuple[tuple[float, float, float], bool]]]


@dataclass(frozen=True)
class Tetrahedralization:
    """What `tetrahedralize` found. The VTK class vtkRobustTetrahedralize describes the arrays."""

    solid: Tetrahedra
    """The tetrahedra inside, with `w` per cell. Empty, with a warning, when nothing is inside."""
    boundary: TriangleSurface
    """The solid's boundary: watertight, oriented outward, with the input's attributes."""
    outliers: TriangleSurface
    """The pieces of input facets that are no face of a cell inside, with the reason in `OutlierReason`."""
    hull: Tetrahedra
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
    surface: AnySurface,
    *,
    gamma: Optional[float] = None,
    sigma: Optional[float] = None,
    orientation: str = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    time_budget: Optional[float] = None,
    memory_budget: Optional[float] = None,
    engine: str = "automatic",
    non_participating: Optional[str] = None,
    merge_coplanar_pieces: bool = False,
    split_seams: bool = False,
    data_term: str = "uniform",
    constrain_facets: Union[bool, str] = False,
    constrain_manifold: bool = False,
    seeds: Optional[Seeds] = None,
    progress: Optional[Progress] = None,
) -> Tetrahedralization:
    """Tetrahedra of the solid that a surface most likely means.

    surface           a vtkPolyData, a file's name, a pair (points, triangles) of arrays or a meshio.Mesh
    gamma             weight of a smooth boundary against the winding number, at least 0; 0 takes
                      every cell with w above 1/2
    sigma             how large a step of w between neighbouring cells may be noise, at least 1e-6
    orientation       "automatic" turns an inside-out surface over, with a warning; "as given"
                      never does, "reverse" always
    merge_tolerance   points at most this far apart become one, in units of the surface, at least 0
    count_duplicates  count a facet as often as it is given
    engine            what makes the tetrahedra: "exact" flips and cuts, "tetgen", or "automatic",
                      which is the first, and the second should it lose a facet
    time_budget       seconds that tetrahedralizing may take, all tries together; 0 goes by the surface's size
    memory_budget     MiB that TetGen's process may hold; 0 goes by the surface's size
    non_participating  the name of a cell array of the surface: cells where it is not 0 do not count in
                      w, but shape the mesh
    merge_coplanar_pieces  put the pieces of an input triangle together again on the boundary where all
                      of it lies there
    split_seams       give the boundary a point for each of the input's texture coordinates and normals
                      in a place, instead of the lowest point's alone
    data_term         how much a cell's own w counts: "uniform", or "volume weighted", so that slivers
                      do not outvote large cells
    constrain_facets  keep every facet as faces of cells inside, thin sheets too; or, by the name of
                      a cell array, those where it is not 0
    constrain_manifold  make the solid's boundary a 2-manifold by adding cells where it is none
    seeds             what has to be inside or outside: pairs of a point and a bool, or a vtkPointSet
                      with the point array Inside (1 or 0)
    progress          called with the stage and the fraction of all the work that is done; what it
                      raises stops the work and is raised

    What is not given has the default of the class vtkRobustTetrahedralize. Returns a
    `Tetrahedralization`. Raises `Error` with one line that names what is wrong.
    """
    tetrahedralizer = make_filter(
        gamma=gamma,
        sigma=sigma,
        orientation=orientation,
        merge_tolerance=merge_tolerance,
        count_duplicates=count_duplicates,
        time_budget=time_budget,
        memory_budget=memory_budget,
        engine=engine,
        non_participating=non_participating,
        merge_coplanar_pieces=merge_coplanar_pieces,
        split_seams=split_seams,
        data_term=data_term,
        constrain_facets=constrain_facets,
        constrain_manifold=constrain_manifold,
    )
    if seeds is not None:
        tetrahedralizer.SetSeedsData(seeds if isinstance(seeds, vtkPointSet) else _seed_points(seeds))
    polygons, warnings = as_surface(surface)
    tetrahedralizer.SetInputData(polygons)
    tetrahedralizer.ExtractInsideOff()
    warnings = warnings + run(tetrahedralizer, progress)

    hull = tetrahedralizer.GetOutput()
    if hull.GetNumberOfCells() == 0:
        raise Error("the filter gave no cells and no reason")
    return Tetrahedralization(
        solid=as_type(Tetrahedra, inside_cells(hull)),
        boundary=as_type(TriangleSurface, tetrahedralizer.GetBoundary()),
        outliers=as_type(TriangleSurface, tetrahedralizer.GetOutliers()),
        hull=as_type(Tetrahedra, hull),
        statistics=statistics_of(hull),
        left_out_cells=cells_of(hull, "LeftOutCellIds"),
        lost_cells=cells_of(hull, "LostCellIds"),
        warnings=warnings,
    )


def make_filter(
    *,
    gamma: Optional[float] = None,
    sigma: Optional[float] = None,
    orientation: str = "automatic",
    merge_tolerance: Optional[float] = None,
    count_duplicates: bool = False,
    time_budget: Optional[float] = None,
    memory_budget: Optional[float] = None,
    engine: str = "automatic",
    non_participating: Optional[str] = None,
    merge_coplanar_pieces: bool = False,
    split_seams: bool = False,
    data_term: str = "uniform",
    constrain_facets: Union[bool, str] = False,
    constrain_manifold: bool = False,
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
    if data_term not in DATA_TERMS:
        raise Error(f"data_term is {data_term!r}; it can be {', '.join(map(repr, DATA_TERMS))}")
    tetrahedralizer.SetDataTerm(DATA_TERMS[data_term])
    tetrahedralizer.SetConstrainFacets(bool(constrain_facets))
    if isinstance(constrain_facets, str):
        tetrahedralizer.SetConstrainedFacetsArrayName(constrain_facets)
    tetrahedralizer.SetConstrainManifold(bool(constrain_manifold))
    tetrahedralizer.SetEngine(ENGINES[engine])
    tetrahedralizer.SetOrientation(ORIENTATIONS[orientation])
    tetrahedralizer.SetCountDuplicates(bool(count_duplicates))
    if time_budget is not None:
        tetrahedralizer.SetTimeBudget(at_least(0, "time_budget", time_budget))
    if memory_budget is not None:
        tetrahedralizer.SetMemoryBudget(at_least(0, "memory_budget", memory_budget))
    if non_participating is not None:
        tetrahedralizer.SetNonParticipatingArrayName(non_participating)
    tetrahedralizer.SetMergeCoplanarPieces(bool(merge_coplanar_pieces))
    tetrahedralizer.SetSplitSeams(bool(split_seams))
    return tetrahedralizer


def _seed_points(seeds: Iterable[tuple[tuple[float, float, float], bool]]) -> vtkPolyData:
    points, inside = vtkPoints(), vtkUnsignedCharArray()
    points.SetDataType(VTK_DOUBLE)
    inside.SetName("Inside")
    try:
        for place, is_inside in seeds:
            x, y, z = map(float, place)
            points.InsertNextPoint(x, y, z)
            inside.InsertNextValue(bool(is_inside))
    except (TypeError, ValueError):
        raise Error(f"seed {inside.GetNumberOfValues()} is no pair of a point and a bool") from None
    data = vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().AddArray(inside)
    return data


def inside_cells(hull: vtkUnstructuredGrid) -> vtkUnstructuredGrid:
    """The cells whose array Inside is 1."""
    threshold = vtkThreshold()
    threshold.SetInputData(hull)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Inside")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(0.5)
    run(threshold)
    return threshold.GetOutput()
