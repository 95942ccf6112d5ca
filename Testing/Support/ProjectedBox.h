// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProjectedBox.h
 * @brief A box and where a projection puts it.
 */
#ifndef ProjectedBox_h
#define ProjectedBox_h

#include "PrintVectors.h"
#include "vtkNBufferProjection.h"

#include <array>

/// A parallel view in which world x and y are pixels and z is the depth.
inline vtkNBufferProjection MapWorldToPixels(int width, int height, int subpixelBits = 4)
{
  const double worldToClip[16] = { 2.0 / width, 0.0, 0.0, -1.0, 0.0, 2.0 / height, 0.0, -1.0, 0.0,
    0.0, 2.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
  vtkNBufferProjection projection;
  projection.Set(worldToClip, width, height, 0x1p-24, 0, subpixelBits);
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

  std::array<double, 6> Bounds; ///< As VTK has them: least x, largest x, least y and so on.
  vtkNBufferBox Box;
  vtkNBufferScreenBox Screen; ///< Meaningless unless the box is Inside.
  vtkNBufferPlacement Placement;
};

#endif
