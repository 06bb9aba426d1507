# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a surface bounds a solid: the sentence with which `check` and every run begin."""

from __future__ import annotations

from typing import Mapping, Sequence


def verdict(statistics: Mapping[str, float]) -> str:
    """In one sentence, by the statistics of vtkSurfaceDefects or of a filter that finds winding numbers. Of a solid that
    was made it tells the volume."""
    if statistics.get("Dimension", 3) == 2:
        return verdict_in_a_plane(statistics)
    sentence, made = _verdict_by_shells(statistics), statistics.get("Volume", 0)
    if made > 0 and sentence.startswith("bounds no solid"):
        return f"means a solid of volume {made:.6g}, by its winding number; its shells alone bound none"
    return sentence


def _verdict_by_shells(statistics: Mapping[str, float]) -> str:
    solids = statistics["ClosedShells"] + statistics["HoledShells"]
    sheets = counted(statistics["SheetShells"], "sheet")
    if statistics.get("Planar", 0):
        area = statistics.get("Area", 0)
        return "bounds no solid: it lies in one plane" + (f", where it covers an area of {area:.6g}" if area > 0 else "")
    if statistics["Shells"] == 0:
        return "bounds no solid: its facets cancel in pairs or do not count"
    if solids == 0:
        return f"bounds no solid: {sheets}"
    if statistics["EnclosedVolume"] <= 0:
        return "bounds no solid as it is oriented: it is inside out"
    if statistics["DisagreeingFacets"] > 0 and statistics["TurnedFacets"] in (0, statistics["Facets"]):
        facets = counted(statistics["DisagreeingFacets"], "facet")
        return f"bounds no solid as it is oriented: {facets} against those around"
    # Where shells are closed and meet nothing the volume is theirs; else it is found by sample lines.
    is_sampled = statistics["HoledShells"] + statistics["OverlapVolume"] + statistics.get("IntersectingPairs", 0) > 0
    volume = f"about {statistics['EnclosedVolume']:.3g}" if is_sampled else f"{statistics['EnclosedVolume']:.6g}"
    if statistics.get("Volume", 0) > 0:
        volume = f"{statistics['Volume']:.6g}"
    sentence = f"bounds a solid of volume {volume}"
    if statistics["TurnedShells"] >= solids:
        sentence += " after it is turned over as a whole"
    elif statistics["TurnedShells"] > 0:
        sentence += f" after turning {int(statistics['TurnedShells']):,} of {counted(statistics['Shells'], 'shell')} over"
    elif statistics["TurnedFacets"] > 0:
        sentence += f" after turning {counted(statistics['TurnedFacets'], 'facet')} over"
    if statistics["HoledShells"] > 0:
        sentence += ", once its holes are closed"
    if statistics.get("Membranes", 0) > 0:
        sentence += f", parted by {counted(statistics['Membranes'], 'membrane')}"
    if statistics["SheetShells"] > 0:
        verb = "encloses" if statistics["SheetShells"] == 1 else "enclose"
        sentence += f"; {sheets} {verb} nothing"
    return sentence


def verdict_in_a_plane(statistics: Mapping[str, float]) -> str:
    """The same of lines."""
    if statistics["Area"] <= 0:
        return "bounds no area in its plane"
    sentence = f"bounds an area of {statistics['Area']:.6g} in a plane"
    if statistics["TurnedSegments"] > 0:
        sentence += f" after turning {int(statistics['TurnedSegments']):,} of {counted(statistics['InputSegments'], 'segment')} over"
    if statistics["OpenEnds"] > 0:
        sentence += ", once its gaps are closed"
    rules = (("AreaByWindingNumber", "by the winding number"), ("AreaByEvenOdd", "by even-odd"), ("AreaAsGiven", "as given"))
    told = [f"{statistics[name]:.6g} {rule}" for name, rule in rules if name in statistics]
    return f"{sentence}: {', '.join(told)}" if told else sentence


def what_it_bounds(statistics: Mapping[str, float]) -> list[str]:
    """More about the solid and what is none, one line each."""
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
    if statistics["OverlapVolume"] > 0:
        lines.append(f"they overlap in a volume of about {statistics['OverlapVolume']:.2g}")
    if statistics["OpenEdges"] > 0:
        across = statistics["OpenLength"] / statistics["Diagonal"]
        lines.append(f"its open boundary is {across:.2g} times as long as the surface is across")
    if statistics["SheetShare"] > 0:
        share = f"about {100 * statistics['SheetShare']:.2g} %" if statistics["SheetShare"] < 0.995 else "all"
        lines.append(f"{share} of the area encloses nothing")
    return lines


def volumes_of_shells(volumes: Sequence[float], most: int = 8) -> list[str]:
    """The largest of several, a line each."""
    order = sorted(range(len(volumes)), key=lambda shell: (-abs(volumes[shell]), shell))
    if len(order) < 2:
        return []
    kinds = {1: "", 0: " (a sheet)", -1: " (a cavity)"}
    lines = [f"shell {shell}: volume {volumes[shell]:.6g}{kinds[(volumes[shell] > 0) - (volumes[shell] < 0)]}" for shell in order[:most]]
    return [*lines, f"and {len(order) - most:,} smaller ones"] if len(order) > most else lines


def counted(count: float, one: str) -> str:
    """ "1 sheet", "2 sheets"; for one only "a sheet"."""
    return f"a {one}" if count == 1 and one == "sheet" else f"{int(count):,} {one}{'' if count == 1 else 's'}"
