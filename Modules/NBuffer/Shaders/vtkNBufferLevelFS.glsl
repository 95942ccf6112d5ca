//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Makes level i + 1 from level i. The squares of level i have the side s = 2^i, and four of them
// make one with twice the side. A neighbour outside the image is replaced by the last texel of its
// row or column, whose square lies inside the larger square anyway (vtkNBufferMath.h).
//
//     +------+------+
//     | x,   | x+s, |
//     | y+s  | y+s  |
//     +------+------+
//     | x,   | x+s, |
//     | y    | y    |
//     +------+------+

//VTK::NBuffer::Dec

uniform sampler2DArray below;
uniform int layer;  // of level i in the array
uniform int side;   // s, in texels
uniform ivec2 last; // last texel of the image

// The extremum that was requested is in channel 0. With both, channel 1 has the other one.
#if NBUFFER_MAXIMUM
#define NBUFFER_EXTREMUM max
#define NBUFFER_OTHER min
#else
#define NBUFFER_EXTREMUM min
#define NBUFFER_OTHER max
#endif

vec2 Fetch(int x, int y)
{
  return texelFetch(below, ivec3(x, y, layer), 0).rg;
}

vec2 Merge(vec2 a, vec2 b)
{
  return vec2(NBUFFER_EXTREMUM(a.r, b.r), NBUFFER_BOTH != 0 ? NBUFFER_OTHER(a.g, b.g) : 0.0);
}

void main()
{
  ivec2 a = ivec2(gl_FragCoord.xy);
  ivec2 b = min(a + side, last);
  vec2 lower = Merge(Fetch(a.x, a.y), Fetch(b.x, a.y));
  vec2 upper = Merge(Fetch(a.x, b.y), Fetch(b.x, b.y));
  gl_FragData[0] = vec4(Merge(lower, upper), 0.0, 1.0);
}
