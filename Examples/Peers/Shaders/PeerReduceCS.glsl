#version 430
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// One level: texel (x, y) holds the farthest of factor x factor depth pixels, fewer at the edges.
// A work group of 16 x 16 invocations reads a pixel each and combines them in shared memory:
//
//     factor 4: 16 cells      factor 8: 4 cells      factor 16: 1 cell
//     +--+--+--+--+           +-----+-----+          +-----------+
//     +--+--+--+--+           |     |     |          |           |
//     +--+--+--+--+           +-----+-----+          |           |
//     +--+--+--+--+           |     |     |          |           |
//     +--+--+--+--+           +-----+-----+          +-----------+
//
// There are no atomics for floats, but floats that are not negative are in the order of their bits.

layout(local_size_x = 16, local_size_y = 16) in;

uniform sampler2D depth;
uniform ivec2 size; // of the depth image, in pixels
uniform int factor; // 4, 8 or 16
layout(r32f, binding = 0) uniform writeonly image2D level;

shared uint cells[16];

void main()
{
  if (gl_LocalInvocationIndex < 16u)
  {
    cells[gl_LocalInvocationIndex] = 0u;
  }
  barrier();
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 cell = ivec2(gl_LocalInvocationID.xy) / factor;
  int index = cell.y * (16 / factor) + cell.x;
  if (all(lessThan(pixel, size)))
  {
    // -0 has the largest bits of all: it becomes 0.
    atomicMax(cells[index], floatBitsToUint(max(texelFetch(depth, pixel, 0).r, 0.0)));
  }
  barrier();
  bool first = all(equal(pixel, (pixel / factor) * factor));
  if (first && all(lessThan(pixel, size)))
  {
    imageStore(level, pixel / factor, vec4(uintBitsToFloat(cells[index])));
  }
}
