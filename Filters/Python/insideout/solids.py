# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids from all types of tetrahedra."""

from __future__ import annotations

import os
from typing import Any, Protocol, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .data import Tetrahedra
from .files import Path, read_solid
from .inputs import (
    ARRAYS,
    Algorithm,
    AlgorithmOutput,
    MeshioMesh,
    has,
    make_points,
    of_foreign,
    output_of,
    path_of,
    refuse_composite,
    table_of,
)
from .pipeline import Error
from .serializing import make_cells


class UnstructuredGrid(Protocol):
    """A vtkUnstructuredGrid."""

    def GetCells(self) -> Any: ...

    def GetDistinctCellTypesArray(self) -> Any: ...


AnySolid = Union[UnstructuredGrid, Path, Tuple[ArrayLike, ArrayLike], MeshioMesh, Algorithm, AlgorithmOutput]
"""The types of solids that every function accepts: a vtkUnstructuredGrid of tetrahedra, of first or second order; the
name of a .vtu, .msh, .inp or .mesh file; a pair (points, cells) of arrays with three and four columns; a meshio.Mesh;
or a VTK algorithm, or an output port of one, which is updated."""


def as_solid(solid: AnySolid) -> tuple[vtkUnstructuredGrid, list[str]]:
    """The solid as VTK holds it, and warnings of skipped data. Raises `Error` for anything else."""
    try:
        return _as_solid(solid)
    except MemoryError:
        raise Error("not enough memory for this solid") from None


def _as_solid(solid: Any) -> tuple[vtkUnstructuredGrid, list[str]]:
    if isinstance(solid, vtkUnstructuredGrid):
        return solid, []
    if isinstance(solid, (str, os.PathLike)):
        return read_solid(path_of("the solid", solid))
    if isinstance(solid, (vtkAlgorithm, vtkAlgorithmOutput)):
        return output_of(solid, "solid", vtkUnstructuredGrid)
    refuse_composite("solid", solid)
    if isinstance(solid, (tuple, list)) and len(solid) == 2:
        return make_solid(*solid), []
    if not isinstance(solid, vtkObject) and has(solid, "points", "cells"):
        return of_foreign(_solid_of_meshio, solid, "meshio.Mesh")
    kind = type(solid).__name__
    if isinstance(solid, vtkPolyData) or has(solid, "vertices", "faces"):
        raise Error(f"the solid is of type {kind}, a surface; it can be a vtkUnstructuredGrid, such as tetrahedralize makes of it")
    if has(solid, "solid"):
        raise Error(f"the solid is of type {kind}; it can be a vtkUnstructuredGrid such as its solid")
    raise Error(
        f"the solid is of type {kind}; it can be a vtkUnstructuredGrid, a file's name, "
        "a pair (points, cells) of arrays, a meshio.Mesh, or a VTK algorithm"
    )


def make_solid(points: ArrayLike, cells: ArrayLike) -> Tetrahedra:
    """A solid of points and tetrahedra."""
    corners = table_of("cells", cells, np.int64)
    if len(corners) and corners.shape[1] != 4:
        raise Error(f"cells has {corners.shape[1]} columns; it must have 4: ids of points, from 0")
    solid = Tetrahedra()
    solid.SetPoints(make_points(points, ARRAYS[0]))
    solid.SetCells(VTK_TETRA, make_cells(corners.reshape(-1, 4)))
    return solid


def _solid_of_meshio(mesh: Any) -> tuple[Tetrahedra, list[str]]:
    """The tetrahedra of a meshio.Mesh, and the number of other cells."""
    chosen = [np.asarray(block.data)[:, :4] for block in mesh.cells if block.type in ("tetra", "tetra10")]
    others = sum(len(block.data) for block in mesh.cells if block.type not in ("tetra", "tetra10"))
    if not chosen:
        raise Error("the meshio.Mesh has no tetrahedra")
    warnings = [f"{others} cells of the meshio.Mesh are ignored: they are not tetrahedra"] if others else []
    return make_solid(mesh.points, np.concatenate(chosen)), warnings
