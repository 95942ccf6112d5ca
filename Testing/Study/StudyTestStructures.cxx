// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Every member of the family against the double loop: what it covers contains the rectangle, what
// it answers is the farthest depth of what it covers, and where it is said to be exact it is.
#include "DepthStructure.h"
#include "PaperMeasures.h"
#include "StudyImage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace
{
using NBufferStudy::DepthAxis;
using NBufferStudy::DepthCover;
using NBufferStudy::DepthFamily;
using NBufferStudy::DepthGrid;
using NBufferStudy::DepthStructure;
using NBufferStudy::DepthTaps;
using NBufferStudy::FullStride;
using StudyTest::Image;

constexpr std::pair<int, int> Sizes[] = { { 1, 1 }, { 1, 37 }, { 41, 1 }, { 7, 3 }, { 64, 64 },
  { 61, 33 }, { 100, 17 }, { 3, 65 } };

std::vector<DepthFamily> MakeFamily()
{
  std::vector<DepthFamily> family;
  for (int factor : { 1, 2, 4, 16 })
  {
    const auto add = [&](DepthTaps taps, bool separable, int band)
    {
      for (int stride : { 0, 1, 2, 3, FullStride })
      {
        family.push_back({ factor, DepthGrid::Windows, stride, band, taps, separable });
      }
      family.push_back({ factor, DepthGrid::Mips, FullStride, band, taps, separable });
      family.push_back({ factor, DepthGrid::FatMips, FullStride, band, taps, separable });
    };
    for (DepthTaps taps :
      { DepthTaps::One, DepthTaps::Four, DepthTaps::TwoByTwo, DepthTaps::FourByFour })
    {
      for (int band : { 0, 1, 2, NBufferStudy::AllShapes })
      {
        add(taps, false, band);
        add(taps, true, band);
      }
    }
    family.push_back({ factor, DepthGrid::Windows, FullStride, 0, DepthTaps::All, false });
  }
  return family;
}

TEST(StudyStructures, AnswersAreThoseOfTheDoubleLoopOverWhatIsCovered)
{
  for (const auto& [width, height] : Sizes)
  {
    const Image image(width, height, 7);
    for (const DepthFamily& family : MakeFamily())
    {
      DepthStructure structure(family);
      structure.Build(image.Depth.data(), width, height);
      std::mt19937 random(11);
      for (int i = 0; i < 12; ++i)
      {
        const vtkNBufferRectangle r = StudyTest::MakeRectangle(image, random);
        const vtkNBufferRectangle covered = structure.GetCovered(r);
        long long lookups = 0;
        const float answer = structure.Query(r, lookups);
        SCOPED_TRACE(testing::Message() << family.GetName() << ": " << r << " by " << covered
                                        << " of " << width << " x " << height);
        ASSERT_TRUE(IsIn(r, covered));
        ASSERT_EQ(answer, image.Scan(covered));
        const int limits[] = { 1, 4, 4, 16 };
        ASSERT_TRUE(
          family.Taps == DepthTaps::All || lookups <= limits[static_cast<int>(family.Taps)]);
      }
    }
  }
}

// A band is exact for rectangles no longer than it reaches; all shapes, for all.
TEST(StudyStructures, BandsAreExactForWhatTheyReach)
{
  const Image image(64, 45, 2);
  std::mt19937 random(4);
  const std::pair<int, DepthTaps> cases[] = { { 0, DepthTaps::Four }, { 1, DepthTaps::Four },
    { 2, DepthTaps::Four }, { 3, DepthTaps::Four }, { NBufferStudy::AllShapes, DepthTaps::Four },
    { NBufferStudy::AllShapes, DepthTaps::TwoByTwo } };
  for (const auto& [band, taps] : cases)
  {
    DepthStructure structure({ 1, DepthGrid::Windows, FullStride, band, taps, false });
    structure.Build(image.Depth.data(), image.Width, image.Height);
    for (int i = 0; i < 2000; ++i)
    {
      const vtkNBufferRectangle r = StudyTest::MakeRectangle(image, random);
      const int ratio = std::abs(std::ilogb(r.GetWidth()) - std::ilogb(r.GetHeight()));
      if (band == NBufferStudy::AllShapes || ratio <= band)
      {
        long long lookups = 0;
        ASSERT_EQ(structure.Query(r, lookups), image.Scan(r)) << "band " << band << ", " << r;
      }
    }
  }
}

TEST(StudyStructures, PlainSquaresAreTheModules)
{
  const Image image(61, 45, 2);
  std::mt19937 random(4);
  DepthStructure structure({ 1, DepthGrid::Windows, FullStride, 0, DepthTaps::Four, false });
  structure.SetSize(image.Width, image.Height);
  EXPECT_EQ(
    structure.GetNumberOfLevels(), vtkNBufferMath::GetNumberOfLevels(image.Width, image.Height));
  for (int i = 0; i < 2000; ++i)
  {
    const vtkNBufferRectangle r = StudyTest::MakeRectangle(image, random);
    const DepthCover cover = structure.GetCover(r);
    const vtkNBufferCover modules = vtkNBufferMath::GetCoverOfFour(r);
    ASSERT_EQ(cover.Level, modules.Level) << r;
    ASSERT_EQ(cover.Columns * cover.Rows, modules.Count) << r;
    for (int place = 0; place < modules.Count; ++place)
    {
      ASSERT_EQ(cover.X[place % cover.Columns], modules.X[place]) << r;
      ASSERT_EQ(cover.Y[place / cover.Columns], modules.Y[place]) << r;
    }
  }
}

/// How loose: along each axis what is covered is at most so many times the rectangle and so many
/// texels longer.
struct Looseness
{
  DepthFamily Family;
  double Times;
  double Texels;
};

TEST(StudyStructures, SquareRectanglesAreNoLooserThanStated)
{
  const auto windows = [](int stride, DepthTaps taps) {
    return DepthFamily{ 1, DepthGrid::Windows, stride, 0, taps, false };
  };
  const Looseness stated[] = {
    { windows(FullStride, DepthTaps::One), 2.0, 0.0 },
    { windows(FullStride, DepthTaps::Four), 1.0, 0.0 },
    // Level i <= ceil(log2(n / 2)) + 1, and up to a stride lost at either end.
    { windows(3, DepthTaps::Four), 1.5, 2.0 },
    { windows(2, DepthTaps::Four), 2.0, 2.0 },
    { windows(1, DepthTaps::Four), 2.0, 2.0 },
    { windows(0, DepthTaps::TwoByTwo), 4.0, 2.0 },
    { windows(0, DepthTaps::FourByFour), 2.0, 2.0 },
    { { 1, DepthGrid::Mips, FullStride, 0, DepthTaps::FourByFour, false }, 4.0, 4.0 },
  };
  const Image image(200, 180, 1);
  std::mt19937 random(6);
  for (const Looseness& looseness : stated)
  {
    DepthStructure structure(looseness.Family);
    structure.SetSize(image.Width, image.Height);
    for (int i = 0; i < 2000; ++i)
    {
      vtkNBufferRectangle r = StudyTest::MakeRectangle(image, random);
      const int side = std::min(r.GetWidth(), r.GetHeight());
      r.X1 = r.X0 + side;
      r.Y1 = r.Y0 + side;
      const vtkNBufferRectangle covered = structure.GetCovered(r);
      const double longest = looseness.Times * side + looseness.Texels;
      ASSERT_LE(std::max(covered.GetWidth(), covered.GetHeight()), longest)
        << looseness.Family.GetName() << ", " << r;
    }
  }
}

TEST(StudyStructures, ASecondImageLeavesNothingOfTheFirst)
{
  const Image first(97, 50, 9);
  const Image second(33, 70, 10);
  for (const DepthFamily& family : MakeFamily())
  {
    DepthStructure structure(family);
    structure.Build(first.Depth.data(), first.Width, first.Height);
    structure.Build(second.Depth.data(), second.Width, second.Height);
    const vtkNBufferRectangle r = { 3, 11, 20, 40 };
    long long lookups = 0;
    ASSERT_EQ(structure.Query(r, lookups), second.Scan(structure.GetCovered(r)))
      << family.GetName();
  }
}

TEST(StudyStructures, TexelsAndMemoryAreThoseOfTheArticle)
{
  const auto count = [](const DepthFamily& family, int width, int height)
  {
    const Image image(width, height, 1);
    DepthStructure structure(family);
    structure.Build(image.Depth.data(), width, height);
    EXPECT_GE(structure.GetMemory(), structure.GetNumberOfTexels() * sizeof(float));
    DepthFamily separable = family;
    separable.Separable = true;
    DepthStructure other(separable);
    other.Build(image.Depth.data(), width, height);
    EXPECT_EQ(other.GetNumberOfTexels(), structure.GetNumberOfTexels());
    return static_cast<double>(structure.GetNumberOfTexels()) / (width * height);
  };
  const auto windows = [](int stride, int band, int factor) {
    return DepthFamily{ factor, DepthGrid::Windows, stride, band, DepthTaps::Four, false };
  };
  // Levels 0 to 8 of 256 x 256.
  EXPECT_EQ(count(windows(FullStride, 0, 1), 256, 256), 9.0);
  EXPECT_EQ(count(windows(FullStride, NBufferStudy::AllShapes, 1), 256, 256), 81.0);
  EXPECT_EQ(count(windows(FullStride, 1, 1), 256, 256), 9.0 + 2 * 8.0);
  // 1 + 1/4 + ... for mips; s = 2 keeps three whole levels.
  EXPECT_NEAR(count(windows(0, 0, 1), 256, 256), 4.0 / 3.0, 1e-4);
  EXPECT_NEAR(count(windows(2, 0, 1), 256, 256), 2.0 + 4.0 / 3.0, 1e-3);
  EXPECT_NEAR(
    count({ 1, DepthGrid::Mips, 0, 0, DepthTaps::TwoByTwo, false }, 255, 255), 1.33, 0.01);
  EXPECT_EQ(count(windows(FullStride, 0, 4), 256, 256), 7.0 / 16.0);
}

TEST(StudyStructures, OverCoverageIsThatOfTheSquares)
{
  const auto measure = [](DepthTaps taps)
  {
    return NBufferStudy::MeasureOverCoverage(
      { 1, DepthGrid::Windows, FullStride, 0, taps, false }, 40, 1);
  };
  const NBufferStudy::OverCoverage one = measure(DepthTaps::One);
  const NBufferStudy::OverCoverage four = measure(DepthTaps::Four);
  double extra = 0.0;
  double area = 0.0;
  for (const auto& [width, height] : Pixels({ 1, 1, 41, 41 }))
  {
    const double pixels = width * height;
    const double side = 1 << vtkNBufferMath::GetLevelForOneLookup(width, height);
    const double small = 1 << vtkNBufferMath::GetLevelForFourLookups(width, height);
    const auto place = static_cast<std::size_t>((height - 1) * 40 + width - 1);
    EXPECT_NEAR(one.Shares[place], side * side / pixels - 1.0, 1e-9);
    EXPECT_NEAR(four.Shares[place],
      std::max<double>(width, small) * std::max<double>(height, small) / pixels - 1.0, 1e-9);
    extra += pixels * four.Shares[place];
    area += pixels;
  }
  EXPECT_NEAR(four.GetShareOfArea(), extra / area, 1e-12);
  EXPECT_LT(four.GetMean(), one.GetMean());
  EXPECT_EQ(four.GetQuantile(0.0), 0.0);
}

TEST(StudyStructures, NamesAreUnique)
{
  std::vector<std::string> names;
  for (const DepthFamily& family : MakeFamily())
  {
    // A stride means nothing to mips, which the list has once for each band.
    if (family.Grid == DepthGrid::Windows || family.Band == 0)
    {
      names.push_back(family.GetName());
    }
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(StudyRebuild, APartIsBuiltAgainAsTheWhole)
{
  std::mt19937 random(9);
  for (const auto& [width, height] : Sizes)
  {
    for (int changes : { 0, 1, 2, 9 })
    {
      Image image(width, height, 3);
      const auto build = [&]()
      {
        vtkNBufferLevels levels;
        levels.BuildBase(image.Depth.data(), width, height, 1, vtkNBufferExtremum::Maximum);
        levels.BuildLevels(64);
        return levels;
      };
      vtkNBufferLevels levels = build();
      for (int i = 0; i < changes; ++i)
      {
        image.Depth[random() % image.Depth.size()] = i % 2 ? 2.0f : -1.0f;
      }
      const vtkNBufferLevels expected = build();
      const NBufferStudy::StaleTexels stale(levels, expected);
      EXPECT_LE(stale.Base, changes);
      long long squares = 0;
      for (int level = 1; changes == 1 && level < expected.GetNumberOfLevels(); ++level)
      {
        const int side = 1 << level;
        squares += static_cast<long long>(std::min(side, stale.Changed.X1)) *
          std::min(side, stale.Changed.Y1);
      }
      const std::size_t texels = image.Depth.size();
      std::copy_n(expected.GetLevelData(0), texels, levels.GetLevelData(0));
      const long long built = stale.Base > 0 ? stale.Rebuild(levels) : 0;
      EXPECT_GE(built, stale.Stale);
      EXPECT_TRUE(changes != 1 || (stale.Stale == squares && built == squares));
      for (int level = 0; level < expected.GetNumberOfLevels(); ++level)
      {
        const float* found = levels.GetLevelData(level);
        EXPECT_TRUE(std::equal(found, found + texels, expected.GetLevelData(level))) << level;
      }
    }
  }
}
}
