// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// How the fuzzer compares shadow masks.
#include "ShadowCheck.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace TestScene;

namespace
{
ShadowFrame MakeFrame(const std::vector<unsigned char>& mask, int width)
{
  ShadowFrame frame;
  frame.Width = width;
  frame.Height = static_cast<int>(mask.size()) / width;
  frame.Depth.assign(mask.size(), 0.5f);
  frame.Receivers.emplace_back(mask.size(), static_cast<unsigned char>(1));
  frame.Facing.emplace_back(mask.size(), static_cast<unsigned char>(1));
  frame.Masks.push_back(mask);
  return frame;
}
}

TEST(FuzzShadows, MasksMayDifferAtEdgesOnly)
{
  // Left of the middle is in shadow.
  constexpr int width = 9;
  std::vector<unsigned char> mask(width * width, 0);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = i % width < 4 ? 255 : 0;
  }
  const ShadowFrame expected = MakeFrame(mask, width);
  OracleImage rays;
  rays.Samples.assign(mask.size(), OracleSample::Unlit);
  rays.Ambiguous.assign(mask.size(), 0);
  const auto judge = [&rays](int) { return rays; };
  // Three samples above each other: more than may differ away from edges.
  const auto compare = [&](std::size_t flipped, ShadowMode mode)
  {
    ShadowFrame tested = expected;
    for (std::size_t i : { flipped, flipped + width, flipped + 2 * width })
    {
      tested.Masks[0][i] = static_cast<unsigned char>(~tested.Masks[0][i]);
    }
    ShadowTally tally;
    const std::string failure = CompareMasks(expected, tested, mode, tally, judge);
    EXPECT_EQ(tally.Samples, width * width);
    return failure;
  };
  constexpr std::size_t middle = 4 * width;
  EXPECT_EQ(compare(middle + 3, ShadowMode::Clamped), "");
  EXPECT_EQ(compare(middle + 4, ShadowMode::Clamped), "");
  EXPECT_NE(compare(middle + 2, ShadowMode::Clamped), "");
  EXPECT_NE(compare(middle + 5, ShadowMode::Clamped), "");
  rays.Ambiguous.assign(mask.size(), 1);
  EXPECT_EQ(compare(middle + 5, ShadowMode::Clamped), "");
  rays.Ambiguous.assign(mask.size(), 0);
  EXPECT_NE(compare(middle + 3, ShadowMode::Scissored), "");
  EXPECT_NE(compare(middle + 4, ShadowMode::Scissored), "");

  ShadowFrame noReceiver = expected;
  noReceiver.Receivers[0][middle + 6] = 0;
  ShadowFrame tested = noReceiver;
  tested.Masks[0][middle + 6] = 255;
  ShadowTally tally;
  EXPECT_EQ(CompareMasks(noReceiver, tested, ShadowMode::Scissored, tally, {}), "");

  noReceiver.Depth[middle + 6] = 1.0f;
  EXPECT_NE(CompareMasks(noReceiver, tested, ShadowMode::Scissored, tally, {}), "");

  ShadowFrame shifted = expected;
  for (std::size_t row = 0; row < width; ++row)
  {
    shifted.Masks[0][row * width + 4] = 255;
  }
  // More than a few samples at the edge: all of its column. Rays decide.
  rays.Samples.assign(mask.size(), OracleSample::Lit);
  EXPECT_NE(CompareMasks(expected, shifted, ShadowMode::Clamped, tally, judge), "");
  rays.Ambiguous.assign(mask.size(), 1);
  EXPECT_EQ(CompareMasks(expected, shifted, ShadowMode::Clamped, tally, judge), "");
  rays.Ambiguous.assign(mask.size(), 0);
  rays.Samples.assign(mask.size(), OracleSample::Shadowed);
  EXPECT_EQ(CompareMasks(expected, shifted, ShadowMode::Clamped, tally, judge), "");
  rays.Samples.assign(mask.size(), OracleSample::Unlit);
  EXPECT_NE(CompareMasks(expected, shifted, ShadowMode::Clamped, tally, judge), "")
    << "rays that see something else decide nothing";
}

TEST(FuzzShadows, StraysAreRightOrUnseen)
{
  constexpr int width = 4;
  const ShadowFrame expected = MakeFrame(std::vector<unsigned char>(width * width, 0), width);
  ShadowFrame tested = expected;
  OracleImage rays;
  rays.Samples.assign(width * width, OracleSample::Shadowed);
  rays.Ambiguous.assign(width * width, 0);
  const auto find = [&](bool inPortions = false)
  {
    return FindStrays(
      expected, tested, [&rays](int) { return rays; }, inPortions);
  };
  // What rays say is right.
  tested.Masks[0][0] = tested.Masks[0][1] = 255;
  ASSERT_TRUE(find());
  EXPECT_EQ(find()->Seen, 2);
  EXPECT_EQ(find()->Unseen, 0);
  tested.Masks[0][2] = 255;
  EXPECT_FALSE(find()) << "too many";
  rays.Samples[2] = OracleSample::Unlit;
  ASSERT_TRUE(find());
  EXPECT_EQ(find()->Seen, 2);
  EXPECT_EQ(find()->Unseen, 1);
  // What rays contradict.
  rays.Samples[0] = OracleSample::Lit;
  EXPECT_FALSE(find());
  rays.Ambiguous[0] = 1;
  EXPECT_FALSE(find()) << "sample 1 is neither unlit nor ambiguous";
  rays.Ambiguous[1] = 1;
  ASSERT_TRUE(find());
  EXPECT_EQ(find()->Seen, 0);
  EXPECT_EQ(find()->Unseen, 3);
  // In portions, ambiguous samples are no longer judged.
  ASSERT_TRUE(find(true));
  EXPECT_EQ(find(true)->InPortions, 2);
  EXPECT_EQ(find(true)->Unseen, 1);
}
