# SPDX-License-Identifier: GPL-3.0-or-later
"""Run VTK algorithms the Python way: errors are exceptions, warnings come back as a list.

VTK reports errors as events and prints those without an observer. `run` observes them, so that none is printed or lost.
It releases the interpreter lock while VTK works: other threads of Python run meanwhile, and Ctrl-C stops the algorithm.
"""

from __future__ import annotations

import ctypes
import re
import signal
import threading
from types import FrameType
from typing import Any, Callable, Mapping, Optional

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkObject, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkFieldData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkIOCore import vtkWriter
from vtkmodules.vtkIOXML import vtkXMLWriter

from . import vtkFiltersInsideOut as _classes
from .errors import Error
from .interruption import before_end_at_once
from .stages import UNNAMED
from .statistics import Statistics

Progress = Callable[[str, float], object]
"""Called with the name of the current stage and the fraction (0 to 1) of the whole work that is done."""

STATISTICS, STATISTICS_NAMES = "Statistics", "StatisticsNames"
"""The field arrays with figures and their names."""

MEASURED = (
    *("Seconds", "Energy", "MinimumW", "MaximumW", "NearDistance", "PeakMemory", "Scale", "Diagonal", "EnclosedVolume", "OpenLength"),
    *("OverlapVolume", "GapVolume", "LostShare", "SheetShare", "MembraneShare", "TurnedShare", "Volume", "CenterOfMass", "Inertia", "MinDihedralAngle"),
    *("DihedralAngle1Percent", "MaxDihedralAngle", "RadiusEdgeRatio99Percent", "MaxRadiusEdgeRatio", "MinMeanRatio"),
    *("AverageMeanRatio", "SurfaceTolerance", "SurfaceDistance", "InputDistance", "Area", "MinAngle", "Angle1Percent", "MaxAngle"),
    *("DroppedVolume", "FilledVolume", "Genus", "FullHeightShare", "MeanHeightShare"),
)
"""The prefixes of statistics that are no counts; statistics of tetrahedra before refinement have the prefix Before."""


class Messages:
    """The errors of VTK objects, kept instead of printed. A context manager: it observes the objects within the `with`
    block.
    """

    def __init__(self, *objects: vtkObject):
        self.errors: list[str] = []
        self._objects = objects
        self._tags: list[tuple[vtkObject, int]] = []

    def __enter__(self) -> Messages:
        @calldata_type(VTK_STRING)
        def append(_object: vtkObject, _event: str, message: str) -> None:
            self.errors.append(plain_message(message))

        self._tags = [(observed, observed.AddObserver("ErrorEvent", append)) for observed in self._objects]
        return self

    def __exit__(self, *_: object) -> None:
        for observed, tag in self._tags:
            observed.RemoveObserver(tag)
        self._tags.clear()


def run(algorithm: vtkAlgorithm, progress: Optional[Progress] = None, harmless: tuple[str, ...] = ()) -> list[str]:
    """Update an algorithm, or write with a writer. Returns its warnings. Raises `Error` with its first error that does
    not begin with one of `harmless`. Algorithms upstream report their own errors: run them before. Raises
    `KeyboardInterrupt` after Ctrl-C, when the algorithm has stopped, and whatever `progress` raises, which stops it
    too.
    """
    _require_memory(algorithm)
    algorithm.SetAbortExecute(0)
    try:
        with _Listener(progress) as listener:
            _update(algorithm, listener)
        listener.raise_error(harmless)
    except BaseException:
        algorithm.SetAbortExecute(0)
        # Otherwise it would count as up to date, and report nothing the next time.
        algorithm.Modified()
        raise
    return listener.messages[_WARNING]


def run_with_upstream(algorithm: vtkAlgorithm) -> list[str]:
    """Run an algorithm and all that are upstream of it, one after the other: each reports its own errors."""
    warnings = []
    for port in range(algorithm.GetNumberOfInputPorts()):
        for connection in range(algorithm.GetNumberOfInputConnections(port)):
            warnings += run_with_upstream(algorithm.GetInputAlgorithm(port, connection))
    return warnings + run(algorithm)


def write_data(data: vtkDataObject, path: str) -> None:
    """Write a data set in VTK's XML format for its type. See `write_bytes`."""
    if not _memory_suffices_for(data):
        raise Error(f"{path}: not enough memory to write it")
    with _Listener() as listener:
        _unlocked.vtkInsideOutWriteData(_address(data, "vtkDataObject"), path.encode(), listener.function)
    listener.raise_error()


def plain_polygons(surface: vtkPolyData, in_floats: bool) -> tuple[vtkPolyData, list[str]]:
    """The checked polygons of a surface (strips as triangles), its points rounded to floats, and warnings of this
    rounding."""
    plain = vtkPolyData()
    with _Listener() as listener:
        _unlocked.vtkInsideOutPlainPolygons(*(_address(data, "vtkDataObject") for data in (surface, plain)), in_floats, listener.function)
    listener.raise_error()
    return plain, listener.messages[_WARNING]


def write_bytes(content: bytes, path: str) -> None:
    """Write a file, whole or not at all: an earlier one stays until it is complete. Raises `Error` that names the file,
    and `KeyboardInterrupt` after Ctrl-C.
    """
    with _Listener() as listener:
        _unlocked.vtkInsideOutWriteBytes(content, len(content), path.encode(), listener.function)
    listener.raise_error()


def _require_memory(algorithm: vtkAlgorithm) -> None:
    """Raise `Error` for too large data, for which VTK would end the program. The classes of this module do that
    themselves."""
    inputs = (
        algorithm.GetInputDataObject(port, connection)
        for port in range(algorithm.GetNumberOfInputPorts())
        for connection in range(algorithm.GetNumberOfInputConnections(port))
    )
    if not hasattr(_classes, algorithm.GetClassName()) and not _memory_suffices_for(*inputs):
        raise Error("not enough memory")


def _memory_suffices_for(*inputs: Optional[vtkDataObject]) -> bool:
    """VTK's copies of data are rarely larger than twice these."""
    try:
        np.empty(2048 * sum(data.GetActualMemorySize() for data in inputs if data is not None), np.uint8)
    except MemoryError:
        return False
    return True


def statistics_of(data: vtkDataObject) -> Statistics:
    """The statistics in the field data of a filter's output, by name; counts are ints."""
    field_data = data.GetFieldData()
    statistics = Statistics()
    values, names = field_data.GetArray(STATISTICS), strings_of(field_data.GetAbstractArray(STATISTICS_NAMES))
    if values is None:
        return statistics
    for index, name in enumerate(names[: values.GetNumberOfTuples()]):
        value = values.GetTuple1(index)
        statistics[name] = value if name.removeprefix("Before").startswith(MEASURED) else int(value)
    return statistics


def fields_of(statistics: Mapping[str, float]) -> vtkFieldData:
    """Field data with these statistics, as filters store them."""
    values, names, fields = vtkDoubleArray(), vtkStringArray(), vtkFieldData()
    for array, name in ((values, STATISTICS), (names, STATISTICS_NAMES)):
        array.SetName(name)
        fields.AddArray(array)
    for name, value in statistics.items():
        values.InsertNextValue(value)
        names.InsertNextValue(name)
    return fields


def add_statistic(name: str, value: float, data: vtkDataObject) -> None:
    """Add a figure to the field data."""
    fields = data.GetFieldData()
    values, names = vtkDoubleArray(), vtkStringArray()
    for array, kept in ((values, STATISTICS), (names, STATISTICS_NAMES)):
        if fields.GetAbstractArray(kept) is not None:
            array.DeepCopy(fields.GetAbstractArray(kept))
        array.SetName(kept)
        fields.AddArray(array)
    index = names.LookupValue(name)
    if index >= 0:
        values.SetValue(index, value)
    else:
        values.InsertNextValue(value)
        names.InsertNextValue(name)


def strings_of(array: Any) -> list[str]:
    """The strings of a vtkStringArray; for an array from a .vtu file the names of its components; empty for None."""
    if isinstance(array, vtkStringArray):
        return [array.GetValue(index) for index in range(array.GetNumberOfValues())]
    return [] if array is None else [array.GetComponentName(index) or "" for index in range(array.GetNumberOfComponents())]


def cells_of(data: vtkDataObject, name: str) -> list[int]:
    """The input cells that a filter listed in a field array: LeftOutCellIds, LostCellIds or TurnedCellIds."""
    array = data.GetFieldData().GetArray(name)
    return [] if array is None else [int(array.GetTuple1(index)) for index in range(array.GetNumberOfValues())]


def plain_message(decorated: str) -> str:
    """A VTK message in one line, without VTK's file, line and address."""
    match = re.match(r"\w+: In .*?, line \d+\n\w+ \(\w+\): (.*)", decorated, re.DOTALL)
    lines = (match.group(1) if match else decorated).strip().splitlines()
    return lines[0] if lines else "unknown error"


# Names of a listener's events, as in vtkInsideOutUpdate.h.
_PROGRESS, _WARNING, _ERROR, _REQUEST_FAILED = range(4)

_ListenerFunction = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int, ctypes.c_char_p, ctypes.c_double)

# The library behind the wrapped classes, called with the interpreter's lock released or held.
_unlocked, _locked = ctypes.CDLL(_classes.__file__), ctypes.PyDLL(_classes.__file__)
for _library in (_unlocked, _locked):
    _library.vtkInsideOutUpdate.argtypes = [ctypes.c_void_p, ctypes.c_int, _ListenerFunction]
_unlocked.vtkInsideOutWriteData.argtypes = [ctypes.c_void_p, ctypes.c_char_p, _ListenerFunction]
_unlocked.vtkInsideOutWriteData.restype = None
_unlocked.vtkInsideOutWriteBytes.argtypes = [ctypes.c_char_p, ctypes.c_size_t, ctypes.c_char_p, _ListenerFunction]
_unlocked.vtkInsideOutWriteBytes.restype = None
_unlocked.vtkInsideOutPlainPolygons.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int, _ListenerFunction]
_unlocked.vtkInsideOutPlainPolygons.restype = None
_unlocked.vtkInsideOutRemoveUnfinishedFiles.argtypes = []
_unlocked.vtkInsideOutRemoveUnfinishedFiles.restype = None
before_end_at_once(_unlocked.vtkInsideOutRemoveUnfinishedFiles)


def set_threads(number: int) -> None:
    """Set the number of threads, at least 1, of filters that this Python thread runs. They warn if it is too large."""
    try:
        _locked.omp_set_num_threads(ctypes.c_int(min(number, 2**31 - 1)))
    except AttributeError:
        pass  # built without OpenMP: there is one


class _Listener:
    """Receives the events of C++ code. Signals and exceptions of `progress` stop it, and are raised at its end. VTK
    would end the program if an observer were interrupted, and would drop other exceptions.
    """

    def __init__(self, progress: Optional[Progress] = None):
        self.messages: dict[int, list[str]] = {_WARNING: [], _ERROR: [], _REQUEST_FAILED: []}
        self.function = _ListenerFunction(self._hear)
        self._progress = progress
        self._reason: Optional[BaseException] = None
        self._handlers: dict[int, Callable[[int, Optional[FrameType]], Any]] = {}

    def __enter__(self) -> _Listener:
        # Only the main thread of Python can handle signals, and only handlers set by Python can be restored.
        if threading.current_thread() is threading.main_thread():
            for number, stop in ((signal.SIGINT, self._interrupt), (signal.SIGTERM, self._terminate)):
                handler = signal.getsignal(number)
                if callable(handler):
                    self._handlers[number] = handler
                    signal.signal(number, stop)
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._handlers.items():
            signal.signal(number, handler)
        if self._reason is not None:
            raise self._reason

    def raise_error(self, harmless: tuple[str, ...] = ()) -> None:
        """Raise the first error that does not begin with one of `harmless`."""
        # The executive reports only that a request failed, which counts only without another error.
        for error in self.messages[_ERROR] or self.messages[_REQUEST_FAILED]:
            if not error.startswith(harmless):
                raise Error(error)

    def _interrupt(self, _signal: int, _frame: Optional[FrameType]) -> None:
        self._reason = self._reason or KeyboardInterrupt()

    def _terminate(self, number: int, frame: Optional[FrameType]) -> None:
        try:
            self._handlers[number](number, frame)
        except BaseException as error:
            self._reason = self._reason or error

    def _hear(self, event: int, text: Optional[bytes], fraction: float) -> int:
        words = (text or b"").decode(errors="backslashreplace")
        if event != _PROGRESS:
            self.messages[event].append(plain_message(words))
        elif self._reason is None and self._progress is not None:
            try:
                self._progress(words or UNNAMED, fraction)
            except BaseException as error:
                self._reason = error
        return int(self._reason is not None)


def _update(algorithm: vtkAlgorithm, listener: _Listener) -> None:
    writes = isinstance(algorithm, (vtkWriter, vtkXMLWriter))
    if writes:
        algorithm.Modified()  # otherwise it would not write a second time
    library = _locked if _may_call_python(algorithm) else _unlocked
    library.vtkInsideOutUpdate(_address(algorithm, "vtkAlgorithm"), writes, listener.function)


def _address(thing: vtkObject, kind: str) -> int:
    return int(thing.GetAddressAsString(kind).partition("=")[2], 16)


def _may_call_python(algorithm: vtkAlgorithm) -> bool:
    """Whether VTK might call Python, without its lock, while the algorithm or one upstream of it runs."""
    events = ("AnyEvent", "StartEvent", "EndEvent", "ProgressEvent", "ErrorEvent", "WarningEvent", "ModifiedEvent")
    if algorithm.IsA("vtkPythonAlgorithm") or any(algorithm.HasObserver(event) for event in events):
        return True
    return any(
        _may_call_python(algorithm.GetInputAlgorithm(port, connection))
        for port in range(algorithm.GetNumberOfInputPorts())
        for connection in range(algorithm.GetNumberOfInputConnections(port))
    )
