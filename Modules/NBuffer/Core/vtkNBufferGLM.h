// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGLM.h
 * @brief Includes GLM for this project, and converts between GLM's types and VTK's arrays.
 *
 * GLM stores a matrix column by column, VTK (vtkMatrix4x4::GetData()) row by row. ToMatrix() and
 * ToRows() are the only functions that convert one to the other. GLM is a private dependency: no
 * public header includes this file.
 *
 * The last bit of a sum depends on the order of its additions. glm::dot() of vectors with three
 * components adds x + y first and then z. With four components it adds (x + y) + (z + w), whereas
 * VTK adds from left to right. Where results must equal VTK's to the bit, or where an error bound
 * counts roundings, use the functions below.
 */
#ifndef vtkNBufferGLM_h
#define vtkNBufferGLM_h

#include <glm/glm.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "vtkMatrix4x4.h"
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

// Vectors and matrices are copied as plain memory. A vector or matrix that is declared without a
// value is not initialised, like a double.
static_assert(std::is_trivial_v<glm::dvec2> && std::is_trivial_v<glm::dvec3> &&
    std::is_trivial_v<glm::dvec4> && std::is_trivial_v<glm::dmat4>,
  "GLM was configured with constructors that fill vectors (GLM_FORCE_CTOR_INIT)");

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGLM
{
/// The matrix whose elements are given row by row, as vtkMatrix4x4::GetData() returns them.
inline glm::dmat4 ToMatrix(const double rows[16])
{
  return glm::transpose(glm::make_mat4(rows));
}

/// The elements of a matrix row by row, as VTK expects them: the inverse of ToMatrix().
inline std::array<double, 16> ToRows(const glm::dmat4& matrix)
{
  std::array<double, 16> rows;
  for (int i = 0; i < 16; ++i)
  {
    rows[static_cast<std::size_t>(i)] = matrix[i % 4][i / 4];
  }
  return rows;
}

///@{
/// The absolute value of each component. (Compilers turn glm::abs() into branches.)
inline glm::dvec3 Abs(const glm::dvec3& x)
{
  return { std::abs(x.x), std::abs(x.y), std::abs(x.z) };
}
inline glm::dvec4 Abs(const glm::dvec4& x)
{
  return { std::abs(x.x), std::abs(x.y), std::abs(x.z), std::abs(x.w) };
}
///@}

/// Whether no component is infinite or NaN.
template <glm::length_t n>
bool IsFinite(const glm::vec<n, double>& x)
{
  return std::all_of(
    glm::value_ptr(x), glm::value_ptr(x) + n, [](double value) { return std::isfinite(value); });
}

/// The smallest float that is not less than a number.
inline float RoundUp(double x)
{
  const auto rounded = static_cast<float>(x);
  return rounded < x ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

/// The vector scaled to unit length, rounded as by vtkMath::Normalize(); a null vector stays null.
/// (glm::normalize() multiplies by a rounded reciprocal, and divides by zero for a null vector.)
inline glm::dvec3 Normalize(const glm::dvec3& x)
{
  const double length = glm::length(x);
  return length != 0.0 ? x / length : x;
}

/// Matrix times vector. The four products of a row are added from left to right, as vtkMatrix4x4
/// adds them.
inline glm::dvec4 Multiply(const glm::dmat4& matrix, const glm::dvec4& x)
{
  return matrix[0] * x[0] + matrix[1] * x[1] + matrix[2] * x[2] + matrix[3] * x[3];
}

/// The inverse matrix, rounded as by vtkMatrix4x4::Invert(). For a singular matrix all elements of
/// the result are NaN, so that no order comparison with numbers computed from them is true.
inline glm::dmat4 Invert(const glm::dmat4& matrix)
{
  // vtkMatrix4x4::Invert() leaves its result as it is if the determinant is zero.
  std::array<double, 16> inverse;
  inverse.fill(std::numeric_limits<double>::quiet_NaN());
  vtkMatrix4x4::Invert(ToRows(matrix).data(), inverse.data());
  return ToMatrix(inverse.data());
}
}
VTK_ABI_NAMESPACE_END
#endif
