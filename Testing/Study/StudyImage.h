// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyImage.h
 * @brief Depth images and rectangles by chance, and the double loop over them.
 */
#ifndef StudyImage_h
#define StudyImage_h

#include "vtkNBufferMath.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace StudyTest
{

struct Image
{
  int Width;
  int Height;
  std::vector<float> Depth;

  /// Every pixel another depth, so that a texel too few or too many shows.
  Image(int width, int height, unsigned int seed)
    : Width(width)
    , Height(height)
    , Depth(static_cast<std::size_t>(width) * height)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (float& depth : this->Depth)
    {
      depth = uniform(random);
    }
  }

  float Scan(const vtkNBufferRectangle& r) const
  {
    float result = -1.0f;
    for (int y = r.Y0; y < r.Y1; ++y)
    {
      for (int x = r.X0; x < r.X1; ++x)
      {
        result = std::max(result, this->Depth[static_cast<std::size_t>(y) * this->Width + x]);
      }
    }
    return result;
  }
};

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

} // namespace StudyTest

#endif
