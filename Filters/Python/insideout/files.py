# SPDX-License-Identifier: GPL-3.0-or-later
"""Read and write surfaces, and VTK's grids. The ending of a file's name decides its format.

A file is written under a temporary name and renamed when it is complete; until then an earlier one stays. XML files are
written in VTK's inline binary mode: what VTK writes by default, appended mode, cannot be read back where expat has a
certain security update.
"""

from __future__ import annotations

import gzip
import os
import shutil
import sys
import tempfile
import zlib
from contextlib import contextmanager
from typing import Any, Iterator, Optional, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkIOXMLParser import vtkXMLDataParser

from .curves import CURVE, read_curve
from .errors import ArgumentError
from .formats import BEGINNINGS, OBJECTS, bytes_of_objects, read_objects
from .interruption import cleaning_up
from .pipeline import Error, Messages, Progress, run, write_bytes, write_data
from .vtkFiltersInsideOut import vtkSolidReader, vtkSurfaceReader, vtkSurfaceWriter

Path = Union[str, os.PathLike]

READABLE_SURFACES = (".ply", ".obj", ".off", ".stl", ".vtp", *OBJECTS, CURVE)
WRITABLE_SURFACES = (".vtp", ".ply", ".stl", ".obj", ".off", *OBJECTS)
GRID = ".vtu"
"""VTK's own format of grids, and the format of a device or pipe whose name has no ending."""

READABLE_SOLIDS = (GRID, ".msh", ".inp", ".mesh")

GZIP = ".gz"

STANDARD_INPUT = "standard input"

_NO_FORMAT = "neither content nor ending"
"""Words of vtkSurfaceReader about an unknown format."""

SHARE_OF_MACHINE = 0.75
"""Limit on the size of a file's content, as a share of the machine's memory."""

PIECE = 1 << 20  # bytes, decompressed at once

LONGEST_CHAIN = 40  # of links, as in Linux

MARKED = (*WRITABLE_SURFACES, *READABLE_SOLIDS, CURVE, ".vti")
"""The endings of outputs that show which program wrote them: by a mark, or tables by the columns that `query` adds."""

_MARKS = (b"Written by InsideOut", b"Binary STL of InsideOut")
"""The marks: a comment, or the title of an STL file."""

_NEAR_AN_END = 1024  # bytes at the beginning and at the end of a file that are searched for a mark

# Errors of VTK's .vtp reader that are harmless: an empty surface, which its users report better, and a range stored
# with an array that is not finite.
HARMLESS_WHEN_READING = ("No Points element available", "Error reading InformationKey element")


def read_surface(path: Path, progress: Optional[Progress] = None) -> tuple[vtkPolyData, list[str]]:
    """Read the surface in a .ply, .obj, .off, .stl, .vtp, .glb or .3mf file, or one of these with .gz appended. Returns
    warnings of skipped content, too. A .csv file is a curve in a plane (see `read_curve`). Coordinates keep all digits
    of the file. If name and content disagree, the content decides, with a warning. Raises `Error` that names the file.
    """
    path = os.fspath(path)
    check_input(path)
    return _read(path, progress)


def read_standard_input(kind: Optional[str] = None, progress: Optional[Progress] = None) -> tuple[vtkPolyData, list[str]]:
    """Read the surface in standard input, and return warnings of skipped content, too. The content decides its format,
    or else `kind` ("obj")."""
    if sys.stdin is None:
        raise Error(f"{STANDARD_INPUT} is closed")
    name = "stdin" if kind is None else f"stdin.{kind}"
    with temporary_folder() as folder:
        path = os.path.join(folder, name)
        try:
            with open(path, "wb") as file:
                shutil.copyfileobj(sys.stdin.buffer, file)
        except OSError as error:
            raise Error(f"cannot keep {STANDARD_INPUT} in {path}: {_reason(error)}") from None
        if _is_compressed(path):
            os.rename(path, path + GZIP)
            path, name = path + GZIP, name + GZIP
        try:
            surface, warnings = _read(path, progress)
        except Error as error:
            hint = "; say what it is by --format" if kind is None and _NO_FORMAT in str(error) else ""
            raise Error(str(error).replace(path, STANDARD_INPUT) + hint) from None
    return surface, [warning.replace(name, STANDARD_INPUT) for warning in warnings]


def read_solid(path: Path, progress: Optional[Progress] = None) -> tuple[vtkUnstructuredGrid, list[str]]:
    """Read the cells in a .vtu, .msh, .inp or .mesh file. Returns warnings of skipped content, too. Raises `Error` that
    names the file."""
    path = os.fspath(path)
    check_input(path, READABLE_SOLIDS)
    if ending(path) == GRID:
        check_xml(path, "UnstructuredGrid", "cells")
    reader = vtkXMLUnstructuredGridReader() if ending(path) == GRID else vtkSolidReader()
    reader.SetFileName(path)
    try:
        warnings = run(reader, progress, harmless=HARMLESS_WHEN_READING)
    except Error as error:
        raise _naming(path, error) from None
    return reader.GetOutput(), warnings


def _read(path: str, progress: Optional[Progress]) -> tuple[vtkPolyData, list[str]]:
    surface, warnings = _read_by_content(path, progress)
    if surface.GetNumberOfPoints() == 0:
        raise Error(f"{path}: the surface is empty: it has no points")
    return surface, warnings


def _read_by_content(path: str, progress: Optional[Progress]) -> tuple[vtkPolyData, list[str]]:
    if _holds_xml(path):
        return _read_xml(path, progress)
    kind = BEGINNINGS.get(_begin(path)[:4])
    if kind is not None:
        return _read_objects(path, kind)
    if input_ending(path) == CURVE:
        with _decompressed(path) as plain:
            try:
                return read_curve(plain), []
            except Error as error:
                raise Error(str(error).replace(plain, path)) from None
    reader = vtkSurfaceReader()
    reader.SetFileName(path)
    try:
        warnings = run(reader, progress)
    except Error as error:
        if input_ending(path) in OBJECTS and _NO_FORMAT in str(error):
            raise Error(f"{path}: is no {_format(input_ending(path))} file: it does not begin as one does") from None
        raise _naming(path, error) from None
    return reader.GetOutput(), warnings


def _read_xml(path: str, progress: Optional[Progress]) -> tuple[vtkPolyData, list[str]]:
    reader = vtkXMLPolyDataReader()
    with _decompressed(path) as plain:
        try:
            check_xml(plain, "PolyData", "polygons")
            reader.SetFileName(plain)
            warnings = run(reader, progress, harmless=HARMLESS_WHEN_READING)
        except Error as error:
            raise _naming(path, Error(str(error).replace(plain, path))) from None
    return reader.GetOutput(), [*_false_names(path, ".vtp"), *warnings]


def _read_objects(path: str, kind: str) -> tuple[vtkPolyData, list[str]]:
    with _decompressed(path) as plain:
        try:
            surface, warnings = read_objects(plain, kind, _most_bytes())
        except Error as error:
            raise Error(f"{path}: {error}") from None
    return surface, [*_false_names(path, kind), *(f"{os.path.basename(path)}: {warning}" for warning in warnings)]


def _false_names(path: str, kind: str) -> Iterator[str]:
    """Return a warning if a file's name contradicts its content; vtkSurfaceReader gives the same for its files."""
    name = os.path.basename(path)
    if _is_compressed(path) and ending(path) != GZIP:
        yield f"{name}: is compressed with gzip, but its name does not end in .gz"
    if ending(path) == GZIP and not _is_compressed(path):
        yield f"{name}: is not compressed, but its name ends in .gz"
    if input_ending(path) in READABLE_SURFACES and input_ending(path) != kind:
        yield f"{name}: holds {_format(kind)}, not what its name says, and was read as such"


def _format(kind: str) -> str:
    return kind[1:].upper()


def _begin(path: str) -> bytes:
    """The first bytes of the content. Failed decompression is ignored: the reader reports the reason."""
    try:
        with gzip.open(path, "rb") if _is_compressed(path) else open(path, "rb") as file:
            return file.read(1000)
    except (OSError, EOFError, zlib.error):
        return b""


def _holds_xml(path: str) -> bool:
    """Whether the content begins as VTK's XML does."""
    begin = _begin(path).removeprefix(b"\xef\xbb\xbf").lstrip()
    return begin.startswith((b"<?xml", b"<VTKFile")) or input_ending(path) == ".vtp" and begin.startswith(b"<")


def _is_compressed(path: str) -> bool:
    with open(path, "rb") as file:
        return file.read(2) == b"\x1f\x8b"


@contextmanager
def _decompressed(path: str) -> Iterator[str]:
    """A file with the same content, uncompressed."""
    if not _is_compressed(path):
        yield path
        return
    most = _most_bytes()
    with temporary_folder() as folder:
        plain = os.path.join(folder, "plain.vtp")
        try:
            with gzip.open(path) as source, open(plain, "wb") as file:
                while piece := source.read(PIECE):
                    file.write(piece)
                    if file.tell() > most:
                        raise Error(f"{path}: is compressed with gzip, and holds more than {most:.0f} bytes, too many for this machine")
        except EOFError:
            raise Error(f"{path}: is compressed with gzip, and its end is missing") from None
        except (gzip.BadGzipFile, zlib.error) as error:
            raise Error(f"{path}: is compressed with gzip, and damaged: {error}") from None
        except OSError as error:
            raise Error(f"cannot decompress {path}: {_reason(error)}") from None
        yield plain


def _most_bytes() -> float:
    return SHARE_OF_MACHINE * os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


@contextmanager
def temporary_folder() -> Iterator[str]:
    """A temporary folder, which is removed at the end with its content."""
    try:
        folder = tempfile.mkdtemp()
    except OSError as error:
        raise Error(f"there is no folder for temporary files: {_reason(error)}") from None
    with cleaning_up(lambda: shutil.rmtree(folder, ignore_errors=True)):
        yield folder


def are_lines(surface: vtkPolyData) -> bool:
    """Whether it is lines without polygons."""
    return bool(surface.GetNumberOfLines() > 0 and surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0)


def check_holds_lines(path: str) -> None:
    """Raise `ArgumentError` unless a file of a surface can be lines, as the boundary in a plane is."""
    if ending(path) != ".vtp":
        raise ArgumentError(f"{path}: the boundary is lines, which only .vtp files hold here")


def write_surface(surface: vtkPolyData, path: Path) -> list[str]:
    """Write a surface as .vtp, .ply, .obj, .off, .3mf, .stl or .glb (the last two have only floats), lines as .vtp.
    Raises `Error` that names the file. Returns warnings of data that the format cannot keep.
    """
    path = os.fspath(path)
    check_output(path, WRITABLE_SURFACES)
    if are_lines(surface):
        check_holds_lines(path)
    if ending(path) == ".vtp":
        write_data(surface, path)
        return []
    if ending(path) in OBJECTS:
        return _write_objects(surface, path)
    writer = vtkSurfaceWriter()
    writer.SetInputData(surface)
    return run_writer(writer, path)


def _write_objects(surface: vtkPolyData, path: str) -> list[str]:
    try:
        content, warnings = bytes_of_objects(surface, ending(path))
    except Error as error:
        raise Error(f"{path}: {error}") from None
    write_bytes(content, path)
    return [f"{path}: {warning}" for warning in warnings]


def run_writer(writer: Any, path: str) -> list[str]:
    """Write a file by a VTK writer. Returns its warnings. Raises `Error` that names the file."""
    writer.SetFileName(path)
    try:
        return run(writer)
    except Error as error:
        raise _naming(path, error) from None


def write_grid(grid: vtkUnstructuredGrid, path: Path) -> None:
    """Write tetrahedra as .vtu. Raises `Error` that names the file."""
    path = os.fspath(path)
    check_output(path, (GRID,))
    write_data(grid, path)


def ending(path: Path) -> str:
    """The ending of a file's name in lower case, with its dot."""
    return os.path.splitext(os.fspath(path))[1].lower()


def input_ending(path: Path) -> str:
    """The ending of a surface's file, without that of the compression."""
    plain, last = os.path.splitext(os.fspath(path))
    return ending(plain) if last.lower() == GZIP else last.lower()


def check_input(path: Path, endings: tuple[str, ...] = READABLE_SURFACES) -> None:
    """Raise `Error` unless the file has one of the endings and can be opened; surfaces may be compressed."""
    path = os.fspath(path)
    found = input_ending(path) if endings == READABLE_SURFACES else ending(path)
    _check_ending(path, found, endings)
    _check_encoding(path)
    try:
        with open(path, "rb") as file:
            file.read(1)
    except OSError as error:
        raise Error(f"cannot read {path}: {_reason(error)}") from None


def check_output(path: Path, endings: tuple[str, ...]) -> None:
    """Raise `Error` unless the name has one of the endings and a file can be written there. Devices and pipes need no
    ending if only one is possible, or if VTK's grids are.
    """
    path = os.fspath(path)
    _check_encoding(path)
    is_special = _is_special(path)
    if not is_special or len(endings) > 1 and GRID not in endings:
        _check_ending(path, ending(path), endings)
    if os.path.isdir(path):
        raise Error(f"cannot write {path}: it is a folder")
    folder = os.path.dirname(os.path.realpath(path))  # the target of a link is replaced, not the link
    if not os.path.isdir(folder):
        raise Error(f"cannot write {path}: there is no folder {folder if os.path.islink(path) else os.path.dirname(path)}")
    if os.path.exists(path) and not os.access(path, os.W_OK) or not is_special and not os.access(folder, os.W_OK):
        raise Error(f"cannot write {path}: permission denied")


def is_of_others(path: Path) -> bool:
    """Whether a non-empty file exists there without a mark of this program."""
    if not os.path.isfile(path) or os.path.getsize(path) == 0:
        return False
    try:
        with open(path, "rb") as file:
            begin = file.read(_NEAR_AN_END)
            file.seek(max(0, os.path.getsize(path) - _NEAR_AN_END))
            ends = (begin, file.read())
    except OSError:
        return True
    if ending(path) == CURVE:
        return not {b"w", b"inside"} <= {name.strip().lower() for name in begin.split(b"\n")[0].split(b",")}
    return not any(mark in end for mark in _MARKS for end in ends)


def identity(path: Path) -> Optional[object]:
    """An identity of the file, the same for links, hard links and other spellings; None for devices and pipes, which no
    file replaces."""
    if _is_special(path):
        return None
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        folder, name = os.path.split(os.path.realpath(path))
        return identity(folder), name
    return status.st_dev, status.st_ino


def _is_special(path: Path) -> bool:
    """Whether this is a device, a pipe or an open stream (`/dev/stdout`), which no file can replace."""
    path = os.fspath(path)
    for _ in range(LONGEST_CHAIN):
        if not os.path.islink(path):
            break
        folder = os.path.dirname(path)
        if os.path.realpath(folder) == os.path.realpath("/proc/self/fd"):
            return True
        path = os.path.join(folder, os.readlink(path))
    return os.path.exists(path) and not os.path.isfile(path) and not os.path.isdir(path)


def _check_ending(path: str, found: str, endings: tuple[str, ...]) -> None:
    if found not in endings:
        raise ArgumentError(f"{path}: unknown ending, it must be {' '.join(endings)}")


def _check_encoding(path: str) -> None:
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
        raise Error(f"cannot read {path}: it is not a VTK XML file of {words} ({kind})")


def _hint(path: str) -> str:
    """A hint at appended data, the likeliest reason why a file in VTK's own format cannot be read."""
    with open(path, "rb") as file:
        appended = b"<AppendedData" in file.read()
    return " (it is in appended mode; write it in binary mode instead)" if appended else ""


def _naming(path: str, error: Error) -> Error:
    """The error with the file's name; the reader gives the name without its folder."""
    message, name = str(error), os.path.basename(path)
    if path in message:
        return error
    return Error(path + message[len(name) :] if message.startswith(name) else f"{path}: {message}")


def _reason(error: OSError) -> str:
    return (error.strerror or str(error)).lower()
