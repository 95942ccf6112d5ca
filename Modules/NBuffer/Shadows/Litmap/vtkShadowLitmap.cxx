// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLitmap.h"

#include "vtkNBufferLevelBuilder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr vtkIdType RowsPerThread = 16;

/// The number of lexels for which several threads build a level.
constexpr vtkIdType LexelsWorthAThread = 1 << 14;

struct MergeExtents
{
  vtkShadowExtent operator()(vtkShadowExtent a, const vtkShadowExtent& b) const
  {
    a.Merge(b);
    return a;
  }
};
}

void vtkShadowLitmap::Begin(int resolution, const vtkShadowBlock& range)
{
  this->Resolution = std::clamp(resolution, 1, MaximumResolution);
  this->NumberOfLevels = 0;
  this->NumberOfReceivers = 0;
  this->WidestAngle = 0.0;
  this->Everywhere = vtkShadowExtent();
  this->Tiles.Begin(0, 0);
  this->P = Scale(range.Low[0], range.High[0], this->Resolution);
  this->Q = Scale(range.Low[1], range.High[1], this->Resolution);
  this->Depths = Scale(range.Low[2], range.High[2], NumberOfBins);
  this->Low = range.Low;
  this->High = range.High;
  const std::size_t size = static_cast<std::size_t>(this->Resolution) * this->Resolution;
  if (this->Lexels.size() < size)
  {
    this->Lexels.resize(size);
  }
  std::fill_n(this->Lexels.begin(), size, vtkShadowExtent());
}

inline std::uint64_t vtkShadowLitmap::GetBins(double nearest, double farthest) const
{
  const int first = this->Depths.GetCell(nearest);
  const int last = this->Depths.GetCell(farthest);
  return (~std::uint64_t(0) << first) & (~std::uint64_t(0) >> (63 - last));
}

inline void vtkShadowLitmap::AddToLexels(
  int i0, int i1, int j0, int j1, const vtkShadowExtent& receiver)
{
  for (int j = j0; j <= j1; ++j)
  {
    vtkShadowExtent* row = this->Lexels.data() + static_cast<std::size_t>(j) * this->Resolution;
    for (int i = i0; i <= i1; ++i)
    {
      row[i].Merge(receiver);
    }
  }
}

bool vtkShadowLitmap::Add(const glm::dvec3& a, const glm::dvec3& b, double radius, int x, int y)
{
  if (!std::isfinite(a[0] + a[1] + a[2] + b[0] + b[1] + b[2]))
  {
    return false;
  }
  vtkShadowExtent receiver;
  receiver.Near = std::min(a[2], b[2]);
  receiver.Far = std::max(a[2], b[2]);
  receiver.X0 = static_cast<std::uint16_t>(x);
  receiver.Y0 = static_cast<std::uint16_t>(y);
  receiver.X1 = static_cast<std::uint16_t>(x + 1);
  receiver.Y1 = static_cast<std::uint16_t>(y + 1);
  receiver.Bins = this->GetBins(receiver.Near, receiver.Far);
  ++this->NumberOfReceivers;

  if (std::isinf(radius))
  {
    this->Everywhere.Merge(receiver);
    return true;
  }
  const double p0 = std::min(a[0], b[0]) - radius;
  const double p1 = std::max(a[0], b[0]) + radius;
  const double q0 = std::min(a[1], b[1]) - radius;
  const double q1 = std::max(a[1], b[1]) + radius;
  this->Low = glm::min(this->Low, glm::dvec2(p0, q0));
  this->High = glm::max(this->High, glm::dvec2(p1, q1));
  const int i0 = this->P.GetCell(p0);
  const int i1 = this->P.GetCell(p1);
  const int j0 = this->Q.GetCell(q0);
  const int j1 = this->Q.GetCell(q1);
  if (i1 - i0 < 2 || j1 - j0 < 2 || a[0] == b[0])
  {
    this->AddToLexels(i0, i1, j0, j1, receiver);
    return true;
  }
  // A long segment is added column by column: the part of the segment in the column, widened by the
  // radius, gives the rows that the segment passes there.
  const double slope = (b[1] - a[1]) / (b[0] - a[0]);
  for (int i = i0; i <= i1; ++i)
  {
    const double begin = i == i0 ? p0 : this->P.GetEdge(i) - radius;
    const double end = i == i1 ? p1 : this->P.GetEdge(i + 1) + radius;
    const double qBegin = a[1] + (begin - a[0]) * slope;
    const double qEnd = a[1] + (end - a[0]) * slope;
    const double low = std::max(std::min(qBegin, qEnd) - radius, q0);
    const double high = std::min(std::max(qBegin, qEnd) + radius, q1);
    this->AddToLexels(i, i, this->Q.GetCell(low), this->Q.GetCell(high), receiver);
  }
  return true;
}

bool vtkShadowLitmap::AddLexel(int i, int j, vtkShadowExtent extent)
{
  const bool inside = i >= 0 && j >= 0 && i < this->Resolution && j < this->Resolution;
  if (!inside || extent.IsEmpty() || extent.Y1 <= extent.Y0 || !(extent.Near <= extent.Far) ||
    !std::isfinite(extent.Far - extent.Near))
  {
    return false;
  }
  extent.Bins = this->GetBins(extent.Near, extent.Far);
  ++this->NumberOfReceivers;
  this->AddToLexels(i, i, j, j, extent);
  return true;
}

vtkShadowLitmap& vtkShadowLitmap::BeginPart(int i)
{
  if (i == 0)
  {
    return *this;
  }
  vtkShadowLitmap& part = this->Parts[static_cast<std::size_t>(i - 1)];
  part.Begin(this->Resolution,
    { { this->P.Low, this->Q.Low, this->Depths.Low },
      { this->P.High, this->Q.High, this->Depths.High } });
  return part;
}

void vtkShadowLitmap::Join()
{
  if (this->Parts.empty())
  {
    return;
  }
  const auto width = static_cast<std::size_t>(this->Resolution);
  vtkSMPTools::For(0, this->Resolution, RowsPerThread,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (const vtkShadowLitmap& part : this->Parts)
      {
        for (std::size_t k = begin * width; k < end * width; ++k)
        {
          this->Lexels[k].Merge(part.Lexels[k]);
        }
      }
    });
  for (const vtkShadowLitmap& part : this->Parts)
  {
    this->Low = glm::min(this->Low, part.Low);
    this->High = glm::max(this->High, part.High);
    this->NumberOfReceivers += part.NumberOfReceivers;
    this->Everywhere.Merge(part.Everywhere);
    this->WidenAngle(part.WidestAngle);
  }
}

void vtkShadowLitmap::Build()
{
  if (!this->Everywhere.IsEmpty())
  {
    this->AddToLexels(0, this->Resolution - 1, 0, this->Resolution - 1, this->Everywhere);
    this->Low = glm::dvec2(-std::numeric_limits<double>::infinity());
    this->High = glm::dvec2(std::numeric_limits<double>::infinity());
  }
  this->NumberOfLevels =
    vtkNBufferMath::GetLevelForFourLookups(this->Resolution, this->Resolution) + 1;
  const std::size_t size = static_cast<std::size_t>(this->Resolution) * this->Resolution;
  if (this->Lexels.size() < size * this->NumberOfLevels)
  {
    this->Lexels.resize(size * this->NumberOfLevels);
  }
  vtkNBufferLevelBuilder::BuildLevels<MergeExtents>(this->Lexels.data(), this->Resolution,
    this->Resolution, 1, this->NumberOfLevels, LexelsWorthAThread);
}

const vtkShadowExtent* vtkShadowLitmap::GetLevelData(int level) const
{
  const std::size_t size = static_cast<std::size_t>(this->Resolution) * this->Resolution;
  return level >= 0 && level < this->NumberOfLevels ? this->Lexels.data() + level * size : nullptr;
}

vtkNBufferRectangle vtkShadowLitmap::GetLexels(double p0, double q0, double p1, double q1) const
{
  if (!(p0 <= p1 && q0 <= q1))
  {
    return { 0, 0, this->Resolution, this->Resolution };
  }
  const double guardP = 1.0 / this->P.CellsPerUnit;
  const double guardQ = 1.0 / this->Q.CellsPerUnit;
  if (p1 + guardP < this->Low[0] || p0 - guardP > this->High[0] || q1 + guardQ < this->Low[1] ||
    q0 - guardQ > this->High[1])
  {
    return {};
  }
  return { this->P.GetCell(p0 - guardP), this->Q.GetCell(q0 - guardQ),
    this->P.GetCell(p1 + guardP) + 1, this->Q.GetCell(q1 + guardQ) + 1 };
}

vtkShadowExtent vtkShadowLitmap::Query(double p0, double q0, double p1, double q1) const
{
  const vtkNBufferRectangle lexels = this->GetLexels(p0, q0, p1, q1);
  if (this->NumberOfLevels == 0 || lexels.IsEmpty())
  {
    return {};
  }
  return vtkNBufferMath::MergeCover(this->Lexels.data(), this->Resolution, this->Resolution,
    vtkNBufferMath::GetCoverOfFour(lexels), MergeExtents());
}

std::vector<vtkShadowSlab> vtkShadowLitmap::GetSlabs(const vtkShadowExtent& extent, int gap) const
{
  const auto isSet = [&extent](int bin) { return (extent.Bins >> bin & 1) != 0; };
  // Ten times the rounding error of a depth's bin and of the edges that are computed here.
  const double rounding = 0x1p-48 * (std::abs(this->Depths.Low) + std::abs(this->Depths.High));
  std::vector<vtkShadowSlab> slabs;
  int bin = 0;
  while (bin < NumberOfBins)
  {
    const int first = bin++;
    if (!isSet(first))
    {
      continue;
    }
    int last = first;
    for (; bin < NumberOfBins && bin - last <= std::max(gap, 1); ++bin)
    {
      last = isSet(bin) ? bin : last;
    }
    slabs.push_back({ extent.Near, extent.Far });
    if (first > 0)
    {
      slabs.back().Near = std::max(extent.Near, this->Depths.GetEdge(first) - rounding);
    }
    if (last < NumberOfBins - 1)
    {
      slabs.back().Far = std::min(extent.Far, this->Depths.GetEdge(last + 1) + rounding);
    }
  }
  return slabs;
}
VTK_ABI_NAMESPACE_END
