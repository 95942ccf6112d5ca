// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowOverlap.h
 * @brief How many things one ray of a light can meet at most, by their rectangles of rays. No
 * OpenGL.
 */
#ifndef vtkShadowOverlap_h
#define vtkShadowOverlap_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// In light coordinates (p, q); as many things as Weight.
struct vtkShadowRectangle
{
  double Low[2] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  double High[2] = { -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  int Weight = 1;

  void Add(const double pq[2])
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Low[i] = pq[i] < this->Low[i] ? pq[i] : this->Low[i];
      this->High[i] = pq[i] > this->High[i] ? pq[i] : this->High[i];
    }
  }
};

namespace vtkShadowOverlap
{
/**
 * An upper bound of the weights of all rectangles that hold one point: the largest sum of those
 * that touch one cell of a grid over all of them, with about four cells for each rectangle. All
 * weights if a coordinate is not finite. Linear in their number.
 */
VTKNBUFFER_EXPORT long long GetBound(const std::vector<vtkShadowRectangle>& rectangles);
}

VTK_ABI_NAMESPACE_END
#endif
