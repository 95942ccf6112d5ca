// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPixelTest
 * @brief Whether a box or a mesh lies behind every sample that its outline covers. No OpenGL.
 *
 * This is the second opinion on boxes that four lookups did not find hidden. Where the whole depth
 * image is in host memory anyway, looking at the pixels costs far less than drawing a prop for
 * nothing:
 *
 *     +---------------------+      The rectangle of a box also covers what is around its outline
 *     |     .--------.      |      (the sky above a hidden house), and its nearest depth is that
 *     |   .'          `.    |      of one corner. Here only squares that touch the outline count,
 *     |  '--------------'   |      and each is compared with the depth of the box's front faces
 *     +---------------------+      in this square.
 *
 * What counts in a pixel is where the device takes samples. Without multisampling that is its
 * middle alone: a rasteriser draws a fragment only if the middle of the pixel lies in the triangle
 * (OpenGL 4.6, section 14.6.1), and its depth is that in the middle. The outline is wider than the
 * box by what a device may move the corners of triangles, which covers snapping, and a middle
 * exactly on the outline counts as inside, which covers every rule for shared edges. With
 * multisampling the square around the middle counts that holds all samples; smoothed polygons cover
 * each pixel that they touch, so that the whole pixel counts.
 *
 * One lookup in the levels answers a square of 8 x 8 pixels. Only the squares that do not hide
 * their part of the box are looked at pixel by pixel, beginning at the top, where houses, masts and
 * trees stick out. The test stops at the first pixel in which the box may be seen.
 *
 * A mesh is tested in the same way, triangle by triangle, where its box is not hidden. Through the
 * gaps of a fence and between two roofs, boxes are seen and nothing that is in them. With E the
 * error of vertices in pixels, B the border of the box (vtkNBufferBoxError.h), g the slope of the
 * triangle, R its depth range and h its height on the screen, a device draws
 *
 *  - no sample farther than E + B outside of the triangle, in x and in y: the outline,
 *  - no sample nearer than
 *
 *        max(z of the nearest corner, z(x, y) - (|g_x| + |g_y|) (E + B))
 *          - the error of a vertex's depth - (2^-8.5 + 16 u n) R / h
 *
 * where z(x, y) is the plane of the triangle. The first line holds because the depth of a sample is
 * a mean of the corners' depths, with the weights that also make its place of the corners' places,
 * and these are at most E + B away from the exact ones. The last term is that of the slack of a
 * box, with the triangle's own range and height. A triangle lower than 1/16 pixel is compared with
 * its nearest corner alone, and with the slack of its box, so that vtkNBufferSliverTest need not
 * know whether the box or the triangles were hidden.
 */
#ifndef vtkNBufferPixelTest_h
#define vtkNBufferPixelTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferMesh;

class VTKNBUFFER_EXPORT vtkNBufferPixelTest
{
public:
  /**
   * All arguments are kept by reference and must outlive the test. `levels` holds the farthest
   * stored depths of the projection's viewport. `depth` is the depth image that they were made
   * from, row 0 at the bottom. `sampleDistance` is how far from the middle of its pixel a sample
   * may be in x and in y: 0 with one sample, at most 0.5 pixels with more, 0.5 for smoothed
   * polygons.
   */
  vtkNBufferPixelTest(const vtkNBufferProjection& projection, const vtkNBufferLevels& levels,
    const float* depth, double sampleDistance);

  /// True only if nothing of the box can be seen. `screen` is what projection.Project() gave for
  /// the box.
  bool IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);

  /**
   * False only if nothing of a mesh can be seen. `screen` is what projection.Project() gave for its
   * box, which has no Margin and is Inside. `toWorld` is the matrix from the coordinates of the
   * mesh to the world, row by row. The test begins with triangle `first`, of which nothing is
   * expected, and sets it to the triangle that may be seen: given again in the next frame it mostly
   * gives the answer at once.
   */
  bool MayBeSeen(const vtkNBufferMesh& mesh, const double toWorld[16],
    const vtkNBufferScreenBox& screen, std::size_t& first);

  /// The number of texels and pixels read so far.
  long long GetLookups() const { return this->Lookups; }

private:
  /// A half plane of the screen: Normal . (x, y) + Offset > 0 outside of the outline.
  struct Edge
  {
    glm::dvec2 Normal;
    double Offset;
  };

  using Errors = vtkNBufferBoxError::TriangleErrors;
  using Corners = std::array<glm::dvec3, 3>;

  /// The errors of vertices and the border, in pixels.
  glm::dvec2 GetSlack(const vtkNBufferScreenBox& screen) const;
  /// Add an edge with this outward normal, beyond all points of an outline and their slack.
  template <typename Points>
  void AddEdge(const glm::dvec2& normal, const Points& points, const glm::dvec2& slack);
  void SetEdges(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
  void SetOutline(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
  /// The same for a triangle, with x and y in pixels and the order of depth in z.
  void SetOutline(const Corners& corners, const Errors& errors, const glm::dvec2& slack);
  /// Whether nothing can be seen of what the outline covers in a rectangle.
  bool IsHidden(const vtkNBufferRectangle& pixels);
  /// Whether a square around (x, y) lies wholly outside of the outline.
  bool IsOutsideOutline(double x, double y, double halfSide) const;
  /// The nearest depth that the box may have in a square around (x, y).
  double GetNearest(double x, double y, double halfSide) const;
  bool IsSquareHidden(int x, int y, const vtkNBufferRectangle& pixels);

  const vtkNBufferProjection& Projection;
  const vtkNBufferLevels& Levels;
  const float* Depth;
  double SampleDistance;
  int SquareLevel; ///< The level whose texels cover a square of 8 pixels.
  ///@{
  /// What is known of the box or triangle under test: the edges of its outline, the planes of its
  /// front faces, and its nearest depth.
  std::array<Edge, 8> Edges;
  int NumberOfEdges = 0;
  std::array<vtkNBufferProjection::FacePlane, 3> Planes;
  int NumberOfPlanes = 0;
  double Nearest = 0.0;
  ///@}
  long long Lookups = 0;
};

VTK_ABI_NAMESPACE_END
#endif
