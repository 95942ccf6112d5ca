// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowDebugImage.h
 * @brief Paints what is laid over the picture to show why shadows take what they take. No OpenGL.
 *
 * Images have four bytes, red, green, blue and opacity, for each pixel of the viewport, row by row,
 * the lowest first; where nothing is to be shown all four are 0. Numbers are shown as heat, on a
 * logarithmic scale that is the same in all frames: 1 blue, 4 cyan, 16 green, 64 yellow, 255 and
 * more red.
 */
#ifndef vtkShadowDebugImage_h
#define vtkShadowDebugImage_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowLitmap.h"
#include "vtkShadowPlan.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkShadowDebugImage
{
using Color = std::array<unsigned char, 4>;
using Image = std::vector<unsigned char>;

/// Of a number of 0 (nothing) or more.
VTKNBUFFER_EXPORT Color GetHeat(int number);

/**
 * Three squares for each litmap (one, or the six of a point light, upwards), from the left: nearest
 * depth and farthest depth of the receivers in a lexel, the nearer to the light the brighter, and
 * the number of occupied bins as heat. Lexels without receivers are dark. p goes to the right, q
 * upwards.
 */
VTKNBUFFER_EXPORT Image PaintLitmaps(
  const vtkShadowLitmap* litmaps, int count, int width, int height);

/// The edges of all boxes in white, and inside of them, as heat, in how many a pixel is.
VTKNBUFFER_EXPORT Image PaintExtents(
  const std::vector<vtkShadowDraw>& draws, const int viewport[4]);

/// Heat in the place of the numbers that `image` has in its first channel.
VTKNBUFFER_EXPORT void PaintCounts(Image& image);
}
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkShadowDebugImage.h
