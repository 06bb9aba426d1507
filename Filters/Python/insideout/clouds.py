# SPDX-License-Identifier: GPL-3.0-or-later
"""`point_cloud`: points with normals as a surface for queries, without triangles."""

from __future__ import annotations

from typing import Optional

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .calling import for_users
from .inputs import ARRAYS, make_points, numbers
from .pipeline import Error
from .serializing import vtk_array


@for_users
def point_cloud(points: ArrayLike, normals: ArrayLike, areas: Optional[ArrayLike] = None) -> vtkPolyData:
    """Points on a surface, such as a scan, for `winding_number`, `inside` and `voxels`.

    points   an array with three columns
    normals  the same, outward, of any length but 0
    areas    the area that each point represents, in squared units, at least 0; estimated if it is None

    Raises `Error` if their numbers differ. Invalid values are reported when the cloud is used.
    """
    cloud = vtkPolyData()
    cloud.SetPoints(make_points(points, ARRAYS[0]))
    size = cloud.GetNumberOfPoints()
    given = {"normals": (normals, (size, 3)), "areas": (areas, (size,))}
    for name, (values, shape) in given.items():
        if values is None and name == "areas":
            continue
        array = numbers(name, values)
        if array.shape != shape:
            raise Error(f"{name} has the shape {array.shape}; with {size} points it must be {shape}")
        made = vtk_array(np.ascontiguousarray(array), VTK_DOUBLE)
        made.SetName("Normals" if name == "normals" else "Area")
        cloud.GetPointData().AddArray(made)
    cloud.GetPointData().SetActiveNormals("Normals")
    return cloud
