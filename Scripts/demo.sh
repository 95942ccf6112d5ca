#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds what it shows (no tests) in build/, and writes out/: pictures of
# shadows, of a walk through the city and of what is culled there, and the figures as JSON (a chart of
# them: Scripts/report.py walk). Each step is announced with the minutes and seconds so far. The first
# picture is there as soon as the library and one example are built; on two cores that takes a few
# minutes, once.

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

out="$nbuffer_source/out"
mkdir -p "$out"

nbuffer_say "1 of 4: the library and two small examples"
nbuffer_setup nbuffer-minimal shadow-room
nbuffer_say "The example of README.md: 10000 cones, one frame"
"$nbuffer_build/bin/nbuffer-minimal"
nbuffer_say "A room with one lamp, whose shadows are exact: out/shadow-room.png"
"$nbuffer_build/bin/shadow-room" --size 480x360 --out "$out"

nbuffer_say "2 of 4: shadows of a city from morning to evening, and of birds over hills"
nbuffer_build "$nbuffer_build" shadow-city shadow-terrain
nbuffer_say "Pictures: out/shadow-city-*.png, out/shadow-terrain.png"
"$nbuffer_build/bin/shadow-city" --size 480x360 --out "$out" --hour 5 --until 19 --step 2
"$nbuffer_build/bin/shadow-terrain" --size 480x360 --out "$out"

nbuffer_say "3 of 4: a walk through the city, with and without the culler"
nbuffer_build "$nbuffer_build" nbuffer-bench
bench="$nbuffer_build/bin/nbuffer-bench"
nbuffer_say "60 frames in four modes, every one compared byte for byte: out/walk.json, out/walk"
"$bench" walk --frames 60 --size 960x720 --modes stock,none,nbuffer,oracle --verify \
  --json "$out/walk.json" --images "$out/walk"

nbuffer_say "4 of 4: pictures of what is culled, and of the levels of the N-buffer"
"$bench" pictures --size 960x720 --out "$out"

nbuffer_say "Written to out/"
(cd "$out" && find . -type f | sort)

nbuffer_say "The same walk in README.md"
python3 "$nbuffer_source/Scripts/check_headline.py" "$out/walk.json"
