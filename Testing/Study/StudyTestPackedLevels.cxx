// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Levels side by side in one texture answer as those in the module's arrays, bit for bit.
#include "DepthTarget.h"
#include "OffscreenFixture.h"
#include "PackedLevels.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <utility>

namespace
{
using NBufferPeers::PackedLevels;

TEST_F(OffscreenFixture, PackedLevelsAnswerAsArrays)
{
  const vtkSmartPointer<vtkOpenGLRenderWindow> window = NewWindow(32, 32);
  PackedLevels packed;
  vtkNew<vtkNBufferTexture> arrays;
  for (const auto& [width, height] : { std::pair(2, 2), std::pair(37, 22), std::pair(64, 64),
         std::pair(301, 173), std::pair(2000, 9) })
  {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    const std::string obstacle = PackedLevels::WhyNot(width, height);
    if (!obstacle.empty())
    {
      GTEST_SKIP() << obstacle;
    }
    const DepthTarget target(GetTargetFormats()[3], width, height, true);
    target.Fill(static_cast<unsigned int>(width));
    target.Bind(0, 0, width, height);
    ASSERT_TRUE(arrays->Build(window, 1, 64, vtkNBufferExtremum::Maximum)) << arrays->GetError();
    packed.Build(window, arrays);
    packed.Query(window, nullptr);
    const std::vector<float> depths = packed.ReadDepths();
    packed.Query(window, arrays);
    EXPECT_EQ(depths, packed.ReadDepths());
    // The rectangles are not all alike.
    EXPECT_GT(*std::max_element(depths.begin(), depths.end()),
      *std::min_element(depths.begin(), depths.end()));
  }
  packed.Release();
  arrays->ReleaseGraphicsResources(window);
}
}
