# SPDX-License-Identifier: GPL-3.0-or-later
"""Boundary layers of surfaces, by us, by gmsh and by Netgen: inverted cells, share of the wall at full height, seconds.

    measure-layers.py [--edges SHARE] [--limit SECONDS] [--keep FOLDER] SURFACE...

Each surface is remeshed to edges of a share of its diagonal, 4 % by default. All of its boundary gets three layers,
the first 0.2 % of the diagonal high, each 1.2 times as high as the one before; their seconds are counted. The others
get the boundary of our solid, which is watertight, and the same heights; the seconds of all cells are counted. Gmsh
extrudes the boundary inward (extrudeBoundaryLayer) and fills the rest; Netgen fills it and has BoundaryLayer;
insideout-kept is our work on the same triangles. A run that is not over after the limit, 120 s by the clock, is
stopped. vtkSolidQuality judges the cells, exactly. Prints a row per surface and program and, for machines, ratio lines
as Measure.h does: layers/inverted, of ours; layers/full, the median share; and layers/seconds, those of insideout-kept
over Netgen's, where both made cells. --keep keeps our solids as .vtu.

Netgen 6.2.1905, Debian's, reads a segment behind the last one: a mesh without segments ends it. So sharp edges, or one
edge where none is sharp, are segments, as in meshes of its own geometries; its layers end there.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Iterator

LAYERS, FIRST, GROWTH = 3, 0.002, 1.2
LEAST_FULL = 0.9
PROGRAMS = ("insideout", "insideout-kept", "gmsh", "netgen")
SHARP = 30.0
"""Degrees between triangles, from which on an edge is sharp for Netgen."""


def by_insideout(surface: str, folder: Path, edges: str) -> dict[str, Any]:
    import insideout

    began = time.process_time()
    made = insideout.tetrahedralize(surface, edge_length=edges, surface_treatment="remeshed")
    points = made.boundary.points
    height = FIRST * float(((points.max(axis=0) - points.min(axis=0)) ** 2).sum() ** 0.5)
    insideout.write(made.boundary, str(folder / "boundary.stl"))
    (folder / "height").write_text(repr(height), encoding="ascii")
    layers = insideout.vtkBoundaryLayers()
    layers.SetInputData(made.solid)
    layers.SetBoundaryData(made.boundary)
    layers.SetLayers(LAYERS)
    layers.SetFirstHeight(height)
    layers.SetGrowth(GROWTH)
    between = time.process_time()
    insideout.pipeline.run(layers)
    ended = time.process_time()
    insideout.write(layers.GetOutput(), str(folder / "insideout.vtu"))
    told = insideout.pipeline.statistics_of(layers.GetOutput())
    return {**judged(layers.GetOutput()), **shares_of(told), "meshing": between - began, "seconds": ended - between}


def shares_of(told: dict[str, float]) -> dict[str, float]:
    narrow = told["NarrowPoints"] / told["WallPoints"]
    return {"full": told["FullHeightShare"], "mean": told["MeanHeightShare"], "narrow": narrow}


def by_insideout_kept(_: str, folder: Path, __: str) -> dict[str, Any]:
    import insideout

    boundary = insideout.read(str(folder / "boundary.stl"))
    began = time.process_time()
    wanted = {"layers": LAYERS, "first_height": heights(folder)[0], "growth": GROWTH}
    made = insideout.tetrahedralize(boundary, surface_treatment="kept", **wanted)
    seconds = time.process_time() - began
    return {**judged(made.solid), **shares_of(made.statistics), "seconds": seconds}


def judged(grid: Any) -> dict[str, Any]:
    """What vtkSolidQuality finds."""
    import insideout

    found = insideout.check_solid(grid).statistics
    return {
        "cells": int(found["Cells"]),
        "prisms": int(found.get("Prisms", 0)),
        "inverted": int(found["NegativeCells"] + found["FlatCells"]),
        "conforms": bool(found["Conforms"]),
        "angle": found["DihedralAngle1Percent"],
    }


def grid_of(points: Any, cells: dict[int, Any]) -> Any:
    """A grid of cells by VTK's types."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(places)
    for kind, corners in cells.items():
        for cell in corners:
            grid.InsertNextCell(kind, len(cell), [int(c) for c in cell])
    return grid


def heights(folder: Path) -> list[float]:
    first = float((folder / "height").read_text(encoding="ascii"))
    return [first * GROWTH**k for k in range(LAYERS)]


def by_gmsh(_: str, folder: Path, __: str) -> dict[str, Any]:
    import gmsh
    import numpy as np

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.merge(str(folder / "boundary.stl"))
    began = time.process_time()
    model = gmsh.model
    model.mesh.classifySurfaces(np.pi, True, False, np.pi)
    model.mesh.createTopology()  # which keeps the triangles; createGeometry would make others
    sums = np.cumsum(heights(folder))
    gmsh.option.setNumber("Geometry.ExtrudeReturnLateralEntities", 0)
    made = model.geo.extrudeBoundaryLayer(model.getEntities(2), [1] * LAYERS, list(-sums), True)
    model.geo.synchronize()
    model.geo.addVolume([model.geo.addSurfaceLoop([tag for dimension, tag in made if dimension == 2])])
    model.geo.synchronize()
    model.mesh.generate(3)
    seconds = time.process_time() - began
    ids, coordinates, _ = model.mesh.getNodes()
    number = np.zeros(int(ids.max()) + 1, dtype=np.int64)
    number[ids.astype(np.int64)] = np.arange(len(ids))
    cells = {}
    orders = {4: (10, (0, 1, 2, 3)), 6: (13, (3, 4, 5, 0, 1, 2)), 7: (14, (0, 1, 2, 3, 4))}
    for kind, (vtk_kind, order) in orders.items():
        nodes = model.mesh.getElementsByType(kind)[1]
        cells[vtk_kind] = number[nodes.astype(np.int64)].reshape(-1, len(order))[:, order]
    if not len(cells[10]):
        raise RuntimeError("no tetrahedra behind the layers")
    return {**judged(grid_of(coordinates.reshape(-1, 3), cells)), "seconds": seconds}


def sharp_edges(places: Any, triangles: Any) -> list[tuple[int, int]]:
    """The edges at which triangles meet at an angle; the first edge where there are none."""
    import numpy as np

    a, b, c = (places[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    at: dict[tuple[int, int], list[int]] = {}
    for t, corners in enumerate(triangles.tolist()):
        for k in range(3):
            low, high = sorted((corners[k], corners[(k + 1) % 3]))
            at.setdefault((low, high), []).append(t)
    least = np.cos(np.radians(SHARP))
    sharp = [edge for edge, around in at.items() if len(around) != 2 or normals[around[0]] @ normals[around[1]] < least]
    return sharp or list(at)[:1]


def by_netgen(_: str, folder: Path, __: str) -> dict[str, Any]:
    import insideout
    import numpy as np
    from netgen.meshing import Element1D, Element2D, FaceDescriptor, Mesh, MeshPoint, Pnt

    boundary = insideout.read(str(folder / "boundary.stl"))
    places, corners = np.unique(boundary.points, axis=0, return_inverse=True)
    triangles = corners.reshape(-1)[boundary.triangles]
    began = time.process_time()
    mesh = Mesh()
    mesh.dim = 3
    ids = [mesh.Add(MeshPoint(Pnt(*map(float, place)))) for place in places]
    wall = mesh.Add(FaceDescriptor(surfnr=1, domin=1, domout=0, bc=1))
    for triangle in triangles:
        mesh.Add(Element2D(wall, [ids[k] for k in triangle]))
    for edge in sharp_edges(places, triangles):
        mesh.Add(Element1D([ids[k] for k in edge], [1, 1], index=1))
    mesh.GenerateVolumeMesh()
    mesh.BoundaryLayer(1, heights(folder), 1, ["layer"] * LAYERS)
    seconds = time.process_time() - began
    points = np.array([tuple(p.p) for p in mesh.Points()])
    cells: dict[int, list[list[int]]] = {10: [], 13: [], 14: []}
    orders = {4: (10, [1, 0, 2, 3]), 5: (14, [3, 2, 1, 0, 4]), 6: (13, [0, 1, 2, 3, 4, 5])}
    for element in mesh.Elements3D():
        ids = [v.nr - 1 for v in element.vertices]
        kind, turned = orders[len(ids)]
        cells[kind].append([ids[k] for k in turned])
    return {**judged(grid_of(points, cells)), "seconds": seconds}


def run(program: str, surface: Path, folder: Path, limit: float, edges: str) -> dict[str, Any]:
    """What a program makes, in a process of its own; or why it makes nothing."""
    asked = ("--one", program, "--folder", str(folder), "--edges", edges)
    command = [sys.executable, str(Path(__file__).resolve()), *asked, str(surface)]
    try:
        # Netgen writes a log where it is called.
        ran = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False, cwd=folder)
    except subprocess.TimeoutExpired:
        return {"refused": f"not over after {limit:g} s"}
    lines = [line for line in ran.stdout.splitlines() if line.startswith("MADE ")]
    if lines:
        return dict(json.loads(lines[-1][5:]))
    last = (ran.stderr.strip().splitlines() or ["no word"])[-1]
    return {"refused": f"signal {-ran.returncode}" if ran.returncode < 0 else last[:90]}


def row(name: str, program: str, made: dict[str, Any]) -> str:
    if "refused" in made:
        return f"{name:24} {program:10} {made['refused']}"
    share = f"full {made['full']:.3f} mean {made['mean']:.3f} narrow {made['narrow']:.3f}" if "full" in made else ""
    conforms = "conforms" if made["conforms"] else "does not conform"
    counts = f"{made['cells']:8} cells {made['prisms']:7} prisms {made['inverted']:5} inverted"
    return f"{name:24} {program:10} {counts}, {conforms:16} {made['seconds']:7.2f} s {share}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--edges", default="4%")
    parser.add_argument("--limit", type=float, default=120)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--one", choices=PROGRAMS, help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("surfaces", nargs="+", type=Path)
    arguments = parser.parse_args()
    if arguments.one:
        by = dict(zip(PROGRAMS, (by_insideout, by_insideout_kept, by_gmsh, by_netgen)))[arguments.one]
        made = by(str(arguments.surfaces[0]), arguments.folder, arguments.edges)
        print("MADE " + json.dumps(made), flush=True)
        os._exit(0)  # modules of others end with signals
    all_made: dict[str, list[dict[str, Any]]] = {program: [] for program in PROGRAMS}
    for surface in arguments.surfaces:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for program in PROGRAMS:
                made = {"refused": "without a boundary"}
                if program == "insideout" or (folder / "height").exists():
                    made = run(program, surface.resolve(), folder, arguments.limit, arguments.edges)
                all_made[program].append(made)
                print(row(surface.stem, program, made), flush=True)
            if arguments.keep:
                with contextlib.suppress(FileNotFoundError):
                    (folder / "insideout.vtu").rename(arguments.keep / f"{surface.stem}.vtu")
    for line in summary(all_made):
        print(line)


def summary(all_made: dict[str, list[dict[str, Any]]]) -> Iterator[str]:
    for program, results in all_made.items():
        whole = [made for made in results if "refused" not in made]
        seconds = sorted(made["seconds"] for made in whole)
        bad = sum(made["inverted"] > 0 or not made["conforms"] for made in whole)
        yield f"{program}: {len(whole)} of {len(results)} made, {bad} with inverted cells or overlaps"
        if seconds:
            yield f"  seconds in the median {seconds[len(seconds) // 2]:.2f}, in all {sum(seconds):.1f}"
    ours = [made for made in all_made["insideout"] if "refused" not in made]
    if ours:
        shares = sorted(made["full"] for made in ours)
        yield f"ratio layers/inverted {sum(made['inverted'] for made in ours)} at most 0"
        yield f"ratio layers/full {shares[len(shares) // 2]:.3f} at least {LEAST_FULL}"
    pairs = list(zip(all_made["insideout-kept"], all_made["netgen"]))
    both = [pair for pair in pairs if not any("refused" in made for made in pair)]
    if both:
        own, other = (sum(pair[k]["seconds"] for pair in both) for k in (0, 1))
        yield f"ratio layers/seconds {own / other:.3f} at most 1"


if __name__ == "__main__":
    main()
