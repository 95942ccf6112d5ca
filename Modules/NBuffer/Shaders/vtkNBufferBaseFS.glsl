//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Makes level 0: a texel is the extremum of a square of NBUFFER_FACTOR x NBUFFER_FACTOR depth
// pixels and of all their samples. With NBUFFER_BOTH, channel 1 has the other extremum. If the
// depth image ends inside a square, the last row or column of the image is read again, which
// changes no extremum. For factor 4 and width 6:
//
//     +---+---+---+---+---+---+ . . . +
//     | 0 | 1 | 2 | 3 | 4 | 5 | 5   5 :
//     +---+---+---+---+---+---+ . . . +
//     '---- texel 0 --''--- texel 1 --'

//VTK::NBuffer::Shared
//VTK::NBuffer::Dec

#if NBUFFER_SOURCE == NBUFFER_SOURCE_INTEGER
#define NBUFFER_VALUE uint
uniform usampler2D depth;
#elif NBUFFER_SOURCE == NBUFFER_SOURCE_MULTISAMPLE
#define NBUFFER_VALUE float
uniform sampler2DMS depth;
#else
#define NBUFFER_VALUE float
uniform sampler2D depth;
#endif
uniform ivec2 origin; // of the rectangle to reduce, in texels of the depth texture
uniform ivec2 last;   // last pixel of the rectangle, counted from its origin

// Of the pixels and samples that were included so far.
NBUFFER_VALUE largest;
NBUFFER_VALUE smallest;

void Include(ivec2 pixel)
{
#if NBUFFER_SOURCE == NBUFFER_SOURCE_MULTISAMPLE
  for (int i = 0; i < NBUFFER_SAMPLES; ++i)
#else
  const int i = 0;
#endif
  {
    NBUFFER_VALUE value = texelFetch(depth, origin + pixel, i).r;
    largest = max(largest, value);
    smallest = min(smallest, value);
  }
}

// Depths that do not fit a float are moved up if they are maxima, otherwise down.
float ToDepth(NBUFFER_VALUE value, bool isMaximum)
{
#if NBUFFER_SOURCE == NBUFFER_SOURCE_INTEGER
  int rounded = int(value >> uint(NBUFFER_DEPTH32_DROPPED_BITS));
  bool isUp = isMaximum ? (value & uint(NBUFFER_DEPTH32_DROPPED_MASK)) != 0u
                        : value == 0xFFFFFFFFu;
  return float(isUp ? rounded + 1 : rounded) * (1.0 / NBUFFER_DEPTH32_SCALE);
#elif NBUFFER_INEXACT
  float error = isMaximum ? NBUFFER_DEPTH32_SAMPLER_ERROR : -NBUFFER_DEPTH32_SAMPLER_ERROR;
  return clamp(value + error, 0.0, 1.0);
#else
  return value;
#endif
}

void main()
{
  ivec2 first = NBUFFER_FACTOR * ivec2(gl_FragCoord.xy);
  largest = smallest = texelFetch(depth, origin + first, 0).r;
  for (int y = 0; y < NBUFFER_FACTOR; ++y)
  {
    for (int x = 0; x < NBUFFER_FACTOR; ++x)
    {
      Include(min(first + ivec2(x, y), last));
    }
  }
  vec2 extrema = vec2(ToDepth(largest, true), ToDepth(smallest, false));
  extrema = NBUFFER_MAXIMUM != 0 ? extrema : extrema.gr;
  gl_FragData[0] = vec4(extrema.r, NBUFFER_BOTH != 0 ? extrema.g : 0.0, 0.0, 1.0);
}
