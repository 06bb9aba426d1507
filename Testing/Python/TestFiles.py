# SPDX-License-Identifier: GPL-3.0-or-later
"""insideout.files: what is written is read back the same, and what cannot be read is named."""

import os
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from insideout.files import read_surface, write_grid, write_surface
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name: str) -> str:
        return os.path.join(self.folder, name)


def awkward_box() -> vtkPolyData:
    """A box whose coordinates no float holds, with normals, texture coordinates, colours and other arrays."""
    surface = surfaces.box(low=(1 / 3, 1e-17, -1e5 / 7), size=np.pi)
    surface.GetPointData().SetNormals(surfaces.add_array(surface.GetPointData(), "up", np.tile([0.0, 0.6, 0.8], (8, 1))))
    texture = np.arange(16.0).reshape(8, 2) / 16
    surface.GetPointData().SetTCoords(surfaces.add_array(surface.GetPointData(), "uv", texture))
    surfaces.add_array(surface.GetPointData(), "pressure", np.arange(8) / 3)
    colours = np.arange(36, dtype=np.uint8).reshape(12, 3)
    surface.GetCellData().SetScalars(surfaces.add_array(surface.GetCellData(), "paint", colours))
    surfaces.add_array(surface.GetCellData(), "part", np.arange(12, dtype=np.int64))
    return surface


class RoundTrips(InAFolder):
    def test_doubles_come_back_to_the_last_bit(self):
        surface = awkward_box()
        for ending in (".ply", ".obj", ".vtp"):
            with self.subTest(ending):
                write_surface(surface, self.path("box" + ending))
                again, warnings = read_surface(self.path("box" + ending))
                self.assertEqual(warnings, [])
                self.assertEqual(again.GetPoints().GetDataType(), VTK_DOUBLE)
                self.assertEqual(surfaces.points_of(again)[:8].tobytes(), surfaces.points_of(surface).tobytes())
                self.assertEqual(surfaces.triangles_of(again).tolist(), surfaces.triangles_of(surface).tolist())

    def test_stl_has_floats(self):
        surface = awkward_box()
        write_surface(surface, self.path("box.stl"))
        again, _ = read_surface(self.path("box.stl"))
        expected = surfaces.points_of(surface)[surfaces.triangles_of(surface)].astype(np.float32)
        found = surfaces.points_of(again)[surfaces.triangles_of(again)]
        self.assertEqual(found.tolist(), expected.astype(float).tolist())

    def test_ply_keeps_every_array(self):
        surface = awkward_box()
        write_surface(surface, self.path("box.ply"))
        again, _ = read_surface(self.path("box.ply"))
        for data, name, expected in (
            (again.GetPointData(), "Normals", np.tile([0.0, 0.6, 0.8], (8, 1))),
            (again.GetPointData(), "TCoords", np.arange(16.0).reshape(8, 2) / 16),
            (again.GetPointData(), "pressure", np.arange(8) / 3),
            (again.GetCellData(), "Colors", np.arange(36).reshape(12, 3)),
            (again.GetCellData(), "part", np.arange(12)),
        ):
            with self.subTest(name):
                array = data.GetArray(name)
                self.assertIsNotNone(array)
                found = np.array([array.GetTuple(k) for k in range(array.GetNumberOfTuples())])
                np.testing.assert_array_equal(found.squeeze(), expected)

    def test_polygons_stay_polygons_and_strips_become_triangles(self):
        polygons = surfaces.polydata(surfaces.box_points(), [(0, 3, 2, 1), (4, 5, 6, 7)])
        strips = surfaces.polydata(surfaces.box_points(), [(0, 1, 3, 2)])
        polygons.SetStrips(strips.GetPolys())
        write_surface(polygons, self.path("mixed.ply"))
        again, _ = read_surface(self.path("mixed.ply"))
        found = []
        for cell in range(again.GetNumberOfCells()):
            ids = again.GetCell(cell).GetPointIds()
            found.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
        self.assertEqual(found, [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 3], [1, 2, 3]])

    def test_vtk_files_are_read_whose_ranges_are_not_finite(self):
        surface = surfaces.box()
        surface.GetPoints().InsertNextPoint(1e300, 0, 0)  # no facet uses it
        surface.GetPoints().GetData().GetRange(-1)  # VTK notes the ranges it knows in the file
        path = self.path("nan.vtp")
        write_surface(surface, path)
        again, warnings = read_surface(path)
        self.assertEqual((again.GetNumberOfPoints(), again.GetNumberOfCells()), (9, 12))
        self.assertEqual(insideout.tetrahedralize(again).statistics["Points"], 8)
        self.assertEqual(warnings, [])

    def test_a_vtk_file_without_points_is_an_empty_surface(self):
        path = self.path("nothing.vtp")
        write_surface(vtkPolyData(), path)
        with self.assertRaisesRegex(insideout.Error, "the surface is empty"):
            insideout.tetrahedralize(path)

    def test_an_empty_surface_is_written_and_vtk_reads_it(self):
        for ending, make in ((".ply", vtkPLYReader), (".stl", vtkSTLReader), (".vtp", vtkXMLPolyDataReader)):
            with self.subTest(ending):
                write_surface(surfaces.polydata([], []), self.path("empty" + ending))
                reader = make()
                reader.SetFileName(self.path("empty" + ending))
                insideout.pipeline.run(reader)
                self.assertEqual(reader.GetOutput().GetNumberOfCells(), 0)

    def test_vtk_reads_the_surfaces(self):
        for ending, make in ((".ply", vtkPLYReader), (".stl", vtkSTLReader), (".vtp", vtkXMLPolyDataReader)):
            with self.subTest(ending):
                write_surface(surfaces.box(), self.path("box" + ending))
                reader = make()
                reader.SetFileName(self.path("box" + ending))
                insideout.pipeline.run(reader)
                self.assertEqual(reader.GetOutput().GetNumberOfCells(), 12)
                self.assertAlmostEqual(surfaces.enclosed_volume(reader.GetOutput()), 1)

    def test_grids_keep_their_arrays(self):
        grid = insideout.tetrahedralize(surfaces.two_boxes()).hull
        write_grid(grid, self.path("hull.vtu"))
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(self.path("hull.vtu"))
        insideout.pipeline.run(reader)
        again = reader.GetOutput()
        self.assertEqual(surfaces.points_of(again).tobytes(), surfaces.points_of(grid).tobytes())
        self.assertEqual(surfaces.tetrahedra_of(again).tolist(), surfaces.tetrahedra_of(grid).tolist())
        for name in ("w", "Inside", "FacetIds", "FacetMultiplicity"):
            found, expected = surfaces.cell_array(again, name), surfaces.cell_array(grid, name)
            self.assertEqual((found.dtype, found.tolist()), (expected.dtype, expected.tolist()))
        self.assertEqual(insideout.pipeline.statistics_of(again), insideout.pipeline.statistics_of(grid))


class Refusals(InAFolder):
    def write_text(self, name: str, text: str) -> str:
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def test_what_cannot_be_read_is_named(self):
        os.mkdir(self.path("folder.ply"))
        for path, reason in (
            (self.path("missing.ply"), "no such file"),
            (self.path("folder.ply"), "is a directory"),
            (self.write_text("surface.txt", "ply"), "unknown ending"),
            (self.write_text("surface", "ply"), "unknown ending"),
            (self.write_text("empty.vtp", ""), "cannot read"),
            (self.write_text("broken.vtp", "<VTKFile type='PolyData'><PolyData>"), "cannot read"),
            (self.write_text("other.vtp", "<VTKFile type='ImageData'/>"), "no VTK XML file of polygons"),
            (self.write_text("zero.obj", "v 0 0 0\nf 0 1 1\n"), "line 2: face refers to point 0"),
        ):
            with self.subTest(os.path.basename(path)):
                with self.assertRaisesRegex(insideout.Error, reason) as caught:
                    read_surface(path)
                self.assertIn(path, str(caught.exception))
                self.assertEqual(str(caught.exception).count(os.path.basename(path)), 1)

    def test_appended_mode_is_read_or_explained(self):
        surface = surfaces.box(low=(1 / 3, 1 / 7, 1 / 9))
        surfaces.add_array(surface.GetPointData(), "noise", np.random.default_rng(1).random((8, 1000)))
        for encoded in (True, False):
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(surface)
            writer.SetFileName(self.path("appended.vtp"))
            writer.SetEncodeAppendedData(encoded)
            writer.Write()
            with self.subTest(encoded=encoded):
                try:
                    again, _ = read_surface(self.path("appended.vtp"))
                except insideout.Error as error:  # what VTK reads depends on the system's expat
                    self.assertIn("appended.vtp", str(error))
                    self.assertIn("appended mode", str(error))
                else:
                    self.assertEqual(surfaces.points_of(again).tobytes(), surfaces.points_of(surface).tobytes())

    def test_what_cannot_be_written_is_named(self):
        os.mkdir(self.path("folder.vtu"))
        grid = insideout.tetrahedralize(surfaces.box()).solid
        for name, reason in (
            ("missing/solid.vtu", "there is no folder"),
            ("folder.vtu", "it is a folder"),
            ("solid.vtk", "unknown ending"),
        ):
            with self.subTest(name):
                with self.assertRaisesRegex(insideout.Error, reason) as caught:
                    write_grid(grid, self.path(name))
                self.assertIn(self.path(name), str(caught.exception))

    def test_a_full_disk_is_an_error(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("the system has no /dev/full")
        os.symlink("/dev/full", self.path("full.ply"))
        with self.assertRaises(insideout.Error):
            write_surface(surfaces.box(), self.path("full.ply"))

    def test_a_cell_out_of_range_is_not_written(self):
        with self.assertRaisesRegex(insideout.Error, "cell 0 refers to point 9 of 8"):
            write_surface(surfaces.box(facets=[(0, 1, 9)]), self.path("box.ply"))


if __name__ == "__main__":
    unittest.main()
