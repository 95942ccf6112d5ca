// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLitmapSet.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::array<glm::dvec3, 8> GetCorners(const vtkShadowBlock& box)
{
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = { (i & 1 ? box.High : box.Low)[0], (i & 2 ? box.High : box.Low)[1],
      (i & 4 ? box.High : box.Low)[2] };
  }
  return corners;
}
}

vtkShadowLitmapSet::vtkShadowLitmapSet(const vtkShadowLight& light, std::vector<Face> faces)
  : Light(light)
  , Faces(std::move(faces))
{
}

vtkShadowLitmapSet::Lookup vtkShadowLitmapSet::LookUp(
  const vtkShadowFootprint& footprint, const vtkShadowPoints* points) const
{
  Lookup lookup;
  const auto query = [&](const Face& face, vtkShadowBlock rays)
  {
    if (this->IsThroughLightPlane(rays))
    {
      rays.Low = glm::dvec3(-Infinity);
      rays.High = glm::dvec3(Infinity);
    }
    rays.High[2] = Infinity;
    lookup.Extent.Merge(face.Litmap->Query(rays.Low[0], rays.Low[1], rays.High[0], rays.High[1]));
    if (points)
    {
      lookup.Queries.push_back({ face, rays });
    }
  };
  const auto queryAlone = [&](const Face& face, const vtkShadowBlock& block)
  {
    lookup.IsInOneFace = true;
    lookup.Near = block.Low[2];
    lookup.Far = block.High[2];
    query(face, block);
  };
  if (!this->HasFaces())
  {
    queryAlone(this->Faces[0], footprint.Block);
    lookup.IsInOneFace = !this->IsThroughLightPlane(footprint.Block);
    return lookup;
  }
  const std::array<glm::dvec3, 8> corners = GetCorners(footprint.Bounds);
  std::vector<vtkShadowBlock> boxes;
  boxes.reserve(this->Faces.size());
  for (const Face& face : this->Faces)
  {
    const vtkShadowBlock box = vtkShadowFootprint::Make(corners, *face.Space).Block;
    if (box.Low[2] > Margin * box.High[2] && std::min(box.Low[0], box.Low[1]) > -1.0 &&
      std::max(box.High[0], box.High[1]) < 1.0)
    {
      queryAlone(face, points ? vtkShadowFootprint::Make(*points, *face.Space).Block : box);
      return lookup;
    }
    boxes.push_back(box);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (boxes[i].High[2] > 0.0)
    {
      query(this->Faces[i], boxes[i]);
    }
  }
  return lookup;
}

double vtkShadowLitmapSet::GetWidestAngle() const
{
  constexpr double margin = 1e-3; // radians; more than in vtkShadowLight::GetConeCosine()
  const double cone = vtkMath::RadiansFromDegrees(this->Light.ConeAngle) + margin;
  return this->IsKnown() ? std::max(cone, this->Faces[0].Litmap->GetWidestAngle()) : cone;
}

vtkShadowLitmapSet::Nearest vtkShadowLitmapSet::GetNearest(
  const vtkShadowFootprint& footprint) const
{
  const vtkShadowBlock& bounds = footprint.Bounds;
  const glm::dvec3 toCenter = 0.5 * (bounds.Low + bounds.High) - this->Light.Position;
  const double distance = glm::length(toCenter);
  const double radius = 0.5 * glm::length(bounds.High - bounds.Low);
  if (!(distance > radius))
  {
    return {};
  }
  const double angle =
    std::acos(std::clamp(glm::dot(toCenter, this->Light.Direction) / distance, -1.0, 1.0));
  return { angle - std::asin(radius / distance), distance - radius };
}

bool vtkShadowLitmapSet::IsOutsideCone(const vtkShadowFootprint& footprint) const
{
  return this->Light.Kind == vtkShadowLightKind::Spot &&
    this->GetNearest(footprint).Angle > this->GetWidestAngle();
}

bool vtkShadowLitmapSet::IsBeyondReach(
  const vtkShadowFootprint& footprint, const vtkShadowConeReach& reach) const
{
  if (this->Light.Kind != vtkShadowLightKind::Spot || std::isinf(reach.A0))
  {
    return false;
  }
  const Nearest nearest = this->GetNearest(footprint);
  return reach.Excludes(nearest.Distance, nearest.Angle - this->GetWidestAngle());
}
VTK_ABI_NAMESPACE_END
