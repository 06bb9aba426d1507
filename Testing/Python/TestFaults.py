# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that cannot be written to their end: the earlier one stays, nothing partial appears, one line says why.

    python3 TestFaults.py          some faults of each kind for the command, and all in one process
    python3 TestFaults.py --all    all of them for the command too, and a table of what happened (minutes)

INSIDEOUT_FAULTS names the library of faults.c, which makes the k-th write, fsync, close or rename fail,
or sends a signal before it.
"""

import contextlib
import errno
import itertools
import os
import signal
import sys
import tempfile
import unittest
import unittest.mock
from collections import Counter

LIBRARY = os.environ["INSIDEOUT_FAULTS"]
if __name__ == "__main__" and os.environ.get("LD_PRELOAD") != LIBRARY:
    os.execve(sys.executable, [sys.executable, *sys.argv], {**os.environ, "LD_PRELOAD": LIBRARY})

import insideout  # noqa: E402 (the library comes first)
import numpy as np  # noqa: E402
import surfaces  # noqa: E402
from insideout.pipeline import write_bytes, write_data  # noqa: E402
from insideout.places import read_places  # noqa: E402
from command import run  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402

ALL = "--all" in sys.argv
ERRORS = (errno.ENOSPC, errno.EIO, errno.EDQUOT)
SIGNALS = {signal.SIGINT: (130, "interrupted"), signal.SIGTERM: (143, "terminated"), signal.SIGKILL: (-signal.SIGKILL, None)}
HANGS = 100
"""Added to a signal, it comes in a call that never ends."""

PIECES = 5
"""The number of pieces into which a written file is broken."""

table: Counter = Counter()
"""How often what happened, by (kind of fault, output, what happened)."""


@contextlib.contextmanager
def fault(call: str, which: int, error: int, folder: str, size: int):
    """Let a call of the process fail below a folder, or bring a signal (a negative error)."""
    with unittest.mock.patch.dict(os.environ, environment_of_fault(call, which, error, folder, size)):
        yield


def environment_of_fault(call: str, which: int, error: int, folder: str, size: int) -> dict:
    environment_of_fault.count += 1  # a text that was not there before
    piece = str(-(-size // PIECES))
    return {"INSIDEOUT_FAULT": f"{call} {which} {error} {folder} {environment_of_fault.count}", "INSIDEOUT_PIECE": piece}


environment_of_fault.count = 0


def calls_to_fail(size: int):
    """The calls at which writing a file of this size is made to fail, with words for each."""
    writes = -(-size // -(-size // PIECES))
    yield "open", 1, "create"
    yield "write", 1, "first write"
    yield "write", writes // 2 + 1, "middle write"
    yield "write", writes, "last write"
    for call in ("fsync", "close", "rename"):
        yield call, 1, call


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.sources = os.path.join(folder.name, "sources")
        self.folder = os.path.join(folder.name, "results")
        os.mkdir(self.sources)
        os.mkdir(self.folder)

    def source(self, name: str) -> str:
        return os.path.join(self.sources, name)

    def files(self) -> dict:
        found = {}
        for name in os.listdir(self.folder):
            with open(os.path.join(self.folder, name), "rb") as file:
                found[name] = file.read()
        return found

    def earlier(self, name: str, exists: bool) -> dict:
        """Let there be only an earlier file, or none."""
        for other in os.listdir(self.folder):
            os.remove(os.path.join(self.folder, other))
        if exists:
            with open(os.path.join(self.folder, name), "wb") as file:
                file.write(b"earlier")
        return self.files()


class OfPython(InAFolder):
    """In one process, which lives on."""

    def writers(self):
        hull = insideout.tetrahedralize(surfaces.box()).hull
        for name in ("box.vtp", "box.ply", "box.stl", "box.obj", "box.off", "box.glb", "box.3mf"):
            yield name, lambda path: insideout.write(surfaces.box(), path)
        for name in ("hull.vtu", "hull.msh", "hull.inp", "hull.mesh", "hull.xdmf"):
            yield name, lambda path: insideout.write(hull, path)
        with open(self.source("query.csv"), "w", encoding="utf-8") as file:
            file.write("0.5,0.5,0.5\n" * 50)
        image = vtkImageData()
        image.SetDimensions(4, 4, 4)
        write_data(image, self.source("query.vti"))
        for name, count in (("query.csv", 50), ("query.vti", 64)):
            places = read_places(self.source(name))
            yield "w" + name[-4:], lambda path, places=places, count=count: places.write(np.ones(count), path)
        yield "picture.png", lambda path: write_bytes(bytes(range(256)) * 100, path)

    def each_writer(self):
        """Each name with its path, what writes it, and what there is then; in the end it writes that again."""
        for name, write in self.writers():
            path = os.path.join(self.folder, name)
            self.earlier(name, False)
            write(path)
            whole = self.files()
            yield name, path, write, whole
            write(path)
            self.assertEqual(self.files(), whole)

    def test_an_error_leaves_the_earlier_file(self):
        for name, path, write, whole in self.each_writer():
            size = len(whole[name])
            for (call, which, words), error, exists in itertools.product(calls_to_fail(size), ERRORS, (True, False)):
                before = self.earlier(name, exists)
                with self.subTest(name, call=words, error=os.strerror(error), exists=exists):
                    with fault(call, which, error, self.folder, size), self.assertRaises(insideout.Error) as caught:
                        write(path)
                    self.assertIn(path, str(caught.exception))
                    self.assertIn(os.strerror(error), str(caught.exception))
                    self.assertEqual(self.files(), before)
                    table[f"{words}: {errno.errorcode[error]}", os.path.splitext(name)[1], "Error, file as before, process lives"] += 1

    def test_ctrl_c_leaves_the_earlier_file(self):
        for name, path, write, whole in self.each_writer():
            size = len(whole[name])
            for call, which, words in calls_to_fail(size):
                before = self.earlier(name, True)
                with self.subTest(name, call=words):
                    with fault(call, which, -signal.SIGINT, self.folder, size), self.assertRaises(KeyboardInterrupt):
                        write(path)
                    self.assertEqual(self.files(), whole if call == "rename" else before)
                    what = "whole file" if call == "rename" else "file as before"
                    table[f"{words}: SIGINT", os.path.splitext(name)[1], f"KeyboardInterrupt, {what}, process lives"] += 1


class OfTheCommand(InAFolder):
    """Each time in a process of its own."""

    def arguments(self):
        """For each output: what it is called, its file, and the command that writes it; few without --all."""
        box, solid = self.source("box.ply"), self.source("solid.vtu")
        insideout.write(surfaces.two_boxes_and_a_stray_facet(), box)
        image = vtkImageData()
        image.SetDimensions(4, 4, 4)
        write_data(image, self.source("query.vti"))
        with open(self.source("query.csv"), "w", encoding="utf-8") as file:
            file.write("0.5,0.5,0.5\n" * 50)

        def result(name: str) -> str:
            return os.path.join(self.folder, name)

        yield "solid.vtu", (box, result("solid.vtu"))
        yield "report.json", (box, solid, "--report", result("report.json"))
        if ALL:
            yield "hull.vtu", (box, solid, "--hull", result("hull.vtu"))
            for ending in (".msh", ".inp", ".mesh", ".xdmf", ".off"):
                yield "solid" + ending, (box, result("solid" + ending))
            for ending in (".vtp", ".ply", ".stl", ".obj"):
                yield "boundary" + ending, (box, solid, "--boundary", result("boundary" + ending))
            yield "outliers.stl", (box, solid, "--outliers", result("outliers.stl"))
            for ending in (".csv", ".vti"):
                yield "w" + ending, ("--winding", self.source("query" + ending), box, result("w" + ending))
            yield "check.json", ("--check", box, "--report", result("check.json"))
            yield "picture.png", (box, solid, "--plot", result("picture.png"))
            yield "angles.png", ("--check", solid, "--plot", result("angles.png"))

    def faults(self, size: int):
        if ALL:
            for call, which, words in calls_to_fail(size):
                for error in (errno.ENOSPC, errno.EIO, *(-number for number in SIGNALS)):
                    yield call, which, words, error
                if call in ("write", "fsync"):
                    for number in (signal.SIGINT, signal.SIGTERM):
                        yield call, which, words + " that hangs", -number - HANGS
        else:
            yield "write", 2, "middle write", errno.ENOSPC
            for number in SIGNALS:
                yield "write", 2, "middle write", -number
            yield "write", 2, "middle write", -signal.SIGINT - HANGS

    def test_every_fault(self):
        for name, arguments in self.arguments():
            self.earlier(name, True)
            done = run(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            size = len(self.files()[name])
            for call, which, words, error in self.faults(size):
                before = self.earlier(name, True)
                with self.subTest(name, call=words, error=error):
                    environment = environment_of_fault(call, which, error, self.folder, size)
                    done = run(*arguments, env={**os.environ, **environment})
                    self.check_command(done, name, call, words, error, before)

    def check_command(self, done, name: str, call: str, words: str, error: int, before: dict):
        status, cause = (1, os.strerror(error)) if error > 0 else SIGNALS[-error % HANGS]
        self.assertEqual(done.returncode, status, done.stderr)
        found = self.files()
        left = [other for other in found if other.startswith(".insideout-")]
        self.assertEqual(len(left), 1 if error == -signal.SIGKILL and call != "open" else 0)
        kept = {other: content for other, content in found.items() if other not in left}
        replaced = call == "rename" and error in (-signal.SIGINT, -signal.SIGTERM)
        if not replaced:
            self.assertEqual(kept, before)
        else:
            self.assertEqual(list(kept), [name])
            self.assertNotEqual(kept, before)
        if cause is not None:
            lines = [line for line in done.stderr.splitlines() if line.startswith("insideout: ")]
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertIn(os.path.join(self.folder, name), lines[0])
            self.assertIn(cause, lines[0])
        self.assertNotIn("Traceback", done.stderr)
        kind = errno.errorcode[error] if error > 0 else signal.Signals(-error % HANGS).name
        what = f"exit {status}, {'whole file' if replaced else 'file as before'}" + (", temporary file left" if left else "")
        table[f"{words}: {kind}", f"command {name}", what] += 1


def print_table() -> None:
    print(f"{sum(table.values())} faults\n\n| fault | outputs | what happened | times |\n|---|---|---|---|")
    rows: dict = {}
    for (kind, output, what), times in table.items():
        outputs, count = rows.get((kind, what), ([], 0))
        rows[kind, what] = ([*outputs, output], count + times)
    for (kind, what), (outputs, count) in rows.items():
        print(f"| {kind} | {' '.join(outputs)} | {what} | {count} |")


if __name__ == "__main__":
    done = unittest.main(argv=[argument for argument in sys.argv if argument != "--all"], exit=False)
    if ALL:
        print_table()
    sys.exit(not done.result.wasSuccessful())
