# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m insideout`."""

import sys

from . import interruption


def is_short_of_memory(error: Exception) -> bool:
    """Whether the error is an interruption or a failed import of Python or a library."""
    words = ("failed to map segment", "annot allocate memory", "can't start new thread")
    return isinstance(error, MemoryError) or any(part in str(error) for part in words)


def run() -> int:
    """Returns the exit status."""
    try:
        interruption.end_soon_after_signals()
        from .command_line import main
    except Exception as error:
        if not is_short_of_memory(error):
            raise
        sys.stderr.write("insideout: not enough memory to begin\n")
        return 1
    return main()


def command() -> int:
    """Returns the exit status, also after an interruption."""
    try:
        return run()
    except KeyboardInterrupt as interrupt:
        print(f"insideout: {interruption.message(interrupt)}", file=sys.stderr)
        interruption.told()
        return interruption.exit_status(interrupt)


if __name__ == "__main__":
    sys.exit(command())
