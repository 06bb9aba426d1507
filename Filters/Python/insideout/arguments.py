# SPDX-License-Identifier: GPL-3.0-or-later
"""The arguments of the command `python3 -m insideout`, and the files that they name."""

from __future__ import annotations

import argparse
import os
from dataclasses import dataclass, fields
from typing import NoReturn, Optional, Sequence, get_args

from .files import GZIP, READABLE_SOLIDS, READABLE_SURFACES, STANDARD_INPUT, WRITABLE_SURFACES, ending, identity
from .options import OPTIONS, flag_of
from .places import QUERIES
from .version import __version__
from .writing import WRITABLE_GRIDS, MshVersion

USAGE_ERROR = 1

EXAMPLES = """\
examples:
  python3 -m insideout broken.ply solid.vtu
      the tetrahedra inside
  python3 -m insideout broken.stl solid.msh --scale 0.001
      the same for gmsh, in metres where the surface is in millimetres
  python3 -m insideout broken.stl fixed.stl
      only their watertight boundary, without tetrahedra where the surface is closed
  python3 -m insideout --check broken.ply
      only what is wrong with it
  python3 -m insideout --check solid.vtu --plot angles.png
      what is wrong with tetrahedra, how good they are, and a histogram of their dihedral angles
  python3 -m insideout broken.ply solid.vtu --boundary solid.stl --plot picture.png --report report.json
      the watertight boundary, a picture and a report too
  python3 -m insideout *.stl 'solids/{}.vtu' --boundary 'solids/{}.ply' --timeout 60
      several; {} is each one's name without ending, and a table comes at the end
  python3 -m insideout broken.ply solid.vtu --edge-length 0.05 --quadratic
      refined, with cells of second order
  python3 -m insideout --together bone.stl fat.ply limb.msh --priority bone
      several bodies in one mesh that conforms: a region for each, where both are that of the bone
  python3 -m insideout parts.obj parts.inp --bodies GroupIds --region-rule all
      the groups of one file as bodies, and a region for each combination
  python3 -m insideout --boolean "bone - (fat | C)" bone.stl fat.ply skin.obj rest.stl
      a set operation of bodies, as broken as they may be: its surface, or with .vtu its tetrahedra
  zcat broken.obj.gz | python3 -m insideout - solid.vtu --format obj
      standard input; a .gz is read as it is, too
  python3 -m insideout --winding grid.vti broken.ply w.vti --distance
      the winding number at places of yours, and how far the surface is, without a mesh

Exit status 0 when all was done, 1 when it was not for some surface (one line says why), 130 after Ctrl-C,
143 after SIGTERM. A file is written whole or not at all: an earlier one of its name stays until then.
"""

CHECK_OPTIONS = ("scale", "orientation", "merge_tolerance")
WINDING_OPTIONS = (*CHECK_OPTIONS, "count_duplicates")
"""Those that make sense without a mesh: of `check`, and of `winding_number`."""

BOOLEAN_OPTIONS = ("boundary", "msh_version", *WINDING_OPTIONS)
"""Those that make sense of set operations."""

MESH_OPTIONS = ("hull", "boundary", "outliers", "plot", "msh_version", "together", *OPTIONS)


@dataclass(frozen=True)
class Files:
    """The files that belong to one surface, or to one solid that is checked."""

    surface: str
    others: tuple[str, ...] = ()  # surfaces that are bodies together with it
    output: Optional[str] = None
    hull: Optional[str] = None
    boundary: Optional[str] = None
    outliers: Optional[str] = None
    plot: Optional[str] = None
    report: Optional[str] = None

    def name(self) -> str:
        """What messages call the surface."""
        name = STANDARD_INPUT if self.surface == "-" else self.surface
        return f"{name} and {len(self.others)} more" if self.others else name

    def surfaces(self) -> list[str]:
        """Those that are read."""
        return [self.surface, *self.others]

    def bodies(self) -> dict[str, str]:
        """Surfaces by the names of bodies: those of the files, and numbers behind where several are called so."""
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
        """Whether it is a solid that is read, by its name."""
        return ending(self.surface) in READABLE_SOLIDS

    def outputs(self) -> list[str]:
        """Those that are written."""
        paths = [getattr(self, name) for name in FILE_OPTIONS]
        return [path for path in paths if path is not None]


FILE_OPTIONS = [field.name for field in fields(Files) if field.name not in ("surface", "others")]


def parse(arguments: Optional[Sequence[str]] = None) -> tuple[argparse.Namespace, list[Files]]:
    """The options, and the files of each surface. Ends the program with one line where they make no sense."""
    parser = _parser()
    options = parser.parse_args(arguments)
    surfaces = list(options.files)
    options.output = None
    if not options.check:
        last = surfaces.pop() if len(surfaces) > 1 else None
        expected = "OUTPUT" if options.winding is None else "OUTPUT" + os.path.splitext(options.winding)[1]
        if last is None:
            parser.error(f"the following arguments are required: {expected}")
        options.output = last
    elif len(surfaces) > 1 and ending(surfaces[-1]) in WRITABLE_GRIDS and not os.path.exists(surfaces[-1]):
        parser.error(f"--check meshes nothing: it goes without OUTPUT{ending(surfaces[-1])}")
    _refuse_what_does_not_go_together(parser, options, surfaces)
    if surfaces.count("-") > 1:
        parser.error("- is named twice: standard input can be read once")
    if options.format is not None and "-" not in surfaces:
        parser.error("--format is for standard input: it goes with - as SURFACE")
    if options.together and getattr(options, "bodies", None) is not None:
        parser.error("--together makes a body of each surface: it goes without --bodies")
    if options.msh_version is not None and ".msh" not in (ending(options.output), ending(options.hull or "")):
        parser.error("--msh-version is for .msh files, and none is to be written")
    if options.threads is not None and options.threads < 1:
        parser.error(f"--threads is {options.threads}; it must be at least 1")
    if options.timeout is not None and not options.timeout > 0:
        parser.error(f"--timeout is {options.timeout:g}; it must be above 0")
    return options, _files(parser, options, surfaces)


def _refuse_what_does_not_go_together(parser: argparse.ArgumentParser, options: argparse.Namespace, surfaces: Sequence[str]) -> None:
    modes = {
        "--check meshes nothing": options.check,
        "--winding meshes nothing": options.winding is not None,
        "--boolean makes one thing of several bodies": options.boolean is not None,
    }
    chosen = [mode for mode, is_chosen in modes.items() if is_chosen]
    mode = chosen[0] if chosen else None
    if len(chosen) > 1:
        parser.error(f"{mode}: it goes without {chosen[1].split()[0]}")
    if options.distance and options.winding is None:
        parser.error("--distance is of places: it goes with --winding")
    solids = [surface for surface in surfaces if ending(surface) in READABLE_SOLIDS]
    if options.check and solids:
        for name in CHECK_OPTIONS:
            if getattr(options, name, None) is not None:
                parser.error(f"--{name.replace('_', '-')} is about surfaces: it goes without {solids[0]}")
    others: tuple[str, ...] = WINDING_OPTIONS if options.boolean is None else BOOLEAN_OPTIONS
    if options.check:
        others = (*CHECK_OPTIONS, "plot") if len(solids) == len(surfaces) else CHECK_OPTIONS
    for name in MESH_OPTIONS:
        if mode is not None and name not in others and getattr(options, name, None) is not None:
            parser.error(f"{mode}: it goes without --{name.replace('_', '-')}")


def _files(parser: argparse.ArgumentParser, options: argparse.Namespace, surfaces: list[str]) -> list[Files]:
    """The files of each surface: {} in a name stands for the surface's, without folder and ending."""
    patterns = {name: getattr(options, name) for name in FILE_OPTIONS if getattr(options, name) is not None}
    seen: dict[str, str] = {}
    all_files = []
    others: tuple[str, ...] = ()
    if options.together or options.boolean is not None:
        surfaces, others = surfaces[:1], tuple(surfaces[1:])
    for surface in surfaces:
        stem = _stem_of(surface)
        named = {name: pattern.replace("{}", stem) for name, pattern in patterns.items()}
        for name, path in named.items():
            if path in seen and identity(path) is not None:
                way = "write {} in it for the surface's name" if "{}" not in patterns[name] else "rename one"
                parser.error(f"{seen[path]} and {surface} would both be written to {path}: {way}")
        seen.update({path: surface for path in named.values() if len(surfaces) > 1})
        all_files.append(Files(surface, others, **named))
    return all_files


def _stem_of(surface: str) -> str:
    """What {} stands for."""
    return "stdin" if surface == "-" else _stem(surface)


def _stem(surface: str) -> str:
    """A file's name without folder and ending, nor that of its compression."""
    name, last = os.path.splitext(os.path.basename(surface))
    return os.path.splitext(name)[0] if last.lower() == GZIP else name


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one line, like every other failure, and not with the usage before it."""

    def error(self, message: str) -> NoReturn:
        self.exit(USAGE_ERROR, f"{self.prog}: {message} (see --help)\n")
        raise SystemExit


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="insideout",
        allow_abbrev=False,
        usage="python3 -m insideout SURFACE... OUTPUT [options]\n"
        "       python3 -m insideout --check SURFACE|SOLID.vtu... [options]\n"
        "       python3 -m insideout --winding QUERY SURFACE... OUTPUT [options]\n"
        "       python3 -m insideout --boolean EXPRESSION SURFACE... OUTPUT [options]",
        description="From a broken surface to tetrahedra of the solid that it means.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    surface_endings = ", ".join(WRITABLE_SURFACES)
    parser.add_argument(
        *("files",),
        metavar="SURFACE... OUTPUT",
        nargs="+",
        help=f"the surfaces ({', '.join(READABLE_SURFACES)}, each also with .gz; - is standard input), and where to write the tetrahedra inside "
        f"({', '.join(WRITABLE_GRIDS)}), or only their watertight boundary ({surface_endings}); in the name of every file that is "
        "written {} stands for the surface's name without folder and ending",
    )
    mode = parser.add_argument_group("instead of tetrahedra")
    mode.add_argument(
        "--check",
        action="store_true",
        help="only say what is wrong with the surface, and whether it matters here; or with the tetrahedra of a .vtu file, and how good they are",
    )
    mode.add_argument(
        "--winding",
        metavar="QUERY",
        help=f"only evaluate the winding number: at the places in a .csv file (columns x, y, z) or at the points of an "
        f"image ({QUERIES[1]}); OUTPUT has the same ending; SURFACE may be points with normals, too, without faces",
    )
    mode.add_argument(
        "--distance",
        action="store_true",
        help="with --winding: how far the surface is from each place, too, negative inside",
    )
    mode.add_argument(
        "--boolean",
        metavar="EXPRESSION",
        help='a set operation of all surfaces, such as "A - (B | C) ^ D": | or + is union, & intersection, - difference, ^ symmetric '
        "difference; a body is called like its file without folder and ending, in quotes where that is more than letters, digits and "
        "underscores, or by a letter, A the first, or #1; its surface is written, or its tetrahedra, by the ending of OUTPUT",
    )
    files = parser.add_argument_group("what to write")
    files.add_argument("--hull", metavar="HULL.vtu", help="all tetrahedra of the convex hull, with w and Inside")
    files.add_argument("--msh-version", choices=get_args(MshVersion), help="of .msh files: 4.1 by default, 2.2 for programs that know no other")
    files.add_argument("--boundary", metavar="FILE", help=f"the solid's boundary ({surface_endings})")
    files.add_argument("--outliers", metavar="FILE", help=f"the facets that are no part of the solid ({surface_endings})")
    files.add_argument("--plot", metavar="FILE.png", help="a picture of the defects, a slice of w, and the tetrahedra; with --check of a .vtu file, a histogram of dihedral angles; needs no window")
    files.add_argument("--report", metavar="FILE.json", help="what was found and done, also when it fails")
    how = parser.add_argument_group("how")
    for name, option in OPTIONS.items():
        how.add_argument(flag_of(name), dest=name, help=option.help(), default=argparse.SUPPRESS, **option.argument())
    how.add_argument(
        *("--together",),
        action="store_true",
        default=None,
        help="make one mesh of all surfaces, which conforms: each is a body, called like its file without folder and ending",
    )
    how.add_argument(
        *("--constrained-array",),
        dest="constrain_facets",
        metavar="ARRAY",
        default=argparse.SUPPRESS,
        help="the same for the facets where this cell array is not 0",
    )
    how.add_argument(
        *("--format",),
        choices=[known[1:] for known in READABLE_SURFACES],
        help="what standard input holds, where its content does not tell",
    )
    how.add_argument("--timeout", metavar="S", type=float, help="give a surface up after this many seconds; none by default")
    how.add_argument("--threads", metavar="N", type=int, help="how many threads work, at most four per processor; by default one each")
    how.add_argument("--quiet", action="store_true", help="print nothing but errors")
    parser.add_argument("--version", action="version", version=f"insideout {__version__}")
    return parser
