// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowOverlap.h
 * @brief How many things one ray of a light can meet at most, from their ranges of rays. No OpenGL.
 */
#ifndef vtkShadowOverlap_h
#define vtkShadowOverlap_h

#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro

#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkShadowOverlap
{
/// Several things on the same rays: those from Low to High in p and q.
struct Item
{
  glm::dvec2 Low = glm::dvec2(std::numeric_limits<double>::infinity());
  glm::dvec2 High = glm::dvec2(-std::numeric_limits<double>::infinity());
  int Weight = 1; ///< How many things these are.
};

/**
 * An upper bound of the weights of all items on one ray. It is the largest sum over the items that
 * touch one cell of a grid over all of them, with about four cells for each item. Items with a
 * coordinate that is not finite count in every cell. The cost is linear in their number.
 */
VTKNBUFFER_EXPORT long long GetBound(const std::vector<Item>& items);
}

VTK_ABI_NAMESPACE_END
#endif
