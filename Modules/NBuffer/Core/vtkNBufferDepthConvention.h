// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferDepthConvention.h
 * @brief What VTK stores as depth, and everything that follows from it. No OpenGL.
 *
 * With clip coordinates (x, y, z, w) as vtkCamera gives them, z in [-w, w], VTK stores
 *
 *     depth = (z / w + 1) / 2        0 on the near plane, 1 on the far plane and in the background,
 *
 * and draws with GL_LEQUAL: a fragment replaces what is stored if it is nearer or equally near.
 *
 * An application may let VTK draw reversed depth instead (vtkNBufferStoredDepth), whose farthest
 * value is the smallest. The culler therefore compares *orders*, which grow with the distance from
 * the eye: the order of VTK's depth is the depth itself, that of reversed depth is the negated
 * depth, which is exact. Depth becomes orders where it reaches host memory; the levels, which are
 * maxima of orders, and all tests are the same for both.
 *
 * The order of a point p is a linear function of p divided by w, as its x and y on the screen are.
 * So the points of a plane in the world have an order that is a linear function of x and y on the
 * screen. Any other depth must have this property, too.
 *
 * The shadow pass supports VTK's depth alone. The constants below belong to that.
 */
#ifndef vtkNBufferDepthConvention_h
#define vtkNBufferDepthConvention_h

#include "vtkNBufferMath.h"

#include <algorithm>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN

/// What is stored as depth, as the state of OpenGL says (vtkNBufferDepthSource).
enum class vtkNBufferStoredDepth
{
  /// VTK's depth as above.
  Ordinary,
  /// z / w, which is 1 on the near plane and 0 on the far plane, at infinity or not, and in the
  /// background. The application sets glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE) and
  /// glDepthFunc(GL_GEQUAL), clears depth to 0, and gives the camera a projection for it.
  Reversed,
  /// Anything else, which the culler does not test.
  Other
};

namespace vtkNBufferDepthConvention
{
/// The extremum that finds the farthest of several stored depths.
constexpr vtkNBufferExtremum GetFarthest(vtkNBufferStoredDepth stored)
{
  return stored == vtkNBufferStoredDepth::Reversed ? vtkNBufferExtremum::Minimum
                                                   : vtkNBufferExtremum::Maximum;
}

/// Replace stored depths by their orders.
inline void ToOrders(vtkNBufferStoredDepth stored, float* depth, std::size_t count)
{
  if (stored == vtkNBufferStoredDepth::Reversed)
  {
    std::transform(depth, depth + count, depth, [](float value) { return -value; });
  }
}

///@{
/// VTK's depth of a point whose clip coordinates are z and w is Scale * z / w + Offset. For a point
/// whose depth is d, z / w is InverseScale * d + InverseOffset.
constexpr double Scale = 0.5;
constexpr double Offset = 0.5;
constexpr double InverseScale = 1.0 / Scale;
constexpr double InverseOffset = -Offset / Scale;
///@}

/// VTK's depth where nothing has been drawn. No order of any depth is farther.
constexpr float Background = 1.0f;

/// Whether this depth of VTK is that of something drawn, and not the background's.
constexpr bool IsDrawn(float stored)
{
  return stored < Background;
}

///@{
/// Arguments of glDepthFunc() for VTK's depth: a fragment passes if it is nearer than what is
/// stored, or if it is farther. The numbers are those of GL_LESS and GL_GREATER.
constexpr unsigned int PassIfNearer = 0x0201;
constexpr unsigned int PassIfFarther = 0x0204;
///@}
}
VTK_ABI_NAMESPACE_END
#endif
