// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthFormats.h
 * @brief The same frame as other formats of depth would hold it, with another near plane.
 *
 * Computed, not drawn: the distance of every pixel comes from a depth image and is stored again by
 * the formula of the convention (DepthConvention.h), rounded as the format rounds.
 * What the first image does not know about a distance is added to it, so that nothing that it shows
 * comes nearer.
 */
#ifndef DepthFormats_h
#define DepthFormats_h

#include "DepthConvention.h"
#include "DepthFrame.h"

#include <vector>

namespace NBufferStudy
{

struct DepthFormat
{
  const char* Name;
  DepthConvention Convention;
  int Bits; ///< 0: a 32-bit float.

  /// A depth in [0, 1] as it is read back, rounded away from the eye where the format does not say.
  float Store(double depth) const;
  /// For vtkNBufferProjection.
  double GetQuantum() const;
};

/// 16, 24, 32 bits and float; reversed; one over the distance.
const std::vector<DepthFormat>& GetDepthFormats();

/// `frame` with stored 24-bit Forward depth and a perspective projection whose planes are at
/// `near` and `far`. The result has its near plane at `newNear`, not beyond `near`.
DepthFrame Convert(
  const DepthFrame& frame, double near, double far, double newNear, const DepthFormat& format);

/// Distances by which what is drawn of each box may be nearer than its nearest corner: the slack.
std::vector<double> GetSlacks(
  const DepthFrame& frame, double near, double far, const DepthFormat& format);

} // namespace NBufferStudy

#endif
