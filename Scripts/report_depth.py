# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/accuracy-depth.md; see report_tables.py."""

import math

import pandas as pd

from report_tables import NotMeasured, number, table


def length(metres):
    """Three digits of the unit that fits; nothing for no value."""
    if math.isnan(metres):
        return ""
    units = (("km", 1e3), ("m", 1), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9))
    unit, size = next((entry for entry in units if metres >= 0.9995 * entry[1]), ("", 0))
    if not unit:
        return "below 1 nm"
    return f"{float(f'{metres / size:.3g}'):,g} {unit}"


def depths(report, near, part):
    """The formats of depth that were drawn with this near plane, and one part of their figures."""
    drawn = [(entry["format"], pd.DataFrame(entry[part])) for entry in report.get("depth") or []
             if "skipped" not in entry and entry["near"] == near]
    if not drawn:
        raise NotMeasured
    return drawn


def powers(points):
    """The distances 1, 10, 100, ... of these."""
    return [distance for distance in sorted(set(points["distance"]))
            if abs(math.log10(distance) - round(math.log10(distance))) < 1e-9]


def resolution(report, near):
    drawn = depths(report, float(near), "resolution")
    distances = powers(drawn[0][1])

    def cell(point):
        worst = length(point["worst"]) if "worst" in point and pd.notna(point["worst"]) else "none"
        return f"{worst} ({length(point['formula'])})"
    return table(["format", *map(length, distances)],
                 ([name, *(cell(points[points["distance"] == distance].iloc[0])
                           for distance in distances)] for name, points in drawn))


def wrong_percent(points):
    return 100.0 * points["wrong"] / points["pixels"]


def fights(report, near):
    """Wrong pixels of two triangles 10 cm apart, facing the eye and slanted."""
    drawn = depths(report, float(near), "fights")
    distances = powers(drawn[0][1])
    slopes = sorted(set(drawn[0][1]["slope"]))

    def cell(points, distance):
        chosen = points[(points["gap"] == 0.1) & (points["distance"] == distance)]
        return " / ".join(number(float(wrong_percent(chosen[chosen["slope"] == slope]).iloc[0]))
                          for slope in slopes)
    pixels = drawn[0][1]["pixels"].median()
    return (f"Each share is of {number(pixels)} pixels.\n\n" + table(
        ["format", *map(length, distances)],
        ([name, *(cell(points, distance) for distance in distances)] for name, points in drawn)))


def clean_run(points):
    """Where none of the pixels is wrong, as a range of the distances that were measured."""
    distances = sorted(set(points["distance"]))
    wrong = set(points[points["wrong"] > 0]["distance"])
    runs, run = [[]], []
    for distance in distances:
        run = [] if distance in wrong else [*run, distance]
        runs.append(run)
    best = max(runs, key=len)
    if not best or len(best) == len(distances):
        return "everywhere" if best else "nowhere"
    if best[0] == distances[0]:
        return "to " + length(best[-1])
    return "from " + length(best[0]) + (
        "" if best[-1] == distances[-1] else " to " + length(best[-1]))


def gaps(report, near):
    drawn = depths(report, float(near), "fights")
    every = sorted(set(drawn[0][1]["gap"]), key=lambda gap: gap or math.inf)
    return table(["format", *(length(gap) if gap else "1/10,000 of the distance" for gap in every)],
                 ([name, *(clean_run(points[points["gap"] == gap]) for gap in every)]
                  for name, points in drawn))


def offsets(report, _):
    def row(name, points):
        r = points["r"] / points["expected_r"]
        larger, steepest = (points["m"] / points[key] for key in ("larger_slope", "steepest_slope"))
        spread = [f"{number(values.min())} to {number(values.max())}" if
                  values.max() - values.min() > 0.005 else number(float(values.iloc[0]))
                  for values in (r, larger, steepest)]
        return [name, *spread, 100.0 * points["moved_by_one"].mean()]
    return table(["format", "r / step of the format", "m / larger slope", "m / steepest slope",
                  "pixels that one unit moves, %"],
                 (row(*entry) for entry in depths(report, 1.0, "offsets")))


def format_entries(report):
    entries = (report.get("formats") or {}).get("entries") or []
    drawn = [entry for entry in entries if "skipped" not in entry]
    if not drawn:
        raise NotMeasured
    return pd.json_normalize(drawn)


def formats(report, _):
    entries = format_entries(report)
    kept = 100.0 * entries["false_visible"] / entries["hidden"].clip(lower=1)
    entries["cell"] = entries["slack.median"].map(length) + kept.map(", {:.1f} %".format)
    cells = entries.pivot(index="format", columns="ratio", values="cell")
    cells = cells.loc[list(dict.fromkeys(entries["format"]))]
    return table(["format", *(f"{ratio:.0e}" for ratio in cells.columns)],
                 ([name, *row] for name, row in zip(cells.index, cells.values)))


def receivers(report, ratio):
    entries = format_entries(report)
    chosen = entries[entries["ratio"] == float(ratio)]
    return table(
        ["format", "pixels that show what is farther, %", "receivers lost, %",
         "error of the position: median", "most", "receivers in another lexel, %", "lexels lost, %",
         "bias needed", "wrong shadows with a bias of 10 cm, %"],
        ([entry["format"], 100.0 * entry["wrong"] / entry["samples"],
          100.0 * entry["lost"] / entry["samples"], length(entry.get("median_error", math.nan)),
          length(entry.get("most_error", math.nan)),
          100.0 * entry["displaced"] / max(entry["compared"], 1),
          100.0 * entry["lost_lexels"] / max(entry["lexels"], 1),
          length(entry.get("bias", math.nan)),
          100.0 * entry["wrong_shadows"] / max(entry["facing"], 1)]
         for _, entry in chosen.iterrows()))


DEPTH_TABLES = {function.__name__: function for function in (
    resolution, fights, gaps, offsets, formats, receivers)}
