// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PositionedLevels.h"

#include "vtkNBufferLevelBuilder.h"

#include <algorithm>

namespace NBufferStudy
{
namespace
{
struct Farther
{
  PositionedDepth operator()(const PositionedDepth& a, const PositionedDepth& b) const
  {
    const bool second = b.Depth > a.Depth || (b.Depth == a.Depth && b.Pixel < a.Pixel);
    return second ? b : a;
  }
};
}

void PositionedLevels::Build(const float* depth, int width, int height)
{
  const int factor = this->Factor;
  this->Width = vtkNBufferMath::GetBaseSize(width, factor);
  this->Height = vtkNBufferMath::GetBaseSize(height, factor);
  const int levels = vtkNBufferMath::GetNumberOfLevels(this->Width, this->Height);
  this->Texels.resize(static_cast<std::size_t>(this->Width) * this->Height * levels);
  const Farther farther;
  for (int y = 0; y < height; ++y)
  {
    PositionedDepth* row = this->Texels.data() + static_cast<std::size_t>(y / factor) * this->Width;
    for (int x = 0; x < width; ++x)
    {
      const std::int32_t pixel = y * width + x;
      const PositionedDepth here = { depth[pixel], pixel };
      PositionedDepth& texel = row[x / factor];
      texel = x % factor == 0 && y % factor == 0 ? here : farther(texel, here);
    }
  }
  vtkNBufferLevelBuilder::BuildLevels<Farther>(
    this->Texels.data(), this->Width, this->Height, 1, levels);
}

PositionedDepth PositionedLevels::Query(const vtkNBufferRectangle& pixels, long long& lookups) const
{
  const vtkNBufferCover cover =
    vtkNBufferMath::GetCoverOfFour(vtkNBufferMath::GetBaseRectangle(pixels, this->Factor));
  lookups += cover.Count;
  return vtkNBufferMath::MergeCover(
    this->Texels.data(), this->Width, this->Height, cover, Farther());
}

} // namespace NBufferStudy
