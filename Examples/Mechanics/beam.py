# SPDX-License-Identifier: GPL-3.0-or-later
"""The beam of cantilever.py in FEniCS (Debian: python3-dolfinx-real), by .xdmf files with tags by geometry.

    python3 beam.py FOLDER [EDGE_LENGTH]

Prints how far the tip goes down, and that divided by what Timoshenko's theory says. Poisson's ratio is 0: the theory's fixed
end has no stresses sideways then. Elements are of second order.
"""

from __future__ import annotations

import sys
from pathlib import Path

import insideout
import numpy as np
from cantilever import ENDS, LENGTH, PRESSURE, STIFFNESS
from shapes import box, write_obj

try:
    import ufl
    from dolfinx import fem, io
    from dolfinx.fem.petsc import LinearProblem
    from mpi4py import MPI
except ImportError as missing:
    sys.exit(f"beam.py: {missing}: apt-get install python3-dolfinx-real")

RULES = {"clamp": "normal -1 0 0", "top": "normal 0 0 1", "tip": "normal 1 0 0"}


def write_mesh(edge: float, folder: Path) -> dict[str, int]:
    """Write the cells and the boundary; return the numbers of tags by their names."""
    parts = [part for low, high in ENDS for part in box((low, 0, 0), (high, 1, 1), edge)]
    write_obj(parts, folder / "beam.obj")
    output = folder / "beam.xdmf"
    result = insideout.tetrahedralize(folder / "beam.obj", edge_length=edge, tag_rules=RULES, output=output)
    return {name: number for number, name in enumerate(result.tags)}


def tip_deflection(folder: Path, numbers: dict[str, int]) -> float:
    """The mean over the end."""
    text = io.XDMFFile.Encoding.ASCII
    with io.XDMFFile(MPI.COMM_WORLD, str(folder / "beam.xdmf"), "r", text) as file:
        mesh = file.read_mesh(name="Grid")
    mesh.topology.create_connectivity(2, 3)
    with io.XDMFFile(MPI.COMM_WORLD, str(folder / "beam_boundary.xdmf"), "r", text) as file:
        tags = file.read_meshtags(mesh, name="Grid")
    space = fem.VectorFunctionSpace(mesh, ("CG", 2))
    clamped = fem.locate_dofs_topological(space, 2, tags.find(numbers["clamp"]))
    support = fem.dirichletbc(np.zeros(3), clamped, space)
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    on_tags = ufl.Measure("ds", domain=mesh, subdomain_data=tags)
    work = STIFFNESS * ufl.inner(ufl.sym(ufl.grad(u)), ufl.sym(ufl.grad(v))) * ufl.dx
    load = ufl.dot(fem.Constant(mesh, (0.0, 0.0, -PRESSURE)), v) * on_tags(numbers["top"])
    moved = LinearProblem(work, load, bcs=[support], petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
    return -fem.assemble_scalar(fem.form(moved[2] * on_tags(numbers["tip"])))  # the end's area is 1


def main(folder: Path, edge: float) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    found = tip_deflection(folder, write_mesh(edge, folder))
    theory = PRESSURE * LENGTH**4 / (8 * STIFFNESS / 12) + PRESSURE * LENGTH**2 / (2 * 10 / 12 * STIFFNESS / 2)
    print(f"The tip goes down {found:.6g}, {found / theory:.5f} of theory.")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.4)
