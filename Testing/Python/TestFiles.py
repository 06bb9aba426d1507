# SPDX-License-Identifier: GPL-3.0-or-later
"""insideout.files: what is written is read back the same, and what cannot be read is named."""

import gzip
import os
import resource
import select
import signal
import stat
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
from concurrent.futures import ThreadPoolExecutor

import insideout
import numpy as np
import surfaces
from insideout import vtkSurfaceWriter
from insideout.files import read_surface, write_grid, write_surface
from insideout.solid_files import write_solid
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader


CORPUS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data", "Corpus")


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name: str) -> str:
        return os.path.join(self.folder, name)


def awkward_box() -> vtkPolyData:
    """A box whose coordinates no float holds, with normals, texture coordinates, colors and other arrays."""
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
        for ending in (".ply", ".obj", ".off", ".vtp"):
            with self.subTest(ending):
                write_surface(surface, self.path("box" + ending))
                again, warnings = read_surface(self.path("box" + ending))
                self.assertEqual(warnings, [])
                self.assertEqual(again.GetPoints().GetDataType(), VTK_DOUBLE)
                self.assertEqual(surfaces.points_of(again)[:8].tobytes(), surfaces.points_of(surface).tobytes())
                self.assertEqual(surfaces.triangles_of(again).tolist(), surfaces.triangles_of(surface).tolist())

    def test_off_has_its_counts_in_the_second_line(self):
        write_surface(awkward_box(), self.path("box.off"))
        with open(self.path("box.off"), encoding="ascii") as file:
            self.assertEqual([next(file), next(file)], ["OFF\n", "8 12 0\n"])

    def test_stl_has_floats(self):
        surface = awkward_box()
        write_surface(surface, self.path("box.stl"))
        again, _ = read_surface(self.path("box.stl"))
        expected = surfaces.points_of(surface)[surfaces.triangles_of(surface)].astype(np.float32)
        found = surfaces.points_of(again)[surfaces.triangles_of(again)]
        self.assertEqual(found.tolist(), expected.astype(float).tolist())

    def test_a_repaired_stl_passes_its_own_check(self):
        for name in ("box-turned-a-little", "boxes-on-walls", "cylinders-tessellated-twice", "segments-beside-edges"):
            with self.subTest(name):
                result = insideout.tetrahedralize(os.path.join(CORPUS, name + ".off"))
                self.assertEqual(write_surface(result.boundary, self.path("fixed.stl")), [])
                found = insideout.check(self.path("fixed.stl")).statistics
                for count in ("OpenEdges", "DegenerateFacets", "DuplicateFacets", "IntersectingPairs", "NearPoints"):
                    self.assertEqual(found[count], 0, count)

    def test_points_brought_near_by_rounding_to_floats_are_told(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1e-7, 0, 0), (-1, 0, 0), (0, -1, 0)]
        surface = surfaces.polydata(corners, [(0, 1, 2), (3, 4, 5)])
        with self.assertWarnsRegex(UserWarning, "near.stl: rounded to the floats that the format has: 2 points are nearer"):
            insideout.write(surface, self.path("near.stl"))
        self.assertEqual(insideout.check(self.path("near.stl")).statistics["NearPoints"], 2)

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


class Names(InAFolder):
    """Files whose format the name does not tell, or not alone."""

    def test_every_format_may_be_compressed_and_shouted(self):
        for name in ("box.ply", "box.obj", "box.stl", "box.vtp", "BOX.PLY", "BOX.OBJ", "BOX.STL", "BOX.VTP"):
            path = self.path(name)
            write_surface(surfaces.box(), path)
            with open(path, "rb") as file:
                content = file.read()
            compressed = path + (".GZ" if name.isupper() else ".gz")
            with gzip.open(compressed, "wb") as file:
                file.write(content[:100])
            with gzip.open(compressed, "ab") as file:
                file.write(content[100:])  # a second member
            for read in (path, compressed):
                with self.subTest(read):
                    surface, warnings = read_surface(read)
                    self.assertEqual((surface.GetNumberOfCells(), warnings), (12, []))

    def test_content_counts_and_not_the_name(self):
        kinds = ("ply", "obj", "stl", "vtp")
        for kind in kinds:
            write_surface(surfaces.box(), self.path("box." + kind))
            for other in (*kinds, "off", "PLY"):
                path = self.path(f"really-{kind}.{other}")
                os.link(self.path("box." + kind), path)
                with self.subTest(path):
                    surface, warnings = read_surface(path)
                    self.assertEqual(surface.GetNumberOfCells(), 12)
                    expected = f"{os.path.basename(path)}: holds {kind.upper()}, not what its name says, and was read as such"
                    self.assertEqual(warnings, [] if other.lower() == kind else [expected])

    def test_damaged_compression_is_named(self):
        for name in ("box.ply.gz", "box.vtp.gz"):
            write_surface(surfaces.box(), self.path(name[:-3]))
            with open(self.path(name[:-3]), "rb") as file:
                whole = gzip.compress(file.read())
            damaged = bytearray(whole)
            damaged[-6] ^= 255
            for content, reason in ((whole[:-20], "its end is missing"), (bytes(damaged), "damaged"), (whole[:12], "its end is missing")):
                with self.subTest(name, reason=reason):
                    with open(self.path(name), "wb") as file:
                        file.write(content)
                    with self.assertRaisesRegex(insideout.Error, f"^{self.path(name)}: is compressed with gzip, and {reason}"):
                        read_surface(self.path(name))

    def test_content_larger_than_memory_is_named(self):
        write_surface(surfaces.box(), self.path("box.vtp"))
        with open(self.path("box.vtp"), "rb") as file, gzip.open(self.path("box.vtp.gz"), "wb") as compressed:
            compressed.write(file.read())
        with unittest.mock.patch("insideout.files.SHARE_OF_MACHINE", 0):
            with self.assertRaisesRegex(insideout.Error, "box.vtp.gz: .* holds more than 0 bytes, too many for this machine"):
                read_surface(self.path("box.vtp.gz"))

    def test_names_say_whether_something_is_compressed(self):
        for kind in ("ply", "vtp"):
            write_surface(surfaces.box(), self.path("plain." + kind))
            os.rename(self.path("plain." + kind), self.path(f"plain.{kind}.gz"))
            write_surface(surfaces.box(), self.path("box." + kind))
            with open(self.path("box." + kind), "rb") as file:
                content = gzip.compress(file.read())
            with open(self.path("box." + kind), "wb") as file:
                file.write(content)
            self.assertIn("is not compressed", read_surface(self.path(f"plain.{kind}.gz"))[1][0])
            self.assertIn("does not end in .gz", read_surface(self.path("box." + kind))[1][0])


class Refusals(InAFolder):
    def write_text(self, name: str, text: str) -> str:
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def test_unreadable_files_are_named(self):
        os.mkdir(self.path("folder.ply"))
        for path, reason in (
            (self.path("missing.ply"), "no such file"),
            (self.path("folder.ply"), "is a directory"),
            (self.write_text("surface.txt", "ply"), "unknown ending"),
            (self.write_text("surface", "ply"), "unknown ending"),
            (self.write_text("empty.vtp", ""), "is empty"),
            (self.write_text("broken.vtp", "<VTKFile type='PolyData'><PolyData>"), "cannot read"),
            (self.write_text("other.vtp", "<VTKFile type='ImageData'/>"), "not a VTK XML file of polygons"),
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

    def test_unwritable_files_are_named(self):
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

    def test_a_cell_out_of_range_is_not_written(self):
        with self.assertRaisesRegex(insideout.Error, "cell 0 refers to point 9 of 8"):
            write_surface(surfaces.box(facets=[(0, 1, 9)]), self.path("box.ply"))


class Writing(InAFolder):
    """What an output's name leads to. TestFaults has what fails meanwhile."""

    def write_all(self):
        """A function for each format, with its name: it writes a file of more than a pipe holds."""
        hull = insideout.tetrahedralize(surfaces.box()).hull
        surfaces.add_array(hull.GetFieldData(), "noise", np.random.default_rng(1).random(20000))
        yield "hull.vtu", lambda path: write_grid(hull, path)
        yield "w.csv", lambda path: insideout.pipeline.write_bytes(b"0123456789abcdef" * 10000, path)
        apart = np.arange(6000) // 12 * 2  # crossings of all with all would take a second to round, and four to check
        points = np.random.default_rng(1).random((6000, 3)) + apart[:, None]
        surface = surfaces.polydata(points, np.arange(6000).reshape(-1, 3))
        for ending in (".vtp", ".ply", ".stl", ".obj", ".off"):
            yield "surface" + ending, lambda path: write_surface(surface, path)
        cells = vtkCellArray()
        cells.SetData(4, numpy_to_vtkIdTypeArray(np.arange(6000), deep=True))
        grid = vtkUnstructuredGrid()
        grid.SetPoints(surface.GetPoints())
        grid.SetCells(VTK_TETRA, cells)
        for ending in (".msh", ".inp", ".mesh", ".xdmf"):
            yield "grid" + ending, lambda path: write_solid(grid, path)

    def content(self, path: str) -> bytes:
        with open(path, "rb") as file:
            return file.read()

    def test_links_stay_and_what_they_lead_to_is_replaced(self):
        os.mkdir(self.path("folder"))
        for name, write in self.write_all():
            with self.subTest(name):
                write(self.path(name))
                whole = self.content(self.path(name))
                target = self.path("folder/" + name)
                os.symlink("folder/" + name, self.path("to-" + name))
                os.symlink(self.path("to-" + name), self.path("to-to-" + name))
                for earlier in (None, b"earlier"):
                    if earlier is not None:
                        with open(target, "wb") as file:
                            file.write(earlier)
                    write(self.path("to-to-" + name))
                    self.assertEqual(os.readlink(self.path("to-" + name)), "folder/" + name)
                    self.assertTrue(os.path.islink(self.path("to-to-" + name)))
                    self.assertFalse(os.path.islink(target))
                    self.assertEqual(self.content(target), whole)
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith(".")], [])

    def test_a_circle_of_links_is_an_error(self):
        os.symlink("b.ply", self.path("a.ply"))
        os.symlink("a.ply", self.path("b.ply"))
        with self.assertRaisesRegex(insideout.Error, "a.ply: Too many levels of symbolic links"):
            write_surface(surfaces.box(), self.path("a.ply"))
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.ply", "b.ply"])

    def test_permissions_are_kept_and_new_files_get_those_of_the_umask(self):
        before = os.umask(0o027)
        self.addCleanup(os.umask, before)
        for name, write in self.write_all():
            with self.subTest(name):
                path = self.path(name)
                write(path)
                self.assertEqual(stat.S_IMODE(os.stat(path).st_mode), 0o640)
                os.chmod(path, 0o604)
                write(path)
                self.assertEqual(stat.S_IMODE(os.stat(path).st_mode), 0o604)

    def test_other_names_of_a_file_keep_what_it_held(self):
        write_surface(surfaces.box(), self.path("box.ply"))
        whole = self.content(self.path("box.ply"))
        os.link(self.path("box.ply"), self.path("other.ply"))
        write_surface(surfaces.two_boxes(), self.path("box.ply"))
        self.assertEqual(self.content(self.path("other.ply")), whole)
        self.assertEqual(read_surface(self.path("box.ply"))[0].GetNumberOfCells(), 24)

    def test_a_pipe_is_written_while_a_thread_reads_it(self):
        for name, write in self.write_all():
            with self.subTest(name):
                write(self.path("whole-" + name))
                os.mkfifo(self.path(name))
                with ThreadPoolExecutor() as pool:
                    read = pool.submit(self.content, self.path(name))
                    write(self.path(name))
                    self.assertEqual(read.result(), self.content(self.path("whole-" + name)))
                self.assertTrue(stat.S_ISFIFO(os.stat(self.path(name)).st_mode))

    def test_a_pipe_without_a_reader_is_an_error(self):
        for name, write in self.write_all():
            with self.subTest(name):
                os.mkfifo(self.path(name))
                reader = os.open(self.path(name), os.O_RDONLY | os.O_NONBLOCK)
                with ThreadPoolExecutor() as pool:
                    # The pipe is full then, and the writer waits until nobody reads any more.
                    pool.submit(lambda: (select.select([reader], [], []), os.close(reader)))
                    with self.assertRaisesRegex(insideout.Error, f"{name}: Broken pipe"):
                        write(self.path(name))

    def test_devices_are_written_in_place(self):
        for name, write in self.write_all():
            with self.subTest(name):
                os.symlink("/dev/null", self.path(name))
                write(self.path(name))
                os.remove(self.path(name))
                os.symlink("/dev/full", self.path(name))
                with self.assertRaisesRegex(insideout.Error, f"{name}: No space left on device"):
                    write(self.path(name))
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_standard_output_goes_on_where_it_is(self):
        program = """import insideout, sys
insideout.write(insideout.tetrahedralize(sys.argv[1]).solid, "/dev/stdout")
print("after")"""
        write_surface(surfaces.box(), self.path("box.ply"))
        with open(self.path("out"), "wb") as file:
            file.write(b"before\n")
            file.flush()
            subprocess.run([sys.executable, "-c", program, self.path("box.ply")], stdout=file, check=True)
        text = self.content(self.path("out"))
        self.assertTrue(text.startswith(b'before\n<?xml version="1.0"?>'))
        self.assertTrue(text.endswith(b"</VTKFile>\n<!-- Written by InsideOut -->\nafter\n"))

    def test_a_limit_of_file_sizes_is_an_error_whatever_its_signal_does(self):
        self.addCleanup(signal.signal, signal.SIGXFSZ, signal.getsignal(signal.SIGXFSZ))
        unlimited = resource.getrlimit(resource.RLIMIT_FSIZE)
        for name, write in self.write_all():
            for action in (signal.SIG_DFL, signal.SIG_IGN):
                with self.subTest(name, action=action):
                    with open(self.path(name), "wb") as file:
                        file.write(b"earlier")
                    signal.signal(signal.SIGXFSZ, action)
                    resource.setrlimit(resource.RLIMIT_FSIZE, (5000, unlimited[1]))
                    try:
                        with self.assertRaisesRegex(insideout.Error, f"{name}: File too large"):
                            write(self.path(name))
                    finally:
                        resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
                    self.assertEqual(self.content(self.path(name)), b"earlier")
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith(".")], [])

    def test_no_memory_is_an_error(self):
        program = """import insideout, numpy as np, resource, surfaces, sys
hull = insideout.tetrahedralize(surfaces.box()).hull
surfaces.add_array(hull.GetFieldData(), "noise", np.random.default_rng(1).random(4000000))
with open("/proc/self/statm") as file:
    used = int(file.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 10000000, resource.RLIM_INFINITY))
try:
    insideout.write(hull, sys.argv[1])
except insideout.Error as error:
    print(error)"""
        path = self.path("hull.vtu")
        done = subprocess.run(
            [sys.executable, "-c", program, path],
            capture_output=True,
            text=True,
            check=False,
            cwd=os.path.dirname(os.path.abspath(__file__)),
            env={**os.environ, "MALLOC_ARENA_MAX": "1", "MALLOC_TRIM_THRESHOLD_": "0"},
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, f"{path}: not enough memory to write it\n")
        self.assertEqual(os.listdir(self.folder), [])

    def test_the_class_says_whether_it_wrote(self):
        writer = vtkSurfaceWriter()
        writer.SetInputData(surfaces.box())
        writer.SetFileName(self.path("box.ply"))
        self.assertEqual(writer.Write(), 1)
        writer.SetFileName(self.path("missing/box.ply"))
        with insideout.pipeline.Messages(writer) as messages:
            self.assertEqual(writer.Write(), 0)
        self.assertEqual(messages.errors, [self.path("missing/box.ply") + ": No such file or directory"])
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, surfaces.box())
        writer.SetInputDataObject(blocks)
        writer.SetFileName(self.path("blocks.ply"))
        with insideout.pipeline.Messages(writer) as messages:
            self.assertEqual(writer.Write(), 0)
        self.assertIn("the input is a vtkMultiBlockDataSet, and a file holds one surface", messages.errors[0])
        self.assertEqual(os.listdir(self.folder), ["box.ply"])


if __name__ == "__main__":
    unittest.main()
