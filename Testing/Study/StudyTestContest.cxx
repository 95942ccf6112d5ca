// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// All contenders on a frame whose answers are known: a wall with a hole in it.
#include "Contest.h"
#include "DepthFormats.h"
#include "Pixels.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace
{
using namespace NBufferStudy;

constexpr int Width = 301;
constexpr int Height = 203;
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
  frame.Width = Width;
  frame.Height = Height;
  frame.Projection = StudyTest::LookAlongY(Width, Height);
  frame.Depth.assign(static_cast<std::size_t>(Width) * Height, 1.0f);
  for (const auto& [x, y] : Pixels(Width / 2, Height))
  {
    frame.Depth[static_cast<std::size_t>(y) * Width + x] = StudyTest::GetDepth(Wall);
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
  const std::vector<ContenderPointer> contenders = MakeContenders(Width, Height, 1000.0);
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
// Formats of depth: what is visible stays so in all of them, and distances survive.

/// Everything at one distance, and boxes well before and well behind it.
DepthFrame MakeEvenFrame()
{
  DepthFrame frame;
  frame.Width = 120;
  frame.Height = 90;
  frame.Projection = StudyTest::LookAlongY(120, 90);
  frame.Depth.assign(120 * 90, StudyTest::GetDepth(100.0));
  for (double y : { 60.0, 99.0, 101.0, 200.0 })
  {
    PutBox(frame, { 0.0, 5.0, y, y + 0.5, 0.0, 5.0 }, y < 100.0);
  }
  return frame;
}

TEST(StudyFormats, NothingVisibleIsHiddenByRounding)
{
  const DepthFrame frame = MakeEvenFrame();
  for (double near : { 1.0, 0.1, 1e-3, 1e-5 })
  {
    for (const DepthFormat& format : GetDepthFormats())
    {
      std::vector<DepthFrame> frames = { Convert(frame, 1.0, 1000.0, near, format) };
      EXPECT_EQ(frames.front().Boxes.size(), frame.Boxes.size());
      std::vector<ContenderPointer> contenders;
      contenders.push_back(MakeFamilyContender(DepthFamily()));
      const ContestResult result = RunContest(frames, contenders, 1, nullptr).front();
      EXPECT_EQ(result.FalseHidden, 0) << format.Name << ", near " << near;
      EXPECT_TRUE(result.FalseVisible == 0 || near != 1.0 || format.Bits == 16) << format.Name;
    }
  }
}

TEST(StudyFormats, SlackGrowsWithTheRatioButForReversedFloats)
{
  const DepthFrame frame = MakeEvenFrame();
  for (const DepthFormat& format : GetDepthFormats())
  {
    const auto slack = [&](double near)
    {
      const std::vector<double> slacks =
        GetSlacks(Convert(frame, 1.0, 1000.0, near, format), near, 1000.0, format);
      EXPECT_GE(*std::min_element(slacks.begin(), slacks.end()), 0.0) << format.Name;
      return *std::max_element(slacks.begin(), slacks.end());
    };
    const double growth = slack(1e-3) / slack(1.0);
    const bool isReversedFloat = format.Bits == 0 && format.Convention != DepthConvention::Forward;
    EXPECT_EQ(growth < 2.0, isReversedFloat) << format.Name << ": " << growth;
  }
}
}
