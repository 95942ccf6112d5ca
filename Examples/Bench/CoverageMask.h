// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoverageMask.h
 * @brief What the ranks of a parallel program could exchange in place of the farthest depth of each
 * tile: also a mask of its nearer pixels, so that the walls of two ranks fill a tile together.
 *
 * It is measured here, and no exchange sends it.
 */
#ifndef CoverageMask_h
#define CoverageMask_h

#include <cstdint>
#include <vector>

namespace NBufferBench
{

/**
 * Two statements for each tile of 4 x 4 pixels, and both are true of what the ranks have drawn
 * together: no pixel is farther than `All`, and no pixel of `Mask` is farther than `Near`. Merging
 * keeps that: the nearer `All` of two is true of both together, either mask with its depth is, and
 * so is the union of the masks with the farther of their depths. If the union covers the tile, that
 * depth is a bound for all pixels. Which of the three masks is kept is only a matter of worth.
 */
class CoverageMask
{
public:
  /// All pixels at the far plane.
  CoverageMask() = default;
  CoverageMask(const float* depth, int width, int height);

  /// Merge what another rank has drawn.
  void Merge(const CoverageMask& other);

  /// Make the pixels as near as is known.
  void Apply(float* depth) const;

private:
  struct Tile
  {
    float All = 1.0F;
    float Near = 1.0F;
    std::uint16_t Mask = 0;
  };
  static Tile MakeTile(const float* depths);
  static Tile MergeTiles(const Tile& a, const Tile& b);

  std::vector<Tile> Tiles;
  int Width = 0;
  int Height = 0;
};

} // namespace NBufferBench

#endif
