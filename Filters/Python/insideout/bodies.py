# SPDX-License-Identifier: GPL-3.0-or-later
"""Several surfaces as the bodies of one, and the parts of a boundary that has interfaces."""

from __future__ import annotations

from typing import Mapping, Optional, Union

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData

from .data import AnySurface, TriangleSurface, as_surface, as_type
from .pipeline import Error, run

AnyBodies = Union[AnySurface, Mapping[str, AnySurface]]
"""A surface, or several by their names, which are the bodies of one mesh."""

BODY_IDS, BODY_NAMES = "BodyIds", "BodyNames"
"""The cell array that numbers joined surfaces, and the field array of their names."""


def join(surfaces: Mapping[str, AnySurface], scale: Optional[float] = None) -> tuple[vtkPolyData, list[str]]:
    """Surfaces as one, whose cell array BodyIds tells them apart, with the data that all of them have; and warnings."""
    if not surfaces:
        raise Error("there are no bodies: the mapping is empty")
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(vtkAppendPolyData.DOUBLE_PRECISION)
    names = vtkStringArray()
    names.SetName(BODY_NAMES)
    all_warnings = []
    for number, (name, surface) in enumerate(surfaces.items()):
        if not isinstance(name, str) or not name:
            raise Error(f"{name!r} is no name of a body")
        try:
            polygons, warnings = as_surface(surface, scale)
        except Error as error:
            raise Error(f"body {name}: {error}") from None
        copy = vtkPolyData()
        copy.ShallowCopy(polygons)
        ids = numpy_to_vtk(np.full(copy.GetNumberOfCells(), number, np.int32), deep=True)
        ids.SetName(BODY_IDS)
        copy.GetCellData().AddArray(ids)
        append.AddInputData(copy)
        names.InsertNextValue(name)
        all_warnings += [f"body {name}: {warning}" for warning in warnings]
    run(append)
    joined = append.GetOutput()
    joined.GetFieldData().AddArray(names)
    return joined, all_warnings


def as_bodies(surface: AnyBodies, scale: Optional[float], array: Optional[str]) -> tuple[vtkPolyData, list[str], Optional[str]]:
    """A surface as VTK holds it, warnings, and the array that says what are bodies: a mapping brings its own."""
    if not isinstance(surface, Mapping):
        return (*as_surface(surface, scale), array)
    if array is not None:
        raise Error("bodies names an array of one surface; several surfaces by their names are bodies already")
    return (*join(surface, scale), BODY_IDS)


def region_ids(boundary: vtkPolyData) -> Optional[NDArray[np.int32]]:
    """Of each triangle the regions behind and before it; None where the boundary is of one body."""
    array = boundary.GetCellData().GetArray("RegionIds")
    return None if array is None else vtk_to_numpy(array)


def outer_boundary(boundary: TriangleSurface) -> TriangleSurface:
    """A boundary without the interfaces between regions: what encloses all bodies."""
    regions = region_ids(boundary)
    if regions is None or (regions[:, 1] < 0).all():
        return boundary
    outer = vtkPolyData()
    outer.DeepCopy(boundary)
    outer.BuildCells()  # what DeleteCell takes
    for triangle in np.flatnonzero(regions[:, 1] >= 0).tolist():
        outer.DeleteCell(triangle)
    outer.RemoveDeletedCells()
    used = vtkCleanPolyData()  # points of interfaces are left
    used.SetInputData(outer)
    used.PointMergingOff()
    run(used)
    return as_type(TriangleSurface, used.GetOutput())
