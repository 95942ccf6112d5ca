# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python package share. They import the package as it is installed."""

import importlib
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import vtknbuffer


def vtk(module):
    """A module of the VTK in use."""
    return importlib.import_module(f"{vtknbuffer._vtk_package}.{module}")


core, rendering, sources = vtk("vtkCommonCore"), vtk("vtkRenderingCore"), vtk("vtkFiltersSources")


def add_walls(renderer, walls=4, side=12, shared=True):
    """Walls of cubes, one behind the other, seen from +z."""
    cube = sources.vtkCubeSource()
    for i in range(walls * side * side):
        if i == 0 or not shared:
            mapper = rendering.vtkPolyDataMapper()
            mapper.SetInputConnection(cube.GetOutputPort())
        actor = rendering.vtkActor()
        actor.SetMapper(mapper)
        # Some cubes stand out of their wall and cast shadows on it.
        actor.SetPosition(i % side, i // side % side, i // side // side * -2 + 0.3 * (7 * i % 4))
        actor.GetProperty().SetColor(i % 7 / 7, i % 5 / 5, 0.8)
        renderer.AddActor(actor)


def make_window(renderers=1, size=(200, 160), **walls):
    """A window off screen with renderers side by side."""
    window = rendering.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    for i in range(renderers):
        renderer = rendering.vtkRenderer()
        renderer.SetViewport(i / renderers, 0, (i + 1) / renderers, 1)
        add_walls(renderer, **walls)
        window.AddRenderer(renderer)
    return window


def renderers_of(window):
    items = window.GetRenderers()
    return [items.GetItemAsObject(i) for i in range(items.GetNumberOfItems())]


def look(window, i):
    """The i-th view of a walk along the walls."""
    for renderer in renderers_of(window):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(4 + i, 5 + 0.3 * i, 18)
        camera.SetFocalPoint(5.5, 5.5, 0)
        renderer.ResetCameraClippingRange()
    window.Render()


def image(window):
    """The pixels of a window, as bytes."""
    pixels = core.vtkUnsignedCharArray()
    width, height = window.GetSize()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
    return vtk("util.numpy_support").vtk_to_numpy(pixels).copy()


def differing(one, other):
    assert one.shape == other.shape
    return int(np.count_nonzero(one != other))


def run_python(code):
    """Run code in a Python of its own. Returns what it prints; its exit status must be 0."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def check_that_all_end(imports, programs):
    """Run each of some programs, by name, in a process of its own, which must end without an error.

    Most of the time of a short program goes into importing PyVista. Here it is imported once, and a
    process is forked from that for each program, before VTK has made a window.
    """
    run_python(f"""
import os, sys
sys.path.insert(0, {str(pathlib.Path(__file__).parent)!r})
{imports}
for name, program in {programs!r}.items():
    child = os.fork()
    if child == 0:
        break
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    if status:
        sys.exit(f"{{name}}: the exit status is {{status}}")
else:
    program = ""
exec(program)
""")


@pytest.fixture
def window():
    return make_window()
