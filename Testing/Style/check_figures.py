#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of which state of the module the figures of README.md and docs/ are; prints each fault, exits
1 on any.

* A table with times or percentages has a commit: in its section, in the section around that, or in
  the beginning of the document, which counts for all of it.
* Every commit that a document names is in the history.
* A commit is old if more than MAXIMUM_COMMITS commits, or commits of more than MAXIMUM_DAYS days, have
  changed Modules/ since. Figures of an old commit are refused, unless docs/figures.md has a row for it
  that names the document and says what has become of them, and the document links to docs/figures.md.
* docs/figures.md has no other rows.

Age is counted in git's history. Without one (a tarball, a shallow clone) nothing is checked: SKIPPED.
"""

import datetime
import pathlib
import re
import subprocess
import sys

MAXIMUM_COMMITS = 200
MAXIMUM_DAYS = 7

LIST = "docs/figures.md"
COMMIT = re.compile(r"(?<![\w#/.-])[0-9a-f]{7}(?![\w-])")
ROW = re.compile(r"^\| ([0-9a-f]{7}) \| ([^|]+) \| ([^|]*) \|$", re.MULTILINE)
FIGURES = re.compile(r"\bms\b|µs|%|\bfps\b")
SHORTEST_REASON = 30  # characters


def git(root, *arguments):
    """The output, or None where git fails."""
    try:
        result = subprocess.run(["git", "-C", root, *arguments], capture_output=True, text=True)
    except OSError:
        return None
    return result.stdout.strip() if result.returncode == 0 else None


def why_skipped(root):
    top = git(root, "rev-parse", "--show-toplevel")
    if top is None or pathlib.Path(top).resolve() != root:
        return "this is no checkout of git, so that no commit has an age"
    if git(root, "rev-parse", "--is-shallow-repository") != "false":
        return "this clone is shallow, so that commits are missing"
    return None


class History:
    def __init__(self, root):
        self.root = root
        self.newest = int(git(root, "log", "-1", "--format=%ct", "--", "Modules") or 0)

    def has(self, commit):
        return git(self.root, "merge-base", "--is-ancestor", commit, "HEAD") is not None

    def knows(self, word):
        return git(self.root, "cat-file", "-e", word + "^{commit}") is not None

    def age(self, commit):
        """Commits that have changed the module since, and the days between."""
        count = int(git(self.root, "rev-list", "--count", commit + "..HEAD", "--", "Modules"))
        seconds = self.newest - int(git(self.root, "log", "-1", "--format=%ct", commit))
        return count, datetime.timedelta(seconds=seconds).days


def commits_of(text, history):
    """Seven digits and nothing else may be a number, too."""
    return {word for word in COMMIT.findall(text)
            if not word.isdigit() or history.knows(word)}


def sections(text):
    """The text of each section by its headings from the first to its own, without fenced blocks."""
    path, parts = [], []
    for line in re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL).splitlines():
        heading = re.match(r"(#+) ", line)
        if heading:
            level = len(heading[1])
            path = [part for part in path if part[0] < level] + [(level, [])]
            parts.append(path)
        if path:
            path[-1][1].append(line)
    return [["\n".join(lines) for _, lines in path] for path in parts]


def check_tables(name, text, history):
    """The paragraphs above a section count for it."""
    for path in sections(text):
        tables = re.findall(r"(?:^\|.*\n?)+", path[-1], re.MULTILINE)
        if any(FIGURES.search(table) for table in tables) and \
                not any(commits_of(part, history) for part in path):
            yield f"{name}: no commit for the figures below '{path[-1].splitlines()[0]}'"


def check(root):
    history = History(root)
    listed = {}
    if (root / LIST).is_file():
        for commit, documents, reason in ROW.findall((root / LIST).read_text()):
            listed[commit] = (set(re.findall(r"\]\(([^)]+)\)", documents)), reason.strip())
    needed = {}
    for path in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        name = path.relative_to(root).as_posix()
        if not path.is_file() or name == LIST:
            continue
        text = path.read_text()
        yield from check_tables(name, text, history)
        for commit in sorted(commits_of(text, history)):
            if not history.has(commit):
                yield f"{name}: {commit} is no commit of this history"
                continue
            count, days = history.age(commit)
            if count <= MAXIMUM_COMMITS and days <= MAXIMUM_DAYS:
                continue
            link = pathlib.PurePosixPath("../" + name if name.count("/") == 0 else
                                         name[len("docs/"):]).as_posix()
            needed.setdefault(commit, set()).add(link)
            if link not in listed.get(commit, (set(), ""))[0]:
                yield (f"{name}: figures of {commit} are {count} commits and {days} days behind the "
                       f"module; record them again, or say in {LIST} why they stand")
            if "figures.md" not in text:
                yield f"{name}: has figures of {commit}, and no link to {LIST}"
    for commit, (documents, reason) in listed.items():
        for link in sorted(documents - needed.get(commit, set())):
            yield f"{LIST}: {commit} is not old, or {link} does not name it"
        if len(reason) < SHORTEST_REASON:
            yield f"{LIST}: {commit} has no reason"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    reason = why_skipped(root)
    if reason:
        print(f"SKIPPED: {reason}")
        return 0
    faults = list(check(root))
    print("\n".join(faults) if faults else "no faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
