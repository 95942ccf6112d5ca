# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista: exact hard shadows of the sun, at any distance."""

import sys

import numpy as np
import pyvista as pv

import vtknbuffer.pyvista  # noqa: F401 (not needed with PyVista 0.48 and later)

plotter = pv.Plotter(window_size=(800, 600), off_screen=len(sys.argv) > 1, lighting="none")
plotter.add_mesh(pv.Plane(i_size=400, j_size=400), color="white")
angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
for ring in (12, 20, 28):
    for angle in angles:
        plotter.add_mesh(pv.Cylinder(center=(ring * np.cos(angle), ring * np.sin(angle), 2.5),
                                     direction=(0, 0, 1), radius=0.5, height=5), color="bisque")
plotter.add_mesh(pv.ParametricTorus(ringradius=6, crosssectionradius=1.5, center=(0, 0, 6)),
                 color="tomato", smooth_shading=True)

sun = pv.Light(position=(-60, -40, 45), light_type="scene light", intensity=0.9)
plotter.add_light(sun)
plotter.add_light(pv.Light(light_type="headlight", intensity=0.25))
plotter.nbuffer.enable_shadows()

plotter.camera_position = [(40, -45, 30), (0, 0, 2), (0, 0, 1)]
plotter.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else None, auto_close=False)
print(plotter.nbuffer.shadow_statistics["verdicts"])
plotter.close()
