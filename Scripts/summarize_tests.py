#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summarises the test runs of one or more builds; the last line is "N passed, N failed, N skipped".

That line counts each case once, on however many windows and VTKs it ran; the line before says on
which ones. A test of ctest that runs several cases of GoogleTest (Testing/AddCases.cmake) counts as
these: its filter names them, and what it prints says what came of each. In each folder are

    test-list.json      what ctest lists (ctest --show-only=json-v1)
    test-results.xml    what ctest ran (ctest --output-junit)
    test-build.json     written by Testing/CMakeLists.txt: the VTK, the windows, which cases are not
                        for this build ("skipped": beginnings of their names with the reason), and
                        which programs run only a choice of their cases on a window ("chosen":
                        program.window)

What is expected follows from the lists. A case fails

* if it fails in one of its runs. A test whose program is missing or whose fixture failed is
  "skipped" for ctest; here it has failed;
* if it is listed and did not run, or is skipped without a reason;
* if another build lists it and this one does not, or if its program lists it on another window of
  the same build and not on this one. A case that cannot run somewhere is listed there all the same
  and prints "SKIPPED: reason", or test-build.json has the reason. With --partial (a choice of tests:
  ctest -R, -L) this is not checked.

The end of what a failed test printed is repeated, since logs of continuous integration may be cut.

The exit status is 0 only if ctest's was, no case failed and one passed.
"""

import argparse
import collections
import json
import pathlib
import re
import sys
import xml.etree.ElementTree

PASSED, FAILED, SKIPPED = "passed", "failed", "skipped"
# Drawn anew each time ctest is started, for a list too.
SEED = re.compile(r"\.seed_\d+")
FILTER = "--gtest_filter="
# What GoogleTest prints when a case begins or ends.
GOOGLE = re.compile(r"\[ +(RUN|OK|FAILED|SKIPPED) +\] ([^\s,]+)")
NO_REASON = "was skipped without a reason"
#: Lines of a failed test that are repeated.
LAST_LINES = 30


class Build:
    """What one build lists and what came of it; cases are named without window and seed."""

    def __init__(self, folder):
        self.name = folder.name
        self.errors = []
        about = self.read(folder / "test-build.json", json.loads) or {}
        self.vtk = about.get("vtk", self.name)
        self.windows = about.get("windows", [])
        #: beginning of names -> why such cases are not listed
        self.skipped = about.get("skipped", {})
        self.chosen = set(about.get("chosen", []))
        listed = self.read(folder / "test-list.json", json.loads) or {"tests": []}
        results = self.read(folder / "test-results.xml", xml.etree.ElementTree.fromstring)
        #: (case, window) -> the program of GoogleTest, or ""
        self.listed = {}
        #: name of a test -> the names of GoogleTest's cases that it runs
        cases = {}
        for test in listed["tests"]:
            command = test.get("command") or [""]
            names = [word[len(FILTER):] for word in command if word.startswith(FILTER)]
            window = self.split(test["name"])[1]
            if names:
                cases[test["name"]] = names[0].split(":")
                label = test["name"].split(".")[0]
                for name in cases[test["name"]]:
                    self.listed[f"{label}.{name}", window] = command[0]
            else:
                self.listed[self.split(test["name"])] = ""
        #: (case, window) -> (outcome, reason)
        self.ran = {}
        #: A failed test's name, with window and seed -> the end of what it printed
        self.printed = {}
        for test in results.iter("testcase") if results is not None else ():
            name = test.get("name")
            outcome, lines = classify(test), (test.findtext("system-out") or "").splitlines()
            if name not in cases:
                self.add(self.split(name), name, outcome, lines)
                continue
            label, window = name.split(".")[0], self.split(name)[1]
            for case, (result, printed) in split_cases(cases[name], outcome, lines).items():
                self.add((f"{label}.{case}", window), f"{label}.{case} in {name}", result, printed)

    def add(self, key, name, outcome, lines):
        """Takes down what came of a run of a case."""
        self.ran[key] = outcome
        if outcome[0] == FAILED:
            self.printed[name] = lines[-LAST_LINES:]

    def read(self, path, parse):
        try:
            return parse(path.read_text())
        except (OSError, ValueError, xml.etree.ElementTree.ParseError) as error:
            self.errors.append(f"{path.name} of {self.name} cannot be read: {error}")
            return None

    def split(self, name):
        """A test's case and window ("" for a test without one)."""
        case, _, window = SEED.sub("", name).rpartition(".")
        return (case, window) if window in self.windows else (SEED.sub("", name), "")


def end_of_case(word, lines):
    """The outcome and the reason of a case of GoogleTest."""
    if word != "SKIPPED":
        return PASSED if word == "OK" else FAILED, ""
    reason = skip_reason(lines)
    return (SKIPPED, reason) if reason else (FAILED, NO_REASON)


def split_cases(names, outcome, lines):
    """case -> (outcome with reason, lines printed) of a process that runs cases of GoogleTest."""
    if outcome[0] == SKIPPED and not any(GOOGLE.match(line) for line in lines):
        # There is no window.
        return {name: (outcome, lines) for name in names}
    printed, found = {name: [] for name in names}, {}
    current = None
    for line in lines:
        # A case may print no newline before its last line.
        match = GOOGLE.search(line)
        if match and match[1] == "RUN":
            current = match[2]
        elif match and match[2] == current:
            found[current] = end_of_case(match[1], printed.get(current, []))
            current = None
        elif current in printed:
            printed[current].append(line)
    ends = {name: found.get(name, (FAILED, outcome[1] or "did not end")) for name in names}
    if outcome[0] == FAILED and FAILED not in (end[0] for end in ends.values()):
        # The process has failed after its last case.
        return {name: (outcome, lines) for name in names}
    return {name: (ends[name], printed[name]) for name in names}


def skip_reason(lines):
    """From the line "SKIPPED: reason" that a test prints, or what GoogleTest makes of it."""
    for line in lines:
        found = re.search(r"skipped: (.*\S)", line, re.IGNORECASE)
        if found:
            return found[1]
    for line, following in zip(lines, lines[1:]):
        if line.endswith(": Skipped"):
            return following.strip()
    return ""


def classify(case):
    """The outcome of a test case of JUnit, and the reason of one that was skipped or failed."""
    if case.find("failure") is not None or case.find("error") is not None:
        return FAILED, ""
    skipped = case.find("skipped")
    if skipped is None:
        return (PASSED, "") if case.get("status") == "run" else (FAILED, "did not run")
    message = skipped.get("message", "")
    if not message.startswith("SKIP_"):
        return FAILED, message or "did not run"
    reason = skip_reason((case.findtext("system-out") or "").splitlines())
    return (SKIPPED, reason) if reason else (FAILED, NO_REASON)


def gaps(builds):
    """Yields (case, where it is not listed)."""
    everywhere = {case for build in builds for case, _ in build.listed}
    for build in builds:
        for case in sorted(everywhere - {case for case, _ in build.listed}):
            if not case.startswith(tuple(build.skipped)):
                yield case, f"VTK {build.vtk} does not list it"
        windows, cases = collections.defaultdict(set), collections.defaultdict(set)
        for (case, window), program in build.listed.items():
            if program:
                windows[program].add(window)
                cases[program].add(case)
        for program, names in cases.items():
            whole = {window for window in windows[program]
                     if f"{pathlib.Path(program).name}.{window}" not in build.chosen}
            for case in sorted(names):
                for window in sorted(whole):
                    if (case, window) not in build.listed:
                        yield case, f"VTK {build.vtk}, {window} does not list it"


def summarize(builds, partial=False):
    """The outcome of each case, and the lines to print about those that did not pass."""
    runs = collections.defaultdict(list)
    lines = collections.Counter()
    for build in builds:
        for key in build.listed.keys() | build.ran.keys():
            case, window = key
            outcome, reason = build.ran.get(key, (FAILED, "is listed and did not run"))
            runs[case].append(outcome)
            where = f"VTK {build.vtk}" + (f", {window}" if window else "")
            if outcome != PASSED:
                lines[f"{outcome}: {case} ({where})" + (f": {reason}" if reason else "")] += 1
        for beginning, reason in build.skipped.items():
            lines[f"{SKIPPED}: {beginning}* (VTK {build.vtk}): {reason}"] += 1
    if not partial:
        for case, reason in gaps(builds):
            runs[case].append(FAILED)
            lines[f"{FAILED}: {case}: {reason}, and gives no reason"] += 1
    outcomes = {case: next(each for each in (FAILED, PASSED, SKIPPED) if each in of_case)
                for case, of_case in runs.items()}
    return outcomes, sorted(lines, reverse=True)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", type=pathlib.Path, nargs="+", help="of builds")
    parser.add_argument("--partial", action="store_true", help="not all tests were to run")
    parser.add_argument("--status", type=int, default=0, help="exit status of ctest")
    arguments = parser.parse_args()

    builds = [Build(folder) for folder in arguments.folders]
    outcomes, lines = summarize(builds, arguments.partial)
    count = collections.Counter(outcomes.values())
    errors = [error for build in builds for error in build.errors]
    if not count[PASSED]:
        errors.append("no test passed")
    if arguments.status != 0 and not count[FAILED]:
        errors.append(f"ctest ended with status {arguments.status}")
    for build in builds:
        for name, text in sorted(build.printed.items()):
            print("\n".join(["", f"end of what {name} printed (VTK {build.vtk}):", *text]))
    print()
    print("\n".join([*lines, *(f"error: {error}" for error in errors)]))
    runs = sum(outcome != SKIPPED for build in builds for outcome, _ in build.ran.values())
    where = "; ".join(f"VTK {build.vtk}" + (f" ({', '.join(build.windows)})" if build.windows else "")
                      for build in builds)
    print(f"{len(outcomes)} cases in {runs} runs: {where}")
    print(f"{count[PASSED]} passed, {count[FAILED]} failed, {count[SKIPPED]} skipped")
    return 1 if errors or count[FAILED] else 0


if __name__ == "__main__":
    sys.exit(main())
