# SPDX-License-Identifier: GPL-3.0-or-later
"""What every result has to hold, on dirty meshes that the Debian package libcgal-demo brings."""

import os
import tarfile
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import insideout
from insideout.files import read_surface
from surfaces import (
    cell_array,
    enclosed_volume,
    exact_volume,
    is_watertight,
    points_of,
    tetrahedra_of,
)

ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"

# Faces of vtkTetra, outward for a positive one.
FACES = np.array([[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]])

# Open edges and intersecting pairs of each mesh, counted by brute force with exact predicates.
MESHES = {
    "man.off": (0, 848),
    "mannequin-devil.off": (64, 1643),
    "elephant-with-holes.off": (1353, 0),
    "pig.stl": (1296, 70),
    "cow.off": (0, 89),
    "b9_mesh.off": (1708, 1),
}


def not_positive(grid):
    """How many cells have no positive volume, by doubles where they are sure and else exactly."""
    corner = points_of(grid)[tetrahedra_of(grid)]
    u, v, t = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
    det = np.einsum("ij,ij->i", np.cross(u, v), t)
    unsure = det <= 1e-13 * np.prod([np.abs(x).max(1) for x in (u, v, t)], axis=0)
    return sum(exact_volume(*corner[i]) <= 0 for i in np.flatnonzero(unsure))


def volume(grid):
    corner = points_of(grid)[tetrahedra_of(grid)]
    u, v, t = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
    return np.einsum("ij,ij->i", np.cross(u, v), t).sum() / 6


class TestRealMeshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        with tarfile.open(ARCHIVE) as archive:
            for name in MESHES:
                member = archive.getmember("data/meshes/" + name)
                member.name = name
                archive.extract(member, cls.folder.name)
        cls.results = {}
        for name in MESHES:
            surface, _ = read_surface(os.path.join(cls.folder.name, name))
            cls.results[name] = surface, insideout.tetrahedralize(surface)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def each(self):
        for name, (surface, result) in self.results.items():
            with self.subTest(mesh=name):
                yield name, surface, result

    def test_the_defects_are_counted(self):
        for name, _, result in self.each():
            found = result.statistics
            self.assertEqual((found["OpenEdges"], found["IntersectingPairs"]), MESHES[name])

    def test_every_cell_has_positive_volume(self):
        for _, _, result in self.each():
            self.assertGreater(result.solid.GetNumberOfCells(), 1000)
            self.assertEqual(not_positive(result.hull), 0)

    def test_cells_meet_in_whole_faces(self):
        for _, _, result in self.each():
            faces = np.sort(tetrahedra_of(result.hull)[:, FACES].reshape(-1, 3), axis=1)
            _, count = np.unique(faces, axis=0, return_counts=True)
            self.assertEqual(set(count), {1, 2})

    def test_every_input_vertex_is_a_point_of_the_hull_bit_by_bit(self):
        for _, surface, result in self.each():
            given = points_of(surface)
            used = np.unique(vtk_to_numpy(surface.GetPolys().GetConnectivityArray()))
            have = {p.tobytes() for p in points_of(result.hull) + 0.0}
            self.assertEqual([p for p in used if (given[p] + 0.0).tobytes() not in have], [])

    def test_the_boundary_is_watertight_and_bounds_the_solid(self):
        for _, _, result in self.each():
            self.assertTrue(is_watertight(result.boundary))
            self.assertAlmostEqual(enclosed_volume(result.boundary) / volume(result.solid), 1, 9)

    def test_w_rises_by_the_multiplicity_of_each_face(self):
        for _, _, result in self.each():
            if not result.statistics["Closed"]:
                continue
            w = cell_array(result.hull, "w")
            rise = cell_array(result.hull, "FacetMultiplicity").astype(int).ravel()
            self.assertTrue((w == np.round(w)).all())
            faces = np.sort(tetrahedra_of(result.hull)[:, FACES].reshape(-1, 3), axis=1)
            _, index = np.unique(faces, axis=0, return_inverse=True)
            order = np.argsort(index.ravel(), kind="stable")
            pair = order[np.flatnonzero(np.diff(index.ravel()[order]) == 0)[:, None] + [0, 1]]
            self.assertTrue((w[pair[:, 0] // 4] - w[pair[:, 1] // 4] == rise[pair[:, 0]]).all())
            self.assertTrue((rise[pair[:, 0]] == -rise[pair[:, 1]]).all())

    def test_closed_surfaces_give_the_cells_with_positive_w(self):
        for _, _, result in self.each():
            if result.statistics["Closed"]:
                inside = cell_array(result.hull, "Inside") == 1
                self.assertTrue((inside == (cell_array(result.hull, "w") >= 1)).all())


if __name__ == "__main__":
    unittest.main()
