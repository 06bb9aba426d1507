# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's points and cells out of arrays and of what VTK algorithms make."""

from __future__ import annotations

from typing import Any, Protocol, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .data import DataSet
from .pipeline import Error, run_with_upstream
from .serializing import vtk_array

# What type checkers know of classes that are not there to them: VTK brings no types, and the others need not be installed.


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
"""What every function takes for points: an array with three columns, or the points of a VTK data set."""

ARRAYS: Tuple[str, str] = ("points", "triangles")


def output_of(source: Union[vtkAlgorithm, vtkAlgorithmOutput], what: str, kind: type[DataSet]) -> tuple[DataSet, list[str]]:
    """The surface, or what it is to be, that an algorithm makes, which is updated, and its warnings."""
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


def refuse_composite(what: str, data: Any) -> None:
    """Raise `Error` for what has blocks."""
    if isinstance(data, vtkCompositeDataSet):
        raise Error(
            f"the {what} is a {data.GetClassName()}, which has blocks: give one of them, "
            "or all as one by the filter vtkCompositeDataGeometryFilter"
        )


def as_points(points: AnyPoints) -> vtkDataSet:
    """A VTK data set with these points. Raises `Error` for what is no table of them."""
    if isinstance(points, vtkDataSet):
        return points
    if isinstance(points, vtkDataObject):
        raise Error(f"points is a {points.GetClassName()}; it can be a vtkDataSet, or an array with three columns")
    data = vtkPolyData()
    try:
        data.SetPoints(make_points(points, ARRAYS[0]))
    except MemoryError:
        raise Error("not enough memory for these points") from None
    return data


def make_points(values: Any, name: str) -> vtkPoints:
    """VTK's points, in double precision, with a copy of the coordinates."""
    rows = table_of(name, values, float)
    if rows.shape[1] != 3:
        raise Error(f"{name} has {rows.shape[1]} columns; it must have 3: x, y and z")
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(vtk_array(rows))
    return points


def table_of(name: str, values: ArrayLike, kind: type) -> NDArray:
    """A table as one array of a type, whatever holds it."""
    if np.ma.is_masked(values):
        row = np.argwhere(np.ma.getmaskarray(values))[0][0]
        raise Error(f"{name} is masked in row {row}: a surface has no gaps, fill them or leave the rows out")
    try:
        table = np.asarray(values)
        if table.dtype.kind == "c":
            raise Error(f"{name} holds complex numbers; it must hold real ones")
        rows: NDArray = np.ascontiguousarray(table, dtype=kind)
    except (TypeError, ValueError):
        raise Error(f"{name} is no table of numbers") from None
    if rows.size == 0:
        return rows.reshape(0, 3)
    if rows.ndim != 2:
        raise Error(f"{name} has {rows.ndim} dimensions; it must have 2, a row for each")
    if kind is np.int64 and not np.array_equal(rows, table):
        raise Error(f"{name} holds what is no whole number")
    return rows


def make_cells(corners: NDArray[np.int64]) -> vtkCellArray:
    """VTK's cells of a table with the points of each."""
    cells = vtkCellArray()
    cells.SetData(corners.shape[1], vtk_array(corners.ravel(), VTK_ID_TYPE))
    return cells
