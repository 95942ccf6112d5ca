// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowCaster.h
 * @brief Casters with a light; what a shadow volume counts at a point, and what it should count.
 */
#ifndef ShadowCaster_h
#define ShadowCaster_h

#include "ShadowMeshes.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowVolume.h"

#include <limits>
#include <optional>
#include <utility>

/// Makes a light at a position that shines towards a target.
inline vtkShadowLight MakeLight(
  vtkShadowLightKind kind, const Point& position, const Point& target = Point(0.0))
{
  vtkShadowLight light;
  light.Kind = kind;
  light.Position = position;
  light.Direction = vtkNBufferGLM::Normalize(target - position);
  return light;
}

/// Returns the light spaces of a light: those of the six sides of a cube around a point light, or
/// the one along the axis of another light.
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

/// Returns whether the light reaches x if nothing is between: for spots, whether x is in the cone.
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

/// A mesh with what a caster has: its topology, and its silhouette for one light.
struct ShadowCaster
{
  ShadowCaster(const ShadowMesh& mesh, const vtkShadowLight& light,
    vtkShadowCounting counting = vtkShadowCounting::Away)
    : Mesh(mesh)
    , Light(light)
    , Topology(mesh.Points, mesh.Triangles)
  {
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

  /// Returns the part of a volume store for this caster. It refers to the points and the silhouette
  /// of this object.
  vtkShadowPart MakePart() const
  {
    const vtkShadowLightSpace space(this->Light);
    return { vtkShadowFootprint::Make(this->Silhouette, this->GetPoints(), space), this->Silhouette,
      &this->GetPoints() };
  }

  /// Returns the least and the largest light depth of the points.
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

/// Returns how many triangles the open segment from the light to x crosses; if `awayOnly`, how many
/// of those that face away from the light as they are wound. Returns nothing if rounding may decide
/// about one of them.
std::optional<int> CountByBruteForce(
  const ShadowMesh& mesh, const vtkShadowLight& light, const Point& x, bool awayOnly);

/// Returns what the volume counts at x: the crossings of its triangles on a ray from x to infinity,
/// +1 where the ray leaves the volume and -1 where it enters the volume.
int CountInVolume(const vtkShadowVolume& volume, const Point& x, std::mt19937& random);

/// Returns whether the triangles of a volume use each edge equally often in both directions.
bool IsWatertight(const vtkShadowVolume& volume);

#endif
