// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowSilhouette
 * @brief A caster as one light sees it: the triangles that count, and their outline. No OpenGL.
 *
 * A point P is in shadow of a caster if m(P) is not 0. m(P) is the number of the caster's triangles
 * that count and that the open segment from the light to P crosses. Which triangles count:
 *
 *      Away: a closed caster,                     All: an open caster,
 *      the light outside                          or the light or the eye inside
 *
 *            light                                      light
 *             v v                                        v v
 *             +-+    lit side: does not count           =====    counts: m = 1 behind it
 *             | |    inside: m = 0                      :::::
 *             +=+    unlit side: counts                 =====    counts: m = 2 behind it
 *             :::    m = 1: in shadow                   :::::
 *
 *  - Away: the triangles that face away from the light count (m is 1 beyond a convex caster). The
 *    shadow begins where the light would leave the caster. Nothing is seen inside of the caster.
 *    On its lit surface, where a cap would lie in the surface itself, there is no cap.
 *  - All: every triangle counts, each turned towards the light (m is 2 beyond a convex caster).
 *    This is for a light inside the caster, for a caster whose inside is seen because the near
 *    plane cuts it, and for open or badly wound meshes.
 *
 * Both agree on what is in shadow outside of the caster and on its lit surface.
 *
 * The outline (the silhouette) consists of the edges at which the signed uses by triangles that
 * count do not cancel. Its multiplicity is the number of uses that are left over: a shadow volume
 * has that many sides there. Meshes need not be manifold.
 *
 *      as the light sees it
 *      D-----------C
 *      |         / |     Triangles A B C and A C D count. Edge A C has two uses of opposite
 *      |     /     |     directions, +1 - 1 = 0: it is not in the outline. Each of the others has
 *      | /         |     one use: multiplicity 1, From -> To is A -> B, B -> C, C -> D, D -> A.
 *      A-----------B
 *
 * One stored sign for each triangle decides everything (vtkShadowLight::GetFacing). Triangles that
 * the light sees edge-on have sign 0 and do not count.
 *
 * A silhouette stays valid until the mesh, its matrix or the light changes. It does not depend on
 * cameras and receivers.
 */
#ifndef vtkShadowSilhouette_h
#define vtkShadowSilhouette_h

#include "vtkShadowLight.h"
#include "vtkShadowTopology.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Which triangles m(P) counts. Each is turned towards the light.
enum class vtkShadowCounting
{
  Away, ///< Triangles that face away from the light: for closed meshes with the light outside.
  All   ///< All triangles.
};

class VTKNBUFFER_EXPORT vtkShadowSilhouette
{
public:
  /// An edge of the outline. As the light sees it, the triangle that counts lies to the left of the
  /// way from From to To.
  struct Edge
  {
    int From = 0;         ///< The merged point where the edge begins.
    int To = 0;           ///< The merged point where the edge ends.
    int Multiplicity = 0; ///< The number of uses that are left over, greater than 0.
  };

  /**
   * Computes triangles and outline. `points` are the world coordinates of the topology's merged
   * points, moved by an invertible affine matrix. A `counting` of Away is replaced by All unless
   * the topology is closed. Components of closed meshes that are wound inside out in world
   * coordinates are turned round.
   */
  void Compute(const vtkShadowTopology& topology, const vtkShadowPoints& points,
    const vtkShadowLight& light, vtkShadowCounting counting);

  /// The counting that was used.
  vtkShadowCounting GetCounting() const { return this->Counting; }

  /// The triangles that count: three merged points each, anticlockwise as seen from the light.
  const std::vector<int>& GetTriangles() const { return this->Triangles; }

  /// The edges of the outline.
  const std::vector<Edge>& GetEdges() const { return this->Edges; }

  /**
   * An upper bound of m(P), for the range of the stencil. It is the largest number of triangles
   * that count over one cell of a grid in the light's view, or the number of all of them if the
   * caster is around the light. For meshes that are proven to be convex it is at most 1 (Away) or 2
   * (All).
   */
  int GetMaximumCount() const { return this->MaximumCount; }

  /**
   * How far beyond each merged point, along its light ray, the volume begins where lit triangles
   * count (All): one world vector for each point. With Away it is empty.
   *
   * The near cap lies in the lit surface, which VTK draws with other roundings: both are cut at the
   * borders of the view, with errors in proportion to the whole triangle. A quad of 14 km was seen
   * 3.5 mm off its plane, which is 2^-22 of its size (commit 075d83b). The push is sixteen times
   * that, along the normal, and keeps the surface on the lit side. What lies behind the surface but
   * nearer to it than the push is lit. For triangles of the size of the view the push is far below
   * a step of depth.
   */
  const std::vector<glm::dvec3>& GetPushes() const { return this->Pushes; }

private:
  void ComputePushes(
    const vtkShadowTopology& topology, const vtkShadowPoints& points, const vtkShadowLight& light);

  vtkShadowCounting Counting = vtkShadowCounting::All;
  std::vector<int> Triangles;
  std::vector<Edge> Edges;
  std::vector<glm::dvec3> Pushes;
  int MaximumCount = 0;
};

VTK_ABI_NAMESPACE_END
#endif
