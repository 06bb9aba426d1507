# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m insideout`."""

import os
import signal
import sys
import threading
import time

PATIENCE = 0.8
"""Seconds from Ctrl-C in which the work may come to its own end and tell so; then it is ended."""


def end_soon_after_ctrl_c() -> None:
    """See to it that the process ends within a second of Ctrl-C, with status 130, whatever it is doing."""
    heard, signalled = os.pipe()
    os.set_blocking(signalled, False)
    signal.set_wakeup_fd(signalled, warn_on_full_buffer=False)

    def watch() -> None:
        while os.read(heard, 1) != bytes([signal.SIGINT]):
            pass
        time.sleep(PATIENCE)
        os._exit(130)

    threading.Thread(target=watch, daemon=True).start()


if __name__ == "__main__":
    end_soon_after_ctrl_c()
    try:
        from .command_line import main

        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
