// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthImage.h
 * @brief A random depth image, and the plain loop over it with which tests compare fast queries.
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
    Uniform, ///< Depths from 0 to 1: another one in each pixel, so that a wrong texel shows.
    Outliers ///< Depths from 0.9 to 1, but in one of 16 pixels from 0 to 1: an extremum changes if
             ///< a single texel is missed.
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

  /// Returns the extremum over the pixels [x0, x1) x [y0, y1) that are in the image, or an infinity
  /// if there are none.
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
