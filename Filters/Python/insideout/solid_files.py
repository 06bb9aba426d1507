# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of tetrahedra: VTK's own formats, and those of solvers."""

from __future__ import annotations

import os
from typing import Dict, Literal, Optional, get_args

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .bodies import outer_boundary
from .data import Tetrahedra, Triangles, as_type, has_layers, is_flat
from .deck import Deck
from .errors import ArgumentError, Error, one_of
from .exporting import is_boundary_alone
from .files import GRID, WRITABLE_SURFACES, Path, check_output, ending, is_of_others, run_writer, temporary_folder, write_grid, write_surface
from .options import in_words_of_python
from .pipeline import run, statistics_of, write_bytes
from .vtkFiltersInsideOut import vtkSolidQuality, vtkSolidWriter
from .xdmf import XDMF, boundary_beside, write_xdmf

MshVersion = Literal["4.1", "2.2"]

WRITABLE_SOLIDS = (".msh", ".inp", ".mesh")
"""Files for solvers that vtkSolidWriter writes, with regions and tags."""

WRITABLE_GRIDS = (GRID, *WRITABLE_SOLIDS, XDMF)

_FITNESS = ("RefusedCells", "PoorCells")
"""The numbers of cells that a solver refuses, and of poor cells."""


def is_for_solver(path: Path) -> bool:
    """Whether a file of this name is for finite element solvers."""
    return ending(path) in (*WRITABLE_SOLIDS, XDMF)


def write_result(
    solid: vtkUnstructuredGrid,
    boundary: vtkPolyData,
    path: Path,
    msh_version: MshVersion = "4.1",
    cells_only: bool = False,
) -> list[str]:
    """Write a solid, or its watertight boundary if the name has the ending of a surface. Returns warnings about the
    file."""
    if ending(path) in WRITABLE_SURFACES:
        return write_surface(outer_boundary(boundary), path)
    return write_solid(solid, path, boundary, msh_version, cells_only=cells_only)


def written_beside(path: Path, grid: vtkUnstructuredGrid, boundary: Optional[vtkPolyData]) -> dict[str, str]:
    """The further files that `write_solid` writes, by their content."""
    has_two = ending(path) == XDMF and boundary is not None and not is_flat(grid)
    return {"tags": boundary_beside(os.fspath(path))} if has_two else {}


def check_beside(path: str) -> None:
    """Raise `Error` where the boundary beside a file of cells would replace a file that nobody named and another program wrote."""
    beside = boundary_beside(path)
    if ending(path) == XDMF and is_of_others(beside):
        raise Error(f"{beside}, beside {path}, is where the boundary goes, and was not written by insideout: move it, or choose another name")


def check_holds_layers(path: str, has_layers: bool) -> None:
    """Raise `ArgumentError` if there are prisms that a file of cells cannot have."""
    if has_layers and ending(path) == XDMF:
        raise ArgumentError(f"{path}: such a file has cells of one type here; write layers as {', '.join((GRID, *WRITABLE_SOLIDS))}")


def check_holds_triangles(path: str) -> None:
    """Raise `ArgumentError` unless a file of cells can have triangles in a plane."""
    if ending(path) in WRITABLE_SOLIDS:
        raise ArgumentError(f"{path}: such a file has tetrahedra here; write triangles in a plane as .vtu or .xdmf")


def write_solid(
    grid: vtkUnstructuredGrid,
    path: Path,
    boundary: Optional[vtkPolyData] = None,
    msh_version: MshVersion = "4.1",
    figures: Optional[Dict[str, float]] = None,
    deck: Optional[Deck] = None,
    cells_only: bool = False,
    replaces_beside: bool = False,
) -> list[str]:
    """Write tetrahedra in any format for them. No cell is changed. Returns warnings of cells that a solver does not
    take; `figures` gets their counts. A deck completes an .inp file. `cells_only` omits boundary and regions.
    `replaces_beside` replaces any file beside an .xdmf file. Raises `Error` that names the file.
    """
    figures = {} if figures is None else figures
    path = os.fspath(path)
    check_output(path, WRITABLE_GRIDS)
    if is_boundary_alone(grid, boundary):
        raise Error(f"{path}: such a file has the solid's cells, and surface_only left these away")
    if is_flat(grid):
        check_holds_triangles(path)
    if cells_only:
        check_has_groups(path)
    if ending(path) in WRITABLE_SOLIDS:
        versions = get_args(MshVersion)
        writer = vtkSolidWriter()
        writer.SetInputData(grid)
        writer.SetBoundaryData(boundary)
        writer.SetCellsOnly(cells_only)
        writer.SetMshVersion(versions.index(one_of(versions, "msh_version", msh_version)))
        warnings = in_words_of_python(run_writer(writer, path) if deck is None else _write_with_deck(writer, path, deck))
        figures.update({name: getattr(writer, "Get" + name)() for name in _FITNESS})
        return warnings
    if ending(path) != XDMF:
        write_grid(grid, path)
        return []
    check_holds_layers(path, has_layers(grid))
    if written_beside(path, grid, boundary) and not replaces_beside:
        check_beside(path)
    warnings = [] if is_flat(grid) or grid.GetNumberOfCells() == 0 else _fitness_of(grid, path, figures)
    try:
        write_xdmf(as_type(Triangles if is_flat(grid) else Tetrahedra, grid), path, boundary)
    except Error as error:
        is_named = any(name in str(error) for name in (path, boundary_beside(path)))
        raise error if is_named else Error(f"{path}: {error}") from None
    return warnings


def check_has_groups(path: str) -> None:
    """Raise `ArgumentError` unless a file of cells has groups that `cells_only` omits."""
    if ending(path) not in WRITABLE_SOLIDS:
        raise ArgumentError(f"{path}: cells_only leaves away the groups of {', '.join(WRITABLE_SOLIDS)} files")


def _fitness_of(grid: vtkUnstructuredGrid, path: str, figures: Dict[str, float]) -> list[str]:
    """The warnings of vtkSolidWriter for its files."""
    measure = vtkSolidQuality()
    measure.SetInputData(grid)
    warnings = in_words_of_python(run(measure))
    found = statistics_of(measure.GetOutput())
    figures.update({name: found[name] for name in _FITNESS})
    return [f"{path}: {warning}" for warning in warnings]


def _write_with_deck(writer: vtkSolidWriter, path: str, deck: Deck) -> list[str]:
    """Write mesh and deck, both or none."""
    with temporary_folder() as folder:
        whole = os.path.join(folder, "whole.inp")
        try:
            warnings = run_writer(writer, whole)
        except Error as error:
            raise Error(str(error).replace(whole, path)) from None
        with open(whole, encoding="utf-8") as file:
            mesh = file.read()
    try:
        text = deck.text_behind(mesh)
    except Error as error:
        raise Error(f"{path}: {error}") from None
    write_bytes((mesh + text).encode(), path)
    return [warning.replace(whole, path) for warning in warnings]
