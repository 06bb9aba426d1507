# SPDX-License-Identifier: GPL-3.0-or-later
"""The subcommands of `insideout`, a module for each."""
