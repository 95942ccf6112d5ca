# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which VTK is chosen, and what is said where it does not fit."""

import os
import pathlib
import subprocess
import sys

import pytest

import vtknbuffer
from vtknbuffer import _backend

PACKAGE = pathlib.Path(vtknbuffer.__file__).parent


def run(code, **environment):
    """Run code in a Python of its own. Returns its exit status and the last line of its errors."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                          env={**os.environ, **environment}, timeout=120)
    return done.returncode, (done.stderr.strip().splitlines() or [""])[-1]


def test_present_backend_is_the_chosen_one():
    assert _backend.find_vtk_package() == vtknbuffer._vtk_package


def test_variable_is_followed():
    name = "vtk" if vtknbuffer._vtk_package == "vtkmodules" else vtknbuffer._vtk_package
    assert run("import vtknbuffer", PYVISTA_VTK_BACKEND=name) == (0, "")


def test_missing_vtk_is_named():
    status, text = run("import vtknbuffer", PYVISTA_VTK_BACKEND="nosuchvtk")
    assert status == 1
    assert text.startswith("ImportError: vtknbuffer needs the VTK of the package nosuchvtk")
    assert "it was compiled for" in text


def with_build(monkeypatch, version):
    """The package as if its module were compiled for another version of VTK."""
    build = sys.modules[f"vtknbuffer.{'_cvista' if vtknbuffer._vtk_package == 'cvista' else '_vtk'}"]
    monkeypatch.setattr(build, "VTK_VERSION", version)


def test_other_version_is_refused(monkeypatch):
    with_build(monkeypatch, "9.0.3")
    with pytest.raises(ImportError) as caught:
        _backend.load()
    assert "compiled for" in str(caught.value) and "9.0.3" in str(caught.value)
    assert "but this process uses" in str(caught.value)


def test_missing_build_is_refused(monkeypatch):
    other = "vtkmodules" if vtknbuffer._vtk_package == "cvista" else "cvista"
    if (PACKAGE / ("_vtk" if other == "vtkmodules" else "_cvista")).is_dir():
        pytest.skip("SKIPPED: this package has a module for both VTKs")
    found = _backend.importlib.import_module
    monkeypatch.setattr(_backend, "find_vtk_package", lambda: other)
    # The other VTK need not be installed for this test: ours answers in its place.
    monkeypatch.setattr(_backend.importlib, "import_module", lambda name: found(
        name.replace(other, vtknbuffer._vtk_package, 1) if name.startswith(other) else name))
    with pytest.raises(ImportError, match="install the other one of the two"):
        _backend.load()
