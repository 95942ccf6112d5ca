// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthFormats.h
 * @brief The depth of a frame in other formats and with another near plane.
 *
 * The depth is computed, not drawn: the distance of every pixel is computed from a depth image and
 * stored again by the formula of the convention (DepthConvention.h), rounded as the format rounds.
 * The uncertainty of a distance in the first image is added to it, so that nothing in the frame
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
  int Bits; ///< 0 for a 32-bit float.

  /// Returns a depth in [0, 1] as it is stored and read back. What does not fit a float is rounded
  /// away from the eye.
  float Store(double depth) const;

  /// Returns the quantum for SetProjection().
  double GetQuantum() const;
};

/// Returns the formats of the study: 16, 24, 32 bits and float; reversed; 1 / w.
const std::vector<DepthFormat>& GetDepthFormats();

/// Converts a frame that has 24-bit Forward depth and a perspective projection whose planes are at
/// `near` and `far`. The near plane of the result is at `newNear`, which is at most `near`.
DepthFrame Convert(
  const DepthFrame& frame, double near, double far, double newNear, const DepthFormat& format);

/// Returns the slack of each box as a distance: how much nearer than the nearest corner of the box
/// something in it may be drawn.
std::vector<double> GetSlacks(
  const DepthFrame& frame, double near, double far, const DepthFormat& format);

} // namespace NBufferStudy

#endif
