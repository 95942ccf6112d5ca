// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOcclusionTest.h"

#include "vtkNBufferDepthConvention.h"

VTK_ABI_NAMESPACE_BEGIN
vtkNBufferOcclusionTest::vtkNBufferOcclusionTest(
  const vtkNBufferLevels& levels, double sampleDistance)
  : Levels(levels)
  , SampleDistance(sampleDistance)
{
}

int vtkNBufferOcclusionTest::GetLevelsNeeded(const vtkNBufferRectangle& pixels, int factor)
{
  const vtkNBufferRectangle texels = vtkNBufferMath::GetBaseRectangle(pixels, factor);
  return vtkNBufferMath::GetLevelForFourLookups(texels.GetWidth(), texels.GetHeight()) + 1;
}

bool vtkNBufferOcclusionTest::IsHidden(const vtkNBufferScreenBox& screen)
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
VTK_ABI_NAMESPACE_END
