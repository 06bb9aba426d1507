# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface in pieces, as a source for VTK's pipelines."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkInformation, vtkInformationVector
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline

from .surfaces import AnySurface, as_surface


class Pieces(VTKPythonAlgorithmBase):
    """A source of surfaces, of which VTK requests one at a time. After a failure they are empty."""

    def __init__(self, pieces: Sequence[AnySurface], scale: float):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.pieces = pieces
        self.scale = scale
        self.warnings: list[str] = []
        self.failure: Optional[Exception] = None

    def RequestInformation(self, _request: vtkInformation, _inputs: Any, outputs: vtkInformationVector) -> int:
        outputs.GetInformationObject(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        return 1

    def RequestData(self, _request: vtkInformation, _inputs: Any, outputs: vtkInformationVector) -> int:
        information = outputs.GetInformationObject(0)
        number = information.Get(vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER())
        output = vtkPolyData.GetData(information)
        output.Initialize()  # the earlier piece is let go
        if self.failure is None and number < len(self.pieces):
            try:
                polygons, warnings = as_surface(self.pieces[number], self.scale)
                output.ShallowCopy(polygons)
                self.warnings += warnings
            except Exception as failure:
                self.failure = failure
        return 1
