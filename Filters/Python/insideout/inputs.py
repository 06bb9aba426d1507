# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's points and cells from arrays and from outputs of VTK algorithms."""

from __future__ import annotations

import os
from typing import Any, Callable, Protocol, Tuple, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .data import DataSet
from .errors import Error, brief
from .pipeline import run_with_upstream
from .serializing import vtk_array

# For type checkers, classes without definitions: VTK has no type hints, and the other packages need not be installed.


class Algorithm(Protocol):
    """A vtkAlgorithm."""

    def GetOutputPort(self) -> Any: ...

    def GetOutputDataObject(self, port: int) -> Any: ...


class AlgorithmOutput(Protocol):
    """A vtkAlgorithmOutput, which GetOutputPort() of an algorithm gives."""

    def GetProducer(self) -> Any: ...

    def GetIndex(self) -> int: ...


class DataSetOfPoints(Protocol):
    """A vtkDataSet."""

    def GetPoint(self, index: int) -> Any: ...

    def GetNumberOfPoints(self) -> int: ...


class MeshioMesh(Protocol):
    """A meshio.Mesh."""

    @property
    def points(self) -> Any: ...

    @property
    def cells(self) -> Any: ...

    @property
    def point_data(self) -> Any: ...

    @property
    def cell_data(self) -> Any: ...


AnyPoints = Union[DataSetOfPoints, ArrayLike]
"""The types of points that every function accepts: an array whose last axis has x, y and z, or the points of a VTK data
set."""

Made = TypeVar("Made")

ARRAYS: Tuple[str, str] = ("points", "triangles")


def output_of(source: Union[vtkAlgorithm, vtkAlgorithmOutput], what: str, kind: type[DataSet]) -> tuple[DataSet, list[str]]:
    """Update an algorithm. Returns its output, a surface or an input for one, and its warnings."""
    algorithm, port = (source, 0) if isinstance(source, vtkAlgorithm) else (source.GetProducer(), source.GetIndex())
    name = algorithm.GetClassName()
    if algorithm.GetNumberOfOutputPorts() == 0:
        raise Error(f"the {what} is a {name}, which has no output")
    warnings = run_with_upstream(algorithm)
    output = algorithm.GetOutputDataObject(port)
    refuse_composite(f"output of the {name}", output)
    if not isinstance(output, kind):
        raise Error(f"the output of the {name} is a {output.GetClassName()}; it must be a {kind.__name__}")
    return output, warnings


def has(thing: Any, *names: str) -> bool:
    """Whether an object has attributes; exceptions of its properties are ignored."""
    try:
        return all(hasattr(thing, name) for name in names)
    except Exception:  # noqa: BLE001 - properties may raise anything
        return False


def of_foreign(make: Callable[[Any], Made], mesh: Any, kind: str) -> Made:
    """Convert an object of another package's class. Raises `Error` if it only resembles one."""
    try:
        return make(mesh)
    except (Error, MemoryError):
        raise
    except Exception as error:  # noqa: BLE001 - attributes may raise or be anything
        raise Error(f"the {type(mesh).__name__} is no {kind}, which it looks like: {brief(str(error))}") from None


def path_of(name: str, path: Any) -> str:
    """A file's name as text. Raises `Error` for anything else."""
    try:
        text = os.fspath(path)
    except Exception:  # noqa: BLE001 - __fspath__ may raise anything
        text = None
    if not isinstance(text, str):
        raise Error(f"{name} is {brief(path)}; it must be a file's name")
    if not text or "\0" in text:
        raise Error(f"{name} is {brief(text)}, which is not a file's name")
    return text


def refuse_composite(what: str, data: Any) -> None:
    """Raise `Error` for a composite data set."""
    if isinstance(data, vtkCompositeDataSet):
        raise Error(
            f"the {what} is a {data.GetClassName()}, which has blocks: give one of them, "
            "or all as one by the filter vtkCompositeDataGeometryFilter"
        )


def as_points(points: AnyPoints) -> vtkDataSet:
    """A VTK data set with these points. Raises `Error` for anything but an array of points."""
    return points_and_shape(points)[0]


def points_and_shape(points: AnyPoints) -> tuple[vtkDataSet, tuple[int, ...]]:
    """A VTK data set with these points, and the shape of an array with a value for each."""
    if isinstance(points, vtkDataSet):
        return points, (points.GetNumberOfPoints(),)
    if isinstance(points, vtkDataObject):
        raise Error(f"points is a {points.GetClassName()}; it can be a vtkDataSet, or an array of points")
    data = vtkPolyData()
    try:
        values = numbers(ARRAYS[0], points)
        if values.shape == (0,):
            values = values.reshape(0, 3)
        if values.ndim == 0 or values.shape[-1] != 3:
            shape = " x ".join(map(str, values.shape)) or "one number"
            raise Error(f"points is {shape}; its last axis must have 3: x, y and z")
        data.SetPoints(_points_of(values.reshape(-1, 3)))
    except MemoryError:
        raise Error("not enough memory for these points") from None
    return data, values.shape[:-1]


def make_points(values: Any, name: str) -> vtkPoints:
    """VTK's points, in double precision, with a copy of the coordinates."""
    rows = table_of(name, values, float)
    if rows.shape[1] != 3:
        raise Error(f"{name} has {rows.shape[1]} columns; it must have 3: x, y and z")
    return _points_of(rows)


def _points_of(rows: NDArray[np.float64]) -> vtkPoints:
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(vtk_array(rows))
    return points


def numbers(name: str, values: Any, kind: type = float) -> NDArray:
    """One array of a type, from any holder of numbers. Raises `Error` for anything else, and for invalid whole
    numbers."""
    if np.ma.is_masked(values):
        row = np.argwhere(np.ma.getmaskarray(values))[0][0]
        raise Error(f"{name} is masked in row {row}: a surface has no gaps, fill them or leave the rows out")
    try:
        given = np.asarray(values)
        if given.dtype.kind == "c":
            raise Error(f"{name} holds complex numbers; it must hold real ones")
        if given.dtype.kind in "mM":
            raise Error(f"{name} holds times; it must hold numbers")
        with np.errstate(invalid="ignore", over="ignore"):
            array: NDArray = np.require(given, kind, "C")
        if kind is np.int64 and not np.array_equal(array, given):
            raise Error(f"{name} holds values that are not whole numbers below 2^63")
    except (Error, MemoryError):
        raise
    except Exception:  # noqa: BLE001 - __array__ may raise anything
        raise Error(f"{name} is not a table of numbers") from None
    return array


def table_of(name: str, values: ArrayLike, kind: type) -> NDArray:
    """A table as one array of a type, from any holder of numbers."""
    rows = numbers(name, values, kind)
    if rows.size == 0:
        return rows.reshape(0, 3)
    if rows.ndim != 2:
        raise Error(f"{name} has {rows.ndim} dimensions; it must have 2, a row for each")
    return rows
