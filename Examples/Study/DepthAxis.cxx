// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DepthAxis.h"

#include "vtkNBufferMath.h"

#include <algorithm>
#include <cstdint>

namespace NBufferStudy
{
namespace
{
/// ceil(n / 2^shift) for any n, also below 0.
int CeilShift(int n, int shift)
{
  return -static_cast<int>(-static_cast<std::int64_t>(n) >> shift);
}
}

DepthAxis::DepthAxis(DepthGrid grid, int size, int stride)
  : Grid(grid)
  , Size(size)
  , Stride(grid == DepthGrid::Windows ? stride : 0)
{
  if (grid == DepthGrid::Windows)
  {
    this->NumberOfLevels = vtkNBufferMath::CeilLog2(size) + 1;
    return;
  }
  for (int count = size;; count /= 2)
  {
    this->Counts.push_back(count);
    if (count == 1)
    {
      break;
    }
  }
  this->NumberOfLevels = static_cast<int>(this->Counts.size());
  if (grid == DepthGrid::FatMips)
  {
    return;
  }
  for (int level = 0; level < this->NumberOfLevels; ++level)
  {
    const int count = this->Counts[level];
    std::vector<int> begins(count);
    std::vector<int> ends(count);
    for (int t = 0; t < count; ++t)
    {
      const DepthStep step = level > 0 ? this->GetStep(level) : DepthStep();
      begins[t] = level > 0 ? this->Begins.back()[step.Ratio * t] : t;
      ends[t] = level > 0
        ? this->Ends.back()[step.Ratio * t + (step.HasThird(t, count) ? 2 : step.Offset)]
        : t + 1;
    }
    this->Begins.push_back(begins);
    this->Ends.push_back(ends);
  }
}

int DepthAxis::GetStride(int level) const
{
  return std::max(level - this->Stride, 0);
}

int DepthAxis::GetCount(int level) const
{
  return this->Grid == DepthGrid::Windows ? CeilShift(this->Size, this->GetStride(level))
                                          : this->Counts[std::min(level, this->NumberOfLevels - 1)];
}

DepthStep DepthAxis::GetStep(int level) const
{
  DepthStep step;
  if (this->Grid == DepthGrid::Windows)
  {
    const int below = this->GetStride(level - 1);
    step.Ratio = 1 << (this->GetStride(level) - below);
    step.Offset = 1 << (level - 1 - below);
  }
  else if (level < this->NumberOfLevels)
  {
    step.Ratio = 2;
    step.Offset = 1;
    if (this->Counts[level - 1] % 2 != 0)
    {
      step.ThirdTap =
        this->Grid == DepthGrid::Mips ? DepthStep::Third::All : DepthStep::Third::Last;
    }
  }
  return step;
}

int DepthAxis::GetBegin(int level, int texel) const
{
  if (this->Grid == DepthGrid::Windows)
  {
    return texel << this->GetStride(level);
  }
  level = std::min(level, this->NumberOfLevels - 1);
  return this->Grid == DepthGrid::Mips ? this->Begins[level][texel] : texel << level;
}

int DepthAxis::GetEnd(int level, int texel) const
{
  if (this->Grid == DepthGrid::Windows)
  {
    return static_cast<int>(std::min<std::int64_t>(
      (static_cast<std::int64_t>(texel) << this->GetStride(level)) + (std::int64_t(1) << level),
      this->Size));
  }
  level = std::min(level, this->NumberOfLevels - 1);
  if (this->Grid == DepthGrid::Mips)
  {
    return this->Ends[level][texel];
  }
  return texel + 1 == this->Counts[level] ? this->Size : (texel + 1) << level;
}

int DepthAxis::Cover(int level, int begin, int end, int* texels, int limit) const
{
  int first = 0;
  int last = 0;
  int pace = 1;
  if (this->Grid == DepthGrid::Windows)
  {
    const int shift = this->GetStride(level);
    const std::int64_t window = std::int64_t(1) << level;
    last = end > window ? CeilShift(static_cast<int>(end - window), shift) : 0;
    // One window where one does, flush with the end: see vtkNBufferMath.h.
    first = std::max(std::min(begin >> shift, last), 0);
    first = last <= (begin >> shift) ? last : first;
    pace = 1 << (level - shift);
  }
  else
  {
    level = std::min(level, this->NumberOfLevels - 1);
    const int count = this->Counts[level];
    if (this->Grid == DepthGrid::Mips)
    {
      first = static_cast<int>(static_cast<std::int64_t>(begin) * count / this->Size);
      last = static_cast<int>((static_cast<std::int64_t>(end) * count - 1) / this->Size);
    }
    else
    {
      first = std::min(begin >> level, count - 1);
      last = std::min((end - 1) >> level, count - 1);
    }
  }
  const int number = 1 + (last - first + pace - 1) / pace;
  if (number <= limit)
  {
    for (int i = 0; i < number; ++i)
    {
      texels[i] = std::min(first + i * pace, last);
    }
  }
  return number;
}

int DepthAxis::GetFinestLevel(int begin, int end, int limit) const
{
  // `limit` texels of level i reach limit * 2^i; fat ones and those with three below may reach
  // farther.
  int level = this->Grid == DepthGrid::Windows
    ? std::max(vtkNBufferMath::CeilLog2((end - begin + limit - 1) / limit), 0)
    : 0;
  while (this->Cover(level, begin, end, nullptr, 0) > limit)
  {
    ++level;
  }
  return level;
}

} // namespace NBufferStudy
