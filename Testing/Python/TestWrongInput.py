# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever a function is given that is wrong, it raises insideout.Error with one line, and nothing else."""

import decimal
import inspect
import os
import pathlib
import tempfile
import types
import unittest
import warnings
from unittest import mock

import insideout
import numpy as np
import surfaces
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkTable,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource

POINTS, TRIANGLES = surfaces.points_of(surfaces.box()), surfaces.triangles_of(surfaces.box())


class Nasty:
    """Whose every attribute raises something else."""

    @property
    def points(self):
        raise ZeroDivisionError("points")

    @property
    def vertices(self):
        raise KeyError("vertices")

    def __array__(self, *_, **__):
        raise OSError("array")

    def __float__(self):
        raise LookupError("float")

    def __fspath__(self):
        raise ArithmeticError("path")

    def __repr__(self):
        raise AssertionError("repr")


def values(folder: str) -> dict[str, object]:
    """What may be given by mistake."""
    return {**numbers_and_texts(folder), **containers(), **surfaces_and_solids(), **objects()}


def numbers_and_texts(folder: str) -> dict[str, object]:
    text = os.path.join(folder, "text.ply")
    pathlib.Path(text).write_text("no surface\n", encoding="ascii")
    return {
        "None": None,
        "numbers": 3,
        "negative": -1,
        "half": 0.5,
        "nan": float("nan"),
        "infinite": float("inf"),
        "beyond floats": 10**400,
        "beyond int64": 2**64,
        "beyond int32": 2**31,
        "tiny": 5e-324,
        "large": 1e308,
        "decimal": decimal.Decimal("1.5"),
        "complex": 1j,
        "bool": True,
        "empty text": "",
        "text": "sideways",
        "with NUL": "a\0b.ply",
        "two lines": "a\nb",
        "surrogate": "\udc80.ply",
        "missing file": os.path.join(folder, "missing.ply"),
        "missing path": pathlib.Path(folder, "missing.stl"),
        "missing solid": os.path.join(folder, "missing.vtu"),
        "missing seeds": os.path.join(folder, "missing.csv"),
        "missing folder": os.path.join(folder, "no", "picture.png"),
        "unknown ending": os.path.join(folder, "file.xyz"),
        "no ending": os.path.join(folder, "file"),
        "damaged file": text,
        "folder": folder,
        "bytes": b"box.ply",
    }


def containers() -> dict[str, object]:
    return {
        "list": [],
        "tuple": (),
        "dict": {},
        "set": {1, 2},
        "dict of nothing": {"a": None},
        "list of None": [None, None],
        "list of texts": ["a", "b"],
        "three texts": ["a", "b", "c"],
        "nested": [[[[0]]]],
        "ragged": [[0, 1, 2], [3, 4]],
        "object": object(),
        "class": int,
        "module": types,
        "generator": (i for i in range(3)),
        "range": range(3),
        "nasty": Nasty(),
        "list of nasty": [Nasty()],
        "lambda": lambda *_: None,
        "empty array": np.zeros(0),
        "no rows": np.zeros((0, 3)),
        "two columns": np.zeros((4, 2)),
        "one point": np.zeros(3),
        "array of nan": np.full((4, 3), np.nan),
        "array of infinity": np.full((2, 2, 3), -np.inf),
        "five dimensions": np.zeros((1, 2, 1, 2, 3)),
        "array of texts": np.array(["a", "b", "c"]),
        "array of times": np.array(["2020-01-01"] * 3, "M8[D]"),
        "array of objects": np.array([None, object(), 3], object),
        "array of large integers": np.array([[2**64 - 1] * 3], np.uint64),
        "structured array": np.zeros(3, [("x", float), ("y", float)]),
        "masked array": np.ma.masked_array(np.zeros((2, 3)), mask=np.eye(2, 3)),
        "array of no dimension": np.array(1.0),
        "matrix of bool": np.eye(3, dtype=bool),
    }


def surfaces_and_solids() -> dict[str, object]:
    quads = np.array([[0, 1, 2, 3]])
    return {
        "points and nothing": (POINTS, []),
        "pair of None": (None, None),
        "pair of numbers": (1, 2),
        "negative ids": (POINTS, -TRIANGLES),
        "large ids": (POINTS, TRIANGLES + 2**40),
        "huge ids": (POINTS, [[10**30, 1, 2]]),
        "ids of uint64": (POINTS, np.full((1, 3), 2**63, np.uint64)),
        "ids of nan": (POINTS, np.full((2, 3), np.nan)),
        "halves as ids": (POINTS, TRIANGLES + 0.5),
        "points of nan": (np.full((8, 3), np.nan), TRIANGLES),
        "large points": (POINTS * 1e308, TRIANGLES),
        "points of texts": ([["a", "b", "c"]] * 3, [[0, 1, 2]]),
        "tetrahedra as arrays": (POINTS, [[0, 1, 2, 4]]),
        "negative tetrahedra": (POINTS, [[-1, 1, 2, 4]]),
        "large tetrahedra": (POINTS, [[0, 1, 2, 400]]),
        "tetrahedra of nan": (np.full((8, 3), np.nan), [[0, 1, 2, 4]]),
        "flat": (POINTS * [1, 1, 0], TRIANGLES),
        "degenerate": (POINTS * 0, TRIANGLES),
        "like meshio": types.SimpleNamespace(points=1, cells=2, point_data={}, cell_data={}),
        "half like meshio": types.SimpleNamespace(points=POINTS, cells=[types.SimpleNamespace(type=3, data=None)]),
        "meshio without data": types.SimpleNamespace(points=POINTS, cells=[types.SimpleNamespace(type="triangle", data=quads)]),
        "tetrahedra like meshio": types.SimpleNamespace(points=POINTS, cells=[types.SimpleNamespace(type="tetra", data=[1, 2])]),
        "like trimesh": types.SimpleNamespace(vertices=None, faces=None),
        "faces as texts": types.SimpleNamespace(vertices=POINTS, faces="abc"),
    }


def objects() -> dict[str, object]:
    surface, solid = surfaces.box(), RESULT.solid
    return {
        "surface": surface,
        "empty surface": vtkPolyData(),
        "empty grid": vtkUnstructuredGrid(),
        "image": vtkImageData(),
        "table": vtkTable(),
        "blocks": vtkMultiBlockDataSet(),
        "vtkObject": vtkObject(),
        "source": vtkSphereSource(),
        "filter without input": insideout.vtkSurfaceDefects(),
        "port": READER.GetOutputPort(),
        "solid": solid,
        "empty solid": insideout.Tetrahedra(),
        "result": RESULT,
        "check": insideout.check(surface),
        "bodies": {"a": surface, 3: surface},
        "body without a name": {"": surface},
        "two surfaces": [surface, surface],
    }


RESULT = insideout.tetrahedralize(surfaces.box())
READER = insideout.vtkSurfaceReader()


def written(folder: str) -> str:
    """A file that can be read."""
    insideout.write(RESULT, os.path.join(folder, "good.msh"))
    return os.path.join(folder, "good.msh")


GOOD = {
    "boolean": lambda _: {"surfaces": [surfaces.box(), surfaces.box((0.5, 0.5, 0.5))]},
    "check": lambda _: {"surface": surfaces.box()},
    "check_solid": lambda _: {"solid": RESULT.solid},
    "distance": lambda _: {"surface": surfaces.box(), "points": POINTS},
    "draw": lambda folder: {"surface": surfaces.box(), "hull": RESULT.hull, "picture": os.path.join(folder, "draw.png")},
    "draw_quality": lambda folder: {"solid": RESULT.solid, "picture": os.path.join(folder, "draw.png")},
    "inside": lambda _: {"surface": surfaces.box(), "points": POINTS},
    "point_cloud": lambda _: {"points": POINTS, "normals": POINTS},
    "read": lambda folder: {"path": written(folder)},
    "refine": lambda _: {"solid": RESULT.solid},
    "resolve": lambda _: {"surface": surfaces.box()},
    "sdf_grid": lambda _: {"surface": surfaces.box(), "shape": 5},
    "tetrahedralize": lambda _: {"surface": surfaces.box()},
    "voxels": lambda _: {"surface": surfaces.box(), "spacing": 0.5},
    "winding_number": lambda _: {"surface": surfaces.box(), "points": POINTS},
    "winding_number_of_pieces": lambda _: {"pieces": [surfaces.box(), surfaces.box((3, 3, 3))], "points": POINTS},
    "write": lambda folder: {"data": RESULT, "path": os.path.join(folder, "solid.vtu")},
}
"""What each function does well with."""


class WrongInput(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        drawn = mock.patch("insideout.drawing.draw_panels", return_value=b"")  # which takes seconds
        drawn.start()
        self.addCleanup(drawn.stop)

    def expect_error_or_answer(self, function, arguments) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", insideout.Warning)
            try:
                function(**arguments)
            except insideout.Error as error:
                self.assertTrue(str(error))
                self.assertNotIn("\n", str(error))
                self.assertLess(len(str(error)), 500)

    def test_each_function_is_tried(self):
        functions = {name for name in insideout.__all__ if inspect.isfunction(getattr(insideout, name))}
        self.assertEqual(set(GOOD), functions)

    def test_right_arguments_work(self):
        for name, good in GOOD.items():
            getattr(insideout, name)(**good(self.folder))

    def test_nothing_but_an_error_comes_of_anything_in_any_place(self):
        wrong = values(self.folder)
        for name, good in GOOD.items():
            function = getattr(insideout, name)
            for parameter in inspect.signature(function).parameters:
                for kind, value in wrong.items():
                    if parameter == "progress" and callable(value):
                        continue  # what it raises comes out as it is
                    with self.subTest(function=name, parameter=parameter, value=kind):
                        self.expect_error_or_answer(function, {**good(self.folder), parameter: value})


if __name__ == "__main__":
    unittest.main()
