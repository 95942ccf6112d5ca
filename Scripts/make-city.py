#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a city file of the examples (buildings and streets) from an OpenStreetMap extract.

    make-city.py EXTRACT OUTPUT.city

The extract is XML: .osm, .osm.bz2 or .osm.gz (`osmium cat` makes XML of .osm.pbf). A building is every
closed way with the tag "building", whatever its value, of at least 4 square metres. Streets are all ways
with the tag "highway" but areas, tunnels, and what is not (yet) there. Heights come from the tags "height"
and "building:levels"; all others are synthetic. The result stays under the ODbL, see
Examples/Data/README.md. Examples/Common/City.h describes the projection, CityFile.h the format.
"""

import argparse
import bz2
import gzip
import math
import pathlib
import re
import sys
import xml.etree.ElementTree
import zlib

EARTH_RADIUS = 6371008.8  # metres
SMALLEST_BUILDING = 4.0  # square metres
NO_STREETS = ("proposed", "construction", "corridor")
ATTRIBUTION = "(c) OpenStreetMap contributors, Open Database License (ODbL) 1.0"
SYNTHETIC, TAG, LEVELS = range(3)  # where a height comes from

# The rule for the heights of buildings that carry none: footprints up to so many square metres are sheds
# and garages, bungalows, houses, blocks of flats, larger blocks, and halls; so many metres low and high.
CLASSES = ((30, 2.4, 3.0), (80, 2.8, 5.0), (250, 6.0, 10.0), (600, 9.0, 17.0), (2000, 10.0, 24.0),
           (math.inf, 7.0, 14.0))


def nearest(value):
    """The nearest whole number; halves are rounded away from 0."""
    return int(math.copysign(math.floor(abs(value) + 0.5), value))


def synthetic_height(area, seed):
    """Spreads heights evenly within the class of the area. Plausible for a Central European town and not
    more. The finaliser of MurmurHash3 gives neighbouring ids unrelated heights."""
    mask = (1 << 64) - 1
    for factor in (0xff51afd7ed558ccd, 0xc4ceb9fe1a85ec53):
        seed ^= seed >> 33
        seed = seed * factor & mask
    seed ^= seed >> 33
    low, high = next((low, high) for most, low, high in CLASSES if area <= most)
    return low + (seed >> 11) / 2**53 * (high - low)


def metres(text):
    """Metres at the beginning of a tag ("12", "12.5 m"), 0 for none. "40 ft" and 7'4" are converted."""
    match = re.match(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", text or "", re.DOTALL)
    value = float(match[1]) if match else 0.0
    feet = match and ("ft" in match[2] or match[2].startswith("'"))
    return value * (0.3048 if feet else 1.0) if 0.0 < value < 1000.0 else 0.0


def height_of(tags):
    tagged, levels = metres(tags.get("height")), metres(tags.get("building:levels"))
    if tagged:
        return tagged, TAG
    return (3.0 * levels + 1.0, LEVELS) if levels else (0.0, SYNTHETIC)


def without_repeats(points):
    return [point for i, point in enumerate(points) if i == 0 or point != points[i - 1]]


def read(file):
    """Buildings as (id, tags, points) and streets as (kind, points), and how many were left out. Points are
    latitude and longitude in units of 1e-7 degrees."""
    opener = {".bz2": bz2.open, ".gz": gzip.open}.get(file.suffix, open)
    places, buildings, streets = {}, [], []
    left_out = {"not closed": 0, "cut off by the extract": 0}
    with opener(file, "rb") as stream:
        for _, entry in xml.etree.ElementTree.iterparse(stream):
            if entry.tag == "node" and "lat" in entry.attrib:
                places[entry.get("id")] = tuple(
                    nearest(float(entry.get(name)) * 1e7) for name in ("lat", "lon"))
            if entry.tag == "way":
                tags = {tag.get("k"): tag.get("v") for tag in entry.iter("tag")}
                nodes = [node.get("ref") for node in entry.iter("nd")]
                points = without_repeats([places.get(node) for node in nodes])
                if "building" in tags:
                    if None in points:
                        left_out["cut off by the extract"] += 1
                    elif nodes[:1] != nodes[-1:] or len(points) < 4:
                        left_out["not closed"] += 1
                    else:
                        buildings.append((int(entry.get("id")), tags, points))
                kind = tags.get("highway")
                if (kind and kind not in NO_STREETS and tags.get("area") != "yes"
                        and "tunnel" not in tags and None not in points and len(points) > 1):
                    streets.append((kind, points))
            if entry.tag in ("node", "way", "relation"):
                entry.clear()
    if not buildings:
        raise SystemExit(f'make-city.py: {file} holds no closed way with the tag "building"')
    return buildings, streets, left_out


def project(points, centre):
    """Centimetres east and north of the centre."""
    scale = EARTH_RADIUS * (math.pi / 180.0) / 0.01
    shrink = math.cos(centre[0] * (math.pi / 180.0))
    return without_repeats([
        (nearest(scale * shrink * (longitude / 1e7 - centre[1])),
         nearest(scale * (latitude / 1e7 - centre[0]))) for latitude, longitude in points])


class Writer:
    """Numbers in seven bits a byte, the low ones first; points as differences from the one before."""

    def __init__(self):
        self.bytes = bytearray(b"NBufferCity\n")
        self.last = (0, 0)

    def unsigned(self, value):
        while value >= 0x80:
            self.bytes.append(value & 0x7f | 0x80)
            value >>= 7
        self.bytes.append(value)

    def signed(self, value):
        self.unsigned(~(value << 1) if value < 0 else value << 1)

    def string(self, text):
        self.unsigned(len(text.encode()))
        self.bytes += text.encode()

    def points(self, points):
        self.unsigned(len(points))
        for point in points:
            self.signed(point[0] - self.last[0])
            self.signed(point[1] - self.last[1])
            self.last = point


def make_buildings(buildings, centre):
    """Yields height, where it comes from, and the ring, counterclockwise."""
    for number, tags, points in buildings:
        ring = project(points, centre)
        if ring[0] == ring[-1]:
            ring.pop()
        doubled = float(sum(ring[i - 1][0] * ring[i][1] - ring[i][0] * ring[i - 1][1]
                            for i in range(len(ring))))
        area = 0.5 * abs(doubled) * 0.01 * 0.01
        if len(ring) >= 3 and area >= SMALLEST_BUILDING:
            height, source = height_of(tags)
            height = height if source != SYNTHETIC else synthetic_height(area, number)
            yield nearest(height / 0.01), source, ring if doubled > 0 else ring[::-1]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("extract", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    options = parser.parse_args()
    try:
        buildings, streets, left_out = read(options.extract)
    except (OSError, EOFError, zlib.error, xml.etree.ElementTree.ParseError, TypeError,
            ValueError) as error:
        raise SystemExit(f"make-city.py: cannot read {options.extract} as XML of OpenStreetMap "
                         f"(.osm, .osm.bz2 or .osm.gz): {error}") from error
    corners = [point for _, _, points in buildings for point in points]
    centre = [nearest((min(axis) / 1e7 + max(axis) / 1e7) * 5e6) / 1e7 for axis in zip(*corners)]
    made = list(make_buildings(buildings, centre))
    lines = [(kind, project(points, centre)) for kind, points in streets]
    lines = [(kind, points) for kind, points in lines if len(points) > 1]
    kinds = list(dict.fromkeys(kind for kind, _ in lines))

    writer = Writer()
    writer.unsigned(1)  # the version of the format
    writer.string(ATTRIBUTION)
    for degrees in centre:
        writer.signed(nearest(degrees / 1e-7))
    writer.unsigned(len(kinds))
    for kind in kinds:
        writer.string(kind)
    writer.unsigned(len(made))
    for height, source, ring in made:
        writer.unsigned(source)
        writer.unsigned(height)
        writer.unsigned(1)
        writer.points(ring)
    writer.unsigned(len(lines))
    for kind, points in lines:
        writer.unsigned(kinds.index(kind))
        writer.points(points)
    # No name and no time: the file depends on its contents alone.
    try:
        with open(options.output, "wb") as file, gzip.GzipFile("", "wb", 9, file, 0) as packed:
            packed.write(writer.bytes)
    except OSError as error:
        raise SystemExit(f"make-city.py: {error}") from error
    sources = [source for _, source, _ in made]
    print(f"{len(made)} buildings; left out: {len(buildings) - len(made)} too small, "
          + ", ".join(f"{count} {why}" for why, count in left_out.items()))
    print(f"heights: {sources.count(TAG)} tagged, {sources.count(LEVELS)} from storeys, "
          f"{sources.count(SYNTHETIC)} synthetic")
    print(f"{len(lines)} streets of {len(kinds)} kinds; centre: {centre[0]}, {centre[1]}")


if __name__ == "__main__":
    sys.exit(main())
