#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the wheels that Scripts/wheel.sh has made, as users install them.

For each Python and each wheel that it can use, a virtual environment is made with the VTK that the
wheel needs. In a folder that is empty it runs a smoke test (Testing/Python/smoke_wheel.py) with each
of the versions that --vtk names, and, unless --smoke is given, all tests in Testing/Python with the
first one and PyVista. The part for cvista is the same file in several wheels; all tests run with the
one that pip chooses. It also checks that a wheel refuses a VTK for which it has no module.

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
        # To compile all modules takes longer than to compile what the tests import.
        self.python_run("-m", "pip", "install", "--quiet", "--disable-pip-version-check",
                        "--no-compile", "--only-binary=:all:", *packages)


def check_refusal(environment, package, variable=None):
    """The package must say in one sentence what it is compiled for, and which VTK is in use."""
    settings = {"PYVISTA_VTK_BACKEND": variable} if variable else {}
    printed = environment.python_run(
        "-c", "import vtknbuffer", status=1, environment=settings).splitlines()[-1]
    if not printed.startswith("ImportError: vtknbuffer was compiled for") or (
            f"but this process uses {package} 9.7" not in printed):
        raise Failure(f"wrong words for a VTK that does not fit: {printed}")
    print(f"   refused as it should be: {printed}", flush=True)


def run_smoke_test(environment, package):
    for line in environment.python_run(SOURCE / "Testing/Python/smoke_wheel.py",
                                       environment={"PYVISTA_VTK_BACKEND": package}).splitlines():
        print(f"   {line}", flush=True)


def run_pytest(environment, package):
    """Run all tests. PyVista's view of trame is tested as well, which has two packages of its own."""
    environment.install("pyvista[cvista]" if package == "cvista" else "pyvista", "pytest",
                        "trame-vtk", "wslink")
    printed = environment.python_run("-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider",
                                     SOURCE / "Testing/Python",
                                     environment={"PYVISTA_VTK_BACKEND": package}).splitlines()
    for line in printed:
        if line.startswith("SKIPPED") or line == printed[-1]:
            print(f"   pytest: {line}", flush=True)


def test_wheel(wheel, packages, python, version, options, tested):
    """Test one wheel; add the packages with which all tests have run to the set ``tested``."""
    folder = options.work / f"{wheel.stem.split('-')[3]}-{version}"
    begin = time.monotonic()
    print(f"== {wheel.name}, Python {version}", flush=True)
    environment = Environment(folder, python, wheel)
    for package in packages:
        for i, number in enumerate(options.vtk if package == "vtk" else ["9.7.0.5"]):
            print(f"   {package} {number}, {time.monotonic() - begin:.0f} s after the start", flush=True)
            environment.install(f"vtk=={number}" if package == "vtk" else CVISTA)
            run_smoke_test(environment, package)
            if i == 0 and package not in tested and not options.smoke:
                run_pytest(environment, package)
                tested.add(package)
    if packages == ("cvista",):
        # The package vtk as well: by the variable it is the one in use, although it does not fit.
        environment.install(f"vtk=={options.vtk[0]}")
        check_refusal(environment, "vtk", "vtk")
        environment.python_run("-m", "pip", "uninstall", "--quiet", "--yes", "cvista")
        check_refusal(environment, "vtk")
    shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("dist", nargs="?", type=pathlib.Path, default=SOURCE / "dist")
    parser.add_argument("--python", nargs="+", default=PYTHONS, metavar="3.X", choices=PYTHONS)
    parser.add_argument("--vtk", nargs="+", default=["9.7.0", "9.7.1", "9.7.2"], metavar="9.7.X")
    parser.add_argument("--smoke", action="store_true", help="only the smoke tests")
    parser.add_argument("--work", type=pathlib.Path, default=SOURCE / "build/wheel/test")
    options = parser.parse_args()
    options.dist, options.work = options.dist.resolve(), options.work.resolve()
    tested = failed = 0
    for version in options.python:
        python = find_python(version)
        wheels = find_wheels(options.dist, version)
        if not wheels or not python:
            print(f"SKIPPED: Python {version}: "
                  + ("it is not found" if wheels else f"there is no wheel for it in {options.dist.name}"))
            continue
        with_all_tests = set()
        for wheel, packages in wheels:
            tested += 1
            try:
                test_wheel(wheel, packages, python, version, options, with_all_tests)
            except Failure as failure:
                failed += 1
                print(f"FAILED: {wheel.name}, Python {version}: {failure}", flush=True)
    print(f"{tested - failed} of {tested} wheels passed")
    sys.exit(1 if failed else 0 if tested else 125)


if __name__ == "__main__":
    main()
