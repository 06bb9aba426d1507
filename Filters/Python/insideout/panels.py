# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of surfaces and hulls, drawn by a separate program (`insideout.picture`), because it needs a display."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import sys
from typing import Optional

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from .files import temporary_folder, write_grid, write_surface
from .interruption import cleaning_up, deferring_signals
from .pipeline import Error

PICTURES = (".png",)


def draw_panels(
    *,
    surface: Optional[vtkPolyData] = None,
    lines: Optional[vtkPolyData] = None,
    hull: Optional[vtkUnstructuredGrid] = None,
    solid: Optional[vtkUnstructuredGrid] = None,
    curve: Optional[vtkPolyData] = None,
    marks: Optional[vtkPolyData] = None,
    quality: Optional[vtkUnstructuredGrid] = None,
    up: Optional[str] = None,
    row: bool = False,
    timeout: Optional[float] = None,
) -> bytes:
    """The content of a .png file that shows those of these that are given: a surface with its defects (without a hull
    from two sides, with a legend); a slice and the solid of a hull; the dihedral angles of a solid.

    surface, lines  as `check` marks and draws them: both or none
    solid           what is inside a hull, where it is not cells of that
    curve           in a plane, of whose hull the hull's triangles are
    marks           the points that `check` draws of a curve
    quality         as `check_solid` measures it
    up              "x", "y" or "z"
    row             the solid's boundary, and its tetrahedra in slices, as well
    timeout         seconds

    Raises `Error` with one line.
    """
    command = [*display_command(), sys.executable, "-m", "insideout.picture"]
    with temporary_folder() as folder:
        names = ("picture.png", "surface.vtp", "lines.vtp", "hull.vtu", "quality.vtu", "curve.vtp", "solid.vtu", "marks.vtp")
        picture, *files = (os.path.join(folder, name) for name in names)
        command.append(picture)
        if surface is not None and lines is not None:
            write_surface(surface, files[0])
            write_surface(lines, files[1])
            command += ["--surface", files[0], files[1]]
        if hull is not None:
            write_grid(hull, files[2])
            command += ["--hull", files[2]]
        if solid is not None:
            write_grid(solid, files[5])
            command += ["--solid", files[5]]
        if curve is not None:
            write_surface(curve, files[4])
            command += ["--curve", files[4]]
        if marks is not None:
            write_surface(marks, files[6])
            command += ["--marks", files[6]]
        if quality is not None:
            figures = vtkUnstructuredGrid()
            figures.SetFieldData(quality.GetFieldData())
            write_grid(figures, files[3])
            command += ["--quality", files[3]]
        if up is not None:
            command += ["--up", up]
        if row:
            command.append("--row")
        _run(command, folder, timeout)
        with open(picture, "rb") as file:
            return file.read()


def display_command() -> list[str]:
    """Arguments that provide a display for a command. Raises `Error` if that is impossible."""
    if os.environ.get("DISPLAY"):
        return []
    if shutil.which("xvfb-run") is None:
        raise Error("there is no display to draw on: set DISPLAY, or apt-get install xvfb xauth")
    # A server that does not reset, which would reject clients, when its last client closes.
    return ["xvfb-run", "-a", "-s", "-noreset -screen 0 1280x1024x24"]


def _run(command: list[str], folder: str, timeout: Optional[float]) -> None:
    """Run a program whose temporary files are in a folder. Raises `Error` with the last line of its output."""
    with contextlib.ExitStack() as to_end:
        with deferring_signals():
            # In a session of its own, so that all processes that it started can be ended.
            process = to_end.enter_context(
                subprocess.Popen(
                    command,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                    text=True,
                    env={**os.environ, "TMPDIR": folder},
                    start_new_session=True,
                )
            )
            to_end.enter_context(cleaning_up(lambda: _end_all_of(process)))
        try:
            _, errors = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            raise Error(f"it takes more than {timeout:g} s") from None
    if process.returncode != 0:
        lines = [line for line in errors.splitlines() if line.strip()]
        raise Error(lines[-1] if lines else "the drawing process ended")


def _end_all_of(process: subprocess.Popen[str]) -> None:
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGTERM)
