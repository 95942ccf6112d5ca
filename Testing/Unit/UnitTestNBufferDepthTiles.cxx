// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDepthTiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace
{
constexpr int Size = vtkNBufferDepthTiles::Size;

/// How often each pixel of an image lies in one of the rectangles. None reaches out of the image.
std::vector<int> CountReads(
  int width, int height, const std::vector<vtkNBufferRectangle>& rectangles)
{
  std::vector<int> counts(static_cast<std::size_t>(width) * height, 0);
  for (const vtkNBufferRectangle& r : rectangles)
  {
    EXPECT_TRUE(!r.IsEmpty() && r.X0 >= 0 && r.Y0 >= 0 && r.X1 <= width && r.Y1 <= height);
    for (int y = r.Y0; y < r.Y1; ++y)
    {
      for (int x = r.X0; x < r.X1; ++x)
      {
        ++counts[static_cast<std::size_t>(y) * width + x];
      }
    }
  }
  return counts;
}

/// The example drawn in the header: one block of 2 x 2 tiles and one tile.
TEST(UnitTestNBufferDepthTiles, AdjacentTilesAreOneRectangle)
{
  vtkNBufferDepthTiles tiles;
  tiles.Begin(4 * Size, 3 * Size);
  const auto rectangles =
    tiles.Add({ { 1, 1, 2 * Size, 2 * Size }, { 3 * Size, Size, 3 * Size + 1, Size + 1 } });
  ASSERT_EQ(rectangles.size(), 2u);
  const auto expect = [&rectangles](int i, int x0, int y0, int x1, int y1)
  {
    EXPECT_EQ(rectangles[i].X0, x0 * Size);
    EXPECT_EQ(rectangles[i].Y0, y0 * Size);
    EXPECT_EQ(rectangles[i].X1, x1 * Size);
    EXPECT_EQ(rectangles[i].Y1, y1 * Size);
  };
  expect(0, 0, 0, 2, 2);
  expect(1, 3, 1, 4, 2);
}

TEST(UnitTestNBufferDepthTiles, NothingIsReadForNothing)
{
  vtkNBufferDepthTiles tiles;
  tiles.Begin(100, 70);
  EXPECT_TRUE(tiles.Add({}).empty());
  EXPECT_TRUE(tiles.Add({ { 5, 5, 5, 20 }, { 100, 0, 120, 70 }, { -9, -9, 0, 0 } }).empty());
}

/// Each pixel of a rectangle is read once, no pixel is read that is farther away than a tile, and
/// all are read again after Begin().
TEST(UnitTestNBufferDepthTiles, EachTileIsReadOnce)
{
  std::mt19937 random(5);
  const auto draw = [&random](int low, int high)
  { return std::uniform_int_distribution<int>(low, high)(random); };
  vtkNBufferDepthTiles tiles;
  for (int image = 0; image < 40; ++image)
  {
    SCOPED_TRACE(image);
    const int width = draw(1, 300);
    const int height = draw(1, 300);
    tiles.Begin(width, height);
    std::vector<int> reads(static_cast<std::size_t>(width) * height, 0);
    std::vector<unsigned char> touched(reads.size(), 0);
    for (int call = 0; call < 4; ++call)
    {
      std::vector<vtkNBufferRectangle> rectangles(draw(0, 3));
      for (vtkNBufferRectangle& rectangle : rectangles)
      {
        const int x = draw(-20, width);
        const int y = draw(-20, height);
        rectangle = { x, y, x + draw(0, 90), y + draw(0, 90) };
        const vtkNBufferRectangle inside = rectangle.GetIntersection({ 0, 0, width, height });
        for (int row = inside.Y0; row < inside.Y1; ++row)
        {
          for (int column = inside.X0; column < inside.X1; ++column)
          {
            touched[static_cast<std::size_t>(row / Size * Size) * width + column / Size * Size] = 1;
          }
        }
      }
      const std::vector<int> counts = CountReads(width, height, tiles.Add(rectangles));
      std::transform(reads.begin(), reads.end(), counts.begin(), reads.begin(), std::plus<int>());
      for (int y = 0; y < height; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          ASSERT_EQ(reads[static_cast<std::size_t>(y) * width + x],
            touched[static_cast<std::size_t>(y / Size * Size) * width + x / Size * Size])
            << x << ", " << y;
        }
      }
    }
  }
}
}
