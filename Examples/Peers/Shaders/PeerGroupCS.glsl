#version 430
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// One level at once (Turitzin 2020, technique 2): a work group finds the farthest of 16 x 16 pixels
// of depth. It has PEER_SIDE x PEER_SIDE invocations, each with a square of its own of these pixels:
//
//     PEER_SIDE 4:  +--+--+--+--+     an invocation reads 4 x 4 pixels, one by one or four at a
//                   +--+--+--+--+     time (PEER_GATHER), and the group finds the farthest of the
//                   +--+--+--+--+     16 results by atomics on one number (PEER_ATOMICS), or over
//                   +--+--+--+--+     a tree of pairs
//
// There are no atomics for floats, but floats that are not negative are in the order of their bits.

//VTK::NBuffer::Dec

#define PEER_CELL 16 // pixels of a texel along each axis
#define PEER_COUNT (PEER_SIDE * PEER_SIDE)

layout(local_size_x = PEER_SIDE, local_size_y = PEER_SIDE) in;

uniform sampler2DArray depth;
layout(r32f, binding = 0) uniform writeonly image2DArray level;

#if PEER_ATOMICS
shared uint farthest;
#else
shared float farthest[PEER_COUNT];
#endif

/// Returns the farthest depth of the invocation's own pixels. What is outside of the image repeats
/// its last row or column.
float FindFarthest()
{
  const int own = PEER_CELL / PEER_SIDE;
  ivec3 size = textureSize(depth, 0);
  ivec2 first = own * ivec2(gl_GlobalInvocationID.xy);
  int layer = int(gl_WorkGroupID.z);
  float result = 0.0;
#if PEER_GATHER
  for (int y = 1; y < own; y += 2)
  {
    for (int x = 1; x < own; x += 2)
    {
      // The corner where the four pixels meet.
      vec2 corner = vec2(first + ivec2(x, y)) / vec2(size.xy);
      vec4 four = textureGather(depth, vec3(corner, float(layer)));
      result = max(result, max(max(four.x, four.y), max(four.z, four.w)));
    }
  }
#else
  for (int y = 0; y < own; ++y)
  {
    for (int x = 0; x < own; ++x)
    {
      ivec2 pixel = min(first + ivec2(x, y), size.xy - 1);
      result = max(result, texelFetch(depth, ivec3(pixel, layer), 0).r);
    }
  }
#endif
  return result;
}

void main()
{
#if PEER_ATOMICS
  if (gl_LocalInvocationIndex == 0u)
  {
    farthest = 0u;
  }
  barrier();
  atomicMax(farthest, floatBitsToUint(FindFarthest()));
  barrier();
  float result = uintBitsToFloat(farthest);
#else
  uint place = gl_LocalInvocationIndex;
  farthest[place] = FindFarthest();
  barrier();
  for (uint count = PEER_COUNT / 2u; count > 0u; count /= 2u)
  {
    if (place < count)
    {
      farthest[place] = max(farthest[place], farthest[place + count]);
    }
    barrier();
  }
  float result = farthest[0];
#endif
  if (gl_LocalInvocationIndex == 0u)
  {
    imageStore(level, ivec3(gl_WorkGroupID), vec4(result));
  }
}
