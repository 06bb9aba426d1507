# SPDX-License-Identifier: GPL-3.0-or-later
"""Little memory: there is an answer, or one line says that there is not enough, whatever the limit."""

import os
import pickle
import resource
import subprocess
import sys
import tempfile
import unittest

import insideout
import numpy as np
from insideout import pipeline
from insideout.data import TriangleSurface, as_type
from insideout.files import write_surface
from TestProcesses import two_spheres

MEBIBYTE = 1 << 20
STEPS = 10


def size_of_process() -> int:
    """The bytes of its address space."""
    with open("/proc/self/status", encoding="ascii") as status:
        return [int(line.split()[1]) << 10 for line in status if line.startswith("VmSize")][0]


def outcome(call, more: int) -> tuple[int, str]:
    """The end of a copy of this process whose memory is limited to this number of bytes more, and its output."""
    receiver, sender = os.pipe()
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_AS, (size_of_process() + more, resource.RLIM_INFINITY))
        try:
            call()
            os.write(sender, b"answer")
        except (insideout.Error, MemoryError) as error:
            os.write(sender, f"error: {error}".encode())
        finally:
            os._exit(0)
    os.close(sender)
    with open(receiver, encoding="utf-8") as words:
        said = words.read()
    return os.waitpid(child, 0)[1], said


class Shortage(unittest.TestCase):
    def test_every_function_answers_or_says_so(self):
        surface = as_type(TriangleSurface, two_spheres(30))
        arrays = surface.points.copy(), surface.triangles.copy()
        points = np.repeat(arrays[0], 20, axis=0)
        for name, call in {
            "check": lambda: insideout.check(surface),
            "resolve": lambda: insideout.resolve(surface),
            "tetrahedralize": lambda: insideout.tetrahedralize(surface),
            "tetrahedralize arrays": lambda: insideout.tetrahedralize(arrays),
            "winding_number": lambda: insideout.winding_number(surface, points),
            "pickle": lambda: pickle.loads(pickle.dumps([surface] * 5)),
        }.items():
            pipeline.set_threads(4)
            seen = set()
            for step in range(STEPS):
                more = MEBIBYTE * step * step // 4
                with self.subTest(name, more=more):
                    status, said = outcome(call, more)
                    self.assertEqual((status, said.partition(":")[0] in ("answer", "error")), (0, True), said)
                    seen.add(said.partition(":")[0])
                    if said.rstrip() not in ("answer", "error:"):  # Python's own has no words
                        self.assertRegex(said, "^error: .*(memory|Unable to allocate)")
            self.assertIn("answer", seen, name)

    def test_the_command_answers_or_says_so(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file, output = os.path.join(folder.name, "spheres.ply"), os.path.join(folder.name, "solid.vtu")
        write_surface(two_spheres(100), file)
        program = "import insideout.command_line; import TestShortage; print(TestShortage.size_of_process())"
        begun = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=os.path.dirname(__file__) or ".")
        limit = int(begun.stdout)
        statuses = []
        while statuses[-1:] != [0]:
            with self.subTest(limit=limit // MEBIBYTE):
                done = subprocess.run(
                    [sys.executable, "-m", "insideout", "--threads", "4", file, output],
                    capture_output=True,
                    text=True,
                    check=False,
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
                )
                statuses.append(done.returncode)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                if done.returncode == 1:
                    self.assertRegex(done.stderr.splitlines()[-1], "^insideout: .*memory")
                else:
                    self.assertTrue(os.path.exists(output))
            limit += limit // 8
        self.assertIn(1, statuses)


if __name__ == "__main__":
    unittest.main()
