# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs that measure-quality.py and table.py compare: what each is given, how it is run, what it says.

Each runs in a process of its own with a limit of memory and of processor time, which does not run on while other processes
have the processors. As a program this is three of them:

    meshers.py netgen BOUNDARY.stl MESH.vol          mesh a surface by Netgen's Python module
    meshers.py delaunay SURFACE.vtp MESH.vtu         vtkDelaunay3D's cells whose centers vtkSelectEnclosedPoints has inside
    meshers.py refine SOLID.vtu MESH.vtu NAME=VALUE...  improve a solid by vtkRefineTetrahedra with these properties
"""

from __future__ import annotations

import contextlib
import io
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Callable, Mapping, Optional

import insideout
import numpy as np
from solids import Boundary, points_and_cells, read_grid, volume_of
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkCellCenters, vtkDelaunay3D, vtkThreshold
from vtkmodules.vtkFiltersModeling import vtkSelectEnclosedPoints
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

MOST_BYTES = 4 << 30
LEAST_VOLUME, MOST_VOLUME = 0.95, 1.05  # of the solid's: a mesh with less or more lacks a part or fills a cavity
MOST_WAITING = 4  # times the processor time, until a process that does nothing is ended
PYTHON = "/usr/bin/python3"  # that of Debian's packages


@dataclass
class Outcome:
    """What became of one surface."""

    figures: Optional[Mapping[str, float]]
    """The statistics of vtkSolidQuality; none without a mesh."""
    seconds: Optional[float]
    """Processor time of the mesher's own, without files: each has one thread."""
    trouble: str = ""
    """The mesh's defects, or the reason for its absence."""


@dataclass
class Answer:
    """A mesh of tetrahedra, or why there is none."""

    points: Optional[np.ndarray] = None
    cells: Optional[np.ndarray] = None
    seconds: Optional[float] = None
    trouble: str = ""


@dataclass
class Mesher:
    """A program, or one with certain options."""

    name: str
    package: Optional[str]
    """Debian's that has it; none if it is ours."""
    exists: Callable[[], bool]
    command: Callable[[Path], list[str]]
    """To run, given the folder of the inputs."""
    mesh: str
    """The file that it writes."""
    seconds: Callable[[str], float]
    """By what it prints."""

    def run(self, folder: Path, volume: float, limit: float) -> Outcome:
        """Mesh a solid of this volume, whose files are in the folder, and say how good the cells are."""
        answer = self.answer(folder, limit)
        if answer.points is None:
            return Outcome(None, None, answer.trouble)
        part = volume_of(answer.points, answer.cells) / volume
        if not LEAST_VOLUME <= part <= MOST_VOLUME:
            return Outcome(None, None, f"{100 * part:.3g} % of the volume")
        return outcome_of(answer.points, answer.cells, answer.seconds)

    def answer(self, folder: Path, limit: float) -> Answer:
        """Mesh what the folder's files have, and leave there what was there before."""
        before = set(folder.iterdir())
        try:
            return self._answer(folder, limit)
        finally:
            for path in set(folder.iterdir()) - before:
                path.unlink()

    def _answer(self, folder: Path, limit: float) -> Answer:
        mesh = folder / self.mesh
        command = self.command(folder)
        over = Answer(trouble=f"over {limit:g} s")
        try:
            done = subprocess.run(
                command,
                cwd=folder,
                timeout=MOST_WAITING * limit,
                text=True,
                errors="replace",
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                preexec_fn=lambda: set_limits(limit),
            )
        except subprocess.TimeoutExpired:
            return over
        if done.returncode in (-signal.SIGXCPU, 128 + signal.SIGXCPU):  # a shell's way to say it
            return over
        if done.returncode != 0 or not mesh.exists():
            return Answer(trouble=_trouble(done.returncode, done.stdout))
        return Answer(*read_mesh(mesh), self.seconds(done.stdout))


def mesh_as_it_comes(surface: str, folder: Path, limit: float) -> str:
    """By our command line, to solid.vtu, hull.vtu and report.json in the folder. Gives what went wrong, or nothing."""
    # A process begins with the peak memory of the one that starts it: a shell's is small.
    command = ["sh", "-c", '"$@"; exit $?', "sh"]
    command += [sys.executable, "-m", "insideout", os.path.abspath(surface), "solid.vtu", "--hull", "hull.vtu"]
    command += ["--report", "report.json", "--quiet", "--dimension", "3", "--timeout", f"{limit:g}"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    said = done.stderr.strip().splitlines() or [f"status {done.returncode}"]
    return "" if done.returncode == 0 else said[-1].removeprefix("insideout: ").removeprefix(f"{os.path.abspath(surface)}: ")


def outcome_of(points: np.ndarray, cells: np.ndarray, seconds: float) -> Outcome:
    checked = insideout.check_solid((points, cells))
    return Outcome(checked.statistics, seconds, "; ".join(finding.text for finding in checked.findings if finding.matters))


def write_inputs(boundary: Boundary, folder: Path) -> None:
    """The boundary as each mesher reads it, with all digits."""
    _write_poly(boundary, folder / "boundary.poly")
    _write_stl(boundary, folder / "boundary.stl")
    _write_gmsh(boundary, folder)


def _write_poly(boundary: Boundary, path: Path) -> None:
    """TetGen's: a facet for each triangle, and a hole for each cavity."""
    with path.open("w") as file:
        file.write(f"{len(boundary.points)} 3 0 0\n")
        file.writelines(f"{k} {x!r} {y!r} {z!r}\n" for k, (x, y, z) in enumerate(boundary.points.tolist()))
        file.write(f"{len(boundary.triangles)} 0\n")
        file.writelines(f"1\n3 {a} {b} {c}\n" for a, b, c in boundary.triangles.tolist())
        file.write(f"{len(boundary.cavities)}\n")
        file.writelines(f"{k} {x!r} {y!r} {z!r}\n" for k, (x, y, z) in enumerate(boundary.cavities.tolist()))
        file.write("0\n")


def _write_stl(boundary: Boundary, path: Path) -> None:
    with path.open("w") as file:
        file.write("solid boundary\n")
        for corners in boundary.points[boundary.triangles].tolist():
            lines = "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners)
            file.write(f"facet normal 0 0 0\nouter loop\n{lines}endloop\nendfacet\n")
        file.write("endsolid boundary\n")


def _write_gmsh(boundary: Boundary, folder: Path) -> None:
    """gmsh's own format, which merges no points: a discrete surface for each shell, and a volume for each part."""
    shells = boundary.shells()
    with (folder / "boundary.msh").open("w") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(boundary.points)}\n")
        file.writelines(f"{k} {x!r} {y!r} {z!r}\n" for k, (x, y, z) in enumerate(boundary.points.tolist(), 1))
        file.write(f"$EndNodes\n$Elements\n{len(boundary.triangles)}\n")
        number = 0
        for entity, (_, _, members) in enumerate(shells, 1):
            for a, b, c in (boundary.triangles[members] + 1).tolist():
                number += 1
                file.write(f"{number} 2 2 0 {entity} {a} {b} {c}\n")
        file.write("$EndElements\n")
    with (folder / "boundary.geo").open("w") as file:
        file.write('Merge "boundary.msh";\n')
        for volume, part in enumerate(sorted({part for part, _, _ in shells}), 1):
            around = ", ".join(str(entity) for entity, shell in enumerate(shells, 1) if shell[0] == part)
            file.write(f"Surface Loop({volume}) = {{{around}}};\nVolume({volume}) = {{{volume}}};\n")


def meshers(settings: list[str]) -> list[Mesher]:
    """All of them, those to compare with first."""
    return [
        *(tetgen(options) for options in TETGENS),
        *(_gmsh(name, algorithm) for name, algorithm in GMSHES.items()),
        _netgen(),
        *(_refinement(treatment, settings) for treatment in TREATMENTS),
    ]


def meshers_of_any_surface() -> list[Mesher]:
    """Those that may be given a surface as it comes."""
    return [tetgen("p"), _gmsh("gmsh", "del3d"), _netgen(), _delaunay(), _ftetwild()]


TETGENS = ("pq1.2/18O9Y", "pq1.2/18O9", "pq1.2O9")  # the last asks for no angle: with one 1.5 seldom ends
GMSHES = {"gmsh Delaunay": "del3d", "gmsh HXT": "hxt"}


def tetgen(options: str) -> Mesher:
    def command(folder: Path) -> list[str]:
        # Each run has files of its own: TetGen names its mesh after what it reads.
        shutil.copyfile(folder / "boundary.poly", folder / f"{_word(options)}.poly")
        return ["tetgen", "-" + options, f"{_word(options)}.poly"]

    def seconds(text: str) -> float:
        stages = re.findall(r"^(.*) seconds: +(\S+)", text, re.MULTILINE)
        return sum(float(took) for stage, took in stages if stage not in ("Output", "Total running"))

    mesh = f"{_word(options)}.1.ele"
    return Mesher(f"TetGen -{options}", "tetgen", lambda: shutil.which("tetgen") is not None, command, mesh, seconds)


def _gmsh(name: str, algorithm: str) -> Mesher:
    def command(_: Path) -> list[str]:
        options = ["-format", "msh2", "-nt", "1", "-v", "4"]
        return ["gmsh", "boundary.geo", "-3", "-algo", algorithm, "-o", f"{algorithm}.msh", *options]

    def seconds(text: str) -> float:
        stages = re.findall(r"Done (?:meshing 3D|optimizing mesh) \(Wall \S+, CPU (\S+)s\)", text)
        return sum(map(float, stages))

    return Mesher(name, "gmsh", lambda: shutil.which("gmsh") is not None, command, f"{algorithm}.msh", seconds)


def _netgen() -> Mesher:
    # The program `netgen` has a batch mode, but Debian's does not find its own libraries.
    return Mesher(
        "Netgen",
        "python3-netgen",
        lambda: find_spec("netgen") is not None,
        lambda _: [PYTHON, __file__, "netgen", "boundary.stl", "netgen.vol"],
        "netgen.vol",
        _told_seconds,
    )


def _delaunay() -> Mesher:
    command = [PYTHON, __file__, "delaunay", "surface.vtp", "delaunay.vtu"]
    return Mesher("vtkDelaunay3D", None, lambda: True, lambda _: command, "delaunay.vtu", _told_seconds)


def _ftetwild() -> Mesher:
    # It tells what it took by the clock; the shell knows its processor time.
    command = "FloatTetwild_bin -i boundary.stl -o ftetwild --max-threads 1; status=$?; times; exit $status"

    def seconds(text: str) -> float:
        spent = re.findall(r"(\d+)m([\d.]+)s", text.splitlines()[-1])
        return sum(60 * int(minutes) + float(rest) for minutes, rest in spent)

    def exists() -> bool:
        return shutil.which("FloatTetwild_bin") is not None

    return Mesher("fTetWild", None, exists, lambda _: ["sh", "-c", command], "ftetwild_.msh", seconds)


TREATMENTS = ("kept", "split", "remeshed")  # of the surface


def _refinement(treatment: str, settings: list[str]) -> Mesher:
    mesh = f"{treatment}.vtu"
    command = [PYTHON, __file__, "refine", "solid.vtu", mesh, f"SurfaceTreatment={treatment.upper()}", *settings]
    return Mesher(f"ours, {treatment}", None, lambda: True, lambda _: command, mesh, _told_seconds)


def _word(options: str) -> str:
    return "tetgen-" + re.sub(r"\W", "-", options)


def set_limits(seconds: float) -> None:
    """Limit memory and processor time of this process, which is to become a mesher."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 5))


def _trouble(status: int, text: str) -> str:
    """Why there is no mesh, in a few words."""
    words = re.compile(r"error|intersect|fail|overlap|wrong|out of memory|bad_alloc", re.IGNORECASE)
    lines = [line.strip() for line in text.splitlines() if words.search(line)]
    end = f"signal {-status}" if status < 0 else f"status {status}"
    return "; ".join([end, *lines[:1]]).replace("|", "/")[:80]


def read_mesh(mesh: Path) -> tuple[np.ndarray, np.ndarray]:
    """Points and tetrahedra of a mesher's file."""
    if mesh.suffix == ".vtu":
        return points_and_cells(read_grid(str(mesh)))
    import meshio

    with contextlib.redirect_stdout(io.StringIO()):  # it prints empty lines
        found = meshio.read(mesh)
    cells = [block.data for block in found.cells if block.type == "tetra"]
    return found.points, np.concatenate(cells) if cells else np.zeros((0, 4), int)


def _told_seconds(text: str) -> float:
    return float(re.findall(r"^SECONDS (\S+)", text, re.MULTILINE)[-1])


def _mesh_by_netgen(surface: str, mesh: str) -> None:
    from netgen.stl import LoadSTLGeometry

    geometry = LoadSTLGeometry(surface)
    began = time.process_time()
    made = geometry.GenerateMesh()
    seconds = time.process_time() - began
    made.Save(mesh)
    print(f"\nSECONDS {seconds}", flush=True)


def _mesh_by_delaunay(surface: str, mesh: str) -> None:
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(surface)
    reader.Update()
    began = time.process_time()
    delaunay, centres, enclosed = vtkDelaunay3D(), vtkCellCenters(), vtkSelectEnclosedPoints()
    delaunay.SetInputConnection(reader.GetOutputPort())
    centres.SetInputConnection(delaunay.GetOutputPort())
    enclosed.SetInputConnection(centres.GetOutputPort())
    enclosed.SetSurfaceConnection(reader.GetOutputPort())
    enclosed.Update()
    inside = enclosed.GetOutput().GetPointData().GetArray("SelectedPoints")
    delaunay.GetOutput().GetCellData().AddArray(inside)
    threshold = vtkThreshold()
    threshold.SetInputData(delaunay.GetOutput())
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "SelectedPoints")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(0.5)
    threshold.Update()
    seconds = time.process_time() - began
    insideout.write(threshold.GetOutput(), mesh)
    print(f"\nSECONDS {seconds}", flush=True)


def _refine(solid: str, mesh: str, *settings: str) -> None:
    refinement = insideout.vtkRefineTetrahedra()
    refinement.SetInputData(read_grid(solid))
    for setting in settings:
        name, value = setting.split("=", 1)
        constant = getattr(insideout.vtkRefineTetrahedra, value, None)
        getattr(refinement, "Set" + name)(float(value) if constant is None else constant)
    began = time.process_time()
    insideout.pipeline.run(refinement)
    seconds = time.process_time() - began
    insideout.write(refinement.GetOutput(), mesh)
    print(f"\nSECONDS {seconds}", flush=True)


if __name__ == "__main__":
    {"netgen": _mesh_by_netgen, "delaunay": _mesh_by_delaunay, "refine": _refine}[sys.argv[1]](*sys.argv[2:])
