// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class PositionedLevels
 * @brief Squares that know where their farthest depth lies: which pixel keeps a box visible.
 *
 * The rules of vtkNBufferMath and vtkNBufferLevelBuilder with another texel. Of equal depths the
 * pixel that comes first, row by row, counts.
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
  std::int32_t Pixel = 0; ///< y * width + x.
};

class PositionedLevels
{
public:
  /// All levels over a base of `factor` x `factor` pixels per texel.
  void Build(const float* depth, int width, int height, int factor);

  /// The farthest pixel of the squares that cover a rectangle of pixels, four at most. Adds what
  /// was read to `lookups`.
  PositionedDepth Query(const vtkNBufferRectangle& pixels, long long& lookups) const;

  std::size_t GetNumberOfTexels() const { return this->Texels.size(); }
  std::size_t GetMemory() const { return this->Texels.capacity() * sizeof(PositionedDepth); }

private:
  std::vector<PositionedDepth> Texels;
  int Factor = 1;
  int Width = 0;
  int Height = 0;
};

} // namespace NBufferStudy

#endif
