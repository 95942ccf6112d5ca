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

} // namespace NBufferStudy
