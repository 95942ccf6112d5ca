// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferBoxError.h
 * @brief How far from its exact place, and how much nearer, a device may draw what is in a box.
 *
 * A graphics device computes with single-precision numbers. What it draws of a box is therefore not
 * exactly where double precision says, and a culler that must not change a picture has to allow for
 * the difference. This file derives the difference and holds its numbers; vtkNBufferProjection adds
 * them to every rectangle and every depth. No OpenGL.
 *
 * ## How far a drawn vertex can be from the exact one
 *
 * Let u be 2^-24. A vertex is a vector v of floats in the vertex buffer. The device multiplies it
 * with a matrix that VTK composes in double precision and rounds to float: from the buffer to the
 * world, p = o + L v, and from the world to clip coordinates, M. A clip coordinate is a sum of four
 * products, added in any order. In three of them the vertex, the matrix element and the product are
 * rounded (3 u), and in the fourth one, whose factor is 1, only the matrix element (u). Three
 * additions follow (3 u). Terms of second order are less than 2^-16 of that:
 *
 *     E = 6 u sum_j |M_j| m_j + 4 u |M_j o + M_3|,     m_j = sum_k |L_jk| max |v_k|,
 *
 * with `Origin` o and `Magnitude` m of vtkNBufferBox. Usually o is the actor's translation and v
 * are the model coordinates. Where coordinates are large compared with the size of the data (UTM
 * coordinates, for example), VTK first subtracts the middle of their range (AUTO_SHIFT_SCALE); o is
 * then that middle, and large coordinates cost no precision. Divided by w, E gives the slack of x,
 * y and z in normalised device coordinates (NDC), corner by corner.
 *
 * The device snaps screen positions to a subpixel grid, which moves a vertex by less than a step of
 * the grid along each axis. A border is added to a box on all sides for this:
 *
 *  - 2^-b + 16 u n pixels where the device says that its grid has b bits (GL_SUBPIXEL_BITS) and the
 *    box is wholly in view; n is the largest window coordinate. The second term is for rounding:
 *    the division by w, the viewport transform, and a cut at a clipping plane, which makes a vertex
 *    between two others, are some ten operations on numbers of at most n.
 *  - 1/16 pixel, OpenGL's minimum of 4 bits, for any other box, for lines and for points. Where the
 *    device cuts a triangle at a side of the view, or at the guard band beyond it, the new vertex
 *    lies on an edge that may begin far outside, with errors in proportion to that.
 *
 * ## How far an interpolated depth can be from those of its vertices
 *
 * A point inside a triangle has a depth between those of its vertices. The depth of a sample in the
 * triangle may lie outside of that range for two reasons. Both are in proportion to the slope s of
 * the triangle's plane, in depth per pixel. With R the depth range of the triangle and t its
 * smallest height in pixels, s is at most R / t, since no triangle is narrower than t in any
 * direction.
 *
 *  - A device decides with the snapped vertices which samples a triangle covers, but its plane of
 *    depth may be that of the vertices before they were snapped (Mesa's llvmpipe does so). On a
 *    grid of 2^-8 pixels a sample then lies up to 2^-8.5 pixels outside of the triangle that gives
 *    the sample its depth: 2^-8.5 s.
 *  - The plane z = (z0 - (dz/dx) x0 - (dz/dy) y0) + (dz/dx) x + (dz/dy) y is rounded to float where
 *    its terms are as large as s n, n being the largest window coordinate: 8 u n s, which is four
 *    times the largest error found.
 *
 * R is at most the depth range of the box. The division by w, the viewport transform and the last
 * addition round a value of at most 1: 4 u. Storing the depth costs a quantum of its format, and
 * reading it back as float costs at most one more (vtkNBufferDepthSource::GetStep()).
 *
 *     slack = 2 quantum + 4 u + (2^-8.5 + 8 u n) R / t,   t = 1/16 pixel
 *
 * Reversed depth, z / w, is rounded in proportion to its value: 6 u (largest depth of the box) take
 * the place of 4 u. For floats, whose quantum is 0, they include the rounding of storage.
 *
 * Triangles lower than 1/16 pixel are not covered. Few of them own a sample, but a rasteriser such
 * as llvmpipe may give this sample any depth. vtkNBufferSliverTest tests them one by one.
 * docs/precision.md compares this slack with the largest errors found for each format and
 * projection.
 */
#ifndef vtkNBufferBoxError_h
#define vtkNBufferBoxError_h

#include "vtkNBufferBox.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferGLM.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferTriangleErrors.h"

#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

/// The order of depth (vtkNBufferDepthConvention.h) as a function of clip coordinates, and the part
/// of its error that depends on how depth is stored.
struct vtkNBufferDepthFormat
{
  ///@{
  /// The order of a point is Scale * z / w + Offset, where z / w is -1 on the near plane: for
  /// reversed depth z is negated.
  double Scale = vtkNBufferDepthConvention::Scale;
  double Offset = vtkNBufferDepthConvention::Offset;
  ///@}
  /// No box that is farther is drawn. The far plane of reversed depth is at 0, but 1 lets no box be
  /// Outside that ordinary depth would show, as long as it is not known which depth will be stored.
  double Farthest = vtkNBufferDepthConvention::Background;
  /// The slack above without its last term, which depends on R.
  double Slack = 0.0;
  /// More slack, as a share of the largest |z / w| of a box; 0 for VTK's depth.
  double RelativeSlack = 0.0;

  /// The depth in a buffer whose values are multiples of `quantum` (vtkNBufferDepthSource).
  VTKNBUFFER_EXPORT static vtkNBufferDepthFormat FromQuantum(
    double quantum, vtkNBufferStoredDepth stored = vtkNBufferStoredDepth::Ordinary);
};

/// The numbers of the derivation above for one depth format and one window.
class VTKNBUFFER_EXPORT vtkNBufferBoxError
{
public:
  static constexpr double UnitRoundoff = 1.0 / (1 << 24);
  /// The step of the grid of Overshoot, in pixels. A device with as many subpixel bits snaps a
  /// vertex to the nearest point of this grid; others are assumed to move it by half a step at
  /// most.
  static constexpr double GridStep = 1.0 / 256;
  static constexpr double LowestHeight = 1.0 / 16; ///< t of the derivation above, in pixels.

  /// The viewport begins at `origin` in the window and has `size` pixels. `subpixelBits` is b of
  /// the derivation above.
  void Set(const vtkNBufferDepthFormat& format, const glm::ivec2& origin, const glm::ivec2& size,
    int subpixelBits);

  /// The value of a row of a matrix at a point, (x, y, z, 1) times the row, added from left to
  /// right as the derivation counts it.
  static double Evaluate(const glm::dvec4& row, const glm::dvec3& point)
  {
    return glm::dot(glm::dvec3(row), point) + row.w;
  }

  /// E of the derivation above: how far the value of a device may be from that of Evaluate(), for
  /// any vertex in the box and a row of the matrix from world to clip coordinates.
  static double GetVertexError(const glm::dvec4& row, const vtkNBufferBox& box)
  {
    return VertexErrors * glm::dot(vtkNBufferGLM::Abs(glm::dvec3(row)), box.Magnitude) +
      OriginErrors * std::abs(Evaluate(row, box.Origin));
  }

  /// E of four rows of a matrix at once: `absolute` are the absolute values of its elements, and
  /// `ofOrigin` are the values of the rows at the origin o.
  static glm::dvec4 GetVertexErrors(
    const glm::dmat4& absolute, const glm::dvec3& magnitude, const glm::dvec4& ofOrigin)
  {
    return VertexErrors * vtkNBufferGLM::Multiply(absolute, glm::dvec4(magnitude, 0.0)) +
      OriginErrors * vtkNBufferGLM::Abs(ofOrigin);
  }

  /// The pixels to add on each side of a projected box: its margin and the border of the derivation
  /// above. `isWhole` says whether the box is wholly in view.
  double GetBorder(const vtkNBufferBox& box, bool isWhole) const
  {
    return isWhole && !(box.Margin > 0.0) ? this->WholeBorder : box.Margin + LargestSnap;
  }

  /// The slack above of a box whose depths have the range R and whose nearest corner has the value
  /// `lowest` of z / w.
  double GetDepthSlack(double lowest, double range) const
  {
    return this->Format.Slack + this->Format.RelativeSlack * std::abs(lowest) +
      this->GetInterpolationSlack(range);
  }

  /// The last term of the slack above: what interpolation costs in a box whose depths have the
  /// range R.
  double GetInterpolationSlack(double range) const { return range * this->DepthRangeSlack; }

  const vtkNBufferDepthFormat& GetFormat() const { return this->Format; }

  using TriangleErrors = vtkNBufferTriangleErrors;

  /// `position` is how far E moves a vertex, in pixels. `depth` is the error of a depth without the
  /// term that depends on R, and `range` is R.
  TriangleErrors GetTriangleErrors(double position, double depth, double range) const;

private:
  ///@{
  /// 6 u and 4 u of the derivation above, with the terms of second order.
  static constexpr double VertexErrors = 6.0 * UnitRoundoff * (1.0 + 0x1p-16);
  static constexpr double OriginErrors = 4.0 * UnitRoundoff * (1.0 + 0x1p-16);
  ///@}
  static constexpr double LargestSnap = 1.0 / 16; // pixels, OpenGL's minimum of subpixel bits

  vtkNBufferDepthFormat Format;
  bool SnapsToGrid = false;
  double WholeBorder = LargestSnap; ///< The border of a box that is wholly in view, in pixels.
  double DepthRangeSlack = 0.0;     ///< The last term of the slack for a depth range of 1.
  double PlaneRounding = 0.0;       ///< 8 u n of the derivation above, in pixels.
  double PositionRounding = 0.0;    ///< 16 u n of the derivation above, in pixels.
  glm::dvec2 Origin{};              ///< The lower left corner of the viewport, in pixels.
};

VTK_ABI_NAMESPACE_END
#endif
