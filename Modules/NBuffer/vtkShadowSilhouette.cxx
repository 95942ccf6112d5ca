// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSilhouette.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// For each component of a closed mesh whether it is wound inside out: its signed volume is
/// negative. Relative to a corner of the component, where most digits are left.
std::vector<bool> FindInsideOut(const vtkShadowTopology& topology, const double* points)
{
  const std::size_t count = static_cast<std::size_t>(topology.GetNumberOfComponents());
  std::vector<const double*> origins(count, nullptr);
  std::vector<double> volumes(count, 0.0);
  const int* corners = topology.GetTriangles().data();
  for (const int component : topology.GetComponents())
  {
    const double*& origin = origins[component];
    if (!origin)
    {
      origin = points + 3 * corners[0];
    }
    double relative[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(points + 3 * corners[i], origin, relative[i]);
    }
    volumes[component] += vtkMath::Determinant3x3(relative[0], relative[1], relative[2]);
    corners += 3;
  }
  std::vector<bool> insideOut(count);
  std::transform(
    volumes.begin(), volumes.end(), insideOut.begin(), [](double volume) { return volume < 0.0; });
  return insideOut;
}

/// A rectangle in light coordinates (p, q).
struct Rectangle
{
  double Low[2] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  double High[2] = { -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };

  void Add(const double pq[2])
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Low[i] = std::min(this->Low[i], pq[i]);
      this->High[i] = std::max(this->High[i], pq[i]);
    }
  }
};

/// The largest number of rectangles that touch one cell of a grid over all of them. Linear in their
/// number: a rectangle is entered into the differences between cells by its four corners.
int FindLargestOverlap(const std::vector<Rectangle>& rectangles, const Rectangle& all)
{
  // About four cells for each rectangle.
  const int size =
    std::clamp(static_cast<int>(2.0 * std::sqrt(static_cast<double>(rectangles.size()))), 1, 1024);
  const std::size_t row = static_cast<std::size_t>(size) + 1;
  const auto getCell = [&](double value, int i)
  {
    const double width = (all.High[i] - all.Low[i]) / size;
    return width > 0.0
      ? static_cast<std::size_t>(std::clamp((value - all.Low[i]) / width, 0.0, size - 1.0))
      : 0;
  };
  std::vector<int> grid(row * row, 0);
  for (const Rectangle& rectangle : rectangles)
  {
    std::size_t low[2];
    std::size_t end[2];
    for (int i = 0; i < 2; ++i)
    {
      const double margin = 1e-6 * (all.High[i] - all.Low[i]); // far above the rounding of p and q
      low[i] = getCell(rectangle.Low[i] - margin, i);
      end[i] = getCell(rectangle.High[i] + margin, i) + 1;
    }
    ++grid[low[1] * row + low[0]];
    --grid[low[1] * row + end[0]];
    --grid[end[1] * row + low[0]];
    ++grid[end[1] * row + end[0]];
  }
  for (std::size_t i = 1; i < grid.size(); ++i)
  {
    grid[i] += i % row > 0 ? grid[i - 1] : 0;
  }
  for (std::size_t i = row; i < grid.size(); ++i)
  {
    grid[i] += grid[i - row];
  }
  return *std::max_element(grid.begin(), grid.end());
}

/// Upper bound of how many of the triangles one ray of the light can meet: as many as have bounding
/// rectangles in light coordinates that overlap, where these exist, or else all.
int BoundOverlap(
  const std::vector<int>& triangles, const double* points, const vtkShadowLight& light)
{
  const int count = static_cast<int>(triangles.size() / 3);
  double axis[3] = { 0.0, 0.0, 0.0 }; // towards the middle, for positional lights
  for (const int corner : triangles)
  {
    double ray[3];
    vtkMath::Subtract(points + 3 * std::size_t(corner), light.Position, ray);
    vtkMath::Add(axis, ray, axis);
  }
  const vtkShadowFrame frame =
    light.IsPositional() ? vtkShadowFrame(light, axis) : vtkShadowFrame(light);
  Rectangle all;
  std::vector<Rectangle> rectangles(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    double pqs[3];
    frame.ToLight(points + 3 * std::size_t(triangles[i]), pqs);
    if (light.IsPositional() && !(pqs[2] > 0.0))
    {
      return count; // the caster is around the light
    }
    all.Add(pqs);
    rectangles[i / 3].Add(pqs);
  }
  const bool finite =
    std::isfinite(all.High[0] - all.Low[0]) && std::isfinite(all.High[1] - all.Low[1]);
  return finite ? FindLargestOverlap(rectangles, all) : count;
}
}

void vtkShadowSilhouette::Compute(const vtkShadowTopology& topology, const double* points,
  const vtkShadowLight& light, vtkShadowCounting counting)
{
  this->Counting = topology.IsClosed() ? counting : vtkShadowCounting::All;
  this->Triangles.clear();
  this->Edges.clear();
  const bool away = this->Counting == vtkShadowCounting::Away;
  const std::vector<bool> insideOut = away ? FindInsideOut(topology, points) : std::vector<bool>();

  // 1: counts as it is wound, -1: counts the other way round, 0: does not count.
  std::vector<signed char> signs(static_cast<std::size_t>(topology.GetNumberOfTriangles()), 0);
  const int* corners = topology.GetTriangles().data();
  for (std::size_t t = 0; t < signs.size(); ++t, corners += 3)
  {
    const int facing =
      light.GetFacing(points + 3 * corners[0], points + 3 * corners[1], points + 3 * corners[2]);
    if (facing == 0 || (away && (facing > 0) != insideOut[topology.GetComponents()[t]]))
    {
      continue;
    }
    signs[t] = static_cast<signed char>(facing);
    this->Triangles.push_back(corners[0]);
    this->Triangles.push_back(corners[facing > 0 ? 1 : 2]);
    this->Triangles.push_back(corners[facing > 0 ? 2 : 1]);
  }

  for (const vtkShadowTopology::Edge& edge : topology.GetEdges())
  {
    int left = 0;
    for (int u = edge.First; u < edge.First + edge.Count; ++u)
    {
      const vtkShadowTopology::Use& use = topology.GetUses()[u];
      left += use.Direction * signs[use.Triangle];
    }
    if (left > 0)
    {
      this->Edges.push_back({ edge.A, edge.B, left });
    }
    else if (left < 0)
    {
      this->Edges.push_back({ edge.B, edge.A, -left });
    }
  }

  const int count = static_cast<int>(this->Triangles.size() / 3);
  this->MaximumCount = topology.IsConvex() ? std::min(count, away ? 1 : 2)
                                           : BoundOverlap(this->Triangles, points, light);
}
VTK_ABI_NAMESPACE_END
