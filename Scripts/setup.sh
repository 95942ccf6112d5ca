# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
#
# What demo.sh, test.sh and sanitize.sh share; they source this file and call nbuffer_setup, which
#
#   1. installs the Debian packages of requirements-debian.txt that are missing (root only),
#   2. puts CMake and Ninja from PyPI into build/setup/tools, pinned by version and hash,
#   3. puts VTK 9.7.0 from PyPI into build/setup/vtk, pinned likewise; with VTK_DIR, VTK_ROOT or
#      CMAKE_PREFIX_PATH in the environment it takes that VTK instead,
#   4. configures and builds in build/, programs in build/bin/: the targets that it is given, or
#      everything; nbuffer_build builds further ones.
#
# nbuffer_setup_debian_vtk does 4 with the distribution's VTK, in build/debian-vtk, everything.
#
# Each step leaves a stamp and is skipped when nothing of what it depends on has changed.

set -euo pipefail

nbuffer_source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
nbuffer_build="$nbuffer_source/build"
nbuffer_debian_build="$nbuffer_build/debian-vtk"
nbuffer_state="$nbuffer_build/setup"

# What follows, with the minutes and seconds since the script was started.
nbuffer_say() {
  printf '\n== %d:%02d  %s\n' "$((SECONDS / 60))" "$((SECONDS % 60))" "$*"
}

nbuffer_fail() {
  printf '\nerror: %s\n' "$*" >&2
  exit 1
}

# Runs a chatty command with its output in a log, which is shown only if the command fails; a dot
# for every second that it takes.
nbuffer_quietly() {
  local log="$nbuffer_state/$1.log"
  shift
  "$@" >"$log" 2>&1 &
  local process=$!
  while kill -0 "$process" 2>/dev/null; do
    printf .
    sleep 1
  done
  printf '\n'
  if ! wait "$process"; then
    tail -n 40 "$log" >&2
    nbuffer_fail "'$*' failed; the whole output is in $log"
  fi
}

# A stamp holds a checksum of what the step was made from.
nbuffer_checksum() {
  cat "$@" | sha256sum | cut -d ' ' -f 1
}

nbuffer_is_done() {
  [[ -f "$nbuffer_state/$1.stamp" && "$(<"$nbuffer_state/$1.stamp")" == "$2" ]]
}

nbuffer_mark_done() {
  printf '%s\n' "$2" >"$nbuffer_state/$1.stamp"
}

# The packages named in a file of requirements.
nbuffer_wanted_packages() {
  sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$nbuffer_source/Scripts/$1"
}

# Those of them that are not installed.
nbuffer_missing_packages() {
  local name
  for name in $(nbuffer_wanted_packages "$1"); do
    if [[ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" != installed ]]; then
      printf '%s\n' "$name"
    fi
  done
}

nbuffer_install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    nbuffer_say "Packages: no Debian system; needed are what Debian calls" \
      "$(nbuffer_wanted_packages "$1" | tr '\n' ' ')"
    return
  fi
  local -a missing
  mapfile -t missing < <(nbuffer_missing_packages "$1")
  if ((${#missing[@]} == 0)); then
    nbuffer_say "Packages: all installed"
    return
  fi
  if ((EUID != 0)); then
    nbuffer_fail "these packages are missing and only root can install them; please run
    sudo apt-get install --no-install-recommends ${missing[*]}
and then this script again."
  fi
  nbuffer_say "Packages: installing ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  nbuffer_quietly apt-update apt-get -o DPkg::Lock::Timeout=300 update
  nbuffer_quietly apt-install apt-get -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 \
    install --yes --no-install-recommends "${missing[@]}"
}

nbuffer_install_tools() {
  local requirements="$nbuffer_source/Scripts/requirements-tools.txt"
  local tools="$nbuffer_state/tools"
  local sum
  sum=$(nbuffer_checksum "$requirements")
  # A virtual environment knows its own place: one that was moved is made anew.
  if ! nbuffer_is_done tools "$sum $tools" || ! "$tools/bin/cmake" --version >/dev/null 2>&1; then
    nbuffer_say "Tools: CMake and Ninja from PyPI"
    rm -rf "$tools"
    nbuffer_quietly venv python3 -m venv "$tools"
    nbuffer_quietly tools "$tools/bin/python" -m pip install --disable-pip-version-check \
      --no-deps --only-binary=:all: --require-hashes -r "$requirements"
    nbuffer_mark_done tools "$sum $tools"
  fi
  export PATH="$tools/bin:$PATH"
}

# Sets nbuffer_vtk to the arguments that tell CMake which VTK to take, none for the user's own.
nbuffer_fetch_vtk() {
  if [[ -n "${VTK_DIR:-}${VTK_ROOT:-}${CMAKE_PREFIX_PATH:-}" ]]; then
    nbuffer_say "VTK: from the environment (VTK_DIR, VTK_ROOT or CMAKE_PREFIX_PATH)"
    nbuffer_vtk=()
    if [[ -n "${VTK_DIR:-}" ]]; then
      nbuffer_vtk=("-DVTK_DIR=$VTK_DIR")
    fi
    return
  fi
  local requirements="$nbuffer_source/Scripts/requirements-vtk.txt"
  local vtk="$nbuffer_state/vtk"
  local sum
  sum=$(nbuffer_checksum "$requirements")
  if ! nbuffer_is_done vtk "$sum"; then
    nbuffer_say "VTK: 9.7.0 from PyPI (58 MB)"
    rm -rf "$vtk"
    # The package asks for Python 3.12, but what C++ needs of it runs no Python at all.
    nbuffer_quietly vtk "$nbuffer_state/tools/bin/python" -m pip install \
      --disable-pip-version-check --no-compile --no-deps --only-binary=:all: --require-hashes \
      --ignore-requires-python --target "$vtk" -r "$requirements"
    nbuffer_mark_done vtk "$sum"
  fi
  nbuffer_vtk=("-DCMAKE_PREFIX_PATH=$vtk/cvista_sdk/cmake")
}

# nbuffer_configure <stamp> <folder> <arguments for CMake...>
nbuffer_configure() {
  local stamp=$1 folder=$2
  shift 2
  # Another VTK or another place of the sources: a fresh cache.
  local choice="$nbuffer_source $* ${VTK_DIR:-} ${VTK_ROOT:-} ${CMAKE_PREFIX_PATH:-}"
  local -a fresh=()
  if ! nbuffer_is_done "$stamp" "$choice"; then
    fresh=(--fresh)
  fi
  nbuffer_say "Configure"
  cmake "${fresh[@]}" -S "$nbuffer_source" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" ||
    nbuffer_fail "CMake could not configure $folder"
  nbuffer_mark_done "$stamp" "$choice"
}

# nbuffer_build <folder> [targets...]: all of them where none is named.
nbuffer_build() {
  local folder=$1
  shift
  nbuffer_say "Build: ${*:-everything}"
  cmake --build "$folder" ${1:+--target "$@"} || nbuffer_fail "the build in $folder failed"
}

# nbuffer_setup [targets...]
nbuffer_setup() {
  mkdir -p "$nbuffer_state"
  nbuffer_install_packages requirements-debian.txt
  nbuffer_install_tools
  nbuffer_fetch_vtk
  nbuffer_configure configure "$nbuffer_build" "${nbuffer_vtk[@]}"
  nbuffer_build "$nbuffer_build" "$@"
  # No X server: VTK's window in memory, unless the user wants another one.
  export VTK_DEFAULT_OPENGL_WINDOW="${VTK_DEFAULT_OPENGL_WINDOW:-vtkOSOpenGLRenderWindow}"
}

# After nbuffer_setup. Returns 1, with the reason printed, where there is no such VTK.
nbuffer_setup_debian_vtk() {
  local requirements=requirements-debian-vtk.txt
  if ! command -v dpkg-query >/dev/null; then
    nbuffer_say "SKIPPED: the distribution's VTK: no Debian system"
    return 1
  fi
  if ((EUID != 0)) && [[ -n "$(nbuffer_missing_packages $requirements)" ]]; then
    nbuffer_say "SKIPPED: the distribution's VTK: only root can install" \
      "$(nbuffer_missing_packages $requirements | tr '\n' ' ')"
    return 1
  fi
  nbuffer_install_packages $requirements
  local config
  config=$(dpkg-query -L libvtk9-dev | grep '/vtk-config\.cmake$')
  nbuffer_configure configure-debian-vtk "$nbuffer_debian_build" "-DVTK_DIR=${config%/*}" \
    -DVTKNBUFFER_WRAP_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
  nbuffer_build "$nbuffer_debian_build"
}
