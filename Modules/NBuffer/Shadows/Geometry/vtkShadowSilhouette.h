// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowSilhouette
 * @brief A caster as one light sees it: the triangles that count, and their outline. No OpenGL.
 *
 * A point P is in shadow of a caster if m(P) is not 0, m being the number of the caster's triangles
 * that count and that the open segment from the light to P crosses:
 *
 *  - of closed casters the triangles that face away from the light count (1 beyond a convex
 *    caster): a shadow begins where the light would leave the caster. Inside of it nothing is seen,
 *    and on its lit surface, where a cap of the volume would lie in the surface itself, there is no
 *    cap;
 *  - with a light inside the caster, where its inside is seen (the near plane cuts it), or of an
 *    open or badly wound mesh, all triangles count, each turned towards the light (2 beyond a
 * convex caster).
 *
 * Both agree on what is in shadow outside of the caster and on its lit surface.
 *
 * The outline is the edges whose signed uses by the triangles counted do not cancel, with the
 * number of uses that are left over: the multiplicity of the sides that a volume has there. Meshes
 * need not be manifold.
 *
 * One stored sign for each triangle decides everything (vtkShadowLight::GetFacing); triangles seen
 * edge-on have sign 0 and do not count.
 *
 * A silhouette lasts as long as mesh, matrix and light do; cameras and receivers have no part in
 * it.
 */
#ifndef vtkShadowSilhouette_h
#define vtkShadowSilhouette_h

#include "vtkShadowLight.h"
#include "vtkShadowTopology.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Which triangles m(P) counts, each turned towards the light.
enum class vtkShadowCounting
{
  Away, ///< Those that face away from it; closed meshes with the light outside only.
  All   ///< All.
};

class VTKNBUFFER_EXPORT vtkShadowSilhouette
{
public:
  struct Edge
  {
    int From = 0;         ///< Merged points: the counted triangle lies to the left of From -> To
    int To = 0;           ///< as the light sees it.
    int Multiplicity = 0; ///< Uses left over, > 0.
  };

  /**
   * `points`: world coordinates of the topology's merged points, xyz each, moved by an invertible
   * affine matrix. `counting` Away is replaced by All unless the topology is closed. Components of
   * closed meshes that are wound inside out in world coordinates are turned round.
   */
  void Compute(const vtkShadowTopology& topology, const double* points, const vtkShadowLight& light,
    vtkShadowCounting counting);

  vtkShadowCounting GetCounting() const { return this->Counting; }

  /// The triangles counted: three merged points each, anticlockwise as seen from the light.
  const std::vector<int>& GetTriangles() const { return this->Triangles; }
  const std::vector<Edge>& GetEdges() const { return this->Edges; }

  /**
   * An upper bound of m(P), for the stencil's range: the largest number of triangles counted over a
   * cell of a grid in the light's view, all of them if the caster is around the light; at most 1
   * (Away) or 2 (All) for meshes that are proven to be convex.
   */
  int GetMaximumCount() const { return this->MaximumCount; }

  /**
   * Where lit triangles count (All), by how much beyond each merged point, along its light ray, the
   * volume begins: xyz each, world; empty otherwise.
   *
   * The near cap lies in the lit surface, which is drawn by VTK with other roundings: both are cut
   * at the borders of the view with errors in proportion to the whole triangle. A quad of 14 km was
   * seen 3.5 mm off its plane, 2^-22 of its size. Sixteen times that, along the normal, keeps the
   * surface on the lit side; what is nearer behind it is lit. For triangles of the size of the view
   * this is far below a step of depth.
   */
  const std::vector<double>& GetPushes() const { return this->Pushes; }

private:
  void ComputePushes(
    const vtkShadowTopology& topology, const double* points, const vtkShadowLight& light);

  vtkShadowCounting Counting = vtkShadowCounting::All;
  std::vector<int> Triangles;
  std::vector<Edge> Edges;
  std::vector<double> Pushes;
  int MaximumCount = 0;
};

VTK_ABI_NAMESPACE_END
#endif
