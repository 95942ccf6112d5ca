// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DepthFamily.h
 * @brief The knobs that make one structure out of the family, and their names.
 *
 *     knob        values
 *     Factor      pixels per texel of the base, which holds their farthest depth
 *     Grid        what lies along an axis, see DepthAxis.h
 *     Stride      s of Windows
 *     Band        levels (i, j) of windows 2^i wide and 2^j high with |i - j| <= Band; 0: squares
 *     Taps        how many texels answer a rectangle, and in which shapes
 *     Separable   rows first, then columns, through memory; or both at once
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
  Four,     ///< Two by two, four in a row or four in a column, what covers least.
  TwoByTwo, ///< What graphics hardware fetches at once.
  FourByFour,
  All ///< No levels: every texel of the base that the rectangle touches.
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

  /// "squares x4 1/4", "rectangles band 1 s=2 x4 1/1", "mips 2x2 1/1": unique within the family.
  std::string GetName() const;
};

} // namespace NBufferStudy

#endif
