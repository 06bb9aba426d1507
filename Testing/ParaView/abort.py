# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by ParaView's window: presses its abort button once in each stage of the first filter that works there.

    STAGES=validating,segmenting paraview --script=abort.py

The button is looked for in what the screen shows and pressed with the mouse. Prints what a
filter was doing then, and the cells that came out; of further runs the cells.
"""

import ctypes
import os
import subprocess
import time

from paraview import servermanager, simple

STAGES = os.environ["STAGES"].split(",")  # where the button is pressed, as filters call them
LINES_OF_STATUS = 40  # pixels at the bottom of the screen

X = ctypes.CDLL("libX11.so.6")
XTEST = ctypes.CDLL("libXtst.so.6")
X.XOpenDisplay.restype = ctypes.c_void_p
DISPLAY = ctypes.c_void_p(X.XOpenDisplay(None))


def screen():
    """Width, height and the bytes (red, green, blue) of each pixel."""
    picture = subprocess.run(["import", "-window", "root", "-depth", "8", "ppm:-"], capture_output=True, check=True).stdout
    magic, size, depth, pixels = picture.split(b"\n", 3)
    assert (magic, depth) == (b"P6", b"255")
    width, height = map(int, size.split())
    return width, height, pixels


def find_button():
    """The middle of what is red in the status bar, as the abort button is when it can be pressed; or None."""
    width, height, pixels = screen()
    red = []
    for i in range(width * (height - LINES_OF_STATUS), width * height):
        r, g, b = pixels[3 * i : 3 * i + 3]
        if r > 160 and g < 90 and b < 90:
            red.append((i % width, i // width))
    return (sum(x for x, _ in red) // len(red), sum(y for _, y in red) // len(red)) if red else None


def click(x, y):
    XTEST.XTestFakeMotionEvent(DISPLAY, -1, x, y, ctypes.c_ulong(0))
    for press in (1, 0):
        XTEST.XTestFakeButtonEvent(DISPLAY, 1, press, ctypes.c_ulong(0))
    X.XSync(DISPLAY, 0)
    time.sleep(0.1)  # for the way to the window


class Watch:
    """One filter's runs, each of which is stopped in the next of some stages."""

    def __init__(self, name, algorithm, stages):
        self.name, self.algorithm, self.stages = name, algorithm, list(stages)
        self.stage = None  # in which the button was pressed in this run
        algorithm.AddObserver("ProgressEvent", self.progress)
        algorithm.AddObserver("EndEvent", self.end)

    def progress(self, algorithm, _event):
        if self.stage is None and self.stages and algorithm.GetProgressText() == self.stages[0]:
            place = find_button()
            if place is not None:  # otherwise it is not drawn yet
                self.stage = self.stages.pop(0)
                click(*place)

    def end(self, algorithm, _event):
        cells = algorithm.GetOutput().GetNumberOfCells()
        if self.stage:
            print(f"{self.name}: pressed while {self.stage}, stopped with {cells} cells", flush=True)
        elif cells > 0:  # VTK asks a stopped filter again and again
            print(f"{self.name}: {cells} cells", flush=True)
        self.stage = None


WATCHES = {}


def watch_filters(*_event):
    for (name, _), proxy in simple.GetSources().items():
        algorithm = proxy.GetClientSideObject()
        if name not in WATCHES and algorithm and algorithm.GetClassName() == "vtkRobustTetrahedralize":
            WATCHES[name] = Watch(name, algorithm, [] if WATCHES else STAGES)


servermanager.ProxyManager().SMProxyManager.AddObserver("RegisterEvent", watch_filters)
