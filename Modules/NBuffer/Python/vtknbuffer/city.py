# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The city that the demonstration walks through, as NumPy arrays.

Data of OpenStreetMap, (c) OpenStreetMap contributors, under the Open Database License 1.0; the
heights are synthetic. Examples/Common/CityFile.h describes the format of the file.
"""

import gzip
import pathlib

import numpy as np

FILE = pathlib.Path(__file__).with_name("neubrandenburg.city")


class _Reader:
    """Reads numbers, strings and points, one after the other."""

    def __init__(self, data):
        self._data = data
        self._place = 0
        self._point = np.zeros(2, int)

    def bytes(self, count):
        self._place += count
        if self._place > len(self._data):
            raise ValueError("the file is cut short")
        return self._data[self._place - count:self._place]

    def unsigned(self):
        value = shift = 0
        while True:
            byte = self.bytes(1)[0]
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def signed(self):
        folded = self.unsigned()
        return -(folded + 1) // 2 if folded & 1 else folded // 2

    def text(self):
        return self.bytes(self.unsigned()).decode()

    def points(self):
        """An array of points in metres."""
        points = np.empty((self.unsigned(), 2))
        for i in range(len(points)):
            self._point = self._point + (self.signed(), self.signed())
            points[i] = self._point / 100
        return points


def read(path=FILE):
    """Return a list of buildings (outline, height in metres) and a list of streets (line)."""
    with gzip.open(path) as stream:
        reader = _Reader(stream.read())
    if reader.bytes(12) != b"NBufferCity\n" or reader.unsigned() != 1:
        raise ValueError(f"{path} is no city file of version 1")
    reader.text()
    reader.signed(), reader.signed()
    [reader.text() for _ in range(reader.unsigned())]
    buildings = []
    for _ in range(reader.unsigned()):
        reader.unsigned()
        height = reader.unsigned() / 100
        rings = [reader.points() for _ in range(reader.unsigned())]
        buildings.append((rings[0], height))
    streets = []
    for _ in range(reader.unsigned()):
        reader.unsigned()
        streets.append(reader.points())
    return buildings, streets


def walls_and_roof(outline, height):
    """Return the points and the polygons of a building, as vtkPolyData takes them."""
    n = len(outline)
    points = np.zeros((2 * n, 3))
    points[:n, :2] = points[n:, :2] = outline
    points[n:, 2] = height
    i = np.arange(n)
    j = (i + 1) % n
    walls = np.column_stack((np.full(n, 4), i, j, j + n, i + n))
    return points, np.concatenate((walls.ravel(), [n], i + n))


def walk(buildings, streets, frames, step=1.0, eye=1.7):
    """Return the eye points and the focal points of a walk along a street with many houses."""
    middles = np.array([outline.mean(axis=0) for outline, _ in buildings])

    def corners_of(line):
        return np.concatenate(([0], np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum()))

    def houses(line):
        return (np.linalg.norm(middles - line[len(line) // 2], axis=1) < 150).sum()

    line = max((line for line in streets if corners_of(line)[-1] > 150), key=houses)
    corners = corners_of(line)
    ahead = 10.0
    places = np.linspace(0, min(frames * step, corners[-1] - ahead), frames)

    def at(place):
        return np.column_stack([np.interp(place, corners, line[:, k]) for k in (0, 1)]
                               + [np.full(frames, eye)])
    return at(places), at(places + ahead)
