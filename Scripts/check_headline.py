#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the headline of README.md with the walk that it is about.

    check_headline.py out/walk.json        # of: nbuffer-bench walk --frames 60 --size 960x720 --json ...

The numbers of props have to be equal; otherwise it exits 1. Times depend on the machine: it says which
are not within a factor of two.
"""

import argparse
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
COUNT, TIME = r"([\d,]+)", r"([\d.]+) ms"
HEADLINE = re.compile(
    rf"Of {COUNT} props stock VTK draws {COUNT} in {TIME} a frame, the culler {COUNT} in {TIME}; "
    rf"{COUNT} own a pixel of the image, and to draw only these takes {TIME}")
FACTOR = 2.0


def compare(text, walk):
    """What is not so, and what is so on another machine only."""
    found = HEADLINE.search(re.sub(r"\s+", " ", text))
    if not found:
        return ["README.md has no headline of the form that is compared"], []
    props, *rest = [float(word.replace(",", "")) for word in found.groups()]
    faults, notes = [], []
    if walk["props"] != props:
        faults.append(f"there are {walk['props']} props, and {props:.0f} in README.md")
    for mode, drawn, time in zip(("stock", "nbuffer", "oracle"), rest[0::2], rest[1::2]):
        values = walk["modes"][mode]
        count = int(values["drawn"])  # a median
        milliseconds = values["median_ms"]
        if count != drawn:
            faults.append(f"{mode} draws {count} props, and {drawn:.0f} in README.md")
        if not time / FACTOR <= milliseconds <= time * FACTOR:
            notes.append(f"{mode} takes {milliseconds:.1f} ms, and {time} ms in README.md")
    return faults, notes


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("walk", type=pathlib.Path, help="the file of nbuffer-bench walk --json")
    file = parser.parse_args().walk
    text = (ROOT / "README.md").read_text()
    try:
        faults, notes = compare(text, json.loads(file.read_text()))
    except (OSError, ValueError) as error:
        raise SystemExit(f"check_headline.py: cannot read {file}: {error}") from error
    except (KeyError, TypeError) as error:
        raise SystemExit(f"check_headline.py: {file} is no walk in the modes stock, nbuffer and oracle: "
                         f"{error}") from error
    for note in notes:
        print(f"another machine, or another load: {note}")
    print("\n".join(faults) if faults else "the numbers of props are those of README.md")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
