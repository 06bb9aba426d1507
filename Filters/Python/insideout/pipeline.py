# SPDX-License-Identifier: GPL-3.0-or-later
"""Run VTK algorithms the Python way: errors are exceptions, warnings come back as a list.

VTK reports errors as events and prints those that nobody observes. `run` observes them, so that
nothing is printed and nothing goes unnoticed.
"""

from __future__ import annotations

import math
import re
import signal
import threading
from typing import Callable, Optional

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

Progress = Callable[[str, float], None]
"""Called with the name of what is being done and the fraction (0 to 1) of the whole that is done."""

STATISTICS_PREFIX = "Statistics_"
MEASURED = ("Seconds", "Energy", "MinimumW", "MaximumW", "NearDistance", "PeakMemory")  # all other statistics count


class Error(RuntimeError):
    """What a filter could not do, in one line that names the culprit."""


class Messages:
    """The errors and warnings of VTK objects, kept instead of printed.

    A context manager: it observes the objects from `with` on and lets go of them at its end.
    """

    def __init__(self, *objects: vtkObject):
        self.errors: list[str] = []
        self.warnings: list[str] = []
        self._objects = objects
        self._tags: list[tuple[vtkObject, int]] = []

    def __enter__(self) -> Messages:
        for observed in self._objects:
            for event, messages in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
                self._tags.append((observed, observed.AddObserver(event, _appender(messages))))
        return self

    def __exit__(self, *_) -> None:
        for observed, tag in self._tags:
            observed.RemoveObserver(tag)
        self._tags.clear()


def run(
    algorithm: vtkAlgorithm,
    progress: Optional[Progress] = None,
    action: Optional[Callable[[], object]] = None,
    harmless: tuple[str, ...] = (),
) -> list[str]:
    """Bring an algorithm up to date, or do `action` with it (`writer.Write`, say).

    Returns its warnings. Raises `Error` with its first error that does not begin with one of `harmless`. What is upstream of the algorithm
    reports for itself: run that before. Raises `KeyboardInterrupt` after Ctrl-C, when the algorithm has
    stopped, and whatever `progress` raises, which stops it too.
    """
    executive = algorithm.GetExecutive()
    with Messages(algorithm) as messages, Messages(executive) as executive_messages, _Stopper(algorithm, progress):
        (action or algorithm.Update)()
    # That a request failed, which is all the executive knows, counts only if nobody says why.
    for error in messages.errors or executive_messages.errors:
        if not error.startswith(harmless):
            raise Error(error)
    return messages.warnings


def statistics_of(data: vtkDataObject) -> dict[str, float]:
    """The figures that a filter put into the field data, by name; counts are ints."""
    field_data = data.GetFieldData()
    statistics: dict[str, float] = {}
    for index in range(field_data.GetNumberOfArrays()):
        name = field_data.GetArrayName(index) or ""
        array = field_data.GetArray(index)
        if name.startswith(STATISTICS_PREFIX) and array is not None and array.GetNumberOfValues() == 1:
            name, value = name[len(STATISTICS_PREFIX) :], array.GetTuple1(0)
            statistics[name] = value if name.startswith(MEASURED) else int(value)
    return statistics


def cells_of(data: vtkDataObject, name: str) -> list[int]:
    """The input cells that a filter listed in a field array: LeftOutCellIds or LostCellIds."""
    array = data.GetFieldData().GetArray(name)
    return [] if array is None else [int(array.GetTuple1(index)) for index in range(array.GetNumberOfValues())]


def at_least(least: float, name: str, value: float) -> float:
    """A filter's parameter. VTK would clamp a bad one without a word: here it is an `Error`."""
    value = float(value)
    if not math.isfinite(value) or value < least:
        raise Error(f"{name} is {value:g}; it must be finite and at least {least:g}")
    return value


def plain_message(decorated: str) -> str:
    """A VTK message without the file, line and address that VTK puts around it, in one line."""
    match = re.match(r"\w+: In .*?, line \d+\n\w+ \(\w+\): (.*)", decorated, re.DOTALL)
    lines = (match.group(1) if match else decorated).strip().splitlines()
    return lines[0] if lines else "unknown error"


def _appender(messages: list[str]) -> Callable:
    @calldata_type(VTK_STRING)
    def append(_object: vtkObject, _event: str, message: str) -> None:
        messages.append(plain_message(message))

    return append


class _Stopper:
    """While it is entered, Ctrl-C and what `progress` raises stop the algorithm, and come out at its end.

    VTK ends the program where an observer is interrupted, and forgets whatever else it raises.
    """

    def __init__(self, algorithm: vtkAlgorithm, progress: Optional[Progress]):
        self._algorithm = algorithm
        self._progress = progress
        self._reason: Optional[BaseException] = None
        self._handler = None

    def __enter__(self) -> None:
        self._algorithm.SetAbortExecute(0)
        self._tag = self._algorithm.AddObserver("ProgressEvent", self._observe)
        # Python lets only the main thread handle signals, and only what Python has set can be set again.
        if threading.current_thread() is threading.main_thread():
            handler = signal.getsignal(signal.SIGINT)
            if callable(handler):
                self._handler = handler
                signal.signal(signal.SIGINT, self._interrupt)

    def __exit__(self, *_) -> None:
        self._algorithm.RemoveObserver(self._tag)
        if self._handler is not None:
            signal.signal(signal.SIGINT, self._handler)
        if self._reason is not None:
            self._algorithm.SetAbortExecute(0)
            # What was stopped is not up to date, whatever the pipeline believes.
            self._algorithm.Modified()
            raise self._reason

    def _interrupt(self, *_) -> None:
        self._reason = self._reason or KeyboardInterrupt()

    def _observe(self, algorithm: vtkAlgorithm, _event: str) -> None:
        if self._reason is None and self._progress is not None:
            try:
                self._progress(algorithm.GetProgressText() or "working", algorithm.GetProgress())
            except Exception as error:
                self._reason = error
        if self._reason is not None:
            algorithm.SetAbortExecute(1)
