// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSliverTest
 * @brief Whether a hidden mesh has triangles that may be drawn in front of its box. No OpenGL.
 *
 * The slack of a box (vtkNBufferBoxError.h) allows for the depth error of triangles that are at
 * least 1/16 pixel high on the screen. A lower triangle, a sliver, seldom owns a sample. Where it
 * does, a rasteriser that uses the depth plane of the vertices before they are snapped (Mesa's
 * llvmpipe) extrapolates along a slope that grows without bound. VTK without a culler then shows a
 * stray pixel through the wall in front. Every curved surface has slivers along its outline. To
 * keep their stray pixels, this test looks at each triangle of a mesh whose box was found hidden.
 * (vtkNBufferFaceTest comes first, and rules out most meshes as a whole.)
 *
 * On the screen, let L be the longest side of a triangle, h its height over this side less the
 * error of its vertices, R its depth range, and r the difference in depth between its third corner
 * and the foot of the height on the longest side. With u and n as in vtkNBufferBoxError.h,
 *
 *     h < 64 u L      rounding leaves no plane: the triangle's samples may have any depth,
 *     h >= 64 u L     its samples are nearer than the triangle itself by at most
 *
 *                         (2^-8.5 + 8 u n) s + min(8 u n, 32 u L) R / h
 *
 *                     where s <= R / L + r / h is the slope of its plane, along the longest side
 *                     and across it. In most cases the slack of the box allows for that.
 *
 * The last term is for the rounding of the slopes. A slope is a sum of two products of a side (at
 * most L) and a difference of depths (at most R), divided by an area (L h). Each product has an
 * error of about 6 u, and the slope acts over a distance of at most L. The term holds as long as
 * rounding does not change the area much, 6 u L^2 << L h.
 *
 * For each triangle that the slack of the box does not cover, the test finds the samples that it
 * may own, and the nearest depth that each of them may have:
 *
 *  - A device draws the samples that lie in the snapped triangle. Its corners differ from the exact
 *    ones, in x and in y, by at most 1/512 pixel plus the errors of vertices. If the device says
 *    that it has 8 subpixel bits, and the box is wholly in view, so that no triangle is cut, a
 *    corner is at the nearest point of a grid of 1/256 pixel; its errors leave open which one only
 *    near the middle between two. A sample may lie in such a triangle only if it lies in the
 *    rectangle around the corners and the three areas that it spans with the sides may have the
 *    same sign. A triangle whose corners are known to be snapped to one line owns none.
 *  - The depth is that of the plane of the vertices before they were snapped. With d the distance
 *    of the sample from the longest side, positive towards the third corner, it is the depth of
 *    that side there plus d / h times r, less the errors above. The errors of vertices are also
 *    those of d and h. Thus samples outside of the triangle are nearer than it on one side, and
 *    farther on the other.
 *
 * Where h is less than the errors of the vertices, nothing is known of the plane. These errors are
 * therefore computed for each triangle and axis: with E of vtkNBufferBoxError.h, w of the nearest
 * corner, a the largest distance of a corner from the middle of the view, and x the largest window
 * coordinate of a corner plus one pixel, on this axis,
 *
 *     E' = E / w + u (4 a + 2 [x]),    [x]: the largest power of two that is not larger than x,
 *
 * because a device that does not cut a triangle rounds three times as it divides by w and scales,
 * and twice more as it adds the middle of the viewport and as it subtracts that of a pixel. A float
 * less than 2 [x] has a last digit of at most 2 u [x], half of which is lost at most. (Among the
 * ground plans of far houses, near the horizon, most of E' is that.)
 *
 * The mesh has to be drawn only if one of these samples is not behind what is stored in its pixel
 * or, if that is not at hand, in its texel of level 0.
 *
 * A device also cuts triangles (at the near plane, the sides of the view and clipping planes),
 * which may make them lower than they were. The test does not cover these.
 *
 * Most triangles own no sample or are no slivers. For these the test takes about 30 ns per
 * triangle.
 */
#ifndef vtkNBufferSliverTest_h
#define vtkNBufferSliverTest_h

#include "vtkNBufferLevels.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferSamples.h"

#include <array>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
struct vtkNBufferMesh;

class VTKNBUFFER_EXPORT vtkNBufferSliverTest
{
public:
  /**
   * `projection` and `levels` are kept by reference and must outlive the test. The levels hold the
   * largest orders of depth of the projection's viewport. `depth` is the image of orders that they
   * were made from, or nullptr if it is not at hand.
   */
  vtkNBufferSliverTest(const vtkNBufferProjection& projection, const vtkNBufferLevels& levels,
    const float* depth, vtkNBufferSamples samples);

  /**
   * False only if none of the triangles `begin` to `end` - 1 of a mesh can be seen, given that its
   * box, which is Inside, was found hidden. `toWorld` is the matrix from model to world
   * coordinates, row by row. `screen` is what projection.Project() gave for the box.
   */
  bool MayBeSeen(const vtkNBufferMesh& mesh, std::size_t begin, std::size_t end,
    const double toWorld[16], const vtkNBufferBox& box, const vtkNBufferScreenBox& screen) const;

private:
  using Errors = vtkNBufferBoxError::TriangleErrors;
  /// The corners of a triangle: x and y in pixels, and the order of depth in z.
  using Corners = std::array<glm::dvec3, 3>;

  /// A projected point. The columns of all samples of the viewport are numbered from left to right,
  /// and the rows from bottom to top. First are the first column and the first row whose samples
  /// may have the same or a larger coordinate than the point; Last are the last ones whose samples
  /// may have the same or a smaller coordinate.
  struct Point
  {
    glm::dvec2 Place;
    double W; ///< Not positive behind the eye.
    glm::ivec2 First;
    glm::ivec2 Last;
  };

  /// Project a point. `reach` is how far, in x and in y, a sample that a point owns may be from the
  /// point.
  Point Project(
    const glm::dvec3& place, const vtkNBufferProjection::Rows& toWindow, double reach) const;

  /// A triangle that the slack of its box does not cover.
  struct Sliver;

  /// Whether a triangle may be seen whose corners are at most `error` pixels from their places, in
  /// x and in y, before they are snapped.
  bool MayBeSeen(const Corners& corners, const glm::dvec2& error, const Errors& errors) const;

  /// Whether one of the samples that a sliver may own may be seen.
  bool HasVisibleSample(const Sliver& sliver, const Errors& errors) const;

  const vtkNBufferProjection& Projection;
  const vtkNBufferLevels& Levels;
  const float* Depth;
  vtkNBufferSamples Samples;
};

VTK_ABI_NAMESPACE_END
#endif
