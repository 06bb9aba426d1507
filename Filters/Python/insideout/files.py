# SPDX-License-Identifier: GPL-3.0-or-later
"""Read surfaces and write results. The ending of a file's name says what it holds.

XML files are written in VTK's inline binary mode: what VTK writes by default, appended mode, cannot
be read back where expat has a certain security update.
"""

from __future__ import annotations

import os
from typing import Optional, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOCore import vtkWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter, vtkXMLWriter
from vtkmodules.vtkIOXMLParser import vtkXMLDataParser

from .pipeline import Error, Messages, Progress, run
from .vtkFiltersInsideOut import vtkSurfaceReader, vtkSurfaceWriter

Path = Union[str, os.PathLike]

READABLE_SURFACES = (".ply", ".obj", ".off", ".stl", ".vtp")
WRITABLE_SURFACES = (".vtp", ".ply", ".stl", ".obj")
WRITABLE_GRIDS = (".vtu",)

# Of zlib, which every reader of VTK's XML files knows. VTK's default takes 2.5 times as long to write
# a solid of 123,000 tetrahedra, for 7 % fewer bytes.
FASTEST_COMPRESSION = 1

# What VTK's .vtp reader calls an error and is none: that a surface is empty, which whoever takes it
# says better, and that a range which VTK noted beside an array is not finite.
HARMLESS_WHEN_READING = ("No Points element available", "Error reading InformationKey element")


def read_surface(path: Path, progress: Optional[Progress] = None) -> tuple[vtkPolyData, list[str]]:
    """The surface in a .ply, .obj, .off, .stl or .vtp file, and what was passed over in the file.

    Coordinates keep all the digits that the file gives. Raises `Error` that names the file.
    """
    path = os.fspath(path)
    check_input(path)
    reader = vtkSurfaceReader()
    if ending(path) == ".vtp":
        check_xml(path, "PolyData", "polygons")
        reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    try:
        warnings = run(reader, progress, harmless=HARMLESS_WHEN_READING)
    except Error as error:
        raise _naming(path, error) from None
    return reader.GetOutput(), warnings


def write_surface(surface: vtkPolyData, path: Path) -> None:
    """Write a surface as .vtp, .ply, .obj or .stl (which has only floats). Raises `Error` that names the file."""
    path = os.fspath(path)
    check_output(path, WRITABLE_SURFACES)
    _write(vtkXMLPolyDataWriter() if ending(path) == ".vtp" else vtkSurfaceWriter(), surface, path)


def write_grid(grid: vtkUnstructuredGrid, path: Path) -> None:
    """Write tetrahedra as .vtu. Raises `Error` that names the file."""
    path = os.fspath(path)
    check_output(path, WRITABLE_GRIDS)
    _write(vtkXMLUnstructuredGridWriter(), grid, path)


def write(data: Union[vtkPolyData, vtkUnstructuredGrid], path: Path) -> None:
    """Write a surface as .vtp, .ply, .obj or .stl, or tetrahedra as .vtu. Raises `Error` that names the file."""
    if isinstance(data, vtkUnstructuredGrid):
        write_grid(data, path)
    else:
        write_surface(data, path)


def ending(path: Path) -> str:
    """The ending of a file's name in lower case, with its dot."""
    return os.path.splitext(os.fspath(path))[1].lower()


def check_input(path: Path, endings: tuple[str, ...] = READABLE_SURFACES) -> None:
    """Raise `Error` unless this is a file with one of the endings that can be opened."""
    path = os.fspath(path)
    _check_name(path, endings)
    try:
        with open(path, "rb") as file:
            file.read(1)
    except OSError as error:
        raise Error(f"cannot read {path}: {_reason(error)}") from None


def check_output(path: Path, endings: tuple[str, ...]) -> None:
    """Raise `Error` unless the name has one of the endings and a file can be written there."""
    path = os.fspath(path)
    _check_name(path, endings)
    folder = os.path.dirname(path) or "."
    if os.path.isdir(path):
        raise Error(f"cannot write {path}: it is a folder")
    if not os.path.isdir(folder):
        raise Error(f"cannot write {path}: there is no folder {folder}")
    if not os.access(path if os.path.exists(path) else folder, os.W_OK):
        raise Error(f"cannot write {path}: permission denied")


def _check_name(path: str, endings: tuple[str, ...]) -> None:
    if ending(path) not in endings:
        raise Error(f"{path}: unknown ending, it must be {' '.join(endings)}")
    try:
        path.encode("utf-8")  # VTK's way of passing names
    except UnicodeEncodeError:
        raise Error(f"{ascii(path)}: the name is not valid UTF-8") from None
    if "\0" in path:
        raise Error(f"{ascii(path)}: the name holds a zero byte")


def check_xml(path: str, kind: str, words: str) -> None:
    """Raise `Error` unless the file is VTK's XML of this kind. VTK's readers crash or say little otherwise."""
    parser = vtkXMLDataParser()
    parser.SetFileName(path)
    with Messages(parser) as messages:
        parser.Parse()
    if messages.errors:
        raise Error(f"cannot read {path}: {messages.errors[0]}{_hint(path)}")
    root = parser.GetRootElement()
    if root is None or root.GetName() != "VTKFile" or root.GetAttribute("type") != kind:
        raise Error(f"cannot read {path}: it is no VTK XML file of {words} ({kind})")


def _hint(path: str) -> str:
    """Appended data is the likeliest reason for a file of VTK's own not to be read."""
    with open(path, "rb") as file:
        appended = b"<AppendedData" in file.read()
    return " (it is in appended mode; write it in binary mode instead)" if appended else ""


def _write(writer: Union[vtkWriter, vtkXMLWriter], data: Union[vtkPolyData, vtkUnstructuredGrid], path: str) -> None:
    writer.SetFileName(path)
    writer.SetInputData(data)
    if isinstance(writer, vtkXMLWriter):
        writer.SetDataModeToBinary()
        writer.SetCompressionLevel(FASTEST_COMPRESSION)
    try:
        run(writer)
    except Error as error:
        raise _naming(path, error) from None
    if not os.path.exists(path):
        raise Error(f"cannot write {path}")


def _naming(path: str, error: Error) -> Error:
    """The error with the file's name in it; the reader gives that without its folder."""
    message, name = str(error), os.path.basename(path)
    if path in message:
        return error
    return Error(path + message[len(name) :] if message.startswith(name) else f"{path}: {message}")


def _reason(error: OSError) -> str:
    return (error.strerror or str(error)).lower()
