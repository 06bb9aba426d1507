# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for solvers are read: our own as they were written, and those of gmsh and meshio."""

import subprocess
import unittest
import warnings
from pathlib import Path

import insideout
import meshio
import numpy as np
import surfaces
from command import CommandLine, read_grid, run_here
from insideout.data import Tetrahedra, Triangles, TriangleSurface, as_type
from insideout.exporting import EDGES
from insideout.files import READABLE_SOLIDS, read_solid
from insideout.pipeline import strings_of
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TRIANGLE

SOLVERS = (("solid.msh", "4.1"), ("solid.msh", "2.2"), ("solid.inp", "4.1"), ("solid.mesh", "4.1"))

BOXES = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
Coherence;
Mesh.MeshSizeMax = 0.5;
"""
GROUPS = """
Physical Volume("left", 10) = {1};
Physical Volume("right part", 20) = {2};
Physical Volume("both", 30) = {1, 2};
Physical Surface("inlet", 5) = {1};
"""
SQUARE = 'Rectangle(1) = {0, 0, 0, 1, 1};\nPhysical Surface("plate") = {1};\n'


def reader_of(path: str) -> insideout.vtkSolidReader:
    reader = insideout.vtkSolidReader()
    reader.SetFileName(path)
    insideout.pipeline.run(reader)
    return reader


def names(data, array: str) -> list:
    return strings_of(data.GetFieldData().GetAbstractArray(array))


def faces_with_tags(boundary) -> list:
    """Places of the corners from the lowest on, and the tag, of each triangle."""
    tags = surfaces.cell_array(boundary, "BoundaryTag")
    corners = boundary.points[boundary.triangles]
    turned = [min(np.roll(face, k, axis=0).tolist() for k in range(3)) for face in corners]
    return sorted(zip(turned, tags.tolist()))


class Solids(CommandLine):
    def gmsh(self, geometry: str, name: str, *options: str) -> str:
        """A file that gmsh writes."""
        script = self.file("shape.geo", 'SetFactory("OpenCASCADE");\n' + geometry)
        dimension = "-2" if geometry is SQUARE else "-3"
        subprocess.run(["gmsh", dimension, *options, "-o", self.path(name), script], check=True, capture_output=True)
        return self.path(name)

    def check_solid(self, grid: Tetrahedra, size: float = 2.0):
        """It is whole, and midpoints are where they belong."""
        found = insideout.check_solid(grid)
        self.assertTrue(found.statistics["Conforms"], found.verdict)
        self.assertIn("all positive", found.verdict)
        self.assertAlmostEqual(grid.volume, size, 10)
        if grid.cells.shape[1] == 10:
            middles = grid.points[grid.cells[:, np.array(EDGES)]].mean(axis=2)
            np.testing.assert_allclose(grid.points[grid.cells[:, 4:]], middles, atol=1e-12)


class OurOwn(Solids):
    @classmethod
    def setUpClass(cls):
        box, other = surfaces.box(), surfaces.box((0.3, 0.2, 0.1))
        cls.bodies = insideout.tetrahedralize({"bone": box, "soft tissue": other}, edge_length=0.4)
        quadratic = insideout.tetrahedralize({"bone": box, "soft tissue": other}, edge_length=0.4, quadratic_cells=True)
        cls.results = {"linear": cls.bodies, "quadratic": quadratic}

    def test_written_solids_come_back(self):
        for kind, result in self.results.items():
            for name, version in SOLVERS:
                with self.subTest(kind=kind, name=name, version=version):
                    insideout.write(result, self.path(name), msh_version=version)
                    reader = reader_of(self.path(name))
                    grid = as_type(Tetrahedra, reader.GetOutput())
                    boundary = as_type(TriangleSurface, reader.GetBoundary())
                    self.assertEqual(grid.points.tobytes(), result.solid.points.tobytes())
                    self.assertEqual(grid.cells.tolist(), result.solid.cells.tolist())
                    self.assertEqual(grid.cell_arrays["RegionId"].tolist(), result.solid.cell_arrays["RegionId"].tolist())
                    self.assertEqual(names(grid, "RegionNames"), ["bone", "soft tissue"])
                    self.assertEqual(faces_with_tags(boundary), faces_with_tags(result.boundary))
                    self.assertEqual(names(boundary, "BoundaryTagNames"), names(result.boundary, "BoundaryTagNames"))

    def test_and_is_written_again_byte_by_byte(self):
        for name, version in SOLVERS:
            with self.subTest(name=name, version=version):
                insideout.write(self.bodies, self.path(name), msh_version=version)
                reader = reader_of(self.path(name))
                insideout.write(reader.GetOutput(), self.path("again-" + name), boundary=reader.GetBoundary(), msh_version=version)
                first, again = (Path(self.path(prefix + name)).read_bytes() for prefix in ("", "again-"))
                self.assertEqual(again, first)

    def test_cells_outside_are_region_minus_one(self):
        hull = insideout.tetrahedralize(surfaces.two_boxes()).hull
        for name, version in SOLVERS:
            with self.subTest(name=name, version=version):
                insideout.write(hull, self.path(name), msh_version=version)
                grid = insideout.read(self.path(name))
                self.assertEqual(grid.cell_arrays["RegionId"].tolist(), hull.cell_arrays["RegionId"].tolist())
                self.assertEqual(names(grid, "RegionNames"), ["solid"])


class OfOthers(Solids):
    def test_gmsh_writes_groups(self):
        for name, version in (("a.msh", "msh41"), ("a.msh", "msh22"), ("a.inp", "inp"), ("a.mesh", "mesh")):
            for order in ("1", "2"):
                with self.subTest(version=version, order=order):
                    path = self.gmsh(BOXES + GROUPS, name, "-format", version, "-order", order)
                    grid = insideout.read(path)
                    self.check_solid(grid)
                    self.assertEqual(grid.cells.shape[1], 4 if order == "1" else 10)
                    corners = grid.points[grid.cells[:, :4]].mean(axis=1)
                    left, right = (np.unique(grid.cell_arrays["RegionId"][side]) for side in (corners[:, 0] < 1, corners[:, 0] > 1))
                    boundary = reader_of(path).GetBoundary()
                    if version.startswith("msh"):
                        self.assertEqual((left.tolist(), right.tolist()), ([9], [19]))
                        self.assertEqual(names(grid, "RegionNames")[9::10], ["left", "right part"])
                        self.assertEqual(names(boundary, "BoundaryTagNames")[4], "inlet")
                    else:
                        self.assertEqual((len(left), len(right)), (1, 1))
                        self.assertNotEqual(left, right)
                    self.assertTrue(np.allclose(as_type(TriangleSurface, boundary).points[:, 0], 0))

    def test_gmsh_writes_entities(self):
        for version in ("msh41", "msh22"):
            with self.subTest(version):
                grid = insideout.read(self.gmsh(BOXES, "a.msh", "-format", version))
                self.check_solid(grid)
                self.assertEqual(np.unique(grid.cell_arrays["RegionId"]).tolist(), [0, 1])

    def test_gmsh_writes_triangles_in_a_plane(self):
        for name in ("a.msh", "a.inp", "a.mesh"):
            with self.subTest(name):
                plate = insideout.read(self.gmsh(SQUARE, name))
                self.assertIsInstance(plate, Triangles)
                self.assertAlmostEqual(plate.volume, 1, 10)
                quadratic, _ = read_solid(self.gmsh(SQUARE, name, "-order", "2"))
                self.assertEqual(quadratic.GetCellType(0), VTK_QUADRATIC_TRIANGLE)

    def test_other_formats_of_gmsh_are_refused(self):
        for options, words in ((("-bin",), "line 2: is binary"), (("-format", "msh40"), "line 2: is of version '4'")):
            with self.subTest(options), self.assertRaisesRegex(insideout.Error, f"{self.folder}/a.msh, {words}"):
                insideout.read(self.gmsh(BOXES, "a.msh", *options))

    def test_meshio_writes_the_same(self):
        solid = insideout.tetrahedralize(surfaces.two_boxes(), edge_length=0.5).solid
        quadratic = insideout.tetrahedralize(surfaces.two_boxes(), edge_length=0.5, quadratic_cells=True).solid
        for name, kind, grid in (
            ("a.msh", "gmsh", solid),
            ("a.msh", "gmsh22", solid),
            ("a.msh", "gmsh", quadratic),
            ("a.inp", "abaqus", solid),
            ("a.inp", "abaqus", quadratic),
            ("a.mesh", "medit", solid),
        ):
            with self.subTest(name=name, kind=kind):
                mesh = meshio.Mesh(grid.points, [(grid.kind(), grid.cells)])
                mesh.write(self.path(name), file_format=kind, **({"binary": False} if "gmsh" in kind else {}))
                found = insideout.read(self.path(name))
                np.testing.assert_allclose(found.points, grid.points, rtol=1e-15)
                self.assertEqual(found.cells.tolist(), grid.cells.tolist())

    def test_other_cells_are_counted(self):
        points = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
        blocks = [("hexahedron", [[0, 4, 6, 2, 1, 5, 7, 3]]), ("tetra", [[0, 4, 2, 1]])]
        for name in ("a.inp", "a.mesh"):
            with self.subTest(name):
                meshio.Mesh(points, blocks).write(self.path(name))
                with self.assertWarnsRegex(insideout.Warning, "left out: 1 "):
                    grid = insideout.read(self.path(name))
                self.assertEqual(grid.GetNumberOfCells(), 1)


class Commands(Solids):
    def setUp(self):
        super().setUp()
        self.solid = insideout.tetrahedralize(surfaces.two_boxes()).solid
        self.cells = f"{self.solid.GetNumberOfCells():,} tetrahedra"

    def written(self, kind: str) -> str:
        insideout.write(self.solid, self.path("given" + kind))
        return self.path("given" + kind)

    def test_check_and_refine_take_each_format(self):
        for kind in READABLE_SOLIDS:
            with self.subTest(kind):
                done = run_here("check", self.written(kind))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(self.cells, done.stdout)
                done = run_here("refine", self.written(kind), self.output, "--edge-length", "0.4", "--quiet")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertGreater(read_grid(self.output).GetNumberOfCells(), self.solid.GetNumberOfCells())

    def test_a_forgotten_output_destroys_no_file_of_others(self):
        given = self.written(".vtu")
        for kind in (".msh", ".inp", ".mesh"):
            with self.subTest(kind):
                other = self.gmsh(BOXES, "other" + kind)
                self.check_failure(run_here("refine", given, other, "--quiet"), f"{other} was not written by insideout")
                self.assertEqual(run_here("refine", given, self.written(kind), "--quiet").returncode, 0)

    def test_functions_take_each_format(self):
        for kind in READABLE_SOLIDS:
            with self.subTest(kind):
                path = self.written(kind)
                self.assertIn(self.cells, insideout.check_solid(path).verdict)
                self.assertGreater(insideout.refine(path, edge_length=0.4).solid.GetNumberOfCells(), self.solid.GetNumberOfCells())

    def test_the_line_at_fault_is_named(self):
        path = self.written(".mesh")
        lines = Path(path).read_text(encoding="utf-8").splitlines()
        lines[-2] = "1 2 3 99 1"
        self.file("given.mesh", "\n".join(lines))
        number = self.solid.GetNumberOfCells()
        words = f"{path}, line {len(lines) - 1}: tetrahedron {number} refers to point 99 of {self.solid.GetNumberOfPoints()}"
        self.check_failure(run_here("check", path, "--quiet"), words)


class Reading(Solids):
    def test_a_file_holds_a_surface_or_a_solid(self):
        surface = insideout.read(self.file("a.ply", surfaces.box()))
        self.assertIsInstance(surface, TriangleSurface)
        self.assertEqual(surface.volume, 1)
        curve = insideout.read(self.file("a.csv", "0,0\n1,0\n0,1\n"))
        self.assertIsInstance(curve, insideout.Polylines)
        solid = insideout.tetrahedralize(surfaces.box()).solid
        insideout.write(solid, self.path("a.vtu"))
        self.assertIsInstance(insideout.read(self.path("a.vtu")), Tetrahedra)
        self.assertEqual(insideout.read(self.path("a.vtu")).volume, 1)

    def test_any_other_ending_is_named(self):
        with self.assertRaisesRegex(insideout.Error, "a.docx: unknown ending, it must be .ply .* .vtu .msh .inp .mesh"):
            insideout.read(self.file("a.docx", "x"))

    def test_nothing_is_warned_of_in_what_we_write(self):
        solid = insideout.tetrahedralize(surfaces.box()).solid
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for kind in READABLE_SOLIDS:
                insideout.write(solid, self.path("a" + kind))
                insideout.read(self.path("a" + kind))

    def test_a_reader_without_a_name_says_so(self):
        with self.assertRaisesRegex(insideout.Error, "no file name is set"):
            insideout.pipeline.run(insideout.vtkSolidReader())

    def test_invalid_files_leave_the_outputs_empty(self):
        reader = insideout.vtkSolidReader()
        reader.SetFileName(self.file("a.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 2000000000 1 2\n"))
        with self.assertRaisesRegex(insideout.Error, "line 5: 2000000000 points announced"):
            insideout.pipeline.run(reader)
        self.assertEqual((reader.GetOutput().GetNumberOfPoints(), reader.GetBoundary().GetNumberOfPoints()), (0, 0))


if __name__ == "__main__":
    unittest.main()
