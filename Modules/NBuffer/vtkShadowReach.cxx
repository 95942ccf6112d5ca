// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReach.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Of the terms of a plane's equation: what rounding may do to them, generously.
constexpr double Rounding = 1e-9;

/// Of triangles in one plane, as far as doubles can tell: far below what Rounding is for.
bool IsSame(const std::array<double, 4>& plane, const std::array<double, 4>& other, double distance)
{
  constexpr double tolerance = 1e-14;
  return std::abs(plane[0] - other[0]) + std::abs(plane[1] - other[1]) +
      std::abs(plane[2] - other[2]) <=
    tolerance &&
    std::abs(plane[3] - other[3]) <= tolerance * distance;
}
}

vtkShadowReach::vtkShadowReach(const vtkShadowSilhouette& silhouette, const double* points,
  const vtkShadowFrame& frame, const vtkShadowBlock& rays)
  : Positional(frame.IsPositional())
  , Rays(rays)
{
  const std::vector<int>& corners = silhouette.GetTriangles();
  for (std::size_t t = 0; t < corners.size() && this->Planes.size() <= MaximumPlanes; t += 3)
  {
    const double* a = points + 3 * std::size_t(corners[t]);
    double sides[2][3];
    for (int i = 0; i < 2; ++i)
    {
      vtkMath::Subtract(points + 3 * std::size_t(corners[t + 1 + i]), a, sides[i]);
    }
    // Corners go round anticlockwise as seen from the light: this points away from it.
    double normal[3];
    vtkMath::Cross(sides[1], sides[0], normal);
    vtkMath::Normalize(normal);
    double relative[3];
    vtkMath::Subtract(a, frame.GetApex(), relative);
    const Plane plane = { vtkMath::Dot(normal, frame.GetU()), vtkMath::Dot(normal, frame.GetV()),
      vtkMath::Dot(normal, frame.GetAxis()), vtkMath::Dot(normal, relative) };
    if (this->Planes.empty() || !IsSame(plane, this->Planes.back(), vtkMath::Norm(relative)))
    {
      this->Planes.push_back(plane);
    }
  }
  this->UsePlanes = this->Planes.size() <= MaximumPlanes;
}

bool vtkShadowReach::IsBefore(const vtkShadowBlock& block, const Plane& plane) const
{
  const double* low = block.Low;
  const double* high = block.High;
  const auto getLargest = [](double factor, double x0, double x1)
  { return factor > 0.0 ? factor * x1 : factor * x0; };
  const auto getTerm = [](double factor, double x0, double x1)
  { return std::abs(factor) * std::max(std::abs(x0), std::abs(x1)); };
  double largest = getLargest(plane[0], low[0], high[0]) + getLargest(plane[1], low[1], high[1]);
  double terms = getTerm(plane[0], low[0], high[0]) + getTerm(plane[1], low[1], high[1]);
  if (this->Positional)
  {
    largest = getLargest(largest + plane[2], low[2], high[2]);
    terms = getTerm(terms + std::abs(plane[2]), low[2], high[2]);
  }
  else
  {
    largest += getLargest(plane[2], low[2], high[2]);
    terms += getTerm(plane[2], low[2], high[2]);
  }
  // False for what is not finite.
  return largest - plane[3] < -Rounding * (terms + std::abs(plane[3]));
}

bool vtkShadowReach::MeetsRays(const vtkShadowBlock& block) const
{
  for (int i = 0; i < 2; ++i)
  {
    if (block.High[i] < this->Rays.Low[i] || block.Low[i] > this->Rays.High[i])
    {
      return false;
    }
  }
  return !block.IsEmpty();
}

bool vtkShadowReach::MayShadow(const vtkShadowBlock& block) const
{
  return this->MeetsRays(block) && block.High[2] >= this->Rays.Low[2] &&
    block.Low[2] <= this->Rays.High[2] &&
    !(this->UsePlanes &&
      std::all_of(this->Planes.begin(), this->Planes.end(),
        [&](const Plane& plane) { return this->IsBefore(block, plane); }));
}
VTK_ABI_NAMESPACE_END
