# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs programs of the examples as users start them, and checks what they draw and print.

    check_programs.py <test> <folder to write to> <program> [what else the test needs]

A test is a function of this file without "test_", with dashes. Where a window needs a display that is
missing, it prints "Skipped: " and the reason.
"""
import json
import os
import pathlib
import re
import shutil
import sys

from running import check, run, skip_without_display

OUT, PROGRAM = pathlib.Path(sys.argv[2]), sys.argv[3]
BASELINES = pathlib.Path(__file__).parents[1] / "Baselines"


def run_quietly(*arguments):
    """What the program prints to stdout; it prints nothing to stderr."""
    printed, errors = run(PROGRAM, *arguments)
    print(printed)
    check(errors == "", f"{arguments}: {errors}")
    return printed


def draw_with_and_without(option, *arguments):
    """What the program prints, and the folder of its picture, as users start it and with an option
    that switches off what it shows."""
    results = []
    for folder, options in ((OUT / "with", ()), (OUT / "without", (option,))):
        results.append((run_quietly("--out", folder, "--size", "320x240", *arguments, *options), folder))
    return results


def measure(arguments, *more):
    """The figures of a run of nbuffer-bench."""
    file = OUT / "figures.json"
    print(*run(PROGRAM, *arguments.split(), *more, "--json", file))
    return json.loads(file.read_text())


def test_shadows(picture, compare):
    """The picture with shadows is like the baseline, and that without them is not."""
    pictures = [folder / f"{picture}.png" for _, folder in draw_with_and_without("--no-shadows")]
    print(*run(compare, BASELINES / f"{picture}.png", *pictures))


def check_same_picture(name, drawn):
    pictures = [(folder / f"{name}.png").read_bytes() for _, folder in drawn]
    check(pictures[0] == pictures[1], "the culler changes the picture")


def test_cull_city():
    """The culler leaves props out, and the picture is the same."""
    drawn = draw_with_and_without("--no-culler")
    (with_culler, hidden), (without, _) = (
        map(int, re.search(r"(\d+) of 15860 props drawn, (\d+) found hidden", printed).groups())
        for printed, _ in drawn)
    check(with_culler < without and hidden > 0,
          f"{with_culler} props drawn with the culler, {without} without it, {hidden} hidden")
    check_same_picture("cull-city", drawn)


def test_minimal():
    """Of the first example, which is run as the README shows it, most is hidden."""
    printed = run_quietly()
    check(re.fullmatch(r"[1-9]\d* of 10000 cones drawn, [1-9]\d* hidden\n", printed), printed)


def test_units(picture):
    """Units of one large prop are hidden in every frame, and no byte of the image differs."""
    drawn = draw_with_and_without("--no-culler", "--frames", 3)
    frames = len(re.findall(r"units drawn, [1-9]\d* hidden", drawn[0][0]))
    check(frames == 3, f"units are hidden in {frames} of 3 frames")
    for printed, folder in drawn:
        check("; 0 bytes differ\n" in printed, f"{folder.name} the culler: {printed}")
        check(("with the culler" in printed) == (folder.name == "with"), f"{folder.name}: {printed}")
    check_same_picture(picture, drawn)


def test_shadow_aim(scene):
    """Fragments of shadow volumes, counted as docs/benchmarks.md does: the mode exact has at most so
    many % of those of whole volumes, and not fewer than the pixels that shadows change."""
    most = {"city-sun": 2, "city-spot": 4, "birds": 10.5, "simple": 27}[scene]
    figures = measure(f"shadow --scene {scene} --frames 16 --block 2 --modes unclamped,exact")
    exact, shadowed = figures["modes"]["exact"], figures["shadowed"]
    check(exact["fragments_percent"] <= most,
          f"exact has {exact['fragments_percent']} % of the fragments; {most} % are allowed")
    check(0 < shadowed <= exact["fragments"],
          f"{exact['fragments']} fragments for {shadowed} pixels that shadows change")


def test_shadow_maps():
    """Settings of VTK's shadow maps do what they are for: a small exponent loses shadows, a polygon
    offset takes acne away, and a map that is drawn for each frame is the same map. Without a setting
    for the exponent (VTK 9.1) only the last one is tested, and that an offset changes something."""
    modes = {"plain": "vtk@256", "small": "vtk@256:Exponent=2", "large": "vtk@256:Exponent=80",
             "offset": "vtk@256:Exponent=80:OffsetFactor=4", "again": "vtk@256:EachFrame=1"}
    has_exponent = "Exponent" in json.loads(run(PROGRAM, "defaults")[0]).get("maps", {})
    if not has_exponent:
        modes.update(small=modes["plain"], large=modes["plain"], offset="vtk@256:OffsetFactor=4")
    figures = measure("shadow --scene birds --size 161x161 --frames 2 --oracle --oracle-once",
                      "--modes", ",".join(["none", *modes.values()]))
    oracles = {name: figures["modes"][mode]["oracle"] for name, mode in modes.items()}
    errors = {name: oracle["errors"] for name, oracle in oracles.items()}
    for name, oracle in oracles.items():
        total = sum(errors[name][kind] for kind in ("outline", "acne", "peter_panning", "leak"))
        check(total == oracle["wrong"], f"{name}: {oracle['wrong']} wrong samples, and {errors[name]}")
    lost = {name: error["peter_panning"] + error["leak"] for name, error in errors.items()}
    check(errors["offset"] != errors["large"] and errors["again"] == errors["plain"], errors)
    check(not has_exponent or (lost["small"] > lost["plain"] and
                               errors["offset"]["acne"] < errors["large"]["acne"]), errors)


def test_walk_counts():
    """How many frames of a walk are not timed, with and without --warm-up; how many props are in view
    of the path aside; what is drawn depth first."""
    def walk(arguments):
        return measure(f"walk --size 161x119 --verify {arguments}")

    # One frame to begin with and one before each of the two blocks; then seven, which go forth and
    # back along the path of three frames.
    for expected, option in ((3, ""), (9, "--warm-up 7")):
        figures = walk(f"--scene plant --path inside --frames 3 --block 2 "
                       f"--modes stock,nbuffer,oracle,none {option}")
        for name in ("stock", "nbuffer", "oracle", "none"):
            mode = figures["modes"][name]
            untimed, timed = mode["untimed_frames"], len(mode["frames_ms"])
            check((untimed, timed) == (expected, 3),
                  f"{name}: {untimed} frames untimed instead of {expected}, {timed} timed")

    figures = walk("--scene plant --path aside --props 10000 --frames 4 "
                   "--modes stock,nbuffer,in-view,oracle,none")
    check(figures["props"] == 10000, f"{figures['props']} props")
    names = ("stock", "nbuffer", "in-view", "oracle")
    frames = [figures["modes"][name]["frames_drawn"] for name in names]
    for stock, nbuffer, in_view, oracle in zip(*frames, strict=True):
        # The default culler tests bounding spheres, which are in view where boxes are not.
        check(1 <= nbuffer <= 5 and oracle <= nbuffer and in_view == stock <= 100,
              f"stock draws {stock}, nbuffer {nbuffer}, in-view {in_view}, oracle {oracle}")

    # Depth first: what stock draws is drawn once for its depth, and with colours about once for each
    # pixel that shows a prop; the culler culls in this pass, too. Props of the plant share mappers.
    figures = walk("--scene city --path street --frames 3 --fragments 1 "
                   "--modes stock,nbuffer,early-depth,early-depth-nbuffer,none")
    fragments, modes = figures["fragments"], figures["modes"]
    for mode, early in (("stock", "early-depth"), ("nbuffer", "early-depth-nbuffer")):
        depth, colors, shown = (fragments[early][key] for key in ("of_depth", "passed", "shown"))
        # Equal depths alone are drawn with colours more than once.
        most = int(shown) + int(shown) // 100 + 1
        check(shown <= colors <= min(most, depth) and colors < fragments[mode]["passed"],
              f"{early}: {depth} fragments for depth, {colors} with colours of {shown} pixels, "
              f"{fragments[mode]['passed']} in mode {mode}")
    check(fragments["early-depth"]["of_depth"] == fragments["stock"]["passed"],
          f"{fragments['early-depth']} fragments instead of {fragments['stock']}")
    drawn = [modes[name]["drawn"] for name in ("stock", "early-depth", "early-depth-nbuffer")]
    check(drawn[0] == drawn[1] > drawn[2], f"{drawn} props drawn by stock, depth first, and culled")


def test_false_visible():
    """How many of the hidden props of the city are drawn all the same. These are counts of props,
    which do not vary with the load of the machine; the culler's setting that measures time is off.
    Props that are drawn for the sake of slivers count, except where it says TestSlivers=0."""
    for path, settings, most in (("street", "BackOff=0:TestSlivers=0", 10), ("street", "BackOff=0", 16),
                                 ("rooftop", "BackOff=0", 200)):
        names = ("in-view", f"nbuffer:{settings}", "oracle")
        modes = measure(f"walk --path {path} --frames 3 --size 480x360",
                        "--modes", ",".join(names))["modes"]
        in_view, drawn, seen = (sum(modes[name]["frames_drawn"]) for name in names)
        hidden, kept = in_view - seen, drawn - seen
        share = 10000 * kept // hidden
        print(f"{path}, {settings}: {kept} of {hidden} hidden props drawn, {share} of 10,000")
        check(kept >= 0 and hidden >= 5000 and share <= most,
              f"{path}: at most {most} of 10,000 hidden props may be drawn")


def test_paper_scenes():
    """What section 3.1 of the N-buffer paper says: a sphere in a slightly larger one is not found by
    its box (but by its triangles), and what small leaves hide together is found by either."""
    by_boxes, by_triangles = "nbuffer:TestPixels=0:TestTriangles=0:BackOff=0", "nbuffer:BackOff=0"
    for scene, fewest_boxes, most_boxes, most_triangles in (("shells", 128, 128, 66),
                                                            ("leaves", 0, 96, 96)):
        modes = measure(f"walk --scene {scene} --frames 4 --warm-up 2 --size 320x240 "
                        f"--modes {by_boxes},{by_triangles}")["modes"]
        boxes, triangles = (modes[name]["frames_drawn"][3] for name in (by_boxes, by_triangles))
        print(f"{scene}: {boxes} drawn by boxes, {triangles} by triangles")
        check(fewest_boxes <= boxes <= most_boxes and triangles <= most_triangles,
              f"{scene}: the paper, or the documents, say otherwise")


def test_ranks():
    """What 1, 16 and 1,000 simulated ranks draw of the city in the street. The picture is small, and
    so are its tiles."""
    figures = measure("ranks --ranks 1,16,1000 --size 161x119 --tile 2")
    shared, oracle = {}, figures["own_a_pixel"]
    for ranks in (1, 16, 1000):
        entry = figures["ranks"][str(ranks)]
        shared[ranks] = entry["drawn_shared"]
        # A message has 4 bytes for each of 81 x 60 tiles, 12 for each rank, and 176 more.
        expected = 4 * 81 * 60 + 12 * ranks + 176 if ranks > 1 else 0
        check(entry["visible_hidden"] == 0 and entry["bytes"] == expected and entry["idle"] < ranks and
              entry["busiest"] <= shared[ranks] <= entry["drawn_local"],
              f"{ranks} ranks, of which a message has {expected} bytes: {entry}")
    check(oracle >= 10 and shared[1000] <= 13 * oracle // 10 and shared[16] <= 15 * shared[1] // 10,
          f"{oracle} props own a pixel; ranks draw {shared}")


def test_board():
    """A board and a cage of boards with two parts of one model, written here; one part without a
    model."""
    models = OUT / "kicad-3dmodels"
    (models / "T.3dshapes").mkdir(parents=True)
    shapes = "".join(f"""
Shape {{ appearance Appearance {{ material Material {{ diffuseColor {color} }} }}
  geometry IndexedFaceSet {{ coord Coordinate {{ point [ {x} 0 0, {x + 1} 0 0, {x} 1 0, {x} 0 1 ] }}
    coordIndex [ 0,2,1,-1, 0,1,3,-1, 0,3,2,-1, 1,2,3,-1 ] }} }}""" for color, x in (("0.9 0.5 0.2", 0),
                                                                               ("0.2 0.5 0.9", 2)))
    (models / "T.3dshapes" / "T.wrl").write_text(f"#VRML V2.0 utf8{shapes}\n")
    model = ('(model "${KICAD6_3DMODEL_DIR}/T.3dshapes/T.wrl" (offset (xyz 0 0 0)) '
             "(scale (xyz 1 1 1)) (rotate (xyz 0 0 0)))")
    board = OUT / "board.kicad_pcb"
    board.write_text(f"""(kicad_pcb (version 20211014) (general (thickness 1.6))
  (footprint "T" (layer "F.Cu") (at 10 10 90) {model})
  (footprint "T" (layer "B.Cu") (at 30 20) {model})
  (footprint "N" (layer "F.Cu") (at 30 20) (model "${{KICAD6_3DMODEL_DIR}}/no.wrl"))
  (gr_line (start 0 0) (end 50 40) (layer "Edge.Cuts")))
""")
    # Of a board two shapes of two parts and itself; of a cage two parts, or their shapes, and the
    # board, 80 times.
    for scene, path, props in (("board.kicad_pcb", "over", 5), (".", "outside", 240),
                               (".", "between", 240), (".:actors", "outside", 400)):
        figures = measure(f"walk --path {path} --frames 3 --size 161x119 --verify",
                          "--scene", f"{OUT}/{scene}")
        check(figures["props"] == props, f"{scene}: {figures['props']} props instead of {props}")

    shutil.rmtree(models)
    os.environ.pop("KICAD6_3DMODEL_DIR", None)
    _, errors = run(PROGRAM, "walk", "--scene", board, "--frames", 1, status=1)
    check("none of the models of its parts was found" in errors, f"without models: {errors}")


def test_map(writer):
    """The study of a map: its table of visibility agrees with what is seen, and a table that does not
    is found out. A map that is damaged is an error that says so."""
    def study(scene, status):
        done = run(PROGRAM, *"study --tiny --frames 6 --size 161x119".split(), "--scene", OUT / scene,
                   "--out", OUT / "study", "--json", OUT / "study.json", status=status)
        print(*done)
        return "".join(done)

    def read_table():
        return json.loads((OUT / "study.json").read_text())["scenes"][0]["table"]

    run(writer, OUT / "true.bsp")
    study("true.bsp:faces", 0)
    table = read_table()
    check(table["contradictions"] == 0 and table["pixels"] > 0 and table["undrawn_pixels"] > 0, table)
    study("true.bsp:clusters", 0)

    run(writer, OUT / "lie.bsp", "lie")
    study("lie.bsp", 2)
    check(read_table()["contradictions"] > 0, "a table that hides what is seen was believed")

    (OUT / "cut.bsp").write_text("IBSP.")
    printed = study("cut.bsp", 1)
    check("cut.bsp: damaged map: its directory ends after the file does" in printed,
          "the message does not say what is wrong")


skip_without_display()
shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)
globals()["test_" + sys.argv[1].replace("-", "_")](*sys.argv[4:])
