// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OverCoverage.h"

#include "DepthStructure.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace NBufferStudy
{

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
  int room = 1;
  while (room < 4 * size)
  {
    room *= 2;
  }
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
