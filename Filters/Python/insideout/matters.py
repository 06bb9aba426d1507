# SPDX-License-Identifier: GPL-3.0-or-later
"""Options without effect on the command's task: each is refused before any file is read, with the reason."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from typing import Callable, Optional, Sequence

from .files import READABLE_SOLIDS, WRITABLE_SURFACES, ending
from .options import LAYER_OPTIONS, OPTIONS, REFINING_OPTIONS, flag_of
from .usage import BOOLEAN_OPTIONS, CHECK_OPTIONS, DECK_OPTIONS, MESH_OPTIONS, WINDING_OPTIONS

WHY_NOT = {"check": "meshes nothing", "query": "meshes nothing", "boolean": "makes one thing of several bodies"}
"""The reasons why commands take no options of `mesh`."""

_OF_COMMANDS = {"check": CHECK_OPTIONS, "query": WINDING_OPTIONS, "boolean": BOOLEAN_OPTIONS}
"""The options of `mesh` that these commands take."""


@dataclass(frozen=True)
class Asked:
    """The command's task."""

    options: argparse.Namespace
    surfaces: Sequence[str]

    def has(self, *names: str) -> bool:
        """Whether one of some options is given."""
        return any(getattr(self.options, name, None) is not None for name in names)

    def flag(self, name: str) -> str:
        """The spelling of an option that is given."""
        return "--no-" + name if getattr(self.options, name) is False else flag_of(name)

    def solid(self) -> Optional[str]:
        """A solid that is drawn or checked instead of a surface."""
        if self.options.command not in ("check", "draw"):
            return None
        return next((path for path in self.surfaces if ending(path) in READABLE_SOLIDS), None)

    def has_solids_alone(self) -> bool:
        return all(ending(path) in READABLE_SOLIDS for path in self.surfaces)

    def writes_surface(self) -> bool:
        return ending(self.options.output or "") in WRITABLE_SURFACES

    def treatment(self) -> str:
        """The treatment of the surface's triangles."""
        given = getattr(self.options, "surface_treatment", "automatic")
        if given != "automatic":
            return given
        is_parted = getattr(self.options, "non_manifold", None) == "split"
        is_kept = is_parted or self.has("separate_overlaps", "merge_coplanar_pieces", "split_seams")
        return "remeshed" if self.has("edge_length", "sizes") and not is_kept else "kept"

    def keeps_boundary(self) -> bool:
        """Whether the only output is a boundary that refinement does not change."""
        return self.treatment() == "kept" and self.writes_surface() and not self.has("plot", "report", "json")

    def has_bodies(self) -> bool:
        return self.has("together", "body_array") or self.options.command == "boolean"


@dataclass(frozen=True)
class Rule:
    """The cases in which some options have no effect, and the reasons."""

    names: Sequence[str]
    holds: Callable[[Asked], bool]
    reason: str


RULES = (
    Rule(REFINING_OPTIONS, lambda asked: getattr(asked.options, "refine", None) is False, "--no-refine leaves the cells as they are"),
    Rule(LAYER_OPTIONS, lambda asked: getattr(asked.options, "refine", None) is False, "layers take refined cells, and --no-refine leaves them as they are"),
    Rule(LAYER_OPTIONS, Asked.writes_surface, "a surface has no layers"),
    Rule(("quadratic_cells",), Asked.writes_surface, "a surface has triangles of first order"),
    Rule(
        ("refine", "edge_length", "grading", "maximum_volume"),
        Asked.keeps_boundary,
        "the boundary stays as it is without --edge-length, or --surface-treatment split or remeshed",
    ),
    Rule(
        ("surface_tolerance", "feature_angle"),
        lambda asked: asked.treatment() != "remeshed",
        "it takes --edge-length or --surface-treatment remeshed",
    ),
    Rule(DECK_OPTIONS, lambda asked: ending(asked.options.output or "") != ".inp", "it completes an .inp file"),
    Rule(DECK_OPTIONS[1:], lambda asked: not asked.has("material"), "it takes --material"),
    Rule(("material",), lambda asked: not asked.has("fix"), "it takes --fix, because there is no equilibrium without a support"),
    Rule(("thicken_all",), lambda asked: not asked.has("thicken"), "it takes --thicken"),
    Rule(("seeded_regions",), lambda asked: not asked.has("seeds"), "it takes --seeds"),
    Rule(("priority", "region_rule", "touch_tolerance"), lambda asked: not asked.has_bodies(), "it takes several bodies, by --together or --body-array"),
    Rule(("body_array",), lambda asked: asked.has("together"), "--together makes a body of each surface"),
    Rule(("format",), lambda asked: "-" not in asked.surfaces, "it is for standard input, and goes with - as SURFACE"),
    Rule(
        ("msh_version",),
        lambda asked: ".msh" not in (ending(asked.options.output or ""), ending(asked.options.hull or "")),
        "it is for .msh files, and none is to be written",
    ),
    Rule(("cells_only",), lambda asked: ending(asked.options.output or "") not in (".msh", ".inp", ".mesh"), "it is for .msh, .inp and .mesh files"),
    Rule(("cells_only",), lambda asked: asked.has("material"), "supports and loads take tags"),
    Rule(("from",), lambda asked: not asked.has("to"), "it takes --to"),
    Rule(("to",), lambda asked: not asked.has("from"), "it takes --from"),
    Rule(("scale",), lambda asked: asked.has("from"), "--from and --to are a scale"),
    Rule(("json",), lambda asked: asked.has("quiet"), "--quiet prints nothing"),
)


def refusal(options: argparse.Namespace, surfaces: Sequence[str]) -> Optional[str]:
    """One line about the first option without effect; None if there is none."""
    asked = Asked(options, surfaces)
    return next((line for line in (_of_command(asked), _of_solid(asked), _of_defects(asked), _by_rules(asked)) if line), None)


def _of_command(asked: Asked) -> Optional[str]:
    """Options of `mesh`, which the short form accepts for all commands."""
    options = asked.options
    if options.command not in _OF_COMMANDS:
        return None
    usable = {*_OF_COMMANDS[options.command]} | ({"plot"} if options.command == "check" and asked.has_solids_alone() else set())
    others = (*MESH_OPTIONS, *DECK_OPTIONS, *(("output", "force", "dry_run") if options.command == "check" else ()))
    found = next((name for name in others if name not in usable and asked.has(name)), None)
    return found and f"{options.called} {WHY_NOT[options.command]}: it goes without {asked.flag(found)}"


def _of_solid(asked: Asked) -> Optional[str]:
    """Options of surfaces, if the input is a solid."""
    solid = asked.solid()
    names = ("from", "to", "together", "defects", "marked", *OPTIONS)
    found = solid and next((name for name in names if name != "surface_only" and asked.has(name)), None)
    return found and f"{asked.flag(found)} is about surfaces: it goes without {solid}"


def _of_defects(asked: Asked) -> Optional[str]:
    """Options of meshing, if a picture shows the defects alone."""
    if not asked.has("defects"):
        return None
    usable = (*CHECK_OPTIONS, "plot", "surface_only")
    found = next((name for name in MESH_OPTIONS if name not in usable and asked.has(name)), None)
    return found and f"--defects meshes nothing: it goes without {asked.flag(found)}"


def _by_rules(asked: Asked) -> Optional[str]:
    return next(
        (f"{asked.flag(name)} cannot matter here: {rule.reason}" for rule in RULES for name in rule.names if asked.has(name) and rule.holds(asked)),
        None,
    )
