#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Scripts/study.sh [--quick] [FILE...]
#
# The study of the city and the other scenes, and then of every scene file named: out/study and
# out/study-NAME. Scenes that this repository must not hold are taken out of Debian's packages once,
# by Scripts/make-scenes.sh; those that are missing are left out, and the study says so.

set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bench=${NBUFFER_BENCH:-$source/build/bin/nbuffer-bench}
if [[ ! -x $bench ]]; then
  echo "$bench is missing: build it (Scripts/demo.sh), or name it in NBUFFER_BENCH" >&2
  exit 1
fi

options=()
if [[ ${1:-} == --quick ]]; then
  options+=(--quick)
  shift
fi
"$bench" study "${options[@]}" --scenes "$source/out/scenes" --out out/study
for file in "$@"; do
  name=$(basename "$file")
  "$bench" study "${options[@]}" --scene "$file" --out "out/study-${name%%.*}"
done
