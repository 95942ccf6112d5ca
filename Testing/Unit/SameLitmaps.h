// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SameLitmaps.h
 * @brief Equality of litmaps, to the bit.
 */
#ifndef SameLitmaps_h
#define SameLitmaps_h

#include "Pixels.h"
#include "vtkShadowLitmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

inline bool IsSameExtent(const vtkShadowExtent& a, const vtkShadowExtent& b)
{
  const auto tie = [](const vtkShadowExtent& e)
  { return std::tie(e.Near, e.Far, e.X0, e.Y0, e.X1, e.Y1, e.Bins); };
  return tie(a) == tie(b);
}

inline bool IsSameBlock(const vtkShadowBlock& a, const vtkShadowBlock& b)
{
  return a.Low == b.Low && a.High == b.High;
}

/// Expects that two litmaps have equal lexels in all levels, equal tiles, the same number of
/// receivers and the same widest angle.
inline void ExpectSameLitmaps(const vtkShadowLitmap& a, const vtkShadowLitmap& b)
{
  EXPECT_EQ(a.GetNumberOfReceivers(), b.GetNumberOfReceivers());
  EXPECT_EQ(a.GetWidestAngle(), b.GetWidestAngle());
  ASSERT_EQ(a.GetResolution(), b.GetResolution());
  ASSERT_EQ(a.GetNumberOfLevels(), b.GetNumberOfLevels());
  const int lexels = a.GetResolution() * a.GetResolution();
  for (int level = 0; level < a.GetNumberOfLevels(); ++level)
  {
    const vtkShadowExtent* data = a.GetLevelData(level);
    EXPECT_TRUE(std::equal(data, data + lexels, b.GetLevelData(level), IsSameExtent)) << level;
  }
  ASSERT_EQ(a.GetTiles().GetNumberOfColumns(), b.GetTiles().GetNumberOfColumns());
  ASSERT_EQ(a.GetTiles().GetNumberOfRows(), b.GetTiles().GetNumberOfRows());
  for (const auto& [column, row] :
    Pixels(a.GetTiles().GetNumberOfColumns(), a.GetTiles().GetNumberOfRows()))
  {
    EXPECT_TRUE(std::equal(a.GetTiles().Get(column, row).begin(),
      a.GetTiles().Get(column, row).end(), b.GetTiles().Get(column, row).begin(), IsSameBlock))
      << "tile " << column << ", " << row;
  }
}

#endif
