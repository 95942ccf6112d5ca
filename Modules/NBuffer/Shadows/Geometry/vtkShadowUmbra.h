// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowUmbra
 * @brief Where a caster's shadow can reach, in light coordinates. No OpenGL.
 *
 * A point P is in shadow of a caster if the segment from the light to P crosses a triangle that
 * counts (vtkShadowSilhouette.h). Then all three of these conditions hold for such a triangle:
 *
 *            light
 *             /|\
 *            / | \
 *     near  +  |  \       1. P lies on one of the triangle's rays: its (p, q) is inside.
 *           : \|   \      2. P is no nearer to the light than the nearest corner: s >= near.
 *           :  |\   \     3. P lies beyond the triangle's plane: a segment crosses a plane
 *           :  P  \  \       once, from the light's side to the other.
 *           :       \ \
 *           :         +
 *
 * A point for which no triangle fulfils all three is not in shadow of the caster, whatever the
 * caster's shape. This excludes the caster's own lit side (if the triangles that face away count),
 * everything that the light meets before the caster, and what stands between the wings of a
 * building. It also excludes what stands on a ground that has a thickness: only the lower side and
 * the walls of such a ground count.
 *
 * If at most 64 triangles count, and the rays of the caster are known, each of them is tested.
 * Otherwise conditions 1 and 2 are tested with the ranges of p, q and s of all triangles together.
 * Condition 3 is then tested only if the triangles have at most 64 planes: P must lie beyond one of
 * them. Consecutive triangles in one plane share it. (The planes of a sphere would say little more
 * than its nearest corner.)
 *
 * Two more kinds of receivers could do without a shadow, but depth alone cannot identify them with
 * certainty. The first are receivers whose surface faces away from the light: VTK interpolates
 * normals and turns them towards the camera, so that such a facet may be lit in part. The second
 * are receivers on the caster's own unlit side: a sample as deep as an unlit facet may belong to
 * something just before the facet (a relief or a poster on a wall), which the wall has to shadow.
 */
#ifndef vtkShadowUmbra_h
#define vtkShadowUmbra_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowBlock.h"
#include "vtkShadowLight.h"
#include "vtkShadowSilhouette.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowUmbra
{
public:
  /// The largest number of triangles that are tested one by one, and of planes otherwise.
  static constexpr std::size_t MaximumFacets = 64;

  /**
   * The umbra in the coordinates of `space`, whose light must be the silhouette's. `points` must be
   * those that the silhouette was computed with. `rays` bounds the umbra. In p and q it holds the
   * triangles that count, and is infinite if they have no such coordinates. In s it begins at their
   * nearest corner or later, and ends at infinity or where shadows are of no interest.
   */
  vtkShadowUmbra(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points,
    const vtkShadowLightSpace& space, const vtkShadowBlock& rays);

  /// Returns false if no point in the block is on one of the rays, at any depth.
  bool MeetsRays(const vtkShadowBlock& block) const;

  /// Returns false if no point in the block, at the depths of `rays`, is in shadow.
  bool MayShadow(const vtkShadowBlock& block) const;

  /// Returns false if no point in either layer of a tile (vtkShadowTiles.h) is on one of the rays.
  bool MeetsRays(const std::array<vtkShadowBlock, 2>& tile) const
  {
    return this->MeetsRays(tile[0]) || this->MeetsRays(tile[1]);
  }

  /// Returns false if no point in either layer of a tile, at the depths of `rays`, is in shadow.
  bool MayShadow(const std::array<vtkShadowBlock, 2>& tile) const
  {
    return this->MayShadow(tile[0]) || this->MayShadow(tile[1]);
  }

private:
  /// The plane of a triangle as (a, b, c, d). A point lies beyond it if a p + b q + c s - d > 0, or
  /// for positional lights s (a p + b q + c) - d > 0.
  using Plane = glm::dvec4;

  /// A triangle that counts.
  struct Facet
  {
    Plane Beyond;        ///< Its plane.
    vtkShadowBlock Rays; ///< The box around its corners in light coordinates.
    /// Its sides as (a, b, c): a point inside has a p + b q <= c. A side is (0, 0, 0), and excludes
    /// nothing, if rounding leaves open on which side of it the triangle lies.
    std::array<glm::dvec3, 3> Sides;
  };

  /// Returns false if no point in the block is on a ray of the facet.
  static bool Meets(const vtkShadowBlock& block, const Facet& facet);
  /// Returns true if no point in the block lies beyond the plane.
  bool IsBefore(const vtkShadowBlock& block, const Plane& plane) const;

  bool Positional;
  vtkShadowBlock Rays;       ///< What the constructor was given.
  std::vector<Facet> Facets; ///< Empty if triangles are not tested one by one.
  std::vector<Plane> Planes; ///< Empty if planes are not tested.
};

VTK_ABI_NAMESPACE_END
#endif
