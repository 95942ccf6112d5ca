// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Every texel and many rectangles of vtkNBufferLevels against a double loop over the image.
#include "../Support/DepthImage.h"
#include "vtkNBufferLevels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Extremum = vtkNBufferExtremum;

struct Image : DepthImage
{
  Image(int width, int height, unsigned int seed)
    : DepthImage(width, height, seed, Fill::Outliers)
  {
  }
};

/// The image that a base of `factor` stands for, by the double loop.
Image Reduce(const Image& image, int factor, Extremum extremum)
{
  Image base((image.Width + factor - 1) / factor, (image.Height + factor - 1) / factor, 0);
  for (int y = 0; y < base.Height; ++y)
  {
    for (int x = 0; x < base.Width; ++x)
    {
      base.Depth[static_cast<std::size_t>(y) * base.Width + x] =
        image.Scan(x * factor, y * factor, (x + 1) * factor, (y + 1) * factor, extremum);
    }
  }
  return base;
}

/// Extremum over windows of `side` texels from each texel on, along one axis: the only trick of
/// this oracle. A square is a row window of column windows, each a plain loop.
std::vector<float> Window(const std::vector<float>& in, int count, int lines, int stride,
  int lineStride, int side, Extremum extremum)
{
  std::vector<float> out(in.size());
  for (int line = 0; line < lines; ++line)
  {
    for (int i = 0; i < count; ++i)
    {
      const std::size_t first = static_cast<std::size_t>(line) * lineStride;
      float value = in[first + static_cast<std::size_t>(i) * stride];
      for (int j = i + 1; j < std::min(i + side, count); ++j)
      {
        const float next = in[first + static_cast<std::size_t>(j) * stride];
        value = extremum == Extremum::Maximum ? std::max(value, next) : std::min(value, next);
      }
      out[first + static_cast<std::size_t>(i) * stride] = value;
    }
  }
  return out;
}

/// All texels of all levels, against the double loop.
void CheckEveryTexel(const vtkNBufferLevels& levels, const Image& base, Extremum extremum)
{
  ASSERT_EQ(levels.GetWidth(), base.Width);
  ASSERT_EQ(levels.GetHeight(), base.Height);
  for (int level = 0; level < levels.GetNumberOfLevels(); ++level)
  {
    const int side = 1 << level;
    const std::vector<float> columns =
      Window(base.Depth, base.Height, base.Width, base.Width, 1, side, extremum);
    const std::vector<float> squares =
      Window(columns, base.Width, base.Height, 1, base.Width, side, extremum);
    const float* data = levels.GetLevelData(level);
    ASSERT_NE(data, nullptr) << "level " << level;
    for (std::size_t i = 0; i < squares.size(); ++i)
    {
      ASSERT_EQ(data[i], squares[i])
        << "level " << level << " texel (" << i % base.Width << ", " << i / base.Width << ")";
    }
  }
}

/// Both kinds of query for one rectangle of the base: conservative, and exactly what the squares
/// of the cover hold.
void CheckQuery(const vtkNBufferLevels& levels, const Image& base, const vtkNBufferRectangle& r,
  Extremum extremum)
{
  std::ostringstream where;
  where << "[" << r.X0 << ", " << r.X1 << ") x [" << r.Y0 << ", " << r.Y1 << ") of " << base.Width
        << " x " << base.Height;
  const float truth = base.Scan(r.X0, r.Y0, r.X1, r.Y1, extremum);
  for (const vtkNBufferCover& cover :
    { vtkNBufferMath::GetCoverOfOne(r), vtkNBufferMath::GetCoverOfFour(r) })
  {
    ASSERT_LT(cover.Level, levels.GetNumberOfLevels()) << where.str();
    const float answer = levels.Query(cover);
    const int side = 1 << cover.Level;
    float squares =
      base.Scan(cover.X[0], cover.Y[0], cover.X[0] + side, cover.Y[0] + side, extremum);
    for (int i = 1; i < cover.Count; ++i)
    {
      const float next =
        base.Scan(cover.X[i], cover.Y[i], cover.X[i] + side, cover.Y[i] + side, extremum);
      squares = extremum == Extremum::Maximum ? std::max(squares, next) : std::min(squares, next);
    }
    ASSERT_EQ(answer, squares) << where.str() << ", " << cover.Count << " texels of level "
                               << cover.Level;
    if (extremum == Extremum::Maximum)
    {
      ASSERT_GE(answer, truth) << where.str();
    }
    else
    {
      ASSERT_LE(answer, truth) << where.str();
    }
    // Where squares do not stick out the answer is exact.
    if (side <= std::min(r.GetWidth(), r.GetHeight()))
    {
      ASSERT_EQ(answer, truth) << where.str();
    }
  }
}

std::string Describe(int width, int height, int factor, Extremum extremum, unsigned int seed)
{
  std::ostringstream os;
  os << width << " x " << height << " factor " << factor
     << (extremum == Extremum::Maximum ? " maximum" : " minimum") << " seed " << seed;
  return os.str();
}

struct Case
{
  int Width;
  int Height;
  int Factor;
  Extremum Kind;
};

void PrintTo(const Case& c, std::ostream* os)
{
  *os << c.Width << " x " << c.Height << ", factor " << c.Factor;
}

/// All factors with both extrema for one size.
std::vector<Case> Cases(int width, int height, const std::vector<int>& factors)
{
  std::vector<Case> cases;
  for (int factor : factors)
  {
    cases.push_back({ width, height, factor, Extremum::Maximum });
    cases.push_back({ width, height, factor, Extremum::Minimum });
  }
  return cases;
}

std::string Name(const testing::TestParamInfo<Case>& info)
{
  return "Factor" + std::to_string(info.param.Factor) +
    (info.param.Kind == Extremum::Maximum ? "Maximum" : "Minimum");
}

class NBufferLevels : public testing::TestWithParam<Case>
{
protected:
  int Width = this->GetParam().Width;
  int Height = this->GetParam().Height;
  int Factor = this->GetParam().Factor;
  Extremum Kind = this->GetParam().Kind;
};
}

using NBufferLevelsSmall = NBufferLevels;

// Hazard: border texels, non-square images and single rows are where a range query goes wrong;
// here every rectangle of small images is asked.
TEST_P(NBufferLevelsSmall, EveryRectangle)
{
  SCOPED_TRACE(Describe(this->Width, this->Height, this->Factor, this->Kind, 7));
  const Image image(this->Width, this->Height, 7);
  const Image base = Reduce(image, this->Factor, this->Kind);
  vtkNBufferLevels levels;
  levels.BuildBase(image.Depth.data(), this->Width, this->Height, this->Factor, this->Kind);
  const int count = vtkNBufferMath::GetNumberOfLevels(base.Width, base.Height);
  EXPECT_EQ(levels.BuildLevels(count), count - 1);
  CheckEveryTexel(levels, base, this->Kind);
  for (int x0 = 0; x0 < base.Width; ++x0)
  {
    for (int x1 = x0 + 1; x1 <= base.Width; ++x1)
    {
      for (int y0 = 0; y0 < base.Height; ++y0)
      {
        for (int y1 = y0 + 1; y1 <= base.Height; ++y1)
        {
          CheckQuery(levels, base, { x0, y0, x1, y1 }, this->Kind);
          if (this->HasFatalFailure())
          {
            return;
          }
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Size1x1, NBufferLevelsSmall, testing::ValuesIn(Cases(1, 1, { 1, 2, 4 })), Name);
INSTANTIATE_TEST_SUITE_P(
  Size1x6, NBufferLevelsSmall, testing::ValuesIn(Cases(1, 6, { 1, 2, 4 })), Name);
INSTANTIATE_TEST_SUITE_P(
  Size6x1, NBufferLevelsSmall, testing::ValuesIn(Cases(6, 1, { 1, 2, 4 })), Name);
INSTANTIATE_TEST_SUITE_P(
  Size12x19, NBufferLevelsSmall, testing::ValuesIn(Cases(12, 19, { 1, 2, 3, 4, 8 })), Name);

using NBufferLevelsLarge = NBufferLevels;

// Hazard: steps between powers of two and rows shared out to threads; every texel of every level,
// and many rectangles of all shapes.
TEST_P(NBufferLevelsLarge, EveryTexelAndRandomRectangles)
{
  SCOPED_TRACE(Describe(this->Width, this->Height, this->Factor, this->Kind, 11));
  const Image image(this->Width, this->Height, 11);
  const Image base = Reduce(image, this->Factor, this->Kind);
  vtkNBufferLevels levels;
  levels.BuildBase(image.Depth.data(), this->Width, this->Height, this->Factor, this->Kind);
  EXPECT_EQ(levels.GetPixelWidth(), this->Width);
  EXPECT_EQ(levels.GetPixelHeight(), this->Height);
  EXPECT_EQ(levels.GetFactor(), this->Factor);
  EXPECT_EQ(levels.GetExtremum(), this->Kind);
  levels.BuildLevels(vtkNBufferMath::GetNumberOfLevels(base.Width, base.Height));
  CheckEveryTexel(levels, base, this->Kind);

  const int w = base.Width;
  const int h = base.Height;
  // Degenerate shapes: single texels in the corners, whole rows and columns, the whole image.
  std::vector<vtkNBufferRectangle> rectangles = { { 0, 0, 1, 1 }, { w - 1, 0, w, 1 },
    { 0, h - 1, 1, h }, { w - 1, h - 1, w, h }, { 0, 0, w, 1 }, { 0, h - 1, w, h }, { 0, 0, 1, h },
    { w - 1, 0, w, h }, { 0, 0, w, h } };
  std::mt19937 random(11);
  for (int i = 0; i < 2000; ++i)
  {
    const int x = static_cast<int>(random() % w);
    const int y = static_cast<int>(random() % h);
    // Sides by powers of two, so that small and long thin ones are as frequent as large ones.
    const int dx = 1 + static_cast<int>(random() % (1u << (random() % 10)));
    const int dy = 1 + static_cast<int>(random() % (1u << (random() % 10)));
    rectangles.push_back({ x, y, std::min(x + dx, w), std::min(y + dy, h) });
  }
  for (const vtkNBufferRectangle& r : rectangles)
  {
    CheckQuery(levels, base, r, this->Kind);
    if (this->HasFatalFailure())
    {
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Size49x2, NBufferLevelsLarge, testing::ValuesIn(Cases(49, 2, { 1, 2, 4, 5, 8 })), Name);
INSTANTIATE_TEST_SUITE_P(
  Size100x300, NBufferLevelsLarge, testing::ValuesIn(Cases(100, 300, { 1, 2, 4, 7, 8 })), Name);
INSTANTIATE_TEST_SUITE_P(
  Size511x1023, NBufferLevelsLarge, testing::ValuesIn(Cases(511, 1023, { 1, 2, 4, 8, 16 })), Name);

// Hazard: a factor larger than the image reduces it to one texel and must not read beyond it.
TEST(NBufferLevelsOnce, FactorLargerThanTheImage)
{
  const Image image(5, 3, 3);
  vtkNBufferLevels levels;
  levels.BuildBase(image.Depth.data(), 5, 3, 8, Extremum::Maximum);
  ASSERT_EQ(levels.GetWidth(), 1);
  ASSERT_EQ(levels.GetHeight(), 1);
  EXPECT_EQ(levels.GetLevelData(0)[0], image.Scan(0, 0, 5, 3, Extremum::Maximum));
  EXPECT_EQ(levels.BuildLevels(5), 0) << "one texel has one level";
}

// Hazard: levels added on demand in a later round must equal those built at once.
TEST(NBufferLevelsOnce, LevelsAreBuiltOneByOneAsIfAtOnce)
{
  const Image image(37, 61, 5);
  const Image base = Reduce(image, 2, Extremum::Maximum);
  vtkNBufferLevels levels;
  levels.BuildBase(image.Depth.data(), 37, 61, 2, Extremum::Maximum);
  EXPECT_EQ(levels.GetNumberOfLevels(), 1);
  EXPECT_EQ(levels.GetLevelData(1), nullptr) << "not built yet";
  EXPECT_EQ(levels.GetLevelData(-1), nullptr);
  EXPECT_EQ(levels.BuildLevels(0), 0);
  EXPECT_EQ(levels.BuildLevels(1), 0);
  EXPECT_EQ(levels.BuildLevels(2), 1);
  EXPECT_EQ(levels.BuildLevels(2), 0) << "nothing is built twice";
  EXPECT_EQ(levels.BuildLevels(4), 2);
  EXPECT_EQ(levels.GetNumberOfLevels(), 4);
  EXPECT_EQ(levels.BuildLevels(100), 2) << "31 texels need levels 0 to 5";
  EXPECT_EQ(levels.GetNumberOfLevels(), vtkNBufferMath::GetNumberOfLevels(19, 31));
  CheckEveryTexel(levels, base, Extremum::Maximum);
}

// Hazard: memory is kept from build to build; values of an older, larger image must not show.
TEST(NBufferLevelsOnce, ASmallerImageAfterALargerOne)
{
  vtkNBufferLevels levels;
  const Image large(200, 100, 1);
  levels.BuildBase(large.Depth.data(), 200, 100, 1, Extremum::Maximum);
  levels.BuildLevels(8);
  const Image small(33, 70, 2);
  levels.BuildBase(small.Depth.data(), 33, 70, 4, Extremum::Minimum);
  EXPECT_EQ(levels.GetNumberOfLevels(), 1) << "levels above the base are dropped";
  levels.BuildLevels(8);
  CheckEveryTexel(levels, Reduce(small, 4, Extremum::Minimum), Extremum::Minimum);
}

// Hazard: an image that is gone must not answer.
TEST(NBufferLevelsOnce, ClearForgetsTheImage)
{
  vtkNBufferLevels levels;
  EXPECT_EQ(levels.GetNumberOfLevels(), 0);
  EXPECT_EQ(levels.GetLevelData(0), nullptr);
  EXPECT_EQ(levels.BuildLevels(3), 0) << "no base";
  const Image image(9, 9, 1);
  levels.BuildBase(image.Depth.data(), 9, 9, 1, Extremum::Maximum);
  levels.BuildLevels(9);
  levels.Clear();
  EXPECT_EQ(levels.GetNumberOfLevels(), 0);
  EXPECT_EQ(levels.GetWidth(), 0);
  EXPECT_EQ(levels.GetHeight(), 0);
  EXPECT_EQ(levels.GetPixelWidth(), 0);
  EXPECT_EQ(levels.GetPixelHeight(), 0);
  EXPECT_EQ(levels.GetLevelData(0), nullptr);
  EXPECT_EQ(levels.BuildLevels(3), 0);
}

// Hazard: a minimised window has no pixels.
TEST(NBufferLevelsOnce, EmptyImages)
{
  const float depth = 1.0f;
  for (const auto& size : { std::pair<int, int>(0, 0), { 0, 7 }, { 7, 0 } })
  {
    vtkNBufferLevels levels;
    levels.BuildBase(&depth, size.first, size.second, 4, Extremum::Maximum);
    EXPECT_EQ(levels.GetNumberOfLevels(), 0);
    EXPECT_EQ(levels.GetLevelData(0), nullptr);
    EXPECT_EQ(levels.BuildLevels(4), 0);
  }
}

// Hazard: levels filled from the graphics device land where queries look for them.
TEST(NBufferLevelsOnce, AllocateIsFilledFromOutside)
{
  const Image image(21, 13, 9);
  const Image base = Reduce(image, 2, Extremum::Maximum);
  vtkNBufferLevels built;
  built.BuildBase(image.Depth.data(), 21, 13, 2, Extremum::Maximum);
  built.BuildLevels(9);
  vtkNBufferLevels filled;
  filled.Allocate(21, 13, 2, 3, Extremum::Maximum);
  ASSERT_EQ(filled.GetWidth(), 11);
  ASSERT_EQ(filled.GetHeight(), 7);
  ASSERT_EQ(filled.GetNumberOfLevels(), 3);
  for (int level = 0; level < 3; ++level)
  {
    std::copy_n(built.GetLevelData(level), 11 * 7, filled.GetLevelData(level));
  }
  EXPECT_EQ(filled.BuildLevels(9), 2) << "the rest is built on top of what was filled in";
  CheckEveryTexel(filled, base, Extremum::Maximum);
  vtkNBufferLevels many;
  many.Allocate(21, 13, 2, 50, Extremum::Maximum);
  EXPECT_EQ(many.GetNumberOfLevels(), vtkNBufferMath::GetNumberOfLevels(11, 7)) << "clamped";
}

// Hazard: equal depths and the ends of the range are values like any other.
TEST(NBufferLevelsOnce, ConstantImagesAndInfinities)
{
  const float infinity = std::numeric_limits<float>::infinity();
  for (float value : { 0.0f, 1.0f, -infinity, infinity, 0.5f })
  {
    for (Extremum extremum : { Extremum::Maximum, Extremum::Minimum })
    {
      const std::vector<float> depth(17 * 5, value);
      vtkNBufferLevels levels;
      levels.BuildBase(depth.data(), 17, 5, 2, extremum);
      levels.BuildLevels(9);
      for (int level = 0; level < levels.GetNumberOfLevels(); ++level)
      {
        for (int i = 0; i < 9 * 3; ++i)
        {
          ASSERT_EQ(levels.GetLevelData(level)[i], value) << level << " " << i;
        }
      }
    }
  }
}
