// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowCaster
 * @brief A mesh that casts shadows, in world coordinates, with its silhouette for each light.
 *
 * A caster is one part of what an actor draws (vtkNBufferSurface::Part), or one instance of a
 * glyph: a polydata under one matrix. Its triangles are those that the mapper draws. The topology
 * of the polydata may be shared by several casters.
 *
 * What is cached here is valid until what it was made from changes:
 *
 *     points       the topology, and the values of the matrix and of the clipping planes
 *     silhouettes  the points, and the light in world coordinates
 *
 * The clipping planes of the mapper cut the triangles. The cut is left open, as VTK draws it. A
 * caster that is cut has a topology of its own.
 *
 * A stencil counts to 255. If more triangles of a caster may lie between a light and a receiver,
 * the triangles are split into several parts, which may be counted one after the other. A receiver
 * is in shadow of the caster if it is in shadow of any part.
 *
 * ## Rounding
 *
 * Volumes are drawn where double precision says, but VTK draws the caster itself with coordinates
 * and matrices of floats. Let u be 2^-24, and m the largest distances of its vertices from the
 * origin of its vertex buffer along the axes. In clip coordinates a vertex is off by at most
 * 6 u (m_x + m_y + m_z): its coordinates, the elements of the matrix and their products are
 * rounded, and so are three sums (vtkNBufferBoxError.h). The position of that origin relative to
 * the eye adds 4 u times its distance, which is as large as m for an eye at the caster, and far
 * less than a pixel for one that is far away. The rounding of a caster is the sum of both, in world
 * units: 10 u (m_x + m_y + m_z) times the scale of the matrix.
 *
 * It matters for meshes that are small compared with their distance from the origin of their
 * coordinates: a room of 8 m at 2 km was wholly in its own shadow. (VTK moves vertices before it
 * rounds them only if the distance is 1000 times the size.) Where it is less than 2^-17 of the
 * caster's size it counts as 0, because the pushes that all casters get suffice then
 * (vtkShadowSilhouette::GetPushes), and more would move the edges of shadows.
 */
#ifndef vtkShadowCaster_h
#define vtkShadowCaster_h

#include "vtkNBufferSurface.h"
#include "vtkShadowFootprint.h"
#include "vtkShadowLight.h"
#include "vtkShadowTopology.h"

#include <array>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKNBUFFER_EXPORT vtkShadowCaster
{
public:
  /// The largest count of a stencil of 8 bits.
  static constexpr int MaximumCount = 255;

  using Plane = vtkNBufferSurface::Plane;

  // Objects cannot be copied, because the cached parts point to the points of their object.
  vtkShadowCaster() = default;
  vtkShadowCaster(const vtkShadowCaster&) = delete;
  void operator=(const vtkShadowCaster&) = delete;

  /// The topology of the triangles that VTK draws for a polydata.
  static std::shared_ptr<const vtkShadowTopology> MakeTopology(vtkPolyData* data);

  /// Brings mesh, matrix (row by row) and clipping planes (in world coordinates) up to date.
  /// Returns whether anything has changed. A mesh that has changed has a new topology.
  bool Update(const std::shared_ptr<const vtkShadowTopology>& mesh,
    const std::array<double, 16>& toWorld, const std::vector<Plane>& planes);

  /// Sets the rounding, see above, from `m` in the coordinates of the mesh. For an instance of a
  /// glyph `actor` is the matrix of the actor, else nullptr. The matrix of the instance rounds its
  /// vertices, too, and how far it moves them from the place of the actor adds to `m`.
  void SetRounding(const glm::dvec3& m, const std::array<double, 16>* actor);

  /// Sets whether the inside of the caster may be seen from everywhere, because its front faces are
  /// not drawn, or have holes. All triangles count then.
  void SetInsideIsSeen(bool seen) { this->InsideIsSeen = seen; }

  /// The merged points in world coordinates.
  const vtkShadowPoints& GetPoints() const { return this->Points; }
  const std::vector<int>& GetTriangles() const { return this->Topology->GetTriangles(); }
  int GetNumberOfTriangles() const { return this->Topology->GetNumberOfTriangles(); }

  /// Brings the parts for a light up to date. `slot` is the number of the light: 0, 1, 2, ... Their
  /// footprints are in `space`. `nearBounds` is vtkShadowCamera::NearBounds: if the caster's bounds
  /// meet it, the inside of the caster may be seen, and all triangles count. Returns true if the
  /// silhouettes were computed, false if they were cached.
  bool UpdateParts(std::size_t slot, const vtkShadowLight& light, const vtkShadowLightSpace& space,
    const vtkShadowBlock& nearBounds);

  /// The parts for a light, usually one.
  const std::vector<vtkShadowPart>& GetParts(std::size_t slot) const
  {
    return this->Slots[slot].Parts;
  }

  ///@{
  /// Make the processor load into its cache what UpdateParts() will read: the caster, then what it
  /// refers to. (With 15,000 casters, planning takes twice as long without this.)
  void Prefetch() const;
  void PrefetchParts(std::size_t slot) const;
  ///@}

private:
  /// What is cached for one light.
  struct Slot
  {
    vtkShadowLight Light;
    vtkShadowCounting Counting = vtkShadowCounting::All;
    std::vector<vtkShadowPart> Parts; ///< Empty before they are computed.
  };

  static void AddPart(Slot& slot, vtkShadowPart part, const vtkShadowLightSpace& space);

  // UpdateParts() reads these three of each caster in each frame. They come first to share cache
  // lines.
  vtkShadowBlock Bounds;
  std::vector<Slot> Slots;
  bool InsideIsSeen = false;
  std::array<double, 16> ToWorld = {};
  std::vector<Plane> Planes;
  double Rounding = 0.0;
  std::shared_ptr<const vtkShadowTopology> MeshTopology;
  std::shared_ptr<const vtkShadowTopology> Topology; ///< The topology after clipping.
  vtkShadowPoints Points;
};

VTK_ABI_NAMESPACE_END
#endif
