# SPDX-License-Identifier: GPL-3.0-or-later
"""Tags, groups, materials and arrays of bodies in set operations: by name, in files, in chains, and their areas as a law."""

import unittest

import insideout
import numpy as np
import surfaces
from command import CommandLine, run
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

PIPE = """v 0 0 0\nv 2 0 0\nv 0 3 0\nv 2 3 0\nv 0 0 4\nv 2 0 4\nv 0 3 4\nv 2 3 4
g inlet\nf 1 5 7 3\ng outlet\nf 2 4 8 6\ng wall\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4
"""
"""A block of 2 x 3 x 4."""

SIDES = ("floor", "floor", "roof", "roof", *["wall"] * 8)
"""The sides of surfaces.box: z = 0, z = 1, and the others."""

TAGS = ("BoundaryTag", "BoundaryTagNames"), ("GroupIds", "GroupNames"), ("MaterialIds", "MaterialNames"), ("Part", "PartNames")


def tagged(surface: vtkPolyData, of_cell, array: str = "GroupIds", names: str = "GroupNames") -> vtkPolyData:
    """A surface whose cells have tags by name, numbered in the order of these names."""
    all_names = sorted(set(of_cell))
    surfaces.add_array(surface.GetCellData(), array, np.array([all_names.index(name) for name in of_cell], np.int32))
    surface.GetFieldData().AddArray(surfaces.strings(names, all_names))
    return surface


def cutter() -> vtkPolyData:
    """Reaches 2 into the roof of the pipe."""
    return surfaces.polydata(np.array(surfaces.box_points()) * (1, 1, 3) + (0.5, 1, 2), surfaces.triangles_of(surfaces.box()))


def triangle_areas(surface: vtkPolyData) -> np.ndarray:
    a, b, c = surfaces.points_of(surface)[surfaces.triangles_of(surface)].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def called(surface: vtkPolyData, array: str = "BoundaryTag", names: str = "BoundaryTagNames") -> list[str]:
    """The name of each cell by an array."""
    data, fields = surface.GetCellData().GetAbstractArray(array), surface.GetFieldData().GetAbstractArray(names)
    if isinstance(data, vtkStringArray):
        return [data.GetValue(cell) for cell in range(data.GetNumberOfValues())]
    return [fields.GetValue(int(data.GetTuple1(cell))) for cell in range(data.GetNumberOfTuples())]


def areas(surface: vtkPolyData, *array: str) -> dict[str, float]:
    sums: dict[str, float] = {}
    for name, area in zip(called(surface, *array), triangle_areas(surface)):
        sums[name] = sums.get(name, 0) + area
    return {name: round(area, 9) for name, area in sums.items()}


def of_tags(result: insideout.Tetrahedralization) -> dict[str, float]:
    size = triangle_areas(result.boundary)
    return {name: round(float(size[triangles].sum()), 9) for name, triangles in result.tags.items()}


class Names(CommandLine):
    AREAS = {"inlet": 12, "outlet": 12, "wall": 27, "cut": 9}

    def test_a_body_without_groups_is_called_by_its_name_in_any_order(self):
        pipe, cut = self.file("pipe.obj", PIPE), cutter()
        for bodies in ({"pipe": pipe, "cut": cut}, {"cut": cut, "pipe": pipe}):
            for tetrahedra in (False, True):
                made = insideout.boolean(bodies, "pipe - cut", tetrahedra=tetrahedra)
                self.assertEqual(made.warnings, [])
                self.assertEqual(areas(made.surface), self.AREAS)
                self.assertEqual(areas(made.surface, "GroupIds", "GroupNames"), self.AREAS)
                for options in ({}, {"tag_array": "GroupIds"}, {"surface_only": True}):
                    self.assertEqual(of_tags(insideout.tetrahedralize(made.surface, **options)), self.AREAS)

    def test_files_keep_them(self):
        pipe, cut = self.file("pipe.obj", PIPE), self.file("cut.off", cutter())
        for ending in (".obj", ".vtp", ".ply"):
            path = self.path("rest" + ending)
            done = run("boolean", "pipe - cut", pipe, cut, path)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = {name: str(number) for number, name in enumerate(self.AREAS)} if ending == ".ply" else {}
            self.assertEqual(of_tags(insideout.tetrahedralize(path)), {names.get(name, name): area for name, area in self.AREAS.items()})
        path = self.path("rest.msh")
        self.assertEqual(run("boolean", "pipe - cut", pipe, cut, path).returncode, 0)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        for name in self.AREAS:
            self.assertIn(f'"{name}"', text)

    def test_a_name_of_several_bodies_gets_theirs(self):
        for array, names in TAGS:
            with self.subTest(array):
                pipe = tagged(surfaces.box((0, 0, 0), 4), SIDES, array, names)
                cut = tagged(surfaces.box((1, 1, 2), 3), [name if name != "wall" else "side" for name in SIDES], array, names)
                for bodies in ({"pipe": pipe, "cut": cut}, {"cut": cut, "pipe": pipe}):
                    made = insideout.boolean(bodies, "pipe - cut").surface
                    expected = {"pipe/floor": 16, "pipe/roof": 7, "wall": 52, "cut/floor": 9, "side": 12}
                    self.assertEqual(areas(made, array, names), expected)
                    self.assertEqual(of_tags(insideout.tetrahedralize(made, tag_array=array))["cut/floor"], 9)

    def test_the_name_of_a_body_is_its_own(self):
        pipe = tagged(surfaces.box((0, 0, 0), 4), ["cut" if name == "floor" else name for name in SIDES])
        made = insideout.boolean({"pipe": pipe, "cut": surfaces.box((1, 1, 2), 3)}, "pipe - cut").surface
        self.assertEqual(areas(made), {"pipe/cut": 16, "roof": 7, "wall": 52, "cut": 21})

    def test_each_body_is_tagged_by_the_first_array_that_tells_its_cells_apart(self):
        pipe = tagged(surfaces.box((0, 0, 0), 4), SIDES, "MaterialIds", "MaterialNames")
        cut = tagged(surfaces.box((1, 1, 2), 3), ["low" if name == "floor" else "high" for name in SIDES], "BoundaryTag", "BoundaryTagNames")
        made = insideout.boolean({"pipe": pipe, "cut": cut}, "pipe - cut").surface
        self.assertEqual(areas(made), {"floor": 16, "roof": 7, "wall": 52, "low": 9, "high": 12})
        self.assertEqual(areas(made, "MaterialIds", "MaterialNames"), {"floor": 16, "roof": 7, "wall": 52, "cut": 21})
        for nothing in (surfaces.box((1, 1, 2), 3), insideout.tetrahedralize(surfaces.box((1, 1, 2), 3)).boundary):
            made = insideout.boolean({"pipe": surfaces.box((0, 0, 0), 4), "cut": nothing}, "pipe - cut").surface
            self.assertEqual(areas(made), {"pipe": 75, "cut": 21})

    def test_numbers_without_names_and_strings(self):
        numbers = np.array([SIDES.index(name) for name in SIDES])
        pipe, cut = surfaces.box((0, 0, 0), 4), surfaces.box((1, 1, 2), 3)
        surfaces.add_array(pipe.GetCellData(), "GroupIds", numbers)
        surfaces.add_array(cut.GetCellData(), "GroupIds", numbers + 4)
        made = insideout.boolean({"pipe": pipe, "cut": cut}, "pipe - cut").surface  # 4 is the pipe's walls, and the cut's floor
        self.assertEqual(areas(made, "GroupIds", "GroupNames"), {"0": 16, "2": 7, "pipe/4": 52, "cut/4": 9, "8": 12})
        surfaces.add_array(cut.GetCellData(), "GroupIds", numbers + 10)
        made = insideout.boolean({"pipe": pipe, "cut": cut}, "pipe - cut").surface  # they tell all apart as they are
        self.assertEqual(sorted(set(surfaces.cell_array(made, "GroupIds").tolist())), [0, 2, 4, 10, 14])
        pipe.GetCellData().AddArray(surfaces.strings("Face", SIDES))
        made = insideout.boolean({"pipe": pipe, "cut": cut}, "pipe - cut").surface
        self.assertEqual(areas(made, "Face"), {"floor": 16, "roof": 7, "wall": 52, "cut": 21})

    def test_triangles_that_close_a_hole_are_tagged_hole(self):
        lid_less = tagged(surfaces.open_box(), [*SIDES[:2], *SIDES[4:]])
        lid_less.GetCellData().AddArray(surfaces.strings("Face", [*SIDES[:2], *SIDES[4:]]))
        surfaces.add_array(lid_less.GetCellData(), "MaterialIds", np.array([0, 0, *[5] * 8]))
        for bodies in ([lid_less], [lid_less, surfaces.box((3, 3, 3))]):
            made = insideout.boolean(bodies).surface
            self.assertIn(-1, surfaces.cell_array(made, "vtkOriginalCellIds"))
            box = {} if len(bodies) == 1 else {"B": 6}
            for array in ((), ("GroupIds", "GroupNames"), ("Face",)):
                self.assertEqual(areas(made, *array), {"floor": 1, "wall": 4, "hole": 1, **box})
            self.assertEqual(areas(made, "MaterialIds", "MaterialNames"), {"0": 1, "5": 4, "hole": 1, **box})


class Arrays(unittest.TestCase):
    def test_arrays_of_different_types_stay_apart(self):
        first, second = surfaces.box((0, 0, 0), 4), surfaces.box((1, 1, 2), 3)
        surfaces.add_array(first.GetCellData(), "load", np.arange(12.0))
        surfaces.add_array(second.GetCellData(), "load", np.arange(36.0).reshape(12, 3))
        surfaces.add_array(first.GetPointData(), "heat", np.arange(8.0))
        surfaces.add_array(second.GetPointData(), "heat", np.arange(16.0).reshape(8, 2))
        surfaces.add_array(first.GetCellData(), "GroupIds", np.full(12, 0.5))
        tagged(second, SIDES)
        for bodies in ({"first": first, "second": second}, {"second": second, "first": first}):
            made = insideout.boolean(bodies, "first - second")
            bodies_of, cells = ([n == "first" for n in np.array(made.names)[made.bodies]], surfaces.cell_array(made.surface, "vtkOriginalCellIds"))
            of_first, of_second = (surfaces.cell_array(made.surface, f"{name}/load") for name in ("first", "second"))
            np.testing.assert_array_equal(of_first, np.where(bodies_of, cells, np.nan))
            np.testing.assert_array_equal(of_second[:, 0], np.where(bodies_of, np.nan, 3.0 * cells))
            self.assertIsNone(made.surface.GetCellData().GetArray("load"))
            self.assertEqual({name for name in made.surface.point_arrays if name.endswith("heat")}, {"first/heat", "second/heat"})
            self.assertEqual(set(surfaces.cell_array(made.surface, "first/GroupIds")[bodies_of]), {0.5})
            self.assertEqual(areas(made.surface, "GroupIds", "GroupNames")["first"], 75)
            for words in ("body first: the array load is passed on as first/load", "body second: the array heat is passed on as second/heat", "body first: the array GroupIds is passed on as first/GroupIds"):
                self.assertTrue(any(line.startswith(words) for line in made.warnings), (words, made.warnings))

    def test_chains_gain_none(self):
        ball = surfaces.ball(1, 8, 7)
        points, random = surfaces.points_of(ball), np.random.default_rng(4)
        balls = [tagged(surfaces.polydata(points + random.uniform(0, 6, 3), surfaces.triangles_of(ball)), ["a", "b"] * (ball.GetNumberOfCells() // 2)) for _ in range(12)]
        at_once = insideout.boolean(balls).surface
        chain = balls[0]
        for number, one in enumerate(balls[1:]):
            chain = insideout.boolean({"all": chain, f"ball{number}": one}).surface
        for data in ("GetPointData", "GetCellData", "GetFieldData"):
            self.assertEqual(*[sorted(getattr(made, data)().GetArrayName(k) for k in range(getattr(made, data)().GetNumberOfArrays())) for made in (chain, at_once)])
        self.assertAlmostEqual(chain.GetActualMemorySize() / at_once.GetActualMemorySize(), 1, 1)
        self.assertEqual(len(set(called(chain))), 24)
        np.testing.assert_allclose(sorted(areas(chain).values()), sorted(areas(at_once).values()), rtol=1e-6)
        self.assertLess(max(map(len, called(chain))), 12)


class Pieces(CommandLine):
    def test_are_joined_where_all_of_a_facet_is_there(self):
        # The inner box cuts faces that it shares, and leaves all of them.
        bodies = {"box": tagged(surfaces.box((0, 0, 0), 4), SIDES), "inner": surfaces.box((1, 1, 1), 3)}
        split, joined = (insideout.boolean(bodies, "box | inner", merge_coplanar_pieces=merge).surface for merge in (False, True))
        self.assertGreater(split.GetNumberOfCells(), 12)
        self.assertEqual(joined.GetNumberOfCells(), 12)
        self.assertEqual(areas(joined), areas(split))
        self.assertEqual(areas(joined), {"floor": 16, "roof": 16, "wall": 64})
        tetrahedra = insideout.boolean(bodies, "box | inner", merge_coplanar_pieces=True, tetrahedra=True)
        self.assertEqual(tetrahedra.surface.GetNumberOfCells(), 12)
        self.assertGreater(tetrahedra.solid.GetNumberOfCells(), 0)

    def test_on_the_command_line(self):
        box, wall = self.file("box.off", surfaces.box((0, 0, 0), 4)), self.file("wall.off", surfaces.box((1, 1, 1), 3))
        self.output = self.path("rest.off")
        for options, count in (((), 0), (("--merge-coplanar-pieces", "--force"), 12)):
            self.assertEqual(run("boolean", "box | wall", box, wall, self.output, *options).returncode, 0)
            found = insideout.files.read_surface(self.output)[0].GetNumberOfCells()
            self.assertEqual(found == 12, count == 12)
        self.output = self.path("rest.msh")
        self.check_failure(run("boolean", "box | wall", box, wall, self.output, "--merge-coplanar-pieces"), "not faces of tetrahedra")


class Law(unittest.TestCase):
    """The area of each tag of a result is that of the pieces that stay."""

    SEED = 20

    def body(self, random: np.random.Generator) -> vtkPolyData:
        """A box or a ball anywhere, turned at will."""
        shape = surfaces.box() if random.random() < 0.5 else surfaces.ball(0.7, 7, 6)
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        points = surfaces.points_of(shape)
        points = (points - points.mean(axis=0)) @ turn.T * random.uniform(0.7, 1.3) + random.normal(size=3) / 4
        return surfaces.polydata(points, surfaces.triangles_of(shape))

    def with_tags(self, body: vtkPolyData, random: np.random.Generator, array: str, names: str):
        """What each cell of a body says: by names that other bodies may have too, or nothing."""
        if random.random() < 0.25:
            return [None] * body.GetNumberOfCells()
        of_cell = random.choice(["floor", "wall", "roof", "A", "B", "1"], body.GetNumberOfCells()).tolist()
        if random.random() < 0.3:
            body.GetCellData().AddArray(surfaces.strings(array, of_cell))
        else:
            tagged(body, of_cell, array, names)
        return of_cell

    def pieces(self, bodies: list[vtkPolyData], expression: str):
        """Each body's cells, and how much of each is on the surface of the result: by pieces of all, and by places in them alone."""
        whole = insideout.resolve(surfaces.joined(*bodies)).surface
        middles = whole.points[whole.triangles].mean(axis=1)
        cells, sizes = surfaces.cell_array(whole, "vtkOriginalCellIds"), triangle_areas(whole)
        first = bodies[0].GetNumberOfCells()
        within = [insideout.inside(body, middles) for body in bodies]
        stays = {"A | B": (~within[1], ~within[0]), "A & B": (within[1], within[0]), "A - B": (~within[1], within[0]), "B - A": (within[1], ~within[0])}[expression]
        for body in (0, 1):
            of_body = (cells < first) == (body == 0)
            which = of_body & stays[body]
            yield np.bincount(cells[which] - body * first, sizes[which], bodies[body].GetNumberOfCells())

    def test_for_random_pairs_with_random_tags(self):
        for number in range(24):
            seed = self.SEED + number
            random = np.random.default_rng(seed)
            bodies = [self.body(random), self.body(random)]
            array, names = TAGS[random.integers(len(TAGS))]
            said = [self.with_tags(body, random, array, names) for body in bodies]
            expression = ("A | B", "A & B", "A - B", "B - A")[random.integers(4)]
            with self.subTest(seed=seed, expression=expression, array=array):
                uses = [set(tags) for tags in said]
                expected: dict[str, float] = {}
                for name, tags, others, sizes in zip("AB", said, reversed(uses), self.pieces(bodies, expression)):
                    for tag, size in zip(tags, sizes):
                        taken = tag in others or (tag != name and None in others and tag == ("B" if name == "A" else "A"))
                        key = name if tag is None else f"{name}/{tag}" if taken and tag != name else tag
                        expected[key] = expected.get(key, 0) + size
                expected = {key: size for key, size in expected.items() if size > 1e-12}
                if all(tags[0] is None for tags in said):
                    array, names = "BoundaryTag", "BoundaryTagNames"
                for options in ({}, {"tetrahedra": True}, {"merge_coplanar_pieces": True}):
                    made = insideout.boolean(bodies, expression, **options).surface
                    found = areas(made, array, names)
                    self.assertEqual(set(found), set(expected))
                    for key, size in expected.items():
                        self.assertAlmostEqual(found[key], size, 8)

    def test_for_faces_in_one_plane_too(self):
        for seed in range(self.SEED, self.SEED + 12):
            random = np.random.default_rng(seed)
            bodies = {name: tagged(surfaces.box(random.integers(0, 3, 3) / 2, random.integers(1, 4) / 2), random.choice(list("abc"), 12)) for name in ("one", "other")}
            with self.subTest(seed=seed):
                made = insideout.boolean(bodies)
                cells, of_body = surfaces.cell_array(made.surface, "vtkOriginalCellIds"), made.bodies
                given = {name: called(body, "GroupIds", "GroupNames") for name, body in bodies.items()}
                for tag, body, cell in zip(called(made.surface), of_body.tolist(), cells.tolist()):
                    self.assertEqual(tag.split("/")[-1], given[made.names[body]][cell])
                    self.assertIn(tag.split("/")[0], (made.names[body], tag))


if __name__ == "__main__":
    unittest.main()
