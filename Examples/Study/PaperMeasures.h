// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperMeasures.h
 * @brief What the paper counts: the depth tests of a query of the hardware (table 2), and how much
 * more than a rectangle a structure covers (figure 4).
 */
#ifndef PaperMeasures_h
#define PaperMeasures_h

#include "DepthStructure.h"

#include "vtkNBufferProjection.h"

#include <vector>

namespace NBufferStudy
{

/// Returns the number of pixels whose centres lie in the outline of a box that is Inside, which is
/// the number of pixels of its front faces. For a box that was clipped it is that of its rectangle.
long long CountOutlinePixels(const vtkNBufferProjection& projection, const vtkNBufferBox& box,
  const vtkNBufferScreenBox& screen);

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
