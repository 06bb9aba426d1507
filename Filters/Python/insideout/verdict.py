# SPDX-License-Identifier: GPL-3.0-or-later
"""The verdict: the sentence with which `check` and every run begin."""

from __future__ import annotations

from typing import Mapping, Sequence

from .pipeline import fields_of
from .vtkFiltersInsideOut import vtkSurfaceDefects

MOST_LINES = 10
"""Limit of the lines that a summary has about the surface."""


def verdict(statistics: Mapping[str, float]) -> str:
    """One sentence on whether the surface bounds a solid, from the statistics of vtkSurfaceDefects or of a filter that
    makes a solid. Statistics of a solid give its volume."""
    return vtkSurfaceDefects.GetVerdictOf(fields_of(statistics))


def what_it_bounds(statistics: Mapping[str, float]) -> list[str]:
    """Further lines about the solid and the parts that enclose nothing."""
    kinds = (("ClosedShells", "closed"), ("HoledShells", "with holes"), ("Membranes", "membrane"), ("SheetShells", "sheet"))
    shells = [
        f"{int(statistics[name]):,} {words}{'s' if words in ('membrane', 'sheet') and statistics[name] != 1 else ''}"
        for name, words in kinds
        if statistics.get(name, 0) > 0
    ]
    if len(shells) == 1:
        shells = [shells[0].split(" ", 1)[1]]
    lines = [f"{counted(statistics['Shells'], 'shell')}: {', '.join(shells)}"] if shells else []
    if statistics["Cavities"] > 0:
        lines.append(f"{int(statistics['Cavities']):,} of them inward within others: cavities")
    if statistics.get("OverlapVolume", 0) > 0:
        volume = statistics["OverlapVolume"]
        bounds = (statistics.get(f"OverlapVolume{end}", volume) for end in ("Low", "High"))
        lines.append(f"they overlap in a volume of {vtkSurfaceDefects.GetVolumeInWords(volume, *bounds)}")
    if statistics["OpenEdges"] > 0:
        across = statistics["OpenLength"] / statistics["Diagonal"]
        lines.append(f"its open boundary is {across:.2g} times as long as the surface is across")
    if statistics["SheetShare"] > 0:
        share = f"about {100 * statistics['SheetShare']:.2g} %" if statistics["SheetShare"] < 0.995 else "all"
        lines.append(f"{share} of the area encloses nothing")
    return lines


def in_few_lines(lines: Sequence[str], most: int = MOST_LINES) -> list[str]:
    """At most `most` lines; the last one summarizes the rest."""
    return [*lines] if len(lines) <= most else [*lines[: most - 1], "; ".join([lines[most - 1], *(line.strip() for line in lines[most:])])]


def volumes_of_shells(volumes: Sequence[float], most: int) -> list[str]:
    """The largest volumes in at most `most` lines; the last one may count the rest. Empty for one shell."""
    order = sorted(range(len(volumes)), key=lambda shell: (-abs(volumes[shell]), shell))
    if len(order) < 2:
        return []
    kinds = {1: "", 0: " (a sheet)", -1: " (a cavity)"}
    lines = [f"shell {shell}: volume {volumes[shell]:.6g}{kinds[(volumes[shell] > 0) - (volumes[shell] < 0)]}" for shell in order[:most]]
    return [*lines[:-1], f"and {len(order) - most + 1:,} smaller ones"] if len(order) > most else lines


def counted(count: float, one: str) -> str:
    """ "1 sheet", "2 sheets"; for one only "a sheet"."""
    return f"a {one}" if count == 1 and one == "sheet" else f"{int(count):,} {one}{'' if count == 1 else 's'}"
