# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies in one mesh, from Python, as blocks and on the command line; and the example in Examples/Bodies."""

import importlib
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import insideout
import numpy as np
import surfaces
from insideout.stages import TETRAHEDRALIZE
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "Testing" / "Judge"))
touching = importlib.import_module("judge-touching")


def box(low, high):
    """Points and triangles, which face outward."""
    corners = np.array([[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)], float)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners, np.array([triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))])


def volume_of(region) -> float:
    return round(region.volume, 12)


def area_of(surface, triangles=slice(None)) -> float:
    a, b, c = surfaces.points_of(surface)[surfaces.triangles_of(surface)[triangles]].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


LEFT, RIGHT = box((0, 0, 0), (2, 2, 2)), box((1, 0, 0), (4, 2, 2))


def polygons(surface) -> vtkPolyData:
    """Without any data."""
    bare = vtkPolyData()
    bare.CopyStructure(insideout.resolve(surface).surface)
    return bare


def blocks_of(bodies) -> vtkMultiBlockDataSet:
    blocks = vtkMultiBlockDataSet()
    for k, (name, surface) in enumerate(bodies.items()):
        blocks.SetBlock(k, surface)
        blocks.GetMetaData(k).Set(vtkMultiBlockDataSet.NAME(), name)
    return blocks


class TestBodies(unittest.TestCase):
    def test_the_first_in_priority_has_what_bodies_share(self):
        for priority, volumes in ((None, [8, 8]), (["right"], [4, 12]), ("right,left", [4, 12])):
            result = insideout.tetrahedralize({"left": LEFT, "right": RIGHT}, priority=priority)
            self.assertEqual([region.bodies for region in result.regions], [("left",), ("right",)])
            self.assertEqual([volume_of(region) for region in result.regions], volumes)
            self.assertEqual({name: round(volume, 12) for name, volume in result.bodies.items()}, {"left": 8, "right": 12})
            self.assertEqual(result.warnings, [])

    def test_region_rule_all_makes_a_region_of_each_combination(self):
        result = insideout.tetrahedralize({"left": LEFT, "right": RIGHT}, region_rule="all")
        self.assertEqual([(region.bodies, volume_of(region)) for region in result.regions], [(("left",), 4), (("left", "right"), 4), (("right",), 8)])
        in_body = result.solid.cell_arrays["InBody"]
        np.testing.assert_array_equal(in_body, result.solid.cell_arrays["BodyW"])
        np.testing.assert_array_equal(in_body.sum(axis=1), result.solid.w)

    def test_each_interface_is_there_once_and_the_boundary_is_tagged_by_both_regions(self):
        for refined in ({}, {"edge_length": 1}, {"surface_treatment": "split"}, {"edge_length": 0.8, "surface_treatment": "remeshed"}):
            with self.subTest(refined):
                result = insideout.tetrahedralize({"left": LEFT, "right": RIGHT}, region_rule="all", **refined)
                boundary, solid = result.boundary, result.solid
                self.assertEqual(list(result.tags), ["left|outside", "left|left+right", "left+right|outside", "left+right|right", "right|outside"])
                ids = {tuple(point): number for number, point in enumerate(solid.points.tolist())}
                triangles = [tuple(sorted(ids[tuple(point)] for point in boundary.points[corners].tolist())) for corners in boundary.triangles]
                self.assertEqual(len(set(triangles)), len(triangles))
                regions = boundary.cell_arrays["RegionIds"]
                expected = {triangle: tuple(pair) for triangle, pair in zip(triangles, regions.tolist())}
                beside = {}
                for cell, region in zip(solid.cells.tolist(), solid.cell_arrays["RegionId"].tolist()):
                    for k in range(4):
                        beside.setdefault(tuple(sorted(cell[:k] + cell[k + 1 :])), []).append(region)
                parting = {face: tuple(sorted(of)) if len(of) == 2 else (of[0], -1) for face, of in beside.items() if len(of) == 1 or of[0] != of[1]}
                self.assertEqual(parting, expected)
                area = {pair: self.area(boundary, np.all(regions == pair, axis=1)) for pair in ((0, 1), (1, 2))}
                self.assertAlmostEqual(area[0, 1], 4, delta=1e-6)
                self.assertAlmostEqual(area[1, 2], 4, delta=1e-6)

    def area(self, surface, which) -> float:
        a, b, c = (surface.points[surface.triangles[which, k]] for k in range(3))
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

    def test_bodies_by_an_array_of_names(self):
        surface = polygons((np.vstack([LEFT[0], RIGHT[0] + (3, 0, 0)]), np.vstack([LEFT[1], RIGHT[1] + 8])))
        names = vtkStringArray()
        names.SetName("Organ")
        for cell in range(surface.GetNumberOfCells()):
            names.InsertNextValue("spleen" if cell < 12 else "liver")
        surface.GetCellData().AddArray(names)
        result = insideout.tetrahedralize(surface, body_array="Organ")
        self.assertEqual({name: round(volume, 12) for name, volume in result.bodies.items()}, {"spleen": 8, "liver": 12})
        self.assertEqual(insideout.tetrahedralize(surface).bodies, {})

    def test_two_labels_per_triangle_are_bodies_however_they_stand(self):
        left, right = box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (2, 1, 1))
        random = np.random.default_rng(2)
        surface = (np.vstack([left[0], right[0]]), np.vstack([left[1], right[1] + 8]))
        labels = np.array([(3, 0)] * 12 + [(7, 0)] * 12)
        middles = surface[0][surface[1]].mean(axis=1)
        labels[:12][middles[:12, 0] == 1] = (3, 7)
        once = ~((middles[:, 0] == 1) & (np.arange(24) >= 12))  # the face between them is there once
        for turned in (np.zeros(24, bool), np.ones(24, bool), random.random(24) < 0.5):
            triangles = np.where(turned[:, None], surface[1][:, ::-1], surface[1])
            given = polygons((surface[0], triangles[once]))
            array = numpy_to_vtk(labels[once].astype(np.int16), deep=True)
            array.SetName("BoundaryLabels")
            given.GetCellData().AddArray(array)
            result = insideout.tetrahedralize(given, body_array="BoundaryLabels", priority="7")
            self.assertEqual([(region.bodies, volume_of(region)) for region in result.regions], [(("3",), 1), (("7",), 1)])
            self.assertEqual({name: round(area_of(result.boundary, of), 12) for name, of in result.tags.items()}, {"3|outside": 5, "3|7": 1, "7|outside": 5})
            self.assertEqual(len(result.outliers.triangles), 0)

    def test_labels_that_part_nothing_are_left_out_or_an_error(self):
        given = polygons((np.vstack([LEFT[0], RIGHT[0] + (3, 0, 0)]), np.vstack([LEFT[1], RIGHT[1] + 8])))
        array = numpy_to_vtk(np.array([(1, 0)] * 12 + [(1, 1)] * 12), deep=True)
        array.SetName("Labels")
        given.GetCellData().AddArray(array)
        result = insideout.tetrahedralize(given, body_array="Labels")
        self.assertEqual({name: round(volume, 12) for name, volume in result.bodies.items()}, {"1": 8})
        self.assertIn("12 triangles have the same label of Labels on both sides, and are left out", result.warnings)
        for value, message in ((1, "the cell array Labels has no triangle with different labels on its two sides"), (0.5, "the cell array Labels has the value 0.5 at cell 0")):
            array = numpy_to_vtk(np.full((24, 2), value), deep=True)
            array.SetName("Labels")
            given.GetCellData().AddArray(array)
            with self.assertRaisesRegex(insideout.Error, message):
                insideout.tetrahedralize(given, body_array="Labels")

    def test_blocks_are_bodies_or_surfaces_by_themselves(self):
        blocks = blocks_of({"left": polygons(LEFT), "right": polygons(RIGHT)})
        made = insideout.vtkRobustTetrahedralize()
        made.SetInputDataObject(0, blocks)
        made.Update()
        self.assertTrue(made.GetOutputDataObject(0).IsA("vtkMultiBlockDataSet"))
        made.BlocksAreBodiesOn()
        made.Update()
        self.assertTrue(made.GetOutputDataObject(0).IsA("vtkUnstructuredGrid"))
        by_name = insideout.tetrahedralize({"left": LEFT, "right": RIGHT})
        cells = vtk_to_numpy(made.GetOutput().GetCells().GetConnectivityArray()).reshape(-1, 4)
        np.testing.assert_array_equal(cells, by_name.solid.cells)
        made.BlocksAreBodiesOff()
        made.Update()
        self.assertTrue(made.GetOutputDataObject(0).IsA("vtkMultiBlockDataSet"))

    def test_a_block_has_the_name_that_it_has_now(self):
        blocks = blocks_of({"left": polygons(LEFT), "right": polygons(RIGHT)})
        made = insideout.vtkRobustTetrahedralize()
        made.BlocksAreBodiesOn()
        made.SetInputDataObject(0, blocks)
        made.Update()
        blocks.GetMetaData(1).Set(vtkMultiBlockDataSet.NAME(), "heart")
        made.SetGamma(1)
        made.Update()
        self.assertEqual(made.GetOutput().GetFieldData().GetAbstractArray("BodyNames").GetValue(1), "heart")

    def test_a_body_without_polygons_is_told(self):
        told = "body none: the surface has no polygons: the body is empty"
        self.assertEqual(insideout.tetrahedralize({"left": LEFT, "none": vtkPolyData()}).warnings, [told])
        made = insideout.vtkRobustTetrahedralize()
        made.BlocksAreBodiesOn()
        made.SetInputDataObject(0, blocks_of({"left": polygons(LEFT), "none": vtkPolyData()}))
        self.assertEqual(insideout.pipeline.run(made), [told])
        made.SetInputDataObject(0, blocks_of({"left": vtkPolyData(), "right": vtkPolyData()}))
        with self.assertRaisesRegex(insideout.Error, "none of the blocks has polygons"):
            insideout.pipeline.run(made)

    def test_a_body_that_others_cover_whole_is_told_with_what_gives_it_cells(self):
        bodies = {"left": LEFT, "right": RIGHT, "within": box((0.5, 0.5, 0.5), (3, 1, 1))}
        told = "body within has no cell: all of its places are of bodies before it (left, right); set priority to within, or region_rule to all"
        covered = insideout.tetrahedralize(bodies)
        self.assertEqual((covered.warnings, covered.regions[2].volume), ([told], 0))
        for advice in ({"priority": "within"}, {"region_rule": "all"}):
            self.assertEqual(insideout.tetrahedralize(bodies, **advice).warnings, [])

    def test_arrays_of_the_input_whose_names_are_taken_stay(self):
        bodies = {"left": polygons(LEFT), "right": polygons(RIGHT)}
        for surface in bodies.values():
            for name in ("BodyIds", "RegionIds"):
                surfaces.add_array(surface.GetCellData(), name, np.full(surface.GetNumberOfCells(), 7))
        made = insideout.vtkRobustTetrahedralize()
        made.BlocksAreBodiesOn()
        made.SetInputDataObject(0, blocks_of(bodies))
        warnings = insideout.pipeline.run(made)
        result = insideout.tetrahedralize(bodies)
        self.assertEqual(result.warnings, warnings)
        self.assertEqual(sum("is passed on as Input_" in warning for warning in warnings), 3)  # BodyIds of each
        for boundary in (made.GetBoundary(), result.boundary):
            for name in ("Input_BodyIds", "Input_RegionIds"):
                self.assertEqual(set(surfaces.cell_array(boundary, name)), {7})

    def test_figures_are_those_of_one_surface(self):
        one = insideout.tetrahedralize(LEFT)
        several = insideout.tetrahedralize({"left": LEFT, "right": RIGHT})
        self.assertEqual(set(one.statistics) - set(several.statistics), set())
        for name, figure in (("SolidComponents", 1), ("SolidTunnels", 0), ("BoundaryComponents", 1), ("Genus", 0)):
            self.assertEqual(several.statistics[name], figure)
        sheet = (np.array([(5, 0, 0), (6, 0, 0), (5, 1, 0)], float), np.array([(0, 1, 2)]))
        self.assertEqual(insideout.tetrahedralize({"left": LEFT, "sheet": sheet}, thicken=0.1).statistics["ThickenedFacets"], 1)

    def test_a_gap_below_the_tolerance_closes_and_a_larger_one_stays(self):
        upper = box((0, 0, 2 + 1e-4), (2, 2, 3))
        for tolerance, count in ((0, 0), (9e-5, 0), (1.1e-4, 2)):
            result = insideout.tetrahedralize({"lower": LEFT, "upper": upper}, merge_tolerance=tolerance)
            self.assertEqual(len(result.tags.get("lower|upper", ())), count)

    def test_faces_that_touch_but_for_the_rounding_of_their_coordinates_are_one(self):
        for name in touching.ASSEMBLIES:
            for grid in touching.GRIDS:
                for kind, turn, wrong in touching.judged(name, grid, 2, 3):
                    self.assertEqual(wrong, "", (name, grid, kind, turn))
        case = touching.turned(touching.tee(None), "floats", np.random.default_rng(4))
        result = insideout.tetrahedralize(case.bodies)
        self.assertRegex("".join(result.warnings), r"bodies \w+ and \w+ touch within \S+, closed: \d+ points? of \w+ moved")
        self.assertEqual(result.statistics["TouchingPairs"], 1)
        self.assertGreater(result.statistics["TouchMovedPoints"], 0)
        self.assertEqual(insideout.tetrahedralize(case.bodies, touch_tolerance=0).statistics["TouchMovedPoints"], 0)
        union = insideout.boolean(case.bodies, "bar | leg")
        self.assertEqual(union.statistics["TouchingPairs"], 1)
        self.assertAlmostEqual(union.statistics["Volume"] / case.scale**3, 40 * 10 * 8 + 10 * 10 * 20, 2)

    def test_faces_that_touch_but_for_rounding_are_told_of_and_close_as_advised(self):
        told = 0
        for seed in range(12):
            lower, upper = surfaces.turned_boxes(seed)
            apart = insideout.tetrahedralize({"lower": lower, "upper": upper})
            lines = [line for line in apart.warnings if "nearly touch" in line]
            self.assertEqual(len(lines), apart.statistics["NearTriangles"] > 0)
            if lines:
                told += 1
                match = re.fullmatch(r"bodies lower and upper nearly touch: (\d+) triangles .* touch_tolerance (\S+) makes.*", lines[0])
                self.assertEqual(int(match[1]), apart.statistics["NearTriangles"])
                touching = insideout.tetrahedralize({"lower": lower, "upper": upper}, touch_tolerance=float(match[2]))
                self.assertEqual(touching.statistics["NearTriangles"], 0)
                self.assertFalse(any("nearly touch" in line for line in touching.warnings))
                self.assertAlmostEqual(area_of(touching.boundary, touching.tags["lower|upper"]), 1, 12)
        self.assertGreater(told, 0)

    def test_a_gap_between_round_faces_closes_as_well(self):
        ball, socket = surfaces.ball_in_a_socket(gap=0.006)
        bodies = {"ball": ball, "socket": socket}
        apart = insideout.tetrahedralize(bodies)
        for rule in ("by-priority", "all"):
            closed = insideout.tetrahedralize(bodies, merge_tolerance=0.011, region_rule=rule)
            self.assertEqual(closed.statistics["SolidCavities"], 0)
            # Where points of both became one facets of the socket come into the ball.
            overlap = sum(region.volume for region in closed.regions if len(region.bodies) == 2)
            self.assertLess(overlap, 1e-3)
            self.assertAlmostEqual(closed.bodies["ball"], surfaces.enclosed_volume(ball), 9, "it keeps its shape")
            self.assertAlmostEqual(closed.statistics["Volume"], surfaces.enclosed_volume(surfaces.ball(2, 8, 9)), 9)
            self.assertAlmostEqual(closed.statistics["Volume"] - apart.statistics["Volume"], closed.statistics["GapVolume"], 2)
            between = sum(area_of(closed.boundary, rows) for tag, rows in closed.tags.items() if tag.startswith("ball|"))
            self.assertAlmostEqual(between / area_of(ball), 1, 2, "all of the ball is interface")
            self.assertNotIn("ball|outside", closed.tags)
            self.assertIn(f"were closed by {closed.statistics['GapCells']} cells", closed.warnings[-1])
        first = insideout.tetrahedralize(bodies, merge_tolerance=0.011, priority=["socket"])
        self.assertGreater(first.bodies["ball"], closed.bodies["ball"] + closed.statistics["GapVolume"] / 2, "it fills the gap")
        self.assertEqual(first.statistics["SolidCavities"], 0)

    def test_a_wider_gap_between_round_faces_stays_bit_by_bit(self):
        ball, socket = surfaces.ball_in_a_socket(gap=0.006)
        apart = insideout.tetrahedralize({"ball": ball, "socket": socket})
        below = insideout.tetrahedralize({"ball": ball, "socket": socket}, merge_tolerance=0.0015)
        self.assertEqual((below.statistics["GapCells"], below.statistics["SolidCavities"]), (0, 1))
        for name in ("points", "cells"):
            self.assertEqual(getattr(below.solid, name).tobytes(), getattr(apart.solid, name).tobytes())
        self.assertEqual(below.solid.cell_arrays["RegionId"].tobytes(), apart.solid.cell_arrays["RegionId"].tobytes())
        self.assertEqual(below.boundary.triangles.tobytes(), apart.boundary.triangles.tobytes())

    def test_seeds_are_of_the_body_that_they_name(self):
        outside = insideout.tetrahedralize({"left": LEFT, "right": RIGHT}, seeds=[((0.5, 1.1, 0.9), False, "left")])
        self.assertLess(outside.bodies["left"], 8)
        self.assertEqual(round(outside.bodies["right"], 12), 12)

    def test_seeds_name_a_body_each(self):
        seeds = insideout.tetrahedralize(LEFT).boundary
        names = vtkStringArray()
        names.SetName("Body")
        names.InsertNextValue("left")  # of the first alone
        points = vtkPolyData()
        points.SetPoints(seeds.GetPoints())
        inside = numpy_to_vtk(np.zeros(points.GetNumberOfPoints(), np.uint8), deep=True)
        inside.SetName("Inside")
        points.GetPointData().AddArray(inside)
        points.GetPointData().AddArray(names)
        with self.assertRaisesRegex(insideout.Error, "the seeds' point array Body has not one value per point"):
            insideout.tetrahedralize({"left": LEFT, "right": RIGHT}, seeds=points)

    def fail_on_work(self, stage, _):
        self.assertNotIn(stage, TETRAHEDRALIZE)

    def test_wrong_bodies_and_options_are_named(self):
        bodies = {"left": LEFT, "right": RIGHT}
        for wrong, words in (
            ({"priority": ["nose"]}, "Priority names nose, which is not a body; there are left, right"),
            ({"priority": 3}, "priority is 3; it must be a list of names"),
            ({"priority": ["left", 3]}, "it must be a list of names"),
            ({"priority": ["left", "left"]}, "Priority names left twice"),
            ({"seeds": [((1, 1, 1), True)]}, "seed 0 is to be inside, but its point array Body does not say which body"),
            ({"seeds": [((1, 1, 1), True, "nose")]}, "seed 0 names nose, which is not a body"),
            ({"split_seams": True}, "split_seams takes one body"),
            ({"separate_overlaps": True}, "separate_overlaps takes one body"),
            ({"non_manifold": "split"}, "non_manifold of the kind Split takes one body"),
            ({"separate_overlaps": True, "progress": self.fail_on_work}, "separate_overlaps takes one body"),
            ({"body_array": "Organ"}, "body_array names an array of one surface"),
        ):
            with self.subTest(wrong), self.assertRaisesRegex(insideout.Error, words):
                insideout.tetrahedralize(bodies, **wrong)
        with self.assertRaisesRegex(insideout.Error, "none of the bodies has polygons"):
            insideout.tetrahedralize({"left": vtkPolyData(), "right": vtkPolyData()})
        with self.assertRaisesRegex(insideout.Error, "no cell array Organ"):
            insideout.tetrahedralize(LEFT, body_array="Organ")
        with self.assertRaisesRegex(insideout.Error, "body right: "):
            insideout.tetrahedralize({"left": LEFT, "right": "missing.ply"})


class TestCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, surface in (("left", LEFT), ("right", RIGHT)):
            insideout.write(polygons(surface), self.folder / f"{name}.ply")

    def run_command(self, *arguments):
        return subprocess.run([sys.executable, "-m", "insideout", *arguments], cwd=self.folder, capture_output=True, text=True, check=False)

    def test_several_surfaces_become_one_mesh_with_a_group_for_each(self):
        done = self.run_command("--together", "left.ply", "right.ply", "both.msh", "--priority", "right", "--report", "both.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 regions, of volume 4 (left), 12 (right)", done.stdout)
        text = (self.folder / "both.msh").read_text(encoding="latin-1")
        for group in ('"left"', '"right"', '"left|right"', '"right|outside"'):
            self.assertIn(group, text)
        bodies = json.loads((self.folder / "both.json").read_text())["bodies"]
        self.assertEqual({name: round(volume, 12) for name, volume in bodies.items()}, {"left": 8, "right": 12})

    def test_a_body_without_polygons_is_told(self):
        (self.folder / "none.obj").write_text("v 0 0 0\n", encoding="utf-8")
        done = self.run_command("--together", "left.ply", "none.obj", "both.vtu")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Warning: body none: the surface has no polygons: the body is empty", done.stdout)

    def test_places_lost_to_other_bodies_are_told_with_options_of_the_command(self):
        insideout.write(insideout.resolve(box((0.5, 0.5, 0.5), (1, 1, 1))).surface, self.folder / "inner.ply")
        done = self.run_command("--together", "left.ply", "inner.ply", "both.msh")
        self.assertIn("bodies within body left (inner) keep their own cells, although it comes before them; set --priority to left, or --region-rule", done.stdout)
        self.assertIn("2 regions, of volume 7.875 (left), 0.125 (inner)", done.stdout)
        done = self.run_command("--together", "left.ply", "inner.ply", "both.msh", "--priority", "left")
        self.assertIn("body inner has no cell: all of its places are of bodies before it (left); set --priority to inner, or --region-rule", done.stdout)

    def test_a_surface_of_them_is_what_encloses_them_all(self):
        done = self.run_command("--together", "left.ply", "right.ply", "both.ply")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(insideout.check(self.folder / "both.ply").verdict, "bounds a solid of volume 16")

    def test_senseless_arguments_are_told_with_their_status(self):
        for arguments, words, status in (
            (("--together", "left.ply", "right.ply", "both.vtu", "--body-array", "Part"), "--body-array cannot matter here: --together", 2),
            (("--together", "--check", "left.ply", "right.ply"), "--check meshes nothing: it goes without --together", 2),
            (("--together", "left.ply", "missing.ply", "both.vtu"), "missing.ply", 1),
        ):
            done = self.run_command(*arguments)
            self.assertEqual(done.returncode, status)
            self.assertIn(words, done.stderr)


class TestHeart(unittest.TestCase):
    def test_all_heat_of_the_blood_leaves_through_the_skin(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [sys.executable, ROOT / "Examples" / "Bodies" / "heart.py", folder, "0.8"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                text=True, check=False,
            )
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertGreater((Path(folder) / "heart.png").stat().st_size, 0)
        made, left, apart = (float(found) for found in re.search(r"within (\S+) mW, heat that leaves (\S+) mW: (\S+)", done.stdout).groups())
        self.assertGreater(made, 500)
        self.assertAlmostEqual(left, made, delta=1e-5 * made)
        self.assertLess(abs(apart), 1e-6)
        chamber, wall = (float(found) for found in re.search(r"chamber (\S+), of its wall (\S+) degrees", done.stdout).groups())
        self.assertGreater(chamber, wall)
        self.assertGreater(wall, 0)


if __name__ == "__main__":
    unittest.main()
