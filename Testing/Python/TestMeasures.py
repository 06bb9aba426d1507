# SPDX-License-Identifier: GPL-3.0-or-later
"""What surfaces, solids and results measure, and their parts; as other packages have them; statistics by groups; pictures."""

import copy
import json
import os
import pickle
import shutil
import subprocess
import sys
import types
import unittest
import warnings
from pathlib import Path
from unittest import mock

import insideout
import numpy as np
import surfaces
from insideout.data import as_type
from insideout.measures import triangles_at_edges
from insideout.plotting import Picture
from insideout.statistics import OTHER
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkUnstructuredGrid

try:
    import pandas
except ImportError:
    pandas = None


def far_boxes():
    """Three that do not touch; one of them, of size 2, in parts that only share places."""
    soup = surfaces.points_of(surfaces.box((9, 0, 0), 2))[surfaces.triangles_of(surfaces.box())].reshape(-1, 3)
    apart = surfaces.polydata(soup, np.arange(36).reshape(-1, 3).tolist())
    return surfaces.joined(surfaces.box(), surfaces.box((3, 0, 0)), apart)


def typed(surface) -> insideout.TriangleSurface:
    return as_type(insideout.TriangleSurface, surface)


class Measures(unittest.TestCase):
    def test_surfaces(self):
        boxes = typed(far_boxes())
        self.assertAlmostEqual(boxes.volume, 10, 12)
        self.assertTrue(boxes.is_watertight)
        self.assertEqual(boxes.components, 3)
        self.assertEqual([round(part.volume, 12) for part in boxes.split()], [1, 1, 8])
        self.assertFalse(typed(surfaces.open_box()).is_watertight)
        self.assertEqual(typed(surfaces.open_box()).components, 1)
        self.assertAlmostEqual(typed(surfaces.reversed_box()).volume, -1, 12)
        empty = insideout.TriangleSurface()
        self.assertEqual((empty.volume, empty.is_watertight, empty.components, empty.split()), (0, False, 0, []))

    def test_solids(self):
        result = insideout.tetrahedralize(far_boxes(), edge_length=0.7)
        for thing in (result, result.solid):
            self.assertAlmostEqual(thing.volume, 10, 10)
            self.assertTrue(thing.is_watertight)
            self.assertEqual(thing.components, 3)
            parts = thing.split()
            self.assertEqual(sorted(round(part.volume, 10) for part in parts), [1, 1, 8])
            self.assertEqual(sum(len(part.cells) for part in parts), len(result.solid.cells))
        self.assertAlmostEqual(result.volume, result.statistics["Volume"], 12)
        self.assertEqual(result.components, result.statistics["Regions"])
        boundary = result.solid.boundary
        self.assertTrue(surfaces.is_watertight(boundary))
        self.assertAlmostEqual(boundary.volume, 10, 10)

    def test_tetrahedra_of_second_order(self):
        solid = insideout.tetrahedralize(surfaces.box(), quadratic_cells=True).solid
        self.assertAlmostEqual(solid.volume, 1, 12)
        self.assertTrue(solid.is_watertight)
        (part,) = solid.split()
        self.assertEqual(part.cells.shape, solid.cells.shape)

    def test_triangles_are_counted_at_edges(self):
        random = np.random.default_rng(0)
        for count, points in ((0, 1), (1, 1), (1, 3), (9, 3), (60, 8), (60, 2**31)):
            triangles = random.integers(0, points, (count, 3))
            found: dict[tuple[int, int], list[int]] = {}
            for start, end in (edge for a, b, c in triangles.tolist() for edge in ((a, b), (b, c), (c, a))):
                if start != end:
                    found.setdefault((min(start, end), max(start, end)), []).append(1 if start < end else -1)
            balance, there = triangles_at_edges(triangles)
            at_edges = [found[edge] for edge in sorted(found)]
            self.assertEqual((balance.tolist(), there.tolist()), ([sum(at) for at in at_edges], [len(at) for at in at_edges]))

    def test_every_result_measures(self):
        surface = surfaces.two_boxes()
        made = insideout.tetrahedralize(surface)
        for result, volume, components in (
            (insideout.check(surface), 2, 2),
            (insideout.resolve(surface), 2, 1),  # where they meet both have the same edges
            (made, 1.875, 1),
            (insideout.tetrahedralize(surface, surface_only=True), 1.875, 1),
            (insideout.boolean([surfaces.box(), surfaces.box((0.5, 0.5, 0.5))]), 1.875, 1),
            (insideout.check_solid(made.solid), 1.875, 1),
            (insideout.refine(made.solid), 1.875, 1),
        ):
            with self.subTest(type(result).__name__):
                self.assertAlmostEqual(result.volume, volume, 12)
                self.assertTrue(result.is_watertight)
                self.assertEqual(result.components, components)
                self.assertAlmostEqual(sum(part.volume for part in result.split()), volume, 12)

    def test_parts_keep_points_arrays_and_names(self):
        boxes = typed(far_boxes())
        surfaces.add_array(boxes.GetCellData(), "Cell", np.arange(36))
        surfaces.add_array(boxes.GetPointData(), "Place", boxes.points)
        last = boxes.split()[-1]
        self.assertEqual(last.cell_arrays["Cell"].tolist(), list(range(24, 36)))
        np.testing.assert_array_equal(last.point_arrays["Place"], last.points)
        solid = insideout.tetrahedralize(far_boxes())
        for part in solid.boundary.split():
            self.assertEqual(part.tag_names, solid.boundary.tag_names)
        self.assertEqual([np.unique(part.cell_arrays["RegionId"]).tolist() for part in solid.split()], [[0], [1], [2]])

    def test_parts_that_touch_in_a_point_or_edge_are_apart(self):
        for low, components in (((1, 1, 1), 2), ((1, 1, 0), 2), ((1, 0, 0), 1)):
            solid = insideout.tetrahedralize(surfaces.joined(surfaces.box(), surfaces.box(low))).solid
            self.assertEqual(solid.components, components)

    def test_in_a_plane_the_volume_is_the_area(self):
        square = surfaces.polydata([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)], [])
        lines = vtkCellArray()
        lines.InsertNextCell(5, (0, 1, 2, 3, 0))
        square.SetLines(lines)
        result = insideout.tetrahedralize(square, dimension=2)
        self.assertAlmostEqual(result.volume, 4, 12)
        self.assertEqual((result.components, len(result.split())), (1, 1))

    def test_cells_without_measures_are_errors(self):
        quads = typed(surfaces.polydata(surfaces.box_points(), [(0, 1, 2, 3)]))
        with self.assertRaisesRegex(insideout.Error, "some cells have not 3 points"):
            quads.volume  # noqa: B018
        strips = vtkPolyData()
        strips.SetPoints(surfaces.box().GetPoints())
        cells = vtkCellArray()
        cells.InsertNextCell(4, (0, 1, 2, 3))
        strips.SetStrips(cells)
        with self.assertRaisesRegex(insideout.Error, "has strips"):
            typed(strips).triangles  # noqa: B018

    def test_a_check_has_views(self):
        check = insideout.check(surfaces.two_boxes())
        self.assertEqual(check.surface.points.shape, (16, 3))
        self.assertEqual(check.surface.triangles.shape, (24, 3))
        self.assertEqual(check.surface.cell_arrays["SelfIntersections"].shape, (24,))
        self.assertGreater(len(check.lines.lines), 0)
        self.assertIn("DefectType", check.lines.cell_arrays)
        again = pickle.loads(pickle.dumps(check))
        np.testing.assert_array_equal(again.surface.triangles, check.surface.triangles)
        self.assertEqual(insideout.check_solid(insideout.tetrahedralize(surfaces.box()).solid).solid.cells.shape[1], 4)


class Points(unittest.TestCase):
    def test_answers_have_the_shape_of_the_points(self):
        surface = surfaces.two_boxes()
        points = np.random.default_rng(1).uniform(-0.5, 2, (2, 3, 4, 3))
        for function in (insideout.winding_number, insideout.inside, insideout.distance):
            rows = function(surface, points.reshape(-1, 3))
            self.assertEqual(rows.shape, (24,))
            for shape in ((2, 3, 4), (24,), (1, 24), (4, 6, 1)):
                found = function(surface, points.reshape(*shape, 3))
                self.assertEqual(found.shape, shape)
                np.testing.assert_array_equal(found, rows.reshape(shape))
            one = function(surface, points[0, 0, 0])
            self.assertEqual((np.shape(one), one), ((), rows[0]))
            self.assertEqual(function(surface, tuple(points[0, 0, 0])), rows[0])
            self.assertEqual(function(surface, np.zeros((5, 0, 3))).shape, (5, 0))
        self.assertTrue(insideout.inside(surface, (0.5, 0.5, 0.5)))


class Packages(unittest.TestCase):
    """PyVista and trimesh are no packages of Debian 12: what stands in for them has the same functions."""

    def stub(self, name: str, **functions):
        module = types.ModuleType(name)
        vars(module).update(functions)
        return mock.patch.dict(sys.modules, {name: module})

    def test_pyvista(self):
        result = insideout.tetrahedralize(surfaces.box())
        with self.stub("pyvista", wrap=lambda data: ("wrapped", data)):
            for thing, kind in ((result, vtkUnstructuredGrid), (result.solid, vtkUnstructuredGrid), (result.boundary, vtkPolyData)):
                word, data = thing.to_pyvista()
                self.assertEqual(word, "wrapped")
                self.assertIs(type(data), kind)
                self.assertTrue(data.GetCellData().HasArray("w") or data.GetCellData().HasArray("BoundaryTag"))

    def test_trimesh(self):
        result = insideout.tetrahedralize(surfaces.box())
        with self.stub("trimesh", Trimesh=types.SimpleNamespace):
            for thing in (result, result.boundary):
                mesh = thing.to_trimesh()
                self.assertFalse(mesh.process)
                np.testing.assert_array_equal(mesh.faces, result.boundary.triangles)
                self.assertAlmostEqual(insideout.tetrahedralize(mesh).volume, 1, 12)

    def test_open3d(self):
        try:
            import open3d
        except ImportError:
            self.skipTest("open3d is not installed")
        result = insideout.tetrahedralize(surfaces.two_boxes())
        for thing in (result, result.boundary):
            mesh = thing.to_open3d()
            self.assertIsInstance(mesh, open3d.geometry.TriangleMesh)
            self.assertTrue(mesh.is_watertight())
            np.testing.assert_array_equal(np.asarray(mesh.vertices), result.boundary.points)
            np.testing.assert_array_equal(np.asarray(mesh.triangles), result.boundary.triangles)
            self.assertAlmostEqual(insideout.tetrahedralize(mesh).volume, 15 / 8, 12)
        with self.assertRaisesRegex(insideout.Error, "the surface is empty"):
            insideout.check(open3d.geometry.TriangleMesh())

    def test_numpy_stl(self):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # its own, of numpy
                import stl
        except ImportError:
            self.skipTest("numpy-stl is not installed")
        result = insideout.tetrahedralize(surfaces.two_boxes())
        for thing in (result, result.boundary):
            mesh = thing.to_stl()
            self.assertIsInstance(mesh, stl.Mesh)
            np.testing.assert_array_equal(mesh.vectors, result.boundary.points[result.boundary.triangles])
            self.assertAlmostEqual(float(mesh.get_mass_properties()[0]), 15 / 8, 6)
            again = insideout.tetrahedralize(mesh)
            self.assertAlmostEqual(again.volume, 15 / 8, 12)
            self.assertEqual(again.statistics["Points"], len(result.boundary.points), "points in one place are one")
            self.assertAlmostEqual(insideout.boolean([mesh, surfaces.box()], "A - B").statistics["Volume"], 7 / 8, 12)
        with self.assertRaisesRegex(insideout.Error, "takes several surfaces"):
            insideout.boolean(mesh)

    def test_objects_that_resemble_meshes_are_errors(self):
        for thing in (types.SimpleNamespace(vertices=1, triangles=2), types.SimpleNamespace(vectors=[[0, 1, 2]], normals=0)):
            with self.assertRaises(insideout.Error):
                insideout.check(thing)

    def test_a_package_that_is_not_there_is_named(self):
        result = insideout.tetrahedralize(surfaces.box())
        for name, called, call in (
            ("pyvista", "pyvista", result.to_pyvista),
            ("trimesh", "trimesh", result.to_trimesh),
            ("open3d", "open3d", result.to_open3d),
            ("stl", "numpy-stl", result.to_stl),
            ("pandas", "pandas", result.statistics.to_pandas),
        ):
            with mock.patch.dict(sys.modules, {name: None}), self.assertRaisesRegex(insideout.Error, f"^{name} is not installed: .*pip install {called}"):
                call()


class Statistics(unittest.TestCase):
    def all(self):
        surface = surfaces.two_boxes()
        made = insideout.tetrahedralize(surface, edge_length=0.5)
        yield insideout.check(surface)
        yield insideout.resolve(surface)
        yield made
        yield insideout.tetrahedralize({"a": surface, "b": surfaces.box((0, 0, 0.2))}, thicken=0.01)
        yield insideout.tetrahedralize(surface, non_manifold="split", separate_overlaps=True, parts_apart=True, refine=True)
        yield insideout.check_solid(made.solid)
        yield insideout.refine(made.solid, surface_treatment="remeshed")
        yield insideout.boolean([surface, surfaces.box()])
        square = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(0, 1, 2)])
        yield insideout.tetrahedralize(square, dimension=2, edge_length=0.3)

    def test_each_figure_is_in_one_group_and_printed_there(self):
        for result in self.all():
            with self.subTest(type(result).__name__):
                statistics = result.statistics
                groups = statistics.groups
                self.assertEqual(list(groups.get(OTHER, {})), [], "name them in a group of insideout/statistics.py")
                self.assertEqual({name: value for group in groups.values() for name, value in group.items()}, statistics)
                printed = str(statistics).splitlines()
                self.assertEqual([line for line in printed if not line.startswith(" ")], list(groups))
                self.assertEqual([line.split()[0] for line in printed if line.startswith(" ")], [name for group in groups.values() for name in group])
                self.assertLess(max(map(len, printed)), 60)

    def test_it_is_a_dict_by_name(self):
        statistics = insideout.check(surfaces.two_boxes()).statistics
        self.assertEqual(statistics["IntersectingPairs"], 18)
        self.assertEqual(json.loads(json.dumps(statistics)), statistics)
        for again in (pickle.loads(pickle.dumps(statistics)), copy.copy(statistics), copy.deepcopy(statistics)):
            self.assertIs(type(again), insideout.Statistics)
            self.assertEqual(again, statistics)

    @unittest.skipIf(pandas is None, "pandas is not installed")
    def test_pandas_has_a_row_for_each_and_a_column_for_each_surface(self):
        both = {"one": insideout.check(surfaces.box()).statistics, "two": insideout.check(surfaces.two_boxes()).statistics}
        table = pandas.DataFrame({name: statistics.to_pandas() for name, statistics in both.items()})
        self.assertEqual(table.shape, (len(both["one"]), 2))
        self.assertEqual(table.loc[("defects", "IntersectingPairs")].tolist(), [0, 18])
        self.assertEqual(table.loc["shells"].loc["Shells", "two"], 2)


# Shows a picture on a display of its own, until the key is pressed that closes VTK's windows.
WINDOW = """
import ctypes, subprocess, threading, time
import insideout, surfaces

def colors():
    return len(set(subprocess.run(["import", "-window", "root", "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout))

grid = insideout.sdf_grid(surfaces.box(), shape=9)
showing = threading.Thread(target=grid.plot)
before = colors()
showing.start()
while showing.is_alive() and colors() < before + 20:
    time.sleep(0.2)
print("shown", flush=True)
x, keys = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
x.XOpenDisplay.restype = ctypes.c_void_p
display = ctypes.c_void_p(x.XOpenDisplay(None))
keys.XTestFakeMotionEvent(display, 0, 200, 200, 0)
for down in (1, 0):
    keys.XTestFakeKeyEvent(display, x.XKeysymToKeycode(display, ord("q")), down, 0)
x.XFlush(display)
showing.join()
print("closed")
"""


class Pictures(unittest.TestCase):
    def setUp(self):
        self.result = insideout.sdf_grid(surfaces.box(), shape=4)

    def test_a_notebook_shows_the_picture(self):
        shown = []
        shell = types.SimpleNamespace(kernel=object())
        ipython = types.ModuleType("IPython")
        ipython.get_ipython = lambda: shell
        ipython.display = types.ModuleType("IPython.display")
        ipython.display.display = shown.append
        with mock.patch.dict(sys.modules, {"IPython": ipython, "IPython.display": ipython.display}):
            self.result.plot()
        (picture,) = shown
        self.assertIsInstance(picture, Picture)
        self.assertEqual(picture._repr_png_(), self.result.png())

    @unittest.skipUnless(shutil.which("xvfb-run") and shutil.which("import"), "nothing to see a window with")
    def test_a_window_shows_the_picture_until_it_is_closed(self):
        done = subprocess.run(
            ["xvfb-run", "-a", "-s", "-noreset -screen 0 1280x1024x24", sys.executable, "-c", WINDOW],
            capture_output=True, text=True, check=False, timeout=300, cwd=Path(__file__).parent,
        )  # fmt: skip
        self.assertEqual(done.stdout.split(), ["shown", "closed"], done.stderr)

    def test_without_notebook_and_window_it_is_an_error(self):
        with mock.patch.dict(os.environ, {"DISPLAY": ""}), self.assertRaisesRegex(insideout.Error, "no notebook and no window"):
            self.result.plot()

    def test_a_display_that_cannot_be_reached_is_an_error(self):
        with mock.patch.dict(os.environ, {"DISPLAY": ":12345"}), self.assertRaisesRegex(insideout.Error, "the window cannot be shown"):
            self.result.plot()


if __name__ == "__main__":
    unittest.main()
