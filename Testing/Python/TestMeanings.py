# SPDX-License-Identifier: GPL-3.0-or-later
"""Public reports of trouble with surfaces are understood as they are meant, by tetrahedra, the surface alone, a set operation and
queries of points. Each input is made here and stands for a report about another program, which is named beside it."""

from __future__ import annotations

import unittest
from dataclasses import dataclass, field
from typing import Callable, Sequence

import insideout
import numpy as np
import surfaces
from command import CommandLine, run_here
from surfaces import BOX_FACETS, cell_array, joined, points_of, polydata, triangles_of
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

FLOOR = (0, 1)
RIGHT, LEFT = (8, 9), (10, 11)
"""Numbers of facets in BOX_FACETS."""


def brick(low, high, without: Sequence[int] = ()) -> vtkPolyData:
    corners = [[(low, high)[up][axis] for up, axis in zip(ups, range(3))] for ups in surfaces.box_points()]
    return polydata(corners, [facet for k, facet in enumerate(BOX_FACETS) if k not in without])


def turned(surface: vtkPolyData, cells=slice(None)) -> vtkPolyData:
    triangles = triangles_of(surface).copy()
    triangles[cells] = triangles[cells][:, ::-1]
    return polydata(points_of(surface), triangles)


def named(surface: vtkPolyData, array: str, *names: tuple[str, int]) -> vtkPolyData:
    """The surface with a cell array of strings: each name for its number of cells."""
    surface.GetCellData().AddArray(surfaces.strings(array, [name for name, count in names for _ in range(count)]))
    return surface


def ball(radius: float) -> vtkPolyData:
    return surfaces.ball(radius, 16, 16)


def tube(radius: float, low: float, high: float, around: int, closed: bool = False) -> vtkPolyData:
    """A tube of outward sides, with a lid at both ends if closed."""
    angles = 2 * np.pi * np.arange(around) / around
    ring = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    points = [(x, y, z) for z in (low, high) for x, y in ring] + [(0, 0, low), (0, 0, high)] * closed
    triangles = []
    for i, j in zip(range(around), np.roll(range(around), -1).tolist()):
        triangles += [(i, j, around + j), (i, around + j, around + i)]
        triangles += [(2 * around, j, i), (2 * around + 1, around + i, around + j)] * closed
    return polydata(points, triangles)


def inside_tube(radius: float, length: float, around: int) -> float:
    return around / 2 * np.sin(2 * np.pi / around) * radius**2 * length


def sides_of(*loops: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    return [side for loop in loops for side in zip(loop, np.roll(loop, -1).tolist())]


COURT = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 2), (1, 2), (1, 3), (3, 3), (3, 1), (1, 1)]
COURT_OUTLINE = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 5, 4]
"""A square of 4 around one of 2, whose outline runs to the inner one and back by the same way. It has an area of 12."""


def house_with_a_court() -> vtkPolyData:
    up = len(COURT)
    points = [(x, y, z) for z in (0, 3) for x, y in COURT]
    walls = [(a, b, b + up, a + up) for a, b in sides_of(COURT_OUTLINE)]
    return polydata(points, [COURT_OUTLINE[::-1], [corner + up for corner in COURT_OUTLINE], *walls])


def moebius_strip() -> vtkPolyData:
    angles = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    points = [((1 + w * np.cos(t / 2)) * np.cos(t), (1 + w * np.cos(t / 2)) * np.sin(t), w * np.sin(t / 2)) for t in angles for w in (-0.4, 0.4)]
    rows = [(2 * i, 2 * i + 1) for i in range(40)] + [(1, 0)]
    return polydata(points, [facet for (a, b), (c, d) in zip(rows, rows[1:]) for facet in ((a, c, d), (a, d, b))])


def shelter() -> vtkPolyData:
    """A box of 5 with walls of a half, open below but for a rim of 1 by 0.2."""
    squares = ((0, 5, 0), (0, 5, 5), (1, 4, 0), (1, 4, 0.2), (0.5, 4.5, 0.2), (0.5, 4.5, 4.5))
    points = [point for a, b, z in squares for point in ((a, a, z), (b, a, z), (b, b, z), (a, b, z))]
    bands = ((0, 4), (8, 0), (12, 8), (16, 12), (20, 16))
    triangles = [(4, 5, 6), (4, 6, 7), (20, 22, 21), (20, 23, 22)]
    for a, b in bands:
        for i, j in sides_of((0, 1, 2, 3)):
            triangles += [(a + i, a + j, b + j), (a + i, b + j, b + i)]
    return polydata(points, triangles)


def mirrored_halves() -> vtkPolyData:
    """A half that is open where its mirror image, with triangles as they were, goes on."""
    half = brick((0, 0, 0), (2, 1, 1), without=LEFT)
    return joined(half, polydata(points_of(half) * (-1, 1, 1), triangles_of(half)))


def both_ways() -> vtkPolyData:
    """A box half of whose facets are there a second time, facing inward."""
    return surfaces.box(facets=[*BOX_FACETS, *(facet[::-1] for facet in BOX_FACETS[2:8])])


def extruded_and_overlapping() -> tuple[vtkPolyData, float]:
    """Twelve blocks on one ground, of whole sizes and places, so that many of their faces are in one plane."""
    blocks = np.random.default_rng(5).integers(1, 6, (12, 5)).tolist()
    heights = np.zeros((12, 12))
    for x, y, across, deep, high in blocks:
        place = heights[x : x + across, y : y + deep]
        np.maximum(place, high, out=place)
    return joined(*(brick((x, y, 0), (x + a, y + d, h)) for x, y, a, d, h in blocks)), float(heights.sum())


@dataclass
class Meaning:
    report: str
    surface: Callable[[], vtkPolyData]
    volume: float
    inside: Sequence[tuple[float, float, float]]
    outside: Sequence[tuple[float, float, float]]
    hole: float = 0
    """The area of the triangles that close holes."""
    statistics: dict[str, float] = field(default_factory=dict)
    """Expected statistics of the solid."""


def volume(surface: vtkPolyData) -> float:
    return insideout.tetrahedralize(surface).volume


MEANINGS = {
    "a courtyard whose outline runs to it and back": Meaning(
        "py4design #16", house_with_a_court, 36, [(0.5, 0.5, 1), (0.5, 2, 1)], [(2, 2, 1)], statistics={"SolidTunnels": 1}
    ),
    "a strip with one side within a ball": Meaning(
        "TetWild #37", lambda: joined(ball(2), moebius_strip()), volume(ball(2)), [(0, 0, 0), (1, 0, 0.05)], [(2.1, 0, 0)]
    ),
    "a hollow ball all of whose normals face inward": Meaning(
        "ITK-SNAP #158", lambda: joined(turned(ball(2)), ball(1)), volume(ball(2)) - volume(ball(1)), [(1.5, 0, 0)], [(0, 0, 0), (3, 0, 0)], statistics={"SolidCavities": 1}
    ),
    "a half and its mirror image": Meaning("PrusaSlicer #6406", mirrored_halves, 4, [(1, 0.5, 0.5), (-1, 0.5, 0.5)], [(3, 0.5, 0.5)]),
    "facets that are there in both orientations": Meaning("libigl #644", both_ways, 1, [(0.5, 0.5, 0.5), (0.5, 0.5, 0.9)], [(0.5, 0.5, 1.1)]),
    "five closed surfaces, each in the next": Meaning(
        "iso2mesh #51", lambda: joined(*map(ball, (1, 1.5, 2, 2.5, 3))), volume(ball(3)), [(0, 0, 0), (2.7, 0, 0)], [(3.1, 0, 0)], statistics={"Regions": 1}
    ),
    "a vessel without ends": Meaning(
        "vedo #790", lambda: tube(1, 0, 6, 24), inside_tube(1, 6, 24), [(0, 0, 0.1), (0, 0, 5.9)], [(0, 0, -0.1), (0, 0, 6.2)], hole=2 * inside_tube(1, 1, 24)
    ),
    "a vessel's wall without ends": Meaning(
        "vmtk #71", lambda: joined(tube(1.2, 0, 6, 24), turned(tube(1, 0, 6, 24))), inside_tube(1, 6, 24) * 0.44, [(1.1, 0, 3)], [(0, 0, 3), (1.3, 0, 3)], hole=0.88 * inside_tube(1, 1, 24), statistics={"SolidTunnels": 1}
    ),
    "a box that is open below, its inner faces turned": Meaning("Cura #2130", lambda: turned(shelter(), slice(28, 44)), 54.4, [(0.2, 2, 2), (0.7, 2, 0.1)], [(2.5, 2.5, 2)]),
    "a building without a floor": Meaning("blosm #292", lambda: brick((0, 0, 0), (20, 20, 3), without=FLOOR), 1200, [(10, 10, 0.1)], [(10, 10, -0.1)], hole=400),
    "two boxes that touch along a part of an edge": Meaning(
        "OpenSCAD #5927", lambda: joined(brick((0, 0, 0), (1, 1, 1)), brick((1, 1, 0.5), (2, 2, 1.5))), 2, [(0.5, 0.5, 0.5), (1.5, 1.5, 1)], [(1.5, 0.5, 0.7)], statistics={"Regions": 2, "SolidComponents": 1}
    ),
    "blocks that overlap on one ground": Meaning("pymeshfix #89", lambda: extruded_and_overlapping()[0], extruded_and_overlapping()[1], [(3.5, 3.5, 0.5)], [(0.5, 0.5, 0.5)]),
}


class Meanings(unittest.TestCase):
    def check(self, what: str, way: str, found: float, expected: float, tolerance: float = 1e-9) -> None:
        self.assertLess(abs(found - expected), tolerance * max(1, abs(expected)), f"{what}, by {way}: {found} instead of {expected}")

    def test_every_way_to_ask_finds_what_is_meant(self):
        for what, meaning in MEANINGS.items():
            with self.subTest(what, report=meaning.report):
                surface = meaning.surface()
                solid = insideout.tetrahedralize(surface)
                self.check(what, "tetrahedra", solid.volume, meaning.volume)
                self.assertEqual(solid.outliers.GetNumberOfCells(), 0)
                for name, value in meaning.statistics.items():
                    self.assertEqual(solid.statistics[name], value, name)
                hole = area_of(solid.boundary, solid.tags["hole"]) if "hole" in solid.tags else 0
                self.check(what, "the holes' caps", hole, meaning.hole)
                for way, made in (
                    ("the surface alone", insideout.tetrahedralize(surface, surface_only=True)),
                    ("a set operation", insideout.boolean([surface])),
                ):
                    self.check(what, way, made.volume, meaning.volume)
                    self.assertTrue(made.is_watertight)
                answers = insideout.inside(surface, [*meaning.inside, *meaning.outside])
                self.assertEqual(answers.tolist(), [True] * len(meaning.inside) + [False] * len(meaning.outside))
                # Random places in the box around the surface.
                low, high = points_of(surface).min(axis=0), points_of(surface).max(axis=0)
                places = np.random.default_rng(1).uniform(low, high, (20000, 3))
                share = insideout.inside(surface, places).mean()
                self.check(what, "random places", share * np.prod(high - low), meaning.volume, 0.05)


def area_of(boundary: vtkPolyData, triangles) -> float:
    corners = points_of(boundary)[triangles_of(boundary)[triangles]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.linalg.norm(normals, axis=1).sum() / 2)


def areas_of_tags(result) -> dict[str, float]:
    return {name: round(area_of(result.boundary, triangles), 9) for name, triangles in result.tags.items()}


class Regions(unittest.TestCase):
    """Tags, bodies and materials of the input keep their names."""

    def volumes(self, result) -> dict[str, float]:
        return {"+".join(region.bodies): round(region.volume, 9) for region in result.regions}

    def test_labels_on_points_are_bodies(self):
        """VTK #18, napari-process-points-and-surfaces #27: the closed surfaces of all labels are one, and labels stand on its points."""
        surface = joined(brick((0, 0, 0), (1, 1, 1)), brick((1, 0, 0), (3, 1, 1)))
        surfaces.add_array(surface.GetPointData(), "Label", np.repeat(np.int32([3, 7]), 8))
        result = insideout.tetrahedralize(surface, body_array="Label")
        self.assertEqual(self.volumes(result), {"3": 1, "7": 2})
        self.assertEqual(areas_of_tags(result), {"3|outside": 5, "3|7": 1, "7|outside": 9})
        self.assertEqual(areas_of_tags(insideout.tetrahedralize(surface, tag_array="Label")), {"3": 5, "7": 9})
        surface.GetPointData().GetArray("Label").SetValue(9, 4)
        with self.assertRaisesRegex(insideout.Error, "point array Label is . and . at corners of cell 12"):
            insideout.tetrahedralize(surface, body_array="Label")
        broken = polydata(points_of(surface), [*triangles_of(surface).tolist(), (0, 1, 10**9)])
        surfaces.add_array(broken.GetPointData(), "Label", np.repeat(np.int32([3, 7]), 8))
        for named in ({"body_array": "Label"}, {"tag_array": "Label"}):
            with self.assertRaisesRegex(insideout.Error, "cell 24 refers to point 1000000000 of 16"):
                insideout.tetrahedralize(broken, **named)

    def test_neighboring_labels_that_overlap_by_half_a_voxel_conform(self):
        """SlicerSegmentMesher #1: each segment has a closed surface of its own."""
        parts = {"a": brick((0, 0, 0), (2.5, 3, 3)), "b": brick((2, 0, 0), (4.5, 3, 3))}
        self.assertEqual(self.volumes(insideout.tetrahedralize(parts)), {"a": 22.5, "b": 18})
        first = insideout.tetrahedralize(parts, priority="b")
        self.assertEqual(self.volumes(first), {"a": 18, "b": 22.5})
        self.assertEqual(areas_of_tags(first)["a|b"], 9)

    def test_tissues_in_one_surface_are_regions(self):
        """iso2mesh #51: nested surfaces that do not meet."""
        radii = {"white": 1, "grey": 1.5, "fluid": 2, "skull": 2.5, "scalp": 3}
        parts = [ball(radius) for radius in radii.values()]
        surface = named(joined(*parts), "Tissue", *((name, part.GetNumberOfCells()) for name, part in zip(radii, parts)))
        volumes = np.diff([0, *map(volume, parts)])
        for found in (insideout.tetrahedralize(surface, body_array="Tissue"), insideout.tetrahedralize(dict(zip(radii, parts)))):
            regions = self.volumes(found)
            self.assertEqual(list(regions), list(radii))
            np.testing.assert_allclose(list(regions.values()), volumes, rtol=1e-9)

    def test_regions_that_overlap_are_combined(self):
        """dolfinx #3332: a source reaches over an inclusion and the matrix around it."""
        parts = {"matrix": brick((0, 0, 0), (4, 4, 4)), "inclusion": brick((1, 1, 1), (3, 3, 3)), "source": brick((2, 0.5, 1.5), (3.5, 3.5, 2.5))}
        found = self.volumes(insideout.tetrahedralize(parts, region_rule="all"))
        self.assertEqual(found, {"matrix": 53.5, "matrix+inclusion": 6, "matrix+inclusion+source": 2, "matrix+source": 2.5})

    def test_a_pin_in_a_hole_of_other_triangles_touches_all_around(self):
        """CadQuery's assembly-mesh-plugin #17: contact faces conform where gaps are narrower than the tolerance asked for."""
        hole = turned(tube(1, 0, 1, 28))
        rim = [(2, 0), (2, 2), (0, 2), (-2, 2), (-2, 0), (-2, -2), (0, -2), (2, -2)]
        points = [*map(tuple, points_of(hole)), *((x, y, z) for z in (0, 1) for x, y in rim)]
        triangles = triangles_of(hole).tolist()
        at = lambda k: round(k * 8 / 28)  # noqa: E731
        for k in range(28):
            n, a, b = (k + 1) % 28, 56 + at(k) % 8, 56 + at(k + 1) % 8
            triangles += [(k, n, a), (28 + k, a + 8, 28 + n)]
            if a != b:
                triangles += [(n, b, a), (28 + n, a + 8, b + 8), (a, b, b + 8), (a, b + 8, a + 8)]
        plate, pin = polydata(points, triangles), tube(1, 0, 1, 40, closed=True)
        touching = insideout.tetrahedralize({"plate": plate, "pin": pin}, merge_tolerance=0.02)
        self.assertGreater(area_of(touching.boundary, touching.tags["plate|pin"]), 0.995 * 28 * 2 * np.sin(np.pi / 28))
        self.assertEqual(touching.statistics["SolidCavities"], 0)
        self.assertEqual(touching.statistics["SolidTunnels"], 0)

    def test_objects_that_touch_are_united(self):
        """vtkbool #80: the third makes the result empty there."""
        row = [brick((k, 0, 0), (k + 1, 1, 1)) for k in range(3)]
        united = insideout.boolean(row)
        self.assertEqual((round(united.volume, 9), united.components, united.is_watertight), (3, 1, True))


class Membranes(unittest.TestCase):
    """Walls without a thickness: they keep the solid whole, and its cells follow them."""

    def walls(self, result, surface, names: str) -> dict[str, float]:
        """The area of the faces within the solid that lie on each kind of wall, by FacetIds."""
        facets = cell_array(result.solid, "FacetIds")
        cells = result.solid.cells
        faces: dict[tuple[int, ...], int] = {}
        for k, corners in enumerate(((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))):
            for face, facet in zip(np.sort(cells[:, corners], axis=1).tolist(), facets[:, k].tolist()):
                if facet >= 0:
                    faces[tuple(face)] = facet
        corners = result.solid.points[np.array(list(faces))]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        kinds = surface.GetCellData().GetAbstractArray(names)
        total: dict[str, float] = {}
        for facet, area in zip(faces.values(), areas.tolist()):
            total[kinds.GetValue(facet)] = total.get(kinds.GetValue(facet), 0) + area
        return {name: round(area, 9) for name, area in total.items()}

    def test_a_baffle_in_a_duct(self):
        """CfdOF #32: of no thickness, from the floor up, with a name for its boundary condition."""
        baffle = polydata([(2, 0, 0), (2, 1, 0), (2, 1, 0.6), (2, 0, 0.6)], [(0, 1, 2), (0, 2, 3)])
        surface = named(joined(brick((0, 0, 0), (4, 1, 1)), baffle), "Patch", ("wall", 8), ("outlet", 2), ("inlet", 2), ("baffle", 2))
        result = insideout.tetrahedralize(surface, tag_array="Patch")
        self.assertAlmostEqual(result.volume, 4)
        self.assertEqual(areas_of_tags(result), {"wall": 16, "outlet": 1, "inlet": 1, "baffle": 0})
        self.assertEqual(self.walls(result, surface, "Patch"), {"wall": 16, "outlet": 1, "inlet": 1, "baffle": 0.6})

    def test_faults_that_cross_in_a_block(self):
        """pyvista/tetgen #95: each face of the mesh has to tell which surface it is of."""
        first = polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
        second = polydata([(0, 0.5, -0.5), (1, 0.5, -0.5), (1, 0.5, 0.5), (0, 0.5, 0.5)], [(0, 1, 2), (0, 2, 3)])
        surface = named(joined(brick((0, 0, -1), (1, 1, 1)), first, second), "Marker", ("block", 12), ("first", 2), ("second", 2))
        result = insideout.tetrahedralize(surface)
        self.assertAlmostEqual(result.volume, 2)
        self.assertEqual(self.walls(result, surface, "Marker"), {"block": 10, "first": 1, "second": 1})


class Grounds(unittest.TestCase):
    def test_a_building_without_a_floor_on_terrain_is_solid(self):
        """3dfier #42: the terrain below it would lower w in it by a half; it seals off no space, and does not count."""
        house, block = brick((0, 0, 0), (2, 2, 1), without=FLOOR), brick((20, 0, 0), (60, 40, 40))
        ground = polydata([(-2, -2, 0), (4, -2, 0), (4, 4, 0), (-2, 4, 0)], [(0, 1, 2), (0, 2, 3)])
        result = insideout.tetrahedralize(joined(house, ground, block))
        self.assertAlmostEqual(result.volume, 64004)
        self.assertTrue(any(warning.startswith("1 sheet outside the solid") for warning in result.warnings), result.warnings)


class Planes(unittest.TestCase):
    def test_an_outline_that_runs_to_its_hole_and_back(self):
        """OpenSaMD #51: the keyhole by which radiotherapy's contours have holes."""
        points = vtkPoints()
        for x, y in COURT:
            points.InsertNextPoint(x, y, 0)
        cells = vtkCellArray()
        cells.InsertNextCell(len(COURT_OUTLINE) + 1, [*COURT_OUTLINE, COURT_OUTLINE[0]])
        outline = vtkPolyData()
        outline.SetPoints(points)
        outline.SetLines(cells)
        result = insideout.tetrahedralize(outline)
        self.assertAlmostEqual(result.volume, 12)
        self.assertEqual(result.statistics["Regions"], 1)
        self.assertEqual(insideout.inside(outline, [(2, 2, 0), (0.5, 0.5, 0), (0.5, 2.1, 0)]).tolist(), [False, True, True])

    def test_contours_within_one_another_that_run_the_same_way(self):
        """platipy #244 and dcmrtstruct2nii #37: in DICOM the way that a contour runs does not matter."""
        squares = [((low, low), (high, low), (high, high), (low, high)) for low, high in ((0, 6), (1, 5))]
        contours = polydata([(x, y, 0) for square in squares for x, y in square], [])
        contours.SetLines(polydata([], [(0, 1, 2, 3, 0), (4, 5, 6, 7, 4)]).GetPolys())
        found = insideout.check(contours)
        self.assertEqual(found.verdict, "bounds an area of 36 in a plane: 36 by the winding number, 20 by even-odd, 36 as given")
        contours.SetLines(polydata([], [(0, 1, 2, 3, 0), (4, 7, 6, 5, 4)]).GetPolys())
        self.assertEqual(insideout.check(contours).verdict, "bounds an area of 20 in a plane")


class Images(unittest.TestCase):
    def test_the_mask_of_an_image_with_axes_of_its_own(self):
        """PyVista #5066 and #8662: a direction matrix, an origin, and an extent that does not begin at 0."""
        low, high = np.array([2, 1, 0.5]), np.array([5, 4, 3.5])
        for direction in ((-1, 0, 0, 0, -1, 0, 0, 0, 1), (1, 0, 0, 0, 1, 0, 0, 0, -1), (0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1), (0, 0, 1, 1, 0, 0, 0, 1, 0)):
            image = vtkImageData()
            image.SetExtent(3, 22, -4, 15, 2, 21)
            image.SetSpacing(0.5, 0.4, 0.3)
            image.SetDirectionMatrix(*direction)
            middle = [0.0, 0.0, 0.0]
            image.TransformContinuousIndexToPhysicalPoint(12.55, 5.55, 11.55, middle)
            image.SetOrigin(*((low + high) / 2 - middle))
            places = np.array([image.GetPoint(k) for k in range(image.GetNumberOfPoints())])
            probe = insideout.vtkProbeWindingNumber()
            probe.SetInputData(image)
            probe.SetSurfaceData(brick(low, high))
            probe.Update()
            mask = surfaces.point_array(probe.GetOutput(), "Inside") != 0
            self.assertGreater(mask.sum(), 200)
            np.testing.assert_array_equal(mask, ((places > low) & (places < high)).all(axis=1))


class Files(CommandLine):
    def test_solids_of_an_stl_file_are_physical_surfaces(self):
        """fTetWild #62: each stands for a boundary condition."""
        corners = points_of(surfaces.box())
        solids = {"red": BOX_FACETS[2:4], "grey": BOX_FACETS[4:], "blue": BOX_FACETS[:2]}
        text = ""
        for name, facets in solids.items():
            text += f"solid {name}\n"
            for facet in facets:
                vertices = "".join(f"vertex {x} {y} {z}\n" for x, y, z in corners[list(facet)])
                text += f"facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n"
            text += f"endsolid {name}\n"
        done = run_here("mesh", self.file("cube.stl", text), self.path("cube.msh"), "--quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        reader = insideout.vtkSolidReader()
        reader.SetFileName(self.path("cube.msh"))
        insideout.pipeline.run(reader)
        boundary = reader.GetOutputDataObject(1)
        names = insideout.pipeline.strings_of(boundary.GetFieldData().GetAbstractArray("BoundaryTagNames"))
        tags = cell_array(boundary, "BoundaryTag")
        areas = {name: area_of(boundary, np.flatnonzero(tags == tag)) for tag, name in enumerate(names)}
        self.assertEqual(areas, {"red": 1, "grey": 4, "blue": 1})


if __name__ == "__main__":
    unittest.main()
