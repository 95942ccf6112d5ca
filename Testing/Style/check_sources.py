#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what every file of the repository has to keep to; prints each fault, exits 1 on any.

* SPDX lines at the top. Files that cannot hold them (pictures, data) need a FILE.license, or a
  README.md in their folder, with the lines.
* At most 600 lines.
* GLSL in .glsl files only (ASCII, because they are encoded into C strings), none in C++ strings
  of Modules/ and Examples/.
* No absolute paths of somebody's machine.
"""

import pathlib
import re
import subprocess
import sys

LIMIT = 600
HEADER_LINES = 12
# Beside every file with a zero byte.
DATA = {".svg", ".osm", ".obj", ".stl", ".ply", ".wrl", ".gltf", ".json", ".csv"}
NO_HEADER = {"LICENSE"}

COPYRIGHT = re.compile(r"SPDX-FileCopyrightText\"?: \"?\S")
LICENCE = re.compile(r"SPDX-License-Identifier\"?: \"?[A-Z][\w.-]+")
# A string literal of C++ (raw ones as well) or a comment; comments come first to be passed over.
TOKEN = re.compile(
    r"//[^\n]*|/\*.*?\*/|R\"(?P<mark>[^\s()\\]{0,16})\((?P<raw>.*?)\)(?P=mark)\""
    r"|'(?:\\.|[^'\\\n])+'|\"(?P<plain>(?:\\.|[^\"\\\n])*)\"",
    re.DOTALL)
GLSL = re.compile(
    r"#version\b|\bgl_[A-Z]\w+|\bvoid\s+main\s*\(|\buniform\s+\w+\s+\w+|\btexelFetch\b"
    r"|\b[iu]?sampler[123]D")
MACHINE_PATH = re.compile(
    r"(?<![\w.$}>-])/(?:home|root|work|tmp|mnt|scratch|Users|private/var)/[\w.+-]"
    r"|\b[A-Z]:\\\\?(?:Users|Documents)")


def files_of(root):
    """Tracked files and new ones that are not ignored; without git all but builds and output."""
    try:
        listed = subprocess.run(
            ["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            check=True, capture_output=True).stdout.decode().split("\0")
        names = [pathlib.Path(name) for name in listed if name]
    except (OSError, subprocess.CalledProcessError):
        names = [path.relative_to(root) for path in root.rglob("*")]
        names = [name for name in names if not re.match(r"build|out$|\.git$", name.parts[0])]
    return sorted(name for name in names
                  if (root / name).is_file() and "__pycache__" not in name.parts)


def has_spdx(path):
    if not path.is_file():
        return False
    head = "\n".join(path.read_text(errors="replace").splitlines()[:HEADER_LINES])
    return bool(COPYRIGHT.search(head) and LICENCE.search(head))


def is_data(name, content):
    return name.suffix in DATA or b"\0" in content


def check_licence(root, name, data):
    path = root / name
    if name.name in NO_HEADER or has_spdx(path):
        return
    if data:
        if has_spdx(path.with_name(path.name + ".license")) or has_spdx(path.parent / "README.md"):
            return
        yield "no SPDX lines, no .license file beside it, none in its folder's README.md"
    else:
        yield f"no SPDX lines in the first {HEADER_LINES} lines"


def check_length(text):
    lines = text.count("\n")
    if lines > LIMIT:
        yield f"{lines} lines, the limit is {LIMIT}"


def check_glsl(name, text):
    if name.suffix == ".glsl":
        if not text.isascii():
            yield "GLSL has to be ASCII"
        return
    if name.suffix not in {".cxx", ".h", ".hxx", ".cpp", ".hpp"} or name.parts[0] == "Testing":
        return
    for token in TOKEN.finditer(text):
        literal = token["raw"] or token["plain"]
        found = GLSL.search(literal) if literal else None
        if found:
            line = text.count("\n", 0, token.start()) + 1
            yield f"line {line}: GLSL in a C++ string ({found[0]})"


def check_paths(text):
    for number, line in enumerate(text.splitlines(), 1):
        found = MACHINE_PATH.search(line)
        if found:
            yield f"line {number}: path of somebody's machine ({found[0]}...)"


def check(root):
    """Yields (file, fault)."""
    for name in files_of(root):
        content = (root / name).read_bytes()
        data = is_data(name, content)
        faults = list(check_licence(root, name, data))
        if b"\0" not in content:
            text = content.decode(errors="replace")
            if not data:
                faults += check_length(text)
            faults += check_glsl(name, text)
            faults += check_paths(text)
        for fault in faults:
            yield name, fault


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    faults = list(check(root))
    for name, fault in faults:
        print(f"{name}: {fault}")
    print(f"{len(files_of(root))} files, {len(faults)} faults")
    return 1 if faults or not files_of(root) else 0


if __name__ == "__main__":
    sys.exit(main())
