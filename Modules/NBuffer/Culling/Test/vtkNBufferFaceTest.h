// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferFaceTest
 * @brief Whether a hidden prop has faces that are seen so nearly edge-on that they may be slivers.
 *
 * vtkNBufferSliverTest projects each triangle of a prop. This test comes first. It finds out for
 * most props, in some ten nanoseconds, that none of their triangles is low enough to be drawn in
 * front of what hides the prop. No OpenGL.
 *
 * Let n, a and h of a face be those of vtkNBufferFaces.h. On the screen, relative to the middle of
 * the view, a point p is at (x / w, y / w), with x, y and w linear in p. The area of the
 * parallelogram that a triangle spans on the screen is the determinant of the three values of its
 * corners, divided by the three w. Both this determinant and the plane of the triangle are
 * multilinear in the corners, so that (Cauchy-Binet)
 *
 *     area = L |n . (e - g a)| h / (w1 w2 w3),
 *
 * where L is the longest side in the world, and (e, g) are the homogeneous coordinates of the eye:
 * the vector, up to its sign, in four dimensions that is perpendicular to the rows of x, y and w.
 * (With a parallel camera g is 0.) A side of length L has on the screen at most a length of k L /
 * w, where k is the norm of the derivatives (dx - (x / w) dw, dy - (y / w) dw). The height of a
 * triangle on the screen is its area divided by its longest side there, and therefore at least
 *
 *     |n . (e - g a)| h w_min / (k w_max^3).
 *
 * How low may a triangle be? With the names of vtkNBufferSliverTest.h, its samples are nearer than
 * the box by at most the slack of the box if
 *
 *     height - 2 |E'| - 64 u (longest side) >= (2^-8.5 + 16 u n) (R + 2 errors of depth) / slack.
 *
 * What hides the box is usually much nearer than the box. This clearance (vtkNBufferState) is added
 * to the slack. Only triangles hardly higher than the errors of their corners remain.
 *
 * A face that fails this is examined more closely. On the screen its plane is almost a line. Let m
 * be the unit vector across this line.
 *
 *  - Not |E'| counts but its part along m, |m_x| E'_x + |m_y| E'_y: errors along the line do not
 *    change the height. (Corners differ a little along m, too. This is the `drift` of the source.)
 *  - The line has to come near a sample. Most ground plans of a city, which are the faces seen
 *    edge-on, lie between two rows of samples.
 *
 * As in vtkNBufferSliverTest, all of this is about triangles that a device does not cut. Nothing is
 * ruled out of a piece that reaches before the near plane.
 */
#ifndef vtkNBufferFaceTest_h
#define vtkNBufferFaceTest_h

#include "vtkNBufferBoxError.h"
#include "vtkNBufferFaces.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferSamples.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKNBUFFER_EXPORT vtkNBufferFaceTest
{
public:
  /// The projection is kept by reference and must outlive the test.
  vtkNBufferFaceTest(const vtkNBufferProjection& projection, vtkNBufferSamples samples);

  /// False only if no triangle of the piece can be drawn in front of the farthest depth that is
  /// stored where its prop may be drawn. `clearance` is by how much this depth is nearer than the
  /// nearest depth of the prop's box; it is 0 if the prop was found hidden in another way.
  bool MayBeInFront(
    const vtkNBufferFaces& faces, const vtkNBufferFaces::Piece& piece, double clearance) const;

private:
  struct View;
  bool MayBeInFront(const vtkNBufferFaces::Face& face, const View& view) const;
  /// k for places that are at most `aside` pixels from the middle of the view.
  double GetStretch(const glm::dvec2& aside) const;

  const vtkNBufferProjection& Projection;
  vtkNBufferSamples Samples;
  vtkNBufferBoxError::TriangleErrors Errors;
  glm::dvec2 Half; ///< Half the size of the view, in pixels.
  ///@{
  /// Takes a point to x, y, z and w, with x and y in pixels, and the same with absolute values.
  glm::dmat4 ToView;
  glm::dmat4 Sizes;
  ///@}
  glm::dmat3 ToRows;      ///< Takes a vector to its factors as a sum of the rows of x, y and w.
  glm::dmat3 RowProducts; ///< The absolute values of the inner products of these rows.
  glm::dvec4 Eye;         ///< (e, g).
  double OfEye;           ///< 1 / g
  double SizeOfW;         ///< The length of the row of w.
};

VTK_ABI_NAMESPACE_END
#endif
