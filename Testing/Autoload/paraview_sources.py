#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""For ParaView's pvbatch: a wall and 300 sources behind it, each with a representation of its own.

paraview_sources.py FOLDER: walks past the wall and writes each frame to the folder.
"""

import sys

from paraview.simple import Box, CreateView, Render, Show
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def write(window, name):
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ShouldRerenderOff()
    picture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(name)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()


def main():
    view = CreateView("RenderView")
    view.ViewSize = [320, 240]
    Show(Box(XLength=24, YLength=10, ZLength=0.5), view)
    for i in range(300):
        center = [i % 25 - 12, i // 25 % 4 * 3 - 5, -2 - i // 100 * 2]
        box = Show(Box(XLength=0.6, YLength=1, ZLength=0.6, Center=center), view)
        box.DiffuseColor = [i % 7 / 7, i % 5 / 5, i % 3 / 3]
    for frame in range(6):
        view.CameraPosition = [0.8 * frame, 0, 30]
        view.CameraFocalPoint = [0.8 * frame, 0, 0]
        Render(view)
        write(view.GetRenderWindow(), f"{sys.argv[1]}/frame-{frame}.png")


if __name__ == "__main__":
    main()
