# SPDX-License-Identifier: GPL-3.0-or-later
"""`boolean`: set operations of bodies whose surfaces may be broken."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Iterable, Literal, Mapping, Optional, Union, get_args

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .bodies import as_body
from .calling import for_users
from .checking import check
from .data import Tetrahedra, TriangleSurface, as_type
from .errors import Error, brief, one_of, switch, text_of
from .lengths import Length
from .options import Options, Orientation, describe_options, in_words_of_python
from .pipeline import Progress, add_statistic, run, statistics_of
from .results import MeshResult, counted
from .statistics import Statistics
from .surfaces import AnySurface, is_stl
from .vtkFiltersInsideOut import vtkWindingBoolean

Operation = Literal["union", "intersection", "difference", "symmetric-difference"]


@dataclass(frozen=True, repr=False)
class Boolean(MeshResult):
    """The result of `boolean`. The VTK class vtkWindingBoolean describes the arrays."""

    surface: TriangleSurface
    """The result's boundary: watertight, oriented outward, without crossing triangles, with the data of all bodies."""
    solid: Tetrahedra
    """The result in tetrahedra, if a body was open, a gap was closed, or `tetrahedra` was given; else empty."""
    names: list[str]
    """The names of the bodies, by their `BodyId`."""
    statistics: Statistics
    """Counts, the volume and seconds, by name."""
    warnings: list[str]
    """Warnings about the bodies, one line each."""

    @property
    def bodies(self) -> NDArray[np.int32]:
        """The body of each triangle of the surface, as an index into `names`; -1 where a hole was closed."""
        return vtk_to_numpy(self.surface.GetCellData().GetArray("BodyId"))

    def figures(self) -> list[tuple[str, str]]:
        made = f" in {counted(self.solid.GetNumberOfCells())} tetrahedra" if self.statistics["Tetrahedra"] else ", without tetrahedra"
        return [
            ("bodies", ", ".join(self.names)),
            ("triangles", counted(self.surface.GetNumberOfCells()) + made),
            ("volume", f"{self.statistics['Volume']:.6g}"),
            *(("", warning) for warning in self.warnings),
        ]

    def seen(self) -> dict[str, Any]:
        return check(self.surface).seen() if self.surface.GetNumberOfCells() > 0 else {}


def letter(number: int) -> str:
    """vtkWindingBoolean's name of an unnamed body."""
    return chr(ord("A") + number) if number < 26 else str(number + 1)


@for_users
@describe_options
def boolean(
    surfaces: Union[Mapping[str, AnySurface], Iterable[AnySurface]],
    expression: Optional[str] = None,
    *,
    operation: Operation = "union",
    tetrahedra: bool = False,
    merge_coplanar_pieces: bool = False,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
    touch_tolerance: Optional[Length] = None,
    count_duplicates: bool = False,
    progress: Optional[Progress] = None,
) -> Boolean:
    """The surface of a set expression of several bodies, however broken their surfaces are.

    surfaces    several surfaces of any type that `insideout` accepts: a dict by name, as in {"liver": "liver.stl",
                "tumor": ...}, or a list, called A, B, C ...
    expression  such as "A - (B | C) ^ D". Operators are | or + (union), & (intersection), - (difference) and ^
                (symmetric difference), with the precedence that they have in Python: + and - first, then &, then ^,
                then |. A name with other characters than letters, digits and underscores stands in quotes; #1 is the
                first body
    operation   set operation of all bodies, if there is no expression: "union", "intersection", "difference" (the first
                minus the others) or "symmetric-difference"
    tetrahedra  make the result's tetrahedra, too; by default they are made only if a body is open or `merge_tolerance`
                closes a gap
    progress    called with the stage and the fraction of all the work that is done; an exception that it raises stops
                the work and is raised

    {options}

    Returns a `Boolean`. Raises `Error` with one line that names the culprit; for an expression, its column.
    """
    options = Options.among(locals())
    algorithm = vtkWindingBoolean()
    algorithm.SetOperation(get_args(Operation).index(one_of(get_args(Operation), "operation", operation)))
    algorithm.SetExpression("" if expression is None else text_of("expression", expression))
    algorithm.SetTetrahedra(switch("tetrahedra", tetrahedra))
    warnings: list[str] = []
    bodies: list[vtkPolyData] = []
    if isinstance(surfaces, (str, os.PathLike, vtkPolyData)) or not hasattr(surfaces, "__iter__") or is_stl(surfaces):
        raise Error(f"surfaces is of type {type(surfaces).__name__}; a boolean takes several surfaces: a list, or a dict by names")
    try:
        named = list(surfaces.items()) if isinstance(surfaces, Mapping) else [("", surface) for surface in surfaces]
    except TypeError:  # an array without a dimension
        raise Error(f"surfaces is {brief(surfaces)}; a boolean takes several surfaces") from None
    if not named:
        raise Error("there are no surfaces: a boolean takes one at least")
    for number, (name, surface) in enumerate(named):
        name = text_of("a body's name", name)
        polygons, more = as_body(name or letter(number), surface, options.factor())
        algorithm.AddInputDataObject(0, polygons)
        algorithm.AddBodyName(name)
        bodies.append(polygons)
        warnings += more
    options.measured_on(*bodies).set_on(algorithm)
    warnings += in_words_of_python(run(algorithm, progress))
    output = algorithm.GetOutput()
    add_statistic("Scale", options.factor(), output)
    names = output.GetFieldData().GetAbstractArray("BodyNames")
    return Boolean(
        surface=as_type(TriangleSurface, output),
        solid=as_type(Tetrahedra, algorithm.GetTetrahedraOutput()),
        names=[names.GetValue(index) for index in range(names.GetNumberOfValues())],
        statistics=statistics_of(output),
        warnings=warnings,
    )
