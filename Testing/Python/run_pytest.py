#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tests of the Python package, or the examples, with the package of a build folder.

    run_pytest.py --venv FOLDER [--examples FOLDER]

PyVista is installed into a virtual environment in FOLDER, which also sees the packages of the
distribution. Where that fails, tests that need PyVista say SKIPPED.
"""

import argparse
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
REQUIREMENTS = SOURCE / "Scripts/requirements-pyvista.txt"


def make_environment(folder):
    """Return the Python of the environment, which has PyVista if it can be installed."""
    python = folder / "bin" / "python"
    stamp = folder / "requirements"
    if not stamp.exists() or stamp.read_text() != REQUIREMENTS.read_text():
        subprocess.run([sys.executable, "-m", "venv", "--clear", "--system-site-packages", folder],
                       check=True)
        done = subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-deps",
                               "--no-compile", "--only-binary=:all:", "--require-hashes", "-r", REQUIREMENTS])
        if done.returncode == 0:
            stamp.write_text(REQUIREMENTS.read_text())
    return python


def run_examples(python, folder):
    """Run each example; it must write a picture that shows something. Return how many failed."""
    folder.mkdir(parents=True, exist_ok=True)
    failed = 0
    for example in sorted((SOURCE / "Examples/Python").glob("*.py")):
        picture = folder / f"{example.stem}.png"
        picture.unlink(missing_ok=True)
        done = subprocess.run([python, example, picture], text=True, capture_output=True)
        lines = len(example.read_text().splitlines())
        # A picture of one colour takes less than a tenth of this.
        size = picture.stat().st_size if picture.is_file() else 0
        passed = done.returncode == 0 and lines < 40 and size > 10000
        failed += not passed
        print(f"{'passed' if passed else 'FAILED'}: {example.name}, {lines} lines, a picture of "
              f"{size} bytes; {(done.stdout.strip().splitlines() or [''])[-1]}", flush=True)
        if not passed:
            print(done.stdout + done.stderr)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--venv", type=pathlib.Path, required=True)
    parser.add_argument("--examples", type=pathlib.Path, metavar="FOLDER",
                        help="run the examples and write their pictures to this folder")
    options = parser.parse_args()
    python = make_environment(options.venv)
    if options.examples:
        if subprocess.run([python, "-c", "import pyvista"], capture_output=True).returncode:
            print("SKIPPED: PyVista cannot be installed")
            sys.exit(125)
        sys.exit(run_examples(python, options.examples) > 0)
    sys.exit(subprocess.run([python, "-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider",
                             SOURCE / "Testing/Python"]).returncode)


if __name__ == "__main__":
    main()
