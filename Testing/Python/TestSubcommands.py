# SPDX-License-Identifier: GPL-3.0-or-later
"""The subcommands of `insideout`: each does what its long-standing form does, and has a help of one screen."""

import json
import os
import re
import shlex
import unittest
import unittest.mock

import insideout
import surfaces
from command import CommandLine, read_grid, run, run_here
from insideout import arguments
from insideout.files import read_surface
from insideout.help import all_screens, screen, screen_of
from insideout.usage import COMMANDS, OTHER_FLAGS, TOPICS, argument_of
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

LINES, COLUMNS = 40, 80  # of a screen
MEASURED = ("Seconds", "PeakMemory")


class Same(CommandLine):
    """The same bytes and reports as the form without the subcommand gives, or the function."""

    def setUp(self):
        super().setUp()
        self.source = self.file("boxes.ply", surfaces.two_boxes_and_a_stray_facet())
        self.other = self.file("other.ply", surfaces.box((0.5, 0, 0)))
        self.cells = self.path("cells.vtu")
        insideout.write(insideout.tetrahedralize(self.source), self.cells)

    def results(self, arguments: tuple[str, ...], names: list[str]) -> list:
        """The command's output and the content of some files, without measured values."""
        done = run(*arguments, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        without_seconds = re.sub(r" +[\d,]+\.\d(?=  \S)", "", done.stdout)  # of tables
        printed = [line for line in without_seconds.splitlines() if not re.match(r"Time |  .* s$", line)]
        stages = [line.split("  ")[0] for line in done.stderr.splitlines()]
        return [printed, stages, *(self.taken(name) for name in names)]

    def taken(self, name: str):
        """The content of a file, which is removed."""
        with open(self.path(name), "rb") as file:
            content = file.read()
        os.remove(self.path(name))
        if not name.endswith(".json"):
            return content
        found = json.loads(content)
        found["statistics"] = {key: value for key, value in found["statistics"].items() if not key.startswith(MEASURED)}
        return found

    def check_same(self, subcommand: str, long_standing: str, *names: str):
        found, expected = (self.results(tuple(shlex.split(form)), [*names]) for form in (subcommand, long_standing))
        for one, other in zip(found, expected):
            self.assertEqual(one, other)

    def test_mesh(self):
        files = "--hull hull.msh --boundary boundary.ply --outliers outliers.stl --report report.json"
        names = ("hull.msh", "boundary.ply", "outliers.stl", "report.json")
        self.check_same(f"mesh boxes.ply solid.msh {files} --gamma 1", f"boxes.ply solid.msh {files} --gamma 1", "solid.msh", *names)
        together = "--together boxes.ply other.ply both.inp --priority other --edge-length 0.5"
        self.check_same("mesh " + together, together, "both.inp")
        self.check_same("mesh boxes.ply other.ply '{}.mesh'", "boxes.ply other.ply '{}.mesh'", "boxes.mesh", "other.mesh")
        self.check_same("mesh boxes.ply fixed.stl", "boxes.ply fixed.stl", "fixed.stl")

    def test_repair(self):
        self.check_same("repair other.ply fixed.ply", "other.ply fixed.ply", "fixed.ply")
        files = "boxes.ply fixed.ply --outliers outliers.off --report report.json"
        self.check_same("repair " + files, files + " --surface-only", "fixed.ply", "outliers.off", "report.json")

    def test_check(self):
        for words in ("boxes.ply --report report.json --scale 2", "cells.vtu --report report.json"):
            self.check_same("check " + words, "--check " + words, "report.json")
        self.check_same("check boxes.ply other.ply cells.vtu", "--check boxes.ply other.ply cells.vtu")

    def test_boolean(self):
        for output in ("made.ply", "made.msh"):
            words = f"'boxes - other' boxes.ply other.ply {output} --boundary boundary.off --report report.json"
            self.check_same("boolean " + words, "--boolean " + words, output, "boundary.off", "report.json")

    def test_query_says_what_writes_grids_in_other_formats(self):
        insideout.write(insideout.sdf_grid(surfaces.box(), shape=3), self.path("grid.vti"))
        for output in ("mask.nrrd", "mask.npz"):
            done = run_here("query", self.path("grid.vti"), self.file("box.ply", surfaces.box()), self.path(output), "--distance")
            said = f"{output}: unknown ending, it must be .vti, as of {self.path('grid.vti')}; in Python insideout.sdf_grid makes grids"
            self.check_failure(done, said)

    def test_query(self):
        self.file("points.csv", "x,y,z,name\n0.5,0.5,0.25,in\n3,3,3,out\n")
        for words in ("points.csv other.ply w.csv", "points.csv boxes.ply w.csv --distance --orientation as-given --report w.json"):
            names = [name for name in ("w.csv", "w.json") if name in words]
            self.check_same("query " + words, "--winding " + words, *names)

    def test_draw(self):
        self.assertEqual(run("draw", "boxes.ply", "picture.png", "--quiet", cwd=self.folder).returncode, 0)
        self.assertEqual(run("boxes.ply", "solid.vtu", "--plot", "plot.png", "--quiet", cwd=self.folder).returncode, 0)
        self.assertEqual(self.taken("picture.png"), self.taken("plot.png"))
        self.check_same("draw cells.vtu angles.png", "--check cells.vtu --plot angles.png", "angles.png")

    def test_refine_is_the_function(self):
        solid = insideout.check_solid(self.cells).solid
        surfaces.add_array(solid.GetPointData(), "Size", [0.4] * solid.GetNumberOfPoints())
        insideout.write(solid, self.path("sized.vtu"))
        for words, options in (
            ("cells.vtu --edge-length 0.4 --quadratic-cells", {"edge_length": 0.4, "quadratic_cells": True}),
            ("sized.vtu --sizes Size --surface-treatment split", {"sizes": "Size", "surface_treatment": "split"}),
        ):
            name, *others = words.split()
            refined = insideout.refine(self.path(name), **options)
            insideout.write(refined.solid, self.path("expected.msh"))
            done = run("refine", self.path(name), self.path("refined.msh"), *others, "--report", self.path("report.json"))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"refined to {refined.statistics['RefinedCells']:,} tetrahedra", done.stdout)
            self.assertEqual(self.taken("refined.msh"), self.taken("expected.msh"))
            found = self.taken("report.json")
            self.assertEqual(found["statistics"]["AddedPoints"], refined.statistics["AddedPoints"])
            for option, value in options.items():
                self.assertEqual(found["parameters"][option], value)
        self.assertEqual(self.results(("refine", "cells.vtu", "refined.inp"), [])[1], ["reading", "refining", "writing"])

    def test_an_option_that_was_called_otherwise_says_nothing(self):
        words = "boxes.ply solid.msh --edge-length 0.5 "
        self.check_same(words + "--surface-treatment split", words + "--surface split", "solid.msh")


class Help(unittest.TestCase):
    def text(self, *given: str) -> str:
        with unittest.mock.patch.dict(os.environ, COLUMNS=str(COLUMNS)):
            done = run_here(*given)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_each_is_one_screen(self):
        for given in ((), *((name,) for name in COMMANDS)):
            with self.subTest(given):
                text = self.text(*given, "--help")
                self.assertEqual(text, self.text(*given, "-h"))
                self.assertLessEqual(len(text.splitlines()), LINES, "shorten what usage.py or options.py say")
                self.assertLessEqual(max(map(len, text.splitlines())), COLUMNS)
                self.assertIn("usage: insideout " + "".join(given), text)
                self.assertIn("--help-all", text)

    def test_narrow_terminals_have_it_too(self):
        for columns in ("1", "27"):
            with unittest.mock.patch.dict(os.environ, COLUMNS=columns):
                for given in (("--help",), ("--help-all",), *((name, "--help") for name in COMMANDS)):
                    self.assertEqual(run_here(*given).returncode, 0)

    def test_the_first_has_the_commands_and_what_stands_for_them(self):
        text = screen()
        for name, command in COMMANDS.items():
            self.assertRegex(text, rf"(?m)^  {name} +{re.escape(command.names())} +{re.escape(command.gist)}$")
        for name in ("mesh", "repair", "check"):
            self.assertRegex(text, rf"(?m)^  insideout {name} broken\.")
        for option, hint in (("--check", "check"), ("--winding POINTS", "query"), ("--boolean EXPRESSION", "boolean"), ("--together", "mesh")):
            self.assertRegex(text, rf"(?m)^  {option} +as insideout {hint}\b")

    def test_nothing_is_lost(self):
        """A screen names all options, and the second one says of each what it means."""
        hidden = [flag for flags in OTHER_FLAGS.values() for flag in flags]  # -o stands beside --output
        for name in COMMANDS:
            with self.subTest(name):
                known = {option for option in arguments._parser_of(name)._option_string_actions if option not in (*hidden, "-h", "--help", "--help-all")}
                named = set(re.findall(r"(?<!insideout)[ (](--[\w-]+)", screen_of(name).rpartition("\n\n")[0]))
                self.assertEqual(named, known)
                told = " ".join(screen_of(name, everything=True).split())
                for option in COMMANDS[name].options:
                    self.assertIn(" ".join(argument_of(option)["help"].split()), told)
        of_topics = [option for options in TOPICS.values() for option in options]
        self.assertEqual(len(of_topics), len(set(of_topics)))
        self.assertEqual(set(of_topics), {option for command in COMMANDS.values() for option in command.options})
        short = set(arguments._parser_of_short_form()._option_string_actions)
        self.assertEqual(short - set(arguments._parser_of("mesh")._option_string_actions), {"--check", "--winding", "--boolean", "--distance", "--version"})

    def test_all_of_it(self):
        text = self.text("--help-all")
        self.assertTrue(text.startswith(self.text("--help")))
        for name in COMMANDS:
            self.assertIn(self.text(name, "--help-all"), text)
        self.assertNotIn("--surface ", text)

    def test_examples_are_understood(self):
        examples = re.findall(r"(?m)^  (?:zcat .* \| )?insideout (\w+ .*\.\w+.*)$", all_screens())
        self.assertGreater(len(examples), 15)
        for words in examples:
            with self.subTest(words):
                given = shlex.split(words.replace("*", "a"))
                self.assertEqual(arguments.parse(given)[0].command, given[0])


class Names(CommandLine):
    def test_a_file_called_like_a_command_is_reached_with_its_folder(self):
        for name in COMMANDS:
            self.file(name, "")
            done = run(f"./{name}", self.output, cwd=self.folder)
            self.check_failure(done, f"./{name}: unknown ending, it must be .ply")
        box = self.file("box.ply", surfaces.box())
        self.check_failure(run(box, "check", cwd=self.folder), "check: unknown ending, it must be .vtu")
        os.remove(self.path("draw"))
        os.mkdir(self.path("draw"))
        os.rename(box, self.path("draw/box.ply"))
        done = run("draw/box.ply", self.output, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_another_word_is_a_file(self):
        for word in ("chekc", "Mesh", "--help.ply", "missing.ply"):
            known = [run_here(*given, self.output) for given in ((word,), ("mesh", word))]
            self.check_failure(known[0])
            self.assertEqual(known[0].stderr.replace("(see --help)", "(see insideout mesh --help)"), known[1].stderr)
        self.check_failure(run_here("chekc", self.output), "chekc: unknown ending, it must be .ply")
        self.check_failure(run_here("chekc.ply", self.output), "chekc.ply: no such file")


class Refused(CommandLine):
    def test_arguments_without_use_are_refused(self):
        box = self.file("box.ply", surfaces.box())
        cells = self.path("cells.vtu")
        insideout.write(insideout.tetrahedralize(box).solid, cells)
        query = self.file("points.csv", "0,0,0\n")
        for given, expected in (
            (("mesh", box), "required: OUTPUT (see insideout mesh --help)"),
            (("mesh",), "required: SURFACE... OUTPUT (see insideout mesh --help)"),
            (("mesh", box, self.output, "--check"), "unrecognized arguments: --check"),
            (("repair", box, self.output), "solid.vtu: unknown ending, it must be .vtp .ply"),
            (("repair", box, self.path("fixed.stl"), "--hull", self.output), "unrecognized arguments: --hull"),
            (("check", box, "--gamma", "1"), "unrecognized arguments: --gamma 1 (see insideout check --help)"),
            (("check", box, self.output), "check meshes nothing: it goes without OUTPUT.vtu"),
            (("check", box, "--plot", self.path("picture.png")), "check meshes nothing: it goes without --plot"),
            (("--check", box, "-o", self.output), "--check meshes nothing: it goes without --output"),
            (("--check", box, "--force"), "--check meshes nothing: it goes without --force"),
            (("draw", "--together", cells, cells, self.path("angles.png")), "--together is about surfaces: it goes without " + cells),
            (("check", cells, "--orientation", "as-given"), "--orientation is about surfaces: it goes without " + cells),
            (("refine", cells, self.path("fixed.ply")), "fixed.ply: unknown ending, it must be .vtu"),
            (("refine", box, self.output), "box.ply: unknown ending, it must be .vtu"),
            (("refine", cells, self.output, "--sizes", "None"), "None"),
            (("refine", cells, self.output, "--grading", "0"), "grading is 0"),
            (("refine", cells, cells), "named twice"),
            (("boolean", "A"), "required: SURFACE... OUTPUT (see insideout boolean --help)"),
            (("boolean", " ", box, self.output), "insideout: boolean is given no expression"),
            (("query", query, box), "required: OUTPUT.csv"),
            (("query", query, box, self.path("w.vti")), "w.vti: unknown ending"),
            (("draw", box, self.output), "solid.vtu: unknown ending, it must be .png"),
            (("draw", cells, self.path("angles.png"), "--gamma", "1"), "--gamma is about surfaces"),
            (("draw", box, self.path("picture.png"), "--surface-only"), "unrecognized arguments: --surface-only"),
        ):
            with self.subTest(given):
                before = sorted(os.listdir(self.folder))
                self.check_failure(run_here(*given), expected)
                self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_a_picture_is_drawn_where_nothing_is_inside(self):
        source, picture = self.file("both.ply", surfaces.closed_both_ways()), self.path("picture.png")
        self.check_failure(run("draw", source, picture, "--orientation", "as-given"), "nothing is inside")
        self.assertTrue(os.path.exists(picture))


class Winding(CommandLine):
    def test_a_table_keeps_its_columns_and_gains_w(self):
        query = self.file("query.csv", "x,y,z,name\n0.5,0.5,0.5,in\n2,2,2,out\n")
        result = self.path("w.csv")
        done = run("--winding", query, self.file("box.ply", surfaces.box()), result)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(result, encoding="utf-8") as file:
            self.assertEqual(file.read().splitlines(), ["x,y,z,name,w,inside", "0.5,0.5,0.5,in,1.0,1", "2,2,2,out,0.0,0"])
        self.assertIn("1 of 2 places are inside", done.stdout)

    def test_a_table_that_has_w_gets_it_anew_and_keeps_all_else(self):
        box = self.file("box.ply", surfaces.box())
        for text, expected in (
            ("x,y,z,w,Name\n0.50,5e-1,.5,7,\"a, b\"\n2,2,2,,größer\n", 'x,y,z,w,Name,inside\n0.50,5e-1,.5,1.0,"a, b",1\n2,2,2,0.0,größer,0\n'),
            ("X,Y,Z,Inside,note,W\n2,2,2,maybe,0x1F,nan\n", "X,Y,Z,Inside,note,W\n2,2,2,0,0x1F,0.0\n"),
            ("x,y,z, w \n2,2,2\n", "x,y,z, w ,inside\n2,2,2,0.0,0\n"),
            ("2,2,2,left\n3,3,3\n", "x,y,z,,w,inside\n2,2,2,left,0.0,0\n3,3,3,,0.0,0\n"),
        ):
            with self.subTest(text):
                done = run("--winding", self.file("query.csv", text), box, self.path("w.csv"))
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(self.path("w.csv"), encoding="utf-8") as file:
                    self.assertEqual(file.read(), expected)
                again = run("--winding", self.path("w.csv"), box, self.path("again.csv"))
                self.assertEqual(again.returncode, 0, again.stderr)
                with open(self.path("again.csv"), encoding="utf-8") as file:
                    self.assertEqual(file.read(), expected)

    def test_bytes_of_other_columns_that_are_no_text_are_kept(self):
        query = self.file("query.csv", b"x,y,z,name\r\n2,2,2,gr\xf6\xdfer\r\n")
        done = run("--winding", query, self.file("box.ply", surfaces.box()), self.path("w.csv"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("w.csv"), "rb") as file:
            self.assertEqual(file.read(), b"x,y,z,name,w,inside\r\n2,2,2,gr\xf6\xdfer,0.0,0\r\n")

    def test_a_table_may_lack_a_heading_and_may_be_empty(self):
        for text, lines in (("0.5,0.5,0.5\n", 2), ("x,y,z\n", 1), ("", 1)):
            with self.subTest(text):
                done = run("--winding", self.file("q.csv", text), self.file("box.ply", surfaces.box()), self.path("w.csv"))
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(self.path("w.csv"), encoding="utf-8") as file:
                    self.assertEqual(len(file.readlines()), lines)

    def test_an_image_gains_w(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        image.SetOrigin(-0.5, -0.5, -0.5)
        writer = vtkXMLImageDataWriter()
        writer.SetDataModeToBinary()
        writer.SetFileName(self.path("query.vti"))
        writer.SetInputData(image)
        insideout.pipeline.run(writer)
        done = run("--winding", self.path("query.vti"), self.file("box.ply", surfaces.box()), self.path("w.vti"))
        self.assertEqual(done.returncode, 0, done.stderr)
        reader = vtkXMLImageDataReader()
        reader.SetFileName(self.path("w.vti"))
        insideout.pipeline.run(reader)
        w = surfaces.point_array(reader.GetOutput(), "w")
        self.assertEqual([round(value) for value in w], [int(k == 13) for k in range(27)])

    def test_distances_are_added_where_they_are_asked_for(self):
        query = self.file("query.csv", "x,y,z\n0.5,0.5,0.25\n3,0.5,0.5\n")
        box = self.file("box.ply", surfaces.box())
        done = run("--winding", query, box, self.path("w.csv"), "--distance")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("w.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read().splitlines(), ["x,y,z,w,inside,distance", "0.5,0.5,0.25,1.0,1,-0.25", "3,0.5,0.5,0.0,0,2.0"])
        self.check_failure(run("--distance", box, self.path("solid.vtu")), "--distance goes with --winding")

    def test_bad_queries(self):
        box = self.file("box.ply", surfaces.box())
        for name, content, result, expected in (
            ("words.csv", "x,y,z\n0,0,0\n1,two,3\n", "w.csv", "words.csv, line 3"),
            ("columns.csv", "a,b,c\n", "w.csv", "they must be x, y, z"),
            ("no.vti", "<VTKFile", "w.vti", "no.vti"),
            ("no.txt", "", "w.txt", "unknown ending"),
            ("other.csv", "0,0,0\n", "w.vti", "w.vti: unknown ending"),
            ("missing.csv", None, "w.csv", "no such file"),
        ):
            with self.subTest(name):
                query = self.path(name) if content is None else self.file(name, content)
                self.check_failure(run("--winding", query, box, self.path(result)), expected)


class SurfaceOnly(CommandLine):
    def test_a_closed_surface_is_repaired_without_tetrahedra(self):
        surface, fixed = self.file("broken.ply", surfaces.two_boxes()), self.path("fixed.ply")
        for arguments, is_made in (((), False), (("--report", self.path("report.json")), True), (("--gamma", "3"), True)):
            done = run(surface, fixed, *arguments)
            self.assertEqual((done.returncode, "closed: its boundary was found without" in done.stdout), (0, not is_made), done.stdout)
            self.assertEqual("tetrahedra inside" in done.stdout, is_made)
            self.assertIn("  volume 1.875", done.stdout)
            self.assertTrue(surfaces.is_watertight(read_surface(fixed)[0]))
            self.assertAlmostEqual(surfaces.enclosed_volume(read_surface(fixed)[0]), 15 / 8, 12)
        done = run(surface, fixed, "--surface-only", "--report", self.path("report.json"))
        self.assertIn("without tetrahedra", done.stdout, done.stderr)
        with open(self.path("report.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["statistics"]["Tetrahedra"], 0)

    def test_an_open_one_goes_through_them(self):
        done = run(self.file("broken.ply", surfaces.open_box()), self.path("fixed.ply"))
        self.assertIn("tetrahedra inside", done.stdout, done.stderr)
        self.assertTrue(surfaces.is_watertight(read_surface(self.path("fixed.ply"))[0]))

    def test_outputs_of_cells_are_refused_beside_surface_only(self):
        surface = self.file("broken.ply", surfaces.two_boxes())
        self.check_failure(run(surface, self.output, "--surface-only"), "solid.vtu: takes tetrahedra, which --surface-only goes without")


class SetOperations(CommandLine):
    def bodies(self) -> list[str]:
        return [self.file("bone.ply", surfaces.box()), self.file("left lung.ply", surfaces.box((0.5, 0, 0)))]

    def test_the_ending_says_what_is_written_of_the_result(self):
        for number, (expression, volume) in enumerate({"bone - 'left lung'": 0.5, "A & B": 0.5, "#1 | #2": 1.5}.items()):
            fixed, grid = self.path(f"{number}.ply"), self.path(f"{number}.vtu")
            done = run("--boolean", expression, *self.bodies(), fixed)
            self.assertIn(f"  volume {volume:g}", done.stdout, done.stderr)
            self.assertIn("without tetrahedra", done.stdout)
            self.assertAlmostEqual(surfaces.enclosed_volume(read_surface(fixed)[0]), volume, 12)
            boundary, report = self.path("boundary.stl"), self.path("report.json")
            done = run("--boolean", expression, *self.bodies(), grid, "--boundary", boundary, "--report", report)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertAlmostEqual(float(sum(surfaces.exact_volumes(read_grid(grid)))), volume, 12)
            self.assertAlmostEqual(surfaces.enclosed_volume(read_surface(boundary)[0]), volume, 6)
            with open(report, encoding="utf-8") as file:
                found = json.load(file)
            self.assertEqual((found["parameters"]["expression"], found["bodies"]), (expression, ["bone", "left lung"]))
        done = run("--boolean", "A - B", *self.bodies(), self.path("rest.msh"))
        self.assertIn("Wrote solid", done.stdout, done.stderr)

    def test_wrong_expressions_and_options_are_one_line(self):
        for expression, words in {"A - (B": "column 5: this parenthesis is never closed", "A - C": "no body is called C; there are bone, left lung",
                                  " ": "--boolean is given no expression", "A - A": "nothing is left of A - A"}.items():
            self.check_failure(run("--boolean", expression, *self.bodies(), self.output), words)
        for option in (("--winding", self.path("q.csv")), ("--gamma", "1"), ("--hull", self.path("hull.vtu")), ("--together",)):
            self.check_failure(run("--boolean", "A", *self.bodies(), self.output, *option), "it goes without --")


if __name__ == "__main__":
    unittest.main()
