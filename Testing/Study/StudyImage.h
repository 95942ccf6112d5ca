// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyImage.h
 * @brief Random depth images, random rectangles in them, and levels of them.
 */
#ifndef StudyImage_h
#define StudyImage_h

#include "../Support/DepthImage.h"
#include "../Support/Pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace StudyTest
{

struct Image : DepthImage
{
  Image(int width, int height, unsigned int seed)
    : DepthImage(width, height, seed, Fill::Uniform)
  {
  }

  using DepthImage::Scan;
  /// Returns the farthest depth in a rectangle.
  float Scan(const vtkNBufferRectangle& r) const
  {
    return this->Scan(r.X0, r.Y0, r.X1, r.Y1, vtkNBufferExtremum::Maximum);
  }
};

/// Returns a rectangle inside the image that is not empty. Each of its sides is at most 8 pixels
/// long in about half of the cases.
inline vtkNBufferRectangle MakeRectangle(const Image& image, std::mt19937& random)
{
  const auto interval = [&random](int size, int& begin, int& end)
  {
    const int a = static_cast<int>(random() % static_cast<unsigned int>(size));
    const int b = static_cast<int>(random() % static_cast<unsigned int>(size));
    begin = std::min(a, b);
    end = std::max(a, b) + 1;
    if (random() % 2 == 0)
    {
      end = std::min(end, begin + 1 + static_cast<int>(random() % 8));
    }
  };
  vtkNBufferRectangle r;
  interval(image.Width, r.X0, r.X1);
  interval(image.Height, r.Y0, r.Y1);
  return r;
}

/// The pixels along an axis from Begin on, without End.
struct Interval
{
  int Begin;
  int End;
};

/// Expects that the texels of a level have the farthest depths of the pixels that they cover.
/// cover(size, texel) returns these along an axis.
template <typename Cover>
void ExpectLevel(const Image& image, const std::vector<float>& level, int width, int height,
  const std::string& what, const Cover& cover)
{
  ASSERT_EQ(level.size(), static_cast<std::size_t>(width) * height) << what;
  for (const auto& [x, y] : Pixels(width, height))
  {
    const Interval columns = cover(image.Width, x);
    const Interval rows = cover(image.Height, y);
    const float expected = image.Scan({ columns.Begin, rows.Begin, columns.End, rows.End });
    const float found = level[static_cast<std::size_t>(y) * width + x];
    ASSERT_EQ(std::memcmp(&expected, &found, sizeof(float)), 0)
      << what << ", texel (" << x << ", " << y << ") of " << image.Width << " x " << image.Height
      << ": expected " << expected << ", found " << found;
  }
}

} // namespace StudyTest

#endif
