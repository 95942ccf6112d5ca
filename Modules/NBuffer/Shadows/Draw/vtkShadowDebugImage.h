// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowDebugImage.h
 * @brief Paints the images that debug views lay over the picture. No OpenGL.
 *
 * An image has four bytes (red, green, blue, opacity) for each pixel of the viewport, row by row,
 * the lowest first. All four are 0 where the image shows nothing. Numbers are shown as heat, on a
 * logarithmic scale that is the same in all frames:
 *
 *     1      4      16      64       255 and more
 *     blue   cyan   green   yellow   red
 */
#ifndef vtkShadowDebugImage_h
#define vtkShadowDebugImage_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowDrawList.h"
#include "vtkShadowLitmap.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkShadowDebugImage
{
using Color = std::array<unsigned char, 4>;
using Image = std::vector<unsigned char>;

/// The colour of a number on this scale. 0 is transparent.
VTKNBUFFER_EXPORT Color GetHeat(int number);

/**
 * Paints `count` litmaps, one or the six of a point light, into an image of width x height pixels.
 * Each litmap has a row of three squares; that of the first litmap is the lowest. p grows to the
 * right, q grows upwards, and lexels without receivers are dark:
 *
 *     +-----------------+ +-----------------+ +-----------------+
 *     | nearest depth   | | farthest depth  | | occupied bins,  |
 *     | of a lexel's    | | of a lexel's    | | as heat         |
 *     | receivers       | | receivers       | |                 |
 *     +-----------------+ +-----------------+ +-----------------+
 *       brighter is nearer to the light
 */
VTKNBUFFER_EXPORT Image PaintLitmaps(
  const vtkShadowLitmap* litmaps, int count, int width, int height);

/// Paints the edges of the boxes of all draws in white, and in each pixel, as heat, the number of
/// boxes that contain it.
VTKNBUFFER_EXPORT Image PaintExtents(
  const std::vector<vtkShadowDraw>& draws, int width, int height);

/// Replaces each pixel of an image by the heat of the number in its first channel.
VTKNBUFFER_EXPORT void PaintCounts(Image& image);
}
VTK_ABI_NAMESPACE_END
#endif
