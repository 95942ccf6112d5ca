#version 430
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Makes a list of the primitives whose units are marked, in the order in which VTK draws them, by
// three passes (G. E. Blelloch, "Prefix sums and their applications", 1990). An invocation has
// NBUFFER_OF_EACH primitives; here a work group has four:
//
//     marked       1 0 0 1 | 1 1 0 0 | 0 0 0 0 | 0 1 1 1
//     NBUFFER_COUNT   2         2         0         3        how many each work group has
//     NBUFFER_ADD     0         2         4         4        where its part of the list begins
//     NBUFFER_COPY 0 . . 1 | 2 3 . . | . . . . | . 4 5 6     where each record is copied to
//
// With NBUFFER_RUNS the units are runs of primitives, otherwise groups in space. (With a uniform
// instead of the definition, some lists are wrong on Mesa's zink 22.3.)
//
// A record is what VTK has in a buffer for a primitive: the indices of its corners, or the matrix or
// color of an instance.

//VTK::NBuffer::Shared
//VTK::NBuffer::Dec

layout(local_size_x = NBUFFER_GROUP) in;

const uint GROUP = uint(NBUFFER_GROUP);

layout(std430, binding = 0) readonly buffer Marks
{
  uint marks[]; // one bit for each unit
};
layout(std430, binding = 2) buffer Sums
{
  uint sums[]; // one for each work group of the passes that count and copy
};

uniform uint first; // the number of the first primitive of the buffers
uniform uint size;  // how many primitives they have
#if defined(NBUFFER_RUNS)
uniform uint unitSize; // the number of primitives of a unit
#else
layout(std430, binding = 1) readonly buffer Units
{
  uint units[]; // the unit of each primitive
};
#endif

shared uint before[GROUP];

bool IsMarked(uint primitive)
{
  uint number = first + primitive;
#if defined(NBUFFER_RUNS)
  uint unit = number / unitSize;
#else
  uint unit = units[number];
#endif
  return (marks[unit / 32u] >> (unit % 32u) & 1u) != 0u;
}

// The sum of what the earlier invocations of the work group have given; `all` becomes that of all.
uint SumBefore(uint mine, out uint all)
{
  uint i = gl_LocalInvocationIndex;
  before[i] = mine;
  barrier();
  for (uint step = 1u; step < GROUP; step *= 2u)
  {
    uint earlier = i >= step ? before[i - step] : 0u;
    barrier();
    before[i] += earlier;
    barrier();
  }
  all = before[GROUP - 1u];
  return before[i] - mine;
}

#if defined(NBUFFER_ADD)

layout(std430, binding = 3) buffer Command
{
  uint command[]; // what glDrawElementsIndirect() draws
};
uniform uint groups; // the number of sums
uniform uint field;  // the element of the command to multiply by the length of the list

// One work group adds all sums.
void main()
{
  uint perInvocation = (groups + GROUP - 1u) / GROUP;
  uint begin = min(gl_LocalInvocationIndex * perInvocation, groups);
  uint end = min(begin + perInvocation, groups);
  uint mine = 0u;
  for (uint i = begin; i < end; ++i)
  {
    mine += sums[i];
  }
  uint all;
  uint sum = SumBefore(mine, all);
  for (uint i = begin; i < end; ++i)
  {
    uint next = sum + sums[i];
    sums[i] = sum;
    sum = next;
  }
  if (gl_LocalInvocationIndex == 0u)
  {
    command[field] *= all;
  }
}

#else

#if defined(NBUFFER_COPY)
layout(std430, binding = 3) readonly buffer Source
{
  uint source[];
};
layout(std430, binding = 4) writeonly buffer Target
{
  uint target[];
};
uniform uint words; // the number of words of a record
#endif

void main()
{
  uint begin = gl_GlobalInvocationID.x * NBUFFER_OF_EACH;
  uint end = min(begin + NBUFFER_OF_EACH, size);
  uint marked = 0u;
  for (uint i = begin; i < end; ++i)
  {
    marked |= uint(IsMarked(i)) << (i - begin);
  }
  uint all;
  uint place = SumBefore(uint(bitCount(marked)), all);
#if defined(NBUFFER_COPY)
  place += sums[gl_WorkGroupID.x];
  for (uint i = begin; i < end; ++i)
  {
    if ((marked >> (i - begin) & 1u) != 0u)
    {
      for (uint k = 0u; k < words; ++k)
      {
        target[words * place + k] = source[words * i + k];
      }
      ++place;
    }
  }
#else
  if (gl_LocalInvocationIndex == 0u)
  {
    sums[gl_WorkGroupID.x] = all;
  }
#endif
}

#endif
