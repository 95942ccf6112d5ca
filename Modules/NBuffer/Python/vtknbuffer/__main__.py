# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""``python -m vtknbuffer FILE...``: a viewer of files that PyVista reads, with the culler.

Keys: n culler on and off, i freeze the verdicts, u a second view with what is culled in red,
k shadows on and off, y verify: compare this view byte by byte with that of stock VTK.
"""

import argparse
import pathlib
import sys
import time

import numpy as np
import pyvista

import vtknbuffer.pyvista  # noqa: F401 (older versions of PyVista do not find it by themselves)

# Files of whole scenes, which VTK's importers read part by part.
_IMPORTERS = {".gltf": "import_gltf", ".glb": "import_gltf", ".wrl": "import_vrml",
              ".vrml": "import_vrml", ".3ds": "import_3ds", ".obj": "import_obj"}


def _leaves(data):
    """Yield the data sets of a composite, and a data set itself."""
    if isinstance(data, pyvista.MultiBlock):
        for block in data:
            if block is not None:
                yield from _leaves(block)
    elif data.n_points > 0:
        yield data


def add_file(plotter, path):
    """Add the parts of a file as actors. Raises ValueError with the cause if it cannot be read."""
    path = pathlib.Path(path)
    if not path.is_file():
        raise ValueError(f"{path}: there is no such file")
    before = plotter.renderer.GetViewProps().GetNumberOfItems()
    importer = getattr(plotter, _IMPORTERS.get(path.suffix.lower(), ""), None)
    try:
        if importer:
            importer(str(path))
        else:
            for mesh in _leaves(pyvista.read(path)):
                bodies = mesh.split_bodies() if isinstance(mesh, pyvista.PolyData) else [mesh]
                for body in bodies if 1 < len(bodies) <= 20000 else [mesh]:
                    plotter.add_mesh(body, reset_camera=False, render=False,
                                     show_scalar_bar=False)
    except Exception as error:
        raise ValueError(f"{path}: {error}") from error
    if plotter.renderer.GetViewProps().GetNumberOfItems() == before:
        raise ValueError(f"{path}: the file has nothing that can be drawn")


def _timed_render(plotter):
    begin = time.perf_counter()
    plotter.render_window.Render()
    plotter.render_window.WaitForCompletion()
    return 1000 * (time.perf_counter() - begin)


def verify(plotter):
    """Draw this view without and with the culler. Returns times and the number of bytes that differ."""
    culler = plotter.nbuffer.culler
    usual = vtknbuffer.get_settings(culler)
    # The time is to be that of a camera that moves: each frame is tested anew.
    vtknbuffer.configure(culler, reuse_when_still=0)
    found = {}
    for name, enabled in (("stock", False), ("culler", True)):
        culler.SetEnabled(enabled)
        for _ in range(3):
            found[name] = _timed_render(plotter)
        found[f"{name}_image"] = plotter.screenshot(None, return_img=True)
    vtknbuffer.configure(culler, **usual)
    found["differing_bytes"] = int(
        np.count_nonzero(found["stock_image"] != found["culler_image"]))
    return found


def _describe(plotter):
    found = verify(plotter)
    counts = plotter.nbuffer.statistics
    return (f"stock {found['stock']:.1f} ms, culler {found['culler']:.1f} ms; "
            f"{counts['drawn']} of {counts['props']} props drawn; "
            f"{found['differing_bytes']} bytes differ")


class _Keys:
    """What the keys do."""

    def __init__(self, plotter):
        self._plotter = plotter
        self._shadows = False
        plotter.add_key_event("n", self._toggle)
        plotter.add_key_event("i", self._freeze)
        plotter.add_key_event("u", plotter.nbuffer.show_culled)
        plotter.add_key_event("k", self._toggle_shadows)
        plotter.add_key_event("y", lambda: print(_describe(plotter)))

    def _toggle(self):
        culler = self._plotter.nbuffer.culler
        culler.SetEnabled(not culler.GetEnabled())
        self._plotter.render()

    def _freeze(self):
        self._plotter.nbuffer.freeze(not self._plotter.nbuffer.culler.GetFreeze())

    def _toggle_shadows(self):
        self._shadows = not self._shadows
        nbuffer = self._plotter.nbuffer
        nbuffer.enable_shadows() if self._shadows else nbuffer.disable_shadows()
        self._plotter.render()


def main():
    parser = argparse.ArgumentParser(
        prog="python -m vtknbuffer", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="FILE", help="all that pyvista.read() reads")
    parser.add_argument("--offscreen", metavar="PNG", help="write a picture instead of a window")
    parser.add_argument("--shadows", action="store_true", help="draw shadows")
    options = parser.parse_args()
    plotter = pyvista.Plotter(off_screen=options.offscreen is not None)
    try:
        for path in options.files:
            add_file(plotter, path)
    except ValueError as error:
        sys.exit(f"python -m vtknbuffer: {error}")
    plotter.reset_camera()
    plotter.nbuffer.enable()
    if options.shadows:
        plotter.nbuffer.enable_shadows()
    if options.offscreen:
        plotter.show(auto_close=False)
        print(_describe(plotter))
        plotter.screenshot(options.offscreen)
        plotter.close()
    else:
        _Keys(plotter)
        plotter.show()


if __name__ == "__main__":
    main()
