// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which squares cover a rectangle: every claim of vtkNBufferMath.h against brute force.
#include "Pixels.h"
#include "vtkNBufferDepthConvention.h"
#include "vtkNBufferMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{
std::int64_t CeilDivide(std::int64_t n, std::int64_t d)
{
  return (n + d - 1) / d;
}

/// The rule of the header, searched from the finest level up.
int SearchLevel(int width, int height, int squares)
{
  int level = 0;
  while (
    CeilDivide(width, std::int64_t(1) << level) * CeilDivide(height, std::int64_t(1) << level) >
    squares)
  {
    ++level;
  }
  return level;
}

/// The paper's branch, from the side of the smallest power-of-two square around the rectangle.
int PaperLevel(int width, int height)
{
  int n = 0;
  while ((1 << n) < std::max(width, height))
  {
    ++n;
  }
  const double side = 1 << n;
  const int shorter = std::min(width, height);
  if (n == 0)
  {
    return 0; // a single texel
  }
  if (shorter > side / 4)
  {
    return n - 1; // left (2 x 2) and middle (2 x 1, 1 x 2) of figure 3
  }
  return n - 2; // right of figure 3: four in a row or column
}

vtkNBufferRectangle GetSquare(const vtkNBufferCover& cover, int i)
{
  const int side = 1 << cover.Level;
  return { cover.X[i], cover.Y[i], cover.X[i] + side, cover.Y[i] + side };
}

/// What must hold for every cover: squares inside the image start, the rectangle covered wholly.
void CheckCover(const vtkNBufferRectangle& r, const vtkNBufferCover& cover)
{
  ASSERT_GE(cover.Level, 0);
  ASSERT_GE(cover.Count, 1);
  ASSERT_LE(cover.Count, 4);
  std::set<std::pair<int, int>> starts;
  for (int i = 0; i < cover.Count; ++i)
  {
    const vtkNBufferRectangle square = GetSquare(cover, i);
    ASSERT_TRUE(IsIn(square.X0, square.Y0, { 0, 0, r.X1, r.Y1 })) << square << " starts outside";
    // No part to the right or above: a larger square is pushed left and down only, unless the
    // image ends there.
    ASSERT_TRUE(square.X1 <= r.X1 || square.X0 == 0) << square << " reaches beyond the far sides";
    ASSERT_TRUE(square.Y1 <= r.Y1 || square.Y0 == 0) << square << " reaches beyond the far sides";
    ASSERT_FALSE(square.GetIntersection(r).IsEmpty()) << square << " does not touch the rectangle";
    ASSERT_TRUE(starts.emplace(square.X0, square.Y0).second) << square << " is looked up twice";
  }
  for (const auto& [x, y] : Pixels(r))
  {
    bool inside = false;
    for (int i = 0; i < cover.Count; ++i)
    {
      inside = inside || IsIn(x, y, GetSquare(cover, i));
    }
    ASSERT_TRUE(inside) << "(" << x << ", " << y << ") is not covered";
  }
}

void CheckCovers(const vtkNBufferRectangle& r)
{
  if (testing::Test::HasFatalFailure())
  {
    return; // One is enough.
  }
  SCOPED_TRACE(r);
  const int w = r.GetWidth();
  const int h = r.GetHeight();
  const vtkNBufferCover one = vtkNBufferMath::GetCoverOfOne(r);
  ASSERT_NO_FATAL_FAILURE(CheckCover(r, one));
  ASSERT_EQ(one.Count, 1);
  ASSERT_EQ(one.Level, SearchLevel(w, h, 1));
  const vtkNBufferCover four = vtkNBufferMath::GetCoverOfFour(r);
  ASSERT_NO_FATAL_FAILURE(CheckCover(r, four));
  ASSERT_EQ(four.Level, SearchLevel(w, h, 4));
  ASSERT_EQ(four.Count, CeilDivide(w, 1 << four.Level) * CeilDivide(h, 1 << four.Level));
}

/// Width and height from 1 to `largest`.
Pixels Sizes(int largest)
{
  return Pixels({ 1, 1, largest + 1, largest + 1 });
}
}

// Hazard: a logarithm in floating point is off by one at powers of two.
TEST(NBufferMath, CeilLog2)
{
  for (const int none : { INT_MIN, -1, 0, 1 })
  {
    EXPECT_EQ(vtkNBufferMath::CeilLog2(none), 0);
  }
  for (int i = 1; i < 31; ++i)
  {
    const int power = 1 << i;
    EXPECT_EQ(vtkNBufferMath::CeilLog2(power), i) << power;
    EXPECT_EQ(vtkNBufferMath::CeilLog2(power - 1), power == 2 ? 0 : i) << power - 1;
    EXPECT_EQ(vtkNBufferMath::CeilLog2(power + 1), i + 1) << power + 1;
  }
  EXPECT_EQ(vtkNBufferMath::CeilLog2(INT_MAX), 31);
}

// Hazard: there is one level too few, and no level covers the largest rectangle.
TEST(NBufferMath, NumberOfLevels)
{
  EXPECT_EQ(vtkNBufferMath::GetNumberOfLevels(0, 5), 0);
  EXPECT_EQ(vtkNBufferMath::GetNumberOfLevels(5, 0), 0);
  EXPECT_EQ(vtkNBufferMath::GetNumberOfLevels(-3, 5), 0);
  EXPECT_EQ(vtkNBufferMath::GetNumberOfLevels(1, 1), 1);
  for (const auto& [w, h] : Sizes(130))
  {
    const int levels = vtkNBufferMath::GetNumberOfLevels(w, h);
    ASSERT_GE(1 << (levels - 1), std::max(w, h)) << w << " x " << h;
    ASSERT_TRUE(levels == 1 || (1 << (levels - 2)) < std::max(w, h)) << w << " x " << h;
    ASSERT_LT(vtkNBufferMath::GetLevelForOneLookup(w, h), levels) << w << " x " << h;
    ASSERT_LT(vtkNBufferMath::GetLevelForFourLookups(w, h), levels) << w << " x " << h;
  }
}

// Hazard: with a level that is coarser than needed, hidden props are kept; with a finer one, pixels
// are missed.
TEST(NBufferMath, LevelsAreTheFinestForEverySizeUpTo600)
{
  for (const auto& [w, h] : Sizes(600))
  {
    ASSERT_EQ(vtkNBufferMath::GetLevelForOneLookup(w, h), SearchLevel(w, h, 1)) << w << " x " << h;
    ASSERT_EQ(vtkNBufferMath::GetLevelForFourLookups(w, h), SearchLevel(w, h, 4))
      << w << " x " << h;
  }
}

// Hazard: the module's rule differs from the five cases of the paper, whose bounds would then not
// hold.
TEST(NBufferMath, LevelsAreThoseOfThePapersFiveCases)
{
  for (const auto& [w, h] : Sizes(600))
  {
    ASSERT_EQ(vtkNBufferMath::GetLevelForFourLookups(w, h), PaperLevel(w, h)) << w << " x " << h;
  }
  // 1 x 1, 2 x 2, 2 x 1, 1 x 2, 4 x 1, 1 x 4, 3 x 1 and 1 x 3 squares.
  const int counts[][3] = { { 1, 1, 1 }, { 7, 6, 4 }, { 8, 4, 2 }, { 4, 8, 2 }, { 8, 2, 4 },
    { 2, 8, 4 }, { 6, 2, 3 }, { 2, 6, 3 } };
  for (const auto& [w, h, count] : counts)
  {
    EXPECT_EQ(vtkNBufferMath::GetCoverOfFour({ 0, 0, w, h }).Count, count) << w << " x " << h;
  }
}

// Hazard: sums overflow an int for the largest sizes.
TEST(NBufferMath, LevelsOfHugeRectangles)
{
  EXPECT_EQ(vtkNBufferMath::GetLevelForOneLookup(INT_MAX, 1), 31);
  EXPECT_EQ(vtkNBufferMath::GetLevelForFourLookups(INT_MAX, 1), 29);
  EXPECT_EQ(vtkNBufferMath::GetLevelForFourLookups(INT_MAX, INT_MAX), 30);
  EXPECT_EQ(vtkNBufferMath::GetLevelForFourLookups(1 << 30, 1 << 30), 29);
}

// Hazard: a pixel of the rectangle that no square covers lets a visible prop be culled.
TEST(NBufferMath, EveryRectangleOfSmallImagesIsCovered)
{
  const int sizes[][2] = { { 1, 1 }, { 1, 6 }, { 6, 1 }, { 12, 19 }, { 23, 9 } };
  for (const auto& [width, height] : sizes)
  {
    ASSERT_NO_FATAL_FAILURE(ForEachRectangle(width, height, CheckCovers));
  }
}

// Hazard: the same, for large rectangles at any place.
TEST(NBufferMath, RandomRectanglesAreCovered)
{
  std::mt19937 random(1);
  for (int i = 0; i < 400; ++i)
  {
    const int size[2] = { 1 + static_cast<int>(random() % 700),
      1 + static_cast<int>(random() % 400) };
    int x[2] = { static_cast<int>(random() % size[0]), static_cast<int>(random() % size[0]) };
    int y[2] = { static_cast<int>(random() % size[1]), static_cast<int>(random() % size[1]) };
    ASSERT_NO_FATAL_FAILURE(CheckCovers({ std::min(x[0], x[1]), std::min(y[0], y[1]),
      std::max(x[0], x[1]) + 1, std::max(y[0], y[1]) + 1 }));
  }
}

// Hazard: with a cover that is much larger than its rectangle, hidden props are kept. The published
// bounds of what is covered in excess hold for every size: nothing for sides within a factor of
// two, less than the rectangle up to 4 : 1, and less than (aspect / 2 - 1) times the rectangle
// beyond.
TEST(NBufferMath, OverCoverageIsBounded)
{
  for (const auto& [w, h] : Sizes(512))
  {
    // Far from the image border nothing is cut off, which is the worst case.
    const vtkNBufferCover cover =
      vtkNBufferMath::GetCoverOfFour({ 2048, 2048, 2048 + w, 2048 + h });
    vtkNBufferRectangle box = GetSquare(cover, 0);
    for (int i = 1; i < cover.Count; ++i)
    {
      const vtkNBufferRectangle square = GetSquare(cover, i);
      box = { std::min(box.X0, square.X0), std::min(box.Y0, square.Y0), std::max(box.X1, square.X1),
        std::max(box.Y1, square.Y1) };
    }
    const double area = static_cast<double>(w) * h;
    const double extra = static_cast<double>(box.GetWidth()) * box.GetHeight() / area - 1.0;
    const double aspect = static_cast<double>(std::max(w, h)) / std::min(w, h);
    ASSERT_TRUE(extra == 0.0 || std::ilogb(w) != std::ilogb(h)) << w << " x " << h;
    ASSERT_TRUE(extra == 0.0 || extra < (aspect < 4.0 ? 1.0 : aspect / 2.0 - 1.0))
      << w << " x " << h << ": " << extra;
    const double oneSide = 1 << vtkNBufferMath::GetLevelForOneLookup(w, h);
    ASSERT_LE(oneSide * oneSide / area - 1.0, 4.0 * aspect - 1.0) << w << " x " << h;
  }
}

// Hazard: a square that sticks out above a wide prop on the ground contains the sky, so that the
// prop is not hidden.
TEST(NBufferMath, LargerSquaresArePushedDown)
{
  const vtkNBufferCover wide = vtkNBufferMath::GetCoverOfFour({ 40, 40, 56, 41 });
  EXPECT_EQ(wide.Level, 2);
  EXPECT_EQ(wide.Count, 4);
  for (int i = 0; i < wide.Count; ++i)
  {
    EXPECT_EQ(wide.Y[i], 37) << "rows 37 to 40, none above the rectangle";
  }
  const vtkNBufferCover low = vtkNBufferMath::GetCoverOfFour({ 40, 1, 56, 2 });
  for (int i = 0; i < low.Count; ++i)
  {
    EXPECT_EQ(low.Y[i], 0) << "never below the image";
  }
}

// Hazard: the base of an image of odd size lacks the last row or column.
TEST(NBufferMath, BaseSizeIsRoundedUp)
{
  for (const auto& [factor, size] : Pixels({ 1, 0, 10, 71 }))
  {
    int texels = 0;
    while (texels * factor < size)
    {
      ++texels;
    }
    ASSERT_EQ(vtkNBufferMath::GetBaseSize(size, factor), texels) << size << " / " << factor;
  }
  EXPECT_EQ(vtkNBufferMath::GetBaseSize(5, INT_MAX), 1);
  EXPECT_EQ(vtkNBufferMath::GetBaseSize(INT_MAX, 2), 1 << 30);
}

// Hazard: a rectangle that is rounded inward in the base misses the pixels of its border texels.
TEST(NBufferMath, BaseRectangleIsRoundedOutwardAndTight)
{
  for (int factor = 1; factor <= 9; ++factor)
  {
    for (int begin = 0; begin < 30; ++begin)
    {
      for (int end = begin + 1; end <= 31; ++end)
      {
        const int first = begin / factor;
        const int last = (end - 1) / factor;
        ASSERT_EQ(vtkNBufferMath::GetBaseRectangle({ begin, 3, end, 4 }, factor),
          (vtkNBufferRectangle{ first, 3 / factor, last + 1, 3 / factor + 1 }))
          << begin << " " << end << " / " << factor;
        ASSERT_EQ(vtkNBufferMath::GetBaseRectangle({ 3, begin, 4, end }, factor),
          (vtkNBufferRectangle{ 3 / factor, first, 3 / factor + 1, last + 1 }));
      }
    }
  }
}

// Hazard: one of the constants of a depth convention is changed, and another one is not.
TEST(NBufferDepthConvention, ConstantsFollowFromTheOrder)
{
  namespace Depth = vtkNBufferDepthConvention;
  // z / w is -1 on the near plane and 1 on the far plane.
  EXPECT_EQ(-Depth::Scale + Depth::Offset, 0.0);
  EXPECT_EQ(Depth::Scale + Depth::Offset, Depth::Background);
  EXPECT_EQ(Depth::InverseOffset, -1.0);
  EXPECT_EQ(Depth::InverseScale * Depth::Background + Depth::InverseOffset, 1.0);
  EXPECT_TRUE(Depth::IsDrawn(0.0f));
  EXPECT_TRUE(Depth::IsDrawn(std::nextafter(Depth::Background, 0.0f)));
  EXPECT_FALSE(Depth::IsDrawn(Depth::Background));
  EXPECT_NE(Depth::PassIfNearer, Depth::PassIfFarther);
}

// Hazard: the farthest of several depths is taken from the wrong end.
TEST(NBufferDepthConvention, FarthestDepthHasTheLargestOrder)
{
  for (const auto stored : { vtkNBufferStoredDepth::Ordinary, vtkNBufferStoredDepth::Reversed })
  {
    std::vector<float> depth = { 0.25f, 0.0f, 1.0f, 0.75f, 1e-30f };
    const auto [low, high] = std::minmax_element(depth.begin(), depth.end());
    const bool isMaximum =
      vtkNBufferDepthConvention::GetFarthest(stored) == vtkNBufferExtremum::Maximum;
    const auto farthest = (isMaximum ? high : low) - depth.begin();
    vtkNBufferDepthConvention::ToOrders(stored, depth.data(), depth.size());
    EXPECT_EQ(std::max_element(depth.begin(), depth.end()) - depth.begin(), farthest);
    EXPECT_EQ(depth[0], isMaximum ? 0.25f : -0.25f);
    EXPECT_EQ(depth[4], isMaximum ? 1e-30f : -1e-30f);
    EXPECT_LE(depth[farthest], vtkNBufferDepthConvention::Background);
  }
}

// Hazard: inclusive and exclusive ends of rectangles are confused.
TEST(NBufferMath, RectanglesAreHalfOpen)
{
  const vtkNBufferRectangle r = { 2, 3, 5, 4 };
  EXPECT_EQ(r.GetWidth(), 3);
  EXPECT_EQ(r.GetHeight(), 1);
  EXPECT_FALSE(r.IsEmpty());
  EXPECT_TRUE((vtkNBufferRectangle{ 2, 3, 2, 4 }).IsEmpty());
  EXPECT_TRUE((vtkNBufferRectangle{ 2, 3, 5, 3 }).IsEmpty());
  EXPECT_TRUE((vtkNBufferRectangle{ 5, 3, 2, 4 }).IsEmpty());
  EXPECT_TRUE(vtkNBufferRectangle().IsEmpty());
}
