#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""check_structure.py finds each kind of fault, and only these, in a made-up repository."""

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import check_structure  # noqa: E402

WORDS = {"CONTRIBUTING.md": "# x\n## Words\n\n| not | but | right in |\n|---|---|---|\n"
                            "| `asked`, `asks` | reads | |\n| `taken` | used | `taken out`, `taken from` |\n"
                            "| `but for` | except for | |\n\n## More\n| `told` | x | |\n"}
MODULE = "Modules/NBuffer/"


def include(*names):
    return "".join(f'#include "{name}"\n' for name in names)


class CheckStructure(unittest.TestCase):
    def faults(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**WORDS, **files}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return sorted(f"{name}: {fault}" for name, fault in check_structure.check(root))

    def none(self, files):
        self.assertEqual(self.faults(files), [])

    def one(self, files, words):
        faults = self.faults(files)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(words, faults[0])

    def test_class_size(self):
        self.none({"Testing/A.h": "\n" * 200, "Testing/A.cxx": "\n" * 400})
        self.one({"Testing/A.h": "\n" * 200, "Testing/A.cxx": "\n" * 401}, "the class has 601 lines")
        # Files of one name in two folders are two classes.
        self.none({"Testing/X/A.h": "\n" * 200, "Testing/Y/A.cxx": "\n" * 500})

    def test_header_size(self):
        self.one({"Testing/A.h": "\n" * 201}, "201 lines, the limit of a header")
        code = "int a;\n" * 200 + "/* a\n * b */\n" + "/// c\n\n" * 200
        self.none({MODULE + "vtkNBufferA.h": code})
        self.one({MODULE + "vtkNBufferA.h": code + "int b; // b\n"}, "201 lines of code")
        self.one({MODULE + "Core/vtkNBufferA.h": "// a\n" * 201}, "201 lines, the limit")

    def test_good_directions(self):
        self.none({
            MODULE + "vtkNBufferMath.h": "",
            MODULE + "Shaders/vtkNBufferShared.h": "",
            MODULE + "Core/A.h": include("vtkNBufferMath.h", "vtkNBufferShared.h", "vtkActor.h"),
            MODULE + "Culling/Test/B.h": include("A.h"),
            MODULE + "Culling/Late/C.h": include("A.h", "B.h"),
            MODULE + "Culling/D.h": include("A.h", "B.h", "C.h"),
            MODULE + "vtkNBufferCuller.h": include("A.h", "B.h", "C.h", "D.h"),
            MODULE + "Shadows/Geometry/E.h": include("A.h"),
            MODULE + "Shadows/Litmap/F.h": include("A.h", "E.h"),
            MODULE + "Shadows/Draw/G.h": include("A.h", "E.h", "F.h"),
            MODULE + "Shadows/H.h": include("A.h", "E.h", "F.h", "G.h"),
            MODULE + "vtkShadowVolumeClampPass.h": include("A.h", "E.h", "F.h", "G.h", "H.h"),
            "Support/I.h": include("A.h"),
            "Examples/Common/J.h": include("I.h", "vtkNBufferCuller.h"),
            "Testing/Unit/K.h": include("I.h", "J.h", "D.h") + "// " + include("L.h"),
            "Testing/Unit/L.h": include("K.h")})

    def test_directions_between_rooms(self):
        for room, other, words in (
                ("Core", "Culling", "Core does not include Culling"),
                ("Core", "Shadows", "Core does not include Shadows"),
                ("Culling", "Shadows/Draw", "Culling does not include Shadows/Draw"),
                ("Shadows", "Culling/Late", "Shadows does not include Culling/Late"),
                ("Culling/Test", "Culling/Late", "Culling/Test does not include Culling/Late"),
                ("Culling/Late", "Culling", "Culling/Late does not include Culling"),
                ("Shadows/Geometry", "Shadows/Litmap", "Shadows/Geometry does not include"),
                ("Shadows/Draw", "Shadows", "Shadows/Draw does not include Shadows")):
            self.one({MODULE + other + "/B.h": "", MODULE + room + "/A.cxx": "\n" + include("B.h")},
                     "A.cxx: line 2: " + words)

    def test_directions_of_public_headers(self):
        def files(includer, *included):
            return {**{MODULE + name: "" for name in included}, MODULE + includer: include(*included)}
        self.none(files("vtkNBufferCuller.cxx", "vtkNBufferTuning.h", "vtkNBufferMath.h"))
        self.none(files("vtkShadowVolumeClampPass.cxx", "vtkShadowStatistics.h", "vtkNBufferMath.h"))
        self.one(files("vtkNBufferCuller.cxx", "vtkShadowVolumeClampPass.h"), "the shadow pass")
        self.one(files("vtkNBufferMath.h", "vtkShadowStatistics.h"), "Core does not include")
        self.one(files("vtkShadowTuning.h", "vtkNBufferTuning.h"), "does not include Culling/Test")
        self.one({**files("vtkNBufferTuning.h"), MODULE + "Core/A.h": include("vtkNBufferTuning.h")},
                 "Core does not include Culling/Test")

    def test_unknown_room(self):
        self.one({MODULE + "Other/A.h": ""}, "the folder Other is not in ROOMS")

    def test_directions_between_folders(self):
        for top, other in (("Modules/NBuffer/Core", "Support"), ("Support", "Examples"),
                           ("Support", "Testing"), ("Examples/X", "Testing")):
            self.one({f"{other}/B.h": "", f"{top}/A.h": include("B.h")},
                     f"{top.split('/')[0]} does not include {other}")
        self.one({"Examples/CMakeLists.txt": "# Testing/A\ninclude(../Testing/A.cmake)\n"},
                 "line 2: Examples does not know Testing")
        self.none({"Testing/CMakeLists.txt": "include(../Examples/A.cmake)\n"})

    def test_names_that_occur_twice(self):
        self.none({"Testing/A.h": "", "Examples/A.h": "", "Examples/B.cxx": include("A.h")})
        self.none({"Testing/X/A.h": include("B.h"), "Testing/X/B.h": "", "Testing/Y/A.h": "",
                   "Testing/Y/B.h": include("A.h")})

    def test_cycles(self):
        self.one({"Testing/A.h": include("B.h"), "Testing/B.h": include("A.h")},
                 "2 classes reach each other (A, B), for example A -> B -> A")
        self.one({"Testing/A.h": include("B.h"), "Testing/B.h": "", "Testing/B.cxx": include("C.h"),
                  "Testing/C.h": include("A.h")}, "3 classes reach each other (A, B, C)")
        self.none({"Testing/A.h": "", "Testing/A.cxx": include("A.h", "B.h"), "Testing/B.h": ""})

    def test_second_helper(self):
        box = "namespace\n{\nvtkActor* AddBox(\n  Stage& s, double (*f)(int))\n{\n}\n}\n"
        self.none({"Testing/A.cxx": box + box})
        faults = self.faults({"Testing/A.cxx": box, "Examples/B.cxx": box})
        self.assertEqual(faults, ["Examples/B.cxx: line 3: AddBox is defined in 2 files",
                                  "Testing/A.cxx: line 3: AddBox is defined in 2 files"])
        member = "void Stage::AddBox(int x) const\n{\n}\n"
        self.assertEqual(len(self.faults({"Testing/A.cxx": box, "Testing/B.cxx": member})), 2)
        # Calls and declarations are no definitions, nor is what stands in comments and strings.
        self.none({"Testing/A.cxx": box, "Testing/B.cxx":
                   "void f() { AddBox(1);\n  return AddBox(2); }\nint AddBox(int);\n"
                   "// int AddBox(int) { }\nauto s = \"int AddBox(int) {\";\n"})
        self.none({"Testing/A.cxx": box, MODULE + "Core/B.cxx": box})

    def test_words(self):
        self.none({MODULE + "Core/A.h": 'int asked; // He masked it; all but three for me.\nauto s = "asked";\n',
                   MODULE + "Core/A.cxx": "// asked\n", "Testing/A.h": "// `asked` x `taken`\n"})
        self.one({MODULE + "Core/A.h": "int a;\n/**\n * It is Asked.\n */\n"}, "A.h: line 3: 'asked'")
        self.one({MODULE + "Core/A.h": "int a; ///< All but\n       ///< for one.\n"}, "line 1: 'but for'")
        self.none({MODULE + "Core/A.h": "int a; // all but\nint b; // for one\n"})
        for folder in ("Support", "Examples/X", "Testing/Unit"):
            self.one({folder + "/A.h": "// It is asked.\n"}, "A.h: line 1: 'asked'")

    def test_words_that_are_right_in_a_phrase(self):
        self.none({"Testing/A.h": "// It is taken out of that, and taken\n// from this.\n"})
        self.one({"Testing/A.h": "// It is taken out and taken.\n"}, "line 1: 'taken'")

    def test_words_in_documents(self):
        self.none({"README.md": "# A\n`asked` ``x `asked` `` told\n\n```\nasked\n```\n<!-- asked -->\n"})
        self.one({"README.md": "# A\n\nAll `x` and `xy` is asked by `x`.\n"}, "README.md: line 3: 'asked'")
        self.one({"docs/images/README.md": "All but\nfor one.\n"}, "line 1: 'but for'")
        self.one({"Testing/X/README.md": "```\n```\n| a | asks |\n"}, "line 3: 'asks'")

    def test_words_are_missing(self):
        self.one({"CONTRIBUTING.md": "# x\n"}, "no table of words")


if __name__ == "__main__":
    unittest.main()
