# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The exchange of depth between the processes of a parallel program (docs/many-machines.md).

    exchange = vtknbuffer.parallel.vtkNBufferParallelDepthExchange()
    exchange.SetController(controller)
    exchange.SetRenderer(renderer)
    vtknbuffer.enable(renderer).SetDepthExchange(exchange)

Every process does this, before its first frame. The package has this module where its VTK has
ParallelCore; wheels do without it.
"""

import importlib

from . import _module

try:
    vtkNBufferParallelDepthExchange = importlib.import_module(
        f"{_module.__name__}Parallel").vtkNBufferParallelDepthExchange
except ModuleNotFoundError as error:
    raise ImportError("this vtknbuffer was compiled without the module NBufferParallel: compile it "
                      "for a VTK that has ParallelCore") from error

__all__ = ["vtkNBufferParallelDepthExchange"]
