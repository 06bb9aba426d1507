# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that a solver takes: refined where the file is for one, else told of; and the same solid as before."""

import importlib.util
import itertools
import json
import os
import re
import subprocess
import sys
import unittest
import unittest.mock
import warnings
from collections import Counter
from pathlib import Path

import insideout
import numpy as np
import surfaces
from command import CommandLine, read_grid, run_here
from insideout import demo
from vtkmodules.util.numpy_support import vtk_to_numpy

DECK = """\
*INCLUDE, INPUT=solid.inp
*MATERIAL, NAME=any
*ELASTIC
1, 0.3
*SOLID SECTION, ELSET=Eall, MATERIAL=any
*BOUNDARY
Nall, 1, 3
*STEP
*STATIC
*END STEP
"""


def slanting_plate(cells=14):
    """A plate of squares, whose corners lie in planes but for rounding: some cells between them are flat in doubles."""
    x, y, z = np.array([(2, -1, 2), (2, 2, -1), (-1, 2, 2)]) / 3
    places = [x * i + y * j + z * k for k in (0, 1) for j in range(cells + 1) for i in range(cells + 1)]
    row = cells + 1
    layer = row * row
    facets = []
    for i, j in itertools.product(range(cells), repeat=2):
        a, b, c, d = j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i
        facets += [(a, c, b), (a, d, c), (a + layer, b + layer, c + layer), (a + layer, c + layer, d + layer)]
    edges = Counter((facet[k], facet[(k + 1) % 3]) for facet in facets for k in range(3))
    for a, b in [edge for edge in edges if edge[::-1] not in edges and edge[0] < layer and edge[1] < layer]:
        facets += [(b, a, a + layer), (b, a + layer, b + layer)]
    return surfaces.polydata(places, facets)


def areas_by_tag(result) -> dict[str, float]:
    points = result.boundary.points
    corners = {name: points[result.boundary.triangles[those]] for name, those in result.tags.items()}
    return {name: float(np.linalg.norm(np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]), axis=1).sum() / 2) for name, c in corners.items()}


def volumes_of(grid, array: str) -> np.ndarray:
    """The volumes of regions, or of the bodies where their winding number is above 1/2."""
    corners = grid.points[grid.cells]
    volumes = np.linalg.det(corners[:, 1:] - corners[:, :1]) / 6
    values = vtk_to_numpy(grid.GetCellData().GetArray(array))
    return np.bincount(values, volumes) if array == "RegionId" else volumes @ (values.reshape(len(volumes), -1) > 0.5)


def groups_of(path: str) -> dict[str, int]:
    """How many element faces each surface of an .inp file has, and that it has sets of each name."""
    found: dict[str, int] = {}
    name = ""
    with open(path, encoding="ascii") as file:
        for line in file:
            keyword = re.match(r"\*(\w+).*?(?:NAME|SET)=(\w+)", line)
            name = f"{keyword[1]} {keyword[2]}" if keyword else "" if line.startswith("*") else name
            found[name] = found.get(name, 0) + (0 if keyword else 1)
    return found


class TheSameSolid(unittest.TestCase):
    """What a solver's file has by default, against the cells as they come."""

    def test_areas_and_volumes_by_name_stay(self):
        ball = surfaces.ball(0.7, 12, 8)
        cases = {
            "tags": (surfaces.joined(surfaces.box(), surfaces.box((0.9, 0.3, 0.2))), {}),
            "bodies": ({"ball": ball, "box": surfaces.box()}, {"priority": "ball"}),
            "combinations": ({"ball": ball, "box": surfaces.box()}, {"region_rule": "all"}),
        }
        surfaces.add_array(cases["tags"][0].GetCellData(), "Side", np.arange(24, dtype=np.int64) // 5)
        cases["tags"][1]["tag_array"] = "Side"
        for name, (surface, options) in cases.items():
            with self.subTest(name):
                plain = insideout.tetrahedralize(surface, refine=False, **options)
                fit = insideout.tetrahedralize(surface, refine=True, **options)
                self.assertGreater(len(fit.solid.cells), len(plain.solid.cells))
                expected = areas_by_tag(plain)
                self.assertGreater(len(expected), 1)
                found = areas_by_tag(fit)
                self.assertEqual(found.keys(), expected.keys())
                np.testing.assert_allclose([found[tag] for tag in expected], list(expected.values()), rtol=1e-12)
                arrays = ["RegionId"] + ["BodyW"] * isinstance(surface, dict)
                for array in arrays:
                    np.testing.assert_allclose(volumes_of(fit.solid, array), volumes_of(plain.solid, array), rtol=1e-11)
                self.assertEqual(fit.statistics["RefusedCells"], 0)
                kept = insideout.tetrahedralize(surface, refine=True, surface_treatment="kept", **options)
                self.assertEqual(surfaces.points_of(kept.boundary).tolist(), surfaces.points_of(plain.boundary).tolist())
                self.assertEqual(kept.boundary.triangles.tolist(), plain.boundary.triangles.tolist())


class Default(CommandLine):
    def setUp(self):
        super().setUp()
        self.surface = self.file("bracket.obj", demo.bracket())
        self.plain = insideout.tetrahedralize(self.surface)
        self.fit = insideout.tetrahedralize(self.surface, refine=True)
        self.assertGreater(len(self.fit.solid.cells), len(self.plain.solid.cells))

    def cells_of(self, name: str) -> int:
        return len(insideout.read(self.path(name)).cells)

    def test_command_refines_for_solvers_alone(self):
        for name, expected in (("a.inp", self.fit), ("a.msh", self.fit), ("a.mesh", self.fit), ("a.vtu", self.plain)):
            self.succeed("mesh", self.surface, self.path(name), "--quiet")
            self.assertEqual(self.cells_of(name), len(expected.solid.cells), name)
            self.succeed("mesh", self.surface, self.path(name), "--quiet", "--no-refine")
            self.assertEqual(self.cells_of(name), len(self.plain.solid.cells), name)

    def test_function_refines_for_solvers_if_it_is_given_the_output(self):
        for name, expected in (("b.inp", self.fit), ("b.msh", self.fit), ("b.vtu", self.plain)):
            made = insideout.tetrahedralize(self.surface, output=self.path(name))
            self.assertEqual(len(made.solid.cells), len(expected.solid.cells), name)
            self.assertEqual(self.cells_of(name), len(expected.solid.cells), name)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", insideout.Warning)
            insideout.tetrahedralize(self.surface, output=self.path("b.inp"), refine=False)
        self.assertEqual(self.cells_of("b.inp"), len(self.plain.solid.cells))
        insideout.tetrahedralize(self.surface, output=self.path("b.stl"))
        self.assertEqual(len(insideout.read(self.path("b.stl")).triangles), len(self.plain.boundary.triangles))
        with self.assertRaisesRegex(insideout.Error, r"b\.txt: unknown ending"):
            insideout.tetrahedralize(self.surface, output=self.path("b.txt"))

    def test_a_file_that_cannot_be_written_is_told_before_the_work(self):
        with self.assertRaisesRegex(insideout.Error, r"b\.inp: such a file has the solid's cells, and surface_only leaves these away"):
            insideout.tetrahedralize(self.surface, output=self.path("b.inp"), surface_only=True)
        square = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        with self.assertRaisesRegex(insideout.Error, r"b\.msh: such a file has tetrahedra here"):
            insideout.tetrahedralize(square, output=self.path("b.msh"))

    def test_a_file_that_has_nothing_in_it_is_not_written(self):
        sheet = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.1)], [(0, 1, 2), (0, 2, 3)])
        with self.assertWarnsRegex(insideout.Warning, r"b\.inp is not written, because nothing is inside"):
            insideout.tetrahedralize(sheet, output=self.path("b.inp"))
        self.assertFalse(os.path.exists(self.path("b.inp")))

    def test_a_check_of_refined_cells_advises_no_refinement(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", insideout.Warning)
            small = insideout.tetrahedralize(slanting_plate(), refine=True)
        found = insideout.check_solid(small.solid)
        self.assertNotIn("refining makes better ones", " ".join(found.warnings))
        self.assertNotIn("RefinedCells", found.statistics)

    def test_regions_that_are_no_integers_are_not_looked_at(self):
        bad = self.plain.solid.NewInstance()
        bad.ShallowCopy(self.plain.solid)
        surfaces.add_array(bad.GetCellData(), "RegionId", np.full(bad.GetNumberOfCells(), np.nan))
        expected = insideout.check_solid(self.plain.solid).statistics
        self.assertEqual(insideout.check_solid(bad).statistics["PoorCells"], expected["PoorCells"])
        self.assertGreater(expected["PoorCells"], 0)

    def test_writing_leaves_cells_as_they_are(self):
        with self.assertWarnsRegex(insideout.Warning, r"c\.inp: a solver suffers from \d+ of \d+ cells, .*: refining makes better ones \(refine\)"):
            insideout.write(self.plain, self.path("c.inp"))
        self.assertEqual(insideout.read(self.path("c.inp")).cells.tolist(), self.plain.solid.cells.tolist())

    def test_groups_have_the_same_names_and_faces(self):
        self.succeed("mesh", self.surface, self.path("fit.inp"), "--quiet")
        self.succeed("mesh", self.surface, self.path("plain.inp"), "--quiet", "--no-refine")
        fit, plain = groups_of(self.path("fit.inp")), groups_of(self.path("plain.inp"))
        self.assertEqual(fit.keys(), plain.keys())
        faces = [name for name in plain if name.startswith("SURFACE")]
        self.assertIn("SURFACE load", faces)
        self.assertEqual([fit[name] for name in faces], [plain[name] for name in faces])

    def test_a_refinement_that_is_refused_and_asked_for_is_an_error(self):
        with self.assertRaisesRegex(insideout.Error, "^edge_length is given, which refines, and refine is False$"):
            insideout.tetrahedralize(self.surface, refine=False, edge_length=5)
        done = run_here("mesh", self.surface, self.path("d.inp"), "--no-refine", "--edge-length", "5")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--edge-length cannot matter here: --no-refine leaves the cells as they are", done.stderr)

    def test_the_dry_run_and_the_report_tell_of_it(self):
        report = self.path("report.json")
        for options, refines in (([], True), (["--no-refine"], False)):
            self.succeed("mesh", self.surface, self.path("e.inp"), "--quiet", "--report", report, *options)
            with open(report, encoding="utf-8") as file:
                told = json.load(file)
            self.assertIs(told["parameters"]["refine"], refines)
            self.assertEqual(told["statistics"]["RefusedCells"], 0)
            self.assertEqual(told["statistics"]["PoorCells"] == 0, refines)
        said = [run_here("mesh", self.surface, self.path("f.inp"), "--dry-run", *more).stdout for more in ([], ["--no-refine"])]
        self.assertNotEqual(*(re.search("about .* tetrahedra", text)[0] for text in said))

    def succeed(self, *arguments: str):
        done = run_here(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)


class Unfit(CommandLine):
    """Cells that a solver does not take: the count, and what helps."""

    def write_unrefined(self) -> int:
        """The number of cells that are told as refused, between faces that are one rounding apart."""
        boxes = surfaces.joined(surfaces.box(), surfaces.box((0.1, 0, 1 - 1e-16)))
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            insideout.tetrahedralize(boxes, refine=False, output=self.path("solid.inp"))
        (told,) = [str(one.message) for one in caught if "a solver refuses" in str(one.message)]
        return int(re.search(r"refuses (\d+) of", told)[1])

    def test_the_count_is_that_of_calculix_cell_by_cell(self):
        count = self.write_unrefined()
        self.assertGreater(count, 1)
        self.file("deck.inp", DECK)
        done = subprocess.run(["ccx", "deck"], cwd=self.folder, capture_output=True, text=True, check=False)
        refused = set(re.findall(r"nonpositive jacobian\s+determinant in element\s+(\d+)", done.stdout))
        self.assertEqual(len(refused), count)

    def test_it_is_the_same_in_check_its_report_and_its_verdict(self):
        count = self.write_unrefined()
        found = insideout.check_solid(self.path("solid.inp"))
        self.assertEqual((found.statistics["RefusedCells"], found.statistics["NegativeCells"]), (count, 0))
        self.assertIn(f"{count:,} cells that a solver refuses", found.verdict)
        self.assertIn(f"{count:,} cells that a solver refuses", [finding.text for finding in found.findings if finding.matters])
        (warning,) = found.warnings
        self.assertRegex(warning, rf"^a solver refuses {count} of \d+ cells")

    def test_flat_cells_are_reconnected_where_nothing_is_refined(self):
        solid = insideout.tetrahedralize(slanting_plate(), refine=False).solid
        self.assertEqual(insideout.check_solid(solid).statistics["RefusedCells"], 0)

    def test_the_unit_counts_and_a_smaller_one_helps(self):
        small = insideout.tetrahedralize(surfaces.box(), refine=True, scale=1e-8)
        with self.assertWarnsRegex(insideout.Warning, r"refuses (\d+) of \1 cells.*: they would pass in a smaller unit \(by scale\)"):
            insideout.write(small, self.path("small.msh"))

    def needle(self, height: float, is_open: bool = False):
        """A box from -1 to 1 with a needle within its upper side, perhaps without its left side."""
        points = [*itertools.product((-1, 1), repeat=3), (-0.5, 0, 1), (0.5, 0, 1), (0, height, 1)]
        around = [(1, 5, 8), (5, 9, 8), (5, 7, 9), (7, 10, 9), (7, 3, 10), (3, 8, 10), (3, 1, 8), (8, 9, 10)]
        sides = [(0, 2, 6, 4), (0, 4, 5, 1), (4, 6, 7, 5), (6, 2, 3, 7), (2, 0, 1, 3)]
        return surfaces.polydata(points, [*around, *sides[: -1 if is_open else None]])

    def test_a_needle_that_a_solver_would_refuse_is_removed_and_told(self):
        needle = self.needle(1e-20)
        kept = insideout.tetrahedralize(needle, refine=True, surface_treatment="kept")
        self.assertGreater(kept.statistics["RefusedCells"], 0)
        made = insideout.tetrahedralize(needle, refine=True)
        self.assertEqual(made.statistics["RefusedCells"], 0)
        self.assertAlmostEqual(made.volume, 8, 9)
        self.assertEqual(len(made.boundary.triangles), len(kept.boundary.triangles))
        told = r"a solver would refuse 1 of \d+ cells where the surface is kept: after 1 changes to its needles and flat cells, which move it by at most 2e-06, 0 are left"
        self.assertRegex(" ".join(made.warnings), told + "; set surface_treatment to kept")
        low = insideout.tetrahedralize(self.needle(1e-14), refine=True)  # which it accepts, to compute without digits
        self.assertRegex(" ".join(low.warnings), told.replace("refuse 1 of", "refuse 0, or lose half its digits at 1, of"))
        # Each of several tags keeps its area.
        surfaces.add_array(needle.GetCellData(), "Side", np.arange(needle.GetNumberOfCells(), dtype=np.int64) // 8)
        tagged = insideout.tetrahedralize(needle, refine=True, tag_array="Side")
        self.assertEqual(tagged.statistics["RefusedCells"], 0)
        expected = areas_by_tag(insideout.tetrahedralize(needle, refine=False, tag_array="Side"))
        self.assertGreater(len(expected), 1)
        found = areas_by_tag(tagged)
        self.assertEqual(found.keys(), expected.keys())
        np.testing.assert_allclose([found[tag] for tag in expected], list(expected.values()), rtol=1e-12)
        # Options that take a kept surface have it, and no advice of other treatments.
        fixed = insideout.tetrahedralize(needle, refine=True, merge_coplanar_pieces=True)
        self.assertGreater(fixed.statistics["RefusedCells"], 0)
        advice = " ".join(insideout.check_solid(fixed.solid).warnings)
        self.assertIn("which other options keep", advice)
        self.assertNotIn("remeshed", advice)

    def test_a_low_step_goes_but_where_its_tag_would_lose_its_area(self):
        outline = [(0, 0), (1, 0), (1, 1), (0.5, 1), (0.5, 1 + 1e-7), (0, 1 + 1e-7)]
        points = [(x, y, z) for y in (0, 1) for x, z in outline]
        sides = [(k, k + 6, (k + 1) % 6 + 6, (k + 1) % 6) for k in range(6)]
        step = surfaces.polydata(points, [*sides, (0, 1, 2, 3, 4, 5), (11, 10, 9, 8, 7, 6)])
        made = insideout.tetrahedralize(step, refine=True, scale=3e-6)
        self.assertEqual(made.statistics["RefusedCells"], 0)
        self.assertRegex(" ".join(made.warnings), r"where the surface is kept: after \d+ changes to its needles")
        surfaces.add_array(step.GetCellData(), "Side", np.eye(1, step.GetNumberOfCells(), 3, dtype=np.int64)[0])
        tagged = insideout.tetrahedralize(step, refine=True, scale=3e-6, tag_array="Side")
        self.assertGreater(tagged.statistics["RefusedCells"], 0)
        self.assertAlmostEqual(areas_by_tag(tagged)["1"] / 9e-19, 1, 6)

    def test_a_small_solid_keeps_its_surface_where_inner_cells_can_be_mended(self):
        made = insideout.tetrahedralize(surfaces.ball(1, 80, 40), refine=True, scale=3e-5)
        self.assertEqual(made.statistics["RefusedCells"], 0)
        self.assertNotIn("SurfaceTolerance", made.statistics)

    def test_a_surface_is_kept_if_remeshing_leaves_cells_too_small_in_this_unit(self):
        made = insideout.tetrahedralize(surfaces.ball(1, 80, 40), refine=True, scale=3e-6)
        self.assertNotIn("SurfaceTolerance", made.statistics)
        (warning,) = insideout.check_solid(made.solid).warnings
        self.assertRegex(warning, r"refuses (\d+) of .*: they would pass in a smaller unit")

    def test_a_surface_whose_wide_needle_a_solver_would_refuse_is_remeshed_and_told(self):
        made = insideout.tetrahedralize(self.needle(1e-4), refine=True, scale=3e-6)
        self.assertEqual(made.statistics["RefusedCells"], 0)
        self.assertRegex(" ".join(made.warnings), r"where the surface is kept: it is remeshed, within \S+, and 0 are left; set")

    def test_a_needle_beside_a_hole_is_remeshed_for_holes_have_no_name_of_the_users(self):
        made = insideout.tetrahedralize(self.needle(1e-4, is_open=True), refine=True, scale=3e-6)
        self.assertEqual(made.statistics["RefusedCells"], 0)
        self.assertRegex(" ".join(made.warnings), "where the surface is kept: it is remeshed")
        areas = areas_by_tag(made)
        self.assertAlmostEqual(areas["hole"] / 3.6e-11, 1, 6)
        self.assertAlmostEqual(areas["surface"] / 1.8e-10, 1, 6)

    def test_needles_of_the_surface_are_told_and_gone_after_the_advice(self):
        needles = surfaces.joined(surfaces.box(), surfaces.box((0.1, 0, 1 - 1e-4)))
        surface = self.file("needles.ply", needles)
        done = run_here("mesh", surface, self.path("solid.msh"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"Warning: .*solid\.msh: a solver .*(they|\d+ of them) lie on needles of the surface, which --surface-treatment remeshed replaces")
        done = run_here("mesh", surface, self.path("solid.msh"), "--surface-treatment", "remeshed", "--force")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("a solver", done.stdout)

    def test_no_cell_is_flat_below_facets_in_one_plane_but_for_their_rounding(self):
        for sides in (6, 8, 12):
            angles = 2 * np.pi * np.arange(sides) / sides
            rims = [np.column_stack([np.cos(angles), np.sin(angles), np.full(sides, z)]) for z in (0, 1)]
            c, s = np.cos(0.3), np.sin(0.3)
            turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
            points = np.vstack([*rims, [[0, 0, 0], [0, 0, 1]]]) @ turn.T
            triangles = []
            for i in range(sides):
                j = (i + 1) % sides
                a, b, c, d = i, j, sides + i, sides + j
                triangles += [(a, b, d), (a, d, c)] if i % 2 else [(a, b, c), (b, d, c)]
                triangles += [(2 * sides, b, a), (2 * sides + 1, c, d)]
            solid = insideout.tetrahedralize((points, triangles), refine=True, surface_treatment="kept").solid
            self.assertGreater(insideout.check_solid(solid).statistics["MinDihedralAngle"], 5, sides)

    def test_files_for_no_solver_have_no_word_of_it(self):
        done = run_here("mesh", self.file("plate.ply", slanting_plate()), self.output)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("a solver", done.stdout)
        self.assertGreater(read_grid(self.output).GetNumberOfCells(), 0)


class Judge(CommandLine):
    """Testing/Judge/judge-fit.py, with CalculiX and gmsh."""

    PROGRAM = Path(__file__).resolve().parent.parent / "Judge" / "judge-fit.py"

    def test_it_finds_a_sound_solid_sound_in_all_analyses(self):
        box = self.file("box.ply", surfaces.box())
        for more in ((), ("--quadratic-cells",)):
            done = subprocess.run(
                [sys.executable, self.PROGRAM, box, "--diagonal", "100", "--analyses", "1", *more], capture_output=True, text=True, check=False
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("mm: gmsh and the analyses find something wrong with 0 solids", done.stdout)

    def test_it_holds_a_box_that_stands_on_a_corner(self):
        box = self.file("box.ply", surfaces.turned_boxes(0)[0])
        done = subprocess.run([sys.executable, self.PROGRAM, box, "--analyses", "1"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_shares_are_of_the_surfaces_given(self):
        boxes = [self.file(f"{name}.ply", surfaces.box()) for name in "abc"]
        done = subprocess.run([sys.executable, self.PROGRAM, *boxes, "--share", "2/2"], capture_output=True, text=True, check=False)
        self.assertEqual(re.findall(r"(.)\.ply in (\w+): CalculiX refuses 0 of 12 cells", done.stdout), [("b", "mm"), ("b", "m")])

    def test_it_tells_of_what_is_wrong(self):
        spec = importlib.util.spec_from_file_location("judge_fit", self.PROGRAM)
        judge = importlib.util.module_from_spec(spec)
        with unittest.mock.patch.dict(sys.modules, {"judge_fit": judge}):  # its dataclass looks there
            spec.loader.exec_module(judge)
        solid = insideout.tetrahedralize(surfaces.box(), refine=True).solid
        path = Path(self.folder)
        insideout.write(solid, path / "solid.inp")
        with unittest.mock.patch.object(judge, "ANALYSES", judge.ANALYSES.replace("{gravity}", "1{gravity}")):
            (said,) = judge.wrong_in_analyses(path, solid)
        self.assertRegex(said, "^the supports bear .*, and the weight is ")
        solid.cells[0, :2] = solid.cells[0, 1::-1]
        insideout.write(solid, path / "solid.inp")
        self.assertRegex(judge.wrong_in_analyses(path, solid)[0], "^CalculiX ends its analyses with status")


if __name__ == "__main__":
    unittest.main()
