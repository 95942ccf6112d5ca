// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Formats of depth: what is visible stays so in all of them, and distances survive.
#include "Contest.h"
#include "DepthFormats.h"
#include "StudyView.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace NBufferStudy;

/// Everything at one distance, and boxes well before and well behind it.
DepthFrame MakeFrame()
{
  DepthFrame frame;
  frame.Width = 120;
  frame.Height = 90;
  frame.Projection = StudyTest::LookAlongY(120, 90);
  frame.Depth.assign(120 * 90, StudyTest::GetDepth(100.0));
  for (double y : { 60.0, 99.0, 101.0, 200.0 })
  {
    const ProjectedBox placed(frame.Projection, { 0.0, 5.0, y, y + 0.5, 0.0, 5.0 });
    DepthBox box;
    box.Box = placed.Box;
    box.Screen = placed.Screen;
    box.Visible = y < 100.0;
    frame.Boxes.push_back(box);
  }
  return frame;
}

TEST(StudyFormats, NothingVisibleIsHiddenByRounding)
{
  const DepthFrame frame = MakeFrame();
  for (double near : { 1.0, 0.1, 1e-3, 1e-5 })
  {
    for (const DepthFormat& format : GetDepthFormats())
    {
      std::vector<DepthFrame> frames = { Convert(frame, 1.0, 1000.0, near, format) };
      EXPECT_EQ(frames.front().Boxes.size(), frame.Boxes.size());
      std::vector<ContenderPointer> contenders;
      contenders.push_back(MakeFamilyContender(DepthFamily(), 1));
      const ContestResult result = RunContest(frames, contenders, 1, nullptr).front();
      EXPECT_EQ(result.FalseHidden, 0) << format.Name << ", near " << near;
      EXPECT_TRUE(result.FalseVisible == 0 || near != 1.0 || format.Bits == 16) << format.Name;
    }
  }
}

TEST(StudyFormats, SlackGrowsWithTheRatioButForReversedFloats)
{
  const DepthFrame frame = MakeFrame();
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
