// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowUmbra
 * @brief Where a caster's shadow can reach, in light coordinates. No OpenGL.
 *
 * A point P is in shadow of a caster if the segment from the light to P crosses a triangle that
 * counts (vtkShadowSilhouette.h). Then all of this holds for one of these triangles:
 *
 *            light
 *             /|\
 *            / | \
 *     near  +  |  \       1. P lies on one of the triangle's rays: in p and q it is inside.
 *           : \|   \      2. P is no nearer to the light than the nearest corner: s >= near.
 *           :  |\   \     3. P lies beyond the triangle's plane: a segment crosses a plane
 *           :  P  \  \       once, from the light's side to the other.
 *           :       \ \
 *           :         +
 *
 * A point for which this holds for no triangle is not in shadow of the caster, whatever the shape
 * of the caster. That leaves out the caster's lit side where triangles that face away count,
 * everything that the light meets before the caster, and what stands in the corner of a building
 * with wings. A ground that has a thickness counts only with its lower side and its walls: it
 * shadows nothing that stands on it.
 *
 * If at most 64 triangles count, each of them is tested. Otherwise the test uses the ranges of p, q
 * and s of all of them, and whether P lies beyond any of their planes if these are at most 64;
 * consecutive triangles in one plane share it. (The planes of a sphere would say little more than
 * its nearest corner.)
 *
 * Two more kinds of receivers need no shadow but are not recognised here: those whose surface faces
 * away from the light, and those on the caster's own unlit side. Depth alone is not enough to be
 * certain, and shading is not known here. Normals are interpolated and turned towards the camera,
 * so that a facet that faces away may be lit in part. And a sample that is as deep as an unlit
 * facet may belong to something just before it, a relief or a poster on a wall, which the wall has
 * to shadow.
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
   * those that the silhouette was computed with. `rays` holds p and q of the triangles that count,
   * infinite where they have none, and depths from their nearest corner on.
   */
  vtkShadowUmbra(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points,
    const vtkShadowLightSpace& space, const vtkShadowBlock& rays);

  /// Returns false if no point in the block is on one of the rays, at any depth.
  bool MeetsRays(const vtkShadowBlock& block) const;

  /// Returns false if no point in the block is in shadow.
  bool MayShadow(const vtkShadowBlock& block) const;

  /// Returns false if no point in either layer of a tile (vtkShadowTiles.h) is on one of the rays.
  bool MeetsRays(const std::array<vtkShadowBlock, 2>& tile) const
  {
    return this->MeetsRays(tile[0]) || this->MeetsRays(tile[1]);
  }

  /// Returns false if no point in either layer of a tile is in shadow.
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
    vtkShadowBlock Rays; ///< The box around its corners.
    /// Its sides as (a, b, c): a point inside has a p + b q <= c. A side is (0, 0, 0) where
    /// rounding does not allow to tell.
    std::array<glm::dvec3, 3> Sides;
  };

  void AddFacets(const std::vector<int>& corners, const vtkShadowPoints& points,
    const vtkShadowLightSpace& space);
  void AddPlanes(const std::vector<int>& corners, const vtkShadowPoints& points,
    const vtkShadowLightSpace& space);
  static bool Meets(const vtkShadowBlock& block, const Facet& facet);
  bool IsBefore(const vtkShadowBlock& block, const Plane& plane) const;

  bool Positional;
  vtkShadowBlock Rays;       ///< The range of rays of all triangles, and their nearest depth.
  std::vector<Facet> Facets; ///< Empty if triangles are not tested one by one.
  std::vector<Plane> Planes; ///< Empty if planes are not tested.
};

VTK_ABI_NAMESPACE_END
#endif
