// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Functions that query an N-buffer, for vertex and fragment shaders of GLSL 1.50 or later. Insert
// this text into a shader; C++ has it as the string vtkNBufferQuery of vtkNBufferQuery.h. For
// particles, for example, a vertex shader rejects what is hidden:
//
//     uniform sampler2DArray even;  // texture unit of vtkNBufferTexture::GetHandle(0)
//     uniform sampler2DArray odd;   // texture unit of vtkNBufferTexture::GetHandle(1)
//     uniform NBufferShape shape;   // set by the names shape.size, shape.factor and shape.levels
//     ...
//     if (NBufferHides(even, odd, shape, pixels, nearest))
//     {
//       gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside of the clip volume
//     }
//
// Meaning. A vtkNBufferTexture holds maxima (the farthest depth) or minima (the nearest depth), as
// Build() was called for, or both (vtkNBufferTexture::SetBothExtrema()). NBufferFarthestOfSquare(),
// NBufferFarthest(), NBufferFarthestPixels() and NBufferHides() read maxima; NBufferNearestInOne(),
// NBufferNearestPixels() and NBufferShows() read minima. The depths that they find are those of
// vtkNBufferLevels::Query(), and the pixels those of vtkNBufferLevels::FindPixels(), for the same
// levels, bit for bit.
//
// Units. Rectangles are half-open, (x0, y0, x1, y1) with x0 <= x < x1 and y upwards, in pixels that
// are counted from the lower left corner of the rectangle that Build() was called for. Depths are
// window depths in [0, 1], 0 at the near plane (GL_LESS or GL_LEQUAL).
//
// Range. Rectangles may lie partly or wholly outside of the image, and may be empty: only the
// pixels inside count. A rectangle without such pixels is hidden and not shown. Images may have up
// to 65,536 pixels a side. If the level that a query needs is not built, nothing is known, so that
// the rectangle is neither hidden nor shown.
//
// The caller rounds to the safe side: a rectangle must contain every pixel that may be drawn,
// `nearest` must not be farther than any fragment, and `farthest` must not be nearer than any
// (docs/precision.md says how far the depth of a fragment may differ from that of its vertices).
//
// Cost. One texelFetch, or at most four, whatever the size of the rectangle, and some dozens of
// integer operations; no loop has more than four turns, and no derivatives are used. Only
// NBufferFarthestPixels() and NBufferNearestPixels() fetch up to four texels of each level.
//
// Sources: X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3),
// 2005, sections 2 and 3.2; for NBufferShows() M. Turitzin, "Hierarchical Depth Buffers", 2020.
// vtkNBufferMath.h has pictures of the squares that cover a rectangle.
#ifndef vtkNBufferQuery_glsl
#define vtkNBufferQuery_glsl

// What all functions need to know of the levels.
struct NBufferShape
{
  ivec2 size; // of the depth image, in pixels: the width and height that Build() was called for
  int factor; // pixels along a side of a texel of level 0: 1, 2, 4 or 8
  int levels; // vtkNBufferTexture::GetNumberOfLevels()
  int minima; // the channel of the minima: 0, but 1 in a texture of maxima that has both extrema
};

// A texel of a level, as vtkNBufferTexture stores it (GetLayer()): even and odd levels are in two
// textures, two levels of the N-buffer for each layer. The extremum that Build() was called for is
// in channel 0.
float NBufferFetch(sampler2DArray even, sampler2DArray odd, int level, ivec2 texel, int channel)
{
  ivec3 place = ivec3(texel, level / 2);
  vec4 value = level % 2 == 0 ? texelFetch(even, place, 0) : texelFetch(odd, place, 0);
  return channel == 0 ? value.r : value.g;
}

// The last texel of a level, at its upper right corner.
ivec2 NBufferGetLastTexel(NBufferShape shape)
{
  return (shape.size - ivec2(1)) / shape.factor;
}

// The texels of level 0 that a rectangle of pixels touches inside the image, as (x0, y0, x1, y1);
// all four are 0 if it touches none.
ivec4 NBufferToTexels(NBufferShape shape, ivec4 pixels)
{
  ivec2 begin = max(pixels.xy, ivec2(0));
  ivec2 end = max(min(pixels.zw, shape.size), ivec2(0));
  ivec2 up = ivec2(shape.factor - 1);
  return all(lessThan(begin, end)) ? ivec4(begin / shape.factor, (end + up) / shape.factor)
                                   : ivec4(0);
}

// The smallest i with 2^i >= n, for 1 <= n <= 65,536. The logarithm is rounded to the nearest whole
// number first, so that its error does not matter.
int NBufferCeilLog2(int n)
{
  int i = int(floor(log2(float(n)) + 0.5));
  return (1 << i) < n ? i + 1 : i;
}

// How many squares of a level cover `size` texels, along x and y.
ivec2 NBufferCountSquares(ivec2 size, int level)
{
  return (size + ivec2((1 << level) - 1)) >> level;
}

// The lower left texel of square number `index`, along x and y, of those that cover `texels`.
ivec2 NBufferGetStart(ivec4 texels, int level, ivec2 index)
{
  int side = 1 << level;
  return max(min(texels.xy + side * index, texels.zw - ivec2(side)), ivec2(0));
}

// The farthest depth in the square of 2^level texels a side whose lower left corner is the texel
// `corner` of level 0, in one lookup. What lies beyond the upper or right border of the image does
// not count, so that the result is exact; this is the query for sprites whose size is a power of
// two. A square that begins outside of the image, on the left or below, is moved inside. Returns 0
// for a square outside of the image, and 1 if the level is not built.
float NBufferFarthestOfSquare(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec2 corner, int level)
{
  if (any(greaterThan(corner, NBufferGetLastTexel(shape))) ||
    any(lessThanEqual(corner + ivec2(1 << level), ivec2(0))))
  {
    return 0.0;
  }
  return level < shape.levels ? NBufferFetch(even, odd, level, max(corner, ivec2(0)), 0) : 1.0;
}

// NBufferFarthest(), and the texel that has this depth: its place in x and y, and its level in z,
// which is -1 if there is no pixel or no level.
float NBufferFindFarthest(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels, out ivec3 place)
{
  place = ivec3(-1);
  ivec4 texels = NBufferToTexels(shape, pixels);
  ivec2 size = texels.zw - texels.xy;
  if (size.x == 0)
  {
    return 0.0;
  }
  // The finest level of which four squares suffice. Four in a row reach 4 * 2^level.
  int level = max(NBufferCeilLog2(max(size.x, size.y)) - 2, 0);
  ivec2 count = NBufferCountSquares(size, level);
  while (count.x * count.y > 4)
  {
    count = NBufferCountSquares(size, ++level);
  }
  if (level >= shape.levels)
  {
    return 1.0;
  }
  float farthest = -1.0;
  for (int i = 0; i < count.x * count.y; ++i)
  {
    ivec2 start = NBufferGetStart(texels, level, ivec2(i % count.x, i / count.x));
    float depth = NBufferFetch(even, odd, level, start, 0);
    if (depth > farthest)
    {
      farthest = depth;
      place = ivec3(start, level);
    }
  }
  return farthest;
}

// The farthest depth over a rectangle, in four lookups at most. If a square is wider or higher than
// the rectangle, the result may be farther. Returns 0 if no pixel of the rectangle is inside the
// image, and 1 if the level is not built.
float NBufferFarthest(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels)
{
  ivec3 place;
  return NBufferFindFarthest(even, odd, shape, pixels, place);
}

// The pixels of a texel of level 0 that has the same depth as a texel of any level, given by its
// place in x and y, its level in z, and its channel.
ivec4 NBufferFindPixels(sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec3 place,
  int channel)
{
  float depth = NBufferFetch(even, odd, place.z, place.xy, channel);
  ivec2 last = NBufferGetLastTexel(shape);
  while (place.z > 0)
  {
    // The squares of four texels of a level make up the square of one of the level above.
    --place.z;
    int i = 0;
    ivec2 texel = place.xy;
    while (i < 3 && NBufferFetch(even, odd, place.z, texel, channel) != depth)
    {
      ++i;
      texel = min(place.xy + ivec2(i % 2, i / 2) * (1 << place.z), last);
    }
    place.xy = texel;
  }
  ivec2 begin = place.xy * shape.factor;
  return ivec4(begin, min(begin + ivec2(shape.factor), shape.size));
}

// Where the depth of NBufferFarthest() is: the pixels of a texel of level 0 that has it, as
// (x0, y0, x1, y1), at most shape.factor along each side. All four are 0 if no pixel of the
// rectangle is inside the image or the level is not built.
ivec4 NBufferFarthestPixels(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels)
{
  ivec3 place;
  NBufferFindFarthest(even, odd, shape, pixels, place);
  return place.z < 0 ? ivec4(0) : NBufferFindPixels(even, odd, shape, place, 0);
}

// Whether everything that is drawn in a rectangle of pixels and is nowhere nearer than `nearest` is
// hidden by what the N-buffer of maxima was built from. Four lookups at most.
bool NBufferHides(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels, float nearest)
{
  return nearest > NBufferFarthest(even, odd, shape, pixels) ||
    NBufferToTexels(shape, pixels) == ivec4(0);
}

// The texel whose square contains a rectangle, its place in x and y and its level in z; z is -1 if
// no pixel of the rectangle is inside the image, and -2 if the level is not built.
ivec3 NBufferGetSquare(NBufferShape shape, ivec4 pixels)
{
  ivec4 texels = NBufferToTexels(shape, pixels);
  ivec2 size = texels.zw - texels.xy;
  if (size.x == 0)
  {
    return ivec3(-1);
  }
  int level = NBufferCeilLog2(max(size.x, size.y));
  return level < shape.levels ? ivec3(NBufferGetStart(texels, level, ivec2(0)), level) : ivec3(-2);
}

// The nearest depth over a rectangle, of an N-buffer of minima, in one lookup. If the square is
// larger than the rectangle, the result may be nearer. Returns 1 if no pixel of the rectangle is
// inside the image, and 0 if the level is not built.
float NBufferNearestInOne(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels)
{
  ivec3 place = NBufferGetSquare(shape, pixels);
  return place.z < 0 ? float(place.z + 2)
                     : NBufferFetch(even, odd, place.z, place.xy, shape.minima);
}

// Where the depth of NBufferNearestInOne() is, as NBufferFarthestPixels() says it.
ivec4 NBufferNearestPixels(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels)
{
  ivec3 place = NBufferGetSquare(shape, pixels);
  return place.z < 0 ? ivec4(0) : NBufferFindPixels(even, odd, shape, place, shape.minima);
}

// Whether everything that is drawn in a rectangle of pixels and is nowhere farther than `farthest`
// lies before everything that the N-buffer of minima was built from. This is the early accept: if
// one lookup finds that it is true, the lookups of NBufferHides() are not needed. False means that
// nothing is known.
bool NBufferShows(
  sampler2DArray even, sampler2DArray odd, NBufferShape shape, ivec4 pixels, float farthest)
{
  return farthest < NBufferNearestInOne(even, odd, shape, pixels) &&
    NBufferToTexels(shape, pixels) != ivec4(0);
}

#endif
