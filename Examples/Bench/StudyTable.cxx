// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyTable.h"

#include <cmath>
#include <cstddef>
#include <cstdio>

namespace NBufferBench
{

std::string Print(double value)
{
  char text[32];
  const double size = std::abs(value);
  const bool whole = size >= 100.0 || std::round(value) == value;
  std::snprintf(text, sizeof(text), whole ? "%.0f" : size >= 10.0 ? "%.1f" : "%.2f", value);
  // Thousands apart.
  std::string result = text;
  for (auto place = static_cast<std::ptrdiff_t>(
                      result.find('.') == std::string::npos ? result.size() : result.find('.')) -
         3;
       place > (value < 0.0 ? 1 : 0); place -= 3)
  {
    result.insert(static_cast<std::size_t>(place), ",");
  }
  return result;
}

std::string PrintShare(double percent)
{
  return percent < 0.0 ? "" : Print(percent);
}

std::string GetTitle(const Json::Value& scene)
{
  const std::string path = scene["path"].asString();
  return scene["scene"].asString() == "city" ? path : scene["scene"].asString() + " " + path;
}

} // namespace NBufferBench
