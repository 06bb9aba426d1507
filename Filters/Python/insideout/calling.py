# SPDX-License-Identifier: GPL-3.0-or-later
"""Common behavior of all functions: unknown arguments are an `Error`, and warnings are Python's."""

from __future__ import annotations

import difflib
import functools
import inspect
import warnings
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Sequence, TypeVar, cast

from .errors import Error, Warning, brief
from .options import error_in_words_of_python

Function = TypeVar("Function", bound=Callable[..., Any])

_heard: ContextVar[Optional[list[str]]] = ContextVar("heard", default=None)
"""The warnings so far of the function that a user has called."""


def for_users(function: Function) -> Function:
    """Decorate a function that a user calls. Its warnings, and the `warnings` of its result, become Python warnings of
    the category `Warning` that point at the caller, each once. Functions that it calls in turn pass their warnings to
    it.
    """
    signature = inspect.signature(function)

    @functools.wraps(function)
    def called(*given: Any, **named: Any) -> Any:
        _check_arguments(function.__name__, signature, given, named)
        outer = _heard.get()
        with _naming_options():
            if outer is not None:
                result = function(*given, **named)
                outer.extend(getattr(result, "warnings", ()))
                return result
            with _listening() as heard:
                result = function(*given, **named)
        for text in dict.fromkeys([*heard, *getattr(result, "warnings", ())]):
            warnings.warn(text, Warning, stacklevel=2)
        return result

    return cast(Function, called)


def tell(texts: Iterable[str]) -> None:
    """Warn about a result that cannot hold warnings: an array."""
    heard = _heard.get()
    if heard is not None:
        heard.extend(texts)


@contextmanager
def _naming_options() -> Iterator[None]:
    """Errors that name properties of a class name Python's options."""
    try:
        yield
    except Error as error:
        words = error_in_words_of_python(str(error))
        if words == str(error):
            raise
        raise type(error)(words) from error.__cause__


@contextmanager
def _listening() -> Iterator[list[str]]:
    heard: list[str] = []
    token = _heard.set(heard)
    try:
        yield heard
    finally:
        _heard.reset(token)


@contextmanager
def quietly() -> Iterator[None]:
    """Functions called meanwhile do not warn: their caller does."""
    with _listening():
        yield


def _check_arguments(name: str, signature: inspect.Signature, given: Sequence[Any], named: Mapping[str, Any]) -> None:
    """Raise `Error` for an unknown argument, with the nearest known one."""
    names = list(signature.parameters)
    hands_on = any(parameter.kind is parameter.VAR_KEYWORD for parameter in signature.parameters.values())
    for one in named:
        if one not in names and not hands_on:
            near = difflib.get_close_matches(one, names, 1)
            raise Error(f"{name} has no argument {one}" + (f"; the nearest is {near[0]}" if near else f"; it has {', '.join(names)}"))
    try:
        arguments = signature.bind(*given, **named).arguments
    except TypeError as error:
        raise Error(f"{name}: {error}") from None
    progress = arguments.get("progress")
    if progress is not None and not callable(progress):
        raise Error(f"progress is {brief(progress)}; it must be a function of a stage's name and a fraction")
