# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress that the command shows: a bar per stage on a terminal, else a line per stage."""

from __future__ import annotations

import time
from typing import Optional, Sequence, TextIO

NAME_WIDTH = 30
BAR_WIDTH = 30


class StageBars:
    """Shows stages as they begin, go on and end.

    On a terminal the stage's bar is redrawn in place; elsewhere, for example in a log, each stage gets one line when it
    is finished. A closed stream does not stop the work.
    """

    def __init__(self, stream: Optional[TextIO]):
        self._stream = stream
        self._redraws = stream is not None and stream.isatty()
        self._stage: Optional[str] = None
        self._begin = 0.0
        self._percent = -1

    def show(self, stage: str, fraction: float) -> None:
        """Report the progress (0 to 1) of a stage. A new stage finishes the previous one."""
        if stage != self._stage:
            self.finish()
            self._stage, self._begin, self._percent = stage, time.monotonic(), -1
        percent = int(100 * min(max(fraction, 0.0), 1.0))
        if self._redraws and percent > self._percent:
            self._percent = percent
            filled = BAR_WIDTH * percent // 100
            bar = "#" * filled + "-" * (BAR_WIDTH - filled)
            self._write(f"\r{stage:{NAME_WIDTH}} [{bar}] {percent:3d} %")

    def finish(self) -> None:
        """The stage shown is finished."""
        if self._stage is not None:
            seconds = f"{time.monotonic() - self._begin:.1f} s"
            start = "\r" if self._redraws else ""
            # As wide as a bar with its percentage, to overwrite all of it.
            self._write(f"{start}{self._stage:{NAME_WIDTH}} {seconds:<{BAR_WIDTH + 8 if self._redraws else 0}}\n")
            self._stage = None

    def abandon(self) -> None:
        """The current stage has failed: keep its bar and end the line."""
        if self._stage is not None and self._redraws:
            self._write("\n")
        self._stage = None

    def show_part(self, stages: Sequence[str], stage: str, fraction_of_all: float) -> None:
        """Report the fraction of a whole of which several stages have equal shares."""
        if stage in stages:  # VTK's own reports at the very start and end name none
            self.show(stage, fraction_of_all * len(stages) - stages.index(stage))

    def _write(self, text: str) -> None:
        if self._stream is not None:
            try:
                self._stream.write(text)
                self._stream.flush()
            except OSError:
                self._stream = None
