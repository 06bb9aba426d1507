# SPDX-License-Identifier: GPL-3.0-or-later
"""A source that gives each rank a piece still means one solid.

    mpirun -np 3 pvbatch TestRanks.py
"""

from paraview import simple

FACETS = 2 * 40 * 18  # of the sphere, in whatever pieces
sphere = simple.Sphere(ThetaResolution=40, PhiResolution=20, Radius=1)


def volume_and_cells(proxy):
    total = simple.IntegrateVariables(Input=simple.CellSize(Input=proxy))
    total.UpdatePipeline()
    cells = proxy.GetDataInformation().GetNumberOfCells()
    return round(total.CellData["Volume"].GetRange()[0], 6) if "Volume" in total.CellData.keys() else 0, cells


def expect(what, found, expected):
    if found != expected:
        raise AssertionError(f"{what}: {found}, expected {expected}")


solid = simple.RobustTetrahedralize(Input=sphere)
volume, cells = volume_and_cells(solid)
assert 4.05 < volume < 4.19, volume  # the polyhedron is a little smaller than the ball's 4.18879
assert cells > FACETS, cells
hull = simple.GeneralizedWindingNumber(Input=sphere)

expect("w at most", hull.CellData["w"].GetRange()[1], 1)
expect("the cut's volume", volume_and_cells(simple.GraphCutSegmentation(Input=hull))[0], volume)
expect("the mesh's volume", volume_and_cells(simple.ConstrainedDelaunay3D(Input=sphere))[0], volume)
expect("resolved facets", volume_and_cells(simple.ResolveSelfIntersections(Input=sphere))[1], FACETS)
expect("checked facets", volume_and_cells(simple.SurfaceDefects(Input=sphere))[1], FACETS)
expect("measured cells", volume_and_cells(simple.SolidQuality(Input=hull))[1], hull.GetDataInformation().GetNumberOfCells())

# The probe works on each rank's piece, with all of the surface.
grid = simple.Wavelet(WholeExtent=[-1, 1, -1, 1, -1, 1])
probe = simple.ProbeWindingNumber(Input=grid, Surface=sphere)
probe.UpdatePipeline()
expect("w of the probe", probe.PointData["Inside"].GetRange(), (0, 1))
print("all as on one rank")
