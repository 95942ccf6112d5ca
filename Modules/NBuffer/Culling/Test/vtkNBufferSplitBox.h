// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferSplitBox.h
 * @brief Cuts long boxes into pieces, each with its own rectangle and nearest depth. No OpenGL.
 *
 * How a rectangle is compared with the depth image is left to the caller, so that the levels, the
 * benchmarks and the tests cut boxes in the same way.
 */
#ifndef vtkNBufferSplitBox_h
#define vtkNBufferSplitBox_h

#include "vtkNBufferProjection.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferSplitBox
{
/// A piece shorter than this many texels of the base gains nothing from another cut.
constexpr double TexelsPerPiece = 2.0;

/**
 * Whether a box lies behind what is drawn. That is so if isBehind(screen) holds for the whole box,
 * or if it holds for each of at most `maximumPieces` pieces into which the box is cut along its
 * longest axis on the screen. `screen` is what projection.Project() gave for the box. `factor` is
 * how many pixels a texel of the base stands for, along each axis.
 */
template <typename IsBehind>
bool AreBehind(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, int maximumPieces, int factor, IsBehind&& isBehind)
{
  if (isBehind(screen))
  {
    return true;
  }
  const auto getLongest = [](const glm::dvec3& lengths)
  {
    const double* x = glm::value_ptr(lengths);
    return static_cast<int>(std::max_element(x, x + 3) - x);
  };
  int axis = getLongest(box.HalfSize);
  int pieces = maximumPieces;
  if (!screen.Clipped)
  {
    const glm::dvec3 lengths = projection.GetAxisLengths(box);
    axis = getLongest(lengths);
    pieces = static_cast<int>(std::min<double>(pieces, lengths[axis] / (TexelsPerPiece * factor)));
  }
  if (pieces < 2)
  {
    return false;
  }
  vtkNBufferBox piece = box;
  // A little longer than a part, so that rounding leaves no gap between two pieces.
  piece.HalfSize[axis] =
    box.HalfSize[axis] / pieces + (std::abs(box.Center[axis]) + box.HalfSize[axis]) * 0x1p-49;
  for (int i = 0; i < pieces; ++i)
  {
    piece.Center[axis] = box.Center[axis] + box.HalfSize[axis] * ((2.0 * i + 1.0) / pieces - 1.0);
    vtkNBufferScreenBox part;
    switch (projection.Project(piece, part))
    {
      case vtkNBufferPlacement::Outside:
        break;
      case vtkNBufferPlacement::Crossing:
        return false;
      case vtkNBufferPlacement::Inside:
        // What is drawn of a piece also lies in the rectangle of the whole box. Without this cut a
        // piece, being a little too long, might need a level that the box does not need.
        part.Pixels = part.Pixels.GetIntersection(screen.Pixels);
        part.Middles = part.Middles.GetIntersection(screen.Middles);
        projection.SetPiece(screen, part);
        if (!part.Pixels.IsEmpty() && !isBehind(part))
        {
          return false;
        }
        break;
    }
  }
  return true;
}
}

VTK_ABI_NAMESPACE_END
#endif
