// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which of many boxes probably hide the others.
#include "vtkNBufferCoarseDepth.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Side = 128; // of the screen, in pixels
constexpr int Share = 8;

vtkNBufferCoarseDepth MakeDepth(const vtkNBufferRectangle& pixels, double farthest)
{
  vtkNBufferCoarseDepth depth(Side, Side);
  depth.Add(pixels, farthest);
  return depth;
}
}

// Hazard: all houses of a row are drawn although the first one hides the others.
TEST(NBufferCoarseDepth, TheFirstOfARowHidesTheOthers)
{
  const vtkNBufferCoarseDepth depth = MakeDepth({ 0, 0, 64, 64 }, 0.2);
  EXPECT_TRUE(depth.IsOpen({ 0, 0, 64, 64 }, 0.1, Share));
  EXPECT_FALSE(depth.IsOpen({ 16, 16, 48, 48 }, 0.3, Share));
  EXPECT_TRUE(depth.IsOpen({ 64, 0, 128, 64 }, 0.3, Share));
}

// Hazard: ground that reaches far away hides what stands on it.
TEST(NBufferCoarseDepth, ABoxHidesBeyondItsFarEndOnly)
{
  const vtkNBufferCoarseDepth depth = MakeDepth({ 0, 0, Side, Side }, 0.9);
  EXPECT_TRUE(depth.IsOpen({ 32, 32, 64, 64 }, 0.3, Share));
  EXPECT_FALSE(depth.IsOpen({ 32, 32, 64, 64 }, 0.95, Share));
}

// Hazard: a box that sticks out counts as hidden, or one of which almost nothing does as open.
TEST(NBufferCoarseDepth, ABoxIsOpenIfMoreThanItsShareIs)
{
  // The outer eighth of a box does not count: the middles of the wall and of the first box end
  // at 56.
  const vtkNBufferCoarseDepth depth = MakeDepth({ 0, 0, 64, Side }, 0.2);
  EXPECT_FALSE(depth.IsOpen({ 0, 32, 64, 48 }, 0.3, Share));
  // Three of its twelve columns of squares are open.
  EXPECT_TRUE(depth.IsOpen({ 8, 32, 72, 48 }, 0.3, Share));
  EXPECT_FALSE(depth.IsOpen({ 8, 32, 72, 48 }, 0.3, 4));
}

// Hazard: the gaps between the middles of the tiles of a wall leave open what is behind the wall,
// but not straight behind a tile. Of this box one column of six is behind a gap.
TEST(NBufferCoarseDepth, TilesOfAWallHideABoxBehindThem)
{
  constexpr int tile = 30;
  vtkNBufferCoarseDepth depth(Side, Side);
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 4; ++x)
    {
      depth.Add({ x * tile, y * tile, (x + 1) * tile, (y + 1) * tile }, 0.2);
    }
  }
  EXPECT_FALSE(depth.IsOpen({ 32, 31, 62, 58 }, 0.3, 4));
  EXPECT_TRUE(depth.IsOpen({ 32, 31, 62, 58 }, 0.3, Share));
}

// Hazard: props that are smaller than the squares hide nothing, so that all of them are drawn.
TEST(NBufferCoarseDepth, ASmallBoxHidesTheSquareOfItsMiddle)
{
  const vtkNBufferCoarseDepth depth = MakeDepth({ 9, 9, 11, 11 }, 0.2);
  EXPECT_FALSE(depth.IsOpen({ 9, 9, 11, 11 }, 0.3, Share));
  EXPECT_TRUE(depth.IsOpen({ 13, 9, 15, 11 }, 0.3, Share));
}

// Hazard: boxes at the edges of the screen, or old ones of a larger screen, reach beyond the image.
TEST(NBufferCoarseDepth, AnySizeOfTheScreenIsCovered)
{
  for (int side : { 1, 3, 4, 5, 100 })
  {
    vtkNBufferCoarseDepth depth(side, side);
    depth.Add({ 0, 0, side, side }, 0.2);
    EXPECT_FALSE(depth.IsOpen({ side / 2, side / 2, side / 2 + 1, side / 2 + 1 }, 0.3, Share))
      << side;
    EXPECT_TRUE(depth.IsOpen({ side - 1, side - 1, side, side }, 0.1, Share)) << side;
    const vtkNBufferRectangle old = { 0, side + 8, 900, side + 800 };
    depth.Add(old, 0.1);
    EXPECT_FALSE(depth.IsOpen(old, 0.0, Share)) << side;
  }
}
