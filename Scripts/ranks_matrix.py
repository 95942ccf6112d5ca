#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a city on the processes of mpirun and compares the pictures to the byte.

    ranks_matrix.py build/debian-vtk/bin/nbuffer-mpi-tests --json out/ranks-matrix.json

For each number of processes, spread and path, the same frames are drawn by VTK alone on one
process, by VTK alone on all processes, and by the culler on all processes with the exchange of depth
and without it. It prints a table of how many pictures differ from the one that they are compared
with, and ends with 1 if any does. Rows that the JSON file has
already are not drawn again, so that a run that was stopped can be continued. The whole matrix takes
an hour or two. Without a display, start it with xvfb-run.
"""

import argparse
import concurrent.futures
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys

SPREADS = ("kd", "random")
PATHS = ("street", "rooftop", "drone", "cuts", "orbit")
# For Open MPI: more processes than processors, which do not wait in a busy loop, and as root.
ENVIRONMENT = {
    "LP_NUM_THREADS": "0", "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
RESULT = re.compile(r"(\d+) of (\d+) frames differ, VTK alone on one process: (\d+) of (\d+)")
DRAWN = re.compile(r"(\w+), all: (\S+) of (\S+) props drawn")


def draw(program, processes, spread, path, frames, size):
    """Return the figures of a row."""
    run = subprocess.run(
        ["mpirun", "-n", str(processes), program, "--spread", spread, "--path", path, "--frames",
         str(frames), "--width", str(size[0]), "--height", str(size[1]), "--modes",
         "shared,local"],
        env={**os.environ, **ENVIRONMENT}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, check=False)
    result = RESULT.search(run.stdout)
    if not result:
        raise SystemExit(f"ranks_matrix.py: {processes} processes, {spread}, {path}:\n{run.stdout}")
    row = {"culled_differ": int(result[1]), "culled": int(result[2]), "stock_differ": int(result[3]),
           "stock": int(result[4]), "ended_with": run.returncode}
    for mode, drawn, inside in DRAWN.findall(run.stdout):
        row[f"drawn_{mode}"], row["inside"] = float(drawn), float(inside)
    return row


def format_table(rows):
    """Return a table of how many of the compared pictures differ, for the document."""
    groups = dict.fromkeys(tuple(key.split()[:2]) for key in rows)
    lines = ["| processes, spread | " + " | ".join(PATHS) + " |", "|---" * (len(PATHS) + 1) + "|"]
    for processes, spread in sorted(groups):
        cells = []
        for path in PATHS:
            row = rows.get(f"{processes} {spread} {path}")
            cells.append(f"{row['culled_differ'] + row['stock_differ']} of "
                         f"{row['culled'] + row['stock']}" if row else "-")
        lines.append(f"| {processes}, `{spread}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="nbuffer-mpi-tests")
    parser.add_argument("--json", type=pathlib.Path, required=True, help="the file of the figures")
    parser.add_argument("--processes", type=int, nargs="+", default=[1, 2, 3, 4, 7])
    parser.add_argument("--paths", nargs="+", default=PATHS)
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--size", type=int, nargs=2, default=[320, 240])
    parser.add_argument("--jobs", type=int, default=1, help="rows drawn at the same time")
    arguments = parser.parse_args()
    setting = {"frames": arguments.frames, "size": arguments.size}
    report = json.loads(arguments.json.read_text()) if arguments.json.exists() else {
        **setting, "rows": {}}
    if any(report[name] != value for name, value in setting.items()):
        raise SystemExit("ranks_matrix.py: the file has rows of other frames or sizes")
    rows = [(path, processes, spread) for path, processes, spread in itertools.product(
        arguments.paths, arguments.processes, SPREADS)
            if f"{processes} {spread} {path}" not in report["rows"]]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        futures = {pool.submit(draw, arguments.program, processes, spread, path, arguments.frames,
                               arguments.size): f"{processes} {spread} {path}"
                   for path, processes, spread in rows}
        for future in concurrent.futures.as_completed(futures):
            report["rows"][futures[future]] = future.result()
            arguments.json.write_text(json.dumps(report, indent=1, sort_keys=True) + "\n")
            print(futures[future], future.result(), flush=True)
    print(format_table(report["rows"]))
    return 1 if any(row["culled_differ"] + row["stock_differ"] + row["ended_with"]
                    for row in report["rows"].values()) else 0


if __name__ == "__main__":
    sys.exit(main())
