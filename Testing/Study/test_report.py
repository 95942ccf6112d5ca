#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests Scripts/report.py on small-study.json and small-benchmarks.json, few entries of a real study.

Ends with 77, skipped, where pandas or matplotlib is missing.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "Scripts"))

try:
    import pandas as pd
    import matplotlib  # noqa: F401 (only whether it is there)
except ImportError as error:
    print(f"Skipped: {error}; Scripts/requirements-report.txt has what is needed")
    sys.exit(77)

import report  # noqa: E402
import report_benchmarks as benchmarks  # noqa: E402
import report_depth as depth  # noqa: E402
import report_device as device  # noqa: E402
import report_shadows as shadows  # noqa: E402
import report_tables as tables  # noqa: E402
import study_benchmarks  # noqa: E402

STUDY = HERE / "small-study.json"
BENCHMARKS = HERE / "small-benchmarks.json"


def rows(text):
    """The cells of the rows of a table, without its head."""
    lines = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


class Figures(unittest.TestCase):
    def setUp(self):
        self.study = json.loads(STUDY.read_text())

    def test_numbers_have_three_digits(self):
        for value, text in ((0, "0"), (0.125, "0.12"), (3, "3"), (12.34, "12.3"), (123.4, "123"),
                            (1234567, "1,234,567"), (-1234.5, "-1,234"), (None, ""),
                            (float("nan"), "")):
            self.assertEqual(tables.number(value), text)

    def test_ratio_is_the_median_over_frames(self):
        walk = {"modes": {"a": {"frames_ms": [2, 9, 8]}, "b": {"frames_ms": [1, 3, 2]}}}
        self.assertEqual(tables.ratio(walk, "a", "b"), 3)

    def test_pareto_line(self):
        points = pd.DataFrame({"time": [3, 1, 2, 4], "error": [5, 9, 9, 1]})
        self.assertEqual(
            list(tables.mark_pareto(points, "time", "error")["pareto"]), [True, True, False, True])

    def test_structures(self):
        for scene in self.study["scenes"]:
            points = tables.structures(scene)
            self.assertEqual(points["is_default"].sum(), 1)
            self.assertTrue(points["kept"].between(0, 100).all())
            self.assertGreaterEqual(points["pareto"].sum(), 1)
            fastest = points["total_ms.median"].idxmin()
            self.assertTrue(points.loc[fastest, "pareto"])
            self.assertTrue((points["loss"] >= points["total_ms.median"] - 1e-9).all())
        self.assertEqual(
            [tables.group_of(name) for name in (
                "culler 1/4 + pixels", "outline per pixel", "squares x4 1/4",
                "squares s=2 x4 1/4", "squares x1 1/4", "fat mips 2x2 1/4",
                "one level 1/8", "rectangles band 1 x4 1/4", "squares x4 1/4 with positions")],
            ["culler", "outline", "four squares", "strided", "one square",
             "mips", "one level", "rectangles", "positions"])

    def test_cost_of_a_prop(self):
        def mode(drawn, time):
            return {"drawn": drawn, "median_ms": time}
        # Props outside the view and the default culler's own time are not in the figure.
        walk = {"modes": {"none": mode(10110, 100), "stock": mode(110, 50), "in-view": mode(110, 3),
                          "oracle": mode(10, 1)}}
        self.assertAlmostEqual(tables.cost_of_a_prop(walk), 20)
        walk["modes"]["in-view"] = walk["modes"]["oracle"]
        self.assertEqual(tables.cost_of_a_prop(walk), 0)
        del walk["modes"]["in-view"]
        self.assertTrue(math.isnan(tables.cost_of_a_prop(walk)))

    def test_kept_props_of_settings(self):
        def mode(drawn):
            return {"median_ms": 1, "p10_ms": 1, "p90_ms": 1, "frames_ms": [1, 1], "frames_drawn": drawn}
        scene = {"modes": {"oracle": mode([5, 5]), "stock": mode([105, 5]), "nbuffer": mode([25, 5])},
                 "tried": [{"kind": "nbuffer", "setting": "BackOff", "value": 1, "mode": "nbuffer"}]}
        self.assertEqual(tables.setting_points(scene, False)["error"][0], 20)

    def test_lengths_have_the_unit_that_fits(self):
        for metres, text in ((12345, "12.3 km"), (999.9, "1 km"), (2, "2 m"), (0.305, "305 mm"),
                             (1.53e-4, "153 µm"), (9e-8, "90 nm"), (2e-10, "below 1 nm"),
                             (float("nan"), "")):
            self.assertEqual(depth.length(metres), text)

    def test_distances_without_wrong_pixels(self):
        def run(*wrong):
            return depth.clean_run(
                pd.DataFrame({"distance": [1, 10, 100, 1000][:len(wrong)], "wrong": wrong}))
        self.assertEqual([run(0, 0, 0, 0), run(7, 7, 7, 7), run(0, 0, 1, 0), run(1, 0, 0, 0),
                          run(1, 0, 0, 1)],
                         ["everywhere", "nowhere", "to 10 m", "from 10 m", "from 10 m to 100 m"])

    def test_formats_that_were_not_drawn_have_no_row(self):
        names = [row[0] for row in rows(depth.resolution(self.study, "0.1"))]
        self.assertEqual(names, ["16 bits", "float reversed", "24 bits W"])
        self.assertEqual([row[0] for row in rows(depth.receivers(self.study, "1e3"))], names)

    def test_wrong_shadows_are_not_on_the_line(self):
        points = tables.shadow_points(self.study["shadows"][0])
        self.assertFalse((points["pareto"] & (points["wrong"] > 0)).any())


    def test_fill_has_both_denominators(self):
        scene = self.study["fill"][0]
        for way in scene["ways"]:
            way["percent_of_reach"] = 2 * way["percent_of_whole"]
        scene["spot"] = True
        paper, ours = rows(shadows.fill(self.study, ""))[0], rows(shadows.fill(self.study, ""))[-1]
        self.assertEqual(paper[2:6], ["65.1", "", "1.67", "2.50"])
        self.assertEqual(ours[0], "birds, orbit, a spot")
        exact = next(way for way in scene["ways"] if way["name"] == "exact")
        self.assertEqual(ours[11:13], [tables.number(exact["percent_of_whole"]),
                                       tables.number(2 * exact["percent_of_whole"])])

    def test_fill_without_rays_has_no_row_of_own_receivers(self):
        scene = self.study["fill"][0]
        self.assertEqual(len(rows(shadows.own(self.study, ""))), 1)
        scene["ways"] = [way for way in scene["ways"] if "lost" not in way]
        with self.assertRaises(tables.NotMeasured):
            shadows.own(self.study, "")

    def test_a_later_file_replaces_the_fill(self):
        with tempfile.TemporaryDirectory() as folder:
            later = pathlib.Path(folder) / "later.json"
            later.write_text(json.dumps({"fill": ["new"]}))
            merged = report.load([STUDY, later])
            self.assertEqual((merged["fill"], "figure5" in merged), (["new"], True))


class Benchmarks(unittest.TestCase):
    def setUp(self):
        self.study = report.load([BENCHMARKS])

    def test_walks_have_goals_and_no_empty_columns(self):
        walk, = self.study["benchmarks"]["inside"]
        walk["modes"] = {name: {"median_ms": times[0], "drawn": 1, "units": 3, "frames_ms": times,
                                "statistics": {"milliseconds": {"cull": 0}}}
                         for name, times in (("stock", [8, 8]), ("nbuffer", [4, 4]), ("same-list", [2, 4]))}
        walk["goals"] = [9, 1.4]
        self.assertEqual(rows(benchmarks.walks(self.study, "inside"))[0][1:],
                         ["8", "4", "2", "3 / 3 / 3", "2 (9)", "1.50 (1.40)"])
        self.assertNotIn("wrong bytes", benchmarks.walks(self.study, "inside"))
        self.assertIn("wrong bytes", benchmarks.walks(self.study, "walks"))

    def test_first_images_are_medians(self):
        self.study["benchmarks"]["first"] = [
            {"mode": "stock", "first_image_ms": time, "drawn": 5} for time in (3, 100, 5)]
        self.assertEqual(rows(benchmarks.first(self.study, "")), [["stock", "5", "5"]])

    def test_a_stopped_run_is_continued(self):
        calls = []

        def bench(*arguments):
            calls.append(arguments)
            return {"frames": 1}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "benchmarks.json"
            file.write_text(json.dumps({"walks": []}))
            reports = study_benchmarks.measure(bench, pathlib.Path("nowhere"), file, False)
            self.assertEqual(set(reports), set(study_benchmarks.RUNS))
            self.assertEqual(reports["walks"], [])
            self.assertFalse(any("nowhere" in word for words in calls for word in words))
            self.assertEqual(len(reports["lamps"]), 17)
            count = len(calls)
            self.assertEqual(study_benchmarks.measure(bench, pathlib.Path("nowhere"), file, False), reports)
            self.assertEqual(len(calls), count)


class Documents(unittest.TestCase):
    def setUp(self):
        self.study = report.load([STUDY, BENCHMARKS])

    def test_every_table_can_be_drawn(self):
        for name, draw in report.TABLES.items():
            argument = {"pareto": "street", "best": "street", "chain": "street",
                        "hierarchy": "street", "shadows": "birds", "setting": "RoundSize",
                        "resolution": "0.1", "fights": "0.1", "gaps": "1",
                        "receivers": "1e3", "maps": "bias", "walks": "settled",
                        "recorded": "benchmarks", "shadow_fragments": "ground",
                        "shadow_times": "shadows no_culler"}.get(name, "")
            try:
                text = draw(self.study, argument)
            except tables.NotMeasured:
                self.assertEqual(name, "known")  # Only maps have a table of their own.
                continue
            for row in rows(text) if "|" in text else []:
                self.assertEqual(len(row), len(text[text.index("|"):].splitlines()[0].split("|")) - 2)

    def test_chains_of_two_eyes(self):
        paper, _, measured = rows(device.eyes(self.study, ""))
        self.assertEqual((paper[1], paper[3], paper[5]), ("0.25", "0.22", "0.12"))
        self.assertEqual(measured[0], "256 x 256")
        self.assertTrue(all(" / " in cell for cell in measured[1:]))
        groups = dict(rows(device.groups(self.study, "")))
        self.assertEqual(len(groups), 4)
        self.assertEqual(groups["4 x 4, fetch, tree"], "not measured")

    def test_early_depth(self):
        found = {row[1]: row for row in rows(tables.early(self.study, ""))}
        self.assertEqual(found["stock"][0], "street")
        self.assertEqual(found["early-depth"][5], found["stock"][6])
        self.assertEqual(found["early-depth"][7], "1")

    def test_shadow_maps(self):
        self.assertEqual(
            [row[1] for row in rows(shadows.maps(self.study, "exponent"))],
            ["vtk@256", "vtk@256:Exponent=80", "vtk@1024", "vtk@1024:Exponent=80"])
        for key in ("resolution", "bias"):
            for row in rows(shadows.maps(self.study, key)):
                self.assertTrue(row[1].startswith("vtk@") and "EachFrame" not in row[1])
        # Of the two with the same map the faster one counts; 4096 takes longer than the volumes.
        row, = rows(shadows.map_times(self.study, ""))
        self.assertEqual((row[0], row[5]), ("birds", "1024 x 1024"))
        self.study["maps"][0]["modes"]["auto"]["median_ms"] = 1
        row, = rows(shadows.map_times(self.study, ""))
        self.assertEqual(row[5], "256 x 256, slower")

    def test_setting_of_shadows(self):
        text = tables.setting(self.study, "BoxCost")
        self.assertIn("256 (default)", text)
        self.assertTrue(all(row[0].startswith("birds, ") for row in rows(text)))

    def test_only_tables_are_replaced(self):
        text = "before\n<!-- table: recorded scenes -->\nold\n<!-- end -->\nafter\n"
        filled, missing = report.fill_document(text, self.study)
        self.assertEqual(missing, [])
        self.assertTrue(filled.startswith("before\n<!-- table: recorded scenes -->\nRecorded at commit "))
        self.assertTrue(filled.endswith(", VTK 9.7.0.\n<!-- end -->\nafter\n"))
        self.assertNotIn("old", filled)
        self.assertEqual(report.fill_document(filled, self.study)[0], filled)

    def test_what_was_not_measured_stays(self):
        text = "<!-- table: pareto nowhere -->\nold\n<!-- end -->\n"
        self.assertEqual(report.fill_document(text, self.study), (text, ["pareto nowhere"]))

    def test_an_unknown_table_is_an_error(self):
        with self.assertRaises(SystemExit):
            report.fill_document("<!-- table: chair -->\n<!-- end -->\n", self.study)

    def test_the_documents_name_known_tables(self):
        for name in report.DOCUMENTS:
            text = (ROOT / "docs" / name).read_text()
            fields = report.TABLE.findall(text)
            self.assertEqual(len(fields), text.count("<!-- table: "), name)
            self.assertEqual(len(fields), text.count("<!-- end -->"), name)
            for _, field, _ in fields:
                self.assertIn(field.split(" ")[0], report.TABLES)


class Commands(unittest.TestCase):
    def run_report(self, *arguments):
        return subprocess.run([sys.executable, ROOT / "Scripts/report.py", *map(str, arguments)],
                              check=True, capture_output=True, text=True)

    def test_study(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "accuracy.md").write_text("<!-- table: table2 -->\n<!-- end -->\n")
            self.run_report("study", STUDY, STUDY, "--docs", folder, "--charts", folder / "charts",
                            "--csv", folder)
            self.assertIn("| the paper |", (folder / "accuracy.md").read_text())
            charts = {file.name for file in (folder / "charts").iterdir()}
            self.assertLessEqual(
                {"pareto-city-street.png", "hierarchy-city-street.png", "formats.png", "depth-resolution.png",
                 "depth-fights.png", "figure-4.png",
                 "shadows-birds.png", "shadow-errors-birds.png", "settings-birds.png",
                 "settings-plant-inside.png"}, charts)
            structures = pd.read_csv(folder / "structures.csv")
            self.assertIn("pareto", structures.columns)
            self.assertTrue((folder / "settings.csv").is_file())

    def test_ranks(self):
        counts = {"drawn_local": 30, "drawn_shared": 19, "busiest": 11}
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for spread in ("kd", "random"):
                (folder / f"{spread}.json").write_text(json.dumps(
                    {"spread": spread, "own_a_pixel": 15, "ranks": {"1": counts, "16": counts}}))
            self.run_report("ranks", *folder.glob("*.json"), "--chart", folder / "ranks.svg")
            chart = (folder / "ranks.svg").read_text()
            for line in ("own depth, kd", "depth of all, random", "own a pixel"):
                self.assertIn(f"<!-- {line} -->", chart)

    def test_walk(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            study = json.loads(STUDY.read_text())
            walk = {**study["scenes"][0]["walk"], "scene": "city", "path": "street", "size": "1x1"}
            (folder / "walk.json").write_text(json.dumps(walk))
            self.run_report("walk", folder / "walk.json", "--chart", folder / "times.svg")
            self.assertIn("<svg", (folder / "times.svg").read_text())


if __name__ == "__main__":
    unittest.main()
