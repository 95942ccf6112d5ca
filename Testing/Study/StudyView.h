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
inline vtkNBufferProjection MakeProjection(int width, int height)
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
inline bool IsInHull(const double corners[16], double x, double y)
{
  for (int a = 0; a < 8; ++a)
  {
    for (int b = 0; b < 8; ++b)
    {
      const double dx = corners[2 * b] - corners[2 * a];
      const double dy = corners[2 * b + 1] - corners[2 * a + 1];
      bool edge = dx != 0.0 || dy != 0.0;
      for (int c = 0; c < 8 && edge; ++c)
      {
        edge =
          dx * (corners[2 * c + 1] - corners[2 * a + 1]) - dy * (corners[2 * c] - corners[2 * a]) >=
          -1e-9;
      }
      if (edge && dx * (y - corners[2 * a + 1]) - dy * (x - corners[2 * a]) < 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace StudyTest

#endif
