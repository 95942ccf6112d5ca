// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyView.h
 * @brief A view along y, and which points lie in the outline of a box in it.
 */
#ifndef StudyView_h
#define StudyView_h

#include "vtkNBufferProjection.h"

#include <cmath>

namespace StudyTest
{

/// From the origin along y, z up, 90 degrees high, near 1, far 1000.
inline vtkNBufferProjection LookAlongY(int width, int height)
{
  const double n = 1.0;
  const double f = 1000.0;
  const double aspect = static_cast<double>(width) / height;
  const double worldToClip[16] = { 1.0 / aspect, 0.0, 0.0, 0.0, //
    0.0, 0.0, 1.0, 0.0,                                         //
    0.0, (f + n) / (f - n), 0.0, -2.0 * f * n / (f - n),        //
    0.0, 1.0, 0.0, 0.0 };
  vtkNBufferProjection projection;
  projection.Set(worldToClip, width, height, 0x1p-24);
  return projection;
}

/// Stored depth at a distance along y.
inline float GetDepth(double y)
{
  return static_cast<float>(0.5 + 0.5 * (1001.0 / 999.0 - 2000.0 / 999.0 / y));
}

/// Whether a point lies in the convex hull of eight corners: no line through two of them has all
/// of them on one side and the point on the other.
inline bool IsInHull(const std::array<glm::dvec2, 8>& corners, double x, double y)
{
  for (int a = 0; a < 8; ++a)
  {
    for (int b = 0; b < 8; ++b)
    {
      const glm::dvec2 d = corners[b] - corners[a];
      bool edge = d.x != 0.0 || d.y != 0.0;
      for (int c = 0; c < 8 && edge; ++c)
      {
        edge = d.x * (corners[c].y - corners[a].y) - d.y * (corners[c].x - corners[a].x) >= -1e-9;
      }
      if (edge && d.x * (y - corners[a].y) - d.y * (x - corners[a].x) < 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace StudyTest

#endif
