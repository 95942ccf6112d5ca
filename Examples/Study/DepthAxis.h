// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthAxis
 * @brief The texels of a level along one axis: what each covers, and which of them cover an
 * interval.
 *
 * All structures of the study are products of two axes. The levels of an axis of n texels are:
 *
 *     Windows   level i has windows of 2^i texels, one at every multiple of the stride
 *               2^max(0, i - s). s = 0 is a mip chain whose sizes are rounded up; s = FullStride is
 *               the N-buffer, which has a window at every texel.
 *     Mips      sizes are halved and rounded down; where a size is odd, every texel covers three of
 *               the level below instead of two, so that texel t of m covers at least
 *               [t n / m, (t + 1) n / m) (M. Turitzin, "Hierarchical Depth Buffers", 2020).
 *     FatMips   sizes as in Mips; where a size is odd, only the last texel covers three.
 */
#ifndef DepthAxis_h
#define DepthAxis_h

#include <vector>

namespace NBufferStudy
{

enum class DepthGrid
{
  Windows,
  Mips,
  FatMips
};

constexpr int FullStride = 30;

/// How texel t of a level is computed from the level below: from the texels Ratio * t and
/// Ratio * t + Offset, and Ratio * t + 2 if it has a third one. Texels beyond the last one are
/// replaced by the last one.
struct DepthStep
{
  enum class Third
  {
    None,
    Last,
    All
  };
  int Ratio = 1;
  int Offset = 0;
  Third ThirdTap = Third::None;

  /// Returns whether texel t of `count` covers a third texel of the level below.
  bool HasThird(int t, int count) const
  {
    return this->ThirdTap == Third::All || (this->ThirdTap == Third::Last && t == count - 1);
  }
};

class DepthAxis
{
public:
  DepthAxis() = default;

  /// `size` is at least 1; `stride` is the s above and is used by Windows only.
  DepthAxis(DepthGrid grid, int size, int stride);

  int GetSize() const { return this->Size; }

  /// Returns the number of levels from level 0 up to the first in which one texel covers
  /// everything. The functions below accept higher levels, whose texels cover the same or more.
  int GetNumberOfLevels() const { return this->NumberOfLevels; }

  /// Returns the number of texels of a level.
  int GetCount(int level) const;

  /// Returns the step from level - 1 to `level`, which is at least 1.
  DepthStep GetStep(int level) const;

  ///@{
  /// Return the interval [begin, end) of the texels of the base that a texel covers.
  int GetBegin(int level, int texel) const;
  int GetEnd(int level, int texel) const;
  ///@}

  /**
   * Finds the texels of `level` that cover [begin, end), which must not be empty and must lie
   * inside the axis. Returns their number, and writes them to `texels`, in rising order, if there
   * are at most `limit`.
   */
  int Cover(int level, int begin, int end, int* texels, int limit) const;

  /// Returns the finest level that covers [begin, end) with at most `limit` texels.
  int GetFinestLevel(int begin, int end, int limit) const;

private:
  int GetStride(int level) const;

  DepthGrid Grid = DepthGrid::Windows;
  int Size = 1;
  int Stride = FullStride;
  int NumberOfLevels = 1;
  /// The number of texels of each level of Mips and FatMips.
  std::vector<int> Counts;
  ///@{
  /// The intervals of Mips, by level and texel.
  std::vector<std::vector<int>> Begins;
  std::vector<std::vector<int>> Ends;
  ///@}
};

} // namespace NBufferStudy

#endif
