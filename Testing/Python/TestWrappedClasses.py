# SPDX-License-Identifier: GPL-3.0-or-later
"""The classes as Python has them from VTK's wrapping, in VTK's own build without the package insideout, too."""

import unittest

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

try:
    from vtkmodules import vtkFiltersInsideOut
except ImportError:
    from insideout import vtkFiltersInsideOut

CLASSES = {name: value for name, value in vars(vtkFiltersInsideOut).items() if name.startswith("vtk") and isinstance(value, type)}
FACETS = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def open_box() -> vtkPolyData:
    """The unit cube's facets but for one, as polygons."""
    points, facets = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for corner in range(8):
        points.InsertNextPoint(corner & 1, corner >> 1 & 1, corner >> 2)
    for facet in FACETS[1:]:
        facets.InsertNextCell(len(facet), facet)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(facets)
    return surface


class WrappedClasses(unittest.TestCase):
    def test_each_makes_objects_that_print_their_name(self):
        self.assertEqual(len(CLASSES), 20, sorted(CLASSES))
        for name, kind in CLASSES.items():
            thing = kind()
            self.assertEqual(thing.GetClassName(), name)
            self.assertIn(name, str(thing))

    def test_a_box_without_lid_has_its_volume(self):
        tetrahedralize = vtkFiltersInsideOut.vtkRobustTetrahedralize()
        tetrahedralize.SetInputData(open_box())
        tetrahedralize.Update()
        quality = vtkFiltersInsideOut.vtkSolidQuality()
        quality.SetInputConnection(tetrahedralize.GetOutputPort())
        quality.Update()
        fields = tetrahedralize.GetOutput().GetFieldData()
        names, values = fields.GetAbstractArray("StatisticsNames"), fields.GetArray("Statistics")
        statistics = {names.GetValue(index): values.GetValue(index) for index in range(names.GetNumberOfValues())}
        self.assertAlmostEqual(statistics["Volume"], 1, 12)
        self.assertEqual(quality.GetOutput().GetNumberOfCells(), tetrahedralize.GetOutput().GetNumberOfCells())

    def test_an_option_out_of_range_stays_within_it(self):
        probe = vtkFiltersInsideOut.vtkProbeWindingNumber()
        heard = []
        probe.AddObserver("WarningEvent", lambda *_: heard.append(1))
        probe.SetApproximationOrder(7)
        self.assertEqual((probe.GetApproximationOrder(), len(heard)), (3, 1))


if __name__ == "__main__":
    unittest.main()
