# SPDX-License-Identifier: GPL-3.0-or-later
"""`check_solid`: the defects of tetrahedra, and their quality."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Union

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkFieldData, vtkUnstructuredGrid

from .calling import for_users
from .checking import Finding, find_among
from .data import LayeredCells, Tetrahedra, as_type, has_layers
from .defects import Defect
from .options import in_words_of_python
from .pipeline import Progress, add_statistic, run, statistics_of
from .results import MeshResult
from .solids import AnySolid, as_solid
from .statistics import Statistics
from .vtkFiltersInsideOut import vtkSolidQuality

# Most important first.
SOLID_DEFECTS = (
    Defect(*("NegativeCells", "negative cell", "negative cells"), "their points run the wrong way, or they are turned inside out: solvers refuse them", True),
    Defect(*("FlatCells", "flat cell", "flat cells"), "they have no volume, exactly: solvers divide by it", True),
    Defect(
        *("RefusedCells", "cell that a solver refuses", "cells that a solver refuses"),
        "their Jacobian determinants are below CalculiX's limit of 1e-20: it stops",
        True,
    ),
    Defect(*("CrowdedFaces", "face of more than two cells", "faces of more than two cells"), "cells overlap there", True),
    Defect(*("OverlappingFaces", "face with both cells on one side", "faces with both cells on one side"), "they overlap", True),
    Defect(
        *("ContactPairs", "pair of boundary faces that meet", "pairs of boundary faces that meet"),
        "beyond the points and edges that they share: cells overlap, or do not fit together",
        True,
    ),
    Defect(
        *("HingedParts", "part held by points or edges alone", "parts held by points or edges alone"),
        "mechanics lets each turn there: hold it, or fill where the solid touches itself",
    ),
    Defect(
        *("PoorCells", "cell that a solver suffers from", "cells that a solver suffers from"),
        "they have dihedral angles under 1 degree: it takes longer, and loses digits",
    ),
    Defect(
        *("CellsUnder5Degrees", "cell with a dihedral angle under 5 degrees", "cells with a dihedral angle under 5 degrees"),
        "solvers take longer, and are less exact; the surface itself is as sharp along {SurfaceEdgesUnder5Degrees:,} edges",
    ),
)


@dataclass(frozen=True, repr=False)
class SolidCheck(MeshResult):
    """The result of `check_solid`. The VTK class vtkSolidQuality describes the arrays and statistics."""

    solid: Union[Tetrahedra, LayeredCells]
    """The solid with the quality of each cell. Its field data are the measurements instead of those of the input."""
    statistics: Statistics
    """Counts, angles and ratios by name."""
    histogram: list[int]
    """The number of dihedral angles per 5 degrees, from 0 to 180."""
    findings: list[Finding]
    """The defects, most important first; empty if there are none."""
    verdict: str
    """One sentence: whether a solver accepts the mesh."""
    warnings: list[str]
    """Warnings about the input, one line each."""

    def figures(self) -> list[tuple[str, str]]:
        return [
            ("", self.verdict),
            *topology_rows(self.statistics),
            *quality_rows(self.statistics),
            *((finding.text, finding.consequence) for finding in self.findings),
            *(("", warning) for warning in self.warnings),
        ]

    def seen(self) -> dict[str, Any]:
        return {"quality": self.solid}


_TREATMENTS = ("RefinedCells", "SurfaceDistance", "KeptByOptions")
"""Statistics that show which advice was already followed."""


@for_users
def check_solid(solid: AnySolid, *, progress: Optional[Progress] = None) -> SolidCheck:
    """Find the defects of a solid of tetrahedra and layers of prisms, and the quality of its cells. Nothing is changed.

    solid     a vtkUnstructuredGrid of tetrahedra, of first or second order, and layers; the name of a .vtu, .msh,
              .inp or .mesh file; a pair (points, cells) of arrays; a meshio.Mesh; or a VTK algorithm
    progress  called with the stage and the fraction of all the work that is done

    Flat, negative and non-conforming cells are found exactly; cells that a solver refuses, in doubles as it computes. A
    warning names the option that helps. Returns a `SolidCheck`. Raises `Error` with one line that names the culprit if
    the input is not a solid.
    """
    measure = vtkSolidQuality()
    grid, warnings = as_solid(solid)
    bare = vtkUnstructuredGrid()
    bare.ShallowCopy(grid)
    bare.SetFieldData(vtkFieldData())  # statistics of another run are not this one's
    told = {name: value for name, value in statistics_of(grid).items() if name in _TREATMENTS}
    for name, value in told.items():
        add_statistic(name, value, bare)
    measure.SetInputData(bare)
    warnings = warnings + in_words_of_python(run(measure, progress))
    statistics = Statistics({name: value for name, value in statistics_of(measure.GetOutput()).items() if name not in told})
    return SolidCheck(
        solid=as_type(LayeredCells if has_layers(grid) else Tetrahedra, measure.GetOutput()),
        statistics=statistics,
        histogram=vtk_to_numpy(measure.GetOutput().GetFieldData().GetArray("DihedralAngleHistogram")).tolist(),
        findings=find_among(SOLID_DEFECTS, {**statistics, "HingedParts": hinged_parts(statistics)}),
        verdict=solid_verdict(statistics),
        warnings=warnings,
    )


def hinged_parts(statistics: Mapping[str, float]) -> int:
    """The parts connected through faces, less those through points; 0 of a non-conforming solid."""
    return int(statistics["Regions"] - statistics.get("SolidComponents", statistics["Regions"]))


def solid_verdict(statistics: Mapping[str, float]) -> str:
    """In one sentence."""
    cells, regions = (int(statistics[name]) for name in ("Cells", "Regions"))
    layers = {name: int(statistics.get(name.capitalize(), 0)) for name in ("pyramids", "prisms")}
    counts = [f"{count:,} {name}" for name, count in layers.items() if count > 0]
    mesh = " and ".join([", ".join([f"{cells - sum(layers.values()):,} tetrahedra", *counts[:-1]]), *counts[-1:]])
    mesh += f" in {regions:,} {'part' if regions == 1 else 'parts'}"
    wrong = [defect.counted(statistics[defect.statistic]) for defect in SOLID_DEFECTS[:3] if statistics[defect.statistic] > 0]
    positive = " and ".join(wrong) if wrong else "all positive"
    if not statistics["Conforms"]:
        return f"{mesh} that do not conform; {positive}"
    return f"{mesh}, conforming, the boundary watertight; {positive}"


def topology_rows(statistics: Mapping[str, float]) -> list[tuple[str, str]]:
    """The solid's topology in words; empty for a non-conforming one."""
    if "SolidComponents" not in statistics:
        return []
    parts = []
    for name, one, many in (("Components", "component", "components"), ("Tunnels", "tunnel", "tunnels"), ("Cavities", "cavity", "cavities")):
        count = int(statistics["Solid" + name])
        parts.append(f"{count:,} {one if count == 1 else many}")
    euler, genus = statistics["SolidEulerCharacteristic"], statistics["Genus"]
    return [("topology", f"{', '.join(parts)}; Euler characteristic {euler:,.0f}, genus of the boundary {genus:,g}")]


def quality_rows(statistics: Mapping[str, float]) -> list[tuple[str, str]]:
    """The figures as pairs of name and value."""
    least, one_percent, largest = (statistics[name] for name in ("MinDihedralAngle", "DihedralAngle1Percent", "MaxDihedralAngle"))
    rows = [
        ("dihedral angles", f"{least:.3g} to {largest:.4g} degrees, 1 % of them up to {one_percent:.3g}"),
        ("radius-edge ratio", f"up to {statistics['MaxRadiusEdgeRatio']:.3g}, of 99 % up to {statistics['RadiusEdgeRatio99Percent']:.3g}"),
        ("mean ratio", f"from {statistics['MinMeanRatio']:.3g}, on average {statistics['AverageMeanRatio']:.3g}; 1 is best"),
    ]
    for degrees in (10, 5):
        cells, edges = (int(statistics[f"{what}Under{degrees}Degrees"]) for what in ("Cells", "SurfaceEdges"))
        rows.append((f"under {degrees} degrees", f"{cells:,} cells; {edges:,} edges of the surface itself"))
    return rows
