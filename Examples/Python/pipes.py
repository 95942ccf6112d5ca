# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista: 1,500 pipes, of which only those that can be seen are drawn."""

import sys

import numpy as np
import pyvista as pv

import vtknbuffer.pyvista  # noqa: F401 (not needed with PyVista 0.48 and later)

plotter = pv.Plotter(window_size=(800, 600), off_screen=len(sys.argv) > 1)
random = np.random.default_rng(1)
for i in range(1500):
    pipe = pv.Cylinder(center=random.uniform(-7, 7, 3), direction=np.eye(3)[i % 3],
                       radius=random.uniform(0.1, 0.4), height=random.uniform(2, 8),
                       resolution=12)
    plotter.add_mesh(pipe, color=random.uniform(0.3, 1, 3), render=False,
                     reset_camera=False)

plotter.nbuffer.enable()

plotter.camera_position = [(20, 14, 11), (0, 0, 0), (0, 0, 1)]
plotter.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else None, auto_close=False)
statistics = plotter.nbuffer.statistics
print(f"{statistics['drawn']} of {statistics['props']} pipes drawn;",
      "the last one:", plotter.nbuffer.verdict(plotter.renderer.GetActors().GetLastActor()))
plotter.close()
