//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Makes a level of an N-buffer from the level below in the same texture (PackedLevels.h).
uniform sampler2D levels;
uniform ivec2 from; // the lower left texel of the level below
uniform ivec2 to;   // and of this level
uniform int side;   // of the squares of the level below
uniform ivec2 last; // the last texel of a level

float Fetch(int x, int y)
{
  return texelFetch(levels, from + ivec2(x, y), 0).r;
}

void main()
{
  ivec2 a = ivec2(gl_FragCoord.xy) - to;
  ivec2 b = min(a + side, last);
  float lower = max(Fetch(a.x, a.y), Fetch(b.x, a.y));
  float upper = max(Fetch(a.x, b.y), Fetch(b.x, b.y));
  gl_FragData[0] = vec4(max(lower, upper));
}
