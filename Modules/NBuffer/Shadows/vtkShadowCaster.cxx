// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCaster.h"

#include "vtkNBufferForEachProp.h"
#include "vtkNBufferPolygonClip.h"
#include "vtkNBufferSurface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>

VTK_ABI_NAMESPACE_BEGIN
// A vector that grows moves its parts only if that cannot throw; otherwise it copies them.
static_assert(std::is_nothrow_move_constructible_v<vtkShadowPart>);

namespace
{
/// Clips triangles by a plane. Triangles on both sides of an edge share the new point on it.
void Clip(std::vector<glm::dvec3>& points, std::vector<vtkIdType>& triangles,
  const vtkShadowCaster::Plane& plane)
{
  std::vector<double> sides;
  for (const glm::dvec3& x : points)
  {
    sides.push_back(plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2] + plane[3]);
  }
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> cuts;
  const auto getCut = [&](vtkIdType a, vtkIdType b)
  {
    const auto [cut, isNew] =
      cuts.try_emplace(std::minmax(a, b), static_cast<vtkIdType>(points.size()));
    if (isNew)
    {
      const auto [from, to] = cut->first;
      const double t = sides[from] / (sides[from] - sides[to]);
      points.push_back(points[from] + t * (points[to] - points[from]));
    }
    return cut->second;
  };
  std::vector<vtkIdType> left;
  std::vector<vtkIdType> triangle(3);
  std::vector<vtkIdType> polygon;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    std::copy_n(triangles.begin() + static_cast<std::ptrdiff_t>(t), 3, triangle.begin());
    vtkNBufferPolygonClip::Clip(
      triangle, [&sides](vtkIdType i) { return sides[i]; },
      [&getCut](vtkIdType a, vtkIdType b, double) { return getCut(a, b); }, polygon);
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      left.insert(left.end(), { polygon[0], polygon[i - 1], polygon[i] });
    }
  }
  triangles = std::move(left);
}
}

std::shared_ptr<const vtkShadowTopology> vtkShadowCaster::MakeTopology(vtkPolyData* data)
{
  const vtkNBufferMesh mesh = vtkNBufferSurface::GetMesh(data);
  std::vector<vtkIdType> triangles;
  triangles.reserve(3 * mesh.Triangles.size());
  for (const std::array<unsigned int, 3>& triangle : mesh.Triangles)
  {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  return std::make_shared<const vtkShadowTopology>(mesh.Points, triangles);
}

bool vtkShadowCaster::Update(const std::shared_ptr<const vtkShadowTopology>& mesh,
  const std::array<double, 16>& toWorld, const std::vector<Plane>& planes)
{
  if (mesh == this->MeshTopology && planes == this->Planes && toWorld == this->ToWorld)
  {
    return false;
  }
  this->MeshTopology = mesh;
  this->ToWorld = toWorld;
  this->Planes = planes;
  this->Topology = this->MeshTopology;
  this->Points = this->Topology->GetPoints();
  const glm::dmat4 matrix = vtkNBufferGLM::ToMatrix(toWorld.data());
  for (glm::dvec3& point : this->Points)
  {
    const glm::dvec4 moved = vtkNBufferGLM::Multiply(matrix, glm::dvec4(point, 1.0));
    point = glm::dvec3(moved) / moved.w;
  }
  if (!planes.empty())
  {
    std::vector<vtkIdType> triangles(
      this->Topology->GetTriangles().begin(), this->Topology->GetTriangles().end());
    for (const Plane& plane : planes)
    {
      Clip(this->Points, triangles, plane);
    }
    this->Topology = std::make_shared<const vtkShadowTopology>(this->Points, triangles);
    this->Points = this->Topology->GetPoints();
  }
  this->Bounds = vtkShadowBlock();
  for (const glm::dvec3& point : this->Points)
  {
    this->Bounds.Add(point);
  }
  this->Slots.clear();
  return true;
}

void vtkShadowCaster::SetRounding(const glm::dvec3& m, const std::array<double, 16>* actor)
{
  const glm::dmat4 toWorld = vtkNBufferGLM::ToMatrix(this->ToWorld.data());
  double largest =
    actor ? glm::length(glm::dvec3(toWorld[3] - vtkNBufferGLM::ToMatrix(actor->data())[3])) : 0.0;
  for (int k = 0; k < 3; ++k)
  {
    largest += glm::length(glm::dvec3(toWorld[k])) * m[k];
  }
  const double rounding = (actor ? 20.0 : 10.0) * 0x1p-24 * largest;
  const double size = glm::length(this->Bounds.High - this->Bounds.Low);
  this->Rounding = std::isfinite(rounding) && rounding > 0x1p-17 * size ? rounding : 0.0;
  for (Slot& slot : this->Slots)
  {
    for (vtkShadowPart& part : slot.Parts)
    {
      part.Rounding = this->Rounding;
    }
  }
}

bool vtkShadowCaster::UpdateParts(std::size_t slot, const vtkShadowLight& light,
  const vtkShadowLightSpace& space, const vtkShadowBlock& nearBounds)
{
  if (slot >= this->Slots.size())
  {
    this->Slots.resize(slot + 1);
  }
  Slot& cached = this->Slots[slot];
  // All triangles count in two cases. A light within the bounds may be inside the caster, where no
  // triangle faces it. And if the inside of the caster is seen, the inside has to be in shadow. The
  // near plane or face culling may show it.
  const bool isAround =
    light.IsPositional() && this->Bounds.Meets({ light.Position, light.Position });
  const vtkShadowCounting counting =
    isAround || this->InsideIsSeen || this->Bounds.Meets(nearBounds) ? vtkShadowCounting::All
                                                                     : vtkShadowCounting::Away;
  if (!cached.Parts.empty() && cached.Light == light && cached.Counting == counting)
  {
    return false;
  }
  cached.Parts.clear();
  cached.Light = light;
  cached.Counting = counting;
  vtkShadowPart whole;
  whole.Topology = this->Topology;
  whole.Points = &this->Points;
  whole.Rounding = this->Rounding;
  AddPart(cached, std::move(whole), space);
  return true;
}

void vtkShadowCaster::Prefetch() const
{
  vtkNBufferForEachProp::Fetch(&this->Bounds);
  vtkNBufferForEachProp::Fetch(&this->Slots);
}

void vtkShadowCaster::PrefetchParts(std::size_t slot) const
{
  if (slot < this->Slots.size())
  {
    vtkNBufferForEachProp::Fetch(&this->Slots[slot].Light);
    vtkNBufferForEachProp::Fetch(&this->Slots[slot].Parts);
  }
}

void vtkShadowCaster::AddPart(Slot& slot, vtkShadowPart part, const vtkShadowLightSpace& space)
{
  part.Silhouette.Compute(*part.Topology, *part.Points, slot.Light, slot.Counting);
  const int triangles = part.Topology->GetNumberOfTriangles();
  if (part.Silhouette.GetMaximumCount() > MaximumCount && triangles > 1)
  {
    const int middle = triangles / 2;
    for (const auto& [begin, end] : { std::pair(0, middle), std::pair(middle, triangles) })
    {
      const auto corners = part.Topology->GetTriangles().begin();
      vtkShadowPart half;
      half.Topology = std::make_shared<const vtkShadowTopology>(
        *part.Points, std::vector<vtkIdType>(corners + 3 * begin, corners + 3 * end));
      half.Points = &half.Topology->GetPoints();
      half.Rounding = part.Rounding;
      AddPart(slot, std::move(half), space);
    }
    return;
  }
  part.Footprint = vtkShadowFootprint::Make(part.Silhouette, *part.Points, space);
  slot.Parts.push_back(std::move(part));
}
VTK_ABI_NAMESPACE_END
