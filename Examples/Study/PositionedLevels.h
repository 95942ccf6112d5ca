// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class PositionedLevels
 * @brief An N-buffer that also has the place of each farthest depth: the pixel that keeps a box
 * visible.
 *
 * The rules are those of vtkNBufferMath and vtkNBufferLevelBuilder, with another texel. Of pixels
 * with equal depths the first one, row by row, counts.
 */
#ifndef PositionedLevels_h
#define PositionedLevels_h

#include "vtkNBufferMath.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace NBufferStudy
{

struct PositionedDepth
{
  float Depth = 0.0f;
  std::int32_t Pixel = 0; ///< The place of the pixel, y * width + x.
};

class PositionedLevels
{
public:
  /// The base has a texel for `factor` x `factor` pixels.
  explicit PositionedLevels(int factor)
    : Factor(factor)
  {
  }

  /// Builds all levels.
  void Build(const float* depth, int width, int height);

  /// Returns the farthest pixel of the squares, at most four, that cover a rectangle of pixels.
  /// Adds the number of texels that were read to `lookups`.
  PositionedDepth Query(const vtkNBufferRectangle& pixels, long long& lookups) const;

  std::size_t GetNumberOfTexels() const { return this->Texels.size(); }
  std::size_t GetMemory() const { return this->Texels.capacity() * sizeof(PositionedDepth); }

private:
  std::vector<PositionedDepth> Texels;
  int Factor;
  int Width = 0;
  int Height = 0;
};

} // namespace NBufferStudy

#endif
