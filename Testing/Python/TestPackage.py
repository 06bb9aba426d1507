# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of `insideout` as a whole: what they take and give, threads, Ctrl-C, types and help."""

import gc
import inspect
import os
import pydoc
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import typing
import unittest
from importlib.util import cache_from_source
from pathlib import Path
from unittest import mock

import insideout
import numpy as np
import surfaces
from insideout.files import write_surface
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

try:
    import meshio
except ImportError:
    meshio = None

QUERY = [(0.25, 0.25, 0.25), (2, 2, 2), (0.75, 0.75, 0.75), (1.25, 1.25, 1.25)]

FUNCTIONS = {
    # name: (call with a surface, type of the result, what makes results comparable)
    "check": (insideout.check, insideout.Check, lambda found: found.findings),
    "resolve": (insideout.resolve, insideout.Resolution, lambda found: found.surface.triangles.tolist()),
    "tetrahedralize": (insideout.tetrahedralize, insideout.Tetrahedralization, lambda found: found.hull.w.tolist()),
    "winding_number": (lambda s: insideout.winding_number(s, QUERY), np.ndarray, lambda found: found.tolist()),
    "inside": (lambda s: insideout.inside(s, QUERY), np.ndarray, lambda found: found.tolist()),
}


def tables(surface: vtkPolyData):
    return surfaces.points_of(surface), surfaces.triangles_of(surface)


def masked(table, row: int):
    mask = np.zeros(table.shape, bool)
    mask[row, 1] = True
    return np.ma.masked_array(table, mask=mask)


def blocks(surface: vtkPolyData) -> vtkMultiBlockDataSet:
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, surface)
    return data


def source_of(data) -> vtkTrivialProducer:
    source = vtkTrivialProducer()
    source.SetOutput(data)
    return source


def missing_file():
    reader = insideout.vtkSurfaceReader()
    reader.SetFileName("missing.ply")
    return reader


def downstream(source) -> vtkCleanPolyData:
    clean = vtkCleanPolyData()
    clean.SetInputConnection(source.GetOutputPort())
    return clean


ARRAYS_OF_UNIT_BOX = (
    [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)],
    [(0, 2, 3), (0, 3, 1), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5), (4, 5, 7), (4, 7, 6)],
)


class Inputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.surface = surfaces.two_boxes()

    def kinds(self):
        points, triangles = tables(self.surface)
        file = os.path.join(self.folder, "boxes.ply")
        write_surface(self.surface, file)
        yield "vtkPolyData", self.surface
        yield "file", file
        yield "arrays", (points, triangles)
        yield "lists", (points.tolist(), triangles.tolist())
        yield "other numbers", (points.astype(np.float32), triangles.astype(np.uint32)[:, ::1])
        if meshio is not None:
            yield "meshio", meshio.Mesh(points, [("triangle", triangles)])
        yield "vertices and faces", types.SimpleNamespace(vertices=points, faces=triangles)
        yield "unmasked", (np.ma.masked_array(points), np.ma.masked_array(triangles, mask=False))
        reader = insideout.vtkSurfaceReader()
        reader.SetFileName(file)
        yield "algorithm", reader
        same = vtkTriangleFilter()
        same.SetInputConnection(reader.GetOutputPort())
        yield "output port", same.GetOutputPort()

    def test_every_function_gives_the_same_for_every_kind_of_surface(self):
        for name, (function, result_type, essence) in FUNCTIONS.items():
            expected = essence(function(self.surface))
            for kind, surface in self.kinds():
                with self.subTest(function=name, kind=kind):
                    result = function(surface)
                    self.assertIs(type(result), result_type)
                    self.assertEqual(essence(result), expected)

    def test_inputs_other_than_surfaces_are_one_line_that_says_what_to_do(self):
        points, triangles = tables(self.surface)
        for surface, expected in (
            (None, "NoneType; it can be a vtkPolyData"),
            (vtkUnstructuredGrid(), "it can be a vtkPolyData"),
            ((points, triangles, triangles), "it can be a vtkPolyData"),
            ((points[:, :2], triangles), "points has 2 columns; it must have 3"),
            ((points, triangles[:, :2]), "triangles has 2 columns"),
            ((points, triangles[0]), "triangles has 1 dimensions"),
            ((points, triangles + 0.5), "not whole numbers"),
            ((points, "triangles"), "not a table of numbers"),
            ((points, [[0, 1, 2], [3, 4]]), "not a table of numbers"),
            ((points, triangles + 1), "refers to point 16 of 16"),
            ((points, triangles[:0]), "empty"),
            ("missing.ply", "cannot read missing.ply"),
            ((masked(points, 5), triangles), "points is masked in row 5"),
            ((points, masked(triangles, 3)), "triangles is masked in row 3"),
            ((points + 0j, triangles), "points holds complex numbers"),
            ((points, triangles + 0j), "triangles holds complex numbers"),
            (types.SimpleNamespace(vertices=points[:, :2], faces=triangles), "vertices has 2 columns"),
            (types.SimpleNamespace(vertices=points, faces=masked(triangles, 0)), "faces is masked in row 0"),
            (blocks(self.surface), "the surface is a vtkMultiBlockDataSet, which has blocks: give one of them"),
            (source_of(blocks(self.surface)), "the output of the vtkTrivialProducer is a vtkMultiBlockDataSet, which has blocks"),
            (source_of(vtkUnstructuredGrid()), "the output of the vtkTrivialProducer is a vtkUnstructuredGrid; it must be"),
            (missing_file(), "missing.ply"),
            (vtkCleanPolyData(), "vtkCleanPolyData.* has 0 connections"),
            (downstream(missing_file()), "missing.ply"),
            (insideout.vtkSurfaceWriter(), "vtkSurfaceWriter, which has no output"),
        ):
            for name, (function, _, _) in FUNCTIONS.items():
                with self.subTest(function=name, expected=expected):
                    with self.assertRaisesRegex(insideout.Error, expected) as caught:
                        function(surface)
                    self.assertNotIn("\n", str(caught.exception))

    def test_bad_queries_and_parameters(self):
        for points in ([1, 2], 3, [(1, 2)], "here", None, [(1j, 0, 0)], masked(np.zeros((4, 3)), 2), blocks(self.surface)):
            with self.subTest(points), self.assertRaisesRegex(insideout.Error, "points"):
                insideout.winding_number(self.surface, points)
        for parameters in ({"orientation": "sideways"}, {"merge_tolerance": -1}, {"threshold": float("nan")}):
            with self.subTest(parameters), self.assertRaisesRegex(insideout.Error, next(iter(parameters))):
                insideout.inside(self.surface, QUERY, **parameters)

    def test_points_may_be_those_of_a_data_set_and_none(self):
        image = vtkImageData()
        image.SetDimensions(2, 2, 2)
        image.SetOrigin(0.75, 0.75, 0.75)
        image.SetSpacing(0.5, 0.5, 0.5)
        self.assertEqual(insideout.winding_number(self.surface, image).tolist(), [2, 1, 1, 1, 1, 1, 1, 1])
        self.assertEqual(insideout.inside(self.surface, []).tolist(), [])

    def test_winding_numbers_and_inside(self):
        self.assertEqual(insideout.winding_number(self.surface, QUERY).tolist(), [1, 0, 2, 1])
        self.assertEqual(insideout.winding_number(self.surface, QUERY, orientation="reverse").tolist(), [-1, 0, -2, -1])
        self.assertEqual(insideout.inside(self.surface, QUERY).tolist(), [True, False, True, True])
        self.assertEqual(insideout.inside(self.surface, QUERY, threshold=1.5).tolist(), [False, False, True, False])

    def test_distances_are_negative_inside(self):
        points, triangles = ARRAYS_OF_UNIT_BOX
        distance = insideout.distance((points, triangles), [(0.5, 0.5, 0.25), (2, 0.5, 0.5), (1, 0.5, 0.5), (np.nan, 0, 0)])
        self.assertEqual(distance[:3].tolist(), [-0.25, 1, 0])
        self.assertTrue(np.isnan(distance[3]))
        self.assertEqual(insideout.distance((points, triangles), [(1, 1, 0.5)], scale=2).tolist(), [-0.5])

    def test_voxels_are_those_whose_centres_are_inside(self):
        points, triangles = ARRAYS_OF_UNIT_BOX
        for spacing in (0.25, 0.3, (0.5, 0.2, 0.1)):
            inside, origin = insideout.voxels((points, triangles), spacing)
            self.assertEqual(inside.dtype, bool)
            centres = origin + np.stack(np.indices(inside.shape), axis=-1) * spacing
            expected = np.all((centres > 0) & (centres < 1), axis=-1)
            np.testing.assert_array_equal(inside, expected)
            half = np.broadcast_to(spacing, 3) / 2
            self.assertTrue(np.all(origin - half <= 1e-15) and np.all(centres[-1, -1, -1] + half >= 1 - 1e-15))
        slanted = np.array(points) @ np.array([[1, 0.5, 0], [0, 1, 0], [0, 0.25, 1]])
        inside, origin = insideout.voxels((slanted, triangles), 0.1, scale=2)
        centres = origin + np.stack(np.indices(inside.shape), axis=-1) * 0.1
        queried = insideout.inside((slanted, triangles), centres.reshape(-1, 3), scale=2)
        np.testing.assert_array_equal(inside.ravel(), queried)
        for bad in (0, -1, "wide", (1, 2), float("nan"), 1e-9):
            with self.subTest(bad), self.assertRaisesRegex(insideout.Error, "spacing"):
                insideout.voxels((points, triangles), bad)
        with self.assertRaisesRegex(insideout.Error, "not finite"):
            insideout.voxels((np.array(points) * [1, 1, np.inf], triangles), 0.1)

    def test_resolve_leaves_no_crossings(self):
        resolved = insideout.resolve(self.surface)
        self.assertEqual(insideout.check(resolved.surface).statistics["IntersectingPairs"], 0)
        self.assertGreater(insideout.check(self.surface).statistics["IntersectingPairs"], 0)
        self.assertEqual(resolved.left_out_cells, [])


class Views(unittest.TestCase):
    def test_results_are_vtk_objects_with_views_of_their_memory(self):
        result = insideout.tetrahedralize(surfaces.two_boxes())
        hull, boundary = result.hull, result.boundary
        self.assertIsInstance(hull, vtkUnstructuredGrid)
        self.assertIsInstance(boundary, vtkPolyData)
        self.assertEqual((hull.points.shape[1], hull.cells.shape), (3, (hull.GetNumberOfCells(), 4)))
        self.assertEqual(hull.w.tolist(), hull.cell_arrays["w"].tolist())
        self.assertEqual(hull.inside.sum(), len(result.solid.cells))
        self.assertEqual(boundary.triangles.shape, (boundary.GetNumberOfCells(), 3))
        self.assertIn("vtkOriginalPointIds", boundary.point_arrays)
        hull.w[0] = 7
        self.assertEqual(hull.GetCellData().GetArray("w").GetValue(0), 7)

    def test_views_outlive_what_they_show(self):
        result = insideout.tetrahedralize(surfaces.box())
        points, copy = result.hull.points, result.hull.points.copy()
        del result
        gc.collect()
        insideout.tetrahedralize(surfaces.box(size=2))
        self.assertEqual(points.tolist(), copy.tolist())

    def test_empty_ones_have_views(self):
        result = insideout.tetrahedralize(surfaces.box())
        self.assertEqual((result.outliers.points.shape, result.outliers.triangles.shape), ((0, 3), (0, 3)))

    def test_they_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            result = insideout.tetrahedralize(surfaces.box())
            insideout.write(result.solid, os.path.join(folder, "solid.vtu"))
            insideout.write(result.boundary, os.path.join(folder, "boundary.ply"))
            with self.assertRaisesRegex(insideout.Error, "unknown ending"):
                insideout.write(result.boundary, os.path.join(folder, "boundary.vtu"))
            self.assertEqual(len(os.listdir(folder)), 2)


@unittest.skipIf(meshio is None, "meshio is not installed")
class Meshio(unittest.TestCase):
    def test_there_and_back(self):
        points, triangles = tables(surfaces.box())
        mesh = meshio.Mesh(
            points,
            [("line", [[0, 1]]), ("triangle", triangles)],
            point_data={"height": points[:, 2]},
            cell_data={"part": [np.array([9]), np.arange(12)]},
        )
        result = insideout.tetrahedralize(mesh)
        self.assertEqual(result.warnings, ["1 cells of the meshio.Mesh are ignored: only polygons count"])
        back = result.boundary.to_meshio()
        self.assertIsInstance(back, meshio.Mesh)
        self.assertEqual(back.point_data["height"].tolist(), back.points[:, 2].tolist())
        self.assertEqual(sorted(back.cell_data["part"][0]), list(range(12)))
        solid = result.solid.to_meshio()
        self.assertEqual(solid.cells[0].type, "tetra")
        self.assertEqual(len(solid.cells[0].data), len(result.solid.cells))

    def test_quads_will_do_and_no_polygons_will_not(self):
        quads = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5), (3, 0, 4, 7)]
        points = surfaces.points_of(surfaces.box())
        self.assertEqual(insideout.winding_number(meshio.Mesh(points, [("quad", quads)]), QUERY[:1]).tolist(), [1])
        with self.assertRaisesRegex(insideout.Error, "no triangles"):
            insideout.check(meshio.Mesh(points, [("line", [[0, 1]])]))


class Threads(unittest.TestCase):
    """With a program in TetGen's place that ends only when something else goes on meanwhile."""

    def stand_in(self, script: str) -> str:
        """A shell script in TetGen's place; returns the folder that it works in."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        helper = os.path.join(folder.name, "helper")
        with open(helper, "w", encoding="utf-8") as file:
            file.write(f"#!/bin/sh\ncd '{folder.name}'\n{script}\n")
        os.chmod(helper, 0o700)
        patch = mock.patch.dict(os.environ, INSIDEOUT_TETGEN=helper)
        patch.start()
        self.addCleanup(patch.stop)
        return folder.name

    def check_that_it_ended_by_itself(self, result):
        warnings = " ".join(result.warnings)
        self.assertIn("exited with status 1", warnings)
        self.assertNotIn("took more than", warnings)

    def test_other_threads_run_meanwhile(self):
        folder = self.stand_in("echo >started; until [ -e go ]; do sleep 0.01; done; exit 1")

        def answer():
            while not os.path.exists(os.path.join(folder, "started")):
                time.sleep(0.01)
            with open(os.path.join(folder, "go"), "w", encoding="utf-8"):
                pass

        answering = threading.Thread(target=answer)
        answering.start()
        self.check_that_it_ended_by_itself(insideout.tetrahedralize(surfaces.box(), engine="tetgen", time_budget=6000))
        answering.join()

    def test_three_work_at_once(self):
        self.stand_in("echo >$$.running; until [ $(ls *.running | wc -l) -ge 3 ]; do sleep 0.01; done; exit 1")
        results = []

        def work():
            results.append(insideout.tetrahedralize(surfaces.box(), engine="tetgen", time_budget=6000))

        threads = [threading.Thread(target=work) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 3)
        for result in results:
            self.check_that_it_ended_by_itself(result)

    def test_a_progress_callback_in_a_thread_stops_that_thread_alone(self):
        caught = []

        def stop(_stage, fraction):
            if fraction > 0.5:
                raise ArithmeticError("mine")

        def work():
            try:
                insideout.tetrahedralize(surfaces.box(), progress=stop)
            except ArithmeticError as error:
                caught.append(str(error))

        thread = threading.Thread(target=work)
        thread.start()
        self.assertEqual(insideout.winding_number(surfaces.box(), QUERY).tolist(), [1, 0, 1, 0])
        thread.join()
        self.assertEqual(caught, ["mine"])


class Together(unittest.TestCase):
    def test_results_in_threads_are_those_of_one_after_the_other(self):
        given = [surfaces.two_boxes(), surfaces.open_box(), surfaces.two_boxes_and_a_stray_facet()]
        expected = [insideout.tetrahedralize(surface).hull.w.tobytes() for surface in given]
        found: dict[int, set] = {k: set() for k in range(len(given))}

        def work(k):
            for _ in range(10):
                found[k].add(insideout.tetrahedralize(given[k]).hull.w.tobytes())

        threads = [threading.Thread(target=work, args=[k]) for k in found for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, {k: {w} for k, w in enumerate(expected)})

    def test_observers_in_python_are_heard_too(self):
        heard = []
        algorithm = insideout.vtkRobustTetrahedralize()
        algorithm.SetInputData(surfaces.box())
        algorithm.AddObserver("ProgressEvent", lambda *_: heard.append(algorithm.GetProgress()))
        self.assertEqual(insideout.pipeline.run(algorithm), [])
        self.assertGreater(len(heard), 3)


class CtrlC(unittest.TestCase):
    def test_every_function_stops_at_the_report_at_which_it_comes(self):
        ball = vtkSphereSource()
        ball.SetThetaResolution(100)
        ball.SetPhiResolution(100)
        ball.SetEndPhi(170)
        ball.Update()
        surface, points = ball.GetOutput(), [(k / 20_000, 0, 0) for k in range(20_000)]
        hear = insideout.pipeline._Listener._hear
        for name, call in {
            "tetrahedralize": lambda: insideout.tetrahedralize(surface),
            "resolve": lambda: insideout.resolve(surface),
            "check": lambda: insideout.check(surface),
            "winding_number": lambda: insideout.winding_number(surface, points),
        }.items():
            reports = []

            def interrupted(listener, event, stage, fraction):
                if stage:  # VTK says when it begins and ends, without one
                    reports.append(stage)
                    if len(reports) == 1:
                        signal.raise_signal(signal.SIGINT)
                return hear(listener, event, stage, fraction)

            with self.subTest(name), mock.patch.object(insideout.pipeline._Listener, "_hear", interrupted):
                with self.assertRaises(KeyboardInterrupt):
                    call()
                self.assertEqual(len(reports), 1)


class Package(unittest.TestCase):
    def public(self):
        for name in insideout.__all__:
            if not name.startswith(("vtk", "_")):
                yield name, getattr(insideout, name)

    def test_to_import_it_takes_no_module_of_vtk_but_those_that_the_classes_need(self):
        modules = Path(__file__).parents[2].joinpath("vtk.module").read_text().partition("DEPENDS")[2].partition("TEST_DEPENDS")[0]
        needed = [f"import vtkmodules.vtk{name}" for name in re.findall(r"^  VTK::(\w+)$", modules, re.MULTILINE)]

        def loaded(statements: str) -> set[str]:
            code = f"{statements}\nimport sys\nprint(*(name for name in sys.modules if name.startswith('vtkmodules.vtk')))"
            return set(subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.split())

        self.assertIn("vtkmodules.vtkFiltersCore", loaded("import insideout"))
        self.assertEqual(loaded("import insideout") - loaded("\n".join(needed)), set())

    def test_to_import_it_takes_nothing_of_networks(self):
        code = "import sys, insideout; sys.exit('urllib.request' in sys.modules)"
        self.assertEqual(subprocess.run([sys.executable, "-c", code], check=False).returncode, 0)

    def test_the_build_has_compiled_every_module(self):
        modules = list(Path(insideout.__file__).parent.rglob("*.py"))
        self.assertIn("options.py", [module.name for module in modules])
        self.assertEqual([module for module in modules if not Path(cache_from_source(str(module))).exists()], [])

    def test_every_public_name_is_documented(self):
        for name, thing in self.public():
            with self.subTest(name):
                self.assertTrue(inspect.getdoc(thing))
                self.assertNotIn("(*args", inspect.getdoc(thing))

    def test_every_parameter_and_result_has_a_type_and_stands_in_the_help(self):
        for name, thing in self.public():
            if isinstance(thing, types.FunctionType):
                with self.subTest(name):
                    hints = typing.get_type_hints(thing)
                    self.assertEqual(set(hints), {*inspect.signature(thing).parameters, "return"})
                    for parameter in inspect.signature(thing).parameters:
                        if name != "inside" or parameter == "threshold":
                            self.assertRegex(thing.__doc__, rf"\n    {parameter}  ")

    def test_the_help_names_all_functions_and_its_code_runs(self):
        page = pydoc.render_doc(insideout, renderer=pydoc.plaintext)
        for name, thing in self.public():
            if isinstance(thing, types.FunctionType):
                self.assertIn(f"insideout.{name}(", insideout.__doc__)
                self.assertIn(f"{name}(", page)

    def test_type_checkers_agree(self):
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not installed")
        folder = os.path.dirname(insideout.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        with tempfile.TemporaryDirectory() as cache:
            done = subprocess.run(
                ["mypy", "--cache-dir", cache, "--ignore-missing-imports", "--disallow-untyped-defs", "--warn-unused-ignores", folder],
                capture_output=True,
                text=True,
                check=False,
            )
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
