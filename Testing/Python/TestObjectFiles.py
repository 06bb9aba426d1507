# SPDX-License-Identifier: GPL-3.0-or-later
"""GLB and 3MF: what is written is read back and others read it, files of others are read, and bad ones are named."""

import gzip
import io
import json
import os
import shutil
import struct
import subprocess
import unittest
import unittest.mock
import zipfile
from xml.etree import ElementTree

import insideout
import numpy as np
import surfaces
from command import CommandLine, run_here
from insideout.files import is_of_others, read_surface, write_surface
from insideout.pipeline import strings_of
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOGeometry import vtkGLTFReader

POINTS = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
TRIANGLES = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
"""A tetrahedron."""

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
RELATIONSHIPS = (
    '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="a" '
    'Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
)


def grouped(surface: vtkPolyData, ids, names, array="GroupIds") -> vtkPolyData:
    surfaces.add_array(surface.GetCellData(), array, np.array(ids, np.int32))
    strings = vtkStringArray()
    strings.SetName({"GroupIds": "GroupNames", "BoundaryTag": "BoundaryTagNames"}[array])
    for name in names:
        strings.InsertNextValue(name)
    surface.GetFieldData().AddArray(strings)
    return surface


def groups_of(surface: vtkPolyData, kind="Group") -> list:
    """The name of each triangle."""
    names = strings_of(surface.GetFieldData().GetAbstractArray(kind + "Names"))
    return [names[k] for k in surfaces.cell_array(surface, kind + "Ids")] if names else []


def corners_of(surface: vtkPolyData) -> list:
    return surfaces.points_of(surface)[surfaces.triangles_of(surface)].tolist()


class Gltf:
    """A GLB file by the specification, piece by piece."""

    def __init__(self):
        self.content = {
            "asset": {"version": "2.0"},
            "accessors": [],
            "bufferViews": [],
            "buffers": [{}],
            "meshes": [],
            "nodes": [],
        }
        self.binary = b""  # whose length is that of its chunk

    def add_numbers(self, content: bytes, count: int, kind: str, component: int, **said) -> int:
        stride = said.pop("byteStride", None)
        view = {
            "buffer": 0,
            "byteOffset": len(self.binary),
            "byteLength": len(content),
            **({"byteStride": stride} if stride else {}),
        }
        self.binary += content + b"\0" * (-len(content) % 4)
        self.content["bufferViews"].append(view)
        accessor = {
            "bufferView": len(self.content["bufferViews"]) - 1,
            "componentType": component,
            "type": kind,
            "count": count,
            **said,
        }
        self.content["accessors"].append(accessor)
        return len(self.content["accessors"]) - 1

    def add_points(self, points=POINTS) -> int:
        return self.add_numbers(np.asarray(points, "<f4").tobytes(), len(points), "VEC3", 5126)

    def add_ids(self, ids=TRIANGLES, component=5123) -> int:
        kind = {5121: "u1", 5123: "<u2", 5125: "<u4"}[component]
        return self.add_numbers(np.asarray(ids, kind).tobytes(), np.size(ids), "SCALAR", component)

    def add_mesh(self, *primitives: dict, **said) -> int:
        self.content["meshes"].append({"primitives": list(primitives), **said})
        return len(self.content["meshes"]) - 1

    def add_node(self, **said) -> int:
        self.content["nodes"].append(said)
        return len(self.content["nodes"]) - 1

    def bytes(self) -> bytes:
        text = json.dumps(self.content).encode()
        text += b" " * (-len(text) % 4)
        chunks = (
            struct.pack("<I4s", len(text), b"JSON")
            + text
            + struct.pack("<I4s", len(self.binary), b"BIN\0")
            + self.binary
        )
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def tetrahedron() -> Gltf:
    gltf = Gltf()
    gltf.add_mesh({"attributes": {"POSITION": gltf.add_points()}, "indices": gltf.add_ids()})
    gltf.add_node(mesh=0)
    return gltf


def mesh_of(points=POINTS, triangles=TRIANGLES, said="") -> str:
    vertices = "".join('<vertex x="%r" y="%r" z="%r"/>' % tuple(map(float, point)) for point in points)
    corners = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}" {said}/>' for a, b, c in triangles)
    return f"<mesh><vertices>{vertices}</vertices><triangles>{corners}</triangles></mesh>"


def model_of(resources: str, build: str, said: str = "") -> str:
    content = f"<resources>{resources}</resources><build>{build}</build>"
    return f'<model xmlns="{CORE}" xmlns:p="{PRODUCTION}" {said}>{content}</model>'


def package_of(model: str, compression=zipfile.ZIP_DEFLATED, **parts: str) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", compression) as archive:
        archive.writestr("_rels/.rels", RELATIONSHIPS)
        archive.writestr("3D/3dmodel.model", model)
        for name, content in parts.items():
            archive.writestr(f"3D/{name}.model", content)
    return file.getvalue()


def small_3mf() -> bytes:
    return package_of(model_of(f'<object id="1">{mesh_of()}</object>', '<item objectid="1"/>'))


class ObjectFiles(CommandLine):
    def read(self, name: str, content: bytes) -> tuple:
        return read_surface(self.file(name, content))

    def check_bad(self, name: str, content: bytes, *expected: str) -> None:
        with self.subTest(expected=expected, length=len(content)):
            path = self.file(name, content)
            with self.assertRaises(insideout.Error) as caught:
                read_surface(path)
            self.assertTrue(str(caught.exception).startswith(path + ": "), caught.exception)
            for words in expected:
                self.assertIn(words, str(caught.exception))


class RoundTrips(ObjectFiles):
    def test_3mf_has_all_digits(self):
        surface = surfaces.box(low=(1 / 3, 1e-17, -1e5 / 7), size=np.pi)
        write_surface(surface, self.path("box.3mf"))
        again, warnings = read_surface(self.path("box.3mf"))
        self.assertEqual(warnings, [])
        self.assertEqual(surfaces.points_of(again).tobytes(), surfaces.points_of(surface).tobytes())
        self.assertEqual(surfaces.triangles_of(again).tolist(), surfaces.triangles_of(surface).tolist())

    def test_glb_has_floats(self):
        surface = surfaces.box(low=(1 / 3, 1e-17, -1e5 / 7), size=np.pi)
        write_surface(surface, self.path("box.glb"))
        again, warnings = read_surface(self.path("box.glb"))
        self.assertEqual(warnings, [])
        self.assertEqual(
            surfaces.points_of(again).tolist(), surfaces.points_of(surface).astype(np.float32).astype(float).tolist()
        )
        self.assertEqual(surfaces.triangles_of(again).tolist(), surfaces.triangles_of(surface).tolist())

    def test_points_brought_near_by_rounding_to_floats_are_told(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1e-7, 0, 0), (-1, 0, 0), (0, -1, 0)]
        surface = surfaces.polydata(corners, [(0, 1, 2), (3, 4, 5)])
        with self.assertWarnsRegex(
            UserWarning, "near.glb: rounded to the floats that the format has: 2 points are nearer"
        ):
            insideout.write(surface, self.path("near.glb"))

    def test_a_repaired_glb_passes_its_own_check(self):
        source = os.path.join(
            os.path.dirname(os.path.abspath(__file__)), "..", "Data", "Corpus", "cylinders-tessellated-twice.off"
        )
        result = insideout.tetrahedralize(source)
        self.assertEqual(write_surface(result.boundary, self.path("fixed.glb")), [])
        found = insideout.check(self.path("fixed.glb")).statistics
        for count in ("OpenEdges", "DegenerateFacets", "DuplicateFacets", "IntersectingPairs", "NearPoints"):
            self.assertEqual(found[count], 0, count)

    def test_groups_of_a_glb_share_their_points(self):
        names = ["wall", 'in"let <é>', "wall"]
        surface = grouped(surfaces.box(), [0] * 4 + [1] * 6 + [2] * 2, names, "BoundaryTag")
        write_surface(surface, self.path("box.glb"))
        again, _ = read_surface(self.path("box.glb"))
        self.assertEqual(again.GetNumberOfPoints(), 8)
        self.assertEqual(corners_of(again), corners_of(surface))
        self.assertEqual(groups_of(again), ["wall"] * 4 + ['in"let <é>'] * 6 + ["wall"] * 2)

    def test_the_triangles_of_a_rounded_glb_keep_their_groups(self):
        points = [(0, 0, 0), (1, 0, 0), (1 + 1e-12, 0, 0), (0, 1, 0), (0, 0, 1)]
        surface = surfaces.polydata(points, [(0, 3, 1), (1, 3, 2), (0, 1, 4)])  # the second loses its area
        write_surface(grouped(surface, [0, 1, 2], ["a", "b", "c"]), self.path("thin.glb"))
        self.assertEqual(groups_of(read_surface(self.path("thin.glb"))[0]), ["a", "c"])

    def test_bodies_that_are_apart_are_objects_of_a_3mf(self):
        points = surfaces.box_points() + surfaces.box_points((3, 0, 0))
        boxes = surfaces.polydata(
            points, [*surfaces.BOX_FACETS, *(tuple(k + 8 for k in facet) for facet in surfaces.BOX_FACETS)]
        )
        write_surface(grouped(boxes, [0] * 12 + [1] * 12, ["bone", "a < b & c"]), self.path("boxes.3mf"))
        again, _ = read_surface(self.path("boxes.3mf"))
        self.assertEqual(corners_of(again), corners_of(boxes))
        self.assertEqual(groups_of(again), ["bone"] * 12 + ["a < b & c"] * 12)
        objects = self.model("boxes.3mf").findall(f".//{{{CORE}}}object")
        self.assertEqual([one.get("type") for one in objects], ["model", "model"])

    def test_groups_that_touch_are_materials_of_one_closed_object(self):
        write_surface(grouped(surfaces.box(), [1] * 4 + [0] * 8, ["wall", "inlet"]), self.path("box.3mf"))
        again, warnings = read_surface(self.path("box.3mf"))
        self.assertEqual((groups_of(again), warnings), ([], []))
        self.assertEqual(groups_of(again, "Material"), ["inlet"] * 4 + ["wall"] * 8)
        self.assertEqual(surfaces.triangles_of(again).tolist(), surfaces.triangles_of(surfaces.box()).tolist())
        self.assertEqual(len(self.model("box.3mf").findall(f".//{{{CORE}}}object")), 1)
        result = insideout.tetrahedralize(self.path("box.3mf"))
        self.assertEqual(sorted(result.tags), ["inlet", "wall"])

    def test_an_open_surface_is_no_model_to_print(self):
        write_surface(surfaces.open_box(), self.path("open.3mf"))
        self.assertEqual(self.model("open.3mf").find(f".//{{{CORE}}}object").get("type"), "surface")

    def test_strips_become_triangles(self):
        strips = vtkPolyData()
        strips.SetPoints(surfaces.box().GetPoints())
        strips.SetStrips(surfaces.polydata(surfaces.box_points(), [(0, 1, 3, 2)]).GetPolys())
        for name in ("strip.glb", "strip.3mf"):
            write_surface(strips, self.path(name))
            self.assertEqual(read_surface(self.path(name))[0].GetNumberOfCells(), 2)

    def test_surfaces_beyond_the_format_are_named(self):
        quad = surfaces.polydata(surfaces.box_points(), [(0, 1, 2), (0, 3, 2, 1)])
        far = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1e39, 0)], [(0, 1, 2)])
        endless = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, np.nan, 0)], [(0, 1, 2)])
        wild = surfaces.polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 7)])
        for surface, name, words in (
            (quad, "a.glb", "polygon 1 has 4 corners, but GLB holds triangles only"),
            (quad, "a.3mf", "polygon 1 has 4 corners, but 3MF holds triangles only"),
            (far, "a.glb", "point 2 is beyond the floats that GLB holds"),
            (endless, "a.glb", "point 2 is not finite, which GLB cannot say"),
            (endless, "a.3mf", "point 2 is not finite, which 3MF cannot say"),
            (wild, "a.glb", "cell 0 refers to point 7 of 3"),
            (wild, "a.3mf", "cell 0 refers to point 7 of 3"),
        ):
            with self.subTest(words), self.assertRaises(insideout.Error) as caught:
                write_surface(surface, self.path(name))
            self.assertEqual(str(caught.exception), f"{self.path(name)}: {words}")
            self.assertFalse(os.path.exists(self.path(name)))

    def test_3mf_refuses_a_corner_twice_and_says_so(self):
        surface = surfaces.polydata(POINTS, [*TRIANGLES.tolist(), (0, 1, 1)])
        warnings = write_surface(surface, self.path("twice.3mf"))
        self.assertIn("1 triangles with a corner twice are left out", warnings[0])
        self.assertEqual(read_surface(self.path("twice.3mf"))[0].GetNumberOfCells(), 4)

    def test_an_empty_surface_is_an_empty_file(self):
        for name in ("empty.glb", "empty.3mf"):
            write_surface(vtkPolyData(), self.path(name))
            with self.assertRaisesRegex(insideout.Error, f"{name}: the surface is empty"):
                read_surface(self.path(name))

    def model(self, name: str) -> ElementTree.Element:
        with zipfile.ZipFile(self.path(name)) as archive:
            return ElementTree.fromstring(archive.read("3D/3dmodel.model"))


class OtherPrograms(ObjectFiles):
    def test_vtk_reads_a_glb(self):
        write_surface(grouped(surfaces.box(), [0] * 4 + [1] * 8, ["wall", "inlet"]), self.path("box.glb"))
        reader = vtkGLTFReader()
        reader.SetFileName(self.path("box.glb"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), 12)

    @unittest.skipIf(shutil.which("assimp") is None, "assimp is not installed")
    def test_assimp_reads_and_writes_both(self):
        surface = grouped(surfaces.box(), [0] * 4 + [1] * 8, ["wall", "inlet"])
        for ours, theirs, kind in (("ours.glb", "theirs.glb", "glb2"), ("ours.3mf", "theirs.3mf", "3mf")):
            with self.subTest(kind):
                write_surface(surface, self.path(ours))
                done = subprocess.run(
                    ["assimp", "export", ours, theirs, "-f" + kind], cwd=self.folder, capture_output=True, check=False
                )
                self.assertEqual(done.returncode, 0, done.stdout)
                again, _ = read_surface(self.path(theirs))
                self.assertEqual(again.GetNumberOfCells(), 12)
                self.assertAlmostEqual(surfaces.enclosed_volume(again), 1)
                self.assertTrue(is_of_others(self.path(theirs)))


class GlbOfOthers(ObjectFiles):
    def test_ids_of_each_type(self):
        for component in (5121, 5123, 5125):
            gltf = Gltf()
            gltf.add_mesh({"attributes": {"POSITION": gltf.add_points()}, "indices": gltf.add_ids(component=component)})
            gltf.add_node(mesh=0)
            surface, warnings = self.read("a.glb", gltf.bytes())
            self.assertEqual((surfaces.triangles_of(surface).tolist(), warnings), (TRIANGLES.tolist(), []))
            self.assertEqual(surfaces.points_of(surface).tolist(), POINTS.tolist())
            self.assertEqual(groups_of(surface), [])

    def test_points_between_other_numbers(self):
        rows = np.hstack([POINTS, np.full((4, 2), 9.0)]).astype("<f4").tobytes()
        gltf = Gltf()
        points = gltf.add_numbers(b"\7" * 8 + rows, 4, "VEC3", 5126, byteStride=20, byteOffset=8)
        gltf.add_mesh({"attributes": {"POSITION": points}, "indices": gltf.add_ids()})
        gltf.add_node(mesh=0)
        self.assertEqual(surfaces.points_of(self.read("a.glb", gltf.bytes())[0]).tolist(), POINTS.tolist())

    def test_points_in_small_integers(self):
        gltf = Gltf()
        gltf.content["extensionsRequired"] = ["KHR_mesh_quantization"]
        fractions = np.hstack([POINTS * 127, np.zeros((4, 1))]).astype("<i1").tobytes()
        points = gltf.add_numbers(fractions, 4, "VEC3", 5120, normalized=True, byteStride=4)
        gltf.add_mesh({"attributes": {"POSITION": points}, "indices": gltf.add_ids()})
        gltf.add_node(mesh=0, scale=[2, 2, 2])
        self.assertEqual(surfaces.points_of(self.read("a.glb", gltf.bytes())[0]).tolist(), (2 * POINTS).tolist())

    def test_nodes_place_their_meshes(self):
        gltf = Gltf()
        mesh = gltf.add_mesh({"attributes": {"POSITION": gltf.add_points()}, "indices": gltf.add_ids()}, name="wedge")
        quarter = np.sqrt(0.5)
        first = gltf.add_node(
            mesh=mesh, name="turned", rotation=[0, 0, quarter, quarter], scale=[1, 2, 3], translation=[10, 0, 0]
        )
        matrix = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]  # by columns; a mirror
        second = gltf.add_node(mesh=mesh, matrix=matrix)
        parent = gltf.add_node(children=[first, second], translation=[0, 0, 100])
        gltf.add_node(mesh=mesh, name="in no scene")
        gltf.content["scenes"] = [{"nodes": [parent]}]
        surface, _ = self.read("a.glb", gltf.bytes())
        turned = [(-2 * y + 10, x, 3 * z + 100) for x, y, z in POINTS]
        mirrored = [(5 - x, 6 + y, 107 + z) for x, y, z in POINTS]
        np.testing.assert_allclose(surfaces.points_of(surface), turned + mirrored, atol=1e-6)
        self.assertEqual(groups_of(surface), ["turned"] * 4 + ["wedge"] * 4)
        self.assertAlmostEqual(
            surfaces.enclosed_volume(surface), (6 + 1) / 6, 5
        )  # the mirror's triangles face outward, too

    def test_primitives_share_points_and_tell_materials(self):
        gltf = Gltf()
        points = gltf.add_points()
        gltf.content["materials"] = [{"name": "steel"}, {}]
        halves = [
            {"attributes": {"POSITION": points}, "indices": gltf.add_ids(rows)}
            for rows in (TRIANGLES[:2], TRIANGLES[2:3], TRIANGLES[3:])
        ]
        halves[0]["material"], halves[1]["material"] = 1, 0
        gltf.add_mesh(*halves)
        gltf.add_node(mesh=0)
        surface, _ = self.read("a.glb", gltf.bytes())
        self.assertEqual(surfaces.triangles_of(surface).tolist(), TRIANGLES.tolist())
        self.assertEqual(surface.GetNumberOfPoints(), 4)
        self.assertEqual(groups_of(surface, "Material"), ["material 1", "material 1", "steel", "default"])

    def test_strips_fans_and_points_without_ids(self):
        gltf = Gltf()
        square = gltf.add_points([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])
        gltf.add_mesh({"attributes": {"POSITION": square}, "mode": 5})
        gltf.add_mesh({"attributes": {"POSITION": square}, "indices": gltf.add_ids([0, 1, 3, 2]), "mode": 6})
        gltf.add_mesh({"attributes": {"POSITION": gltf.add_points(POINTS[TRIANGLES].reshape(-1, 3))}})
        for mesh in range(3):
            gltf.add_node(mesh=mesh)
        surface, _ = self.read("a.glb", gltf.bytes())
        strip, fan = [[0, 1, 2], [1, 3, 2]], [[0, 1, 3], [0, 3, 2]]
        self.assertEqual(
            surfaces.triangles_of(surface).tolist(), [*strip, *fan, *np.arange(4, 16).reshape(-1, 3).tolist()]
        )

    def test_skipped_content_is_counted(self):
        gltf = tetrahedron()
        points = {"attributes": {"POSITION": 0}}
        gltf.content["meshes"][0]["primitives"] += [{**points, "mode": 0}, {**points, "mode": 1}]
        gltf.content["meshes"][0]["weights"] = [0]
        gltf.content["nodes"][0]["skin"] = 0
        gltf.content["textures"] = [{}, {}]
        _, warnings = self.read("a.glb", gltf.bytes())
        self.assertEqual(
            warnings, ["a.glb: skipped: 1 skins, 1 morphs, 2 primitives of points or lines, 2 textures"]
        )

    def test_extensions_that_a_shape_needs_are_named(self):
        gltf = tetrahedron()
        gltf.content["extensionsRequired"] = ["KHR_materials_unlit", "KHR_draco_mesh_compression"]
        self.check_bad("a.glb", gltf.bytes(), "needs the extension KHR_draco_mesh_compression")

    def test_truncated_at_each_byte(self):
        content = tetrahedron().bytes()
        for length in range(len(content)):
            self.check_bad("a.glb", content[:length])

    def test_each_word_of_the_json_missing_or_wrong(self):
        def places(value, path=()):
            if path:
                yield path
            for key, inner in (
                value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
            ):
                yield from places(inner, (*path, key))

        gltf = tetrahedron()
        gltf.content["scenes"], gltf.content["scene"] = [{"nodes": [0]}], 0
        gltf.content["nodes"][0]["translation"] = [1, 2, 3]
        original = json.dumps(gltf.content)
        refused = 0
        for path in places(gltf.content):
            for wrong in (-1, 7, 1e300, 2**70, "x", None, [], {}, [[]], True):
                gltf.content = json.loads(original)
                holder = gltf.content
                for key in path[:-1]:
                    holder = holder[key]
                holder[path[-1]] = wrong
                file = self.file("a.glb", gltf.bytes())
                try:
                    read_surface(file)
                except insideout.Error as error:
                    self.assertTrue(str(error).startswith(file), error)
                    refused += 1
        self.assertGreater(refused, 200)

    def test_damage_is_named(self):
        def changed(path, value):
            gltf = tetrahedron()
            gltf.content["scenes"] = [{"nodes": [0]}]
            holder = gltf.content
            for key in path[:-1]:
                holder = holder[key]
            holder[path[-1]] = value
            return gltf.bytes()

        for path, value, words in (
            (("nodes", 0, "mesh"), 3, "it refers to number 3 of 1 meshes"),
            (("nodes", 0, "children"), [0], "node 0 has two parents"),
            (("nodes", 0, "translation"), [0, 0], "node 0 is placed by [0, 0]"),
            (("accessors", 0, "count"), 5, "the accessor 0 reaches beyond its buffer view"),
            (("accessors", 0, "sparse"), {}, "has a sparse accessor (0)"),
            (("accessors", 1, "count"), 11, "a primitive of triangles has 11 corners"),
            (("bufferViews", 1, "byteLength"), 2400, "the buffer view 1 reaches beyond the 72 bytes of numbers"),
            (("bufferViews", 1, "byteOffset"), 0, "the accessor 1 has ids of points outside 0 to 3"),
            (("buffers", 0, "uri"), "a.bin", "has numbers outside of its own chunk"),
            (("extensionsRequired",), [1], "its JSON is damaged"),
        ):
            self.check_bad("a.glb", changed(path, value), words)
        content = tetrahedron().bytes()
        self.check_bad("a.glb", content.replace(b'"asset"', b'"asset '), "its JSON is damaged")
        self.check_bad("a.glb", content[:4] + struct.pack("<I", 1) + content[8:], "is of version 1 of glTF")
        deep = b"[" * 200000
        chunk = struct.pack("<I4s", len(deep), b"JSON") + deep
        self.check_bad("a.glb", struct.pack("<4sII", b"glTF", 2, 12 + len(chunk)) + chunk, "nested too deeply")
        self.check_bad("a.glb", b"Dear reader, this is a letter", "is no GLB file")

    def test_meshes_placed_without_end_are_refused(self):
        gltf = tetrahedron()
        for _ in range(200):
            gltf.add_node(mesh=0, translation=[1, 0, 0])
        with unittest.mock.patch("insideout.files.SHARE_OF_MACHINE", 1e-6):
            self.check_bad("a.glb", gltf.bytes(), "too many for this machine")


class ThreeMfOfOthers(ObjectFiles):
    def test_components_and_items_place_objects(self):
        resources = (
            f'<object id="1" name="wedge">{mesh_of()}</object>'
            '<object id="2" name="pair"><components><component objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/>'
            '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 5 6 7"/></components></object>'
            f'<object id="3" name="unused">{mesh_of()}</object><object id="4">{mesh_of()}</object>'
        )
        build = '<item objectid="2" transform="2 0 0 0 2 0 0 0 2 0 0 100"/><item objectid="4"/>'
        surface, warnings = self.read("a.3mf", package_of(model_of(resources, build)))
        turned = [(2 * (10 - y), 2 * x, 2 * z + 100) for x, y, z in POINTS]
        mirrored = [(2 * (5 - x), 2 * (6 + y), 2 * (7 + z) + 100) for x, y, z in POINTS]
        np.testing.assert_allclose(surfaces.points_of(surface), [*turned, *mirrored, *POINTS], atol=1e-12)
        self.assertEqual(groups_of(surface), ["wedge"] * 8 + [""] * 4)
        self.assertAlmostEqual(surfaces.enclosed_volume(surface), (8 + 8 + 1) / 6)
        self.assertEqual(warnings, [])

    def test_objects_in_other_parts_of_the_archive(self):
        outer = '<object id="9"><components><component objectid="1" p:path="/3D/inner.model"/></components></object>'
        said = 'requiredextensions="p" unit="inch"'
        content = package_of(
            model_of(outer, '<item objectid="9"/>', said), inner=model_of(f'<object id="1">{mesh_of()}</object>', "")
        )
        surface, warnings = self.read("a.3mf", content)
        self.assertEqual(surfaces.points_of(surface).tolist(), POINTS.tolist())
        self.assertEqual(warnings, ["a.3mf: its unit is 'inch'; coordinates are taken as they are"])

    def test_stored_without_compression_and_zipped_again(self):
        content = package_of(
            model_of(f'<object id="1">{mesh_of()}</object>', '<item objectid="1"/>'), zipfile.ZIP_STORED
        )
        self.assertEqual(self.read("a.3mf", content)[0].GetNumberOfCells(), 4)
        self.assertEqual(self.read("a.3mf.gz", gzip.compress(content))[0].GetNumberOfCells(), 4)

    def test_materials_have_names_and_colors_have_none(self):
        bases = "".join(f'<base name="{name}" displaycolor="#FF0000"/>' for name in ("steel", "glass"))
        bases = f'<basematerials id="5">{bases}</basematerials>'
        resources = (
            bases
            + f'<object id="1" pid="5" pindex="1">{mesh_of()}</object>'
            + "".join(
                f'<object id="{k}">{mesh_of(said=said)}</object>'
                for k, said in ((2, 'pid="5" p1="0"'), (3, 'pid="77" p1="0"'))
            )
        )
        build = "".join(f'<item objectid="{k}"/>' for k in (1, 2, 3))
        surface, _ = self.read("a.3mf", package_of(model_of(resources, build)))
        self.assertEqual(groups_of(surface, "Material"), ["glass"] * 4 + ["steel"] * 4 + ["default"] * 4)

    def test_truncated_at_each_byte(self):
        content = small_3mf()
        for length in range(len(content)):
            self.check_bad("a.3mf", content[:length])

    def test_each_byte_changed(self):
        content = small_3mf()
        refused = 0
        for at in range(len(content)):
            path = self.file("a.3mf", content[:at] + bytes([content[at] ^ 0x41]) + content[at + 1 :])
            try:
                read_surface(path)
            except insideout.Error as error:
                self.assertTrue(str(error).startswith(path), error)
                refused += 1
        self.assertGreater(refused, len(content) // 2)

    def test_damage_is_named(self):
        good = f'<object id="1">{mesh_of()}</object>'
        item = '<item objectid="1"/>'
        looped = '<object id="1"><components><component objectid="1"/></components></object>'
        for model, words in (
            (model_of(good, '<item objectid="2"/>'), "3D/3dmodel.model has no object '2'"),
            (model_of(looped, item), "the object '1' is a component of itself"),
            (model_of(good.replace('v3="1"', 'v3="4"'), item), "ids of vertices outside 0 to 3"),
            (model_of(good.replace('v3="1"', 'v3="-1"'), item), "ids of vertices outside 0 to 3"),
            (model_of(good.replace('v3="1"', 'v3="one"'), item), "3D/3dmodel.model, line 1: invalid literal for int"),
            (model_of(good.replace('v3="1"', ""), item), "3D/3dmodel.model, line 1: 'v3' is missing"),
            (model_of(good, '<item objectid="1" transform="1 0 0"/>'), "the transform '1 0 0' is not of 12 numbers"),
            (model_of(good, item, 'xmlns:x="http://x.org" requiredextensions="x"'), "needs the extension http://x.org"),
            (model_of(good, '<item objectid="1" p:path="/3D/none.model"/>'), "its archive has no 3D/none.model"),
            (model_of(good, item)[:-9], "3D/3dmodel.model, "),
        ):
            self.check_bad("a.3mf", package_of(model), words)
        file = io.BytesIO()
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("letter.txt", "Dear reader")
        self.check_bad("a.3mf", file.getvalue(), "is not a 3MF file: its archive has no _rels/.rels")
        self.check_bad("a.3mf", b"Dear reader, this is a letter", "is no 3MF file")

    def test_entities_that_grow_are_refused(self):
        laughs = '<!DOCTYPE x [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>' + model_of("", "")
        self.check_bad("a.3mf", package_of(laughs), "a document type declaration, which 3MF forbids")

    def test_more_than_the_machine_holds_is_refused(self):
        bomb = model_of(" " * 4_000_000, "")
        nested = f'<object id="1">{mesh_of()}</object>'
        for k in range(2, 40):
            pair = f'<component objectid="{k - 1}"/>' * 2
            nested += f'<object id="{k}"><components>{pair}</components></object>'
        with unittest.mock.patch("insideout.files.SHARE_OF_MACHINE", 1e-4):
            self.check_bad("a.3mf", package_of(bomb), "holds more than", "too many for this machine")
            self.check_bad("a.3mf", package_of(model_of(nested, '<item objectid="39"/>')), "too many for this machine")


class Commands(ObjectFiles):
    def test_content_counts_and_not_the_name(self):
        for name, content, kind in (("a.ply", tetrahedron().bytes(), "GLB"), ("b.stl", small_3mf(), "3MF")):
            surface, warnings = self.read(name, content)
            self.assertEqual(surface.GetNumberOfCells(), 4)
            self.assertEqual(warnings, [f"{name}: holds {kind}, not what its name says, and was read as such"])
        write_surface(surfaces.box(), self.path("box.ply"))
        os.rename(self.path("box.ply"), self.path("box.glb"))
        surface, warnings = read_surface(self.path("box.glb"))
        self.assertEqual((surface.GetNumberOfCells(), len(warnings)), (12, 1))

    def test_checked_repaired_and_written_again(self):
        source = self.file("boxes.3mf", surfaces.two_boxes())
        done = run_here("check", source)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("18 intersecting pairs", done.stdout)
        for fixed in ("fixed.glb", "fixed.3mf"):
            for _ in range(2):  # the second time it replaces its own
                done = run_here(source, self.path(fixed), "--quiet")
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(surfaces.is_watertight(read_surface(self.path(fixed))[0]))
            self.assertAlmostEqual(surfaces.enclosed_volume(read_surface(self.path(fixed))[0]), 15 / 8, 6)

    def test_files_of_others_are_not_replaced_unasked(self):
        source = self.file("box.off", surfaces.box())
        for name, content in (("other.glb", tetrahedron().bytes()), ("other.3mf", small_3mf())):
            other = self.file(name, content)
            self.check_failure(run_here("repair", source, other, "--quiet"), f"{other} was not written by insideout")
            with open(other, "rb") as file:
                self.assertEqual(file.read(), content)

    def test_a_bad_file_is_one_line(self):
        for name, content in (("a.glb", tetrahedron().bytes()[:-1]), ("a.3mf", small_3mf()[:-1])):
            self.check_failure(run_here("check", self.file(name, content)), name)


if __name__ == "__main__":
    unittest.main()
