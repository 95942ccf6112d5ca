#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds in build/, walks through the city with and without the culler
# and writes out/: pictures, a chart, and the figures as JSON. A few minutes the first time.

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

nbuffer_setup

bench="$nbuffer_build/bin/nbuffer-bench"
out="$nbuffer_source/out"
mkdir -p "$out"

nbuffer_say "A walk along the streets: 60 frames in four modes, every one compared byte for byte"
"$bench" walk --frames 60 --size 960x720 --modes stock,none,nbuffer,oracle --verify \
  --json "$out/walk.json" --images "$out/walk"

nbuffer_say "Pictures: what is culled, and the levels of the N-buffer"
"$bench" pictures --size 960x720 --no-chart --out "$out"

nbuffer_say "Shadows: a city, hills, a room"
"$nbuffer_build/bin/shadow-city" --size 480x360 --out "$out" --hour 5 --until 19 --step 2
"$nbuffer_build/bin/shadow-terrain" --size 480x360 --out "$out"
"$nbuffer_build/bin/shadow-room" --size 480x360 --out "$out"

nbuffer_say "Written to out/"
(cd "$out" && find . -type f | sort)
