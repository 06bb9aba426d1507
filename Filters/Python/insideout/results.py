# SPDX-License-Identifier: GPL-3.0-or-later
"""Common behavior of all results: they can be pickled, copied, measured, drawn, and printed as a line or a table."""

from __future__ import annotations

import base64
import html
from dataclasses import fields, replace
from typing import Any, Optional, TypeVar

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .calling import quietly
from .data import LayeredCells, Polylines, Tetrahedra, Triangles, TriangleSurface, is_flat
from .panels import draw_panels
from .pipeline import Error
from .plotting import plot
from .serializing import Plain

Self = TypeVar("Self", bound="Result")
SECONDS_TO_DRAW = 60.0


class Result:
    """The base of the dataclasses that functions return."""

    def figures(self) -> list[tuple[str, str]]:
        """A warning: its text, and the amount."""
        raise NotImplementedError

    def png(self) -> bytes:
        """The content of a .png file that shows the result. Raises `Error` if it cannot be drawn."""
        raise NotImplementedError

    def plot(self) -> None:
        """Show a picture of the result: in a notebook below the cell, otherwise in a window until that is closed.
        Raises `Error` if neither is available, or there is nothing to show. `png` returns the picture.
        """
        plot(self.png(), type(self).__name__)

    def __reduce__(self) -> tuple:
        content = {field.name: getattr(self, field.name) for field in fields(self)}
        return _result, (type(self), {name: _picklable(value) for name, value in content.items()})

    def __copy__(self: Self) -> Self:
        return replace(self)

    def __repr__(self) -> str:
        words = ", ".join(f"{what} {how_much}" for what, how_much in self.figures())
        return f"<{type(self).__name__}: {' '.join(words.split())}>"

    def _repr_html_(self) -> str:
        """The representation in a notebook: a table, and a picture if there is one."""
        rows = "".join(
            f"<tr><td>{html.escape(what)}</td><td>{html.escape(how_much)}</td></tr>" for what, how_much in self.figures()
        )
        picture = self._picture()
        image = f'<img alt="" style="max-width: 100%" src="data:image/png;base64,{picture}">' if picture else ""
        return f"<table><caption>{type(self).__name__}</caption>{rows}</table>{image}"

    def _picture(self) -> Optional[str]:
        """The picture in base64; None if it cannot be drawn for any reason: the table suffices."""
        try:
            return base64.b64encode(self.png()).decode("ascii")
        except Exception:  # noqa: BLE001
            return None


class MeshResult(Result):
    """The base of results with VTK data sets among their fields: a solid, its boundary, or a surface."""

    def seen(self) -> dict[str, Any]:
        """The content of its picture, as arguments of `draw_panels`."""
        return {}

    def png(self) -> bytes:
        with quietly():
            seen = self.seen()
        if not seen:
            raise Error(f"the {type(self).__name__} has nothing to be drawn")
        return draw_panels(timeout=SECONDS_TO_DRAW, **seen)

    @property
    def volume(self) -> float:
        """The volume of the solid, or else of the surface's interior. In two dimensions the area."""
        solid = getattr(self, "solid", None)
        has_layers = isinstance(solid, LayeredCells) and not is_flat(solid)
        return float(self._first_of("boundary" if has_layers else "solid", "boundary", "surface").volume)

    @property
    def is_watertight(self) -> bool:
        """Whether each edge of the boundary, or the surface, has equally many triangles in both directions."""
        return bool(self._first_of("boundary", "surface", "solid").is_watertight)

    @property
    def components(self) -> int:
        """The number of the solid's parts, connected through faces, or else of the surface's parts, connected through
        edges."""
        return int(self._first_of("solid", "boundary", "surface").components)

    def split(self) -> list[Any]:
        """These parts, as separate data sets with all arrays."""
        return list(self._first_of("solid", "boundary", "surface").split())

    def to_pyvista(self) -> Any:
        """The solid, or else the surface, as a data set of PyVista, with all arrays, which are shared."""
        return self._first_of("solid", "boundary", "surface").to_pyvista()

    def to_trimesh(self) -> Any:
        """The boundary or the surface as a trimesh.Trimesh, without arrays."""
        return self._surface_for("a trimesh.Trimesh").to_trimesh()

    def to_open3d(self) -> Any:
        """The boundary or the surface as an open3d.geometry.TriangleMesh, without arrays."""
        return self._surface_for("an Open3D TriangleMesh").to_open3d()

    def to_stl(self) -> Any:
        """The boundary or the surface as a mesh.Mesh of numpy-stl, with coordinates in single precision."""
        return self._surface_for("a mesh.Mesh of numpy-stl").to_stl()

    def _surface_for(self, kind: str) -> Any:
        found = self._first_of("boundary", "surface")
        if isinstance(found, Polylines):
            raise Error(f"the result lies in a plane: {kind} has triangles in space")
        return found

    def _first_of(self, *names: str) -> Any:
        """The first of some fields that exists and is not empty; else the last that exists."""
        there = [getattr(self, name) for name in names if hasattr(self, name)]
        return next((data for data in there if data.GetNumberOfCells() > 0), there[-1])


def counted(count: int) -> str:
    return f"{count:,}"


def _picklable(value: Any) -> Any:
    ours = isinstance(value, (TriangleSurface, Tetrahedra, Triangles, Polylines))
    return Plain(value) if isinstance(value, (vtkPolyData, vtkUnstructuredGrid)) and not ours else value


def _result(result_type: type, content: dict[str, Any]) -> Any:
    return result_type(**content)
