// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowUmbra.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A generous bound of the rounding error of a plane's equation, relative to the sum of the
/// magnitudes of its terms.
constexpr double Rounding = 1e-9;

/// Returns true if two planes are equal up to the rounding of doubles. `distance` is the distance
/// of a point in the plane from the apex. The tolerance is far smaller than Rounding.
bool IsSame(const glm::dvec4& plane, const glm::dvec4& other, double distance)
{
  constexpr double tolerance = 1e-14;
  return std::abs(plane[0] - other[0]) + std::abs(plane[1] - other[1]) +
      std::abs(plane[2] - other[2]) <=
    tolerance &&
    std::abs(plane[3] - other[3]) <= tolerance * distance;
}

/// The plane of a triangle whose corners go round anticlockwise as seen from the light.
glm::dvec4 GetPlane(
  const int* corners, const vtkShadowPoints& points, const vtkShadowLightSpace& space)
{
  const glm::dvec3& a = points[corners[0]];
  // The normal points away from the light.
  const glm::dvec3 normal =
    vtkNBufferGLM::Normalize(glm::cross(points[corners[2]] - a, points[corners[1]] - a));
  return { glm::dot(normal, space.GetU()), glm::dot(normal, space.GetV()),
    glm::dot(normal, space.GetAxis()), glm::dot(normal, a - space.GetApex()) };
}

/// The side from a to b of triangle (a, b, c) in p and q (vtkShadowUmbra::Facet::Sides). It is all
/// zero if c is so close to the line through a and b that rounding may move it across.
glm::dvec3 GetSide(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const glm::dvec2 normal = { b[1] - a[1], a[0] - b[0] };
  const double size = std::abs(a[0]) + std::abs(a[1]) + std::abs(c[0]) + std::abs(c[1]);
  const double length = std::hypot(normal[0], normal[1]);
  const double inside = glm::dot(normal, c - a);
  if (!(std::abs(inside) > Rounding * length * size))
  {
    return glm::dvec3(0.0);
  }
  const double scale = (inside > 0.0 ? -1.0 : 1.0) / length;
  const glm::dvec2 outwards = normal * scale;
  return { outwards[0], outwards[1], glm::dot(outwards, a) };
}

/// The part of a block that lies on the rays of another one, at any depth.
vtkShadowBlock GetCommon(const vtkShadowBlock& block, const vtkShadowBlock& rays)
{
  return { glm::max(block.Low, glm::dvec3(glm::dvec2(rays.Low), block.Low[2])),
    glm::min(block.High, glm::dvec3(glm::dvec2(rays.High), block.High[2])) };
}

bool Overlap(const vtkShadowBlock& block, const vtkShadowBlock& rays)
{
  return !(block.High[0] < rays.Low[0] || block.High[1] < rays.Low[1] ||
    block.Low[0] > rays.High[0] || block.Low[1] > rays.High[1]);
}
}

vtkShadowUmbra::vtkShadowUmbra(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points,
  const vtkShadowLightSpace& space, const vtkShadowBlock& rays)
  : Positional(space.IsPositional())
  , Rays(rays)
{
  const std::vector<int>& corners = silhouette.GetTriangles();
  if (corners.size() <= 3 * MaximumFacets && std::isfinite(rays.Low[0]))
  {
    this->Facets.reserve(corners.size() / 3);
    for (std::size_t t = 0; t < corners.size(); t += 3)
    {
      Facet facet = { GetPlane(corners.data() + t, points, space), {}, {} };
      glm::dvec3 pqs[3];
      for (std::size_t i = 0; i < 3; ++i)
      {
        pqs[i] = space.ToLight(points[corners[t + i]]);
        facet.Rays.Add(pqs[i]);
      }
      for (std::size_t i = 0; i < 3; ++i)
      {
        facet.Sides[i] = GetSide(pqs[i], pqs[(i + 1) % 3], pqs[(i + 2) % 3]);
      }
      this->Facets.push_back(facet);
    }
    return;
  }
  for (std::size_t t = 0; t < corners.size() && this->Planes.size() <= MaximumFacets; t += 3)
  {
    const Plane plane = GetPlane(corners.data() + t, points, space);
    const double distance = glm::length(points[corners[t]] - space.GetApex());
    if (this->Planes.empty() || !IsSame(plane, this->Planes.back(), distance))
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
  const glm::dvec3& low = block.Low;
  const glm::dvec3& high = block.High;
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
  // This is false if any value is not finite.
  return largest - plane[3] < -Rounding * (terms + std::abs(plane[3]));
}

bool vtkShadowUmbra::Meets(const vtkShadowBlock& block, const Facet& facet)
{
  return Overlap(block, facet.Rays) &&
    std::all_of(facet.Sides.begin(), facet.Sides.end(),
      [&block](const glm::dvec3& side)
      {
        double least = 0.0;
        double terms = std::abs(side[2]);
        for (int i = 0; i < 2; ++i)
        {
          const double factor = side[i];
          // A factor of 0 has a case of its own, because 0 times infinity is NaN.
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
