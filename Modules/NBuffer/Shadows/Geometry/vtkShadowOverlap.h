// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowOverlap.h
 * @brief An upper bound of how many triangles one ray of a light meets. No OpenGL.
 */
#ifndef vtkShadowOverlap_h
#define vtkShadowOverlap_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowBlock.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace vtkShadowOverlap
{
/// A triangle, or those of a caster.
struct Item
{
  vtkShadowBlock Rays; ///< It lies inside the rectangle of these rays in (p, q); s does not matter.
  int Weight = 1;      ///< The largest number of these triangles that one ray meets.
};

/**
 * Returns an upper bound of the sum of the weights of the items that one ray meets. A grid covers
 * all items, with about four cells for each item and at most 1024 x 1024. The bound is the largest
 * sum of the weights of the items that touch one cell. An item with a coordinate that is not finite
 * counts in every cell. The cost is linear in the number of items.
 */
VTKNBUFFER_EXPORT long long GetBound(const std::vector<Item>& items);
}

VTK_ABI_NAMESPACE_END
#endif
