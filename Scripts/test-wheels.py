#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the wheels that Scripts/wheel.sh has made, as users install them.

For each Python and the wheel that pip chooses for it, a virtual environment is made with the VTK that
the wheel needs; with --all for each wheel that the Python can use. In a folder that is empty it runs a smoke test (Testing/Python/smoke_wheel.py) and the
demonstration, and with --pytest all tests in Testing/Python with PyVista. It also checks that a
wheel refuses a VTK for which it has no module. The wheels of the package vtk are tested with each
of the versions that --vtk names.

What cannot be tested is said in a line that begins with "SKIPPED: ". The exit status is 1 if a test
failed, and 125 if none could run.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[1]
PYTHONS = ("3.10", "3.11", "3.12", "3.13")
CVISTA = "cvista[rendering]==9.7.0.5"


class Failure(Exception):
    """What has failed, with what it printed."""


def find_python(version):
    """Return an interpreter of this version, or None."""
    pyenv = pathlib.Path(os.environ.get("PYENV_ROOT", pathlib.Path.home() / ".pyenv"))
    found = [os.environ.get("PYTHON"), shutil.which(f"python{version}"),
             *pyenv.glob(f"versions/{version}.*/bin/python")]
    code = f"import sys; sys.exit(sys.version_info[:2] != ({version.replace('.', ', ')}))"
    for python in filter(None, found):
        if subprocess.run([python, "-c", code], capture_output=True).returncode == 0:
            return python
    return None


def find_wheels(dist, version):
    """Return the wheels in this folder for this version of Python, the one that pip chooses first.

    With each wheel the packages that it has a module for are returned.
    """
    found = []
    for wheel in sorted(dist.glob("vtk_nbuffer-*.whl")):
        python, abi = wheel.stem.split("-")[2:4]
        if abi == "abi3" and int(version[2:]) >= int(python[3:]):
            found.append((wheel, ("cvista",)))
        elif python == f"cp{version.replace('.', '')}":
            found.insert(0, (wheel, ("vtk", "cvista") if int(version[2:]) >= 12 else ("vtk",)))
    return found


class Environment:
    """A virtual environment with one wheel, and an empty folder."""

    def __init__(self, folder, python, wheel):
        shutil.rmtree(folder, ignore_errors=True)
        self.python = folder / "bin" / "python"
        self.empty = folder / "empty"
        self.run([python, "-m", "venv", folder], cwd=None)
        self.empty.mkdir()
        self.install(wheel)

    def run(self, command, status=0, **options):
        """Run a command in the empty folder; return what it prints, or raise Failure.

        If it is to fail with this status, what it prints as errors is returned.
        """
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("PYTHONPATH", "PYVISTA_VTK_BACKEND")}
        environment.update(options.pop("environment", {}))
        done = subprocess.run(
            [str(word) for word in command], env=environment, text=True, capture_output=True,
            **{"cwd": getattr(self, "empty", None), **options})
        if done.returncode != status:
            raise Failure(f"{' '.join(map(str, command))} returns {done.returncode}, not {status}:\n"
                          + "\n".join((done.stdout + done.stderr).splitlines()[-30:]))
        return (done.stderr if status else done.stdout).strip()

    def python_run(self, *words, **options):
        return self.run([self.python, *words], **options)

    def install(self, *packages):
        self.python_run("-m", "pip", "install", "--quiet", "--disable-pip-version-check",
                        "--only-binary=:all:", *packages)


def check_refusal(environment, package, variable=None):
    """The package must say in one sentence what it is compiled for, and which VTK is in use."""
    settings = {"PYVISTA_VTK_BACKEND": variable} if variable else {}
    printed = environment.python_run(
        "-c", "import vtknbuffer", status=1, environment=settings).splitlines()[-1]
    if not printed.startswith("ImportError: vtknbuffer was compiled for") or (
            f"but this process uses {package} 9.7" not in printed):
        raise Failure(f"wrong words for a VTK that does not fit: {printed}")
    print(f"   refused as it should be: {printed}", flush=True)


def run_tests(environment, package, title, with_pytest):
    """All tests with the VTK that is installed."""
    settings = {"environment": {"PYVISTA_VTK_BACKEND": package}}
    begin = time.monotonic()
    for line in environment.python_run(SOURCE / "Testing/Python/smoke_wheel.py",
                                       **settings).splitlines():
        print(f"   {line}")
    demo = environment.python_run("-m", "vtknbuffer.demo", "--frames", "5", **settings)
    if not demo.endswith("\n0 bytes of all images differ."):
        raise Failure(f"the demonstration fails:\n{demo}")
    print(f"   demonstration: {demo.splitlines()[-5]}", flush=True)
    if with_pytest and list(SOURCE.glob("Testing/Python/test_*.py")):
        environment.install("pyvista[cvista]" if package == "cvista" else "pyvista", "pytest")
        printed = environment.python_run("-m", "pytest", "-q", "-p", "no:cacheprovider",
                                         SOURCE / "Testing/Python", **settings)
        print(f"   pytest: {printed.splitlines()[-1]}")
    print(f"   {title}: passed in {time.monotonic() - begin:.0f} s", flush=True)


def test_wheel(wheel, packages, python, version, options):
    folder = options.work / f"{wheel.stem.split('-')[3]}-{version}"
    for package in packages:
        versions = options.vtk if package == "vtk" else ["9.7.0.5"]
        begin = time.monotonic()
        print(f"== {wheel.name}, Python {version}, {package}", flush=True)
        environment = Environment(folder, python, wheel)
        for i, number in enumerate(versions):
            environment.install(f"vtk=={number}" if package == "vtk" else CVISTA)
            print(f"   {package} {number}, {time.monotonic() - begin:.0f} s after the start", flush=True)
            run_tests(environment, package, f"{package} {number}", options.pytest and i == 0)
        if len(packages) == 1:
            # The other VTK as well: by the variable it is the one in use, although it does not fit.
            other = "cvista" if package == "vtk" else "vtk"
            if other == "vtk":
                environment.install(f"vtk=={options.vtk[0]}")
                check_refusal(environment, "vtk", "vtk")
                environment.python_run("-m", "pip", "uninstall", "--quiet", "--yes", "cvista")
                check_refusal(environment, "vtk")
            elif int(version[2:]) >= 12:
                environment.install(CVISTA)
                check_refusal(environment, "cvista")
    shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dist", nargs="?", type=pathlib.Path, default=SOURCE / "dist")
    parser.add_argument("--python", nargs="+", default=PYTHONS, metavar="3.X", choices=PYTHONS)
    parser.add_argument("--vtk", nargs="+", default=["9.7.0", "9.7.1", "9.7.2"], metavar="9.7.X")
    parser.add_argument("--all", action="store_true",
                        help="also wheels that pip does not choose if it has another one")
    parser.add_argument("--pytest", action="store_true",
                        help="also run Testing/Python, with the first of these versions of VTK")
    parser.add_argument("--work", type=pathlib.Path, default=SOURCE / "build/wheel/test")
    options = parser.parse_args()
    options.dist, options.work = options.dist.resolve(), options.work.resolve()
    tested = failed = 0
    for version in options.python:
        python = find_python(version)
        wheels = find_wheels(options.dist, version)[:None if options.all else 1]
        if not wheels or not python:
            print(f"SKIPPED: Python {version}: "
                  + ("it is not found" if wheels else f"there is no wheel for it in {options.dist.name}"))
            continue
        for wheel, packages in wheels:
            tested += 1
            try:
                test_wheel(wheel, packages, python, version, options)
            except Failure as failure:
                failed += 1
                print(f"FAILED: {wheel.name}, Python {version}: {failure}", flush=True)
    print(f"{tested - failed} of {tested} wheels passed")
    sys.exit(1 if failed else 0 if tested else 125)


if __name__ == "__main__":
    main()
