# SPDX-License-Identifier: GPL-3.0-or-later
"""Several surfaces joined as bodies of one surface, and the parts of a boundary with interfaces."""

from __future__ import annotations

from typing import Mapping, Optional, Union, cast

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData

from .data import TriangleSurface, as_type
from .errors import Error, text_of
from .pipeline import run
from .surfaces import AnySurface, as_surface, is_stl

AnyBodies = Union[AnySurface, Mapping[str, AnySurface]]
"""A surface, or several surfaces by name, which are the bodies of one mesh."""

BODY_IDS, BODY_NAMES = "BodyIds", "BodyNames"
"""The cell array that numbers joined surfaces, and the field array of their names."""


def as_body(name: str, surface: AnySurface, scale: float) -> tuple[vtkPolyData, list[str]]:
    """Like `as_surface`; warnings and errors name the body."""
    try:
        polygons, warnings = as_surface(surface, scale)
    except Error as error:
        raise Error(f"body {name}: {error}") from None
    return polygons, [f"body {name}: {warning}" for warning in warnings]


def join(surfaces: Mapping[str, AnySurface], scale: float = 1) -> tuple[vtkPolyData, list[str]]:
    """Join surfaces into one, with the cell array BodyIds and the data that all of them have. Returns warnings, too."""
    if not surfaces:
        raise Error("there are no bodies: the mapping is empty")
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(vtkAppendPolyData.DOUBLE_PRECISION)
    names = vtkStringArray()
    names.SetName(BODY_NAMES)
    all_warnings = []
    for number, (name, surface) in enumerate(surfaces.items()):
        if not text_of("a body's name", name):
            raise Error("a body's name is empty")
        polygons, warnings = as_body(name, surface, scale)
        copy = vtkPolyData()
        copy.ShallowCopy(polygons)
        if not _has_polygons(copy):
            warnings.append(f"body {name}: the surface has no polygons: the body is empty")
        warnings += [f"body {name}: {warning}" for warning in _keep_array(copy.GetCellData(), BODY_IDS)]
        ids = numpy_to_vtk(np.full(copy.GetNumberOfCells(), number, np.int32), deep=True)
        ids.SetName(BODY_IDS)
        copy.GetCellData().AddArray(ids)
        append.AddInputData(copy)
        names.InsertNextValue(name)
        all_warnings += warnings
    run(append)
    joined = append.GetOutput()
    if not _has_polygons(joined):
        raise Error("none of the bodies has polygons")
    joined.GetFieldData().AddArray(names)
    return joined, all_warnings


def _has_polygons(surface: vtkPolyData) -> bool:
    return surface.GetNumberOfPolys() + surface.GetNumberOfStrips() > 0


def _keep_array(data: vtkDataSetAttributes, name: str) -> list[str]:
    """Rename an array whose name is taken, as the filters do, with a warning."""
    array = data.GetAbstractArray(name)
    if array is None:
        return []
    renamed = f"Input_{name}"
    while data.HasArray(renamed):
        renamed = f"Input_{renamed}"
    copy = array.NewInstance()
    copy.DeepCopy(array)
    copy.SetName(renamed)
    data.RemoveArray(name)
    data.AddArray(copy)
    return [f"the input's array {name} is passed on as {renamed}, because the output has its own"]


def as_bodies(surface: AnyBodies, scale: float, array: Optional[str]) -> tuple[vtkPolyData, list[str], Optional[str]]:
    """A surface as VTK holds it, warnings, and the array that identifies the bodies (made here for a mapping)."""
    if not isinstance(surface, Mapping) or is_stl(surface):
        return (*as_surface(cast(AnySurface, surface), scale), array)
    if array is not None:
        raise Error("body_array names an array of one surface; several surfaces by their names are bodies already")
    return (*join(surface, scale), BODY_IDS)


def region_ids(boundary: vtkPolyData) -> Optional[NDArray[np.int32]]:
    """The regions behind and in front of each triangle; None for a boundary of one body."""
    array = boundary.GetCellData().GetArray("RegionIds")
    return None if array is None else vtk_to_numpy(array)


def outer_boundary(boundary: TriangleSurface) -> TriangleSurface:
    """A boundary without the interfaces between regions: it encloses all bodies."""
    regions = region_ids(boundary)
    if regions is None or (regions[:, 1] < 0).all():
        return boundary
    outer = vtkPolyData()
    outer.DeepCopy(boundary)
    outer.BuildCells()  # required by DeleteCell
    for triangle in np.flatnonzero(regions[:, 1] >= 0).tolist():
        outer.DeleteCell(triangle)
    outer.RemoveDeletedCells()
    used = vtkCleanPolyData()  # removes points of interfaces
    used.SetInputData(outer)
    used.PointMergingOff()
    run(used)
    return as_type(TriangleSurface, used.GetOutput())
