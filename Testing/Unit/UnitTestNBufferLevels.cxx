// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Every texel and many rectangles of vtkNBufferLevels against a double loop over the image.
#include "../Support/DepthImage.h"
#include "Pixels.h"
#include "vtkNBufferLevels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
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

float Pick(Extremum extremum, float a, float b)
{
  return extremum == Extremum::Maximum ? std::max(a, b) : std::min(a, b);
}

/// The image that a base of `factor` stands for, by the double loop.
Image Reduce(const Image& image, int factor, Extremum extremum)
{
  Image base((image.Width + factor - 1) / factor, (image.Height + factor - 1) / factor, 0);
  for (const auto& [x, y] : Pixels(base.Width, base.Height))
  {
    base.Depth[static_cast<std::size_t>(y) * base.Width + x] =
      image.Scan(x * factor, y * factor, (x + 1) * factor, (y + 1) * factor, extremum);
  }
  return base;
}

void BuildBase(vtkNBufferLevels& levels, const Image& image, int factor, Extremum extremum)
{
  levels.BuildBase(image.Depth.data(), image.Width, image.Height, factor, extremum);
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
        value = Pick(extremum, value, in[first + static_cast<std::size_t>(j) * stride]);
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
  const float truth = base.Scan(r.X0, r.Y0, r.X1, r.Y1, extremum);
  for (const vtkNBufferCover& cover :
    { vtkNBufferMath::GetCoverOfOne(r), vtkNBufferMath::GetCoverOfFour(r) })
  {
    SCOPED_TRACE(testing::Message() << r << " of " << base.Width << " x " << base.Height << ", "
                                    << cover.Count << " texels of level " << cover.Level);
    ASSERT_LT(cover.Level, levels.GetNumberOfLevels());
    const float answer = levels.Query(cover);
    const int side = 1 << cover.Level;
    const auto scan = [&](int i)
    { return base.Scan(cover.X[i], cover.Y[i], cover.X[i] + side, cover.Y[i] + side, extremum); };
    float squares = scan(0);
    for (int i = 1; i < cover.Count; ++i)
    {
      squares = Pick(extremum, squares, scan(i));
    }
    ASSERT_EQ(answer, squares);
    ASSERT_EQ(Pick(extremum, answer, truth), answer) << "the truth is " << truth;
    // Where squares do not stick out the answer is exact.
    ASSERT_TRUE(answer == truth || side > std::min(r.GetWidth(), r.GetHeight()));
    // The pixels are those of a texel that has the answer, in one of the squares.
    const vtkNBufferRectangle pixels = levels.FindPixels(cover);
    const int factor = levels.GetFactor();
    const int x = pixels.X0 / factor;
    const int y = pixels.Y0 / factor;
    ASSERT_EQ(pixels,
      (vtkNBufferRectangle{ x * factor, y * factor,
        std::min((x + 1) * factor, levels.GetPixelWidth()),
        std::min((y + 1) * factor, levels.GetPixelHeight()) }));
    ASSERT_EQ(levels.GetTexel(0, x, y), answer);
    int inside = 0;
    for (int i = 0; i < cover.Count; ++i)
    {
      inside +=
        x >= cover.X[i] && x < cover.X[i] + side && y >= cover.Y[i] && y < cover.Y[i] + side;
    }
    ASSERT_GT(inside, 0);
  }
}

/// Calls function(image, base, levels, factor, extremum) for all factors and both extrema.
template <typename Function>
void ForEachBase(const Image& image, const std::vector<int>& factors, Function function)
{
  for (const int factor : factors)
  {
    for (const Extremum extremum : { Extremum::Maximum, Extremum::Minimum })
    {
      SCOPED_TRACE(testing::Message()
        << image.Width << " x " << image.Height << " factor " << factor
        << (extremum == Extremum::Maximum ? " maximum" : " minimum"));
      const Image base = Reduce(image, factor, extremum);
      vtkNBufferLevels levels;
      BuildBase(levels, image, factor, extremum);
      const int count = vtkNBufferMath::GetNumberOfLevels(base.Width, base.Height);
      EXPECT_EQ(levels.BuildLevels(count), count - 1);
      EXPECT_EQ(levels.GetPixelWidth(), image.Width);
      EXPECT_EQ(levels.GetPixelHeight(), image.Height);
      EXPECT_EQ(levels.GetFactor(), factor);
      EXPECT_EQ(levels.GetExtremum(), extremum);
      CheckEveryTexel(levels, base, extremum);
      function(levels, base, extremum);
    }
  }
}
}

// Hazard: a range query is most often wrong at border texels, in images that are not square, and in
// single rows. Here every rectangle of small images is queried. A factor larger than the image
// reduces it to one texel, and must not read beyond the image.
TEST(NBufferLevels, EveryRectangleOfSmallImages)
{
  const std::pair<Image, std::vector<int>> cases[] = { { Image(1, 1, 7), { 1, 2, 4 } },
    { Image(1, 6, 7), { 1, 2, 4 } }, { Image(6, 1, 7), { 1, 2, 4 } }, { Image(5, 3, 3), { 8 } },
    { Image(12, 19, 7), { 1, 2, 3, 4, 8 } } };
  for (const auto& [image, factors] : cases)
  {
    ForEachBase(image, factors,
      [](const vtkNBufferLevels& levels, const Image& base, Extremum extremum)
      {
        ForEachRectangle(base.Width, base.Height,
          [&](const vtkNBufferRectangle& r)
          {
            if (!testing::Test::HasFatalFailure())
            {
              CheckQuery(levels, base, r, extremum);
            }
          });
      });
  }
}

// Hazard: steps between powers of two and rows shared out to threads; every texel of every level,
// and many rectangles of all shapes.
using NBufferLevelsOfLargeImages = testing::TestWithParam<std::tuple<int, int, std::vector<int>>>;

TEST_P(NBufferLevelsOfLargeImages, EveryTexelAndRandomRectangles)
{
  const auto& [width, height, factors] = this->GetParam();
  ForEachBase(Image(width, height, 11), factors,
    [](const vtkNBufferLevels& levels, const Image& base, Extremum extremum)
    {
      const int w = base.Width;
      const int h = base.Height;
      // Degenerate shapes: single texels in the corners, whole rows and columns, the whole image.
      std::vector<vtkNBufferRectangle> rectangles = { { 0, 0, 1, 1 }, { w - 1, 0, w, 1 },
        { 0, h - 1, 1, h }, { w - 1, h - 1, w, h }, { 0, 0, w, 1 }, { 0, h - 1, w, h },
        { 0, 0, 1, h }, { w - 1, 0, w, h }, { 0, 0, w, h } };
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
        ASSERT_NO_FATAL_FAILURE(CheckQuery(levels, base, r, extremum));
      }
    });
}

INSTANTIATE_TEST_SUITE_P(Sizes, NBufferLevelsOfLargeImages,
  testing::Values(std::tuple(49, 2, std::vector<int>{ 1, 2, 4, 5, 8 }),
    std::tuple(100, 300, std::vector<int>{ 1, 2, 4, 7, 8 }),
    std::tuple(511, 1023, std::vector<int>{ 1, 2, 4, 8, 16 })),
  [](const auto& info)
  {
    return std::to_string(std::get<0>(info.param)) + "x" + std::to_string(std::get<1>(info.param));
  });

// Hazard: levels added on demand in a later round must equal those built at once.
TEST(NBufferLevelsOnce, LevelsAreBuiltOneByOneAsIfAtOnce)
{
  const Image image(37, 61, 5);
  const Image base = Reduce(image, 2, Extremum::Maximum);
  vtkNBufferLevels levels;
  BuildBase(levels, image, 2, Extremum::Maximum);
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

// Hazard: memory is kept from build to build, and values of an older, larger image are used.
TEST(NBufferLevelsOnce, ASmallerImageAfterALargerOne)
{
  vtkNBufferLevels levels;
  const Image large(200, 100, 1);
  BuildBase(levels, large, 1, Extremum::Maximum);
  levels.BuildLevels(8);
  const Image small(33, 70, 2);
  BuildBase(levels, small, 4, Extremum::Minimum);
  EXPECT_EQ(levels.GetNumberOfLevels(), 1) << "levels above the base are dropped";
  levels.BuildLevels(8);
  CheckEveryTexel(levels, Reduce(small, 4, Extremum::Minimum), Extremum::Minimum);
}

// Hazard: levels are queried after the image is gone. (A minimised window has no pixels.)
TEST(NBufferLevelsOnce, WithoutAnImageThereIsNothing)
{
  const auto expectNothing = [](vtkNBufferLevels& levels, int width = 0, int height = 0)
  {
    EXPECT_EQ(levels.GetNumberOfLevels(), 0);
    EXPECT_EQ(levels.GetPixelWidth(), width);
    EXPECT_EQ(levels.GetPixelHeight(), height);
    EXPECT_EQ(levels.GetLevelData(0), nullptr);
    EXPECT_EQ(levels.BuildLevels(3), 0);
  };
  vtkNBufferLevels levels;
  expectNothing(levels);
  BuildBase(levels, Image(9, 9, 1), 1, Extremum::Maximum);
  levels.BuildLevels(9);
  levels.Clear();
  expectNothing(levels);
  EXPECT_EQ(levels.GetWidth(), 0);
  EXPECT_EQ(levels.GetHeight(), 0);
  const float depth = 1.0f;
  for (const auto& [width, height] : { std::pair(0, 0), std::pair(0, 7), std::pair(7, 0) })
  {
    vtkNBufferLevels empty;
    empty.BuildBase(&depth, width, height, 4, Extremum::Maximum);
    expectNothing(empty, width, height);
  }
}

// Hazard: a square that only partly lies in rows where nothing was drawn is left out. What is
// stored in such rows outside of these squares must not matter.
TEST(NBufferLevels, RowsOutsideAreNotLookedAt)
{
  for (const int factor : { 1, 2, 4, 8 })
  {
    for (const auto& [begin, end] : { std::pair(0, 21), std::pair(5, 6), std::pair(8, 16),
           std::pair(3, 20), std::pair(7, 7), std::pair(21, 21), std::pair(0, 0) })
    {
      SCOPED_TRACE(testing::Message() << "factor " << factor << " rows " << begin << " to " << end);
      Image image(13, 21, 7);
      Image stale = image;
      for (const auto& [x, y] : Pixels(image.Width, image.Height))
      {
        const std::size_t i = static_cast<std::size_t>(y) * image.Width + x;
        const bool isSquareOutside =
          (y / factor + 1) * factor <= begin || y / factor * factor >= end;
        image.Depth[i] = y < begin || y >= end ? 2.0f : image.Depth[i];
        stale.Depth[i] = isSquareOutside ? 5.0f : image.Depth[i];
      }
      vtkNBufferLevels expected;
      BuildBase(expected, image, factor, Extremum::Maximum);
      vtkNBufferLevels levels;
      levels.BuildBase(stale.Depth.data(), image.Width, image.Height, factor, Extremum::Maximum,
        { begin, end, 2.0f });
      const std::ptrdiff_t size = std::ptrdiff_t{ levels.GetWidth() } * levels.GetHeight();
      EXPECT_TRUE(std::equal(
        levels.GetLevelData(0), levels.GetLevelData(0) + size, expected.GetLevelData(0)));
    }
  }
}

// Hazard: levels that are filled from the graphics device are not where queries look for them.
TEST(NBufferLevelsOnce, AllocateIsFilledFromOutside)
{
  const Image image(21, 13, 9);
  const Image base = Reduce(image, 2, Extremum::Maximum);
  vtkNBufferLevels built;
  BuildBase(built, image, 2, Extremum::Maximum);
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
        const float* data = levels.GetLevelData(level);
        EXPECT_EQ(std::count(data, data + 9 * 3, value), 9 * 3) << level;
      }
    }
  }
}
