# SPDX-License-Identifier: GPL-3.0-or-later
"""`python3 -m insideout`."""

import signal
import sys

# VTK holds the interpreter while it works, so that Python would hear of Ctrl-C only afterwards:
# leave it to the system, which ends the process at once (status 130 in a shell).
signal.signal(signal.SIGINT, signal.SIG_DFL)

from .command_line import main  # noqa: E402

sys.exit(main())
