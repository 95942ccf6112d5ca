// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCaster.h
 * @brief Lights and casters of meshes; what a shadow volume counts at a point, and what it should.
 */
#ifndef ShadowCaster_h
#define ShadowCaster_h

#include "ShadowMeshes.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowVolume.h"

#include <limits>
#include <optional>
#include <utility>

inline vtkShadowLight MakeLight(
  vtkShadowLightKind kind, const Point& position, const Point& target = Point(0.0))
{
  vtkShadowLight light;
  light.Kind = kind;
  light.Position = position;
  light.Direction = vtkNBufferGLM::Normalize(target - position);
  return light;
}

/// The six sides of a cube around a light, or its own axis if it is no point light.
inline std::vector<vtkShadowLightSpace> MakeFrames(const vtkShadowLight& light)
{
  if (light.Kind != vtkShadowLightKind::Point)
  {
    return { vtkShadowLightSpace(light) };
  }
  std::vector<vtkShadowLightSpace> frames;
  for (int i = 0; i < 6; ++i)
  {
    Point axis(0.0);
    axis[i / 2] = i % 2 ? -1.0 : 1.0;
    frames.emplace_back(light, axis);
  }
  return frames;
}

/// Whether the light reaches x if nothing is between.
inline bool IsReached(const vtkShadowLight& light, const Point& x)
{
  const Point ray = x - light.Position;
  return light.Kind != vtkShadowLightKind::Spot ||
    glm::dot(ray, light.Direction) >= light.GetConeCosine() * glm::length(ray);
}

/// The inverse of vtkShadowLightSpace::ToLight().
inline Point ToWorld(const vtkShadowLightSpace& space, const Point& pqs)
{
  const double factor = space.IsPositional() ? pqs[2] : 1.0;
  return space.GetApex() + factor * (pqs[0] * space.GetU() + pqs[1] * space.GetV()) +
    pqs[2] * space.GetAxis();
}

/// A mesh as casters are: topology, and a silhouette for one light.
struct ShadowCaster
{
  ShadowCaster(const ShadowMesh& mesh, const vtkShadowLight& light,
    vtkShadowCounting counting = vtkShadowCounting::Away)
    : Mesh(mesh)
    , Light(light)
  {
    this->Topology.Build(mesh.Points, mesh.Triangles);
    this->Silhouette.Compute(this->Topology, this->GetPoints(), light, counting);
  }

  const std::vector<Point>& GetPoints() const { return this->Topology.GetPoints(); }

  void AddWhole(vtkShadowVolume& volume, const vtkShadowBlock* view = nullptr) const
  {
    volume.AddWhole(this->Silhouette, this->GetPoints(), this->Light, view);
  }

  void AddClamped(
    vtkShadowVolume& volume, const vtkShadowLightSpace& frame, const vtkShadowSlab& slab) const
  {
    volume.AddClamped(
      this->Silhouette, this->GetPoints(), frame, slab, this->GetDepths(frame).second);
  }

  /// The part that stands for it, which points to its points.
  vtkShadowPart MakePart() const
  {
    const vtkShadowLightSpace space(this->Light);
    return { vtkShadowFootprint::Make(this->Silhouette, this->GetPoints(), space), this->Silhouette,
      &this->GetPoints() };
  }

  /// The least and the largest depth of its points.
  std::pair<double, double> GetDepths(const vtkShadowLightSpace& frame) const
  {
    double least = std::numeric_limits<double>::infinity();
    double largest = -least;
    for (const Point& point : this->GetPoints())
    {
      least = std::min(least, frame.GetDepth(point));
      largest = std::max(largest, frame.GetDepth(point));
    }
    return { least, largest };
  }

  ShadowMesh Mesh;
  vtkShadowLight Light;
  vtkShadowTopology Topology;
  vtkShadowSilhouette Silhouette;
};

/// Triangles that the open segment from the light to x crosses: all, or the ones that face the
/// light as they are wound. None if that is not certain.
std::optional<int> CountByBruteForce(
  const ShadowMesh& mesh, const vtkShadowLight& light, const Point& x, bool awayOnly);

/// Signed crossings of the triangles of a volume on the way from x to infinity.
int CountInVolume(const vtkShadowVolume& volume, const Point& x, std::mt19937& random);

/// Every directed edge is met by as many of the opposite direction.
bool IsWatertight(const vtkShadowVolume& volume);

#endif
