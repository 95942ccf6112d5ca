// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOcclusionTest.h"

#include "vtkNBufferSplitBox.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferOcclusionTest::vtkNBufferOcclusionTest(const vtkNBufferProjection& projection,
  const vtkNBufferLevels& levels, int maximumPieces, double sampleDistance)
  : Projection(projection)
  , Levels(levels)
  , MaximumPieces(maximumPieces)
  , SampleDistance(sampleDistance)
{
}

int vtkNBufferOcclusionTest::GetLevelsNeeded(const vtkNBufferRectangle& pixels, int factor)
{
  const vtkNBufferRectangle texels = vtkNBufferMath::GetBaseRectangle(pixels, factor);
  return vtkNBufferMath::GetLevelForFourLookups(texels.GetWidth(), texels.GetHeight()) + 1;
}

bool vtkNBufferOcclusionTest::IsBehind(const vtkNBufferScreenBox& screen)
{
  const vtkNBufferRectangle& pixels = screen.GetSampled(this->SampleDistance);
  if (pixels.IsEmpty())
  {
    return true;
  }
  const vtkNBufferCover cover = vtkNBufferMath::GetCoverOfFour(
    vtkNBufferMath::GetBaseRectangle(pixels, this->Levels.GetFactor()));
  // Without the level nothing is known, which means visible.
  if (cover.Level >= this->Levels.GetNumberOfLevels())
  {
    return false;
  }
  ++this->Queries;
  this->Lookups += cover.Count;
  return screen.Nearest > vtkNBufferDepthConvention::GetOrder(this->Levels.Query(cover));
}

bool vtkNBufferOcclusionTest::IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen)
{
  return vtkNBufferSplitBox::AreBehind(this->Projection, box, screen, this->MaximumPieces,
    this->Levels.GetFactor(),
    [this](const vtkNBufferScreenBox& part) { return this->IsBehind(part); });
}
VTK_ABI_NAMESPACE_END
