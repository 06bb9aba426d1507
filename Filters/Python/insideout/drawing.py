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

    surface  any type of surface that `insideout` accepts: a vtkPolyData, a file's name, a pair (points, triangles) ...;
             or a `Check`, to draw the defects alone
    hull     all tetrahedra of its hull, `tetrahedralize(surface).hull`; or None to draw the defects alone, from two
             sides, with the worst places and all counts
    picture  the file's name, .png or .html
    solid    the solid, if its cells are not those of the hull: a refined `result.solid`
    title    the heading of a page; by default the name of the surface's file
    up       which axis is up, "x", "y" or "z"; by default z for a .stl file, otherwise y, or z if the surface is longer
             along z by a tenth
    row      draw a whole row, with the solid's boundary and its tetrahedra in slices, too; not for a page

    {options}

    The view is that of the four sides (and the top, if the surface is very flat) with the largest outline; of two
    opposite sides, the one with more points in front of the middle. The counts are those of the run that made the hull,
    and are in the file's description, too; give the same options, so that the marks agree with them. Colors are those
    of Okabe and Ito, which color-blind readers can distinguish. In two dimensions the picture shows the curve with its
    defects as points, w in all triangles, and the triangles inside, from above.

    Pictures are drawn in a separate process, without a window, by xvfb-run if there is no display. A page needs no
    display. Raises `Error` with one line that names the culprit.
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

    solid    a `SolidCheck`, or any type of solid that `check_solid` accepts: a vtkUnstructuredGrid, a file's name ...
    picture  the file's name

    The figures are in the file's description, too. Raises `Error` with one line that names the culprit.
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
    from .page import page_of  # it imports VTK's rendering classes

    write_bytes(page_of(checked, hull, solid, title or "A surface", up), path)


def _write_panels(picture: str, **seen: Any) -> None:
    try:
        drawn = draw_panels(**seen)
    except (Error, OSError) as error:
        raise Error(f"cannot draw {picture}: {error}") from None
    write_bytes(drawn, picture)


def up_of(surface: Union[Check, AnySurface]) -> Optional[str]:
    """The up axis by the kind of file: z for formats of machines; None for others, which may use either."""
    is_of_machines = isinstance(surface, (str, os.PathLike)) and input_ending(path_of("the surface", surface)) in _OF_MACHINES
    return "z" if is_of_machines else None
