// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SameLitmaps.h
 * @brief Equality of litmaps, to the bit.
 */
#ifndef SameLitmaps_h
#define SameLitmaps_h

#include "vtkShadowLitmap.h"

#include <gtest/gtest.h>

#include <algorithm>

inline bool IsSameExtent(const vtkShadowExtent& a, const vtkShadowExtent& b)
{
  return a.Near == b.Near && a.Far == b.Far && a.X0 == b.X0 && a.Y0 == b.Y0 && a.X1 == b.X1 &&
    a.Y1 == b.Y1 && a.Bins == b.Bins;
}

/// Lexels of all levels, numbers, reach, and the tiles of an image of that size.
inline void ExpectSameLitmaps(
  const vtkShadowLitmap& a, const vtkShadowLitmap& b, int width, int height)
{
  EXPECT_EQ(a.GetNumberOfReceivers(), b.GetNumberOfReceivers());
  EXPECT_EQ(a.GetReach(), b.GetReach());
  ASSERT_EQ(a.GetResolution(), b.GetResolution());
  ASSERT_EQ(a.GetNumberOfLevels(), b.GetNumberOfLevels());
  const int lexels = a.GetResolution() * a.GetResolution();
  for (int level = 0; level < a.GetNumberOfLevels(); ++level)
  {
    const vtkShadowExtent* data = a.GetLevelData(level);
    EXPECT_TRUE(std::equal(data, data + lexels, b.GetLevelData(level), IsSameExtent)) << level;
  }
  constexpr int size = vtkShadowTiles::Size;
  for (int row = 0; row < (height + size - 1) / size; ++row)
  {
    for (int column = 0; column < (width + size - 1) / size; ++column)
    {
      const vtkShadowBlock& x = a.GetTiles().Get(column, row);
      const vtkShadowBlock& y = b.GetTiles().Get(column, row);
      EXPECT_TRUE(std::equal(x.Low, x.Low + 3, y.Low) && std::equal(x.High, x.High + 3, y.High))
        << "tile " << column << ", " << row;
    }
  }
}

#endif
