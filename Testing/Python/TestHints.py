# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line says of a result that another option would make better for a printer."""

import unittest

import insideout
import surfaces
from command import CommandLine, run_here
from insideout.data import as_type
from insideout.hints import hints_for_printing
from insideout.options import Options


def notes(*arguments: str) -> list[str]:
    done = run_here(*arguments, "--force")
    assert done.returncode == 0, done.stderr
    return [line.removeprefix("Note: ") for line in done.stdout.splitlines() if line.startswith("Note: ")]


class TestHints(CommandLine):
    def test_slicers_take_a_repaired_surface_after_the_advice(self):
        touching = self.file("touching.ply", surfaces.joined(surfaces.box(), surfaces.box((1, 1, 0))))
        fixed = self.path("fixed.stl")
        crowded = "the surface is watertight, and 1 edge has more than two triangles, which some slicers refuse: --non-manifold fill adds to the solid there"
        good = "the surface is watertight, and each edge has two triangles"
        for options, said in (([], crowded), (["--non-manifold", "split"], crowded), (["--non-manifold", "fill"], good)):
            self.assertEqual(notes("repair", touching, fixed, *options), [said], options)
        self.assertEqual(notes("repair", touching, self.path("fixed.obj"), "--non-manifold", "split"), [good])
        self.assertEqual(surfaces.count_not_manifold(surfaces.triangles_of(insideout.resolve(fixed).surface)), (0, 0))

    def test_an_open_surface_is_not_said_to_have_two_triangles_at_each_edge(self):
        for triangles in (surfaces.triangles_of(surfaces.box())[1:].tolist(), []):
            surface = as_type(insideout.TriangleSurface, surfaces.polydata(surfaces.points_of(surfaces.box()), triangles))
            self.assertEqual(hints_for_printing(surface, "open.ply", Options()), ["the surface has open edges"])


if __name__ == "__main__":
    unittest.main()
