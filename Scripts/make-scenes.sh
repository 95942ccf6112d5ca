#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Scripts/make-scenes.sh [--packages FOLDER] [--out FOLDER] [arena] [cards] [motorbike]
#
# Scenes for Scripts/study.py that this repository must not hold, taken out of Debian's packages,
# which stay what they are: nothing is installed. All of them where none is named. Packages that are
# not in the folder of packages are downloaded by apt-get into it.
#
#   arena       oa_thor.bsp of openarena-088-data, ctf_inyard.bsp of openarena-081-maps (GPL-2+;
#               112 MB to download)
#   cards       six boards of kicad-demos, and those models of kicad-packages3d that they use
#               (CC-BY-SA-4.0 with KiCad's design exception; 382 MB to download)
#   motorbike   motorBike.obj.gz of openfoam-examples (GPL-3+; 36 MB)

set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$source/out/scenes
packages=

fail() {
  echo "make-scenes.sh: $*" >&2
  exit 1
}

wanted=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --packages | --out)
      [[ $# -gt 1 ]] || fail "$1 needs a folder"
      if [[ $1 == --out ]]; then out=$2; else packages=$2; fi
      shift
      ;;
    arena | cards | motorbike) wanted+=("$1") ;;
    *) fail "unknown: $1; there are arena, cards and motorbike, --packages and --out" ;;
  esac
  shift
done
if [[ ${#wanted[@]} -eq 0 ]]; then
  wanted=(arena cards motorbike)
fi
for tool in dpkg-deb python3; do
  command -v "$tool" >/dev/null || fail "$tool is missing"
done
mkdir -p "$out"
out=$(cd "$out" && pwd)
packages=${packages:-$out/packages}
mkdir -p "$packages"
packages=$(cd "$packages" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The file of a package, downloaded if need be.
find_package() {
  local found
  found=$(find "$packages" -maxdepth 1 -name "$1_*.deb" | sort | tail -n 1)
  if [[ -z $found ]]; then
    command -v apt-get >/dev/null || fail "$packages has no $1_*.deb, and there is no apt-get"
    echo "downloading $1" >&2
    (cd "$packages" && apt-get download "$1" >&2) ||
      fail "apt-get download $1 failed; get the package from packages.debian.org into $packages"
    found=$(find "$packages" -maxdepth 1 -name "$1_*.deb" | sort | tail -n 1)
  fi
  [[ -n $found ]] || fail "no package $1"
  echo "$found"
}

# unpack PACKAGE PATTERN...: files of a package, into the scratch folder.
unpack() {
  local package
  package=$(find_package "$1")
  shift
  dpkg-deb --fsys-tarfile "$package" | tar -x -C "$scratch" --wildcards "$@"
}

# take_map PACKAGE MAP: a map out of the archives (.pk3, which are zip) of a package.
take_map() {
  unpack "$1" '*.pk3'
  python3 - "$scratch" "$2" "$out" <<'EOF'
import pathlib, sys, zipfile

folder, name, out = sys.argv[1:]
for archive in sorted(pathlib.Path(folder).rglob("*.pk3")):
    with zipfile.ZipFile(archive) as files:
        if f"maps/{name}" in files.namelist():
            pathlib.Path(out, name).write_bytes(files.read(f"maps/{name}"))
            break
else:
    sys.exit(f"make-scenes.sh: no archive of the package has maps/{name}")
EOF
  rm -rf "${scratch:?}"/*
  echo "$out/$2"
}

take_cards() {
  local boards=$out/kicad/boards models=$out/kicad/kicad-3dmodels name
  mkdir -p "$boards" "$models"
  unpack kicad-demos '*.kicad_pcb'
  for name in carte_test complex_hierarchy flat_hierarchy kit-dev-coldfire-xilinx_5213 \
    pic_programmer video; do
    find "$scratch" -name "$name.kicad_pcb" -exec cp {} "$boards/" \;
    [[ -f $boards/$name.kicad_pcb ]] || fail "kicad-demos has no board $name"
  done
  rm -rf "${scratch:?}"/*
  # What follows the variable in (model "${KICAD6_3DMODEL_DIR}/..."; KiCad takes VRML for STEP.
  grep -ho '(model "\?${KI[A-Z0-9_]*}/[^" )]*' "$boards"/*.kicad_pcb |
    sed -e 's/^[^}]*}\///' -e 's/\.[a-z]*$/.wrl/' | sort -u >"$out/kicad/models.txt"
  dpkg-deb --fsys-tarfile "$(find_package kicad-packages3d)" |
    tar -x -C "$scratch" --wildcards --no-anchored -T "$out/kicad/models.txt" 2>/dev/null || true
  local folder
  folder=$(find "$scratch" -type d -name '*.3dshapes' -print -quit)
  [[ -n $folder ]] || fail "kicad-packages3d has none of the models of the boards"
  cp -r "$(dirname "$folder")"/. "$models/"
  rm -rf "${scratch:?}"/*
  echo "$out/kicad"
}

for scene in "${wanted[@]}"; do
  case $scene in
    arena)
      take_map openarena-088-data oa_thor.bsp
      take_map openarena-081-maps ctf_inyard.bsp
      ;;
    cards) take_cards ;;
    motorbike)
      unpack openfoam-examples '*/motorBike.obj.gz'
      find "$scratch" -name motorBike.obj.gz -exec cp {} "$out/" \;
      [[ -f $out/motorBike.obj.gz ]] || fail "openfoam-examples has no motorBike.obj.gz"
      rm -rf "${scratch:?}"/*
      echo "$out/motorBike.obj.gz"
      ;;
  esac
done
