# SPDX-License-Identifier: GPL-3.0-or-later
"""Tags of the boundary, which come from what the surface's cells belong to, and the solid's regions."""

import json
import pickle
import unittest
from fractions import Fraction

import insideout
import numpy as np
import surfaces
from insideout.files import read_surface, write_surface
from surfaces import cell_array, polydata
from command import CommandLine, run
from vtkmodules.vtkCommonCore import vtkBitArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPolyData

FACES = ("bottom", "top", "front", "back", "right", "left")
"""Tags of surfaces.BOX_FACETS, two triangles each."""


def tagged(surface: vtkPolyData, values, name: str = "Part") -> vtkPolyData:
    """The surface with a cell array of strings or numbers."""
    if isinstance(values[0], str):
        surface.GetCellData().AddArray(surfaces.strings(name, values))
    else:
        surfaces.add_array(surface.GetCellData(), name, values)
    return surface


def one_cell(*points: int) -> vtkCellArray:
    cells = vtkCellArray()
    cells.InsertNextCell(len(points), points)
    return cells


def names_of(boundary: vtkPolyData) -> list:
    names = boundary.GetFieldData().GetAbstractArray("BoundaryTagNames")
    return [names.GetValue(tag) for tag in range(names.GetNumberOfValues())]


def boxes(*places) -> vtkPolyData:
    return surfaces.joined(*(surfaces.box(low, size) for low, size in places))


def open_sphere(n: int = 12, radius: float = 1.0) -> vtkPolyData:
    """A globe without its cap, with points that no short double holds."""
    theta = np.linspace(0, np.pi, n)[1:-1]
    phi = np.linspace(0, 2 * np.pi, 2 * n, endpoint=False)
    rows = [[(radius * np.sin(t) * np.cos(p), radius * np.sin(t) * np.sin(p), radius * np.cos(t)) for p in phi] for t in theta]
    points = [point for row in rows for point in row] + [(0, 0, -radius)]
    m, facets = 2 * n, []
    for i in range(len(rows) - 1):
        for j in range(m):
            a, b, c, d = i * m + j, i * m + (j + 1) % m, (i + 1) * m + j, (i + 1) * m + (j + 1) % m
            facets += [(a, c, b), (b, c, d)]
    last = (len(rows) - 1) * m
    facets += [(last + j, len(points) - 1, last + (j + 1) % m) for j in range(m)]
    return polydata(points, facets)


class Tags(unittest.TestCase):
    def check(self, result: insideout.Tetrahedralization, of_cell, hole: str = "hole") -> None:
        """Each triangle of the boundary has the tag of the cell that vtkOriginalCellIds names."""
        cells = cell_array(result.boundary, "vtkOriginalCellIds")
        expected = [hole if cell < 0 else of_cell[cell] for cell in cells.tolist()]
        names = names_of(result.boundary)
        tags = cell_array(result.boundary, "BoundaryTag")
        self.assertEqual(tags.dtype, np.int32)
        self.assertEqual([names[tag] for tag in tags.tolist()], expected)
        self.assertEqual(len(set(names)), len(names))
        self.assertEqual(hole in names, -1 in cells)
        if hole in names:
            self.assertEqual(names[-1], hole)
        self.assertEqual(list(result.tags), names)
        for name, triangles in result.tags.items():
            self.assertEqual(triangles.tolist(), [k for k, one in enumerate(expected) if one == name])


class OfArrays(Tags):
    def test_a_surface_that_says_nothing_has_one_tag(self):
        result = insideout.tetrahedralize(surfaces.box())
        self.check(result, ["surface"] * 12)
        self.assertEqual(names_of(result.boundary), ["surface"])

    def test_strings_are_numbered_as_they_come(self):
        values = [face for face in ("top", "wall", "wall", "", "wall", "top") for _ in (1, 2)]
        result = insideout.tetrahedralize(tagged(surfaces.box(), values), tag_array="Part")
        self.check(result, [value or "default" for value in values])
        self.assertEqual(names_of(result.boundary), ["top", "wall", "default"])

    def test_integers_of_every_type_keep_their_meaning_in_order(self):
        values = [7, 7, -3, -3, 100, 100, 7, 7, 0, 0, 100, 100]
        for kind in (np.int8, np.int16, np.int32, np.int64, np.float32, np.float64):
            with self.subTest(kind.__name__):
                result = insideout.tetrahedralize(tagged(surfaces.box(), np.array(values, kind)), tag_array="Part")
                self.check(result, list(map(str, values)))
                self.assertEqual(names_of(result.boundary), ["-3", "0", "7", "100"])
        large = [2**62 + 1, 2**62] * 6
        result = insideout.tetrahedralize(tagged(surfaces.box(), np.array(large, np.uint64)), tag_array="Part")
        self.check(result, list(map(str, large)))
        bits = vtkBitArray()
        bits.SetName("Bits")
        for k in range(12):
            bits.InsertNextValue(k % 2)
        surface = surfaces.box()
        surface.GetCellData().AddArray(bits)
        self.check(insideout.tetrahedralize(surface, tag_array="Bits"), ["0", "1"] * 6)

    def test_a_field_array_may_name_them_and_one_name_is_one_tag(self):
        for name, names in (("Part", "PartNames"), ("PartIds", "PartNames")):
            surface = tagged(surfaces.box(), np.array([0, 1, 2, 3, 4, 5] * 2), name)
            surface.GetFieldData().AddArray(surfaces.strings(names, ["wall", "inlet", "wall", "", "outlet"]))
            result = insideout.tetrahedralize(surface, tag_array=name)
            self.check(result, ["wall", "inlet", "wall", "3", "outlet", "5"] * 2)
            self.assertEqual(names_of(result.boundary), ["wall", "inlet", "3", "outlet", "5"])

    def test_names_are_utf_8_whatever_they_were(self):
        surface = surfaces.box()
        surface.GetCellData().AddArray(surfaces.strings("Part", [b"Geh\xe4use", "Gehäuse", "Deckel"] * 4))
        result = insideout.tetrahedralize(surface, tag_array="Part")
        self.check(result, ["Gehäuse", "Gehäuse", "Deckel"] * 4)

    def test_arrays_that_give_no_tags_are_named(self):
        surface = tagged(surfaces.box(), np.array([1.0] * 7 + [0.5] + [2.0] * 4))
        tagged(surface, np.array([np.nan] * 12), "Unknown")
        tagged(surface, np.array([2**63] * 12, np.uint64), "Huge")
        tagged(surface, np.zeros((12, 2), int), "Pairs")
        surfaces.add_array(surface.GetPointData(), "OfPoints", np.arange(8))
        for name, message in (
            ("Part", "the cell array Part has the value 0.5 at cell 7: tags are integers or strings"),
            ("Unknown", "the cell array Unknown has the value nan at cell 0: tags are integers or strings"),
            ("Huge", "the cell array Huge has the value 9223372036854775808 at cell 0: tags are integers or strings"),
            *((name, f"the surface has no cell array {name} of one integer or string per cell, for its tags") for name in ("Pairs", "None")),
            ("OfPoints", "the point array OfPoints is 0 and 2 at corners of cell 0: tags are of whole cells"),
        ):
            with self.subTest(name), self.assertRaises(insideout.Error) as raised:
                insideout.tetrahedralize(surface, tag_array=name)
            self.assertEqual(str(raised.exception), message)

    def test_the_error_comes_before_the_work(self):
        heard = []
        with self.assertRaises(insideout.Error):
            insideout.tetrahedralize(surfaces.box(), tag_array="None", progress=lambda stage, part: heard.append(stage))
        self.assertNotIn("tetrahedralizing", heard)

    def test_another_array_does_not_mesh_again(self):
        surface = tagged(tagged(surfaces.box(), np.arange(12)), ["a", "b"] * 6, "Other")
        made = insideout.vtkRobustTetrahedralize()
        made.SetInputData(surface)
        made.Update()
        stages = []
        made.AddObserver("ProgressEvent", lambda *_: stages.append(made.GetProgressText()))
        made.SetTagArrayName("Other")
        made.Update()
        self.assertEqual(names_of(made.GetBoundary()), ["a", "b"])
        self.assertNotIn("tetrahedralizing", stages)

    def test_the_first_that_tells_cells_apart_is_taken(self):
        surface, known = surfaces.box(), {}
        order = ("STLSolidLabeling", "MaterialIds", "GroupIds", "BoundaryTag")
        for shift, name in enumerate(order):
            tagged(surface, (np.arange(12) + shift) // 6, name)
            surface.GetFieldData().AddArray(surfaces.strings({"STLSolidLabeling": "None"}.get(name, name.replace("Ids", "") + "Names"), "xyz"))
            known[name] = names_of(insideout.tetrahedralize(surface).boundary)
        self.assertEqual(known["STLSolidLabeling"], ["0", "1"])
        self.assertEqual(known["MaterialIds"], ["x", "y", "z"][: len(set((np.arange(12) + 1) // 6))])
        cells = {name: cell_array(surface, name).tolist() for name in order}
        self.check(insideout.tetrahedralize(surface), ["xyz"[value] for value in cells["BoundaryTag"]])
        tagged(surface, np.zeros(12, int), "BoundaryTag")
        self.check(insideout.tetrahedralize(surface), ["xyz"[value] for value in cells["GroupIds"]])
        tagged(surface, np.ones(12, int), "GroupIds")
        self.check(insideout.tetrahedralize(surface), ["xyz"[value] for value in cells["MaterialIds"]])
        tagged(surface, np.full(12, 0.5), "MaterialIds")
        self.check(insideout.tetrahedralize(surface), [str(value) for value in cells["STLSolidLabeling"]])
        tagged(surface, np.zeros(12, int), "STLSolidLabeling")
        self.check(insideout.tetrahedralize(surface), ["x"] * 12)

    def test_lines_and_vertices_tag_nothing(self):
        surface = surfaces.box()
        surface.SetLines(one_cell(0, 6))
        surface.SetVerts(one_cell(0))
        values = ["point", "line", *("side" if k < 8 else "top" for k in range(12))]
        result = insideout.tetrahedralize(tagged(surface, values), tag_array="Part")
        self.check(result, values)
        self.assertEqual(names_of(result.boundary), ["side", "top"])


class OfDirtySurfaces(Tags):
    """Tags follow the pieces of cut facets, whatever becomes of these."""

    def dirty(self):
        """Boxes that cross, overlap in faces and lie within each other, and an open globe through one: by names."""
        parts = {
            "first": surfaces.box(),
            "crosses": surfaces.box((0.5, 0.25, 0.3), 1),
            "shares a face": surfaces.box((-1, 0, 0), 1),
            "within a plane": surfaces.box((0.25, 0.25, 1), 0.5),
            "is inside": surfaces.box((0.1, 0.1, 0.1), 0.1),
            "globe": open_sphere(),
            "stray": polydata([(5, 5, -2), (7, 5, 2), (5, 7, 2)], [(0, 1, 2)]),
            "crossed by it": surfaces.box((5, 5, -1), 2),
        }
        surface = surfaces.joined(*parts.values())
        names = [name for name, part in parts.items() for _ in range(part.GetNumberOfCells())]
        return tagged(surface, names), names

    def test_each_piece_has_the_tag_of_its_facet(self):
        surface, names = self.dirty()
        result = insideout.tetrahedralize(surface, tag_array="Part")
        self.check(result, names)
        self.assertGreater(result.boundary.GetNumberOfCells(), surface.GetNumberOfCells())
        self.assertEqual(names_of(result.boundary), [*dict.fromkeys(names), "hole"])
        sizes = {name: len(triangles) for name, triangles in result.tags.items()}
        self.assertEqual([name for name, size in sizes.items() if size == 0], ["is inside", "stray"])

    def test_a_tag_lies_on_its_part(self):
        """By places alone: each triangle lies in a plane of the box that it is called by."""
        lows = {"a": ((0, 0, 0), 1), "b": ((0.5, 0.5, 0.5), 1), "c": ((0.25, 0.25, -0.5), 0.75)}
        surface = tagged(boxes(*lows.values()), [name for name in lows for _ in range(12)])
        result = insideout.tetrahedralize(surface, tag_array="Part")
        middles = result.boundary.points[result.boundary.triangles].mean(axis=1)
        self.assertEqual(list(result.tags), ["a", "b", "c"])
        for name, triangles in result.tags.items():
            low, size = np.array(lows[name][0]), lows[name][1]
            places = (middles[triangles] - low) / size
            self.assertGreater(len(places), 0)
            self.assertTrue((np.abs(np.abs(places - 0.5).max(axis=1) - 0.5) < 1e-12).all(), name)

    def test_merged_pieces_and_seams_keep_their_tags(self):
        surface, names = self.dirty()
        texture = surfaces.add_array(surface.GetPointData(), "uv", np.random.default_rng(1).random((surface.GetNumberOfPoints(), 2)))
        surface.GetPointData().SetTCoords(texture)
        counts = []
        for merge in (False, True):
            for split in (False, True):
                result = insideout.tetrahedralize(surface, tag_array="Part", merge_coplanar_pieces=merge, split_seams=split)
                self.check(result, names)
                counts.append((result.boundary.GetNumberOfCells(), result.boundary.GetNumberOfPoints()))
        self.assertEqual(counts[0][0], counts[1][0])
        self.assertLess(counts[2][0], counts[0][0])
        self.assertLess(counts[0][1], counts[1][1])

    def test_slabs_and_rims_have_the_tag_of_their_sheet(self):
        sheet = polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        result = insideout.tetrahedralize(tagged(sheet, ["near", "far"]), tag_array="Part", thicken=0.25)
        self.check(result, ["near", "far"])
        points, triangles = result.boundary.points, result.boundary.triangles
        for name, side in (("near", 1), ("far", -1)):
            middles = points[triangles[result.tags[name]]].mean(axis=1)
            on_rim = (np.abs(np.abs(middles[:, :2] - 0.5) - 0.5) < 0.15).any(axis=1) & (np.abs(middles[:, 2]) < 0.1)
            self.assertTrue(on_rim.any(), name)
            self.assertTrue((side * (middles[:, 0] - middles[:, 1]) > 0).all(), name)

    def test_holes_have_a_name_of_their_own(self):
        surface = surfaces.open_box()
        for names, hole in ((["hole"] * 10, "hole_2"), (["hole", "hole_2"] * 5, "hole_3")):
            self.check(insideout.tetrahedralize(tagged(surface, names), tag_array="Part"), names, hole)

    def test_polygons_and_strips_have_one_tag_each(self):
        quads = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5)]
        surface = polydata(surfaces.box_points(), quads)
        surface.SetStrips(one_cell(3, 0, 7, 4))
        names = list("abcdef")
        result = insideout.tetrahedralize(tagged(surface, names), tag_array="Part")
        self.check(result, names)
        self.assertEqual([len(triangles) for triangles in result.tags.values()], [2] * 6)

    def test_a_second_run_keeps_the_tags_of_the_first(self):
        surface, names = self.dirty()
        first = insideout.tetrahedralize(surface, tag_array="Part")
        again = insideout.tetrahedralize(first.boundary)
        of_cell = np.array(names_of(first.boundary))[cell_array(first.boundary, "BoundaryTag")]
        self.check(again, of_cell.tolist(), "no hole is left")
        self.assertEqual(names_of(again.boundary), [name for name, triangles in first.tags.items() if len(triangles)])


def obj_box() -> str:
    """A group for each face; the first three are of steel."""
    lines = ["v {} {} {}".format(*point) for point in surfaces.box_points()] + ["o box"]
    for k, facet in enumerate(surfaces.BOX_FACETS):
        lines += [] if k % 2 else [f"g {FACES[k // 2]}", "usemtl " + ("steel" if k < 6 else "glass")]
        lines.append("f {} {} {}".format(*(p + 1 for p in facet)))
    return "\n".join(lines)


def stl_box() -> str:
    """A solid for each face."""
    points, lines = surfaces.box_points(), []
    for k, facet in enumerate(surfaces.BOX_FACETS):
        lines += [] if k % 2 else [f"solid {FACES[k // 2]}"]
        lines += ["facet normal 0 0 0", "outer loop", *("vertex {} {} {}".format(*points[p]) for p in facet), "endloop", "endfacet"]
        lines += [f"endsolid {FACES[k // 2]}"] if k % 2 else []
    return "\n".join(lines)


OBJ, STL = obj_box(), stl_box()


class OfFiles(CommandLine, Tags):
    def test_groups_and_materials_of_obj(self):
        path = self.file("box.obj", OBJ)
        of_cell = [face for face in FACES for _ in (1, 2)]
        self.check(insideout.tetrahedralize(path), of_cell)
        materials = ["steel"] * 6 + ["glass"] * 6
        self.check(insideout.tetrahedralize(path, tag_array="MaterialIds"), materials)
        one_group = self.file("materials.obj", "\n".join(line for line in OBJ.splitlines() if line[:2] != "g "))
        self.check(insideout.tetrahedralize(one_group), materials)

    def test_solids_of_stl(self):
        of_cell = [face for face in FACES for _ in (1, 2)]
        self.check(insideout.tetrahedralize(self.file("box.stl", STL)), of_cell)
        walls = STL.replace("solid left", "solid wall").replace("solid right", "solid wall").replace("solid front", "solid")
        expected = [{"left": "wall", "right": "wall", "front": "2"}.get(face, face) for face in of_cell]
        self.check(insideout.tetrahedralize(self.file("walls.stl", walls)), expected)

    def test_names_survive_files_and_pickles(self):
        result = pickle.loads(pickle.dumps(insideout.tetrahedralize(self.file("box.obj", OBJ))))
        self.check(result, [face for face in FACES for _ in (1, 2)])
        of_triangle = [FACES[tag] for tag in cell_array(result.boundary, "BoundaryTag")]
        for ending in (".vtp", ".obj"):
            path = self.path("boundary" + ending)
            write_surface(result.boundary, path)
            self.check(insideout.tetrahedralize(path), of_triangle)
        again = read_surface(self.path("boundary.vtp"))[0]
        self.assertEqual(names_of(again), list(FACES))
        self.assertEqual(cell_array(again, "BoundaryTag").tolist(), cell_array(result.boundary, "BoundaryTag").tolist())

    def test_the_command_tells_and_writes_them(self):
        path = self.file("box.obj", OBJ.replace("f 5 6 7", "").replace("f 5 7 8", "") + "\ng odd\nf 1 1 1\n")
        report, boundary = self.path("report.json"), self.path("boundary.vtp")
        done = run(path, self.output, "--report", report, "--boundary", boundary)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("\n  tags bottom 2, front 2, back 2, right 2, left 2, odd 0, hole 2\n", done.stdout)
        self.assertNotIn("regions", done.stdout)
        with open(report, encoding="utf-8") as file:
            told = json.load(file)
        names = [*(face for face in FACES if face != "top"), "odd", "hole"]
        self.assertEqual(told["tags"], dict(zip(names, (2, 2, 2, 2, 2, 0, 2))))
        self.assertEqual(names_of(read_surface(boundary)[0]), names)
        self.assertEqual(len(told["regions"]), 1)
        done = run(path, self.output, "--tag-array", "MaterialIds", "--boundary", boundary)
        self.assertEqual(names_of(read_surface(boundary)[0]), ["steel", "glass", "hole"])
        self.assertIn("\n  tags steel 4, glass 6, hole 2\n", done.stdout)

    def test_the_command_says_what_array_there_is_not(self):
        self.check_failure(run(self.file("box.obj", OBJ), self.output, "--tag-array", "Part"), "no cell array Part")


class OfBlocks(Tags):
    def run_on(self, *surfaces_by_name, **options):
        blocks = vtkMultiBlockDataSet()
        for k, (name, surface) in enumerate(surfaces_by_name):
            blocks.SetBlock(k, surface)
            if name is not None:
                blocks.GetMetaData(k).Set(vtkCompositeDataSet.NAME(), name)
        made = insideout.vtkRobustTetrahedralize()
        made.SetInputDataObject(blocks)
        for name, value in options.items():
            getattr(made, "Set" + name)(value)
        insideout.pipeline.run(made)
        boundaries = [made.GetOutputDataObject(1).GetBlock(k) for k in range(len(surfaces_by_name))]
        return [(names_of(one), set(cell_array(one, "BoundaryTag"))) for one in boundaries]

    def test_blocks_are_numbered_over_all_of_them(self):
        found = self.run_on(("wing", surfaces.box()), (None, surfaces.open_box()), ("tail", surfaces.box()), ("wing", surfaces.box((3, 3, 3))))
        names = ["wing", "1", "tail"]
        self.assertEqual(found, [(names, {0}), ([*names, "hole"], {1, 3}), (names, {2}), (names, {0})])

    def test_arrays_that_differ_within_a_block_come_first(self):
        grouped = tagged(surfaces.box(), np.arange(12) // 6, "GroupIds")
        self.assertEqual(self.run_on(("wing", surfaces.box()), ("tail", grouped)), [(["wing", "tail"], {0}), (["0", "1"], {0, 1})])

    def test_a_block_alone_needs_no_number(self):
        self.assertEqual(self.run_on((None, surfaces.box())), [(["surface"], {0})])
        self.assertEqual(self.run_on(("wing", surfaces.box())), [(["wing"], {0})])
        one_group = tagged(surfaces.box(), np.zeros(12, int), "GroupIds")
        self.assertEqual(self.run_on(("wing", one_group)), [(["0"], {0})])


def integrals(surface: vtkPolyData):
    """Volume, center of mass and inertia tensor within a closed surface, by exact integrals over it (Gauss's theorem)."""
    points = [[Fraction(x) for x in point] for point in surfaces.points_of(surface).tolist()]
    volume, first, second = Fraction(0), [Fraction(0)] * 3, [[Fraction(0)] * 3 for _ in range(3)]
    for a, b, c in ([points[p] for p in triangle] for triangle in surfaces.triangles_of(surface).tolist()):
        six = sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
        total = [a[i] + b[i] + c[i] for i in range(3)]
        volume += six / 6
        for i in range(3):
            first[i] += six * total[i] / 24
            for j in range(i, 3):
                second[i][j] += six * (total[i] * total[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]) / 120
    center = [x / volume for x in first]
    xx, yy, zz, xy, yz, xz = (second[i][j] - volume * center[i] * center[j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)))
    return float(volume), list(map(float, center)), list(map(float, (yy + zz, xx + zz, xx + yy, -xy, -yz, -xz)))


class Regions(unittest.TestCase):
    def expect_mass(self, found: insideout.Region, volume, center, inertia, size: float = 1.0):
        few = 1e-14
        self.assertAlmostEqual(found.volume, volume, delta=few * volume)
        for one, other in zip(found.center_of_mass, center):
            self.assertAlmostEqual(one, other, delta=few * size)
        for one, other in zip(found.inertia, inertia):
            self.assertAlmostEqual(one, other, delta=few * max(inertia))

    def ellipsoid(self) -> vtkPolyData:
        closed = open_sphere()
        points, triangles = surfaces.points_of(closed), surfaces.triangles_of(closed).tolist()
        top = len(points)
        triangles += [(k, (k + 1) % 24, top) for k in range(24)]
        turned = np.linalg.qr(np.arange(9).reshape(3, 3) ** 2 + np.eye(3))[0]
        turned *= np.sign(np.linalg.det(turned))
        return polydata(([*points.tolist(), (0, 0, 1)] * np.array([1, 2, 0.3])) @ turned + (10, -7, 3), triangles)

    def test_each_solid_weighs_what_the_integral_over_its_surface_says(self):
        parts = [surfaces.box((-3, 0, 0), 2), self.ellipsoid(), surfaces.box((20, 0, 0), 1 / 3)]
        result = insideout.tetrahedralize(surfaces.joined(*parts))
        self.assertEqual(result.statistics["Regions"], 3)
        found = sorted(result.regions, key=lambda region: region.center_of_mass[0])
        for region, part in zip(found, parts):
            self.expect_mass(region, *integrals(part), size=20)
        self.expect_mass(found[0], 8, (-2, 1, 1), (16 / 3, 16 / 3, 16 / 3, 0, 0, 0))

    def test_the_tetrahedra_of_a_region_weigh_what_it_does(self):
        result = insideout.tetrahedralize(surfaces.joined(surfaces.two_boxes(), self.ellipsoid()))
        volumes = np.array(list(map(float, surfaces.exact_volumes(result.solid))))
        region_of = cell_array(result.solid, "RegionId")
        self.assertEqual(region_of.dtype, np.int32)
        first = [int(np.flatnonzero(region_of == k)[0]) for k in range(2)]
        self.assertEqual((first[0], first == sorted(first)), (0, True))
        for k, region in enumerate(result.regions):
            self.assertAlmostEqual(volumes[region_of == k].sum(), region.volume, delta=1e-13)
        self.assertAlmostEqual(sum(region.volume for region in result.regions), result.statistics["Volume"], delta=1e-13)

    def test_they_do_not_depend_on_the_tetrahedra(self):
        """Cells that count nothing shape the mesh: the solid stays, but is cut otherwise."""
        plain = surfaces.joined(self.ellipsoid(), surfaces.box((20, 0, 0)))
        within = surfaces.box((9.9, -7.1, 2.95), 0.1)
        cut = tagged(surfaces.joined(plain, within), [0] * plain.GetNumberOfCells() + [1] * 12, "Extra")
        one, other = insideout.tetrahedralize(plain), insideout.tetrahedralize(cut, non_participating_array="Extra")
        self.assertNotEqual(one.solid.GetNumberOfCells(), other.solid.GetNumberOfCells())
        by_place = [sorted(result.regions, key=lambda region: region.center_of_mass[0]) for result in (one, other)]
        for a, b in zip(*by_place):
            self.expect_mass(a, b.volume, b.center_of_mass, b.inertia, size=20)

    def test_parts_that_touch_in_an_edge_or_a_point_are_two(self):
        for low, count in (((1, 0, 0), 1), ((1, 1, 0), 2), ((1, 1, 1), 2), ((0.5, 0.5, 0.5), 1), ((2, 0, 0), 2)):
            result = insideout.tetrahedralize(boxes(((0, 0, 0), 1), (low, 1)))
            self.assertEqual(len(result.regions), count, low)
            self.assertEqual(result.statistics["Regions"], count)

    def test_cells_outside_are_in_none(self):
        result = insideout.tetrahedralize(boxes(((0, 0, 0), 1), ((3, 1, 0), 1)))
        region_of = cell_array(result.hull, "RegionId")
        self.assertEqual((region_of == -1).tolist(), (cell_array(result.hull, "Inside") == 0).tolist())
        self.assertEqual(region_of[region_of >= 0].tolist(), cell_array(result.solid, "RegionId").tolist())
        made = insideout.vtkRobustTetrahedralize()
        made.SetInputData(boxes(((0, 0, 0), 1), ((3, 1, 0), 1)))
        made.Update()
        self.assertEqual(cell_array(made.GetOutput(), "RegionId").tolist(), cell_array(result.solid, "RegionId").tolist())
        shapes = {"RegionVolume": 1, "RegionCenterOfMass": 3, "RegionInertia": 6}
        for name, components in shapes.items():
            array = made.GetOutput().GetFieldData().GetArray(name)
            self.assertEqual((array.GetNumberOfTuples(), array.GetNumberOfComponents()), (2, components))

    def test_nothing_has_none(self):
        result = insideout.tetrahedralize(surfaces.closed_both_ways(), orientation="as-given")
        self.assertEqual((result.regions, result.statistics["Regions"]), ([], 0))
        self.assertEqual({name: len(triangles) for name, triangles in result.tags.items()}, {"surface": 0})


class ByGeometry(Tags):
    """Tags of boxes, whose facets are those of `FACES` in pairs."""

    def tags(self, surface, rules, **options) -> list:
        result = insideout.tetrahedralize(surface, tag_rules=rules, **options)
        names = names_of(result.boundary)
        self.assertEqual(list(result.tags), names)
        return [names[tag] for tag in cell_array(result.boundary, "BoundaryTag").tolist()]

    def test_rules_come_after_the_tags_that_facets_have(self):
        surface = tagged(surfaces.box(), [face for face in FACES for _ in (1, 2)])
        sides = ["front", "front", "back", "back", "right", "right", "left", "left"]
        for rules in ("lid=normal 0 0 1; bottom=plane 0 0 1 0 0 1 & array Odd", ["lid=normal 0 0 1"], {"lid": "normal 0 0 1"}):
            surfaces.add_array(surface.GetCellData(), "Odd", np.arange(12) % 2)
            expected = ["lid", "bottom"] if "array" in rules else ["lid", "lid"]
            self.assertCountEqual(self.tags(surface, rules, tag_array="Part"), ["bottom", "bottom", *expected, *sides])
            self.assertCountEqual(self.tags(surface, rules, tag_array="Part", surface_only=True), ["bottom", "bottom", *expected, *sides])

    def test_normals_point_out_of_the_solid_however_facets_are_turned(self):
        for surface in (surfaces.box(), surfaces.reversed_box()):
            result = insideout.tetrahedralize(surface, tag_rules={"lid": "normal 0 0 1"})
            top = result.boundary.points[result.boundary.triangles[result.tags["lid"]]]
            self.assertEqual((len(result.tags["lid"]), top[..., 2].tolist()), (2, [[1.0] * 3] * 2))

    def test_triangles_that_close_a_hole_are_tagged_by_rules(self):
        result = insideout.tetrahedralize(surfaces.open_box(), tag_rules="lid=normal 0 0 1")
        self.assertEqual({name: len(found) for name, found in result.tags.items()}, {"surface": 10, "lid": 2})

    def test_a_remeshed_surface_keeps_the_edges_between_them(self):
        rules = {"patch": lambda centers, normals: (centers[:, 2] > 0.9) & (centers[:, 0] > centers[:, 1]), "floor": "normal 0 0 -1"}
        result = insideout.tetrahedralize(surfaces.box(), tag_rules=rules, edge_length=0.2)
        corners = result.boundary.points[result.boundary.triangles]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        self.assertGreater(len(areas), 100)
        for name, area in (("patch", 0.5), ("floor", 1), ("surface", 4.5)):
            self.assertAlmostEqual(areas[result.tags[name]].sum(), area, delta=1e-12)
        self.assertNotIn("InsideOutTag_0", result.boundary.cell_arrays)

    def test_functions_get_the_polygons_as_they_are_given(self):
        seen = []

        def note(centers, normals):
            seen.extend((centers, normals))
            return np.ones(len(centers), bool)

        quads = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (1, 2, 6, 5), (3, 0, 4, 7)]
        self.assertEqual({*self.tags(surfaces.polydata(surfaces.box_points(), quads), {"all": note})}, {"all"})
        centers, normals = seen
        outward = np.array([(0, 0, -1), (0, 0, 1), (0, -1, 0), (0, 1, 0), (1, 0, 0), (-1, 0, 0)])
        np.testing.assert_allclose(normals, outward, atol=1e-15)
        np.testing.assert_allclose(centers, 0.5 + outward / 2, atol=1e-15)
        with self.assertRaisesRegex(insideout.Error, r"^the function of the tag odd gives .*; it must give 12 bools, one for each polygon"):
            insideout.tetrahedralize(surfaces.box(), tag_rules={"odd": lambda centers, normals: [True]})

    def test_a_rule_without_a_triangle_is_told_and_a_wrong_one_named(self):
        result = insideout.tetrahedralize(surfaces.box(), tag_rules="far=box 5 5 5 6 6 6")
        self.assertIn("no triangle of the boundary is tagged by the rule far=box 5 5 5 6 6 6", result.warnings)
        heard = []
        for rules, message in (
            ("far", "^the rule far is not a name, an equals sign and a condition"),
            ({"a": "box 1"}, "^the rule a=box 1 has 1 numbers behind box, which takes X Y Z X Y Z"),
            ({"a;b": "faces"}, "^tag_rules is .*; it must be conditions by names, without semicolons"),
        ):
            with self.assertRaisesRegex(insideout.Error, message):
                insideout.tetrahedralize(surfaces.box(), tag_rules=rules, progress=lambda stage, part: heard.append(stage))
        with self.assertRaisesRegex(insideout.Error, "^the rule a=array Odd names a cell array of one number per cell, which the surface does not have"):
            insideout.tetrahedralize(surfaces.box(), tag_rules="a=array Odd")
        self.assertLessEqual({*heard}, {"working"})

    def test_bodies_have_them_too(self):
        bodies = {"low": surfaces.box(), "high": surfaces.box((0, 0, 1))}
        result = insideout.tetrahedralize(bodies, tag_rules={"lid": "normal 0 0 1 & plane 0 0 2 0 0 1"})
        self.assertEqual({name: len(found) for name, found in result.tags.items()}, {"low|outside": 10, "high|outside": 8, "low|high": 2, "lid": 2})


class GeometryOnTheCommandLine(CommandLine):
    def test_tags_are_sets_supports_loads_and_walls_with_layers(self):
        path, solid = self.file("box.ply", surfaces.box()), self.path("solid.inp")
        rules = ("--tag", "foot=face 0.5 0.5 -1", "--tag", "lid=normal 0 0 1")
        done = run("mesh", path, solid, *rules, "--material", "steel", "--fix", "foot", "--pressure", "lid", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(solid, encoding="ascii") as file:
            deck = file.read()
        self.assertRegex(deck, r"\*NSET, NSET=foot\n")
        self.assertIn("*BOUNDARY\nfoot, 1, 3\n", deck)
        self.assertIn("*DSLOAD\nlid, P, 2\n", deck)
        self.assertIn("tags surface ", done.stdout)
        report = self.path("report.json")
        layers = ("--layers", "2", "--first-height", "0.02", "--layer-tags", "lid", "--edge-length", "0.3", "--report", report)
        done = run("mesh", path, self.output, *rules, *layers)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(report, encoding="utf-8") as file:
            told = json.load(file)
        self.assertEqual(told["parameters"]["tag_rules"], "foot=face 0.5 0.5 -1;lid=normal 0 0 1")
        self.assertEqual(set(told["tags"]), {"surface", "foot", "lid"})
        self.assertEqual(told["statistics"]["Layers"], 2)


class RegionsOnTheCommandLine(CommandLine):
    def test_it_tells_them(self):
        path = self.file("boxes.ply", boxes(*(((2 * k, 0, 0), 1) for k in range(10))))
        report = self.path("report.json")
        done = run(path, self.output, "--report", report)
        self.assertIn("\n  10 regions, of volume 1, 1, 1, 1, 1, 1, 1, 1 and 2 more\n", done.stdout)
        self.assertNotIn("tags", done.stdout)
        with open(report, encoding="utf-8") as file:
            told = json.load(file)
        self.assertEqual(told["tags"], {"surface": told["statistics"]["BoundaryFaces"]})
        self.assertEqual([len(told["regions"]), told["statistics"]["Regions"]], [10, 10])
        first = min(told["regions"], key=lambda region: region["center_of_mass"][0])
        self.assertAlmostEqual(first["volume"], 1, 14)
        np.testing.assert_allclose(first["center_of_mass"], [0.5] * 3, atol=1e-14)
        np.testing.assert_allclose(first["inertia"], [1 / 6] * 3 + [0] * 3, atol=1e-14)


if __name__ == "__main__":
    unittest.main()
