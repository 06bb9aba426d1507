# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be chosen about a solid: each option once, for VTK's filters, the functions and the command line."""

from __future__ import annotations

import inspect
import re
import textwrap
from dataclasses import dataclass, field, fields
from typing import Any, Callable, Iterable, Literal, Mapping, Optional, Sequence, TypeVar, Union, get_args

from vtkmodules.vtkCommonDataModel import vtkPolyData

from .option_kinds import Choice, Count, Dimensions, Names, Number, Option, Order, Places, Scale, Seeds, Switch, SwitchOrArray, owner_of
from .vtkFiltersInsideOut import vtkRobustTriangulate

Orientation = Literal["automatic", "as-given", "reverse", "outward"]
Engine = Literal["automatic", "exact", "tetgen"]
DataTerm = Literal["uniform", "volume-weighted"]
Dimension = Literal["automatic", "2", "3", 2, 3]
SurfaceTreatment = Literal["kept", "split", "remeshed"]
NonManifold = Literal["keep", "fill", "split"]
QuadratureOrder = Literal[1, 2, 3, 4, 5]
Topology = Literal["any", "one-component", "simply-connected"]
RegionRule = Literal["by-priority", "all"]
Filter = TypeVar("Filter")
Function = TypeVar("Function", bound=Callable[..., Any])


def _is(option: Option) -> Any:
    return field(default=option.default, metadata={"option": option})


@dataclass(frozen=True)
class Options:
    """The options of `tetrahedralize`, some of which other functions have too.

    They are properties of vtkRobustTetrahedralize and of the stages that it hands out; in a plane of vtkRobustTriangulate.
    Neither has a scale: that is for the surface, before any filter has it.
    """

    scale: Optional[float] = _is(
        Scale("", "multiply the surface's coordinates by this: 0.001 makes metres of millimetres; other lengths are in the new unit")
    )
    dimension: Dimension = _is(
        Dimensions(
            "",
            'how many dimensions the input has: "2", lines or polygons in a plane, which become triangles; "3", a surface; '
            '"automatic" is 2 for lines without polygons and for polygons in one plane, with a warning',
            default="automatic",
            choices=("automatic", "2", "3"),
        )
    )
    gamma: Optional[float] = _is(
        Number("Gamma", "weight of a smooth boundary against the winding number; 0 takes every cell with w above 1/2")
    )
    sigma: Optional[float] = _is(
        Number("Sigma", "how large a step of w between neighbouring cells may be noise", least=1e-6)
    )
    orientation: Orientation = _is(
        Choice(
            "Orientation",
            'which way facets are meant to face: "automatic" turns over what is inside out, with a warning, and leaves '
            'cavities; "as-given" turns nothing, "reverse" everything, and "outward" all that encloses something outward',
            default="automatic",
            choices=get_args(Orientation),
        )
    )
    thicken: Optional[float] = _is(
        Number("Thicken", "give sheets, which enclose nothing, this thickness, in the surface's units; 0 leaves them")
    )
    thicken_all: bool = _is(Switch("ThickenAll", "thicken every facet, and not only sheets"))
    merge_tolerance: Optional[float] = _is(
        Number("MergeTolerance", "points of the surface at most this far apart become one, in its units; narrower gaps between bodies close")
    )
    count_duplicates: bool = _is(Switch("CountDuplicates", "count a facet as often as it is given"))
    time_budget: Optional[float] = _is(
        Number("TimeBudget", "seconds that tetrahedralizing may take, all tries together; 0 goes by work, not by time")
    )
    memory_budget: Optional[float] = _is(
        Number("MemoryBudget", "MiB that TetGen's process may hold; 0 goes by the surface's size")
    )
    engine: Engine = _is(
        Choice(
            "Engine",
            'what makes the tetrahedra: "exact" flips and cuts, "tetgen", or "automatic", which is the first, and the '
            "second should it lose a facet",
            default="automatic",
            choices=get_args(Engine),
            prefix="ENGINE_",
        )
    )
    data_term: DataTerm = _is(
        Choice(
            "DataTerm",
            'how much a cell\'s own w counts: "uniform", or "volume-weighted", so that slivers do not outvote large cells',
            default="uniform",
            choices=get_args(DataTerm),
        )
    )
    constrain_facets: Union[bool, str] = _is(
        SwitchOrArray(
            "ConstrainFacets",
            "keep every facet as faces of cells inside, thin sheets too",
            "; or, by the name of a cell array, those where it is not 0",
        )
    )
    non_manifold: NonManifold = _is(
        Choice(
            "NonManifold",
            'what becomes of the solid\'s boundary where it is no 2-manifold: "keep" leaves it, "fill" adds cells, and "split" '
            "copies points in their place, so that parts that touch share none",
            default="keep",
            choices=get_args(NonManifold),
            prefix="NONMANIFOLD_",
        )
    )
    separate_overlaps: bool = _is(
        Switch(
            "SeparateOverlaps",
            "where two layers of the solid overlap give each cells of its own, so that a limb can be pulled out of another",
        )
    )
    largest_regions: Optional[int] = _is(
        Count("LargestRegions", "how many regions of the solid, parts that faces connect, stay at most: the largest; 0 is any number")
    )
    minimum_region_volume: Optional[float] = _is(
        Number("MinimumRegionVolume", "drop regions of a smaller volume, in a plane area, in the surface's units")
    )
    seeded_regions: bool = _is(Switch("SeededRegions", "drop regions without a seed that is to be inside"))
    fill_cavities: bool = _is(Switch("FillCavities", "fill the cavities that the solid encloses, in a plane its holes"))
    topology: Topology = _is(
        Choice(
            "Topology",
            'what the solid is to be: "any", as the cut has it; "one-component", regions joined or dropped, whichever adds less '
            'energy; "simply-connected", without tunnels and cavities besides, which are cut open or filled',
            default="any",
            choices=get_args(Topology),
            prefix="TOPOLOGY_",
        )
    )
    non_participating: Optional[str] = _is(
        Option(
            "NonParticipatingArrayName",
            "the name of a cell array of the surface: cells where it is not 0 do not count in w, but shape the mesh",
        )
    )
    quadrature_order: Optional[QuadratureOrder] = _is(
        Order("QuadratureOrder", "degree up to which w is integrated over a cell, which matters near holes only", most=max(get_args(QuadratureOrder)))
    )
    merge_coplanar_pieces: bool = _is(
        Switch(
            "MergeCoplanarPieces",
            "put the pieces of an input triangle together again on the boundary where all of it lies there",
        )
    )
    split_seams: bool = _is(
        Switch(
            "SplitSeams",
            "give the boundary a point for each of the input's texture coordinates and normals in a place, instead of "
            "the lowest point's alone",
        )
    )
    surface_only: bool = _is(
        Switch(
            "SurfaceOnly",
            "only the boundary is wanted: of a closed surface it is found without tetrahedra, at the speed of resolving "
            "self-intersections, where nothing else is asked for that takes them",
        )
    )
    tag_array: Optional[str] = _is(
        Option(
            "TagArrayName",
            "the name of a cell array of the surface, of integers or strings, that tags the boundary; by default its groups, "
            "materials or solids do",
        )
    )
    bodies: Optional[str] = _is(
        Option(
            "BodyArrayName",
            "the name of a cell array of the surface, of integers or strings, that says which body each facet is of: all become "
            "one mesh, of a region for each",
        )
    )
    parts_apart: bool = _is(
        Switch(
            "PartsApart",
            "tetrahedralize parts of the surface whose boxes do not meet apart, by several threads at once, without cells "
            "between them: the same solid where the surface is closed, in other tetrahedra; all open pieces are one part",
        )
    )
    region_rule: RegionRule = _is(
        Choice(
            "RegionRule",
            'what becomes a region where there are bodies: "by-priority", each body, of several in a place the one that comes '
            'first; "all", each combination of bodies that occurs',
            default="by-priority",
            choices=get_args(RegionRule),
        )
    )
    priority: Union[str, Sequence[str], None] = _is(
        Names("Priority", "the names of bodies, parted by commas, from the one that comes first; the others follow in their own order", "; or a list of them")
    )
    refine: bool = _is(
        Switch(
            "Refine",
            "better tetrahedra of the same solid, or in a plane better triangles; any other option of refinement implies it",
        )
    )
    edge_length: Optional[float] = _is(
        Number("EdgeLength", "how long edges are to be at most, in the surface's units; 0 goes by the surface's own")
    )
    grading: Optional[float] = _is(
        Number("Grading", "by how much edges may grow per unit of distance from the boundary", least=1e-6)
    )
    maximum_volume: Optional[float] = _is(
        Number("MaximumVolume", "the largest volume of tetrahedra, or in a plane area of triangles, in the surface's units; 0 is any size")
    )
    surface_treatment: SurfaceTreatment = _is(
        Choice(
            "Surface",
            "what becomes of the triangles of the boundary of tetrahedra that are refined: kept bit by bit, split into pieces, "
            "or remeshed within a tolerance",
            default="kept",
            alias="--surface",
            choices=get_args(SurfaceTreatment),
        )
    )
    surface_tolerance: Optional[float] = _is(
        Number("SurfaceTolerance", "how far a remeshed boundary may be from the old one; 0 is a thousandth of the size")
    )
    feature_angle: Optional[float] = _is(
        Number("FeatureAngle", "edges of a remeshed boundary stay where normals differ by more, in degrees", most=180)
    )
    quadratic: bool = _is(Switch("QuadraticCells", "tetrahedra of ten points, of which six are amid the straight edges"))
    seeds: Optional[Seeds] = _is(
        Places(
            "SeedsData",
            "what has to be inside or outside: a table of x, y, z, inside (1 or 0), and body where there are bodies",
            "; or pairs of a point and a bool, and a body's name behind them, or a vtkPointSet with the point arrays Inside (1 or 0) "
            "and Body (a name)",
        )
    )

    def factor(self) -> float:
        """What the surface's coordinates are multiplied by."""
        return 1.0 if self.scale is None else float(self.scale)

    @classmethod
    def among(cls, values: Mapping[str, Any]) -> Options:
        """Those of some named values that are options."""
        return cls(**{name: value for name, value in values.items() if name in OPTIONS})

    def refines(self) -> bool:
        """Whether the solid is to be refined: by an option that has no other meaning, too."""
        return self.refine or any(self._is_given(name) for name in REFINING_OPTIONS)

    def parts(self) -> bool:
        """Whether the solid has more points or cells than the hull has of it."""
        return self.non_manifold == "split" or self.separate_overlaps

    def is_planar(self, polygons: vtkPolyData) -> bool:
        """Whether an input becomes triangles: asked for, or told by the input."""
        OPTIONS["dimension"].set_on(None, "dimension", self.dimension)
        if self.dimension != "automatic":
            return str(self.dimension) == "2"
        thickens = self.thicken and polygons.GetNumberOfPolys() + polygons.GetNumberOfStrips() > 0
        return not thickens and bool(vtkRobustTriangulate.IsInAPlane(polygons))

    def left_out_by(self, algorithm: Any) -> list[str]:
        """The names of those that are given and a filter does not have."""
        return [
            name
            for name, option in OPTIONS.items()
            if option.vtk_property and self._is_given(name) and owner_of(algorithm, option.vtk_property) is None
        ]

    def _is_given(self, name: str) -> bool:
        value, default = getattr(self, name), OPTIONS[name].default
        return value is not default and not (isinstance(value, str) and value == default)

    def set_on(self, algorithm: Filter, names: Optional[Iterable[str]] = None) -> Filter:
        """Set what is given on a filter, which is returned: all, or some. Raises `Error` for what is out of range."""
        for name, option in OPTIONS.items():
            if names is not None and name not in names:
                continue
            if self._is_given(name):
                option.set_on(algorithm, name, getattr(self, name))
        return algorithm


REFINING_OPTIONS = (
    *("edge_length", "grading", "maximum_volume", "surface_treatment", "surface_tolerance", "feature_angle", "quadratic"),
)
"""What `refine` has too."""

OPTIONS: dict[str, Option] = {one.name: one.metadata["option"] for one in fields(Options)}
"""What stands behind each of them, by its name in Python."""


def in_words_of_python(texts: Iterable[str]) -> list[str]:
    """Texts that name VTK's properties, with the names that these have in Python."""
    return _renamed(texts, {option.vtk_property: name for name, option in OPTIONS.items() if option.vtk_property})


def in_words_of_command(texts: Iterable[str]) -> list[str]:
    """Texts that name Python's options, with those of the command line."""
    return _renamed(texts, {name: flag_of(name) for name in OPTIONS if name not in ("scale", "seeds", "bodies", "priority")})


def flag_of(name: str) -> str:
    """What an option is called on the command line."""
    return "--" + name.replace("_", "-")


def _renamed(texts: Iterable[str], names: Mapping[str, str]) -> list[str]:
    def new_name(found: re.Match[str]) -> str:
        return names[found.group()]

    return [re.sub(rf"\b({'|'.join(names)})\b", new_name, text) for text in texts]


def describe_options(function: Function) -> Function:
    """Say in a function's help, where {options} stands, what those of its options mean that it does not tell itself."""
    page = function.__doc__ or ""
    names = [name for name in inspect.signature(function).parameters if name in OPTIONS and f" {name}  " not in page]
    width = max(map(len, names)) + 2
    lines = [
        textwrap.fill(name.ljust(width) + OPTIONS[name].help() + OPTIONS[name].more_words, 106, subsequent_indent=" " * width)
        for name in names
    ]
    function.__doc__ = re.sub(
        r"^( *)\{options\}$", lambda found: textwrap.indent("\n".join(lines), found[1]), page, flags=re.MULTILINE
    )
    return function
