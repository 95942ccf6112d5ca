// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferMath.h"

#include <algorithm>
#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// ceil(n / 2^level), without overflow for any int.
int CountSquares(int n, int level)
{
  return static_cast<int>((static_cast<std::int64_t>(n) + (std::int64_t(1) << level) - 1) >> level);
}

/// Squares of side 2^level cover [begin, end): each begins where the one before it ends, but the
/// last one ends at `end`. Returns where square `index` begins. A single square that is larger than
/// the range ends at `end` too, or begins at 0 if it would otherwise begin below 0.
int GetStart(int begin, int end, int level, int index)
{
  const std::int64_t side = std::int64_t(1) << level;
  const std::int64_t last = end - side;
  if (last < begin)
  {
    return static_cast<int>(std::max<std::int64_t>(last, 0));
  }
  return static_cast<int>(std::min(begin + index * side, last));
}

vtkNBufferCover GetCover(const vtkNBufferRectangle& rectangle, int level)
{
  vtkNBufferCover cover;
  cover.Level = level;
  const int columns = CountSquares(rectangle.GetWidth(), level);
  const int rows = CountSquares(rectangle.GetHeight(), level);
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      cover.X[cover.Count] = GetStart(rectangle.X0, rectangle.X1, level, column);
      cover.Y[cover.Count] = GetStart(rectangle.Y0, rectangle.Y1, level, row);
      ++cover.Count;
    }
  }
  return cover;
}
}

namespace vtkNBufferMath
{
int CeilLog2(int n)
{
  int result = 0;
  while ((std::int64_t(1) << result) < n)
  {
    ++result;
  }
  return result;
}

int GetBaseSize(int size, int factor)
{
  return size / factor + (size % factor > 0 ? 1 : 0);
}

vtkNBufferRectangle GetBaseRectangle(const vtkNBufferRectangle& pixels, int factor)
{
  vtkNBufferRectangle texels;
  texels.X0 = pixels.X0 / factor;
  texels.Y0 = pixels.Y0 / factor;
  texels.X1 = GetBaseSize(pixels.X1, factor);
  texels.Y1 = GetBaseSize(pixels.Y1, factor);
  return texels;
}

int GetNumberOfLevels(int width, int height)
{
  return width < 1 || height < 1 ? 0 : CeilLog2(std::max(width, height)) + 1;
}

int GetLevelForOneLookup(int width, int height)
{
  return CeilLog2(std::max(width, height));
}

int GetLevelForFourLookups(int width, int height)
{
  // Four squares in a row reach 4 * 2^k, so that no level below log2(longer side) - 2 can do.
  int level = std::max(CeilLog2(std::max(width, height)) - 2, 0);
  while (static_cast<std::int64_t>(CountSquares(width, level)) * CountSquares(height, level) > 4)
  {
    ++level;
  }
  return level;
}

vtkNBufferCover GetCoverOfOne(const vtkNBufferRectangle& rectangle)
{
  return GetCover(rectangle, GetLevelForOneLookup(rectangle.GetWidth(), rectangle.GetHeight()));
}

vtkNBufferCover GetCoverOfFour(const vtkNBufferRectangle& rectangle)
{
  return GetCover(rectangle, GetLevelForFourLookups(rectangle.GetWidth(), rectangle.GetHeight()));
}
}
VTK_ABI_NAMESPACE_END
