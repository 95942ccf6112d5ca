#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""A script as a user of VTK writes it, which knows nothing of this project.

street.py PICTURE: walks past a wall with 500 boxes behind it and writes the last frame.
"""

import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (VTK needs the import to find its windows)
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)


def add_box(renderer, center, size, color):
    source = vtkCubeSource()
    source.SetCenter(center)
    source.SetXLength(size[0])
    source.SetYLength(size[1])
    source.SetZLength(size[2])
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    renderer.AddActor(actor)


def main():
    renderer = vtkRenderer()
    add_box(renderer, (0, 0, 0), (24, 10, 0.5), (0.7, 0.7, 0.6))
    for i in range(500):
        add_box(renderer, (i % 25 - 12, i // 25 % 5 * 3 - 6, -2 - i // 125 * 2), (0.6, 1, 0.6),
                (i % 7 / 7, i % 5 / 5, i % 3 / 3))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(320, 240)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    for frame in range(6):
        camera.SetPosition(0.8 * frame, 0, 30)
        camera.SetFocalPoint(0.8 * frame, 0, 0)
        renderer.ResetCameraClippingRange()
        window.Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
