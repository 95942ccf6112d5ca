# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/accuracy-shadow-maps.md and docs/accuracy-shadows.md; see report_tables.py."""

import re

from report_tables import NotMeasured, number, span, table, times_of


ERRORS = ("outline", "acne", "peter_panning", "leak")


def wrong_percent(mode):
    return 100.0 * mode["oracle"]["wrong"] / max(mode["oracle"]["samples"], 1)


def map_modes(scene, key):
    """The modes of shadow maps that vary the resolution, the exponent or the bias."""
    def varies(name):
        return ("resolution" if "EachFrame" in name else "bias" if "Offset" in name
                else "exponent")
    return [(name, mode) for name, mode in scene["modes"].items()
            if name.startswith("vtk") and varies(name) == key]


def maps(report, key):
    rows = []
    for scene in report.get("maps") or []:
        shown = map_modes(scene, key)
        for name, mode in sorted(shown, key=lambda entry: [
                int(number) for number in re.findall(r"\d+", entry[0])]):
            oracle = mode["oracle"]
            rows.append([scene["scene"], name.replace(":EachFrame=1", ""), wrong_percent(mode),
                         *(oracle["errors"][error] for error in ERRORS)])
    return table(["scene", "mode", "wrong, %", "outline", "acne", "peter-panning", "leaks"], rows)


def map_times(report, _):
    """The largest map that takes no longer than the volumes, and what is wrong with it."""
    rows = []
    for scene in report.get("maps") or []:
        ours = scene["modes"]["auto"]
        timed = {}
        for name, mode in map_modes(scene, "resolution"):
            timed.setdefault(int(re.search(r"@(\d+)", name)[1]), []).append(mode)
        fast = [size for size, modes in timed.items()
                if min(mode["median_ms"] for mode in modes) <= ours["median_ms"]]
        size = max(fast) if fast else min(timed)
        wrong = [f"{number(mode['oracle']['wrong'])} ({number(wrong_percent(mode))} %)"
                 for mode in timed[size]]
        rows.append([scene["scene"], scene["modes"]["none"]["median_ms"], span(times_of(ours)),
                     ours["oracle"]["wrong"], span(times_of(scene["modes"]["vtk@1024"])),
                     f"{size} x {size}" + ("" if fast else ", slower"),
                     span(times_of(timed[size][0])), *(wrong + [""])[:2]])
    return table(["scene", "no shadows ms", "volumes (auto) ms", "wrong", "a map that is kept ms",
                  "largest map as fast", "ms", "wrong, VTK's exponent", "wrong, exponent 40"], rows)


def fill_title(scene):
    notes = [note for flag, note in (("spot", "a spot"), ("ground_casts", "the ground casts"))
             if scene[flag]]
    return ", ".join([f"{scene['scene']}, {scene['path']}", *notes])


def fill_ways(scene):
    """The ways by name, and the pixels of the image."""
    width, height = map(int, scene["size"].split("x"))
    return {way["name"]: way for way in scene["ways"]}, width * height


def fill(report, _):
    """From the paper's method to the module's, next to the paper's figures (section 4.4)."""
    if not report.get("fill"):
        raise NotMeasured
    pixels, blank = 640 * 480, [""] * 8
    rows = [["the paper, city", "", 20e6 / pixels, "", 512e3 / pixels, 2.5, "", *blank],
            ["the paper, terrain with towers and birds", *[""] * 4, 2.5, "", *blank],
            ["the paper, simpler scenes", *[""] * 4, 20, "", *blank]]
    for scene in report["fill"]:
        ways, pixels = fill_ways(scene)
        whole, paper = ways["whole"], ways["paper"]
        rows.append([
            fill_title(scene), scene["casters"], whole["fragments"] / pixels,
            ways["reach"]["percent_of_whole"], paper["fragments"] / pixels,
            paper["percent_of_whole"], paper["percent_of_reach"],
            *(ways[name]["percent_of_whole"] for name in (
                "scattered", "scattered, slabs", "scattered, slabs, box", "slabs", "exact")),
            ways["exact"]["percent_of_reach"],
            *(ways.get("auto", {}).get(f"percent_of_{all}") for all in ("whole", "reach"))])
    return table(
        ["scene, path", "casters", "whole volumes, fragments a pixel", "in reach of the light, %",
         "the paper's method, fragments a pixel", "% of whole", "% of those in reach",
         "scattered litmap, %", "and several slabs, %", "and one box, %", "and tiles: `slabs`, %",
         "and boxes of pixels: `exact`, %", "% of those in reach",
         "the default: `auto`, %", "% of those in reach"], rows)


def fill_paper(report, _):
    """What the paper's method draws, and what the size of litmaps changes."""
    if not report.get("fill"):
        raise NotMeasured
    rows = []
    for scene in report["fill"]:
        ways, _ = fill_ways(scene)
        paper = ways["paper"]
        rows.append([
            fill_title(scene), paper["drawn"], ways["paper, casters that are seen"]["drawn"],
            100.0 * ways["paper, casters that are seen"]["fragments"] / max(paper["fragments"], 1),
            ways["scattered, not clamped"]["percent_of_whole"],
            *(ways.get(name, {}).get("percent_of_whole") for name in (
                "paper@64", "paper", "paper@1024", "scattered@64", "scattered", "scattered@1024"))])
    return table(
        ["scene, path", "casters drawn", "of these seen", "fragments of these, %",
         "not clamped, % of whole", "paper, litmap 64, %", "256, %", "1024, %",
         "scattered, litmap 64, %", "256, %", "1024, %"], rows)


def own(report, _):
    """Receivers that a caster need not draw for."""
    if not report.get("fill"):
        raise NotMeasured
    names = [f"exact, {name}" for name in (
        "own lit sides out", "own out if convex", "own out", "nearest caster only")]
    rows = []
    for scene in report["fill"]:
        ways, _ = fill_ways(scene)
        if names[0] in ways:
            out = ways["exact, own out"]
            rows.append([fill_title(scene), ways["exact"]["percent_of_whole"],
                         *(ways[name]["percent_of_whole"] for name in names),
                         ways[names[1]]["lost_shown"], out["lost"], out["lost_shown"],
                         ways[names[3]]["lost"]])
    return table(
        ["scene, path", "`exact`, %", "convex casters' own lit samples out, %",
         "convex casters' own out, %", "all own out, %", "nearest caster alone, %",
         "convex own out: pixels that change", "all own out: wrong samples", "pixels that change",
         "nearest alone: wrong samples"], rows)


def figure5(report, _):
    """From and to which height the volume of the selected caster is drawn."""
    if not report.get("figure5"):
        raise NotMeasured
    rows = []
    for name, entry in report["figure5"].items():
        heights = ", ".join(f"{number(high)} to {number(low)}" for low, high in entry["pieces"])
        rows.append([f"({name})", heights or "nothing"])
    return table(["configuration", "drawn from and to a height of"], rows)


SHADOW_TABLES = {function.__name__: function for function in (
    maps, map_times, fill, fill_paper, own, figure5)}
