# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of sizes: lengths in percent, and backgrounds, whose data sets a filter gets beside its rules."""

from __future__ import annotations

import os
import re
from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from vtkmodules.vtkCommonDataModel import vtkDataSet
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

from .errors import ArgumentError, Error, brief
from .inputs import DataSetOfPoints, path_of

SizeRules = Union[str, Sequence[str], Mapping[str, Union[float, str, DataSetOfPoints]]]

BACKGROUND = "background"
"""The word of rules that name a data set."""

BACKGROUND_ENDINGS = (".vti", ".vtr", ".vts", ".vtu", ".vtp")


def listed(name: str, value: Any) -> list[Tuple[str, Any]]:
    """The rules as pairs of what they are of and a number, a share as text, or a data set."""
    if isinstance(value, Mapping):
        return list(value.items())
    given = value.split(";") if isinstance(value, str) else value
    if not isinstance(given, (list, tuple)) or not all(isinstance(one, str) and one.count(";") == 0 for one in given):
        raise ArgumentError(f"{name} is {brief(value)}; it must be WHAT=NUMBER, a list of such texts, or a dict")
    pairs = []
    for rule in (one.strip() for one in given):
        what, equals, number = rule.rpartition("=")
        if rule.split(" ")[0].split("=")[0] == BACKGROUND:  # the names of files may have an equals sign
            what, equals, number = rule.partition("=")
        if rule:
            pairs.append((what.strip() if equals else rule, number.strip() if equals else None))
    return pairs


def has_shares(value: Any) -> bool:
    """Whether a length of rules is in percent."""
    return value is not None and any(_percent(number) is not None for _, number in listed("size_rules", value))


def with_numbers(value: Any, diagonal: float) -> Any:
    """The rules with each share as a number."""
    pairs = [(what, number if (share := _percent(number)) is None else share * diagonal) for what, number in listed("size_rules", value)]
    return dict(pairs) if isinstance(value, Mapping) else [what if number is None else f"{what}={number}" for what, number in pairs]


def text_of_rules(name: str, value: Any) -> str:
    """The rules but for backgrounds, as the filter takes them."""
    pairs = [(what, number) for what, number in listed(name, value) if not _is_background(what)]
    for what, number in pairs:
        if ";" in str(what) or not isinstance(number, (int, float, str, type(None))) or isinstance(number, bool):
            raise ArgumentError(f"{name} has {brief(number)} for {what}; it must be a number")
    return ";".join(str(what) if number is None else f"{what}={number!r}" if isinstance(number, float) else f"{what}={number}" for what, number in pairs)


def background_of(name: str, value: Any) -> Optional[Tuple[vtkDataSet, str]]:
    """The data set of the rule for a background and the name of its point array of lengths. Raises `Error`."""
    found = [(what, given) for what, given in listed(name, value) if _is_background(what)]
    if not found:
        return None
    if len(found) > 1:
        raise ArgumentError(f"{name} has {len(found)} backgrounds; it can have one")
    what, given = found[0]
    array = what.removeprefix(BACKGROUND).strip()
    data = given if isinstance(given, vtkDataSet) else _read(path_of(name, given or ""))
    names = [data.GetPointData().GetArrayName(index) for index in range(data.GetPointData().GetNumberOfArrays())]
    if not array and len(names) != 1:
        raise ArgumentError(f"{name}: the background has the point arrays {', '.join(map(str, names)) or 'none'}; name that of lengths: {BACKGROUND} ARRAY")
    return data, array or names[0]


def _is_background(what: Any) -> bool:
    return isinstance(what, str) and re.match(rf"{BACKGROUND}(\s|$)", what) is not None


def _percent(number: Any) -> Optional[float]:
    found = re.fullmatch(r"([\d.]+(?:[eE][-+]?\d+)?)\s*%", number) if isinstance(number, str) else None
    try:
        return float(found[1]) / 100 if found else None
    except ValueError:
        return None


def _read(path: str) -> vtkDataSet:
    if not path.endswith(BACKGROUND_ENDINGS):
        raise Error(f"{path or 'a background without a name'}: a background is a file of VTK with points, {' '.join(BACKGROUND_ENDINGS)}")
    if not os.access(path, os.R_OK):  # the reader of VTK names no reason
        raise Error(f"{path}: there is no such file, or it cannot be read")
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if not isinstance(data, vtkDataSet) or data.GetNumberOfPoints() == 0:
        raise Error(f"{path}: no data set of VTK with points")
    return data
