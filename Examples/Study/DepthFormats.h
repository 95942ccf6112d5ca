// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthFormats.h
 * @brief What a depth buffer stores, by format and by encoding of the distance, and what can be
 * concluded from a stored value.
 *
 * A distance here is w of the clip coordinates: the length along the axis of the view. With the
 * planes at `near` and `far`:
 *
 *     encoding      stored depth                  near plane  far plane   computed by
 *     Forward       (z / w + 1) / 2, as VTK has   0           1           the matrix
 *     Reversed      near / w                      1           near / far  the matrix, clip control
 *     Linear        w / far, a W-buffer           near / far  1           the fragment shader
 *     Logarithmic   log(w / near) / log(far/near) 0           1           the fragment shader
 *
 * Reversed is reversed depth with the far plane at infinity. It is also the W-buffer of those who
 * store 1 / w, and InverseW of DepthConvention.h.
 */
#ifndef DepthFormats_h
#define DepthFormats_h

#include "DepthConvention.h"
#include "DepthFrame.h"

#include <string>
#include <vector>

namespace NBufferStudy
{

enum class DepthEncoding
{
  Forward,
  Reversed,
  Linear,
  Logarithmic
};

struct DepthPlanes
{
  double Near;
  double Far;
};

struct DepthFormat
{
  DepthEncoding Encoding;
  int Bits; ///< 16, 24 or 32, or 0 for a 32-bit float.

  /// Returns "16 bits", "float reversed", "24 bits W", "32 bits logarithmic", ...
  std::string GetName() const;

  /// Returns 1 if larger depths are farther, and -1 for Reversed.
  double GetSign() const { return this->Encoding == DepthEncoding::Reversed ? -1.0 : 1.0; }

  /// Returns the depth where nothing has been drawn.
  double GetBackground() const { return this->Encoding == DepthEncoding::Reversed ? 0.0 : 1.0; }

  ///@{
  /// Return the depth of a distance, not rounded, and the distance of a depth.
  double GetDepth(const DepthPlanes& planes, double distance) const;
  double GetDistance(const DepthPlanes& planes, double depth) const;
  ///@}

  /// Returns the difference between neighbouring stored depths around this one.
  double GetQuantum(double depth) const;

  /// Returns how far neighbouring stored depths are apart at a distance, in the unit of distances:
  /// the resolution, if the device computed without errors.
  double GetResolution(const DepthPlanes& planes, double distance) const;

  /// Returns the largest distance of a surface that a device draws with this depth.
  double GetFarthest(const DepthPlanes& planes, double depth) const;
};

/// Returns all encodings with 16, 24 and 32 bits and float.
const std::vector<DepthFormat>& GetDepthFormats();

/// Returns a frame in which boxes can be tested against a depth image that was drawn in a format
/// with these planes. `frame` has the matrix of the view and the boxes, and must be a perspective.
/// The depth of the result is an order of Forward or, for all other encodings, of InverseW: neither
/// a linear nor a logarithmic depth is linear in clip coordinates, but any of them can be
/// converted.
DepthFrame MakeFrame(const DepthFrame& frame, const DepthFormat& format, const DepthPlanes& planes,
  const std::vector<double>& depth);

/// Returns the slack of each box of a frame of MakeFrame() as a distance: how far a surface has to
/// be in front of the nearest corner of the box to hide it.
std::vector<double> GetSlacks(
  const DepthFrame& frame, const DepthFormat& format, const DepthPlanes& planes);

} // namespace NBufferStudy

#endif
