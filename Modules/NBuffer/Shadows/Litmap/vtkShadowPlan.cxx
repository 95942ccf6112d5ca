// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPlan.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Of a caster's own size: what rounding may do to its footprint, generously.
constexpr double Margin = 1e-6;

/// Infinite in both directions: all lexels.
constexpr double Everything = std::numeric_limits<double>::infinity();

/// Of View::BoxCost, for each triangle.
constexpr double TriangleShare = 1.0 / 32;

void GetCorners(const double bounds[6], double corners[24])
{
  for (int i = 0; i < 8; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners[3 * i + k] = bounds[2 * k + (i >> k & 1)];
    }
  }
}

/// How many of the triangles counted the ray from `origin` along `direction` crosses.
int CountCrossings(const vtkShadowSilhouette& silhouette, const double* points,
  const double origin[3], const double direction[3])
{
  int count = 0;
  const std::vector<int>& triangles = silhouette.GetTriangles();
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    double corners[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(points + 3 * triangles[t + i], origin, corners[i]);
    }
    // Anticlockwise as seen from the origin: the ray passes left of all three edges.
    bool inside = true;
    for (int i = 0; i < 3; ++i)
    {
      double normal[3];
      vtkMath::Cross(corners[i], corners[(i + 1) % 3], normal);
      inside = inside && vtkMath::Dot(normal, direction) < 0.0;
    }
    count += inside;
  }
  return count;
}
}

vtkShadowFootprint vtkShadowFootprint::Make(
  const double* points, int numberOfPoints, const vtkShadowLightSpace& frame)
{
  vtkShadowFootprint result;
  result.P[0] = result.Q[0] = result.Near = std::numeric_limits<double>::infinity();
  result.P[1] = result.Q[1] = result.Far = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < numberOfPoints; ++i)
  {
    double pqs[3];
    frame.ToLight(points + 3 * i, pqs);
    result.P[0] = std::min(result.P[0], pqs[0]);
    result.P[1] = std::max(result.P[1], pqs[0]);
    result.Q[0] = std::min(result.Q[0], pqs[1]);
    result.Q[1] = std::max(result.Q[1], pqs[1]);
    result.Near = std::min(result.Near, pqs[2]);
    result.Far = std::max(result.Far, pqs[2]);
    for (int k = 0; k < 3; ++k)
    {
      const double x = points[3 * i + k];
      result.Bounds[2 * k] = i > 0 ? std::min(result.Bounds[2 * k], x) : x;
      result.Bounds[2 * k + 1] = i > 0 ? std::max(result.Bounds[2 * k + 1], x) : x;
    }
  }
  return result;
}

vtkShadowFootprint vtkShadowFootprint::Make(
  const vtkShadowSilhouette& silhouette, const double* points, const vtkShadowLightSpace& frame)
{
  std::vector<double> corners;
  corners.reserve(3 * silhouette.GetTriangles().size());
  for (const int corner : silhouette.GetTriangles())
  {
    const double* point = points + 3 * std::size_t(corner);
    corners.insert(corners.end(), point, point + 3);
  }
  return Make(corners.data(), static_cast<int>(silhouette.GetTriangles().size()), frame);
}

vtkShadowPlan::vtkShadowPlan(const vtkShadowLight& light, const vtkShadowLightSpace& frame,
  const View& view, vtkShadowMode mode, const vtkShadowLitmap* litmap, int gap)
  : Light(light)
  , Frame(frame)
  , Camera(view)
  , Mode(mode)
  , Whole{ &this->Frame, litmap }
  , Gap(gap)
{
}

void vtkShadowPlan::AddFace(const vtkShadowLightSpace& frame, const vtkShadowLitmap& litmap)
{
  this->Faces.push_back({ &frame, &litmap });
}

const vtkShadowPlan::Face* vtkShadowPlan::FindContainingFace(
  const vtkShadowFootprint& footprint) const
{
  if (this->Faces.empty())
  {
    return this->IsThroughLightPlane(footprint) ? nullptr : &this->Whole;
  }
  double corners[24];
  GetCorners(footprint.Bounds, corners);
  const auto found = std::find_if(this->Faces.begin(), this->Faces.end(),
    [&corners](const Face& face)
    {
      const vtkShadowFootprint box = vtkShadowFootprint::Make(corners, 8, *face.Frame);
      return box.Near > Margin * box.Far && std::min(box.P[0], box.Q[0]) > -1.0 &&
        std::max(box.P[1], box.Q[1]) < 1.0;
    });
  return found == this->Faces.end() ? nullptr : &*found;
}

vtkShadowPlan::FaceQuery vtkShadowPlan::MakeFaceQuery(
  const Face& face, const vtkShadowFootprint& footprint) const
{
  vtkShadowBlock rays;
  const bool anywhere = this->IsThroughLightPlane(footprint);
  const double* ranges[2] = { footprint.P, footprint.Q };
  for (int i = 0; i < 2; ++i)
  {
    rays.Low[i] = anywhere ? -Everything : ranges[i][0];
    rays.High[i] = anywhere ? Everything : ranges[i][1];
  }
  rays.Low[2] = anywhere ? -Everything : footprint.Near;
  rays.High[2] = Everything;
  return { face, rays };
}

void vtkShadowPlan::AddFaces(const vtkShadowFootprint& footprint, Lookup& lookup) const
{
  double corners[24];
  GetCorners(footprint.Bounds, corners);
  for (const Face& face : this->Faces)
  {
    const vtkShadowFootprint box = vtkShadowFootprint::Make(corners, 8, *face.Frame);
    if (box.Far > 0.0)
    {
      lookup.Add(this->MakeFaceQuery(face, box));
    }
  }
}

vtkShadowPlan::Lookup vtkShadowPlan::LookUp(
  const vtkShadowFootprint& footprint, const double* points, int numberOfPoints) const
{
  Lookup lookup;
  const Face* home = this->FindContainingFace(footprint);
  lookup.IsInOneFace = home != nullptr;
  if (home)
  {
    const vtkShadowFootprint there = this->Faces.empty()
      ? footprint
      : vtkShadowFootprint::Make(points, numberOfPoints, *home->Frame);
    lookup.Near = there.Near;
    lookup.Far = there.Far;
    lookup.Add(this->MakeFaceQuery(*home, there));
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

vtkShadowPlan::Boxes vtkShadowPlan::FindBoxes(const Lookup& lookup,
  const vtkShadowSilhouette& silhouette, const double* points, bool& isOnRays) const
{
  const vtkShadowExtent& extent = lookup.Extent;
  vtkShadowTileSet set({ extent.X0, extent.Y0, extent.X1, extent.Y1 });
  for (const FaceQuery& query : lookup)
  {
    const vtkShadowTiles& tiles = query.Map.Litmap->GetTiles();
    const vtkShadowUmbra reach(silhouette, points, *query.Map.Frame, query.Rays);
    set.Mark(
      [&](int column, int row)
      {
        const bool meets = !tiles.IsKnown() || reach.MeetsRays(tiles.Get(column, row));
        isOnRays = isOnRays || meets;
        return meets && (!tiles.IsKnown() || reach.MayShadow(tiles.Get(column, row)));
      });
  }
  // As many triangles as a whole volume of a directional light has, for all kinds of pieces.
  const std::size_t triangles =
    silhouette.GetTriangles().size() / 3 + 2 * silhouette.GetEdges().size();
  return set.GetBoxes(
    this->Camera.BoxCost * (1.0 + TriangleShare * static_cast<double>(triangles)));
}

bool vtkShadowPlan::IsBeyondNearPlane(const vtkShadowVolume& volume, std::size_t firstVertex) const
{
  const std::vector<float>& vertices = volume.GetVertices();
  const double* plane = this->Camera.NearPlane;
  for (std::size_t i = firstVertex; i < vertices.size(); i += 4)
  {
    double sum = 0.0;
    double terms = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const double term = plane[k] * vertices[i + k];
      sum += term;
      terms += std::abs(term);
    }
    if (!(sum > Margin * terms))
    {
      return false;
    }
  }
  return true;
}

bool vtkShadowPlan::IsThroughLightPlane(const vtkShadowFootprint& footprint) const
{
  return this->Frame.IsPositional() && !(footprint.Near > Margin * std::abs(footprint.Far));
}

bool vtkShadowPlan::HasLitmaps() const
{
  return this->Mode != vtkShadowMode::Unclamped && (this->Whole.Litmap || !this->Faces.empty());
}

double vtkShadowPlan::GetWidestAngle() const
{
  constexpr double margin = 1e-3; // radians; more than vtkShadowLight::IsInCone() is wider
  const double cone = vtkMath::RadiansFromDegrees(this->Light.ConeAngle) + margin;
  return this->Whole.Litmap ? std::max(cone, this->Whole.Litmap->GetWidestAngle()) : cone;
}

bool vtkShadowPlan::IsOutsideCone(const vtkShadowFootprint& footprint) const
{
  if (this->Light.Kind != vtkShadowLightKind::Spot)
  {
    return false;
  }
  double toCenter[3];
  double radius2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double* bounds = footprint.Bounds + 2 * i;
    toCenter[i] = 0.5 * (bounds[0] + bounds[1]) - this->Light.Position[i];
    radius2 += 0.25 * (bounds[1] - bounds[0]) * (bounds[1] - bounds[0]);
  }
  const double distance = vtkMath::Norm(toCenter);
  const double radius = std::sqrt(radius2);
  if (!(distance > radius))
  {
    return false;
  }
  const double angle =
    std::acos(std::clamp(vtkMath::Dot(toCenter, this->Light.Direction) / distance, -1.0, 1.0));
  return angle - std::asin(radius / distance) > this->GetWidestAngle();
}

std::vector<vtkShadowSlab> vtkShadowPlan::GetSlabs(const Lookup& lookup) const
{
  std::vector<vtkShadowSlab> slabs;
  const vtkShadowLitmap& litmap = *lookup.Queries[0].Map.Litmap;
  for (const auto& [near, far] : litmap.GetSlabs(lookup.Extent, this->Gap))
  {
    if (far < lookup.Near)
    {
      continue;
    }
    // Pieces that begin at the caster itself would overlap: one for all of them.
    if (!slabs.empty() && slabs.back().Near <= lookup.Far && near <= lookup.Far)
    {
      slabs.back().Far = far;
    }
    else
    {
      slabs.push_back({ near, far });
    }
  }
  return slabs;
}

void vtkShadowPlan::AddRectangle(
  const vtkShadowSilhouette& silhouette, const vtkShadowFootprint& footprint)
{
  vtkShadowRectangle rectangle;
  rectangle.Weight = silhouette.GetMaximumCount();
  if (!this->IsThroughLightPlane(footprint))
  {
    const double low[2] = { footprint.P[0], footprint.Q[0] };
    const double high[2] = { footprint.P[1], footprint.Q[1] };
    rectangle.Add(low);
    rectangle.Add(high);
  }
  this->Rectangles.push_back(rectangle); // of infinite sides if it may be anywhere
}

bool vtkShadowPlan::IsCountBelow(int limit) const
{
  return vtkShadowOverlap::GetBound(this->Rectangles) <= limit;
}

void vtkShadowPlan::AddDraw(const vtkShadowVolume& volume, const Boxes& boxes, vtkShadowDraw draw)
{
  draw.NumberOfIndices = static_cast<int>(volume.GetIndices().size()) - draw.FirstIndex;
  if (draw.NumberOfIndices == 0)
  {
    return;
  }
  const int* viewport = this->Camera.Viewport;
  std::copy_n(viewport, 4, draw.Box);
  // What the stencil begins with has to be taken away again everywhere.
  if (boxes.empty() || draw.Start != 0 || !this->Camera.Boxes)
  {
    this->Draws.push_back(draw);
    return;
  }
  for (const vtkNBufferRectangle& box : boxes)
  {
    draw.Box[0] = viewport[0] + box.X0;
    draw.Box[1] = viewport[1] + box.Y0;
    draw.Box[2] = box.GetWidth();
    draw.Box[3] = box.GetHeight();
    this->Draws.push_back(draw);
    draw.Again = true;
  }
}

void vtkShadowPlan::AddWhole(const vtkShadowSilhouette& silhouette, const double* points,
  int numberOfPoints, const Boxes& boxes, vtkShadowVolume& volume)
{
  vtkShadowDraw draw;
  draw.FirstIndex = static_cast<int>(volume.GetIndices().size());
  draw.MaximumCount = silhouette.GetMaximumCount();
  draw.Offset = silhouette.GetCounting() == vtkShadowCounting::All;
  const std::size_t firstVertex = volume.GetVertices().size();
  volume.AddWhole(silhouette, points, numberOfPoints, this->Light);
  draw.ZPass = this->IsBeyondNearPlane(volume, firstVertex);
  if (!draw.ZPass && this->Camera.Parallel && this->Frame.IsPositional())
  {
    draw.Start = CountCrossings(silhouette, points, this->Light.Position, this->Camera.Direction);
  }
  this->AddDraw(volume, boxes, draw);
}

std::optional<vtkShadowVerdict> vtkShadowPlan::EarlyOutByPlace(
  const vtkShadowSilhouette& silhouette, const vtkShadowFootprint& footprint) const
{
  if (silhouette.GetTriangles().empty())
  {
    return vtkShadowVerdict::Empty;
  }
  if (!this->HasLitmaps())
  {
    return {};
  }
  if (this->Light.Kind == vtkShadowLightKind::Spot && footprint.Far <= 0.0 &&
    this->GetWidestAngle() < 0.5 * vtkMath::Pi())
  {
    return vtkShadowVerdict::BehindLight;
  }
  if (this->IsThroughLightPlane(footprint) && this->IsOutsideCone(footprint))
  {
    return vtkShadowVerdict::OutsideCone;
  }
  return {};
}

std::optional<vtkShadowVerdict> vtkShadowPlan::EarlyOutByReceivers(const Lookup& lookup)
{
  if (lookup.Extent.IsEmpty())
  {
    return vtkShadowVerdict::NoReceiver;
  }
  if (lookup.IsInOneFace && lookup.Extent.Far < lookup.Near)
  {
    return vtkShadowVerdict::BeforeCaster;
  }
  return {};
}

std::optional<vtkShadowVerdict> vtkShadowPlan::EarlyOut(
  const vtkShadowSilhouette& silhouette, const vtkShadowFootprint& footprint) const
{
  const auto verdict = this->EarlyOutByPlace(silhouette, footprint);
  if (verdict || !this->HasLitmaps())
  {
    return verdict;
  }
  double corners[24];
  GetCorners(footprint.Bounds, corners);
  return EarlyOutByReceivers(this->LookUp(footprint, corners, 8));
}

vtkShadowPlan::Choice vtkShadowPlan::Decide(const vtkShadowSilhouette& silhouette,
  const double* points, int numberOfPoints, const vtkShadowFootprint& footprint) const
{
  Choice choice;
  if (const auto verdict = this->EarlyOutByPlace(silhouette, footprint))
  {
    choice.Verdict = *verdict;
    return choice;
  }
  if (!this->HasLitmaps())
  {
    choice.Verdict = vtkShadowVerdict::Whole;
    return choice;
  }
  const Lookup lookup = this->LookUp(footprint, points, numberOfPoints);
  if (const auto verdict = EarlyOutByReceivers(lookup))
  {
    choice.Verdict = *verdict;
    return choice;
  }
  const bool clamped = lookup.IsInOneFace && this->Mode == vtkShadowMode::Clamped;
  bool isOnRays = false;
  if (clamped)
  {
    choice.Slabs = this->ChooseSlabs(lookup, silhouette, points, isOnRays);
    choice.Frame = lookup.Queries[0].Map.Frame;
    choice.Far = lookup.Far;
  }
  else
  {
    choice.Where = this->FindBoxes(lookup, silhouette, points, isOnRays);
  }
  if (choice.Slabs.empty() && choice.Where.empty())
  {
    choice.Verdict = isOnRays ? vtkShadowVerdict::BeforeCaster : vtkShadowVerdict::NoReceiver;
    return choice;
  }
  const bool through = this->Faces.empty() && !lookup.IsInOneFace;
  choice.Verdict = clamped ? vtkShadowVerdict::Clamped
    : through              ? vtkShadowVerdict::ThroughLightPlane
                           : vtkShadowVerdict::Boxed;
  return choice;
}

std::vector<vtkShadowPlan::BoxedSlab> vtkShadowPlan::ChooseSlabs(const Lookup& lookup,
  const vtkShadowSilhouette& silhouette, const double* points, bool& isOnRays) const
{
  std::vector<BoxedSlab> slabs;
  for (const vtkShadowSlab& slab : this->GetSlabs(lookup))
  {
    Lookup inSlab = lookup;
    vtkShadowBlock& rays = inSlab.Queries[0].Rays;
    rays.Low[2] = std::max(lookup.Near, slab.Near);
    rays.High[2] = slab.Far;
    Boxes boxes = this->FindBoxes(inSlab, silhouette, points, isOnRays);
    if (!boxes.empty())
    {
      slabs.push_back({ slab, std::move(boxes) });
    }
  }
  return slabs;
}

void vtkShadowPlan::Draw(const Choice& choice, const vtkShadowSilhouette& silhouette,
  const double* points, int numberOfPoints, const vtkShadowFootprint& footprint,
  vtkShadowVolume& volume)
{
  if (!choice.IsDrawn())
  {
    return;
  }
  this->AddRectangle(silhouette, footprint);
  if (choice.Slabs.empty())
  {
    this->AddWhole(silhouette, points, numberOfPoints, choice.Where, volume);
  }
  for (const BoxedSlab& slab : choice.Slabs)
  {
    this->AddSlab(choice, slab, silhouette, points, numberOfPoints, volume);
  }
}

void vtkShadowPlan::AddSlab(const Choice& choice, const BoxedSlab& slab,
  const vtkShadowSilhouette& silhouette, const double* points, int numberOfPoints,
  vtkShadowVolume& volume)
{
  vtkShadowDraw draw;
  draw.FirstIndex = static_cast<int>(volume.GetIndices().size());
  draw.MaximumCount = silhouette.GetMaximumCount();
  draw.Offset = choice.Far >= slab.Slab.Near && silhouette.GetCounting() == vtkShadowCounting::All;
  const std::size_t firstVertex = volume.GetVertices().size();
  volume.AddClamped(
    silhouette, points, numberOfPoints, *choice.Frame, slab.Slab, choice.Far, vtkShadowCap::Fan);
  draw.ZPass = this->IsBeyondNearPlane(volume, firstVertex);
  this->AddDraw(volume, slab.Where, draw);
  ++this->Slabs;
}
VTK_ABI_NAMESPACE_END
