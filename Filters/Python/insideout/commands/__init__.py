# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command `insideout` does: a module for each of its subcommands."""
