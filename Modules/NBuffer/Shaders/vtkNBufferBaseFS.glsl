//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Makes level 0: a texel is the extremum of a square of NBUFFER_FACTOR x NBUFFER_FACTOR depth
// pixels and of all their samples. If the depth image ends inside a square, the last row or column
// of the image is read again, which changes no extremum. For factor 4 and width 6:
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

#if NBUFFER_MAXIMUM
#define NBUFFER_EXTREMUM max
#else
#define NBUFFER_EXTREMUM min
#endif

NBUFFER_VALUE Fetch(ivec2 pixel)
{
  NBUFFER_VALUE value = texelFetch(depth, origin + pixel, 0).r;
#if NBUFFER_SOURCE == NBUFFER_SOURCE_MULTISAMPLE
  for (int i = 1; i < NBUFFER_SAMPLES; ++i)
  {
    value = NBUFFER_EXTREMUM(value, texelFetch(depth, origin + pixel, i).r);
  }
#endif
  return value;
}

float ToDepth(NBUFFER_VALUE value)
{
#if NBUFFER_SOURCE == NBUFFER_SOURCE_INTEGER
  int rounded = int(value >> uint(NBUFFER_DEPTH32_DROPPED_BITS));
#if NBUFFER_MAXIMUM
  rounded += (value & uint(NBUFFER_DEPTH32_DROPPED_MASK)) != 0u ? 1 : 0;
#else
  rounded += value == 0xFFFFFFFFu ? 1 : 0;
#endif
  return float(rounded) * (1.0 / NBUFFER_DEPTH32_SCALE);
#elif NBUFFER_INEXACT && NBUFFER_MAXIMUM
  return min(value + NBUFFER_DEPTH32_SAMPLER_ERROR, 1.0);
#elif NBUFFER_INEXACT
  return max(value - NBUFFER_DEPTH32_SAMPLER_ERROR, 0.0);
#else
  return value;
#endif
}

void main()
{
  ivec2 first = NBUFFER_FACTOR * ivec2(gl_FragCoord.xy);
  NBUFFER_VALUE value = Fetch(first);
  for (int y = 0; y < NBUFFER_FACTOR; ++y)
  {
    for (int x = 0; x < NBUFFER_FACTOR; ++x)
    {
      value = NBUFFER_EXTREMUM(value, Fetch(min(first + ivec2(x, y), last)));
    }
  }
  gl_FragData[0] = vec4(ToDepth(value));
}
