// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPlan.h"

#include "vtkShadowTiles.h"
#include "vtkShadowUmbra.h"

#include <algorithm>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The part of the cost of a box that is added for each triangle.
constexpr double TriangleShare = 1.0 / 32;
}

vtkShadowPlan::vtkShadowPlan(const vtkShadowLight& light, const View& view, vtkShadowMode mode,
  std::vector<Face> litmaps, const vtkShadowTuning& tuning)
  : Litmaps(light, mode == vtkShadowMode::Unclamped ? std::vector<Face>() : std::move(litmaps))
  , Draws(light, view)
  , IsClamped(mode == vtkShadowMode::Clamped)
  , BoxCost(view.Boxes ? tuning.BoxCost : std::numeric_limits<double>::infinity())
  , ConeReach(view.ConeReach)
  , SlabGap(tuning.SlabGap)
{
}

std::optional<vtkShadowVerdict> vtkShadowPlan::EarlyOut(const vtkShadowPart& caster) const
{
  if (caster.Silhouette.GetTriangles().empty())
  {
    return vtkShadowVerdict::Empty;
  }
  if (!this->Litmaps.IsKnown())
  {
    return this->Litmaps.IsBeyondReach(caster.Footprint, this->ConeReach)
      ? std::optional(vtkShadowVerdict::OutsideCone)
      : std::nullopt;
  }
  if (this->Litmaps.IsBehindSpot(caster.Footprint))
  {
    return vtkShadowVerdict::BehindLight;
  }
  if (this->Litmaps.IsThroughLightPlane(caster.Footprint.Block) &&
    this->Litmaps.IsOutsideCone(caster.Footprint))
  {
    return vtkShadowVerdict::OutsideCone;
  }
  return EarlyOutByReceivers(this->Litmaps.LookUp(caster.Footprint));
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

vtkShadowPlan::Choice vtkShadowPlan::Decide(const vtkShadowPart& caster) const
{
  if (const auto verdict = this->EarlyOut(caster))
  {
    return { *verdict };
  }
  if (!this->Litmaps.IsKnown())
  {
    return { vtkShadowVerdict::Whole };
  }
  Lookup lookup = this->Litmaps.LookUp(caster.Footprint, caster.Points);
  if (const auto verdict = EarlyOutByReceivers(lookup))
  {
    return { *verdict };
  }
  Choice choice;
  const bool clamped = lookup.IsInOneFace && this->IsClamped;
  bool isOnRays = false;
  if (clamped)
  {
    choice.Space = lookup.Queries[0].Map.Space;
    choice.Far = lookup.Far;
    vtkShadowBlock& rays = lookup.Queries[0].Rays;
    for (const vtkShadowSlab& slab : this->GetSlabs(lookup))
    {
      rays.Low[2] = std::max(lookup.Near, slab.Near);
      rays.High[2] = slab.Far;
      Boxes boxes = this->FindBoxes(lookup, caster, isOnRays);
      if (!boxes.empty())
      {
        choice.Slabs.push_back({ slab, std::move(boxes) });
      }
    }
  }
  else
  {
    choice.Pixels = this->FindBoxes(lookup, caster, isOnRays);
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

vtkShadowPlan::Boxes vtkShadowPlan::FindBoxes(
  const Lookup& lookup, const vtkShadowPart& caster, bool& isOnRays) const
{
  const vtkShadowExtent& extent = lookup.Extent;
  vtkShadowTileSet set({ extent.X0, extent.Y0, extent.X1, extent.Y1 });
  for (const vtkShadowLitmapSet::FaceQuery& query : lookup.Queries)
  {
    const vtkShadowTiles& tiles = query.Map.Litmap->GetTiles();
    const vtkShadowUmbra umbra(caster.Silhouette, *caster.Points, *query.Map.Space, query.Rays);
    set.Mark(
      [&](int column, int row)
      {
        const bool meets = !tiles.IsKnown() || umbra.MeetsRays(tiles.Get(column, row));
        isOnRays = isOnRays || meets;
        return meets && (!tiles.IsKnown() || umbra.MayShadow(tiles.Get(column, row)));
      });
  }
  // The same cost is used for all kinds of pieces: that of the near cap and of two triangles for
  // each silhouette edge.
  const std::size_t triangles =
    caster.Silhouette.GetTriangles().size() / 3 + 2 * caster.Silhouette.GetEdges().size();
  const double cost = this->BoxCost * (1.0 + TriangleShare * static_cast<double>(triangles));
  return set.GetBoxes(cost);
}

std::vector<vtkShadowSlab> vtkShadowPlan::GetSlabs(const Lookup& lookup) const
{
  std::vector<vtkShadowSlab> slabs;
  const vtkShadowLitmap& litmap = *lookup.Queries[0].Map.Litmap;
  for (const auto& [near, far] : litmap.GetSlabs(lookup.Extent, this->SlabGap))
  {
    if (far < lookup.Near)
    {
      continue;
    }
    // If the caster reaches into several slabs, their pieces would all begin at the caster and
    // overlap. One piece replaces them.
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

void vtkShadowPlan::Draw(
  const Choice& choice, const vtkShadowPart& caster, vtkShadowVolumeStore& store)
{
  ++this->Verdicts[static_cast<std::size_t>(choice.Verdict)];
  this->Slabs += static_cast<int>(choice.Slabs.size());
  if (!choice.IsDrawn())
  {
    return;
  }
  // An empty block, which is not finite, stands for a caster that may be on any ray.
  this->Draws.AddRays(caster.Silhouette,
    this->Litmaps.IsThroughLightPlane(caster.Footprint.Block) ? vtkShadowBlock()
                                                              : caster.Footprint.Block);
  if (choice.Slabs.empty())
  {
    this->Draws.AddWhole(caster, choice.Pixels, store);
  }
  for (const BoxedSlab& slab : choice.Slabs)
  {
    this->Draws.AddClamped(caster, *choice.Space, slab.Slab, choice.Far, slab.Pixels, store);
  }
}
VTK_ABI_NAMESPACE_END
