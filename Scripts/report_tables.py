# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the documents, and the figures that follow from what nbuffer-bench measured.

Each table is a function of the report and of the argument behind its name in the document.
"""

import math

import pandas as pd

PEERS = ["stock", "nbuffer", "queries", "queries-conservative", "chc", "oracle"]


class NotMeasured(Exception):
    """The figures of a table are not in the files."""


# Numbers and Markdown.


def number(value):
    """Three digits, thousands apart; nothing for no value."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return ""
    size = abs(value)
    digits = 0 if size >= 100 or round(value) == value else 1 if size >= 10 else 2
    return f"{value:,.{digits}f}"


def span(times):
    return "" if times is None else (
        f"{number(times['median'])} ({number(times['p10'])} to {number(times['p90'])})")


def times_of(mode):
    """The summary of a mode's times as `median`, `p10` and `p90`."""
    return {name: mode[name + "_ms"] for name in ("median", "p10", "p90")}


def median_of(times):
    return times["median"] if times else None


def table(head, rows):
    rows = list(rows)
    if not rows:
        raise NotMeasured
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(
        cell if isinstance(cell, str) else number(cell) for cell in line) + " |\n" for line in lines)


def title(scene):
    """Paths of the city have no other name."""
    return scene["path"] if scene["scene"] == "city" else f"{scene['scene']} {scene['path']}"


def find(entries, name):
    for entry in entries or []:
        if name in (title(entry), entry["scene"]):
            return entry
    raise NotMeasured


def ratio(report, a, b):
    """The median over the frames of (time of a) / (time of b)."""
    frames = pd.DataFrame({name: report["modes"][name]["frames_ms"] for name in {a, b}})
    return float((frames[a] / frames[b]).median())


# Figures that follow from the measured ones.


def group_of(name):
    for group in ("culler", "outline", "table"):
        if name.startswith(group):
            return group
    return ("positions" if "positions" in name else "one level" if name.startswith("one level")
            else "mips" if "mips" in name else "rectangles" if name.startswith("rect")
            else "strided" if " s=" in name
            else "one square" if "x1 " in name else "four squares")


def mark_pareto(points, time, error):
    """Marks the points than which no other one is faster and has less error."""
    order = points.sort_values(time, kind="stable")
    least = order[error].cummin().shift(fill_value=math.inf)
    points["pareto"] = (order[error] < least).reindex(points.index)
    return points


def cost_of_a_prop(walk):
    """Microseconds that drawing one more of the props in view takes; nan without a mode in-view."""
    if "in-view" not in walk["modes"]:
        return math.nan
    in_view, oracle = walk["modes"]["in-view"], walk["modes"]["oracle"]
    props = in_view["drawn"] - oracle["drawn"]
    return 1e3 * (in_view["median_ms"] - oracle["median_ms"]) / props if props > 0 else 0.0


def structures(scene):
    """The depth structures of a scene as a table of pandas."""
    points = pd.json_normalize(scene["structures"])
    points["group"] = points["name"].map(group_of)
    points["kept"] = 100.0 * points["false_visible"] / points["hidden"].clip(lower=1)
    covered = points["covered_area"] > 0
    points["over"] = (100.0 * (points["covered_area"] / points["area"] - 1.0)).where(covered)
    kept = 0.01 * points["kept"] * scene["hidden"]
    points["loss"] = points["total_ms.median"] + 1e-3 * kept * cost_of_a_prop(scene["walk"])
    return mark_pareto(points, "total_ms.median", "kept")


def shadow_points(scene):
    points = pd.DataFrame([
        {"name": name, "kind": name.split("@")[0], **times_of(mode),
         "percent": mode.get("fragments_percent", math.nan), "fragments": mode.get("fragments"),
         "exact": mode["must_be_exact"], **mode["oracle"]}
        for name, mode in scene["modes"].items() if name != "none"])
    points["wrong_percent"] = 100.0 * points["wrong"] / points["samples"].clip(lower=1)
    points["is_default"] = points["name"] == scene["default"]
    # Nothing that is right is faster and covers less.
    points["right"] = points["percent"].where(points["wrong"] == 0).fillna(math.inf)
    return mark_pareto(points, "median", "right")


def shadowed_percent(scene):
    """Pixels that shadows change, in percent of the fragments of whole volumes."""
    return 100.0 * scene["shadowed"] / max(scene["modes"]["unclamped"]["fragments"], 1)


def setting_points(scene, of_shadows):
    """What was tried of each setting: its time, its ratio to the default, and its error."""
    points = []
    for entry in scene["tried"]:
        mode = scene["modes"][entry["mode"]]
        point = {**entry, **times_of(mode), "ratio": ratio(scene, entry["mode"], entry["kind"]),
                 "is_default": entry["mode"] == entry["kind"], "error": math.nan,
                 "usual": entry["kind"] in ("nbuffer", "auto")}
        if of_shadows:
            point["error"] = mode["fragments_percent"]
        elif "oracle" in scene["modes"]:
            seen, drawn, stock = (sum(scene["modes"][name]["frames_drawn"])
                                  for name in ("oracle", entry["mode"], "stock"))
            point["error"] = 100.0 * (drawn - seen) / (stock - seen) if stock > seen else 0.0
        points.append(point)
    return pd.DataFrame(points)


def setting_scenes(report):
    settings = report.get("settings") or {}
    for part in ("culler", "still", "shadows"):
        for scene in settings.get(part) or []:
            yield part, scene, setting_points(scene, part == "shadows")


# Tables. Each has a function of the report and the argument that follows its name.

POINT_HEAD = ["", "structure", "hidden props kept, %", "covered too much, %", "build ms", "query ms",
              "both: p10 to p90", "lookups", "MB", "loss ms"]


def point_row(place, point):
    return [place, point["name"] + (" (default)" if point["is_default"] else ""), point["kept"],
            point["over"], point["build_ms.median"], point["query_ms.median"],
            f"{number(point['total_ms.p10'])} to {number(point['total_ms.p90'])}", point["lookups"],
            1e-6 * point["bytes"], point["loss"]]


def recorded(report, parts):
    """At which commit, and where, these parts of the study were measured."""
    found = [(report.get("recorded") or {}).get(part) for part in parts.split()]
    if None in found:
        raise NotMeasured
    return f"Recorded at {', and '.join(sorted(set(found)))}.\n"


def pareto(report, path):
    scene = find(report.get("scenes"), path)
    points = structures(scene).sort_values("total_ms.median", kind="stable")
    rows, place = [], 0
    for _, point in points.iterrows():
        if point["pareto"]:
            place += 1
            rows.append(point_row(str(place), point))
        elif point["is_default"]:
            rows.append(point_row("", point))
    return (f"{number(scene['in_view'])} props in view, {number(scene['hidden'])} of them hidden "
            f"(means over {scene['frames']} frames); {len(points)} structures.\n\n"
            + table(POINT_HEAD, rows))


def best(report, path):
    points = structures(find(report.get("scenes"), path)).sort_values("loss", kind="stable")
    return table(POINT_HEAD, (
        point_row(f"{place}.", point) for place, (_, point) in enumerate(points.iterrows(), 1)
        if place <= 6 or point["is_default"]))


def chain(report, path):
    points = structures(find(report.get("scenes"), path)).set_index("name", drop=False)
    names = ["one level 1/4", "one level 1/8", "one level 1/16", "mips 2x2 1/4", "fat mips 2x2 1/4",
             "mips 4x4 1/4", "fat mips 4x4 1/4", "squares x1 1/4", "squares s=2 x4 1/4",
             "squares x4 1/4", "squares x4 1/8", "squares x4 1/16"]
    return table(POINT_HEAD, (
        point_row("", points.loc[name]) for name in names if name in points.index))


def frames(report, _):
    def row(scene):
        walk = scene["walk"]
        stock, nbuffer, oracle = (walk["modes"][name] for name in ("stock", "nbuffer", "oracle"))
        return [title(scene), stock["median_ms"], nbuffer["median_ms"], oracle["median_ms"],
                " / ".join(number(mode["drawn"]) for mode in (stock, nbuffer, oracle)),
                ratio(walk, "stock", "nbuffer"), ratio(walk, "nbuffer", "oracle"),
                cost_of_a_prop(walk)]
    return table(["path", "stock ms", "nbuffer ms", "oracle ms", "drawn: stock / nbuffer / oracle",
                  "stock / nbuffer", "nbuffer / oracle", "a prop more, µs"],
                 map(row, report.get("scenes") or []))


def peers(report, _):
    rows, skipped = [], {}
    for scene in report.get("scenes") or []:
        modes = scene["walk"]["modes"]
        if not {"queries", "chc"} & set(modes):
            continue  # The table of whole frames has it.
        seen = modes["oracle"]["drawn"]
        hidden = modes["stock"]["drawn"] - seen
        for name in filter(modes.__contains__, PEERS):
            mode, asked = modes[name], modes[name].get("queries") or {}
            rows.append([
                title(scene), name, span(times_of(mode)), mode["drawn"],
                100.0 * (mode["drawn"] - seen) / hidden if hidden > 0 else 0.0,
                *(asked.get(key) for key in ("queries", "waits", "wait_ms", "redrawn")),
                mode["differing_bytes"]])
        skipped = scene["walk"]["skipped"]
    return table(["path", "mode", "ms (p10 to p90)", "props drawn", "hidden props kept, %",
                  "queries", "waited for", "waiting ms", "drawn again", "wrong bytes"], rows) + "".join(
                      f"\nSkipped: {mode}, {why}.\n" for mode, why in skipped.items())


def fragments(report, _):
    return table(
        ["path", "mode", "draws", "fragments", "shown", "wasted", "wasted, % of fragments",
         "by hidden props", "by drawing again"],
        ([title(scene), name, entry["draws"], entry["passed"], entry["shown"], entry["wasted"],
          100.0 * entry["wasted"] / max(entry["passed"], 1), entry["of_hidden"], entry["again"]]
         for scene in report.get("scenes") or []
         for name, entry in sorted((scene.get("fragments") or {}).items(),
                                   key=lambda item: PEERS.index(item[0]))))


def early(report, _):
    modes = ["stock", "early-depth", "nbuffer", "early-depth-nbuffer", "oracle"]
    return table(
        ["path", "mode", "ms (p10 to p90)", "props drawn", "draws", "fragments for depth alone",
         "fragments with colours", "of these for each pixel shown", "wrong bytes"],
        ([title(walk), name, span(times_of(walk["modes"][name])), walk["modes"][name]["drawn"],
          walk["fragments"][name]["draws"], walk["fragments"][name]["of_depth"],
          walk["fragments"][name]["passed"],
          walk["fragments"][name]["passed"] / max(walk["fragments"][name]["shown"], 1),
          str(walk["modes"][name]["differing_bytes"])]
         for walk in report.get("early") or [] for name in modes))


def latent(report, _):
    return table(
        ["path", "poses ago", "frames", "frames with wrong pixels", "visible props missing",
         "wrong pixels", "most in a frame", "hidden props left out, %"],
        ([title(scene), *(str(entry[name]) for name in (
            "step", "frames", "popping_frames", "missing_props", "wrong_pixels",
            "most_wrong_pixels")),
          100.0 * entry["left_out"] / max(entry["hidden_props"], 1)]
         for scene in report.get("scenes") or [] for entry in scene.get("latent") or []))


def hierarchy(report, path):
    def row(entry):
        flat, tree = entry["flat"], entry["tree"]
        return [entry["props"], flat["kept"], flat["tests"], tree["tests"], tree["nodes"],
                flat["ms"]["median"], tree["ms"]["median"],
                flat["ms"]["median"] / tree["ms"]["median"] if tree["ms"]["median"] else 0.0,
                entry["refit_ms"]["median"], entry["build_ms"]["median"]]
    return table(["props", "kept", "boxes tested: flat", "tree", "nodes looked at", "flat ms",
                  "tree ms", "flat / tree", "refit ms", "build ms"],
                 map(row, find(report.get("hierarchy"), path)["entries"]))


def table2(report, _):
    here = report.get("table2")
    if not here:
        raise NotMeasured
    keys = ("oq_hierarchy", "oq", "nb_hierarchy", "nb")
    paper = dict(zip(keys, (1100000, 200000, 350, 500)))
    return (f"{number(here['boxes'])} boxes in view, {number(here['visible'])} visible.\n\n" + table(
        ["depth tests of a frame", "queries over a hierarchy", "queries",
         "N-buffer over a hierarchy", "N-buffer"],
        [["the paper", *(paper[key] for key in keys)],
         ["here", *(here["tests"][key] for key in keys)]]))


def particles(report, _):
    """The paper's counts and frame rates (section 4.3) next to those measured here."""
    rows = []
    for entry in report.get("particles") or []:
        count, tests, draw, build = (entry[name] for name in (
            "particles", "tests", "draw_ms", "build_ms"))
        plain = median_of(draw["none"])
        culled, early = ([median_of(build[name]), median_of(draw[name])]
                         for name in ("maxima", "minima_first"))
        rows.append([
            f"{number(count)} {entry['kind']}", "the scene" if entry["occluders"] else "nothing",
            *(tests[name] / count for name in ("drawn", "maxima", "minima_first")),
            *(100.0 * entry[name] / count for name in ("hidden", "rejected", "accepted")),
            entry["wrongly_rejected"], plain, *(" + ".join(map(number, times)) for times in (
                culled, early)), *(1e3 / max(time, 1e-4) for time in (plain, sum(culled)))])
    if rows:
        rows.insert(0, ["the paper: 3,600 sprites", "a scene", 256, 1, *[""] * 8, 100, 3])
    return table(["particles", "behind", "depth tests of one: drawn", "by maxima", "minima first",
                  "hidden, %", "rejected, %", "accepted early, %", "wrongly rejected",
                  "not culled ms", "culled: levels + particles ms",
                  "minima first: levels + particles ms", "not culled Hz", "culled Hz"], rows)


def figure4(report, _):
    return table(["", "all pixels too many / all in rectangles, %", "mean over sizes, %", "median, %",
                  "most, %"],
                 ([entry["caption"], *(entry[name + "_percent"] for name in (
                     "area", "mean", "median", "most"))] for entry in report.get("figure4") or []))


def left_out(report, _):
    if "left_out" not in report:
        raise NotMeasured
    names = ", ".join(f"`{name}`" for name in report["left_out"])
    return f"Not there in this run and left out: {names}.\n" if names else ""


def known(report, _):
    rows = []
    for scene in report.get("scenes") or []:
        if "table" in scene:
            counts, points = scene["table"], structures(scene)
            kept = points.loc[points["is_default"], "kept"].iloc[0]
            rows.append([
                title(scene), counts["in_view"], counts["table"],
                counts["visible"] + 0.01 * kept * scene["hidden"], counts["visible"],
                counts["pixels"], counts["undrawn_pixels"] + counts["contradictions"],
                counts["undrawn_pixels"]])
    return table(["scene", "props in view", "left in by the table", "kept by the culler",
                  "own a pixel", "pixels checked", "outside the table",
                  "of these through undrawn walls"], rows)


def shadows(report, name):
    scene = find(report.get("shadows"), name)
    points = shadow_points(scene).sort_values("median", kind="stable")
    rows, place = [], 0
    for _, point in points.iterrows():
        place += bool(point["pareto"])
        if point["pareto"] or point["is_default"] or point["wrong"] or point["name"] == "unclamped":
            rows.append([str(place) if point["pareto"] else "",
                         point["name"] + (" (default)" if point["is_default"] else ""), span(point),
                         point["percent"],
                         f"{number(point['wrong'])} of {number(point['samples'])}",
                         point["ambiguous"]])
    return (f"Without shadows {number(scene['modes']['none']['median_ms'])} ms; pixels that shadows "
            f"change: {number(shadowed_percent(scene))} % of the fragments of whole volumes; "
            f"{len(points)} modes.\n\n" + table(
                ["", "mode@litmap", "ms (p10 to p90)", "fragments, %", "wrong samples",
                 "differ and are ambiguous"], rows))


def setting(report, name):
    rows, values, of_shadows = [], {}, False
    for part, scene, points in setting_scenes(report):
        of_shadows = of_shadows or (part == "shadows" and (points["setting"] == name).any())
        for kind, group in points[points["setting"] == name].groupby("kind", sort=False):
            default = group[group["is_default"]].iloc[0]
            cells = {}
            for _, point in group.iterrows():
                values[point["value"]] = point["is_default"]
                error = "" if math.isnan(point["error"]) else f"; {number(point['error'])} %"
                cells[point["value"]] = number(
                    1 if point["is_default"] else point["ratio"]) + error
            rows.append((
                f"{scene['scene']}, {kind}" if part == "shadows" else title(scene), span(default),
                ratio(scene, scene["again"], kind) if default["usual"] else "", cells))
    head = ["scene, mode" if of_shadows else "path", "default: ms (p10 to p90)", "default again"]
    tried = sorted(values)
    head += [f"{value}{' (default)' if values[value] else ''}" for value in tried]
    return table(head, ([*row, *(cells.get(value, "") for value in tried)] for *row, cells in rows))


def few(report, _):
    modes = ["nbuffer", "nbuffer:MinimumNumberOfCandidates=1",
             "nbuffer:MinimumNumberOfCandidates=1:BackOff=0"]
    return table(
        ["path", "props in view", "drawn by the culler", "stock ms (p10 to p90)", "default / stock",
         "from 1 on / stock", "from 1 on, never backing off / stock"],
        ([title(scene), entry["props"], entry["modes"][modes[-1]]["drawn"],
          span(times_of(entry["modes"]["stock"])), *(ratio(entry, mode, "stock") for mode in modes)]
         for scene in (report.get("settings") or {}).get("few") or []
         for entry in scene["entries"]))


OTHER_TABLES = {function.__name__: function for function in (
    recorded, frames, peers, fragments, early, pareto, best, chain, hierarchy,
    latent, table2, particles, figure4, left_out, known, shadows, setting, few)}
