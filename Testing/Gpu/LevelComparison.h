// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelComparison.h
 * @brief The levels of a depth image in host memory, to compare those of the device with.
 */
#ifndef LevelComparison_h
#define LevelComparison_h

#include "vtkNBufferLevels.h"

#include <cstring>
#include <sstream>
#include <string>
#include <vector>

/// More levels than any image of the tests has, for calls that build up to a number of levels.
constexpr int AllLevels = 99;

/// Builds all levels of a depth image in host memory.
inline vtkNBufferLevels BuildOnHost(
  const std::vector<float>& depth, int width, int height, int factor, vtkNBufferExtremum extremum)
{
  vtkNBufferLevels levels;
  levels.BuildBase(depth.data(), width, height, factor, extremum);
  levels.BuildLevels(vtkNBufferMath::GetNumberOfLevels(levels.GetWidth(), levels.GetHeight()));
  return levels;
}

/// Returns which is the first texel that differs, in any level and in any bit; "" if none does.
inline std::string FindDifference(const vtkNBufferLevels& expected, const vtkNBufferLevels& found)
{
  std::ostringstream text;
  text.precision(10);
  if (expected.GetWidth() != found.GetWidth() || expected.GetHeight() != found.GetHeight() ||
    expected.GetNumberOfLevels() != found.GetNumberOfLevels())
  {
    text << "expected " << expected.GetNumberOfLevels() << " levels of " << expected.GetWidth()
         << " x " << expected.GetHeight() << ", found " << found.GetNumberOfLevels() << " of "
         << found.GetWidth() << " x " << found.GetHeight();
    return text.str();
  }
  for (int level = 0; level < expected.GetNumberOfLevels(); ++level)
  {
    for (int i = 0; i < expected.GetWidth() * expected.GetHeight(); ++i)
    {
      const float* a = expected.GetLevelData(level) + i;
      const float* b = found.GetLevelData(level) + i;
      if (std::memcmp(a, b, sizeof(float)) != 0)
      {
        text << "level " << level << " texel (" << i % expected.GetWidth() << ", "
             << i / expected.GetWidth() << "): expected " << *a << ", found " << *b;
        return text.str();
      }
    }
  }
  return {};
}

#endif
