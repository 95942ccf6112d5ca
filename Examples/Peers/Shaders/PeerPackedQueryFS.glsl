//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
//VTK::Output::Dec

// Queries a rectangle for each fragment, of levels in two arrays or in one texture.
//VTK::NBuffer::Dec

uniform NBufferShape shape;
#if NBUFFER_PACKED
uniform sampler2D levels;
uniform int columns; // levels side by side in a row of the texture
#else
uniform sampler2DArray even;
uniform sampler2DArray odd;
#endif

void main()
{
  // Any rectangle with one corner in the fragment: sides of 1 to 256 pixels.
  ivec2 corner = ivec2(gl_FragCoord.xy);
  uint random = uint(corner.x) * 1973u + uint(corner.y) * 9277u;
  random = (random ^ (random >> 7u)) * 26699u;
  ivec2 size = ivec2(1 + int(random % 256u), 1 + int((random >> 8u) % 256u));
  ivec4 pixels = ivec4(corner, corner + size);
#if NBUFFER_PACKED
  ivec4 texels = NBufferToTexels(shape, pixels);
  size = texels.zw - texels.xy;
  int level = max(NBufferCeilLog2(max(size.x, size.y)) - 2, 0);
  ivec2 count = NBufferCountSquares(size, level);
  while (count.x * count.y > 4)
  {
    count = NBufferCountSquares(size, ++level);
  }
  ivec2 origin = ivec2(level % columns, level / columns) * shape.size;
  float farthest = 0.0;
  for (int i = 0; i < count.x * count.y; ++i)
  {
    ivec2 start = NBufferGetStart(texels, level, ivec2(i % count.x, i / count.x));
    farthest = max(farthest, texelFetch(levels, origin + start, 0).r);
  }
  gl_FragData[0] = vec4(farthest);
#else
  gl_FragData[0] = vec4(NBufferFarthest(even, odd, shape, pixels));
#endif
}
