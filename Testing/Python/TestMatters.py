# SPDX-License-Identifier: GPL-3.0-or-later
"""Options that cannot matter are refused before any file is read; and what a run tells: plans, reports, files and the exit status."""

import json
import os
import unittest

import insideout
import surfaces
from command import CommandLine, run_here
from insideout import arguments
from insideout.commands.check import CheckJob
from insideout.estimates import estimate
from insideout.matters import RULES
from insideout.options import Options, flag_of


LAYERS = (("--layers", "3"), ("--first-height", "1"), ("--growth", "1"), ("--layer-tags", "wall"))


class Refused(CommandLine):
    def cases(self) -> tuple:
        stl, vtu, solid, inp = self.path("fixed.stl"), self.output, self.path("a.vtu"), self.path("a.inp")
        return (
            (("mesh", "a.ply", stl, "--quadratic-cells"), "--quadratic-cells", "first order"),
            (("mesh", "a.ply", stl, "--quadratic"), "--quadratic-cells", "first order"),
            *((("mesh", "a.ply", stl, *given), given[0], "has no layers") for given in LAYERS),
            *((("mesh", "a.ply", vtu, "--no-refine", *given), given[0], "layers take refined cells") for given in LAYERS),
            (("mesh", "a.ply", inp, "--no-refine", "--size", "curvature=24"), "--size-rules", "leaves the cells as they are"),
            (("repair", "a.ply", stl, "--refine"), "--refine", "without --edge-length"),
            (("repair", "a.ply", stl, "--no-refine"), "--no-refine", "without --edge-length"),
            (("mesh", "a.ply", vtu, "--no-refine", "--surface-treatment", "split"), "--surface-treatment", "--no-refine leaves the cells"),
            (("repair", "a.ply", stl, "--edge-length", "1", "--surface-treatment", "kept"), "--edge-length", "without --edge-length, or --surface-treatment"),
            (("repair", "a.ply", stl, "--maximum-volume", "1"), "--maximum-volume", "without --edge-length"),
            (("repair", "a.ply", stl, "--surface-treatment", "split", "--surface-tolerance", "1"), "--surface-tolerance", "remeshed"),
            (("refine", solid, vtu, "--feature-angle", "10"), "--feature-angle", "remeshed"),
            (("mesh", "a.ply", vtu, "--material", "steel", "--fix", "a"), "--material", "completes an .inp file"),
            (("mesh", "a.ply", inp, "--material", "steel"), "--material", "--fix"),
            (("mesh", "a.ply", inp, "--fix", "a"), "--fix", "--material"),
            (("mesh", "a.ply", inp, "--pressure", "a", "1"), "--pressure", "--material"),
            (("mesh", "a.ply", inp, "--gravity"), "--gravity", "--material"),
            (("mesh", "a.ply", vtu, "--thicken-all"), "--thicken-all", "--thicken"),
            (("mesh", "a.ply", vtu, "--seeded-regions"), "--seeded-regions", "--seeds"),
            (("mesh", "a.ply", vtu, "--priority", "a"), "--priority", "several bodies"),
            (("mesh", "a.ply", vtu, "--region-rule", "all"), "--region-rule", "several bodies"),
            (("mesh", "a.ply", vtu, "--touch-tolerance", "0"), "--touch-tolerance", "several bodies"),
            (("mesh", "--together", "a.ply", "b.ply", vtu, "--body-array", "B"), "--body-array", "--together makes a body"),
            (("mesh", "a.ply", vtu, "--format", "ply"), "--format", "standard input"),
            (("mesh", "a.ply", vtu, "--msh-version", "2.2"), "--msh-version", ".msh"),
            (("mesh", "a.ply", vtu, "--cells-only"), "--cells-only", ".mesh files"),
            (("mesh", "a.ply", inp, "--material", "steel", "--fix", "a", "--cells-only"), "--cells-only", "supports and loads take tags"),
            (("mesh", "a.ply", vtu, "--from", "mm"), "--from", "--to"),
            (("mesh", "a.ply", vtu, "--to", "mm"), "--to", "--from"),
            (("mesh", "a.ply", vtu, "--to", "mm", "--from", "m", "--scale", "2"), "--scale", "are a scale"),
            (("check", "a.ply", "--json", "--quiet"), "--json", "--quiet prints nothing"),
        )

    def test_options_without_effect_on_the_output_are_refused(self):
        for given, flag, reason in self.cases():
            with self.subTest(given):
                done = run_here(*given)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertRegex(done.stderr, rf"^insideout: {flag} cannot matter here: .*{reason}.* \(see insideout {given[0]} --help\)\n$")
        self.assertEqual(os.listdir(self.folder), [])

    def test_each_rule_has_a_case_above(self):
        tried = {flag for _, flag, _ in self.cases()}
        self.assertEqual({flag_of(name) for rule in RULES for name in rule.names} - tried, {"--grading", "--maximum-cells"})  # as --maximum-volume

    def test_a_curve_is_known_to_lie_in_a_plane(self):
        curve = self.file("curve.csv", "0,0\n1,0\n0,1\n0,0\n")
        done = run_here("mesh", curve, self.path("fixed.stl"))
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("fixed.stl: the boundary is lines, which only .vtp files hold here", done.stderr)
        for option in (("--separate-overlaps",), ("--thicken", "1"), ("--parts-apart",)):
            done = run_here("mesh", curve, self.output, *option)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(f"{option[0]} does nothing in a plane, where {curve} lies", done.stderr)
        done = run_here("mesh", "--together", curve, curve, self.output)
        self.assertIn("--together does nothing in a plane", done.stderr)

    def test_options_with_a_possible_effect_are_taken(self):
        source, stl = self.file("box.ply", surfaces.box()), self.path("fixed.stl")
        for more in (
            ("--edge-length", "0.5", "--surface-treatment", "split"),
            ("--edge-length", "0.5", "--report", self.path("report.json")),
            ("--priority", "box", "--together"),
        ):
            done = run_here("mesh", source, stl, *more, "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)


class Told(CommandLine):
    def setUp(self):
        super().setUp()
        self.source = self.file("open.ply", surfaces.open_box())

    def test_every_file_that_was_written(self):
        files = {"hull": "hull.vtu", "boundary": "b.ply", "outliers": "o.vtp", "report": "r.json"}
        given = [word for name, file in files.items() for word in ("--" + name, self.path(file))]
        done = run_here("mesh", self.source, self.output, *given)
        told = {line.split()[2] for line in done.stdout.splitlines() if line.startswith("Wrote ")}
        self.assertEqual(told, {os.path.join(self.folder, name) for name in os.listdir(self.folder)} - {self.source})

    def test_a_report_instead_of_the_summary(self):
        done = run_here("mesh", self.source, self.output, "--json", "--report", self.path("report.json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        printed = json.loads(done.stdout)
        with open(self.path("report.json"), encoding="utf-8") as file:
            self.assertEqual(printed, json.load(file))
        self.assertEqual(printed["outputs"], {"solid": self.output})

    def test_a_line_for_each_surface_also_where_it_fails(self):
        done = run_here("check", self.source, self.path("missing.ply"), "--json")
        first, second = map(json.loads, done.stdout.splitlines())
        self.assertEqual((done.returncode, first["exit_status"], second["exit_status"]), (1, 0, 1))
        self.assertIn("missing.ply: no such file", second["error"])
        self.assertIn("missing.ply: no such file", done.stderr)

    def test_the_file_in_every_error_of_the_work(self):
        nan = self.file("nan.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 nan\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
        empty = self.file("empty.off", "OFF\n0 0 0\n")
        for path, words in ((nan, "point 3"), (empty, "empty")):
            for command in (("check", path), ("mesh", path, self.output), ("repair", path, self.path("x.ply"))):
                self.check_failure(run_here(*command), path, words)

    def test_standard_input_in_errors_too(self):
        options, (files,) = arguments.parse(["check", "-"])
        self.assertEqual(CheckJob(options, files).naming("near-coincident point 3"), "standard input: near-coincident point 3")
        self.assertEqual(CheckJob(options, files).naming("standard input, line 2"), "standard input, line 2")

    def test_arguments_that_make_no_sense_end_with_2_and_all_else_that_fails_with_1(self):
        points = self.file("points.csv", "x,y,z\n0,0,0\n")
        for status, given in (
            (2, ("mesh",)),
            (2, ("mesh", self.source, self.output, "--gamma", "-3")),
            (2, ("mesh", self.source, self.output, "--gamma", "much")),
            (2, ("mesh", self.source, self.path("solid.xyz"))),
            (2, ("mesh", self.source, self.output, "--hull", self.output)),
            (2, ("mesh", self.source, self.output, "--scale", "0")),
            (1, ("mesh", self.path("missing.ply"), self.output)),
            (1, ("mesh", self.source, self.path("missing/solid.vtu"))),
            (1, ("query", points, self.file("bad.ply", "ply\n"), self.path("w.csv"))),
        ):
            with self.subTest(given):
                self.assertEqual(run_here(*given).returncode, status)

    def test_a_table_of_answers_is_replaced_and_one_of_others_is_not(self):
        points, answers = self.file("points.csv", "x,y,z\n0.5,0.5,0.5\n"), self.path("answers.csv")
        for _ in range(2):
            self.assertEqual(run_here("query", points, self.source, answers, "--quiet").returncode, 0)
        other = self.file("other.csv", "x,y,z,weight\n1,2,3,4\n")
        self.check_failure(run_here("query", points, self.source, other), f"{other} was not written by insideout")
        with open(other, encoding="utf-8") as file:
            self.assertEqual(file.read(), "x,y,z,weight\n1,2,3,4\n")
        self.assertEqual(run_here("query", points, self.source, other, "--force", "--quiet").returncode, 0)


class DryRun(CommandLine):
    def setUp(self):
        super().setUp()
        self.source, self.other = self.file("open.ply", surfaces.open_box()), self.file("other.ply", surfaces.box((2, 0, 0)))
        self.cells = self.path("cells.vtu")
        insideout.write(insideout.tetrahedralize(self.other), self.cells)
        self.points = self.file("points.csv", "x,y,z\n0,0,0\n")

    def test_it_tells_of_the_input_and_of_files_and_writes_none(self):
        before = sorted(os.listdir(self.folder))
        closed = "bounds a solid of volume 1"
        for given, *expected in (
            (("mesh", self.source, self.output, "--report", self.path("r.json")), "volume about 1.00000 (95 %: 0.99990 to 1.00010), once", "tetrahedra", f"Would write report     {self.path('r.json')}"),
            (("repair", self.other, self.path("fixed.ply")), closed, f"Would write surface    {self.path('fixed.ply')}"),
            (("boolean", "A | B", self.source, self.other, self.output), "Surface open.ply: ", "Surface other.ply: ", "Would write solid"),
            (("mesh", "--together", self.source, self.other, self.output), "Surface open.ply: ", "Surface other.ply: ", "Would write solid"),
            (("draw", self.source, self.path("picture.png")), "once its holes are closed", "Would write picture"),
            (("query", self.points, self.source, self.path("w.csv")), "Would write winding"),
            (("refine", self.cells, self.output), "Solid cells.vtu: ", "in 1 part", "Would write solid"),
            (("mesh", self.source, self.cells), f"Would replace solid      {self.cells}"),
        ):
            with self.subTest(given):
                done = run_here(*given, "--dry-run")
                self.assertEqual(done.returncode, 0, done.stderr)
                for words in expected:
                    self.assertIn(words, done.stdout)
                self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_it_fails_where_the_run_would_before_its_work(self):
        for given in ((self.path("missing.ply"), self.output), (self.source, self.path("no/solid.vtu")), (self.source, self.output, "--gamma", "-1")):
            dry, done = run_here("mesh", *given, "--dry-run"), run_here("mesh", *given)
            self.assertEqual((dry.returncode, dry.stderr), (done.returncode, done.stderr))
            self.assertGreater(dry.returncode, 0)

    def test_estimates_are_of_the_order_of_what_is_made(self):
        ball = self.file("ball.ply", surfaces.ball(1, 20, 20))
        for more in ((), ("--edge-length", "10%")):
            estimated = json.loads(run_here("mesh", ball, self.output, *more, "--dry-run", "--json").stdout)["estimate"]
            made = json.loads(run_here("mesh", ball, self.output, *more, "--json").stdout)["statistics"]
            cells = made.get("RefinedCells", made["InsideCells"])
            self.assertLess(max(estimated["cells"] / cells, cells / estimated["cells"]), 2.5)

    def test_layers_are_estimated_too(self):
        ball = self.file("ball.ply", surfaces.ball(1, 20, 20))
        layers = ("--layers", "4", "--first-height", "0.02")
        for more in ((), ("--edge-length", "10%")):
            dry = json.loads(run_here("mesh", ball, self.output, *layers, *more, "--dry-run", "--json").stdout)["estimate"]
            made = json.loads(run_here("mesh", ball, self.output, *layers, *more, "--json").stdout)["statistics"]
            prisms = made["Prisms"]
            self.assertLess(max(dry["layer_cells"] / prisms, prisms / dry["layer_cells"]), 3)
        self.assertRegex(run_here("mesh", ball, self.output, *layers, "--dry-run").stdout, r"about [0-9,]+ cells, [0-9,]+ of them in layers, in ")

    def test_more_cells_than_the_limit_are_told(self):
        words = "so short an --edge-length asks for more cells than --maximum-cells allows: the work would stop before refining"
        for more, expected in ((("0.1",), False), (("0.002",), True), (("0.1", "--maximum-cells", "100"), True), (("0.002", "--maximum-cells", "0"), False)):
            with self.subTest(more):
                said = run_here("mesh", self.other, self.output, "--edge-length", *more, "--dry-run").stdout
                self.assertEqual(words in said, expected, said)

    def test_lengths_whose_cubes_are_no_doubles_are_estimated(self):
        few = estimate(insideout.check(surfaces.box()).statistics, Options(edge_length=1e200))
        many = estimate(insideout.check(surfaces.box()).statistics, Options(edge_length=1e-200))
        self.assertLess(few.cells, 1000)
        self.assertEqual(many.words(), "more tetrahedra than can be counted")


if __name__ == "__main__":
    unittest.main()
