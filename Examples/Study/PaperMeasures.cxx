// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PaperMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace NBufferStudy
{

long long CountOutlinePixels(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen)
{
  const vtkNBufferRectangle& pixels = screen.Pixels;
  if (screen.Clipped)
  {
    return static_cast<long long>(pixels.GetWidth()) * pixels.GetHeight();
  }
  const std::array<glm::dvec2, 8> corners = projection.GetCorners(box);
  long long count = 0;
  for (int y = pixels.Y0; y < pixels.Y1; ++y)
  {
    // A row of a convex outline is what the segments between its corners reach.
    const double center = y + 0.5;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int a = 0; a < 8; ++a)
    {
      for (int b = a + 1; b < 8; ++b)
      {
        const double y0 = corners[a].y;
        const double y1 = corners[b].y;
        if ((y0 <= center) != (y1 <= center))
        {
          const double t = (center - y0) / (y1 - y0);
          const double x = corners[a].x + t * (corners[b].x - corners[a].x);
          low = std::min(low, x);
          high = std::max(high, x);
        }
      }
    }
    if (low <= high)
    {
      const double first = std::max(std::ceil(low - 0.5), static_cast<double>(pixels.X0));
      const double end = std::min(std::floor(high - 0.5) + 1.0, static_cast<double>(pixels.X1));
      count += end > first ? static_cast<long long>(end - first) : 0;
    }
  }
  return count;
}

double OverCoverage::GetMean() const
{
  return std::accumulate(this->Shares.begin(), this->Shares.end(), 0.0) /
    static_cast<double>(std::max<std::size_t>(this->Shares.size(), 1));
}

double OverCoverage::GetShareOfArea() const
{
  double extra = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < this->Shares.size(); ++i)
  {
    const auto side = static_cast<std::size_t>(this->Size);
    const double pixels = static_cast<double>((i % side + 1) * (i / side + 1));
    extra += pixels * this->Shares[i];
    area += pixels;
  }
  return extra / area;
}

double OverCoverage::GetQuantile(double share) const
{
  std::vector<double> sorted = this->Shares;
  const auto place =
    sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

OverCoverage MeasureOverCoverage(const DepthFamily& family, int size, int places)
{
  // Room on all sides, so that the border cuts nothing off what is covered.
  const int room = 1 << vtkNBufferMath::CeilLog2(4 * size);
  DepthStructure structure(family);
  structure.SetSize(4 * room, 4 * room);
  std::mt19937 random(1);
  const auto place = [&random, room]() { return static_cast<int>(random() % room) + room; };
  OverCoverage result;
  result.Size = size;
  for (int height = 1; height <= size; ++height)
  {
    for (int width = 1; width <= size; ++width)
    {
      double covered = 0.0;
      for (int i = 0; i < places; ++i)
      {
        vtkNBufferRectangle r;
        r.X0 = place();
        r.Y0 = place();
        r.X1 = r.X0 + width;
        r.Y1 = r.Y0 + height;
        const vtkNBufferRectangle all = structure.GetCovered(r);
        covered += static_cast<double>(all.GetWidth()) * all.GetHeight();
      }
      result.Shares.push_back(covered / places / width / height - 1.0);
    }
  }
  return result;
}

StaleTexels::StaleTexels(const vtkNBufferLevels& before, const vtkNBufferLevels& after)
{
  const int width = after.GetWidth();
  const int height = after.GetHeight();
  const float* a = before.GetLevelData(0);
  const float* b = after.GetLevelData(0);
  // An N-buffer of a mask: the square of a texel has a changed one if its maximum is 1.
  std::vector<float> mask(static_cast<std::size_t>(width) * height);
  int reach[4] = { width, height, 0, 0 };
  for (int i = 0; i < width * height; ++i)
  {
    const bool isChanged = a[i] != b[i];
    mask[static_cast<std::size_t>(i)] = isChanged ? 1.0f : 0.0f;
    if (isChanged)
    {
      ++this->Base;
      reach[0] = std::min(reach[0], i % width);
      reach[1] = std::min(reach[1], i / width);
      reach[2] = std::max(reach[2], i % width + 1);
      reach[3] = std::max(reach[3], i / width + 1);
    }
  }
  this->Changed = { reach[0], reach[1], reach[2], reach[3] };
  vtkNBufferLevels stale;
  stale.BuildBase(mask.data(), width, height, 1, vtkNBufferExtremum::Maximum);
  stale.BuildLevels(after.GetNumberOfLevels());
  for (int level = 1; level < stale.GetNumberOfLevels(); ++level)
  {
    const float* first = stale.GetLevelData(level);
    this->Stale += std::count(first, first + mask.size(), 1.0f);
  }
}

long long StaleTexels::Rebuild(vtkNBufferLevels& levels) const
{
  long long built = 0;
  const int width = levels.GetWidth();
  const int lastRow = levels.GetHeight() - 1;
  for (int level = 1; level < levels.GetNumberOfLevels(); ++level)
  {
    const int side = 1 << level;
    const int step = side / 2;
    const int begin = std::max(this->Changed.X0 - side + 1, 0);
    // What lies to the right has other neighbours, unless the border replaces them.
    const int inside = std::clamp(width - step, begin, std::max(this->Changed.X1, begin));
    for (int y = std::max(this->Changed.Y0 - side + 1, 0); y < this->Changed.Y1; ++y)
    {
      const float* a = levels.GetLevelData(level - 1) + static_cast<std::size_t>(y) * width;
      const float* b = levels.GetLevelData(level - 1) +
        static_cast<std::size_t>(std::min(y + step, lastRow)) * width;
      float* out = levels.GetLevelData(level) + static_cast<std::size_t>(y) * width;
      const auto merge = [](float p, float q) { return p > q ? p : q; };
      for (int x = begin; x < inside; ++x)
      {
        out[x] = merge(merge(a[x], a[x + step]), merge(b[x], b[x + step]));
      }
      for (int x = inside; x < this->Changed.X1; ++x)
      {
        out[x] = merge(merge(a[x], b[x]), merge(a[width - 1], b[width - 1]));
      }
      built += std::max(this->Changed.X1 - begin, 0);
    }
  }
  return built;
}

} // namespace NBufferStudy
