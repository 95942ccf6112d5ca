// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperMeasures.h
 * @brief What the N-buffer paper counts: the depth tests of a hardware occlusion query (table 2),
 * how much more than a rectangle a structure covers (figure 4), and the texels that change with a
 * pixel (section 4.2).
 *
 * X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum 24(3), 2005.
 */
#ifndef PaperMeasures_h
#define PaperMeasures_h

#include "DepthStructure.h"

#include "vtkNBufferLevels.h"
#include "vtkNBufferProjection.h"

#include <vector>

namespace NBufferStudy
{

/// Returns the number of pixels whose centres lie in the outline of a box: those that its front
/// faces cover. The placement of the box must be Inside. For a box that was clipped the result is
/// the number of pixels of its rectangle.
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
  /// Returns the sum of (covered - area) over all sizes, divided by the sum of the areas.
  double GetShareOfArea() const;
  /// Returns a quantile of the shares.
  double GetQuantile(double share) const;
};

/// Measures rectangles up to size x size, far from the border of the image.
OverCoverage MeasureOverCoverage(const DepthFamily& family, int size, int places);

/**
 * Which texels of levels of maxima have to be built again when texels of level 0 have changed:
 * those whose square has a changed texel. They lie on its left and below:
 *
 *     +--+--+--+--+
 *     |r |r |r |c |   c  the changed texel
 *     |r |r |r |r |   r  built again, on level 2
 *     |r |r |r |r |
 *     |r |r |r |r |
 *     +--+--+--+--+
 */
struct StaleTexels
{
  /// Compares level 0 of two structures of the same size.
  StaleTexels(const vtkNBufferLevels& before, const vtkNBufferLevels& after);

  /// Builds the levels of `levels` above level 0 again where their squares reach into Changed.
  /// All other texels must be those of before the change. Returns the number of texels built.
  long long Rebuild(vtkNBufferLevels& levels) const;

  vtkNBufferRectangle Changed; ///< The smallest rectangle that has all changed texels.
  long long Base = 0;          ///< The number of changed texels of level 0.
  long long Stale = 0;         ///< The number of texels to be built again, on all levels above.
};

} // namespace NBufferStudy

#endif
