# SPDX-License-Identifier: GPL-3.0-or-later
"""The possible defects of a surface, in words."""

from typing import NamedTuple


class Defect(NamedTuple):
    """One kind of defect."""

    statistic: str  # the filters' name of its count
    one: str
    several: str
    consequence: str = ""  # how InsideOut treats it; empty for defects that only a mesh can show
    matters: bool = False  # whether the solid may be wrong or missing

    def counted(self, count: float) -> str:
        """The count in words."""
        return f"{int(count):,} {self.one if count == 1 else self.several}"


# Most important first.
DEFECTS = (
    Defect(
        *("InconsistentEdges", "inconsistent edge", "inconsistent edges"),
        "two facets face opposite ways there: those that disagree with the rest of what they are joined to are turned over",
    ),
    Defect(
        *("UndecidedShells", "part that could equally face the other way", "parts that could equally face the other way"),
        "what they enclose may be solid or not: the orientation says what is done with them",
        matters=True,
    ),
    Defect(
        *("TurnedFacets", "facet that faces the wrong way", "facets that face the wrong way"),
        "turned over, as far as can be told from what they enclose; cavities are left",
    ),
    Defect(
        *("NearPoints", "near-coincident point", "near-coincident points"),
        "parts that should be joined there may be torn: if so, set the merge tolerance to {NearDistance:.2g}",
        matters=True,
    ),
    Defect(
        *("TwoSidedSheets", "two-sided sheet", "two-sided sheets"),
        "sheets shape the mesh but bound nothing: give them a thickness where they are meant to be solid",
        matters=True,
    ),
    Defect(
        *("OpenEdges", "open edge", "open edges"),
        "holes are closed where the winding number passes 1/2; look at the result where they are large",
    ),
    Defect("IntersectingPairs", "intersecting pair", "intersecting pairs", "facets are cut where they meet, exactly"),
    Defect("NonManifoldEdges", "non-manifold edge", "non-manifold edges", "edges may have any number of facets"),
    Defect("DuplicateFacets", "duplicate facet", "duplicate facets", "copies count where closed shells need them"),
    Defect(
        *("CancelledFacets", "facet cancelled by its opposite", "facets cancelled by their opposites"),
        "such facets shape the mesh but bound nothing, like walls within a solid",
    ),
    Defect("TwoSidedSolids", "two-sided component", "two-sided components", "solids are kept once, turned outward"),
    Defect("DegenerateFacets", "degenerate facet", "degenerate facets", "without area, and left out"),
    Defect("NonParticipatingFacets", "facet that does not count, as asked", "facets that do not count, as asked"),
    Defect("LeftOutFacets", "facet that could not be resolved", "facets that could not be resolved"),
    Defect("LostFacets", "facet that the mesh does not follow", "facets that the mesh does not follow"),
)

# In two dimensions.
PLANAR_DEFECTS = (
    Defect(
        *("OpenEnds", "open end", "open ends"),
        "gaps are closed where the winding number passes 1/2; look at the result where they are large",
    ),
    Defect("IntersectingPairs", "intersecting pair", "intersecting pairs", "segments are cut where they meet, exactly"),
    Defect("Crossings", "crossing", "crossings", "each becomes a point of the mesh"),
    Defect("TJunctions", "T-junction", "T-junctions", "the segment that the point lies within is cut there"),
    Defect(
        *("TurnedSegments", "segment that runs the wrong way", "segments that run the wrong way"),
        "turned over, as far as can be told from what they enclose; holes are left",
    ),
    Defect("DuplicateSegments", "duplicate segment", "duplicate segments", "segments count once per direction"),
    Defect(
        *("CancelledSegments", "segment cancelled by its opposite", "segments cancelled by their opposites"),
        "such segments shape the mesh but bound nothing",
    ),
    Defect("TwoSidedCurves", "two-sided closed curve", "two-sided closed curves", "kept once, turned counter-clockwise"),
    Defect("DegenerateSegments", "degenerate segment", "degenerate segments", "without length, and left out"),
    Defect("LeftOutSegments", "segment that could not be resolved", "segments that could not be resolved"),
)
