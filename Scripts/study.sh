#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Scripts/study.sh [--quick] [FILE...]
#
# The study of the city, and then of every scene file named: out/study and out/study-NAME. Scenes
# that this repository must not hold come from Debian's packages; the negative control for example:
#
#     apt-get download openfoam-examples && dpkg -x openfoam-examples_*.deb openfoam
#     Scripts/study.sh $(find openfoam -name motorBike.obj.gz)

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
"$bench" study "${options[@]}" --out out/study
for file in "$@"; do
  name=$(basename "$file")
  "$bench" study "${options[@]}" --scene "$file" --out "out/study-${name%%.*}"
done
