# SPDX-License-Identifier: GPL-3.0-or-later
"""Run CalculiX (`ccx`, Debian's package calculix-ccx) on an .inp file, and put what it says onto the grid that was written.

    python3 calculix.py bracket.inp steel.frd steel.vtu

puts the displacements and stresses of `ccx steel` onto the cells of bracket.inp: ParaView opens steel.vtu, and its filter Warp By
Vector shows how it moves.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import insideout
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

NUMBER = 12  # characters of a number in .frd files, behind 13 with the point's number


class CalculiXError(RuntimeError):
    pass


def solve(job: str, folder: Path) -> None:
    """Solve job.inp of this text; the results are in job.frd and job.dat."""
    (folder / "job.inp").write_text(job)
    done = subprocess.run(["ccx", "job"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    (folder / "job.log").write_text(done.stdout)
    error = re.search(r"\*ERROR.*", done.stdout)
    if done.returncode != 0 or error:
        raise CalculiXError(f"ccx ended with status {done.returncode}: {error.group() if error else 'see job.log'}")


def point_results(folder: Path, name: str, points: int, frd: str = "job.frd") -> np.ndarray:
    """What a file of results has for all points under this name (DISP, STRESS), of the last step."""
    values: dict[int, list[float]] = {}
    wanted = False
    with (folder / frd).open() as file:
        for line in file:
            if line.startswith(" -4"):
                wanted = line[5:13].strip() == name
                values = {} if wanted else values
            elif wanted and line.startswith(" -1"):
                numbers = line.rstrip("\n")[13:]
                values[int(line[3:13])] = [float(numbers[k : k + NUMBER]) for k in range(0, len(numbers), NUMBER)]
    if len(values) != points:
        raise CalculiXError(f"{frd} has {name} of {len(values)} points, and the grid has {points}")
    return np.array([values[point] for point in range(1, points + 1)])


def total_force(folder: Path) -> np.ndarray:
    """What `*NODE PRINT, TOTALS=ONLY` wrote of RF into job.dat, of the last step."""
    lines = (folder / "job.dat").read_text().splitlines()
    at = max(k for k, line in enumerate(lines) if "total force" in line)
    return np.array([float(number) for number in next(line for line in lines[at + 1 :] if line.strip()).split()])


def total_heat(folder: Path) -> float:
    """What `*NODE PRINT, TOTALS=ONLY` wrote of RFL into job.dat, of the last step: positive where heat comes in."""
    lines = (folder / "job.dat").read_text().splitlines()
    at = max(k for k, line in enumerate(lines) if "total heat generation" in line)
    return float(next(line for line in lines[at + 1 :] if line.strip()).split()[0])


def printed_displacements(folder: Path) -> np.ndarray:
    """What `*NODE PRINT` wrote of U into job.dat, with one digit more than job.frd has: a row for each point of its set."""
    rows = [line.split() for line in (folder / "job.dat").read_text().splitlines() if re.match(r" +\d+ ", line)]
    return np.array([[float(number) for number in row[1:4]] for row in rows])


def with_results(grid: vtkUnstructuredGrid, folder: Path, frd: str = "job.frd") -> vtkUnstructuredGrid:
    """The grid with Displacement, Stress (xx, yy, zz, xy, yz, xz) and MisesStress at its points."""
    displacement = point_results(folder, "DISP", grid.GetNumberOfPoints(), frd)[:, :3]
    stress = point_results(folder, "STRESS", grid.GetNumberOfPoints(), frd)
    solved = vtkUnstructuredGrid()
    solved.ShallowCopy(grid)
    for name, values in (("Displacement", displacement), ("Stress", stress), ("MisesStress", mises(stress))):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        solved.GetPointData().AddArray(array)
    return solved


def mises(stress: np.ndarray) -> np.ndarray:
    xx, yy, zz, xy, yz, xz = stress.T
    return np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + xz**2))


def main(solid: Path, frd: Path, output: Path) -> None:
    solved = with_results(insideout.read(solid), frd.parent, frd.name)
    insideout.write(solved, output)
    arrays = solved.GetPointData()
    moved, stress = (vtk_to_numpy(arrays.GetArray(name)) for name in ("Displacement", "MisesStress"))
    print(f"moves by {np.linalg.norm(moved, axis=1).max():.3g} at most; von Mises stress up to {stress.max():.3g}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(*(Path(argument) for argument in sys.argv[1:]))
    except (insideout.Error, CalculiXError, OSError) as error:
        sys.exit(f"calculix.py: {error}")
