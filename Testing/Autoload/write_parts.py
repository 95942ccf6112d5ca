#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""write_parts.py FILE.gltf: a wall with 2,000 parts behind it, each a node of its own."""

import base64
import json
import struct
import sys

CORNERS = [(x, y, z) for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
TRIANGLES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7),
             (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def make_scene():
    points = b"".join(struct.pack("<3f", *corner) for corner in CORNERS)
    indices = b"".join(struct.pack("<3H", *triangle) for triangle in TRIANGLES)
    nodes = [{"mesh": 0, "translation": [0, 0, 0], "scale": [36, 19, 1]}]
    for i in range(2000):
        nodes.append({"mesh": 1 + i % 3,
                      "translation": [i % 40 - 19.5, i // 40 % 10 * 2 - 9, -3 - i // 400 * 3],
                      "scale": [0.7, 1.2, 0.7]})
    colors = [[0.7, 0.7, 0.6], [0.8, 0.2, 0.1], [0.2, 0.6, 0.3], [0.2, 0.3, 0.8]]
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": i}]}
                   for i in range(len(colors))],
        "materials": [{"pbrMetallicRoughness": {
            "baseColorFactor": [*color, 1], "metallicFactor": 0}} for color in colors],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(CORNERS), "type": "VEC3",
             "min": [-0.5] * 3, "max": [0.5] * 3},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(TRIANGLES),
             "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(points)},
            {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)}],
        "buffers": [{
            "byteLength": len(points) + len(indices),
            "uri": "data:application/octet-stream;base64,"
                   + base64.b64encode(points + indices).decode()}]}


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        json.dump(make_scene(), file)
