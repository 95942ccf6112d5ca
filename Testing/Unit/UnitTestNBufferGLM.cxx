// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Conversions between GLM's types and VTK's arrays. GLM rounds as VTK does where that matters.
#include "PrintVectors.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace
{
using RowsOfMatrix = std::array<double, 16>;

RowsOfMatrix MakeRows(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-10.0, 10.0);
  RowsOfMatrix rows;
  std::generate(rows.begin(), rows.end(), [&]() { return uniform(random); });
  return rows;
}
}

TEST(NBufferGLM, RowsAndColumns)
{
  RowsOfMatrix rows;
  std::iota(rows.begin(), rows.end(), 0.0);
  const glm::dmat4 matrix = vtkNBufferGLM::ToMatrix(rows.data());
  EXPECT_EQ(matrix[3], glm::dvec4(3.0, 7.0, 11.0, 15.0)) << "the last column";
  EXPECT_EQ(vtkNBufferGLM::ToRows(matrix), rows);
}

// Hazard: the world-to-clip matrix, or what is compared with it, differs in a bit from that of the
// mappers.
TEST(NBufferGLM, RoundsAsVTKDoes)
{
  std::mt19937 random(5);
  for (int n = 0; n < 1000; ++n)
  {
    const RowsOfMatrix a = MakeRows(random);
    const RowsOfMatrix b = MakeRows(random);
    const glm::dmat4 matrix = vtkNBufferGLM::ToMatrix(a.data());

    RowsOfMatrix product;
    vtkMatrix4x4::Multiply4x4(a.data(), b.data(), product.data());
    ASSERT_EQ(vtkNBufferGLM::ToRows(matrix * vtkNBufferGLM::ToMatrix(b.data())), product);

    RowsOfMatrix inverse;
    vtkMatrix4x4::Invert(a.data(), inverse.data());
    ASSERT_EQ(vtkNBufferGLM::ToRows(vtkNBufferGLM::Invert(matrix)), inverse);

    glm::dvec4 moved;
    vtkMatrix4x4::MultiplyPoint(a.data(), b.data(), glm::value_ptr(moved));
    ASSERT_EQ(vtkNBufferGLM::Multiply(matrix, glm::make_vec4(b.data())), moved);

    glm::dvec3 unit = glm::make_vec3(b.data());
    const glm::dvec3 normalized = vtkNBufferGLM::Normalize(unit);
    vtkMath::Normalize(glm::value_ptr(unit));
    ASSERT_EQ(normalized, unit);
  }
  EXPECT_EQ(vtkNBufferGLM::Normalize(glm::dvec3(0.0)), glm::dvec3(0.0));
}

// Hazard: for a degenerate camera, uninitialised memory of VTK is used as the inverse matrix.
TEST(NBufferGLM, TheInverseOfASingularMatrixIsNaN)
{
  glm::dmat4 singular(1.0);
  singular[2] = singular[1];
  for (const double element : vtkNBufferGLM::ToRows(vtkNBufferGLM::Invert(singular)))
  {
    EXPECT_TRUE(std::isnan(element));
  }
}

TEST(NBufferGLM, AbsoluteValues)
{
  const glm::dvec3 x = vtkNBufferGLM::Abs({ -1.5, 0.0, 2.5 });
  EXPECT_EQ(x, glm::dvec3(1.5, 0.0, 2.5));
  EXPECT_TRUE(std::isnan(vtkNBufferGLM::Abs(glm::dvec3(std::nan(""), 0.0, 0.0)).x));
}
