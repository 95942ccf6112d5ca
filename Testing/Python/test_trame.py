# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The view that trame renders on the server, for notebooks among others."""

import io
import os
import time

import pytest

import vtknbuffer
from conftest import differing, vtk

os.environ["VTK_MODULE_NAME"] = vtknbuffer._vtk_package

try:
    import numpy as np
    import pyvista
    from PIL import Image
    from trame_vtk.modules.vtk.protocols import publish_image_delivery as delivery

    import vtknbuffer.pyvista
except ImportError as error:
    pytest.skip(f"SKIPPED: {error}", allow_module_level=True)


class Server(delivery.vtkWebPublishImageDelivery):
    """trame's delivery of images, without a connection."""

    def __init__(self):
        super().__init__(decode=False)
        self._application = vtk("vtkWebCore").vtkWebApplication()
        self._application.SetImageEncoding(0)

    @property
    def app(self):
        return self._application


def test_image_of_the_server_is_the_same():
    images = []
    for enabled in (False, True):
        plotter = pyvista.Plotter(off_screen=True, window_size=(200, 150))
        for i in range(60):
            plotter.add_mesh(pyvista.Plane(center=(0, 0, -i)), color=(i / 60, 0.5, 0.5))
        if enabled:
            plotter.nbuffer.enable()
        plotter.show(auto_close=False)
        server = Server()
        view = str(server.app.GetObjectIdMap().GetGlobalId(plotter.render_window))
        for i in range(10):  # Where nothing was hidden, only every eighth frame is tested.
            plotter.camera_position = [(0.03 * i, 0, 4), (0, 0, 0), (0, 1, 0)]
            plotter.renderer.ResetCameraClippingRange()
            reply = server.still_render({"view": view, "quality": 100})
        # Images are compressed in another thread; until that is done, the last one is sent.
        for _ in range(100):
            if not reply["stale"]:
                break
            time.sleep(0.05)
            reply = server.still_render({"view": view, "quality": 100, "mtime": 1})
        images.append(np.asarray(Image.open(io.BytesIO(reply["image"]))))
        if enabled:
            assert plotter.nbuffer.statistics["verdicts"]["Hidden"] > 20
        plotter.close()
    assert images[0].std() > 0
    assert differing(*images) == 0
