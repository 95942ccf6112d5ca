#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the shape of the code; prints each fault, exits 1 on any.

* A class, its header and source together, has at most 600 lines; a header at most 200. In a public
  header of the module comments and blank lines do not count: it is a manual.
* Includes go one way between the folders of the module (ROOMS), and between the folders on top:
  Modules <- Support <- Examples <- Testing. CMake's files keep to the latter too.
* No two classes include each other, not by way of others either.
* What tests and examples share is defined once: no second function of a name in HELPERS.
* Comments of headers and the text of documents keep away from the words that CONTRIBUTING.md lists
  under "Words". What is code (between backticks) does not count.
"""

import bisect
import collections
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from check_sources import TOKEN, files_of  # noqa: E402

CLASS_LIMIT = 600
HEADER_LIMIT = 200

MODULE = pathlib.PurePath("Modules/NBuffer")
CODE = {".h", ".cxx"}

# The rooms of the module, each with the rooms that it may include; a room is a folder or a name of
# PUBLIC. Every room may include Shaders, whose one header holds what C++ and GLSL share.
ROOMS = {
    "Shaders": (),
    "Core": (),
    "Culling/Test": ("Core",),
    "Culling/Late": ("Core", "Culling/Test"),
    "Culling/Divide": ("Core", "Culling/Test", "Culling/Late"),
    "Culling": ("Core", "Culling/Test", "Culling/Late", "Culling/Divide"),
    "the culler": ("Core", "Culling/Test", "Culling/Late", "Culling/Divide", "Culling"),
    "Shadows/Geometry": ("Core",),
    "Shadows/Litmap": ("Core", "Shadows/Geometry"),
    "Shadows/Draw": ("Core", "Shadows/Geometry", "Shadows/Litmap"),
    "Shadows": ("Core", "Shadows/Geometry", "Shadows/Litmap", "Shadows/Draw"),
    "the shadow pass": (
        "Core", "Shadows/Geometry", "Shadows/Litmap", "Shadows/Draw", "Shadows"),
}
# The rooms of the files that lie on top, by their names; the first that fits.
PUBLIC = (
    (r"vtkNBufferCuller(?!Traits)|vtkNBufferDepthExchange", "the culler"),
    (r"vtkNBufferTuning", "Culling/Test"),
    (r"vtkShadowVolumeClampPass", "the shadow pass"),
    (r"vtkShadow", "Shadows/Geometry"),
    (r"vtkNBuffer", "Core"),
)

# The folders on top, each with those that it may include.
FOLDERS = {
    "Modules": (),
    "Support": ("Modules",),
    "Examples": ("Modules", "Support"),
    "Testing": ("Modules", "Support", "Examples"),
}

# Functions of which there were several, once.
HELPERS = ("AddBox", "MakeBox", "AddBall", "MakeBall", "AddSphere", "MakeSphere", "AddTriangle",
           "MakeTriangle", "AddQuad", "MakeQuad", "MakeProjection", "MakeMatrix", "AddLight",
           "ReadPixels", "CountDifferentBytes")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
# A row of the table of words: the words, what to write instead, phrases in which they are right.
WORD_ROW = re.compile(r"^\|\s*((?:`[^`|]+`(?:,\s*)?)+)\s*\|[^|\n]*\|([^|\n]*)", re.MULTILINE)
# What is not text in Markdown: blocks of code, code in a line, and comments of HTML.
MARKDOWN_CODE = re.compile(r"^```.*?^```|<!--.*?-->|(`+)[^`].*?\1", re.MULTILINE | re.DOTALL)


def without_comments(text, strings=False):
    """The text with comments blanked, line by line as before; string literals too, if wanted."""
    def blank(token):
        is_comment = token[0].startswith(("//", "/*"))
        return re.sub(r"[^\n]", " ", token[0]) if is_comment or strings else token[0]
    return TOKEN.sub(blank, text)


def comments(text):
    """Yields (line, text) of each comment; lines that follow each other make one."""
    block = []
    previous = -1
    for token in TOKEN.finditer(text):
        if not token[0].startswith(("//", "/*")):
            continue
        if block and text[previous:token.start()].strip(" \t") != "\n":
            yield block
            block = []
        line = text.count("\n", 0, token.start()) + 1
        for offset, words in enumerate(token[0].split("\n")):
            block.append((line + offset, words.strip(" \t/*!<")))
        previous = token.end()
    if block:
        yield block


class Tree:
    """The sources of a repository, and who includes whom; its documents."""

    def __init__(self, root):
        self.texts = {}
        self.cmake = {}
        self.documents = {}
        for name in files_of(root):
            name = pathlib.PurePath(name)
            if name.suffix == ".md":
                self.documents[name] = (root / name).read_text(errors="replace")
            if name.parts[0] not in FOLDERS:
                continue
            if name.suffix in CODE:
                self.texts[name] = (root / name).read_text(errors="replace")
            elif name.suffix == ".cmake" or name.name == "CMakeLists.txt":
                self.cmake[name] = (root / name).read_text(errors="replace")
        self.by_name = collections.defaultdict(list)
        for name in self.texts:
            self.by_name[name.name].append(name)

    def find(self, includer, included):
        """The file of an #include, or None for foreign and generated ones. Several of one name: the
        one beside the includer, or else the one that is nearest to the module."""
        candidates = self.by_name.get(included.rpartition("/")[2], [])
        beside = includer.parent / included
        order = list(FOLDERS)
        return min(candidates, default=None,
                   key=lambda name: (name != beside, name.parts[0] != includer.parts[0],
                                     order.index(name.parts[0]), name))

    def includes(self, name):
        """Yields (line, file)."""
        text = without_comments(self.texts[name])
        for found in INCLUDE.finditer(text):
            file = self.find(name, found[1])
            if file:
                yield text.count("\n", 0, found.start(1)) + 1, file


def count_lines(text):
    return text.count("\n") + (not text.endswith("\n") and text != "")


def check_sizes(tree):
    classes = collections.defaultdict(list)
    for name, text in tree.texts.items():
        classes[name.with_suffix("")].append(name)
        if name.suffix != ".h":
            continue
        lines = count_lines(text)
        what = "lines"
        if name.parent == MODULE:
            lines = sum(bool(line.strip()) for line in without_comments(text).splitlines())
            what = "lines of code"
        if lines > HEADER_LIMIT:
            yield name, f"{lines} {what}, the limit of a header is {HEADER_LIMIT}"
    for names in classes.values():
        lines = [count_lines(tree.texts[name]) for name in names]
        if len(names) > 1 and sum(lines) > CLASS_LIMIT:
            parts = " and ".join(f"{count} in {name.name}" for count, name in zip(lines, names))
            yield names[0], f"the class has {sum(lines)} lines ({parts}), the limit is {CLASS_LIMIT}"


def room_of(name):
    """A file's room in the module, or None for what is not in it."""
    if not name.is_relative_to(MODULE):
        return None
    folder = name.parent.relative_to(MODULE).as_posix()
    if folder == ".":
        return next(room for pattern, room in (*PUBLIC, ("", None)) if re.match(pattern, name.name))
    return folder


def check_directions(tree):
    for name in tree.texts:
        room = room_of(name)
        if name.is_relative_to(MODULE) and room not in ROOMS:
            yield name, f"the folder {room} is not in ROOMS of Testing/Style/check_structure.py"
            continue
        top = name.parts[0]
        for line, file in tree.includes(name):
            other = room_of(file)
            if file.parts[0] != top and file.parts[0] not in FOLDERS[top]:
                yield name, f"line {line}: {top} does not include {file.parts[0]} ({file.name})"
            elif room and other not in (None, room, "Shaders", *ROOMS[room]):
                yield name, f"line {line}: {room} does not include {other} ({file.name})"
    for name, text in tree.cmake.items():
        top = name.parts[0]
        text = re.sub(r"#[^\n]*", "", text)
        for found in re.finditer(rf"\b({'|'.join(FOLDERS)})/", text):
            if found[1] != top and found[1] not in FOLDERS[top]:
                line = text.count("\n", 0, found.start()) + 1
                yield name, f"line {line}: {top} does not know {found[1]}"


def find_way(edges, start, goal):
    """The shortest way from one class to another, as a list of classes after `start`, or None."""
    ways = collections.deque([(start,)])
    seen = set()
    while ways:
        way = ways.popleft()
        for following in sorted(edges[way[-1]] - seen):
            if following == goal:
                return [*way[1:], goal]
            seen.add(following)
            ways.append((*way, following))
    return None


def check_cycles(tree):
    """One fault for each set of classes that all reach each other, at the first one by name."""
    edges = collections.defaultdict(set)
    for name in tree.texts:
        for _, file in tree.includes(name):
            if file.with_suffix("") != name.with_suffix(""):
                edges[name.with_suffix("")].add(file.with_suffix(""))
    reached = {}
    for start in list(edges):
        reached[start], ways = set(), [start]
        while ways:
            for following in edges[ways.pop()] - reached[start]:
                reached[start].add(following)
                ways.append(following)
    left = {start for start in reached if start in reached[start]}
    while left:
        first = min(left)
        group = {other for other in reached[first] if first in reached.get(other, ())}
        left -= group
        way = min((find_way(edges, member, member) for member in sorted(group)), key=len)
        example = " -> ".join(each.name for each in (way[-1], *way))
        others = ", ".join(sorted(each.name for each in group))
        yield first, f"{len(group)} classes reach each other ({others}), for example {example}"


def closing(text, opening):
    """The position behind the bracket that closes the one at `opening`."""
    depth = 0
    for position in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[position], 0)
        if depth == 0:
            return position + 1
    return len(text)


def definitions(text):
    """Yields (line, name) of the functions of HELPERS that are defined in the text."""
    text = without_comments(text, strings=True)
    for found in re.finditer(rf"[\w>&*]\s+[&*]*(?:\w+::)*({'|'.join(HELPERS)})\s*(\()", text):
        before = re.search(r"(\w+)\s*[&*]*(?:\w+::)*$", text[:found.start(1)])
        if before and before[1] in ("return", "new", "else", "case"):
            continue
        rest = text[closing(text, found.start(2)):]
        if re.match(r"\s*(?:const\b\s*|noexcept\b\s*|override\b\s*|->\s*[\w:<>&*\s]+?)*\{", rest):
            yield text.count("\n", 0, found.start(1)) + 1, found[1]


def check_helpers(tree):
    places = collections.defaultdict(list)
    for name, text in tree.texts.items():
        if name.parts[0] != "Modules":
            for line, helper in definitions(text):
                if not any(name == other for other, _ in places[helper]):
                    places[helper].append((name, line))
    for helper, found in places.items():
        for name, line in found if len(found) > 1 else ():
            yield name, f"line {line}: {helper} is defined in {len(found)} files"


def avoided_words(contributing):
    """The words in the first column of the table under "## Words", and the phrases in its third
    column in which they are right."""
    section = re.search(r"^## Words\n(.*?)(?=^## |\Z)", contributing, re.MULTILINE | re.DOTALL)
    rows = WORD_ROW.findall(section[1]) if section else []
    return tuple([word for row in rows for word in re.findall(r"`([^`]+)`", row[column])]
                 for column in (0, 1))


def any_of(words):
    """A pattern of words and phrases; these may be broken into lines."""
    return "|".join(re.escape(word).replace(r"\ ", r"\s+") for word in words)


def paragraphs(text):
    """Yields (line, text) of each line of a document without its code, as one block."""
    text = MARKDOWN_CODE.sub(lambda code: re.sub(r"[^\n]", "#", code[0]), text)
    yield list(enumerate(text.splitlines(), 1))


def check_words(tree, words, allowed=()):
    pattern = re.compile(rf"\b({any_of(words)})\b", re.IGNORECASE)
    right = re.compile(rf"`[^`]*`|\b(?:{any_of(allowed)})\b" if allowed else "`[^`]*`", re.IGNORECASE)
    blocks = [(name, block) for name, text in tree.texts.items() if name.suffix == ".h"
              for block in comments(text)]
    blocks += [(name, block) for name, text in tree.documents.items() for block in paragraphs(text)]
    for name, block in blocks:
        starts, joined = [], ""
        for _, line in block:
            starts.append(len(joined))
            joined += line + " "
        joined = right.sub(lambda phrase: "#" * len(phrase[0]), joined)
        for found in pattern.finditer(joined):
            line = block[bisect.bisect_right(starts, found.start()) - 1][0]
            yield name, f"line {line}: '{found[1].lower()}' (CONTRIBUTING.md, Words)"


def check(root):
    """Yields (file, fault)."""
    tree = Tree(root)
    yield from check_sizes(tree)
    yield from check_directions(tree)
    yield from check_cycles(tree)
    yield from check_helpers(tree)
    contributing = root / "CONTRIBUTING.md"
    words, allowed = avoided_words(contributing.read_text()) if contributing.is_file() else ([], [])
    if words:
        yield from check_words(tree, words, allowed)
    else:
        yield "CONTRIBUTING.md", "no table of words under ## Words"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    faults = sorted((str(name), fault) for name, fault in check(root))
    for name, fault in faults:
        print(f"{name}: {fault}")
    print(f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
