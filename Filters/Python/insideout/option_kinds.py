# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds of options: what each takes, and how it comes to VTK's filters and to the command line."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Iterable, Optional, Tuple, Union

from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPointSet, vtkPolyData

from .inputs import DataSetOfPoints
from .pipeline import Error, at_least, one_of
from .places import read_seeds
from .vtkFiltersInsideOut import vtkRobustTetrahedralize

Seed = Union[Tuple[Tuple[float, float, float], bool], Tuple[Tuple[float, float, float], bool, str]]
Seeds = Union[DataSetOfPoints, str, Iterable[Seed]]


@dataclass(frozen=True)
class Option:
    """What stands behind a field of `Options`. As it is, the field is the name of an array."""

    vtk_property: str
    words: str  # what it means, on the command line too
    more_words: str = ""  # what else it can be in Python
    default: Any = None  # what leaves a filter its own default
    alias: str = ""  # an earlier name on the command line, which no help tells

    def checked(self, algorithm: Any, name: str, value: Any) -> Any:
        """What a filter's property gets. Raises `Error` for what VTK would clamp without a word."""
        return value

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        owner = owner_of(algorithm, self.vtk_property)
        getattr(owner, "Set" + self.vtk_property)(self.checked(owner, name, value))

    def used_by(self, algorithm: Any, value: Any) -> Any:
        """What a filter goes by on which this value was set."""
        return value

    def used_number(self, algorithm: Any) -> Any:
        return getattr(owner_of(algorithm, self.vtk_property), "Get" + self.vtk_property)()

    def help(self) -> str:
        return self.words

    def argument(self) -> dict[str, Any]:
        """What argparse is to know of it besides."""
        return {"metavar": "ARRAY"}


@dataclass(frozen=True)
class Number(Option):
    least: float = 0
    most: Optional[float] = None

    def checked(self, algorithm: Any, name: str, value: Any) -> float:
        number = at_least(self.least, name, value)
        if self.most is not None and number > self.most:
            raise Error(f"{name} is {number:g}; it must be at most {self.most:g}")
        return number

    def used_by(self, algorithm: Any, value: Any) -> float:
        return self.used_number(algorithm)

    def help(self) -> str:
        limits = f"at least {self.least:g}" if self.most is None else f"{self.least:g} to {self.most:g}"
        return f"{self.words}; {limits}, default {self.used_by(vtkRobustTetrahedralize(), None):g}"

    def argument(self) -> dict[str, Any]:
        return {"metavar": "NUMBER", "type": float}


@dataclass(frozen=True)
class Choice(Option):
    choices: tuple[str, ...] = ()
    prefix: str = ""  # of VTK's constants, which are named like the choices

    def checked(self, algorithm: Any, name: str, value: Any) -> int:
        return getattr(algorithm, self.prefix + one_of(self.choices, name, value).upper().replace("-", "_"))

    def help(self) -> str:
        return f"{self.words}; default {self.default}"

    def argument(self) -> dict[str, Any]:
        return {"choices": self.choices}


class Dimensions(Choice):
    """A number, too; it chooses the filter."""

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        one_of(self.choices, name, str(value))


@dataclass(frozen=True)
class Switch(Option):
    default: bool = False

    def checked(self, algorithm: Any, name: str, value: Any) -> bool:
        return bool(value)

    def argument(self) -> dict[str, Any]:
        return {"action": "store_true"}


@dataclass(frozen=True)
class Order(Option):
    """A whole number within a range."""

    least: int = 1
    most: int = 1

    def checked(self, algorithm: Any, name: str, value: Any) -> int:
        return int(one_of(tuple(range(self.least, self.most + 1)), name, value))

    def used_by(self, algorithm: Any, value: Any) -> int:
        return self.used_number(algorithm)

    def help(self) -> str:
        return f"{self.words}; {self.least} to {self.most}, default {self.used_by(vtkRobustTetrahedralize(), None)}"

    def argument(self) -> dict[str, Any]:
        return {"metavar": "ORDER", "type": int, "choices": range(self.least, self.most + 1)}


class Count(Option):
    """A whole number of at least 0."""

    MOST = 2**31 - 1

    def checked(self, algorithm: Any, name: str, value: Any) -> int:
        number = at_least(0, name, value)
        if number != int(number) or number > self.MOST:
            raise Error(f"{name} is {value:g}; it must be a whole number of at most {self.MOST}")
        return int(number)

    def used_by(self, algorithm: Any, value: Any) -> int:
        return self.used_number(algorithm)

    def help(self) -> str:
        return f"{self.words}; default {self.used_by(vtkRobustTetrahedralize(), None)}"

    def argument(self) -> dict[str, Any]:
        return {"metavar": "COUNT", "type": int}


class SwitchOrArray(Switch):
    """On by the name of an array too, which chooses the facets."""

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        super().set_on(algorithm, name, value)
        if isinstance(value, str):
            algorithm.SetConstrainedFacetsArrayName(value)


@dataclass(frozen=True)
class Scale(Option):
    """What a surface's coordinates are multiplied by before any filter has it: there is no property."""

    def checked(self, algorithm: Any, name: str, value: Any) -> float:
        if not at_least(0, name, value) > 0:
            raise Error(f"{name} is {value:g}; it must be above 0")
        return float(value)

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        self.checked(algorithm, name, value)

    def used_by(self, algorithm: Any, value: Any) -> float:
        return 1.0 if value is None else float(value)

    def help(self) -> str:
        return f"{self.words}; default 1"

    def argument(self) -> dict[str, Any]:
        return {"metavar": "FACTOR", "type": float}


class Names(Option):
    """A list of names, or these as one text, parted by commas."""

    def checked(self, algorithm: Any, name: str, value: Any) -> str:
        if isinstance(value, str):
            return value
        if not isinstance(value, (list, tuple)) or not all(isinstance(one, str) for one in value):
            raise Error(f"{name} is {value!r}; it must be a list of names")
        return ",".join(re.sub(r"([\\\\,])", r"\\\1", one) for one in value)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "NAME,NAME..."}


class Places(Option):
    def checked(self, algorithm: Any, name: str, value: Any) -> vtkPointSet:
        if isinstance(value, vtkPointSet):
            return value
        return _seed_points(read_seeds(value) if isinstance(value, str) else value)

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        algorithm.SetSeedsData(self.checked(algorithm, name, value))

    def argument(self) -> dict[str, Any]:
        return {"metavar": "FILE.csv"}


def owner_of(algorithm: Any, vtk_property: str) -> Any:
    """The filter that declares a property: a stage that the given one hands out, or it itself. None where neither does."""
    stages = (getattr(algorithm, name)() for name in ("GetWindingNumber", "GetSegmentation", "GetRefinement") if hasattr(algorithm, name))
    return next((owner for owner in (*stages, algorithm) if hasattr(owner, "Set" + vtk_property)), None)


def _seed_points(seeds: Iterable[Seed]) -> vtkPolyData:
    points, inside, bodies = vtkPoints(), vtkUnsignedCharArray(), vtkStringArray()
    points.SetDataType(VTK_DOUBLE)
    inside.SetName("Inside")
    bodies.SetName("Body")
    try:
        for place, is_inside, *body in seeds:
            x, y, z = map(float, place)
            name = "".join(body)
            points.InsertNextPoint(x, y, z)
            inside.InsertNextValue(bool(is_inside))
            bodies.InsertNextValue(name)
    except (TypeError, ValueError):
        raise Error(f"seed {inside.GetNumberOfValues()} is no pair of a point and a bool") from None
    data = vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().AddArray(inside)
    data.GetPointData().AddArray(bodies)
    return data
