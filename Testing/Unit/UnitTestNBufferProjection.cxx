// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// From boxes to rectangles and depths: conservative for every sampled point, and not too much so.
#include "SampledViews.h"
#include "vtkNBufferProjection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace
{
using Convention = DepthConvention;
using NBufferStudy::DepthConventionNames;
using NBufferStudy::DepthConventions;

/// All that is claimed of a box, for one of its points.
void CheckPoint(const vtkNBufferProjection& projection, vtkNBufferPlacement placement, bool outside,
  const vtkNBufferBox& box, const vtkNBufferScreenBox& screen, const ScreenPoint& point)
{
  ASSERT_FALSE(outside) << "rejected, but a point of it is drawn";
  ASSERT_NE(placement, vtkNBufferPlacement::Outside) << "rejected, but a point of it is drawn";
  if (placement != vtkNBufferPlacement::Inside)
  {
    return;
  }
  const vtkNBufferRectangle& r = screen.Pixels;
  ASSERT_GE(point.X, r.X0);
  ASSERT_LE(point.X, r.X1);
  ASSERT_GE(point.Y, r.Y0);
  ASSERT_LE(point.Y, r.Y1);
  ASSERT_GE(point.Z, screen.Nearest);
  ASSERT_LE(point.Z, screen.Farthest);
  for (int face = 0; face < 6; ++face)
  {
    if (const auto plane = projection.GetFacePlane(box, screen, face))
    {
      ASSERT_GE(point.Z, plane->Depth + plane->SlopeX * point.X + plane->SlopeY * point.Y)
        << "face " << face;
    }
  }
}

class NBufferProjection : public testing::TestWithParam<std::tuple<double, Convention>>
{
};
}

// Hazard: a point outside of its box's rectangle, or nearer than its nearest depth, is culled
// although it is seen; a frustum test that divides by w loses boxes that reach behind the eye.
TEST_P(NBufferProjection, EverySampledPointIsCovered)
{
  const auto [offset, convention] = this->GetParam();
  ViewSampler sampler(5);
  int inside = 0;
  int rejected = 0;
  int crossing = 0;
  int visiblePoints = 0;
  for (int v = 0; v < 150; ++v)
  {
    const View view = sampler.MakeView(offset);
    if (view.Parallel && convention == Convention::InverseW)
    {
      continue;
    }
    const vtkNBufferProjection projection = MakeProjection(view, convention);
    for (int b = 0; b < 40; ++b)
    {
      const std::array<double, 6> bounds = sampler.MakeBounds(view);
      SCOPED_TRACE(view.Text + ", " + GetText(bounds));
      const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds.data());
      vtkNBufferScreenBox screen;
      const bool outside = projection.IsOutside(box);
      const vtkNBufferPlacement placement = projection.Project(box, screen);
      rejected += outside || placement == vtkNBufferPlacement::Outside;
      crossing += placement == vtkNBufferPlacement::Crossing;
      if (placement == vtkNBufferPlacement::Inside)
      {
        ++inside;
        ASSERT_FALSE(screen.Pixels.IsEmpty());
        ASSERT_GE(screen.Pixels.X0, 0);
        ASSERT_GE(screen.Pixels.Y0, 0);
        ASSERT_LE(screen.Pixels.X1, view.Width);
        ASSERT_LE(screen.Pixels.Y1, view.Height);
        ASSERT_LE(screen.Nearest, screen.Farthest);
      }
      for (const auto& point : sampler.MakePoints(bounds, 60))
      {
        if (const auto exact = ProjectExactly(view, point, convention))
        {
          ++visiblePoints;
          CheckPoint(projection, placement, outside, box, screen, *exact);
        }
        for (int permutation = 0; permutation < 4; ++permutation)
        {
          if (const auto drawn = ProjectAsDevice(view, point, permutation, convention))
          {
            CheckPoint(projection, placement, outside, box, screen, *drawn);
          }
        }
        if (this->HasFatalFailure())
        {
          return;
        }
      }
    }
  }
  // The samples must not all be trivial.
  EXPECT_GT(rejected, 300);
  EXPECT_GT(visiblePoints, 10000);
  EXPECT_GT(inside + crossing, 1000);
}

INSTANTIATE_TEST_SUITE_P(Offset, NBufferProjection,
  testing::Combine(testing::Values(0.0, 1e3, 1e5, 5e6), testing::ValuesIn(DepthConventions)),
  [](const auto& info)
  {
    return std::to_string(static_cast<int>(std::get<0>(info.param))) +
      DepthConventionNames[static_cast<int>(std::get<1>(info.param))];
  });

// Hazard: slack that is safe because it is huge hides nothing.
TEST(NBufferProjectionOnce, RectangleAndDepthAreTight)
{
  ViewSampler sampler(6);
  int compared = 0;
  for (int v = 0; v < 100; ++v)
  {
    const View view = sampler.MakeView(0.0, false);
    const vtkNBufferProjection projection = MakeProjection(view);
    for (int b = 0; b < 40; ++b)
    {
      const std::array<double, 6> bounds = sampler.MakeBounds(view);
      SCOPED_TRACE(view.Text + ", " + GetText(bounds));
      vtkNBufferScreenBox screen;
      if (projection.Project(vtkNBufferBox::FromBounds(bounds.data()), screen) !=
        vtkNBufferPlacement::Inside)
      {
        continue;
      }
      glm::dvec3 low(1e300);
      glm::dvec3 high(-1e300);
      bool all = true;
      for (const auto& corner : sampler.MakePoints(bounds, 0))
      {
        const auto point = ProjectExactly(view, corner);
        all = all && point;
        if (point)
        {
          const glm::dvec3 p = { point->X, point->Y, point->Z };
          low = glm::min(low, p);
          high = glm::max(high, p);
        }
      }
      if (!all)
      {
        continue;
      }
      ++compared;
      // A sixteenth of a pixel and the float slack, then whole pixels.
      ASSERT_GE(screen.Pixels.X0, std::floor(low.x - 0.25));
      ASSERT_LE(screen.Pixels.X1, std::ceil(high.x + 0.25));
      ASSERT_GE(screen.Pixels.Y0, std::floor(low.y - 0.25));
      ASSERT_LE(screen.Pixels.Y1, std::ceil(high.y + 0.25));
      // The header's slack for interpolation, (2^-8.5 + 8 u n) R / t, is by far the largest part.
      const double interpolation =
        16.0 * (1.0 / 362.0 + 0x1p-21 * std::max(view.Width, view.Height)) * (high.z - low.z);
      ASSERT_GE(screen.Nearest, low.z - 1e-4 - 1.01 * interpolation);
    }
  }
  EXPECT_GT(compared, 200);
}

// Hazard: half of all boxes kept because they are called crossing although the eye is far.
TEST(NBufferProjectionOnce, CrossingOnlyAtTheNearPlane)
{
  ViewSampler sampler(7);
  for (int v = 0; v < 100; ++v)
  {
    const View view = sampler.MakeView(0.0, false);
    const vtkNBufferProjection projection = MakeProjection(view);
    for (int b = 0; b < 40; ++b)
    {
      const std::array<double, 6> bounds = sampler.MakeBounds(view);
      vtkNBufferScreenBox screen;
      const vtkNBufferPlacement placement =
        projection.Project(vtkNBufferBox::FromBounds(bounds.data()), screen);
      bool clear = true;
      for (const auto& corner : sampler.MakePoints(bounds, 0))
      {
        const double along =
          glm::dot(corner - view.Position, view.Direction) / glm::length(view.Direction);
        clear = clear && along > 1.01 * view.Near;
      }
      ASSERT_TRUE(!clear || placement != vtkNBufferPlacement::Crossing)
        << view.Text << ", " << GetText(bounds);
    }
  }
}

// Hazard: bounds without meaning must never lead to a cull.
TEST(NBufferProjectionOnce, NaNAndInfinityAreCrossing)
{
  ViewSampler sampler(8);
  const View view = sampler.MakeView(0.0, false);
  const vtkNBufferProjection projection = MakeProjection(view);
  const double bad[] = { std::nan(""), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (double value : bad)
  {
    for (int i = 0; i < 6; ++i)
    {
      double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
      bounds[i] = value;
      const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
      vtkNBufferScreenBox screen;
      EXPECT_FALSE(projection.IsOutside(box)) << value << " " << i;
      EXPECT_EQ(projection.Project(box, screen), vtkNBufferPlacement::Crossing)
        << value << " " << i;
    }
  }
}

// Hazard: the centre and half size of a box do not give its bounds back.
TEST(NBufferProjectionOnce, BoxContainsItsBounds)
{
  ViewSampler sampler(9);
  for (int n = 0; n < 20000; ++n)
  {
    double bounds[6];
    for (int i = 0; i < 3; ++i)
    {
      const double scale = std::pow(10.0, sampler.Uniform(-8.0, 8.0));
      bounds[2 * i] = sampler.Uniform(-1.0, 1.0) * scale;
      bounds[2 * i + 1] = bounds[2 * i] +
        std::abs(sampler.Uniform(-1.0, 1.0)) * std::pow(10.0, sampler.Uniform(-8.0, 8.0));
    }
    const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_LE(box.Center[i] - box.HalfSize[i], bounds[2 * i]);
      ASSERT_GE(box.Center[i] + box.HalfSize[i], bounds[2 * i + 1]);
      ASSERT_GE(box.Magnitude[i], std::abs(bounds[2 * i]));
      ASSERT_GE(box.Magnitude[i], std::abs(bounds[2 * i + 1]));
    }
  }
}

// Hazard: a line of eight pixels behind an edge shows four of them above it.
TEST(NBufferProjectionOnce, MarginWidensTheRectangle)
{
  ViewSampler sampler(10);
  for (int n = 0; n < 2000; ++n)
  {
    const View view = sampler.MakeView(0.0, false);
    const vtkNBufferProjection projection = MakeProjection(view);
    const std::array<double, 6> bounds = sampler.MakeBounds(view);
    vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds.data());
    vtkNBufferScreenBox plain;
    vtkNBufferScreenBox wide;
    const vtkNBufferPlacement before = projection.Project(box, plain);
    box.Margin = 4.0;
    EXPECT_FALSE(projection.IsOutside(box)) << "left to Project()";
    if (before == vtkNBufferPlacement::Inside)
    {
      // What sticks out may reach the near plane in view where the box itself does not.
      const vtkNBufferPlacement after = projection.Project(box, wide);
      ASSERT_NE(after, vtkNBufferPlacement::Outside);
      if (after == vtkNBufferPlacement::Crossing)
      {
        continue;
      }
      ASSERT_LE(wide.Pixels.X0, std::max(plain.Pixels.X0 - 3, 0));
      ASSERT_GE(wide.Pixels.X1, std::min(plain.Pixels.X1 + 3, view.Width));
      ASSERT_LE(wide.Pixels.Y0, std::max(plain.Pixels.Y0 - 3, 0));
      ASSERT_GE(wide.Pixels.Y1, std::min(plain.Pixels.Y1 + 3, view.Height));
    }
  }
}

class NBufferProjectionOfDepths : public testing::TestWithParam<Convention>
{
};

// Hazard: two props tie in a pixel in which they are said not to touch.
TEST_P(NBufferProjectionOfDepths, BoxesMeetInTheirContactAlone)
{
  ViewSampler sampler(11);
  int apart = 0;
  int smaller = 0;
  int met = 0;
  for (int n = 0; n < 6000; ++n)
  {
    const View view = sampler.MakeView(0.0, n % 2 == 0);
    const vtkNBufferProjection projection = MakeProjection(view, this->GetParam());
    const std::array<double, 6> a = sampler.MakeBounds(view);
    std::array<double, 6> b = a;
    // A neighbour: moved by about its size along one axis, every third by a part of it along all.
    const int axis = sampler.Integer(0, 2);
    for (int j = 0; j < 3; ++j)
    {
      const double size = a[2 * j + 1] - a[2 * j];
      const double shift = n % 3 == 0 ? size * sampler.Uniform(-0.9, 0.9)
        : j == axis                   ? size * sampler.Uniform(0.9, 1.3)
                                      : 0.0;
      b[2 * j] += shift;
      b[2 * j + 1] += shift;
    }
    const vtkNBufferBox boxA = vtkNBufferBox::FromBounds(a.data());
    const vtkNBufferBox boxB = vtkNBufferBox::FromBounds(b.data());
    vtkNBufferScreenBox screenA;
    vtkNBufferScreenBox screenB;
    if (projection.Project(boxA, screenA) != vtkNBufferPlacement::Inside ||
      projection.Project(boxB, screenB) != vtkNBufferPlacement::Inside)
    {
      continue;
    }
    const vtkNBufferRectangle contact = projection.GetContact(boxA, screenA, boxB, screenB);
    const bool touch = !contact.IsEmpty();
    const vtkNBufferRectangle both = screenA.Pixels.GetIntersection(screenB.Pixels);
    if (touch)
    {
      ASSERT_TRUE(contact.X0 >= both.X0 && contact.Y0 >= both.Y0 && contact.X1 <= both.X1 &&
        contact.Y1 <= both.Y1);
      smaller += contact.GetWidth() * contact.GetHeight() < both.GetWidth() * both.GetHeight();
    }
    apart += touch ? 0 : 1;
    SCOPED_TRACE(view.Text + ", " + GetText(a) + ", " + GetText(b));
    const vtkNBufferRectangle& r = screenA.Pixels;
    for (int i = 0; i < 50; ++i)
    {
      const double x = sampler.Uniform(r.X0, r.X1);
      const double y = sampler.Uniform(r.Y0, r.Y1);
      if (touch && x >= contact.X0 && x < contact.X1 && y >= contact.Y0 && y < contact.Y1)
      {
        continue;
      }
      const auto depthsA = GetDepthsAlongRay(view, a, x, y);
      const auto depthsB = GetDepthsAlongRay(view, b, x, y);
      if (depthsA && depthsB)
      {
        ++met;
        ASSERT_TRUE((*depthsA)[1] < (*depthsB)[0] || (*depthsB)[1] < (*depthsA)[0])
          << (*depthsA)[0] << " " << (*depthsA)[1] << " and " << (*depthsB)[0] << " "
          << (*depthsB)[1];
      }
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(smaller, 50);
  EXPECT_GT(met, 100);
}

INSTANTIATE_TEST_SUITE_P(Each, NBufferProjectionOfDepths, testing::ValuesIn(DepthConventions),
  [](const auto& info) { return std::string(DepthConventionNames[static_cast<int>(info.param)]); });

// Hazard: a viewport that begins far from the window's corner is rounded with larger coordinates.
TEST(NBufferProjectionOnce, SlackGrowsWithTheLargestCoordinate)
{
  ViewSampler sampler(12);
  const View view = sampler.MakeView(0.0, false);
  const glm::dvec3 center = view.Position + 20.0 * view.Direction;
  const double bounds[6] = { center.x - 1.0, center.x + 1.0, center.y - 1.0, center.y + 1.0,
    center.z - 1.0, center.z + 1.0 };
  const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
  vtkNBufferProjection projection = MakeProjection(view);
  vtkNBufferScreenBox before;
  ASSERT_EQ(projection.Project(box, before), vtkNBufferPlacement::Inside);
  projection.Set(view.WorldToClip.data(), view.Width, view.Height, 0x1p-24, 20000);
  vtkNBufferScreenBox after;
  ASSERT_EQ(projection.Project(box, after), vtkNBufferPlacement::Inside);
  EXPECT_LT(after.Nearest, before.Nearest);
  EXPECT_GT(after.Farthest, before.Farthest);
}
