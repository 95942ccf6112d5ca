#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs the tests under tools that find memory errors; installs what is missing, as test.sh does.
#
#   Scripts/sanitize.sh                  address, leak and undefined-behaviour sanitizers: the unit,
#                                        GPU, image, leak, fuzz and shadow tests under OSMesa and 60
#                                        frames of a walk, in build-asan-ubsan/ (the preset asan-ubsan)
#   Scripts/sanitize.sh -L unit          arguments are ctest's
#   Scripts/sanitize.sh valgrind         valgrind's memcheck: a small part of the tests, with the
#                                        optimised build in build/
#
# VTK and Mesa are not instrumented. What the tools find in them is listed, with the reason, in
# Testing/Sanitizers. The exit status is 0 only if nothing else was found.

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

run_sanitizers() {
  mkdir -p "$nbuffer_state"
  nbuffer_install_packages requirements-debian.txt
  nbuffer_install_tools
  nbuffer_fetch_vtk
  cd "$nbuffer_source"
  nbuffer_say "Configure and build with sanitizers"
  cmake --preset asan-ubsan "${nbuffer_vtk[@]}"
  cmake --build --preset asan-ubsan
  nbuffer_say "Tests"
  ctest --preset asan-ubsan --parallel 2 "$@"
  if (($# == 0)); then
    nbuffer_say "A walk"
    # As the preset has it for the tests.
    VTK_DEFAULT_OPENGL_WINDOW=vtkOSOpenGLRenderWindow \
      LSAN_OPTIONS="suppressions=$nbuffer_source/Testing/Sanitizers/lsan.supp" \
      UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
      build-asan-ubsan/bin/nbuffer-bench walk --frames 60 --block 1 --modes nbuffer
  fi
}

# valgrind_run <program> <filter of GoogleTest>
valgrind_run() {
  nbuffer_say "valgrind: $1 $2"
  # Generated code of llvmpipe is slow to translate: softpipe has none.
  GALLIUM_DRIVER=softpipe VTK_DEFAULT_OPENGL_WINDOW=vtkOSOpenGLRenderWindow \
    valgrind --quiet --error-exitcode=1 --num-callers=30 --leak-check=full \
    --show-leak-kinds=definite --errors-for-leak-kinds=definite \
    --suppressions="$nbuffer_source/Testing/Sanitizers/valgrind.supp" \
    "$nbuffer_build/bin/$1" --gtest_filter="$2" --gtest_brief=1
}

run_valgrind() {
  nbuffer_setup nbuffer-unit-tests nbuffer-gpu-tests nbuffer-image-tests nbuffer-leak-tests
  nbuffer_install_packages requirements-debian-valgrind.txt
  # Random searches repeat the same code for minutes.
  valgrind_run nbuffer-unit-tests \
    'NBufferMath*:*Once.*:NBufferLevels.EveryRectangleOfSmallImages:NBufferTieOrder*:NBufferBackOff*:NBufferStatistics*'
  valgrind_run nbuffer-gpu-tests 'GpuTestNBufferTexture.*'
  valgrind_run nbuffer-image-tests 'CullerBasics.NoPropsAndOneProp:CullerChangesOnce.EverythingMoves'
  valgrind_run nbuffer-leak-tests '-LeaksOverManyFrames.*'
}

if [[ "${1:-}" == valgrind ]]; then
  run_valgrind
else
  run_sanitizers "$@"
fi
