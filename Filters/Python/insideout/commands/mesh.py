# SPDX-License-Identifier: GPL-3.0-or-later
"""`insideout mesh`: tetrahedra of the solid that a surface means."""

from __future__ import annotations

import os
import time
from dataclasses import replace
from typing import Any, Iterator, Optional, Sequence

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..bodies import outer_boundary
from ..curves import CURVE
from ..data import Tetrahedra, TriangleSurface
from ..deck import USUAL_UNIT, Deck
from ..drawing import DRAWINGS, check_display, draw, refuse_page_of_plane, up_of
from ..errors import ArgumentError
from ..files import WRITABLE_SURFACES, are_lines, check_holds_lines, ending, input_ending, write_surface
from ..hints import hints_for_printing
from ..interruption import work_on
from ..options import LAYER_OPTIONS, OPTIONS, flag_of
from ..pipeline import Error
from ..solid_files import WRITABLE_GRIDS, MshVersion, check_holds_triangles, is_for_solver, write_solid, written_beside
from ..stages import DRAWING, LAYERS, REFINE, TETRAHEDRALIZE, WRITING
from ..summary import defects, seams, summary, tetrahedralizer
from ..tetrahedralization import Region, Tetrahedralization, tetrahedralize
from ..usage import CHECK_OPTIONS
from ..verdict import verdict
from ..vtkFiltersInsideOut import vtkBoundaryLayers, vtkRobustTetrahedralize, vtkRobustTriangulate
from ..xdmf import XDMF, boundary_beside
from .job import Job


class MeshJob(Job):
    """One run that makes tetrahedra."""

    stages: Sequence[str] = TETRAHEDRALIZE
    left_out_cells: list[int] = []
    lost_cells: list[int] = []
    regions: list[Region] = []
    bodies: dict[str, float] = {}
    tags: dict[str, int] = {}
    hints: list[str] = []
    deck: Optional[Deck] = None

    def check_parameters(self) -> dict[str, Any]:
        options = self.options
        if options.material is not None:
            pressures = options.pressure or []
            self.deck = Deck(options.material, options.fix, pressures, bool(options.gravity), options.to or USUAL_UNIT)
        if is_for_solver(self.files.output or ""):
            self.settings = self.settings.for_solver()
        if self.settings.refines():
            self.stages = (*TETRAHEDRALIZE, *REFINE)
        if self.settings.makes_layers():
            self.stages = (*TETRAHEDRALIZE, *REFINE, *LAYERS)
            self.settings.measured_on().set_on(vtkBoundaryLayers(), LAYER_OPTIONS)
        check_display(self.files.plot)
        parameters = {**self.parameters_of(tuple(OPTIONS), vtkRobustTetrahedralize()), "refine": self.settings.refines()}
        parameters.update({name: getattr(self.settings, name) for name in LAYER_OPTIONS})
        return {**parameters, **({"deck": vars(self.deck)} if self.deck else {})}

    def endings(self) -> dict[str, tuple[str, ...]]:
        return {
            "output": WRITABLE_GRIDS + WRITABLE_SURFACES,
            "hull": WRITABLE_GRIDS,
            "boundary": WRITABLE_SURFACES,
            "outliers": WRITABLE_SURFACES,
            "plot": DRAWINGS,
        }

    def check(self) -> None:
        super().check()
        output = self.files.output or ""
        self.check_merging()
        self.check_name_beside()
        if input_ending(self.files.surface) == CURVE or str(self.settings.dimension) == "2":
            self.check_plane()
            for name in self.settings.left_out_by(vtkRobustTriangulate()):
                told = "together" if name == "body_array" and self.options.together else name
                if name != "surface_only":
                    raise ArgumentError(f"{flag_of(told)} does nothing in a plane, where {self.files.surface} lies")
        beside = boundary_beside(output) if ending(output) == XDMF else None
        if beside in (self.files.hull, self.files.boundary, self.files.outliers) and beside:
            raise ArgumentError(f"{beside} gets the tags of {output}: give another name")
        for taking in (output, self.files.hull or "", self.files.plot or ""):
            if self.settings.surface_only and taking and ending(taking) not in WRITABLE_SURFACES:
                raise Error(f"{taking}: takes tetrahedra, which --surface-only goes without")

    def goes_without_cells(self) -> bool:
        """Whether no output has tetrahedra or depends on them."""
        files = self.files
        tells = files.hull or files.plot or files.report or self.options.json
        return self.settings.surface_only or ending(files.output or "") in WRITABLE_SURFACES and not tells

    def check_plane(self) -> None:
        """Raise `Error` for files that cannot hold planar results."""
        refuse_page_of_plane(self.files.plot)
        for path in filter(None, (self.files.output, self.files.hull, self.files.boundary, self.files.outliers)):
            (check_holds_lines if ending(path) in WRITABLE_SURFACES else check_holds_triangles)(path)

    def work(self) -> None:
        surface = self.read()
        if are_lines(surface):
            self.check_plane()
        if self.goes_without_cells():
            self.settings = replace(self.settings, surface_only=True)
        result = tetrahedralize(surface, progress=self.show_progress, **vars(self.settings))
        self.bars.finish()
        self.warnings = self.warnings + result.warnings
        self.statistics = dict(result.statistics)
        self.left_out_cells = result.left_out_cells
        self.lost_cells = result.lost_cells
        self.regions = result.regions
        self.bodies = result.bodies
        self.tags = {name: len(triangles) for name, triangles in result.tags.items()}
        try:
            self.write(surface, result)
        finally:
            self.measure()
        if result.boundary.GetNumberOfCells() == 0:
            least, most = self.statistics["MinimumW"], self.statistics["MaximumW"]
            raise Error(f"{self.files.name()}: nothing is inside, w ranges from {least:.6g} to {most:.6g}")

    def write(self, surface: vtkPolyData, result: Tetrahedralization) -> None:
        """Write the requested files; only hull and picture if nothing is inside."""
        began = time.monotonic()
        self.bars.show(WRITING, 0)
        for kind, data, path, write in self.files_to_write(result):
            work_on(path)
            self.warnings = self.warnings + (write(data, path) or [])
            self.outputs[kind] = path
            if kind == "solid":
                self.outputs.update(written_beside(path, result.solid, result.boundary))
        self.hints = self.hints_of(result)
        self.bars.finish()
        self.statistics["SecondsWrite"] = time.monotonic() - began
        if self.files.plot is not None:
            self.bars.show(DRAWING, 0)
            marks = {name: getattr(self.settings, name) for name in CHECK_OPTIONS}
            work_on(self.files.plot)
            # A solid of cells of the hull need not be written twice.
            solid = result.solid if self.settings.refines() or self.settings.parts() else None
            title = os.path.basename(self.files.name())
            draw(surface, result.hull, self.files.plot, solid=solid, title=title, up=up_of(self.files.surface), **marks)
            self.bars.finish()
            self.outputs["picture"] = self.files.plot
            self.statistics["SecondsDraw"] = time.monotonic() - began - self.statistics["SecondsWrite"]

    def hints_of(self, result: Tetrahedralization) -> list[str]:
        is_printable = "surface" in self.outputs and isinstance(result.boundary, TriangleSurface)
        return hints_for_printing(outer_boundary(result.boundary), self.outputs["surface"], self.settings) if is_printable else []

    def files_to_write(self, result: Tetrahedralization) -> Iterator[tuple]:
        files = self.files
        version: MshVersion = self.options.msh_version or "4.1"

        def write_with_boundary(solid: Tetrahedra, path: str) -> list[str]:
            return write_solid(solid, path, result.boundary, version, self.statistics, self.deck, bool(self.options.cells_only), self.is_replacing())

        def write_hull(hull: Tetrahedra, path: str) -> None:
            write_solid(hull, path, msh_version=version)  # no option changes its cells, so advice on them is omitted

        if files.hull is not None:
            yield "hull", result.hull, files.hull, write_hull
        if result.boundary.GetNumberOfCells() > 0:
            if ending(files.output or "") in WRITABLE_SURFACES:
                yield "surface", outer_boundary(result.boundary), files.output, write_surface
            elif files.output is not None:
                yield "solid", result.solid, files.output, write_with_boundary
            if files.boundary is not None:
                yield "boundary", result.boundary, files.boundary, write_surface
            if files.outliers is not None:
                yield "outliers", result.outliers, files.outliers, write_surface

    def more_for_the_report(self) -> dict[str, object]:
        return {
            "tetrahedralizer": tetrahedralizer(self.statistics),
            "defects": defects(self.statistics),
            "verdict": verdict(self.statistics) if self.statistics else None,
            "left_out_cells": self.left_out_cells,
            "lost_cells": self.lost_cells,
            "regions": [vars(region) for region in self.regions],
            "bodies": self.bodies,
            "tags": self.tags,
        }

    def summary(self) -> list[str]:
        volumes = [region.volume for region in self.regions]
        regions = ["+".join(region.bodies) for region in self.regions] if self.bodies else []
        return summary(os.path.basename(self.files.name()), self.statistics, volumes, self.tags, regions)

    def notes(self) -> list[str]:
        unit = [f"the analysis takes lengths as {self.deck.unit}, and forces as newtons; --from and --to choose another unit"] if self.deck else []
        return super().notes() + unit + self.hints + ([] if self.settings.split_seams else seams(self.statistics))
