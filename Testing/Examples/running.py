# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts of this folder share: they run programs, and end with a message where one does not
do what it has to."""
import os
import pathlib
import subprocess
import sys

IS_X = os.environ.get("VTK_DEFAULT_OPENGL_WINDOW") == "vtkXOpenGLRenderWindow"


def check(holds, message):
    if not holds:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {message}")


def run(*command, status=0, **options):
    """What a program prints to stdout and to stderr."""
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, errors="replace",
                          check=False, **options)
    check(done.returncode == status, f"{command} ended with {done.returncode} instead of {status}: "
          f"{done.stdout}{done.stderr}")
    return done.stdout, done.stderr


def skip_without_display():
    """Where a window needs a display that is missing, the reason is printed, and the script ends."""
    if IS_X and not os.environ.get("DISPLAY"):
        print("Skipped: this VTK opens X windows only, and DISPLAY is not set")
        sys.exit()
