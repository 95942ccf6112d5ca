// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPlan.h"

#include "vtkShadowTiles.h"
#include "vtkShadowUmbra.h"

#include <algorithm>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The part of View::BoxCost that is added for each triangle.
constexpr double TriangleShare = 1.0 / 32;
}

vtkShadowPlan::vtkShadowPlan(const vtkShadowLight& light, const vtkShadowLightSpace& space,
  const View& view, vtkShadowMode mode, const vtkShadowLitmap* litmap, int gap)
  : Litmaps(light, space, litmap)
  , Draws(light, view)
  , BoxCost(view.BoxCost)
  , Mode(mode)
  , Gap(gap)
{
}

void vtkShadowPlan::AddFace(const vtkShadowLightSpace& space, const vtkShadowLitmap& litmap)
{
  this->Litmaps.AddFace(space, litmap);
}

bool vtkShadowPlan::HasLitmaps() const
{
  return this->Mode != vtkShadowMode::Unclamped && this->Litmaps.IsKnown();
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
  if (this->Litmaps.IsBehindSpot(footprint))
  {
    return vtkShadowVerdict::BehindLight;
  }
  if (this->Litmaps.IsThroughLightPlane(footprint) && this->Litmaps.IsOutsideCone(footprint))
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
  const std::array<glm::dvec3, 8> corners = footprint.GetCorners();
  return EarlyOutByReceivers(this->Litmaps.LookUp(footprint, corners));
}

vtkShadowPlan::Choice vtkShadowPlan::Decide(const vtkShadowSilhouette& silhouette,
  vtkShadowPoints points, const vtkShadowFootprint& footprint) const
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
  const Lookup lookup = this->Litmaps.LookUp(footprint, points);
  if (const auto verdict = EarlyOutByReceivers(lookup))
  {
    choice.Verdict = *verdict;
    return choice;
  }
  const bool clamped = lookup.IsInOneFace && this->Mode == vtkShadowMode::Clamped;
  bool isOnRays = false;
  if (clamped)
  {
    choice.Space = lookup.Queries[0].Map.Space;
    choice.Far = lookup.Far;
    for (const vtkShadowSlab& slab : this->GetSlabs(lookup))
    {
      Lookup inSlab = lookup;
      inSlab.Queries[0].Rays.Low[2] = std::max(lookup.Near, slab.Near);
      inSlab.Queries[0].Rays.High[2] = slab.Far;
      FoundBoxes boxes = this->FindBoxes(inSlab, silhouette, points);
      isOnRays = isOnRays || boxes.IsOnRays;
      if (!boxes.Where.empty())
      {
        choice.Slabs.push_back({ slab, std::move(boxes.Where) });
      }
    }
  }
  else
  {
    FoundBoxes boxes = this->FindBoxes(lookup, silhouette, points);
    isOnRays = boxes.IsOnRays;
    choice.Where = std::move(boxes.Where);
  }
  if (!choice.IsDrawn())
  {
    choice.Verdict = isOnRays ? vtkShadowVerdict::BeforeCaster : vtkShadowVerdict::NoReceiver;
    return choice;
  }
  const bool isThrough = !this->Litmaps.HasFaces() && !lookup.IsInOneFace;
  choice.Verdict = clamped ? vtkShadowVerdict::Clamped
    : isThrough            ? vtkShadowVerdict::ThroughLightPlane
                           : vtkShadowVerdict::Boxed;
  return choice;
}

vtkShadowPlan::FoundBoxes vtkShadowPlan::FindBoxes(
  const Lookup& lookup, const vtkShadowSilhouette& silhouette, vtkShadowPoints points) const
{
  const vtkShadowExtent& extent = lookup.Extent;
  vtkShadowTileSet set({ extent.X0, extent.Y0, extent.X1, extent.Y1 });
  bool isOnRays = false;
  for (const vtkShadowLitmapSet::FaceQuery& query : lookup)
  {
    const vtkShadowTiles& tiles = query.Map.Litmap->GetTiles();
    const vtkShadowUmbra umbra(silhouette, points, *query.Map.Space, query.Rays);
    set.Mark(
      [&](int column, int row)
      {
        const bool meets = !tiles.IsKnown() || umbra.MeetsRays(tiles.Get(column, row));
        isOnRays = isOnRays || meets;
        return meets && (!tiles.IsKnown() || umbra.MayShadow(tiles.Get(column, row)));
      });
  }
  // For all kinds of pieces the cost is that of as many triangles as a directional light's whole
  // volume has.
  const std::size_t triangles =
    silhouette.GetTriangles().size() / 3 + 2 * silhouette.GetEdges().size();
  const double cost = this->BoxCost * (1.0 + TriangleShare * static_cast<double>(triangles));
  return { set.GetBoxes(cost), isOnRays };
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
    // Pieces that begin at the caster itself would overlap: one piece stands for all of them.
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

void vtkShadowPlan::Draw(const Choice& choice, const vtkShadowSilhouette& silhouette,
  vtkShadowPoints points, const vtkShadowFootprint& footprint, vtkShadowVolume& volume)
{
  if (!choice.IsDrawn())
  {
    return;
  }
  // A block that is empty, and so infinite, stands for a caster that may be on any ray.
  this->Draws.AddRays(
    silhouette, this->Litmaps.IsThroughLightPlane(footprint) ? vtkShadowBlock() : footprint.Block);
  if (choice.Slabs.empty())
  {
    this->Draws.AddWhole(silhouette, points, choice.Where, volume);
  }
  for (const BoxedSlab& slab : choice.Slabs)
  {
    this->Draws.AddClamped(
      silhouette, points, *choice.Space, slab.Slab, choice.Far, slab.Where, volume);
    ++this->Slabs;
  }
}
VTK_ABI_NAMESPACE_END
