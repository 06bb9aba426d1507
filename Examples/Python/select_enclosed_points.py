# SPDX-License-Identifier: GPL-3.0-or-later
"""Which points are inside a surface that has a hole? vtkProbeWindingNumber beside vtkSelectEnclosedPoints.

    python3 select_enclosed_points.py

marks 100,000 random points about a ball of which a cap is missing with either filter, and counts the
points on which each is wrong. The two are used alike.
"""

import sys

import insideout
from vtkmodules.vtkCommonCore import vtkMath, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkSelectEnclosedPoints
from vtkmodules.vtkFiltersSources import vtkSphereSource


def open_ball():
    """A ball of radius 1 without its north cap, 25 degrees wide."""
    ball = vtkSphereSource()
    ball.SetRadius(1)
    ball.SetThetaResolution(60)
    ball.SetPhiResolution(30)
    ball.SetStartPhi(25)
    return ball


def random_points(number):
    math, points = vtkMath(), vtkPoints()
    math.RandomSeed(1)
    points.SetDataTypeToDouble()
    for _ in range(number):
        points.InsertNextPoint([math.Random(-1.5, 1.5) for _ in range(3)])
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def number_wrong(selector, surface, data):
    selector.SetInputData(data)
    selector.SetSurfaceConnection(surface.GetOutputPort())
    selector.Update()
    wrong = 0
    for i in range(data.GetNumberOfPoints()):
        radius = sum(x * x for x in data.GetPoint(i)) ** 0.5
        nearly_on_the_surface = 0.99 < radius <= 1
        # Where the ball is open, whoever closes it decides: only what is off the cap counts.
        in_the_opening = data.GetPoint(i)[2] > 0.8 and radius < 1.1
        if not nearly_on_the_surface and not in_the_opening:
            wrong += selector.IsInside(i) != (radius < 1)
    return wrong


if __name__ == "__main__":
    points = random_points(100_000)
    by_rays = number_wrong(vtkSelectEnclosedPoints(), open_ball(), points)
    by_winding_number = number_wrong(insideout.vtkProbeWindingNumber(), open_ball(), points)
    print(f"vtkSelectEnclosedPoints is wrong on {by_rays} points, vtkProbeWindingNumber on {by_winding_number}")
    if by_winding_number > 0:
        sys.exit("the winding number should be right")
