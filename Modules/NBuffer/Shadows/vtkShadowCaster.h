// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCaster
 * @brief One mesh that throws shadows, in the world, and its silhouettes for the lights.
 *
 * A caster is a polydata (a block of a composite data set is one by itself) under one matrix. Its
 * triangles are those that the mapper draws: VTK's own functions make them.
 *
 * What is cached lasts as long as what it was made from:
 *
 *     topology     the mesh (modification time of the data)
 *     points       topology, matrix and clipping planes, value by value
 *     silhouettes  points, and the light in world coordinates
 *
 * Clipping planes of the mapper cut the triangles; what is cut stays open, as it is drawn.
 *
 * A stencil counts to 255. Where more triangles of a caster than that may lie between a light and a
 * receiver, its triangles are shared out among several parts, which are drawn one by one: counts
 * add up over triangles.
 */
#ifndef vtkShadowCaster_h
#define vtkShadowCaster_h

#include "vtkShadowLight.h"
#include "vtkShadowPlan.h"
#include "vtkShadowSilhouette.h"
#include "vtkShadowTopology.h"

#include <array>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkPolyData;

class vtkShadowCaster
{
public:
  static constexpr int MaximumCount = 255;

  /// For one light: which part of the mesh, its silhouette, and what it takes up.
  struct Part
  {
    std::shared_ptr<const vtkShadowTopology> Topology;
    std::vector<glm::dvec3> Points; ///< World; empty: those of the caster.
    vtkShadowSilhouette Silhouette;
    vtkShadowFootprint Footprint;

    /// Have the processor fetch what vtkShadowPlan::EarlyOut() will read.
    void Prefetch() const;
  };

  /// A plane that keeps the side to which its normal points: a x + b y + c z + d >= 0 in the world.
  using Plane = std::array<double, 4>;

  /// Bring mesh, matrix and planes up to date. Returns whether anything has changed.
  bool Update(vtkPolyData* mesh, vtkMatrix4x4* matrix, const std::vector<Plane>& planes);

  /// World coordinates of the merged points.
  const std::vector<glm::dvec3>& GetPoints() const { return this->Points; }
  const std::vector<int>& GetTriangles() const { return this->Topology->GetTriangles(); }
  int GetNumberOfTriangles() const { return this->Topology->GetNumberOfTriangles(); }

  /**
   * The parts for a light, usually one. `slot` names the light: 0, 1, 2, ... `nearBounds` are those
   * of the near plane's rectangle: the inside of a caster that it meets may be seen. `built` is
   * raised by the number of silhouettes that were not cached.
   */
  const std::vector<Part>& GetParts(std::size_t slot, const vtkShadowLight& light,
    const vtkShadowLightSpace& frame, const vtkShadowBlock& nearBounds, int& built);

  ///@{
  /// Have the processor fetch what GetParts() will read; first this, then what it refers to.
  void Prefetch() const;
  void PrefetchParts(std::size_t slot) const;
  ///@}

  static const std::vector<glm::dvec3>& GetPoints(const vtkShadowCaster& caster, const Part& part)
  {
    return part.Points.empty() ? caster.Points : part.Points;
  }

private:
  struct Slot
  {
    vtkShadowLight Light;
    vtkShadowCounting Counting = vtkShadowCounting::All;
    bool Valid = false;
    std::vector<Part> Parts;
  };

  bool Meets(const vtkShadowBlock& bounds) const;
  bool IsAround(const vtkShadowLight& light) const;
  void AddPart(
    Slot& slot, Part part, const vtkShadowLightSpace& frame, vtkShadowCounting counting) const;

  const void* Mesh = nullptr; ///< To compare only.
  vtkMTimeType MeshTime = 0;
  std::array<double, 16> Matrix = {};
  std::vector<Plane> Planes;
  std::shared_ptr<const vtkShadowTopology> MeshTopology;
  std::shared_ptr<const vtkShadowTopology> Topology; ///< Of what the planes leave.
  std::vector<glm::dvec3> Points;
  vtkShadowBlock Bounds;
  std::vector<Slot> Slots;
};

VTK_ABI_NAMESPACE_END
#endif
