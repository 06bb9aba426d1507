# SPDX-License-Identifier: GPL-3.0-or-later
"""Draw a surface and its solid."""

from __future__ import annotations

import os
from typing import Any, Optional, Union

from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

from .calling import for_users
from .checking import Check, check
from .data import is_flat
from .errors import Error, brief, one_of, switch, text_of
from .files import Path, are_lines, check_output, ending, input_ending
from .inputs import path_of
from .lengths import Length
from .options import Options, Orientation, describe_options
from .panels import PICTURES, display_command, draw_panels
from .pipeline import write_bytes
from .quality import SolidCheck, check_solid
from .solids import AnySolid
from .surfaces import AnySurface, as_surface

PAGE = ".html"
DRAWINGS = (*PICTURES, PAGE)
_OF_MACHINES = (".stl", ".3mf")


@for_users
@describe_options
def draw(
    surface: Union[Check, AnySurface],
    hull: Optional[vtkUnstructuredGrid],
    picture: Path,
    *,
    solid: Optional[vtkUnstructuredGrid] = None,
    title: Optional[str] = None,
    up: Optional[str] = None,
    row: bool = False,
    scale: Optional[float] = None,
    orientation: Orientation = "automatic",
    merge_tolerance: Optional[Length] = None,
) -> None:
    """Draw a surface's defects, a slice of w through its hull, and the tetrahedra inside; or the defects alone.

    A .png file is a picture. An .html file is a page to turn and to cut, with the report: any browser with WebGL 2 shows
    it, without a network.

    surface  what `insideout` takes for one: a vtkPolyData, a file's name, a pair (points, triangles) ...; or what
             `check` found of it, where only that is drawn
    hull     all tetrahedra of its hull, `tetrahedralize(surface).hull`; or None for what is wrong alone, from
             two sides, with the worst places and all counts
    picture  the file's name, .png or .html
    solid    what is inside, where that is not cells of the hull but made of them: a refined `result.solid`
    title    what a page calls the surface; if it is not given the name of its file
    up       which axis is up, "x", "y" or "z"; if it is not given z for a .stl file, otherwise y, or z where
             the surface is longer along it by a tenth
    row      a whole row of a contact sheet: the solid's boundary, and its tetrahedra in slices, as well; not of a page

    {options}

    It is seen from the side that shows most: of the four sides, or from above if it is very flat, the one
    whose outline is largest, and of two opposite ones that with more points before the middle. The counts
    are those of the run that made the hull, and stand in the file's description, too; give the options it
    had for the marks to agree with them. Colors are those of Okabe and Ito, which color-blind readers tell
    apart. In two dimensions it is the curve with its defects as
    points, w in all triangles, and those inside, seen straight from above.

    Draws pictures in a process of its own, without a window; where there is no display it takes xvfb-run's. A page needs none.
    Raises `Error` with one line that names what is wrong.
    """
    picture = path_of("picture", picture)
    check_output(picture, DRAWINGS)
    for name, grid in (("hull", hull), ("solid", solid)):
        if grid is not None and not isinstance(grid, vtkUnstructuredGrid):
            raise Error(f"{name} is {brief(grid)}; it must be a vtkUnstructuredGrid")
    if hull is not None and (hull.GetNumberOfCells() == 0 or not hull.GetCellData().HasArray("w")):
        raise Error("hull has no cells with an array w: it must be that of `tetrahedralize`, without surface_only")
    row = switch("row", row)
    title = None if title is None else text_of("title", title)
    up = one_of(("x", "y", "z"), "up", up) if up is not None else up_of(surface)
    if isinstance(surface, Check):
        if hull is not None:
            raise Error("the surface is a Check, which is drawn alone: give the surface itself beside a hull")
        _write_drawing(picture, surface, None, None, title, up, row)
        return
    if hull is not None and is_flat(hull):
        refuse_page_of_plane(picture)
        curve = as_surface(surface, Options(scale=scale).factor())[0]
        # Defects of polygons are those of surfaces in space: their edges are open.
        marks = check(curve, orientation=orientation, merge_tolerance=merge_tolerance).lines if curve.GetNumberOfPolys() == 0 else None
        _write_panels(picture, curve=curve, marks=marks, hull=hull, solid=solid, up=up)
        return
    checked = check(surface, scale=scale, orientation=orientation, merge_tolerance=merge_tolerance)
    if title is None and isinstance(surface, (str, os.PathLike)):
        title = os.path.basename(path_of("the surface", surface))
    _write_drawing(picture, checked, hull, solid, title, up, row)


@for_users
def draw_quality(solid: Union[SolidCheck, AnySolid], picture: Path) -> None:
    """Draw the histogram of a solid's dihedral angles, as a .png file.

    solid    what `check_solid` found, or what it takes: a vtkUnstructuredGrid, a file's name ...
    picture  the file's name

    The figures stand in the file's description, too. Raises `Error` with one line that names what is wrong.
    """
    picture = path_of("picture", picture)
    check_output(picture, PICTURES)
    checked = solid if isinstance(solid, SolidCheck) else check_solid(solid)
    _write_panels(picture, quality=checked.solid)


def check_display(drawing: Optional[str]) -> None:
    """Raise `Error` if a picture needs a display and there is none. A page needs none."""
    if drawing is not None and ending(drawing) != PAGE:
        display_command()


def refuse_page_of_plane(drawing: Optional[str]) -> None:
    """Raise `Error` if a page is requested of planar input."""
    if drawing is not None and ending(drawing) == PAGE:
        raise Error(f"{drawing}: a page shows a surface in space, and this lies in a plane: draw a picture ({PICTURES[0]})")


def _write_drawing(
    path: str,
    checked: Check,
    hull: Optional[vtkUnstructuredGrid],
    solid: Optional[vtkUnstructuredGrid],
    title: Optional[str],
    up: Optional[str],
    row: bool,
) -> None:
    """A picture or a page of a surface that is checked."""
    if ending(path) != PAGE:
        _write_panels(path, surface=checked.surface, lines=checked.lines, hull=hull, solid=solid, up=up, row=row)
        return
    if are_lines(checked.surface):
        refuse_page_of_plane(path)
    from .page import page_of  # which takes VTK's rendering classes

    write_bytes(page_of(checked, hull, solid, title or "A surface", up), path)


def _write_panels(picture: str, **seen: Any) -> None:
    try:
        drawn = draw_panels(**seen)
    except (Error, OSError) as error:
        raise Error(f"cannot draw {picture}: {error}") from None
    write_bytes(drawn, picture)


def up_of(surface: Union[Check, AnySurface]) -> Optional[str]:
    """The up axis by the kind of file: z for machines' formats; others may use either."""
    is_of_machines = isinstance(surface, (str, os.PathLike)) and input_ending(path_of("the surface", surface)) in _OF_MACHINES
    return "z" if is_of_machines else None
