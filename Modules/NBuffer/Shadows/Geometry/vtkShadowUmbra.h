// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowUmbra
 * @brief Where a caster's shadow can reach, in light coordinates. No OpenGL.
 *
 * A point P is in shadow of a caster if the segment from the light to P crosses a triangle that
 * counts (vtkShadowSilhouette.h). Then of one of these triangles
 *
 *  - the ray of P is one of its rays: in p and q, P lies in the triangle;
 *  - P is no nearer to the light than its nearest corner: s >= near;
 *  - P lies beyond its plane: a segment crosses a plane once, from the light's side to the other.
 *
 * So what is not all of that for the same triangle is not in shadow of the caster, whatever its
 * shape: its lit side, where the triangles that face away count, what the light meets before it,
 * and what lies in the corner of a building with wings. The planes of a ground that has a thickness
 * are those below and beside it: it shadows nothing that stands on it.
 *
 * Triangles are asked one by one where there are at most 64 that count. Of more, the ranges of p, q
 * and s are asked, and whether P lies beyond any of the planes if there are at most 64 of these,
 * triangle after triangle in one plane being one; of a sphere planes would say little more than its
 * nearest corner.
 *
 * Two more kinds of receivers need no shadow, but are not told from others here: those whose
 * surface faces away from the light, and those on the caster's own unlit side. Depth alone is not
 * enough to be certain, and shading is not known here. Normals are interpolated, and turned towards
 * the camera, so that a facet that faces away may be lit in part; and a sample as deep as an unlit
 * facet may be of something else just before it, a relief or a poster on a wall, whose light that
 * wall has to take away.
 */
#ifndef vtkShadowReach_h
#define vtkShadowReach_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowLight.h"
#include "vtkShadowSilhouette.h"
#include "vtkShadowTiles.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowUmbra
{
public:
  static constexpr std::size_t MaximumFacets = 64; ///< Triangles, or planes.

  /**
   * In the coordinates of `frame`, whose light must be the silhouette's. `points`: those that the
   * silhouette was computed with. `rays`: p and q of the triangles that count, infinite where they
   * have none; s in it from their nearest corner on.
   */
  vtkShadowUmbra(const vtkShadowSilhouette& silhouette, const double* points,
    const vtkShadowLightSpace& frame, const vtkShadowBlock& rays);

  /// False if no point in the block is on one of the rays, at any depth.
  bool MeetsRays(const vtkShadowBlock& block) const;

  /// False if no point in the block is in shadow.
  bool MayShadow(const vtkShadowBlock& block) const;

  ///@{
  /// The same of a tile.
  bool MeetsRays(const vtkShadowTiles::Layers& tile) const
  {
    return this->MeetsRays(tile[0]) || this->MeetsRays(tile[1]);
  }
  bool MayShadow(const vtkShadowTiles::Layers& tile) const
  {
    return this->MayShadow(tile[0]) || this->MayShadow(tile[1]);
  }
  ///@}

private:
  /// a p + b q + c s - d, or s (a p + b q + c) - d for positional lights: > 0 beyond it.
  using Plane = std::array<double, 4>;

  /// A triangle that counts.
  struct Facet
  {
    Plane Beyond;
    vtkShadowBlock Rays; ///< Around its corners.
    /// a p + b q <= c inside; a = b = c = 0 of sides that say nothing.
    std::array<std::array<double, 3>, 3> Sides;
  };

  void AddFacets(
    const std::vector<int>& corners, const double* points, const vtkShadowLightSpace& frame);
  void AddPlanes(
    const std::vector<int>& corners, const double* points, const vtkShadowLightSpace& frame);
  static bool Meets(const vtkShadowBlock& block, const Facet& facet);
  bool IsBefore(const vtkShadowBlock& block, const Plane& plane) const;

  bool Positional;
  vtkShadowBlock Rays;
  std::vector<Facet> Facets; ///< None: not asked one by one.
  std::vector<Plane> Planes; ///< None: not asked.
};

VTK_ABI_NAMESPACE_END
#endif
