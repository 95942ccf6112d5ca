# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plain VTK: one line adds the culler, and a dict says what it did."""

import sys

from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

import vtknbuffer

cone = vtkConeSource()
cone.SetDirection(0, 0, 1)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(cone.GetOutputPort())
renderer = vtkRenderer()
for i in range(10000):  # 16 walls of cones, one behind the other.
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(i % 25, i // 25 % 25, i // 625 * -2)
    actor.GetProperty().SetColor(0.4 + i % 25 / 50, 0.9 - i // 625 / 20, 0.5)
    renderer.AddActor(actor)
culler = vtknbuffer.enable(renderer)  # Nothing else: the image stays the same, to the bit.
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.AddRenderer(renderer)
renderer.ResetCamera()
renderer.GetActiveCamera().Azimuth(30)
renderer.ResetCameraClippingRange()
window.Render()
print(vtknbuffer.statistics(culler)["verdicts"])
grabber = vtkWindowToImageFilter()
grabber.SetInput(window)
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "plain_vtk.png")
writer.SetInputConnection(grabber.GetOutputPort())
writer.Write()
