// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferProjection.h
 * @brief From a box in the world to a rectangle of pixels and a nearest depth. No OpenGL.
 *
 * Everything is computed in double precision and rounded so that the answer covers whatever the
 * graphics device may draw of the box with its single-precision vertices:
 *
 *     outside    no fragment of the box can land in the viewport,
 *     crossing   it reaches the near plane in view, or the eye: nothing is known, it is visible,
 *     inside     all its fragments land in `Pixels`, none nearer than `Nearest`.
 *
 * ## How far a drawn vertex can be from the exact one
 *
 * With u = 2^-24, a vertex is a float vector v in the vertex buffer, and the device multiplies it
 * with a matrix that VTK composes in double and rounds to float: from buffer to world p = o + L v,
 * from world to clip M. A clip coordinate is a sum of four products, with the vertex rounded (u),
 * the matrix element rounded (u), a product and three additions (4 u); 2 u more absorb what is of
 * second order:
 *
 *     E = 8 u (sum_j |M_j| m_j + |M_j o + M_3|),     m_j = sum_k |L_jk| max |v_k|,
 *
 * with `Origin` o and `Magnitude` m below. Usually o is the actor's translation and v are the model
 * coordinates. VTK moves coordinates that are far from their origin for their size (UTM!) into the
 * middle of their range first (AUTO_SHIFT_SCALE); o is then that middle, and large coordinates cost
 * no precision. Divided by w this gives the slack of x, y and z in NDC, corner by corner.
 *
 * Screen positions are snapped to a subpixel grid of at least 4 bits (OpenGL's minimum): 1/16 of a
 * pixel is added on all sides.
 *
 * ## How far an interpolated depth can be from its vertices'
 *
 * A point inside a triangle has a depth between those of its vertices. The depth of a sample in it
 * may lie outside of that range for two reasons, both in proportion to the slope s of the plane,
 * depth per pixel. With R the triangle's depth range and t its smallest height in pixels s is at
 * most R / t, since no triangle is narrower than t in any direction.
 *
 *  - Samples are chosen with snapped vertices, the plane may be that of the vertices as they were
 *    (Mesa's llvmpipe does so). On a grid of 2^-8 pixels a sample then lies up to 2^-8.5 pixels
 *    beside the triangle that gives its depth: 2^-8.5 s.
 *  - The plane z = (z0 - (dz/dx) x0 - (dz/dy) y0) + (dz/dx) x + (dz/dy) y is rounded to float where
 *    its terms are as large as s n, n being the largest window coordinate: 8 u n s, four
 *    times the largest found.
 *
 * R is at most the depth range of the box. The division by w, the viewport transform and the last
 * addition round a value up to 1: 4 u. Storing the depth costs a quantum of its format, reading it
 * back as float at most one more.
 *
 *     slack = 2 quantum + 4 u + (2^-8.5 + 8 u n) R / t,   t = 1/16 pixel
 *
 * A piece of a box shows triangles of the whole box: R remains that of the whole (SetPiece).
 *
 * Triangles lower than 1/16 pixel are not covered: those few that own a sample nevertheless may
 * be given any depth by such a rasteriser. They are a matter of vtkNBufferSliverTest, which looks
 * at the triangles themselves. docs/precision.md has the largest errors found for each format and
 * projection, beside this slack.
 *
 * ## Other depths than VTK's
 *
 * Everything is computed in the order of distance (vtkNBufferDepthConvention.h), for Forward the
 * window depth itself. Where small depths are far, they are precise there: for Reversed and
 * InverseW the slack is 2 quantum + 6 u * (largest depth of the box) + the same part of R, with a
 * quantum of 0 for floats, whose storage the 6 u include.
 *
 * Equal depth counts as visible: a box is hidden only if Nearest > the farthest depth in Pixels.
 */
#ifndef vtkNBufferProjection_h
#define vtkNBufferProjection_h

#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro

#include <algorithm>
#include <array>

VTK_ABI_NAMESPACE_BEGIN

/**
 * An axis-aligned box in world coordinates and the rounding that its vertices suffer.
 */
struct vtkNBufferBox
{
  double Center[3] = { 0.0, 0.0, 0.0 };
  double HalfSize[3] = { 0.0, 0.0, 0.0 };
  /// o and m above, world units: where vertex buffer coordinates are 0, and how far they reach.
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Magnitude[3] = { 0.0, 0.0, 0.0 };
  /// Pixels by which what is drawn may stick out of the projected box (wide lines, points).
  double Margin = 0.0;

  bool operator==(const vtkNBufferBox& other) const
  {
    const auto same = [](const double a[3], const double b[3])
    { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; };
    return same(this->Center, other.Center) && same(this->HalfSize, other.HalfSize) &&
      same(this->Origin, other.Origin) && same(this->Magnitude, other.Magnitude) &&
      this->Margin == other.Margin;
  }

  /// A box from VTK bounds whose vertex buffer holds world coordinates.
  VTKNBUFFER_EXPORT static vtkNBufferBox FromBounds(const double bounds[6]);
};

enum class vtkNBufferPlacement
{
  Outside,
  Crossing,
  Inside
};

/**
 * What a box covers on the screen; only meaningful for boxes that are Inside.
 */
struct vtkNBufferScreenBox
{
  vtkNBufferRectangle Pixels; ///< Of the viewport, (0, 0) its lower left pixel; never empty.
  ///@{
  /// Order of distance, larger is farther: the window depth for Forward, minus the stored depth for
  /// the other conventions. Slack subtracted from one and added to the other.
  double Nearest = 0.0;
  double Farthest = 1.0;
  ///@}
  double DepthRange = 1.0; ///< R above, for which Nearest and Farthest allow; order of distance.
  double Slack[3] = {};    ///< How far a drawn point may be from its exact place, NDC.
  double MaximumW = 0.0;   ///< Largest clip w of the corners.
  bool Clipped = false;    ///< Corners are behind the eye: the part in view was cut out.
};

/**
 * One camera, one viewport, one depth format.
 */
class VTKNBUFFER_EXPORT vtkNBufferProjection
{
public:
  /**
   * `worldToClip`: row-major 4 x 4, clip space with z in [-w, w]: vtkCamera's projection matrix for
   * (aspect, -1, 1) times its model-view matrix, whatever the convention. `depthQuantum`: the step
   * of the depth format (2^-16, 2^-24, ...), for Forward the one near 1. Sizes in pixels.
   * `largestCoordinate`: where the viewport ends in the window, if it does not begin at 0.
   */
  void Set(const double worldToClip[16], int width, int height, double depthQuantum,
    vtkNBufferDepthConvention convention = vtkNBufferDepthConvention::Forward,
    int largestCoordinate = 0);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  const double* GetWorldToClip() const { return &this->WorldToClip[0][0]; }

  /// Stored depth times this is the order of distance, see vtkNBufferDepthConvention.h.
  double GetDepthSign() const { return this->DepthSign; }

  /**
   * Whether a box lies outside one of the six planes, tested in clip space by sign and never by
   * division, so that eye points inside the box are no special case. Boxes with a Margin are left
   * to Project(). About 15 ns.
   */
  bool IsOutside(const vtkNBufferBox& box) const;

  /**
   * Rectangle and nearest depth. NaN anywhere gives Crossing. About 70 ns.
   *
   * Of a box that reaches behind the eye only the part inside the four sides of the view counts
   * (a street under the viewer's feet begins some metres ahead on the screen); it is cut out first,
   * about a microsecond. Crossing remains what crosses the near plane in view.
   */
  vtkNBufferPlacement Project(const vtkNBufferBox& box, vtkNBufferScreenBox& result) const;

  /// Let `piece`, what Project gave for a piece of a box, allow for the triangles of the box, which
  /// may be as steep as `whole` says.
  void SetPiece(const vtkNBufferScreenBox& whole, vtkNBufferScreenBox& piece) const
  {
    const double rest = std::max(whole.DepthRange - piece.DepthRange, 0.0);
    piece.DepthRange += rest;
    piece.Nearest -= rest * this->DepthRangeSlack;
    piece.Farthest += rest * this->DepthRangeSlack;
  }

  /**
   * What is known of how a device draws one triangle of a box that is Inside, see above. Pixels and
   * order of distance.
   */
  struct TriangleErrors
  {
    double Position;     ///< Of a vertex, in x and in y, before it is snapped.
    double Overshoot;    ///< A sample from the triangle that it is part of, beyond Position.
    double Depth;        ///< Of any sample, besides what follows from slopes and their rounding.
    double OfSlope;      ///< In units of the slope of the plane.
    double OfRounding;   ///< In units of depth range by height, at most, and
    double OfLength;     ///< in the same units and those of the longest side.
    double Granted;      ///< What the slack of the box grants the last three.
    double LargestSlope; ///< Depth range by height up to which that is enough in any case.
    double LowestHeight; ///< In units of the longest side; below it the plane is lost in rounding.
  };
  TriangleErrors GetTriangleErrors(
    const vtkNBufferBox& box, const vtkNBufferScreenBox& screen) const;

  /// Rows of a matrix from model coordinates to (x, y, order, 1) times w, in pixels of the viewport
  /// and order of distance. `toWorld`: row-major.
  void GetWindowMatrix(const double toWorld[16], double matrix[4][4]) const;

  /**
   * Whether nothing of a box that is Inside lies beyond a side of the view, behind the eye or
   * beyond the far plane: then every box in it is Inside as well, and need not be asked.
   */
  bool IsWhollyInside(const vtkNBufferScreenBox& screen) const
  {
    // Farthest lies at least DepthSlack behind the box, Nearest of what is in it as much before.
    return !screen.Clipped && screen.Pixels.X0 > 0 && screen.Pixels.Y0 > 0 &&
      screen.Pixels.X1 < this->Width && screen.Pixels.Y1 < this->Height &&
      screen.Farthest - 2.0 * this->DepthSlack <= this->FarthestOrder;
  }

  /**
   * Where two boxes, both Inside, may have fragments of equal depth in one sample: a rectangle of
   * pixels. Returns false if nowhere. Such fragments stand for nearly the same point of the world,
   * which lies in both boxes but for rounding; so the rectangle is that of what they share, one box
   * inflated by the rounding and cut to the other. Props side by side in a street overlap in their
   * rectangles and depth intervals and share nothing; props that touch share a face.
   *
   * How far to inflate: with b a face of the other box along world axis j, and N the clip-to-world
   * matrix, L(q) = (N_j - b N_3) q = (p_j - b) / w is linear in the NDC point q of world point p.
   * It is not positive for points of the other box (b its upper face), and two fragments in one
   * place differ in it by no more than r = sum_k |N_jk - b N_3k| (slack_k of one + slack_k of the
   * other): p_j <= b + w_max r. About 0.15 us.
   */
  bool GetContact(const vtkNBufferBox& box, const vtkNBufferScreenBox& screen,
    const vtkNBufferBox& other, const vtkNBufferScreenBox& otherScreen,
    vtkNBufferRectangle& pixels) const;

  /**
   * The plane of a face as a bound on depth. Face 0 to 5: low x, high x, low y, ... Where it faces
   * the eye, what is drawn of the box in a square of pixels of half side `h` around (x, y) is
   * nowhere nearer than
   *
   *     Depth + SlopeX x + SlopeY y - h (|SlopeX| + |SlopeY|)
   *
   * in order of distance and pixels of the viewport, slack included. Returns false for a face that
   * looks away or is seen edge-on.
   */
  struct FacePlane
  {
    double Depth;
    double SlopeX;
    double SlopeY;
  };
  bool GetFacePlane(
    const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, int face, FacePlane& plane) const;

  /// The eight corners of a box that is Inside, in pixels of the viewport: x0, y0, x1, y1, ...
  void GetCorners(const vtkNBufferBox& box, double corners[16]) const;

  /**
   * Length in pixels of the projections of the box's three axes through its centre, for choosing
   * where to cut it. The box must be Inside.
   */
  void GetAxisLengths(const vtkNBufferBox& box, double lengths[3]) const;

private:
  class Extent;
  using ClipPoint = std::array<double, 4>;
  vtkNBufferPlacement Clip(
    const vtkNBufferBox& box, const ClipPoint corners[8], Extent& extent) const;
  vtkNBufferPlacement Finish(
    const vtkNBufferBox& box, const Extent& extent, vtkNBufferScreenBox& result) const;

  void SetConvention(vtkNBufferDepthConvention convention, double depthQuantum);

  double WorldToClip[4][4] = {};
  double Rows[4][4] = {}; ///< WorldToClip, but row 2 gives the order, -1 on the near plane.
  double Planes[6][4] = {};
  double ClipToWorld[4][4] = {}; ///< The inverse of Rows.
  double DepthSign = 1.0;
  double FarthestOrder = 1.0; ///< Of the background.
  ///@{
  /// order = OrderScale * (row 2 of Rows . p) / w + OrderOffset.
  double OrderScale = 0.5;
  double OrderOffset = 0.5;
  ///@}
  double DepthSlack = 0.0;
  double RelativeDepthSlack = 0.0; ///< In units of the largest depth of the box.
  double DepthRangeSlack = 0.0;    ///< In units of the depth range of the box.
  double PlaneRounding = 0.0;      ///< 8 u n, pixels.
  int Width = 0;
  int Height = 0;
};

VTK_ABI_NAMESPACE_END
#endif
