# SPDX-License-Identifier: GPL-3.0-or-later
"""What stops the command: a timeout, Ctrl-C and SIGTERM."""

import json
import os
import select
import signal
import subprocess
import sys
import unittest

import surfaces
from command import CommandLine, run

SIGNALS = ((signal.SIGINT, "interrupted", 130), (signal.SIGTERM, "terminated", 143))


class Stopping(CommandLine):
    """What stops the command while TetGen hangs."""

    def setUp(self):
        super().setUp()
        helper = self.file("helper", "#!/bin/sh\nexec sleep infinity\n")
        os.chmod(helper, 0o700)
        self.environment = dict(os.environ, INSIDEOUT_TETGEN=helper)

    def test_a_timeout_ends_a_surface(self):
        done = run(self.file("box.ply", surfaces.box()), self.output, "--engine", "tetgen", "--timeout", "1", env=self.environment)
        self.check_failure(done, "stopped while tetrahedralizing", "--timeout")

    def signalled(self, stage: str, number: int, *arguments: str, env=None) -> tuple:
        """What a command says after a signal that comes in a stage, and its exit status."""
        with subprocess.Popen(
            [sys.executable, "-m", "insideout", *arguments], stderr=subprocess.PIPE, env=env, text=True
        ) as process:
            self.assertTrue(any(stage in line for line in process.stderr))
            process.send_signal(number)
            return process.stderr.read(), process.wait()

    def test_a_signal_ends_the_command(self):
        report, box = self.path("report.json"), self.file("box.ply", surfaces.box())
        arguments = (box, self.output, "--engine", "tetgen", "--report", report)
        for number, words, status in SIGNALS:
            with self.subTest(words):
                said = self.signalled("resolving", number, *arguments, env=self.environment)
                self.assertEqual(said, (f"insideout: {box}: {words}\n", status))
                with open(report, encoding="utf-8") as file:
                    self.assertEqual(json.load(file)["exit_status"], status)

    def test_a_signal_ends_it_while_a_pipe_waits_for_a_reader(self):
        os.mkfifo(self.output)
        box = self.file("box.ply", surfaces.box())
        for number, words, status in SIGNALS:
            with self.subTest(words):
                errors, found = self.signalled("extracting", number, box, self.output)
                self.assertRegex(errors, f"^insideout: .*: {words}\n$")
                self.assertEqual(found, status)

    def test_a_signal_ends_a_drawing_and_leaves_nothing(self):
        """A program takes the display's place that makes a file, says so, and never ends."""
        begun, never = self.path("begun"), self.path("never")
        os.mkfifo(begun)
        os.mkfifo(never)
        display = self.file("xvfb-run", f"#!/bin/sh\n: >$TMPDIR/made\necho >'{begun}'\nexec cat '{never}'\n")
        os.chmod(display, 0o700)
        folder, picture = self.path("temporary"), self.path("picture.png")
        os.mkdir(folder)
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        environment.update(TMPDIR=folder, PATH=f"{self.folder}{os.pathsep}{os.environ['PATH']}")
        box = self.file("box.ply", surfaces.box())
        for number, words, status in SIGNALS:
            with self.subTest(words), open(os.open(begun, os.O_RDONLY | os.O_NONBLOCK), encoding="utf-8") as display_says, subprocess.Popen(
                [sys.executable, "-m", "insideout", box, self.output, "--plot", picture, "--quiet"],
                stderr=subprocess.PIPE,
                env=environment,
                text=True,
            ) as process:
                heard, _, _ = select.select([display_says, process.stderr], [], [])
                self.assertEqual(heard, [display_says])
                drawing = os.open(never, os.O_WRONLY)
                self.addCleanup(os.close, drawing)
                self.assertEqual(len(os.listdir(folder)), 1)
                process.send_signal(number)
                self.assertEqual(process.stderr.read(), f"insideout: {picture}: {words}\n")
                self.assertEqual(process.wait(), status)
                self.assertEqual(os.listdir(folder), [])
                self.assertFalse(os.path.exists(picture))
                ended = select.poll()
                ended.register(drawing, 0)
                self.assertEqual(ended.poll(), [(drawing, select.POLLERR)])  # nobody reads it any more


if __name__ == "__main__":
    unittest.main()
