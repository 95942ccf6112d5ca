// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDrawList.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// A generous bound of the rounding error of a distance from the near plane, relative to the sum of
/// the magnitudes of its terms.
constexpr double Margin = 1e-6;

/// A draw of the triangles that will be added to `volume` next.
vtkShadowDraw MakeDraw(const vtkShadowPart& caster, const vtkShadowVolume& volume)
{
  vtkShadowDraw draw;
  draw.FirstIndex = static_cast<int>(volume.GetIndices().size());
  draw.MaximumCount = caster.Silhouette.GetMaximumCount();
  draw.Offset = caster.Silhouette.GetCounting() == vtkShadowCounting::All;
  return draw;
}
}

vtkShadowDrawList::vtkShadowDrawList(const vtkShadowLight& light, const View& view)
  : Light(light)
  , Camera(view)
{
}

void vtkShadowDrawList::AddRays(const vtkShadowSilhouette& silhouette, const vtkShadowBlock& rays)
{
  this->Items.push_back({ rays.Low, rays.High, silhouette.GetMaximumCount() });
}

void vtkShadowDrawList::AddWhole(
  const vtkShadowPart& caster, const Boxes& boxes, vtkShadowVolume& volume)
{
  vtkShadowDraw draw = MakeDraw(caster, volume);
  const std::size_t firstVertex = volume.GetVertices().size();
  const vtkShadowBlock& view = this->Camera.ParallelView;
  volume.AddWhole(
    caster.Silhouette, *caster.Points, this->Light, view.IsEmpty() ? nullptr : &view);
  draw.ZPass = this->IsBeyondNearPlane(volume, firstVertex);
  this->AddDraw(volume, boxes, draw);
}

void vtkShadowDrawList::AddClamped(const vtkShadowPart& caster, const vtkShadowLightSpace& space,
  const vtkShadowSlab& slab, double casterFar, const Boxes& boxes, vtkShadowVolume& volume)
{
  vtkShadowDraw draw = MakeDraw(caster, volume);
  draw.Offset = draw.Offset && casterFar >= slab.Near;
  const std::size_t firstVertex = volume.GetVertices().size();
  volume.AddClamped(caster.Silhouette, *caster.Points, space, slab, casterFar);
  draw.ZPass = this->IsBeyondNearPlane(volume, firstVertex);
  this->AddDraw(volume, boxes, draw);
}

void vtkShadowDrawList::AddDraw(
  const vtkShadowVolume& volume, const Boxes& boxes, vtkShadowDraw draw)
{
  draw.NumberOfIndices = static_cast<int>(volume.GetIndices().size()) - draw.FirstIndex;
  if (draw.NumberOfIndices == 0)
  {
    return;
  }
  const int* viewport = this->Camera.Viewport;
  std::copy_n(viewport, 4, draw.Box);
  if (boxes.empty() || !this->Camera.Boxes)
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

bool vtkShadowDrawList::IsBeyondNearPlane(
  const vtkShadowVolume& volume, std::size_t firstVertex) const
{
  const std::vector<float>& vertices = volume.GetVertices();
  for (std::size_t i = firstVertex; i < vertices.size(); i += 4)
  {
    const glm::dvec4 terms =
      this->Camera.NearPlane * glm::dvec4(glm::make_vec4(vertices.data() + i));
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
