# SPDX-License-Identifier: GPL-3.0-or-later
"""End the command within a second of Ctrl-C or SIGTERM, with one line that names the file, and without leftover files.
"""

from __future__ import annotations

import os
import signal
import threading
import time
from contextlib import contextmanager
from types import FrameType
from typing import Callable, Iterator, Optional

PATIENCE = 0.8
"""Seconds after the signal in which the work may end by itself with its message; then it is ended."""

PATIENCE_TO_CLEAN_UP = 0.1
"""Further seconds to remove leftover files, which may be on a file system that no longer responds."""

WORDS = {signal.SIGINT: "interrupted", signal.SIGTERM: "terminated"}


class Terminated(KeyboardInterrupt):
    """The exception of SIGTERM, after a call of `end_soon_after_signals`."""


class _Command:
    """the command's current work"""

    file: Optional[str] = None
    told = False
    clean_ups: list[Callable[[], object]] = []


def work_on(file: str) -> None:
    """Set the file that is named when a signal ends the work."""
    _Command.file = file


def message(interrupt: KeyboardInterrupt) -> str:
    """The message of an interruption; `told` says that it was printed."""
    return _message(_signal_of(interrupt))


def told() -> None:
    """The user was told why the program ends."""
    _Command.told = True


def exit_status(interrupt: KeyboardInterrupt) -> int:
    """The exit status that a shell reports for a program ended by this signal."""
    return 128 + _signal_of(interrupt)


@contextmanager
def cleaning_up(clean_up: Callable[[], object]) -> Iterator[None]:
    """Call this function at the end, also if the process ends at once."""
    before_end_at_once(clean_up)
    try:
        yield
    finally:
        _Command.clean_ups.remove(clean_up)
        clean_up()


@contextmanager
def deferring_signals() -> Iterator[None]:
    """Delay the exception of a signal to the end of the block, so that nothing begun in it is lost. Programs that are
    started in it do not inherit this.
    """
    if threading.current_thread() is not threading.main_thread():
        yield  # only the main thread is interrupted, and only it can delay that
        return
    heard: list[int] = []
    handlers = {number: handler for number in WORDS if callable(handler := signal.getsignal(number))}
    for number in handlers:
        signal.signal(number, lambda number, _frame: heard.append(number))
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
        for first in heard[:1]:
            signal.raise_signal(first)


def before_end_at_once(clean_up: Callable[[], object]) -> None:
    """Call this function if the process does not end by itself in time."""
    _Command.clean_ups.append(clean_up)


def end_soon_after_signals() -> None:
    """Make the process end within a second of Ctrl-C or SIGTERM in any state."""
    signal.signal(signal.SIGTERM, _terminate)
    heard, signalled = os.pipe()
    os.set_blocking(signalled, False)
    signal.set_wakeup_fd(signalled, warn_on_full_buffer=False)

    def watch() -> None:
        number = 0
        while number not in WORDS:
            number = os.read(heard, 1)[0]
        time.sleep(PATIENCE)
        _end_at_once(number)

    threading.Thread(target=watch, daemon=True).start()


def _terminate(_signal: int, _frame: Optional[FrameType]) -> None:
    raise Terminated


def _end_at_once(number: int) -> None:
    if not _Command.told:
        try:
            os.write(2, f"insideout: {_message(number)}\n".encode(errors="backslashreplace"))
        except OSError:
            pass  # the exit status reports it
    cleaner = threading.Thread(target=_clean_up, daemon=True)
    cleaner.start()
    cleaner.join(PATIENCE_TO_CLEAN_UP)
    os._exit(128 + number)


def _clean_up() -> None:
    for clean_up in reversed(_Command.clean_ups):
        try:
            clean_up()
        except OSError:
            pass  # the other functions must still be called


def _signal_of(interrupt: KeyboardInterrupt) -> int:
    return signal.SIGTERM if isinstance(interrupt, Terminated) else signal.SIGINT


def _message(number: int) -> str:
    words = WORDS[signal.Signals(number)]
    return words if _Command.file is None else f"{_Command.file}: {words}"
