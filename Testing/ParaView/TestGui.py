# SPDX-License-Identifier: GPL-3.0-or-later
"""The plugin in ParaView's window: clicked through under Xvfb, then its state and script replayed without one.

    python3 TestGui.py SURFACE.off FOLDER

leaves screenshots, the state, its script and ParaView's messages in FOLDER.
"""

import itertools
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import unittest
import xml.etree.ElementTree
from pathlib import Path
from xml.sax.saxutils import quoteattr

from insideout.actors import colours_of_w

SURFACE, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
HERE = Path(__file__).resolve().parent
SCREEN = "1900x1100"
PATIENCE = 600  # seconds, for what hangs

MENUS = "pqClientMainWindow/menubar/"
FILTERS = MENUS + "menuFilters/pqProxyGroupMenuManager0/"
TOOLBAR = "pqClientMainWindow/Inside Out/1QToolButton"  # and which of those that are shown
PANEL = "pqClientMainWindow/propertiesDock/propertiesPanel/"
PROPERTIES = PANEL + "scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel/"
PIPELINE = "pqClientMainWindow/pipelineBrowserDock/pipelineBrowser"
INFORMATION = (
    "pqClientMainWindow/informationDock/informationWidgetFrame/informationScrollArea/qt_scrollarea_viewport/"
    "informationWidget/"
)
EDITOR = "pqClientMainWindow/0pqPythonScriptEditor0/"


def do(thing: str, command: str = "activate", arguments: str = "") -> str:
    """What ParaView's player of events takes."""
    return f"<pqevent object={quoteattr(thing)} command={quoteattr(command)} arguments={quoteattr(arguments)} />"


def check(thing: str, what: str, expected: str) -> str:
    """The player ends with an error when it is something else."""
    return f"<pqcheck object={quoteattr(thing)} property={quoteattr(what)} arguments={quoteattr(expected)} />"


APPLY = do(PANEL + "Accept")


def choose(row: str) -> str:
    return do(PIPELINE, "currentChanged", f"{row}|0")


def add(filter_name: str) -> str:
    return do(FILTERS + filter_name)


def open_file(path: Path) -> list[str]:
    return [
        do(MENUS + "menu_File/actionFileOpen"),
        do("pqClientMainWindow/FileOpenDialog", "filesSelected", str(path)),
        APPLY,
    ]


def save_state(path: Path) -> list[str]:
    return [
        do(MENUS + "menu_File/actionFileSaveServerState"),
        do("pqClientMainWindow/FileSaveServerStateDialog", "filesSelected", str(path)),
    ]


def color_by(array: str) -> str:
    return do("pqClientMainWindow/variableToolbar/displayColor/Variables", "set_string", array)


SMOOTH_LESS = do(PROPERTIES + "Gamma/DoubleLineEdit0", "set_string", "0.5")
ADVANCED = do(PANEL + "SearchBox/AdvancedButton", "set_boolean", "true")
HULL_TOO = do(PROPERTIES + "GenerateHull/CheckBox", "set_boolean", "true")

USUAL_PATH = [
    *open_file(SURFACE),
    add("SurfaceDefects"),
    APPLY,
    choose("/0/0"),
    add("RobustTetrahedralize"),
    SMOOTH_LESS,
    ADVANCED,
    HULL_TOO,
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

WITH_EDGES = "Surface With Edges"

NUMBERS = r"^(\S+): (\d+ points, .*)$"  # as pipeline_numbers.py prints them

STAGES = [
    "validating",
    "finding self-intersections",
    "resolving self-intersections",
    "tetrahedralizing",
    "winding numbers",
    "segmenting",
    "extracting",
]


def write_spheres(path: Path, rings: int) -> None:
    """Three spheres that cross each other and are open at a pole: of 70 rings, seconds of work."""
    points, triangles = [], []
    for k, centre in enumerate([(0.01, 0.02, 0.03), (0.9, 0.1, 0.2), (0.3, 0.8, 0.1)]):
        first = len(points)
        for i, j in itertools.product(range(3, rings), range(2 * rings)):
            polar, around = math.pi * i / rings, math.pi * j / rings
            normal = (math.sin(polar) * math.cos(around), math.sin(polar) * math.sin(around), math.cos(polar))
            points.append([c + (1 + 0.03 * k) * n for c, n in zip(centre, normal)])
        for i, j in itertools.product(range(rings - 4), range(2 * rings)):
            a, b = (first + 2 * rings * i + (j + next_one) % (2 * rings) for next_one in (0, 1))
            triangles += [(a, a + 2 * rings, b), (b, a + 2 * rings, b + 2 * rings)]
    lines = [f"OFF\n{len(points)} {len(triangles)} 0", *(f"{x!r} {y!r} {z!r}" for x, y, z in points)]
    path.write_text("\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in triangles]) + "\n", encoding="ascii")


def write_box_and_sheet(path: Path) -> None:
    """A box without a lid, and beside it a square, which encloses nothing."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    square = [(2, 0, 0.25), (3, 0, 0.25), (3, 1, 0.75), (2, 1, 0.75)]
    faces = [(0, 2, 3, 1), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6), (8, 9, 10, 11)]
    lines = [f"OFF\n12 {len(faces)} 0", *(f"{x} {y} {z}" for x, y, z in corners + square)]
    path.write_text("\n".join(lines + ["4 {} {} {} {}".format(*face) for face in faces]) + "\n", encoding="ascii")


class State:
    """What a state file says of how things look."""

    def __init__(self, path: Path):
        self.root = xml.etree.ElementTree.parse(path).getroot().find("ServerManagerState")
        self.names = {item.get("id"): item.get("name") for item in self.root.iterfind("ProxyCollection/Item")}

    def proxies(self, group: str):
        return self.root.iterfind(f"Proxy[@group='{group}']")

    @staticmethod
    def values(proxy, name: str) -> list[str]:
        return [element.get("value") for element in proxy.iterfind(f"Property[@name='{name}']/Element")]

    def looks(self) -> dict[tuple[str, int], tuple[str, str, str]]:
        """For each shown object, by name and port: its representation, array and color."""
        found = {}
        for proxy in self.proxies("representations"):
            source = proxy.find("Property[@name='Input']/Proxy")
            if source is not None and self.values(proxy, "Visibility") == ["1"]:
                representation = self.values(proxy, "Representation")[0]
                array = self.values(proxy, "ColorArrayName")[4]
                color = " ".join(self.values(proxy, "DiffuseColor"))
                place = (self.names[source.get("value")], int(source.get("output_port")))
                found[place] = (representation, array, color)
        return found

    def legends(self) -> int:
        """The number of legends that are shown."""
        bars = [one for one in self.proxies("representations") if one.get("type") == "ScalarBarWidgetRepresentation"]
        return sum(self.values(bar, "Visibility") == ["1"] for bar in bars)

    def named(self, group: str, name: str):
        return next(proxy for proxy in self.proxies(group) if self.names[proxy.get("id")] == name)

    def colors_of_w(self) -> list[float]:
        return [float(value) for value in self.values(self.named("lookup_tables", "w.PVLookupTable"), "RGBPoints")]

    def normal_of(self, slice_name: str) -> list[str]:
        plane = self.named("filters", slice_name).find("Property[@name='CutFunction']/Proxy").get("value")
        return self.values(self.root.find(f"Proxy[@id='{plane}']"), "Normal")


def colors_of_pictures() -> list[float]:
    """Those of w in the Python package's pictures: w, red, green, blue and so on."""
    colors, node = colours_of_w(), [0.0] * 6
    found = []
    for i in range(colors.GetSize()):
        colors.GetNodeValue(i, node)
        found += node[:4]
    return found


COLORS_OF_W = colors_of_pictures()


# Two that look for a free display at once may take the same one, and the second is then without: other tests look
# from 99 on. A display that starts anew when its last client goes would turn away pvbatch, which comes, goes and
# comes again.
ON_A_DISPLAY, TRIES = ["xvfb-run", "-n", "150", "-a", "-s", f"-noreset -screen 0 {SCREEN}x24"], 3


def lost_display(messages: str) -> bool:
    signs = ("bad X server connection", "could not connect to display", "Xvfb failed to start")
    return any(sign in messages for sign in signs)


class Window:
    """Runs ParaView on a display of its own and takes a picture of it every second."""

    def __init__(self, name: str, *options: str, events=()):
        home = FOLDER / "home"
        home.mkdir(mode=0o700, exist_ok=True)
        script = FOLDER / f"{name}.xml"
        script.write_text("\n".join(["<pqevents>", *events, "</pqevents>"]), encoding="utf-8")
        command = ["paraview", "-qwindowgeometry", SCREEN + "+0+0", "--dr", *options]
        command += [f"--test-directory={FOLDER}", f"--test-script={script}", "--exit"]
        pictures = (
            f'(k=10; while sleep 1; do k=$((k+1)); import -window root "{FOLDER}/{name}-$k.png" 2>/dev/null; done) & shots=$!; '
            '"$@"; status=$?; kill $shots; exit $status'
        )
        for _ in range(TRIES):
            self.play([*ON_A_DISPLAY, "sh", "-c", pictures, "sh", *command], home)
            if not lost_display(self.messages):
                break
        (FOLDER / f"{name}.log").write_text(self.messages, encoding="utf-8")

    def play(self, command: list[str], home: Path):
        with subprocess.Popen(
            command,
            env={**os.environ, "STAGES": ",".join(STAGES), "HOME": str(home), "XDG_RUNTIME_DIR": str(home)},
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

    def complaints(self) -> list[str]:
        words = ("critical:", "error", "Traceback", "ERR|", "fatal:", "warning:")
        return [line for line in self.messages.splitlines() if any(word in line for word in words)]


def run_in_batch(script: str, *arguments: str) -> str:
    for _ in range(TRIES):
        done = subprocess.run(
            [*ON_A_DISPLAY, "pvbatch", script, *arguments],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=PATIENCE, check=False,
        )
        if not lost_display(done.stdout):
            break
    return done.stdout


def replay(*arguments: str) -> str:
    return run_in_batch(str(HERE / "replay.py"), *arguments)


class TestGui(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.state, cls.script = FOLDER / "clicked.pvsm", FOLDER / "clicked.py"
        cls.window = Window("clicked", events=[*USUAL_PATH, *save_state(cls.state)])

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

    def test_5_the_abort_button_stops_every_stage_and_apply_runs_it_again(self):
        surface = FOLDER / "spheres.off"
        write_spheres(surface, rings=70)
        window = Window(
            "aborted",
            f"--script={HERE / 'abort.py'}",
            events=[
                *open_file(surface),
                add("RobustTetrahedralize"),
                *[APPLY, *save_state(FOLDER / "stopped.pvsm")],
                *[APPLY] * len(STAGES),
                *save_state(FOLDER / "at-last.pvsm"),
                choose("/0/0"),
                add("RobustTetrahedralize"),
                APPLY,
                *save_state(FOLDER / "never-stopped.pvsm"),
            ],
        )
        self.assertEqual(window.status, 0, window.messages)
        pressed = re.findall(
            r"^RobustTetrahedralize1: pressed while (.*), stopped with 0 cells$", window.messages, re.M
        )
        self.assertEqual(pressed, STAGES, window.messages)
        said = "RobustTetrahedralize1 was stopped and has no output. Apply runs it again."
        self.assertEqual(window.messages.count(said), len(STAGES), window.messages)
        wholes = re.findall(r"^RobustTetrahedralize(\d): (\d+) cells$", window.messages, re.M)
        self.assertEqual([name for name, _ in wholes], ["1", "2"], "each whole once")
        self.assertEqual(wholes[0][1], wholes[1][1], "as if it had never been stopped")
        self.assertIn((surface.name, 0), State(FOLDER / "stopped.pvsm").looks(), "the input again")
        (first,), (second,) = (State(FOLDER / f"{name}.pvsm").looks().items() for name in ("at-last", "never-stopped"))
        self.assertEqual((first[0], second[0]), (("RobustTetrahedralize1", 0), ("RobustTetrahedralize2", 0)))
        self.assertEqual(first[1], second[1], "shown as if it had never been stopped")
        self.assertEqual(first[1][0], "Surface", "without edges, which would cover the faces")

    def test_6_the_information_panel_tells_the_statistics(self):
        arrays = INFORMATION + "dataArraysTable"
        events = [
            *open_file(SURFACE),
            add("RobustTetrahedralize"),
            APPLY,
            do("pqClientMainWindow/1QTabBar1", "set_tab_with_text", "Information"),
            check(arrays, "modelItemData", "10.0,Statistics"),
            check(arrays, "modelItemData", "11.0,StatisticsNames"),
        ]
        window = Window("information", events=events)
        self.assertEqual((window.status, window.complaints()), (0, []), window.messages)

    def test_7_a_trace_of_clicks_gives_the_same_in_pvbatch(self):
        trace, script = FOLDER / "traced.py", str(HERE / "pipeline_numbers.py")
        start_or_stop = do(MENUS + "menuTools/actionToolsStartStopTrace")
        events = [
            start_or_stop,
            do("TraceOptionsDialog/widget/OKButton"),
            *open_file(SURFACE),
            do(TOOLBAR + "0"),
            APPLY,
            choose("/0/0"),
            do(TOOLBAR + "1"),
            SMOOTH_LESS,
            APPLY,
            do(TOOLBAR + "2"),
            APPLY,
            start_or_stop,
            do(EDITOR + "PythonScriptEditorMenuBar/File", "activate", "Save &As..."),
            do(EDITOR + "FileOpenDialog", "filesSelected", str(trace)),
        ]
        window = Window("traced", f"--script={script}", events=events)
        self.assertEqual((window.status, window.complaints()), (0, []), window.messages)
        self.assertIn(".Gamma = 0.5", trace.read_text(encoding="utf-8"))
        replayed = run_in_batch(script, str(trace))
        seen = dict(re.findall(NUMBERS, window.messages, re.M))  # of each thing what was seen last
        self.assertEqual(dict(re.findall(NUMBERS, replayed, re.M)), seen, replayed)
        self.assertEqual(
            sorted(seen), ["RobustTetrahedralize1", "SliceWindingNumber1", "SurfaceDefects1", SURFACE.name]
        )

    def test_8_the_toolbar_has_the_usual_path_and_no_more(self):
        window = Window("toolbar", events=[*open_file(SURFACE), do(TOOLBAR + "2"), do(TOOLBAR + "3")])
        self.assertIn(f"Couldn't find object  `{TOOLBAR}3`", window.messages)
        self.assertNotIn(f"Couldn't find object  `{TOOLBAR}2`", window.messages)

    def play(self, name: str, *events: str, options=()):
        window = Window(name, *options, events=events)
        self.assertEqual((window.status, window.complaints()), (0, []), window.messages)

    def test_9_a_solid_looks_like_one_after_apply_and_then_as_the_user_likes(self):
        first, later, loaded = (FOLDER / f"{name}.pvsm" for name in ("first", "later", "loaded"))
        solid = ("RobustTetrahedralize1", 0)
        self.play(
            "solid",
            *[*open_file(SURFACE), add("RobustTetrahedralize"), APPLY, *save_state(first)],
            *[color_by("w"), SMOOTH_LESS, APPLY, *save_state(later)],
        )
        self.assertEqual(State(first).looks(), {solid: (WITH_EDGES, "", "1 1 1")})
        self.assertEqual(State(later).looks(), {solid: (WITH_EDGES, "w", "1 1 1")})
        self.assertEqual(State(later).colors_of_w(), COLORS_OF_W)
        self.play("solid-loaded", *save_state(loaded), options=[f"--state={later}"])
        self.assertEqual(State(loaded).looks(), State(later).looks())

    def test_10_outliers_are_red_after_apply(self):
        surface, state = FOLDER / "outliers.off", FOLDER / "outliers.pvsm"
        write_box_and_sheet(surface)
        self.play("outliers", *open_file(surface), add("RobustTetrahedralize"), APPLY, *save_state(state))
        solid, outliers = ("RobustTetrahedralize1", 0), ("RobustTetrahedralize1", 2)
        red = "0.9 0.2 0.15"
        self.assertEqual(
            State(state).looks(), {solid: (WITH_EDGES, "", "1 1 1"), outliers: ("Surface", "", red)}
        )

    def test_11_slices_face_the_camera_in_colors_with_a_meaning(self):
        state = State(self.state)
        self.assertEqual(state.looks()["SliceWindingNumber1", 0][:2], ("Surface", "w"))
        self.assertEqual(state.normal_of("SliceWindingNumber1"), ["0", "0", "1"])
        self.assertEqual(state.colors_of_w(), COLORS_OF_W)

    def test_12_first_pictures_show_what_a_filter_adds_and_nothing_that_covers_it(self):
        solid, quality = FOLDER / "covered.pvsm", FOLDER / "quality.pvsm"
        self.play(
            "pictures",
            *[*open_file(SURFACE), add("SurfaceDefects"), APPLY, choose("/0/0"), add("RobustTetrahedralize"), APPLY],
            *[*save_state(solid), add("SolidQuality"), APPLY, *save_state(quality)],
        )
        self.assertEqual(State(solid).looks(), {("RobustTetrahedralize1", 0): (WITH_EDGES, "", "1 1 1")})
        looks = State(quality).looks()
        self.assertEqual(looks["SolidQuality1", 0][:2], (WITH_EDGES, "MinDihedralAngle"))
        self.assertEqual(State(quality).legends(), 1, "none of w, by which nothing is colored")

    def test_13_a_slice_of_a_solid_takes_its_hull(self):
        state = FOLDER / "slice.pvsm"
        self.play("slice", *open_file(SURFACE), add("RobustTetrahedralize"), APPLY, add("SliceWindingNumber"), APPLY, *save_state(state))
        saved = State(state)
        self.assertEqual(saved.values(saved.named("filters", "RobustTetrahedralize1"), "GenerateHull"), ["1"])
        taken = saved.named("filters", "SliceWindingNumber1").find("Property[@name='Input']/Proxy")
        self.assertEqual(taken.get("output_port"), "3")

    def test_14_what_is_out_of_range_is_told_and_by_which_filter(self):
        too_smooth = do(PROPERTIES + "Gamma/DoubleLineEdit0", "set_string", "-3")
        window = Window("told", events=[*open_file(SURFACE), add("RobustTetrahedralize"), too_smooth, APPLY])
        self.assertEqual(window.status, 0, window.messages)
        # The window shows what stands behind the first colon.
        told = re.findall(r"WARN\|[^:]*: ([^\x1b\n]*)", window.messages)
        self.assertEqual(told, ["Robust Tetrahedralize: Gamma is -3, but must be at least 0: it is taken as 0"])

    def test_15_the_panel_tells_in_six_lines_what_was_wrong_and_what_came_out(self):
        surface = FOLDER / "told.off"
        write_box_and_sheet(surface)
        lines = ("Input Triangles 12, Components 2", "Intersecting Pairs 0", "Open Edges 8, Holed Shells 1",
                 "Inside Cells 6, Regions 1", "Outlier Facets 2", "bounds a solid of volume 1, once its holes are closed; a sheet encloses nothing")
        told = check(PROPERTIES + "ShownSummary/Text", "text", "\n".join(lines))
        window = Window("summary", events=[*open_file(surface), add("RobustTetrahedralize"), APPLY, told])
        self.assertEqual(window.status, 0, window.messages)

    def test_16_colors_of_defects_are_shown_as_they_are_without_a_legend(self):
        other, own = FOLDER / "other.pvsm", FOLDER / "own.pvsm"
        surface = do("pqClientMainWindow/representationToolbar/displayRepresentation/comboBox", "set_string", "Surface")
        self.play(
            "defect-colors",
            *[*open_file(SURFACE), add("SurfaceDefects"), APPLY, surface, color_by("ComponentId"), *save_state(other)],
            *[color_by("DefectColor"), *save_state(own)],
        )
        first = ("SurfaceDefects1", 0)
        self.assertEqual((State(other).looks()[first][:2], State(other).legends()), (("Surface", "ComponentId"), 1))
        self.assertEqual((State(own).looks()[first][:2], State(own).legends()), (("Defect Colors", "DefectColor"), 0))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
