#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Walls of cubes spread over the processes of mpirun, drawn from Python with and without the culler.

    mpirun -n 3 sort_last.py

The pictures, composited by depth, must be the same to the byte, and no process may draw what only
the walls of others hide. While nothing moves, nothing is exchanged.
"""

import sys
import traceback

try:
    import numpy
    from mpi4py import MPI
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
    from vtkmodules.vtkFiltersSources import vtkCubeSource
    from vtkmodules.vtkParallelMPI import vtkMPIController
    from vtkmodules.vtkRenderingCore import (
        vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

    import vtknbuffer.parallel
except ImportError as missing:
    print(f"SKIPPED: {missing}")
    sys.exit(0)

SIZE = 20  # Cubes along each side of a wall.
WALLS = 12


def make_window(rank, ranks):
    """Return a window with every `ranks`-th cube of walls that stand one behind the other."""
    cube = vtkCubeSource()
    renderer = vtkRenderer()
    for i in range(rank, SIZE * SIZE * WALLS, ranks):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        wall = i // (SIZE * SIZE)
        actor.SetPosition(i % SIZE, i // SIZE % SIZE, -3 * wall)
        actor.GetProperty().SetColor(0.3 + i % 7 / 10, 1 - wall / WALLS, 0.5)
        renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(320, 240)
    window.AddRenderer(renderer)
    return window, renderer


def draw(window, renderer, frame):
    """Return the composited picture of all processes, on each of them."""
    camera = renderer.GetActiveCamera()
    camera.SetPosition(SIZE / 2 + frame / 10, SIZE / 2, 12)
    camera.SetFocalPoint(SIZE / 2, SIZE / 2, 0)
    camera.SetClippingRange(1, 100)
    window.Render()
    width, height = window.GetSize()
    colors, depths = vtkUnsignedCharArray(), vtkFloatArray()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, colors)
    window.GetZbufferData(0, 0, width - 1, height - 1, depths)
    all_colors = numpy.array(MPI.COMM_WORLD.allgather(vtk_to_numpy(colors)))
    nearest = numpy.array(MPI.COMM_WORLD.allgather(vtk_to_numpy(depths))).argmin(axis=0)
    return all_colors[nearest, numpy.arange(width * height)]


def main():
    controller = vtkMPIController()
    controller.Initialize()  # mpi4py has initialized MPI.
    rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    stock, ours, local = (make_window(rank, ranks) for _ in range(3))
    exchange = vtknbuffer.parallel.vtkNBufferParallelDepthExchange()
    exchange.SetController(controller)
    exchange.SetRenderer(ours[1])
    cullers = [vtknbuffer.enable(ours[1]), vtknbuffer.enable(local[1])]
    cullers[0].SetDepthExchange(exchange)
    exchanges = []
    for frame in range(12):
        views = [draw(*window, min(frame, 5)) for window in (stock, ours, local)]
        assert all(numpy.array_equal(views[0], view) for view in views[1:]), frame
        exchanges.append(exchange.GetNumberOfExchanges())
    drawn = [MPI.COMM_WORLD.allreduce(culler.GetNumberOfPropsDrawn()) for culler in cullers]
    if rank == 0:
        print(f"drawn of {SIZE * SIZE * WALLS}: {drawn[0]}, without the exchange {drawn[1]}; "
              f"exchanges {exchanges}")
    if ranks > 1:
        assert drawn[0] < drawn[1]
        assert exchanges[3] == 1
        assert exchanges[-1] == 0 and exchange.GetNumberOfBytes() == 4
    exchange.SetRenderer(None)


try:
    main()
except Exception:
    traceback.print_exc()
    MPI.COMM_WORLD.Abort(1)  # The other processes would wait for this one.
