// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowFootprint.h
 * @brief The space that a caster takes up in light coordinates and in the world. No OpenGL.
 *
 *            light                    The rays p0 <= p <= p1, q0 <= q <= q1 hold whatever
 *           /  :  \                   the caster shadows, at depths beyond near.
 *      ----/---:---\-----  near
 *         /  +---+  \
 *        /   |   |   \                (vtkShadowLight.h explains p, q and s.)
 *       /    +---+    \
 *      --------------------  far
 *     p0               p1
 */
#ifndef vtkShadowFootprint_h
#define vtkShadowFootprint_h

#include "vtkNBufferForEachProp.h"
#include "vtkShadowBlock.h"
#include "vtkShadowLight.h"
#include "vtkShadowSilhouette.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN

struct vtkShadowFootprint
{
  /// Returns the footprint of all these points.
  template <typename Points>
  static vtkShadowFootprint Make(const Points& points, const vtkShadowLightSpace& space)
  {
    vtkShadowFootprint result;
    for (const glm::dvec3& point : points)
    {
      result.Add(point, space);
    }
    return result;
  }

  /// Returns the footprint of the triangles that count (vtkShadowSilhouette.h), and of no others.
  /// `points` must be those that the silhouette was computed with.
  static vtkShadowFootprint Make(const vtkShadowSilhouette& silhouette,
    const vtkShadowPoints& points, const vtkShadowLightSpace& space)
  {
    vtkShadowFootprint result;
    for (const int corner : silhouette.GetTriangles())
    {
      result.Add(points[corner], space);
    }
    return result;
  }

  /// Widens the footprint to hold a point.
  void Add(const glm::dvec3& point, const vtkShadowLightSpace& space)
  {
    this->Block.Add(space.ToLight(point));
    this->Bounds.Add(point);
  }

  vtkShadowBlock Bounds; ///< The box around the points in world coordinates.
  /// The box around them in light coordinates. For a positional light its p and q mean nothing if
  /// its least s is not positive.
  vtkShadowBlock Block;
};

/// A caster, or some of its triangles, as one light sees it.
struct vtkShadowPart
{
  /// Makes the processor load into its cache what vtkShadowPlan::EarlyOut() will read.
  void Prefetch() const
  {
    vtkNBufferForEachProp::Fetch(&this->Footprint.Block);
    vtkNBufferForEachProp::Fetch(&this->Silhouette);
  }

  /// The rounding for which its volume is pushed (vtkShadowCounter.h).
  double GetPushedRounding() const
  {
    return this->Silhouette.GetCounting() == vtkShadowCounting::All ? this->Rounding : 0.0;
  }

  vtkShadowFootprint Footprint;   ///< The footprint of the triangles that count.
  vtkShadowSilhouette Silhouette; ///< The triangles that count, and their outline.
  ///@{
  /// What the silhouette was computed with. The points are in world coordinates and belong to the
  /// caster or to the topology.
  const vtkShadowPoints* Points = nullptr;
  std::shared_ptr<const vtkShadowTopology> Topology = nullptr;
  ///@}
  double Rounding = 0.0; ///< How far off VTK may draw the caster, in world units; 0 if not far.
};

VTK_ABI_NAMESPACE_END
#endif
