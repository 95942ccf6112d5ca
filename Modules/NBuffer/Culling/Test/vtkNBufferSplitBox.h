// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferSplitBox.h
 * @brief Long boxes in pieces, each with its own rectangle and nearest depth. No OpenGL.
 *
 * What answers a rectangle is left to the caller, so that the rule is the same for all that do.
 */
#ifndef vtkNBufferPieces_h
#define vtkNBufferPieces_h

#include "vtkNBufferProjection.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferSplitBox
{
/// A piece shorter than this many texels of the base gains nothing from another cut.
constexpr double TexelsPerPiece = 2.0;

/**
 * Whether isBehind(screen) holds for the box or, cut along its longest axis on the screen into at
 * most `maximumPieces` pieces, for each of these. `screen` is what projection.Project gave for the
 * box, `factor` how many pixels a texel of the base stands for.
 */
template <typename IsBehind>
bool AreBehind(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen, int maximumPieces, int factor, IsBehind&& isBehind)
{
  if (isBehind(screen))
  {
    return true;
  }
  int axis = static_cast<int>(std::max_element(box.HalfSize, box.HalfSize + 3) - box.HalfSize);
  int pieces = maximumPieces;
  if (!screen.Clipped)
  {
    double lengths[3];
    projection.GetAxisLengths(box, lengths);
    axis = static_cast<int>(std::max_element(lengths, lengths + 3) - lengths);
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
        // What is drawn of a piece also lies in the rectangle of the whole box. Without this a
        // piece, being a little too long, might ask for a level that the box does not need.
        part.Pixels = vtkNBufferMath::Intersect(part.Pixels, screen.Pixels);
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
