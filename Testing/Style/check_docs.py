#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the documents keep up with the sources; prints each fault, exits 1 on any.

* docs/limits.md names every verdict and every decision.
* Every test that docs/hazards.md names exists, every hazard has one, and every test of a hazard is
  named there. The named scenarios of culling are tests (ImageTestScenarios.cxx).
* A file that a document shows, in a fenced block behind the comment <!-- file: PATH -->, is shown as
  it is, without its lines of SPDX.
"""

import pathlib
import re
import sys


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
    for name in re.findall(r'HazardBuilder scene\(\s*"([\w./]+)"', sources):
        tests.add(re.search(r"\w+\.\w+", name)[0] if "." in name else f"CullerHazards.{name}")
    named = set()
    in_table = False
    for line in (root / "docs/hazards.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")[1:-1]]
        in_table = cells[:1] == ["hazard"] or (in_table and bool(cells))
        if not in_table or len(cells) < 2 or set(cells[0]) <= set("- ") or cells[0] == "hazard":
            continue
        names = re.findall(r"`([\w]+\.[\w]+)[^`]*`", cells[1])
        if not names:
            yield f"docs/hazards.md: no test for '{cells[0]}'"
        named.update(names)
        for name in names:
            if name not in tests:
                yield f"docs/hazards.md: there is no test {name}"
    for name in sorted(tests - named):
        if name.startswith("CullerHazard"):
            yield f"docs/hazards.md: {name} is not named"


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
    faults = [*check_limits(root), *check_hazards(root), *check_shown_files(root)]
    print("\n".join(faults) if faults else "no faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
