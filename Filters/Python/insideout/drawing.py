# SPDX-License-Identifier: GPL-3.0-or-later
"""`draw`: one picture of what InsideOut does to a surface."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile

from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

from .data import AnySurface, as_surface
from .files import Path, check_output, write_grid, write_surface
from .pipeline import Error

PICTURES = (".png",)


def draw(surface: AnySurface, hull: vtkUnstructuredGrid, picture: Path) -> None:
    """Draw a surface's defects, a slice of w through its hull, and the tetrahedra inside, as a .png file.

    surface  a vtkPolyData, a file's name, a pair (points, triangles) of arrays or a meshio.Mesh
    hull     all tetrahedra of its hull: `tetrahedralize(surface).hull`
    picture  the file's name

    Draws in a process of its own, without a window; where there is no display it takes xvfb-run's.
    Raises `Error` with one line that names what is wrong.
    """
    check_output(picture, PICTURES)
    command = [*display_command(), sys.executable, "-m", "insideout.picture"]
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, "surface.vtp"), os.path.join(folder, "hull.vtu")]
        write_surface(as_surface(surface)[0], files[0])
        write_grid(hull, files[1])
        done = subprocess.run([*command, *files, os.fspath(picture)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = [line for line in done.stderr.splitlines() if line.strip()]
        raise Error(f"cannot draw {os.fspath(picture)}: {lines[-1] if lines else 'the drawing process ended'}")


def display_command() -> list[str]:
    """What to begin a command with that needs a display. Raises `Error` where there is none to be had."""
    if os.environ.get("DISPLAY"):
        return []
    if shutil.which("xvfb-run") is None:
        raise Error("there is no display to draw on: set DISPLAY, or apt-get install xvfb xauth")
    # One that does not start anew, and turn clients away meanwhile, when its last client goes.
    return ["xvfb-run", "-a", "-s", "-noreset -screen 0 1280x1024x24"]
