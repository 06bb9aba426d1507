# SPDX-License-Identifier: GPL-3.0-or-later
"""The output of --help: a screen for the command and for each of its subcommands; --help-all has the rest."""

from __future__ import annotations

import argparse
import re
import shutil
import textwrap
from .options import flag_of
from .usage import COMMANDS, OTHER_FLAGS, argument_of

INDENT = 27  # columns before an option's description
FEWEST_COLUMNS, MOST_COLUMNS = 2 * INDENT, 100  # narrower terminals break lines themselves

SHORT_FORM = """\
options that stand for a command, without one:
  --check                 as insideout check
  --winding POINTS        as insideout query POINTS; --distance is there, too
  --boolean EXPRESSION    as insideout boolean EXPRESSION
  --together              as insideout mesh --together: one mesh of all surfaces
"""

MORE = """\
more:
  insideout COMMAND --help      its options in one screen
  insideout COMMAND --help-all  what all of them mean, and examples
  insideout --help-all          all of this, for each command
  insideout --version
"""

ENDING = """\
A file called like a command is given as ./check. The exit status is 0 when all
was done, 1 when it was not for some file (one line says why), 2 when arguments
make no sense, 130 after Ctrl-C, 143 after SIGTERM. A file is written whole or
not at all: an earlier one of its name stays until then. A surface at OUTPUT
that another program wrote stays, but for -o and --force; no input is ever
replaced.
"""


def screen() -> str:
    """The list of commands, and how to get more help."""
    width = max(map(len, COMMANDS))
    operands = max(len(command.names()) for command in COMMANDS.values())
    lines = [
        "usage: insideout COMMAND ... [options]",
        "       insideout SURFACE... OUTPUT [options]    short for insideout mesh",
        "",
        "Tetrahedra of the solid that a broken triangle surface means.",
        "",
        "commands:",
        *(f"  {name:{width}} {command.names():{operands}}  {command.gist}" for name, command in COMMANDS.items()),
        "",
        "examples:",
        *("  " + command.examples.splitlines()[0] for name, command in list(COMMANDS.items())[:4] if name != "demo"),
        "",
    ]
    return "\n".join([*lines, SHORT_FORM, MORE, ENDING])


def all_screens() -> str:
    """The list of commands, and the full help of each."""
    return "\n".join([screen(), *(screen_of(name, everything=True) for name in COMMANDS)])


def screen_of(name: str, everything: bool = False) -> str:
    """A command's purpose with its options in brief, or in full."""
    command = COMMANDS[name]
    indent = max(len(operand) for operand, _ in command.operands) + 4
    lines = [f"usage: insideout {name} {command.names()} [options]", "", *textwrap.wrap(command.words, _columns())]
    lines += [line for operand, words in command.operands for line in _beside(f"  {operand}", words, indent)]
    for topic, options in command.by_topic().items():
        told = [option for option in options if everything or not command.first or option in command.first]
        others = " ".join(flag for option in options if option not in told for flag in _flags(option))
        heading = f"{topic} (also {others}):" if others else f"{topic}:"
        lines += [*[""] * everything, *textwrap.wrap(heading, _columns(), subsequent_indent="  ", break_on_hyphens=False)]
        for option in told:
            words = str(argument_of(option)["help"])
            lines += _beside("  " + _spelled(option), words if everything else _gist(words))
    if everything:
        lines += ["", "examples:", *("  " + line for line in command.examples.splitlines())]
    else:
        lines += ["", f"insideout {name} --help-all says more of each, and has examples."]
    return "\n".join(lines) + "\n"


def _spelled(name: str) -> str:
    """An option with its values."""
    argument = argument_of(name)
    choices = "{" + ",".join(map(str, argument.get("choices", ()))) + "}"
    metavar = argument.get("metavar") or ("" if argument.get("action") else choices)
    taken = metavar if isinstance(metavar, str) else " ".join(metavar)
    short = [flag for flag in OTHER_FLAGS.get(name, []) if not flag.startswith("--")]
    return f"{', '.join([*short, *_flags(name)])} {taken}".rstrip()


def _flags(name: str) -> list[str]:
    """An option, and its negation if there is one."""
    is_decision = argument_of(name).get("action") is argparse.BooleanOptionalAction
    return [flag_of(name), *(["--no-" + name] if is_decision else [])]


def _gist(words: str) -> str:
    """The first clause of a description, and the default unless the option is a switch."""
    default = re.search(r"\bDefault (?!off|on|empty)[^\s:;,]+?(?=[.:;,]?(?:\s|$))", words)
    gist = re.split(r"[;:,]|\.(?= |$)", words)[0]
    return (gist if gist[1:2].isupper() or gist.startswith("MiB") else gist[:1].lower() + gist[1:]) + (f"; {default[0].lower()}" if default else "")


def _beside(head: str, words: str, indent: int = INDENT) -> list[str]:
    """A heading with its words, on the next line if it is long."""
    lines = [" " * indent + line for line in textwrap.wrap(words, _columns() - indent, break_on_hyphens=False)]
    if lines and len(head) < indent:
        return [head + lines[0][len(head) :], *lines[1:]]
    return [head, *lines]


def _columns() -> int:
    return max(FEWEST_COLUMNS, min(shutil.get_terminal_size().columns, MOST_COLUMNS))
