#version 430
// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Compares the boxes of the nodes of one level of vtkNBufferUnits with the farthest depths in an
// N-buffer. This is vtkNBufferProjection::Project() and vtkNBufferOcclusionTest, operation by
// operation. Boxes that reach before the near plane or behind the eye are left to the host.
// `precise` keeps compilers from merging operations.

//VTK::NBuffer::Shared
//VTK::NBuffer::Query

layout(local_size_x = NBUFFER_GROUP) in;

layout(std430, binding = 0) readonly buffer Boxes
{
  float boxes[]; // of all nodes: the lower and the upper corner, 6 numbers
};
layout(std430, binding = 1) buffer Answers
{
  uint answers[]; // NBUFFER_ANSWER_BITS bits for each node
};

uniform uint first;   // the place of the first node of the level among all nodes
uniform uint size;    // how many nodes the level has
uniform uint parents; // the place of the first node of the level above
uniform bool hasParents;

uniform sampler2DArray even;
uniform sampler2DArray odd;
uniform NBufferShape shape;

// See vtkNBufferProjection and vtkNBufferBoxError.
uniform dvec4 rows[4];         // from the coordinates of the boxes to clip space
uniform dvec4 errors;          // E of each row
uniform dvec2 borders;         // of boxes that are wholly in view, and of others, in pixels
uniform dvec3 order;           // scale and offset of the order of depth, and the farthest order
uniform dvec3 slack;           // of depth: constant, by |z / w|, by the range of depths
uniform ivec2 viewport;        // size in pixels
uniform bool samplesAreMiddles; // whether each pixel has one sample, in its middle

// More than this is taken for infinite, which is left to the host.
const double largest = 1.0e300lf;

double Evaluate(dvec4 row, dvec3 point)
{
  precise double x = row.x * point.x;
  precise double y = row.y * point.y;
  precise double z = row.z * point.z;
  precise double xy = x + y;
  precise double xyz = xy + z;
  precise double value = xyz + row.w;
  return value;
}

// floor() and ceil(), which Mesa's llvmpipe (22.3) gets wrong for doubles between 0 and 1.
int Floor(double x)
{
  int truncated = int(x);
  return double(truncated) > x ? truncated - 1 : truncated;
}

int Ceil(double x)
{
  int truncated = int(x);
  return double(truncated) < x ? truncated + 1 : truncated;
}

// The box of a node, with its corners rounded as by vtkNBufferBox::FromBounds().
void GetBox(uint node, out dvec3 center, out dvec3 halfSize)
{
  for (int i = 0; i < 3; ++i)
  {
    double low = double(boxes[6u * node + uint(i)]);
    double high = double(boxes[6u * node + 3u + uint(i)]);
    precise double middle = 0.5lf * (low + high);
    precise double halfRange = 0.5lf * (high - low);
    precise double rounding = (abs(middle) + halfRange) * 8.8817841970012523e-16lf; // 2^-50
    precise double whole = halfRange + rounding;
    center[i] = middle;
    halfSize[i] = whole;
  }
}

uint GetAnswer(uint node)
{
  dvec3 middle;
  dvec3 halfSize;
  GetBox(node, middle, halfSize);
  dvec4 center;
  dvec4 axes[3];
  for (int i = 0; i < 4; ++i)
  {
    center[i] = Evaluate(rows[i], middle);
    for (int j = 0; j < 3; ++j)
    {
      precise double axis = rows[i][j] * halfSize[j];
      axes[j][i] = axis;
    }
  }
  dvec3 low = dvec3(largest);
  dvec3 high = dvec3(-largest);
  for (int corner = 0; corner < 8; ++corner)
  {
    precise dvec4 clip = center + ((corner & 1) != 0 ? axes[0] : -axes[0]);
    clip = clip + ((corner & 2) != 0 ? axes[1] : -axes[1]);
    clip = clip + ((corner & 4) != 0 ? axes[2] : -axes[2]);
    precise double w = clip.w - errors.w;
    precise double fromNear = clip.z + clip.w;
    precise double nearError = errors.z + errors.w;
    if (!(w > errors.w && fromNear > nearError))
    {
      return NBUFFER_ANSWER_NONE;
    }
    precise double inverse = 1.0lf / w;
    precise dvec3 ndc = clip.xyz / clip.w;
    precise dvec3 ofW = abs(ndc) * errors.w;
    precise dvec3 sum = errors.xyz + ofW;
    precise dvec3 error = sum * inverse;
    precise dvec3 lower = ndc - error;
    precise dvec3 upper = ndc + error;
    low = min(low, lower);
    high = max(high, upper);
  }
  if (!all(lessThan(abs(low), dvec3(largest))) || !all(lessThan(abs(high), dvec3(largest))))
  {
    return NBUFFER_ANSWER_NONE;
  }
  bool isWhole =
    all(greaterThanEqual(low, dvec3(-1.0lf))) && all(lessThanEqual(high, dvec3(1.0lf)));
  double border = isWhole ? borders.x : borders.y;
  ivec4 pixels;
  for (int i = 0; i < 2; ++i)
  {
    double side = double(viewport[i]);
    precise double scaledLow = 0.5lf * (low[i] + 1.0lf) * side;
    precise double scaledHigh = 0.5lf * (high[i] + 1.0lf) * side;
    precise double begin = scaledLow - border;
    precise double end = scaledHigh + border;
    if (end <= 0.0lf || begin >= side)
    {
      return NBUFFER_ANSWER_OUTSIDE;
    }
    double from = max(begin, 0.0lf);
    double to = min(end, side);
    pixels[i] = samplesAreMiddles ? Ceil(from - 0.5lf) : int(from);
    pixels[i + 2] = samplesAreMiddles ? Floor(to - 0.5lf) + 1 : Ceil(to);
  }
  precise double range = order.x * (high.z - low.z);
  precise double relative = slack.y * abs(low.z);
  precise double ofRange = range * slack.z;
  precise double constant = slack.x + relative;
  precise double allowed = constant + ofRange;
  precise double scaled = order.x * low.z;
  precise double nearest = scaled + order.y;
  nearest = nearest - allowed;
  if (nearest > order.z)
  {
    return NBUFFER_ANSWER_OUTSIDE;
  }
  bool isHidden = NBufferToTexels(shape, pixels) == ivec4(0) ||
    nearest > double(NBufferFarthest(even, odd, shape, pixels));
  return isHidden ? NBUFFER_ANSWER_HIDDEN : NBUFFER_ANSWER_VISIBLE;
}

uint FindAnswer(uint node)
{
  uint bit = NBUFFER_ANSWER_BITS * node;
  return answers[bit / 32u] >> (bit % 32u) & NBUFFER_ANSWER_MASK;
}

void main()
{
  uint i = gl_GlobalInvocationID.x;
  if (i >= size)
  {
    return;
  }
  uint above = hasParents ? FindAnswer(parents + i / NBUFFER_FANOUT) : NBUFFER_ANSWER_NONE;
  // Nobody looks at what is below a node that is hidden or outside.
  if (above != NBUFFER_ANSWER_HIDDEN && above != NBUFFER_ANSWER_OUTSIDE)
  {
    uint bit = NBUFFER_ANSWER_BITS * (first + i);
    atomicOr(answers[bit / 32u], GetAnswer(first + i) << (bit % 32u));
  }
}
