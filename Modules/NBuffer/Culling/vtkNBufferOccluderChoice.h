// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferOccluderChoice.h
 * @brief Which of many props to draw before the next test: those that probably hide the others. No
 * OpenGL.
 *
 * The first two rounds choose from the props that are largest on the screen, and later ones from
 * the nearest of those that are left. Of half a million parts of boards 13,000 are drawn then,
 * where 4,555 own a pixel; if all rounds chose from the nearest, 50,000 would be drawn. If all
 * rounds chose from the largest, fewer pipes of a plant would be drawn, but six times as many of
 * them once more for equal depths.
 *
 * Where houses stand in rows the nearest of them also hide each other. So the boxes are drawn into
 * a coarse depth image of squares of 8 x 8 pixels, from near to far. A box is chosen if it is in
 * front of the chosen ones in more than half of the squares that it touches. From then on it counts
 * as hiding what lies beyond its farthest depth, in the middle three quarters of the width and
 * height of its rectangle.
 *
 * The choice need not be right: every prop that is not chosen is tested. Where the camera jumps
 * from one place of a city to another, about 65 props are drawn in a frame, and 15 own a pixel.
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
/// It is enough to choose from this many props.
constexpr std::size_t MaximumSize = 256;

/// The largest number of props that the first round may draw, if `props` are held back: `roundSize`
/// or, if that is more, one in 512. Each round tests all props that are left, so that rounds have
/// to be larger where a great many are held back.
inline std::size_t GetLimit(int roundSize, std::size_t props)
{
  return std::max<std::size_t>(roundSize, props / 512);
}

/**
 * Choose at most `limit` of `boxes` in a viewport of `width` x `height` pixels, and return their
 * indices. The boxes must be sorted by their nearest depths, the nearest box first. Takes about a
 * microsecond per box.
 */
VTKNBUFFER_EXPORT std::vector<std::size_t> Choose(
  const std::vector<vtkNBufferScreenBox>& boxes, std::size_t limit, int width, int height);
}

VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferOccluderChoice.h
