// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OverCoverage.h
 * @brief How much more than a rectangle a structure looks at, for rectangles of all sizes.
 */
#ifndef OverCoverage_h
#define OverCoverage_h

#include "DepthFamily.h"

#include <vector>

namespace NBufferStudy
{

struct OverCoverage
{
  int Size = 0;
  /// (covered - area) / area of rectangles of width x + 1 and height y + 1, at y * Size + x: the
  /// mean over places by chance.
  std::vector<double> Shares;

  double GetMean() const;
  /// The pixels covered too much, divided by the pixels of the rectangles, over all sizes.
  double GetShareOfArea() const;
  double GetQuantile(double share) const;
};

/// Rectangles up to size x size, far from the border of the image.
OverCoverage MeasureOverCoverage(const DepthFamily& family, int size, int places);

} // namespace NBufferStudy

#endif
