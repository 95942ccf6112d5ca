// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOcclusionTest.h"

#include <limits>

VTK_ABI_NAMESPACE_BEGIN
int vtkNBufferOcclusionTest::GetLevelsNeeded(const vtkNBufferRectangle& pixels, int factor)
{
  const vtkNBufferRectangle texels = vtkNBufferMath::GetBaseRectangle(pixels, factor);
  return vtkNBufferMath::GetLevelForFourLookups(texels.GetWidth(), texels.GetHeight()) + 1;
}

vtkNBufferCover vtkNBufferOcclusionTest::GetCover(const vtkNBufferScreenBox& screen) const
{
  const vtkNBufferRectangle& pixels = screen.GetSampled(this->SampleDistance);
  return pixels.IsEmpty() ? vtkNBufferCover()
                          : vtkNBufferMath::GetCoverOfFour(
                              vtkNBufferMath::GetBaseRectangle(pixels, this->Levels.GetFactor()));
}

double vtkNBufferOcclusionTest::GetClearance(const vtkNBufferScreenBox& screen)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const vtkNBufferCover cover = this->GetCover(screen);
  // Without samples nothing can be seen. Without the level nothing is known, which means visible.
  if (cover.Count == 0 || cover.Level >= this->Levels.GetNumberOfLevels())
  {
    return cover.Count == 0 ? infinity : -infinity;
  }
  ++this->Queries;
  this->Lookups += cover.Count;
  return screen.Nearest - this->Levels.Query(cover);
}

bool vtkNBufferOcclusionTest::FindVisiblePixels(
  const vtkNBufferScreenBox& screen, vtkNBufferRectangle& pixels)
{
  const vtkNBufferCover cover = this->GetCover(screen);
  const bool isFound = cover.Level < this->Levels.GetNumberOfLevels() && !this->IsHidden(screen);
  pixels = isFound ? this->Levels.FindPixels(cover) : vtkNBufferRectangle();
  return isFound;
}
VTK_ABI_NAMESPACE_END
