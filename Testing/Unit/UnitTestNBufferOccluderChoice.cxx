// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which props are drawn first where nothing is known.
#include "vtkNBufferOccluderChoice.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
constexpr int Side = 128; // of the screen, in pixels

vtkNBufferScreenBox MakeScreenBox(
  const vtkNBufferRectangle& pixels, double nearest, double farthest)
{
  vtkNBufferScreenBox box;
  box.Pixels = pixels;
  box.Nearest = nearest;
  box.Farthest = farthest;
  return box;
}

std::vector<std::size_t> Choose(const std::vector<vtkNBufferScreenBox>& boxes, int limit = 64)
{
  return vtkNBufferOccluderChoice::Choose(boxes, limit, Side, Side);
}
}

using Places = std::vector<std::size_t>;

// Hazard: all houses of a row are drawn although the first one hides the others.
TEST(NBufferOccluderChoice, TheFirstOfARowIsChosen)
{
  const vtkNBufferRectangle wide = { 0, 0, 64, 64 };
  const vtkNBufferRectangle behind = { 16, 16, 48, 48 };
  const vtkNBufferRectangle beside = { 64, 0, 128, 64 };
  EXPECT_EQ(Choose({}), Places());
  EXPECT_EQ(Choose({ MakeScreenBox(wide, 0.1, 0.2), MakeScreenBox(behind, 0.3, 0.4),
              MakeScreenBox(beside, 0.5, 0.6), MakeScreenBox(behind, 0.7, 0.8) }),
    Places({ 0, 2 }));
  EXPECT_EQ(
    Choose({ MakeScreenBox(wide, 0.1, 0.2), MakeScreenBox(beside, 0.5, 0.6) }, 1), Places({ 0 }));
}

// Hazard: ground that reaches far away is used as an occluder from its near end on.
TEST(NBufferOccluderChoice, ABoxHidesBeyondItsFarEndOnly)
{
  const vtkNBufferRectangle ground = { 0, 0, Side, Side };
  const vtkNBufferRectangle house = { 32, 32, 64, 64 };
  EXPECT_EQ(Choose({ MakeScreenBox(ground, 0.1, 0.9), MakeScreenBox(house, 0.3, 0.4),
              MakeScreenBox(house, 0.95, 0.96) }),
    Places({ 0, 1 }));
}

// Hazard: a box of which half sticks out is not chosen, or a box of which almost nothing sticks out
// is.
TEST(NBufferOccluderChoice, ABoxIsChosenIfHalfOfItIsOpen)
{
  const vtkNBufferRectangle wall = { 0, 0, 64, Side };
  for (const auto& [left, isChosen] : { std::pair(40, false), { 64, true } })
  {
    const vtkNBufferRectangle house = { left, 32, left + 16, 48 };
    EXPECT_EQ(Choose({ MakeScreenBox(wall, 0.1, 0.2), MakeScreenBox(house, 0.3, 0.4) }).size(),
      isChosen ? 2u : 1u);
  }
  // The outer eighth of a rectangle hides nothing.
  EXPECT_EQ(
    Choose({ MakeScreenBox(wall, 0.1, 0.2), MakeScreenBox({ 56, 32, 64, 48 }, 0.3, 0.4) }).size(),
    2u);
}

// Hazard: boxes at the edges of the screen, or old ones of a larger screen, reach beyond the image.
TEST(NBufferOccluderChoice, AnySizeOfTheScreenIsCovered)
{
  for (int side : { 1, 7, 8, 9, 100 })
  {
    EXPECT_EQ(vtkNBufferOccluderChoice::Choose(
                { MakeScreenBox({ 0, 0, side, side }, 0.1, 0.2),
                  MakeScreenBox({ side - 1, side - 1, side, side }, 0.3, 0.4) },
                2, side, side)
                .size(),
      2u)
      << side;
    const vtkNBufferScreenBox old = MakeScreenBox({ 0, side + 8, 900, side + 800 }, 0.1, 0.2);
    EXPECT_EQ(vtkNBufferOccluderChoice::Choose({ old }, 2, side, side), Places()) << side;
  }
}

// Hazard: half a million props are tested in six rounds, each of which draws almost nothing.
TEST(NBufferOccluderChoice, AGreatManyPropsHaveLargerRounds)
{
  EXPECT_EQ(vtkNBufferOccluderChoice::GetLimit(64, 100), 64u);
  EXPECT_EQ(vtkNBufferOccluderChoice::GetLimit(64, 64 * 512 + 511), 64u);
  EXPECT_EQ(vtkNBufferOccluderChoice::GetLimit(64, 512 * 1000), 1000u);
}
