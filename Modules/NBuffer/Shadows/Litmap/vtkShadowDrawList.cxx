// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDrawList.h"

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A generous bound of the rounding error of a distance from the near plane, relative to the sum of
/// the magnitudes of its terms.
constexpr double Margin = 1e-6;
}

vtkShadowDrawList::vtkShadowDrawList(const vtkShadowLight& light, const View& view)
  : Light(light)
  , Camera(view)
  , NearPlane(glm::row(view.EyeToClip, 2) + glm::row(view.EyeToClip, 3))
{
}

void vtkShadowDrawList::AddRays(const vtkShadowSilhouette& silhouette, const vtkShadowBlock& rays)
{
  this->Items.push_back({ rays.Low, rays.High, silhouette.GetMaximumCount() });
}

void vtkShadowDrawList::AddWhole(
  const vtkShadowPart& caster, const Boxes& boxes, vtkShadowVolumeStore& store)
{
  const vtkShadowBlock& view = this->Camera.ParallelView;
  const vtkShadowPiece piece =
    store.GetWhole(caster, this->Light, view.IsEmpty() ? nullptr : &view);
  this->AddDraws(caster, true, boxes, store.GetVolume(), piece);
}

void vtkShadowDrawList::AddClamped(const vtkShadowPart& caster, const vtkShadowLightSpace& space,
  const vtkShadowSlab& slab, double casterFar, const Boxes& boxes, vtkShadowVolumeStore& store)
{
  const vtkShadowPiece piece = store.AddClamped(caster, space, slab, casterFar);
  this->AddDraws(caster, casterFar >= slab.Near, boxes, store.GetVolume(), piece);
}

void vtkShadowDrawList::AddDraws(const vtkShadowPart& caster, bool isNearCapItsOwn,
  const Boxes& boxes, const vtkShadowVolume& volume, const vtkShadowPiece& piece)
{
  vtkShadowDraw draw;
  draw.FirstIndex = static_cast<int>(piece.FirstIndex);
  draw.NumberOfIndices = static_cast<int>(piece.GetNumberOfIndices());
  if (draw.NumberOfIndices == 0)
  {
    return;
  }
  this->Triangles += draw.NumberOfIndices / 3;
  draw.MaximumCount = caster.Silhouette.GetMaximumCount();
  draw.Offset = isNearCapItsOwn && caster.Silhouette.GetCounting() == vtkShadowCounting::All;
  draw.ZPass = this->IsBeyondNearPlane(volume, piece);
  draw.Box = { 0, 0, this->Camera.Viewport[2], this->Camera.Viewport[3] };
  if (boxes.empty() || !this->Camera.Boxes)
  {
    this->Draws.push_back(draw);
    return;
  }
  for (const vtkNBufferRectangle& box : boxes)
  {
    draw.Box = box;
    this->Draws.push_back(draw);
    draw.Again = true;
  }
}

bool vtkShadowDrawList::IsBeyondNearPlane(
  const vtkShadowVolume& volume, const vtkShadowPiece& piece) const
{
  for (std::size_t i = piece.FirstVertex; i < piece.EndVertex; ++i)
  {
    const glm::dvec4 terms = this->NearPlane * this->Camera.ToEye(volume.GetVertices()[i]);
    const auto addUp = [](const glm::dvec4& x) { return x[0] + x[1] + x[2] + x[3]; };
    if (!(addUp(terms) > Margin * addUp(glm::abs(terms))))
    {
      return false;
    }
  }
  return true;
}

bool vtkShadowDrawList::IsCountBelow(int limit) const
{
  return vtkShadowOverlap::GetBound(this->Items) <= limit;
}
VTK_ABI_NAMESPACE_END
