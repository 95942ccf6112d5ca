// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyView.h
 * @brief A view along y, and whether a point lies in the outline of a box.
 */
#ifndef StudyView_h
#define StudyView_h

#include "../Support/ProjectedBox.h"

#include <algorithm>

namespace StudyTest
{

/// Returns the view from the origin along y, with z up, a vertical view angle of 90 degrees, and
/// the clipping planes at the distances 1 and 1000.
inline vtkNBufferProjection LookAlongY(int width, int height)
{
  const double aspect = static_cast<double>(width) / height;
  const double worldToClip[16] = { 1.0 / aspect, 0.0, 0.0, 0.0, //
    0.0, 0.0, 1.0, 0.0,                                         //
    0.0, 1001.0 / 999.0, 0.0, -2000.0 / 999.0,                  //
    0.0, 1.0, 0.0, 0.0 };
  vtkNBufferProjection projection;
  projection.Set(worldToClip, width, height, vtkNBufferDepthFormat::FromQuantum(0x1p-24));
  return projection;
}

/// Returns the depth that this view stores at a distance along y.
inline float GetDepth(double y)
{
  return static_cast<float>(0.5 + 0.5 * (1001.0 / 999.0 - 2000.0 / 999.0 / y));
}

/// Returns whether a point lies in the convex hull of eight corners: no line through two of them
/// has all corners on one side and the point on the other.
inline bool IsInHull(const std::array<glm::dvec2, 8>& corners, double x, double y)
{
  const auto cross = [](const glm::dvec2& u, const glm::dvec2& v) { return u.x * v.y - u.y * v.x; };
  for (const glm::dvec2& a : corners)
  {
    for (const glm::dvec2& b : corners)
    {
      const glm::dvec2 d = b - a;
      if (d != glm::dvec2(0.0) && cross(d, glm::dvec2(x, y) - a) < 0.0 &&
        std::all_of(corners.begin(), corners.end(),
          [&](const glm::dvec2& c) { return cross(d, c - a) >= -1e-9; }))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace StudyTest

#endif
