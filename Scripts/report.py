#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws tables and charts from what nbuffer-bench measures.

    report.py study out/study/study.json [MORE.json ...] [--docs docs] [--charts docs/images/study] [--csv out]
    report.py walk out/walk.json --chart out/frame-times.svg
    report.py shadow out/shadow.json --chart out/shadow-times.svg
    report.py ranks out/ranks-*.json --chart out/ranks.png

`study` replaces the tables in the documents. A table stands between two comments,

    <!-- table: NAME ARGUMENT -->
    <!-- end -->

and everything outside of them is written by hand and stays. A table whose figures are not in the
files stays, too. Of several files, a later one replaces the shadows, the fill and the settings of
an earlier one. Examples/Bench/SCHEMA.md describes the figures.

It needs pandas and matplotlib, from PyPI,

    python3 -m venv out/venv && out/venv/bin/pip install -r Scripts/requirements-report.txt
    out/venv/bin/python Scripts/report.py ...

or from Debian: apt-get install python3-pandas python3-matplotlib.
"""

import argparse
import json
import math
import pathlib
import re
import sys

try:
    import matplotlib
    import numpy as np
    import pandas as pd
except ImportError as error:
    raise SystemExit(f"{__doc__}\nreport.py: {error}") from error

from report_benchmarks import BENCHMARK_TABLES
from report_depth import DEPTH_TABLES, depths, format_entries, wrong_percent
from report_device import DEVICE_TABLES
from report_shadows import SHADOW_TABLES
from report_tables import (
    OTHER_TABLES, NotMeasured, mark_pareto, number, setting_scenes, shadow_points, shadowed_percent,
    structures)

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 (the backend has to be chosen first)

DOCUMENTS = ("accuracy.md", "accuracy-depth.md", "accuracy-device.md", "accuracy-levels.md",
             "accuracy-particles.md", "accuracy-scenes.md", "accuracy-settings.md",
             "accuracy-shadow-maps.md", "accuracy-shadows.md", "benchmarks.md")
TABLES = {**BENCHMARK_TABLES, **OTHER_TABLES, **DEPTH_TABLES, **DEVICE_TABLES, **SHADOW_TABLES}
TABLE = re.compile(r"(<!-- table: ([^\n]*?) -->\n).*?(<!-- end -->)", re.DOTALL)

# Colours of Okabe and Ito, and shapes for readers who do not tell colours apart.
BLACK, ORANGE, SKY, GREEN = "#000000", "#e69f00", "#56b4e9", "#009e73"
BLUE, RED, PINK, GREY = "#0072b2", "#d55e00", "#cc79a7", "#787878"
GROUPS = {
    "one square": (ORANGE, "s"), "four squares": (BLUE, "s"),
    "strided": (SKY, "s"), "rectangles": (PINK, "o"), "mips": (RED, "x"), "one level": (GREY, "+"),
    "table": ("#aa0000", "o"), "positions": (BLUE, "+"), "culler": (GREEN, "D"),
    "outline": (BLACK, "D")}
SHADOW_LOOKS = {
    "unclamped": (BLACK, "s"), "exact": (BLUE, "s"), "clamp": (ORANGE, "o"), "slabs": (PINK, "D"),
    "auto": (GREEN, "D"), "paper": (RED, "x"), "vtk": (GREY, "+")}
SETTING_LOOKS = {
    "RoundSize": (ORANGE, "s"), "MaximumNumberOfRounds": (BLUE, "s"), "BaseFactor": (GREEN, "D"),
    "TestPixels": (BLACK, "x"), "BackOff": (RED, "+"),
    "TakeOverFrustumCulling": (SKY, "+"), "auto, BoxCost": (GREEN, "D"),
    "exact, BoxCost": (BLUE, "s"), "slabs, BoxCost": (PINK, "D"), "slabs, SlabGap": (ORANGE, "o")}
DEPTH_COLORS = {
    "16 bits": RED, "24 bits": ORANGE, "24 bits reversed": SKY, "float reversed": BLUE,
    "16 bits W": GREY, "24 bits W": BLACK, "16 bits logarithmic": PINK, "24 bits logarithmic": GREEN}
MODE_COLORS = {
    "none": GREY, "stock": RED, "nbuffer": BLUE, "oracle": GREEN, "unclamped": RED, "exact": BLUE,
    "clamp": SKY, "slabs": PINK, "auto": GREEN, "vtk": ORANGE}


def fill_document(text, report):
    """Returns the text with the tables of the report, and the names of those that it lacks."""
    missing = []

    def replace(match):
        name, _, argument = match[2].partition(" ")
        if name not in TABLES:
            raise SystemExit(f"report.py: there is no table {name}")
        try:
            return match[1] + TABLES[name](report, argument) + match[3]
        except NotMeasured:
            missing.append(match[2])
            return match[0]
    return TABLE.sub(replace, text), missing


# Charts.


def save(figure, file):
    file = pathlib.Path(file)
    file.parent.mkdir(parents=True, exist_ok=True)
    figure.tight_layout()
    figure.savefig(file, dpi=100)
    pyplot.close(figure)


def error_chart(groups, line, default, words, bound, file):
    """Errors against times, both axes logarithmic; no error stands below all others. `groups` has,
    by label, points, colour and marker; `words` title and axes; `bound` the dashed line."""
    errors = pd.concat([points["error"] for points, *_ in groups.values()])
    floor = 0.5 * errors[errors > 0].min() if (errors > 0).any() else 0.01
    figure, axes = pyplot.subplots(figsize=(12, 7.2))
    for label, (points, color, marker) in groups.items():
        axes.scatter(points["time"], points["error"].clip(lower=floor), color=color, marker=marker,
                     label=label, zorder=3)
    line = line.sort_values("time")
    axes.plot(line["time"], line["error"].clip(lower=floor), color="#3c3c3c", label="Pareto line")
    for place, (_, point) in enumerate(line.iterrows(), 1):
        axes.annotate(str(place), (point["time"], max(point["error"], floor)),
                      xytext=(5, 4), textcoords="offset points")
    axes.scatter(default["time"], default["error"].clip(lower=floor), s=320, color=GREEN, alpha=0.4,
                 label="default settings", zorder=2)
    axes.axhline(max(bound[1], floor), color=GREEN, linestyle="--", label=bound[0])
    axes.set(xscale="log", yscale="log", title=words[0], xlabel=words[1], ylabel=words[2])
    axes.grid(which="both", color="#e1e1e1")
    axes.legend()
    save(figure, file)


def chart_points(points, time, error):
    return points.assign(time=points[time], error=points[error])[lambda p: p["error"].notna()]


def grouped(points, key, looks):
    return {label: (points[points[key] == label], *look) for label, look in looks.items()
            if (points[key] == label).any()}


def structure_charts(report, folder):
    for scene in report.get("scenes") or []:
        points = chart_points(structures(scene), "total_ms.median", "kept")
        error_chart(grouped(points, "group", GROUPS), points[points["pareto"]],
                    points[points["is_default"]],
                    (f"{scene['scene']}, {scene['path']}, {scene['size']}",
                     "milliseconds of a frame: build and all queries",
                     "hidden props that are kept, %"), ("oracle: 0 %, in no time", 0.0),
                    folder / f"pareto-{scene['file_name']}.png")


def shadow_charts(report, folder):
    for scene in report.get("shadows") or []:
        words = (f"{scene['scene']}, shadows, {scene['size']}",
                 "milliseconds of a frame with shadows")
        points = shadow_points(scene)
        for stem, error, label, bound in (
                ("shadows", "percent", "fragments of volumes, % of whole ones",
                 ("pixels that shadows change", shadowed_percent(scene))),
                ("shadow-errors", "wrong_percent",
                 "samples that differ from rays and are not ambiguous, %", ("none", 0.0))):
            if stem == "shadow-errors":
                mark_pareto(points, "median", "wrong_percent")
            drawn = chart_points(points, "median", error)
            error_chart(grouped(drawn, "kind", SHADOW_LOOKS), drawn[drawn["pareto"]],
                        drawn[drawn["is_default"]], (*words, label), bound,
                        folder / f"{stem}-{scene['scene']}.png")


def setting_charts(report, folder):
    for part, scene, points in setting_scenes(report):
        if part == "still":
            continue
        of_shadows = part == "shadows"
        points["label"] = (points["kind"] + ", " if of_shadows else "") + points["setting"]
        points = chart_points(points, "median", "error")
        name = scene["scene"].split(" ")[0] + ("" if of_shadows else f"-{scene['path']}")
        error_chart(
            grouped(points, "label", SETTING_LOOKS), points[:0],
            points[points["is_default"] & points["usual"]][:1],
            (f"{scene['scene']}, {scene['path']}{', shadows' if of_shadows else ''}, one setting "
             "varied at a time", "milliseconds of a frame",
             "fragments of volumes, % of whole ones" if of_shadows else "hidden props drawn, %"),
            ("pixels that shadows change", shadowed_percent(scene)) if of_shadows
            else ("oracle: 0 %", 0.0), folder / f"settings-{name}.png")


def line_chart(lines, words, file, log_x=True):
    figure, axes = pyplot.subplots(figsize=(12, 6.4))
    for label, (x, y, color) in lines.items():
        axes.plot(x, y, color=color, linewidth=2.5, label=label,
                  marker="o" if len(x) == 1 else None)
    axes.set(yscale="log", title=words[0], xlabel=words[1], ylabel=words[2])
    if log_x:
        axes.set_xscale("log")
    axes.grid(color="#e1e1e1")
    axes.legend()
    save(figure, file)


def depth_charts(report, folder):
    """Only some of the formats: the others lie on one of these lines."""
    def lines(drawn, select):
        return {name: (*select(points), DEPTH_COLORS[name]) for name, points in drawn
                if name in DEPTH_COLORS}

    def fight(points):
        chosen = points[(points["gap"] == 0.1) & (points["slope"] == points["slope"].max())]
        return chosen["distance"], wrong_percent(chosen).clip(lower=1e-3)
    if report.get("depth"):
        line_chart(lines(depths(report, 0.1, "resolution"), lambda points: (
            points["distance"], points["worst"])),
            ("near plane at 10 cm, drawn", "distance, metres",
             "separation that is always distinguished, metres"), folder / "depth-resolution.png")
        line_chart(lines(depths(report, 0.1, "fights"), fight),
                   ("two slanted triangles 10 cm apart, near plane at 10 cm", "distance, metres",
                    "wrong pixels, % (below all others: none)"), folder / "depth-fights.png")
    if report.get("formats"):
        entries = format_entries(report)
        line_chart(lines(entries.groupby("format", sort=False), lambda group: (
            group["ratio"], group["slack.median"].clip(lower=1e-4))),
            (f"{report['formats']['scene']}, {report['formats']['path']}: formats of depth",
             "far / near", "median slack of a box, metres"), folder / "formats.png")


def other_charts(report, folder):
    for scene in report.get("hierarchy") or []:
        entries = pd.json_normalize(scene["entries"])
        tree = entries["tree.ms.median"]
        line_chart({"one by one": (entries["props"], entries["flat.ms.median"], RED),
                    "over the hierarchy": (entries["props"], tree, BLUE),
                    "hierarchy and refit": (entries["props"], tree + entries["refit_ms.median"],
                                            SKY)},
                   (f"{scene['scene']}, {scene['path']}, copies side by side", "props",
                    "milliseconds to test all of them"),
                   folder / f"hierarchy-{scene['file_name']}.png")
    depth_charts(report, folder)
    if report.get("figure4"):
        figure, axes = pyplot.subplots(1, len(report["figure4"]), figsize=(16, 3.2))
        for axis, entry in zip(axes, report["figure4"]):
            shares = np.log1p(pd.DataFrame(entry["shares"]).clip(lower=0))
            axis.imshow(shares, origin="lower", cmap="viridis", vmin=0, vmax=math.log1p(30.0),
                        extent=(1, len(shares) * entry["step"], 1, len(shares) * entry["step"]))
            axis.set_xlabel(f"{entry['caption']}: {number(entry['mean_percent'])} %")
        save(figure, folder / "figure-4.png")


def times_chart(report, file):
    """Milliseconds by frame, one line for each mode without settings and sizes of its own."""
    line_chart({f"{name}, {number(mode['median_ms'])} ms": (
        range(len(mode["frames_ms"])), mode["frames_ms"], MODE_COLORS.get(name))
        for name, mode in report["modes"].items() if not set("@:") & set(name)},
        (f"{report['scene']}, {report['path']}, {report['size']}", "frame",
         "milliseconds per frame"), file, log_x=False)


def ranks_chart(files, file):
    """Props drawn by all ranks, by their number; the files are of `nbuffer-bench ranks`.

    Files of one spread that have other numbers of props (weak scaling) are one line.
    """
    points = {}
    for report in (json.loads(pathlib.Path(name).read_text()) for name in files):
        for ranks, counts in report["ranks"].items():
            entry = points.setdefault(report["spread"], {}).setdefault(int(ranks), {})
            entry.update(counts, own_a_pixel=report["own_a_pixel"])
    lines = {}
    for spread, entries in points.items():
        ranks = sorted(entries)
        colors = (RED, BLUE, GREEN) if spread == "kd" else (ORANGE, SKY, GREY)
        for (key, words), color in zip((("drawn_local", "own depth"), ("drawn_shared", "depth of all"),
                                        ("own_a_pixel", "own a pixel")), colors):
            if key != "own_a_pixel" or spread == "kd":
                label = words if key == "own_a_pixel" else f"{words}, {spread}"
                lines[label] = (ranks, [entries[n][key] for n in ranks], color)
    line_chart(lines, ("Props drawn by all ranks", "ranks", "props"), file)


# Commands.


def load(files):
    """One report of several files: parts of a later one replace those before."""
    reports = [json.loads(pathlib.Path(file).read_text()) for file in files]
    merged = reports[0]
    for report in reports[1:]:
        for part in ("benchmarks", "shadows", "device", "packed", "rebuild", "early", "maps", "fill",
                     "figure5"):
            if report.get(part):
                merged[part] = report[part]
        merged.setdefault("recorded", {}).update(report.get("recorded") or {})
        for part, value in (report.get("settings") or {}).items():
            if isinstance(value, list) or part not in merged.get("settings", {}):
                merged.setdefault("settings", {})[part] = value
    return merged


def write_csv(report, folder):
    def join(parts):
        return pd.concat([points.assign(scene=scene["scene"], path=scene["path"])
                          for scene, points in parts])
    folder.mkdir(parents=True, exist_ok=True)
    for name, parts in {
            "structures": [(scene, structures(scene)) for scene in report.get("scenes") or []],
            "shadows": [(scene, shadow_points(scene)) for scene in report.get("shadows") or []],
            "settings": [(scene, points.assign(part=part))
                         for part, scene, points in setting_scenes(report)]}.items():
        if parts:
            join(parts).to_csv(folder / f"{name}.csv", index=False)


def run_study(options):
    report = load(options.files)
    if options.docs:
        for name in DOCUMENTS:
            path = options.docs / name
            if path.is_file():
                text, missing = fill_document(path.read_text(), report)
                path.write_text(text)
                for field in missing:
                    print(f"{path}: kept {field}, which was not measured", file=sys.stderr)
    if options.charts:
        for draw in (structure_charts, shadow_charts, setting_charts, other_charts):
            draw(report, options.charts)
    if options.csv:
        write_csv(report, options.csv)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    study = commands.add_parser("study", help="tables and charts of a study")
    study.add_argument("files", nargs="+")
    study.add_argument("--docs", type=pathlib.Path, help="folder of the documents")
    study.add_argument("--charts", type=pathlib.Path, help="folder for the charts")
    study.add_argument("--csv", type=pathlib.Path, help="folder for every point as CSV")
    study.set_defaults(run=run_study)
    for name in ("walk", "shadow"):
        times = commands.add_parser(name, help="a chart of frame times")
        times.add_argument("file")
        times.add_argument("--chart", required=True, help="file of the chart (.png or .svg)")
        times.set_defaults(run=lambda options: times_chart(load([options.file]), options.chart))
    ranks = commands.add_parser("ranks", help="a chart of what ranks draw")
    ranks.add_argument("files", nargs="+")
    ranks.add_argument("--chart", required=True, help="file of the chart (.png or .svg)")
    ranks.set_defaults(run=lambda options: ranks_chart(options.files, options.chart))
    options = parser.parse_args()
    options.run(options)


if __name__ == "__main__":
    main()
