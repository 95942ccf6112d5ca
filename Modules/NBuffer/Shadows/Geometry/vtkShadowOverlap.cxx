// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowOverlap.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
bool IsFinite(const vtkShadowOverlap::Item& item)
{
  const vtkShadowBlock& rays = item.Rays;
  return std::isfinite(rays.Low[0] + rays.Low[1] + rays.High[0] + rays.High[1]);
}
}

long long vtkShadowOverlap::GetBound(const std::vector<Item>& items)
{
  vtkShadowBlock all;
  std::size_t finite = 0;
  long long anywhere = 0;
  for (const Item& item : items)
  {
    if (IsFinite(item))
    {
      all.Add(item.Rays.Low, item.Rays.High);
      ++finite;
    }
    else
    {
      anywhere += item.Weight;
    }
  }
  if (finite == 0)
  {
    return anywhere;
  }
  const int size =
    std::clamp(static_cast<int>(2.0 * std::sqrt(static_cast<double>(finite))), 1, 1024);
  const std::size_t row = static_cast<std::size_t>(size) + 1;
  const auto getCell = [&](double value, int i)
  {
    const double width = (all.High[i] - all.Low[i]) / size;
    return width > 0.0 && std::isfinite(width)
      ? static_cast<std::size_t>(std::clamp((value - all.Low[i]) / width, 0.0, size - 1.0))
      : 0;
  };
  // Each item changes only four cells, at the corners of its rectangle. The sums over rows and
  // columns below then add its weight to every cell of the rectangle.
  std::vector<long long> grid(row * row, 0);
  for (const Item& item : items)
  {
    if (!IsFinite(item))
    {
      continue;
    }
    std::size_t low[2];
    std::size_t end[2];
    for (int i = 0; i < 2; ++i)
    {
      const double margin = 1e-6 * (all.High[i] - all.Low[i]); // far above the rounding of p and q
      low[i] = getCell(item.Rays.Low[i] - margin, i);
      end[i] = getCell(item.Rays.High[i] + margin, i) + 1;
    }
    grid[low[1] * row + low[0]] += item.Weight;
    grid[low[1] * row + end[0]] -= item.Weight;
    grid[end[1] * row + low[0]] -= item.Weight;
    grid[end[1] * row + end[0]] += item.Weight;
  }
  for (std::size_t i = 1; i < grid.size(); ++i)
  {
    grid[i] += i % row > 0 ? grid[i - 1] : 0;
  }
  for (std::size_t i = row; i < grid.size(); ++i)
  {
    grid[i] += grid[i - row];
  }
  return anywhere + *std::max_element(grid.begin(), grid.end());
}
VTK_ABI_NAMESPACE_END
