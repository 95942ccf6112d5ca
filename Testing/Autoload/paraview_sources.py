#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""For ParaView's pvbatch: a wall and 70 sources behind it, each with a representation of its own.

paraview_sources.py: walks past the wall, changes between levels of detail, and appends a checksum of
each frame to the file FRAME_SUMS, as FrameSums.cxx does for windows that it sees; ParaView makes its own.
"""

import hashlib
import os

from paraview.simple import Box, CreateView, Show, Sphere
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray


def main():
    view = CreateView("RenderView")
    view.ViewSize = [320, 240]
    view.LODThreshold = 0
    view.LODResolution = 0.2
    Show(Box(XLength=14, YLength=6, ZLength=0.5), view)
    for i in range(70):
        center = [i % 14 - 6.5, i // 14 % 3 * 2.5 - 2.5, -2 - i // 35 * 2]
        Show(Sphere(Radius=0.8, Center=center, ThetaResolution=24, PhiResolution=24), view)
    for frame in range(8):
        view.CameraPosition = [0.8 * frame, 0, 22]
        view.CameraFocalPoint = [0.8 * frame, 0, 0]
        view.SMProxy.UpdateVTKObjects()
        for render in (view.SMProxy.StillRender, view.SMProxy.InteractiveRender) * 2:
            render()
            pixels = vtkUnsignedCharArray()
            view.GetRenderWindow().GetRGBACharPixelData(0, 0, 319, 239, 0, pixels)
            with open(os.environ["FRAME_SUMS"], "a", encoding="ascii") as file:
                print(hashlib.sha256(bytes(memoryview(pixels))).hexdigest(), file=file)


if __name__ == "__main__":
    main()
