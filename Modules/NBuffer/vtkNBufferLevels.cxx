// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferLevels.h"

#include "vtkNBufferLevelBuilder.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// Compilers turn each of these expressions into one vector instruction.
struct Maximum
{
  float operator()(float a, float b) const { return a > b ? a : b; }
};
struct Minimum
{
  float operator()(float a, float b) const { return a < b ? a : b; }
};

/// Make one row of the base: merge the first `rows` rows of `depth` into one, and then each
/// `factor` neighbours in that row into one texel. `scratch` has room for a row of depth.
template <typename Op>
void ReduceRows(const float* depth, int width, int rows, int factor, float* scratch, float* out)
{
  const Op op;
  const float* columns = depth;
  if (rows > 1)
  {
    for (int x = 0; x < width; ++x)
    {
      scratch[x] = op(depth[x], depth[static_cast<std::size_t>(width) + x]);
    }
    for (int row = 2; row < rows; ++row)
    {
      const float* next = depth + static_cast<std::size_t>(row) * width;
      for (int x = 0; x < width; ++x)
      {
        scratch[x] = op(scratch[x], next[x]);
      }
    }
    columns = scratch;
  }
  const int whole = width / factor;
  if (factor == 4)
  {
    for (int x = 0; x < whole; ++x)
    {
      out[x] =
        op(op(columns[4 * x], columns[4 * x + 1]), op(columns[4 * x + 2], columns[4 * x + 3]));
    }
  }
  else
  {
    for (int x = 0; x < whole; ++x)
    {
      float value = columns[x * factor];
      for (int i = 1; i < factor; ++i)
      {
        value = op(value, columns[x * factor + i]);
      }
      out[x] = value;
    }
  }
  if (whole * factor < width)
  {
    float value = columns[whole * factor];
    for (int x = whole * factor + 1; x < width; ++x)
    {
      value = op(value, columns[x]);
    }
    out[whole] = value;
  }
}

template <typename Op>
void ReduceToBase(
  const float* depth, int width, int height, int factor, const vtkNBufferRows& rows, float* base)
{
  const int baseWidth = vtkNBufferMath::GetBaseSize(width, factor);
  const int baseHeight = vtkNBufferMath::GetBaseSize(height, factor);
  vtkNBufferLevelBuilder::ForEachRow(baseHeight, static_cast<vtkIdType>(width) * height,
    [=](int begin, int end)
    {
      std::vector<float> scratch(factor > 1 ? width : 0);
      for (int y = begin; y < end; ++y)
      {
        const int first = y * factor;
        float* const out = base + static_cast<std::size_t>(y) * baseWidth;
        if (first + factor <= rows.Begin || first >= rows.End)
        {
          std::fill_n(out, baseWidth, rows.Outside);
          continue;
        }
        ReduceRows<Op>(depth + static_cast<std::size_t>(first) * width, width,
          std::min(factor, height - first), factor, scratch.data(), out);
      }
    });
}
}

void vtkNBufferLevels::Allocate(
  int pixelWidth, int pixelHeight, int factor, int levels, vtkNBufferExtremum extremum)
{
  this->PixelWidth = pixelWidth;
  this->PixelHeight = pixelHeight;
  this->Factor = factor;
  this->Width = vtkNBufferMath::GetBaseSize(pixelWidth, factor);
  this->Height = vtkNBufferMath::GetBaseSize(pixelHeight, factor);
  this->NumberOfLevels =
    std::min(levels, vtkNBufferMath::GetNumberOfLevels(this->Width, this->Height));
  this->Extremum = extremum;
  this->Texels.resize(std::max(this->Texels.size(), this->GetLevelOffset(this->NumberOfLevels)));
}

void vtkNBufferLevels::BuildBase(const float* depth, int width, int height, int factor,
  vtkNBufferExtremum extremum, const vtkNBufferRows& rows)
{
  this->Allocate(width, height, factor, 1, extremum);
  if (this->NumberOfLevels == 0)
  {
    return;
  }
  const auto reduce =
    extremum == vtkNBufferExtremum::Maximum ? &ReduceToBase<Maximum> : &ReduceToBase<Minimum>;
  reduce(depth, width, height, factor, rows, this->GetLevelData(0));
}

int vtkNBufferLevels::BuildLevels(int count)
{
  const int first = this->NumberOfLevels;
  const int levels = std::min(count, vtkNBufferMath::GetNumberOfLevels(this->Width, this->Height));
  if (first == 0 || levels <= first)
  {
    return 0;
  }
  this->Texels.resize(std::max(this->Texels.size(), this->GetLevelOffset(levels)));
  this->NumberOfLevels = levels;
  if (this->Extremum == vtkNBufferExtremum::Maximum)
  {
    vtkNBufferLevelBuilder::BuildLevels<Maximum>(
      this->Texels.data(), this->Width, this->Height, first, levels);
  }
  else
  {
    vtkNBufferLevelBuilder::BuildLevels<Minimum>(
      this->Texels.data(), this->Width, this->Height, first, levels);
  }
  return levels - first;
}

vtkNBufferRectangle vtkNBufferLevels::FindPixels(const vtkNBufferCover& cover) const
{
  const float extremum = this->Query(cover);
  // The squares of four texels of a level make up the square of one of the level above.
  vtkNBufferCover texels = cover;
  int x = 0;
  int y = 0;
  for (;;)
  {
    int i = 0;
    while (
      i + 1 < texels.Count && this->GetTexel(texels.Level, texels.X[i], texels.Y[i]) != extremum)
    {
      ++i;
    }
    x = texels.X[i];
    y = texels.Y[i];
    if (texels.Level == 0)
    {
      break;
    }
    --texels.Level;
    const int right = std::min(x + (1 << texels.Level), this->Width - 1);
    const int top = std::min(y + (1 << texels.Level), this->Height - 1);
    texels = { texels.Level, 4, { x, right, x, right }, { y, y, top, top } };
  }
  const int f = this->Factor;
  return vtkNBufferRectangle{ x * f, y * f, (x + 1) * f, (y + 1) * f }.GetIntersection(
    { 0, 0, this->PixelWidth, this->PixelHeight });
}

void vtkNBufferLevels::Clear()
{
  this->NumberOfLevels = 0;
  this->Width = this->Height = this->PixelWidth = this->PixelHeight = 0;
}

const float* vtkNBufferLevels::GetLevelData(int level) const
{
  return level >= 0 && level < this->NumberOfLevels
    ? this->Texels.data() + this->GetLevelOffset(level)
    : nullptr;
}

float* vtkNBufferLevels::GetLevelData(int level)
{
  return const_cast<float*>(std::as_const(*this).GetLevelData(level));
}
VTK_ABI_NAMESPACE_END
