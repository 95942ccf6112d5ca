//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// The next level of a mip chain of depth, half as large and rounded down (Turitzin 2020): a texel
// holds the farthest of 2 x 2 texels. Of an odd width, one column would be left over:
//
//     +---+---+---+---+---+---+---+      +---+---+---+---+---+---+---+
//     | 0 | 1 | 2 | 3 | 4 | 5 | 6 |      | 0 | 1 | 2 | 3 | 4 | 5 | 6 |
//     +---+---+---+---+---+---+---+      +---+---+---+---+---+---+---+
//     '-- texel 0 --'                    '-texel 0-'-texel 1-'-texel 2-'
//             '-- texel 1 --'
//                     '-- texel 2 --'
//           exact: three each                fat: three in the last one
//
// Rows likewise; where both sides are odd, the texel in the corner counts, too.

//VTK::NBuffer::Dec

uniform sampler2DArray depth; // its only level is the one to reduce
uniform int layer;
uniform ivec2 size; // of that level, in texels

float Fetch(ivec2 texel)
{
  // Where one side has come down to a texel, there is no second one.
  return texelFetch(depth, ivec3(min(texel, size - 1), layer), 0).r;
}

void main()
{
  ivec2 first = 2 * ivec2(gl_FragCoord.xy);
  float farthest = max(max(Fetch(first), Fetch(first + ivec2(1, 0))),
    max(Fetch(first + ivec2(0, 1)), Fetch(first + ivec2(1, 1))));
#if PEER_FAT
  bvec2 odd = equal(first, size - 3);
#else
  bvec2 odd = equal(size & 1, ivec2(1));
#endif
  if (odd.x)
  {
    farthest = max(farthest, max(Fetch(first + ivec2(2, 0)), Fetch(first + ivec2(2, 1))));
  }
  if (odd.y)
  {
    farthest = max(farthest, max(Fetch(first + ivec2(0, 2)), Fetch(first + ivec2(1, 2))));
  }
  if (odd.x && odd.y)
  {
    farthest = max(farthest, Fetch(first + ivec2(2, 2)));
  }
  gl_FragDepth = farthest;
}
