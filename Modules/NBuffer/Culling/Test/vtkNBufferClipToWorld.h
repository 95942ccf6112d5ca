// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferClipToWorld
 * @brief The inverse of a projection, and how wrong it is for a box. No OpenGL.
 *
 * The inverse N of a matrix M is rounded, and of a matrix that is nearly singular (a user matrix
 * that flattens a prop) it is nothing but rounding errors. What follows from N is therefore checked
 * with M. For a face of a box, b its coordinate on world axis j, let
 *
 *     L(q) = (N_j - b N_3) q,    for an exact inverse L(M p) = p_j - b.
 *
 * L(M p) is linear in the point p, so that its values at the corners of a box bound those of all
 * points, whatever N is. (They are rounded to double precision; what uses them allows for points
 * that a device rounds to single precision.)
 */
#ifndef vtkNBufferClipToWorld_h
#define vtkNBufferClipToWorld_h

#include "vtkNBufferBoxError.h"
#include "vtkNBufferModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKNBUFFER_EXPORT vtkNBufferClipToWorld
{
public:
  /// `worldToClip` is M, row by row as in vtkMatrix4x4. If it has no inverse, N is NaN.
  void Set(const double worldToClip[16]);

  /// The largest value in a box of a linear function of the world, given by its factors.
  static double GetLargest(const glm::dvec4& function, const vtkNBufferBox& box)
  {
    return vtkNBufferBoxError::Evaluate(function, box.Center) +
      glm::dot(vtkNBufferGLM::Abs(glm::dvec3(function)), box.HalfSize);
  }

  /// A row of N.
  glm::dvec4 GetRow(int i) const { return glm::row(this->Inverse, i); }

  /// L, for the coordinate b on a world axis.
  glm::dvec4 GetFace(int axis, double b) const { return this->GetRow(axis) - b * this->GetRow(3); }

  /// A linear function of clip coordinates as one of the world, such as L(M p) for L.
  glm::dvec4 ToWorld(const glm::dvec4& function) const { return function * this->Matrix; }

  /// By how much L(M p) may differ from p_j - b for points p of a box. `face` is L.
  double GetError(const glm::dvec4& face, int axis, double b, const vtkNBufferBox& box) const;

  /// A bound of 1 / w for the points of a box that are in view; infinite if there is none.
  double GetLargestInverseW(const vtkNBufferBox& box) const;

private:
  glm::dmat4 Matrix = glm::dmat4(0.0);  ///< M
  glm::dmat4 Inverse = glm::dmat4(0.0); ///< N
};

VTK_ABI_NAMESPACE_END
#endif
