# SPDX-License-Identifier: GPL-3.0-or-later
"""`tetrahedralize`: from a surface to its solid in one call."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence, Tuple, Union, cast

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkThreshold

from .bodies import AnyBodies, as_bodies
from .calling import for_users
from .checking import check
from .data import LayeredCells, Polylines, Tetrahedra, Triangles, TriangleSurface, as_type
from .exporting import is_boundary_alone, mesh_of_solid
from .files import WRITABLE_SURFACES, Path, check_output, ending
from .inputs import path_of
from .layering import layered
from .lengths import Length
from .options import LAYER_OPTIONS, OPTIONS, DataTerm, Dimension, Engine, NonManifold, Options, Orientation, QuadratureOrder, RegionRule, Seeds, SizeRules, SurfaceTreatment, TagRules, Topology, describe_options, in_words_of_python
from .pipeline import Error, Progress, add_statistic, cells_of, run, statistics_of, strings_of
from .results import MeshResult, counted
from .solid_files import WRITABLE_GRIDS, check_beside, check_holds_layers, check_holds_triangles, is_for_solver, write_result
from .statistics import Statistics
from .tagging import with_functions_as_arrays, without_arrays_of_functions
from .verdict import verdict
from .vtkFiltersInsideOut import vtkRobustTetrahedralize, vtkRobustTriangulate


@dataclass(frozen=True)
class Region:
    """A region of a solid, with density 1 and in the surface's units. The array `RegionId` says which cells it has."""

    volume: float
    """The volume; in two dimensions the area, with inertia 0."""
    center_of_mass: Tuple[float, float, float]
    inertia: Tuple[float, float, float, float, float, float]
    """xx, yy, zz, xy, yz and xz about its own center of mass: xx is the integral of y^2 + z^2, xy that of -x y."""
    bodies: Tuple[str, ...] = ()
    """The names of its bodies, if there are bodies."""


@dataclass(frozen=True, repr=False)
class Tetrahedralization(MeshResult):
    """The result of `tetrahedralize`. The VTK class vtkRobustTetrahedralize describes the arrays.

    In two dimensions solid and hull are `Triangles`, boundary and outliers `Polylines`.
    """

    solid: Union[Tetrahedra, Triangles]
    """The tetrahedra inside, with `w` and `RegionId` per cell, separated and refined as requested. Empty, with a
    warning, if nothing is inside; and empty, as the hull is, with `surface_only`. With `layers` it is a
    `LayeredCells`."""
    boundary: Union[TriangleSurface, Polylines]
    """The solid's boundary: watertight, oriented outward, with the input's attributes, and `BoundaryTag` per triangle.
    With several bodies the interfaces between regions follow: see `RegionIds`."""
    outliers: Union[TriangleSurface, Polylines]
    """The pieces of input facets that are no face of a cell inside, with the reason in `OutlierReason`."""
    hull: Union[Tetrahedra, Triangles]
    """All tetrahedra of the convex hull, with `w` and `Inside` per cell."""
    statistics: Statistics
    """Counts, the range of w, seconds per stage and peak memory in MiB, by name."""
    left_out_cells: list[int]
    """The cells of the surface with facets that could not be resolved; hardly ever any."""
    turned_cells: list[int]
    """The cells of the surface that the orientation turned over."""
    lost_cells: list[int]
    """The cells of the surface with facets that the mesh does not follow; hardly ever any."""
    warnings: list[str]
    """Warnings about the input, one line each."""

    @property
    def verdict(self) -> str:
        """One sentence: whether the surface bounds a solid, as the verdict of `check`, but with the volume of the
        cells."""
        return verdict(self.statistics)

    def is_planar(self) -> bool:
        """Whether it is two-dimensional."""
        return isinstance(self.hull, Triangles)

    @property
    def regions(self) -> list[Region]:
        """The regions in the order of `RegionId`: parts connected through faces, or with several bodies as
        `region_rule` says. None if no tetrahedra were made."""
        if self.is_planar():
            fields = self.hull.GetFieldData()
            areas, centers = (vtk_to_numpy(fields.GetArray(f"Region{name}")).tolist() for name in ("Area", "CenterOfMass"))
            return [Region(area, (x, y, z), (0.0,) * 6) for area, (x, y, z) in zip(areas, centers)]
        # A solid with a remeshed boundary has its own volume; an empty solid has no regions.
        fields = (self.solid if self.solid.GetFieldData().HasArray("RegionVolume") else self.hull).GetFieldData()
        if not fields.HasArray("RegionVolume"):
            return []
        volumes, centers, inertias = (
            vtk_to_numpy(fields.GetArray(f"Region{name}")).tolist() for name in ("Volume", "CenterOfMass", "Inertia")
        )
        bodies = self._bodies_of_regions() or [()] * len(volumes)
        return [
            Region(volume, (x, y, z), (xx, yy, zz, xy, yz, xz), of)
            for volume, (x, y, z), (xx, yy, zz, xy, yz, xz), of in zip(volumes, centers, inertias, bodies)
        ]

    @property
    def bodies(self) -> dict[str, float]:
        """The volumes of the bodies by name, each body alone, before any refinement. Empty without bodies."""
        names, volumes = (self.hull.GetFieldData().GetAbstractArray(name) for name in ("BodyNames", "BodyVolume"))
        return {} if volumes is None else dict(zip(strings_of(names), vtk_to_numpy(volumes).tolist()))

    def _bodies_of_regions(self) -> list[Tuple[str, ...]]:
        fields = self.hull.GetFieldData()
        of = fields.GetArray("RegionBodies")
        if of is None:
            return []
        names = np.array(strings_of(fields.GetAbstractArray("BodyNames")))
        return [tuple(names[row != 0].tolist()) for row in vtk_to_numpy(of).reshape(-1, len(names))]

    @property
    def tags(self) -> dict[str, NDArray[np.int64]]:
        """The triangles of the boundary with each tag, by its name: groups, materials or solids of the surface, or the
        tags in `tag_array`; triangles that close a hole have the tag "hole". With several bodies a name has the regions
        on both sides, as "bone|fat" and "fat|outside"."""
        names = strings_of(self.boundary.GetFieldData().GetAbstractArray("BoundaryTagNames"))
        of_triangle = vtk_to_numpy(self.boundary.GetCellData().GetArray("BoundaryTag"))
        return {name: np.flatnonzero(of_triangle == tag) for tag, name in enumerate(names)}

    def figures(self) -> list[tuple[str, str]]:
        least, most = self.statistics["MinimumW"], self.statistics["MaximumW"]
        cells = [
            ("triangles inside" if self.is_planar() else "tetrahedra inside", self.statistics.get("InsideCells")),
            ("refined to", self.statistics.get("RefinedCells")),
            ("in the convex hull", self.statistics.get("HullCells")),
            ("bodies", len(self.bodies) or None),
            ("regions", self.statistics.get("Regions")),
        ]
        return [
            *((what, counted(int(count))) for what, count in cells if count is not None),
            ("boundary lines" if self.is_planar() else "boundary triangles", counted(self.boundary.GetNumberOfCells())),
            ("outliers", counted(self.outliers.GetNumberOfCells())),
            ("winding numbers", f"{least:.6g} to {most:.6g}"),
            *(("", warning) for warning in self.warnings),
        ]

    def seen(self) -> dict[str, Any]:
        if self.hull.GetNumberOfCells() > 0:
            return {"hull": self.hull, "solid": self.solid}
        return check(self.boundary).seen()

    def to_meshio(self) -> Any:
        """The solid and its boundary as one meshio.Mesh: tetrahedra and triangles with all their arrays, in groups.

        There is a block of cells for each region and tag. `gmsh:physical` and `gmsh:geometrical` of cells are RegionId
        and BoundaryTag plus 1; `gmsh:dim_tags` of points are the entities that they lie on. field_data has the number
        and dimension of each group by name, as meshio reads them from a .msh file. An array that only one of the two
        has is NaN (-1 for integers, 0 for unsigned ones) at the other's cells. FacetIds, of four components, becomes
        FacetIds_0 to _3, because few formats support four.
        """
        if is_boundary_alone(self.solid, self.boundary):
            raise Error("the mesh has the solid's cells, and surface_only left these away")
        return self.solid.to_meshio() if isinstance(self.solid, (LayeredCells, Triangles)) else mesh_of_solid(self.solid, self.boundary)


@for_users
@describe_options
def tetrahedralize(
    surface: AnyBodies,
    *,
    # All fields of Options.
    output: Optional[Path] = None,
    progress: Optional[Progress] = None,
) -> Tetrahedralization:
    """Tetrahedra of the solid that a surface most likely means; for lines or polygons in a plane, triangles.

    surface   any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles)
              ...; or a dict of surfaces by name, which are the bodies of one mesh
    output    the file to write the result to, as `write` does. Cells for a solver (.msh, .inp, .mesh, .xdmf) are
              refined, unless refine is False. If nothing is inside, a warning says so and no file is written
    progress  called with the stage and the fraction of all the work that is done; an exception that it
              raises stops the work and is raised

    {options}

    Omitted options have the defaults of vtkRobustTetrahedralize and of its stages. Returns a `Tetrahedralization`.
    Raises `Error` with one line that names the culprit.
    """
    options = Options.among(locals())
    makes_layers = options.makes_layers()
    if output is not None:
        output = path_of("output", output)
        check_output(output, WRITABLE_GRIDS + WRITABLE_SURFACES)
        check_holds_layers(output, makes_layers)
        if options.surface_only and ending(output) not in WRITABLE_SURFACES:
            raise Error(f"{output}: such a file has the solid's cells, and surface_only leaves these away")
        options = options.for_solver() if is_for_solver(output) else options
    polygons, warnings, body_array = as_bodies(surface, options.factor(), options.body_array)
    options = options.measured_on(polygons)
    polygons, options = with_functions_as_arrays(polygons, options)
    algorithm: Any = options.set_on(vtkRobustTetrahedralize())
    algorithm.SetBodyArrayName(body_array or "")
    if options.is_planar(polygons):
        check_holds_triangles(output or "")
        algorithm, more = _triangulator(options, polygons, body_array)
        warnings += more
    elif output is not None:
        check_beside(output)
    algorithm.SetInputData(polygons)
    algorithm.SetRefine(options.refines())
    algorithm.SetGenerateHull(not options.surface_only)
    warnings += in_words_of_python(run(algorithm, progress))
    solid, boundary, outliers, hull = (_copy_of(algorithm.GetOutputDataObject(port)) for port in range(4))
    for output_of_facets in (boundary, outliers):
        without_arrays_of_functions(output_of_facets)
    if options.surface_only:
        solid = hull = _without_cells(solid)
    elif hull.GetNumberOfCells() == 0:
        raise Error("the filter gave no cells and no reason")
    if makes_layers and solid.GetNumberOfCells() > 0:
        solid, boundary, more = layered(solid, boundary, options, progress)
        warnings += more
    for grid in (solid, hull):
        add_statistic("Scale", options.factor(), grid)
    statistics = statistics_of(solid)
    cells, faces = (Triangles, Polylines) if statistics.get("Dimension") == 2 else (Tetrahedra, TriangleSurface)
    of_solid = LayeredCells if "Layers" in statistics else cells
    if output is not None and boundary.GetNumberOfCells() > 0:
        warnings += write_result(as_type(of_solid, solid), as_type(faces, boundary), output)
    elif output is not None:
        warnings.append(f"{output} is not written, because nothing is inside")
    return Tetrahedralization(
        solid=cast("Union[Tetrahedra, Triangles]", as_type(of_solid, solid)),
        boundary=as_type(faces, boundary),
        outliers=as_type(faces, outliers),
        hull=as_type(cells, hull),
        statistics=statistics,
        left_out_cells=cells_of(hull, "LeftOutCellIds"),
        turned_cells=cells_of(hull, "TurnedCellIds"),
        lost_cells=cells_of(hull, "LostCellIds"),
        warnings=warnings,
    )


def _triangulator(options: Options, polygons: vtkPolyData, body_array: Optional[str]) -> Tuple[vtkRobustTriangulate, list[str]]:
    """The filter for triangles in a plane, and its warnings. Raises `Error` for options of tetrahedra alone."""
    algorithm = vtkRobustTriangulate()
    left_out = [name for name in options.left_out_by(algorithm) if name not in LAYER_OPTIONS]
    if body_array:
        raise Error("the input lies in a plane, where body_array has no meaning: bodies are in space")
    if options.separate_overlaps:
        raise Error("the input lies in a plane, where separate_overlaps does nothing: it separates tetrahedra")
    warnings = [f"{name} does nothing in a plane" for name in left_out if name != "surface_only"]
    if options.dimension == "automatic":
        are_lines = polygons.GetNumberOfPolys() + polygons.GetNumberOfStrips() == 0
        found = "the input is lines" if are_lines else "the polygons lie in one plane"
        warnings.insert(0, f"{found}: two dimensions, triangles instead of tetrahedra")
    return options.set_on(algorithm, OPTIONS.keys() - {*left_out}), warnings


def _copy_of(output: vtkDataObject) -> Any:
    """A copy of an output that another run of its filter does not change."""
    copy = output.NewInstance()
    copy.ShallowCopy(output)
    return copy


def _without_cells(grid: vtkUnstructuredGrid) -> vtkUnstructuredGrid:
    """The statistics of a grid."""
    told = vtkUnstructuredGrid()
    told.GetFieldData().ShallowCopy(grid.GetFieldData())
    return told


def inside_cells(hull: vtkUnstructuredGrid) -> vtkUnstructuredGrid:
    """The cells whose array Inside is 1."""
    threshold = vtkThreshold()
    threshold.SetInputData(hull)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Inside")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(0.5)
    run(threshold)
    return threshold.GetOutput()
