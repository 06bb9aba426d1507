# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m insideout`: what it reads, writes, prints and refuses."""

import gzip
import json
import os
import shutil
import subprocess
import sys
import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine, read_grid, run
from insideout.files import read_surface
from insideout.options import OPTIONS
from insideout.stages import TETRAHEDRALIZE
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


OFF_BOX = "\n".join(
    ["OFF", "8 12 0"]
    + ["{} {} {}".format(*point) for point in surfaces.box_points()]
    + ["3 {} {} {}".format(*facet) for facet in surfaces.BOX_FACETS]
)


class Success(CommandLine):
    def test_every_input_format(self):
        for name, content in (
            ("box.ply", surfaces.box()),
            ("box.obj", surfaces.box()),
            ("box.stl", surfaces.box()),
            ("box.vtp", surfaces.box()),
            ("box.off", OFF_BOX),
            ("SHOUTED.OFF", OFF_BOX),
            ("box.off.gz", gzip.compress(OFF_BOX.encode())),
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
                self.assertEqual(set(found["parameters"]), set(OPTIONS))
                self.assertEqual(
                    found["parameters"],
                    {
                        **found["parameters"],
                        **{"gamma": 0.5, "sigma": 0.2, "merge_tolerance": 0, "time_budget": 60, "memory_budget": 0},
                        **{"scale": 1, "engine": "automatic", "dimension": "automatic", "data_term": "uniform", "orientation": "automatic"},
                        **{"count_duplicates": False, "quadrature_order": 1, "seeds": None},
                        **{"thicken": 0, "thicken_all": False},
                        **{"constrain_facets": False, "constrained_facets_array": None, "non_manifold": "keep", "separate_overlaps": False},
                        **{"largest_regions": 0, "minimum_region_volume": 0, "seeded_regions": False, "fill_cavities": False, "topology": "any"},
                        **{"tag_array": None, "tag_rules": None, "non_participating_array": None, "merge_coplanar_pieces": False, "split_seams": False, "surface_only": False},
                        **{"body_array": None, "parts_apart": False, "region_rule": "by-priority", "priority": None},
                        **{"refine": False, "edge_length": 0, "grading": 0.35, "maximum_volume": 0, "maximum_cells": 10000000, "size_rules": None, "surface_treatment": "automatic"},
                        **{"surface_tolerance": 0, "feature_angle": 30, "quadratic_cells": False},
                    },
                )
                self.assertEqual(found["tetrahedralizer"], "exact flips and cuts")

    def test_every_format_of_output(self):
        source = self.file("boxes.ply", surfaces.two_boxes_and_a_stray_facet())
        first_line = {
            **{".msh": "$MeshFormat", ".inp": "** Written by InsideOut", ".mesh": "MeshVersionFormatted 2", ".xdmf": "<Xdmf"},
            **{".vtp": "<?xml", ".ply": "ply", ".obj": "# Written", ".off": "OFF", ".stl": "Binary STL", ".glb": "glTF", ".3mf": "PK"},
        }
        for ending, begin in first_line.items():
            with self.subTest(ending):
                output, report = self.path("result" + ending), self.path("report.json")
                done = run(source, output, "--report", report, "--scale", "0.1")
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(output, "rb") as file:
                    self.assertTrue(file.read().startswith(begin.encode()))
                with open(report, encoding="utf-8") as file:
                    found = json.load(file)
                is_surface = ending in (".vtp", ".ply", ".obj", ".off", ".stl", ".glb", ".3mf")
                more = {"tags": self.path("result_boundary.xdmf")} if ending == ".xdmf" else {}
                self.assertEqual(found["outputs"], {"surface" if is_surface else "solid": output, **more})
                self.assertEqual((found["parameters"]["scale"], found["statistics"]["Scale"]), (0.1, 0.1))
                self.assertAlmostEqual(found["statistics"]["Volume"], 15 / 8000, delta=1e-15)
                self.assertIn("coordinates multiplied by 0.1", done.stdout)
                if is_surface:
                    again = read_surface(output)[0]
                    self.assertAlmostEqual(surfaces.enclosed_volume(again), 15 / 8000, delta=1e-9)
                    self.assertEqual(insideout.check(again).statistics["OpenEdges"], 0)

    def test_versions_of_msh(self):
        source = self.file("box.ply", surfaces.box())
        for options, expected in (((), "4.1"), (("--msh-version", "4.1"), "4.1"), (("--msh-version", "2.2"), "2.2")):
            done = run(source, self.path("solid.msh"), "--hull", self.path("hull.msh"), *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            for name in ("solid.msh", "hull.msh"):
                with open(self.path(name), encoding="utf-8") as file:
                    self.assertEqual(file.readlines()[1], f"{expected} 0 8\n")
        self.check_failure(run(source, self.output, "--msh-version", "2.2"), "--msh-version cannot matter here: it is for .msh")

    def test_a_scale_is_that_of_checks_pictures_and_places_too(self):
        source, report = self.file("box.ply", surfaces.box()), self.path("report.json")
        done = run("--check", source, "--scale", "2", "--report", report)
        self.assertIn("bounds a solid of volume 8", done.stdout)
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["parameters"]["scale"], 2)
        query = self.file("query.csv", "1.5,1.5,1.5\n")
        self.assertIn("1 of 1 places are inside", run("--winding", query, source, self.path("w.csv"), "--scale", "2").stdout)
        self.assertNotIn("multiplied", run("--check", source).stdout)
        self.check_failure(run(source, self.output, "--scale", "0"), "scale is 0; it must be above 0")

    def test_needs_of_a_format_are_known_before_the_work(self):
        source = self.file("box.ply", surfaces.box())
        for ending in (".msh", ".inp", ".mesh", ".xdmf"):
            done = run(source, self.path("solid" + ending), "--merge-coplanar-pieces")
            self.check_failure(done, "--merge-coplanar-pieces", "solid" + ending)
            self.assertEqual(len(done.stderr.splitlines()), 1, "work was begun")

    def test_the_report_is_json_of_a_surface_beyond_all_volumes(self):
        report = self.path("report.json")
        huge = insideout.surfaces.make_surface(surfaces.points_of(surfaces.box()) * 1e110, surfaces.BOX_FACETS)
        done = run(self.file("huge.ply", huge), self.output, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            found = json.load(file, parse_constant=self.fail)["statistics"]
        self.assertIsNone(found["Volume"])
        self.assertEqual(found["CenterOfMassX"], 5e109)

    def test_a_picture_of_it(self):
        picture = self.path("picture.png")
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        done = run(self.file("boxes.ply", surfaces.two_boxes()), self.output, "--plot", picture, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (2400, 900, 1))
        self.assertGreater(len(np.unique(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()), axis=0)), 100)

    def test_constraints(self):
        source = self.file("figure.ply", surfaces.two_boxes_and_a_stray_facet())
        report = self.path("report.json")
        for options in ((), ("--constrain-facets",), ("--constrain-facets", "--non-manifold", "fill")):
            done = run(source, self.output, "--report", report, "--data-term", "uniform", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(report, encoding="utf-8") as file:
                found = json.load(file)
            self.assertEqual(found["parameters"]["non_manifold"], options[-1] if "fill" in options else "keep")
            self.assertEqual(found["statistics"]["ForcedFacets"] > 0, bool(options))
            self.assertEqual(found["statistics"]["OutlierFacets"] == 0, bool(options))

    def test_engine(self):
        source = self.file("box.ply", surfaces.box())
        report = self.path("report.json")
        done = run(source, self.output, "--engine", "exact", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["tetrahedralizer"], "exact flips and cuts")
        os.remove(self.output)
        self.check_failure(run(source, self.output, "--engine", "steam"), "--engine")

    def test_options_of_the_surface(self):
        surface = surfaces.two_boxes_and_a_stray_facet()
        surfaces.add_array(surface.GetCellData(), "Second", np.repeat([0, 1, 0], [12, 12, 1]))
        boundary = self.path("boundary.vtp")
        source = self.file("boxes.vtp", surface)
        done = run(source, self.output, "--boundary", boundary, "--non-participating-array", "Second")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(float(sum(surfaces.exact_volumes(read_grid(self.output)))), 1, delta=1e-12)
        self.assertIn("12 facets that do not count, as asked", done.stdout)
        self.assertRegex(done.stdout, r"[1-9]\d* outlier facets \([1-9]\d* segmented as outside\)")
        pieces = read_surface(boundary)[0].GetNumberOfCells()
        self.assertGreater(pieces, 12)

        merged = run(
            *(source, self.output, "--boundary", boundary, "--non-participating-array", "Second"),
            *("--merge-coplanar-pieces", "--split-seams"),
        )
        self.assertEqual(merged.returncode, 0, merged.stderr)
        self.assertEqual(read_surface(boundary)[0].GetNumberOfCells(), 12)
        os.remove(self.output)
        self.check_failure(run(source, self.output, "--non-participating-array", "Third"), "no cell array Third")

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
        stages = ("reading", *TETRAHEDRALIZE, "writing")
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
            check=False,
        )
        os.close(theirs)
        shown = os.read(ours, 100000).decode()
        os.close(ours)
        self.assertEqual(done.returncode, 0)
        self.assertIn("\rtetrahedralizing", shown)
        self.assertIn("[##############################] 100 %", shown)

    def test_quiet_keeps_the_reason_of_each_failure(self):
        names = [self.file("flat.ply", surfaces.polydata(surfaces.box_points()[:4], [(0, 1, 2)])), self.path("missing.ply")]
        names += [self.file("box.ply", surfaces.box()), self.file("bad.off", "OFF\n1 1 0\n")]
        for mode in ([self.path("{}.vtu")], ["--check"]):
            with self.subTest(mode):
                done = run(*names, *mode, "--quiet")
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                failing = [name for name in names if "box" not in name and "flat" not in name]
                lines = done.stderr.splitlines()
                self.assertEqual(len(lines), len(failing), done.stderr)
                for name, line in zip(failing, lines):
                    self.assertTrue(line.startswith("insideout: "), line)
                    self.assertIn(name, line)

    def test_points_merged_across_seams_of_textures_are_one_note_and_no_warning(self):
        obj = "".join("v {} {} {}\n".format(*point) for point in surfaces.box_points()) + "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
        corners = [[(corner, 1 + (k + turn) % 4) for turn, corner in enumerate(facet)] for k, facet in enumerate(surfaces.BOX_FACETS)]
        obj += "".join("f " + " ".join(f"{corner + 1}/{place}" for corner, place in facet) + "\n" for facet in corners)
        file = self.file("box.obj", obj)
        done = run(file, self.output)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("Warning", done.stdout)
        (line,) = [line for line in done.stdout.splitlines() if "texture" in line]
        self.assertRegex(line, r"^Note: \d+ points, copies .* --split-seams keeps them all$")
        self.assertNotIn("texture", run(file, self.output, "--split-seams").stdout)
        self.assertNotIn("Note", run(self.file("box.ply", surfaces.box()), self.output).stdout)

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
        self.assertEqual(process.wait(), 0)
        self.assertNotIn("Traceback", errors)
        self.assertNotIn("Exception", errors)
        self.assertGreater(read_grid(self.output).GetNumberOfCells(), 0)


class StandardInput(CommandLine):
    def content(self, name: str) -> bytes:
        with open(self.file(name, surfaces.box()), "rb") as file:
            return file.read()

    def run_on(self, content: bytes, *arguments: str) -> subprocess.CompletedProcess:
        done = subprocess.run([sys.executable, "-m", "insideout", *arguments], input=content, capture_output=True, check=False)
        return subprocess.CompletedProcess(done.args, done.returncode, done.stdout.decode(), done.stderr.decode())

    def test_its_content_tells_what_it_is(self):
        for content in (self.content("box.ply"), self.content("box.vtp"), gzip.compress(self.content("box.stl"))):
            done = self.run_on(content, "-", self.path("{}.vtu"), "--boundary", self.path("{}-boundary.ply"))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("Surface standard input: bounds a solid", done.stdout)
            self.assertNotIn("Warning", done.stdout)
            self.assertEqual(read_surface(self.path("stdin-boundary.ply"))[0].GetNumberOfCells(), 12)
        self.assertEqual(self.run_on(self.content("box.obj"), "--check", "-").returncode, 0)

    def test_or_the_format_that_is_given(self):
        content = b"f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\nv 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\n"
        self.check_failure(self.run_on(content, "-", self.output), "standard input: neither content", "--format")
        done = self.run_on(content, "-", self.output, "--format", "obj")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.check_failure(self.run_on(b"", "-", self.path("other.vtu")), "standard input: is empty")
        self.check_failure(self.run_on(b"ply\n", "-", self.path("other.vtu")), "standard input, line 2")
        self.check_failure(self.run_on(b"", "-", "-", self.path("{}.vtu")), "named twice")
        self.check_failure(run(self.path("a.ply"), self.path("a.vtu"), "--format", "ply"), "--format")

    def check_failure(self, done: subprocess.CompletedProcess, *expected: str):
        if os.path.exists(self.output):
            os.remove(self.output)
        super().check_failure(done, *expected)


class Several(CommandLine):
    def test_one_that_fails_does_not_keep_the_others_and_a_table_tells_all(self):
        first, last = self.file("first.ply", surfaces.box()), self.file("last.ply", surfaces.open_box())
        missing = self.path("missing.ply")
        done = run(
            *(first, missing, last, self.path("{}.vtu"), "--boundary", self.path("{}-boundary.stl")),
            *("--report", self.path("{}.json"), "--threads", "1"),
        )
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.count("insideout: "), 1)
        for stem in ("first", "last"):
            self.assertAlmostEqual(float(sum(surfaces.exact_volumes(read_grid(self.path(stem + ".vtu"))))), 1, delta=1e-12)
            self.assertTrue(os.path.exists(self.path(stem + "-boundary.stl")))
        with open(self.path("missing.json"), encoding="utf-8") as file:
            self.assertIn("no such file", json.load(file)["error"])
        heading, *table, end = done.stdout.splitlines()[-5:]
        self.assertEqual(heading.split()[0], "surface")
        self.assertEqual([line.split()[0] for line in table], [first, missing, last])
        self.assertEqual(table[2].split()[1:3], ["10", "4"])
        self.assertIn("no such file", table[1])
        self.assertEqual(heading.split()[-2:], ["seconds", "result"])
        self.assertIn("bounds a solid of volume 1", table[0])
        self.assertEqual(end, "2 of 3 surfaces done")

    def test_several_are_checked(self):
        names = [self.file("a.ply", surfaces.box()), self.file("b.ply", surfaces.open_box())]
        done = run("--check", *names)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines()[-1], "2 of 2 surfaces done")
        self.assertIn("bounds a solid of volume about 1.00000 (95 %: 0.99990 to 1.00010), once its holes are closed", done.stdout.splitlines()[-2])

    def test_one_of_several_checked_or_evaluated_surfaces_may_fail(self):
        box, broken = self.file("a.ply", surfaces.box()), self.file("broken.ply", "ply\n")
        query = self.file("query.csv", "0.5,0.5,0.5\n2,2,2\n")
        for arguments in (("--check", broken, box), ("--winding", query, broken, box, self.path("{}.csv"))):
            with self.subTest(arguments):
                done = run(*arguments)
                self.assertEqual(done.returncode, 1)
                *_, first, last, end = done.stdout.splitlines()
                self.assertRegex(first, rf"^{broken} .*- .*broken.ply, line 2")
                self.assertTrue(last.startswith(box))
                self.assertEqual(end, "1 of 2 surfaces done")

    def test_devices_may_be_written_for_each(self):
        done = run(self.file("a.ply", surfaces.box()), self.file("b.ply", surfaces.box()), "/dev/null")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.splitlines()[-1], "2 of 2 surfaces done")

    def test_no_file_is_written_twice(self):
        names = [self.file("a.ply", surfaces.box()), self.file("a.stl", surfaces.box())]
        for output in (self.output, self.path("{}.vtu")):
            done = run(*names, output)
            self.check_failure(done, "would both be written to", "or give --together for one mesh of all")


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
        lines = surfaces.polydata([(0, 0, 0), (1, 0, 0)], [])
        lines.SetLines(surfaces.polydata([], [(0, 1)]).GetPolys())
        nan = OFF_BOX.replace("1 0 1", "1 nan 1", 1)
        for name, content, expected in (
            ("empty.vtp", surfaces.polydata([], []), "empty"),
            ("empty.off", "OFF\n0 0 0\n", ""),
            ("lines.vtp", lines, "all points lie on one line"),
            ("nan.off", nan, "5"),
            ("range.off", OFF_BOX.replace("3 3 4 7", "3 3 4 8"), "8"),
            ("range.vtp", surfaces.box(facets=[(0, 1, 2), (3, 4, 8)]), "cell 1 refers to point 8 of 8"),
            ("degenerate.ply", surfaces.box(facets=[(0, 0, 1)]), "degenerate"),
        ):
            with self.subTest(name):
                self.check_failure(run(self.file(name, content), self.output), expected)

    def test_nothing_inside(self):
        source = self.file("both.ply", surfaces.closed_both_ways())
        hull, boundary, report = self.path("hull.vtu"), self.path("boundary.ply"), self.path("report.json")
        done = run(source, self.output, "--hull", hull, "--boundary", boundary, "--report", report, "--orientation", "as-given")
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
        os.symlink("box.ply", self.path("link.ply"))
        os.link(source, self.path("hard.stl"))
        os.symlink("solid.vtu", self.path("link.vtu"))
        os.mkdir(self.path("folder.vtu"))
        for arguments, expected in (
            ((self.path("solid.vtk"),), "solid.vtk: unknown ending"),
            ((self.path("missing/solid.vtu"),), "there is no folder"),
            ((self.path("folder.vtu"),), "it is a folder"),
            ((self.output, "--hull", self.path("hull.vtp")), "hull.vtp: unknown ending"),
            ((self.output, "--boundary", self.path("boundary.msh")), "boundary.msh: unknown ending"),
            ((self.output, "--outliers", self.path("outliers")), "outliers: unknown ending"),
            ((self.output, "--report", self.path("report.txt")), "report.txt: unknown ending"),
            ((self.output, "--hull", self.output), "is named twice"),
            ((self.output, "--boundary", source), "is read"),
            ((self.output, "--boundary", self.path("./box.ply")), "is read"),
            ((self.output, "--boundary", self.path("link.ply")), "is read"),
            ((self.output, "--boundary", self.path("hard.stl")), "is read"),
            ((self.output, "--hull", self.path("link.vtu")), "is named twice"),
        ):
            with self.subTest(expected):
                done = run(source, *arguments)
                self.check_failure(done, expected)
                self.assertEqual(len(done.stderr.splitlines()), 1, "work was begun")

    def test_no_input_of_any_kind_is_an_output(self):
        box, other = self.file("box.ply", surfaces.box()), self.file("other.stl", surfaces.box())
        query, seeds = self.file("query.csv", "0,0,0\n"), self.file("seeds.csv", "0.5,0.5,0.5,1\n")
        os.link(seeds, self.path("seeds.vtu"))
        for arguments in (
            ("--winding", query, box, query),
            ("--winding", query, box, self.path("./query.csv")),
            (box, self.path("seeds.vtu"), "--seeds", seeds),
            (other, box, self.path("{}.vtu"), "--boundary", self.path("{}.ply"), "--outliers", self.path("{}-outliers.stl")),
        ):
            with self.subTest(arguments):
                before = {name: os.stat(self.path(name)).st_mtime_ns for name in os.listdir(self.folder)}
                done = run(*arguments)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(len(done.stderr.splitlines()), 1, "work was begun")
                self.assertIn("is read", done.stderr)
                self.assertEqual({name: os.stat(self.path(name)).st_mtime_ns for name in os.listdir(self.folder)}, before)

    def test_devices_may_be_named_twice(self):
        done = run(self.file("box.ply", surfaces.box()), "/dev/null", "--hull", "/dev/null", "--report", "/dev/stdout", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(json.loads(done.stdout)["outputs"], {"solid": "/dev/null", "hull": "/dev/null"})

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
        for arguments in (
            (),
            ("surface.ply",),
            ("surface.ply", self.output, "--gamma", "much"),
            ("a", "b", "--nonsense"),
            ("a", "b", "--threads", "0"),
            ("a", "b", "--timeout", "0"),
            ("--check", "a.ply", self.output),
            ("--check", "a.ply", self.path("solid.msh")),
            ("a.ply", self.output, "--msh-version", "3"),
            ("--check", "a.ply", "--plot", "a.png"),
            ("--winding", "q.csv", "a.ply", "w.csv", "--gamma", "1"),
        ):
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
