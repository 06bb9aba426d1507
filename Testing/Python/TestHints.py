# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line says of a result that another option would make better for a solver or a printer."""

import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine, run_here
from insideout import demo

ASKED = 5.0
"""The edge length, in millimeters: the longest edge of the bracket's surface has 72."""


def notes(*arguments: str) -> list[str]:
    done = run_here(*arguments, "--force")
    assert done.returncode == 0, done.stderr
    return [line.removeprefix("Note: ") for line in done.stdout.splitlines() if line.startswith("Note: ")]


class TestHints(CommandLine):
    def setUp(self):
        super().setUp()
        self.bracket = self.file("bracket.obj", demo.bracket())
        self.solid = self.path("solid.inp")

    def quality(self) -> dict[str, float]:
        return insideout.check_solid(self.solid).statistics

    def test_long_edges_of_a_kept_boundary_are_told_and_short_after_the_advice(self):
        first, *others = notes(self.bracket, self.solid, "--edge-length", str(ASKED))
        self.assertEqual(others, [])
        said = "--edge-length is 5, and edges of the boundary, whose triangles are kept, are up to 72.1 long: --surface-treatment split"
        self.assertTrue(first.startswith(said), first)
        self.assertEqual(notes(self.bracket, self.solid, "--edge-length", str(ASKED), "--surface-treatment", "split"), [])
        points, cells = insideout.read(self.solid).points, insideout.read(self.solid).cells
        edges = np.concatenate([points[cells[:, a]] - points[cells[:, b]] for a in range(4) for b in range(a)])
        self.assertLess(np.linalg.norm(edges, axis=1).max(), 3 * ASKED)

    def test_thin_cells_are_told_and_are_fewer_after_the_advice(self):
        (first,) = notes(self.bracket, self.solid)
        before = self.quality()
        least, thin, cells = before["MinDihedralAngle"], before["CellsUnder5Degrees"], before["Cells"]
        said = f"tetrahedra have angles down to {least:.3g} degrees, {thin} of {cells} below 5: solvers may stop or err; --refine makes better ones"
        self.assertEqual(first, said)
        notes(self.bracket, self.solid, "--refine")
        after = self.quality()
        self.assertLess(after["CellsUnder5Degrees"] / after["Cells"], 0.1 * thin / cells)

    def test_thin_cells_of_points_that_nearly_meet_are_told_and_gone_after_the_advice(self):
        both = self.file("both.ply", surfaces.joined(surfaces.box(), surfaces.box((0, 0, 1 - 1e-7))))
        (near,) = notes(both, self.solid, "--refine")
        advice = "; --merge-tolerance 0.001% joins points that nearly meet and --surface-treatment remeshed gives the boundary better triangles"
        self.assertTrue(near.endswith(advice), near)
        merged = notes(both, self.solid, "--refine", "--merge-tolerance", "0.001%", "--surface-treatment", "remeshed")
        self.assertRegex(" ".join(merged), "^--merge-tolerance 0.001% is [^ ]+$")
        self.assertEqual(self.quality()["CellsUnder5Degrees"], 0)

    def test_files_for_no_solver_have_no_hints(self):
        self.assertEqual(notes(self.bracket, self.path("solid.vtu"), "--edge-length", str(ASKED)), [])

    def test_whether_a_slicer_takes_a_repaired_surface_is_told_and_it_does_after_the_advice(self):
        touching = self.file("touching.ply", surfaces.joined(surfaces.box(), surfaces.box((1, 1, 0))))
        fixed = self.path("fixed.stl")
        crowded = "the surface is watertight, and 1 edge has more than two triangles, which some slicers refuse: --non-manifold fill adds to the solid there"
        good = "the surface is watertight, and each edge has two triangles"
        for options, said in (([], crowded), (["--non-manifold", "split"], crowded), (["--non-manifold", "fill"], good)):
            self.assertEqual(notes("repair", touching, fixed, *options), [said], options)
        self.assertEqual(notes("repair", touching, self.path("fixed.obj"), "--non-manifold", "split"), [good])
        self.assertEqual(surfaces.count_not_manifold(surfaces.triangles_of(insideout.resolve(fixed).surface)), (0, 0))


if __name__ == "__main__":
    unittest.main()
