// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPixelTest
 * @brief Whether a box lies behind every sample that its outline covers. No OpenGL.
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
 * multisampling a sample may lie anywhere in its pixel, and smoothed polygons cover each pixel that
 * they touch: then the whole pixel counts.
 *
 * One lookup in the levels answers a square of 8 x 8 pixels. Only the squares that do not hide
 * their part of the box are looked at pixel by pixel, beginning at the top, where houses, masts and
 * trees stick out. The test stops at the first pixel in which the box may be seen.
 */
#ifndef vtkNBufferPixelTest_h
#define vtkNBufferPixelTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferPixelTest
{
public:
  /**
   * All arguments are kept by reference and must outlive the test. `levels` holds the farthest
   * stored depths of the projection's viewport. `depth` is the depth image that they were made
   * from, row 0 at the bottom. `sampleDistance` is how far from the middle of its pixel a sample
   * may be in x and in y: 0, or 0.5 pixels with multisampling or smoothed polygons.
   */
  vtkNBufferPixelTest(const vtkNBufferProjection& projection, const vtkNBufferLevels& levels,
    const float* depth, double sampleDistance);

  /// True only if nothing of the box can be seen. `screen` is what projection.Project() gave for
  /// the box.
  bool IsHidden(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);

  /// The number of texels and pixels read so far.
  long long GetLookups() const { return this->Lookups; }

private:
  /// A half plane of the screen: Normal . (x, y) + Offset > 0 outside of the outline.
  struct Edge
  {
    glm::dvec2 Normal;
    double Offset;
  };

  void SetEdges(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
  void SetOutline(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen);
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
  /// What is known of the box under test: the edges of its outline, the planes of its front faces,
  /// and its nearest depth.
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
