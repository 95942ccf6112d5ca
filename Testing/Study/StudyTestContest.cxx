// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// All contenders on a frame whose answers are known: a wall with a hole in it.
#include "Contest.h"
#include "Pixels.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace
{
using namespace NBufferStudy;

constexpr int Width = 301;
constexpr int Height = 203;
constexpr double Wall = 50.0;

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
    const ProjectedBox placed(frame.Projection, { x, x + 4.0, y, y + 1.0, -2.0, 2.0 });
    EXPECT_TRUE(placed.IsInside());
    DepthBox box;
    box.Box = placed.Box;
    box.Screen = placed.Screen;
    box.Visible = visible;
    frame.Boxes.push_back(box);
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
}
