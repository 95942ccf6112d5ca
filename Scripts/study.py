#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the whole study of what accuracy costs in time and writes OUT/study.json.

    study.py [--quick | --tiny] [--out out/study] [--only shadows]
    study.py --scene model.obj.gz --out out/study-model        # a scene of one's own
    report.py study out/study/study.json --docs docs --charts docs/images/study

It calls nbuffer-bench for each part and puts the reports together; Examples/Bench/SCHEMA.md
describes the result. Scenes that this repository must not hold are taken out of Debian's packages
once, by make-scenes.sh; those that are missing are left out, and the report says so.

Ends with 2 if anything visible was hidden or lit wrongly, as nbuffer-bench does.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys
import time

import study_benchmarks

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = ("structures", "early", "scenes", "settings", "shadow-settings", "shadows", "maps", "fill")
FEWER = ("depth", "device")  # Of a part above; only on request.
BENCHMARKS = "benchmarks"  # Those of docs/benchmarks.md; only on request.
IMAGES_DIFFER = 2

Effort = collections.namedtuple(
    "Effort", "flags settings_frames settings_paths few plant shadow_scenes shadow_settings_scenes "
    "shadow_size shadow_frames shadow_settings_frames litmaps maps fill_frames")
SHADOW_SCENES = ["city-sun", "city-spot", "birds", "simple"]
EFFORTS = {
    "full": Effort([], 15, ["street", "rooftop", "drone", "cuts"], [8, 16, 24, 32, 48, 64, 128],
                   True, SHADOW_SCENES, SHADOW_SCENES, "640x480", 8, 8,
                   [32, 64, 128, 256, 512, 1024], [256, 512, 1024, 2048, 4096], 2),
    "quick": Effort(["--quick"], 5, ["street"], [32], False, ["birds"], ["birds"], "320x240", 2, 1,
                    [64, 256], [256, 1024], 1),
    "tiny": Effort(["--tiny"], 2, ["street"], [8], False, ["city-sun", "birds"], ["birds"],
                   "320x240", 1, 1, [64], [256], 1)}

# Scenes beside the city: name, whether it is a file, paths, whether a quick run has it (its first
# path), and the options that bound what is measured.
OTHER_SCENES = [
    ("plant", False, ["inside", "around"], True, (4, 3, 24, 4)),
    ("oa_thor.bsp:faces", True, ["walk"], True, (6, 3, 40, 6)),
    ("oa_thor.bsp:clusters", True, ["walk"], False, (6, 3, 40, 6)),
    ("ctf_inyard.bsp:faces", True, ["walk"], False, (6, 3, 40, 6)),
    ("kicad", True, ["outside", "between"], False, (3, 3, 8, 2)),
    ("kicad/boards/kit-dev-coldfire-xilinx_5213.kicad_pcb", True, ["over"], False, (4, 3, 16, 3)),
    ("motorBike.obj.gz", True, ["orbit"], False, (4, 3, 24, 3))]

# Scenes, paths and further options of nbuffer-bench fill. The lamp of city-spot stands near the
# poses that follow each other; of the others the poses are far apart.
FILL_SCENES = [
    ("birds", "orbit", "--own", "--spread"), ("birds", "orbit", "--spread", "--spot"),
    ("towers", "eye-height", "--own", "--spread"),
    ("towers", "eye-height", "--spread", "--spot"), ("towers", "above", "--spread"),
    ("towers", "eye-height", "--own", "--spread", "--ground-caster"),
    ("simple", "orbit", "--own", "--spread"), ("city-sun", "street", "--own", "--spread"),
    ("city-sun", "rooftop", "--spread"), ("city-sun", "drone", "--own", "--spread"),
    ("city-sun", "street", "--spread", "--ground-caster"), ("city-spot", "street", "--own")]

# The values that are tried of each setting, one setting at a time.
CULLER_VALUES = {
    "RoundSize": [16, 32, 64, 128, 256, 1024], "MaximumNumberOfRounds": [1, 2, 3, 4, 6, 8],
    "BaseFactor": [1, 2, 4, 8], "TestPixels": [0, 1],
    "BackOff": [0, 1], "TakeOverFrustumCulling": [0, 1]}
REST_VALUES = {"BackOff": [0, 1], "BaseFactor": [4, 8]}  # For scenes where culling gains little.
STILL_VALUES = {"ReuseWhenStill": [0, 1]}
BOX_COSTS = [8, 16, 64, 256, 1024, 4096]
SHADOW_VALUES = [("auto", "BoxCost", BOX_COSTS), ("exact", "BoxCost", BOX_COSTS),
                 ("slabs", "BoxCost", BOX_COSTS), ("slabs", "SlabGap", [1, 2, 4, 8, 16, 64])]

# VTK's shadow maps with the usual resolution: exponents, and polygon offsets (factor, units) with an
# exponent that needs them. Resolutions have VTK's own exponent and the best one. The lamp hangs so
# high that the map of a spot is not empty.
MAP_EXPONENTS = [2, 5, 20, 40, 80, 88]
MAP_OFFSETS = [(1, 0), (4, 0), (16, 0), (0, 16), (0, 1000), (4, 1000)]
MAP_RESOLUTION, MAP_BEST_EXPONENT, MAP_OFFSET_EXPONENT = 1024, 40, 80
MAP_LAMP = "60,-60,290,9"

# The default under other names. After a mode that draws everything, the next mode finds nothing of
# its own in the caches: the first of these names pays for that, and its times are not used. The one
# that is drawn again, far from the turn of the default, shows what ratios are worth.
CULLER_NAMES = "nbuffer:TestPixels=1", "nbuffer:BackOff=1"
SHADOW_NAMES = "auto:SlabGap=4", "auto:BoxCost=256"


def commit():
    """The last one that changed what is measured, with a + if it has been changed since."""
    def git(*arguments):
        return subprocess.run(["git", "-C", ROOT, *arguments, "--", "Modules", "Examples", "Support"],
                              capture_output=True, text=True).stdout.strip()
    changed = git("status", "--porcelain", "--untracked-files=no")
    return (git("log", "-1", "--format=%h", "--abbrev=7") or "unknown") + ("+" if changed else "")


class Study:
    def __init__(self, options):
        self.options = options
        self.effort = EFFORTS[options.effort]
        self.wrong = False
        self.machine = ""
        self.file = options.out / "part.json"
        options.out.mkdir(parents=True, exist_ok=True)
        self.defaults = self.bench("defaults")

    def bench(self, *arguments):
        """Runs nbuffer-bench and returns its report."""
        command = [str(self.options.bench), *map(str, arguments)]
        if arguments[0] == "defaults":
            return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        print(" ".join(command), flush=True)
        if "--size" not in command and self.options.size:
            command += ["--size", self.options.size]
        code = subprocess.run([*command, "--json", str(self.file)]).returncode
        if code not in (0, IMAGES_DIFFER):
            raise SystemExit(code)
        self.wrong = self.wrong or code == IMAGES_DIFFER
        report = json.loads(self.file.read_text())
        self.file.unlink()
        if "renderer" in report:
            effort = "" if self.options.effort == "full" else f", {self.options.effort} run"
            self.machine = f", {report['renderer']}, VTK {report['vtk']}{effort}"
        return report

    def structures(self):
        """All of the city, or of another scene."""
        scene = ["--scene", *self.options.scene] if self.options.scene else []
        return self.bench("study", *scene, *self.effort.flags, "--out", self.options.out)

    def depth(self):
        """Formats of depth alone, which the structures of the city have, too."""
        report = self.bench("study", "--depth-only", *self.effort.flags, "--out", self.options.out)
        return {name: report[name] for name in ("depth", "formats")}

    def device(self):
        """Of the structures how levels are built: in part, and on the graphics device."""
        report = self.bench("study", *self.effort.flags, "--device-only", "--out", self.options.out)
        return {name: report[name] for name in ("device", "packed", "rebuild")}

    def early(self):
        """Depth before colours, alone and with the culler; fragments in a fourth of the frames."""
        frames = self.effort.settings_frames * 2
        return {"early": [self.bench(
            "walk", "--scene", "city", "--path", path, "--frames", frames, "--verify",
            "--fragments", frames // 4, "--modes",
            "none,stock,nbuffer,early-depth,early-depth-nbuffer,oracle")
            for path in self.effort.settings_paths if path != "cuts"]}

    def scenes(self):
        scenes, left_out = [], []
        for name, is_file, paths, in_quick, bounds in OTHER_SCENES:
            if self.options.effort == "tiny" or (self.options.effort == "quick" and not in_quick):
                continue
            place = self.options.scenes / name if is_file else name
            # What follows the colon says how a map is cut.
            if is_file and not pathlib.Path(str(place).rsplit(":", 1)[0]).exists():
                left_out.append(name)
                continue
            for path in paths if self.options.effort == "full" else paths[:1]:
                frames, repeat, walk_frames, pairs = bounds
                scenes += self.bench(
                    "study", "--scene", place, "--path", path, *self.effort.flags, "--paths-only",
                    *(["--frames", frames, "--repeat", repeat, "--walk-frames", walk_frames,
                       "--latent-pairs", pairs] if self.options.effort == "full" else []),
                    "--out", self.options.out)["scenes"]
        return {"scenes": scenes, "left_out": left_out}

    def tried(self, kind, values, defaults):
        """What was tried of settings; the default is the mode without settings."""
        return [{"kind": kind, "setting": setting, "value": value,
                 "mode": kind if defaults[setting] == value else f"{kind}:{setting}={value}"}
                for setting, tried in values.items() for value in tried]

    def walk_settings(self, scene, path, values, *flags):
        warm_up, again = CULLER_NAMES
        tried = self.tried("nbuffer", values, self.defaults["culler"])
        modes = ["none", "stock", warm_up, "nbuffer", *(entry["mode"] for entry in tried), again]
        if "--still" not in flags:
            modes.append("oracle")
        frames = self.effort.settings_frames
        report = self.bench(
            "walk", "--scene", scene, "--path", path, "--frames", frames, "--modes",
            ",".join(modes), "--verify", *flags)
        return {**report, "tried": tried, "again": again}

    def settings(self):
        settings = collections.defaultdict(list)
        few = ["stock", "nbuffer", "nbuffer:MinimumNumberOfCandidates=1",
               "nbuffer:MinimumNumberOfCandidates=1:BackOff=0"]
        for path in self.effort.settings_paths:
            settings["culler"].append(self.walk_settings("city", path, CULLER_VALUES))
            if path == "cuts":
                continue
            settings["still"].append(self.walk_settings("city", path, STILL_VALUES, "--still"))
            entries = [self.bench(
                "walk", "--path", path, "--frames", self.effort.settings_frames, "--nearest", number,
                "--modes", ",".join(["none", CULLER_NAMES[0], *few]), "--verify")
                for number in self.effort.few]
            settings["few"].append({"scene": "city", "path": path, "entries": entries})
        if self.effort.plant:
            settings["culler"].append(
                self.walk_settings("plant", "around", REST_VALUES, "--of", 480))
        return {"settings": settings}

    def shadow(self, scene, frames, modes, *flags):
        # Many modes: turns have to be short to meet the same disturbances.
        size = [] if "--size" in flags else ["--size", self.effort.shadow_size]
        return self.bench("shadow", "--scene", scene, *size, "--frames",
                          frames, "--block", 2, "--modes", ",".join(modes), *flags)

    def shadow_settings(self):
        warm_up, again = SHADOW_NAMES
        tried = [entry for kind, setting, values in SHADOW_VALUES
                 for entry in self.tried(kind, {setting: values}, self.defaults["shadow"])]
        modes = ["none", "unclamped", warm_up]
        for entry in tried:
            modes += [entry["kind"], entry["mode"]]
        return {"settings": {"shadows": [
            {**self.shadow(scene, self.effort.shadow_settings_frames, [*modes, again]),
             "tried": tried, "again": again} for scene in self.effort.shadow_settings_scenes]}}

    def shadows(self):
        modes = ["none", "unclamped", *(
            f"{mode}@{litmap}" for litmap in self.effort.litmaps
            for mode in ("auto", "exact", "clamp", "slabs")), "paper@256", "vtk@256", "vtk@1024"]
        default = f"auto@{self.defaults['shadow']['LitmapResolution']}"
        return {"shadows": [
            {**self.shadow(scene, self.effort.shadow_frames, modes, "--oracle", "--oracle-once"),
             "default": default} for scene in self.effort.shadow_scenes]}

    def maps(self):
        """VTK's shadow maps in square windows: resolution, exponent and bias, in wrong samples."""
        usual = f"vtk@{MAP_RESOLUTION}"
        modes = ["none", "auto", usual]
        for size in self.effort.maps:
            modes += [f"vtk@{size}:EachFrame=1", f"vtk@{size}:Exponent={MAP_BEST_EXPONENT}:EachFrame=1"]
        modes += [f"{usual}:Exponent={exponent}" for exponent in MAP_EXPONENTS]
        modes += [f"{usual}:Exponent={MAP_OFFSET_EXPONENT}:OffsetFactor={factor}:OffsetUnits={units}"
                  for factor, units in MAP_OFFSETS]
        if "Exponent" not in self.defaults["maps"]:  # A version of VTK that has no setting for it.
            modes = [mode for mode in modes if "Exponent" not in mode]
        side = self.effort.shadow_size.split("x")[1]
        return {"maps": [
            self.shadow(scene, self.effort.shadow_frames, modes, "--oracle", "--oracle-once", "--size",
                        f"{side}x{side}", *(["--lamp", MAP_LAMP] if scene == "city-spot" else []))
            for scene in self.effort.shadow_settings_scenes]}

    def fill(self):
        """What the paper's figures 5 and 7 and its section 4.4 show."""
        pictures = {}
        for scene, path in (("birds", "orbit"), ("towers", "eye-height"), ("city-sun", "street")):
            if self.options.effort != "full" and scene != "birds":
                continue
            pictures = self.bench("volumes", "--scene", scene, "--path", path, "--size", "320x240",
                                  "--out", self.options.out)
        scenes = FILL_SCENES[:1] if self.options.effort != "full" else FILL_SCENES
        return {**pictures, "fill": [self.bench(
            "fill", "--scene", scene, "--path", path, "--size", self.effort.shadow_size, "--frames",
            self.effort.fill_frames, *flags) for scene, path, *flags in scenes]}

    def benchmarks(self):
        file = self.options.out / f"benchmarks-{self.options.effort}-{commit()}.json"
        return {BENCHMARKS: study_benchmarks.measure(
            self.bench, self.options.scenes, file, self.options.effort == "tiny")}

    def run(self):
        begin = time.monotonic()
        parts = ["structures"] if self.options.scene else self.options.only or PARTS
        report = {"recorded": {}}
        for part in parts:
            report["recorded"][part] = f"commit {commit()}"
            for name, value in getattr(self, part.replace("-", "_"))().items():
                if isinstance(value, list) and name in report:
                    report[name] += value
                elif isinstance(value, dict) and name in report:
                    report[name].update(value)
                else:
                    report[name] = value
            report["recorded"][part] += self.machine
        report["effort"] = self.options.effort
        report["seconds"] = round(time.monotonic() - begin, 1)
        (self.options.out / "study.json").write_text(json.dumps(report, indent=1) + "\n")
        print(f"written to {self.options.out} in {report['seconds']:.0f} s")
        return IMAGES_DIFFER if self.wrong else 0


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    effort = parser.add_mutually_exclusive_group()
    effort.add_argument("--quick", dest="effort", action="store_const", const="quick",
                        help="fewer frames and repetitions: about 3 minutes")
    effort.add_argument("--tiny", dest="effort", action="store_const", const="tiny",
                        help="one frame of each: only whether everything runs")
    parser.add_argument("--only", nargs="+", choices=(*PARTS, *FEWER, BENCHMARKS), help="parts of the study")
    parser.add_argument("--scene", nargs="+", help="another scene than the city, its structures")
    parser.add_argument("--size", help="of the images, such as 960x720")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/study"))
    parser.add_argument("--scenes", type=pathlib.Path, default=ROOT / "out/scenes",
                        help="folder of the scenes that make-scenes.sh builds")
    parser.add_argument("--bench", type=pathlib.Path, default=ROOT / "build/bin/nbuffer-bench")
    parser.set_defaults(effort="full")
    options = parser.parse_args()
    if not options.bench.is_file():
        parser.error(f"{options.bench} is missing: build it, or name it by --bench")
    sys.exit(Study(options).run())


if __name__ == "__main__":
    main()
