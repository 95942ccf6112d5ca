# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""python -m vtknbuffer, and python -m vtknbuffer.demo."""

import re
import subprocess
import sys

import pytest

pyvista = pytest.importorskip("pyvista", reason="SKIPPED: PyVista is not installed")

from vtknbuffer.__main__ import main  # noqa: E402


@pytest.fixture
def view(monkeypatch, capsys):
    """What ``python -m vtknbuffer`` does, in this process. Returns what it prints."""
    def call(*words):
        monkeypatch.setattr(sys, "argv", ["vtknbuffer", *map(str, words)])
        monkeypatch.setattr(pyvista.global_theme, "window_size", [160, 120])
        main()
        return capsys.readouterr().out
    return call


def run(*words):
    """Run Python. Returns its exit status, and what it prints as output and as errors."""
    done = subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True,
                          timeout=300)
    return done.returncode, done.stdout, done.stderr


def many_spheres():
    """Spheres of three walls as one mesh, and its number of parts."""
    spheres = [pyvista.Sphere(radius=0.45, center=(i % 5, i // 5 % 5, i // 25 * 2),
                              theta_resolution=6, phi_resolution=6) for i in range(75)]
    return pyvista.merge(spheres).extract_surface(), len(spheres)


@pytest.mark.parametrize("ending", ["vtp", "ply", "stl", "vtk"])
def test_file_is_shown_part_by_part(tmp_path, view, ending):
    mesh, parts = many_spheres()
    mesh.save(tmp_path / f"spheres.{ending}")
    picture = tmp_path / "picture.png"
    output = view(tmp_path / f"spheres.{ending}", "--offscreen", picture)
    found = re.search(r"(\d+) of (\d+) props drawn; (\d+) bytes differ", output)
    assert found, output
    assert 0 < int(found[2]) <= parts
    assert int(found[3]) == 0
    assert pyvista.read(picture).get_array(0).std() > 1


def test_blocks_and_shadows(tmp_path):
    pyvista.MultiBlock({f"part {i}": pyvista.Cube(center=(0, 0, -2 * i))
                        for i in range(40)}).save(tmp_path / "parts.vtm")
    status, output, errors = run("-m", "vtknbuffer", tmp_path / "parts.vtm", "--shadows",
                                 "--offscreen", tmp_path / "picture.png")
    assert status == 0, errors
    assert "0 bytes differ" in output


@pytest.mark.parametrize("name, content", [
    ("missing.vtp", None), ("empty.vtp", b""), ("cut.vtp", b"<VTKFile type='PolyData'><Poly"),
    ("unknown.xyzzy", b"1 2 3"), ("nothing.ply", b"ply\nformat ascii 1.0\nend_header\n")])
def test_refused_files_are_one_sentence(tmp_path, view, name, content):
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(SystemExit) as caught:
        view(path, "--offscreen", tmp_path / "picture.png")
    assert str(caught.value).startswith(f"python -m vtknbuffer: {path}: ")
    assert not (tmp_path / "picture.png").exists()


def test_refused_files_end_the_program(tmp_path):
    status, output, errors = run("-m", "vtknbuffer", tmp_path / "missing.vtp")
    assert status == 1
    assert errors.splitlines()[-1].endswith("there is no such file")
    assert "Traceback" not in errors


def test_demonstration():
    # It needs no PyVista.
    status, output, errors = run(
        "-c", "import runpy, sys; sys.modules['pyvista'] = None; runpy.run_module('vtknbuffer.demo', "
        "run_name='__main__', alter_sys=True)", "--frames", "3", "--size", "160", "120")
    assert status == 0, errors
    assert output.splitlines()[-1] == "0 bytes of all images differ."
    assert re.search(r"^  oracle +[0-9.]+ ms", output, re.MULTILINE)
    assert re.search(r"(\d+) of 15329 props drawn", output)
    assert run("-m", "vtknbuffer.demo", "--frames", "0")[0] == 2
