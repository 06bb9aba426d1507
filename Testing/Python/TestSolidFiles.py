# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for solvers, read by the programs that they are for: gmsh, meshio and CalculiX itself."""

import os
import re
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

import gmsh
import insideout
import meshio
import numpy as np
import surfaces
from insideout.data import Tetrahedra, as_type
from insideout.exporting import EDGES
from insideout.solid_files import write_solid
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.util.numpy_support import numpy_to_vtk

LENGTH = 1.5
SIDES = ("clamped end", "loaded end", "y low", "y high", "z low", "z high")


def beam() -> insideout.Tetrahedralization:
    """Two cubes that overlap in half of each, and make a beam; each of its sides has a tag."""
    second = [tuple(corner + 8 for corner in facet) for facet in surfaces.BOX_FACETS]
    points = surfaces.box_points() + surfaces.box_points((0.5, 0, 0))
    result = insideout.tetrahedralize(surfaces.polydata(points, [*surfaces.BOX_FACETS, *second]))
    corners = result.boundary.points[result.boundary.triangles]
    tags = np.full(len(corners), -1)
    for tag, (axis, place) in enumerate(((0, 0), (0, LENGTH), (1, 0), (1, 1), (2, 0), (2, 1))):
        tags[(corners[:, :, axis] == place).all(axis=1)] = tag
    add_tags(result.boundary, tags, SIDES)
    return result


def add_tags(boundary: vtkPolyData, tags, names) -> None:
    surfaces.add_array(boundary.GetCellData(), "BoundaryTag", np.asarray(tags, np.int32))
    array = vtkStringArray()
    array.SetName("BoundaryTagNames")
    for name in names:
        array.InsertNextValue(name)
    boundary.GetFieldData().AddArray(array)


def quadratic(grid: vtkUnstructuredGrid) -> Tetrahedra:
    """The same cells with a point in the middle of each edge."""
    points, cells = surfaces.points_of(grid), surfaces.tetrahedra_of(grid)
    ends = np.sort(cells[:, np.array(EDGES)].reshape(-1, 2), axis=1)
    edges, number = np.unique(ends, axis=0, return_inverse=True)
    made = vtkUnstructuredGrid()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    coordinates.SetData(numpy_to_vtk(np.vstack([points, points[edges].mean(axis=1)]), deep=True))
    made.SetPoints(coordinates)
    for cell, middles in zip(cells, number.reshape(-1, 6) + len(points)):
        made.InsertNextCell(VTK_QUADRATIC_TETRA, 10, [*cell, *middles])
    for index in range(grid.GetCellData().GetNumberOfArrays()):
        made.GetCellData().AddArray(grid.GetCellData().GetArray(index))
    return as_type(Tetrahedra, made)


def with_wall(result: insideout.Tetrahedralization) -> tuple[vtkUnstructuredGrid, vtkPolyData]:
    """The solid in two regions with a wall between them, which is the last tag and faces out of the first."""
    solid, boundary = vtkUnstructuredGrid(), vtkPolyData()
    solid.ShallowCopy(result.solid)
    centres = result.solid.points[result.solid.cells].mean(axis=1)
    regions = (centres[:, 0] > LENGTH / 2).astype(np.int32)
    surfaces.add_array(solid.GetCellData(), "RegionId", regions)
    faces, number = surfaces.faces_of(result.solid)
    order = np.argsort(number, kind="stable")
    pairs = [{a, b} for a, b in zip(order, order[1:]) if number[a] == number[b] and regions[a // 4] != regions[b // 4]]
    wall = [faces[face] for pair in pairs for face in pair if regions[face // 4] == 0]
    points = np.vstack([result.boundary.points, result.solid.points])
    triangles = np.vstack([result.boundary.triangles, np.array(wall) + len(result.boundary.points)])
    boundary.ShallowCopy(surfaces.polydata(points.tolist(), triangles.tolist()))
    tags = [*surfaces.cell_array(result.boundary, "BoundaryTag"), *[len(SIDES)] * len(wall)]
    add_tags(boundary, tags, (*SIDES, "wall"))
    return solid, boundary


class InAFolder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = beam()
        cls.solid, cls.boundary = with_wall(cls.result)
        cls.counts = {(3, f"region_{region}"): int((surfaces.cell_array(cls.solid, "RegionId") == region).sum()) for region in (0, 1)}
        tags = surfaces.cell_array(cls.boundary, "BoundaryTag")
        cls.counts.update(((2, name), int((tags == tag).sum())) for tag, name in enumerate((*SIDES, "wall")))
        cls.grids = {"linear": cls.solid, "quadratic": quadratic(cls.solid)}

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name: str) -> str:
        return os.path.join(self.folder, name)

    def written(self, name: str, grid, **options) -> str:
        write_solid(grid, self.path(name), self.boundary, **options)
        return self.path(name)

    def test_the_sample_is_what_it_is_meant_to_be(self):
        self.assertEqual(sum(self.counts.values()), self.solid.GetNumberOfCells() + self.boundary.GetNumberOfCells())
        self.assertGreater(min(self.counts.values()), 0)


class Gmsh(InAFolder):
    def setUp(self):
        super().setUp()
        gmsh.initialize()
        self.addCleanup(gmsh.finalize)
        gmsh.option.setNumber("General.Verbosity", 1)

    def groups(self) -> dict:
        """How many elements each physical group has, by dimension and name."""
        found = {}
        for dimension, tag in gmsh.model.getPhysicalGroups():
            entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
            elements = [len(tags) for entity in entities for tags in gmsh.model.mesh.getElements(dimension, entity)[1]]
            found[dimension, gmsh.model.getPhysicalName(dimension, tag)] = sum(elements)
        return found

    def check_points(self, grid):
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        self.assertEqual(len(tags), grid.GetNumberOfPoints())
        found = np.empty((len(tags), 3))
        found[tags.astype(int) - 1] = coordinates.reshape(-1, 3)
        self.assertEqual(found.tobytes(), surfaces.points_of(grid).tobytes())

    def check_order(self):
        """Each point of an element is where gmsh takes it to be, seen from the corners."""
        places = dict(zip(*(values.tolist() for values in self.points_by_tag())))
        for dimension, corners in ((2, 3), (3, 4)):
            for kind, _, nodes in zip(*gmsh.model.mesh.getElements(dimension)):
                _, _, _, count, local, primary = gmsh.model.mesh.getElementProperties(kind)
                self.assertEqual(primary, corners)
                local = local.reshape(count, dimension)
                weights = np.hstack([1 - local.sum(axis=1, keepdims=True), local])
                for element in nodes.reshape(-1, count).tolist():
                    points = np.array([places[node] for node in element])
                    np.testing.assert_allclose(points, weights @ points[:corners], atol=1e-15)

    def check_volume(self):
        (kind,) = gmsh.model.mesh.getElementTypes(3)
        places, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss4")
        _, determinants, _ = gmsh.model.mesh.getJacobians(kind, places)
        self.assertGreater(determinants.min(), 0)
        self.assertAlmostEqual((determinants.reshape(-1, len(weights)) @ weights).sum(), LENGTH, 10)  # as good as its weights

    @staticmethod
    def points_by_tag():
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        return tags, coordinates.reshape(-1, 3)

    def test_it_reads_msh_with_all_groups_and_bits(self):
        for version in ("4.1", "2.2"):
            for kind, grid in self.grids.items():
                with self.subTest(version=version, kind=kind):
                    gmsh.open(self.written("solid.msh", grid, msh_version=version))
                    self.assertEqual(self.groups(), self.counts)
                    self.check_points(grid)
                    self.check_order()
                    self.check_volume()
                    gmsh.clear()

    def test_cells_alone_are_one_block_of_nodes_and_one_of_elements(self):
        for kind, grid in self.grids.items():
            for version in ("4.1", "2.2"):
                with self.subTest(kind, version=version):
                    insideout.write(grid, self.path("cells.msh"), boundary=self.result.boundary, msh_version=version, cells_only=True)
                    gmsh.open(self.path("cells.msh"))
                    self.assertEqual([name for _, name in ((tag, gmsh.model.getPhysicalName(*tag)) for tag in gmsh.model.getPhysicalGroups())], ["solid"])
                    self.assertEqual(sum(map(len, gmsh.model.mesh.getElements(3)[1])), grid.GetNumberOfCells())
                    self.assertEqual(len(gmsh.model.mesh.getElements(2)[0]), 0)
                    gmsh.clear()
        insideout.write(self.result, self.path("cells.msh"), cells_only=True)
        with open(self.path("cells.msh"), encoding="utf-8") as file:
            lines = file.read().split("\n")
        points, cells = self.result.solid.GetNumberOfPoints(), self.result.solid.GetNumberOfCells()
        self.assertEqual(lines[lines.index("$Nodes") + 1], f"1 {points} 1 {points}")
        self.assertEqual(lines[lines.index("$Elements") + 1], f"1 {cells} 1 {cells}")
        with self.assertRaisesRegex(insideout.Error, "solid.vtu: cells_only leaves away the groups of .msh, .inp, .mesh files"):
            insideout.write(self.result, self.path("solid.vtu"), cells_only=True)

    def test_it_knows_what_bounds_the_volumes_and_lies_on_the_surfaces(self):
        gmsh.open(self.written("solid.msh", self.solid))
        wall = len(SIDES) + 1
        around = [sorted(tag for _, tag in gmsh.model.getBoundary([(3, region)])) for region in (1, 2)]
        self.assertEqual(around, [[1, 3, 4, 5, 6, wall], [-wall, 2, 3, 4, 5, 6]])
        for tag in range(1, 3):
            nodes, _ = gmsh.model.mesh.getNodesForPhysicalGroup(2, tag)
            expected = surfaces.points_of(self.solid)[:, 0] == (0, LENGTH)[tag - 1]
            self.assertEqual(sorted(nodes.astype(int) - 1), np.flatnonzero(expected).tolist())

    def test_it_reads_mesh(self):
        for kind, grid in self.grids.items():
            with self.subTest(kind):
                gmsh.open(self.written("solid.mesh", grid))
                found = {}
                for dimension, entity in gmsh.model.getEntities():
                    elements = gmsh.model.mesh.getElements(dimension, entity)[1]
                    found[dimension, entity] = sum(map(len, elements))
                expected = {(3, region + 1): self.counts[3, f"region_{region}"] for region in (0, 1)}
                expected.update(((2, tag + 1), self.counts[2, name]) for tag, name in enumerate((*SIDES, "wall")))
                self.assertEqual({key: count for key, count in found.items() if count}, expected)
                self.check_points(grid)
                self.check_order()
                gmsh.clear()

    def test_it_reads_names_of_any_kind(self):
        names = ['a "quoted" name', "Außenwand", "x" * 200, "", "two\nlines", "back\\slash"]
        boundary = vtkPolyData()
        boundary.ShallowCopy(self.result.boundary)
        add_tags(boundary, surfaces.cell_array(self.result.boundary, "BoundaryTag"), names)
        write_solid(self.result.solid, self.path("solid.msh"), boundary)
        gmsh.open(self.path("solid.msh"))
        expected = ["a _quoted_ name", "Außenwand", "x" * 100, "tag_3", "two_lines", "back_slash"]
        self.assertEqual([gmsh.model.getPhysicalName(2, tag) for tag in range(1, 7)], expected)
        self.assertEqual(sorted(meshio.read(self.path("solid.msh")).field_data), sorted([*expected, "solid"]))

    def test_a_solid_alone_is_one_group_within_another(self):
        write_solid(self.result.solid, self.path("solid.msh"))
        gmsh.open(self.path("solid.msh"))
        cells, faces = self.result.solid.GetNumberOfCells(), self.result.boundary.GetNumberOfCells()
        self.assertEqual(self.groups(), {(3, "solid"): cells, (2, "surface"): faces})

    def test_a_hull_tells_what_is_outside(self):
        hull = insideout.tetrahedralize(surfaces.two_boxes()).hull
        write_solid(hull, self.path("hull.msh"))
        gmsh.open(self.path("hull.msh"))
        inside = int(hull.inside.sum())
        cells = {name: count for (dimension, name), count in self.groups().items() if dimension == 3}
        self.assertEqual(cells, {"solid": inside, "outside": hull.GetNumberOfCells() - inside})

    def test_groups_of_a_surface_and_cells_of_a_refined_solid_arrive(self):
        obj = "".join("v {} {} {}\n".format(*point) for point in surfaces.box_points())
        for name, facets in (("base_plate", surfaces.BOX_FACETS[:2]), ("walls", surfaces.BOX_FACETS[4:])):
            obj += f"g {name}\n" + "".join("f {} {} {}\n".format(*(corner + 1 for corner in facet)) for facet in facets)
        with open(self.path("open.obj"), "w", encoding="utf-8") as file:
            file.write(obj)
        result = insideout.tetrahedralize(self.path("open.obj"), edge_length=0.4, quadratic_cells=True)
        insideout.write(result, self.path("open.msh"))
        gmsh.open(self.path("open.msh"))
        expected = {(2, name): len(triangles) for name, triangles in result.tags.items()}
        self.assertEqual({name for _, name in expected}, {"base_plate", "walls", "hole"})
        self.assertEqual(self.groups(), {**expected, (3, "solid"): result.solid.GetNumberOfCells()})
        self.check_points(result.solid)
        self.check_order()
        self.assertEqual([block.type for block in result.to_meshio().cells], ["tetra10"] + ["triangle6"] * 3)

    def test_it_reads_what_meshio_makes_of_a_result(self):
        cells = self.result.solid.GetNumberOfCells()
        sides = {(2, name): self.counts[2, name] for name in SIDES}
        plain = insideout.tetrahedralize(surfaces.two_boxes())
        counts = {(3, "solid"): plain.solid.GetNumberOfCells(), (2, "surface"): plain.boundary.GetNumberOfCells()}
        # In 4.1 meshio knows no group all of whose points are others' too.
        for result, kind, expected in ((self.result, "gmsh22", {(3, "solid"): cells, **sides}), (plain, "gmsh", counts)):
            with self.subTest(kind):
                result.to_meshio().write(self.path("solid.msh"), file_format=kind)
                gmsh.open(self.path("solid.msh"))
                self.assertEqual(self.groups(), expected)
                self.check_points(result.solid)
                gmsh.clear()


class Meshio(InAFolder):
    def counts_of(self, mesh, name: str) -> dict:
        """How many cells have each number, by the cells' dimension."""
        found = {}
        for block, numbers in zip(mesh.cells, mesh.cell_data[name]):
            for number, count in zip(*np.unique(numbers, return_counts=True)):
                key = (2 if block.type.startswith("triangle") else 3, int(number))
                found[key] = found.get(key, 0) + int(count)
        return found

    def expected(self) -> dict:
        numbers = {(3, f"region_{region}"): region + 1 for region in (0, 1)}
        numbers.update(((2, name), tag + 1) for tag, name in enumerate((*SIDES, "wall")))
        return {(dimension, numbers[dimension, name]): count for (dimension, name), count in self.counts.items()}

    def test_it_reads_msh(self):
        for version in ("4.1", "2.2"):
            for kind, grid in self.grids.items():
                with self.subTest(version=version, kind=kind):
                    mesh = meshio.read(self.written("solid.msh", grid, msh_version=version))
                    self.assertEqual(self.counts_of(mesh, "gmsh:physical"), self.expected())
                    found = {(int(dimension), name): int(number) for name, (number, dimension) in mesh.field_data.items()}
                    self.assertEqual(set(found), set(self.counts))
                    self.check_cells(mesh, grid)

    def check_cells(self, mesh, grid):
        """The same cells by the places of their points."""
        nodes = as_type(Tetrahedra, grid).cells
        expected = surfaces.points_of(grid)[nodes]
        found = np.concatenate([mesh.points[block.data] for block in mesh.cells if block.type.startswith("tetra")])
        self.assertEqual(sorted(cell.tobytes() for cell in found), sorted(cell.tobytes() for cell in expected))

    def test_it_reads_linear_mesh(self):
        mesh = meshio.read(self.written("solid.mesh", self.solid))
        self.assertEqual(self.counts_of(mesh, "medit:ref"), self.expected())
        self.assertEqual(mesh.points.tobytes(), surfaces.points_of(self.solid).tobytes())
        self.check_cells(mesh, self.solid)

    def test_it_reads_inp_with_its_sets(self):
        for kind, grid in self.grids.items():
            with self.subTest(kind):
                mesh = meshio.read(self.written("solid.inp", grid))
                self.check_cells(mesh, grid)
                names = {name.replace(" ", "_") for _, name in self.counts}
                self.assertEqual(set(mesh.point_sets) - {"Nall"}, names)
                for region in (0, 1):
                    name = f"region_{region}"
                    self.assertEqual(sum(map(len, mesh.cell_sets[name])), self.counts[3, name])
                self.assertEqual(sum(len(block.data) for block in mesh.cells), grid.GetNumberOfCells())

    def test_it_reads_xdmf_bit_by_bit(self):
        for kind, grid in self.grids.items():
            with self.subTest(kind):
                surfaces.add_array(grid.GetPointData(), "third", np.full(grid.GetNumberOfPoints(), 1 / 3, np.float32))
                insideout.write(grid, self.path("solid.xdmf"))
                mesh = meshio.read(self.path("solid.xdmf"))
                self.assertEqual(mesh.points.tobytes(), surfaces.points_of(grid).tobytes())
                self.check_cells(mesh, grid)
                for name in ("w", "RegionId", "Inside"):
                    np.testing.assert_array_equal(mesh.cell_data[name][0], surfaces.cell_array(grid, name))
                for k in range(4):
                    np.testing.assert_array_equal(mesh.cell_data[f"FacetIds_{k}"][0], surfaces.cell_array(grid, "FacetIds")[:, k])
                self.assertEqual(set(mesh.point_data["third"]), {np.float32(1 / 3)})
                self.assertEqual(os.listdir(self.folder), ["solid.xdmf"])

    def test_xdmf_of_a_result_has_the_boundary_beside_it(self):
        for kind, grid in self.grids.items():
            with self.subTest(kind):
                insideout.write(grid, self.path("solid.xdmf"), boundary=self.result.boundary)
                self.assertEqual(sorted(os.listdir(self.folder)), ["solid.xdmf", "solid_boundary.xdmf"])
                cells, faces = (meshio.read(self.path(name)) for name in ("solid.xdmf", "solid_boundary.xdmf"))
                self.assertEqual(faces.points.tobytes(), cells.points.tobytes())
                self.assertEqual(next(iter(cells.cell_data)), "RegionId")
                self.assertEqual(next(iter(faces.cell_data)), "BoundaryTag")
                boundary = self.result.boundary
                np.testing.assert_array_equal(faces.cell_data["BoundaryTag"][0], boundary.cell_arrays["BoundaryTag"])
                nodes = faces.cells[0].data
                np.testing.assert_array_equal(faces.points[nodes[:, :3]], boundary.points[boundary.triangles])
                if nodes.shape[1] == 6:
                    ends = faces.points[nodes[:, :3]]
                    np.testing.assert_allclose(faces.points[nodes[:, 3:]], (ends + np.roll(ends, -1, axis=1)) / 2, atol=1e-15)
                named = {name: number.tolist() for name, number in faces.field_data.items()}
                self.assertEqual(named, {name: [tag, 2] for tag, name in enumerate(boundary.tag_names)})

    def test_the_boundary_beside_an_xdmf_replaces_no_file_of_others(self):
        beside = self.path("solid_boundary.xdmf")
        with open(beside, "w", encoding="utf-8") as file:
            file.write("mine")
        refusal = r"solid_boundary\.xdmf, beside .*solid\.xdmf, is where the boundary goes, and was not written by insideout"
        with self.assertRaisesRegex(insideout.Error, refusal):
            insideout.write(self.result.solid, self.path("solid.xdmf"), boundary=self.result.boundary)
        with self.assertRaisesRegex(insideout.Error, refusal):
            insideout.tetrahedralize(self.result.boundary, output=self.path("solid.xdmf"))
        self.assertEqual(os.listdir(self.folder), ["solid_boundary.xdmf"])
        insideout.write(self.result.boundary, self.path("boundary.ply"))
        command = [sys.executable, "-m", "insideout", "mesh", self.path("boundary.ply"), self.path("solid.xdmf"), "--no-refine"]
        refused = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertRegex(refused.stderr, refusal)
        with open(beside, encoding="utf-8") as file:
            self.assertEqual(file.read(), "mine")
        subprocess.run([*command, "--force"], capture_output=True, check=True)
        subprocess.run(command, capture_output=True, check=True)  # now it is of this program
        with open(beside, encoding="utf-8") as file:
            self.assertIn("Written by InsideOut", file.read())

    def test_xdmf_refuses_triangles_that_are_no_faces(self):
        box = surfaces.box()
        with self.assertRaisesRegex(insideout.Error, "solid.xdmf: .* of the boundary is not a "):
            insideout.write(self.result.solid, self.path("solid.xdmf"), boundary=box)

    def test_a_result_becomes_one_mesh_with_groups(self):
        write_solid(self.result.solid, self.path("solid.msh"), self.result.boundary)
        there = meshio.read(self.path("solid.msh"))
        mesh = self.result.to_meshio()
        self.assertEqual([block.type for block in mesh.cells], ["tetra"] + ["triangle"] * len(SIDES))
        for name in ("gmsh:physical", "gmsh:geometrical"):
            self.assertEqual(self.counts_of(mesh, name), self.counts_of(there, name))
        listed = [{name: values.tolist() for name, values in one.field_data.items()} for one in (mesh, there)]
        self.assertEqual(*listed)
        self.assertEqual(mesh.points.tobytes(), self.result.solid.points.tobytes())
        entities = [dict(zip(map(bytes, one.points), one.point_data["gmsh:dim_tags"].tolist())) for one in (mesh, there)]
        self.assertEqual(*entities)
        tags = self.result.boundary.cell_arrays["BoundaryTag"]
        for tag in range(len(SIDES)):
            places = self.result.boundary.points[self.result.boundary.triangles[tags == tag]]
            np.testing.assert_array_equal(mesh.points[mesh.cells[1 + tag].data], places)
            self.assertTrue(np.isnan(mesh.cell_data["w"][1 + tag]).all())
            self.assertEqual(set(mesh.cell_data["FacetIds_0"][1 + tag]), {-1})
        np.testing.assert_array_equal(mesh.cell_data["w"][0], self.result.solid.w)
        again = insideout.tetrahedralize(mesh)
        self.assertAlmostEqual(again.statistics["Volume"], LENGTH, 12)

    def test_so_does_one_of_quadratic_cells(self):
        made = types.SimpleNamespace(solid=self.grids["quadratic"], boundary=self.result.boundary)
        mesh = insideout.Tetrahedralization.to_meshio(made)
        self.assertEqual([block.type for block in mesh.cells], ["tetra10"] * 2 + ["triangle6"] * len(SIDES))
        corners = mesh.points[np.vstack([block.data for block in mesh.cells[2:]])]
        np.testing.assert_array_equal(corners[:, 3:], (corners[:, :3] + np.roll(corners[:, :3], -1, axis=1)) / 2)
        self.assertAlmostEqual(insideout.tetrahedralize(mesh).statistics["Volume"], LENGTH, 12)


STIFFNESS, POISSON, PRESSURE, WEIGHT = 210.0, 0.3, 2.0, 3.0

MATERIAL = f"""*INCLUDE, INPUT=solid.inp
*MATERIAL, NAME=some
*ELASTIC
{STIFFNESS}, {POISSON}
*DENSITY
1
*SOLID SECTION, ELSET=Eall, MATERIAL=some
*BOUNDARY
clamped_end, 1, 1
y_low, 2, 2
z_low, 3, 3
"""

STEP = f"""*STEP
*STATIC
*DSLOAD
loaded_end, P, {-PRESSURE}
{{loads}}
*NODE PRINT, NSET=Nall
U
*END STEP
"""


class CalculiX(InAFolder):
    """The file's node sets, surfaces by face and element sets in a problem whose answer is known."""

    def displacements(self, job: str) -> np.ndarray:
        with open(self.path("job.inp"), "w", encoding="utf-8") as file:
            file.write(job)
        done = subprocess.run(
            ["ccx", "job"], cwd=self.folder, capture_output=True, text=True, check=False, env={**os.environ, "OMP_NUM_THREADS": "1"}
        )
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assertNotRegex(done.stdout, r"\*(WARNING|ERROR)", done.stdout)
        with open(self.path("job.dat"), encoding="utf-8") as file:
            rows = [line.split() for line in file if re.match(r" +\d+ ", line)]
        self.assertEqual([int(row[0]) for row in rows], list(range(1, len(rows) + 1)))
        return np.array([[float(number) for number in row[1:]] for row in rows])

    def test_a_bar_is_drawn_as_hooke_says(self):
        for kind, grid in self.grids.items():
            with self.subTest(kind):
                self.written("solid.inp", grid)
                found = self.displacements(MATERIAL + STEP.format(loads="** none"))
                strain = PRESSURE / STIFFNESS * np.array([1, -POISSON, -POISSON])
                np.testing.assert_allclose(found, surfaces.points_of(grid) * strain, atol=1e-7)

    def test_a_bar_between_walls_hangs_in_a_parabola(self):
        """Second order, with quadratic cells exact: if a midpoint were another's, they would not be."""
        grid = self.grids["quadratic"]
        self.written("solid.inp", grid)
        walls = "y_high, 2, 2\nz_high, 3, 3\n"
        loads = "*DLOAD\n" + "\n".join(f"region_{region}, GRAV, {WEIGHT}, 1, 0, 0" for region in (0, 1))
        found = self.displacements(MATERIAL + walls + STEP.format(loads=loads))
        modulus = STIFFNESS * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
        x = surfaces.points_of(grid)[:, 0]
        expected = (PRESSURE * x + WEIGHT * (LENGTH * x - x**2 / 2)) / modulus
        np.testing.assert_allclose(found[:, 0], expected, atol=1e-7)
        np.testing.assert_allclose(found[:, 1:], 0, atol=1e-7)

    def test_names_that_only_case_tells_apart_are_two_sets(self):
        names = ["end", "END", "1 2", "Nall", "solid", "größe" + "e" * 100]
        boundary = vtkPolyData()
        boundary.ShallowCopy(self.result.boundary)
        add_tags(boundary, surfaces.cell_array(self.result.boundary, "BoundaryTag"), names)
        write_solid(self.result.solid, self.path("solid.inp"), boundary)
        job = MATERIAL + STEP.format(loads="** none")
        for side, name in (("clamped_end", "end"), ("y_low", "group_1_2"), ("z_low", "solid_2"), ("loaded_end", "END_2")):
            job = job.replace(side, name)
        found = self.displacements(job)
        np.testing.assert_allclose(found[:, 0], surfaces.points_of(self.result.solid)[:, 0] * PRESSURE / STIFFNESS, atol=1e-7)

    def test_small_numbers_are_read_as_what_they_are(self):
        """It reads twenty characters of each, and would pass over an exponent behind them."""
        small, boundary = vtkUnstructuredGrid(), vtkPolyData()
        for made, data in ((small, self.result.solid), (boundary, self.result.boundary)):
            made.ShallowCopy(data)
            made.SetPoints(vtkPoints())
            made.GetPoints().SetDataTypeToDouble()
            made.GetPoints().SetData(numpy_to_vtk(surfaces.points_of(data) * (1e-5 / 3) - 1e-5, deep=True))
        write_solid(small, self.path("solid.inp"), boundary)
        self.assertGreater(max(len(repr(x)) for x in surfaces.points_of(small).ravel().tolist()), 20)
        found = self.displacements(MATERIAL + STEP.format(loads="** none"))
        expected = (surfaces.points_of(small)[:, 0] + 1e-5) * PRESSURE / STIFFNESS
        np.testing.assert_allclose(found[:, 0], expected, rtol=1e-5, atol=1e-14)


class Refusals(InAFolder):
    def test_boundaries_and_cells_that_do_not_fit_are_named(self):
        other = insideout.tetrahedralize(surfaces.box((5, 5, 5)))
        for name in ("solid.msh", "solid.inp", "solid.mesh"):
            with self.assertRaisesRegex(insideout.Error, f"{name}: triangle 0 of the boundary is not a face of the solid's cells"):
                insideout.write(self.result.solid, self.path(name), boundary=other.boundary)
            with self.assertRaisesRegex(insideout.Error, f"{name}: the grid has no cells"):
                insideout.write(vtkUnstructuredGrid(), self.path(name))
        with self.assertRaisesRegex(insideout.Error, "msh_version is '3'; it can be '4.1', '2.2'"):
            insideout.write(self.result, self.path("solid.msh"), msh_version="3")
        with self.assertRaisesRegex(insideout.Error, "of type str; it can be a result"):
            insideout.write("solid", self.path("solid.msh"))
        with self.assertRaisesRegex(insideout.Error, "solid.vtk: unknown ending, it must be .vtu .msh .inp .mesh .xdmf"):
            insideout.write(self.result, self.path("solid.vtk"))
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_result_is_written_by_its_ending(self):
        for name in ("fixed.stl", "fixed.ply", "fixed.obj", "fixed.off", "fixed.vtp"):
            with self.subTest(name):
                insideout.write(self.result, self.path(name))
                again = insideout.tetrahedralize(self.path(name))
                self.assertEqual(again.statistics["OpenEdges"], 0)
                self.assertAlmostEqual(again.statistics["Volume"], LENGTH, 12)


if __name__ == "__main__":
    unittest.main()
