#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds in build/ and runs the tests: with VTK 9.7 from PyPI, and on a
# Debian system with the distribution's VTK as well, in build/debian-vtk under Xvfb. With VTK_DIR,
# VTK_ROOT or CMAKE_PREFIX_PATH in the environment, that VTK is the only one.
#
#   Scripts/test.sh                    every test
#   Scripts/test.sh -L unit            arguments are ctest's; labels: ctest --print-labels
#   Scripts/test.sh --one-vtk          not with the distribution's VTK
#   Scripts/test.sh --minimum 90       fails if fewer tests ran (skipped ones did not run)
#
# The last line is "N passed, N failed, N skipped".

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

minimum=0
one_vtk="${VTK_DIR:-}${VTK_ROOT:-}${CMAKE_PREFIX_PATH:-}"
while (($#)); do
  case "$1" in
    --minimum)
      [[ "${2:-}" =~ ^[0-9]+$ ]] || nbuffer_fail "--minimum wants a number"
      minimum=$2
      shift 2
      ;;
    --one-vtk)
      one_vtk=yes
      shift
      ;;
    *) break ;;
  esac
done

results=()
status=0
# run_tests <folder> <command that runs ctest...>
run_tests() {
  local folder=$1
  shift
  results+=("$folder/test-results.xml")
  rm -f "${results[-1]}"
  "$@" --test-dir "$folder" --build-config Release --parallel 2 --output-on-failure \
    --output-junit "${results[-1]}" "${ctest_arguments[@]}" || status=$?
}
ctest_arguments=("$@")

nbuffer_setup
nbuffer_say "Tests"
run_tests "$nbuffer_build" ctest

if [[ -z "$one_vtk" ]] && nbuffer_setup_debian_vtk; then
  nbuffer_say "Tests with the distribution's VTK"
  run_tests "$nbuffer_debian_build" \
    xvfb-run --auto-servernum --server-args "-screen 0 1280x1024x24 -noreset" ctest
fi

python3 "$nbuffer_source/Scripts/summarize_tests.py" "${results[@]}" \
  --minimum "$minimum" --status "$status"
