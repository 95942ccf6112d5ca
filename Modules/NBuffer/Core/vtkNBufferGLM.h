// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGLM.h
 * @brief GLM as this project includes it, and the ways between its types and VTK's arrays.
 *
 * GLM's matrices are stored by columns, VTK's (vtkMatrix4x4::GetData()) by rows: a matrix goes from
 * one to the other through ToMatrix() and nowhere else. GLM is a private dependency: no public
 * header includes this file.
 *
 * Where an error bound counts roundings, the order of operations matters: glm::dot() of three
 * components adds from left to right; of four components it adds two pairs.
 */
#ifndef vtkNBufferGLM_h
#define vtkNBufferGLM_h

// A vector or matrix without arguments is zero, or the identity.
#define GLM_FORCE_CTOR_INIT

#include <glm/glm.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "vtkMatrix4x4.h"
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <array>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGLM
{
/// Three numbers of VTK's, such as a point or a direction.
inline glm::dvec3 ToVector(const double x[3])
{
  return { x[0], x[1], x[2] };
}

/// A matrix of VTK's, row by row.
inline glm::dmat4 ToMatrix(const double rows[16])
{
  return glm::transpose(glm::make_mat4(rows));
}

/// The way back of ToMatrix(): the elements row by row, as VTK and the uniforms take them.
inline std::array<double, 16> ToRows(const glm::dmat4& matrix)
{
  std::array<double, 16> rows;
  for (int i = 0; i < 16; ++i)
  {
    rows[static_cast<std::size_t>(i)] = matrix[i % 4][i / 4];
  }
  return rows;
}

/// Unit length, as vtkMath::Normalize() rounds it; a null vector stays null. (glm::normalize()
/// multiplies by a rounded reciprocal, and divides by zero.)
inline glm::dvec3 Normalize(const glm::dvec3& x)
{
  const double length = glm::length(x);
  return length != 0.0 ? x / length : x;
}

/// Matrix times vector, the four products of a row added from left to right, as vtkMatrix4x4 does.
/// (GLM's operator adds two pairs.)
inline glm::dvec4 Multiply(const glm::dmat4& matrix, const glm::dvec4& x)
{
  return matrix[0] * x[0] + matrix[1] * x[1] + matrix[2] * x[2] + matrix[3] * x[3];
}

/// The inverse, as vtkMatrix4x4::Invert() rounds it.
inline glm::dmat4 Invert(const glm::dmat4& matrix)
{
  std::array<double, 16> inverse;
  vtkMatrix4x4::Invert(ToRows(matrix).data(), inverse.data());
  return ToMatrix(inverse.data());
}
}
VTK_ABI_NAMESPACE_END
#endif
