// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPixelTest
 * @brief Whether a box or a mesh lies behind every sample that its outline covers. No OpenGL.
 *
 * This test is for boxes that vtkNBufferOcclusionTest did not find hidden. Where the whole depth
 * image is in host memory, that takes far less time than drawing a false-visible prop:
 *
 *     +---------------------+      The rectangle of a box also covers what is around its outline
 *     |     .--------.      |      (the sky above a hidden house), and its nearest depth is that
 *     |   .'          `.    |      of one corner. Here only squares that touch the outline count,
 *     |  '--------------'   |      and each is compared with the depth of the box's front faces
 *     +---------------------+      in this square.
 *
 * Only the places in a pixel at which the device may take samples count. Without multisampling that
 * is the middle alone: a rasteriser draws a fragment only if the middle of the pixel lies in the
 * triangle (OpenGL 4.6, section 14.6.1), and the depth of the fragment is that in the middle. With
 * multisampling it is a square around the middle that holds all samples. Smoothed polygons cover
 * every pixel that they touch, so that the whole pixel counts.
 *
 * The outline is wider than the box by as much as a device may move the corners of triangles,
 * snapping included. A middle exactly on the outline counts as inside, so that it does not matter
 * which of two triangles owns a middle on their common edge.
 *
 * One lookup in the levels tests a square of 8 x 8 pixels. Only the squares that do not hide their
 * part of the box are looked at pixel by pixel, beginning at the top, where houses, masts and trees
 * stick out. The test stops at the first pixel in which the box may be visible.
 *
 * If the box of a mesh is not hidden, the mesh is tested in the same way, triangle by triangle.
 * Often only an empty part of a box is visible, for example between two roofs or through the gaps
 * of a fence. With E the error of vertices in pixels, B the border of the box and u and n as in
 * vtkNBufferBoxError.h, g the slope of the triangle, R its depth range and h its height on the
 * screen, a device draws
 *
 *  - no sample farther than E + B outside of the triangle, in x and in y: the outline,
 *  - no sample nearer than
 *
 *        max(z of the nearest corner, z(x, y) - (|g_x| + |g_y|) (E + B))
 *          - the error of a vertex's depth - (2^-8.5 + 16 u n) R / h
 *
 * where z(x, y) is the plane of the triangle. The first line of the formula holds because the depth
 * of a sample is a weighted mean of the depths of the corners, its place is the mean of their
 * places with the same weights, and these places are at most E + B away from the exact ones. The
 * last term is that of the slack of a box, with the triangle's own range and height. For a triangle
 * lower than 1/16 pixel only its nearest corner is used, with the slack of its box, so that
 * vtkNBufferSliverTest need not know whether the box or the triangles were found hidden.
 */
#ifndef vtkNBufferPixelTest_h
#define vtkNBufferPixelTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferMesh;

class VTKNBUFFER_EXPORT vtkNBufferPixelTest
{
public:
  /**
   * All arguments are kept by reference and must outlive the test. `levels` holds the largest
   * orders of depth of the projection's viewport. `depth` is the image of orders that they were
   * made from, row 0 at the bottom. In a parallel program the texels of `levels` may be nearer than
   * their pixels, because of what other ranks have drawn; of a pixel and its texel the nearer one
   * counts. `sampleDistance` is that of vtkNBufferOcclusionTest.
   */
  vtkNBufferPixelTest(const vtkNBufferProjection& projection, const vtkNBufferLevels& levels,
    const float* depth, double sampleDistance);

  /// True only if nothing of the box can be seen. `screen` is the result of projection.Project().
  bool IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);

  /**
   * False only if nothing of a mesh can be seen. `screen` is what projection.Project() gave for its
   * box, which has no Margin and is Inside. `toWorld` is the matrix from the coordinates of the
   * mesh to the world, row by row. The test begins with triangle `first`, which may be any number,
   * and ends after `count` triangles; if there are more, false says nothing of them. If a triangle
   * may be visible, `first` is set to it, with which the next test mostly ends.
   */
  bool MayBeSeen(const vtkNBufferMesh& mesh, const double toWorld[16],
    const vtkNBufferScreenBox& screen, std::size_t& first, std::size_t count);

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

  /// How far a device may draw the corners of triangles from their exact places, along x and y, in
  /// pixels: the sum of the vertex errors and the border.
  glm::dvec2 GetSlack(const vtkNBufferScreenBox& screen) const;
  /// Add the edge with this outward normal that has all points, slack included, on its inner side.
  template <typename Points>
  void AddEdge(const glm::dvec2& normal, const Points& points, const glm::dvec2& slack);
  /// Set the box under test.
  void SetOutline(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
  /// Set the triangle under test, with x and y in pixels and the order of depth in z.
  void SetOutline(const Corners& corners, const Errors& errors, const glm::dvec2& slack);
  /// Whether nothing can be seen of what the outline covers in a rectangle.
  bool IsHidden(const vtkNBufferRectangle& pixels);
  /// Whether a square around (x, y) lies wholly outside of the outline.
  bool IsOutsideOutline(double x, double y, double halfSide) const;
  /// The nearest depth that the box or triangle may have in a square around (x, y).
  double GetNearest(double x, double y, double halfSide) const;
  bool IsSquareHidden(int x, int y, const vtkNBufferRectangle& pixels);
  bool IsPixelHidden(int column, int row);

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
  std::vector<glm::dvec3> OnScreen; ///< The points of the mesh under test.
  long long Lookups = 0;
};

VTK_ABI_NAMESPACE_END
#endif
