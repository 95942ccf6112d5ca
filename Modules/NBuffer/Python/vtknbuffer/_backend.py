# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the VTK that this process uses, and loads the module that was compiled for it.

Two Python packages contain a VTK: ``vtkmodules`` (the packages ``vtk`` of PyPI and Debian) and
``cvista``. Objects of one cannot be used with the other, so that this package contains a
compiled module for each, in the folders ``_vtk`` and ``_cvista``, or for only one of them.
"""

import importlib
import importlib.util
import os
import sys

# Versions of VTK whose classes have the same layout, as far as this module uses them: sizes, members
# and virtual tables in the packages of PyPI were compared (only the cell locators of 9.7.2 differ),
# and Scripts/test-wheels.py tests a module that was compiled for 9.7.0 with the others. Any other
# version has to be the one that it was compiled for.
_INTERCHANGEABLE = ({"9.7.0", "9.7.1", "9.7.2"},)


def find_vtk_package():
    """Return the name of the package that contains the VTK in use: "cvista" or "vtkmodules".

    The choice is PyVista's: if PyVista is loaded, the package that it uses, otherwise that of the
    environment variable PYVISTA_VTK_BACKEND, otherwise cvista if it is installed. Without PyVista
    and the variable, a VTK that is loaded already comes first.
    """
    pyvista = sys.modules.get("pyvista")
    if pyvista is not None:
        backend = pyvista.vtk_backend() if hasattr(pyvista, "vtk_backend") else "vtk"
    else:
        backend = os.environ.get("PYVISTA_VTK_BACKEND")
    if backend:
        return "vtkmodules" if backend == "vtk" else backend
    loaded = [name for name in ("cvista", "vtkmodules") if name in sys.modules]
    if len(loaded) == 1:
        return loaded[0]
    # A folder that cvista has left behind when it was uninstalled has no origin.
    cvista = importlib.util.find_spec("cvista")
    return "cvista" if cvista and cvista.origin else "vtkmodules"


def _describe_builds(folders):
    """Return, for a message, for what the modules in these folders were compiled."""
    builds = []
    for folder in folders:
        if importlib.util.find_spec(f"{__package__}.{folder}"):
            build = importlib.import_module(f"{__package__}.{folder}")
            builds.append(f"{folder[1:]} {build.VTK_VERSION}")
    return " and ".join(builds) or "nothing"


def load():
    """Load the compiled module. Returns it and the name of the package that contains VTK.

    Raises ImportError, with one sentence that names both sides, if the package has no module for
    the VTK in use.
    """
    package = find_vtk_package()
    folder = "_cvista" if package == "cvista" else "_vtk"
    try:
        version = importlib.import_module(
            f"{package}.vtkCommonCore").vtkVersion.GetVTKVersion()
        # Its factories make the OpenGL classes that the module works with.
        importlib.import_module(f"{package}.vtkRenderingOpenGL2")
    except ImportError as error:
        raise ImportError(
            f"vtknbuffer needs the VTK of the package {package}, which cannot be imported "
            f"({error}); it was compiled for {_describe_builds(('_vtk', '_cvista'))}.") from error

    in_use = f"{'cvista' if package == 'cvista' else 'vtk'} {version}"
    if not importlib.util.find_spec(f"{__package__}.{folder}"):
        raise ImportError(
            f"vtknbuffer was compiled for {_describe_builds(('_vtk', '_cvista'))}, but this "
            f"process uses {in_use}: install the other one of the two, or set "
            "PYVISTA_VTK_BACKEND to the one that is to be used.")
    built_for = importlib.import_module(f"{__package__}.{folder}").VTK_VERSION
    if version != built_for and not any({version, built_for} <= group
                                        for group in _INTERCHANGEABLE):
        raise ImportError(
            f"vtknbuffer was compiled for {_describe_builds((folder,))}, but this process uses "
            f"{in_use}, whose classes may have another layout: install that version of VTK, or "
            "a vtknbuffer that was compiled for this one.")
    return importlib.import_module(f"{__package__}.{folder}.vtkNBuffer"), package
