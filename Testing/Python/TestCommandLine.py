# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m insideout`, each time as a process of its own."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import insideout
import surfaces
from insideout.files import read_surface, write_surface
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def run(*arguments: str, **options) -> subprocess.CompletedProcess:
    return subprocess.run(
        [sys.executable, "-m", "insideout", *arguments], capture_output=True, text=True, timeout=120, check=False, **options
    )


def read_grid(path: str):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    insideout.pipeline.run(reader)
    return reader.GetOutput()


OFF_BOX = "\n".join(
    ["OFF", "8 12 0"]
    + ["{} {} {}".format(*point) for point in surfaces.box_points()]
    + ["3 {} {} {}".format(*facet) for facet in surfaces.BOX_FACETS]
)


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.output = self.path("solid.vtu")

    def path(self, name: str) -> str:
        return os.path.join(self.folder, name)

    def file(self, name: str, content) -> str:
        """Write a file: text, bytes, or a surface in the format of the name's ending."""
        if isinstance(content, (str, bytes)):
            with open(self.path(name), "wb") as file:
                file.write(content.encode() if isinstance(content, str) else content)
        else:
            write_surface(content, self.path(name))
        return self.path(name)

    def check_failure(self, done: subprocess.CompletedProcess, *expected: str):
        """One line that says what, no traceback, no file."""
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertNotIn("ERR|", done.stderr)
        errors = [line for line in done.stderr.splitlines() if line.startswith("insideout: ")]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertEqual(done.stderr.splitlines()[-1], errors[0])
        for text in expected:
            self.assertIn(text, errors[0])
        self.assertFalse(os.path.exists(self.output))


class Success(CommandLine):
    def test_every_input_format(self):
        for name, content in (
            ("box.ply", surfaces.box()),
            ("box.obj", surfaces.box()),
            ("box.stl", surfaces.box()),
            ("box.vtp", surfaces.box()),
            ("box.off", OFF_BOX),
            ("SHOUTED.OFF", OFF_BOX),
        ):
            with self.subTest(name):
                done = run(self.file(name, content), self.output)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertAlmostEqual(float(sum(surfaces.exact_volumes(read_grid(self.output)))), 1, delta=1e-12)
                self.assertIn("nothing wrong", done.stdout)
                os.remove(self.output)

    def test_every_output(self):
        source = self.file("boxes.ply", surfaces.two_boxes_and_a_stray_facet())
        for ending in (".vtp", ".ply", ".stl", ".obj"):
            with self.subTest(ending):
                names = [self.path(name) for name in ("hull.vtu", "boundary" + ending, "outliers" + ending, "report.json")]
                hull, boundary, outliers, report = names
                done = run(
                    *(source, self.output, "--hull", hull, "--boundary", boundary),
                    *("--outliers", outliers, "--report", report),
                    *("--gamma", "0.5", "--sigma", "0.2", "--time-budget", "60"),
                )
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertAlmostEqual(float(sum(surfaces.exact_volumes(read_grid(self.output)))), 15 / 8, delta=1e-12)
                self.assertAlmostEqual(surfaces.enclosed_volume(read_surface(boundary)[0]), 15 / 8, delta=1e-6)
                with open(report, encoding="utf-8") as file:
                    found = json.load(file)
                self.assertEqual(read_grid(hull).GetNumberOfCells(), found["statistics"]["HullCells"])
                self.assertEqual(read_surface(outliers)[0].GetNumberOfCells(), found["statistics"]["OutlierFacets"])
                self.assertGreater(found["statistics"]["OutlierFacets"], 0)
                self.assertEqual(
                    found["parameters"],
                    {"gamma": 0.5, "sigma": 0.2, "merge_tolerance": 0, "time_budget": 60, "memory_budget": 0},
                )
                self.assertEqual(found["tetrahedralizer"], "exact flips and cuts")

    def test_engine(self):
        source = self.file("box.ply", surfaces.box())
        report = self.path("report.json")
        done = run(source, self.output, "--engine", "exact", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["tetrahedralizer"], "exact flips and cuts")
        os.remove(self.output)
        self.check_failure(run(source, self.output, "--engine", "steam"), "--engine")

    def test_empty_outliers_are_written_in_every_format(self):
        source = self.file("box.ply", surfaces.box())
        for ending in (".vtp", ".ply", ".stl", ".obj"):
            with self.subTest(ending):
                done = run(source, self.output, "--outliers", self.path("outliers" + ending))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(os.path.exists(self.path("outliers" + ending)))

    def test_the_report_holds_what_the_summary_says(self):
        report = self.path("report.json")
        done = run(self.file("open.ply", surfaces.open_box()), self.output, "--report", report)
        with open(report, encoding="utf-8") as file:
            found = json.load(file)
        self.assertEqual((found["exit_status"], found["error"]), (0, None))
        self.assertEqual(found["input"], self.path("open.ply"))
        self.assertEqual(found["outputs"], {"solid": self.output})
        self.assertEqual(found["defects"], ["4 open edges"])
        self.assertEqual(found["statistics"]["OpenEdges"], 4)
        self.assertEqual(found["statistics"]["InsideCells"], read_grid(self.output).GetNumberOfCells())
        self.assertEqual(found["warnings"], [])
        self.assertEqual((found["left_out_cells"], found["lost_cells"]), ([], []))
        for text in ("4 open edges", f"{found['statistics']['InsideCells']} tetrahedra inside", "tetrahedralizing", " s"):
            self.assertIn(text, done.stdout)

    def test_progress_is_a_line_per_stage_in_a_log(self):
        done = run(self.file("box.ply", surfaces.box()), self.output)
        stages = ("reading", *insideout.tetrahedralization.STAGES, "writing")
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), len(stages), done.stderr)
        for line, stage in zip(lines, stages):
            self.assertRegex(line, rf"^{stage} +[0-9.]+ s$")

    def test_progress_is_a_bar_on_a_terminal(self):
        ours, theirs = os.openpty()
        done = subprocess.run(
            [sys.executable, "-m", "insideout", self.file("box.ply", surfaces.box()), self.output],
            stdout=subprocess.PIPE,
            stderr=theirs,
            timeout=120,
            check=False,
        )
        os.close(theirs)
        shown = os.read(ours, 100000).decode()
        os.close(ours)
        self.assertEqual(done.returncode, 0)
        self.assertIn("\rtetrahedralizing", shown)
        self.assertIn("[##############################] 100 %", shown)

    def test_quiet_prints_nothing(self):
        done = run(self.file("inverted.ply", surfaces.reversed_box()), self.output, "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_warnings_are_listed(self):
        done = run(self.file("inverted.ply", surfaces.reversed_box()), self.output)
        self.assertEqual(done.returncode, 0)
        self.assertIn("Warning: the surface is inside out", done.stdout)
        self.assertIn("turned over", done.stdout)

    def test_a_reader_that_leaves_is_no_error(self):
        process = subprocess.Popen(
            [sys.executable, "-m", "insideout", self.file("box.ply", surfaces.box()), self.output],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        process.stdout.close()
        errors = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(120), 0)
        self.assertNotIn("Traceback", errors)
        self.assertNotIn("Exception", errors)
        self.assertGreater(read_grid(self.output).GetNumberOfCells(), 0)


class Failure(CommandLine):
    def test_files_that_cannot_be_read(self):
        with open(self.file("whole.ply", surfaces.box()), "rb") as file:
            whole = file.read()
        os.mkdir(self.path("folder.ply"))
        for name, content, expected in (
            ("missing.ply", None, "no such file"),
            ("folder.ply", None, "is a directory"),
            ("truncated.ply", whole[: len(whole) * 3 // 4], ""),
            ("header.ply", whole[:40], ""),
            ("nothing.ply", "", ""),
            ("noise.obj", "f 1 2 3\n", ""),
            ("huge.off", "OFF\n2000000000 2000000000 0\n", ""),
            ("broken.vtp", "<VTKFile", "cannot read"),
            ("surface.txt", OFF_BOX, "unknown ending"),
        ):
            with self.subTest(name):
                if content is not None:
                    self.file(name, content)
                self.check_failure(run(self.path(name), self.output), name, expected)

    def test_surfaces_without_a_solid(self):
        flat = surfaces.polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        lines = surfaces.polydata([(0, 0, 0), (1, 0, 0)], [])
        lines.SetLines(surfaces.polydata([], [(0, 1)]).GetPolys())
        nan = OFF_BOX.replace("1 0 1", "1 nan 1", 1)
        for name, content, expected in (
            ("empty.vtp", surfaces.polydata([], []), "empty"),
            ("empty.off", "OFF\n0 0 0\n", ""),
            ("lines.vtp", lines, "only lines"),
            ("nan.off", nan, "5"),
            ("range.off", OFF_BOX.replace("3 3 4 7", "3 3 4 8"), "8"),
            ("range.vtp", surfaces.box(facets=[(0, 1, 2), (3, 4, 8)]), "cell 1 refers to point 8 of 8"),
            ("degenerate.ply", surfaces.box(facets=[(0, 0, 1)]), "degenerate"),
            ("flat.ply", flat, "plane"),
        ):
            with self.subTest(name):
                self.check_failure(run(self.file(name, content), self.output), expected)

    def test_nothing_inside(self):
        source = self.file("both.ply", surfaces.closed_both_ways())
        hull, boundary, report = self.path("hull.vtu"), self.path("boundary.ply"), self.path("report.json")
        done = run(source, self.output, "--hull", hull, "--boundary", boundary, "--report", report)
        self.check_failure(done, "nothing is inside", "w ranges from")
        self.assertGreater(read_grid(hull).GetNumberOfCells(), 0)
        self.assertFalse(os.path.exists(boundary))
        with open(report, encoding="utf-8") as file:
            found = json.load(file)
        self.assertEqual(found["exit_status"], 1)
        self.assertIn("nothing is inside", found["error"])
        self.assertEqual(found["outputs"], {"hull": hull})
        self.assertLess(found["statistics"]["MaximumW"], 1)

    def test_outputs_are_checked_before_the_work(self):
        source = self.file("box.ply", surfaces.box())
        os.mkdir(self.path("folder.vtu"))
        for arguments, expected in (
            ((self.path("solid.vtk"),), "solid.vtk: unknown ending"),
            ((self.path("missing/solid.vtu"),), "there is no folder"),
            ((self.path("folder.vtu"),), "it is a folder"),
            ((self.output, "--hull", self.path("hull.vtp")), "hull.vtp: unknown ending"),
            ((self.output, "--boundary", self.path("boundary.off")), "boundary.off: unknown ending"),
            ((self.output, "--outliers", self.path("outliers")), "outliers: unknown ending"),
            ((self.output, "--report", self.path("report.txt")), "report.txt: unknown ending"),
            ((self.output, "--hull", self.output), "is named twice"),
            ((self.output, "--boundary", source), "is named twice"),
        ):
            with self.subTest(expected):
                done = run(source, *arguments)
                self.check_failure(done, expected)
                self.assertEqual(len(done.stderr.splitlines()), 1, "work was begun")

    def test_a_folder_without_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        os.mkdir(self.path("locked"), 0o500)
        done = run(self.file("box.ply", surfaces.box()), self.path("locked/solid.vtu"))
        self.check_failure(done, "permission denied")

    def test_bad_parameters(self):
        source = self.file("box.ply", surfaces.box())
        for option, value in (("gamma", "-1"), ("gamma", "nan"), ("gamma", "inf"), ("sigma", "0"), ("sigma", "-2")):
            with self.subTest(option=option, value=value):
                self.check_failure(run(source, self.output, f"--{option}", value), option)

    def test_arguments_that_make_no_sense(self):
        for arguments in ((), ("surface.ply",), ("surface.ply", self.output, "--gamma", "much"), ("a", "b", "--nonsense")):
            with self.subTest(arguments):
                done = run(*arguments)
                self.check_failure(done, "--help")

    def test_the_report_tells_of_the_failure(self):
        report = self.path("report.json")
        done = run(self.path("missing.ply"), self.output, "--report", report, "--quiet")
        self.check_failure(done, "missing.ply")
        with open(report, encoding="utf-8") as file:
            found = json.load(file)
        self.assertEqual(found["exit_status"], 1)
        self.assertEqual("insideout: " + found["error"] + "\n", done.stderr)
        self.assertEqual(found["outputs"], {})


if __name__ == "__main__":
    unittest.main()
