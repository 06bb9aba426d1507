# SPDX-License-Identifier: GPL-3.0-or-later
"""What every result has to hold, on dirty meshes that the Debian package libcgal-demo brings."""

import os
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import insideout
from insideout.files import read_surface
from real_surfaces import unpack_cgal
from surfaces import (
    cell_array,
    count_not_manifold,
    enclosed_volume,
    exact_volume,
    faces_of,
    is_watertight,
    points_of,
    tetrahedra_of,
    triangles_of,
)


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


class FacesOf:
    """The faces of a hull's cells, however these are labelled."""

    def __init__(self, hull):
        self.faces, self.number = faces_of(hull)
        self.is_on_input = np.bincount(self.number, weights=cell_array(hull, "FacetIds").ravel() >= 0) > 0

    def not_manifold(self, inside):
        """Edges and points at which the boundary of the cells inside is no manifold."""
        inside = np.repeat(inside == 1, 4)
        is_boundary = np.bincount(self.number, weights=inside)[self.number] == 1
        return count_not_manifold(self.faces[inside & is_boundary])

    def unkept(self, inside):
        """Faces on input cells that no cell inside has."""
        sides_inside = np.bincount(self.number, weights=np.repeat(inside == 1, 4))
        return int((self.is_on_input & (sides_inside == 0)).sum())


class TestRealMeshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.results = {}
        for path in unpack_cgal(cls.folder.name, MESHES):
            surface, _ = read_surface(path)
            cls.results[os.path.basename(path)] = surface, insideout.tetrahedralize(surface)
        assert set(cls.results) == set(MESHES)

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
        for name, _, result in self.each():
            # b9_mesh is a scan of the ground: its closed specks alone are a solid.
            self.assertGreater(result.solid.GetNumberOfCells(), 100 if name == "b9_mesh.off" else 1000)
            self.assertEqual(not_positive(result.hull), 0)

    def test_cells_meet_in_whole_faces(self):
        for _, _, result in self.each():
            self.assertEqual(set(np.bincount(faces_of(result.hull)[1])), {1, 2})

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
            index = faces_of(result.hull)[1]
            order = np.argsort(index, kind="stable")
            pair = order[np.flatnonzero(np.diff(index[order]) == 0)[:, None] + [0, 1]]
            self.assertTrue((w[pair[:, 0] // 4] - w[pair[:, 1] // 4] == rise[pair[:, 0]]).all())
            self.assertTrue((rise[pair[:, 0]] == -rise[pair[:, 1]]).all())

    def test_closed_surfaces_give_the_cells_with_positive_w(self):
        for _, _, result in self.each():
            if result.statistics["Closed"]:
                inside = cell_array(result.hull, "Inside") == 1
                self.assertTrue((inside == (cell_array(result.hull, "w") >= 1)).all())

    def test_constraints_hold_on_what_the_cut_makes_of_each_mesh(self):
        broken = np.zeros(3, int)
        for _, _, result in self.each():
            faces = FacesOf(result.hull)
            inside = cell_array(result.hull, "Inside")
            broken += [*faces.not_manifold(inside), faces.unkept(inside)]
            for keep, manifold in ((True, False), (False, True), (True, True)):
                cut = insideout.vtkGraphCutSegmentation()
                cut.SetConstrainFacets(keep)
                cut.SetNonManifold(cut.NONMANIFOLD_FILL if manifold else cut.NONMANIFOLD_KEEP)
                cut.ExtractInsideOff()
                cut.SetInputData(result.hull)
                cut.Update()
                inside = cell_array(cut.GetOutput(), "Inside")
                self.assertTrue(not manifold or faces.not_manifold(inside) == (0, 0))
                self.assertTrue(not keep or faces.unkept(inside) == 0)
        self.assertTrue((broken > 0).all(), f"without constraints, {broken} edges, points and faces are not right")

    def test_constraints_hold_on_the_solid_of_a_surface(self):
        surface, plain = self.results["cow.off"]
        self.assertGreater(plain.outliers.GetNumberOfCells(), 0)
        result = insideout.tetrahedralize(surface, constrain_facets=True, non_manifold="fill")
        self.assertEqual(FacesOf(result.hull).unkept(cell_array(result.hull, "Inside")), 0)
        self.assertEqual(count_not_manifold(triangles_of(result.boundary)), (0, 0))
        self.assertEqual(result.outliers.GetNumberOfCells(), 0)


class Remeshed(unittest.TestCase):
    def test_edges_contracted_to_a_length_leave_no_flat_cell(self):
        with tempfile.TemporaryDirectory() as folder:
            (path,) = unpack_cgal(folder, ("joint.off",))
            made = insideout.tetrahedralize(path, edge_length="4%", surface_treatment="remeshed")
        self.assertGreater(insideout.check_solid(made.solid).statistics["MinDihedralAngle"], 1)


if __name__ == "__main__":
    unittest.main()
