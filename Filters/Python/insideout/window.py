# SPDX-License-Identifier: GPL-3.0-or-later
"""A program with a window that shows a picture until it is closed; it needs a display.

    python3 -m insideout.window PICTURE.png TITLE
"""

import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleImage
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkImageActor, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor


def show(file: str, title: str) -> None:
    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    seen = vtkImageActor()
    seen.SetInputData(reader.GetOutput())
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(seen)
    window = vtkRenderWindow()
    window.SetSize(width, height)
    window.SetWindowName(title)
    window.AddRenderer(renderer)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleImage())
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    camera.SetParallelScale(height / 2)
    window.Render()
    interactor.Start()


if __name__ == "__main__":
    show(*sys.argv[1:])
