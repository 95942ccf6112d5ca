#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs nbuffer-view on files that are written here.

    check_view.py files <nbuffer-view> <folder> [<nbuffer-bench>]
                                                   one small scene in every format that is read
    check_view.py errors <nbuffer-view> <folder>   files that are refused; what the help lists
    check_view.py keys <nbuffer-view> <folder>     what the keys do; in X in a window, too

Where a window needs a display that is missing, it prints "Skipped: " and the reason.
"""
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import time
import zlib

import running
import view_files
from running import IS_X, check, skip_without_display

TEST, PROGRAM = sys.argv[1:3]
OUT = pathlib.Path(sys.argv[3])


def run(*arguments, status=0):
    return running.run(PROGRAM, *arguments, status=status, timeout=240)


def draw(file, keys, size="240x180"):
    """What is printed, and the pixels of the picture."""
    picture = OUT / "picture.png"
    picture.unlink(missing_ok=True)
    printed, errors = run(file, "--offscreen", picture, "--size", size, "--keys", keys)
    check(errors == "", f"{file} with {keys}: {errors}")
    return printed, read_png(picture)


def read_png(file):
    """The pixels of a picture of 8 bits and 3 channels, in rows from the top."""
    data = file.read_bytes()
    position, packed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            check((depth, color) == (8, 2), f"{file} has depth {depth} and type {color}")
        packed += body if kind == b"IDAT" else b""
        position += 12 + length
    raw, stride, rows = zlib.decompress(packed), 3 * width, []
    above = bytes(stride)
    for y in range(height):
        line = bytearray(raw[y * (stride + 1):(y + 1) * (stride + 1)])
        method, row = line[0], line[1:]
        for i in range(stride):
            left = row[i - 3] if i >= 3 else 0
            corner = above[i - 3] if i >= 3 else 0
            up = above[i]
            if method == 1:
                row[i] = (row[i] + left) & 255
            elif method == 2:
                row[i] = (row[i] + up) & 255
            elif method == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif method == 4:
                guess = left + up - corner
                nearest = min((left, up, corner), key=lambda value: abs(guess - value))
                row[i] = (row[i] + nearest) & 255
        above = bytes(row)
        rows.append([tuple(row[i:i + 3]) for i in range(0, stride, 3)])
    return rows


def share(rows, belongs):
    pixels = [pixel for row in rows for pixel in row]
    return sum(map(belongs, pixels)) / len(pixels)


def listed_endings():
    """The endings in the help."""
    text = run("--help")[0].split("Files that this build reads", 1)[1].split("\n\n")[1]
    return set(re.findall(r"(?<=\s)\.[\w.]+", text))


def test_files():
    listed = listed_endings()
    count = 0
    for file, parts in view_files.write_all(OUT).items():
        ending = file.suffixes[0] if file.suffix == ".gz" else file.suffix
        if ending not in listed:
            print(f"{ending} is not read by this build")
            continue
        printed, rows = draw(file, "v i")
        check(f"\n{parts} part{'s' if parts > 1 else ''};" in printed,
              f"{file.name}: not {parts} parts: {printed}")
        check("verify: 0 bytes differ" in printed, f"{file.name}: {printed}")
        seen = share(rows, lambda pixel, background=rows[0][0]: pixel != background)
        check(0.1 < seen < 0.9, f"{file.name}: {seen:.3f} of the picture are not background")
        print(f"{file.name}: {parts} parts, {100 * seen:.1f} % of the picture")
        count += 1
    check(count >= 15, f"only {count} files were read")
    # Several files of meshes are one scene; without regions a mesh is one part.
    several = draw(OUT / "boxes.vtp", "i")[0] and run(
        OUT / "boxes.vtp", OUT / "binary.stl", OUT / "boxes.vti", "--whole", "--offscreen",
        OUT / "picture.png", "--size", "240x180")[0]
    check("\n3 parts;" in several, several)
    if len(sys.argv) > 4:
        for name, count in (("boxes.vtu", 65), ("boxes.vtm", 65)):
            printed, _ = running.run(
                sys.argv[4], "walk", "--scene", OUT / name, "--split", "--frames", 2, "--size",
                "161x119", "--verify", "--json", OUT / "walk.json", timeout=240)
            check("0 bytes differ" in printed and
                  json.loads((OUT / "walk.json").read_text())["props"] == count, printed)
    # The names of the parts; the wall is box0.
    for name in ("boxes.vtm", "boxes.vtpc", "boxes.obj"):
        printed, _ = draw(OUT / name, "@150,90")
        check("under the pointer: box0\n" in printed, f"{name}: {printed}")


def refuse(file, cause):
    _, errors = run(file, "--offscreen", OUT / "picture.png", status=1)
    check(errors.startswith("nbuffer-view: ") and errors.count("\n") == 1 and cause in errors,
          f"{file}: not one sentence with '{cause}': {errors}")


def test_errors():
    listed = listed_endings()
    whole = {file: parts for file, parts in view_files.write_all(OUT).items()
             if file.suffix in listed}
    check({".vtp", ".vtu", ".vtk", ".glb", ".city", ".bsp"} <= listed, f"the help lists {listed}")
    for ending in {*view_files.WRITERS} - listed:
        refuse(OUT / f"boxes{ending}", f"the ending {ending} is not known")
    for name, contents, cause in (
            ("empty.vtp", "", "empty.vtp is empty"), ("empty.city", "", "empty.city is empty"),
            ("other.city", "what", "is damaged, or is no city"),
            ("what.nothing", "what", "the ending .nothing is not known; known are"),
            ("what", "what", "has no ending; known are"),
            ("points.obj", "v 0 0 0\nv 1 0 0\n", "the file has no geometry"),
            ("none.vtp", view_files.vtp([]), "the file has no geometry"),
            ("what.glb", "what", "is damaged, was cut short, or is not what its ending says"),
            ("cut.bsp", "IBSP.", "damaged map")):
        (OUT / name).write_text(contents)
        refuse(OUT / name, cause)
    for name in ("missing.vtp", "missing.bsp", "missing.kicad_pcb", "missing"):
        refuse(OUT / name, f"{name}")
    (OUT / "folder").mkdir()
    refuse(OUT / "folder", "folder is a folder, and there is no .kicad_pcb in it")
    # Cut short: that is noticed in most formats, and in the others nothing crashes. VTK 9.1 does not
    # notice it in .stl.
    for file in whole:
        data = file.read_bytes()
        for percent in (40, 90):
            cut = OUT / f"cut{file.suffix}"
            cut.write_bytes(data[:len(data) * percent // 100])
            if file.suffix not in (".obj", ".gml", ".citygml", *([".stl"] if IS_X else [])):
                refuse(cut, f"{cut.name} is damaged, was cut short")
                continue
            done = subprocess.run(
                [PROGRAM, cut, "--offscreen", OUT / "picture.png", "--size", "240x180"],
                capture_output=True, text=True, errors="replace", timeout=240, check=False)
            check(done.returncode in (0, 1) and done.stderr.count("\n") == done.returncode,
                  f"{cut} ended with {done.returncode}: {done.stderr}")
    run(status=106)
    vtp = OUT / "boxes.vtp"
    refuse_option = run(vtp, "--offscreen", OUT / "no" / "picture.png", status=1)[1]
    check("cannot write" in refuse_option, refuse_option)
    for keys in ("z", "v @1,2,3", "@", "@1"):
        errors = run(vtp, "--offscreen", OUT / "picture.png", "--keys", keys, status=1)[1]
        check(errors.count("\n") == 1, f"{keys}: {errors}")
    if not IS_X:
        errors = run(vtp, status=1)[1]
        check("no window can be opened" in errors and "--offscreen" in errors, errors)


FROZEN_DIFFER = re.compile("verify: [1-9][0-9]* bytes differ .* frozen\n")


def is_red(pixel):
    return pixel[0] > 120 and pixel[0] > 1.8 * max(pixel[1:])


def press_in_window(file):
    """Keys of an X server, as a user presses them; needs xdotool."""
    with subprocess.Popen([PROGRAM, file, "--size", "400x300"], stdout=subprocess.PIPE,
                          text=True) as viewer:
        for line in viewer.stdout:
            if line.startswith("stock VTK"):
                break
        found = ""
        for _ in range(50):
            search = ["xdotool", "search", "--pid", str(viewer.pid), "--name", "nbuffer-view"]
            found = subprocess.run(search, capture_output=True, text=True, check=False).stdout.split()
            if found:
                break
            time.sleep(0.2)
        check(found, "xdotool does not find the window")
        subprocess.run(["xdotool", "windowfocus", found[0]], check=False)
        for key in ("c", "v", "q"):
            time.sleep(0.5)
            subprocess.run(["xdotool", "key", key], check=True)
        printed = viewer.stdout.read()
        check(viewer.wait(60) == 0, f"the window ended with {viewer.returncode}")
    check("culled parts in red" in printed and "verify: 0 bytes differ" in printed, printed)


def test_keys():
    view_files.write_all(OUT)
    wall = OUT / "boxes.vtp"
    _, plain = draw(wall, "i")
    printed, without = draw(wall, "n i")
    check("culler off" in printed, printed)
    check(plain == without, "the culler changes the picture")
    printed, red = draw(wall, "c i")
    culled = int(re.search(r"(\d+) culled parts in red", printed)[1])
    check(culled > 0, printed)
    check(share(red, is_red) > share(plain, is_red) + 0.01, "nothing is red")
    # Frozen, from where the wall does not hide them: they are as red as can be.
    flight = "c f @200,90>40,90 v i"
    printed, frozen = draw(wall, flight)
    check(FROZEN_DIFFER.search(printed), f"frozen verdicts should change the picture: {printed}")
    check(share(frozen, is_red) > 0.01, "what was culled is not seen in red")
    # Of one part, the instances and the triangles that are hidden.
    for scene in ("glyph-wall", "isosurface"):
        _, plain_scene = draw(scene, "i")
        printed, red = draw(scene, "c v i")
        culled = int(re.search(r"(\d+) culled parts in red", printed)[1])
        check(culled > 10000 and "verify: 0 bytes differ" in printed, printed)
        check(share(red, is_red) > share(plain_scene, is_red) + 0.01, f"nothing is red in {scene}")
    printed, shadows = draw(wall, "s . , v i")
    check(re.search(r"shadows at 09:00\n.*09:30\n.*09:00\nverify: 0 bytes differ", printed), printed)
    check(shadows != plain, "there are no shadows")
    check(draw(wall, "s s i")[1] == plain, "what the shadows change remains")
    printed, level = draw(wall, "l l i")
    check("level 0 of the N-buffer: the depth\n" in printed and
          "level 1 of the N-buffer: the farthest in 2 x 2 pixels\n" in printed, printed)
    half = len(plain) // 2
    check(level[half + 1:] == plain[half + 1:] and level[:half] != plain[:half],
          "the level is not in the upper half")
    check(draw(wall, "Up Left Prior v i")[1] != plain, "the camera does not walk")
    check(draw(wall, "Up Left Prior r i")[1] == plain, "the camera does not go home")
    check(draw(wall, "w o @100,90>140,90 i")[1] != plain, "the mouse does not turn the camera")
    draw(wall, "w @10,10>50,50")
    check(draw(wall, "h i")[1] != plain, "there is no list of keys")
    printed, _ = draw(wall, "t v a @2,2")
    check(printed.count("times as fast") == 2, printed)
    check("under the pointer" not in printed, "the background has a name")
    if IS_X:
        printed, errors = run(wall, "--size", "400x300", "--keys", "c v s v f h l w Up f q")
        check(printed.count("verify: 0 bytes differ") == 2 and errors == "", printed + errors)
        printed, _ = run(wall, "--size", "240x180", "--keys", f"v {flight} q")
        check("verify: 0 bytes differ" in printed and FROZEN_DIFFER.search(printed),
              f"in a window frozen verdicts should change the picture: {printed}")
        if shutil.which("xdotool"):
            press_in_window(wall)
        else:
            print("without xdotool no keys of the X server are sent")


def main():
    skip_without_display()
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    {"files": test_files, "errors": test_errors, "keys": test_keys}[TEST]()


if __name__ == "__main__":
    main()
