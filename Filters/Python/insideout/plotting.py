# SPDX-License-Identifier: GPL-3.0-or-later
"""Show a picture: in a notebook, or in a window of a separate process."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any, Optional

from .files import temporary_folder
from .pipeline import Error


class Picture:
    """The content of a .png file, which a notebook shows."""

    def __init__(self, content: bytes):
        self.content = content

    def _repr_png_(self) -> bytes:
        return self.content


def plot(content: bytes, title: str) -> None:
    """Show the content of a .png file. Raises `Error` where there is no notebook and no window."""
    notebook = _notebook()
    if notebook is not None:
        notebook.display(Picture(content))
        return
    if not os.environ.get("DISPLAY"):
        raise Error("there is no notebook and no window to plot in: write the bytes of png() into a file")
    with temporary_folder() as folder:
        file = os.path.join(folder, "picture.png")
        with open(file, "wb") as opened:
            opened.write(content)
        done = subprocess.run([sys.executable, "-m", "insideout.window", file, title], stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise Error(f"the window cannot be shown: {(done.stderr.strip().splitlines() or ['it was ended'])[-1]}")


def _notebook() -> Optional[Any]:
    """IPython's display functions in a notebook; None elsewhere, for a terminal shows no pictures."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from IPython import display

    return display
