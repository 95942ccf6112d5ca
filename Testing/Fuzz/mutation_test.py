#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plants errors in a copy of the module and demands that nbuffer-fuzz finds each in 1,000 frames,
rare ones in 10,000.

    Testing/Fuzz/mutation_test.py --build build --scratch FOLDER

takes compiler and VTK from the configured build folder, copies the sources to FOLDER and builds
there. Some minutes, so that it is not part of the normal run. Fails if

* the unchanged module fails,
* an error's old text is not found exactly once: list (mutants.py) and sources must not drift apart,
* an error survives.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import mutants

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MODULE = pathlib.Path("Modules/NBuffer")


def find_in_module(root, name):
    """Files of the module have unique names, whatever the folder."""
    return next((root / MODULE).rglob(name))


def copy_sources(target):
    """Tracked files and new ones that are not ignored. Only what differs, to build only that."""
    listed = subprocess.run(
        ["git", "-C", SOURCE, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        check=True, capture_output=True).stdout.decode().split("\0")
    for name in filter(None, listed):
        source, copy = SOURCE / name, target / name
        if not source.is_file():
            continue
        if not copy.is_file() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, copy)
            shutil.copymode(source, copy)


def configure(source, build, like):
    """With the generator, compiler and VTK of another build folder."""
    cache = (like / "CMakeCache.txt").read_text()
    command = ["cmake", "-S", source, "-B", build, "-DVTKNBUFFER_BUILD_EXAMPLES=OFF",
               "-DCMAKE_BUILD_TYPE=Release", "-DVTKNBUFFER_UNITY_BUILD=OFF"]
    generator = re.search(r"^CMAKE_GENERATOR:INTERNAL=(.+)$", cache, re.MULTILINE)
    if generator:
        command += ["-G", generator[1]]
    for name in ("CMAKE_CXX_COMPILER", "CMAKE_PREFIX_PATH", "VTK_DIR", "CMAKE_MAKE_PROGRAM"):
        found = re.search(rf"^{name}:\w+=(.+)$", cache, re.MULTILINE)
        if found:
            command.append(f"-D{name}={found[1]}")
    if shutil.which("ccache"):
        command.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def build_fuzzer(build, jobs):
    result = subprocess.run(
        ["cmake", "--build", build, "--target", "nbuffer-fuzz", "--parallel", str(jobs)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        sys.exit(f"does not compile:\n{result.stdout[-4000:]}")


def run_fuzzer(build, frames, seed, output, shadows):
    """Frames until the first failure, or None, and what failed."""
    counts = output / "counts.json"
    counts.unlink(missing_ok=True)
    result = subprocess.run(
        [build / "bin" / "nbuffer-fuzz", "--frames", str(frames), "--seed", str(seed),
         "--shadows", "1" if shadows else "0",
         "--max-failures", "1", "--no-shrink", "--json", counts, "--output", output],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    if result.returncode == 125:
        sys.exit(result.stdout)
    if not counts.is_file():
        # A crash is found as well; after how many frames nobody knows.
        return (-1 if result.returncode != 0 else None), f"ended with {result.returncode}"
    failed = json.loads(counts.read_text())["frames_until_failure"]
    text = re.search(r"^FAILED.*\n(.*)$", result.stdout, re.MULTILINE)
    return (failed if failed >= 0 else None), text[1].strip() if text else ""


def plant(source, replacements):
    """Returns the original texts of the files changed."""
    originals = {}
    for name, old, new in replacements:
        path = find_in_module(source, name)
        text = path.read_text()
        originals.setdefault(path, text)
        if text.count(old) != 1:
            sys.exit(f"{name}: found {text.count(old)} times instead of once:\n{old}")
        path.write_text(text.replace(old, new))
    return originals


def check_texts(chosen):
    for name, replacements in chosen.items():
        for file, old, _ in replacements:
            count = find_in_module(SOURCE, file).read_text().count(old)
            if count != 1:
                yield f"{name}: in {file} found {count} times instead of once:\n{old}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, help="configured build folder to be like")
    parser.add_argument("--scratch", type=pathlib.Path, help="folder for copy and build; kept")
    parser.add_argument("--frames", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="", help="only errors whose name holds this")
    parser.add_argument("--shadows", action="store_true", help="only errors in shadow volumes")
    parser.add_argument("--equivalent", action="store_true",
                        help="the changes that are no errors, which must not be found")
    parser.add_argument("--check-texts", action="store_true",
                        help="only whether every old text is there once; builds nothing")
    arguments = parser.parse_args()

    shadow_mutants = {**mutants.SHADOW_MUTANTS, **mutants.RARE_SHADOWS}
    rare = {**mutants.RARE, **mutants.RARE_SHADOWS}
    errors = {**mutants.MUTANTS, **mutants.RARE, **shadow_mutants}
    everything = {**errors, **mutants.EQUIVALENT}
    faults = list(check_texts(everything))
    if faults or arguments.check_texts:
        print("\n".join(faults) or f"{len(everything)} changes fit the sources")
        return 1 if faults else 0
    if not arguments.build or not arguments.scratch:
        parser.error("--build and --scratch are needed")

    chosen = (mutants.EQUIVALENT if arguments.equivalent
              else shadow_mutants if arguments.shadows else errors)
    chosen = {name: list_ for name, list_ in chosen.items() if arguments.only in name}
    scratch = arguments.scratch.resolve()
    source, build, output = scratch / "source", scratch / "build", scratch / "output"
    output.mkdir(parents=True, exist_ok=True)
    copy_sources(source)
    configure(source, build, arguments.build.resolve())
    build_fuzzer(build, arguments.jobs)
    for shadows in {name in shadow_mutants for name in chosen}:
        frames, text = run_fuzzer(build, arguments.frames, arguments.seed, output, shadows)
        if frames is not None:
            sys.exit(f"the unchanged module fails after {frames} frames: {text}")
        print(f"unchanged: no failure in {arguments.frames} frames"
              f"{' with shadows' if shadows else ''}, seed {arguments.seed}", flush=True)

    wrong = []
    for name, replacements in chosen.items():
        originals = plant(source, replacements)
        try:
            build_fuzzer(build, arguments.jobs)
            limit = arguments.frames * (10 if name in rare else 1)
            frames, text = run_fuzzer(build, limit, arguments.seed, output,
                                      name in shadow_mutants)
        finally:
            for path, original in originals.items():
                path.write_text(original)
        if (frames is None) != arguments.equivalent:
            wrong.append(name)
        print(f"{'survived' if frames is None else f'after {frames:4} frames'}: {name}  [{text}]",
              flush=True)
    print(f"{len(chosen) - len(wrong)} of {len(chosen)} as expected" +
          "".join(f"\nNOT: {name}" for name in wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
