# SPDX-License-Identifier: GPL-3.0-or-later
"""What pictures of defects show, by their actors, colors and words; and the file with the same.

    python3 TestDraw.py
"""

import itertools
import os
import tempfile
import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine, run_here
from insideout import actors, demo, legend
from insideout.actors import triangles_of
from insideout.files import read_surface
from insideout.marked import with_lines
from insideout.scenes import LINES, curve_panel, defect_panels, surface_panel
from insideout.stages import CHECK, TETRAHEDRALIZE
from insideout.view import View
from insideout.worst import worst_places
from vtkmodules import vtkCommonCore as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

# Machado, Oliveira and Fernandes (2009): what is left of linear red, green and blue without one kind of cones.
COLOR_BLIND = {
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}
TOLD_APART = 10  # CIELAB: 2 is just seen side by side


def lab(linear):
    """CIELAB of linear sRGB."""
    xyz = np.array(((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))) @ np.clip(linear, 0, 1)
    share = xyz / (0.9505, 1.0, 1.089)
    f = np.where(share > 0.008856, np.cbrt(share), 7.787 * share + 16 / 116)
    return np.array((116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])))


def linear(colour):
    c = np.array(colour)
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def colour_of(prop):
    return tuple(round(part, 6) for part in prop.GetProperty().GetColor())


def actors_in(props, colour):
    return [prop for prop in props if prop.IsA("vtkActor") and colour_of(prop) == colour]


def drawn(props):
    """The cells of each color."""
    return {colour_of(prop): prop.GetMapper().GetInput() for prop in props if prop.IsA("vtkActor")}


def texts(props):
    return [prop.GetInput() for prop in props if prop.IsA("vtkTextActor")]


def letters(props):
    return {prop.GetInput() for prop in props if prop.IsA("vtkBillboardTextActor3D")}


def swatches(props):
    return [colour_of(prop) for prop in props if prop.GetClassName().endswith("Actor2D")]


def panels_of(surface):
    checked = insideout.check(surface)
    marked = triangles_of(checked.surface)
    view = View(marked)
    return checked, defect_panels(marked, checked.lines, checked.statistics, view)


def box_with_a_stray_fin():
    """A box, and a triangle on one of its edges: that has three facets. It lacks a facet of the lid."""
    points = [*surfaces.box_points(), (0.5, -1, 0)]
    return surfaces.polydata(points, [*surfaces.BOX_FACETS[:2], *surfaces.BOX_FACETS[3:], (0, 1, 8)])


class Panels(unittest.TestCase):
    def test_on_large_facets_the_curves_are_drawn_over_a_light_shade(self):
        _, panels = panels_of(demo.bracket())
        for panel in panels[:2]:
            found = drawn(panel.props)
            self.assertGreater(found[actors.CROSSING_FACETS].GetNumberOfPolys(), 0)
            self.assertGreater(found[actors.CROSSING].GetNumberOfLines(), 0)
            self.assertEqual(found[actors.CROSSING].GetNumberOfPolys(), 0)
            (curves,) = actors_in(panel.props, actors.CROSSING)
            factor, units = vtk.reference(0.0), vtk.reference(0.0)
            curves.GetMapper().GetRelativeCoincidentTopologyLineOffsetParameters(factor, units)
            self.assertLess((float(factor), float(units)), (0, 0), "nearer than the facets")

    def test_lines_behind_facets_are_seen_faintly(self):
        _, panels = panels_of(demo.bracket())
        for panel in panels[:2]:
            for colour in (actors.OPEN, actors.CROSSING):
                (over,) = actors_in(panel.over, colour)
                self.assertLess(over.GetProperty().GetOpacity(), 0.5)

    def test_each_kind_has_its_color(self):
        _, panels = panels_of(demo.figure())
        found = drawn(panels[0].props)
        self.assertEqual(set(found), {actors.SOUND, actors.CROSSING_FACETS, actors.DUPLICATE, actors.CROSSING, actors.OPEN})
        self.assertEqual(found[actors.DUPLICATE].GetNumberOfPolys(), 80)
        found = drawn(panels_of(demo.inverted())[1][0].props)
        self.assertEqual(found[actors.TURNED].GetNumberOfPolys(), 440)
        found = drawn(panels_of(box_with_a_stray_fin())[1][0].props)
        self.assertEqual(found[actors.NON_MANIFOLD].GetNumberOfLines(), 1)
        inconsistent = surfaces.box(facets=[surfaces.BOX_FACETS[0][::-1], *surfaces.BOX_FACETS[1:]])
        found = drawn(panels_of(inconsistent)[1][0].props)
        self.assertGreater(found[actors.INCONSISTENT].GetNumberOfLines(), 0)

    def test_they_are_those_of_the_marked_surface(self):
        def as_bytes(colour):
            return tuple(round(255 * part) for part in colour)

        for surface in (demo.figure(), demo.inverted(), box_with_a_stray_fin(), surfaces.box(facets=[surfaces.BOX_FACETS[0][::-1], *surfaces.BOX_FACETS[1:]])):
            checked = insideout.check(surface)
            kinds = vtk_to_numpy(checked.lines.GetCellData().GetArray("DefectType"))
            found = vtk_to_numpy(checked.lines.GetCellData().GetArray("DefectColor"))
            for kind, colour in LINES:
                self.assertLessEqual(set(map(tuple, found[kinds == kind].tolist())), {as_bytes(colour)})
            for name, colour in (("SelfIntersections", actors.CROSSING_FACETS), ("Turned", actors.TURNED)):
                marked = vtk_to_numpy(checked.surface.GetCellData().GetArray(name)) > 0
                found = vtk_to_numpy(checked.surface.GetCellData().GetArray("DefectColor"))[marked]
                self.assertLessEqual(set(map(tuple, found.tolist())), {as_bytes(colour)})

    def test_color_blind_readers_tell_the_colors_apart(self):
        colours = [*set(legend.DRAWN.values()), actors.SOUND]
        for name, matrix in COLOR_BLIND.items():
            for one, other in itertools.combinations(colours, 2):
                seen = [lab(np.array(matrix) @ linear(colour)) for colour in (one, other)]
                self.assertGreater(np.linalg.norm(seen[0] - seen[1]), TOLD_APART, (name, one, other))

    def test_the_legend_has_each_count_beside_its_color(self):
        checked, panels = panels_of(demo.figure())
        told = texts(panels[2].props)
        for finding in checked.findings:
            self.assertIn(finding.text, told)
        self.assertIn(checked.verdict, " ".join(told))
        for colour in (actors.OPEN, actors.CROSSING, actors.DUPLICATE):
            self.assertIn(colour, swatches(panels[2].props))

    def test_a_sound_surface_has_nothing_wrong(self):
        _, panels = panels_of(surfaces.box())
        self.assertEqual(set(drawn(panels[0].props)), {actors.SOUND})
        self.assertEqual(panels[0].over, [])
        self.assertIn("nothing wrong", texts(panels[2].props))
        self.assertNotIn("The worst places", texts(panels[2].props))

    def test_the_longest_legend_fits_its_panel(self):
        checked = insideout.check(demo.figure())
        statistics = {**checked.statistics, **{defect.statistic: 1 for defect in legend.DEFECTS}}
        places = 5 * worst_places(triangles_of(checked.surface), checked.lines)[:1]
        for prop in legend.whole_legend(statistics, places):
            if prop.IsA("vtkTextActor"):
                self.assertTrue(0 < prop.GetPosition()[1] < 1, prop.GetInput())

    def test_beside_a_hull_the_first_counts_are_beneath(self):
        checked = insideout.check(demo.figure())
        panel = surface_panel(triangles_of(checked.surface), checked.lines, checked.statistics)
        self.assertEqual(texts(panel.props)[1:], ["62 open edges", "295 intersecting pairs", "80 duplicate facets"])

    def outline(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "outline.csv")
            with open(file, "w", encoding="utf-8") as opened:
                opened.write(demo.OUTLINE)
            return read_surface(file)[0]

    def test_a_curve_has_its_defects_as_points(self):
        checked = insideout.check(self.outline())
        found = drawn(curve_panel(checked.surface, checked.lines).props)
        self.assertEqual(found[actors.CROSSING].GetNumberOfVerts(), 2)
        self.assertEqual(found[actors.OPEN].GetNumberOfVerts(), 2)


class WorstPlaces(unittest.TestCase):
    def test_the_longest_hole_is_told_of(self):
        small, large = surfaces.BOX_FACETS[1:], surfaces.BOX_FACETS[2:]
        points = [*surfaces.box_points(), *surfaces.box_points((5, 0, 0))]
        surface = surfaces.polydata(points, [*small, *(tuple(corner + 8 for corner in facet) for facet in large)])
        checked = insideout.check(surface)
        (place,) = worst_places(triangles_of(checked.surface), checked.lines)
        self.assertEqual(place.text, "longest open boundary: 4 edges, 4 long")
        self.assertGreaterEqual(place.point[0], 5)

    def test_the_largest_part_that_faces_the_wrong_way_is_told_of(self):
        checked = insideout.check(demo.inverted())
        (place,) = worst_places(triangles_of(checked.surface), checked.lines)
        self.assertIn("wrong way: area 7.9", place.text)
        self.assertAlmostEqual(np.linalg.norm(place.point - (2.5, 0, 0)), 0.8, 1)

    def test_places_are_labelled_on_the_side_that_shows_them(self):
        checked, panels = panels_of(demo.figure())
        places = worst_places(triangles_of(checked.surface), checked.lines)
        self.assertEqual(len(places), 2)
        self.assertEqual(letters(panels[0].over) | letters(panels[1].over), {"A", "B"})
        _, panels = panels_of(demo.inverted())
        self.assertEqual(sorted(map(len, (letters(panel.over) for panel in panels[:2]))), [0, 1])

    def test_points_are_told_in_the_digits_that_the_size_asks_for(self):
        for scale, where in ((1, "(0, 0.5, 0)"), (1e-6, "(0, 5e-07, 0)"), (1e6, "(0, 5e+05, 0)")):
            points = scale * np.array(surfaces.box_points()) + (1e-15 * scale, 0, 0)
            checked = insideout.check((points, np.array(surfaces.BOX_FACETS[2:])))
            (place,) = worst_places(triangles_of(checked.surface), checked.lines)
            self.assertEqual(sorted(place.where.strip("()").split(", ")), sorted(where.strip("()").split(", ")))


class Marked(CommandLine):
    def test_it_has_facets_and_lines_with_the_arrays_of_both(self):
        checked = insideout.check(demo.figure())
        joined = with_lines(checked)
        facets, lines = checked.surface.GetNumberOfCells(), checked.lines.GetNumberOfCells()
        self.assertEqual(joined.GetNumberOfCells(), facets + lines)
        data = joined.GetCellData()
        for other in (checked.surface.GetCellData(), checked.lines.GetCellData()):
            for k in range(other.GetNumberOfArrays()):
                self.assertTrue(data.HasArray(other.GetAbstractArray(k).GetName()))
        kinds = vtk_to_numpy(data.GetArray("DefectType"))
        self.assertEqual(np.count_nonzero(kinds == -1), facets)
        crossings = vtk_to_numpy(data.GetArray("SelfIntersections"))
        self.assertEqual(crossings.sum(), vtk_to_numpy(checked.surface.GetCellData().GetArray("SelfIntersections")).sum())
        names = [data.GetAbstractArray("DefectName").GetValue(cell) for cell in range(joined.GetNumberOfCells())]
        self.assertEqual({name for name, kind in zip(names, kinds) if kind == -1}, {""})
        self.assertEqual({name for name, kind in zip(names, kinds) if kind == 0}, {"open boundary"})
        self.assertEqual(joined.GetFieldData().GetArray("ShellVolumes").GetNumberOfTuples(), 7)

    def test_the_command_draws_and_marks_without_meshing(self):
        source, picture, marked = self.file("broken.ply", demo.figure()), self.path("wrong.png"), self.path("wrong.vtp")
        done = run_here("draw", source, picture, "--defects", "--marked", marked)
        self.assertEqual(done.returncode, 0, done.stderr)
        for stage in set(TETRAHEDRALIZE) - set(CHECK):
            self.assertNotIn(stage, done.stderr)
        self.assertNotIn("tetrahedra", done.stdout)
        self.assertIn("Wrote picture ", done.stdout)
        self.assertIn("Wrote marked ", done.stdout)
        with open(picture, "rb") as file:
            self.assertIn(b"62 open edges; 295 intersecting pairs", file.read())
        read, warnings = read_surface(marked)
        self.assertEqual((read.GetNumberOfPolys(), warnings), (1954, []))
        self.assertGreater(read.GetNumberOfLines(), 0)
        self.assertEqual(sorted(os.listdir(self.folder)), ["broken.ply", "wrong.png", "wrong.vtp"])

    def test_beside_a_mesh_the_marks_are_written_too(self):
        source, picture, marked = self.file("box.ply", surfaces.open_box()), self.path("box.png"), self.path("box.vtp")
        self.assertEqual(run_here("draw", source, picture, "--marked", marked).returncode, 0)
        self.assertEqual(read_surface(marked)[0].GetNumberOfLines(), 1)

    def test_lines_in_a_plane_are_drawn_without_triangles(self):
        source = self.file("outline.csv", demo.OUTLINE)
        done = run_here("draw", source, self.path("wrong.png"), "--defects", "--marked", self.path("wrong.vtp"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("wrong.png"), "rb") as file:
            self.assertIn(b"2 open ends; 2 intersecting pairs; 2 crossings", file.read())

    def test_options_without_use_are_refused(self):
        source, cells, picture = self.file("box.ply", surfaces.box()), self.path("cells.vtu"), self.path("wrong.png")
        insideout.write(insideout.tetrahedralize(source), cells)
        for arguments, words in (
            ((source, picture, "--defects", "--gamma", "2"), "--defects meshes nothing: it goes without --gamma"),
            ((source, picture, "--defects", "--refine"), "--defects meshes nothing: it goes without --refine"),
            ((cells, picture, "--defects"), f"--defects is about surfaces: it goes without {cells}"),
            ((cells, picture, "--marked", self.path("m.vtp")), f"--marked is about surfaces: it goes without {cells}"),
            ((source, picture, "--marked", self.path("m.ply")), "m.ply: unknown ending, it must be .vtp"),
        ):
            with self.subTest(arguments):
                done = run_here("draw", *arguments)
                self.assertEqual(done.returncode, 2)
                self.assertIn(words, done.stderr)
                self.assertFalse(os.path.exists(picture))

    def test_in_python_a_check_is_drawn_alone(self):
        checked, picture = insideout.check(demo.bracket()), self.path("wrong.png")
        insideout.draw(checked, None, picture)
        with open(picture, "rb") as file:
            drawn_from_check = file.read()
        insideout.draw(demo.bracket(), None, picture)
        with open(picture, "rb") as file:
            self.assertEqual(file.read(), drawn_from_check)
        with self.assertRaisesRegex(insideout.Error, "a Check, which is drawn alone"):
            insideout.draw(checked, insideout.tetrahedralize(surfaces.box()).hull, picture)


if __name__ == "__main__":
    unittest.main()
