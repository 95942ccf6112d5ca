# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The runs of nbuffer-bench for the tables of docs/benchmarks.md.

RUNS has the runs of each table in the order of its rows. The words of a row may be followed by goals:
for stock / nbuffer at least, and for nbuffer / oracle at most.
"""

import collections
import json
import pathlib
import random

Run = collections.namedtuple("Run", "label arguments goals")


def run(label, arguments, *goals):
    return Run(label, arguments.split(), goals)


# Where modes have turns. STOCK begins in a new window; SETTLED when the culler knows what does not change.
STOCK = "walk --frames 60 --verify --modes stock,nbuffer,oracle"
SETTLED = "walk --frames 30 --warm-up 300 --modes nbuffer,oracle"
SETTLED_SOONER = "walk --frames 30 --warm-up 150 --modes nbuffer,oracle"
ONE_PROP = "walk --frames 20 --warm-up 25 --block 10 --modes"
WITH_ORACLE = f"{ONE_PROP} stock,nbuffer,oracle"
FIRST_FRAMES = "walk --first-frames 5 --frames 14 --modes stock,nbuffer"
LISTS = "walk --modes nbuffer:HierarchySize=10000000,nbuffer"
SHADOWS = "shadow --block 2 --scene"
LAMPS = "shadow --scene city-spot --frames 10 --modes unclamped,auto,exact"
CHOSEN_LAMPS = ("25,-25,120,20", "25,25,120,20", "-25,25,120,20", "-25,-25,120,20", "25,-25,120,6",
                "25,-25,60,40", "0,0,9,60", "3,3,9,75", "10,-10,20,60")


def random_lamps():
    """Nobody had seen these before their first results were recorded."""
    uniform = random.Random(2005).uniform
    return [f"{uniform(-60, 60):.1f},{uniform(-60, 60):.1f},{uniform(8, 150):.1f},{uniform(6, 80):.1f}"
            for _ in range(8)]


# SCENES/ stands for the folder of the scenes that make-scenes.sh builds.
RUNS = {
    "settled": [
        run("street", f"{SETTLED} --path street", None, 1.3),
        run("rooftop", f"{SETTLED} --path rooftop", None, 1.5),
        run("drone", f"{SETTLED} --path drone", None, 1.3),
        run("cuts", f"{SETTLED} --path cuts", None, 2),
        run("oa_thor.bsp by faces", f"{SETTLED_SOONER} --scene SCENES/oa_thor.bsp:faces", None, 1.6),
        run("plant, inside", f"{SETTLED_SOONER} --scene plant --path inside", None, 1.2),
        run("plant, around", f"{SETTLED_SOONER} --scene plant --path around", None, 1.2),
        run("a board, over", f"{SETTLED_SOONER} --path over --scene "
            "SCENES/kicad/boards/kit-dev-coldfire-xilinx_5213.kicad_pcb"),
        run("aside: at most 5 of 10,000 props", f"{SETTLED_SOONER} --scene plant --props 10000 --path aside")],
    "seeds": [run(f"rooftop, seed {seed}", f"{SETTLED_SOONER} --path rooftop --seed {seed}", None, 1.5)
              for seed in (2, 3, 4, 5)],
    "inside": [
        run("`glyph-wall`, 200,000 cubes behind a wall", f"{WITH_ORACLE} --scene glyph-wall", 45, 1.5),
        run("`glyph-cloud`, 200,000 cubes", f"{WITH_ORACLE} --scene glyph-cloud", 9, 1.4),
        run("`glyph-cloud`, cuts", f"{WITH_ORACLE} --scene glyph-cloud --path cuts"),
        run("`points-wall`, 1,000,000 points", f"{WITH_ORACLE} --scene points-wall", 28, 1.4),
        run("`points-terrain`, 1,000,000 points", f"{WITH_ORACLE} --scene points-terrain"),
        run("city, one mesh, street", f"{WITH_ORACLE} --merge polydata", 1.9, 1.25),
        run("city, one mesh, cuts", f"{WITH_ORACLE} --merge polydata --path cuts"),
        run("city, composite data, street", f"{ONE_PROP} stock,nbuffer,same-list --merge composite",
            1.7, 1.15),
        run("city, composite data, rooftop",
            f"{ONE_PROP} stock,nbuffer,same-list --merge composite --path rooftop"),
        run("`isosurface`, outside", f"{WITH_ORACLE} --scene isosurface --path outside", 1.8, 1.25),
        run("`isosurface`, outside, shuffled",
            f"{WITH_ORACLE} --scene isosurface --path outside --shuffle", 1.8, 1.25),
        run("`isosurface`, inside", f"{WITH_ORACLE} --scene isosurface --path inside", 6, 1.3),
        run("`isosurface`, cuts", f"{WITH_ORACLE} --scene isosurface --path cuts"),
        run("`terrain`, at eye height", f"{WITH_ORACLE} --scene terrain", 1.5, 1.2),
        run("nothing hidden: `glyph-open`",
            f"{ONE_PROP} stock,nbuffer --scene glyph-open --instances 50000", 0.98),
        run("nothing hidden: `terrain`, above",
            f"{ONE_PROP} stock,nbuffer --scene terrain --path above", 0.98)],
    "walks": [
        run("street", f"{STOCK} --path street"), run("rooftop", f"{STOCK} --path rooftop"),
        run("drone", f"{STOCK} --path drone"), run("cuts", f"{STOCK} --path cuts"),
        run("motorBike, orbit", f"{STOCK} --scene SCENES/motorBike.obj.gz")],
    "edges": [
        run("15,860 props", f"{STOCK} --edges"),
        run("one mesh", f"{WITH_ORACLE} --edges --merge polydata")],
    "first": [run(mode, f"first --mode {mode}") for mode in ("stock", "nbuffer") * 3],
    "device": [run(path, f"{SETTLED} --backend opengl --path {path}")
               for path in ("street", "rooftop", "drone", "cuts")],
    "shadows": [
        run(scene, f"{SHADOWS} {scene} --frames 16 --oracle --modes "
            "none,unclamped,cull,exact,clamp,slabs,auto,paper,vtk")
        for scene in ("city-sun", "city-spot", "birds", "simple")],
    "no_culler": [
        run(scene, f"{SHADOWS} {scene} --frames 10 --no-culler --modes none,unclamped,exact,auto,vtk")
        for scene in ("city-sun", "city-spot")],
    "choices": [
        run(f"{scene}, {size}", f"{SHADOWS} {scene} --frames 16 --size {size} --modes exact,auto,unclamped")
        for scene in ("birds", "simple") for size in ("640x480", "960x720")],
    "ground": [
        run(scene, f"{SHADOWS} {scene} --frames 3 --ground-caster --modes none,unclamped,exact,auto")
        for scene in ("city-sun", "city-spot", "birds", "simple")],
    "swarm": [
        run("swarm: 10,000 instances", f"{SHADOWS} swarm --frames 6 --modes none,unclamped,exact,auto"),
        run("city-sun: 15,860 blocks", f"{SHADOWS} city-sun --frames 6 --merge composite --ground-caster "
            "--modes none,unclamped,exact,auto")],
    "lamps": [run(f"{kind}: {lamp}", f"{LAMPS} --lamp={lamp}") for kind, lamps in (
        ("chosen", CHOSEN_LAMPS), ("random", random_lamps())) for lamp in lamps],
    "lists": [
        *(run(path, f"{LISTS} --frames 30 --path {path} --props {props}")
          for path in ("street", "rooftop") for props in (15860, 30000, 100000, 300000)),
        run("street", f"{LISTS} --frames 15 --props 1000000")],
    "first_frames": [
        run("`glyph-open`", f"{FIRST_FRAMES} --scene glyph-open --instances 50000"),
        run("`terrain`, above", f"{FIRST_FRAMES} --scene terrain --path above"),
        run("`terrain`, at eye height", f"{FIRST_FRAMES} --scene terrain")]}


def measure(bench, scenes, file, tiny):
    """The reports of all runs, by table. `bench` runs nbuffer-bench with arguments and returns its report.

    Tables that the file has already are not measured again, so that a run that was stopped can be
    continued. Runs whose scenes are missing are left out. If `tiny`, only the first run of a table is
    made, with few frames.
    """
    reports = json.loads(file.read_text()) if file.exists() else {}
    for table, runs in RUNS.items():
        if table in reports:
            continue
        entries = []
        for label, arguments, goals in runs[:1] if tiny else runs:
            arguments = [word.replace("SCENES", str(scenes)) for word in arguments]
            files = [word.split(":")[0] for word in arguments if str(scenes) in word]
            if not all(pathlib.Path(name).exists() for name in files):
                continue
            if tiny and "--first-frames" not in arguments:
                arguments = [shorter(name, word) for name, word in zip(["", *arguments], arguments)]
            entries.append({**bench(*arguments), "label": label, "goals": list(goals)})
        reports[table] = entries
        file.write_text(json.dumps(reports))
    return reports


def shorter(name, word):
    return "2" if name in ("--frames", "--warm-up", "--block") else word
