// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferDepthConvention.h
 * @brief What a renderer stores as depth, and what is the farther one of two. No OpenGL.
 *
 * With clip coordinates (x, y, z, w) as vtkCamera gives them, z in [-w, w]:
 *
 *     convention  stored depth         near plane  far plane  hides     background
 *     Forward     (z / w + 1) / 2      0           1          maximum   1
 *     Reversed    (1 - z / w) / 2      1           0          minimum   0
 *     InverseW    near / w             1           near / far minimum   0
 *
 * VTK draws Forward. A renderer that draws Reversed has its matrix give (w - z) / 2 as z, with
 * glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE): only so do small floats keep their precision.
 * InverseW says nothing in parallel projection, where w is constant: every box is then Crossing.
 *
 * The mathematics knows one quantity only, which grows with distance in every convention:
 *
 *     order = sign * stored depth,   sign = 1 for Forward, -1 for the others.
 *
 * It is linear-fractional in the point, (row . p) / w, so that planes stay planes; in units in
 * which the near plane is at -1 (NDC z for Forward, order itself for the others) the same test
 * finds what lies before it: row . p + w > 0.
 */
#ifndef vtkNBufferDepthConvention_h
#define vtkNBufferDepthConvention_h

#include "vtkNBufferMath.h"

VTK_ABI_NAMESPACE_BEGIN

enum class vtkNBufferDepthConvention
{
  Forward,
  Reversed,
  InverseW
};

namespace vtkNBufferMath
{
/// order = sign * stored depth.
inline double GetDepthSign(vtkNBufferDepthConvention convention)
{
  return convention == vtkNBufferDepthConvention::Forward ? 1.0 : -1.0;
}

/// What the levels must hold: the farthest stored depth of their squares.
inline vtkNBufferExtremum GetFarthest(vtkNBufferDepthConvention convention)
{
  return convention == vtkNBufferDepthConvention::Forward ? vtkNBufferExtremum::Maximum
                                                          : vtkNBufferExtremum::Minimum;
}

/// The stored depth where nothing has been drawn: no drawn depth is farther.
inline float GetBackgroundDepth(vtkNBufferDepthConvention convention)
{
  return convention == vtkNBufferDepthConvention::Forward ? 1.0f : 0.0f;
}

/// The stored depth on the near plane: no drawn depth is nearer.
inline float GetNearestDepth(vtkNBufferDepthConvention convention)
{
  return 1.0f - GetBackgroundDepth(convention);
}
}

VTK_ABI_NAMESPACE_END
#endif
