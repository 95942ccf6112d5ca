#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the images of scripts of others with and without the culler, such as VTK's own tests.

    compare_scripts.py [--shadows] [--data FOLDER] SCRIPT...
    compare_scripts.py --data vtk-data vtk/*/*/Testing/Python/*.py    # VTK's sources and data

Each script runs in a process of its own, with the package vtknbuffer. Where it calls Render(), or
show() of a plotter of PyVista, its window is also drawn from other sides, with a wall in front of a
half of the view and without, and each image is compared with that of the same frame without the
culler, byte for byte. With --shadows each renderer has a sun and a pass for shadows: the image is
the same as without the pass if shadows darken nothing, and the same with all modes except for
Clamped if they do. Windows whose images differ from frame to frame without the culler are left out,
and so are scripts that fail. The exit status is 1 if an image differs.
"""

import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SETTINGS = {"minimum_number_of_candidates": 1, "back_off": 0, "minimum_number_of_primitives": 64,
            "divide_after": 1, "divide_in_background": 0, "time_units": 0}
SIDES = 8
SIDES_WITH_SHADOWS = 2
WINDOWS = 4  # of a script
PLOTTER_SIZE = 400, 300


def draw(window):
    """Render, and return the size and the colours of the image."""
    import vtkmodules.all as vtk

    window.Render()
    width, height = window.GetSize()
    colors = vtk.vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 1, colors, 0)
    return width, height, bytes(memoryview(colors))


def make_wall(renderer):
    """Return an actor of a wall in front of the left half of what the camera sees."""
    import vtkmodules.all as vtk

    camera = renderer.GetActiveCamera()
    matrix = vtk.vtkMatrix4x4()
    matrix.DeepCopy(camera.GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), 0.0, 1.0))
    matrix.Invert()
    corners = [matrix.MultiplyPoint((x, y, 0.1, 1.0)) for x, y in ((-1, -1), (0, -1), (-1, 1))]
    wall = vtk.vtkPlaneSource()
    for set_corner, corner in zip((wall.SetOrigin, wall.SetPoint1, wall.SetPoint2), corners):
        set_corner([value / corner[3] for value in corner[:3]])
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(wall.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def views(renderers, sides):
    """Show the scene from several sides, with and without a wall, and restore the cameras."""
    import vtkmodules.all as vtk

    cameras = []
    for renderer in renderers:
        cameras.append(vtk.vtkCamera())
        cameras[-1].DeepCopy(renderer.GetActiveCamera())
    for has_walls in (False, True):
        walls = [make_wall(renderer) for renderer in renderers if has_walls]
        for renderer, wall in zip(renderers, walls):
            renderer.AddViewProp(wall)
        for side in range(sides):
            for renderer in renderers if side % 3 else ():
                renderer.GetActiveCamera().Azimuth(11.0 + 2.0 * side)
                renderer.ResetCameraClippingRange()
            yield side
        for renderer, wall in zip(renderers, walls):
            renderer.RemoveViewProp(wall)
    for renderer, camera in zip(renderers, cameras):
        renderer.GetActiveCamera().DeepCopy(camera)


def compare_culler(window, renderers, counts):
    """Compare the images with and without the culler."""
    import vtknbuffer

    cullers = [vtknbuffer.enable(renderer, **SETTINGS) for renderer in renderers]
    for _ in views(renderers, SIDES):
        images = []
        for enabled in (True, False, False):
            for culler in cullers:
                culler.SetEnabled(enabled)
            images.append(draw(window))
            for culler in cullers if enabled else ():
                statistics = json.loads(culler.GetStatisticsAsJSON())
                counts["props hidden"] += statistics["verdicts"]["Hidden"]
                counts["units hidden"] += statistics["units_hidden"]
        if images[1] == images[2]:
            counts["frames"] += 1
            counts["frames that differ"] += images[0] != images[1]
    for renderer, culler in zip(renderers, cullers):
        renderer.GetCullers().RemoveItem(culler)


def add_sun(renderer):
    """Add a light that comes from above the camera."""
    import vtkmodules.all as vtk

    camera = renderer.GetActiveCamera()
    sun = vtk.vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetFocalPoint(camera.GetFocalPoint())
    sun.SetPosition([eye + camera.GetDistance() * up
                     for eye, up in zip(camera.GetPosition(), camera.GetViewUp())])
    sun.SetIntensity(0.5)
    renderer.AddLight(sun)
    return sun


def compare_shadows(window, renderers, counts):
    """Compare images without shadows with those of shadows that darken nothing, and the modes."""
    import vtknbuffer

    # The pass takes the place of these.
    renderers = [renderer for renderer in renderers
                 if not renderer.GetPass() and not renderer.GetUseSSAO()
                 and not renderer.GetUseHiddenLineRemoval()]
    suns = [add_sun(renderer) for renderer in renderers]
    passes = [vtknbuffer.vtkShadowVolumeClampPass() for _ in renderers]

    def draw_with(attenuation, mode=None):
        for renderer, shadows in zip(renderers, passes):
            lights = renderer.GetLights()
            for i in range(lights.GetNumberOfItems()):
                lights.GetItemAsObject(i).SetShadowAttenuation(attenuation)
            if mode is not None:
                shadows.SetMode(mode)
            renderer.SetPass(shadows if mode is not None else None)
        # Where renderers share shaders, VTK gives them the lights of another one in the first frame.
        draw(window)
        return draw(window)

    for _ in views(renderers, SIDES_WITH_SHADOWS):
        for sun in suns:
            sun.Modified()
        plain = draw_with(0.0)
        modes = vtknbuffer.vtkShadowVolumeClampPass
        if plain == draw_with(0.0):
            counts["frames"] += 1
            counts["frames that differ"] += draw_with(0.0, modes.Automatic) != plain
        shadowed = draw_with(1.0, modes.Unclamped)
        if shadowed == draw_with(1.0, modes.Unclamped):
            counts["frames with shadows"] += shadowed != plain
            counts["frames that differ"] += any(
                draw_with(1.0, mode) != shadowed
                for mode in (modes.Culled, modes.Scissored, modes.Automatic))
    for renderer, sun in zip(renderers, suns):
        renderer.SetPass(None)
        renderer.RemoveLight(sun)


def compare(window, shadows, counts):
    """Compare the images of a window that shows the same in each frame."""
    import vtknbuffer

    renderers = [renderer for renderer in vtknbuffer._renderers(window)
                 if renderer.IsA("vtkOpenGLRenderer") and renderer.IsActiveCameraCreated()]
    if renderers and draw(window) == draw(window):
        (compare_shadows if shadows else compare_culler)(window, renderers, counts)


def watch_plotters(render):
    """Call a function with the window of each plotter of PyVista that is shown."""
    import pyvista

    show = pyvista.Plotter.show

    def show_and_render(plotter, *arguments, **options):
        shown = show(plotter, *arguments, **{**options, "auto_close": False, "interactive": False})
        render(plotter.render_window)
        if options.get("auto_close", True):
            plotter.close()
        return shown

    pyvista.OFF_SCREEN = True
    pyvista.global_theme.window_size = PLOTTER_SIZE
    pyvista.Plotter.show = show_and_render


def run(script, data, shadows, result):
    """Run a script in this process, which ends then, and write what was counted."""
    import vtkmodules.util.misc

    counts = collections.Counter()
    compared = []

    def render(rendered):
        rendered.Render()
        window = rendered
        if not hasattr(window, "GetRenderers") and hasattr(window, "GetRenderWindow"):
            window = window.GetRenderWindow()
        if hasattr(window, "GetRenderers") and window not in compared and len(compared) < WINDOWS:
            compared.append(window)
            compare(window, shadows, counts)

    text = script.read_text(encoding="utf-8", errors="replace")
    if "pyvista" in text:
        watch_plotters(render)
    text = re.sub(r"([A-Za-z_][\w.\[\]]*)\.Render\(\)", r"_compare_render(\1)", text)
    text = re.sub(r"[A-Za-z_][\w.]*\.Start\(\)", "None", text)  # of an interactor
    vtkmodules.util.misc.vtkGetDataRoot = lambda: str(data)
    sys.argv = [str(script)]
    sys.path.insert(0, str(script.parent))
    try:
        exec(compile(text, script, "exec"),
             {"__name__": "__main__", "__file__": str(script), "_compare_render": render})
    except SystemExit:
        pass
    finally:
        result.write_text(json.dumps(counts))
        os._exit(0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scripts", type=pathlib.Path, nargs="+", metavar="SCRIPT")
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(), metavar="FOLDER",
                        help="what vtkGetDataRoot() returns to the scripts")
    parser.add_argument("--shadows", action="store_true",
                        help="compare with vtkShadowVolumeClampPass in the place of the culler")
    parser.add_argument("--result", type=pathlib.Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.result:
        run(options.scripts[0].resolve(), options.data.resolve(), options.shadows, options.result)
    total = collections.Counter()
    for script in options.scripts:
        with tempfile.TemporaryDirectory() as folder:
            result = pathlib.Path(folder) / "counts.json"
            command = [sys.executable, __file__, script.resolve(), "--data",
                       options.data.resolve(), "--result", result,
                       *["--shadows"] * options.shadows]
            try:
                subprocess.run(command, cwd=folder, capture_output=True, timeout=120,
                               stdin=subprocess.DEVNULL)
            except subprocess.TimeoutExpired:
                pass
            counts = json.loads(result.read_text()) if result.exists() else {}
        total.update(counts)
        total["scripts"] += counts.get("frames", 0) > 0
        if counts.get("frames that differ"):
            print(f"{script}: {counts['frames that differ']} of {counts['frames']} frames differ",
                  flush=True)
    print(", ".join(f"{count} {what}" for what, count in total.items()))
    sys.exit(total["frames that differ"] > 0)


if __name__ == "__main__":
    main()
