// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolume
 * @brief The triangles of casters' shadow volumes, whole or clamped to slabs. No OpenGL.
 *
 * The triangles made here bound the set of points P with m(P) > 0 (vtkShadowSilhouette.h) so that,
 * counted with sign along any line from outside, they add up to m(P):
 *
 *  - the near cap is the triangles counted, pushed away from the light by what rounding may do to
 *    them where they are lit themselves (vtkShadowSilhouette::GetPushes);
 *  - the far cap is the same turned round and moved away from the light;
 *  - the sides join the outlines of both, once for each use of an edge that is left over.
 *
 * Every corner of a volume is computed once per merged point and shared by index, so that sides and
 * caps fit to the bit and each piece is watertight.
 *
 * ## Whole and clamped
 *
 * The whole volume reaches to infinity: corners with w = 0. For a directional light all of its far
 * cap is one point, so that sides are triangles and there is no far cap.
 *
 * A clamped piece is what lies between the planes s = near and s = far (vtkShadowLight.h). It holds
 * the same receivers as the whole volume if all receivers in the caster's footprint have depths in
 * the slab. Its near cap is
 *  - the plane, if the whole caster is nearer to the light (s_far < near): sides begin there, or
 *  - the caster's own triangles otherwise: the piece then begins at the caster. Never vertex by
 *    vertex: a triangle that crosses the plane would be moved beyond its true surface and unshadow
 *    what lies right behind it.
 * The far plane lies beyond the caster (far > s_far), else it would extrude backwards. Both caps
 * are always there. Plane caps may be fans: in a plane, the triangles' images and a fan from any
 * point over the silhouette edges have the same winding number everywhere, because they have the
 * same boundary and a plane holds no closed surface.
 *
 * Front faces (anticlockwise) look outwards.
 */
#ifndef vtkShadowVolume_h
#define vtkShadowVolume_h

#include "vtkShadowLight.h"
#include "vtkShadowSilhouette.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// How a plane of a clamped piece is closed.
enum class vtkShadowCap
{
  Triangles, ///< The images of the triangles counted, as in Decoret 2005.
  Fan        ///< One triangle for each silhouette edge, from a common point.
};

/// A slab of light depths, world units along the axis of a vtkShadowLightSpace.
struct vtkShadowSlab
{
  double Near = 0.0;
  double Far = 0.0;
};

class VTKNBUFFER_EXPORT vtkShadowVolume
{
public:
  /// World position that the vertices are relative to (the eye: floats are then fine where it
  /// looks closely). Clears the volume.
  void Begin(const double origin[3]);

  /**
   * Add the whole volume of a caster: near cap, sides and, for positional lights, far cap.
   * `points`: those that the silhouette was computed with.
   */
  void AddWhole(const vtkShadowSilhouette& silhouette, const double* points, int numberOfPoints,
    const vtkShadowLight& light);

  /**
   * Add the part of a caster's volume that lies in the slab, see above. `casterFar`: the largest
   * depth of its points in `frame`, or more. For a positional light the depths of all points must
   * be positive. A slab that ends before the caster does is extended to a little beyond it.
   */
  void AddClamped(const vtkShadowSilhouette& silhouette, const double* points, int numberOfPoints,
    const vtkShadowLightSpace& frame, const vtkShadowSlab& slab, double casterFar,
    vtkShadowCap cap);

  /// x, y, z, w of each vertex. w = 1: a point relative to the origin; w = 0: a direction.
  const std::vector<float>& GetVertices() const { return this->Vertices; }

  /// Three vertices for each triangle.
  const std::vector<unsigned int>& GetIndices() const { return this->Indices; }

private:
  class Image;
  enum class Side
  {
    Near,
    Far
  };

  unsigned int AddVertex(const double x[3], float w);
  void AddTriangle(unsigned int a, unsigned int b, unsigned int c);
  void AddTriangles(const vtkShadowSilhouette& silhouette, Image& image, Side side);
  void AddFan(const vtkShadowSilhouette& silhouette, Image& image, Side side);
  void AddSides(const vtkShadowSilhouette& silhouette, Image& nearImage, Image& farImage);

  double Origin[3] = { 0.0, 0.0, 0.0 };
  std::vector<float> Vertices;
  std::vector<unsigned int> Indices;
};

VTK_ABI_NAMESPACE_END
#endif
