// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// What debug views show, pixel by pixel.
#include "Pixels.h"
#include "vtkShadowDebugImage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace
{
using vtkShadowDebugImage::Color;
using vtkShadowDebugImage::GetHeat;
using vtkShadowDebugImage::Image;

Color GetPixel(const Image& image, int width, int x, int y)
{
  Color color;
  std::copy_n(image.begin() + 4 * (y * width + x), 4, color.begin());
  return color;
}

constexpr Color Clear = { 0, 0, 0, 0 };
}

TEST(ShadowDebugImage, EachNumberHasItsHeat)
{
  EXPECT_EQ(GetHeat(0), Clear);
  EXPECT_EQ(GetHeat(-1), Clear);
  std::set<Color> colors;
  for (int number = 1; number <= 32; ++number)
  {
    EXPECT_TRUE(colors.insert(GetHeat(number)).second) << number;
    EXPECT_GT(GetHeat(number)[3], 0) << number;
  }
  // Blue, cyan, green, yellow, red.
  EXPECT_EQ(GetHeat(1)[2], 255);
  EXPECT_EQ(GetHeat(4)[1], 200);
  EXPECT_EQ(GetHeat(16)[1], 220);
  EXPECT_EQ(GetHeat(64)[0], 255);
  EXPECT_EQ(GetHeat(256)[1], 20);
  EXPECT_EQ(GetHeat(1 << 30), GetHeat(256));
}

// Boxes are random, and some reach out of the viewport. The colour of each pixel shows the number
// of boxes there.
TEST(ShadowDebugImage, ExtentsAreThoseOfTheBoxes)
{
  std::mt19937 random(3);
  const auto draw = [&random](int low, int high)
  { return std::uniform_int_distribution<int>(low, high)(random); };
  std::vector<vtkShadowDraw> draws(60);
  for (vtkShadowDraw& box : draws)
  {
    const int x = draw(-12, 48);
    const int y = draw(-10, 40);
    box.Box = { x, y, x + draw(0, 30), y + draw(0, 30) };
  }
  const Image image = vtkShadowDebugImage::PaintExtents(draws, 40, 30);
  ASSERT_EQ(image.size(), 4u * 40 * 30);
  int edges = 0;
  for (const auto& [x, y] : Pixels(40, 30))
  {
    int number = 0;
    bool edge = false;
    for (const vtkShadowDraw& box : draws)
    {
      const vtkNBufferRectangle r = box.Box.GetIntersection({ 0, 0, 40, 30 });
      const bool inside = IsIn(x, y, r);
      number += inside;
      edge = edge || (inside && !IsIn(x, y, { r.X0 + 1, r.Y0 + 1, r.X1 - 1, r.Y1 - 1 }));
    }
    edges += edge;
    EXPECT_EQ(GetPixel(image, 40, x, y), (edge ? Color{ 255, 255, 255, 200 } : GetHeat(number)))
      << x << ", " << y;
  }
  EXPECT_GT(edges, 100);
}

TEST(ShadowDebugImage, CountsBecomeHeat)
{
  Image image = { 0, 0, 0, 0, 1, 1, 1, 1, 17, 17, 17, 17 };
  vtkShadowDebugImage::PaintCounts(image);
  EXPECT_EQ(GetPixel(image, 3, 0, 0), Clear);
  EXPECT_EQ(GetPixel(image, 3, 1, 0), GetHeat(1));
  EXPECT_EQ(GetPixel(image, 3, 2, 0), GetHeat(17));
}

// Two litmaps of 2 x 2 lexels: squares of 8 x 8 pixels, with gaps of 2.
TEST(ShadowDebugImage, LitmapsAreSquares)
{
  vtkShadowLitmap litmaps[2];
  for (vtkShadowLitmap& litmap : litmaps)
  {
    litmap.Begin(2, { { 0.0, 0.0, 0.0 }, { 2.0, 2.0, 64.0 } });
    for (const double s : { 0.5, 63.5 })
    {
      const glm::dvec3 place = { s < 1.0 ? 0.5 : 1.5, 0.5, s };
      ASSERT_TRUE(litmap.Add(place, place, 0.0, 1, 1));
    }
    litmap.Build();
  }
  constexpr int width = 30;
  constexpr int height = 20;
  const Image image = vtkShadowDebugImage::PaintLitmaps(litmaps, 2, width, height);
  for (const int y : { 0, 10 })
  {
    for (const int x : { 0, 10 })
    {
      EXPECT_EQ(GetPixel(image, width, x, y), (Color{ 255, 255, 255, 255 })) << x << ", " << y;
      EXPECT_EQ(GetPixel(image, width, x + 4, y), (Color{ 50, 50, 50, 255 })) << x << ", " << y;
      EXPECT_EQ(GetPixel(image, width, x + 7, y + 7), (Color{ 20, 20, 30, 200 }));
      EXPECT_EQ(GetPixel(image, width, x + 8, y), Clear);
      EXPECT_EQ(GetPixel(image, width, x, y + 8), Clear);
    }
    Color heat = GetHeat(1);
    heat[3] = 255;
    EXPECT_EQ(GetPixel(image, width, 20, y), heat);
  }
  const Image none = vtkShadowDebugImage::PaintLitmaps(litmaps, 0, width, height);
  EXPECT_EQ(std::count(none.begin(), none.end(), 0), 4 * width * height);
}
