# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages: what is in the file, and what a browser makes of it.

    python3 TestPage.py
"""

import base64
import json
import os
import re
import unittest
import zlib

import insideout
import numpy as np
import surfaces
from browser import CHROMIUM, Browser
from command import CommandLine, run_here
from insideout import actors, demo
from insideout.files import write_surface
from insideout.page import outer_faces, relative, rows_by_least

MOST_LINES = 500  # of the viewer
MOST_BESIDE_DATA = 5e6  # bytes


def content_of(path):
    """The page's text, its scene, and the arrays as the viewer unpacks them."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    scene = json.loads(re.search('id="scene">(.*?)</script>', text, re.S)[1])
    content = zlib.decompress(base64.b64decode(re.search('id="data">(.*?)</script>', text, re.S)[1]))
    arrays, begin = {}, 0
    for array in scene["arrays"]:
        kind = {"bytes": np.uint8, "floats": np.float32, "ids": np.uint32}[array["kind"]]
        size = array["rows"] * array["columns"] * np.dtype(kind).itemsize
        columns = np.frombuffer(content, np.uint8, size, begin).reshape(-1, array["rows"])
        rows = np.ascontiguousarray(columns.T).view(kind)
        if array["kind"] == "ids":
            least = np.cumsum(rows[:, :1], axis=0, dtype=np.uint32)
            rows = np.hstack([least, rows[:, 1:] + least])
        arrays[array["name"]] = rows
        begin += size
    assert begin == len(content)
    return text, scene, arrays


def sorted_rows(rows):
    return sorted(map(tuple, rows.tolist()))


class File(CommandLine):
    def page(self, surface, **options):
        result = insideout.tetrahedralize(surface)
        insideout.draw(surface, result.hull, self.path("page.html"), **options)
        return result, *content_of(self.path("page.html"))

    def test_it_holds_what_is_drawn_and_asks_for_nothing_else(self):
        surface = demo.figure()
        result, text, scene, arrays = self.page(surface)
        cells = np.sort(result.hull.cells, axis=1)
        self.assertEqual(sorted_rows(arrays["cells"]), sorted_rows(cells))
        inside = len(arrays["outer"])
        self.assertEqual(sorted_rows(arrays["cells"][:inside]), sorted_rows(cells[result.hull.inside]))
        places = (result.hull.points - scene["center"]) / scene["radius"]
        np.testing.assert_allclose(arrays["points"], places, atol=1e-6)
        order = np.lexsort(cells.T)
        again = np.lexsort(arrays["cells"].T)
        np.testing.assert_allclose(arrays["w"][again, 0] / 85 - 1, result.hull.w[order].clip(-1, 2), atol=0.5 / 85 + 1e-12)
        self.assertNotRegex(text, r"https?:|src=|href=|url\(|@import")
        self.assertIn("default-src 'none'", text)

    def test_facets_keep_their_sides_and_what_they_are(self):
        surface = demo.figure()
        _, _, _, arrays = self.page(surface)
        checked = insideout.check(surface)
        given = surfaces.triangles_of(checked.surface)
        least = given.argmin(axis=1)[:, np.newaxis]
        turned = np.take_along_axis(given, (least + np.arange(3)) % 3, axis=1)
        self.assertEqual(sorted_rows(arrays["surface"]), sorted_rows(turned))
        duplicates = surfaces.cell_array(checked.surface, "Duplicate") > 0
        drawn = arrays["surface"][arrays["kinds"][:, 0] == 3]
        self.assertGreater(len(drawn), 0)
        self.assertEqual(sorted_rows(drawn), sorted_rows(turned[duplicates]))

    def test_outer_faces_are_those_of_one_cell(self):
        cells = np.sort(insideout.tetrahedralize(surfaces.two_boxes()).solid.cells, axis=1)
        for far in (0, 2**21):  # ids too large for one number of three
            found = outer_faces(cells + far)
            faces = [np.delete(cell, k).tolist() for cell in cells for k in range(4)]
            outer = [faces.count(face) == 1 for face in faces]
            self.assertEqual([bool(bits & 1 << k) for bits in found.tolist() for k in range(4)], outer)

    def test_rows_come_back(self):
        rows = np.random.default_rng(3).integers(0, 2**32, (200, 3))
        rows = rows_by_least(rows, np.arange(200) % 2)[0]
        coded = relative(rows)
        least = np.cumsum(coded[:, :1], axis=0, dtype=np.uint32)
        np.testing.assert_array_equal(np.hstack([least, coded[:, 1:] + least]), rows)

    def test_a_refined_solid_is_drawn_in_place_of_the_hull_s_cells(self):
        result = insideout.tetrahedralize(surfaces.two_boxes(), edge_length=0.3, quadratic_cells=True)
        insideout.draw(surfaces.two_boxes(), result.hull, self.path("page.html"), solid=result.solid)
        arrays = content_of(self.path("page.html"))[2]
        self.assertEqual(len(arrays["solid"]), len(result.solid.cells))
        self.assertEqual(sorted_rows(arrays["solid"]), sorted_rows(np.sort(result.solid.cells[:, :4], axis=1)))

    def test_the_report_tells_what_is_wrong_and_what_came_out(self):
        surface = demo.figure()
        result, text, _, _ = self.page(surface, title="<i>figure & co</i>")
        checked = insideout.check(surface)
        for finding in checked.findings:
            self.assertIn(finding.text, text)
            self.assertIn(finding.consequence, text)
        self.assertIn("<title>&lt;i&gt;figure &amp; co&lt;/i&gt;</title>", text)
        self.assertIn(f"{len(result.solid.cells):,} tetrahedra inside", text)

    def test_small_beside_its_data(self):
        self.page(demo.figure())
        text = content_of(self.path("page.html"))[0]
        data = re.search('id="data">(.*?)</script>', text, re.S)[1]
        self.assertLess(len(text.encode()) - len(data), MOST_BESIDE_DATA)
        viewer = os.path.join(os.path.dirname(insideout.__file__), "viewer.js")
        with open(viewer, encoding="utf-8") as file:
            self.assertLessEqual(len(file.readlines()), MOST_LINES)

    def test_the_same_surface_gives_the_same_bytes(self):
        written = []
        for _ in range(2):
            self.page(demo.figure())
            with open(self.path("page.html"), "rb") as file:
                written.append(file.read())
        self.assertEqual(*written)

    def test_the_command_writes_pages_without_a_display(self):
        write_surface(demo.figure(), self.path("figure.ply"))
        display = os.environ.pop("DISPLAY", None)
        path, os.environ["PATH"] = os.environ["PATH"], self.folder  # without xvfb-run
        try:
            figure, target = self.path("figure.ply"), self.path("page.html")
            for arguments in (("draw", figure, target), ("draw", "--defects", figure, target), ("mesh", figure, self.path("solid.vtu"), "--plot", target)):
                done = run_here(*arguments)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("<title>figure.ply</title>", content_of(target)[0])
                os.remove(target)
        finally:
            os.environ["PATH"] = path
            if display is not None:
                os.environ["DISPLAY"] = display

    def test_planar_inputs_have_no_page(self):
        outline = self.file("outline.csv", "x,y\n0,0\n1,0\n1,1\n0,1\n0,0\n")
        target = self.path("page.html")
        self.check_failure(run_here("draw", outline, target), "page.html", "lies in a plane")
        self.check_failure(run_here("draw", outline, target, "--defects"), "page.html", "lies in a plane")
        solid = self.file("cells.mesh", "")
        self.check_failure(run_here("draw", solid, target), "unknown ending, it must be .png")
        self.assertFalse(os.path.exists(target))


@unittest.skipIf(CHROMIUM is None, "chromium is not installed")
class InABrowser(CommandLine):
    """The two boxes: in the middle of the slice w is 2, and 1 near the ends."""

    def setUp(self):
        super().setUp()
        browser = Browser()
        self.browser = browser.__enter__()
        self.addCleanup(browser.__exit__)

    def page_of(self, surface, with_hull=True):
        hull = insideout.tetrahedralize(surface).hull if with_hull else None
        insideout.draw(surface if with_hull else insideout.check(surface), hull, self.path("page.html"))
        return self.path("page.html")

    def slide(self, position, axis=0):
        self.browser.evaluate(
            f"document.querySelector('[name=axis][value=\"{axis}\"]').checked = true;"
            f"document.getElementById('position').value = {position};"
            "document.getElementById('position').dispatchEvent(new Event('input', {bubbles: true}))"
        )
        return self.count("#slice canvas", {w: actors.colours_of_w().GetColor(w) for w in (0, 1, 2)})

    def count(self, element, colours):
        """How many pixels have each color."""
        image = self.browser.pixels(element).astype(int)
        return {name: int((np.abs(image - np.array(colour) * 255).max(axis=2) <= 3).sum()) for name, colour in colours.items()}

    def drawn(self, element):
        return int((self.browser.pixels(element) < 250).any(axis=2).sum())

    def test_it_draws_and_the_slider_moves_the_slice(self):
        self.browser.show(self.page_of(surfaces.two_boxes()))
        for panel in ("surface", "slice", "solid"):
            self.assertGreater(self.drawn(f"#{panel} canvas"), 5000, panel)
        for axis in range(3):
            middle, low, high = (self.slide(position, axis) for position in (0, -0.8, 0.8))
            self.assertGreater(middle[2], 500)
            self.assertGreater(middle[1], 1000)
            for end in (low, high):
                self.assertEqual(end[2], 0)
                self.assertGreater(end[1], 1000)
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.requests(), [f"file://{self.path('page.html')}"])

    def test_the_section_of_a_plane_has_its_area(self):
        """A box of one color; what is drawn of its section is as large as what is drawn of the hull, wherever the plane is."""
        self.browser.show(self.page_of(surfaces.box()))
        sizes = [self.slide(position)[1] for position in (-0.7, -0.1, 0.4, 0.9)]
        self.assertLess(max(sizes) - min(sizes), 0.03 * max(sizes))

    def test_the_solid_is_cut_open_there(self):
        self.browser.show(self.page_of(demo.figure()))
        self.slide(1)
        whole = self.drawn("#solid canvas")
        self.slide(-1)
        cut = self.drawn("#solid canvas")
        self.browser.evaluate("document.getElementById('other').click()")
        self.assertLess(min(cut, self.drawn("#solid canvas")), whole / 4)

    def test_it_turns_zooms_and_comes_back(self):
        self.browser.show(self.page_of(demo.figure()))
        first = self.browser.pixels("#surface canvas")
        x, y = self.browser.evaluate("(b => [b.left + b.width / 2, b.top + b.height / 2])(document.querySelector('#surface canvas').getBoundingClientRect())")
        self.browser.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", clickCount=1)
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 60, y=y + 20, button="left", buttons=1)
        self.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + 60, y=y + 20, button="left", clickCount=1)
        turned = self.browser.pixels("#surface canvas")
        self.assertTrue((turned != first).any())
        before = self.drawn("#solid canvas")
        self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=400)
        self.browser.wait("camera.zoom < 0.6")
        self.assertLess(self.drawn("#solid canvas"), 0.6 * before)
        self.browser.evaluate("document.getElementById('reset').click()")
        np.testing.assert_array_equal(self.browser.pixels("#surface canvas"), first)
        self.assertEqual(self.browser.complaints(), [])

    def test_defects_alone_have_one_panel(self):
        self.browser.show(self.page_of(demo.figure(), with_hull=False))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('canvas').length"), 1)
        found = self.count("#surface canvas", {"open": actors.OPEN, "crossing": actors.CROSSING})
        self.assertGreater(min(found.values()), 50, found)
        self.assertEqual(self.browser.complaints(), [])

    def test_a_place_is_shown_and_a_panel_alone(self):
        self.browser.show(self.page_of(demo.figure()))
        before = self.browser.pixels("#surface canvas")
        self.browser.evaluate("document.querySelector('[data-place]').click()")
        self.assertGreaterEqual(self.browser.evaluate("camera.zoom"), 5)
        self.assertTrue((self.browser.pixels("#surface canvas") != before).any())
        self.browser.evaluate("document.querySelector('#solid .enlarge').click()")
        widths = self.browser.evaluate("[...document.querySelectorAll('canvas')].map(canvas => canvas.clientWidth)")
        self.assertEqual(widths[:2], [0, 0])
        self.assertGreater(widths[2], 1000)

    def test_a_small_window_has_all_of_it(self):
        self.browser.show(self.page_of(demo.figure()), 360, 640)
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 360)
        self.browser.evaluate("document.querySelector('#solid').scrollIntoView()")
        self.assertGreater(self.drawn("#solid canvas"), 5000)
        bottom = self.browser.evaluate("document.getElementById('cut').getBoundingClientRect().bottom")
        self.assertLessEqual(bottom, 640, "the slider stays in sight")

    def test_without_webgl_it_says_so_and_keeps_the_report(self):
        self.browser.call("Page.addScriptToEvaluateOnNewDocument", source="HTMLCanvasElement.prototype.getContext = () => null")
        self.browser.show(self.page_of(demo.figure()), until="document.getElementById('message')?.textContent")
        self.assertIn("no WebGL 2", self.browser.evaluate("document.getElementById('message').textContent"))
        self.assertIn("open edges", self.browser.evaluate("document.getElementById('report').textContent"))


if __name__ == "__main__":
    unittest.main()
