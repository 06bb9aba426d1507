# SPDX-License-Identifier: GPL-3.0-or-later
"""The arguments of the command `insideout`, and the files that they name."""

from __future__ import annotations

import argparse
import os
import sys
from dataclasses import dataclass, fields
from functools import partial
from typing import Any, Callable, Iterable, NoReturn, Optional, Sequence

from .files import GZIP, READABLE_SOLIDS, STANDARD_INPUT, ending, identity
from .help import all_screens, screen, screen_of
from .lengths import scale_between
from .matters import WHY_NOT, refusal
from .options import flag_of
from .solid_files import WRITABLE_GRIDS
from .usage import BEFORE_FILES, COMMANDS, DECK_OPTIONS, DEMO_FOLDER, OTHER_FLAGS, argument_of
from .version import __version__

USAGE_ERROR = 2
"""The exit status for invalid arguments."""

_NOT_GIVEN: dict[str, Any] = dict.fromkeys(
    (
        *("files", "expression", "points", "distance", "sizes", "output", "hull", "boundary", "outliers", "plot", "marked", "report"),
        *("msh_version", "cells_only", "format", "together", "timeout", "threads", "quiet", "json", "check", "defects", "force", "is_output_told"),
        *("dry_run", "from", "to", *DECK_OPTIONS),
    )
)
"""Values that jobs read, whether or not the command has the option."""


@dataclass(frozen=True)
class Files:
    """The files that belong to one surface, or to one solid that is checked."""

    surface: str
    others: tuple[str, ...] = ()  # surfaces that are further bodies
    output: Optional[str] = None
    hull: Optional[str] = None
    boundary: Optional[str] = None
    outliers: Optional[str] = None
    plot: Optional[str] = None
    marked: Optional[str] = None
    report: Optional[str] = None

    def name(self) -> str:
        """The name of the surface in messages."""
        name = STANDARD_INPUT if self.surface == "-" else self.surface
        return f"{name} and {len(self.others)} more" if self.others else name

    def surfaces(self) -> list[str]:
        """The input files."""
        return [self.surface, *self.others]

    def bodies(self) -> dict[str, str]:
        """Surfaces by the names of bodies: the names of the files, with a number appended to repeated ones."""
        named: dict[str, str] = {}
        for surface in self.surfaces():
            stem = _stem_of(surface)
            number = 2
            name = stem
            while name in named:
                name, number = f"{stem}_{number}", number + 1
            named[name] = surface
        return named

    def is_solid(self) -> bool:
        """Whether the input is a solid, by its name."""
        return ending(self.surface) in READABLE_SOLIDS

    def outputs(self) -> list[str]:
        """The output files."""
        paths = [getattr(self, name) for name in FILE_OPTIONS]
        return [path for path in paths if path is not None]


FILE_OPTIONS = [field.name for field in fields(Files) if field.name not in ("surface", "others")]


def parse(arguments: Optional[Sequence[str]] = None) -> tuple[argparse.Namespace, list[Files]]:
    """Return the options, and the files of each surface (none for `demo`). Ends the program with one line if they are
    invalid.
    """
    given = list(sys.argv[1:] if arguments is None else arguments)
    name = given.pop(0) if given and given[0] in COMMANDS else None
    parser = _parser_of_short_form() if name is None else _parser_of(name)
    options = parser.parse_args(given, argparse.Namespace(**_NOT_GIVEN, command=name, called=name))
    if name == "demo":
        return options, []
    if name is None:
        _name_command(parser, options)
    surfaces = list(options.files)
    if options.command != "check":
        options.is_output_told = options.output is not None
        last = options.output if options.is_output_told else surfaces.pop() if len(surfaces) > 1 else None
        expected = COMMANDS[options.command].operands[-1][0]
        if last is None:
            parser.error(f"the following arguments are required: {expected + os.path.splitext(options.points or '')[1]}")
        options.output = None
        setattr(options, "plot" if options.command == "draw" else "output", last)
    elif len(surfaces) > 1 and ending(surfaces[-1]) in WRITABLE_GRIDS and not os.path.exists(surfaces[-1]):
        parser.error(f"{options.called} {WHY_NOT[options.command]}: it goes without OUTPUT{ending(surfaces[-1])}")
    refused = refusal(options, surfaces)
    if refused:
        parser.error(refused)
    if surfaces.count("-") > 1:
        parser.error("- is named twice: standard input can be read once")
    if options.threads is not None and options.threads < 1:
        parser.error(f"--threads is {options.threads}; it must be at least 1")
    if options.timeout is not None and not options.timeout > 0:
        parser.error(f"--timeout is {options.timeout:g}; it must be above 0")
    if options.to is not None:
        options.scale = scale_between(getattr(options, "from"), options.to)
    all_files = _files(parser, options, surfaces)
    options.several = len(all_files) > 1
    return options, all_files


def _name_command(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """The command of the short form, by the options that stand for a command."""
    standing = {
        "--check": ("check", options.check),
        "--winding": ("query", options.points is not None),
        "--boolean": ("boolean", options.expression is not None),
    }
    chosen = [flag for flag, (_, is_chosen) in standing.items() if is_chosen]
    options.called = chosen[0] if chosen else "mesh"
    options.command = standing[options.called][0] if chosen else "mesh"
    if len(chosen) > 1:
        parser.error(f"{options.called} {WHY_NOT[options.command]}: it goes without {chosen[1]}")
    if options.distance and options.command != "query":
        parser.error("--distance goes with --winding")


def _files(parser: argparse.ArgumentParser, options: argparse.Namespace, surfaces: list[str]) -> list[Files]:
    """The files of each surface: {} in a name stands for the surface's name, without folder and ending."""
    patterns = {name: getattr(options, name) for name in FILE_OPTIONS if getattr(options, name) is not None}
    seen: dict[str, str] = {}
    all_files = []
    others: tuple[str, ...] = ()
    if options.together or options.command == "boolean":
        surfaces, others = surfaces[:1], tuple(surfaces[1:])
    for surface in surfaces:
        stem = _stem_of(surface)
        named = {name: pattern.replace("{}", stem) for name, pattern in patterns.items()}
        for name, path in named.items():
            if path in seen and identity(path) is not None:
                way = "write {} in it for the surface's name" if "{}" not in patterns[name] else "rename one"
                way += ", or give --together for one mesh of all" if "together" in COMMANDS[options.command].options else ""
                parser.error(f"{seen[path]} and {surface} would both be written to {path}: {way}")
        seen.update({path: surface for path in named.values() if len(surfaces) > 1})
        all_files.append(Files(surface, others, **named))
    return all_files


def _stem_of(surface: str) -> str:
    """The replacement of {}."""
    return "stdin" if surface == "-" else _stem(surface)


def _stem(surface: str) -> str:
    """A file's name without its folder, its ending and that of its compression."""
    name, last = os.path.splitext(os.path.basename(surface))
    return os.path.splitext(name)[0] if last.lower() == GZIP else name


class _Parser(argparse.ArgumentParser):
    """Reports an error in one line, like every other failure, without the usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(USAGE_ERROR, f"insideout: {message} (see {self.usage})\n")
        raise SystemExit


class _Show(argparse.Action):
    """Print a text and end."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        parser._print_message(self.const(), sys.stdout)
        parser.exit()


def _parser(hint: str, options: Iterable[str], some: Callable[[], str], everything: Callable[[], str]) -> argparse.ArgumentParser:
    """A parser with options, a hint for invalid arguments, and its help text."""
    parser = _Parser(usage=hint, allow_abbrev=False, add_help=False)
    parser.add_argument("-h", "--help", nargs=0, action=_Show, const=some)
    parser.add_argument("--help-all", nargs=0, action=_Show, const=everything)
    for name in options:
        argument: dict[str, Any] = {**argument_of(name), "help": argparse.SUPPRESS}  # printed by help.py
        parser.add_argument(flag_of(name), *OTHER_FLAGS.get(name, []), default=argparse.SUPPRESS, **argument)
    return parser


def _parser_of(name: str) -> argparse.ArgumentParser:
    """The parser of a subcommand."""
    command = COMMANDS[name]
    parser = _parser(f"insideout {name} --help", command.options, partial(screen_of, name), partial(screen_of, name, everything=True))
    for operand in BEFORE_FILES:
        if operand in dict(command.operands):
            parser.add_argument(operand.lower(), metavar=operand)
    if name == "demo":
        parser.add_argument("folder", metavar="FOLDER", nargs="?", default=DEMO_FOLDER)
    else:
        parser.add_argument("files", metavar=command.names(BEFORE_FILES), nargs="+")
    return parser


def _parser_of_short_form() -> argparse.ArgumentParser:
    """The parser of the command without a subcommand: that of `mesh`, with options that stand for other subcommands."""
    parser = _parser("--help", (*COMMANDS["mesh"].options, "distance"), screen, all_screens)
    parser.add_argument("--version", action="version", version=f"insideout {__version__}")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--winding", dest="points", metavar="POINTS")
    parser.add_argument("--boolean", dest="expression", metavar="EXPRESSION")
    parser.add_argument("files", metavar=COMMANDS["mesh"].names(), nargs="+")
    return parser
