# SPDX-License-Identifier: GPL-3.0-or-later
"""The winding number of a surface whose pieces are read one after the other."""

import gc
import os
import tempfile
import unittest

import insideout
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkWeakReference
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOParallelXML import vtkXMLPPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import numpy as np

from insideout.pipeline import run, statistics_of


def ball():
    source = vtkSphereSource()
    source.SetThetaResolution(31)
    source.SetPhiResolution(22)
    source.Update()
    data = source.GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def in_pieces(points, triangles, *ends):
    """Triangles in sequence, each piece with all points."""
    return [(points, part) for part in np.split(triangles, ends)]


def whole(surface, places):
    return insideout.winding_number(surface, places, orientation="as-given", count_duplicates=True)


PLACES = np.random.default_rng(5).uniform(-0.8, 0.8, (2000, 3))


def image():
    places = vtkImageData()
    places.SetDimensions(9, 8, 7)
    places.SetOrigin(-0.61, -0.62, -0.63)
    places.SetSpacing(0.15, 0.17, 0.19)
    return places


class Remembering(list):
    """Makes a surface of its item whenever one is taken, and counts how many there are."""

    def __init__(self, pieces):
        super().__init__(pieces)
        self.made = []
        self.most = 0

    def __getitem__(self, number):
        gc.collect()
        self.most = max(self.most, sum(one.Get() is not None for one in self.made))
        made = insideout.surfaces.make_surface(*super().__getitem__(number))
        reference = vtkWeakReference()
        reference.Set(made.GetPolys())
        self.made.append(reference)
        return made


class TestSurfacePieces(unittest.TestCase):
    def test_give_the_winding_numbers_of_the_whole_bit_by_bit(self):
        points, triangles = ball()
        for kept in (len(triangles), len(triangles) - 300):
            surface = (points, triangles[:kept])
            expected = whole(surface, PLACES)
            self.assertGreater(len(set(expected)), 1)
            for ends in ([], [500], [200, 201, 700]):
                pieces = in_pieces(*surface, *ends)
                np.testing.assert_array_equal(insideout.winding_number_of_pieces(pieces, PLACES), expected)
        self.assertGreater(len(set(expected)), 1000)

    def test_let_one_go_before_the_next_is_read(self):
        pieces = Remembering(in_pieces(*ball(), 300, 600, 900))
        insideout.winding_number_of_pieces(pieces, PLACES)
        self.assertEqual(len(pieces.made), 4)
        self.assertEqual(pieces.most, 0)

    def test_shape_scale_and_a_data_set_are_as_of_the_whole(self):
        points, triangles = ball()
        pieces = in_pieces(points, triangles, 400)
        self.assertEqual(insideout.winding_number_of_pieces(pieces, (0, 0, 0)), 1)
        self.assertEqual(insideout.winding_number_of_pieces(pieces, (0.4, 0, 0), scale=0.5), 0)
        np.testing.assert_array_equal(
            insideout.winding_number_of_pieces(pieces, image()), whole((points, triangles), image())
        )

    def test_an_empty_piece_adds_nothing(self):
        points, triangles = ball()
        pieces = in_pieces(points, triangles, 0, 400, 400)
        self.assertEqual(insideout.winding_number_of_pieces(pieces, (0, 0, 0)), 1)
        with self.assertRaisesRegex(insideout.Error, "no piece of the surface has polygons with an area"):
            insideout.winding_number_of_pieces(in_pieces(points, triangles[:0], 0), (0, 0, 0))

    def test_errors_name_the_culprit(self):
        points, triangles = ball()
        broken = points.copy()
        broken[7] = np.nan
        for pieces, words in (
            ([(points, triangles), "no such file.stl"], "no such file.stl"),
            ([(points, triangles[:9]), (broken, triangles)], "piece 1 of the surface: point 7 is not finite"),
            ([], "it has to be a list of surfaces"),
            ("a.stl", "it has to be a list of surfaces"),
        ):
            with self.assertRaisesRegex(insideout.Error, words):
                insideout.winding_number_of_pieces(pieces, PLACES)

    def test_copies_add_up_and_two_sided_parts_cancel_however_they_are_cut(self):
        points, triangles = ball()
        back = triangles[:, ::-1]
        for all_triangles, expected in ((np.vstack([triangles, triangles]), 2), (np.vstack([triangles, back]), 0)):
            for ends in ([], [len(triangles)], [100, 900]):
                pieces = in_pieces(points, all_triangles, *ends)
                self.assertEqual(insideout.winding_number_of_pieces(pieces, (0, 0, 0)), expected)

    def test_a_degenerate_piece_is_a_warning(self):
        points, triangles = ball()
        with self.assertWarnsRegex(insideout.Warning, "piece 1 of the surface: .*degenerate"):
            w = insideout.winding_number_of_pieces([(points, triangles), (points, [[3, 3, 5]])], (0, 0, 0))
        self.assertEqual(w, 1)

    def test_warnings_name_the_piece(self):
        points, triangles = ball()
        pieces = [(points, triangles[:400]), (points, np.vstack([triangles[400:], [[3, 3, 5]]]))]
        with self.assertWarnsRegex(insideout.Warning, "piece 1 of the surface: .*degenerate"):
            insideout.winding_number_of_pieces(pieces, PLACES)

    def test_can_be_stopped(self):
        class Enough(Exception):
            pass

        def stop(_, fraction):
            if fraction > 0.4:
                raise Enough

        with self.assertRaises(Enough):
            insideout.winding_number_of_pieces(in_pieces(*ball(), 200, 400), PLACES, progress=stop)


class TestPipeline(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        source = vtkSphereSource()  # makes pieces
        source.SetThetaResolution(40)
        writer = vtkXMLPPolyDataWriter()
        writer.SetFileName(os.path.join(folder.name, "ball.pvtp"))
        writer.SetNumberOfPieces(5)
        writer.SetStartPiece(0)
        writer.SetEndPiece(4)
        writer.SetDataModeToBinary()
        writer.SetInputConnection(source.GetOutputPort())
        writer.Write()
        self.reader = vtkXMLPPolyDataReader()
        self.reader.SetFileName(writer.GetFileName())

    def probe(self, connection, pieces=5):
        probe = insideout.vtkProbeWindingNumber()
        probe.SetInputData(image())
        probe.SetSurfaceConnection(connection)
        probe.SetOrientation(probe.AS_GIVEN)
        probe.SetSurfacePieces(pieces)
        return probe

    def test_pieces_of_a_file_come_through_filters_one_by_one(self):
        shift = vtkTransformPolyDataFilter()
        shift.SetTransform(vtkTransform())
        shift.GetTransform().Translate(0.05, 0, 0)
        shift.SetInputConnection(self.reader.GetOutputPort())
        expected = self.probe(shift.GetOutputPort(), 1)
        run(expected)
        sizes = []
        shift.AddObserver("EndEvent", lambda *_: sizes.append(shift.GetOutput().GetNumberOfCells()))
        probe = self.probe(shift.GetOutputPort())
        probe.Update()
        self.assertEqual(len(sizes), 5)
        self.assertLess(max(sizes), 0.3 * sum(sizes))
        for name in ("w", "Inside"):
            np.testing.assert_array_equal(*(vtk_to_numpy(one.GetOutput().GetPointData().GetArray(name)) for one in (probe, expected)))
        self.assertEqual(statistics_of(probe.GetOutput())["SurfacePieces"], 5)
        probe.Update()
        self.assertEqual(len(sizes), 5)  # nothing has changed
        probe.OutputWindingNumberOff()
        probe.Update()
        self.assertEqual(len(sizes), 10)
        self.assertIsNone(probe.GetOutput().GetPointData().GetArray("w"))

    def test_options_that_need_the_whole_surface_are_errors(self):
        for name, value in (("Orientation", 0), ("Orientation", 3), ("MergeTolerance", 0.1), ("Distance", 1), ("Method", 3)):
            probe = self.probe(self.reader.GetOutputPort())
            getattr(probe, "Set" + name)(value)
            with self.assertRaisesRegex(insideout.Error, f"{name}.* needs the whole surface"):
                run(probe)
            self.assertEqual(probe.GetOutput().GetNumberOfPoints(), 0)

    def test_a_source_without_pieces_is_an_error(self):
        self.reader.Update()
        probe = self.probe(self.reader.GetOutputPort())
        probe.SetSurfaceData(self.reader.GetOutput())
        with self.assertRaisesRegex(insideout.Error, "in 5 pieces, and its source makes none"):
            run(probe)


if __name__ == "__main__":
    unittest.main()
