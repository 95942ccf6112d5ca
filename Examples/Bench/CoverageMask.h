// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoverageMask.h
 * @brief An alternative to the farthest depth of each tile, which the ranks of a parallel program
 * exchange: it also has a mask of the tile's nearer pixels, so that the walls of two ranks can fill
 * a tile together.
 *
 * It is only measured here; vtkNBufferDepthExchange does not send it.
 */
#ifndef CoverageMask_h
#define CoverageMask_h

#include <cstdint>
#include <vector>

namespace NBufferBench
{

/**
 * Makes two statements about each tile of 4 x 4 pixels, both of which are true of the depth that
 * the ranks have drawn together: no pixel is farther than `All`, and no pixel of `Mask` is farther
 * than `Near`. Merge() keeps them true: the nearer `All` of two ranks is a bound of both together.
 * So is either mask with its depth, and the union of the masks with the farther of their depths; if
 * the union covers the tile, that depth is also a bound for all pixels. All three masks are right.
 * The one with the largest product is kept: its number of pixels times how much nearer than `All`
 * its depth is.
 */
class CoverageMask
{
public:
  /// Makes a mask without tiles; Merge() then copies the other mask.
  CoverageMask() = default;
  /// Makes the mask of a depth image. Larger depths are farther.
  CoverageMask(const float* depth, int width, int height);

  /// Merges what another rank has drawn.
  void Merge(const CoverageMask& other);

  /// Moves the pixels of a depth image that are farther than the mask's bounds to these bounds.
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
