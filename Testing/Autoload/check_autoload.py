#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program that is not changed with and without the plug-in of Examples/Autoload.

    check_autoload.py --plugin FOLDER --sums FOLDER --vtk VERSION --out FOLDER
        [--set VARIABLE=VALUE]... [--report KEY=NUMBER]... [--frames N] [--any-order] command...

"{out}" in the command stands for the folder of the run, in which the program may write pictures.
These, and every frame that the plug-in of FrameSums.cxx sees, have to be the same to the byte in both
runs, and in the same order without --any-order. The report has to name a renderer in which props were
hidden, with the decision Culled in at least N frames, and its first renderer has to have the numbers that
--report gives. Exits with 125 and says SKIPPED where the program is missing or uses another VTK than the plug-in.
"""

import argparse
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys

# How to find out which VTK a program of the distribution uses, and its package in Debian.
DISTRIBUTED = {
    "python3": ("python3-vtk9", [
        "-c", "import vtkmodules.vtkCommonCore as c; print(c.vtkVersion.GetVTKVersion())"]),
    "f3d": ("f3d", ["--version"]),
}


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(125)


def check_program(program, vtk):
    package, arguments = DISTRIBUTED.get(pathlib.Path(program).name, (None, None))
    if not package:
        return
    found = None
    if shutil.which(program):
        found = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    if not found or found.returncode != 0:
        skip(f"{program} with VTK is missing (Debian: {package})")
    words = found.stdout.split()
    if vtk not in words:
        version = next((word for word in words if word.startswith("9.")), "of another version")
        skip(f"{program} uses VTK {version}, and the plug-in was built with VTK {vtk}")


def run(command, out, variables):
    """The checksums of the frames and of the pictures."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    sums = out / "sums.txt"
    command = [word.replace("{out}", str(out)) for word in command]
    done = subprocess.run(command, env={**os.environ, **variables, "FRAME_SUMS": str(sums)},
                          capture_output=True, text=True, check=False)
    print(done.stdout + done.stderr, end="", flush=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} ended with {done.returncode}")
    pictures = [f"{file.name} {hashlib.sha256(file.read_bytes()).hexdigest()}"
                for file in sorted(out.glob("*.png"))]
    return (sums.read_text().splitlines() if sums.exists() else []) + pictures


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True)
    parser.add_argument("--sums", required=True)
    parser.add_argument("--vtk", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--report", action="append", default=[])
    parser.add_argument("--frames", type=int, default=1)
    parser.add_argument("--any-order", action="store_true")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()
    if os.environ.get("VTK_DEFAULT_OPENGL_WINDOW", "").startswith("vtkX") \
            and not os.environ.get("DISPLAY"):
        skip("this VTK opens X windows only, and DISPLAY is not set")
    check_program(arguments.command[0], arguments.vtk)

    expected = run(arguments.command, arguments.out / "without", {
        "VTK_AUTOLOAD_PATH": arguments.sums})
    report = arguments.out / "report.json"
    report.unlink(missing_ok=True)
    frames = run(arguments.command, arguments.out / "with", {
        "VTK_AUTOLOAD_PATH": os.pathsep.join([arguments.sums, arguments.plugin]),
        "NBUFFER_REPORT": str(report),
        **dict(variable.split("=", 1) for variable in arguments.set)})
    text = report.read_text()
    print(text, end="", flush=True)
    renderers = json.loads(text)["renderers"]
    culled = [renderer["decisions"].get("Culled", 0) for renderer in renderers
              if renderer["hidden"] > 0]
    if max(culled, default=0) < arguments.frames or len(frames) < arguments.frames:
        sys.exit(f"no renderer hid anything in {arguments.frames} frames")
    for key, number in (words.split("=") for words in arguments.report):
        if renderers[0].get(key) != int(number):
            sys.exit(f"{key} is {renderers[0].get(key)} in the report instead of {number}")
    if arguments.any_order:
        frames, expected = sorted(frames), sorted(expected)
    if frames != expected:
        sys.exit(f"the plug-in changes {sum(map(str.__ne__, frames, expected))} of "
                 f"{len(expected)} frames and pictures, and there are {len(frames)}")
    print(f"{len(frames)} frames and pictures are the same to the byte")


if __name__ == "__main__":
    main()
