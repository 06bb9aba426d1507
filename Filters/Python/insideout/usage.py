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
"""Those that make sense without a mesh: of `check`, and of `winding_number`."""

SET_OPTIONS = (*WINDING_OPTIONS, "merge_coplanar_pieces")
BOOLEAN_OPTIONS = ("boundary", "msh_version", *SET_OPTIONS)
"""Those that make sense of set operations."""

_UNITS = ("from", "to")
"""What stands for `scale`."""

OF_THE_RUN = ("output", "force", "dry_run", "report", "json", "format", "timeout", "threads", "quiet")
"""What each command has."""

_MESH_FILES = ("hull", "boundary", "outliers", "plot", "msh_version", "cells_only")
MESH_OPTIONS = (*_MESH_FILES, "together", *OPTIONS)

DECK_OPTIONS = ("material", "fix", "pressure", "gravity")
"""What makes an .inp file a complete deck."""

_OF_TETRAHEDRA = ("hull", "plot", "msh_version", "cells_only", "surface_only", "quadratic_cells", *LAYER_OPTIONS)
"""What a repaired surface has no use for."""

_OF_OUTPUT = ("output", "force", "dry_run")
"""What a command has no use for that writes nothing."""

_SURFACE_ENDINGS, _GRID_ENDINGS = " ".join(WRITABLE_SURFACES), " ".join(WRITABLE_GRIDS)

_OTHERS: dict[str, dict[str, Any]] = {
    "hull": {"metavar": "HULL.vtu", "help": "all tetrahedra of the convex hull, with w and Inside"},
    "boundary": {"metavar": "FILE", "help": f"its boundary ({_SURFACE_ENDINGS})"},
    "outliers": {"metavar": "FILE", "help": f"the facets that are no part of the solid ({_SURFACE_ENDINGS})"},
    "plot": {
        "metavar": "FILE",
        "help": "a picture (.png), which needs no window: the defects, a slice of w, and the tetrahedra; or a page (.html) with the same to turn and to cut; "
        "of a solid that is checked, a histogram of dihedral angles",
    },
    "output": {
        "metavar": "FILE",
        "help": "OUTPUT, which is not the last operand then, and replaces whatever is there, but for what is read",
    },
    "force": {"action": "store_true", "help": "replace a surface at OUTPUT, even where another program wrote it"},
    "defects": {"action": "store_true", "help": "only what is wrong, from two sides, with the worst places and all counts; nothing is meshed"},
    "marked": {
        "metavar": "FILE.vtp",
        "help": "the surface with what is wrong marked per cell, and with its open, non-manifold and inconsistent edges and intersection curves as lines",
    },
    "dry_run": {
        "action": "store_true",
        "help": "only check: say what the input is, about how much work it will be, and which files would be written",
    },
    "json": {"action": "store_true", "help": "print the report instead of the summary, one line for each surface"},
    "from": {"choices": tuple(UNITS), "help": "the unit of the surface's file; goes with --to, instead of --scale"},
    "to": {"choices": tuple(UNITS), "help": "the unit of all that is written, and of all lengths that are given; goes with --from"},
    "report": {"metavar": "FILE.json", "help": "what was found and done, also when it fails"},
    "msh_version": {"choices": get_args(MshVersion), "help": "the version of .msh files; 4.1 by default, 2.2 for programs that know no other"},
    "cells_only": {
        "action": "store_true",
        "help": "leave boundary and regions away in an .msh, .inp or .mesh file: one block of nodes and one of elements, as MuJoCo takes it",
    },
    "format": {
        "metavar": "KIND",
        "choices": [known[1:] for known in READABLE_SURFACES],
        "help": f"what standard input holds, where its content does not tell: {', '.join(known[1:] for known in READABLE_SURFACES)}",
    },
    "together": {
        "action": "store_true",
        "help": "make one mesh of all surfaces, which conforms: each is a body, called like its file without folder and ending",
    },
    "material": {
        "metavar": "NAME",
        "choices": tuple(MATERIALS),
        "help": f"complete an .inp file for a static analysis, which ccx runs, with {' or '.join(MATERIALS)}; lengths are in the unit of --to, or millimeters, forces in newtons",
    },
    "fix": {"metavar": "TAG", "action": "append", "help": "hold the points of this part of the boundary; may be given several times"},
    "pressure": {
        "metavar": ("TAG", "VALUE"),
        "nargs": 2,
        "action": "append",
        "help": "press on this part of the boundary, by newtons per squared unit: megapascals for millimeters; may be given several times",
    },
    "gravity": {"action": "store_true", "help": "let the weight act along -z"},
    "sizes": {"metavar": "ARRAY", "help": "how long edges are to be at each point, by this point array of the solid"},
    "distance": {"action": "store_true", "help": "how far the surface is from each point, too, negative inside"},
    "timeout": {"metavar": "S", "type": float, "help": "give a surface up after this many seconds; none by default"},
    "threads": {"metavar": "N", "type": int, "help": "how many threads work, at most four per processor and VTK_SMP_MAX_THREADS; by default one each"},
    "quiet": {"action": "store_true", "help": "print nothing but errors"},
}
"""Arguments for argparse of options that are not a filter's."""

OTHER_FLAGS = {
    "output": ["-o"],
    "surface_treatment": ["--surface"],
    "tag_rules": ["--tag"],
    "quadratic_cells": ["--quadratic"],
    "body_array": ["--bodies"],
    "constrained_facets_array": ["--constrained-array"],
    "non_participating_array": ["--non-participating"],
}
"""Short ones, which help tells, and earlier names, which it does not."""

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
"""All options, in the order in which help tells them."""

BEFORE_FILES = ("EXPRESSION", "POINTS")
"""Operands that are no surfaces and no output."""

_SURFACE = ("SURFACE", f"{' '.join(READABLE_SURFACES)}, also .gz; - standard input")
_SURFACE_OR_SOLID = ("SURFACE|SOLID", f"{_SURFACE[1]}; or tetrahedra ({' '.join(READABLE_SOLIDS)})")
_OUTPUT = (
    "OUTPUT",
    f"tetrahedra ({_GRID_ENDINGS}), or only their watertight boundary ({_SURFACE_ENDINGS}); "
    "{} in the name of any written file stands for the surface's name without folder and ending",
)


@dataclass(frozen=True)
class Command:
    """A word that says what the command is to do."""

    gist: str  # in half a line
    words: str
    operands: tuple[tuple[str, str], ...]  # the files and so on behind it, and what each is
    options: Sequence[str]
    examples: str
    first: Sequence[str] = ()  # the options that one screen describes, where it has no room for all

    def names(self, left_out: Sequence[str] = ()) -> str:
        """The names of the operands."""
        return " ".join(name + "..." * name.startswith("S") for name, _ in self.operands if name not in left_out)

    def by_topic(self) -> dict[str, list[str]]:
        """The options, without topics that have none."""
        chosen = {topic: [name for name in names if name in self.options] for topic, names in TOPICS.items()}
        return {topic: names for topic, names in chosen.items() if names}


COMMANDS: dict[str, Command] = {
    "demo": Command(
        "broken surfaces to try all this on",
        "Write small broken surfaces, and say which commands to try on them.",
        (("[FOLDER]", f"where to, a new folder {DEMO_FOLDER} by default; files that another program wrote stay"),),
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
    the watertight boundary, a picture and a report too
insideout mesh *.stl 'solids/{}.vtu' --boundary 'solids/{}.ply' --timeout 60
    several; {} is each one's name without ending, and a table comes at the end
insideout mesh broken.ply solid.vtu --edge-length 2% --quadratic-cells
    refined to edges of 2 percent of the diagonal, with cells of second order
insideout mesh --together bone.stl fat.ply limb.msh --priority bone
    several bodies in one mesh that conforms: a region for each, where both are that of the bone
insideout mesh parts.obj parts.inp --body-array GroupIds --region-rule all
    the groups of one file as bodies, and a region for each combination
insideout mesh bracket.obj bracket.inp --material steel --fix clamp --pressure load 0.5
    a complete analysis for CalculiX: ccx bracket
zcat broken.obj.gz | insideout mesh - solid.vtu --format obj
    standard input; a .gz is read as it is, too
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
        "what is wrong, and whether it matters",
        "Say what is wrong with a surface, and whether it matters here; or with tetrahedra, and how good they are. Nothing is meshed.",
        (_SURFACE_OR_SOLID,),
        ("plot", *CHECK_OPTIONS, *_UNITS, *(name for name in OF_THE_RUN if name not in _OF_OUTPUT)),
        """\
insideout check broken.ply
    whether it bounds a solid, and what is wrong with it
insideout check solid.vtu --plot angles.png
    what is wrong with tetrahedra, how good they are, and a histogram of their dihedral angles
""",
    ),
    "refine": Command(
        "better tetrahedra of the same solid",
        "Make better tetrahedra of the same solid.",
        (
            ("SOLID", f"tetrahedra ({' '.join(READABLE_SOLIDS)}); their cell array RegionId tells regions apart"),
            ("OUTPUT", f"{_GRID_ENDINGS}; {{}} in the name stands for the solid's name without folder and ending"),
        ),
        ("msh_version", *REFINING_OPTIONS, "sizes", *(name for name in OF_THE_RUN if name != "format")),
        """\
insideout refine solid.vtu better.vtu --edge-length 0.05 --quadratic-cells
    edges of at most this length, and cells of second order
""",
    ),
    "boolean": Command(
        "set operations of broken bodies",
        "Make a set operation of bodies, however broken their surfaces are.",
        (
            (
                "EXPRESSION",
                'such as "A - (B | C) ^ D": | or + is union, & intersection, - difference, ^ symmetric difference; a body is called '
                "like its file without folder and ending, in quotes where that is more than letters, digits and underscores, or by a "
                "letter, A the first, or #1",
            ),
            _SURFACE,
            ("OUTPUT", f"the result's surface ({_SURFACE_ENDINGS}), or its tetrahedra ({_GRID_ENDINGS})"),
        ),
        (*BOOLEAN_OPTIONS, *_UNITS, *OF_THE_RUN),
        """\
insideout boolean "bone - (fat | C)" bone.stl fat.ply skin.obj rest.stl
    its surface, or with .vtu its tetrahedra
""",
    ),
    "query": Command(
        "winding numbers and distances",
        "Evaluate the winding number at points, say which of them are inside, and how far the surface is. Nothing is meshed.",
        (
            ("POINTS", f"a .csv file with the columns x, y, z, or an image ({QUERIES[1]}), whose points are meant"),
            (_SURFACE[0], _SURFACE[1] + "; or points with normals, without faces"),
            ("OUTPUT", "the points with w and what is inside; it has the ending of POINTS"),
        ),
        ("distance", *WINDING_OPTIONS, *_UNITS, *OF_THE_RUN),
        """\
insideout query grid.vti broken.ply w.vti --distance
    the winding number at points of yours, and how far the surface is, without a mesh
""",
    ),
    "draw": Command(
        "defects, winding numbers, tetrahedra",
        "Draw a picture, without a window, of a surface and what becomes of it, or of how good tetrahedra are.",
        (_SURFACE_OR_SOLID, ("PICTURE.png", "the defects, a slice of w, and the tetrahedra, as .html to turn and to cut; of a solid, a histogram of dihedral angles")),
        ["defects", "marked", *(name for name in (*MESH_OPTIONS, *_UNITS, *OF_THE_RUN) if name not in (*_MESH_FILES, "surface_only", *LAYER_OPTIONS))],
        """\
insideout draw broken.ply picture.png
    the surface's defects, a slice of w, and the tetrahedra inside
insideout draw broken.ply page.html
    the same to turn, and to cut with a slider, with the report, in any browser
insideout draw broken.ply wrong.png --defects --marked wrong.vtp
    only what is wrong, without meshing; and the same to look at in ParaView
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
