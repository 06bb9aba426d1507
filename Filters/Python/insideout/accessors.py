# SPDX-License-Identifier: GPL-3.0-or-later
"""Accessors: PyVista's data sets have the functions under the name `insideout`, with PyVista's data sets out::

    import pyvista
    mesh = pyvista.read("broken.ply")
    grid = mesh.insideout.tetrahedralize()
    grid.insideout.refine(edge_length=0.1)

PyVista 0.48 and later find the accessors as an entry point of the wheel; after any other installation `import
insideout.accessors` registers them. Options are those of the functions of `insideout`, which never imports this module.
"""

from __future__ import annotations

from typing import Any

from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkStringArray

from .booleans import boolean
from .calling import for_users
from .checking import check
from .exporting import pyvista_of
from .inputs import AnyPoints
from .marked import with_lines
from .packages import import_package
from .quality import check_solid
from .queries import inside
from .refinement import refine
from .surfaces import AnySurface
from .tetrahedralization import tetrahedralize

NAME = "insideout"


class SurfaceAccessor:
    """The accessor of a pyvista.PolyData."""

    def __init__(self, mesh: Any):
        self._mesh = mesh

    @for_users
    def tetrahedralize(self, **options: Any) -> Any:
        """The tetrahedra of the solid that the surface means, as a pyvista.UnstructuredGrid: see `insideout.tetrahedralize`."""
        return tetrahedralize(self._mesh, **options).to_pyvista()

    @for_users
    def check(self, **options: Any) -> Any:
        """The defects, as a pyvista.PolyData with the surface and the lines of its defects among its cells: see `insideout.check`.

        The array `DefectColor` has the color of each cell, and the field data `Verdict` and `Findings` describe the
        defects in words.
        """
        found = check(self._mesh, **options)
        marked = with_lines(found)
        for name, words in (("Verdict", [found.verdict]), ("Findings", [finding.text for finding in found.findings])):
            marked.GetFieldData().AddArray(_strings(name, words))
        return pyvista_of(marked)

    @for_users
    def repair(self, **options: Any) -> Any:
        """The watertight boundary of the solid, as a pyvista.PolyData: `insideout.tetrahedralize` with `surface_only`."""
        return tetrahedralize(self._mesh, surface_only=True, **options).boundary.to_pyvista()

    @for_users
    def inside(self, points: AnyPoints, **options: Any) -> NDArray:
        """Which points are inside: see `insideout.inside`. A data set, such as a pyvista.ImageData, stands for its
        points."""
        return inside(self._mesh, points, **options)

    @for_users
    def boolean(self, other: AnySurface, expression: str = "A - B", **options: Any) -> Any:
        """The result of a set expression of this surface, A, and another, B, as a pyvista.PolyData: see `insideout.boolean`."""
        return boolean([self._mesh, other], expression, **options).surface.to_pyvista()


class SolidAccessor:
    """The accessor of a pyvista.UnstructuredGrid of tetrahedra."""

    def __init__(self, grid: Any):
        self._grid = grid

    @for_users
    def check(self, **options: Any) -> Any:
        """The tetrahedra with the quality of each: see `insideout.check_solid`."""
        return pyvista_of(check_solid(self._grid, **options).solid)

    @for_users
    def refine(self, **options: Any) -> Any:
        """Better tetrahedra of the same solid, as a pyvista.UnstructuredGrid: see `insideout.refine`."""
        return refine(self._grid, **options).to_pyvista()


def _strings(name: str, words: list[str]) -> vtkStringArray:
    array = vtkStringArray()
    array.SetName(name)
    for word in words:
        array.InsertNextValue(word)
    return array


_pyvista = import_package("pyvista")
_pyvista.register_dataset_accessor(NAME, _pyvista.PolyData)(SurfaceAccessor)
_pyvista.register_dataset_accessor(NAME, _pyvista.UnstructuredGrid)(SolidAccessor)
