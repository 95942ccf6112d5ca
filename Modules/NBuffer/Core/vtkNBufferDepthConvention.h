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
 * Other renderers store other depths. With reversed depth, (1 - z / w) / 2, the near plane is at 1,
 * the background is at 0, and the farthest depth of a square is the minimum, not the maximum. This
 * is the only file that knows which depth is stored. All other files get these from here:
 *
 *  - the *order* of a depth, which grows with the distance from the eye whatever is stored; the
 *    mathematics of the culler (vtkNBufferProjection) compares orders and nothing else;
 *  - the extremum that the levels of an N-buffer must hold;
 *  - the depths that are stored on the near plane and in the background;
 *  - the comparisons that are set with glDepthFunc, and which way glPolygonOffset moves.
 *
 * VTK's order of a point p is a linear function of p divided by w, as its x and y on the screen
 * are. So the points of a plane in the world have an order that is a linear function of x and y on
 * the screen. Any other depth must have this property, too.
 */
#ifndef vtkNBufferDepthConvention_h
#define vtkNBufferDepthConvention_h

#include "vtkNBufferMath.h"

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferDepthConvention
{
/// 1 if stored depths grow with the distance from the eye, otherwise -1.
constexpr double Sign = 1.0;

/// The order of a stored depth, which grows with the distance from the eye.
constexpr double GetOrder(double stored)
{
  return Sign * stored;
}

///@{
/// The order of a point whose clip coordinates are z and w is Scale * z / w + Offset.
constexpr double Scale = 0.5;
constexpr double Offset = 0.5 * Sign;
///@}

///@{
/// For a point whose stored depth is d, z / w is InverseScale * d + InverseOffset.
constexpr double InverseScale = Sign / Scale;
constexpr double InverseOffset = -Offset / Scale;
///@}

/// The stored depth where nothing has been drawn, to which the depth buffer is cleared. No drawn
/// depth is farther.
constexpr float Background = Sign > 0.0 ? 1.0f : 0.0f;

/// The stored depth on the near plane. No drawn depth is nearer.
constexpr float Nearest = 1.0f - Background;

/// The extremum that finds the farthest of several stored depths.
constexpr vtkNBufferExtremum Farthest =
  Sign > 0.0 ? vtkNBufferExtremum::Maximum : vtkNBufferExtremum::Minimum;

/// Whether this stored depth is that of something drawn, and not the background's.
constexpr bool IsDrawn(float stored)
{
  return Sign > 0.0 ? stored < Background : stored > Background;
}

///@{
/// Arguments of glDepthFunc(): a fragment passes if it is nearer than what is stored, if it is
/// nearer or has the same depth, or if it is farther. The numbers are those of GL_LESS, GL_LEQUAL
/// and GL_GREATER.
constexpr unsigned int PassIfNearer = Sign > 0.0 ? 0x0201 : 0x0204;
constexpr unsigned int PassIfNearerOrEqual = Sign > 0.0 ? 0x0203 : 0x0206;
constexpr unsigned int PassIfFarther = Sign > 0.0 ? 0x0204 : 0x0201;
///@}
}
VTK_ABI_NAMESPACE_END
#endif
