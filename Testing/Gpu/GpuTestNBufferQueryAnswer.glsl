// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The answers to one query: what the functions of vtkNBufferQuery.glsl return.
uniform sampler2DArray even;
uniform sampler2DArray odd;
uniform NBufferShape shape;
uniform sampler2D queries; // column i: a rectangle in row 0; a depth and a level in row 1
uniform bool isMaximum;

// Pixels as one number: 9 bits for each coordinate, and 3 for each side.
float Pack(ivec4 pixels)
{
  ivec2 side = (pixels.zw - pixels.xy) % 8;
  return float(pixels.x + 512 * (pixels.y + 512 * (side.x + 8 * side.y)));
}

vec4 GetAnswer(int i)
{
  ivec4 pixels = ivec4(texelFetch(queries, ivec2(i, 0), 0));
  vec4 depth = texelFetch(queries, ivec2(i, 1), 0);
  if (isMaximum)
  {
    return vec4(NBufferFarthest(even, odd, shape, pixels),
      NBufferHides(even, odd, shape, pixels, depth.x) ? 1.0 : 0.0,
      NBufferFarthestOfSquare(even, odd, shape, pixels.xy, int(depth.y)),
      Pack(NBufferFarthestPixels(even, odd, shape, pixels)));
  }
  return vec4(NBufferNearestInOne(even, odd, shape, pixels),
    NBufferShows(even, odd, shape, pixels, depth.x) ? 1.0 : 0.0, 0.0,
    Pack(NBufferNearestPixels(even, odd, shape, pixels)));
}
