// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSilhouette.h"

#include "vtkShadowOverlap.h"

#include <algorithm>
#include <array>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// The least distance between the two sides of a component, and of a cap from the surface in which
/// it would lie, in units of a triangle's longest side; see GetPushes().
constexpr double LeastDistance = 0x1p-18;

/// A component of a closed mesh.
struct Component
{
  bool IsInsideOut() const { return this->Volume < 0.0; }

  /// Whether its two sides are about in the same place: its mean thickness, which is the volume
  /// divided by half of the area, is at most 2/3 of LeastDistance.
  bool IsThin() const
  {
    return std::abs(this->Volume) <= LeastDistance * std::sqrt(this->SquaredSide) * this->Area;
  }

  const glm::dvec3* Origin = nullptr; ///< A corner.
  double Volume = 0.0;                ///< Six times the volume, negative if wound inside out.
  double Area = 0.0;                  ///< Twice the area.
  double SquaredSide = 0.0;           ///< The square of the longest side of a triangle.
};

/// Coordinates are relative to a corner of the component, so that the fewest digits are lost.
std::vector<Component> FindComponents(
  const vtkShadowTopology& topology, const vtkShadowPoints& points)
{
  std::vector<Component> components(static_cast<std::size_t>(topology.GetNumberOfComponents()));
  const int* corners = topology.GetTriangles().data();
  for (const int number : topology.GetComponents())
  {
    Component& component = components[static_cast<std::size_t>(number)];
    const glm::dvec3& a = points[corners[0]];
    const glm::dvec3 u = points[corners[1]] - a;
    const glm::dvec3 v = points[corners[2]] - a;
    const glm::dvec3 normal = glm::cross(u, v);
    component.Origin = component.Origin ? component.Origin : &a;
    component.Volume += glm::dot(a - *component.Origin, normal);
    component.Area += glm::length(normal);
    component.SquaredSide =
      std::max({ component.SquaredSide, glm::dot(u, u), glm::dot(v, v), glm::dot(u - v, u - v) });
    corners += 3;
  }
  return components;
}

/// See GetMaximumCount().
int BoundOverlap(
  const std::vector<int>& triangles, const vtkShadowPoints& points, const vtkShadowLight& light)
{
  const int count = static_cast<int>(triangles.size() / 3);
  glm::dvec3 axis(0.0); // towards the middle, for positional lights
  for (const int corner : triangles)
  {
    axis += points[corner] - light.Position;
  }
  const vtkShadowLightSpace space =
    light.IsPositional() ? vtkShadowLightSpace(light, axis) : vtkShadowLightSpace(light);
  std::vector<vtkShadowOverlap::Item> items(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const glm::dvec3 pqs = space.ToLight(points[triangles[i]]);
    if (light.IsPositional() && !(pqs[2] > 0.0))
    {
      return count; // The caster is around the light.
    }
    items[i / 3].Rays.Add(pqs);
  }
  return static_cast<int>(vtkShadowOverlap::GetBound(items));
}
}

void vtkShadowSilhouette::Compute(const vtkShadowTopology& topology, const vtkShadowPoints& points,
  const vtkShadowLight& light, vtkShadowCounting counting)
{
  this->ComputeTime.Modified();
  this->Triangles.clear();
  this->Edges.clear();
  bool away = topology.IsClosed() && counting == vtkShadowCounting::Away;
  const std::vector<Component> components =
    away ? FindComponents(topology, points) : std::vector<Component>();
  away = away &&
    std::none_of(components.begin(), components.end(),
      [](const Component& component) { return component.IsThin(); });
  this->Counting = away ? vtkShadowCounting::Away : vtkShadowCounting::All;

  // 1: the triangle counts as it is wound, -1: it counts the other way round, 0: it does not count.
  std::vector<signed char> signs(static_cast<std::size_t>(topology.GetNumberOfTriangles()), 0);
  const int* corners = topology.GetTriangles().data();
  for (std::size_t t = 0; t < signs.size(); ++t, corners += 3)
  {
    const int facing = light.GetFacing(points[corners[0]], points[corners[1]], points[corners[2]]);
    if (facing == 0 ||
      (away && (facing > 0) != components[topology.GetComponents()[t]].IsInsideOut()))
    {
      continue;
    }
    signs[t] = static_cast<signed char>(facing);
    this->Triangles.push_back(corners[0]);
    this->Triangles.push_back(corners[facing > 0 ? 1 : 2]);
    this->Triangles.push_back(corners[facing > 0 ? 2 : 1]);
  }

  for (const vtkShadowTopology::Edge& edge : topology.GetEdges())
  {
    int left = 0;
    for (int u = edge.First; u < edge.First + edge.Count; ++u)
    {
      const vtkShadowTopology::Use& use = topology.GetUses()[u];
      left += use.Direction * signs[use.Triangle];
    }
    if (left > 0)
    {
      this->Edges.push_back({ edge.A, edge.B, left });
    }
    else if (left < 0)
    {
      this->Edges.push_back({ edge.B, edge.A, -left });
    }
  }

  this->Pushes.clear();
  if (!away)
  {
    this->ComputePushes(topology, points, light);
  }
  const int count = static_cast<int>(this->Triangles.size() / 3);
  this->MaximumCount = topology.IsConvex() ? std::min(count, away ? 1 : 2)
                                           : BoundOverlap(this->Triangles, points, light);
}

void vtkShadowSilhouette::ComputePushes(
  const vtkShadowTopology& topology, const vtkShadowPoints& points, const vtkShadowLight& light)
{
  constexpr double leastCosine = 0.125; // Where rays graze, the depth test cuts volumes anyway.
  this->Pushes.assign(static_cast<std::size_t>(topology.GetNumberOfPoints()), glm::dvec3(0.0));
  for (std::size_t t = 0; t < this->Triangles.size(); t += 3)
  {
    const std::array<glm::dvec3, 3> corners = { points[this->Triangles[t]],
      points[this->Triangles[t + 1]], points[this->Triangles[t + 2]] };
    const glm::dvec3 sides[3] = { corners[1] - corners[0], corners[2] - corners[1],
      corners[0] - corners[2] };
    const double longest =
      std::max({ glm::length(sides[0]), glm::length(sides[1]), glm::length(sides[2]) });
    const glm::dvec3 normal = vtkNBufferGLM::Normalize(glm::cross(sides[0], sides[1]));
    for (std::size_t i = 0; i < 3; ++i)
    {
      const glm::dvec3 ray = light.IsPositional()
        ? vtkNBufferGLM::Normalize(corners[i] - light.Position)
        : light.Direction;
      const double length =
        LeastDistance * longest / std::max(std::abs(glm::dot(normal, ray)), leastCosine);
      glm::dvec3& push = this->Pushes[static_cast<std::size_t>(this->Triangles[t + i])];
      if (length > glm::length(push))
      {
        push = ray * length;
      }
    }
  }
}
VTK_ABI_NAMESPACE_END
