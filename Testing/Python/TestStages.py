# SPDX-License-Identifier: GPL-3.0-or-later
"""Which stages run again when what changes, that each says what it does, and that each can be stopped."""

import os
import unittest
from unittest import mock

import insideout
import numpy as np
import surfaces
from insideout.commands.check import CheckJob, SolidCheckJob
from insideout.commands.mesh import MeshJob
from insideout.commands.query import QueryJob
from insideout.commands.refine import RefineJob
from insideout.stages import CHECK, CHECK_SOLID, REFINE, RESOLVE, TETRAHEDRALIZE, UNNAMED, WINDING
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource, vtkSphereSource

SEGMENTING = TETRAHEDRALIZE[-2:]


def stages_of(algorithm) -> list[str]:
    """The stages that an update goes through."""
    seen = []
    insideout.pipeline.run(algorithm, lambda stage, _: seen.append(stage))
    return [stage for stage in dict.fromkeys(seen) if stage != UNNAMED]


def content(data) -> tuple:
    return surfaces.points_of(data).tobytes(), [
        data.GetCellData().GetArray(k).GetName() for k in range(data.GetCellData().GetNumberOfArrays())
    ], data.GetNumberOfCells()


class Names(unittest.TestCase):
    """No filter reports a stage whose name Python does not know, and each reports those that Python expects."""

    def test_each_function(self):
        for expected, work in (
            (CHECK, insideout.check),
            (RESOLVE, insideout.resolve),
            (TETRAHEDRALIZE, insideout.tetrahedralize),
            (TETRAHEDRALIZE, lambda surface, **options: insideout.tetrahedralize(surface, engine="tetgen", **options)),
            (WINDING, lambda surface, **options: insideout.winding_number(surface, [(0.5, 0.5, 0.5)], **options)),
        ):
            for surface in (surfaces.two_boxes(), surfaces.open_box()):
                seen = []
                work(surface, progress=lambda stage, _: seen.append(stage))
                self.assertEqual([stage for stage in dict.fromkeys(seen) if stage != UNNAMED], list(expected))

    def test_the_check_of_a_solid(self):
        seen = []
        insideout.check_solid(insideout.tetrahedralize(surfaces.two_boxes()).solid, progress=lambda stage, _: seen.append(stage))
        self.assertEqual([stage for stage in dict.fromkeys(seen) if stage != UNNAMED], list(CHECK_SOLID))

    def test_each_filter(self):
        known = {*TETRAHEDRALIZE, *CHECK, *WINDING}
        resolver, winding = insideout.vtkResolveSelfIntersections(), insideout.vtkGeneralizedWindingNumber()
        for first in (resolver, winding, insideout.vtkSurfaceDefects(), insideout.vtkRobustTetrahedralize()):
            first.SetInputData(surfaces.two_boxes())
            self.assertLessEqual({*stages_of(first)}, known)
        for second, source in ((insideout.vtkConstrainedDelaunay3D(), resolver), (insideout.vtkGraphCutSegmentation(), winding)):
            second.SetInputData(source.GetOutput())
            seen = {*stages_of(second)}
            self.assertTrue(seen)
            self.assertLessEqual(seen, known)

    def test_the_command_shows_all_that_is_reported(self):
        jobs = (MeshJob, CheckJob, SolidCheckJob, QueryJob, RefineJob)
        self.assertEqual([job.stages for job in jobs], [TETRAHEDRALIZE, CHECK, CHECK_SOLID, WINDING, REFINE])


class Again(unittest.TestCase):
    def setUp(self):
        self.input = surfaces.open_box()
        self.filter = insideout.vtkRobustTetrahedralize()
        self.filter.SetInputData(self.input)
        self.assertEqual(stages_of(self.filter), list(TETRAHEDRALIZE))

    def test_nothing_changes_and_nothing_runs(self):
        time_of_output = self.filter.GetOutput().GetMTime()
        self.assertEqual(stages_of(self.filter), [])
        self.filter.SetGamma(self.filter.GetGamma())
        self.assertEqual(stages_of(self.filter), [])
        self.assertEqual(self.filter.GetOutput().GetMTime(), time_of_output)

    def test_changes_of_the_segmentation_run_only_that(self):
        for change in (
            lambda: self.filter.SetGamma(0.5),
            lambda: self.filter.GetSegmentation().SetSigma(0.5),
            lambda: self.filter.GetSegmentation().FillCavitiesOn(),
            lambda: self.filter.GenerateHullOn(),
        ):
            change()
            self.assertEqual(stages_of(self.filter), list(SEGMENTING))

    def test_changes_of_the_mesh_run_all_stages(self):
        for change in (
            lambda: self.filter.SetOrientation(1),
            lambda: self.filter.SetMergeTolerance(1e-9),
            lambda: self.filter.GetWindingNumber().CountDuplicatesOn(),
            lambda: self.filter.GetWindingNumber().SetQuadratureOrder(2),
            lambda: self.filter.GetWindingNumber().SetEngineToExact(),
            lambda: self.filter.GetWindingNumber().SetTimeBudget(60),
            lambda: self.filter.GetWindingNumber().SetMemoryBudget(2000),
            lambda: self.input.Modified(),
            lambda: self.input.GetPoints().Modified(),
            lambda: self.input.GetPolys().Modified(),
            lambda: surfaces.add_array(self.input.GetCellData(), "new", np.arange(10)),
            lambda: self.filter.SetInputData(surfaces.open_box()),
        ):
            change()
            self.assertEqual(stages_of(self.filter), list(TETRAHEDRALIZE))
            self.assertEqual(stages_of(self.filter), [])

    def test_results_are_those_of_a_fresh_filter(self):
        for gamma in (0, 0.1, 10):
            self.filter.SetGamma(gamma)
            insideout.pipeline.run(self.filter)
            fresh = insideout.vtkRobustTetrahedralize()
            fresh.SetInputData(self.input)
            fresh.SetGamma(gamma)
            insideout.pipeline.run(fresh)
            for port in range(3):
                self.assertEqual(content(self.filter.GetOutputDataObject(port)), content(fresh.GetOutputDataObject(port)))

    def test_warnings_come_again(self):
        self.filter.SetInputData(surfaces.reversed_box())
        surfaces.add_array(self.filter.GetInput().GetPointData(), "vtkOriginalPointIds", np.arange(8.0))
        first = insideout.pipeline.run(self.filter)
        self.assertEqual(len(first), 2)
        self.filter.SetGamma(0.5)
        self.assertEqual(insideout.pipeline.run(self.filter), first)

    def test_data_of_the_input_that_was_meshed_are_used_although_the_object_changes_later(self):
        self.input.Initialize()
        self.input.ShallowCopy(surfaces.two_boxes())
        self.assertEqual(stages_of(self.filter), list(TETRAHEDRALIZE))
        self.assertAlmostEqual(float(sum(surfaces.exact_volumes(self.filter.GetOutput()))), 15 / 8, delta=1e-12)

    def test_a_failure_is_forgotten(self):
        bad = surfaces.box(facets=[(0, 1, 99)])
        self.filter.SetInputData(bad)
        for _ in range(2):
            self.filter.Modified()
            with self.assertRaisesRegex(insideout.Error, "99"):
                insideout.pipeline.run(self.filter)
        self.filter.SetInputData(self.input)
        self.assertGreater(len(stages_of(self.filter)), 0)
        self.assertGreater(self.filter.GetOutput().GetNumberOfCells(), 0)

    def test_release_of_data_releases_the_hull(self):
        self.filter.ReleaseDataFlagOn()
        for gamma in (0.3, 0.4):
            self.filter.SetGamma(gamma)
            seen = stages_of(self.filter)
        self.assertEqual(seen, list(TETRAHEDRALIZE))

    def test_a_stage_behind_its_own_filter_is_freed_with_it(self):
        polygon = vtkRegularPolygonSource()
        polygon.Update()
        for kind, surface in (
            (insideout.vtkRobustTetrahedralize, surfaces.two_boxes()),
            (insideout.vtkRobustTriangulate, polygon.GetOutput()),
        ):
            freed = []
            owner = kind()
            owner.AddObserver("DeleteEvent", lambda *_: freed.append(True))
            owner.SetInputData(surface)
            owner.GenerateHullOn()
            stage = owner.GetSegmentation()
            stage.SetInputConnection(owner.GetOutputPort(3))
            stage.Update()
            self.assertGreater(stage.GetOutput().GetNumberOfCells(), 0)
            del owner, stage
            self.assertEqual(freed, [True])

    def test_each_block_is_remembered(self):
        blocks = vtkMultiBlockDataSet()
        for k, surface in enumerate((surfaces.box(), surfaces.two_boxes(), surfaces.open_box())):
            blocks.SetBlock(k, surface)
            blocks.GetMetaData(k).Set(vtkMultiBlockDataSet.NAME(), f"part {k}")
        self.filter.SetInputDataObject(blocks)
        self.assertEqual(stages_of(self.filter), list(TETRAHEDRALIZE))
        self.filter.SetGamma(0.5)
        self.assertEqual(stages_of(self.filter), list(SEGMENTING))
        for port in range(3):
            output = self.filter.GetOutputDataObject(port)
            self.assertEqual(output.GetClassName(), "vtkMultiBlockDataSet")
            for k in range(3):
                self.assertEqual(output.GetMetaData(k).Get(vtkMultiBlockDataSet.NAME()), f"part {k}")
        solids = self.filter.GetOutputDataObject(0)
        for k, volume in enumerate((1, 15 / 8, 1)):
            self.assertAlmostEqual(float(sum(surfaces.exact_volumes(solids.GetBlock(k)))), volume, delta=1e-12)


def dirty_balls(resolution=110):
    """Three balls that cross, each open at a pole: about as many facets as the real models have."""
    points, triangles = [], []
    for k in range(3):
        ball = vtkSphereSource()
        ball.SetThetaResolution(resolution)
        ball.SetPhiResolution(resolution)
        ball.SetStartPhi(12)
        ball.SetCenter(0.37 * k, 0.11 * k * k, 0)
        ball.Update()
        triangles.append(surfaces.triangles_of(ball.GetOutput()) + sum(map(len, points)))
        points.append(surfaces.points_of(ball.GetOutput()))
    return insideout.surfaces.make_surface(np.concatenate(points), np.concatenate(triangles))


class Stop(Exception):
    pass


class Stopping(unittest.TestCase):
    """On a surface of 70,000 facets, or on the one that INSIDEOUT_TEST_SURFACE names."""

    @classmethod
    def setUpClass(cls):
        name = os.environ.get("INSIDEOUT_TEST_SURFACE")
        cls.surface = insideout.files.read_surface(name)[0] if name else dirty_balls()

    def filter(self, kind="vtkRobustTetrahedralize", **parameters):
        made = getattr(insideout, kind)()
        for name, value in parameters.items():
            getattr(insideout.options.owner_of(made, name), "Set" + name)(value)
        made.SetInputData(self.surface)
        return made

    def check_stop(self, algorithm, stage, report):
        """Stop at a stage's report of this number: it is the last, the output is empty, and all can begin anew."""
        reports, heard = [], []
        hear = insideout.pipeline._Listener._hear

        def listen(listener, event, words, fraction):
            if words:  # VTK says when it begins and ends, without any
                heard.append(words)
            return hear(listener, event, words, fraction)

        def progress(current, _):
            if current == stage:
                reports.append(len(heard))
                if len(reports) == report:
                    raise Stop

        with mock.patch.object(insideout.pipeline._Listener, "_hear", listen), self.assertRaises(Stop):
            insideout.pipeline.run(algorithm, progress)
        self.assertEqual(reports[-1], len(heard))
        for port in range(algorithm.GetNumberOfOutputPorts()):
            self.assertEqual(algorithm.GetOutputDataObject(port).GetNumberOfCells(), 0)

    def test_every_stage_stops_and_the_next_run_is_whole(self):
        algorithm = self.filter()
        for stage in TETRAHEDRALIZE:
            with self.subTest(stage):
                self.check_stop(algorithm, stage, 1)
        insideout.pipeline.run(algorithm)
        self.assertGreater(algorithm.GetOutput().GetNumberOfCells(), 0)

    def test_tetrahedralizing_stops_in_the_midst_with_either_engine(self):
        for engine in (1, 2):
            with self.subTest(engine=engine):
                self.check_stop(self.filter(Engine=engine), "tetrahedralizing", 2)


if __name__ == "__main__":
    unittest.main()
