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
#
# The last line is "N passed, N failed, N skipped" and counts each case once; the line before says on
# which VTKs and windows. What has to run follows from what ctest lists: summarize_tests.py.

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

one_vtk="${VTK_DIR:-}${VTK_ROOT:-}${CMAKE_PREFIX_PATH:-}"
if [[ "${1:-}" == --one-vtk ]]; then
  one_vtk=yes
  shift
fi

folders=()
status=0
# run_tests <folder> <command that runs ctest...>
run_tests() {
  local folder=$1
  shift
  folders+=("$folder")
  rm -f "$folder/test-results.xml"
  ctest --test-dir "$folder" --build-config Release --show-only=json-v1 \
    "${ctest_arguments[@]}" >"$folder/test-list.json" || nbuffer_fail "ctest lists no tests"
  # The summary reads all that tests print.
  "$@" --test-dir "$folder" --build-config Release --parallel 2 --output-on-failure \
    --output-junit "$folder/test-results.xml" \
    --test-output-size-passed 10000000 --test-output-size-failed 10000000 \
    "${ctest_arguments[@]}" || status=$?
}
ctest_arguments=("$@")

# Everything, not what the arguments of this script name.
# shellcheck disable=SC2119
nbuffer_setup
nbuffer_say "Tests"
run_tests "$nbuffer_build" ctest

if [[ -z "$one_vtk" ]] && nbuffer_setup_debian_vtk; then
  nbuffer_say "Tests with the distribution's VTK"
  run_tests "$nbuffer_debian_build" \
    xvfb-run --auto-servernum --server-args "-screen 0 1280x1024x24 -noreset" ctest
fi

python3 "$nbuffer_source/Scripts/summarize_tests.py" "${folders[@]}" --status "$status" \
  ${1:+--partial}
