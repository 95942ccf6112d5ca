#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""summarize_tests.py counts cases once and finds what did not run, in made-up results of two builds."""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest
import xml.sax.saxutils

sys.dont_write_bytecode = True
import summarize_tests  # noqa: E402

SKIP = '<skipped message="SKIP_RETURN_CODE=125"/>'
NEW = ("9.7.0", ["osmesa", "egl"])
OLD = ("9.1.0", ["x"])


def listed(name):
    """A test of ctest: the fuzzer, or a program of GoogleTest that runs the cases after the colon or
    the one of the test's own name."""
    name, _, cases = name.partition(": ")
    label, _, own = name.partition(".")
    if label == "fuzz":
        return {"name": name, "command": ["bin/nbuffer-fuzz"]}
    for window in NEW[1] + OLD[1]:
        own = own.removesuffix(f".{window}")
    return {"name": name,
            "command": [f"bin/nbuffer-{label}-tests", f"--gtest_filter={cases or own}"]}


def printed(case, end="OK", *lines):
    """What GoogleTest prints of a case, one that does not end if the end is empty."""
    return "".join(f"{line}\n" for line in [
        f"[ RUN      ] {case}", *lines, *([f"[ {end} ] {case} (3 ms)"] if end else [])])


def prints(*texts):
    return f"<system-out>{''.join(texts)}</system-out>"


class SummarizeTests(unittest.TestCase):
    def run_on(self, *builds, options=()):
        """Builds are (version and windows, names listed, what ran: name -> outcome, further members
        of test-build.json). Returns the exit status and the lines printed."""
        with tempfile.TemporaryDirectory() as temporary:
            folders = []
            for index, ((vtk, windows), names, ran, *about) in enumerate(builds):
                folder = pathlib.Path(temporary, f"build{index}")
                folder.mkdir()
                folders.append(str(folder))
                (folder / "test-build.json").write_text(json.dumps(
                    {"vtk": vtk, "windows": windows, **(about[0] if about else {})}))
                tests = [listed(name) for name in names]
                (folder / "test-list.json").write_text(json.dumps({"tests": tests}))
                # Where nothing else is given, all cases of a test have passed.
                passed = {test["name"]: prints(*map(printed, test["command"][1].split("=")[1].split(":")))
                          for test in tests if len(test["command"]) > 1}
                cases = "".join(
                    f"<testcase name={xml.sax.saxutils.quoteattr(name)} status=\"run\">"
                    f"{inner or passed.get(name, '')}</testcase>" for name, inner in ran.items())
                (folder / "test-results.xml").write_text(f"<testsuite>{cases}</testsuite>")
            sys.argv = ["summarize_tests.py", *folders, *options]
            with contextlib.redirect_stdout(io.StringIO()) as output:
                status = summarize_tests.main()
        return status, output.getvalue().splitlines()

    def good(self, *builds, last, options=()):
        status, lines = self.run_on(*builds, options=options)
        self.assertEqual((status, lines[-1]), (0, last), lines)
        return lines

    def bad(self, *builds, last, words, options=()):
        status, lines = self.run_on(*builds, options=options)
        self.assertEqual((status, lines[-1]), (1, last), lines)
        self.assertIn(words, "\n".join(lines))

    def test_cases_count_once(self):
        names = ["image.A.B.osmesa", "image.A.B.egl", "unit.C.D"]
        lines = self.good(
            (NEW, names, dict.fromkeys(names, "")),
            (OLD, ["image.A.B.x", "unit.C.D"], {"image.A.B.x": "", "unit.C.D": ""}),
            last="2 passed, 0 failed, 0 skipped")
        self.assertEqual(lines[-2], "2 cases in 5 runs: VTK 9.7.0 (osmesa, egl); VTK 9.1.0 (x)")

    def test_one_failure_fails_the_case(self):
        names = ["image.A.B.osmesa", "image.A.B.egl"]
        self.bad((NEW, names, {names[0]: "", names[1]: "<failure/>"}),
                 last="0 passed, 1 failed, 0 skipped", words="failed: image.A.B (VTK 9.7.0, egl)")

    def test_skipped_with_a_reason(self):
        names = ["image.A.B.osmesa", "image.A.B.egl", "unit.C.D"]
        skip = SKIP + prints("a.cxx:3: Skipped\nno EGL\n")
        lines = self.good((NEW, names, {names[0]: "", names[1]: skip, names[2]: ""}),
                          last="2 passed, 0 failed, 0 skipped")
        self.assertIn("skipped: image.A.B (VTK 9.7.0, egl): no EGL", lines)
        skip = SKIP + prints("SKIPPED: no window\n")
        self.good((NEW, names, {names[0]: skip, names[1]: skip, names[2]: ""}),
                  last="1 passed, 0 failed, 1 skipped")

    def test_skipped_without_a_reason(self):
        self.bad((NEW, ["unit.C.D"], {"unit.C.D": SKIP}),
                 last="0 passed, 1 failed, 0 skipped", words="was skipped without a reason")

    def test_program_missing(self):
        self.bad((NEW, ["unit.C.D"], {"unit.C.D": '<skipped message="Unable to find executable"/>'}),
                 last="0 passed, 1 failed, 0 skipped", words="Unable to find executable")

    def test_listed_and_not_run(self):
        self.bad((NEW, ["unit.C.D", "unit.E.F"], {"unit.C.D": ""}),
                 last="1 passed, 1 failed, 0 skipped", words="unit.E.F (VTK 9.7.0): is listed and did not")

    def test_missing_on_a_window(self):
        names = ["image.A.B.osmesa", "image.A.B.egl", "image.A.C.osmesa"]
        build = (NEW, names, dict.fromkeys(names, ""))
        self.bad(build, last="1 passed, 1 failed, 0 skipped",
                 words="image.A.C: VTK 9.7.0, egl does not list it")
        self.good(build, options=["--partial"], last="2 passed, 0 failed, 0 skipped")
        self.good((*build, {"chosen": ["nbuffer-image-tests.egl"]}), last="2 passed, 0 failed, 0 skipped")
        self.bad((*build, {"chosen": ["nbuffer-image-tests.osmesa"]}),
                 last="1 passed, 1 failed, 0 skipped", words="image.A.C: VTK 9.7.0, egl does not list it")

    def test_missing_with_a_vtk(self):
        new = (NEW, ["unit.C.D", "unit.E.F"], {"unit.C.D": "", "unit.E.F": ""})
        old = (OLD, ["unit.C.D"], {"unit.C.D": ""})
        self.bad(new, old, last="1 passed, 1 failed, 0 skipped",
                 words="unit.E.F: VTK 9.1.0 does not list it")
        lines = self.good(new, (*old, {"skipped": {"unit.E.": "needs OSMesa"}}), last="2 passed, 0 failed, 0 skipped")
        self.assertIn("skipped: unit.E.* (VTK 9.1.0): needs OSMesa", lines)

    def test_seeds_are_not_part_of_the_case(self):
        self.good((NEW, ["fuzz.fresh.seed_12"], {"fuzz.fresh.seed_98": ""}),
                  (OLD, ["fuzz.fresh.seed_34"], {"fuzz.fresh.seed_76": ""}),
                  last="1 passed, 0 failed, 0 skipped")

    def test_end_of_what_a_failed_test_printed(self):
        text = "\n".join(["begin", *("frame" for _ in range(summarize_tests.LAST_LINES)), "bytes differ"])
        failed = f"<failure/>{prints(text)}"
        build = (NEW, ["fuzz.fresh.seed_12", "unit.C.D"], {"fuzz.fresh.seed_98": failed, "unit.C.D": ""})
        for words in "end of what fuzz.fresh.seed_98 printed (VTK 9.7.0):", "bytes differ":
            self.bad(build, last="1 passed, 1 failed, 0 skipped", words=words)
        self.assertNotIn("begin", self.run_on(build)[1])

    def test_cases_in_one_process(self):
        name = "image.A.osmesa"
        names = [f"{name}: A.B:A.C", "image.A.2.osmesa: A.D"]
        lines = self.good((NEW, names, {name: "", "image.A.2.osmesa": ""}),
                          last="3 passed, 0 failed, 0 skipped")
        self.assertEqual(lines[-2], "3 cases in 3 runs: VTK 9.7.0 (osmesa, egl)")
        one = (NEW, names[:1])
        skipped = printed("A.C", "SKIPPED", "a.cxx:3: Skipped", "no OpenGL 4")
        self.assertIn("skipped: image.A.C (VTK 9.7.0, osmesa): no OpenGL 4",
                      self.good((*one, {name: prints(printed("A.B"), skipped)}),
                                last="1 passed, 0 failed, 1 skipped"))
        for end in "FAILED", "":
            text = printed("A.B") + printed("A.C", end, "bytes differ")
            build = (*one, {name: f"<failure/>{prints(text)}"})
            self.bad(build, last="1 passed, 1 failed, 0 skipped", words="failed: image.A.C (VTK 9.7.0, osmesa)")
            self.bad(build, last="1 passed, 1 failed, 0 skipped", words="bytes differ")

    def test_process_of_several_cases(self):
        name = "image.A.osmesa"
        for inner in (f"<failure/>{prints(printed('A.B'), printed('A.C'))}",
                      '<skipped message="Unable to find executable"/>'):
            self.bad((NEW, [f"{name}: A.B:A.C"], {name: inner}),
                     last="0 passed, 2 failed, 0 skipped", words="failed: image.A.B (VTK 9.7.0, osmesa)")
        # It ends well without having run all of its cases.
        self.bad((NEW, [f"{name}: A.B:A.C"], {name: prints(printed("A.B"))}),
                 last="1 passed, 1 failed, 0 skipped", words="image.A.C (VTK 9.7.0, osmesa): did not end")

    def test_nothing_ran(self):
        self.bad((NEW, [], {}), last="0 passed, 0 failed, 0 skipped", words="no test passed")

    def test_no_results(self):
        with tempfile.TemporaryDirectory() as folder:
            sys.argv = ["summarize_tests.py", folder]
            with contextlib.redirect_stdout(io.StringIO()) as output:
                self.assertEqual(summarize_tests.main(), 1)
        self.assertIn("test-list.json", output.getvalue())

    def test_status_of_ctest(self):
        self.bad((NEW, ["unit.C.D"], {"unit.C.D": ""}), options=["--status", "8"],
                 last="1 passed, 0 failed, 0 skipped", words="ctest ended with status 8")


if __name__ == "__main__":
    unittest.main()
