# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds of options: their values, and their mapping to VTK's filters and to the command line."""

from __future__ import annotations

import argparse
import os
import re
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPointSet, vtkPolyData

from .declared import Declared
from .errors import ArgumentError, Error, at_least, brief, one_of, switch, text_of
from .inputs import DataSetOfPoints, path_of
from .places import read_seeds
from .sizing import background_of, text_of_rules

Seed = Union[Tuple[Tuple[float, float, float], bool], Tuple[Tuple[float, float, float], bool, str]]
Seeds = Union[DataSetOfPoints, str, Iterable[Seed]]
TagFunction = Callable[[NDArray[np.float64], NDArray[np.float64]], ArrayLike]
TagRules = Union[str, Sequence[str], Mapping[str, Union[str, TagFunction]]]


@dataclass(frozen=True)
class Option:
    """The kind of a field of `Options`. This base class is the kind of an array's name."""

    vtk_property: str
    words: str  # description, with the names of properties and constants
    more_words: str = ""  # further values in Python
    least: float = 0
    most: Optional[float] = None
    choices: tuple[str, ...] = ()  # in the order of VTK's constants, from 0

    def checked(self, name: str, value: Any) -> Any:
        """Return the value of a filter's property. Raises `Error` for values that VTK would clamp silently."""
        return text_of(name, value)

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        getattr(owner_of(algorithm, self.vtk_property), "Set" + self.vtk_property)(self.checked(name, value))

    def used_by(self, algorithm: Any, value: Any) -> Any:
        """The filter's value for this value of the option."""
        return value

    def used_number(self, algorithm: Any) -> Any:
        owner = owner_of(algorithm, self.vtk_property)
        return None if owner is None else getattr(owner, "Get" + self.vtk_property)()

    def argument(self) -> dict[str, Any]:
        """Further arguments for argparse."""
        return {"metavar": "ARRAY"}


class Number(Option):
    def checked(self, name: str, value: Any) -> float:
        number = at_least(self.least, name, value)
        if self.most is not None and number > self.most:
            raise ArgumentError(f"{name} is {number:g}; it must be at most {self.most:g}")
        return number

    def used_by(self, algorithm: Any, value: Any) -> float:
        return self.used_number(algorithm)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "NUMBER", "type": float}


class Lengths(Number):
    """A number, or a share of the diagonal, which `Options.measured_on` converts."""

    def used_by(self, algorithm: Any, value: Any) -> Any:
        return value if isinstance(value, str) else self.used_number(algorithm)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "LENGTH", "type": _length}


class Choice(Option):
    def checked(self, name: str, value: Any) -> int:
        return self.choices.index(one_of(self.choices, name, value))

    def argument(self) -> dict[str, Any]:
        return {"choices": self.choices}


class Dimensions(Choice):
    """The number of dimensions, which selects the filter."""

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        one_of(self.choices, name, str(value) if isinstance(value, int) else value)


class Switch(Option):
    def checked(self, name: str, value: Any) -> bool:
        return switch(name, value)

    def argument(self) -> dict[str, Any]:
        return {"action": "store_true"}


class Decision(Option):
    """A switch with the default None, which depends on other options."""

    def checked(self, name: str, value: Any) -> bool:
        return switch(name, value)

    def argument(self) -> dict[str, Any]:
        return {"action": argparse.BooleanOptionalAction}


class Order(Option):
    """A whole number within a range."""

    def range(self) -> range:
        return range(int(self.least), int(self.most or 0) + 1)

    def checked(self, name: str, value: Any) -> int:
        return int(one_of(tuple(self.range()), name, value))

    def used_by(self, algorithm: Any, value: Any) -> int:
        return self.used_number(algorithm)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "ORDER", "type": int, "choices": self.range()}


class Count(Option):
    """A whole number of at least 0."""

    MOST = 2**31 - 1

    def checked(self, name: str, value: Any) -> int:
        number = at_least(self.least, name, value)
        if number != int(number) or number > self.MOST:
            raise ArgumentError(f"{name} is {brief(value)}; it must be a whole number of at most {self.MOST}")
        return int(number)

    def used_by(self, algorithm: Any, value: Any) -> int:
        return self.used_number(algorithm)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "COUNT", "type": int}


class ChosenFacets(Option):
    """The array that selects the facets to keep; it switches keeping on."""

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        super().set_on(algorithm, name, value)
        owner_of(algorithm, "ConstrainFacets").SetConstrainFacets(True)


class Scale(Option):
    """The factor of a surface's coordinates, applied before all filters; it is no property of a filter."""

    def checked(self, name: str, value: Any) -> float:
        if not at_least(0, name, value) > 0:
            raise ArgumentError(f"{name} is {value:g}; it must be above 0")
        return float(value)

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        self.checked(name, value)

    def used_by(self, algorithm: Any, value: Any) -> float:
        return 1.0 if value is None else float(value)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "FACTOR", "type": float}


class Names(Option):
    """A list of names, or one text with comma-separated names."""

    def checked(self, name: str, value: Any) -> str:
        if isinstance(value, str):
            return text_of(name, value)
        if not isinstance(value, (list, tuple)) or not all(isinstance(one, str) for one in value):
            raise ArgumentError(f"{name} is {brief(value)}; it must be a list of names")
        return ",".join(re.sub(r"([\\\\,])", r"\\\1", text_of(name, one)) for one in value)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "NAME,NAME..."}


class Rules(Option):
    """Rules by name, or each as NAME=CONDITION. Functions were converted to arrays before (see tagging.py)."""

    def checked(self, name: str, value: Any) -> str:
        if isinstance(value, str):
            return text_of(name, value)
        given = [f"{tag}={rule}" for tag, rule in value.items()] if isinstance(value, Mapping) else value
        if not isinstance(given, (list, tuple)) or not all(isinstance(one, str) and one.count(";") == 0 for one in given):
            raise ArgumentError(f"{name} is {brief(value)}; it must be conditions by names, without semicolons")
        return ";".join(text_of(name, one) for one in given)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "NAME=CONDITION", "action": _JoinRules}


class SizesByRules(Option):
    """Rules of sizes; a background among them is a data set of its own for the filter (see sizing.py)."""

    def checked(self, name: str, value: Any) -> str:
        return text_of(name, text_of_rules(name, value))

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        super().set_on(algorithm, name, value)
        found = background_of(name, value)
        if found:
            owner = owner_of(algorithm, self.vtk_property)
            data, array = found
            owner.SetBackgroundData(data)
            owner.SetSizingArrayName(array)

    def argument(self) -> dict[str, Any]:
        return {"metavar": "WHAT=NUMBER", "action": _JoinRules}


class _JoinRules(argparse.Action):
    """Append each rule to those before it."""

    def __call__(self, _: object, namespace: argparse.Namespace, value: Any, __: object = None) -> None:
        rules = getattr(namespace, self.dest, None)
        setattr(namespace, self.dest, f"{rules};{value}" if rules else value)


class Places(Option):
    def checked(self, name: str, value: Any) -> vtkPointSet:
        if isinstance(value, vtkPointSet):
            return value
        return _seed_points(read_seeds(path_of(name, value)) if isinstance(value, (str, os.PathLike)) else value)

    def set_on(self, algorithm: Any, name: str, value: Any) -> None:
        algorithm.SetSeedsData(self.checked(name, value))

    def argument(self) -> dict[str, Any]:
        return {"metavar": "FILE.csv"}


def kind_of(one: Declared) -> type[Option]:
    """The kind of an option that a class declares."""
    if one.choices:
        return Choice
    whole = Count if one.most is None else Order
    return {"bool": Switch, "int": whole, "double": Number, "string": Option}[one.kind]


def owner_of(algorithm: Any, vtk_property: str) -> Any:
    """The filter that declares a property: the given one, one of its stages, or None."""
    stages = (getattr(algorithm, name)() for name in ("GetWindingNumber", "GetSegmentation", "GetRefinement") if hasattr(algorithm, name))
    return next((owner for owner in (*stages, algorithm) if hasattr(owner, "Set" + vtk_property)), None)


def _length(text: str) -> Union[float, str]:
    """Convert a length for argparse: to a number, or the text of a share."""
    return text if text.endswith("%") else float(text)


def _seed_points(seeds: Iterable[Seed]) -> vtkPolyData:
    points, inside, bodies = vtkPoints(), vtkUnsignedCharArray(), vtkStringArray()
    points.SetDataType(VTK_DOUBLE)
    inside.SetName("Inside")
    bodies.SetName("Body")
    try:
        for place, is_inside, *body in seeds:
            x, y, z = map(float, place)
            name = text_of("a seed's body", "".join(body))
            points.InsertNextPoint(x, y, z)
            inside.InsertNextValue(bool(is_inside))
            bodies.InsertNextValue(name)
    except (TypeError, ValueError, OverflowError):
        raise Error(f"seed {inside.GetNumberOfValues()} is not a pair of a point and a bool") from None
    data = vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().AddArray(inside)
    data.GetPointData().AddArray(bodies)
    return data
