# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of a result by groups."""

from __future__ import annotations

import re
from typing import Any, Dict

from .packages import import_package

GROUPS = {
    "input": "Input|Points$|Facets$|Segments$|Dimension|Scale|Diagonal|Planar|Bodies|Places",
    "defects": "Open|NonManifoldEdges|Inconsistent|Unbalanced|Intersecting|Merged|Near|Degenerate|Duplicate|Cancelled|TwoSided"
    "|NonParticipating|Crossings|TJunctions|Gap|Touch",
    "shells": "Components$|Closed$|.*Shells$|SharedFacets|Sheet|Membrane|Cavities$|EnclosedVolume|OverlapVolume|Turned|Disagreeing|Undecided|Uncounted|Doubtful|Thickened",
    "resolved surface": "Resolved|LeftOut",
    "layers": "Layer|Prisms|Pyramids|Wall|Reduced|Bare|FullHeight|MeanHeight",
    "mesh of the hull": "Rung|Hull|.*Steiner|Lost(Facets|Segments)|PartsApart|Tetrahedra$",
    "winding number and cut": "MinimumW|MaximumW|Energy|Forced|Changed|Unsatisfied|Seed|Shared",
    "topology, as asked for": "Dropped|Filled|Joined|NonManifoldPoints|Overlaps$|Separated|Copied|SplitPoints",
    "solid": "Inside|Regions|Volume|Area|CenterOfMass|Inertia|Cells$|Negative|Flat|Crowded|Overlapping|Contact|Conforms",
    "boundary": "BoundaryFaces|Seam|Tags",
    "shape of the solid": "Solid(Components|Tunnels|Cavities|EulerCharacteristic)|Boundary|Genus",
    "outliers": "Outlier|LostShare",
    "refinement": "Added|Removed|Refined|Surface(Points|Tolerance|Distance)|InputDistance|Kept(Facets|ByOptions)",
    "quality before": "Before",
    "quality": "M(in|ax|inimum|aximum|ean|edian).*|Average|Dihedral|Angle|RadiusEdge|CellsUnder|SurfaceEdgesUnder|Refused|Poor",
    "time and memory": "Seconds|PeakMemory",
}
"""Groups by regular expressions for the beginnings of names: the first match counts."""

OTHER = "other"


def group_of(name: str) -> str:
    return next((group for group, names in GROUPS.items() if re.match(names, name)), OTHER)


class Statistics(Dict[str, float]):
    """A dict of figures by name, printed by groups."""

    @property
    def groups(self) -> dict[str, dict[str, float]]:
        """The same figures by group and name."""
        groups: dict[str, dict[str, float]] = {group: {} for group in (*GROUPS, OTHER)}
        for name, value in self.items():
            groups[group_of(name)][name] = value
        return {group: figures for group, figures in groups.items() if figures}

    def to_pandas(self) -> Any:
        """A pandas.Series by group and name. Several are the columns of a table: pandas.DataFrame({"left": ..., "right": ...})."""
        pandas = import_package("pandas")
        index = [(group, name) for group, figures in self.groups.items() for name in figures]
        names = pandas.MultiIndex.from_tuples(index, names=("group", "statistic"))
        return pandas.Series([self[name] for _, name in index], index=names, name="value", dtype=float)

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        lines = []
        for group, figures in self.groups.items():
            lines += [group, *(f"  {name:<{width}}  {value:>12,.6g}" for name, value in figures.items())]
        return "\n".join(lines)
