// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDrawList.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A generous bound of the rounding error of a distance from the near plane, relative to the sum of
/// the magnitudes of its terms.
constexpr double Margin = 1e-6;

/// A camera looks along a light if the sides of its volumes move across the view by less than this
/// part of it in the whole range of depths. (OpenGL fails only where they hardly move at all.)
constexpr double Along = 0x1p-10;

/// Whether whole volumes end beyond the view; see the header.
bool EndsBeyondView(const vtkShadowLight& light, const vtkShadowDrawList::View& view)
{
  const glm::dvec4 direction = view.EyeToClip * glm::dvec4(light.Direction, 0.0);
  const bool isAlong =
    std::max(std::abs(direction.x), std::abs(direction.y)) < Along * std::abs(direction.z);
  return !view.ParallelView.IsEmpty() && (light.IsPositional() || isAlong);
}
}

bool vtkShadowDrawList::SetView(const View& view)
{
  if (EndsBeyondView(this->Light, this->Camera) || EndsBeyondView(this->Light, view))
  {
    return false;
  }
  this->Camera = view;
  for (std::size_t i = 0; i < this->Draws.size(); ++i)
  {
    this->Draws[i].Box = { 0, 0, view.Viewport[2], view.Viewport[3] };
    this->Draws[i].ZPass = this->IsBeyondNearPlane(this->Pieces[i]);
  }
  return true;
}

void vtkShadowDrawList::AddRays(const vtkShadowSilhouette& silhouette, const vtkShadowBlock& rays)
{
  this->Bound.reset();
  this->Items.push_back({ rays, silhouette.GetMaximumCount() });
}

void vtkShadowDrawList::AddWhole(
  const vtkShadowPart& caster, const Boxes& boxes, vtkShadowVolumeStore& store)
{
  const vtkShadowBlock* end =
    EndsBeyondView(this->Light, this->Camera) ? &this->Camera.ParallelView : nullptr;
  this->AddDraws(caster, true, boxes, store.GetWhole(caster, this->Light, end));
}

void vtkShadowDrawList::AddClamped(const vtkShadowPart& caster, const vtkShadowLightSpace& space,
  const vtkShadowSlab& slab, double casterFar, const Boxes& boxes, vtkShadowVolumeStore& store)
{
  const vtkShadowPiece piece = store.AddClamped(caster, space, slab, casterFar);
  this->AddDraws(caster, casterFar >= slab.Near, boxes, piece);
}

void vtkShadowDrawList::AddDraws(const vtkShadowPart& caster, bool isNearCapItsOwn,
  const Boxes& boxes, const vtkShadowPiece& piece)
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
  const bool isAll = caster.Silhouette.GetCounting() == vtkShadowCounting::All;
  if (isNearCapItsOwn)
  {
    draw.NumberOfOffsetIndices =
      isAll ? draw.NumberOfIndices : static_cast<int>(caster.Silhouette.GetTriangles().size());
  }
  if (caster.GetPushedRounding() > 0.0)
  {
    draw.Rounding = static_cast<float>(std::exp2(std::ceil(std::log2(caster.Rounding))));
  }
  draw.ZPass = this->IsBeyondNearPlane(piece);
  const Boxes everywhere = { { 0, 0, this->Camera.Viewport[2], this->Camera.Viewport[3] } };
  for (const vtkNBufferRectangle& box : boxes.empty() || !this->Camera.Boxes ? everywhere : boxes)
  {
    draw.Box = box;
    this->Draws.push_back(draw);
    this->Pieces.push_back(piece);
    draw.Again = true;
  }
}

bool vtkShadowDrawList::IsBeyondNearPlane(const vtkShadowPiece& piece) const
{
  // The product of this row with a vertex relative to the eye is z + w.
  const glm::dvec4 plane =
    glm::row(this->Camera.EyeToClip, 2) + glm::row(this->Camera.EyeToClip, 3);
  // Whether z + w is positive in a box of vertices that have this w.
  const auto isBeyond = [&](const vtkShadowBlock& box, double w)
  {
    const glm::dvec3 normal(plane);
    const glm::dvec3 low = normal * (box.Low - w * this->Camera.Eye);
    const glm::dvec3 high = normal * (box.High - w * this->Camera.Eye);
    const double constant = w * plane.w;
    const auto addUp = [](const glm::dvec3& x) { return x[0] + x[1] + x[2]; };
    return box.IsEmpty() ||
      addUp(glm::min(low, high)) + constant >
      Margin * (addUp(glm::max(glm::abs(low), glm::abs(high))) + std::abs(constant));
  };
  return isBeyond(piece.Points, 1.0) && isBeyond(piece.Directions, 0.0);
}

bool vtkShadowDrawList::IsCountWithin(int limit) const
{
  if (!this->Bound)
  {
    this->Bound = vtkShadowOverlap::GetBound(this->Items);
  }
  return *this->Bound <= limit;
}
VTK_ABI_NAMESPACE_END
