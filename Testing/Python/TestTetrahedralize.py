# SPDX-License-Identifier: GPL-3.0-or-later
"""insideout.tetrahedralize and the filters behind it: laws that results obey, data, and bad input."""

import contextlib
import io
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import insideout
import numpy as np
import surfaces
from insideout.stages import TETRAHEDRALIZE, UNNAMED
from surfaces import cell_array, point_array
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_ID_TYPE, VTK_SHORT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid


@contextlib.contextmanager
def what_is_printed(into: list):
    """Everything that the process writes to its standard output and error, VTK's C++ included."""
    with tempfile.TemporaryFile() as file:
        saved = os.dup(1), os.dup(2)
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            for number, original in enumerate(saved, start=1):
                os.dup2(original, number)
                os.close(original)
            file.seek(0)
            into.append(file.read().decode())


class Laws(unittest.TestCase):
    def check(self, result: insideout.Tetrahedralization, volume: float):
        solid_volumes = surfaces.exact_volumes(result.solid)
        self.assertTrue(all(v > 0 for v in surfaces.exact_volumes(result.hull)), "a cell is not positive")
        self.assertAlmostEqual(float(sum(solid_volumes)), volume, delta=1e-12)
        self.assertTrue(surfaces.is_watertight(result.boundary))
        self.assertAlmostEqual(surfaces.enclosed_volume(result.boundary), volume, delta=1e-12)
        inside = cell_array(result.hull, "Inside")
        self.assertEqual(set(np.unique(inside)) - {0, 1}, set())
        self.assertEqual(inside.sum(), result.solid.GetNumberOfCells())
        counted = result.statistics
        self.assertEqual(counted["InsideCells"], result.solid.GetNumberOfCells())
        self.assertEqual(counted["HullCells"], result.hull.GetNumberOfCells())
        self.assertEqual(counted["BoundaryFaces"], result.boundary.GetNumberOfCells())
        self.assertEqual(counted["OutlierFacets"], result.outliers.GetNumberOfCells())
        self.assertAlmostEqual(counted["Volume"], volume, delta=1e-12)

    def test_mass_properties_are_those_of_a_box(self):
        box = surfaces.box((10, 20, 30), 2)
        for scale in (1, 1e-3):
            points = surfaces.points_of(box) * (1, 2, 3) * scale
            found = insideout.tetrahedralize((points, surfaces.triangles_of(box))).statistics
            mass = 2 * 4 * 6 * scale**3
            self.assertAlmostEqual(found["Volume"] / mass, 1, 14)
            for axis, expected, others in (("X", 11, (4, 6)), ("Y", 42, (2, 6)), ("Z", 93, (2, 4))):
                self.assertAlmostEqual(found["CenterOfMass" + axis] / scale / expected, 1, 14)
                inertia = mass * scale**2 * (others[0] ** 2 + others[1] ** 2) / 12
                self.assertAlmostEqual(found["Inertia" + axis + axis] / inertia, 1, 13)
            for pair in ("XY", "YZ", "XZ"):
                self.assertLess(abs(found["Inertia" + pair]), 1e-12 * found["InertiaXX"])

    def test_mass_properties_do_not_depend_on_the_tetrahedra(self):
        surface = surfaces.two_boxes()
        found = [insideout.tetrahedralize(surface, engine=engine).statistics for engine in ("exact", "tetgen")]
        for name in ("Volume", "CenterOfMassX", "InertiaXX", "InertiaYZ"):
            self.assertAlmostEqual(found[0][name], found[1][name], 12)

    def test_statistics_tell_how_the_solid_hangs_together(self):
        u, v = (angles.ravel() for angles in np.meshgrid(np.arange(12) * np.pi / 6, np.arange(8) * np.pi / 4, indexing="ij"))
        ring = np.array([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)]).T
        corner = [[8 * (i % 12) + j % 8 for j in range(9)] for i in range(13)]
        quads = [(corner[i][j], corner[i + 1][j], corner[i + 1][j + 1], corner[i][j + 1]) for i in range(12) for j in range(8)]
        around = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
        outward, inward = np.array(surfaces.BOX_FACETS), np.array(surfaces.BOX_FACETS)[:, ::-1]

        def two_boxes(low, size, second):
            return np.array(surfaces.box_points() + surfaces.box_points(low, size)), np.vstack([outward, second + 8])

        for surface, components, tunnels, cavities, genus in (
            (surfaces.box(), 1, 0, 0, 0),
            ((ring, around), 1, 1, 0, 1),
            (two_boxes((0.25, 0.25, 0.25), 0.5, inward), 1, 0, 1, 0),
            (two_boxes((5, 0, 0), 1, outward), 2, 0, 0, 0),
            (two_boxes((1, 1, 1), 1, outward), 1, 0, 0, 0),
        ):
            found = insideout.tetrahedralize(surface).statistics
            names = ("SolidComponents", "SolidTunnels", "SolidCavities", "Genus")
            self.assertEqual([found[name] for name in names], [components, tunnels, cavities, genus])
            self.assertEqual(found["SolidEulerCharacteristic"], components - tunnels + cavities)
            self.assertEqual(found["BoundaryCavities"], found["Regions"] + cavities)

    def test_a_box_is_filled(self):
        result = insideout.tetrahedralize(surfaces.box())
        self.check(result, 1)
        self.assertEqual(set(cell_array(result.solid, "w")), {1.0})
        self.assertEqual(result.warnings, [])
        self.assertEqual(result.outliers.GetNumberOfCells(), 0)
        self.assertEqual([result.statistics[name] for name in ("Closed", "OpenEdges", "IntersectingPairs")], [1, 0, 0])

    def test_two_boxes_that_overlap_become_their_union(self):
        result = insideout.tetrahedralize(surfaces.two_boxes())
        self.check(result, 15 / 8)
        volumes = np.array([float(v) for v in surfaces.exact_volumes(result.hull)])
        w = cell_array(result.hull, "w")
        self.assertEqual(set(w), {0.0, 1.0, 2.0})
        self.assertAlmostEqual(volumes[w == 2].sum(), 1 / 8, delta=1e-12)
        self.assertGreater(result.statistics["IntersectingPairs"], 0)

    def test_a_stray_facet_is_kept_when_it_has_to_be(self):
        surface = surfaces.two_boxes_and_a_stray_facet()
        stray = surface.GetNumberOfCells() - 1
        plain = insideout.tetrahedralize(surface)
        self.assertGreater(plain.outliers.GetNumberOfCells(), 0)
        self.assertEqual(plain.statistics["Energy"], plain.statistics["EnergyOfCut"])
        for manifold in ("keep", "fill"):
            kept = insideout.tetrahedralize(surface, constrain_facets=True, non_manifold=manifold)
            self.assertEqual(kept.outliers.GetNumberOfCells(), 0)
            self.assertIn(stray, cell_array(kept.boundary, "vtkOriginalCellIds"))
            self.assertGreater(kept.statistics["ForcedFacets"], 0)
            self.assertGreater(kept.statistics["Energy"], kept.statistics["EnergyOfCut"])
            self.assertTrue(surfaces.is_watertight(kept.boundary))

    def test_an_array_chooses_the_facets_that_are_kept(self):
        surface = surfaces.two_boxes_and_a_stray_facet()
        chosen = np.ones(surface.GetNumberOfCells(), np.uint8)
        surfaces.add_array(surface.GetCellData(), "Keep", chosen)
        self.assertEqual(insideout.tetrahedralize(surface, constrained_facets_array="Keep").outliers.GetNumberOfCells(), 0)
        chosen[-1] = 0
        surfaces.add_array(surface.GetCellData(), "Keep", chosen)
        some = insideout.tetrahedralize(surface, constrained_facets_array="Keep")
        self.assertEqual(set(cell_array(some.outliers, "vtkOriginalCellIds")), {len(chosen) - 1})
        with self.assertRaisesRegex(insideout.Error, "no cell array Kept"):
            insideout.tetrahedralize(surface, constrained_facets_array="Kept")

    def test_seeds_have_their_way(self):
        surface = surfaces.two_boxes()
        plain = insideout.tetrahedralize(surface)
        out = insideout.tetrahedralize(surface, seeds=[((0.2, 0.2, 0.2), False), ((1.1, 1.1, 0.4), True)])
        self.assertEqual(out.warnings, plain.warnings)
        self.assertGreater(out.statistics["Energy"], plain.statistics["Energy"])
        self.assertNotEqual(
            float(sum(surfaces.exact_volumes(out.solid))), float(sum(surfaces.exact_volumes(plain.solid)))
        )
        twice = insideout.tetrahedralize(surface, seeds=[((0.2, 0.2, 0.2), True), ((0.2, 0.2, 0.2), False)])
        self.assertTrue(any("seed 1 is to be outside" in line for line in twice.warnings), twice.warnings)
        self.assertEqual(twice.statistics["SeedConflicts"], 1)
        with self.assertRaisesRegex(insideout.Error, "no point array Inside"):
            insideout.tetrahedralize(surface, seeds=surface)
        with self.assertRaisesRegex(insideout.Error, "seed 1 is not a pair"):
            insideout.tetrahedralize(surface, seeds=[((0, 0, 0), True), (1, 2, 3)])

    def test_a_data_term_is_one_of_two(self):
        weighted = insideout.tetrahedralize(surfaces.two_boxes(), data_term="volume-weighted")
        self.check(weighted, 15 / 8)
        with self.assertRaisesRegex(insideout.Error, "data_term is 'heavy'"):
            insideout.tetrahedralize(surfaces.two_boxes(), data_term="heavy")

    def test_an_open_box_is_closed(self):
        result = insideout.tetrahedralize(surfaces.open_box())
        self.check(result, 1)
        self.assertEqual(result.statistics["OpenEdges"], 4)
        self.assertEqual(result.statistics["Closed"], 0)
        lid = cell_array(result.boundary, "vtkOriginalCellIds") == -1
        self.assertEqual(lid.sum(), 2)
        centres = surfaces.points_of(result.boundary)[surfaces.triangles_of(result.boundary)].mean(axis=1)
        self.assertTrue((centres[lid, 2] == 1).all(), "the faces without an input cell are not the lid")
        # At a point on its axis the open box subtends the sphere less the lid.
        w = cell_array(result.solid, "w")
        self.assertTrue(((w > 0.5) & (w < 1)).all())

    def test_an_inside_out_box_is_turned_over_with_a_warning(self):
        result = insideout.tetrahedralize(surfaces.reversed_box())
        self.check(result, 1)
        self.assertEqual(result.statistics["TurnedShells"], 1)
        self.assertEqual(len(result.warnings), 1)
        self.assertIn("inside out", result.warnings[0])

    def test_orientation_as_given_and_reverse(self):
        for orientation, sign in (("as-given", -1), ("reverse", 1)):
            with self.subTest(orientation):
                result = insideout.tetrahedralize(surfaces.reversed_box(), orientation=orientation)
                self.assertEqual(set(cell_array(result.hull, "w")), {float(sign)})
                self.assertEqual(result.solid.GetNumberOfCells() > 0, sign > 0)

    def test_nothing_inside_is_a_warning_that_gives_the_range_of_w(self):
        result = insideout.tetrahedralize(surfaces.reversed_box(), orientation="as-given")
        self.assertEqual(result.solid.GetNumberOfCells(), 0)
        self.assertEqual(result.boundary.GetNumberOfCells(), 0)
        self.assertEqual(result.outliers.GetNumberOfCells(), 12)
        self.assertIn("nothing is inside: w ranges from -1", " ".join(result.warnings))
        self.assertEqual(result.statistics["MinimumW"], -1)

    def test_merge_tolerance_closes_a_crack(self):
        points = surfaces.box_points() + [(0, 0, 1e-6)]
        cracked = surfaces.polydata(points, [(8, 2, 1), *surfaces.BOX_FACETS[1:]])
        self.assertEqual(insideout.tetrahedralize(cracked).statistics["Closed"], 0)
        self.assertEqual(insideout.tetrahedralize(cracked, merge_tolerance=1e-5).statistics["Closed"], 1)

    def test_duplicates_count_once_unless_told_otherwise(self):
        twice = surfaces.box(facets=[*surfaces.BOX_FACETS, *surfaces.BOX_FACETS])
        for count_duplicates, w in ((False, 1.0), (True, 2.0)):
            with self.subTest(count_duplicates=count_duplicates):
                result = insideout.tetrahedralize(twice, count_duplicates=count_duplicates)
                self.assertEqual(set(cell_array(result.solid, "w")), {w})
                self.check(result, 1)

    def test_polygons_and_strips_are_the_same_as_their_triangles(self):
        quads = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5), (3, 0, 4, 7)]
        self.check(insideout.tetrahedralize(surfaces.box(facets=quads)), 1)
        strips = surfaces.box(facets=[(a, b, d, c) for a, b, c, d in quads])
        strips.SetStrips(strips.GetPolys())
        strips.SetPolys(None)
        self.check(insideout.tetrahedralize(strips), 1)

    def test_same_input_same_result(self):
        first, second = (insideout.tetrahedralize(surfaces.two_boxes()) for _ in range(2))
        self.assertEqual(surfaces.points_of(first.hull).tobytes(), surfaces.points_of(second.hull).tobytes())
        self.assertEqual(surfaces.tetrahedra_of(first.hull).tobytes(), surfaces.tetrahedra_of(second.hull).tobytes())
        self.assertEqual(cell_array(first.hull, "w").tobytes(), cell_array(second.hull, "w").tobytes())


class Data(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        surface = surfaces.two_boxes()
        points = surfaces.points_of(surface)
        surfaces.add_array(surface.GetPointData(), "place", points @ (1.0, 10.0, 100.0))
        surfaces.add_array(surface.GetPointData(), "number", np.arange(16, dtype=np.int32))
        surfaces.add_array(surface.GetCellData(), "part", np.repeat([7, 8], 12).astype(np.int32))
        cls.surface = surface
        cls.result = insideout.tetrahedralize(surface)

    def check_array(self, data, name, data_type, components=1):
        array = data.GetArray(name)
        self.assertIsNotNone(array, f"there is no array {name}")
        self.assertEqual(array.GetDataType(), data_type, name)
        self.assertEqual(array.GetNumberOfComponents(), components, name)

    def test_the_arrays_of_the_tetrahedra(self):
        for grid in (self.result.hull, self.result.solid):
            self.assertEqual(grid.GetPoints().GetDataType(), VTK_DOUBLE)
            self.check_array(grid.GetCellData(), "w", VTK_DOUBLE)
            self.check_array(grid.GetCellData(), "Inside", VTK_UNSIGNED_CHAR)
            self.check_array(grid.GetCellData(), "FacetIds", VTK_ID_TYPE, 4)
            self.check_array(grid.GetCellData(), "FacetMultiplicity", VTK_SHORT, 4)
            self.check_array(grid.GetPointData(), "vtkOriginalPointIds", VTK_ID_TYPE)

    def test_the_arrays_of_the_surfaces(self):
        for surface in (self.result.boundary, self.result.outliers):
            self.assertEqual(surface.GetPoints().GetDataType(), VTK_DOUBLE)
            self.check_array(surface.GetPointData(), "vtkOriginalPointIds", VTK_ID_TYPE)
            self.check_array(surface.GetCellData(), "vtkOriginalCellIds", VTK_ID_TYPE)

    def test_the_solid_has_its_statistics_as_field_data(self):
        for grid in (self.result.hull, self.result.solid):
            fields = grid.GetFieldData()
            array, names = fields.GetArray("Statistics"), fields.GetAbstractArray("StatisticsNames")
            self.assertEqual((array.GetDataType(), array.GetNumberOfTuples()), (VTK_DOUBLE, names.GetNumberOfValues()))
            self.assertEqual(array.GetValue(names.LookupValue("HullCells")), self.result.hull.GetNumberOfCells())
            self.assertLess(fields.GetNumberOfArrays(), 12, "menus and panels list each of them")
        self.assertIsInstance(self.result.statistics["HullCells"], int)
        self.assertIsInstance(self.result.statistics["SecondsCDT"], float)

    def test_original_points_keep_their_coordinates_and_all_are_there(self):
        given = surfaces.points_of(self.surface)
        ids = point_array(self.result.hull, "vtkOriginalPointIds")
        kept = ids >= 0
        self.assertEqual(sorted(ids[kept]), list(range(16)))
        self.assertEqual(surfaces.points_of(self.result.hull)[kept].tobytes(), given[ids[kept]].tobytes())

    def test_point_data_are_interpolated_on_the_surface(self):
        boundary = self.result.boundary
        new = point_array(boundary, "vtkOriginalPointIds") == -1
        self.assertGreater(new.sum(), 0)
        expected = surfaces.points_of(boundary) @ (1.0, 10.0, 100.0)
        np.testing.assert_allclose(point_array(boundary, "place"), expected, rtol=1e-12)

    def test_cell_data_come_from_the_cell_that_a_face_lies_on(self):
        for surface in (self.result.boundary, self.result.outliers):
            ids = cell_array(surface, "vtkOriginalCellIds")
            self.assertTrue((ids >= 0).all())
            self.assertEqual(cell_array(surface, "part").tolist(), np.where(ids < 12, 7, 8).tolist())

    def test_w_jumps_by_the_multiplicity_of_the_face(self):
        hull = self.result.hull
        cells, w = surfaces.tetrahedra_of(hull), cell_array(hull, "w")
        multiplicity = cell_array(hull, "FacetMultiplicity")
        faces_of_a_tetrahedron = ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))
        sides = {}
        for c, cell in enumerate(cells):
            for k, face in enumerate(faces_of_a_tetrahedron):
                sides.setdefault(frozenset(cell[list(face)]), []).append((c, k))
        for one, *other in sides.values():
            beyond = w[other[0][0]] if other else 0
            self.assertEqual(w[one[0]] - beyond, multiplicity[one])

    def test_facet_ids_name_the_cell_that_the_face_lies_in(self):
        hull = self.result.hull
        points, cells, ids = surfaces.points_of(hull), surfaces.tetrahedra_of(hull), cell_array(hull, "FacetIds")
        corners = surfaces.points_of(self.surface)[surfaces.triangles_of(self.surface)]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        found = set()
        for k, face in enumerate(((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))):
            on = np.flatnonzero(ids[:, k] >= 0)
            facets = ids[on, k]
            found.update(facets.tolist())
            offsets = points[cells[on][:, face]] - corners[facets, 0][:, None, :]
            self.assertEqual(np.abs(np.einsum("ijk,ik->ij", offsets, normals[facets])).max(), 0)
        self.assertEqual(found, set(range(24)))

    def test_an_array_whose_name_clashes_is_renamed_with_a_warning(self):
        surface = surfaces.box()
        surfaces.add_array(surface.GetPointData(), "vtkOriginalPointIds", np.arange(8.0))
        result = insideout.tetrahedralize(surface)
        self.assertEqual(point_array(result.boundary, "Input_vtkOriginalPointIds").tolist(), list(range(8)))
        self.assertIn("vtkOriginalPointIds", result.warnings[0])


def without_polygons():
    lines = surfaces.box()
    lines.SetLines(lines.GetPolys())
    lines.SetPolys(None)
    return lines


def with_point(coordinate):
    surface = surfaces.box()
    surface.GetPoints().SetPoint(5, 1, coordinate, 1)
    return surface


FLAT = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
BAD_INPUT = {
    # name: (surface, what the message has to say)
    "empty": (vtkPolyData(), "the surface is empty"),
    "points only": (surfaces.box(facets=[]), "the surface is empty"),
    "lines only": (without_polygons(), "no polygons, only lines|the input is lines"),
    "not a number": (with_point(float("nan")), "point 5 is not finite"),
    "infinite": (with_point(float("inf")), "point 5 is not finite"),
    "id too large": (surfaces.box(facets=[*surfaces.BOX_FACETS[:11], (3, 4, 8)]), "cell 11 refers to point 8 of 8"),
    "id negative": (surfaces.box(facets=[*surfaces.BOX_FACETS[:11], (3, 4, -1)]), "cell 11 refers to point -1 of 8"),
    "all degenerate": (surfaces.box(facets=[(0, 0, 1), (2, 3, 3), (4, 7, 7)]), "degenerate"),
    "in one line": (surfaces.polydata([(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1, 2)]), "degenerate"),
    "coplanar": (FLAT, "plane"),
}


class BadInput(unittest.TestCase):
    def test_each_is_one_line_that_names_the_culprit_and_nothing_is_printed(self):
        for name, (surface, expected) in BAD_INPUT.items():
            with self.subTest(name):
                printed = []
                with what_is_printed(printed), self.assertRaises(insideout.Error) as caught:
                    insideout.tetrahedralize(surface, dimension=3)
                self.assertRegex(str(caught.exception), expected)
                self.assertNotIn("\n", str(caught.exception))
                self.assertNotIn("0x", str(caught.exception))
                self.assertEqual(printed, [""])
                # and everything goes on as before
                self.assertGreater(insideout.tetrahedralize(surfaces.box()).solid.GetNumberOfCells(), 0)

    def test_each_filter_gives_an_error_event_and_empty_outputs(self):
        for make in (
            insideout.vtkRobustTetrahedralize,
            insideout.vtkGeneralizedWindingNumber,
            insideout.vtkConstrainedDelaunay3D,
            insideout.vtkResolveSelfIntersections,
        ):
            for name, (surface, expected) in BAD_INPUT.items():
                if name == "coplanar" and make is not insideout.vtkRobustTetrahedralize:
                    continue  # it can be resolved, and become triangles
                with self.subTest(filter=make.__name__, surface=name):
                    self.check_filter(make(), surface, expected)

    def check_filter(self, algorithm, surface, expected):
        algorithm.SetInputData(surfaces.box())
        insideout.pipeline.run(algorithm)
        self.assertGreater(algorithm.GetOutputDataObject(0).GetNumberOfCells(), 0)
        algorithm.SetInputData(surface)
        with self.assertRaisesRegex(insideout.Error, expected):
            insideout.pipeline.run(algorithm)
        for port in range(algorithm.GetNumberOfOutputPorts()):
            self.assertEqual(algorithm.GetOutputDataObject(port).GetNumberOfPoints(), 0)
            self.assertEqual(algorithm.GetOutputDataObject(port).GetNumberOfCells(), 0)

    def test_the_graph_cut_needs_w(self):
        segmentation = insideout.vtkGraphCutSegmentation()
        hull = insideout.tetrahedralize(surfaces.box()).hull
        hull.GetCellData().RemoveArray("w")
        segmentation.SetInputData(hull)
        with self.assertRaisesRegex(insideout.Error, "no cell array w"):
            insideout.pipeline.run(segmentation)

    def test_parameters_out_of_range(self):
        for parameters in (
            *({"gamma": value} for value in (-1, float("nan"), float("inf"), "much")),
            *({"sigma": value} for value in (0, -1, float("nan"))),
            *({"merge_tolerance": value} for value in (-1, float("nan"))),
            *({"time_budget": value} for value in (-1, float("nan"))),
            *({"memory_budget": value} for value in (-1, float("inf"))),
            {"orientation": "sideways"},
            {"engine": "steam"},
        ):
            name = next(iter(parameters))
            with self.subTest(**parameters), self.assertRaisesRegex(insideout.Error, name):
                insideout.tetrahedralize(surfaces.box(), **parameters)

    def test_a_warning_is_no_error(self):
        surface = surfaces.box()
        lines = surfaces.polydata([], [(0, 1)]).GetPolys()
        surface.SetLines(lines)
        printed = []
        with what_is_printed(printed), self.assertWarnsRegex(insideout.Warning, "lines are ignored"):
            result = insideout.tetrahedralize(surface)
        self.assertEqual(printed, [""])
        self.assertEqual(len(result.warnings), 1)
        self.assertIn("lines are ignored", result.warnings[0])


INTERRUPTED = """
import insideout, os, surfaces
try:
    insideout.tetrahedralize(surfaces.box(), engine="tetgen", progress=lambda stage, _: print(stage, flush=True))
except KeyboardInterrupt:
    print("interrupted", flush=True)
os.environ["INSIDEOUT_TETGEN"] = "/bin/false"
print(insideout.tetrahedralize(surfaces.box()).solid.GetNumberOfCells() > 0)
"""


class TetGenInTrouble(unittest.TestCase):
    """Programs in TetGen's place that hang or fail."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def stand_in(self, script: str):
        """A shell script in TetGen's place; its process id is to be read in the file pid."""
        path = os.path.join(self.folder, "helper")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\necho $$ > "{self.folder}/pid"\n{script}\n')
        os.chmod(path, 0o700)
        patch = mock.patch.dict(os.environ, INSIDEOUT_TETGEN=path)
        patch.start()
        self.addCleanup(patch.stop)

    def check_that_helper_has_ended(self):
        with open(os.path.join(self.folder, "pid"), encoding="utf-8") as file:
            self.assertFalse(os.path.exists(f"/proc/{file.read().strip()}"))
        with self.assertRaises(ChildProcessError):
            os.waitpid(-1, os.WNOHANG)

    def test_exceptions_of_a_progress_callback_stop_the_work(self):
        self.stand_in("exec sleep infinity")
        reports = []

        def progress(stage, _):
            if stage == "tetrahedralizing":
                reports.append(stage)
                if len(reports) == 3:
                    raise ArithmeticError("mine")

        with self.assertRaisesRegex(ArithmeticError, "mine"):
            insideout.tetrahedralize(surfaces.box(), progress=progress, engine="tetgen")
        self.assertEqual(len(reports), 3)
        self.check_that_helper_has_ended()

    def test_an_observer_stops_the_filter(self):
        self.stand_in("exec sleep infinity")
        tetrahedralizer = insideout.vtkRobustTetrahedralize()
        tetrahedralizer.SetInputData(surfaces.box())
        tetrahedralizer.GetWindingNumber().SetEngineToTetGen()
        reports = []

        def observe(algorithm, _event):
            if algorithm.GetProgressText() == "tetrahedralizing":
                reports.append(algorithm.GetProgress())
                if len(reports) == 3:
                    algorithm.SetAbortExecute(1)

        tetrahedralizer.AddObserver("ProgressEvent", observe)
        tetrahedralizer.Update()
        self.assertEqual(len(reports), 3)
        self.assertEqual(tetrahedralizer.GetOutput().GetNumberOfCells(), 0)
        self.check_that_helper_has_ended()

    def test_ctrl_c_is_an_exception(self):
        self.stand_in("exec sleep infinity")
        environment = dict(os.environ)
        environment["PYTHONPATH"] = os.pathsep.join([os.path.dirname(__file__), os.environ.get("PYTHONPATH", "")])
        with subprocess.Popen(
            [sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, env=environment, text=True
        ) as process:
            while not os.path.exists(os.path.join(self.folder, "pid")):
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            for line in process.stdout:
                if line == "interrupted\n":
                    break
            self.assertEqual(line, "interrupted\n")
            self.assertEqual(process.stdout.read(), "True\n")
        self.assertEqual(process.returncode, 0)
        self.check_that_helper_has_ended()

    def test_lost_facets_are_counted_warned_of_and_listed_and_the_solid_is_right(self):
        self.stand_in("exit 1")
        points = [(2, 0, 0), (-1, 2, 0), (-1, -2, 0), (0, 0, 0.1), (0, 0, -0.1)]
        closed = [(0, 1, 3), (1, 2, 3), (2, 0, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4)]
        surface = surfaces.polydata(points, [*closed, (0, 1, 2)])
        result = insideout.tetrahedralize(surface, gamma=0, engine="tetgen")
        name = insideout.vtkConstrainedDelaunay3D.GetRungName(result.statistics["Rung"])
        lost = result.statistics["LostFacets"]
        if name.startswith("Delaunay"):
            self.assertEqual(lost, 1)
            self.assertIn(f"the tetrahedra come from: {name}", result.warnings)
            self.assertTrue(any("1 facets are not in the mesh" in warning for warning in result.warnings))
        self.assertFalse(name.startswith("TetGen"))
        self.assertEqual(result.lost_cells, [6] if lost else [])
        self.assertTrue(any("exited with status 1" in warning for warning in result.warnings))
        self.assertTrue(surfaces.is_watertight(result.boundary))

        hull = insideout.vtkConstrainedDelaunay3D()
        hull.SetInputData(surface)
        hull.SetEngineToTetGen()
        warnings = insideout.pipeline.run(hull)
        statistics = insideout.pipeline.statistics_of(hull.GetOutput())
        self.assertEqual(statistics["Rung"], result.statistics["Rung"])
        self.assertEqual(statistics["LostFacets"], lost)
        self.assertTrue(any("exited with status 1" in warning for warning in warnings))

    def test_exact_flips_need_no_helper_and_lose_nothing(self):
        self.stand_in("exit 1")
        points = [(2, 0, 0), (-1, 2, 0), (-1, -2, 0), (0, 0, 0.1), (0, 0, -0.1)]
        closed = [(0, 1, 3), (1, 2, 3), (2, 0, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4)]
        surface = surfaces.polydata(points, [*closed, (0, 1, 2)])
        for engine in ("exact", "automatic"):
            with self.subTest(engine):
                result = insideout.tetrahedralize(surface, engine=engine)
                name = insideout.vtkConstrainedDelaunay3D.GetRungName(result.statistics["Rung"])
                self.assertEqual(name, "exact flips and cuts")
                self.assertEqual(result.statistics["LostFacets"], 0)
                self.assertFalse(any("exited with status 1" in warning for warning in result.warnings))

    def test_every_filter_that_tetrahedralizes_has_an_engine(self):
        self.stand_in("exit 1")
        for name in ("vtkConstrainedDelaunay3D", "vtkGeneralizedWindingNumber", "vtkRobustTetrahedralize"):
            with self.subTest(name):
                filter = getattr(insideout, name)()
                stage = insideout.options.owner_of(filter, "Engine")
                self.assertEqual(stage.GetEngine(), stage.ENGINE_AUTOMATIC)
                stage.SetEngineToExact()
                self.assertEqual(stage.GetEngine(), stage.ENGINE_EXACT)
                filter.SetInputData(surfaces.box())
                self.assertEqual(insideout.pipeline.run(filter), [])

    def test_a_budget_ends_what_hangs(self):
        self.stand_in("exec sleep infinity")
        result = insideout.tetrahedralize(surfaces.box(), time_budget=1, engine="tetgen")
        self.assertTrue(any("took more than the 0.3333 s" in warning for warning in result.warnings))
        self.assertAlmostEqual(surfaces.enclosed_volume(result.boundary), 1, delta=1e-12)
        self.check_that_helper_has_ended()


class Package(unittest.TestCase):
    def test_every_wrapped_class_is_a_public_name(self):
        for name in (
            *("vtkConstrainedDelaunay3D", "vtkGeneralizedWindingNumber", "vtkGraphCutSegmentation"),
            *("vtkResolveSelfIntersections", "vtkRobustTetrahedralize", "vtkSurfaceReader", "vtkSurfaceWriter", "vtkSolidReader", "vtkSolidWriter"),
        ):
            self.assertIn(name, insideout.__all__)
            self.assertEqual(getattr(insideout, name)().GetClassName(), name)

    def test_the_progress_goes_through_all_stages_and_only_forward(self):
        seen = []
        insideout.tetrahedralize(surfaces.two_boxes(), progress=lambda stage, fraction: seen.append((stage, fraction)))
        stages = list(dict.fromkeys(stage for stage, _ in seen if stage != UNNAMED))
        self.assertEqual(tuple(stages), TETRAHEDRALIZE)
        fractions = [fraction for _, fraction in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1)

    def test_inputs_other_than_surfaces_are_named(self):
        for thing in (None, 3, vtkUnstructuredGrid()):
            with self.assertRaisesRegex(insideout.Error, type(thing).__name__):
                insideout.tetrahedralize(thing)

    def test_help_is_there(self):
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            help(insideout.tetrahedralize)
        self.assertIn("gamma", text.getvalue())


if __name__ == "__main__":
    unittest.main()
