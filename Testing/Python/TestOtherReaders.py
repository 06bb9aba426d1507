# SPDX-License-Identifier: GPL-3.0-or-later
"""meshio reads .vtu and .ply files of every kind of run; gmsh and VTK read the surfaces."""

import os
import unittest
import warnings

import gmsh
import insideout
import meshio
import numpy as np
import surfaces
from command import read_grid
from insideout.files import read_solid, read_surface
from TestFiles import InAFolder
from TestPlane import two_squares
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOPLY import vtkPLYReader

AWKWARD = 'große "Kiste" <1> & #2'
"""A name that XML has to encode."""


def named(surface: vtkPolyData) -> vtkPolyData:
    """The surface, whose facets are by turns of three parts with names."""
    surfaces.add_array(surface.GetCellData(), "GroupIds", np.arange(surface.GetNumberOfCells()) % 3)
    names = vtkStringArray()
    names.SetName("GroupNames")
    for name in ("one", "", AWKWARD):
        names.InsertNextValue(name)
    surface.GetFieldData().AddArray(names)
    return surface


def runs():
    """Results of every kind, by name."""
    boxes = surfaces.two_boxes()
    yield "plain", insideout.tetrahedralize(boxes)
    yield "tags", insideout.tetrahedralize(named(surfaces.two_boxes()))
    yield "arrays", insideout.tetrahedralize(with_arrays(surfaces.two_boxes()))
    yield "bodies", insideout.tetrahedralize({AWKWARD: surfaces.box(), "b": surfaces.box((0.5, 0.5, 0.5))})
    yield "quadratic", insideout.tetrahedralize(boxes, refine=True, edge_length=0.5, quadratic_cells=True)
    yield "turned", insideout.tetrahedralize(surfaces.reversed_box())
    yield "open", insideout.tetrahedralize(surfaces.open_box())
    yield "stray", insideout.tetrahedralize(surfaces.two_boxes_and_a_stray_facet())
    yield "empty", insideout.tetrahedralize(surfaces.polydata(surfaces.box_points(), [(0, 1, 2), (4, 5, 6)]))
    yield "split", insideout.tetrahedralize(boxes, non_manifold="split")


def with_arrays(surface: vtkPolyData) -> vtkPolyData:
    surfaces.add_array(surface.GetPointData(), "pressure", np.arange(16) / 3)
    surfaces.add_array(surface.GetCellData(), "three", np.arange(72.0).reshape(24, 3))
    surfaces.add_array(surface.GetCellData(), "Colors", np.arange(72, dtype=np.uint8).reshape(24, 3))
    return surface


class Grids(InAFolder):
    def check(self, grid) -> None:
        path = self.path("grid.vtu")
        insideout.write(grid, path)
        mesh, again = meshio.read(path), read_grid(path)
        np.testing.assert_array_equal(mesh.points, surfaces.points_of(grid))
        self.assertEqual(insideout.pipeline.statistics_of(again), insideout.pipeline.statistics_of(grid))
        found = [block.data for block in mesh.cells]
        expected = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
        self.assertEqual(np.concatenate([np.zeros(0, int), *map(np.ravel, found)]).tolist(), expected.tolist())
        self.assertEqual(again.GetNumberOfCells(), grid.GetNumberOfCells())
        for data, read in ((grid.GetCellData(), mesh.cell_data), (grid.GetPointData(), mesh.point_data)):
            for index in range(data.GetNumberOfArrays()):
                values = read[data.GetArrayName(index)]
                np.testing.assert_array_equal(np.concatenate(values) if data is grid.GetCellData() else values, vtk_to_numpy(data.GetArray(index)))

    def test_meshio_reads_what_every_run_gives(self):
        for name, result in runs():
            for kind in ("solid", "hull"):
                if name != "empty" or kind == "hull":  # meshio reads no grid without cells, however it is written
                    with self.subTest(name, kind=kind):
                        self.check(getattr(result, kind))

    def test_meshio_reads_triangles_in_a_plane(self):
        result = insideout.tetrahedralize(two_squares())
        for kind in ("solid", "hull"):
            with self.subTest(kind):
                self.check(getattr(result, kind))

    def test_meshio_reads_what_is_refined(self):
        result = insideout.tetrahedralize({"a": surfaces.box(), "b": surfaces.box((0.5, 0.5, 0.5))})
        self.check(insideout.refine(result.solid, edge_length=0.7).solid)

    def test_names_of_regions_are_kept(self):
        result = insideout.tetrahedralize({AWKWARD: surfaces.box(), "b": surfaces.box((0.5, 0.5, 0.5))})
        insideout.write(result.solid, self.path("bodies.vtu"))
        solid, _ = read_solid(self.path("bodies.vtu"))
        written = []
        for grid in (result.solid, solid):
            insideout.write(grid, self.path("bodies.msh"))
            with open(self.path("bodies.msh"), encoding="utf-8") as file:
                written.append(file.read())
        self.assertEqual(written[0], written[1])
        self.assertIn("große", written[0])


class Surfaces(InAFolder):
    def setUp(self):
        super().setUp()
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        self.addCleanup(gmsh.finalize)

    def check(self, surface: vtkPolyData) -> None:
        path = self.path("surface.ply")
        insideout.write(surface, path)
        points, triangles = surfaces.points_of(surface), surfaces.triangles_of(surface)

        if len(points):
            again, told = read_surface(path)
            self.assertEqual(told, [])
            np.testing.assert_array_equal(surfaces.points_of(again), points)
            np.testing.assert_array_equal(surfaces.triangles_of(again), triangles)

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # meshio's own, of numpy
            mesh = meshio.read(path)
        np.testing.assert_array_equal(mesh.points, points)
        np.testing.assert_array_equal(np.concatenate([np.zeros((0, 3), int), *(block.data for block in mesh.cells)]), triangles)
        for name in ("vtkOriginalCellIds", "BoundaryTag"):
            if len(triangles) and surface.GetCellData().HasArray(name):
                np.testing.assert_array_equal(mesh.cell_data[name][0], surfaces.cell_array(surface, name))

        gmsh.clear()
        gmsh.merge(path)
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        elements = gmsh.model.mesh.getElements(2)[2]
        self.assertEqual(sum(map(len, elements)), triangles.size)
        if len(triangles):
            place = dict(zip(tags.tolist(), coordinates.reshape(-1, 3).tolist()))
            self.assertEqual([place[tag] for tag in elements[0].tolist()], points[triangles.ravel()].tolist())

        reader = vtkPLYReader()
        reader.SetFileName(path)
        insideout.pipeline.run(reader)
        np.testing.assert_array_equal(surfaces.triangles_of(reader.GetOutput()), triangles)

    def test_gmsh_meshio_and_vtk_read_what_every_run_gives(self):
        for name, result in runs():
            for kind in ("boundary", "outliers"):
                with self.subTest(name, kind=kind):
                    self.check(getattr(result, kind))

    def test_they_read_the_surface_that_check_marks(self):
        self.check(insideout.check(named(surfaces.two_boxes_and_a_stray_facet())).surface)

    def test_they_read_a_resolved_surface(self):
        self.check(insideout.resolve(surfaces.two_boxes()).surface)

    def test_they_read_the_surface_of_a_set_operation(self):
        self.check(insideout.boolean([surfaces.box(), surfaces.box((0.5, 0.5, 0.5))], "A - B").surface)


if __name__ == "__main__":
    unittest.main()
