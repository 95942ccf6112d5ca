# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/benchmarks.md; see report_tables.py and study_benchmarks.py."""

import pandas as pd

from report_tables import NotMeasured, number, ratio, shadowed_percent, span, table

FLAT, TREE = "nbuffer:HierarchySize=10000000", "nbuffer"


def reports_of(report, name):
    found = (report.get("benchmarks") or {}).get(name)
    if not found:
        raise NotMeasured
    return found


def with_used_columns(head, rows):
    """The table without the columns that no row has anything in."""
    used = [i for i in range(len(head)) if any(row[i] not in ("", None) for row in rows)]
    return table([head[i] for i in used], ([row[i] for i in used] for row in rows))


def with_goal(walk, modes, place):
    """The ratio of two modes, and the goal for it, if there are any."""
    if not set(modes) <= set(walk["modes"]):
        return ""
    goal = (walk["goals"] + [None, None])[place]
    return number(ratio(walk, *modes)) + (f" ({number(goal)})" if goal is not None else "")


def walks(report, name):
    """Whole frames, and what is drawn in them: props, or units where props are divided."""
    rows = []
    for walk in reports_of(report, name):
        modes = walk["modes"]
        bound = "same-list" if "same-list" in modes else "oracle"
        shown = [modes[mode] for mode in ("stock", "nbuffer", bound) if mode in modes]
        times = [modes[mode]["median_ms"] if mode in modes else "" for mode in ("stock", "nbuffer", bound)]
        statistics = modes["nbuffer"]["statistics"]
        rows.append([
            walk["label"], *times,
            " / ".join(number(mode.get("units") or mode["drawn"]) for mode in shown),
            with_goal(walk, ("stock", "nbuffer"), 0), with_goal(walk, ("nbuffer", bound), 1),
            str(walk["differing_bytes"]) if walk["verified_frames"] else "",
            statistics["milliseconds"]["cull"] if "stock" not in modes else ""])
    drawn = " / ".join(name for i, name in enumerate(("stock", "nbuffer", "oracle"), 1)
                       if any(row[i] != "" for row in rows))
    return with_used_columns(
        ["", "stock ms", "nbuffer ms", "oracle ms", f"drawn: {drawn}", "stock / nbuffer",
         "nbuffer / oracle", "wrong bytes", "`Cull()` ms"], rows)


STAGES = ("cull", "read", "build", "test", "pixel_test", "sliver_test")


def stages(report, _):
    """Where the time of the calling thread goes, on the host and with the back-end of devices."""
    rows = []
    for name, backend in (("settled", "CPU"), ("device", "OpenGL")):
        for walk in reports_of(report, name):
            statistics = walk["modes"]["nbuffer"]["statistics"]
            rows.append([f"{walk['label']}, {backend}",
                         *(statistics["milliseconds"][stage] for stage in STAGES),
                         walk["modes"]["nbuffer"]["median_ms"], statistics["read_backs"],
                         statistics["bytes_read"]])
    return table(["path, back-end", "`Cull()`", "read", "levels", "test", "pixels", "slivers", "frame ms",
                  "reads", "bytes read"], rows)


def first(report, _):
    runs = pd.DataFrame(reports_of(report, "first"))
    medians = runs.groupby("mode", sort=False)[["first_image_ms", "drawn"]].median()
    return table(["", "first image ms", "drawn"], (
        [mode, row["first_image_ms"], row["drawn"]] for mode, row in medians.iterrows()))


def first_frames(report, _):
    return table(["scene", "first image", "images 1 to 10", "after 10"], (
        [walk["label"], *(span(walk["first_frames"]["nbuffer"][name])
                          for name in ("first", "first_ten", "after_ten"))]
        for walk in reports_of(report, "first_frames")))


def lists(report, _):
    def row(walk):
        flat, tree = (walk["modes"][name] for name in (FLAT, TREE))
        def both(stage):
            return [mode["statistics"]["milliseconds"][stage] for mode in (flat, tree)]
        statistics = flat["statistics"]
        return [walk["label"], walk["props"], statistics["props"] - statistics["verdicts"]["Outside"],
                *both("cull"), *both("test"), flat["median_ms"], tree["median_ms"], ratio(walk, FLAT, TREE)]
    return table(["path", "props", "in view", "`Cull()` ms: flat", "tree", "test ms: flat", "tree",
                  "frame ms: flat", "tree", "flat / tree"], map(row, reports_of(report, "lists")))


# Shadows.


def millions(count):
    return f"{1e-6 * count:.2f} M"


def shadow_fragments(report, name):
    modes = ("cull", "exact", "clamp", "slabs", "auto", "paper")
    return with_used_columns(
        ["scene", "unclamped, a frame", *(f"{mode} %" for mode in modes), "no mode can have less %"],
        [[scene["label"], millions(scene["modes"]["unclamped"]["fragments"]),
          *(scene["modes"][mode]["fragments_percent"] if mode in scene["modes"] else "" for mode in modes),
          shadowed_percent(scene)] for scene in reports_of(report, name)])


def shadow_errors(report, _):
    modes = ("unclamped", "exact", "clamp", "slabs", "auto", "paper", "vtk")
    def cell(oracle):
        return f"{number(oracle['wrong'])} ({number(oracle['ambiguous'])})"
    return table(["scene", "samples", *modes], (
        [scene["label"], scene["modes"]["exact"]["oracle"]["samples"],
         *(cell(scene["modes"][mode]["oracle"]) for mode in modes)]
        for scene in reports_of(report, "shadows")))


def shadow_times(report, names):
    """Several tables of runs below each other. The ratios are those of the same frames."""
    rows = []
    shown = ("none", "unclamped", "exact", "slabs", "auto", "vtk")
    for name in names.split():
        for scene in reports_of(report, name):
            modes = scene["modes"]
            ratios = [ratio(scene, *pair) if set(pair) <= set(modes) else "" for pair in (
                ("unclamped", "exact"), ("unclamped", "auto"), ("auto", "none"))]
            rows.append([scene["label"] + (", without the culler" if name == "no_culler" else ""),
                         *(modes[mode]["median_ms"] if mode in modes else "" for mode in shown), *ratios])
    return with_used_columns(
        ["scene", *(f"{mode} ms" for mode in shown), "unclamped / exact", "unclamped / auto",
         "auto / none"], rows)


def lamps(report, _):
    def row(scene):
        modes = scene["modes"]
        lamps, lamp = scene["label"].split(": ")
        *place, cone = lamp.split(",")
        return [lamps, ", ".join(place), cone, millions(modes["unclamped"]["fragments"]),
                *(modes[mode]["fragments_percent"] for mode in ("exact", "auto")),
                *(modes[mode]["median_ms"] for mode in ("exact", "auto")), scene["shadowed"]]
    return table(["lamps", "east, north, up", "cone", "unclamped, a frame", "`exact` %", "`auto` %",
                  "`exact` ms", "`auto` ms", "pixels that shadows change"],
                 map(row, reports_of(report, "lamps")))


SHADOW_STAGES = {"collecting casters": "casters", "drawing the receivers' depth": "depth", "reading it": "read",
                 "litmaps and tiles": "litmaps", "decisions, and making volumes": "plan",
                 "drawing volumes": "draw"}


def shadow_stages(report, _):
    scenes = [scene for scene in reports_of(report, "shadows") if scene["label"].startswith("city")]
    columns = [(scene, mode) for scene in scenes for mode in ("unclamped", "exact")]
    return table(["ms of the calling thread", *(f"{scene['label']}, {mode}" for scene, mode in columns)], (
        [words, *(scene["modes"][mode]["statistics"]["milliseconds"][stage] for scene, mode in columns)]
        for words, stage in SHADOW_STAGES.items()))


BENCHMARK_TABLES = {function.__name__: function for function in (
    walks, stages, first, first_frames, lists, shadow_fragments, shadow_errors, shadow_times, lamps,
    shadow_stages)}
