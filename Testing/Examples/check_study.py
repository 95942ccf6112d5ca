# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a study of one frame of each path and checks whether its figures can be true; where pandas
and matplotlib are installed, also that the tables and charts of the documents can be made of them.

    check_study.py <nbuffer-bench> <source tree> <folder to write to>
"""
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys

from running import check

BENCH, SOURCE, OUT = (pathlib.Path(argument) for argument in sys.argv[1:])
DOCUMENTS = ("accuracy", "accuracy-depth", "accuracy-device", "accuracy-levels",
             "accuracy-particles", "accuracy-scenes", "accuracy-settings", "accuracy-shadow-maps",
             "accuracy-shadows")
CHARTS = ("depth-", "pareto-", "shadows-", "shadow-errors-", "settings-city-street", "settings-birds")


def run(script, *arguments):
    subprocess.run([sys.executable, SOURCE / "Scripts" / script, *arguments], check=True)


def check_scene(name, scene):
    structures = scene["structures"]
    check(len(structures) >= 49, f"{name}: {len(structures)} structures")
    check(scene["hidden"] > 0, f"{name}: nothing is hidden")
    for point in structures:
        kept = point["false_visible"]
        check(0 <= kept <= point["hidden"] and point["false_hidden"] == 0,
              f"{point['name']}: {kept} of {point['hidden']} kept, "
              f"{point['false_hidden']} visible ones hidden")
    defaults = sum(point["is_default"] for point in structures)
    check(defaults == 1, f"{name}: {defaults} defaults")

    # Queries of the hardware are conservative: no byte differs, and what is visible is drawn.
    walk = scene["walk"]
    check(walk["differing_bytes"] == 0, f"{name}: {walk['differing_bytes']} wrong bytes")
    seen = walk["modes"]["oracle"]["drawn"]
    everything = walk["modes"]["stock"]["drawn"]
    in_view = walk["modes"]["in-view"]["drawn"]
    check(in_view == everything, f"{name}: {in_view} in view, and stock draws {everything}")
    for mode in ("queries", "chc"):
        drawn = walk["modes"][mode]["drawn"]
        asked = walk["modes"][mode]["queries"]["queries"]
        wasted = scene["fragments"][mode]["wasted"]
        check(seen <= drawn < everything and asked >= 1 and wasted >= 0,
              f"{name}, {mode}: {drawn} drawn of {everything}, {seen} seen, {asked} queries, "
              f"{wasted} fragments wasted")
    of_hidden = scene["fragments"]["oracle"]["of_hidden"]
    check(of_hidden == 0, f"{name}: the oracle draws {of_hidden} fragments of hidden props")


def check_shadows(name, scene):
    """No mode has more fragments than whole volumes, and no sample is in wrong light."""
    check(scene["wrong_samples"] == 0, f"{name}: {scene['wrong_samples']} wrong samples")
    for mode, values in scene["modes"].items():
        percent = values.get("fragments_percent", 0)
        check(percent <= 100, f"{name}, {mode}: {percent} % of the fragments")


def check_maps(scene):
    """Errors of shadow maps are all that is wrong, and the volumes have none."""
    modes = {name: mode["oracle"] for name, mode in scene["modes"].items() if name != "none"}
    for name, oracle in modes.items():
        check(sum(oracle["errors"].values()) == oracle["wrong"],
              f"{name}: {oracle['errors']} of {oracle['wrong']} wrong samples")
    check(modes["auto"]["wrong"] == 0 and modes["vtk@1024"]["wrong"] > 0,
          f"maps: {modes['auto']['wrong']} wrong by volumes, {modes['vtk@1024']['wrong']} by maps")


def check_fill(scene):
    """Every way counts what it must, and what is proven to change no shadow changes none."""
    check(scene["differing_ways"] == 0 and scene["lost"] == 0,
          f"fill: {scene['differing_ways']} counts that the pass does not have, {scene['lost']} "
          "samples in wrong light")
    for way in scene["ways"]:
        check(way["percent_of_whole"] <= way["percent_of_reach"] and
              (way["name"] == "reach") <= (way["percent_of_reach"] == 100), f"fill: {way}")
    ways = {way["name"]: way["fragments"] for way in scene["ways"]}
    # Each way leaves out what the one before it draws, except that of two litmaps none is always
    # the tighter one.
    order = ["reach", "scattered, not clamped", "scattered, slabs", "scattered, slabs, box", "slabs"]
    for more, less in zip(["whole", *order], order):
        check(ways[less] <= ways[more], f"fill: {less} {ways[less]}, {more} {ways[more]}")
    check(0 < ways["exact, nearest caster only"] < ways["exact"] <= ways["scattered, not clamped"] and
          0 < ways["paper"] < ways["whole"], f"fill: {ways}")


def check_figure5(figure):
    """The selected caster is between 3.9 and 4.5, the table at 1.5, the highest receiver below at
    0.5; slabs are a little wider."""
    pieces = {name: entry["pieces"] for name, entry in figure.items()}

    def is_near(name, *expected):
        return len(pieces[name]) == len(expected) and all(
            abs(a - b) < 0.1 for piece, range in zip(pieces[name], expected)
            for a, b in zip(piece, range))
    check(is_near("a", (0, 4.5)) and is_near("b", (0, 0.5)) and is_near("c", (3.9, 4.5)) and
          is_near("d") and is_near("e", (0, 4.5)) and is_near("e, nearest", (1.5, 4.5)) and
          is_near("e, slabs", (3.9, 4.5), (1.4, 1.5), (0, 0.5)), f"figure 5: {pieces}")


def check_settings(name, scene):
    """The modes of all values were measured, and the default is among the values."""
    tried = scene["tried"]
    for one in tried:
        time = scene["modes"][one["mode"]]["median_ms"]
        check(time > 0, f"{one['mode']}: {time} ms")
    settings = {(one["kind"], one["setting"]) for one in tried}
    defaults = [(one["kind"], one["setting"]) for one in tried if one["mode"] == one["kind"]]
    check(sorted(settings) == sorted(defaults), f"{name}: defaults of {defaults} among {settings}")


def check_depth(study):
    """No visible box is hidden in any format; more bits, and floats near 0, distinguish more."""
    for entry in study["formats"]["entries"]:
        check("skipped" in entry or entry["false_hidden"] == 0,
              f"{entry['format']}: {entry.get('false_hidden')} visible ones hidden")
    drawn = {entry["format"]: entry for entry in study["depth"]
             if entry["near"] == 1 and "skipped" not in entry}
    orders = [("16 bits", "24 bits"), ("16 bits W", "24 bits W")]
    if "float reversed" in drawn:
        orders.append(("24 bits", "float reversed"))
    for coarse, fine in orders:
        far, near = ([point for point in drawn[name]["resolution"] if point["distance"] == 100][0]
                     for name in (coarse, fine))
        check(far["worst"] > near["worst"], f"{coarse} is finer than {fine} at 100")
        wrong = [sum(point["wrong"] for point in drawn[name]["fights"]) for name in (coarse, fine)]
        check(wrong[0] > wrong[1], f"{coarse} has {wrong[0]} wrong pixels, {fine} {wrong[1]}")
    # A depth of the shader's own has no offset.
    moved = {name: drawn[name]["offsets"][0]["moved_by_one"] for name in ("16 bits", "16 bits W")}
    check(moved == {"16 bits": 1, "16 bits W": 0}, f"pixels that an offset moves: {moved}")


def check_figures(study):
    check(len(study["scenes"]) == 3, f"{len(study['scenes'])} scenes instead of three paths")
    for index, scene in enumerate(study["scenes"]):
        check_scene(f"scene {index}", scene)
    check_depth(study)
    rows = len(study["device"][0]["rows"])
    eyes = len(study["device"][0]["eyes"])
    check(rows >= 15 and eyes == 21, f"{rows} rows of what the device does, {eyes} of two eyes")
    early = study["early"][0]
    shaded, shown = (early["fragments"]["early-depth-nbuffer"][key] for key in ("passed", "shown"))
    check(early["differing_bytes"] == 0 and shown <= shaded <= 1.01 * shown,
          f"early depth: {early['differing_bytes']} wrong bytes, {shaded} fragments of {shown}")
    tests = study["table2"]["tests"]
    check(tests["nb"] < tests["oq"],
          f"{tests['nb']} lookups, {tests['oq']} pixels: four lookups a box have to be fewer")
    for entry in study["particles"]:
        name = f"{entry['kind']}, {'the' if entry['occluders'] else 'no'} scene before them"
        count, tests = entry["particles"], entry["tests"]
        check(entry["wrongly_rejected"] == 0 and entry["changed"] == 0, f"{name}: wrong verdicts")
        # What is drawn in front of nothing is seen; in a street most particles are not.
        check(entry["rejected"] <= entry["hidden"] and
              (entry["rejected"] > count / 4) == entry["occluders"],
              f"{name}: {entry['rejected']} of {entry['hidden']} hidden ones rejected")
        check(count <= tests["maxima"] <= 4 * count < tests["drawn"], f"{name}: {tests}")
        check(entry["kind"] == "boxes" or tests["maxima"] == count,
              f"{name}: {tests['maxima']} lookups instead of one each")
    check(len(study["particles"]) == 4, "particles: two kinds before and without a scene")
    settings = study["settings"]
    # Of one frame of a city and one of loose parts, and of settings.
    check(len(study["shadows"]) == 2, f"{len(study['shadows'])} scenes with shadows, not two")
    for scene in (*study["shadows"], settings["shadows"][0]):
        check_shadows("shadows", scene)
    for scene in study["maps"]:
        check_maps(scene)
    check_fill(study["fill"][0])
    check_figure5(study["figure5"])
    for part in ("culler", "still", "shadows"):
        check_settings(part, settings[part][0])
    entry = settings["few"][0]["entries"][0]
    drawn = entry["modes"]["nbuffer:MinimumNumberOfCandidates=1"]["drawn"]
    wrong = settings["culler"][0]["differing_bytes"] + entry["differing_bytes"]
    check(wrong == 0 and 1 <= drawn <= 8, f"settings: {wrong} wrong bytes, {drawn} drawn of 8 props")


def check_report(study):
    (OUT / "docs").mkdir()
    for name in DOCUMENTS:
        shutil.copy(SOURCE / "docs" / f"{name}.md", OUT / "docs")
    run("report.py", "study", OUT / "study.json", "--docs", OUT / "docs",
        "--charts", OUT / "charts", "--csv", OUT / "csv")
    for name in DOCUMENTS:
        made = (OUT / "docs" / f"{name}.md").read_text()
        committed = (SOURCE / "docs" / f"{name}.md").read_text()
        check(made != committed and "\n@" not in made and "| nan |" not in made,
              f"{name}.md lacks the figures of this study")
    lines = (OUT / "csv" / "structures.csv").read_text().splitlines()
    structures = sum(len(scene["structures"]) for scene in study["scenes"])
    check(len(lines) == 1 + structures, f"structures.csv has {len(lines)} lines of {structures}")
    for beginning in CHARTS:
        check(any((OUT / "charts").glob(f"{beginning}*.png")), f"no chart {beginning}*")
    for name in ("shadows", "settings"):
        check((OUT / "csv" / f"{name}.csv").exists(), f"{name}.csv is missing")


shutil.rmtree(OUT, ignore_errors=True)
run("study.py", "--tiny", "--size", "161x119", "--out", OUT, "--bench", BENCH)
STUDY = json.loads((OUT / "study.json").read_text())
check_figures(STUDY)
if all(importlib.util.find_spec(name) for name in ("pandas", "matplotlib")):
    check_report(STUDY)
else:
    print("pandas or matplotlib is missing: tables and charts are not made")
