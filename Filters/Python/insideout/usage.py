# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands, the options of each, and what --help says of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence, get_args

from .deck import MATERIALS
from .files import READABLE_SOLIDS, READABLE_SURFACES, WRITABLE_SURFACES
from .lengths import UNITS
from .options import LAYER_OPTIONS, OPTIONS, REFINING_OPTIONS, flag_of, help_of
from .options import TOPICS as TOPICS_OF_OPTIONS
from .places import QUERIES
from .solid_files import WRITABLE_GRIDS, MshVersion

DEMO_FOLDER = "demo"

CHECK_OPTIONS = ("scale", "orientation", "merge_tolerance")
WINDING_OPTIONS = (*CHECK_OPTIONS, "count_duplicates")
"""Options without a mesh: of `check`, and of `winding_number`."""

SET_OPTIONS = (*WINDING_OPTIONS, "merge_coplanar_pieces")
BOOLEAN_OPTIONS = ("boundary", "msh_version", *SET_OPTIONS)
"""Options of set operations."""

_UNITS = ("from", "to")
"""Options that replace `scale`."""

OF_THE_RUN = ("output", "force", "dry_run", "report", "json", "format", "timeout", "threads", "quiet")
"""Options of every command."""

_MESH_FILES = ("hull", "boundary", "outliers", "plot", "msh_version", "cells_only")
MESH_OPTIONS = (*_MESH_FILES, "together", *OPTIONS)

DECK_OPTIONS = ("material", "fix", "pressure", "gravity")
"""Options that make an .inp file a complete deck."""

_OF_TETRAHEDRA = ("hull", "plot", "msh_version", "cells_only", "surface_only", "quadratic_cells", *LAYER_OPTIONS)
"""Options without meaning for a repaired surface."""

_OF_OUTPUT = ("output", "force", "dry_run")
"""Options without meaning for a command that writes nothing."""

_SURFACE_ENDINGS, _GRID_ENDINGS = " ".join(WRITABLE_SURFACES), " ".join(WRITABLE_GRIDS)

_OTHERS: dict[str, dict[str, Any]] = {
    "hull": {"metavar": "HULL.vtu", "help": "all tetrahedra of the convex hull, with w and Inside"},
    "boundary": {"metavar": "FILE", "help": f"solid's boundary ({_SURFACE_ENDINGS})"},
    "outliers": {"metavar": "FILE", "help": f"facets that are not part of the solid ({_SURFACE_ENDINGS})"},
    "plot": {
        "metavar": "FILE",
        "help": "picture (.png) of the defects, a slice of w, and the tetrahedra; or page (.html) with the same to turn and to cut; "
        "if a solid is checked, a histogram of dihedral angles",
    },
    "output": {
        "metavar": "FILE",
        "help": "OUTPUT instead of the last operand; any existing file there but an input is replaced",
    },
    "force": {"action": "store_true", "help": "replace a surface at OUTPUT even if another program wrote it"},
    "defects": {"action": "store_true", "help": "draw only the defects, from two sides, with the worst places and all counts; nothing is meshed"},
    "marked": {
        "metavar": "FILE.vtp",
        "help": "surface with its defects marked per cell, and with its open, non-manifold and inconsistent edges and intersection curves as lines",
    },
    "dry_run": {
        "action": "store_true",
        "help": "describe the input without running; estimate the work, and list the files that would be written",
    },
    "json": {"action": "store_true", "help": "print the report instead of the summary, one line per surface"},
    "from": {"choices": tuple(UNITS), "help": "unit of the surface's file; used with --to, instead of --scale"},
    "to": {"choices": tuple(UNITS), "help": "unit of all outputs and of lengths in options; used with --from"},
    "report": {"metavar": "FILE.json", "help": "report of the run; with counts, times and warnings, also if it fails"},
    "msh_version": {"choices": get_args(MshVersion), "help": "version of .msh files; 4.1 by default, 2.2 for programs that know no other"},
    "cells_only": {
        "action": "store_true",
        "help": "omit boundary and regions in a .msh, .inp or .mesh file: one block of nodes and one of elements, as MuJoCo takes it",
    },
    "format": {
        "metavar": "KIND",
        "choices": [known[1:] for known in READABLE_SURFACES],
        "help": f"format of standard input, if its content does not decide it: {', '.join(known[1:] for known in READABLE_SURFACES)}",
    },
    "together": {
        "action": "store_true",
        "help": "make one conforming mesh of all surfaces: each is a body, named like its file without folder and ending",
    },
    "material": {
        "metavar": "NAME",
        "choices": tuple(MATERIALS),
        "help": f"complete an .inp file for a static analysis with ccx, with {' or '.join(MATERIALS)}; lengths are in the unit of --to, or millimeters, forces in newtons",
    },
    "fix": {"metavar": "TAG", "action": "append", "help": "fix the points with this tag of the boundary; may be given several times"},
    "pressure": {
        "metavar": ("TAG", "VALUE"),
        "nargs": 2,
        "action": "append",
        "help": "pressure on the triangles with this tag of the boundary, in newtons per squared unit: megapascals for millimeters; may be given several times",
    },
    "gravity": {"action": "store_true", "help": "apply the weight along -z"},
    "sizes": {"metavar": "ARRAY", "help": "point array of the solid with the edge length at each point"},
    "distance": {"action": "store_true", "help": "also compute the signed distance of each point to the surface, negative inside"},
    "timeout": {"metavar": "S", "type": float, "help": "limit on the seconds per surface; none by default"},
    "threads": {"metavar": "N", "type": int, "help": "number of threads, at most four per processor and VTK_SMP_MAX_THREADS; by default one per processor"},
    "quiet": {"action": "store_true", "help": "print nothing but errors"},
}
"""Arguments for argparse of options that do not belong to a filter."""

OTHER_FLAGS = {
    "output": ["-o"],
    "surface_treatment": ["--surface"],
    "tag_rules": ["--tag"],
    "size_rules": ["--size"],
    "quadratic_cells": ["--quadratic"],
    "body_array": ["--bodies"],
    "constrained_facets_array": ["--constrained-array"],
    "non_participating_array": ["--non-participating"],
}
"""Short options, which help shows, and former names, which it does not."""

TOPICS: dict[str, Sequence[str]] = {
    "files": ("output", "force", "hull", "boundary", "outliers", "plot", "defects", "marked", "report", "json", "dry_run", "msh_version", "cells_only", "format"),
    "surface": ("scale", *_UNITS, *(name for name in TOPICS_OF_OPTIONS["surface"] if name != "scale")),
    "bodies": ("together", *TOPICS_OF_OPTIONS["bodies"]),
    "segmentation": TOPICS_OF_OPTIONS["segmentation"],
    "topology": TOPICS_OF_OPTIONS["topology"],
    "refinement": ("refine", *REFINING_OPTIONS, "sizes", *LAYER_OPTIONS),
    "analysis": DECK_OPTIONS,
    "points": ("distance",),
    "work": (*(name for name in TOPICS_OF_OPTIONS["work"] if name != "refine"), "timeout", "threads", "quiet"),
}
"""All options, in the order of the help."""

BEFORE_FILES = ("EXPRESSION", "POINTS")
"""Operands that are neither surfaces nor outputs."""

_SURFACE = ("SURFACE", f"{' '.join(READABLE_SURFACES)}, also .gz; - standard input")
_SURFACE_OR_SOLID = ("SURFACE|SOLID", f"{_SURFACE[1]}; or tetrahedra ({' '.join(READABLE_SOLIDS)})")
_OUTPUT = (
    "OUTPUT",
    f"tetrahedra ({_GRID_ENDINGS}), or only their watertight boundary ({_SURFACE_ENDINGS}); "
    "{} in the name of any written file stands for the surface's name without folder and ending",
)


@dataclass(frozen=True)
class Command:
    """A subcommand."""

    gist: str  # in half a line
    words: str
    operands: tuple[tuple[str, str], ...]  # the operands after it, and their descriptions
    options: Sequence[str]
    examples: str
    first: Sequence[str] = ()  # the options on the first screen, if it has no room for all

    def names(self, left_out: Sequence[str] = ()) -> str:
        """The names of the operands."""
        return " ".join(name + "..." * name.startswith("S") for name, _ in self.operands if name not in left_out)

    def by_topic(self) -> dict[str, list[str]]:
        """The options by topic, without empty topics."""
        chosen = {topic: [name for name in names if name in self.options] for topic, names in TOPICS.items()}
        return {topic: names for topic, names in chosen.items() if names}


COMMANDS: dict[str, Command] = {
    "demo": Command(
        "broken surfaces to try all this on",
        "Write small broken surfaces, and print commands to try on them.",
        (("[FOLDER]", f"the folder, by default a new one, {DEMO_FOLDER}; files that another program wrote stay"),),
        ("quiet",),
        f"""\
insideout demo
    into the folder {DEMO_FOLDER}
""",
    ),
    "mesh": Command(
        "tetrahedra of the solid inside",
        "Make tetrahedra of the solid that a surface means, or triangles in a plane.",
        (_SURFACE, _OUTPUT),
        (*MESH_OPTIONS, *DECK_OPTIONS, *_UNITS, *OF_THE_RUN),
        """\
insideout mesh broken.ply solid.vtu
    the tetrahedra inside
insideout mesh broken.stl solid.msh --from mm --to m
    the same for gmsh, in meters where the surface is in millimeters
insideout mesh broken.ply solid.vtu --boundary solid.stl --plot picture.png --report report.json
    also the watertight boundary, a picture and a report
insideout mesh *.stl 'solids/{}.vtu' --boundary 'solids/{}.ply' --timeout 60
    several; {} is each one's name without ending, and a table comes at the end
insideout mesh broken.ply solid.vtu --edge-length 2% --quadratic-cells
    refined to edges of 2 percent of the diagonal, with cells of second order
insideout mesh --together bone.stl fat.ply limb.msh --priority bone
    several bodies in one conforming mesh, a region for each; overlaps belong to the bone
insideout mesh parts.obj parts.inp --body-array GroupIds --region-rule all
    the groups of one file as bodies, and a region for each combination
insideout mesh bracket.obj bracket.inp --material steel --fix clamp --pressure load 0.5
    a complete analysis for CalculiX: ccx bracket
zcat broken.obj.gz | insideout mesh - solid.vtu --format obj
    standard input; .gz files can also be read directly
""",
        first=(
            *("boundary", "report", "scale", "orientation", "merge_tolerance", "together", "gamma"),
            *("non_manifold", "refine", "edge_length", "material"),
        ),
    ),
    "repair": Command(
        "the solid's watertight boundary",
        "Make the watertight boundary of the solid that a surface means, without tetrahedra where it is closed.",
        (_SURFACE, ("OUTPUT", f"{_SURFACE_ENDINGS}; {{}} in the name stands for the surface's name without folder and ending")),
        [name for name in (*MESH_OPTIONS, *_UNITS, *OF_THE_RUN) if name not in _OF_TETRAHEDRA],
        """\
insideout repair broken.stl fixed.stl
    without self-intersections, inner walls and duplicates
insideout repair *.ply 'fixed/{}.ply' --report 'fixed/{}.json'
    several, with a report for each
""",
        first=(
            *("outliers", "report", "scale", "orientation", "merge_tolerance", "split_seams", "together"),
            *("gamma", "constrain_facets", "non_manifold", "timeout", "quiet"),
        ),
    ),
    "check": Command(
        "defects, and whether they matter",
        "Find the defects of a surface, and whether they matter here; or the defects and quality of tetrahedra. Nothing is meshed.",
        (_SURFACE_OR_SOLID,),
        ("plot", *CHECK_OPTIONS, *_UNITS, *(name for name in OF_THE_RUN if name not in _OF_OUTPUT)),
        """\
insideout check broken.ply
    whether it bounds a solid, and its defects
insideout check solid.vtu --plot angles.png
    the defects and quality of tetrahedra, and a histogram of their dihedral angles
""",
    ),
    "refine": Command(
        "better tetrahedra of the same solid",
        "Make better tetrahedra of the same solid.",
        (
            ("SOLID", f"tetrahedra ({' '.join(READABLE_SOLIDS)}); their cell array RegionId distinguishes regions"),
            ("OUTPUT", f"{_GRID_ENDINGS}; {{}} in the name stands for the solid's name without folder and ending"),
        ),
        ("msh_version", *REFINING_OPTIONS, "sizes", *(name for name in OF_THE_RUN if name != "format")),
        """\
insideout refine solid.vtu better.vtu --edge-length 0.05 --quadratic-cells
    edges of about this length, and cells of second order
""",
    ),
    "boolean": Command(
        "set operations of broken bodies",
        "Make a set operation of bodies, however broken their surfaces are.",
        (
            (
                "EXPRESSION",
                'such as "A - (B | C) ^ D": | or + is union, & intersection, - difference, ^ symmetric difference; a body is called '
                "like its file without folder and ending, in quotes if that has other characters than letters, digits and underscores; or by a "
                "letter, A the first, or #1",
            ),
            _SURFACE,
            ("OUTPUT", f"the result's surface ({_SURFACE_ENDINGS}), or its tetrahedra ({_GRID_ENDINGS})"),
        ),
        (*BOOLEAN_OPTIONS, *_UNITS, *OF_THE_RUN),
        """\
insideout boolean "bone - (fat | C)" bone.stl fat.ply skin.obj rest.stl
    the result's surface, or with .vtu its tetrahedra
""",
    ),
    "query": Command(
        "winding numbers and distances",
        "Compute winding numbers at points, which points are inside, and distances to the surface. Nothing is meshed.",
        (
            ("POINTS", f"a .csv file with the columns x, y, z, or the points of an image ({QUERIES[1]})"),
            (_SURFACE[0], _SURFACE[1] + "; or points with normals, without faces"),
            ("OUTPUT", "the points with w and inside (1 or 0); it has the ending of POINTS"),
        ),
        ("distance", *WINDING_OPTIONS, *_UNITS, *OF_THE_RUN),
        """\
insideout query grid.vti broken.ply w.vti --distance
    winding numbers and distances at your points, without a mesh
""",
    ),
    "draw": Command(
        "defects, winding numbers, tetrahedra",
        "Draw a picture, without a window, of a surface and its solid, or of the quality of tetrahedra.",
        (_SURFACE_OR_SOLID, ("PICTURE.png", "the defects, a slice of w, and the tetrahedra (as .html to turn and to cut); for a solid, a histogram of dihedral angles")),
        ["defects", "marked", *(name for name in (*MESH_OPTIONS, *_UNITS, *OF_THE_RUN) if name not in (*_MESH_FILES, "surface_only", *LAYER_OPTIONS))],
        """\
insideout draw broken.ply picture.png
    the surface's defects, a slice of w, and the tetrahedra inside
insideout draw broken.ply page.html
    the same to turn, and to cut with a slider, with the report, in any browser
insideout draw broken.ply wrong.png --defects --marked wrong.vtp
    only the defects, without meshing; and the same for ParaView
insideout draw solid.vtu angles.png
    the dihedral angles of tetrahedra
""",
        first=(
            *("defects", "marked", "report", "scale", "orientation", "merge_tolerance", "gamma"),
            *("constrain_facets", "refine", "edge_length", "timeout", "quiet"),
        ),
    ),
}

def argument_of(name: str) -> dict[str, Any]:
    """An option's arguments for argparse."""
    if name in _OTHERS:
        return {"dest": name, **_OTHERS[name]}
    return {"dest": name, "help": help_of(name, flag_of, ""), **OPTIONS[name].argument()}
