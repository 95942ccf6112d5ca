#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Make a compact city file (buildings and streets) from an OpenStreetMap
# extract: .osm, .osm.bz2, .osm.gz or .osm.pbf. Further arguments go to
# nbuffer-city. The result stays under the ODbL, see Examples/Data/README.md.
set -eu

if [ $# -lt 2 ]; then
  echo "usage: $0 EXTRACT OUTPUT.city [--multipolygons]" >&2
  exit 1
fi

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=${NBUFFER_BUILD:-$root/build}
tool=$build/bin/nbuffer-city

if [ ! -x "$tool" ]; then
  if [ ! -f "$build/CMakeCache.txt" ]; then
    echo "$0: $build is no build folder. Run Scripts/demo.sh once, or set NBUFFER_BUILD." >&2
    exit 1
  fi
  cmake --build "$build" --target nbuffer-city
fi

exec "$tool" "$@"
