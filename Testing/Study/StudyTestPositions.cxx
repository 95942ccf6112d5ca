// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PositionedLevels.h"
#include "StudyImage.h"

#include <gtest/gtest.h>

namespace
{
using NBufferStudy::PositionedDepth;
using NBufferStudy::PositionedLevels;
using StudyTest::Image;

TEST(StudyPositions, TheFarthestPixelAndItsPlace)
{
  std::mt19937 random(3);
  for (int factor : { 1, 3, 4 })
  {
    const Image image(53, 31, 5);
    PositionedLevels levels;
    levels.Build(image.Depth.data(), image.Width, image.Height, factor);
    for (int i = 0; i < 500; ++i)
    {
      const vtkNBufferRectangle r = StudyTest::MakeRectangle(image, random);
      long long lookups = 0;
      const PositionedDepth found = levels.Query(r, lookups);
      EXPECT_GE(found.Depth, image.Scan(r));
      EXPECT_EQ(found.Depth, image.Depth[found.Pixel]);
      EXPECT_LE(lookups, 4);
    }
  }
}

TEST(StudyPositions, TheFirstOfEqualDepths)
{
  Image image(9, 7, 1);
  std::fill(image.Depth.begin(), image.Depth.end(), 0.5f);
  PositionedLevels levels;
  levels.Build(image.Depth.data(), image.Width, image.Height, 1);
  long long lookups = 0;
  EXPECT_EQ(levels.Query({ 2, 3, 6, 7 }, lookups).Pixel, 3 * 9 + 2);
}
}
