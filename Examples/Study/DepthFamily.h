// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthFamily.h
 * @brief The parameters that select one structure of the family, and their names.
 *
 *     parameter   meaning
 *     Factor      pixels per texel of the base, which holds their farthest depth
 *     Grid        the texels along an axis, see DepthAxis.h
 *     Stride      the s of Windows
 *     Band        levels (i, j) of windows 2^i wide and 2^j high with |i - j| <= Band; 0: squares
 *     Taps        how many texels are read for a rectangle, and in which shapes
 *     Separable   whether rows and then columns are merged, through memory, or both at once
 */
#ifndef DepthFamily_h
#define DepthFamily_h

#include "DepthAxis.h"

#include <string>

namespace NBufferStudy
{

enum class DepthTaps
{
  One,
  Four,     ///< Two by two, four in a row or four in a column: the shape that covers least.
  TwoByTwo, ///< The texels that graphics hardware fetches at once.
  FourByFour,
  All ///< Every texel of the base that the rectangle touches; there are no levels.
};

constexpr int AllShapes = 30;

struct DepthFamily
{
  int Factor = 1;
  DepthGrid Grid = DepthGrid::Windows;
  int Stride = FullStride;
  int Band = 0;
  DepthTaps Taps = DepthTaps::Four;
  bool Separable = false;

  /// Returns a name that is unique within the family, such as "squares x4 1/4", "rectangles band 1
  /// s=2 x4 1/1" or "mips 2x2 1/1".
  std::string GetName() const;
};

} // namespace NBufferStudy

#endif
