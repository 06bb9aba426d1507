# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions and warnings, and the checks of arguments that raise them."""

from __future__ import annotations

import math
from typing import Any, Collection

MOST_OF_VALUE = 60  # length to which messages shorten a value


class Error(RuntimeError):
    """A function's failure, in one line that names the culprit."""

    def __init__(self, words: str):
        super().__init__("\\n".join(words.splitlines()))  # names of files may have several


class ArgumentError(Error):
    """An argument that is invalid for any content of the files."""


class Warning(UserWarning):  # noqa: A001
    """A note that may change an answer, in one line: the category of all warnings here."""


def finite(name: str, value: Any) -> float:
    """Return a number given by a function's caller. Raises `ArgumentError` for anything else."""
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    except Exception:  # noqa: BLE001 - whatever an object's __float__ raises
        raise ArgumentError(f"{name} is {brief(value)}; it must be a number") from None
    if not math.isfinite(number):
        raise ArgumentError(f"{name} is {brief(value)}; it must be finite")
    return number


def at_least(least: float, name: str, value: Any) -> float:
    """Return a filter's parameter. VTK would clamp an invalid one silently: here it is an `ArgumentError`."""
    number = finite(name, value)
    if number < least:
        raise ArgumentError(f"{name} is {number:g}; it must be finite and at least {least:g}")
    return number


def one_of(choices: Collection[Any], name: str, value: Any) -> Any:
    """Return a choice given by a function's caller. Raises `ArgumentError` for anything else."""
    try:
        known = value in set(choices)
    except TypeError:  # a value without a hash is no choice
        known = False
    if not known:
        raise ArgumentError(f"{name} is {brief(value)}; it can be {', '.join(map(repr, choices))}")
    return value


def switch(name: str, value: Any) -> bool:
    """Return True or False as given by a function's caller."""
    try:
        return bool({True: True, False: False}[value])
    except (KeyError, TypeError):
        raise ArgumentError(f"{name} is {brief(value)}; it must be True or False") from None


def text_of(name: str, value: Any) -> str:
    """Return a name or other text of a function's caller that VTK can hold."""
    if not isinstance(value, str) or "\0" in value or any("\ud800" <= letter <= "\udfff" for letter in value):
        raise ArgumentError(f"{name} is {brief(value)}; it must be text")
    return value


def brief(value: Any) -> str:
    """A value as it appears in a message: one line, not too long."""
    try:
        words = " ".join(repr(value).split())
    except Exception:  # noqa: BLE001 - whatever an object's __repr__ raises
        words = f"a {type(value).__name__}"
    return words if len(words) <= MOST_OF_VALUE else words[:MOST_OF_VALUE] + " ..."
