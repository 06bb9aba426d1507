# SPDX-License-Identifier: GPL-3.0-or-later
"""Material, supports and loads that complete an .inp file for a static analysis with CalculiX."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Sequence

from .errors import ArgumentError, Error
from .lengths import UNITS

MATERIALS = {"steel": (2.1e11, 0.3, 7850.0), "aluminum": (7e10, 0.33, 2700.0), "titanium": (1.1e11, 0.34, 4500.0)}
"""Young's modulus in pascals, Poisson's ratio, and density in kilograms per cubic meter."""

GRAVITY = 9.80665  # meters per second squared

USUAL_UNIT = "mm"


@dataclass(frozen=True)
class Deck:
    """A static analysis of a solid. Units are consistent, with forces in newtons: millimeters go with megapascals and
    tonnes."""

    material: str
    fixed: Sequence[str]
    """The tags whose points are fixed."""
    pressures: Sequence[Sequence[str]]
    """Tags and the pressures on them, in newtons per squared unit."""
    has_weight: bool
    unit: str = USUAL_UNIT

    def __post_init__(self) -> None:
        for tag, value in self.pressures:
            try:
                is_finite = math.isfinite(float(value))
            except ValueError:
                is_finite = False
            if not is_finite:
                raise ArgumentError(f"--pressure {tag} is {value}; it must be a number")

    def tags(self) -> list[str]:
        return [*self.fixed, *(tag for tag, _ in self.pressures)]

    def text_behind(self, mesh: str) -> str:
        """The lines to append to those of a mesh. Raises `Error` for a tag that the mesh does not have."""
        names = _names_of_sets(mesh, self.tags())
        modulus, ratio, density = MATERIALS[self.material]
        meters = float(UNITS[self.unit])
        steps = [f"*DSLOAD\n{names[tag]}, P, {float(value):.15g}\n" for tag, value in self.pressures]
        steps += [f"*DLOAD\nEall, GRAV, {GRAVITY / meters:.15g}, 0, 0, -1\n"] if self.has_weight else []
        return (
            f"** Static analysis in {self.unit}, newtons and seconds\n"
            f"*MATERIAL, NAME={self.material}\n*ELASTIC\n{modulus * meters**2:.15g}, {ratio:g}\n*DENSITY\n{density * meters**4:.15g}\n"
            f"*SOLID SECTION, ELSET=Eall, MATERIAL={self.material}\n"
            f"*BOUNDARY\n{''.join(f'{names[tag]}, 1, 3{chr(10)}' for tag in self.fixed)}"
            f"*STEP\n*STATIC\n{''.join(steps)}"
            f"{''.join(f'*NODE PRINT, NSET={names[tag]}, TOTALS=ONLY{chr(10)}RF{chr(10)}' for tag in self.fixed)}"
            "*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n"
        )


def _names_of_sets(mesh: str, tags: Sequence[str]) -> dict[str, str]:
    """The names of the sets of tags in an .inp file, by tag. Raises `Error` for a tag that is missing or not unique.
    """
    found = re.findall(r"^\*\* (\w+): tag \d+, (.*)$", mesh, re.MULTILINE)
    for tag in tags:
        sets = [name for name, other in found if other == tag]
        if len(sets) > 1:
            raise Error(f"{len(sets)} tags are called {tag}: give them different names")
        if not sets and all(tag != name for name, _ in found):
            raise Error(f"there is no tag {tag}: the boundary has {', '.join(dict.fromkeys(other for _, other in found))}")
    return {**{name: name for name, _ in found}, **{tag: name for name, tag in found}}
