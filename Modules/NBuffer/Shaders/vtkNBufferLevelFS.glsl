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

#if NBUFFER_MAXIMUM
#define NBUFFER_EXTREMUM max
#else
#define NBUFFER_EXTREMUM min
#endif

float Fetch(int x, int y)
{
  return texelFetch(below, ivec3(x, y, layer), 0).r;
}

void main()
{
  ivec2 a = ivec2(gl_FragCoord.xy);
  ivec2 b = min(a + side, last);
  float lower = NBUFFER_EXTREMUM(Fetch(a.x, a.y), Fetch(b.x, a.y));
  float upper = NBUFFER_EXTREMUM(Fetch(a.x, b.y), Fetch(b.x, b.y));
  gl_FragData[0] = vec4(NBUFFER_EXTREMUM(lower, upper));
}
