# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout demo`: a folder of small broken surfaces, and commands to try on them."""

from __future__ import annotations

import os
import shlex
from typing import Optional

from .. import demo
from ..files import is_of_others, temporary_folder, write_surface
from ..pipeline import Error, write_bytes, write_data
from .job import FAILURE, SUCCESS, print_error, print_lines

SURFACES = {
    "broken.ply": demo.figure,
    "inverted.stl": demo.inverted,
    "organ.ply": demo.organ,
    "tumor.ply": demo.tumor,
    "bracket.obj": demo.bracket,
    "scan.ply": demo.scan,
}
TEXTS = {"outline.csv": demo.OUTLINE, "places.csv": demo.PLACES, "steel.inp": demo.STEEL}
GRID, POINTS_ALONG_GRID = "grid.vti", 50

COMMANDS = (
    ("insideout check broken.ply", "what is wrong, and whether it matters"),
    ("insideout draw broken.ply wrong.png --defects", "the same as a picture"),
    ("insideout draw broken.ply page.html", "a page to turn and to cut, for any browser"),
    ("insideout repair broken.ply fixed.stl", "its watertight surface, to print"),
    ("insideout mesh broken.ply solid.vtu --plot solid.png", "its tetrahedra, and a picture of them"),
    ("insideout mesh inverted.stl both.vtu", "a part that is inside out is turned over"),
    ("insideout mesh bracket.obj bracket.inp --edge-length 5 --surface-treatment split --quadratic-cells", "cells and sets by name for CalculiX"),
    ("ccx steel", "its stress under the load of steel.inp, where CalculiX is installed"),
    ("insideout mesh --together organ.ply tumor.ply organs.msh --priority tumor", "two organs, one mesh, a region each"),
    ('insideout boolean "organ - tumor" organ.ply tumor.ply rest.stl', "a set operation"),
    ("insideout query grid.vti scan.ply mask.vti --distance", "a mask and signed distances of an open scan"),
    ("insideout query places.csv broken.ply inside.csv", "which places are inside"),
    ("insideout mesh outline.csv outline.vtu", "triangles of an outline with a gap and crossings"),
)
"""Commands to try, and their results; they may run in any order, except for ccx, which needs the bracket's cells."""


def contents() -> dict[str, bytes]:
    """The content of the demo's files, by name."""
    made = {name: text.encode() for name, text in TEXTS.items()}
    with temporary_folder() as folder:
        for name, surface in SURFACES.items():
            write_surface(surface(), os.path.join(folder, name))
        write_data(demo.grid_around(demo.scan(), POINTS_ALONG_GRID), os.path.join(folder, GRID))
        for name in (*SURFACES, GRID):
            with open(os.path.join(folder, name), "rb") as file:
                made[name] = file.read()
    return made


def write_demo(folder: str) -> list[str]:
    """Write the files into a folder, which is made if it is missing. Returns their names. Raises `Error`, and writes
    nothing, if one would replace a file of another program.
    """
    made = contents()
    for name, content in made.items():
        path = os.path.join(folder, name)
        if os.path.isdir(path):
            raise Error(f"{path} is a folder; give the demo another one: insideout demo FOLDER")
        if is_of_others(path) and not _holds(path, content):
            raise Error(f"{path} was not written by insideout, and stays; give the demo another folder: insideout demo FOLDER")
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise Error(f"cannot make the folder {folder}: {(error.strerror or str(error)).lower()}") from None
    for name, content in made.items():
        write_bytes(content, os.path.join(folder, name))
    return sorted(made)


def _holds(path: str, content: bytes) -> bool:
    try:
        with open(path, "rb") as file:
            return file.read() == content
    except OSError:
        return False


def run_demo(folder: str, quiet: Optional[bool]) -> int:
    """Returns the exit status."""
    try:
        names = write_demo(folder)
    except (Error, OSError) as error:
        print_error(str(error))
        return FAILURE
    if quiet:
        return SUCCESS
    width = max(len(command) for command, _ in COMMANDS)
    there = [] if os.path.abspath(folder) == os.getcwd() else [f"cd {shlex.quote(folder)}"]
    lines = [f"Wrote into {folder}: {' '.join(names)}", "", "Try:", ""]
    print_lines([*lines, *there, *(f"{command:{width}}  # {what}" for command, what in COMMANDS)])
    return SUCCESS
