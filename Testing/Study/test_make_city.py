#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests Scripts/make-city.py on an extract of three buildings and a street."""

import gzip
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "Scripts/make-city.py"
HOUSE = '<way id="{0}"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="{1}"/><tag k="building" v="yes"/>{2}</way>'
EXTRACT = """<osm><node id="1" lat="53.0000000" lon="13.0000000"/>
<node id="2" lat="53.0000000" lon="13.0002000"/><node id="3" lat="53.0001000" lon="13.0002000"/>
""" + HOUSE.format(7, 1, '<tag k="height" v="40 ft"/>') + HOUSE.format(
    8, 1, '<tag k="building:levels" v="3"/>') + HOUSE.format(9, 2, "") + """
<way id="10"><nd ref="1"/><nd ref="3"/><tag k="highway" v="path"/></way>
<way id="11"><nd ref="1"/><nd ref="3"/><tag k="highway" v="path"/><tag k="tunnel" v="yes"/></way>
<way id="12"><nd ref="1"/><nd ref="99"/><tag k="highway" v="path"/></way></osm>"""


class MakeCity(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.extract = pathlib.Path(self.folder.name, "town.osm")
        self.city = pathlib.Path(self.folder.name, "town.city")

    def run_script(self, text):
        self.extract.write_text(text)
        return subprocess.run([sys.executable, SCRIPT, self.extract, self.city],
                              capture_output=True, text=True)

    def test_buildings_and_streets(self):
        run = self.run_script(EXTRACT)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.splitlines(), [
            "2 buildings; left out: 0 too small, 1 not closed, 0 cut off by the extract",
            "heights: 1 tagged, 1 from storeys, 0 synthetic",
            "1 streets of 1 kinds; centre: 53.00005, 13.0001"])
        data = gzip.decompress(self.city.read_bytes())
        self.assertTrue(data.startswith(b"NBufferCity\n\x01"))
        # The source and the height in centimetres: 40 ft by the tag, 3 storeys of 3 m and 1 m.
        self.assertIn(bytes([1, 0x80 | 1219 & 0x7f, 1219 >> 7, 1, 3]), data)
        self.assertIn(bytes([2, 0x80 | 1000 & 0x7f, 1000 >> 7, 1, 3]), data)

    def test_an_extract_without_buildings_is_an_error(self):
        run = self.run_script("<osm/>")
        self.assertEqual(run.returncode, 1)
        self.assertIn('no closed way with the tag "building"', run.stderr)
        self.assertFalse(self.city.exists())

    def test_an_extract_that_cannot_be_read_is_an_error(self):
        for text, reason in (("OSMHeader", "syntax error"), ("<osm>", "no element found"),
                             ('<osm><node id="1" lat="x" lon="0"/></osm>', "could not convert")):
            run = self.run_script(text)
            self.assertEqual(run.returncode, 1)
            self.assertRegex(run.stderr, rf"^make-city.py: cannot read .*town.osm .*{reason}.*\n$")
        self.extract = self.extract.with_suffix(".osm.gz")
        self.assertRegex(self.run_script("plain").stderr, r"^make-city.py: .*: Not a gzipped file.*\n$")
        self.extract.unlink()
        run = subprocess.run([sys.executable, SCRIPT, self.extract, self.city],
                             capture_output=True, text=True)
        self.assertRegex(run.stderr, r"^make-city.py: .*No such file.*\n$")


if __name__ == "__main__":
    unittest.main()
