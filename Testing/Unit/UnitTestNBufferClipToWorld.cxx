// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What follows from the inverse of a matrix holds also where the inverse is wrong.
#include "SampledViews.h"
#include "vtkNBufferClipToWorld.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
/// Calls function(inverse, view, box, points, isFlat) for many views, each with a box and points in
/// it. In every second one isFlat is true, and the matrix is singular or nearly so.
template <typename Function>
void ForEachInverse(unsigned int seed, Function function)
{
  ViewSampler sampler(seed);
  for (int n = 0; n < 4000; ++n)
  {
    View view = sampler.MakeView(0.0, n % 4 < 2);
    const std::array<double, 6> bounds = sampler.MakeBounds(view);
    const bool isFlat = n % 2 == 0;
    if (isFlat)
    {
      sampler.Flatten(view, bounds);
    }
    vtkNBufferClipToWorld inverse;
    inverse.Set(view.WorldToClip.data());
    SCOPED_TRACE(GetText(view, bounds));
    function(inverse, view, vtkNBufferBox::FromBounds(bounds.data()),
      sampler.MakePoints(bounds, 20), isFlat);
  }
}
}

TEST(NBufferClipToWorld, ErrorsOfFacesAreBounded)
{
  int large = 0;
  int small = 0;
  ForEachInverse(31,
    [&](const vtkNBufferClipToWorld& inverse, const View& view, const vtkNBufferBox& box,
      const std::vector<glm::dvec3>& points, bool isFlat)
    {
      const glm::dmat4 matrix = vtkNBufferGLM::ToMatrix(view.WorldToClip.data());
      const glm::dmat4 sizes(
        glm::abs(matrix[0]), glm::abs(matrix[1]), glm::abs(matrix[2]), glm::abs(matrix[3]));
      for (int axis = 0; axis < 3; ++axis)
      {
        const double b = box.Center[axis] + box.HalfSize[axis];
        const glm::dvec4 face = inverse.GetFace(axis, b);
        const double error = inverse.GetError(face, axis, b, box);
        const double size = std::abs(b) + glm::length(box.Center) + glm::length(box.HalfSize);
        large += isFlat && !(error < 0.01 * size);
        small += !isFlat && error < 1e-6 * size;
        for (const glm::dvec3& point : points)
        {
          const glm::dvec4 clip = matrix * glm::dvec4(point, 1.0);
          // Sums of four products, in which each is rounded.
          const double rounding =
            0x1p-49 * glm::dot(glm::abs(face), sizes * glm::dvec4(glm::abs(point), 1.0)) +
            1e-12 * size;
          ASSERT_FALSE(std::abs(glm::dot(face, clip) - (point[axis] - b)) > error + rounding)
            << axis;
        }
      }
    });
  EXPECT_GT(large, 500) << "the inverse is to be wrong in some";
  EXPECT_GT(small, 3000) << "and right in others";
}

TEST(NBufferClipToWorld, InverseOfWIsBounded)
{
  int inView = 0;
  int tight = 0;
  ForEachInverse(32,
    [&](const vtkNBufferClipToWorld& inverse, const View& view, const vtkNBufferBox& box,
      const std::vector<glm::dvec3>& points, bool)
    {
      const double bound = inverse.GetLargestInverseW(box);
      const glm::dvec4 row = glm::row(vtkNBufferGLM::ToMatrix(view.WorldToClip.data()), 3);
      for (const glm::dvec3& point : points)
      {
        if (ProjectExactly(view, point))
        {
          const double w = glm::dot(row, glm::dvec4(point, 1.0));
          ++inView;
          tight += bound < 2.0 / w;
          ASSERT_LE(1.0 / w, bound * (1.0 + 1e-9));
        }
      }
    });
  EXPECT_GT(inView, 10000);
  EXPECT_GT(2 * tight, inView);
}
