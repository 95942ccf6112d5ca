// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSilhouette.h"

#include "vtkShadowOverlap.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/// For each component of a closed mesh whether it is wound inside out: its signed volume is
/// negative. Relative to a corner of the component, where most digits are left.
std::vector<bool> FindInsideOut(const vtkShadowTopology& topology, const double* points)
{
  const std::size_t count = static_cast<std::size_t>(topology.GetNumberOfComponents());
  std::vector<const double*> origins(count, nullptr);
  std::vector<double> volumes(count, 0.0);
  const int* corners = topology.GetTriangles().data();
  for (const int component : topology.GetComponents())
  {
    const double*& origin = origins[component];
    if (!origin)
    {
      origin = points + 3 * corners[0];
    }
    double relative[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(points + 3 * corners[i], origin, relative[i]);
    }
    volumes[component] += vtkMath::Determinant3x3(relative[0], relative[1], relative[2]);
    corners += 3;
  }
  std::vector<bool> insideOut(count);
  std::transform(
    volumes.begin(), volumes.end(), insideOut.begin(), [](double volume) { return volume < 0.0; });
  return insideOut;
}

/// Upper bound of how many of the triangles one ray of the light can meet: as many as have bounding
/// rectangles in light coordinates that overlap, where these exist, or else all.
int BoundOverlap(
  const std::vector<int>& triangles, const double* points, const vtkShadowLight& light)
{
  const int count = static_cast<int>(triangles.size() / 3);
  double axis[3] = { 0.0, 0.0, 0.0 }; // towards the middle, for positional lights
  for (const int corner : triangles)
  {
    double ray[3];
    vtkMath::Subtract(points + 3 * std::size_t(corner), light.Position, ray);
    vtkMath::Add(axis, ray, axis);
  }
  const vtkShadowLightSpace frame =
    light.IsPositional() ? vtkShadowLightSpace(light, axis) : vtkShadowLightSpace(light);
  std::vector<vtkShadowRectangle> rectangles(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    double pqs[3];
    frame.ToLight(points + 3 * std::size_t(triangles[i]), pqs);
    if (light.IsPositional() && !(pqs[2] > 0.0))
    {
      return count; // the caster is around the light
    }
    rectangles[i / 3].Add(pqs);
  }
  return static_cast<int>(vtkShadowOverlap::GetBound(rectangles));
}
}

void vtkShadowSilhouette::Compute(const vtkShadowTopology& topology, const double* points,
  const vtkShadowLight& light, vtkShadowCounting counting)
{
  this->Counting = topology.IsClosed() ? counting : vtkShadowCounting::All;
  this->Triangles.clear();
  this->Edges.clear();
  const bool away = this->Counting == vtkShadowCounting::Away;
  const std::vector<bool> insideOut = away ? FindInsideOut(topology, points) : std::vector<bool>();

  // 1: counts as it is wound, -1: counts the other way round, 0: does not count.
  std::vector<signed char> signs(static_cast<std::size_t>(topology.GetNumberOfTriangles()), 0);
  const int* corners = topology.GetTriangles().data();
  for (std::size_t t = 0; t < signs.size(); ++t, corners += 3)
  {
    const int facing =
      light.GetFacing(points + 3 * corners[0], points + 3 * corners[1], points + 3 * corners[2]);
    if (facing == 0 || (away && (facing > 0) != insideOut[topology.GetComponents()[t]]))
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
  const vtkShadowTopology& topology, const double* points, const vtkShadowLight& light)
{
  constexpr double alongNormal = 0x1p-18; // of a triangle's longest side
  constexpr double leastCosine = 0.125;   // what the light grazes is cut by depth anyway
  this->Pushes.assign(3 * static_cast<std::size_t>(topology.GetNumberOfPoints()), 0.0);
  for (std::size_t t = 0; t < this->Triangles.size(); t += 3)
  {
    const double* corners[3];
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = points + 3 * std::size_t(this->Triangles[t + i]);
    }
    double sides[3][3];
    double longest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(corners[(i + 1) % 3], corners[i], sides[i]);
      longest = std::max(longest, vtkMath::Norm(sides[i]));
    }
    double normal[3];
    vtkMath::Cross(sides[0], sides[1], normal);
    vtkMath::Normalize(normal);
    for (int i = 0; i < 3; ++i)
    {
      double ray[3] = { light.Direction[0], light.Direction[1], light.Direction[2] };
      if (light.IsPositional())
      {
        vtkMath::Subtract(corners[i], light.Position, ray);
        vtkMath::Normalize(ray);
      }
      const double length =
        alongNormal * longest / std::max(std::abs(vtkMath::Dot(normal, ray)), leastCosine);
      double* push = &this->Pushes[3 * std::size_t(this->Triangles[t + i])];
      if (length > vtkMath::Norm(push))
      {
        vtkMath::MultiplyScalar(ray, length);
        std::copy_n(ray, 3, push);
      }
    }
  }
}
VTK_ABI_NAMESPACE_END
