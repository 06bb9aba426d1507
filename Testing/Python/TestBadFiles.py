# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that cannot be read: each gives one message that names it, and nothing else happens."""

import gzip
import os
import random
import struct
import unittest

import insideout
import surfaces
from command import CommandLine, run, run_here
from insideout.files import write_surface

SURFACES = ("ply", "obj", "off", "stl", "vtp", "glb", "3mf")


def ascii_stl() -> bytes:
    corners = surfaces.points_of(surfaces.box())[surfaces.triangles_of(surfaces.box())]
    lines = ["solid box"]
    for triangle in corners.tolist():
        lines += ["facet normal 0 0 0", "outer loop", *("vertex %r %r %r" % tuple(point) for point in triangle), "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid box", ""]).encode()


def binary_ply() -> bytes:
    head = "ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
    head += "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
    points = b"".join(struct.pack("<3d", *point) for point in surfaces.box_points())
    return head.encode() + points + b"".join(struct.pack("<B3i", 3, *facet) for facet in surfaces.BOX_FACETS)


class BadFiles(CommandLine):
    def setUp(self):
        super().setUp()
        self.good = {"ascii.stl": ascii_stl(), "binary.ply": binary_ply()}
        for kind in SURFACES:
            write_surface(surfaces.box(), self.path("box." + kind))
            with open(self.path("box." + kind), "rb") as file:
                self.good["box." + kind] = file.read()
        insideout.write(insideout.tetrahedralize(surfaces.box()).solid, self.path("cells.vtu"))
        with open(self.path("cells.vtu"), "rb") as file:
            self.good["cells.vtu"] = file.read()
        os.remove(self.path("cells.vtu"))

    def check_bad(self, name: str, content: bytes, *expected: str) -> None:
        with self.subTest(name, content=content[:40], length=len(content)):
            path = self.file(name, content)
            for command in (("check", path), (path, self.output)) if not name.endswith(".vtu") else (("check", path), ("refine", path, self.output)):
                self.check_failure(run_here(*command), name, *expected)

    def test_empty_ones(self):
        for name in self.good:
            self.check_bad(name, b"")
            self.check_bad(name, b"\n")
            if not name.endswith(".vtu"):
                self.check_bad(name + ".gz", gzip.compress(b""))

    def test_truncated_ones(self):
        for name, content in self.good.items():
            if name not in ("box.obj", "box.off"):  # text without counts; lines of it are below
                for share in (0.1, 0.3, 0.6, 0.9):
                    self.check_bad(name, content[: int(share * len(content))])
            if not name.endswith(".vtu"):
                self.check_bad(name + ".gz", gzip.compress(content)[:-9], "its end is missing")
        lines = self.good["box.off"].splitlines(keepends=True)
        for count in (1, 2, 3, 7, len(lines) - 1):
            self.check_bad("box.off", b"".join(lines[:count]))

    def test_wrong_counts(self):
        for name, before, after in (
            ("box.ply", b"vertex 8", b"vertex 7"),
            ("box.ply", b"vertex 8", b"vertex -8"),
            ("box.ply", b"vertex 8", b"vertex 99999999999999999999"),
            ("box.ply", b"face 12", b"face 13"),
            ("box.ply", b"face 12", b"face 2000000000"),
            ("box.ply", b"face 12", b"face twelve"),
            ("binary.ply", b"vertex 8", b"vertex 2000000000"),
            ("binary.ply", b"face 12", b"face 13"),
            ("box.off", b"8 12 0", b"7 12 0"),
            ("box.off", b"8 12 0", b"8 13 0"),
            ("box.off", b"8 12 0", b"2000000000 12 0"),
            ("box.off", b"8 12 0", b"-8 12 0"),
            ("box.vtp", b'NumberOfPoints="8"', b'NumberOfPoints="9"'),
            ("box.vtp", b'NumberOfPolys="12"', b'NumberOfPolys="20"'),
            ("cells.vtu", b'NumberOfPoints="9"', b'NumberOfPoints="90"'),
            ("cells.vtu", b'NumberOfCells="11"', b'NumberOfCells="110"'),
        ):
            self.assertIn(before, self.good[name], name)
            self.check_bad(name, self.good[name].replace(before, after))
        for count in (13, 2**32 - 1):
            stl = self.good["box.stl"]
            self.check_bad("box.stl", stl[:80] + struct.pack("<I", count) + stl[84:], f"{count} triangles announced, 12 present")

    def test_ids_of_points_that_are_not_there(self):
        for name, before, after in (
            ("box.ply", b"\n3 0 2 1", b"\n3 0 2 8"),
            ("box.ply", b"\n3 0 2 1", b"\n3 0 -2 1"),
            ("box.off", b"\n3 0 2 1", b"\n3 0 2 8"),
            ("box.obj", b"\nf 1 3 2", b"\nf 1 3 9"),
            ("box.obj", b"\nf 1 3 2", b"\nf 1 3 0"),
            ("box.obj", b"\nf 1 3 2", b"\nf 1 3 -9"),
        ):
            self.assertIn(before, self.good[name], name)
            self.check_bad(name, self.good[name].replace(before, after))

    def test_garbage(self):
        noise = random.Random(1)
        for name in self.good:
            for length in (3, 83, 500, 5000):
                self.check_bad(name, bytes(noise.randrange(256) for _ in range(length)))
                self.check_bad(name, b"\0" * length)
            head = self.good[name][: len(self.good[name]) // 2]
            if name not in ("box.stl", "box.obj"):
                self.check_bad(name, head + bytes(noise.randrange(256) for _ in range(300)))
            self.check_bad(name, b"Dear reader,\nthis is a letter and no mesh.\n")
            self.check_bad(name, b'{"json": [1, 2, 3]}\n')
            self.check_bad(name, b"<html><body>404 Not Found</body></html>\n")
            self.check_bad(name, b"PK\x03\x04" + bytes(200))
            self.check_bad(name, b"\x89PNG\r\n\x1a\n" + bytes(200))

    def test_content_that_contradicts_the_ending_is_an_error(self):
        self.check_bad("picture.png", b"\x89PNG\r\n\x1a\n" + bytes(200), "unknown ending")
        self.check_bad("box.step", b"ISO-10303-21;\n", "unknown ending")
        self.check_bad("noending", self.good["box.ply"], "unknown ending")
        self.check_bad("cells.vtp", self.good["cells.vtu"], "not a VTK XML file of polygons")
        self.check_bad("box.vtu", self.good["box.vtp"], "not a VTK XML file of cells")
        self.check_bad("box.vtu", self.good["box.ply"])
        self.check_bad("points.csv", b"a,b\n1,2\n")
        self.check_bad("points.csv", b"x,y\n1,one\n")

    def test_folders_and_missing_files_are_errors(self):
        for kind in (*SURFACES, "vtu"):
            os.mkdir(self.path("folder." + kind))
            self.check_failure(run_here("check", self.path("folder." + kind)), "folder." + kind, "is a directory")
            self.check_failure(run_here("check", self.path("missing." + kind)), "missing." + kind, "no such file")

    def test_a_process_of_its_own_ends_as_well(self):
        for name in ("box.stl", "box.ply", "box.vtp"):
            path = self.file(name, self.good[name][:-40])
            self.check_failure(run(path, self.output), name)


if __name__ == "__main__":
    unittest.main()
