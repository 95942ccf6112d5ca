// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumeStore.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The store is cleared if it holds more indices than Surplus times those that the last frame used,
/// plus SmallNumberOfIndices, so that it is not cleared for the sake of a few casters.
constexpr std::size_t Surplus = 4;
constexpr std::size_t SmallNumberOfIndices = 1 << 16;
}

void vtkShadowVolumeStore::Clear()
{
  this->Volume = vtkShadowVolume();
  this->Whole.clear();
  this->Time.Modified();
}

void vtkShadowVolumeStore::BeginFrame()
{
  if (this->PiecesMade > 0 &&
    this->Volume.GetIndices().size() > Surplus * this->UsedIndices + SmallNumberOfIndices)
  {
    this->Clear();
  }
  this->UsedIndices = 0;
  this->PiecesMade = 0;
}

vtkShadowPiece vtkShadowVolumeStore::Use(const vtkShadowPiece& piece)
{
  this->UsedIndices += piece.GetNumberOfIndices();
  return piece;
}

vtkShadowPiece vtkShadowVolumeStore::GetWhole(
  const vtkShadowPart& caster, const vtkShadowLight& light, const vtkShadowBlock* view)
{
  const auto make = [&]
  {
    ++this->PiecesMade;
    return this->Volume.AddWhole(caster.Silhouette, *caster.Points, light, view);
  };
  if (view)
  {
    return this->Use(make());
  }
  const auto [place, isNew] = this->Whole.try_emplace(caster.Silhouette.GetMTime());
  if (isNew)
  {
    place->second = make();
  }
  return this->Use(place->second);
}

vtkShadowPiece vtkShadowVolumeStore::AddClamped(const vtkShadowPart& caster,
  const vtkShadowLightSpace& space, const vtkShadowSlab& slab, double casterFar)
{
  ++this->PiecesMade;
  return this->Use(
    this->Volume.AddClamped(caster.Silhouette, *caster.Points, space, slab, casterFar));
}
VTK_ABI_NAMESPACE_END
