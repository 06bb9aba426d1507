# SPDX-License-Identifier: GPL-3.0-or-later
"""From where pictures see a surface, and what they say of it.

    python3 TestPicture.py
"""

import os
import signal
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np
import surfaces
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import insideout
from insideout.surfaces import make_surface
from insideout.drawing import up_of
from insideout.panels import draw_panels
from insideout.actors import triangles_of
from insideout.view import View

X, Y, Z = np.eye(3)


def box(*size):
    """A box of triangles of this size."""
    points = [(x, y, z) for z in (0, size[2]) for y in (0, size[1]) for x in (0, size[0])]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    return np.array(points, float), np.array(triangles)


def seen(surface, up=None):
    """The axis that runs to the eye, and the one that is up."""
    view = View(triangles_of(make_surface(*surface)), up)
    return view.slice_normal.tolist(), view.up.tolist()


class TestView(unittest.TestCase):
    def test_it_is_seen_from_its_broadest_side(self):
        for size, axis in (((1, 2, 3), 0), ((3, 1, 2), 1), ((2, 1, 3), 1), ((3, 2, 1), 2), ((2, 3, 1), 2)):
            with self.subTest(size=size):
                self.assertEqual(np.argmax(np.abs(seen(box(*size))[0])), axis)

    def test_surfaces_longer_along_z_stand_along_z_and_all_others_along_y(self):
        for size, up in (((1, 1, 2), Z), ((1, 2, 1), Y), ((3, 1, 2), Z), ((1, 0.98, 1), Y)):
            with self.subTest(size=size):
                self.assertEqual(seen(box(*size))[1], up.tolist())

    def test_a_machine_part_stands_on_z_and_a_plate_of_it_is_seen_from_above(self):
        self.assertEqual((up_of("part.STL"), up_of("figure.ply"), up_of(box(1, 1, 1))), ("z", None, None))
        self.assertEqual(seen(box(1, 3, 1), "z")[1], Z.tolist())
        self.assertEqual(seen(box(4, 3, 0.1), "z"), (Z.tolist(), Y.tolist()))
        self.assertEqual(seen(box(3, 4, 0.1), "z"), (Z.tolist(), X.tolist()))
        self.assertEqual(seen(box(4, 3, 2), "z")[1], Z.tolist(), "not flat enough for that")

    def test_the_side_with_more_detail_is_before(self):
        for side in (-1, 1):
            points, triangles = box(1, 4, 4)
            small, more = box(0.1, 0.1, 0.1)
            lump = small + (1 if side > 0 else -0.1, 2, 2)
            surface = (np.vstack([points, lump]), np.vstack([triangles, more + len(points)]))
            self.assertEqual(seen(surface)[0], (side * X).tolist())

    def test_the_outline_counts_and_not_the_box_around_it(self):
        """For a plate with a long pin the boxes around all sides are alike."""
        for plate, pin, axis in (((4, 4, 0.1), (0.1, 0.1, 4), 2), ((0.1, 4, 4), (4, 0.1, 0.1), 0)):
            (points, triangles), (more_points, more) = box(*plate), box(*pin)
            surface = (np.vstack([points, more_points]), np.vstack([triangles, more + len(points)]))
            self.assertEqual(np.argmax(np.abs(seen(surface)[0])), axis)

    def test_any_size_is_seen_alike(self):
        points, triangles = box(1, 2, 3)
        for scale in (1e-150, 1, 1e150):
            self.assertEqual(seen((scale * points, triangles)), seen((points, triangles)))


def box_beside_one_that_is_inside_out():
    """A little apart, so that a tolerance of 0.001 joins them."""
    second = [tuple(corner + 8 for corner in reversed(facet)) for facet in surfaces.BOX_FACETS]
    points = surfaces.box_points() + surfaces.box_points((1.0005, 0, 0))
    return surfaces.polydata(points, [*surfaces.BOX_FACETS, *second])


def description_of(picture):
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    places = [0, 0]
    reader.GetTextChunks("Description", places)
    return [reader.GetTextValue(k) for k in range(*places)]


class InterruptedAtOnce(subprocess.Popen):
    """A program that does not end by itself; the user interrupts before its caller knows of it."""

    begun = []

    def __init__(self, _command, **options):
        super().__init__(["sleep", "1000000"], **options)
        self.begun.append(self.pid)
        signal.raise_signal(signal.SIGINT)


class TestInterruption(unittest.TestCase):
    def test_a_drawing_that_has_just_begun_is_ended(self):
        with mock.patch("subprocess.Popen", InterruptedAtOnce), self.assertRaises(KeyboardInterrupt):
            draw_panels()
        (begun,) = InterruptedAtOnce.begun
        with self.assertRaises(ProcessLookupError):
            os.killpg(begun, signal.SIGKILL)
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)


class TestRow(unittest.TestCase):
    def test_a_whole_row_has_the_boundary_and_slices_too(self):
        with tempfile.TemporaryDirectory() as folder:
            sizes = []
            hull = insideout.tetrahedralize(surfaces.two_boxes()).hull
            for row in (False, True):
                picture = os.path.join(folder, "row.png")
                insideout.draw(surfaces.two_boxes(), hull, picture, row=row)
                reader = vtkPNGReader()
                reader.SetFileName(picture)
                reader.Update()
                width, height, _ = reader.GetOutput().GetDimensions()
                pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
                panels = 5 if row else 3
                seen = [(panel[height // 5 : -height // 5, :, :3].min(axis=2) < 200).mean() for panel in np.split(pixels, panels, axis=1)]
                self.assertGreater(min(seen), 0.02)
                sizes.append(width / panels)
            self.assertEqual(*sizes)


class TestCounts(unittest.TestCase):
    def test_they_are_those_of_the_text_of_the_same_run(self):
        seen = set()
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        with tempfile.TemporaryDirectory() as folder:
            surface, solid, picture = (os.path.join(folder, name) for name in ("boxes.ply", "solid.vtu", "boxes.png"))
            insideout.write(box_beside_one_that_is_inside_out(), surface)
            for options in ((), ("--orientation", "as-given"), ("--merge-tolerance", "0.001")):
                command = [sys.executable, "-m", "insideout", surface, solid, "--plot", picture, *options]
                done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
                self.assertEqual(done.returncode, 0, done.stderr)
                [description] = description_of(picture)
                said = [line.strip() for line in done.stdout.splitlines()]
                for count in description.split("; "):
                    self.assertIn(count, said, options)
                seen.add(description)
        self.assertEqual(len(seen), 3, seen)


if __name__ == "__main__":
    unittest.main()
