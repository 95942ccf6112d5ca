// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolume
 * @brief The triangles of casters' shadow volumes, whole or clamped to slabs. No OpenGL.
 *
 * The triangles made here bound the set of points P with m(P) > 0 (vtkShadowSilhouette.h). Along
 * any line from outside to P, the front faces (+1) and back faces (-1) add up to m(P).
 *
 *               light
 *             /   |   \
 *            /    |    \
 *           /  +=====+  \      near cap: the triangles that count
 *          /  /:::::::\  \
 *         /  /:::::::::\  \    sides: join the outlines of both caps; each edge has as
 *        /  /:::::::::::\  \   many sides as its multiplicity says
 *       /  +=============+  \  far cap: the near cap turned round and moved away
 *                              from the light
 *
 * If all triangles count (vtkShadowCounting::All), the near cap would lie in the lit surface. It is
 * therefore pushed away from the light (vtkShadowSilhouette::GetPushes).
 *
 * The near and the far corner of each merged point are computed once, and triangles share them by
 * index. So sides and caps fit to the bit, and each piece is watertight. Front faces
 * (anticlockwise) look outwards.
 *
 * ## Whole and clamped
 *
 * The whole volume of a perspective camera reaches to infinity: its far corners have w = 0. All far
 * corners of a directional light are one point, so that the sides are triangles and there is no far
 * cap.
 *
 * A parallel camera projects points at infinity to clip coordinates with w = 0, too. OpenGL does
 * not say whether a triangle with three such corners is drawn: Mesa's llvmpipe does not draw it,
 * NVIDIA's driver does. For a parallel camera the whole volume of a light at L therefore ends
 * beyond everything that the camera can see, which lies in a box: a far corner is L + k (P - L) for
 * the near corner P, so that the far cap is the near cap made k times as large. A visible point on
 * the ray from L through point Q of the caster is L + t (Q - L) with t <= D / d. Here D is the
 * largest distance from L to a point of the box, and d the least distance from L to a triangle that
 * counts. So the volume holds the point if k is at least D / d. Volumes of directional lights have
 * no triangle with three such corners and stay infinite, except where the camera looks along the
 * light (vtkShadowDrawList.h). They then end in a plane across the light beyond the box.
 *
 * A clamped piece is the part of the volume between the planes s = near and s = far
 * (vtkShadowLight.h). It holds the same receivers as the whole volume if all receivers on the
 * caster's rays have depths in this slab. s_far is the depth of the caster's farthest point.
 *
 *         whole            the caster is nearer        the caster reaches
 *                          than the slab               into the slab
 *
 *        +=====+               +-----+                     :     :
 *        |:::::|               |     |  caster    near - - : - - : - -
 *        |:::::|               +-----+                     +=====+      caster
 *        |:::::|    near - - - +=====+ - -                 |:::::|
 *        |:::::|               |:::::|                     |:::::|
 *        v:::::v    far  - - - +=====+ - -         far - - +=====+ - -
 *
 *  - If the whole caster is nearer to the light than the slab (s_far < near), the near cap lies in
 *    the plane s = near and the sides begin there.
 *  - Otherwise the near cap is the caster's own triangles. It is never the plane for some vertices
 *    and the caster for others: a triangle that crosses the plane would be moved beyond its true
 *    surface, and what lies right behind this surface would lose its shadow.
 *
 * The far plane lies beyond the caster (far > s_far); otherwise the sides would run towards the
 * light. A clamped piece always has both caps. A cap in a plane is a fan of triangles, which join
 * each silhouette edge to a common point. (Decoret 2005 projects the triangles that count to the
 * plane instead.) Both kinds of cap have the same winding number everywhere, because they have the
 * same boundary and a plane holds no closed surface.
 */
#ifndef vtkShadowVolume_h
#define vtkShadowVolume_h

#include "vtkShadowBlock.h"
#include "vtkShadowLight.h"
#include "vtkShadowSilhouette.h"

#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// The part of a volume that one call added: a range of its indices, and where its vertices are.
struct vtkShadowPiece
{
  std::size_t GetNumberOfIndices() const { return this->EndIndex - this->FirstIndex; }

  std::size_t FirstIndex = 0;
  std::size_t EndIndex = 0;  ///< The number after that of the last index.
  vtkShadowBlock Points;     ///< The box around its vertices with w = 1, in world coordinates.
  vtkShadowBlock Directions; ///< The box around its vertices with w = 0.
};

class VTKNBUFFER_EXPORT vtkShadowVolume
{
public:
  /**
   * Adds the whole volume of a caster. `points` must be those that the silhouette was computed
   * with. If the volume has to end, `view` is a box, in world coordinates, that holds everything
   * that can be seen: the volume ends beyond it. If `view` is null, the volume is infinite.
   */
  vtkShadowPiece AddWhole(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points,
    const vtkShadowLight& light, const vtkShadowBlock* view = nullptr);

  /**
   * Adds the part of a caster's volume that lies in the slab, see above. `casterFar` is at least
   * the largest depth of its points in `space`. For a positional light the depths of all points
   * must be positive. A slab that ends before the caster does is extended to a little beyond it.
   */
  vtkShadowPiece AddClamped(const vtkShadowSilhouette& silhouette, const vtkShadowPoints& points,
    const vtkShadowLightSpace& space, const vtkShadowSlab& slab, double casterFar);

  /// The world coordinates x, y, z, w of each vertex. w = 1 is a point, w = 0 a direction.
  const std::vector<glm::dvec4>& GetVertices() const { return this->Vertices; }

  /// Three vertices for each triangle.
  const std::vector<unsigned int>& GetIndices() const { return this->Indices; }

private:
  class Image;
  enum class Side
  {
    Near,
    Far
  };

  unsigned int AddVertex(const glm::dvec3& x, double w);
  void AddTriangle(unsigned int a, unsigned int b, unsigned int c);
  void AddTriangles(const vtkShadowSilhouette& silhouette, Image& image, Side side);
  void AddFan(const vtkShadowSilhouette& silhouette, Image& image, Side side);
  void AddSides(const vtkShadowSilhouette& silhouette, Image& nearImage, Image& farImage);

  std::vector<glm::dvec4> Vertices;
  std::vector<unsigned int> Indices;
  vtkShadowPiece Piece; ///< The one that is being added, or was added last.
};

VTK_ABI_NAMESPACE_END
#endif
