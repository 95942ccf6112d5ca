// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProjectedBox.h
 * @brief A box together with the result of projecting it.
 */
#ifndef ProjectedBox_h
#define ProjectedBox_h

#include "PrintVectors.h"
#include "vtkNBufferProjection.h"

#include <array>

/// Returns a parallel view in which world x and y are pixels and z is the window depth.
inline vtkNBufferProjection MapWorldToPixels(int width, int height, int subpixelBits = 4)
{
  const double worldToClip[16] = { 2.0 / width, 0.0, 0.0, -1.0, 0.0, 2.0 / height, 0.0, -1.0, 0.0,
    0.0, 2.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
  vtkNBufferProjection projection;
  projection.Set(
    worldToClip, width, height, vtkNBufferDepthFormat::FromQuantum(0x1p-24), {}, subpixelBits);
  return projection;
}

struct ProjectedBox
{
  ProjectedBox(const vtkNBufferProjection& projection, const std::array<double, 6>& bounds)
    : Bounds(bounds)
    , Box(vtkNBufferBox::FromBounds(bounds.data()))
    , Placement(projection.Project(this->Box, this->Screen))
  {
  }

  bool IsInside() const { return this->Placement == vtkNBufferPlacement::Inside; }

  std::array<double, 6> Bounds; ///< In VTK's order: least x, largest x, least y and so on.
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen; ///< Valid only if the placement is Inside.
  vtkNBufferPlacement Placement;
};

#endif
