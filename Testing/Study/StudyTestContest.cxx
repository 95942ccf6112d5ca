// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// All contenders on a frame whose answers are known: a wall with a hole in it.
#include "Contest.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <set>

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
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width / 2; ++x)
    {
      frame.Depth[static_cast<std::size_t>(y) * Width + x] = StudyTest::GetDepth(Wall);
    }
  }
  const auto add = [&frame](double x, double y, bool visible)
  {
    const double bounds[6] = { x, x + 4.0, y, y + 1.0, -2.0, 2.0 };
    DepthBox box;
    box.Box = vtkNBufferBox::FromBounds(bounds);
    box.Visible = visible;
    ASSERT_EQ(frame.Projection.Project(box.Box, box.Screen), vtkNBufferPlacement::Inside);
    frame.Boxes.push_back(box);
  };
  add(-60.0, 70.0, false);
  add(-50.0, 90.0, false);
  add(-30.0, 40.0, true);
  add(20.0, 70.0, true);
  add(-2.0, 70.0, true);
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
