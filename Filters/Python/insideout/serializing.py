# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's surfaces and tetrahedra as numpy arrays and back, so that they can be pickled and copied."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import get_vtk_array_type, numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, VTK_ID_TYPE, vtkAbstractArray, vtkDataArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkFieldData, vtkPolyData, vtkUnstructuredGrid

from .pipeline import Error

CELLS = ("Verts", "Lines", "Polys", "Strips")
ATTRIBUTES = ("PointData", "CellData", "FieldData")


class Plain:
    """A data set of VTK's own, which cannot be pickled itself. Unpickling returns the data set."""

    def __init__(self, data: Any):
        self.data = data

    def __reduce__(self) -> tuple:
        return unpacked, (type(self.data), packed(self.data))


def packed(data: Any) -> dict[str, Any]:
    """The content of a vtkPolyData, or a vtkUnstructuredGrid without polyhedra, as arrays."""
    points = data.GetPoints()
    content: dict[str, Any] = {"Points": None if points is None else _packed_array(points.GetData())}
    if isinstance(data, vtkPolyData):
        content.update((name, _packed_cells(getattr(data, "Get" + name)())) for name in CELLS)
    elif data.GetNumberOfCells() > 0:
        content["Cells"] = _packed_cells(data.GetCells())
        content["Types"] = types_of_cells(data)
    content.update((name, _packed_attributes(getattr(data, "Get" + name)())) for name in ATTRIBUTES)
    return content


def types_of_cells(grid: Any) -> NDArray[np.uint8]:
    """VTK's number of each cell's type, of a vtkUnstructuredGrid with cells."""
    # VTK 9.6 (its release notes, "DataModel": "vtkDataSet: GetCellTypes updates") gave the array another name.
    types = grid.GetCellTypesArray() if hasattr(grid, "GetCellTypesArray") else grid.GetCellTypes()
    return vtk_to_numpy(types).copy()


def unpacked(data_type: type, content: dict[str, Any]) -> Any:
    """The data set of this type from its `packed` form."""
    data = data_type()
    if content["Points"] is not None:
        points, coordinates = vtkPoints(), _unpacked_array(content["Points"])
        points.SetDataType(coordinates.GetDataType())
        points.SetData(coordinates)
        data.SetPoints(points)
    for name in CELLS:
        if name in content:
            getattr(data, "Set" + name)(_unpacked_cells(content[name]))
    if "Types" in content:
        data.SetCells(vtk_array(content["Types"]), _unpacked_cells(content["Cells"]))
    for name in ATTRIBUTES:
        _unpack_attributes(content[name], getattr(data, "Get" + name)())
    return data


def vtk_array(values: ArrayLike, kind: Optional[int] = None) -> vtkDataArray:
    """A copy of numbers as a VTK array of a given type. Raises MemoryError where VTK would end the program."""
    rows = np.ascontiguousarray(values)
    item_size = vtkDataArray.GetDataTypeSize(kind or get_vtk_array_type(rows.dtype))
    # VTK allocates it twice.
    np.empty(2 * rows.size * item_size + LEAST_SPARE, np.uint8)
    return numpy_to_vtk(rows, deep=True, array_type=kind)


LEAST_SPARE = 1 << 20
"""Bytes that must be free beyond the array's own, because VTK allocates more."""


def make_cells(corners: NDArray[np.int64]) -> vtkCellArray:
    """VTK's cells from a table with the points of each."""
    cells = vtkCellArray()
    cells.SetData(corners.shape[1], vtk_array(corners.ravel(), VTK_ID_TYPE))
    return cells


def _packed_cells(cells: vtkCellArray) -> tuple[NDArray, NDArray]:
    return vtk_to_numpy(cells.GetOffsetsArray()).copy(), vtk_to_numpy(cells.GetConnectivityArray()).copy()


def _unpacked_cells(content: tuple[NDArray, NDArray]) -> vtkCellArray:
    cells = vtkCellArray()
    cells.SetData(*(vtk_array(ids, VTK_ID_TYPE) for ids in content))
    return cells


def _packed_array(array: vtkAbstractArray) -> dict[str, Any]:
    components = array.GetNumberOfComponents()
    values: Any
    if isinstance(array, vtkStringArray):
        values = [array.GetValue(index) for index in range(array.GetNumberOfValues())]
    elif isinstance(array, vtkDataArray) and array.GetDataType() == VTK_BIT:
        values = [array.GetValue(index) for index in range(array.GetNumberOfValues())]
    elif isinstance(array, vtkDataArray):
        values = vtk_to_numpy(array).copy()
    else:
        raise Error(f"the array {array.GetName()} is a {array.GetClassName()}: only numbers and strings can be pickled")
    return {
        "Name": array.GetName(),
        "Type": array.GetDataType(),
        "Components": components,
        "ComponentNames": [array.GetComponentName(index) for index in range(components)] if array.HasAComponentName() else [],
        "Values": values,
    }


def _unpacked_array(content: dict[str, Any]) -> vtkAbstractArray:
    values = content["Values"]
    if isinstance(values, list):
        array = vtkAbstractArray.CreateArray(content["Type"])
        array.SetNumberOfComponents(content["Components"])
        for value in values:
            array.InsertNextValue(value)
    else:
        array = vtk_array(values, content["Type"])
        array.SetNumberOfComponents(content["Components"])
    array.SetName(content["Name"])
    for index, name in enumerate(content["ComponentNames"]):
        if name is not None:
            array.SetComponentName(index, name)
    return array


def _packed_attributes(data: vtkFieldData) -> list[tuple[dict[str, Any], int]]:
    """Each array, and the attribute that it is (scalars, normals ...), or -1."""
    is_active = isinstance(data, vtkDataSetAttributes)
    return [
        (_packed_array(data.GetAbstractArray(index)), data.IsArrayAnAttribute(index) if is_active else -1)
        for index in range(data.GetNumberOfArrays())
    ]


def _unpack_attributes(content: list[tuple[dict[str, Any], int]], data: vtkFieldData) -> None:
    for array, active in content:
        index = data.AddArray(_unpacked_array(array))
        if active >= 0:
            data.SetActiveAttribute(index, active)
