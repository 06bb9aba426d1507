# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces from all types of triangles."""

from __future__ import annotations

import os
from typing import Any, Mapping, Optional, Protocol, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkObject
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .data import Tetrahedra, TriangleSurface
from .files import Path, read_surface
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
from .serializing import vtk_array


class PolyData(Protocol):
    """A vtkPolyData."""

    def GetPolys(self) -> Any: ...

    def GetStrips(self) -> Any: ...


class Trimesh(Protocol):
    """A trimesh.Trimesh, or any object with `vertices` (n, 3) and `faces` (m, 3)."""

    @property
    def vertices(self) -> Any: ...

    @property
    def faces(self) -> Any: ...


class Open3DMesh(Protocol):
    """An open3d.geometry.TriangleMesh."""

    @property
    def vertices(self) -> Any: ...

    @property
    def triangles(self) -> Any: ...


class StlMesh(Protocol):
    """A stl.mesh.Mesh of numpy-stl."""

    @property
    def vectors(self) -> Any: ...


PointsAndTriangles = Tuple[ArrayLike, ArrayLike]

AnySurface = Union[PolyData, Path, PointsAndTriangles, MeshioMesh, Trimesh, Open3DMesh, StlMesh, Algorithm, AlgorithmOutput]
"""The types of surfaces that every function accepts: a vtkPolyData of polygons or strips; the name of a .ply, .obj,
.off, .stl, .vtp, .glb or .3mf file; a pair (points, triangles) of arrays with three columns; a meshio.Mesh; an object
with `vertices` and `faces`, as a trimesh.Trimesh; a TriangleMesh of Open3D, or a mesh.Mesh of numpy-stl; or a VTK
algorithm, or an output port of one, which is updated."""

_POLYGONS = {"triangle": 3, "quad": 4, "polygon": None}
"""The beginnings of meshio's names of polygon types, and their numbers of corners, which midpoints may follow."""


def as_surface(surface: AnySurface, scale: float = 1) -> tuple[vtkPolyData, list[str]]:
    """The surface as VTK holds it, its coordinates multiplied, and warnings of skipped data. Raises `Error` for
    anything else.
    """
    try:
        polygons, warnings = _as_surface(surface)
        return (polygons if scale == 1 else _scaled(polygons, scale)), warnings
    except MemoryError:
        raise Error("not enough memory for this surface") from None


def _scaled(surface: vtkPolyData, scale: float) -> vtkPolyData:
    """A copy whose coordinates are multiplied, as doubles."""
    copy = vtkPolyData()
    copy.ShallowCopy(surface)
    if surface.GetNumberOfPoints() > 0:
        with np.errstate(over="ignore"):  # an infinite coordinate is an error of its own
            points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float) * scale
        copy.SetPoints(make_points(points, ARRAYS[0]))
    return copy


def _as_surface(surface: Any) -> tuple[vtkPolyData, list[str]]:
    if isinstance(surface, vtkPolyData):
        return surface, []
    if isinstance(surface, (str, os.PathLike)):
        return read_surface(path_of("the surface", surface))
    if isinstance(surface, (vtkAlgorithm, vtkAlgorithmOutput)):
        return output_of(surface, "surface", vtkPolyData)
    refuse_composite("surface", surface)
    if isinstance(surface, (tuple, list)) and len(surface) == 2:
        return make_surface(*surface), []
    if not isinstance(surface, vtkObject):
        if has(surface, "points", "cells"):
            return of_foreign(_surface_of_meshio, surface, "meshio.Mesh")
        if has(surface, "vertices", "faces"):
            return of_foreign(_surface_of_trimesh, surface, "trimesh.Trimesh")
        if has(surface, "vertices", "triangles"):
            return of_foreign(_surface_of_open3d, surface, "open3d.geometry.TriangleMesh")
        if is_stl(surface):
            return of_foreign(_surface_of_stl, surface, "stl.mesh.Mesh")
    kind = type(surface).__name__
    if isinstance(surface, Tetrahedra) or has(surface, "boundary", "solid"):
        raise Error(f"the surface is of type {kind}, which has tetrahedra; it can be a vtkPolyData such as its boundary")
    raise Error(
        f"the surface is of type {kind}; it can be a vtkPolyData, a file's name, "
        "a pair (points, triangles) of arrays, a meshio.Mesh, an object with vertices and faces, or a VTK algorithm"
    )


def _surface_of_trimesh(mesh: Any) -> tuple[TriangleSurface, list[str]]:
    return make_surface(mesh.vertices, mesh.faces, names=("vertices", "faces")), []


def is_stl(thing: Any) -> bool:
    """Whether it is a stl.mesh.Mesh, which is a mapping, too, but without names as keys."""
    return has(thing, "vectors", "normals")


def _surface_of_open3d(mesh: Any) -> tuple[TriangleSurface, list[str]]:
    return make_surface(mesh.vertices, mesh.triangles, names=("vertices", "triangles")), []


def _surface_of_stl(mesh: Any) -> tuple[TriangleSurface, list[str]]:
    """Each triangle has its own points; equal coordinates are merged later."""
    corners = np.asarray(mesh.vectors)
    if corners.ndim != 3 or corners.shape[1:] != (3, 3):
        raise Error(f"vectors is {' x '.join(map(str, corners.shape))}; it must have three points for each triangle")
    return make_surface(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), names=("vectors", "triangles")), []


def make_surface(points: ArrayLike, *polygons: ArrayLike, names: tuple[str, str] = ARRAYS) -> TriangleSurface:
    """A surface of points and polygons: arrays with a column for each corner."""
    offsets, corners = [np.zeros(1, np.int64)], [np.zeros(0, np.int64)]
    for block in polygons:
        rows = table_of(names[1], block, np.int64)
        if len(rows) and rows.shape[1] < 3:
            raise Error(f"{names[1]} has {rows.shape[1]} columns; it must have 3: ids of points, from 0")
        offsets.append(offsets[-1][-1] + rows.shape[1] * np.arange(1, len(rows) + 1))
        corners.append(rows.ravel())
    cells = vtkCellArray()
    cells.SetData(*(vtk_array(np.concatenate(ids), VTK_ID_TYPE) for ids in (offsets, corners)))
    surface = TriangleSurface()
    surface.SetPoints(make_points(points, names[0]))
    surface.SetPolys(cells)
    return surface


def _add_arrays(arrays: Mapping[str, ArrayLike], data: vtkDataSetAttributes) -> None:
    for name, values in arrays.items():
        rows = np.ascontiguousarray(values)
        if rows.dtype.kind in "iuf" and rows.ndim in (1, 2):
            array = vtk_array(rows)
            array.SetName(name)
            data.AddArray(array)


def _surface_of_meshio(mesh: Any) -> tuple[TriangleSurface, list[str]]:
    """The polygons of a meshio.Mesh with their data, and the number of other cells."""
    chosen = [k for k, block in enumerate(mesh.cells) if block.type.startswith(tuple(_POLYGONS))]
    others = sum(len(block.data) for k, block in enumerate(mesh.cells) if k not in chosen)
    if not chosen:
        raise Error("the meshio.Mesh has no triangles, quads or polygons")
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] == 2:
        raise Error("the meshio.Mesh is flat: it bounds no volume")
    surface = make_surface(points, *(_corners_of_meshio(mesh.cells[k]) for k in chosen))
    _add_arrays(mesh.point_data, surface.GetPointData())
    joined = {name: np.concatenate([np.asarray(blocks[k]) for k in chosen]) for name, blocks in mesh.cell_data.items()}
    _add_arrays(joined, surface.GetCellData())
    return surface, [f"{others} cells of the meshio.Mesh are ignored: only polygons count"] if others else []


def _corners_of_meshio(block: Any) -> NDArray:
    """The corners of cells, without midpoints."""
    rows = np.asarray(block.data)
    corners = next(count for begin, count in _POLYGONS.items() if block.type.startswith(begin))
    return rows if rows.ndim != 2 else rows[:, :corners]
