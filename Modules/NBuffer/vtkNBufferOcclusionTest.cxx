// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOcclusionTest.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A piece shorter than this many texels of the base gains nothing from another cut.
constexpr double TexelsPerPiece = 2.0;
}

vtkNBufferOcclusionTest::vtkNBufferOcclusionTest(
  const vtkNBufferProjection& projection, const vtkNBufferLevels& levels, int maximumPieces)
  : Projection(projection)
  , Levels(levels)
  , MaximumPieces(maximumPieces)
{
}

int vtkNBufferOcclusionTest::GetLevelsNeeded(const vtkNBufferRectangle& pixels, int factor)
{
  const vtkNBufferRectangle texels = vtkNBufferMath::GetBaseRectangle(pixels, factor);
  return vtkNBufferMath::GetLevelForFourLookups(texels.GetWidth(), texels.GetHeight()) + 1;
}

bool vtkNBufferOcclusionTest::IsBehind(const vtkNBufferScreenBox& screen)
{
  const vtkNBufferCover cover = vtkNBufferMath::GetCoverOfFour(
    vtkNBufferMath::GetBaseRectangle(screen.Pixels, this->Levels.GetFactor()));
  // Without the level there is no information, which means visible.
  if (cover.Level >= this->Levels.GetNumberOfLevels())
  {
    return false;
  }
  ++this->Queries;
  this->Lookups += cover.Count;
  return screen.Nearest > this->Projection.GetDepthSign() * this->Levels.Query(cover);
}

bool vtkNBufferOcclusionTest::IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  if (this->IsBehind(screen))
  {
    return true;
  }
  int axis = static_cast<int>(std::max_element(box.HalfSize, box.HalfSize + 3) - box.HalfSize);
  int pieces = this->MaximumPieces;
  if (!screen.Clipped)
  {
    double lengths[3];
    this->Projection.GetAxisLengths(box, lengths);
    axis = static_cast<int>(std::max_element(lengths, lengths + 3) - lengths);
    pieces = static_cast<int>(
      std::min<double>(pieces, lengths[axis] / (TexelsPerPiece * this->Levels.GetFactor())));
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
    switch (this->Projection.Project(piece, part))
    {
      case vtkNBufferPlacement::Outside:
        break;
      case vtkNBufferPlacement::Crossing:
        return false;
      case vtkNBufferPlacement::Inside:
        // What is drawn of a piece also lies in the rectangle of the whole box. Without this a
        // piece, being a little too long, might ask for a level that the box does not need.
        part.Pixels = vtkNBufferMath::Intersect(part.Pixels, screen.Pixels);
        if (!part.Pixels.IsEmpty() && !this->IsBehind(part))
        {
          return false;
        }
        break;
    }
  }
  return true;
}
VTK_ABI_NAMESPACE_END
