// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OverCoverage.h
 * @brief How much more than a rectangle a structure covers, for rectangles of all sizes.
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
  /// At y * Size + x: the mean of (covered - area) / area over random places of rectangles of width
  /// x + 1 and height y + 1.
  std::vector<double> Shares;

  /// Returns the mean of the shares.
  double GetMean() const;
  /// Returns the pixels that are covered in excess, over all sizes, divided by all pixels.
  double GetShareOfArea() const;
  /// Returns a quantile of the shares.
  double GetQuantile(double share) const;
};

/// Measures rectangles up to size x size, far from the border of the image.
OverCoverage MeasureOverCoverage(const DepthFamily& family, int size, int places);

} // namespace NBufferStudy

#endif
