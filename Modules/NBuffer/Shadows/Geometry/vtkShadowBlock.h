// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowBlock.h
 * @brief Ranges of light coordinates: a box in p, q and s, and a slab in s alone. No OpenGL.
 */
#ifndef vtkShadowBlock_h
#define vtkShadowBlock_h

#include "vtkNBufferGLM.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN

/**
 * A box along the axes, of light coordinates (p, q, s) or, where that is said, of the world's. It
 * is empty as constructed.
 */
struct vtkShadowBlock
{
  glm::dvec3 Low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 High = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool IsEmpty() const { return !(this->Low[2] <= this->High[2]); }

  /// Widens coordinate i to hold [low, high].
  void Add(int i, double low, double high)
  {
    this->Low[i] = low < this->Low[i] ? low : this->Low[i];
    this->High[i] = high > this->High[i] ? high : this->High[i];
  }

  /// Widens the box to hold a point.
  void Add(const glm::dvec3& x)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Add(i, x[i], x[i]);
    }
  }
};

/// A range of depths s, in world units along the axis of a vtkShadowLightSpace.
struct vtkShadowSlab
{
  double Near = 0.0; ///< The depth nearer to the light.
  double Far = 0.0;  ///< The depth farther from the light.
};

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowBlock.h
