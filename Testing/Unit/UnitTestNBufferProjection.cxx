// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// From boxes to rectangles and depths: conservative for every sampled point, and not too much so.
#include "Pixels.h"
#include "SampledViews.h"
#include "vtkNBufferLevels.h"
#include "vtkNBufferPixelTest.h"
#include "vtkNBufferSurface.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace
{
using Convention = DepthConvention;
using NBufferStudy::DepthConventionNames;
using NBufferStudy::DepthConventions;

/// All that is claimed of a box, for one of its points.
void CheckPoint(const vtkNBufferProjection& projection, const ProjectedBox& box, bool outside,
  const glm::dvec3& point)
{
  ASSERT_FALSE(outside) << "rejected, but a point of it is drawn";
  ASSERT_NE(box.Placement, vtkNBufferPlacement::Outside) << "rejected, but a point of it is drawn";
  if (!box.IsInside())
  {
    return;
  }
  ASSERT_TRUE(IsWithin(point, box.Screen)) << testing::PrintToString(point);
  for (int face = 0; face < 6; ++face)
  {
    if (const auto plane = projection.GetFacePlane(box.Box, box.Screen, face))
    {
      ASSERT_GE(point.z, plane->Depth + plane->SlopeX * point.x + plane->SlopeY * point.y)
        << "face " << face;
    }
  }
}

using NBufferProjection = testing::TestWithParam<std::tuple<double, Convention>>;
using NBufferProjectionOfDepths = testing::TestWithParam<Convention>;

/// Calls function(projection, view, box) for boxes that lie in one of `count` views of a moderate
/// range.
template <typename Function>
void ForEachBox(ViewSampler& sampler, int count, Function function)
{
  for (int v = 0; v < count; ++v)
  {
    const View view = sampler.MakeView(0.0, false);
    const vtkNBufferProjection projection = MakeProjection(view);
    for (int b = 0; b < 40; ++b)
    {
      const ProjectedBox box(projection, sampler.MakeBounds(view));
      SCOPED_TRACE(GetText(view, box.Bounds));
      function(projection, view, box);
    }
  }
}
}

// Hazard: a point is outside of its box's rectangle, or nearer than the box's nearest depth, and is
// culled although it is seen; or a frustum test that divides by w loses boxes that reach behind the
// eye.
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
      const ProjectedBox box(projection, sampler.MakeBounds(view));
      SCOPED_TRACE(GetText(view, box.Bounds));
      const bool outside = projection.IsOutside(box.Box);
      rejected += outside || box.Placement == vtkNBufferPlacement::Outside;
      crossing += box.Placement == vtkNBufferPlacement::Crossing;
      if (box.IsInside())
      {
        ++inside;
        ASSERT_FALSE(box.Screen.Pixels.IsEmpty());
        ASSERT_TRUE(IsIn(box.Screen.Pixels, { 0, 0, view.Width, view.Height }));
        ASSERT_LE(box.Screen.Nearest, box.Screen.Farthest);
      }
      for (const auto& point : sampler.MakePoints(box.Bounds, 60))
      {
        const auto exact = ProjectExactly(view, point, convention);
        visiblePoints += exact.has_value();
        for (int permutation = -1; permutation < 4; ++permutation)
        {
          const auto drawn =
            permutation < 0 ? exact : ProjectAsDevice(view, point, permutation, convention);
          if (drawn)
          {
            ASSERT_NO_FATAL_FAILURE(CheckPoint(projection, box, outside, *drawn));
          }
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

// Hazard: the slack is so large that nothing is found hidden.
TEST(NBufferProjectionOnce, RectangleAndDepthAreTight)
{
  ViewSampler sampler(6);
  int compared = 0;
  ForEachBox(sampler, 100,
    [&](const vtkNBufferProjection&, const View& view, const ProjectedBox& box)
    {
      glm::dvec3 low(1e300);
      glm::dvec3 high(-1e300);
      bool all = box.IsInside();
      for (const auto& corner : sampler.MakePoints(box.Bounds, 0))
      {
        const auto point = ProjectExactly(view, corner);
        all = all && point;
        low = glm::min(low, point.value_or(low));
        high = glm::max(high, point.value_or(high));
      }
      if (!all)
      {
        return;
      }
      ++compared;
      // A sixteenth of a pixel and the float slack, then whole pixels.
      const vtkNBufferRectangle& r = box.Screen.Pixels;
      ASSERT_GE(r.X0, std::floor(low.x - 0.25));
      ASSERT_LE(r.X1, std::ceil(high.x + 0.25));
      ASSERT_GE(r.Y0, std::floor(low.y - 0.25));
      ASSERT_LE(r.Y1, std::ceil(high.y + 0.25));
      // The header's slack for interpolation, (2^-8.5 + 8 u n) R / t, is by far the largest part.
      const double interpolation =
        16.0 * (1.0 / 362.0 + 0x1p-21 * std::max(view.Width, view.Height)) * (high.z - low.z);
      ASSERT_GE(box.Screen.Nearest, low.z - 1e-4 - 1.01 * interpolation);
    });
  EXPECT_GT(compared, 200);
}

// Hazard: half of all boxes are classified as crossing, and kept, although the eye is far away from
// them.
TEST(NBufferProjectionOnce, CrossingOnlyAtTheNearPlane)
{
  ViewSampler sampler(7);
  ForEachBox(sampler, 100,
    [&](const vtkNBufferProjection&, const View& view, const ProjectedBox& box)
    {
      const std::vector<glm::dvec3> corners = sampler.MakePoints(box.Bounds, 0);
      const bool clear = std::all_of(corners.begin(), corners.end(),
        [&view](const glm::dvec3& corner) {
          return glm::dot(corner - view.Position, glm::normalize(view.Direction)) >
            1.01 * view.Near;
        });
      ASSERT_TRUE(!clear || box.Placement != vtkNBufferPlacement::Crossing);
    });
}

// Hazard: a prop whose bounds are not finite is culled.
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
      std::array<double, 6> bounds = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
      bounds[i] = value;
      const ProjectedBox box(projection, bounds);
      EXPECT_FALSE(projection.IsOutside(box.Box)) << value << " " << i;
      EXPECT_EQ(box.Placement, vtkNBufferPlacement::Crossing) << value << " " << i;
    }
    // As of a unit that is finite, in a prop with a point that is not.
    const ProjectedBox finite(projection, sampler.MakeBounds(view));
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkNBufferBox unit = finite.Box;
      unit.Magnitude[axis] = value;
      vtkNBufferScreenBox screen;
      EXPECT_FALSE(projection.IsOutside(unit)) << value << " " << axis;
      EXPECT_EQ(projection.Project(unit, screen), vtkNBufferPlacement::Crossing) << value;
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

// Hazard: a line of eight pixels behind an edge is seen: four of its pixels are above the edge.
TEST(NBufferProjectionOnce, MarginWidensTheRectangle)
{
  ViewSampler sampler(10);
  ForEachBox(sampler, 50,
    [](const vtkNBufferProjection& projection, const View& view, const ProjectedBox& plain)
    {
      vtkNBufferBox box = plain.Box;
      box.Margin = 4.0;
      EXPECT_FALSE(projection.IsOutside(box)) << "left to Project()";
      vtkNBufferScreenBox wide;
      // What sticks out may reach the near plane in view where the box itself does not.
      const vtkNBufferPlacement after = projection.Project(box, wide);
      if (plain.IsInside() && after != vtkNBufferPlacement::Crossing)
      {
        ASSERT_NE(after, vtkNBufferPlacement::Outside);
        const vtkNBufferRectangle& r = plain.Screen.Pixels;
        const vtkNBufferRectangle all = { 0, 0, view.Width, view.Height };
        ASSERT_TRUE(
          IsIn(all.GetIntersection({ r.X0 - 3, r.Y0 - 3, r.X1 + 3, r.Y1 + 3 }), wide.Pixels));
      }
    });
}

// Hazard: two props tie in a pixel in which they are said not to touch, or nearer than it is said.
TEST_P(NBufferProjectionOfDepths, BoxesMeetInTheirContactAlone)
{
  ViewSampler sampler(11);
  int apart = 0;
  int smaller = 0;
  int met = 0;
  int farther = 0;
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
    const ProjectedBox boxA(projection, a);
    const ProjectedBox boxB(projection, b);
    if (!boxA.IsInside() || !boxB.IsInside())
    {
      continue;
    }
    const vtkNBufferScreenBox shared =
      projection.GetContact(boxA.Box, boxA.Screen, boxB.Box, boxB.Screen).Screen;
    const vtkNBufferRectangle& contact = shared.Pixels;
    const double nearest = shared.Nearest;
    const bool touch = !contact.IsEmpty();
    const vtkNBufferRectangle both = boxA.Screen.Pixels.GetIntersection(boxB.Screen.Pixels);
    ASSERT_TRUE(!touch || IsIn(contact, both));
    smaller +=
      touch && contact.GetWidth() * contact.GetHeight() < both.GetWidth() * both.GetHeight();
    apart += !touch;
    farther += touch && nearest > std::max(boxA.Screen.Nearest, boxB.Screen.Nearest);
    ASSERT_TRUE(!touch || nearest >= std::max(boxA.Screen.Nearest, boxB.Screen.Nearest));
    SCOPED_TRACE(GetText(view, a) + " and " + GetText(view, b));
    const vtkNBufferRectangle& r = boxA.Screen.Pixels;
    for (int i = 0; i < 50; ++i)
    {
      const double x = sampler.Uniform(r.X0, r.X1);
      const double y = sampler.Uniform(r.Y0, r.Y1);
      const auto depthsA = GetDepthsAlongRay(view, a, x, y);
      const auto depthsB = GetDepthsAlongRay(view, b, x, y);
      const bool inContact = touch && IsIn(static_cast<int>(x), static_cast<int>(y), contact);
      if (!inContact && depthsA && depthsB)
      {
        ++met;
        ASSERT_TRUE((*depthsA)[1] < (*depthsB)[0] || (*depthsB)[1] < (*depthsA)[0])
          << testing::PrintToString(*depthsA) << " and " << testing::PrintToString(*depthsB);
      }
      if (inContact && depthsA && depthsB && this->GetParam() == DepthConvention::Forward)
      {
        // The rays of a depth buffer have these depths as orders.
        const double first = std::max((*depthsA)[0], (*depthsB)[0]);
        ASSERT_TRUE(first > std::min((*depthsA)[1], (*depthsB)[1]) || first >= nearest);
      }
    }
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(smaller, 50);
  EXPECT_GT(met, 100);
  EXPECT_GT(farther, 20);
}

INSTANTIATE_TEST_SUITE_P(Each, NBufferProjectionOfDepths, testing::ValuesIn(DepthConventions),
  [](const auto& info) { return std::string(DepthConventionNames[static_cast<int>(info.param)]); });

// Hazard: a user matrix flattens a prop, and its inverse, which gives the planes of the faces of
// the boxes in it, is nothing but rounding errors (found by fuzzing).
TEST(NBufferProjectionOnce, FacesHoldWhereTheMatrixIsNearlySingular)
{
  ViewSampler sampler(23);
  int checked = 0;
  for (int n = 0; n < 3000; ++n)
  {
    View view = sampler.MakeView(0.0, n % 2 == 0);
    const std::array<double, 6> bounds = sampler.MakeBounds(view);
    sampler.Flatten(view, bounds);
    const vtkNBufferProjection projection = MakeProjection(view);
    const ProjectedBox box(projection, bounds);
    SCOPED_TRACE(GetText(view, box.Bounds));
    for (const auto& point : sampler.MakePoints(bounds, 30))
    {
      if (const auto exact = ProjectExactly(view, point))
      {
        checked += box.IsInside();
        ASSERT_NO_FATAL_FAILURE(CheckPoint(projection, box, false, *exact));
      }
    }
  }
  EXPECT_GT(checked, 10000);
}

// Hazard: the slack is several times as large as its derivation in vtkNBufferBoxError.h says, which
// is safe but hides less. Each part of it is compared with the number of the derivation.
TEST(NBufferProjectionOnce, SlackIsThatOfItsDerivation)
{
  constexpr double u = 0x1p-24;
  constexpr double quantum = 0x1p-16;
  constexpr double range = 0.25;
  const vtkNBufferDepthFormat format = vtkNBufferDepthFormat::FromQuantum(quantum);
  EXPECT_DOUBLE_EQ(format.Slack, 2.0 * quantum + 4.0 * u);
  EXPECT_EQ(format.RelativeSlack, 0.0);
  vtkNBufferBoxError error;
  error.Set(format, { 0, 0 }, { 1000, 750 }, 8);
  const double interpolation = 16.0 * (std::exp2(-8.5) + 8.0 * u * 1000.0) * range;
  EXPECT_NEAR(error.GetDepthSlack(0.5, range), format.Slack + interpolation, 1e-3 * interpolation);
  EXPECT_DOUBLE_EQ(error.GetDepthSlack(0.5, 0.0), format.Slack);
  // The order of reversed depth is z / w itself, and its slack grows with the depth.
  const auto reversed =
    vtkNBufferDepthFormat::FromQuantum(quantum, vtkNBufferStoredDepth::Reversed);
  EXPECT_EQ(reversed.Scale, 1.0);
  EXPECT_EQ(reversed.Offset, 0.0);
  error.Set(reversed, { 0, 0 }, { 1000, 750 }, 8);
  EXPECT_DOUBLE_EQ(error.GetDepthSlack(-0.5, 0.0), 2.0 * quantum + 3.0 * u);
  EXPECT_NEAR(error.GetDepthSlack(0.0, range), 2.0 * quantum + interpolation, 1e-3 * interpolation);
  error.Set(format, { 0, 0 }, { 1000, 750 }, 8);
  vtkNBufferBox box;
  box.Origin = { 1.0, 0.0, 0.0 };
  box.Magnitude = { 1.0, 2.0, 3.0 };
  const double vertexError = (6.0 * (1 + 4 + 9) + 4.0 * 3) * u;
  EXPECT_NEAR(vtkNBufferBoxError::GetVertexError({ 1.0, -2.0, 3.0, -4.0 }, box), vertexError,
    0x1p-15 * vertexError);
}

// Hazard: amid a box the slack of a point is larger than at all of its corners. High above the
// origin w has a large error, which counts most where a point is near and far aside.
TEST(NBufferProjectionOnce, SlackHoldsAmidTheBox)
{
  const glm::dvec3 eye(-0.1750805, -0.1736855, 25480.3542);
  const glm::dvec3 way(0.475888, 0.472096, -0.742062);
  const glm::dmat4 worldToClip = glm::perspective(glm::radians(93.16), 1000.0 / 750.0, 0.05, 50.0) *
    glm::lookAt(eye, eye + way, glm::dvec3(0.0, 0.0, 1.0));
  const glm::dmat4 rows = glm::transpose(worldToClip);
  vtkNBufferProjection projection;
  projection.Set(
    glm::value_ptr(rows), 1000, 750, vtkNBufferDepthFormat::FromQuantum(0x1p-24), glm::ivec2(0), 8);
  const double bounds[6] = { 0.0, 26.956, 0.0, 0.0, 25480.004915, 25480.081222 };
  const vtkNBufferBox box = vtkNBufferBox::FromBounds(bounds);
  vtkNBufferScreenBox screen;
  ASSERT_EQ(projection.Project(box, screen), vtkNBufferPlacement::Inside);
  const auto getError = [&](int row)
  { return vtkNBufferBoxError::GetVertexError(projection.GetWorldToClip()[row], box); };
  const double allowed = screen.Slack.x - 2.0 * screen.Border / 1000.0;
  for (int i = 0; i <= 1000; ++i)
  {
    const glm::dvec4 clip = worldToClip * glm::dvec4(26.956e-3 * i, 0.0, bounds[4], 1.0);
    const double slack =
      (getError(0) + std::abs(clip.x / clip.w) * getError(3)) / (clip.w - getError(3));
    ASSERT_LE(slack, allowed) << i;
  }
}

// Hazard: a viewport that begins far from the window's corner is rounded with larger coordinates.
TEST(NBufferProjectionOnce, SlackGrowsWithTheOriginOfTheViewport)
{
  ViewSampler sampler(12);
  const View view = sampler.MakeView(0.0, false);
  const glm::dvec3 center = view.Position + 20.0 * view.Direction;
  const std::array<double, 6> bounds = { center.x - 1.0, center.x + 1.0, center.y - 1.0,
    center.y + 1.0, center.z - 1.0, center.z + 1.0 };
  vtkNBufferProjection projection = MakeProjection(view);
  const ProjectedBox before(projection, bounds);
  ASSERT_TRUE(before.IsInside());
  projection.Set(view.WorldToClip.data(), view.Width, view.Height,
    vtkNBufferDepthFormat::FromQuantum(0x1p-24), { 0, 20000 });
  const ProjectedBox after(projection, bounds);
  ASSERT_TRUE(after.IsInside());
  EXPECT_LT(after.Screen.Nearest, before.Screen.Nearest);
  EXPECT_GT(after.Screen.Farthest, before.Screen.Farthest);
}

// Hazard: a box gets the border of a fine subpixel grid although the device places vertices
// elsewhere; or the grid is fine, and the box gets a wide border.
TEST(NBufferProjectionOnce, BorderIsThatOfTheSubpixelGridInView)
{
  const auto getBorder = [](int subpixelBits, double left, double right, double far = 0.6)
  {
    const ProjectedBox box(MapWorldToPixels(100, 100, subpixelBits),
      std::array<double, 6>{ left, right, 10, 20, 0.5, far });
    EXPECT_TRUE(box.IsInside());
    return box.Screen.Border;
  };
  constexpr double rounding = 16.0 * 0x1p-24 * 100.0;
  EXPECT_DOUBLE_EQ(getBorder(8, 10.0, 20.0), 0x1p-8 + rounding);
  EXPECT_DOUBLE_EQ(getBorder(6, 10.0, 20.0), 0x1p-6 + rounding);
  EXPECT_DOUBLE_EQ(getBorder(4, 10.0, 20.0), 0x1p-4);
  EXPECT_DOUBLE_EQ(getBorder(8, -1e-3, 20.0), 0x1p-4) << "reaches beyond the left side";
  EXPECT_DOUBLE_EQ(getBorder(8, 10.0, 100.001), 0x1p-4) << "reaches beyond the right side";
  EXPECT_DOUBLE_EQ(getBorder(8, 10.0, 20.0, 1.001), 0x1p-4) << "reaches beyond the far plane";

  vtkNBufferBox line =
    ProjectedBox(MapWorldToPixels(100, 100, 8), { 10, 20, 10, 20, 0.5, 0.6 }).Box;
  line.Margin = 1.0;
  vtkNBufferScreenBox screen;
  ASSERT_EQ(MapWorldToPixels(100, 100, 8).Project(line, screen), vtkNBufferPlacement::Inside);
  EXPECT_DOUBLE_EQ(screen.Border, 1.0 + 0x1p-4);
}

// Hazard: the rectangle of a box is widened for the grid to which devices snap vertices, but its
// outline is not: a pixel whose middle is a twentieth of a pixel outside of the outline counts as
// not covered.
TEST(NBufferProjectionOnce, OutlinesAreWidenedForTheSubpixelGrid)
{
  constexpr int size = 32;
  const vtkNBufferProjection projection = MapWorldToPixels(size, size);
  std::vector<float> depth(size * size, 0.1f);
  depth[15 * size + 20] = 1.0f; // The only pixel that is not before the box.
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), size, size, 1, vtkNBufferExtremum::Maximum);
  levels.BuildLevels(5);
  vtkNBufferPixelTest test(projection, levels, depth.data(), 0.0);
  const auto makeBox = [&projection](double right) {
    return ProjectedBox(projection, { 10.0, right, 10.0, 20.0, 0.5, 0.6 });
  };
  const auto isHidden = [&](double right)
  {
    const ProjectedBox box = makeBox(right);
    return test.IsHidden(box.Box, box.Screen);
  };
  EXPECT_FALSE(isHidden(20.5 - 0.05)) << "a vertex may be snapped to the middle";
  EXPECT_TRUE(isHidden(20.5 - 0.08)) << "none is snapped so far";

  vtkNBufferMesh mesh;
  mesh.Points = { { 10.0, 10.0, 0.5 }, { 20.45, 15.5, 0.5 }, { 10.0, 20.0, 0.6 } };
  mesh.Triangles = { { 0, 1, 2 } };
  const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  std::size_t first = 0;
  EXPECT_TRUE(test.MayBeSeen(mesh, identity, makeBox(20.45).Screen, first, 1)) << "nor a corner";
}

// Hazard: a device may snap a box to the middle of a pixel, and the box is said to be between the
// middles; or a box between the middles is said to be drawn.
TEST(NBufferProjectionOnce, MiddlesAreThoseThatAVertexMaySnapTo)
{
  const auto getMiddles = [](double left, double right)
  {
    const ProjectedBox box(
      MapWorldToPixels(100, 100, 8), std::array<double, 6>{ left, right, 10, 20, 0.5, 0.6 });
    EXPECT_TRUE(box.IsInside());
    EXPECT_FALSE(box.Screen.Pixels.IsEmpty());
    return box.Screen.Middles;
  };
  constexpr double less = 0.9 / 256; // of a pixel
  constexpr double more = 1.1 / 256;
  EXPECT_EQ(getMiddles(30.5 - 5.0, 30.5 + 5.0).GetWidth(), 11);
  EXPECT_EQ(getMiddles(30.5 - 5.0 + less, 30.5 + 5.0 - less).GetWidth(), 11);
  EXPECT_EQ(getMiddles(30.5 - 5.0 + more, 30.5 + 5.0 - more).GetWidth(), 9);
  EXPECT_EQ(getMiddles(30.5 + more, 31.5 - more).GetWidth(), 0);
  EXPECT_TRUE(getMiddles(30.5 + more, 31.5 - more).IsEmpty());
  const vtkNBufferRectangle one = getMiddles(30.5 + less, 31.5 - more);
  EXPECT_EQ(one.X0, 30);
  EXPECT_EQ(one.X1, 31);
  EXPECT_EQ(one.Y0, 10);
  EXPECT_EQ(one.Y1, 20);
}
