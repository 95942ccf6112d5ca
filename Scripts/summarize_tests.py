#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summarises ctest's JUnit files; the last line is "N passed, N failed, N skipped".

The exit status is 0 only if ctest's was, nothing failed and enough tests ran. A test whose
program is missing or whose fixture failed is "skipped" for ctest; here it has failed.
"""

import argparse
import pathlib
import sys
import xml.etree.ElementTree


def skip_reason(case):
    """From the line "SKIPPED: reason" that a test prints, or what GoogleTest makes of it."""
    lines = (case.findtext("system-out") or "").splitlines()
    for line in lines:
        if "SKIPPED: " in line:
            return line.partition("SKIPPED: ")[2].strip()
    for line, following in zip(lines, lines[1:]):
        if line.endswith(": Skipped"):
            return following.strip()
    return "no reason given"


def classify(case):
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    skipped = case.find("skipped")
    if skipped is None:
        return "passed" if case.get("status") == "run" else "failed"
    message = skipped.get("message", "")
    return "skipped" if message.startswith("SKIP_") or case.get("status") == "disabled" else "failed"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=pathlib.Path, nargs="+")
    parser.add_argument("--minimum", type=int, default=0, help="tests that must have run")
    parser.add_argument("--status", type=int, default=0, help="exit status of ctest")
    arguments = parser.parse_args()

    groups = {"passed": [], "failed": [], "skipped": []}
    for results in arguments.results:
        if not results.exists():
            print(f"error: {results.name} of {results.parent.name} was not written")
            arguments.status = arguments.status or 1
            continue
        for case in xml.etree.ElementTree.parse(results).iter("testcase"):
            groups[classify(case)].append(case)

    print()
    for case in groups["skipped"]:
        print(f"skipped: {case.get('name')}: {skip_reason(case)}")
    for case in groups["failed"]:
        print(f"failed: {case.get('name')}")
    ran = len(groups["passed"]) + len(groups["failed"])
    enough = ran >= max(arguments.minimum, 1)
    if not enough:
        print(f"error: {ran} tests ran, at least {max(arguments.minimum, 1)} are expected")
    if arguments.status != 0 and not groups["failed"]:
        print(f"error: ctest ended with status {arguments.status}")
    print(", ".join(f"{len(cases)} {name}" for name, cases in groups.items()))
    return 0 if enough and arguments.status == 0 and not groups["failed"] else 1


if __name__ == "__main__":
    sys.exit(main())
