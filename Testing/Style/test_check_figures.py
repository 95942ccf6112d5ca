#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""check_figures.py finds each kind of fault, and only these, in made-up repositories; and
Scripts/check_headline.py compares counts."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "Scripts"))
import check_figures  # noqa: E402
import check_headline  # noqa: E402

TABLE = "| mode | ms |\n|---|---|\n| stock | 12 |\n"
REASON = "Held by a test that counts the same in every build."


def run(root, *arguments, **variables):
    return subprocess.run(
        ["git", "-C", root, "-c", "user.name=a", "-c", "user.email=a@b", *arguments], check=True,
        capture_output=True, text=True, env={"HOME": str(root), "PATH": "/usr/bin:/bin:/usr/local/bin",
                                             **variables}).stdout.strip()


class CheckFigures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve() / "repository"
        (self.root / "Modules").mkdir(parents=True)
        (self.root / "docs").mkdir()
        run(self.root, "init", "-q")
        self.first = self.change(1)

    def change(self, day):
        """Changes the module on a day of a month; the commit."""
        file = self.root / "Modules/a.cxx"
        file.write_text((file.read_text() if file.exists() else "") + "int a;\n")
        run(self.root, "add", "-A")
        date = f"2024-01-{day:02}T12:00:00+0000"
        run(self.root, "commit", "-q", "-m", "a", GIT_AUTHOR_DATE=date, GIT_COMMITTER_DATE=date)
        return run(self.root, "rev-parse", "--short=7", "HEAD")

    def faults(self, **documents):
        for name, text in documents.items():
            path = "README.md" if name == "README" else f"docs/{name}.md"
            (self.root / path).write_text(text)
        self.assertIsNone(check_figures.why_skipped(self.root))
        return list(check_figures.check(self.root))

    def one_fault(self, words, **documents):
        faults = self.faults(**documents)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(words, faults[0])

    def test_fresh(self):
        text = f"# A\n\nAll are of {self.first}.\n\n## B\n\n{TABLE}"
        self.change(8)
        self.assertEqual(self.faults(README=text, a=text), [])

    def test_older_than_a_week(self):
        self.change(9)
        text = f"# A\n\n{TABLE}\nOf {self.first}, see docs/figures.md.\n"
        self.one_fault("1 commits and 8 days behind the module", README=text)
        row = f"| {self.first} | [README](../README.md) | {{}} |\n"
        self.assertEqual(self.faults(figures=row.format(REASON)), [])
        self.one_fault("no reason", figures=row.format("Stands."))
        self.one_fault("no link to docs/figures.md", figures=row.format(REASON),
                       README=text.replace("figures.md", ""))

    def test_too_many_commits(self):
        most = check_figures.MAXIMUM_COMMITS
        self.addCleanup(setattr, check_figures, "MAXIMUM_COMMITS", most)
        check_figures.MAXIMUM_COMMITS = 2
        text = f"# A\n\n{TABLE}\nOf {self.first}, see figures.md.\n"
        for _ in range(2):
            self.change(1)
        self.assertEqual(self.faults(a=text), [])
        self.change(1)
        self.one_fault("docs/a.md: figures of", a=text)
        row = f"| {self.first} | [a](a.md) | {REASON} |\n"
        self.assertEqual(self.faults(figures=row), [])
        check_figures.MAXIMUM_COMMITS = 3
        self.one_fault("is not old, or a.md does not name it", figures=row)

    def test_no_commit(self):
        self.one_fault("no commit for the figures below '## C'",
                       a=f"# A\n\n## B\n\nOf {self.first}.\n\n## C\n\n{TABLE}")
        self.assertEqual(self.faults(a="# A\n\n| name |\n|---|\n| x |\n"), [])

    def test_unknown_commit(self):
        self.one_fault("is no commit of this history", a="# A\n\nOf abcdef1, with 1234567 cubes.\n")

    def test_skipped(self):
        self.change(1)
        clone = self.root.parent / "clone"
        run(self.root, "clone", "-q", "--depth", "1", f"file://{self.root}", str(clone))
        self.assertIn("shallow", check_figures.why_skipped(clone))
        self.assertIn("no checkout", check_figures.why_skipped(self.root / "docs"))


class CheckHeadline(unittest.TestCase):
    HEADLINE = ("Of 15,860 props stock VTK draws 3,327 in 218 ms a frame,\nthe culler 16 in 16.4 ms; 14\n"
                "own a pixel of the image, and to draw only these takes 10.5 ms (commit")

    def faults(self, drawn=16, time=16.4, text=HEADLINE):
        modes = {name: {"drawn": count, "median_ms": milliseconds}
                 for name, count, milliseconds in (
                     ("stock", 3327, 218.0), ("nbuffer", drawn, time), ("oracle", 14, 10.5))}
        walk = json.loads(json.dumps({"props": 15860, "modes": modes}))
        return check_headline.compare(text, walk)

    def test_alike(self):
        self.assertEqual(self.faults(), ([], []))

    def test_counts_are_equal(self):
        faults, notes = self.faults(drawn=17)
        self.assertEqual((len(faults), notes), (1, []))
        self.assertIn("nbuffer draws 17 props", faults[0])

    def test_times_are_in_a_range(self):
        faults, notes = self.faults(time=40.0)
        self.assertEqual((faults, len(notes)), ([], 1))
        self.assertIn("40.0 ms", notes[0])

    def test_no_headline(self):
        self.assertEqual(len(self.faults(text="Nothing.")[0]), 1)

    def run_script(self, *arguments):
        done = subprocess.run([sys.executable, check_headline.__file__, *arguments],
                              capture_output=True, text=True)
        self.assertNotIn("Traceback", done.stderr)
        return done.returncode

    def test_no_walk(self):
        self.assertEqual((self.run_script("--help"), self.run_script()), (0, 2))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "walk.json")
            for text in ("{", "[]", '{"modes": {}}', '{"props": 1, "modes": {"stock": 1}}'):
                file.write_text(text)
                self.assertEqual(self.run_script(str(file)), 1)
            self.assertEqual(self.run_script(folder + "/none.json"), 1)


if __name__ == "__main__":
    unittest.main()
