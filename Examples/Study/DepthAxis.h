// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class DepthAxis
 * @brief What the texels of a level cover along one axis, and which of them cover an interval.
 *
 * All structures of the study are products of two axes. Level i of an axis of n texels:
 *
 *     Windows   windows of 2^i, one at every multiple of the stride 2^max(0, i - s). s = 0 is a
 *               mip chain whose sizes are rounded up, s = FullStride the N-buffer, which has a
 *               window at every texel.
 *     Mips      sizes are halved and rounded down; where a size is odd, every texel takes three of
 *               the level below instead of two, so that texel t of m covers at least
 *               [t n / m, (t + 1) n / m) (M. Turitzin, "Hierarchical Depth Buffers", 2020).
 *     FatMips   sizes as Mips; where a size is odd the last texel alone takes three.
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

/// How texel t of a level is made of the level below: texels Ratio * t and Ratio * t + Offset, and
/// Ratio * t + 2 where it has a third one. What lies beyond the last texel is the last texel.
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

  /// Whether texel t of `count` has a third one below it.
  bool HasThird(int t, int count) const
  {
    return this->ThirdTap == Third::All || (this->ThirdTap == Third::Last && t == count - 1);
  }
};

class DepthAxis
{
public:
  DepthAxis() = default;

  /// size >= 1; stride is s above, of Windows alone.
  DepthAxis(DepthGrid grid, int size, int stride);

  int GetSize() const { return this->Size; }

  /// Level 0 up to the first in which one texel covers everything. Levels above may be queried:
  /// their texels cover what those of the last one cover, or more.
  int GetNumberOfLevels() const { return this->NumberOfLevels; }

  int GetCount(int level) const;
  DepthStep GetStep(int level) const; ///< From level - 1 to `level`, level >= 1.

  ///@{
  /// The texels of the base that a texel covers: [begin, end).
  int GetBegin(int level, int texel) const;
  int GetEnd(int level, int texel) const;
  ///@}

  /**
   * The texels of `level` that cover [begin, end), which must not be empty and lie inside the axis.
   * Returns how many they are, and writes them, in rising order, if they are at most `limit`.
   */
  int Cover(int level, int begin, int end, int* texels, int limit) const;

  /// The finest level that covers [begin, end) with at most `limit` texels.
  int GetFinestLevel(int begin, int end, int limit) const;

private:
  int GetStride(int level) const;

  DepthGrid Grid = DepthGrid::Windows;
  int Size = 1;
  int Stride = FullStride;
  int NumberOfLevels = 1;
  /// Of Mips and FatMips, by level.
  std::vector<int> Counts;
  ///@{
  /// Of Mips, by level and texel.
  std::vector<std::vector<int>> Begins;
  std::vector<std::vector<int>> Ends;
  ///@}
};

} // namespace NBufferStudy

#endif
