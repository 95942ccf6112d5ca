// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthStructure.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace NBufferStudy
{
namespace
{
constexpr auto Farther = [](float a, float b) { return a > b ? a : b; };

/// Texels x to end - 1 of a row of a level from the row below, all taps inside it.
void MergeInside(const float* in, const DepthStep& step, int end, float* out)
{
  const float* other = in + step.Offset;
  if (step.Ratio == 1)
  {
    std::transform(in, in + end, other, out, Farther);
  }
  else if (step.ThirdTap == DepthStep::Third::All)
  {
    for (int x = 0; x < end; ++x)
    {
      out[x] = Farther(Farther(in[2 * x], in[2 * x + 1]), in[2 * x + 2]);
    }
  }
  else
  {
    for (int x = 0; x < end; ++x)
    {
      out[x] = Farther(in[2 * x], other[2 * x]);
    }
  }
}

void MergeRow(const float* in, int width, const DepthStep& step, float* out, int count)
{
  const int reach = step.ThirdTap == DepthStep::Third::All ? 2 : step.Offset;
  const int end = std::clamp((width - reach + step.Ratio - 1) / step.Ratio, 0, count);
  MergeInside(in, step, end, out);
  for (int x = end; x < count; ++x)
  {
    out[x] = Farther(in[x * step.Ratio], in[std::min(x * step.Ratio + step.Offset, width - 1)]);
  }
  if (step.ThirdTap == DepthStep::Third::Last)
  {
    out[count - 1] = Farther(out[count - 1], in[width - 1]);
  }
}

/// One row from the two or three rows that a row of a level is made of.
void MergeRows(
  const float* in, int width, int height, const DepthStep& step, int y, int count, float* out)
{
  const auto row = [=](int place)
  { return in + static_cast<std::size_t>(std::min(place, height - 1)) * width; };
  const float* first = row(y * step.Ratio);
  std::transform(first, first + width, row(y * step.Ratio + step.Offset), out, Farther);
  if (step.HasThird(y, count))
  {
    std::transform(out, out + width, row(y * step.Ratio + 2), out, Farther);
  }
}
}

std::string DepthFamily::GetName() const
{
  std::string name = this->Taps == DepthTaps::All ? "one level"
    : this->Grid == DepthGrid::Mips               ? "mips"
    : this->Grid == DepthGrid::FatMips            ? "fat mips"
    : this->Band == 0                             ? "squares"
                                                  : "rectangles";
  if (this->Taps != DepthTaps::All)
  {
    if (this->Band > 0 && this->Band < AllShapes)
    {
      name += " band " + std::to_string(this->Band);
    }
    if (this->Grid == DepthGrid::Windows && this->Stride < FullStride)
    {
      name += " s=" + std::to_string(this->Stride);
    }
    const char* const taps[] = { "x1", "x4", "2x2", "4x4" };
    name += std::string(" ") + taps[static_cast<int>(this->Taps)];
  }
  name += " 1/" + std::to_string(this->Factor);
  return this->Separable ? name + " separable" : name;
}

DepthStructure::DepthStructure(const DepthFamily& family)
  : Family(family)
{
}

bool DepthStructure::IsPlain() const
{
  return this->Family.Grid == DepthGrid::Windows && this->Family.Band == 0 &&
    this->Family.Stride >= FullStride && !this->Family.Separable;
}

bool DepthStructure::HasLevel(int x, int y) const
{
  if (this->Family.Taps == DepthTaps::All)
  {
    return x == 0 && y == 0;
  }
  if (std::abs(x - y) > this->Family.Band)
  {
    return false;
  }
  // Above the last level of its axis a level says nothing new, but the band may call for it.
  const int topX = std::max(this->Columns.GetNumberOfLevels() - 1, y - this->Family.Band);
  const int topY = std::max(this->Rows.GetNumberOfLevels() - 1, x - this->Family.Band);
  return x <= topX && y <= topY;
}

void DepthStructure::SetSize(int width, int height)
{
  this->Width = width;
  this->Height = height;
  this->Columns = DepthAxis(this->Family.Grid,
    vtkNBufferMath::GetBaseSize(width, this->Family.Factor), this->Family.Stride);
  this->Rows = DepthAxis(this->Family.Grid,
    vtkNBufferMath::GetBaseSize(height, this->Family.Factor), this->Family.Stride);
  this->Side = std::max(this->Columns.GetNumberOfLevels(), this->Rows.GetNumberOfLevels());
  this->Places.assign(static_cast<std::size_t>(this->Side) * this->Side, -1);
  this->Levels.clear();
  const auto place = [this](int x, int y) -> int&
  { return this->Places[static_cast<std::size_t>(y) * this->Side + x]; };
  for (int y = 0; y < this->Side; ++y)
  {
    for (int x = 0; x < this->Side; ++x)
    {
      if (!this->HasLevel(x, y))
      {
        continue;
      }
      place(x, y) = this->GetNumberOfLevels();
      Level level;
      level.X = x;
      level.Y = y;
      level.Width = this->Columns.GetCount(x);
      level.Height = this->Rows.GetCount(y);
      if (x > 0 || y > 0)
      {
        // By one axis where the neighbour exists; in a band of 0 it never does.
        const bool hasLeft = x > 0 && place(x - 1, y) >= 0;
        const bool hasLower = y > 0 && place(x, y - 1) >= 0;
        level.StepX = hasLeft || !hasLower;
        level.StepY = !hasLeft;
        level.From = place(x - (level.StepX ? 1 : 0), y - (level.StepY ? 1 : 0));
      }
      this->Levels.push_back(std::move(level));
    }
  }
}

void DepthStructure::Allocate()
{
  const std::size_t row = static_cast<std::size_t>(this->Columns.GetSize());
  this->Scratch.resize(this->Family.Separable ? row * this->Rows.GetSize() : row);
  for (std::size_t i = 1; i < this->Levels.size(); ++i)
  {
    Level& level = this->Levels[i];
    level.Storage.resize(static_cast<std::size_t>(level.Width) * level.Height);
    level.Texels = level.Storage.data();
  }
}

void DepthStructure::BuildColumns(
  const float* in, int width, int height, const Level& level, float* out)
{
  const DepthStep step = this->Rows.GetStep(level.Y);
  for (int y = 0; y < level.Height; ++y)
  {
    MergeRows(in, width, height, step, y, level.Height, out + static_cast<std::size_t>(y) * width);
  }
}

void DepthStructure::BuildLevel(Level& level)
{
  const Level& from = this->Levels[level.From];
  const auto row = [](float* texels, int width, int y)
  { return texels + static_cast<std::size_t>(y) * width; };
  if (!level.StepX)
  {
    this->BuildColumns(from.Texels, from.Width, from.Height, level, level.Texels);
    return;
  }
  const DepthStep step = this->Columns.GetStep(level.X);
  if (!level.StepY || this->Family.Separable)
  {
    float* rows = level.StepY ? this->Scratch.data() : level.Texels;
    for (int y = 0; y < from.Height; ++y)
    {
      MergeRow(
        row(from.Texels, from.Width, y), from.Width, step, row(rows, level.Width, y), level.Width);
    }
    if (level.StepY)
    {
      this->BuildColumns(rows, level.Width, from.Height, level, level.Texels);
    }
    return;
  }
  const DepthStep stepY = this->Rows.GetStep(level.Y);
  for (int y = 0; y < level.Height; ++y)
  {
    MergeRows(from.Texels, from.Width, from.Height, stepY, y, level.Height, this->Scratch.data());
    MergeRow(
      this->Scratch.data(), from.Width, step, row(level.Texels, level.Width, y), level.Width);
  }
}

void DepthStructure::Build(const float* depth, int width, int height)
{
  if (width != this->Width || height != this->Height)
  {
    this->SetSize(width, height);
  }
  this->Base.BuildBase(depth, width, height, this->Family.Factor, vtkNBufferExtremum::Maximum);
  if (this->IsPlain())
  {
    this->Base.BuildLevels(this->GetNumberOfLevels());
    for (Level& level : this->Levels)
    {
      level.Texels = this->Base.GetLevelData(level.X);
    }
    return;
  }
  this->Allocate();
  this->Levels.front().Texels = this->Base.GetLevelData(0);
  for (std::size_t i = 1; i < this->Levels.size(); ++i)
  {
    this->BuildLevel(this->Levels[i]);
  }
}

DepthCover DepthStructure::GetCover(const vtkNBufferRectangle& texels) const
{
  struct Shape
  {
    int Columns, Rows;
  };
  constexpr Shape one[] = { { 1, 1 } };
  constexpr Shape four[] = { { 2, 2 }, { 4, 1 }, { 1, 4 } };
  constexpr Shape sixteen[] = { { 4, 4 } };
  const Shape* shapes = this->Family.Taps == DepthTaps::One ? one
    : this->Family.Taps == DepthTaps::FourByFour            ? sixteen
                                                            : four;
  const Shape* end = shapes + (this->Family.Taps == DepthTaps::Four ? 3 : 1);

  int bestX = 0;
  int bestY = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (; shapes != end; ++shapes)
  {
    int x = this->Columns.GetFinestLevel(texels.X0, texels.X1, shapes->Columns);
    int y = this->Rows.GetFinestLevel(texels.Y0, texels.Y1, shapes->Rows);
    x = std::max(x, y - this->Family.Band);
    y = std::max(y, x - this->Family.Band);
    // Of Mips alone, whose texels do not nest, a coarser level may cut what a finer one does not.
    const bool nested = this->Family.Grid != DepthGrid::Mips;
    for (bool found = nested; !found;)
    {
      found = true;
      if (this->Columns.Cover(x, texels.X0, texels.X1, nullptr, 0) > shapes->Columns)
      {
        ++x;
        found = false;
      }
      if (this->Rows.Cover(y, texels.Y0, texels.Y1, nullptr, 0) > shapes->Rows)
      {
        ++y;
        found = false;
      }
      x = std::max(x, y - this->Family.Band);
      y = std::max(y, x - this->Family.Band);
    }
    const double area = static_cast<double>(std::max(texels.GetWidth(), 1 << x)) *
      std::max(texels.GetHeight(), 1 << y);
    if (area < smallest)
    {
      smallest = area;
      bestX = x;
      bestY = y;
    }
  }
  DepthCover cover;
  cover.LevelX = bestX;
  cover.LevelY = bestY;
  cover.Level = this->Places[static_cast<std::size_t>(bestY) * this->Side + bestX];
  cover.Columns = this->Columns.Cover(bestX, texels.X0, texels.X1, cover.X, 4);
  cover.Rows = this->Rows.Cover(bestY, texels.Y0, texels.Y1, cover.Y, 4);
  return cover;
}

float DepthStructure::Query(const vtkNBufferRectangle& pixels, long long& lookups) const
{
  const vtkNBufferRectangle texels = vtkNBufferMath::GetBaseRectangle(pixels, this->Family.Factor);
  float result = -std::numeric_limits<float>::infinity();
  if (this->Family.Taps == DepthTaps::All)
  {
    const Level& base = this->Levels.front();
    for (int y = texels.Y0; y < texels.Y1; ++y)
    {
      const float* row = base.Texels + static_cast<std::size_t>(y) * base.Width;
      result = std::accumulate(row + texels.X0, row + texels.X1, result, Farther);
    }
    lookups += static_cast<long long>(texels.GetWidth()) * texels.GetHeight();
    return result;
  }
  const DepthCover cover = this->GetCover(texels);
  const Level& level = this->Levels[cover.Level];
  for (int y = 0; y < cover.Rows; ++y)
  {
    const float* row = level.Texels + static_cast<std::size_t>(cover.Y[y]) * level.Width;
    for (int x = 0; x < cover.Columns; ++x)
    {
      result = Farther(result, row[cover.X[x]]);
    }
  }
  lookups += static_cast<long long>(cover.Columns) * cover.Rows;
  return result;
}

vtkNBufferRectangle DepthStructure::GetCovered(const vtkNBufferRectangle& pixels) const
{
  vtkNBufferRectangle covered = vtkNBufferMath::GetBaseRectangle(pixels, this->Family.Factor);
  if (this->Family.Taps != DepthTaps::All)
  {
    const DepthCover cover = this->GetCover(covered);
    covered.X0 = this->Columns.GetBegin(cover.LevelX, cover.X[0]);
    covered.X1 = this->Columns.GetEnd(cover.LevelX, cover.X[cover.Columns - 1]);
    covered.Y0 = this->Rows.GetBegin(cover.LevelY, cover.Y[0]);
    covered.Y1 = this->Rows.GetEnd(cover.LevelY, cover.Y[cover.Rows - 1]);
  }
  covered.X0 *= this->Family.Factor;
  covered.Y0 *= this->Family.Factor;
  covered.X1 = std::min(covered.X1 * this->Family.Factor, this->Width);
  covered.Y1 = std::min(covered.Y1 * this->Family.Factor, this->Height);
  return covered;
}

std::size_t DepthStructure::GetNumberOfTexels() const
{
  return std::accumulate(this->Levels.begin(), this->Levels.end(), std::size_t(0),
    [](std::size_t texels, const Level& level)
    { return texels + static_cast<std::size_t>(level.Width) * level.Height; });
}

std::size_t DepthStructure::GetMemory() const
{
  std::size_t texels = this->Scratch.capacity();
  for (const Level& level : this->Levels)
  {
    texels += level.Storage.capacity();
  }
  texels += static_cast<std::size_t>(this->Base.GetWidth()) * this->Base.GetHeight() *
    this->Base.GetNumberOfLevels();
  return texels * sizeof(float);
}

} // namespace NBufferStudy
