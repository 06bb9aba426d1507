# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as objects: pickled, copied, and shown in a line or as a notebook shows them."""

import copy
import os
import pickle
import unittest
from dataclasses import fields
from html.parser import HTMLParser
from unittest import mock

import insideout
import numpy as np
import surfaces
from insideout.data import as_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkBitArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData

WAYS = {
    "pickle": lambda thing: pickle.loads(pickle.dumps(thing)),
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
}

ATTRIBUTES = (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.FIELD)


def array_content(array):
    kind = (array.GetName(), array.GetDataType(), array.GetNumberOfComponents(), array.GetComponentName(0))
    if isinstance(array, (vtkStringArray, vtkBitArray)):
        return kind, [array.GetValue(k) for k in range(array.GetNumberOfValues())]
    return kind, vtk_to_numpy(array).tobytes()


def cells_content(cells):
    return vtk_to_numpy(cells.GetOffsetsArray()).tolist(), vtk_to_numpy(cells.GetConnectivityArray()).tolist()


def content(data):
    """All that a data set holds, by VTK's own functions."""
    arrays = [data.GetAttributesAsFieldData(kind) for kind in ATTRIBUTES]
    found = [[array_content(one.GetAbstractArray(k)) for k in range(one.GetNumberOfArrays())] for one in arrays]
    found += [one.GetScalars() and one.GetScalars().GetName() for one in (data.GetPointData(), data.GetCellData())]
    if data.GetPoints() is not None:
        found += [data.GetPoints().GetDataType(), array_content(data.GetPoints().GetData())[1]]
    if isinstance(data, vtkPolyData):
        return found + [cells_content(cells) for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips())]
    types = [data.GetCellType(c) for c in range(data.GetNumberOfCells())]
    return found + ([cells_content(data.GetCells()), types] if types else [])


def is_data(value) -> bool:
    return isinstance(value, vtkDataObject)


def results():
    surface = surfaces.two_boxes_and_a_stray_facet()
    surfaces.add_array(surface.GetCellData(), "Colour", np.arange(25, dtype=np.int16))
    names = vtkStringArray()
    names.SetName("Names")
    names.SetNumberOfComponents(2)
    for name in ("left", "right", "", "größer"):
        names.InsertNextValue(name)
    surface.GetFieldData().AddArray(names)
    meshed = insideout.tetrahedralize(surface)
    return [insideout.check(surface), insideout.resolve(surface), meshed, insideout.check_solid(meshed.solid)]


class Copies(unittest.TestCase):
    def expect_same(self, found, expected) -> None:
        self.assertIs(type(found), type(expected))
        self.assertIsNot(found, expected)
        self.assertEqual(content(found), content(expected))

    def test_results_keep_all_that_they_hold(self):
        for result in results():
            for way, again in WAYS.items():
                made = again(result)
                self.assertIs(type(made), type(result))
                for field in fields(result):
                    before, after = getattr(result, field.name), getattr(made, field.name)
                    with self.subTest(result=type(result).__name__, way=way, field=field.name):
                        if not is_data(before):
                            self.assertEqual(after, before)
                        elif way == "copy":
                            self.assertIs(after, before)
                        else:
                            self.expect_same(after, before)

    def test_surfaces_and_tetrahedra_alone(self):
        checked, resolved, made, _ = results()
        for data in (resolved.surface, made.solid, made.boundary, made.outliers, made.hull, insideout.Tetrahedra(), insideout.TriangleSurface()):
            for way, again in WAYS.items():
                with self.subTest(way, data=repr(data)):
                    self.expect_same(again(data), data)

    def test_every_kind_of_array_and_cell(self):
        points = vtkPoints()
        points.SetDataType(VTK_FLOAT)
        for k in range(5):
            points.InsertNextPoint(k / 3, k * k, 1)
        plain = vtkPolyData()
        plain.SetPoints(points)
        for name, ids in (("Verts", [0]), ("Lines", [0, 1]), ("Polys", [0, 1, 2]), ("Strips", [1, 2, 3, 4])):
            cells = vtkCellArray()
            cells.InsertNextCell(len(ids), ids)
            getattr(plain, "Set" + name)(cells)
        for kind in "b B h H i I l L q Q f d".split():
            surfaces.add_array(plain.GetPointData(), kind, np.arange(10).reshape(5, 2).astype(kind))
        plain.GetPointData().SetActiveScalars("f")
        plain.GetPointData().GetArray("d").SetComponentName(0, "east")
        bits = vtkBitArray()
        bits.SetName("Bits")
        for bit in (1, 0, 1):
            bits.InsertNextValue(bit)
        plain.GetFieldData().AddArray(bits)
        surface = as_type(insideout.TriangleSurface, plain)
        for way, again in WAYS.items():
            with self.subTest(way):
                self.expect_same(again(surface), surface)

    def test_a_deep_copy_shares_nothing_and_a_copy_everything(self):
        solid = results()[2].solid
        shallow, deep = copy.copy(solid), copy.deepcopy(solid)
        solid.points[0, 0] = 7
        self.assertEqual(shallow.points[0, 0], 7)
        self.assertNotEqual(deep.points[0, 0], 7)


class Table(HTMLParser):
    """What a notebook makes of a result."""

    def __init__(self, text: str):
        super().__init__()
        self.cells, self.images, self.open = [], [], []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attributes):
        if tag == "img":
            self.images.append(dict(attributes)["src"])
        else:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1:] == ["td"]:
            self.cells.append(data)


class Shown(unittest.TestCase):
    def test_in_one_line(self):
        for result in results():
            self.assertRegex(repr(result), rf"^<{type(result).__name__}: .+>$")
        solid = results()[2].solid
        self.assertEqual(repr(solid), f"<Tetrahedra: {len(solid.points)} points, {len(solid.cells)} cells>")

    def test_as_a_table_with_a_picture(self):
        checked, resolved, made, quality = results()
        for result in (checked, resolved, made, quality):
            with self.subTest(type(result).__name__):
                table = Table(result._repr_html_())
                (image,) = table.images
                self.assertTrue(image.startswith("data:image/png;base64,iVBORw0KGgo"))
        self.assertIn(str(len(made.solid.cells)), Table(made._repr_html_()).cells)
        self.assertIn(checked.verdict, Table(checked._repr_html_()).cells)

    def test_as_a_table_alone_where_nothing_can_be_drawn(self):
        made = results()[2]
        for environment in ({"DISPLAY": "", "PATH": ""}, {"DISPLAY": ":12345"}):
            with self.subTest(environment), mock.patch.dict(os.environ, environment):
                table = Table(made._repr_html_())
                self.assertEqual(table.images, [])
                self.assertIn(str(len(made.solid.cells)), table.cells)

    def test_within_a_time(self):
        made = results()[2]
        with mock.patch("insideout.results.SECONDS_TO_DRAW", 0.0):
            self.assertEqual(Table(made._repr_html_()).images, [])


if __name__ == "__main__":
    unittest.main()
