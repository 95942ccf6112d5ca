// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferProjection
 * @brief From a box in the world to a rectangle of pixels and a nearest depth. No OpenGL.
 *
 * Everything is computed in double precision and rounded so that the answer covers whatever the
 * graphics device may draw of the box with its single-precision vertices (vtkNBufferBoxError.h
 * derives how far that may be):
 *
 *     outside    no fragment of the box can land in the viewport,
 *     crossing   the box reaches the eye or, in view, the near plane: nothing is known about its
 *                pixels, and it counts as visible,
 *     inside     all fragments of the box land in `Pixels`, none of them nearer than `Nearest`;
 *                those in the middles of pixels land in `Middles`.
 *
 * All depths are orders of distance (vtkNBufferDepthConvention.h), for VTK the window depth itself.
 *
 * Equal depth counts as visible: a box is hidden only if Nearest > the farthest depth in Pixels.
 */
#ifndef vtkNBufferProjection_h
#define vtkNBufferProjection_h

#include "vtkNBufferBoxError.h"
#include "vtkNBufferClipToWorld.h"
#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferScreenBox.h"

#include <array>
#include <optional>

VTK_ABI_NAMESPACE_BEGIN

/// One camera, one viewport, one depth format.
class VTKNBUFFER_EXPORT vtkNBufferProjection
{
public:
  /// The rows of a 4 x 4 matrix.
  using Rows = std::array<glm::dvec4, 4>;

  /**
   * `worldToClip` is the matrix from world to clip coordinates, row by row as in vtkMatrix4x4, with
   * z in [-w, w]: vtkCamera's projection matrix for (aspect, -1, 1) times its model-view matrix.
   * For depths other than VTK's, z must be the one that `format` describes. The viewport is `width`
   * x `height` pixels, and `origin` is its lower left corner in the window, in pixels.
   * `subpixelBits` is vtkNBufferGL::GetSubpixelBits(), which OpenGL guarantees to be at least 4.
   */
  void Set(const double worldToClip[16], int width, int height, const vtkNBufferDepthFormat& format,
    const glm::ivec2& origin = glm::ivec2(0), int subpixelBits = 4);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const Rows& GetWorldToClip() const { return this->WorldToClip; }
  const vtkNBufferBoxError& GetError() const { return this->Error; }

  /**
   * Whether a box lies outside one of the six planes of the view. The test uses only signs in clip
   * space and never divides, so that a box around the eye is no special case. Always false for a
   * box with a Margin: only Project() allows for what sticks out of it. Takes about 15 ns.
   */
  bool IsOutside(const vtkNBufferBox& box) const;

  /**
   * Where the box is, and, if it is Inside, its pixels and its depths in `result`. NaN anywhere
   * gives Crossing. Takes about 70 ns.
   *
   * If a box reaches behind the eye, only its part inside the four sides of the view counts: a
   * street under the viewer's feet begins some metres ahead on the screen. That part is cut out
   * first, which takes about a microsecond. Only boxes that cross the near plane in view remain
   * Crossing.
   */
  vtkNBufferPlacement Project(const vtkNBufferBox& box, vtkNBufferScreenBox& result) const;

  /// Like Project(), but faster where many boxes are outside, because IsOutside() comes first.
  vtkNBufferPlacement Place(const vtkNBufferBox& box, vtkNBufferScreenBox& result) const
  {
    return this->IsOutside(box) ? vtkNBufferPlacement::Outside : this->Project(box, result);
  }

  /// The errors with which a device may draw a triangle of a box that is Inside, given the result
  /// of Project() for the box.
  vtkNBufferBoxError::TriangleErrors GetTriangleErrors(const vtkNBufferScreenBox& screen) const;

  /// The rows of the matrix from model coordinates to (x, y, order, 1) times w, with x and y in
  /// pixels of the viewport. `toWorld` is the matrix from model to world coordinates.
  Rows GetWindowMatrix(const glm::dmat4& toWorld) const;

  /**
   * Whether nothing of a box that is Inside lies beyond a side of the view, behind the eye or
   * beyond the far plane. If so, every box that it contains is Inside as well and need not be
   * tested for that.
   */
  bool IsWhollyInside(const vtkNBufferScreenBox& screen) const
  {
    // Farthest is at least Slack behind the farthest point of the box. The Nearest of any box
    // inside is at least Slack before that point, and must not be beyond the far plane.
    const vtkNBufferDepthFormat& format = this->Error.GetFormat();
    return !screen.Clipped && screen.Pixels.X0 > 0 && screen.Pixels.Y0 > 0 &&
      screen.Pixels.X1 < this->Width && screen.Pixels.Y1 < this->Height &&
      screen.Farthest - 2.0 * format.Slack <= format.Farthest;
  }

  /**
   * Where two boxes, both Inside, may have fragments of equal depth in one sample. Such fragments
   * stand for nearly the same point of the world, which lies in both boxes except for rounding. The
   * function therefore inflates the other box by the rounding, cuts it to this one, and projects
   * what the boxes share. (Props side by side in a street overlap in their rectangles and depth
   * intervals but share nothing; props that touch share a face.) The result has the slack of this
   * box, with whose errors its fragments are drawn, so that it can be tested like any box.
   *
   * How far to inflate: let b be the coordinate of a face of the other box on world axis j, and N
   * the clip-to-world matrix. Then L(q) = (N_j - b N_3) q = (p_j - b) / w is linear in the NDC
   * point q of a world point p. For the upper face, L is not positive at any point of the other
   * box. Between two fragments in one place, L differs by no more than r = sum_k |N_jk - b N_3k|
   * (slack_k of one + slack_k of the other). So p_j <= b + w_max r for a fragment of this box,
   * whose largest w is w_max. The same holds for lower faces, with the opposite sign. To both sides
   * comes the error of L (vtkNBufferClipToWorld.h). Takes about 0.15 us.
   */
  vtkNBufferContact GetContact(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen,
    const vtkNBufferBox& other, const vtkNBufferScreenBox& otherScreen) const;

  /**
   * The plane of a face as a bound on depth: what is drawn of the box in a square of half side h
   * around (x, y) is nowhere nearer than the order of distance
   *
   *     Depth + SlopeX x + SlopeY y - h (|SlopeX| + |SlopeY|)
   *
   * where x, y and h are in pixels of the viewport. The slack is included.
   */
  struct FacePlane
  {
    double Depth;
    double SlopeX;
    double SlopeY;
  };

  /// The bound by face 0 to 5 (low x, high x, low y, ...) of a box that is Inside. Empty for a face
  /// that looks away from the eye or is seen edge-on, because it bounds nothing.
  std::optional<FacePlane> GetFacePlane(
    const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, int face) const;

  /// The corners of a box that is Inside, in pixels of the viewport.
  std::array<glm::dvec2, 8> GetCorners(const vtkNBufferBox& box) const;

private:
  class Extent;
  using Corners = std::array<glm::dvec4, 8>;
  vtkNBufferPlacement Clip(const vtkNBufferBox& box, const Corners& corners, Extent& extent) const;
  vtkNBufferPlacement Finish(
    const vtkNBufferBox& box, const Extent& extent, vtkNBufferScreenBox& result) const;

  Rows WorldToClip{};
  vtkNBufferClipToWorld ClipToWorld;
  std::array<glm::dvec4, 6> Planes{}; ///< The planes of the view, which are not negative inside.
  vtkNBufferBoxError Error;
  int Width = 0;
  int Height = 0;
};

VTK_ABI_NAMESPACE_END
#endif
