// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowUmbra.h"

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

/// Of a triangle that goes round anticlockwise as seen from the light.
std::array<double, 4> GetPlane(
  const int* corners, const double* points, const vtkShadowLightSpace& frame)
{
  const double* a = points + 3 * std::size_t(corners[0]);
  double sides[2][3];
  for (int i = 0; i < 2; ++i)
  {
    vtkMath::Subtract(points + 3 * std::size_t(corners[1 + i]), a, sides[i]);
  }
  double normal[3]; // away from the light
  vtkMath::Cross(sides[1], sides[0], normal);
  vtkMath::Normalize(normal);
  double relative[3];
  vtkMath::Subtract(a, frame.GetApex(), relative);
  return { vtkMath::Dot(normal, frame.GetU()), vtkMath::Dot(normal, frame.GetV()),
    vtkMath::Dot(normal, frame.GetAxis()), vtkMath::Dot(normal, relative) };
}

/// The side from a to b of a triangle in p and q, whose third corner is c. Nothing where that is
/// too close to the side's line to tell on which side of it the triangle lies.
std::array<double, 3> GetSide(const double a[2], const double b[2], const double c[2])
{
  double normal[2] = { b[1] - a[1], a[0] - b[0] };
  const double size = std::abs(a[0]) + std::abs(a[1]) + std::abs(c[0]) + std::abs(c[1]);
  const double length = std::hypot(normal[0], normal[1]);
  const double inside = normal[0] * (c[0] - a[0]) + normal[1] * (c[1] - a[1]);
  if (!(std::abs(inside) > Rounding * length * size))
  {
    return { 0.0, 0.0, 0.0 };
  }
  const double scale = (inside > 0.0 ? -1.0 : 1.0) / length;
  normal[0] *= scale;
  normal[1] *= scale;
  return { normal[0], normal[1], normal[0] * a[0] + normal[1] * a[1] };
}

/// What a block has of these rays.
vtkShadowBlock GetCommon(const vtkShadowBlock& block, const vtkShadowBlock& rays)
{
  vtkShadowBlock common = block;
  for (int i = 0; i < 2; ++i)
  {
    common.Low[i] = std::max(block.Low[i], rays.Low[i]);
    common.High[i] = std::min(block.High[i], rays.High[i]);
  }
  return common;
}

bool Overlap(const vtkShadowBlock& block, const vtkShadowBlock& rays)
{
  for (int i = 0; i < 2; ++i)
  {
    if (block.High[i] < rays.Low[i] || block.Low[i] > rays.High[i])
    {
      return false;
    }
  }
  return true;
}
}

vtkShadowUmbra::vtkShadowUmbra(const vtkShadowSilhouette& silhouette, const double* points,
  const vtkShadowLightSpace& frame, const vtkShadowBlock& rays)
  : Positional(frame.IsPositional())
  , Rays(rays)
{
  const std::vector<int>& corners = silhouette.GetTriangles();
  if (corners.size() <= 3 * MaximumFacets && std::isfinite(rays.Low[0]))
  {
    this->AddFacets(corners, points, frame);
  }
  else
  {
    this->AddPlanes(corners, points, frame);
  }
}

void vtkShadowUmbra::AddFacets(
  const std::vector<int>& corners, const double* points, const vtkShadowLightSpace& frame)
{
  this->Facets.reserve(corners.size() / 3);
  for (std::size_t t = 0; t < corners.size(); t += 3)
  {
    Facet facet = { GetPlane(corners.data() + t, points, frame), {}, {} };
    double pqs[3][3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      frame.ToLight(points + 3 * std::size_t(corners[t + i]), pqs[i]);
      for (int k = 0; k < 3; ++k)
      {
        facet.Rays.Add(k, pqs[i][k], pqs[i][k]);
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      facet.Sides[i] = GetSide(pqs[i], pqs[(i + 1) % 3], pqs[(i + 2) % 3]);
    }
    this->Facets.push_back(facet);
  }
}

void vtkShadowUmbra::AddPlanes(
  const std::vector<int>& corners, const double* points, const vtkShadowLightSpace& frame)
{
  for (std::size_t t = 0; t < corners.size() && this->Planes.size() <= MaximumFacets; t += 3)
  {
    const Plane plane = GetPlane(corners.data() + t, points, frame);
    double relative[3];
    vtkMath::Subtract(points + 3 * std::size_t(corners[t]), frame.GetApex(), relative);
    if (this->Planes.empty() || !IsSame(plane, this->Planes.back(), vtkMath::Norm(relative)))
    {
      this->Planes.push_back(plane);
    }
  }
  if (this->Planes.size() > MaximumFacets)
  {
    this->Planes.clear();
  }
}

bool vtkShadowUmbra::IsBefore(const vtkShadowBlock& block, const Plane& plane) const
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

bool vtkShadowUmbra::Meets(const vtkShadowBlock& block, const Facet& facet)
{
  return Overlap(block, facet.Rays) &&
    std::all_of(facet.Sides.begin(), facet.Sides.end(),
      [&block](const std::array<double, 3>& side)
      {
        double least = 0.0;
        double terms = std::abs(side[2]);
        for (int i = 0; i < 2; ++i)
        {
          const double factor = side[static_cast<std::size_t>(i)];
          // Not 0 times infinity.
          least += factor > 0.0 ? factor * block.Low[i]
            : factor < 0.0      ? factor * block.High[i]
                                : 0.0;
          terms += std::abs(factor) * std::max(std::abs(block.Low[i]), std::abs(block.High[i]));
        }
        return !(least - side[2] > Rounding * terms);
      });
}

bool vtkShadowUmbra::MeetsRays(const vtkShadowBlock& block) const
{
  return !block.IsEmpty() && Overlap(block, this->Rays) &&
    (this->Facets.empty() ||
      std::any_of(this->Facets.begin(), this->Facets.end(),
        [&block](const Facet& facet) { return Meets(block, facet); }));
}

bool vtkShadowUmbra::MayShadow(const vtkShadowBlock& block) const
{
  if (block.IsEmpty() || !Overlap(block, this->Rays) || block.High[2] < this->Rays.Low[2] ||
    block.Low[2] > this->Rays.High[2])
  {
    return false;
  }
  if (!this->Facets.empty())
  {
    return std::any_of(this->Facets.begin(), this->Facets.end(),
      [&](const Facet& facet)
      {
        return block.High[2] >= facet.Rays.Low[2] && Meets(block, facet) &&
          !this->IsBefore(GetCommon(block, facet.Rays), facet.Beyond);
      });
  }
  return this->Planes.empty() ||
    std::any_of(this->Planes.begin(), this->Planes.end(),
      [&](const Plane& plane) { return !this->IsBefore(block, plane); });
}
VTK_ABI_NAMESPACE_END
