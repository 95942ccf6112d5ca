# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista: what a view leaves out, in red, from a second view."""

import sys

import numpy as np
import pyvista as pv

import vtknbuffer.pyvista  # noqa: F401 (not needed with PyVista 0.48 and later)

off_screen = len(sys.argv) > 1
plotter = pv.Plotter(window_size=(800, 600), off_screen=off_screen)
random = np.random.default_rng(3)
for x in range(40):
    for y in range(40):
        height = random.uniform(1, 6)
        plotter.add_mesh(pv.Cube(center=(3 * x, 3 * y, height / 2), x_length=2, y_length=2,
                                 z_length=height), color="wheat", render=False, reset_camera=False)
plotter.add_mesh(pv.Plane(center=(58, 58, 0), i_size=140, j_size=140), color="gray")
plotter.nbuffer.enable()

# A street at eye height.
plotter.camera_position = [(58.5, -6, 1.7), (58.5, 50, 1.7), (0, 0, 1)]
plotter.show(auto_close=False, interactive=not off_screen)

second = plotter.nbuffer.show_culled(cpos=[(-20, -70, 90), (58, 50, 0), (0, 0, 1)],
                                     show=not off_screen)
if off_screen:
    second.screenshot(sys.argv[1])
print(plotter.nbuffer.statistics["verdicts"]["Hidden"], "props hidden")
plotter.close()
