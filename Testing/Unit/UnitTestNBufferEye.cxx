// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether two cameras see a point from directions that are more than 30 degrees apart.
#include "vtkNBufferEye.h"

#include "SampledViews.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
glm::dvec3 GetDirectionToEye(const View& view, const glm::dvec3& point)
{
  return glm::normalize(view.Parallel ? -view.Direction : view.Position - point);
}
}

TEST(NBufferEye, SeesFromTheDirectionOfTheCamera)
{
  ViewSampler sampler(11);
  int elsewhere = 0;
  int parallel = 0;
  constexpr int samples = 2000;
  for (int i = 0; i < samples; ++i)
  {
    const View a = sampler.MakeView(0.0, false);
    const View b = sampler.MakeView(0.0, false);
    const glm::dvec3 point(
      sampler.Uniform(-20.0, 20.0), sampler.Uniform(-20.0, 20.0), sampler.Uniform(-20.0, 20.0));
    const double cosine = glm::dot(GetDirectionToEye(a, point), GetDirectionToEye(b, point));
    const bool isFromElsewhere =
      vtkNBufferEye(MakeProjection(a)).SeesFromElsewhere(point, vtkNBufferEye(MakeProjection(b)));
    if (std::abs(cosine - 0.866) > 1e-6)
    {
      EXPECT_EQ(isFromElsewhere, cosine < 0.866) << a.Text << "\n" << b.Text;
    }
    elsewhere += isFromElsewhere;
    parallel += a.Parallel && b.Parallel;
  }
  EXPECT_GT(elsewhere, samples / 4);
  EXPECT_LT(elsewhere, samples * 3 / 4);
  EXPECT_GT(parallel, samples / 20);
}

TEST(NBufferEye, AStillCameraSeesFromTheSamePlace)
{
  const View view = ViewSampler(3).MakeView(0.0);
  const vtkNBufferEye eye(MakeProjection(view));
  EXPECT_FALSE(eye.SeesFromElsewhere(glm::dvec3(1.0), eye));
  EXPECT_TRUE(eye.SeesFromElsewhere(glm::dvec3(1.0), vtkNBufferEye())) << "no eye";
}
