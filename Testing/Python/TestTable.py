# SPDX-License-Identifier: GPL-3.0-or-later
"""Testing/Benchmark/table.py says what the filters say, and tells right meshes from wrong ones."""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import insideout
import numpy as np

TESTING = Path(__file__).resolve().parent.parent
SURFACE = TESTING / "Data" / "two-boxes.off"
sys.path.insert(0, str(TESTING / "Benchmark"))
import table  # noqa: E402
from meshers import Answer  # noqa: E402


class TestTable(unittest.TestCase):
    def test_a_surface_has_a_row_of_its_own_counts(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, TESTING / "Benchmark" / "table.py", SURFACE, "--only", "--output", folder]
            printed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            rows, peers = (list(csv.DictReader(Path(folder, name).read_text().splitlines())) for name in ("table.csv", "peers.csv"))
        self.assertIn("| ours | 1 of 1 | 1 | 1 |", printed)
        statistics = insideout.tetrahedralize(SURFACE).statistics
        self.assertEqual([row["model"] for row in rows], ["two-boxes.off"])
        for column in ("|V|", "|F|", "|dF|", "#self-int.", "#CC", "#nme.", "|E|", "in the hull", "Steiner"):
            self.assertEqual(int(rows[0][column]), statistics[table.COLUMNS[column]], column)
        ours = next(peer for peer in peers if peer["mesher"] == "ours")
        self.assertEqual((ours["is_right"], ours["keeps_facets"], float(ours["kept"])), ("True", "True", 1.0))
        delaunay = next(peer for peer in peers if peer["mesher"] == "vtkDelaunay3D")
        self.assertEqual(delaunay["keeps_facets"], "False")  # the boxes cross, so facets have no faces there

    def test_a_mesh_that_lacks_or_turns_a_cell_is_not_right(self):
        surface = table.triangles_as_they_come(str(SURFACE))
        solid = insideout.tetrahedralize(SURFACE).solid
        places = table.places_on(surface.points, surface.triangles)
        volume = table.volume_of(solid.points, solid.cells)
        are_kept = table.distances_from_faces(places, solid.points, solid.cells) <= table.NEAR
        verdicts = []
        turned = solid.cells.copy()
        turned[0, :2] = turned[0, 1::-1]
        for cells in (solid.cells, solid.cells[len(solid.cells) // 2 :], turned):
            verdicts.append(table.verdict_of(Answer(solid.points, cells, 0.0), places, are_kept, volume))
        self.assertEqual([one.is_right for one in verdicts], [True, False, False])
        self.assertEqual([one.keeps_facets for one in verdicts], [True, False, True])
        self.assertLessEqual(verdicts[0].farthest, table.NEAR)
        self.assertGreater(verdicts[1].farthest, 0.01)
        self.assertIn("negative", verdicts[2].trouble)

    def test_a_place_beside_a_face_is_not_on_it(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0)])
        places = np.array([(0.2, 0.2, 0), (0.2, 0.2, 1e-6), (0.1, 0, 0.3), (1, 1, 1.0)])
        distances = table.distances_from_faces(places, points, np.array([(0, 1, 2, 3)]))
        self.assertEqual((distances <= table.NEAR).tolist(), [True, False, True, False])

    def test_a_model_of_the_thesis_has_its_row(self):
        self.assertEqual(table.thesis_row("AlienSpaceObject.obj", 17692)[1:5], ["8762", "17692", "0", "1686"])
        self.assertIsNone(table.thesis_row("man.off", 34986))
        self.assertIsNone(table.thesis_row("bear.off", 27648))  # another bear


if __name__ == "__main__":
    unittest.main()
