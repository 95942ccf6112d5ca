#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds in build/ and runs the tests.
#
#   Scripts/test.sh                    every test
#   Scripts/test.sh -L unit            arguments are ctest's; labels: ctest --print-labels
#   Scripts/test.sh --minimum 90       fails if fewer tests ran (skipped ones did not run)
#
# The last line is "N passed, N failed, N skipped".

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

minimum=0
if [[ "${1:-}" == --minimum ]]; then
  [[ "${2:-}" =~ ^[0-9]+$ ]] || nbuffer_fail "--minimum wants a number"
  minimum=$2
  shift 2
fi

nbuffer_setup

nbuffer_say "Tests"
results="$nbuffer_build/test-results.xml"
rm -f "$results"
status=0
ctest --test-dir "$nbuffer_build" --build-config Release --parallel 2 --output-on-failure \
  --output-junit "$results" "$@" || status=$?
python3 "$nbuffer_source/Scripts/summarize_tests.py" "$results" \
  --minimum "$minimum" --status "$status"
