# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Scripts/test-wheels.py runs with each wheel and each VTK, in a folder that is empty.

2,000 cubes are drawn in 12 views with and without the culler. All images have to be the same to the
byte, and some cubes hidden. Prints what it found.
"""

import importlib
import sys

import vtknbuffer


def vtk(module):
    return importlib.import_module(f"{vtknbuffer._vtk_package}.{module}")


core, rendering, sources = vtk("vtkCommonCore"), vtk("vtkRenderingCore"), vtk("vtkFiltersSources")


def make_window():
    cube = sources.vtkCubeSource()
    renderer = rendering.vtkRenderer()
    for i in range(2000):
        mapper = rendering.vtkPolyDataMapper()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor = rendering.vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(i % 10, i // 10 % 10, i // 100 * -2)
        actor.GetProperty().SetColor(i % 7 / 7, i % 5 / 5, 0.8)
        renderer.AddActor(actor)
    window = rendering.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(400, 300)
    window.AddRenderer(renderer)
    return window, renderer


def walk(window, renderer):
    """The images of 12 views, as bytes."""
    images = []
    width, height = window.GetSize()
    for i in range(12):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(-6 + 2 * i, 4.5, 25)
        camera.SetFocalPoint(4.5, 4.5, 0)
        renderer.ResetCameraClippingRange()
        window.Render()
        pixels = core.vtkUnsignedCharArray()
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
        images.append(bytes(memoryview(pixels)))
    return images


def main():
    window, renderer = make_window()
    expected = walk(window, renderer)
    culler = vtknbuffer.enable(renderer)
    images = walk(window, renderer)
    counts = vtknbuffer.statistics(culler)
    hidden = counts["verdicts"]["Hidden"]
    differing = sum(one != other for one, other in zip(expected, images))
    varied = len({*expected[0]}) > 2
    package = vtknbuffer._vtk_package
    version = core.vtkVersion.GetVTKVersion()
    print(f"{package} {version}, {window.GetClassName()}: {counts['props']} props, "
          f"{hidden} hidden; {differing} of {len(images)} images differ")
    if differing or not hidden or not varied:
        sys.exit("the images differ, no cube is hidden, or nothing is drawn")


if __name__ == "__main__":
    main()
