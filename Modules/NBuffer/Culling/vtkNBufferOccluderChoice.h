// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferOccluderChoice.h
 * @brief Which of many props to draw before the next test: those that probably hide the others. No
 * OpenGL.
 *
 * The nearest props hide most, but where houses stand in rows the nearest of them also hide each
 * other. So the boxes are drawn into a coarse depth image of squares of 8 x 8 pixels, from near to
 * far. A box is chosen if it is before the chosen ones in half of the squares that it touches. It
 * then hides what lies beyond its farthest depth, in the middle three quarters of its rectangle.
 *
 * The choice need not be right: every prop that is not chosen is tested. In cuts from one place of
 * a city to another, some 90 props are drawn in a frame instead of 140 with the 64 nearest.
 */
#ifndef vtkNBufferOccluderChoice_h
#define vtkNBufferOccluderChoice_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferScreenBox.h"

#include <algorithm>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferOccluderChoice
{
/// This many of the nearest props are enough to choose from.
constexpr std::size_t MaximumSize = 256;

/// How many props the first of several rounds draws at most, of `props` that are held back. Each
/// round tests all that are left, so that a great many want larger rounds than `roundSize`.
inline std::size_t GetLimit(int roundSize, std::size_t props)
{
  return std::max<std::size_t>(roundSize, props / 512);
}

/**
 * Choose at most `limit` of boxes on a screen of `width` x `height` pixels, and return their
 * places. The boxes are in the order of their nearest depths. Takes about a microsecond for each.
 */
VTKNBUFFER_EXPORT std::vector<std::size_t> Choose(
  const std::vector<vtkNBufferScreenBox>& boxes, std::size_t limit, int width, int height);
}

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferOccluderChoice.h
