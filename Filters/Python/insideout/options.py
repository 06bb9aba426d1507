# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of a solid: each option once, for the functions and the command line. Each class has the options of one
topic of the command's help as fields. The header of its VTK class declares its meaning, range, default and choices
(declared.py, written by the build). The few options that are not properties are described here. The build also adds the
fields to the parameters of the functions that have them.
"""

from __future__ import annotations

import inspect
import re
import textwrap
from dataclasses import dataclass, fields, replace
from typing import Any, Callable, Iterable, Literal, Mapping, Optional, Sequence, TypeVar, Union

from vtkmodules.vtkCommonDataModel import vtkPointSet, vtkPolyData

from .declared import CONSTANTS, DECLARED
from .errors import ArgumentError
from .lengths import Length, diagonal_of, share_of
from .option_kinds import ChosenFacets, Decision, Dimensions, Lengths, Names, Option, Places, Rules, Scale, Seeds, SizesByRules, TagRules, kind_of, owner_of
from .sizing import SizeRules, has_shares, with_numbers
from .vtkFiltersInsideOut import vtkBoundaryLayers, vtkRobustTriangulate

Orientation = Literal["automatic", "as-given", "reverse", "outward"]
Engine = Literal["automatic", "exact", "tetgen"]
DataTerm = Literal["uniform", "volume-weighted"]
Dimension = Literal["automatic", "2", "3", 2, 3]
SurfaceTreatment = Literal["automatic", "kept", "split", "remeshed"]
NonManifold = Literal["keep", "fill", "split"]
QuadratureOrder = Literal[1, 2, 3, 4, 5]
Topology = Literal["any", "one-component", "simply-connected"]
RegionRule = Literal["by-priority", "all"]
Filter = TypeVar("Filter")
Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True)
class SurfaceOptions:
    scale: Optional[float] = None
    orientation: Orientation = "automatic"
    merge_tolerance: Optional[Length] = None
    count_duplicates: bool = False
    thicken: Optional[Length] = None
    thicken_all: bool = False
    dimension: Dimension = "automatic"
    non_participating_array: Optional[str] = None
    tag_array: Optional[str] = None
    tag_rules: Optional[TagRules] = None
    merge_coplanar_pieces: bool = False
    split_seams: bool = False


@dataclass(frozen=True)
class BodiesOptions:
    body_array: Optional[str] = None
    priority: Union[str, Sequence[str], None] = None
    region_rule: RegionRule = "by-priority"
    touch_tolerance: Optional[Length] = None


@dataclass(frozen=True)
class SegmentationOptions:
    gamma: Optional[float] = None
    sigma: Optional[float] = None
    data_term: DataTerm = "uniform"
    quadrature_order: Optional[QuadratureOrder] = None
    constrain_facets: bool = False
    constrained_facets_array: Optional[str] = None
    seeds: Optional[Seeds] = None


@dataclass(frozen=True)
class TopologyOptions:
    non_manifold: NonManifold = "keep"
    separate_overlaps: bool = False
    membranes_separate_regions: bool = False
    topology: Topology = "any"
    fill_cavities: bool = False
    largest_regions: Optional[int] = None
    minimum_region_volume: Optional[float] = None
    seeded_regions: bool = False


@dataclass(frozen=True)
class RefinementOptions:
    edge_length: Optional[Length] = None
    grading: Optional[float] = None
    maximum_volume: Optional[float] = None
    maximum_cells: Optional[int] = None
    size_rules: Optional[SizeRules] = None
    surface_treatment: SurfaceTreatment = "automatic"
    surface_tolerance: Optional[Length] = None
    feature_angle: Optional[float] = None
    quadratic_cells: bool = False


@dataclass(frozen=True)
class LayersOptions:
    layers: Optional[int] = None
    first_height: Optional[Length] = None
    growth: Optional[float] = None
    layer_tags: Union[str, Sequence[str], None] = None


@dataclass(frozen=True)
class WorkOptions:
    refine: Optional[bool] = None
    surface_only: bool = False
    engine: Engine = "automatic"
    parts_apart: bool = False
    time_budget: Optional[float] = None
    memory_budget: Optional[float] = None


@dataclass(frozen=True)
class Options(SurfaceOptions, BodiesOptions, SegmentationOptions, TopologyOptions, RefinementOptions, LayersOptions, WorkOptions):
    """The options of `tetrahedralize`, some of which other functions have too. They are properties of
    vtkRobustTetrahedralize and its stages, of vtkBoundaryLayers (for boundary layers), and in a plane of
    vtkRobustTriangulate.
    """

    def factor(self) -> float:
        """The factor of the surface's coordinates."""
        return 1.0 if self.scale is None else OPTIONS["scale"].checked("scale", self.scale)

    @classmethod
    def among(cls, values: Mapping[str, Any]) -> Options:
        """The named values that are options."""
        return cls(**{name: value for name, value in values.items() if name in OPTIONS})

    def refines(self) -> bool:
        """Whether the solid is refined, explicitly or by an option of refinement."""
        given = next((name for name in (*REFINING_OPTIONS, *LAYER_OPTIONS) if self._is_given(name)), None)
        if given and self.refine is False:
            raise ArgumentError(f"{given} is given, which refines, and refine is False")
        return bool(self.refine or given)

    def for_solver(self) -> Options:
        """The same options for a solver's file: with refinement, unless other options exclude it."""
        return replace(self, refine=True) if self.refine is None and not self.surface_only else self

    def makes_layers(self) -> bool:
        """Whether the solid gets boundary layers. Raises `ArgumentError` if other options exclude them."""
        given = next((name for name in LAYER_OPTIONS if self._is_given(name)), None)
        if given and self.first_height is None:
            raise ArgumentError(f"{given} is given, and first_height is not: layers need the height of the first one")
        if self.layers == 1 and self._is_given("growth"):
            raise ArgumentError("growth is given, and layers is 1: a single layer does not grow")
        others = ("quadratic_cells", "surface_only")
        unfit = next((name for name in others if given and self._is_given(name)), None)
        if unfit:
            raise ArgumentError(f"{given} is given, and so is {unfit}: layers are made of linear tetrahedra")
        return given is not None

    def parts(self) -> bool:
        """Whether the solid has copies of the hull's points or cells."""
        return self.non_manifold == "split" or self.separate_overlaps

    def is_planar(self, polygons: vtkPolyData) -> bool:
        """Whether an input becomes triangles, by the option or by the input itself."""
        OPTIONS["dimension"].set_on(None, "dimension", self.dimension)
        if self.dimension != "automatic":
            return str(self.dimension) == "2"
        thickens = self.thicken and polygons.GetNumberOfPolys() + polygons.GetNumberOfStrips() > 0
        return not thickens and bool(vtkRobustTriangulate.IsInAPlane(polygons))

    def left_out_by(self, algorithm: Any) -> list[str]:
        """The names of given options that a filter does not have."""
        return [
            name
            for name, option in OPTIONS.items()
            if option.vtk_property and self._is_given(name) and owner_of(algorithm, option.vtk_property) is None
        ]

    def _is_given(self, name: str) -> bool:
        value, default = getattr(self, name), DEFAULTS[name]
        return value is not default and not (isinstance(value, str) and value == default)

    def measured_on(self, *all_data: vtkPointSet, factor: float = 1) -> Options:
        """The same options with each length as a number: shares refer to the diagonal of the box around all data, times
        a factor."""
        shares = {name: share for name in LENGTHS if (share := share_of(name, getattr(self, name))) is not None}
        diagonal = factor * diagonal_of(all_data) if shares or has_shares(self.size_rules) else 0
        numbers: dict[str, Any] = {name: share * diagonal for name, share in shares.items()}
        if has_shares(self.size_rules):
            numbers["size_rules"] = with_numbers(self.size_rules, diagonal)
        return replace(self, **numbers)

    def set_on(self, algorithm: Filter, names: Optional[Iterable[str]] = None) -> Filter:
        """Set all or some of the given options on a filter, and return it. Raises `Error` for a value out of range."""
        for name, option in OPTIONS.items():
            if names is not None and name not in names:
                continue
            if self._is_given(name) and (name not in LAYER_OPTIONS or isinstance(algorithm, vtkBoundaryLayers)):
                option.set_on(algorithm, name, getattr(self, name))
        return algorithm


_OWN: dict[str, Option] = {
    "scale": Scale("", "Factor on the surface's coordinates: 0.001 makes meters of millimeters. Other lengths are in the new unit. Default 1."),
    "dimension": Dimensions(
        "",
        'Number of dimensions of the input: "2", lines or polygons in a plane, which become triangles; "3", a surface; '
        '"automatic" is 2 for lines without polygons and for polygons in one plane, with a warning. Default "automatic".',
        choices=("automatic", "2", "3"),
    ),
    "seeds": Places(
        "SeedsData",
        "What has to be inside or outside: a table of x, y, z, inside (1 or 0), and body where there are bodies.",
        " Or tuples (point, bool) or (point, bool, body's name), or a vtkPointSet with the point arrays Inside (1 or 0) "
        "and Body (a name).",
    ),
}
"""Options that are no properties, or accept more values than those."""

LENGTHS = ("merge_tolerance", "touch_tolerance", "thicken", "edge_length", "surface_tolerance", "first_height")
"""Lengths that can be shares of the diagonal."""

_KINDS: dict[str, type[Option]] = {
    **dict.fromkeys(LENGTHS, Lengths),
    "priority": Names,
    "layer_tags": Names,
    "tag_rules": Rules,
    "size_rules": SizesByRules,
    "constrained_facets_array": ChosenFacets,
    "refine": Decision,
}
_MORE_WORDS = {
    "priority": " Or a list of them.",
    "layer_tags": " Or a list of them.",
    "size_rules": ' Or a dict of these: of "tag wall" 0.5, of "background" a vtkDataSet.',
    "tag_rules": " Or a dict of conditions by names, also functions: of the centers and unit normals of the input's polygons, as they are "
    "given, both (n, 3), to n bools.",
}
_MORE_WORDS_OF_KIND: dict[type[Option], str] = {
    Lengths: ' Or "2%" of the diagonal of the input.',
    Decision: " On where the file that is to be written is for a solver: .msh, .inp, .mesh or .xdmf.",
    SizesByRules: ' Lengths may be "2%" of the diagonal. "background ARRAY=FILE" are lengths at the points of an image or mesh of VTK.',
}


def _declared(name: str) -> Option:
    one = DECLARED[name]
    kind = _KINDS.get(name, kind_of(one))
    words = one.words + _MORE_WORDS_OF_KIND.get(kind, "")
    return kind(one.vtk_property, words, _MORE_WORDS.get(name, ""), one.least or 0, one.most, one.choices)


TOPICS: dict[str, list[str]] = {base.__name__.removesuffix("Options").lower(): [one.name for one in fields(base)] for base in Options.__bases__}
"""The options by topic."""

OPTIONS: dict[str, Option] = {name: _OWN.get(name) or _declared(name) for names in TOPICS.values() for name in names}
"""The kind of each option, by its name in Python."""

DEFAULTS: dict[str, Any] = {one.name: one.default for one in fields(Options)}
"""The value that leaves a filter's default."""

_PROPERTIES = {option.vtk_property: name for name, option in OPTIONS.items() if option.vtk_property}

REFINING_OPTIONS = tuple(TOPICS["refinement"])
"""The options of `refine`."""

LAYER_OPTIONS = tuple(TOPICS["layers"])
"""The options of boundary layers."""


def in_words_of_python(texts: Iterable[str]) -> list[str]:
    """A text with VTK's names of properties replaced by those of Python."""
    return [re.sub(r"\bset (\w+) to ([A-Z]\w*)", _chosen_in_python, text) for text in _renamed(texts, _PROPERTIES)]


def error_in_words_of_python(text: str) -> str:
    """The same of an error, which may name files that are called like a word: only names of several words."""
    return _renamed([text], {name: python for name, python in _PROPERTIES.items() if "_" in python})[0]


def error_in_words_of_command(text: str) -> str:
    """An error with the options of the command line in place of Python's, of several words only."""
    return _renamed([text], {name: flag_of(name) for name in OPTIONS if "_" in name})[0]


def _chosen_in_python(found: re.Match[str]) -> str:
    """ "set orientation to automatic" for a value as spelled in panels."""
    name, value = found.groups()
    return f"set {name} to {value.lower()}" if name in OPTIONS and value.lower() in OPTIONS[name].choices else found.group()


def in_words_of_command(texts: Iterable[str]) -> list[str]:
    """A text with Python's names of options replaced by those of the command line."""
    flags = {name: flag_of(name) for name in OPTIONS if name not in ("scale", "seeds", "priority", "layers", "growth")}
    return _renamed(texts, {**flags, "set priority": "set --priority"})  # a single word may not be an option


def help_of(name: str, spelled: Callable[[str], str] = str, quote: str = '"') -> str:
    """An option's description, with options spelled and choices quoted for the reader."""
    words = re.sub(rf"\b(?:{'|'.join(CONSTANTS)})\b", lambda found: f"{quote}{CONSTANTS[found[0]]}{quote}", OPTIONS[name].words)
    # A single word that begins a sentence is no option's name.
    names = "|".join(name if re.search("[a-z][A-Z]", name) else f"(?<=[a-z,;:] ){name}" for name in _PROPERTIES)
    # A statistic may have the name of an option, and keeps it.
    return re.sub(rf"(?<!\bstatistic )(?:{names})\b", lambda found: spelled(_PROPERTIES[found[0]]), words)


def flag_of(name: str) -> str:
    """An option's name on the command line."""
    return "--" + name.replace("_", "-")


def _renamed(texts: Iterable[str], names: Mapping[str, str]) -> list[str]:
    def new_name(found: re.Match[str]) -> str:
        return names[found.group()]

    return [re.sub(rf"(?<![-\w])(?:{'|'.join(names)})\b", new_name, text) for text in texts]


def describe_options(function: Function) -> Function:
    """Replace {options} in a function's help by descriptions of the options that it does not describe itself."""
    page = function.__doc__ or ""
    names = [name for name in inspect.signature(function).parameters if name in OPTIONS and f" {name}  " not in page]
    width = max(map(len, names)) + 2
    lines = [
        textwrap.fill(name.ljust(width) + help_of(name) + OPTIONS[name].more_words, 106, subsequent_indent=" " * width)
        for name in names
    ]
    function.__doc__ = re.sub(
        r"^( *)\{options\}$", lambda found: textwrap.indent("\n".join(lines), found[1]), page, flags=re.MULTILINE
    )
    return function
