// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLitmapSet.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// What rounding may do to a footprint, in units of the caster's own size, generously.
constexpr double Margin = 1e-6;

constexpr double Infinity = std::numeric_limits<double>::infinity();
}

vtkShadowLitmapSet::vtkShadowLitmapSet(
  const vtkShadowLight& light, const vtkShadowLightSpace& space, const vtkShadowLitmap* litmap)
  : Light(light)
  , Whole{ &space, litmap }
{
}

void vtkShadowLitmapSet::AddFace(const vtkShadowLightSpace& space, const vtkShadowLitmap& litmap)
{
  this->Faces.push_back({ &space, &litmap });
}

/// The face where all of a caster's rays are. It is null if they are in no one face, or if the
/// caster reaches through the light's plane.
const vtkShadowLitmapSet::Face* vtkShadowLitmapSet::FindContainingFace(
  const vtkShadowFootprint& footprint) const
{
  if (this->Faces.empty())
  {
    return this->IsThroughLightPlane(footprint) ? nullptr : &this->Whole;
  }
  const std::array<glm::dvec3, 8> corners = footprint.GetCorners();
  const auto found = std::find_if(this->Faces.begin(), this->Faces.end(),
    [&corners](const Face& face)
    {
      const vtkShadowBlock box = vtkShadowFootprint::Make(corners, *face.Space).Block;
      return box.Low[2] > Margin * box.High[2] && std::min(box.Low[0], box.Low[1]) > -1.0 &&
        std::max(box.High[0], box.High[1]) < 1.0;
    });
  return found == this->Faces.end() ? nullptr : &*found;
}

vtkShadowLitmapSet::FaceQuery vtkShadowLitmapSet::MakeFaceQuery(
  const Face& face, const vtkShadowFootprint& footprint) const
{
  vtkShadowBlock rays = footprint.Block;
  if (this->IsThroughLightPlane(footprint))
  {
    rays.Low = glm::dvec3(-Infinity);
    rays.High = glm::dvec3(Infinity);
  }
  rays.High[2] = Infinity;
  return { face, rays };
}

void vtkShadowLitmapSet::AddFaces(const vtkShadowFootprint& footprint, Lookup& lookup) const
{
  const std::array<glm::dvec3, 8> corners = footprint.GetCorners();
  for (const Face& face : this->Faces)
  {
    const vtkShadowFootprint box = vtkShadowFootprint::Make(corners, *face.Space);
    if (box.GetFar() > 0.0)
    {
      lookup.Add(this->MakeFaceQuery(face, box));
    }
  }
}

vtkShadowLitmapSet::Lookup vtkShadowLitmapSet::LookUp(
  const vtkShadowFootprint& footprint, vtkShadowPoints points) const
{
  Lookup lookup;
  const Face* face = this->FindContainingFace(footprint);
  lookup.IsInOneFace = face != nullptr;
  if (face)
  {
    const vtkShadowFootprint inFace =
      this->Faces.empty() ? footprint : vtkShadowFootprint::Make(points, *face->Space);
    lookup.Near = inFace.GetNear();
    lookup.Far = inFace.GetFar();
    lookup.Add(this->MakeFaceQuery(*face, inFace));
  }
  else if (this->Faces.empty())
  {
    lookup.Add(this->MakeFaceQuery(this->Whole, footprint));
  }
  else
  {
    this->AddFaces(footprint, lookup);
  }
  for (const FaceQuery& query : lookup)
  {
    const vtkShadowBlock& rays = query.Rays;
    lookup.Extent.Merge(
      query.Map.Litmap->Query(rays.Low[0], rays.Low[1], rays.High[0], rays.High[1]));
  }
  return lookup;
}

bool vtkShadowLitmapSet::IsThroughLightPlane(const vtkShadowFootprint& footprint) const
{
  const double margin = Margin * std::abs(footprint.GetFar());
  return this->Light.IsPositional() && !(footprint.GetNear() > margin);
}

double vtkShadowLitmapSet::GetWidestAngle() const
{
  constexpr double margin = 1e-3; // radians; more than vtkShadowLight::IsInCone() is wider
  const double cone = vtkMath::RadiansFromDegrees(this->Light.ConeAngle) + margin;
  return this->Whole.Litmap ? std::max(cone, this->Whole.Litmap->GetWidestAngle()) : cone;
}

bool vtkShadowLitmapSet::IsBehindSpot(const vtkShadowFootprint& footprint) const
{
  return this->Light.Kind == vtkShadowLightKind::Spot && footprint.GetFar() <= 0.0 &&
    this->GetWidestAngle() < 0.5 * vtkMath::Pi();
}

bool vtkShadowLitmapSet::IsOutsideCone(const vtkShadowFootprint& footprint) const
{
  if (this->Light.Kind != vtkShadowLightKind::Spot)
  {
    return false;
  }
  const vtkShadowBlock& bounds = footprint.Bounds;
  const glm::dvec3 toCenter = 0.5 * (bounds.Low + bounds.High) - this->Light.Position;
  const double distance = glm::length(toCenter);
  const glm::dvec3 size = bounds.High - bounds.Low;
  const double radius =
    std::sqrt(0.25 * size[0] * size[0] + 0.25 * size[1] * size[1] + 0.25 * size[2] * size[2]);
  if (!(distance > radius))
  {
    return false;
  }
  const double angle =
    std::acos(std::clamp(glm::dot(toCenter, this->Light.Direction) / distance, -1.0, 1.0));
  return angle - std::asin(radius / distance) > this->GetWidestAngle();
}
VTK_ABI_NAMESPACE_END
