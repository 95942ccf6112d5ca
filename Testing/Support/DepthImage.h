// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthImage.h
 * @brief A depth image by chance, and the double loop over it that everything is compared with.
 */
#ifndef DepthImage_h
#define DepthImage_h

#include "vtkNBufferMath.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

struct DepthImage
{
  enum class Fill
  {
    Uniform, ///< Every pixel another depth, so that a texel too few or too many shows.
    Outliers ///< Mostly near 1 with single outliers both ways: one texel missed changes an
             ///< extremum.
  };

  int Width;
  int Height;
  std::vector<float> Depth;

  DepthImage(int width, int height, unsigned int seed, Fill fill)
    : Width(width)
    , Height(height)
    , Depth(static_cast<std::size_t>(width) * height)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (float& depth : this->Depth)
    {
      const float value = uniform(random);
      depth = fill == Fill::Outliers && random() % 16 ? 0.9f + 0.1f * value : value;
    }
  }

  /// The oracle: a loop over the pixels of a rectangle, cut to the image.
  float Scan(int x0, int y0, int x1, int y1, vtkNBufferExtremum extremum) const
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const bool largest = extremum == vtkNBufferExtremum::Maximum;
    float result = largest ? -infinity : infinity;
    for (int y = std::max(y0, 0); y < std::min(y1, this->Height); ++y)
    {
      for (int x = std::max(x0, 0); x < std::min(x1, this->Width); ++x)
      {
        const float value = this->Depth[static_cast<std::size_t>(y) * this->Width + x];
        result = largest ? std::max(result, value) : std::min(result, value);
      }
    }
    return result;
  }
};

#endif
