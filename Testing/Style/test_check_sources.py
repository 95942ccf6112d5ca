#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""check_sources.py finds each kind of fault, and only these, in a made-up repository; so does
check_docs.py."""

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import check_docs  # noqa: E402
import check_sources  # noqa: E402

HEADER = """\
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
"""


class CheckSources(unittest.TestCase):
    def faults(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return [f"{name}: {fault}" for name, fault in check_sources.check(root)]

    def one_fault(self, files, words):
        faults = self.faults(files)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(words, faults[0])

    def test_good(self):
        self.assertEqual(self.faults({
            "LICENSE": "text",
            "build/x.cxx": "",
            "Modules/a.cxx": HEADER + '// uniform sampler2D x in a comment\nchar q = \'"\';\n',
            "Modules/a.glsl": HEADER + "void main() {}\n",
            "Modules/b.cxx": HEADER + 'auto s = "//VTK::Light::Impl";\n',
            "Testing/a.cxx": HEADER + 'auto s = "uniform float x;";\n',
            "data/README.md": HEADER,
            "data/a.json": "{}",
            "CMakeLists.txt": HEADER + "$ENV{HOME}/src/x <a>/tmp/x ${b}/tmp/x\n"}), [])

    def test_no_spdx(self):
        self.one_fault({"a.cxx": "int a;\n"}, "no SPDX lines in the first")
        self.one_fault({"a.json": "{}\n"}, "no .license file")

    def test_too_long(self):
        self.assertEqual(self.faults({"a.h": HEADER + "\n" * 598}), [])
        self.one_fault({"a.h": HEADER + "\n" * 599}, "601 lines")

    def test_glsl_in_strings(self):
        self.one_fault({"Modules/a.cxx": HEADER + 'auto s = "void main()";\n'}, "line 3: GLSL")
        self.one_fault({"Modules/a.cxx": HEADER + 'auto s = R"(\n#version 150)";\n'}, "GLSL")
        self.one_fault({"Modules/a.cxx": HEADER + 'auto s = "\\"gl_Position";\n'}, "GLSL")
        self.one_fault({"a.glsl": HEADER + "// \u00e9\n"}, "ASCII")

    def test_machine_paths(self):
        # Put together here, so that this file is free of them itself.
        for path in ("/ho" "me/me/x", '"/tm' 'p/x"', "C:\\Us" "ers\\x"):
            self.one_fault({"a.md": HEADER + path + "\n"}, "line 3: path")


class CheckDocs(unittest.TestCase):
    def faults(self, check, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return list(check(root))

    def test_links(self):
        files = {"docs/b.md": "# It's `b`, or not\n```\n# c\n```\n", "docs/c/d.png": ""}
        self.assertEqual(self.faults(check_docs.check_links, {**files, "README.md":
            "# A 1\n[x](docs/b.md#its-b-or-not) ![y](docs/c/d.png) [z](#a-1) [w](https://a.b/c) `[v](u)`\n"}),
            [])
        self.assertEqual(self.faults(check_docs.check_links, {**files, "docs/a.md":
            "[x](docs/b.md) [y](b.md#c) [z](#a)\n"}),
            ["docs/a.md: there is no docs/b.md", "docs/a.md: b.md has no heading #c",
             "docs/a.md: it has no heading #a"])

    def test_hazards(self):
        files = {"Testing/a.cxx": "TEST(Aa, Bb)\nTEST_P(Cc, Dd)\n", "docs/hazards.md":
                 "`Ee.Ff` `Aa.Bb`\n\n| hazard | tests |\n|---|---|\n| x | `Aa.Bb`, `Cc.Dd/g` |\n| y | `Aa.Cc` |\n| z | - |\n"}
        self.assertEqual(self.faults(check_docs.check_hazards, files),
                         ["docs/hazards.md: there is no test Aa.Cc", "docs/hazards.md: no test for 'z'"])
        self.assertEqual(self.faults(check_docs.check_tests_in_text, files),
                         ["docs/hazards.md: there is no test Ee.Ff"])

    def test_planted_errors(self):
        code = "MUTANTS = {'a': 1}\nSHADOW_MUTANTS = RARE = {}\nRARE_SHADOWS = {'b c': 1}\n"
        text = "# x\n- d\n## Planted errors\n\n- a\n\nRare:\n\n- {}\n\n## y\n- e\n"
        files = {"Testing/Fuzz/mutants.py": code, "docs/hazards.md": text.format("b c")}
        self.assertEqual(self.faults(check_docs.check_planted_errors, files), [])
        files["docs/hazards.md"] = text.format("b")
        self.assertEqual(self.faults(check_docs.check_planted_errors, files),
                         ["docs/hazards.md: the planted error 'b c' is not named",
                          "docs/hazards.md: 'b' is not planted by Testing/Fuzz/mutants.py"])

    def test_rules(self):
        files = {"Modules/X/a.h": "", "docs/architecture.md":
                 "`c.h`\n## Which file owns which rule\n| x | `a.h`, `b.h` |\n## y\n`d.h`\n"}
        self.assertEqual(self.faults(check_docs.check_rules, files),
                         ["docs/architecture.md: there is no file b.h"])


class CheckShownFiles(unittest.TestCase):
    def faults(self, shown, code="int main()\n{\n}\n", name="a.cxx"):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "a.cxx").write_text(HEADER + code)
            (root / "README.md").write_text(
                f"# A\n\n<!-- file: {name} -->\n```cpp\n{shown}```\n\n```cpp\nint other;\n```\n")
            return list(check_docs.check_shown_files(root))

    def test_shown_as_it_is(self):
        self.assertEqual(self.faults("int main()\n{\n}\n"), [])

    def test_shown_otherwise(self):
        self.assertEqual(
            self.faults("int main()\n{\n  return 1;\n}\n"),
            ["README.md: a.cxx is shown otherwise than it is"])

    def test_not_there(self):
        self.assertEqual(self.faults("", name="b.cxx"), ["README.md: there is no file b.cxx"])


if __name__ == "__main__":
    unittest.main()
