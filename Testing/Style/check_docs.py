#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the documents keep up with the sources; prints each fault, exits 1 on any.

* docs/limits.md names every verdict and every decision.
* Every test that docs/hazards.md names exists, and every hazard has one.
* A file that a document shows, in a fenced block behind the comment <!-- file: PATH -->, is shown as
  it is, without its lines of SPDX.
* The section "Planted errors" of docs/hazards.md names the errors of Testing/Fuzz/mutants.py.
* Every file in the table of rules of docs/architecture.md exists.
* Every link to a file of the repository, or to a heading in one, leads there.
"""

import pathlib
import re
import runpy
import sys

sys.dont_write_bytecode = True
from check_sources import files_of  # noqa: E402

LINK = re.compile(r"\]\(([^)\s#]*)(?:#([^)\s]+))?\)")
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)


def enumerators(header, name):
    body = re.search(rf"enum class {name}[^{{]*{{(.*?)\n}};", header, re.DOTALL)[1]
    names = re.findall(r"^\s*([A-Z]\w*)", body, re.MULTILINE)
    return [value for value in names if not value.startswith("NumberOf")]


def check_limits(root):
    header = (root / "Modules/NBuffer/vtkNBufferStatistics.h").read_text()
    text = (root / "docs/limits.md").read_text()
    for enumeration in ("vtkNBufferVerdict", "vtkNBufferDecision"):
        for name in enumerators(header, enumeration):
            if f"`{name}`" not in text:
                yield f"docs/limits.md: {enumeration}::{name} is not named"


def check_hazards(root):
    sources = "\n".join(path.read_text() for path in sorted((root / "Testing").rglob("*.cxx")))
    tests = {f"{suite}.{case}" for suite, case in re.findall(
        r"TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", sources)}
    in_table = False
    for line in (root / "docs/hazards.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        in_table = cells[:1] == ["hazard"] or (in_table and bool(cells))
        if not in_table or len(cells) < 2 or set(cells[0]) <= set("- ") or cells[0] == "hazard":
            continue
        names = re.findall(r"`([\w]+\.[\w]+)[^`]*`", cells[1])
        if not names:
            yield f"docs/hazards.md: no test for '{cells[0]}'"
        for name in names:
            if name not in tests:
                yield f"docs/hazards.md: there is no test {name}"


def check_tests_in_text(root):
    """The tests that docs/hazards.md names outside of its tables."""
    text = re.sub(r"^\|.*$", "", (root / "docs/hazards.md").read_text(), flags=re.MULTILINE)
    sources = "\n".join(path.read_text() for path in sorted((root / "Testing").rglob("*.cxx")))
    for suite, case in re.findall(r"`([A-Z]\w+)\.([A-Z]\w+)[^`\n]*`", text):
        if not re.search(rf"TEST(?:_F|_P)?\(\s*{suite}\s*,\s*{case}\s*\)", sources):
            yield f"docs/hazards.md: there is no test {suite}.{case}"


def section(text, heading):
    """The text below a heading of the second level."""
    found = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    return found[1] if found else ""


def check_planted_errors(root):
    lists = runpy.run_path(str(root / "Testing/Fuzz/mutants.py"))
    planted = {name for which in ("MUTANTS", "SHADOW_MUTANTS", "RARE", "RARE_SHADOWS")
               for name in lists[which]}
    text = section((root / "docs/hazards.md").read_text(), "Planted errors")
    named = set(re.findall(r"^- (.*)$", text, re.MULTILINE))
    for name in sorted(planted - named):
        yield f"docs/hazards.md: the planted error '{name}' is not named"
    for name in sorted(named - planted):
        yield f"docs/hazards.md: '{name}' is not planted by Testing/Fuzz/mutants.py"


def check_rules(root):
    files = {path.name for path in (root / "Modules").rglob("*.h")}
    text = section((root / "docs/architecture.md").read_text(), "Which file owns which rule")
    for name in re.findall(r"`(\w+\.h)`", text):
        if name not in files:
            yield f"docs/architecture.md: there is no file {name}"


def anchors(text):
    """The names that GitHub gives to the headings of a document."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    for heading in re.findall(r"^#+ +(.*)$", text, re.MULTILINE):
        yield re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def check_links(root):
    for name in files_of(root):
        if name.suffix != ".md":
            continue
        text = CODE.sub("", (root / name).read_text())
        for target, anchor in LINK.findall(text):
            if re.match(r"\w+:", target):
                continue
            file = (root / name).parent / target if target else root / name
            if not file.exists():
                yield f"{name}: there is no {target}"
            elif anchor and anchor not in anchors(file.read_text()):
                yield f"{name}: {target or 'it'} has no heading #{anchor}"


def check_shown_files(root):
    for document in [*sorted(root.glob("*.md")), *sorted((root / "docs").glob("*.md"))]:
        for name, shown in re.findall(
                r"^<!-- file: (\S+) -->\n+```\w*\n(.*?)^```", document.read_text(),
                re.DOTALL | re.MULTILINE):
            if not (root / name).is_file():
                yield f"{document.name}: there is no file {name}"
                continue
            lines = (root / name).read_text().splitlines(keepends=True)
            text = "".join(line for line in lines if "SPDX-" not in line)
            if shown.strip() != text.strip():
                yield f"{document.name}: {name} is shown otherwise than it is"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    faults = [*check_limits(root), *check_hazards(root), *check_tests_in_text(root),
              *check_planted_errors(root), *check_rules(root), *check_links(root),
              *check_shown_files(root)]
    print("\n".join(faults) if faults else "no faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
