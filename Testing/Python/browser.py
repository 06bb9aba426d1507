# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, driven by its DevTools protocol through a pipe: no package beside it is needed."""

from __future__ import annotations

import base64
import json
import os
import shutil
import signal
import subprocess
import tempfile
from typing import Any, Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

CHROMIUM = shutil.which("chromium")

_FLAGS = (
    *("--headless=new", "--no-sandbox", "--no-first-run", "--disable-background-networking", "--disable-component-update"),
    *("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--remote-debugging-pipe"),
)
_MOST_FRAMES = 20_000  # that a condition may take; pages under test are done within a few

_COMPLAINTS = ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")


class Browser:
    """One page in a browser, which is ended with the context."""

    def __enter__(self) -> Browser:
        self._folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)  # its processes end when they like
        (to_read, self._to), (self._from, from_write) = os.pipe(), os.pipe()
        # It reads from 3 and writes to 4.
        command = ["sh", "-c", f'exec "$@" 3<&{to_read} 4>&{from_write}', "sh", CHROMIUM or "chromium"]
        self._process = subprocess.Popen(
            [*command, *_FLAGS, f"--user-data-dir={self._folder.name}", "about:blank"],
            pass_fds=(to_read, from_write),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        os.close(to_read)
        os.close(from_write)
        self._number, self._received, self._session = 0, b"", None
        self.events: list[dict[str, Any]] = []
        pages: list[dict[str, Any]] = []
        while not pages:
            pages = [target for target in self.call("Target.getTargets")["targetInfos"] if target["type"] == "page"]
        self._session = self.call("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        return self

    def __exit__(self, *_: object) -> None:
        os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        os.close(self._to)
        os.close(self._from)
        self._folder.cleanup()

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if self._session is not None:
            message["sessionId"] = self._session
        os.write(self._to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._read()
            if answer.get("id") == self._number:
                assert "error" not in answer, answer
                return answer["result"]
            self.events.append(answer)

    def _read(self) -> dict[str, Any]:
        while b"\0" not in self._received:
            some = os.read(self._from, 1 << 20)
            assert some, "the browser ended"
            self._received += some
        message, self._received = self._received.split(b"\0", 1)
        return json.loads(message)

    def show(self, path: str, width: int = 1200, height: int = 800, until: str = "document.body.dataset.drawn") -> None:
        """Open a file in a window of this size, and wait until a condition holds."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.events.clear()
        self.call("Page.navigate", url=f"file://{path}")
        self.wait(f"document.body && ({until})")

    def wait(self, condition: str) -> None:
        """Draw frame by frame until a condition holds."""
        for _ in range(_MOST_FRAMES):
            if self.evaluate(condition):
                return
            self.evaluate("new Promise(done => requestAnimationFrame(() => done(1)))")
        raise AssertionError(f"never: {condition}")

    def evaluate(self, expression: str) -> Any:
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def complaints(self) -> list[Any]:
        """All that came to the console."""
        self.evaluate("0")
        return [event["params"] for event in self.events if event["method"] in _COMPLAINTS]

    def requests(self) -> list[str]:
        self.evaluate("0")
        return [event["params"]["request"]["url"] for event in self.events if event["method"] == "Network.requestWillBeSent"]

    def pixels(self, element: Optional[str] = None) -> np.ndarray:
        """Red, green and blue of the window's part that an element takes, row by row from above."""
        # The requested drawing is done in the frame before the second one.
        self.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))")
        content = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            file.write(content)
            file.flush()
            reader = vtkPNGReader()
            reader.SetFileName(file.name)
            reader.Update()
        columns, rows, _ = reader.GetOutput().GetDimensions()
        image = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1, :, :3]
        if element is None:
            return image
        box = f"document.querySelector('{element}').getBoundingClientRect()"
        left, top, right, bottom = self.evaluate(f"(b => [b.left, b.top, b.right, b.bottom].map(Math.round))({box})")
        return image[top:bottom, left:right]
