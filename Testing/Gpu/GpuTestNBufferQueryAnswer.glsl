// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The answers to one query: what the functions of vtkNBufferQuery.glsl return.
uniform sampler2DArray even;
uniform sampler2DArray odd;
uniform NBufferShape shape;
uniform sampler2D queries; // column i: a rectangle in row 0; a depth and a level in row 1
uniform bool isMaximum;

vec4 GetAnswer(int i)
{
  ivec4 pixels = ivec4(texelFetch(queries, ivec2(i, 0), 0));
  vec4 depth = texelFetch(queries, ivec2(i, 1), 0);
  if (isMaximum)
  {
    // The pixels as one number: 9 bits for each coordinate, and 3 for each side.
    ivec4 place = NBufferFarthestPixels(even, odd, shape, pixels);
    ivec2 side = (place.zw - place.xy) % 8;
    return vec4(NBufferFarthest(even, odd, shape, pixels),
      NBufferHides(even, odd, shape, pixels, depth.x) ? 1.0 : 0.0,
      NBufferFarthestOfSquare(even, odd, shape, pixels.xy, int(depth.y)),
      float(place.x + 512 * (place.y + 512 * (side.x + 8 * side.y))));
  }
  return vec4(NBufferNearestInOne(even, odd, shape, pixels),
    NBufferShows(even, odd, shape, pixels, depth.x) ? 1.0 : 0.0, 0.0, 0.0);
}
