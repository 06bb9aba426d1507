# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel of pictures with the quality of tetrahedra."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkRectf, vtkTable, vtkUnstructuredGrid
from vtkmodules.vtkRenderingContext2D import vtkContextActor

from .actors import CROSSING, SOLID
from .legend import title, words
from .pipeline import statistics_of
from .quality import quality_rows, solid_verdict
from .scenes import Panel
from .serializing import vtk_array
from .view import HEIGHT, PANEL_WIDTH

SHARP_BINS = 2  # of the histogram: up to 10 degrees


def histogram_panel(figures: vtkUnstructuredGrid) -> Panel:
    counts = vtk_to_numpy(figures.GetFieldData().GetArray("DihedralAngleHistogram"))
    width = 180 / len(counts)
    chart = vtkChartXY()
    chart.SetAutoSize(False)
    chart.SetSize(vtkRectf(0.05 * PANEL_WIDTH, 0.27 * HEIGHT, 0.9 * PANEL_WIDTH, 0.62 * HEIGHT))
    chart.SetBarWidthFraction(0.95)
    shares = 100 * counts / max(counts.sum(), 1)
    bins = np.arange(len(counts))
    table, colours = vtkTable(), vtkLookupTable()
    for name, values in (("angle", (bins + 0.5) * width), ("share", shares), ("sharp", 1.0 * (bins < SHARP_BINS))):
        column = vtk_array(values)
        column.SetName(name)
        table.AddColumn(column)
    colours.SetNumberOfTableValues(2)
    colours.SetTableRange(0, 1)
    for k, colour in enumerate((SOLID, CROSSING)):
        colours.SetTableValue(k, *colour)
    bars = chart.AddPlot(vtkChart.BAR)
    bars.SetInputData(table, "angle", "share")
    bars.SelectColorArray("sharp")
    bars.SetLookupTable(colours)
    bars.ScalarVisibilityOn()
    for side, name, least, most in ((vtkAxis.BOTTOM, "degrees", 0, 180), (vtkAxis.LEFT, "% of all angles", 0, 1.1 * shares.max())):
        axis = chart.GetAxis(side)
        axis.SetTitle(name)
        axis.SetBehavior(vtkAxis.FIXED)
        axis.SetRange(least, most)
        axis.GetTitleProperties().SetFontSize(22)
        axis.GetTitleProperties().SetBold(False)
        axis.GetLabelProperties().SetFontSize(18)
    drawn = vtkContextActor()
    drawn.GetScene().AddItem(chart)
    lines = [words(text, 0.2 - 0.033 * k, size=20) for k, text in enumerate(texts_of(figures))]
    return Panel([drawn, title("Dihedral angles of the tetrahedra"), *lines])


def texts_of(figures: vtkUnstructuredGrid) -> list[str]:
    """The quality of a solid, worded as in the command's summary."""
    statistics = statistics_of(figures)
    return [solid_verdict(statistics), *(f"{what}: {how_much}" for what, how_much in quality_rows(statistics))]
