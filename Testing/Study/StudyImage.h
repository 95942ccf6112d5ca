// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StudyImage.h
 * @brief Random depth images, and random rectangles in them.
 */
#ifndef StudyImage_h
#define StudyImage_h

#include "../Support/DepthImage.h"
#include "../Support/Pixels.h"

#include <algorithm>
#include <random>

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

} // namespace StudyTest

#endif
