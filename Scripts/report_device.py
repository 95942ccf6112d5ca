# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of levels on the graphics device, by size of the image; see report_tables.py."""

from report_tables import median_of, number, span, table


def device_row(entry, name, factor):
    return next((row for row in entry["rows"] if (row["name"], row["factor"]) == (name, factor)), {})


def device(report, _):
    def row(entry):
        def get(*key):
            return device_row(entry, *key)
        everything, one = get("module, all levels", 1), get("module, one level", 4)
        return [f"{entry['width']} x {entry['height']}", span(entry["draw_ms"]),
                median_of(entry["read_ms"]), span(everything["build_ms"]),
                median_of(everything["read_ms"]), span(get("module, all levels", 4)["build_ms"]),
                span(one["build_ms"]), median_of(one["read_ms"]),
                *(median_of(get(*key)["build_ms"]) for key in (
                    ("CPU, all levels", 1), ("CPU, all levels", 4), ("CPU, one level", 4)))]
    return table(["size", "drawing ms", "reading depth ms", "OpenGL: all levels ms",
                  "reading them ms", "all on 1/4 ms", "one 1/4 ms", "reading it ms",
                  "CPU: all levels ms", "all on 1/4 ms", "one 1/4 ms"],
                 map(row, report.get("device") or []))


def single(report, _):
    rows, skipped = [], {}
    for entry in report.get("device") or []:
        for factor in (4, 8, 16):
            cells = [f"{entry['width']} x {entry['height']}", f"1/{factor}"]
            for name in ("pass", "passes", "compute"):
                row = device_row(entry, name, factor)
                cells += [span(row.get("build_ms")), median_of(row.get("device_ms"))]
                if "skipped" in row:
                    skipped[name] = row["skipped"]
            rows.append([*cells, median_of(device_row(entry, "pass", factor).get("read_ms")),
                         median_of(device_row(entry, "CPU, one level", factor)["build_ms"])])
    return table(["size", "1/N", "one pass ms", "device ms", "passes of 2 x 2 ms", "device ms",
                  "compute ms", "device ms", "reading it ms", "CPU ms"], rows) + "".join(
                      f"\nSkipped: {name}, {why}.\n" for name, why in skipped.items())


def packed(report, _):
    """Levels in two arrays and side by side in one texture, and both extrema at once."""
    rows, skipped = [], {}
    for entry in report.get("packed") or []:
        size = f"{entry['width']} x {entry['height']}"
        if "skipped" in entry:
            skipped[size] = entry["skipped"]
            continue
        rows.append([size, *(span(entry[name + "_ms"]) for name in (
            "arrays", "packed", "query_arrays", "query_packed", "both_extrema"))])
    return table(["size", "two arrays ms (p10 to p90)", "one texture ms", "a query per pixel: arrays ms",
                  "one texture ms", "maxima and minima in two arrays ms"], rows) + "".join(
                      f"\nSkipped: {size}, {why}.\n" for size, why in skipped.items())


def rebuild(report, _):
    """The texels and the time of building levels again where a second round changed the depth."""
    return table(
        ["path", "poses ago", "base", "frames that change", "texels of the base that change, %",
         "texels of the levels that change, %", "built again, %", "all levels ms (p10 to p90)",
         "built again ms"],
        ([entry["path"], str(entry["step"]), f"1/{entry['factor']}",
          f"{entry['changed_frames']} of {entry['frames']}",
          *(entry[name + "_percent"] for name in ("changed", "stale", "built")),
          span(entry["whole_ms"]), span(entry["rebuild_ms"])]
         for entry in report.get("rebuild") or []))


def eyes_row(entry, name):
    return next((row for row in entry.get("eyes") or [] if row["name"] == name), {})


def eyes_size(entry):
    return f"{entry['width']} x {entry['height']}"


def both_times(row):
    """Until the device has finished, and what its timer says."""
    return " / ".join(number(median_of(row[name])) for name in ("build_ms", "device_ms")
                      if row.get(name)) or "not measured"


EYES = {"exact chain": "exact chain", "fat chain": "fat chain",
        "exact chain, levels 1 to 4": "its levels 1 to 4", "pass": "1/16 by a pass",
        "groups 4 x 4, gather, atomics": "1/16 by groups", "N-buffer, all levels": "N-buffer",
        "N-buffer, all levels on 1/4": "N-buffer on 1/4"}


def eyes(report, _):
    """Turitzin's figures (GeForce GTX 980 and Radeon R9 290) above those measured here."""
    rows = [[eyes_size(entry), *(both_times(eyes_row(entry, name)) for name in EYES)]
            for entry in report.get("device") or [] if entry.get("eyes")]
    if rows:
        rows.insert(0, ["1648 x 1776, GTX 980", "0.25", "", "0.22", "", "0.12", "", ""])
        rows.insert(1, ["1648 x 1776, R9 290", "0.30", "", "0.25", "", "0.08", "", ""])
    return table(["two eyes of", *(f"{title} ms" for title in EYES.values())], rows)


def groups(report, _):
    entries = [entry for entry in report.get("device") or [] if entry.get("eyes")]
    names = [row["name"] for row in (entries or [{"eyes": []}])[-1]["eyes"]
             if row["name"].startswith("groups ")]
    return table(["invocations, reads, result", *(eyes_size(entry) + ", ms" for entry in entries)],
                 ([name[len("groups "):], *(both_times(eyes_row(entry, name)) for entry in entries)]
                  for name in names))


def table1(report, _):
    """The paper's sizes, levels and milliseconds (GeForce FX 6800) beside those measured here."""
    paper = {(256, 256): (8, 2.0), (512, 512): (9, 8.0), (640, 480): (10, 10.0),
             (1024, 1024): (10, 31.0)}
    rows = []
    for entry in report.get("device") or []:
        size = entry["width"], entry["height"]
        if size in paper:
            built = device_row(entry, "module, all levels", 1)
            rows.append([f"{size[0]} x {size[1]}", str(built["levels"]), str(paper[size][0]),
                         paper[size][1],
                         median_of(device_row(entry, "CPU, all levels", 1)["build_ms"]),
                         span(built["build_ms"])])
    return table(["size", "levels", "the paper's: levels", "the paper's ms", "CPU ms",
                  "OpenGL ms (p10 to p90)"], rows)


DEVICE_TABLES = {function.__name__: function for function in (
    device, single, packed, rebuild, eyes, groups, table1)}
