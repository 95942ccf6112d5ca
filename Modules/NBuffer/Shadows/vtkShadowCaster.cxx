// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCaster.h"

#include "vtkNBufferForEachProp.h"
#include "vtkNBufferSurface.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
std::shared_ptr<const vtkShadowTopology> MakeTopology(vtkPolyData* data)
{
  auto topology = std::make_shared<vtkShadowTopology>();
  const vtkNBufferMesh mesh = vtkNBufferSurface::GetMesh(data);
  std::vector<double> points;
  points.reserve(3 * mesh.Points.size());
  for (const glm::dvec3& point : mesh.Points)
  {
    points.insert(points.end(), { point.x, point.y, point.z });
  }
  std::vector<vtkIdType> triangles;
  triangles.reserve(3 * mesh.Triangles.size());
  for (const std::array<unsigned int, 3>& triangle : mesh.Triangles)
  {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  topology->Build(points.data(), static_cast<vtkIdType>(mesh.Points.size()), triangles.data(),
    static_cast<vtkIdType>(mesh.Triangles.size()));
  return topology;
}

/// Triangles [begin, end) alone, in coordinates that the caller has.
std::shared_ptr<const vtkShadowTopology> MakeTopology(
  const vtkShadowTopology& whole, const std::vector<double>& points, int begin, int end)
{
  const std::vector<vtkIdType> triangles(
    whole.GetTriangles().begin() + 3 * begin, whole.GetTriangles().begin() + 3 * end);
  auto topology = std::make_shared<vtkShadowTopology>();
  topology->Build(points.data(), whole.GetNumberOfPoints(), triangles.data(), end - begin);
  return topology;
}

/// What a plane leaves of triangles. New points are shared by the triangles on both sides of an
/// edge.
void Clip(std::vector<double>& points, std::vector<vtkIdType>& triangles,
  const vtkShadowCaster::Plane& plane)
{
  std::vector<double> sides;
  for (std::size_t k = 0; k < points.size(); k += 3)
  {
    sides.push_back(
      plane[0] * points[k] + plane[1] * points[k + 1] + plane[2] * points[k + 2] + plane[3]);
  }
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> cuts;
  const auto getCut = [&](vtkIdType a, vtkIdType b)
  {
    const auto [cut, isNew] =
      cuts.try_emplace(std::minmax(a, b), static_cast<vtkIdType>(points.size() / 3));
    if (isNew)
    {
      const auto [from, to] = cut->first;
      const double t = sides[from] / (sides[from] - sides[to]);
      for (int i = 0; i < 3; ++i)
      {
        const double x = points[3 * from + i];
        points.push_back(x + t * (points[3 * to + i] - x));
      }
    }
    return cut->second;
  };
  std::vector<vtkIdType> left;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
  {
    std::vector<vtkIdType> polygon;
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType a = triangles[t + i];
      const vtkIdType b = triangles[t + (i + 1) % 3];
      if (sides[a] >= 0.0)
      {
        polygon.push_back(a);
      }
      if ((sides[a] >= 0.0) != (sides[b] >= 0.0))
      {
        polygon.push_back(getCut(a, b));
      }
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      left.insert(left.end(), { polygon[0], polygon[i - 1], polygon[i] });
    }
  }
  triangles = std::move(left);
}
}

bool vtkShadowCaster::Update(
  vtkPolyData* mesh, const std::array<double, 16>& toWorld, const std::vector<Plane>& planes)
{
  const bool newMesh = this->Mesh != mesh || this->MeshTime != mesh->GetMTime();
  if (newMesh)
  {
    this->MeshTopology = MakeTopology(mesh);
    this->Mesh = mesh;
    this->MeshTime = mesh->GetMTime();
  }
  if (!newMesh && planes == this->Planes && toWorld == this->ToWorld)
  {
    return false;
  }
  this->ToWorld = toWorld;
  this->Planes = planes;
  this->Topology = this->MeshTopology;
  this->Points = this->Topology->GetPoints();
  for (std::size_t k = 0; k < this->Points.size(); k += 3)
  {
    double x[4] = { this->Points[k], this->Points[k + 1], this->Points[k + 2], 1.0 };
    vtkMatrix4x4::MultiplyPoint(toWorld.data(), x, x);
    for (int i = 0; i < 3; ++i)
    {
      this->Points[k + i] = x[i] / x[3];
    }
  }
  if (!planes.empty())
  {
    std::vector<vtkIdType> triangles(
      this->Topology->GetTriangles().begin(), this->Topology->GetTriangles().end());
    for (const Plane& plane : planes)
    {
      Clip(this->Points, triangles, plane);
    }
    auto clipped = std::make_shared<vtkShadowTopology>();
    clipped->Build(this->Points.data(), static_cast<vtkIdType>(this->Points.size() / 3),
      triangles.data(), static_cast<vtkIdType>(triangles.size() / 3));
    this->Points = clipped->GetPoints();
    this->Topology = clipped;
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Bounds[2 * i] = HUGE_VAL;
    this->Bounds[2 * i + 1] = -HUGE_VAL;
    for (std::size_t k = i; k < this->Points.size(); k += 3)
    {
      this->Bounds[2 * i] = std::min(this->Bounds[2 * i], this->Points[k]);
      this->Bounds[2 * i + 1] = std::max(this->Bounds[2 * i + 1], this->Points[k]);
    }
  }
  this->Slots.clear();
  return true;
}

bool vtkShadowCaster::Meets(const double bounds[6]) const
{
  const double* b = this->Bounds;
  return bounds[1] >= b[0] && bounds[0] <= b[1] && bounds[3] >= b[2] && bounds[2] <= b[3] &&
    bounds[5] >= b[4] && bounds[4] <= b[5];
}

bool vtkShadowCaster::IsAround(const vtkShadowLight& light) const
{
  const double* x = light.Position;
  const double point[6] = { x[0], x[0], x[1], x[1], x[2], x[2] };
  return light.IsPositional() && this->Meets(point);
}

const std::vector<vtkShadowCaster::Part>& vtkShadowCaster::GetParts(std::size_t slot,
  const vtkShadowLight& light, const vtkShadowLightSpace& frame, const double nearBounds[6],
  int& built)
{
  if (slot >= this->Slots.size())
  {
    this->Slots.resize(slot + 1);
  }
  Slot& cached = this->Slots[slot];
  // A light in the bounds may be inside the caster, where no triangle faces it; and where the
  // inside is seen, it is in shadow.
  const vtkShadowCounting counting = this->IsAround(light) || this->Meets(nearBounds)
    ? vtkShadowCounting::All
    : vtkShadowCounting::Away;
  if (!cached.Valid || !(cached.Light == light) || cached.Counting != counting)
  {
    cached.Parts.clear();
    cached.Light = light;
    cached.Counting = counting;
    cached.Valid = true;
    Part whole;
    whole.Topology = this->Topology;
    this->AddPart(cached, std::move(whole), frame, counting);
    ++built;
  }
  return cached.Parts;
}

void vtkShadowCaster::Prefetch() const
{
  vtkNBufferForEachProp::Fetch(this->Bounds);
  vtkNBufferForEachProp::Fetch(&this->Slots);
}

void vtkShadowCaster::Part::Prefetch() const
{
  vtkNBufferForEachProp::Fetch(&this->Silhouette);
  vtkNBufferForEachProp::Fetch(this->Footprint.P);
  vtkNBufferForEachProp::Fetch(this->Footprint.Bounds + 2);
}

void vtkShadowCaster::PrefetchParts(std::size_t slot) const
{
  if (slot < this->Slots.size())
  {
    vtkNBufferForEachProp::Fetch(&this->Slots[slot].Light);
    vtkNBufferForEachProp::Fetch(&this->Slots[slot].Parts);
  }
}

void vtkShadowCaster::AddPart(
  Slot& slot, Part part, const vtkShadowLightSpace& frame, vtkShadowCounting counting) const
{
  const double* points = GetPoints(*this, part);
  part.Silhouette.Compute(*part.Topology, points, slot.Light, counting);
  const int triangles = part.Topology->GetNumberOfTriangles();
  if (part.Silhouette.GetMaximumCount() > MaximumCount && triangles > 1)
  {
    const std::vector<double> all(points, points + 3 * part.Topology->GetNumberOfPoints());
    const int middle = triangles / 2;
    for (const auto& [begin, end] : { std::pair(0, middle), std::pair(middle, triangles) })
    {
      Part half;
      half.Topology = MakeTopology(*part.Topology, all, begin, end);
      half.Points = half.Topology->GetPoints();
      this->AddPart(slot, std::move(half), frame, counting);
    }
    return;
  }
  part.Footprint = vtkShadowFootprint::Make(part.Silhouette, points, frame);
  slot.Parts.push_back(std::move(part));
}
VTK_ABI_NAMESPACE_END
