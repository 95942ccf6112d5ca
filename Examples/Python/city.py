# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista: houses of the shipped city as actors, with culling and shadows."""

import sys

import numpy as np
import pyvista as pv

import vtknbuffer.pyvista  # noqa: F401 (not needed with PyVista 0.48 and later)
from vtknbuffer import city

plotter = pv.Plotter(window_size=(800, 600), off_screen=len(sys.argv) > 1, lighting="none")
buildings, streets = city.read()
eyes, focal_points = city.walk(buildings, streets, 60)
random = np.random.default_rng(1)
for outline, height in buildings:
    if np.linalg.norm(outline[0] - eyes[0, :2]) < 700:
        plotter.add_mesh(pv.PolyData(*city.walls_and_roof(outline, height)), render=False,
                         color=random.uniform(0.6, 0.95, 3), reset_camera=False)
plotter.add_mesh(pv.Plane(i_size=18000, j_size=18000), color="darkseagreen")
plotter.add_light(pv.Light(position=(-40, -60, 70), light_type="scene light"))
plotter.add_light(pv.Light(light_type="headlight", intensity=0.3))
plotter.set_background("lightskyblue")

plotter.nbuffer.enable()
plotter.nbuffer.enable_shadows()

plotter.camera_position = [eyes[0] + (0, 0, 35), focal_points[59] + (0, 0, 20), (0, 0, 1)]
plotter.show(screenshot=sys.argv[1] if len(sys.argv) > 1 else None, auto_close=False)
print(plotter.nbuffer.statistics["drawn"], "of", len(plotter.actors), "props drawn")
plotter.close()
