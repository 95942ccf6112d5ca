// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowSilhouette
 * @brief A caster as one light sees it: the triangles that count, and their outline. No OpenGL.
 *
 * A point P is in shadow of a caster if m(P) is not 0. m(P) is the number of triangles of the
 * caster that the open segment from the light to P crosses, where only some triangles count. (The
 * segment of a directional light comes from infinity.) There are two ways to choose these:
 *
 *      Away: a closed caster,                     All: an open caster,
 *      the light outside                          or the light inside, or its inside is seen
 *
 *            light                                      light
 *             v v                                        v v
 *             +-+    lit side: does not count           =====    counts: m = 1 behind it
 *             | |    inside: m = 0                      :::::
 *             +=+    unlit side: counts                 =====    counts: m = 2 behind it
 *             :::    m = 1: in shadow                   :::::
 *
 *  - Away: the triangles that face away from the light count (m is 1 beyond a convex caster). The
 *    shadow begins where the light would leave the caster. This is correct because nothing inside
 *    of the caster is seen. Its advantage is that no cap of the volume lies in the lit surface.
 *  - All: every triangle counts and is turned towards the light (m is 2 beyond a convex caster).
 *    This is for a light inside the caster, for a caster whose inside is seen because the near
 *    plane cuts it or its front faces are not drawn, and for open or badly wound meshes. It is also
 *    for closed meshes with a component that has no thickness, such as sheets that have each
 *    triangle twice, wound both ways: their unlit side lies in the lit one.
 *
 * Outside of the caster and on its lit surface, the same points are in shadow in both ways.
 *
 * The outline (the silhouette) consists of the edges at which the signed uses by triangles that
 * count do not cancel (vtkShadowTopology.h). The multiplicity of an edge is the number of uses that
 * are left over: a shadow volume has that many sides there. Meshes need not be manifold.
 *
 *      as the light sees it
 *      D-----------C
 *      |         / |     Triangles A B C and A C D count. Edge A C has two uses of opposite
 *      |     /     |     directions, +1 - 1 = 0: it is not in the outline. Each of the others has
 *      | /         |     one use: multiplicity 1, From -> To is A -> B, B -> C, C -> D, D -> A.
 *      A-----------B
 *
 * Triangles and outline follow from one stored sign for each triangle (vtkShadowLight::GetFacing).
 * Triangles that the light sees edge-on have sign 0 and do not count.
 *
 * A silhouette stays valid until the mesh, its matrix or the light changes. It does not depend on
 * cameras and receivers.
 */
#ifndef vtkShadowSilhouette_h
#define vtkShadowSilhouette_h

#include "vtkShadowLight.h"
#include "vtkShadowTopology.h"

#include "vtkTimeStamp.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Which triangles m(P) counts, see above. Each is turned towards the light.
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
   * Computes triangles and outline. `points` are the topology's merged points, moved to world
   * coordinates by an invertible affine matrix. If the topology is not closed, or a component has
   * no thickness, All is used whatever `counting` is. With Away, a component that is wound inside
   * out in world coordinates is treated as if its winding were reversed.
   */
  void Compute(const vtkShadowTopology& topology, const vtkShadowPoints& points,
    const vtkShadowLight& light, vtkShadowCounting counting);

  /// The time of the last Compute() (vtkTimeStamp), or 0 before the first. Two silhouettes with the
  /// same time are copies of each other.
  vtkMTimeType GetMTime() const { return this->ComputeTime.GetMTime(); }

  /// The counting that Compute() used.
  vtkShadowCounting GetCounting() const { return this->Counting; }

  /// The triangles that count: three merged points each, anticlockwise as seen from the light.
  const std::vector<int>& GetTriangles() const { return this->Triangles; }

  /// The edges of the outline.
  const std::vector<Edge>& GetEdges() const { return this->Edges; }

  /**
   * An upper bound of m(P), from which the range of the stencil follows. It is the largest number
   * of triangles that count and touch one cell of a grid over p and q (vtkShadowOverlap.h). If the
   * caster surrounds the light, it is the number of all triangles that count. For meshes that are
   * proven to be convex it is at most 1 (Away) or 2 (All).
   */
  int GetMaximumCount() const { return this->MaximumCount; }

  /**
   * With All, a vector in world coordinates for each merged point, along the ray of the light
   * through the point and away from the light. The near cap consists of the points moved by these
   * vectors. With Away there are no vectors.
   *
   * Without the push the near cap would lie in the lit surface, which VTK draws with other rounding
   * errors: cap and surface are clipped at the borders of the view, with errors in proportion to
   * the whole triangle. A quad of 14 km was drawn 3.5 mm off its plane, which is 2^-22 of its size
   * (commit 075d83b). Measured along the normal, the push is sixteen times that, so that the
   * surface stays lit. What lies behind the surface, but nearer to it than the push, is lit, too.
   * For triangles of the size of the view the push is far smaller than a step of depth.
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
  vtkTimeStamp ComputeTime;
};

VTK_ABI_NAMESPACE_END
#endif
