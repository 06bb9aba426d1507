# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of arrays, which need no display."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData

from .serializing import vtk_array

LEAST_SIDE = 400
"""The least size in pixels: smaller arrays are enlarged."""

INSIDE, BORDER, OUTSIDE = np.array([(40, 84, 160), (250, 250, 247), (190, 60, 40)], float)
LINES = 8  # of equal distance, between 0 and the largest


def picture_of_slice(distance: NDArray[np.float64]) -> bytes:
    """The content of a .png file that shows signed distances: blue below 0, red above, with lines of equal distance."""
    from vtkmodules.vtkIOImage import vtkPNGWriter  # its module is not needed by the classes

    enlarged = max(1, -(-LEAST_SIDE // max(distance.shape)))
    values = np.kron(np.nan_to_num(distance), np.ones((enlarged, enlarged)))
    share = values / (np.abs(values).max() or 1)
    strength = np.abs(share)[..., np.newaxis] ** 0.5
    colour = BORDER + strength * (np.where(share[..., np.newaxis] < 0, INSIDE, OUTSIDE) - BORDER)
    colour[np.floor(share * LINES) % 2 == 0] *= 0.93
    pixels = colour.astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(*pixels.shape[:2], 1)
    image.GetPointData().SetScalars(vtk_array(pixels.transpose(1, 0, 2).reshape(-1, 3), VTK_UNSIGNED_CHAR))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    return bytes(vtk_to_numpy(writer.GetResult()))
