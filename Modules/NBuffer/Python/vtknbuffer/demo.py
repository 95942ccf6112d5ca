# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""``python -m vtknbuffer.demo``: a walk through a city, with and without the culler.

Prints the frame times of stock VTK, of VTK with the culler, and of the oracle, which draws exactly
the props that own a pixel and which no culler can beat. It compares the images
with and without the culler byte by byte.
"""

import argparse
import importlib
import statistics
import time

import numpy as np

import vtknbuffer
from vtknbuffer import city


def _vtk(module):
    return importlib.import_module(f"{vtknbuffer._vtk_package}.{module}")


core, data, rendering = _vtk("vtkCommonCore"), _vtk("vtkCommonDataModel"), _vtk("vtkRenderingCore")
to_numpy = _vtk("util.numpy_support")


def _make_actor(points, polygons, color, kept):
    mesh = data.vtkPolyData()
    vtk_points = core.vtkPoints()
    coordinates = to_numpy.numpy_to_vtk(points, deep=True)
    vtk_points.SetData(coordinates)
    mesh.SetPoints(vtk_points)
    cells = data.vtkCellArray()
    cells.ImportLegacyFormat(to_numpy.numpy_to_vtkIdTypeArray(polygons.astype(np.int64), deep=True))
    mesh.SetPolys(cells)
    kept.extend((coordinates, vtk_points, cells, mesh))
    mapper = rendering.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    actor = rendering.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    return actor


def make_window(buildings, size, kept):
    """Return a window off screen with one actor per building, and its renderer.

    The list ``kept`` receives what the actors are made of. It has to live longer than the window:
    when Python drops such an object and VTK does not, the package vtk searches all that were
    dropped before, which takes minutes for 15,000 actors.
    """
    renderer = rendering.vtkRenderer()
    renderer.SetBackground(0.6, 0.75, 0.9)
    colors = np.random.default_rng(1).uniform(0.5, 0.9, (len(buildings), 3))
    for (outline, height), color in zip(buildings, colors):
        renderer.AddActor(_make_actor(*city.walls_and_roof(outline, height), color, kept))
    corners = np.array([[-9e3, -9e3, 0], [9e3, -9e3, 0], [9e3, 9e3, 0], [-9e3, 9e3, 0.0]])
    renderer.AddActor(_make_actor(corners, np.array([4, 0, 1, 2, 3]), (0.45, 0.5, 0.4), kept))
    window = rendering.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    return window, renderer


def _image(window):
    pixels = core.vtkUnsignedCharArray()
    width, height = window.GetSize()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
    return to_numpy.vtk_to_numpy(pixels).copy()


def _timed_render(window):
    begin = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    return 1000 * (time.perf_counter() - begin)


def _props_with_pixels(renderer, window):
    """The props that own a pixel of the present view, by VTK's hardware selector."""
    selector = rendering.vtkHardwareSelector()
    selector.SetRenderer(renderer)
    width, height = window.GetSize()
    selector.SetArea(0, 0, width - 1, height - 1)
    selector.SetFieldAssociation(data.vtkDataObject.FIELD_ASSOCIATION_CELLS)
    found = selector.Select()
    return {found.GetNode(i).GetProperties().Get(data.vtkSelectionNode.PROP())
            for i in range(found.GetNumberOfNodes())}


def run(frames, size, report=print):
    """Walk, and return the medians in milliseconds and the number of bytes that differ."""
    kept = []  # It outlives what _run() makes; see make_window().
    return _run(frames, size, report, kept)


def _run(frames, size, report, kept):
    buildings, streets = city.read()
    report(f"making {len(buildings)} actors ...")
    window, renderer = make_window(buildings, size, kept)
    eyes, focal_points = city.walk(buildings, streets, frames)
    camera = renderer.GetActiveCamera()
    camera.SetViewUp(0, 0, 1)
    actors = renderer.GetActors()
    props = [actors.GetItemAsObject(i) for i in range(actors.GetNumberOfItems())]
    culler = vtknbuffer.vtkNBufferCuller()

    def look(i):
        camera.SetPosition(*eyes[i])
        camera.SetFocalPoint(*focal_points[i])
        camera.SetClippingRange(0.5, 6000)

    def walk():
        times, images = [], []
        for i in range(frames):
            look(i)
            times.append(_timed_render(window))
            images.append(_image(window))
        return times, images

    look(0)
    window.Render()
    report("walking with stock VTK ...")
    stock, expected = walk()
    renderer.AddCuller(culler)
    for i in range(min(frames, 5)):  # Not timed: the culler knows nothing of this view yet.
        look(i)
        window.Render()
    report("walking with the culler ...")
    ours, images = walk()
    counts = vtknbuffer.statistics(culler)
    renderer.RemoveCuller(culler)
    report("walking with the oracle ...")
    oracle = []
    for i in range(0, frames, max(frames // 8, 1)):
        look(i)
        seen = _props_with_pixels(renderer, window)
        for prop in props:
            prop.SetVisibility(prop in seen)
        window.Render()
        look(i)
        oracle.append(_timed_render(window))
        for prop in props:
            prop.VisibilityOn()
    return {
        "props": counts["props"], "drawn": counts["drawn"],
        "stock": statistics.median(stock), "culler": statistics.median(ours),
        "oracle": statistics.median(oracle),
        "differing_bytes": int(sum((a != b).sum() for a, b in zip(expected, images))),
    }


def main():
    parser = argparse.ArgumentParser(prog="python -m vtknbuffer.demo", description=__doc__)
    parser.add_argument("--frames", type=int, default=60, help="frames of the walk (default: 60)")
    parser.add_argument("--size", type=int, nargs=2, default=(960, 720), metavar=("WIDTH", "HEIGHT"))
    options = parser.parse_args()
    if options.frames < 1 or min(options.size) < 1:
        parser.error("frames and size must be at least 1")
    found = run(options.frames, options.size)
    print(f"{found['drawn']} of {found['props']} props drawn in the last frame; medians of "
          f"{options.frames} frames:")
    for name in ("stock", "culler", "oracle"):
        print(f"  {name:8}{found[name]:8.1f} ms{found['stock'] / found[name]:8.1f} x stock's speed")
    print(f"{found['differing_bytes']} bytes of all images differ.")


if __name__ == "__main__":
    main()
