# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions of PyVista's data sets under the name `insideout`.

PyVista is no package of Debian 12. A stand-in implements what is used of it, by the documentation of version 0.48. Its data sets are
VTK's. A failed lookup of an attribute searches the entry points of the group `pyvista.accessors`. It imports the module of the one with
the attribute's name, which registers a class, and looks the attribute up again. PyVista itself was never tried here.

    python3 TestAccessors.py
"""

import contextlib
import importlib
import io
import os
import re
import runpy
import subprocess
import sys
import tempfile
import tomllib
import types
import unittest
import warnings
from importlib.metadata import entry_points
from unittest import mock

import insideout
import numpy as np
import surfaces
from insideout import demo
from insideout.files import write_surface
from insideout.pipeline import strings_of, write_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkUnstructuredGrid

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PROJECT = os.path.join(ROOT, "Filters", "Python", "pyproject.toml")
EXAMPLE = os.path.join(ROOT, "Examples", "Python", "with_pyvista.py")
GROUP = "pyvista.accessors"


class DataSet:
    """Looks accessors up as PyVista does, and has what the example takes."""

    bounds = property(lambda self: self.GetBounds())
    n_points = property(lambda self: self.GetNumberOfPoints())
    n_cells = property(lambda self: self.GetNumberOfCells())

    @property
    def field_data(self):
        return {"Verdict": strings_of(self.GetFieldData().GetAbstractArray("Verdict"))}

    def __getitem__(self, name):
        return vtk_to_numpy(self.GetPointData().GetArray(name)).astype(bool)

    def __setitem__(self, name, values):
        surfaces.add_array(self.GetPointData(), name, values.astype(np.uint8))

    def save(self, path):
        write_data(self, path)

    def __getattr__(self, name):
        for entry in entry_points(group=GROUP):
            if entry.name == name and entry.value not in sys.modules:
                importlib.import_module(entry.value)
                return getattr(self, name)
        raise AttributeError(name)


class PolyData(DataSet, vtkPolyData):
    pass


class UnstructuredGrid(DataSet, vtkUnstructuredGrid):
    pass


class ImageData(DataSet, vtkImageData):
    def __init__(self, dimensions, spacing, origin):
        self.SetDimensions(*(int(count) for count in dimensions))
        self.SetSpacing(*spacing)
        self.SetOrigin(*origin)


def wrap(data):
    wrapped = (PolyData if isinstance(data, vtkPolyData) else UnstructuredGrid)()
    wrapped.ShallowCopy(data)
    return wrapped


def register_dataset_accessor(name, target):
    def register(accessor):
        assert name.isidentifier() and not hasattr(target, name)
        setattr(target, name, property(accessor))
        return accessor

    return register


class Accessors(unittest.TestCase):
    def setUp(self):
        pyvista = types.ModuleType("pyvista")
        vars(pyvista).update(PolyData=PolyData, UnstructuredGrid=UnstructuredGrid, ImageData=ImageData)
        vars(pyvista).update(wrap=wrap, read=lambda path: wrap(insideout.read(path)), register_dataset_accessor=register_dataset_accessor)
        modules = mock.patch.dict(sys.modules, {"pyvista": pyvista})
        modules.start()
        self.addCleanup(modules.stop)
        self.addCleanup(self.forget)
        # The metadata that a wheel has beside the package, as the project declares them.
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        metadata = os.path.join(folder.name, "insideout-0.dist-info")
        os.mkdir(metadata)
        with open(PROJECT, "rb") as file:
            declared = tomllib.load(file)["project"]["entry-points"]
        with open(os.path.join(metadata, "METADATA"), "w", encoding="utf-8") as file:
            file.write("Metadata-Version: 2.1\nName: insideout\nVersion: 0\n")
        with open(os.path.join(metadata, "entry_points.txt"), "w", encoding="utf-8") as file:
            for group, entries in declared.items():
                file.write(f"[{group}]\n" + "".join(f"{name} = {value}\n" for name, value in entries.items()))
        path = mock.patch.object(sys, "path", [folder.name, *sys.path])
        path.start()
        self.addCleanup(path.stop)

    def forget(self):
        sys.modules.pop("insideout.accessors", None)
        for kind in (PolyData, UnstructuredGrid):
            if "insideout" in vars(kind):
                del kind.insideout

    def test_the_entry_point_is_a_module_that_registers_when_it_is_first_used(self):
        self.assertEqual([entry.value for entry in entry_points(group=GROUP)], ["insideout.accessors"])
        self.assertNotIn("insideout.accessors", sys.modules)
        grid = wrap(surfaces.two_boxes()).insideout.tetrahedralize()
        self.assertIn("insideout.accessors", sys.modules)
        self.assertIsInstance(grid, UnstructuredGrid)
        self.assertAlmostEqual(insideout.check_solid(grid).volume, 15 / 8, 12)
        self.assertRaises(AttributeError, lambda: grid.outsidein)

    def test_solids_are_refined_and_checked(self):
        grid = wrap(surfaces.two_boxes()).insideout.tetrahedralize(gamma=0)
        better = grid.insideout.refine(edge_length=0.4)
        self.assertIsInstance(better, UnstructuredGrid)
        self.assertGreater(better.GetNumberOfCells(), grid.GetNumberOfCells())
        checked = better.insideout.check()
        self.assertIsInstance(checked, UnstructuredGrid)
        self.assertEqual(checked.GetNumberOfCells(), better.GetNumberOfCells())

    def test_surfaces_are_repaired_and_joined(self):
        mesh = wrap(surfaces.two_boxes())
        fixed = mesh.insideout.repair()
        self.assertIsInstance(fixed, PolyData)
        self.assertTrue(surfaces.is_watertight(fixed))
        self.assertAlmostEqual(surfaces.enclosed_volume(fixed), 15 / 8, 12)
        for arguments in ((), ("A - B",)):
            rest = mesh.insideout.boolean(wrap(surfaces.box()), *arguments)
            self.assertIsInstance(rest, PolyData)
            self.assertAlmostEqual(surfaces.enclosed_volume(rest), 7 / 8, 12)

    def test_defects_are_marked_and_named(self):
        checked = wrap(surfaces.open_box()).insideout.check()
        self.assertIsInstance(checked, PolyData)
        self.assertGreater(checked.GetNumberOfLines(), 0)
        self.assertTrue(checked.GetCellData().HasArray("DefectColor"))
        said = checked.GetFieldData().GetAbstractArray("Verdict").GetValue(0)
        self.assertEqual(said, insideout.check(surfaces.open_box()).verdict)
        self.assertIn("open edges", checked.GetFieldData().GetAbstractArray("Findings").GetValue(0))

    def test_points_are_inside(self):
        mesh = wrap(surfaces.two_boxes())
        np.testing.assert_array_equal(mesh.insideout.inside([(0.2, 0.2, 0.2), (1.2, 0.2, 0.2), (1.2, 1.2, 1.2)]), [True, False, True])
        image = vtkImageData()
        image.SetDimensions(4, 4, 4)
        image.SetOrigin(0.1, 0.1, 0.1)
        image.SetSpacing(0.4, 0.4, 0.4)
        points = np.array([image.GetPoint(k) for k in range(64)])
        in_one = ((points > 0) & (points < 1)).all(axis=1) | ((points > 0.5) & (points < 1.5)).all(axis=1)
        np.testing.assert_array_equal(mesh.insideout.inside(image), in_one)

    def test_the_example_fills_voxels_and_tetrahedra_of_an_open_scan(self):
        with tempfile.TemporaryDirectory() as folder:
            scan = os.path.join(folder, "scan.ply")
            write_surface(demo.scan(), scan)
            said = io.StringIO()
            with mock.patch.object(sys, "argv", [EXAMPLE, scan, folder]), contextlib.redirect_stdout(said):
                runpy.run_path(EXAMPLE)
            self.assertIn("once its holes are closed", said.getvalue())
            inside, voxels = (int(count.replace(",", "")) for count in re.search("([0-9,]+) of ([0-9,]+) voxels", said.getvalue()).groups())
            low, high = np.reshape(demo.scan().GetBounds(), (3, 2)).T
            volume = insideout.tetrahedralize(scan).volume
            self.assertAlmostEqual(inside * (max(high - low) / 40) ** 3 / volume, 1, delta=0.03)
            self.assertAlmostEqual(insideout.check_solid(os.path.join(folder, "solid.vtu")).volume / volume, 1, 9)
            self.assertTrue(os.path.exists(os.path.join(folder, "voxels.vti")))

    def test_errors_and_warnings_are_those_of_the_functions(self):
        mesh = wrap(surfaces.reversed_box())
        with self.assertRaisesRegex(insideout.Error, "tetrahedralize has no argument gama; the nearest is gamma"):
            mesh.insideout.tetrahedralize(gama=1)
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            mesh.insideout.tetrahedralize()
        self.assertEqual({warning.category for warning in heard}, {insideout.Warning})
        self.assertEqual({warning.filename for warning in heard}, {__file__}, "they point at who called")

    def test_the_package_never_imports_pyvista(self):
        code = "import sys, insideout; sys.exit('pyvista' in sys.modules or 'insideout.accessors' in sys.modules)"
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "pyvista.py"), "w", encoding="utf-8") as file:
                file.write("")
            path = os.pathsep.join([folder, os.environ.get("PYTHONPATH", "")])
            done = subprocess.run([sys.executable, "-c", code], env={**os.environ, "PYTHONPATH": path}, check=False)
        self.assertEqual(done.returncode, 0)

    def test_without_pyvista_it_says_so(self):
        with mock.patch.dict(sys.modules, {"pyvista": None}), self.assertRaisesRegex(insideout.Error, "pyvista is not installed"):
            importlib.import_module("insideout.accessors")


if __name__ == "__main__":
    unittest.main()
