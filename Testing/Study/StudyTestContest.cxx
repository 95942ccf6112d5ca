// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// All contenders on a frame whose answers are known: a wall with a hole in it.
#include "Contest.h"
#include "DepthFormats.h"
#include "Pixels.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace
{
using namespace NBufferStudy;

constexpr int ContestWidth = 301;
constexpr int ContestHeight = 203;
constexpr double Wall = 50.0;

void PutBox(DepthFrame& frame, const std::array<double, 6>& bounds, bool visible)
{
  const ProjectedBox placed(frame.Projection, bounds);
  EXPECT_TRUE(placed.IsInside());
  frame.Boxes.push_back({ placed.Box, placed.Screen, visible });
}

/// A wall at a distance of 50, open to the right of the middle, and props behind and before it.
DepthFrame MakeFrame()
{
  DepthFrame frame;
  frame.Width = ContestWidth;
  frame.Height = ContestHeight;
  frame.Projection = StudyTest::LookAlongY(ContestWidth, ContestHeight);
  frame.Depth.assign(static_cast<std::size_t>(ContestWidth) * ContestHeight, 1.0f);
  for (const auto& [x, y] : Pixels(ContestWidth / 2, ContestHeight))
  {
    frame.Depth[static_cast<std::size_t>(y) * ContestWidth + x] = StudyTest::GetDepth(Wall);
  }
  const std::tuple<double, double, bool> boxes[] = { { -60.0, 70.0, false }, { -50.0, 90.0, false },
    { -30.0, 40.0, true }, { 20.0, 70.0, true }, { -2.0, 70.0, true } };
  for (const auto& [x, y, visible] : boxes)
  {
    PutBox(frame, { x, x + 4.0, y, y + 1.0, -2.0, 2.0 }, visible);
  }
  return frame;
}

TEST(StudyContest, WhatIsHiddenForAllAndForNone)
{
  const std::vector<ContenderPointer> contenders =
    MakeContenders(ContestWidth, ContestHeight, 1000.0);
  std::set<std::string> names;
  for (const ContenderPointer& contender : contenders)
  {
    names.insert(contender->GetName());
  }
  EXPECT_EQ(names.size(), contenders.size());
  EXPECT_EQ(names.count(GetDefaultName()), 1u);

  std::vector<DepthFrame> frames;
  frames.push_back(MakeFrame());
  const std::vector<ContestResult> results = RunContest(frames, contenders, 2, nullptr);
  ASSERT_EQ(results.size(), contenders.size());
  for (const ContestResult& result : results)
  {
    EXPECT_EQ(result.Boxes, 5) << result.Name;
    EXPECT_EQ(result.Hidden, 2) << result.Name;
    EXPECT_EQ(result.FalseHidden, 0) << result.Name;
    EXPECT_EQ(result.BuildTimes.size(), 2u) << result.Name;
    EXPECT_EQ(result.QueryTimes.size(), 2u) << result.Name;
    EXPECT_GT(result.Texels, 0u) << result.Name;
    EXPECT_GE(result.Memory, result.Texels * sizeof(float)) << result.Name;
    EXPECT_GT(result.Counts.Lookups, 0) << result.Name;
    EXPECT_GE(result.GetOverCoverage(), 0.0) << result.Name;
    if (result.Name.find("mips") == std::string::npos)
    {
      EXPECT_EQ(result.FalseVisible, 0) << result.Name;
    }
  }
}

TEST(StudyContest, WhatIsTooLargeIsLeftOut)
{
  EXPECT_LT(MakeContenders(1024, 1024, 20.0).size(), MakeContenders(1024, 1024, 1000.0).size());
}

//------------------------------------------------------------------------------------------------
// Formats of depth: the formulas agree with each other, and what is visible stays so in all of
// them.

constexpr DepthPlanes Planes = { 1.0, 1000.0 };

TEST(StudyFormats, DepthsGrowWithTheDistanceAndHaveIt)
{
  for (const DepthFormat& format : GetDepthFormats())
  {
    double before = format.GetSign() < 0.0 ? -1.1 : -0.1;
    for (const double distance : { 1.0, 1.5, 10.0, 300.0, 1000.0 })
    {
      const double depth = format.GetDepth(Planes, distance);
      EXPECT_NEAR(format.GetDistance(Planes, depth), distance, 1e-9 * distance) << format.GetName();
      EXPECT_GT(format.GetSign() * depth, before) << format.GetName();
      before = format.GetSign() * depth;
    }
    EXPECT_LE(before, format.GetSign() * format.GetBackground() + 1e-12) << format.GetName();
  }
}

TEST(StudyFormats, ResolutionIsTheStepOfStoredDepths)
{
  for (const DepthFormat& format : GetDepthFormats())
  {
    for (const double distance : { 3.0, 50.0, 700.0 })
    {
      const double depth = format.GetDepth(Planes, distance);
      const double step = format.GetSign() * format.GetQuantum(depth);
      const double next = format.GetDistance(Planes, depth + step) - distance;
      const double last = distance - format.GetDistance(Planes, depth - step);
      EXPECT_NEAR(format.GetResolution(Planes, distance) / (0.5 * (next + last)), 1.0, 0.05)
        << format.GetName() << " at " << distance;
      // What has this depth can be that much farther, but not much more.
      EXPECT_GE(format.GetFarthest(Planes, depth), distance + 0.99 * next) << format.GetName();
      EXPECT_LE(format.GetFarthest(Planes, depth), distance + 3.0 * next + 2e-5 * distance)
        << format.GetName();
    }
  }
}

TEST(StudyFormats, StepsOfFloatsAreThoseOfTheMachine)
{
  const DepthFormat format = { DepthEncoding::Reversed, 0 };
  for (const float depth : { 1.0f, 0.75f, 0.1f, 1e-6f })
  {
    EXPECT_EQ(format.GetQuantum(depth), std::nextafter(depth, 2.0f) - depth);
  }
}

/// A frame with boxes well before and well behind a distance of 100.
DepthFrame MakeBoxes()
{
  DepthFrame frame;
  frame.Width = 120;
  frame.Height = 90;
  frame.Projection = StudyTest::LookAlongY(120, 90);
  for (double y : { 60.0, 99.0, 101.0, 200.0 })
  {
    PutBox(frame, { 0.0, 5.0, y, y + 0.5, 0.0, 5.0 }, y < 100.0);
  }
  return frame;
}

/// The same frame with everything at one distance, as a buffer of this format stores it.
DepthFrame MakeEvenFrame(const DepthFrame& frame, const DepthFormat& format,
  const DepthPlanes& planes, double distance = 100.0)
{
  const double depth = format.GetDepth(planes, distance);
  const double quantum = format.GetQuantum(depth);
  const std::vector<double> stored(120 * 90, std::round(depth / quantum) * quantum);
  return MakeFrame(frame, format, planes, stored);
}

long long CountFalseHidden(const DepthFrame& frame)
{
  std::vector<ContenderPointer> contenders;
  contenders.push_back(MakeFamilyContender(DepthFamily()));
  return RunContest({ frame }, contenders, 0, nullptr).front().FalseHidden;
}

TEST(StudyFormats, NoSurfaceIsHiddenByItsOwnDepth)
{
  for (const DepthFormat& format : GetDepthFormats())
  {
    // Some of these are stored nearer than they are.
    for (double distance = 60.0; distance < 160.0; distance += 1.37)
    {
      DepthFrame frame = MakeBoxes();
      frame.Boxes.clear();
      PutBox(frame, { 0.0, 5.0, distance, distance + 1e-3, 0.0, 5.0 }, true);
      EXPECT_EQ(CountFalseHidden(MakeEvenFrame(frame, format, Planes, distance)), 0)
        << format.GetName() << " at " << distance;
    }
  }
}

TEST(StudyFormats, NothingVisibleIsHiddenByRounding)
{
  for (const double near : { 1.0, 0.1, 1e-3, 1e-5 })
  {
    for (const DepthFormat& format : GetDepthFormats())
    {
      std::vector<DepthFrame> frames = { MakeEvenFrame(MakeBoxes(), format, { near, 1000.0 }) };
      EXPECT_EQ(frames.front().Boxes.size(), 4u);
      std::vector<ContenderPointer> contenders;
      contenders.push_back(MakeFamilyContender(DepthFamily()));
      const ContestResult result = RunContest(frames, contenders, 1, nullptr).front();
      EXPECT_EQ(result.FalseHidden, 0) << format.GetName() << ", near " << near;
      EXPECT_TRUE(result.FalseVisible == 0 || near != 1.0 || format.Bits == 16) << format.GetName();
    }
  }
}

TEST(StudyFormats, NothingIsBehindWhatWasNotDrawn)
{
  for (const DepthFormat& format : GetDepthFormats())
  {
    std::vector<DepthFrame> frames = { MakeFrame(
      MakeBoxes(), format, Planes, std::vector<double>(120 * 90, format.GetBackground())) };
    std::vector<ContenderPointer> contenders;
    contenders.push_back(MakeFamilyContender(DepthFamily()));
    EXPECT_EQ(RunContest(frames, contenders, 1, nullptr).front().FalseVisible, 2)
      << format.GetName();
  }
}

TEST(StudyFormats, SlackGrowsWithTheRatioWhereDepthsAreNotRelative)
{
  for (const DepthFormat& format : GetDepthFormats())
  {
    const auto slack = [&](double near)
    {
      const DepthPlanes planes = { near, 1000.0 };
      const std::vector<double> slacks =
        GetSlacks(MakeEvenFrame(MakeBoxes(), format, planes), format, planes);
      EXPECT_GE(*std::min_element(slacks.begin(), slacks.end()), 0.0) << format.GetName();
      return *std::max_element(slacks.begin(), slacks.end());
    };
    // A logarithmic depth has its steps for 8 powers of ten instead of 3.
    const bool grows = format.Encoding == DepthEncoding::Forward ||
      (format.Encoding == DepthEncoding::Reversed && format.Bits > 0);
    const double growth = slack(1e-5) / slack(1.0);
    EXPECT_EQ(growth > 3.0, grows) << format.GetName() << ": " << growth;
  }
}
}
