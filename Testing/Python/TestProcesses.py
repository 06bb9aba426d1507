# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes that are forked or spawned, also within a call, and too many threads.

ctest ends tests that hang: the time limit there is far above the usual time.
"""

import multiprocessing
import os
import threading
import unittest

import insideout
import surfaces
from insideout import pipeline
from command import run
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

WORKERS = 4
THREADS = 4  # a machine with one processor supports this number, too


def two_spheres(facets_around: int = 60):
    """Large enough for several threads."""
    both = vtkAppendPolyData()
    for place in (0.0, 0.3):
        sphere = vtkSphereSource()
        sphere.SetCenter(place, place, 0)
        sphere.SetThetaResolution(facets_around)
        sphere.SetPhiResolution(facets_around)
        both.AddInputConnection(sphere.GetOutputPort())
    both.Update()
    return both.GetOutput()


def answer(surface=None) -> tuple:
    """The properties of a surface that can be compared. By default it is the spheres."""
    pipeline.set_threads(THREADS)
    result = insideout.tetrahedralize(two_spheres() if surface is None else surface)
    w = insideout.winding_number(surfaces.two_boxes(), [(0.25, 0.25, 0.25), (0.75, 0.75, 0.75)])
    return result.solid.points.tobytes(), result.solid.cells.tobytes(), result.hull.w.tobytes(), w.tobytes()


def give(sender, work, *arguments) -> None:
    sender.send(work(*arguments))
    sender.close()


def answer_of_a_worker(method: str):
    """What a process gives that this one starts."""
    return answers_of_workers(multiprocessing.get_context(method), 1, answer)[0]


def answers_of_workers(context, number: int, work, *arguments) -> list:
    """The results of this number of processes, all at once."""
    receivers, processes = [], []
    for _ in range(number):
        receiver, sender = context.Pipe(duplex=False)
        processes.append(context.Process(target=give, args=(sender, work, *arguments)))
        processes[-1].start()
        sender.close()  # so that the end of a process that dies is heard
        receivers.append(receiver)
    answers = [receiver.recv() for receiver in receivers]
    for process in processes:
        process.join()
        assert process.exitcode == 0
    return answers


class Processes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.expected = answer()

    def expect(self, answers: list) -> None:
        for found in answers:
            self.assertTrue(found == self.expected)

    def test_forked_workers_give_the_same_after_a_call_in_the_parent(self):
        self.expect(answers_of_workers(multiprocessing.get_context("fork"), WORKERS, answer))

    def test_spawned_workers_give_the_same(self):
        self.expect(answers_of_workers(multiprocessing.get_context("spawn"), WORKERS, answer))

    def test_workers_of_workers_give_the_same(self):
        for method in ("fork", "spawn"):
            context = multiprocessing.get_context("fork")
            self.expect(answers_of_workers(context, 2, answer_of_a_worker, method))

    def test_workers_that_are_forked_while_another_thread_is_within_a_call_give_the_same(self):
        within, done = threading.Event(), threading.Event()
        found = []

        def stop_here(stage: str, fraction: float) -> None:
            within.set()
            done.wait()

        def call() -> None:
            pipeline.set_threads(THREADS)
            found.append(insideout.check(two_spheres(), progress=stop_here).verdict)

        thread = threading.Thread(target=call)
        thread.start()
        within.wait()
        try:
            self.expect(answers_of_workers(multiprocessing.get_context("fork"), WORKERS, answer))
        finally:
            done.set()
            thread.join()
        self.assertEqual(found, [insideout.check(two_spheres()).verdict])

    def test_workers_that_are_forked_at_any_moment_of_a_call_give_the_same(self):
        ended = threading.Event()

        def call() -> None:
            pipeline.set_threads(THREADS)
            while not ended.is_set():
                insideout.tetrahedralize(two_spheres(30))

        thread = threading.Thread(target=call)
        thread.start()
        small = surfaces.two_boxes()
        expected = answer(small)
        try:
            for _ in range(10):
                answers = answers_of_workers(multiprocessing.get_context("fork"), 2, answer, small)
                self.assertTrue(answers == [expected, expected])
        finally:
            ended.set()
            thread.join()

    def test_workers_that_are_forked_by_progress_give_the_same(self):
        stages = []

        def fork(stage: str, fraction: float) -> None:
            if stage not in stages:
                stages.append(stage)
                answers = answers_of_workers(multiprocessing.get_context("fork"), 1, answer)
                self.assertTrue(answers == [self.expected])

        pipeline.set_threads(THREADS)
        result = insideout.tetrahedralize(two_spheres(), progress=fork)
        self.assertGreater(len(stages), 5)
        self.assertEqual(result.hull.w.tobytes(), self.expected[2])

    def test_a_copy_of_a_process_that_goes_on_with_the_call_says_why_it_cannot(self):
        """As after a bare os.fork() in progress, which nobody should write."""
        parent = os.getpid()
        receiver, sender = os.pipe()

        def fork(stage: str, fraction: float) -> None:
            if stage == "winding numbers" and os.getpid() == parent and not children:
                children.append(os.fork())

        children: list[int] = []
        pipeline.set_threads(THREADS)
        points = two_spheres(100)
        try:
            insideout.winding_number(two_spheres(), points, progress=fork)
            words = "no error"
        except insideout.Error as error:
            words = str(error)
        if os.getpid() != parent:
            os.write(sender, words.encode())
            os._exit(0)
        self.assertEqual(words, "no error")
        os.waitpid(children[0], 0)
        # Where one thread did all the work, the copy could go on.
        self.assertRegex(os.read(receiver, 1000).decode(), "^this process was forked in the middle of the work|^no error$")


class Threads(unittest.TestCase):
    MOST = 4 * os.cpu_count()

    def test_too_many_are_cut_with_one_warning(self):
        surface = os.path.join(os.path.dirname(__file__), "..", "Data", "two-boxes.off")
        for asked in ("30000", "100000", str(10**20)):
            for arguments, environment in (
                (("--threads", asked), {}),
                ((), {"OMP_NUM_THREADS": asked if len(asked) < 9 else "2000000000"}),
            ):
                with self.subTest(asked=asked, environment=environment):
                    done = run("--check", surface, *arguments, env={**os.environ, **environment})
                    self.assertEqual(done.returncode, 0, done.stderr)
                    warnings = [line for line in done.stdout.splitlines() if line.startswith("Warning: ")]
                    self.assertEqual(len(warnings), 1, done.stdout)
                    self.assertRegex(
                        warnings[0], rf"^Warning: \d+ threads are asked for, but {self.MOST} work: more than 4 for each .* {os.cpu_count()} processors"
                    )

    def test_as_many_as_help_are_no_reason_for_a_warning(self):
        surface = os.path.join(os.path.dirname(__file__), "..", "Data", "two-boxes.off")
        done = run("--check", surface, "--threads", str(self.MOST))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("Warning", done.stdout)

    def test_every_function_that_has_warnings_tells_of_too_many(self):
        try:
            pipeline.set_threads(30000)
            for function in (insideout.check, insideout.resolve, insideout.tetrahedralize):
                with self.subTest(function.__name__):
                    (warning,) = function(surfaces.two_boxes()).warnings
                    self.assertIn(f"30000 threads are asked for, but {self.MOST} work", warning)
            self.assertEqual(insideout.inside(surfaces.two_boxes(), [(0.25, 0.25, 0.25)]).tolist(), [True])
        finally:
            pipeline.set_threads(THREADS)


if __name__ == "__main__":
    unittest.main()
