# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin in ParaView's window: clicked through under Xvfb, then its state and script replayed without one.

    python3 TestGui.py SURFACE.off FOLDER

leaves screenshots, the state, its script and ParaView's messages in FOLDER.
"""

import os
import shutil
import signal
import subprocess
import sys
import unittest
from pathlib import Path
from xml.sax.saxutils import quoteattr

SURFACE, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
HERE = Path(__file__).resolve().parent
SCREEN = "1500x1100"
PATIENCE = 100  # seconds

FILTERS = "pqClientMainWindow/menubar/menuFilters/pqProxyGroupMenuManager0/"
PANEL = "pqClientMainWindow/propertiesDock/propertiesPanel/"
PROPERTIES = PANEL + "scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel/"
PIPELINE = "pqClientMainWindow/pipelineBrowserDock/pipelineBrowser"

APPLY = (PANEL + "Accept", "activate", "")


def choose(row: str):
    return (PIPELINE, "currentChanged", f"{row}|0")


def add(filter_name: str):
    return (FILTERS + filter_name, "activate", "")


USUAL_PATH = [
    ("pqClientMainWindow/menubar/menu_File/actionFileOpen", "activate", ""),
    ("pqClientMainWindow/FileOpenDialog", "filesSelected", str(SURFACE)),
    APPLY,
    add("SurfaceDefects"),
    APPLY,
    choose("/0/0"),
    add("RobustTetrahedralize"),
    (PROPERTIES + "Gamma/DoubleLineEdit0", "set_string", "0.5"),
    (PROPERTIES + "ExtractInside/CheckBox", "set_boolean", "false"),
    APPLY,
    add("SliceWindingNumber"),
    APPLY,
    choose("/0/0"),
    add("GeneralizedWindingNumber"),
    APPLY,
    add("GraphCutSegmentation"),
    APPLY,
    choose("/0/0"),
    add("ResolveSelfIntersections"),
    APPLY,
    add("ConstrainedDelaunay3D"),
    APPLY,
]

class Window:
    """Runs ParaView on a display of its own and takes a picture of it every second."""

    def __init__(self, name: str, *options: str, events=()):
        home = FOLDER / "home"
        home.mkdir(mode=0o700, exist_ok=True)
        script = FOLDER / f"{name}.xml"
        lines = [
            f"<pqevent object={quoteattr(thing)} command={quoteattr(command)} arguments={quoteattr(arguments)} />"
            for thing, command, arguments in events
        ]
        script.write_text("\n".join(["<pqevents>", *lines, "</pqevents>"]), encoding="utf-8")
        command = ["paraview", "-qwindowgeometry", SCREEN + "+0+0", "--dr", *options]
        command += [f"--test-directory={FOLDER}", f"--test-script={script}", "--exit"]
        pictures = (
            f'(k=10; while sleep 1; do k=$((k+1)); import -window root "{FOLDER}/{name}-$k.png"; done) & shots=$!; '
            '"$@"; status=$?; kill $shots; exit $status'
        )
        with subprocess.Popen(
            ["xvfb-run", "-a", "-s", f"-screen 0 {SCREEN}x24", "sh", "-c", pictures, "sh", *command],
            env={**os.environ, "HOME": str(home), "XDG_RUNTIME_DIR": str(home)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            start_new_session=True,
        ) as process:
            try:
                self.messages, _ = process.communicate(timeout=PATIENCE)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)  # the display and all that is on it
                self.messages, _ = process.communicate()
        self.status = process.returncode
        (FOLDER / f"{name}.log").write_text(self.messages, encoding="utf-8")

    def complaints(self) -> list[str]:
        words = ("critical:", "error", "Traceback", "ERR|", "fatal:", "warning:")
        return [line for line in self.messages.splitlines() if any(word in line for word in words)]


def replay(*arguments: str) -> str:
    done = subprocess.run(
        ["xvfb-run", "-a", "pvbatch", str(HERE / "replay.py"), *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60, check=False,
    )
    return done.stdout


class TestGui(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.state, cls.script = FOLDER / "clicked.pvsm", FOLDER / "clicked.py"
        save = [
            ("pqClientMainWindow/menubar/menu_File/actionFileSaveServerState", "activate", ""),
            ("pqClientMainWindow/FileSaveServerStateDialog", "filesSelected", str(cls.state)),
        ]
        cls.window = Window("clicked", events=[*USUAL_PATH, *save])

    def test_1_all_that_is_clicked_works(self):
        self.assertEqual((self.window.status, self.window.complaints()), (0, []), self.window.messages)
        self.assertTrue(list(FOLDER.glob("clicked-*.png")))

    def test_2_the_state_gives_the_same_without_a_window(self):
        self.assertIn("inside 1.75, hull 2, gamma 0.5", replay(str(self.state), str(self.script)))

    def test_3_the_script_of_the_state_gives_the_same(self):
        self.assertIn("inside 1.75, hull 2, gamma 0.5", replay(str(self.script)))

    def test_4_the_state_loads_in_the_window(self):
        window = Window("loaded", f"--state={self.state}")
        self.assertEqual((window.status, window.complaints()), (0, []), window.messages)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
