// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTiles.h
 * @brief Receivers by tiles of the screen, and boxes of pixels around some of the tiles. No OpenGL.
 *
 * A litmap says which receivers lie on given rays. Its answer is one box of pixels, and most pixels
 * in the box may lie on other rays, or nearer to the light than the caster. Tiles of 4 x 4 pixels
 * answer the inverse question: where in light coordinates (vtkShadowLight.h) do the receivers of
 * these pixels lie? The tiles that a caster can shadow (vtkShadowUmbra.h) are marked, and a few
 * boxes that share no pixel are put around them.
 *
 *      +--+--+--+--+--+--+--+
 *      |  |##|##|  |  |  |  |     # marked tiles
 *      +--+--+--+--+--+--+--+
 *      |  |##|  |  |  |  |  |     one box around all marks has 6 x 3 tiles,
 *      +--+--+--+--+--+--+--+     two boxes have 2 x 2 and 1 x 1
 *      |  |  |  |  |  |  |##|
 *      +--+--+--+--+--+--+--+
 *
 * Where the camera sees past an edge, a tile has receivers in two places: on the surface that ends
 * at the edge, and on the surface behind it. One block around both would also hold the empty space
 * between them. If small things stand before a distant ground, their shadows mostly reach only that
 * space, and tiles would be marked without need. So a tile has two layers, divided at a window
 * depth of its own (SetSplit()), with a block for each.
 */
#ifndef vtkShadowTiles_h
#define vtkShadowTiles_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkShadowBlock.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkShadowTiles
{
public:
  /// The width and height of a tile in pixels.
  static constexpr int Size = 4;

  /// The blocks of a tile in light coordinates: that of the receivers with a window depth less than
  /// the tile's split, and that of the others.
  using Layers = std::array<vtkShadowBlock, 2>;

  /// Removes all receivers and splits, and sets the size of the image in pixels. With a size of 0
  /// the tiles are not known (IsKnown()). Memory is kept.
  void Begin(int width, int height);

  /// Sets the window depth at which the second layer of a tile begins. Any depth is correct; a good
  /// one separates receivers that lie far apart. Set it before receivers are added.
  void SetSplit(int column, int row, float depth)
  {
    this->Splits[this->GetIndex(column, row)] = depth;
  }

  /**
   * Adds a receiver with window depth `depth` that covers pixel (x, y) of the image. It lies
   * somewhere on the segment from a to b in light coordinates (p, q, s), or at most radius[i] from
   * it in coordinate i. An infinite radius means anywhere. Threads may add to different tiles at
   * the same time.
   */
  void Add(
    const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& radius, int x, int y, float depth)
  {
    const std::size_t tile = this->GetIndex(x / Size, y / Size);
    this->Tiles[tile][depth >= this->Splits[tile]].AddSegment(a, b, radius);
  }

  /// Returns true if the image has a size.
  bool IsKnown() const { return this->Columns > 0; }

  int GetNumberOfColumns() const { return this->Columns; }
  int GetNumberOfRows() const { return this->Rows; }

  /// The blocks of one tile.
  const Layers& Get(int column, int row) const { return this->Tiles[this->GetIndex(column, row)]; }

private:
  std::size_t GetIndex(int column, int row) const
  {
    return static_cast<std::size_t>(row) * this->Columns + column;
  }

  int Columns = 0;
  int Rows = 0;
  std::vector<Layers> Tiles; ///< Row by row.
  std::vector<float> Splits; ///< For each tile; infinite for a tile with one layer.
};

/**
 * A set of tiles in a rectangle of pixels.
 */
class VTKNBUFFER_EXPORT vtkShadowTileSet
{
public:
  /// Makes an empty set. It can hold the tiles that touch `pixels`, which must not be empty.
  explicit vtkShadowTileSet(const vtkNBufferRectangle& pixels);

  /// Calls functor(column, row) -> bool for all tiles that are not in the set yet, and adds those
  /// for which it returns true.
  template <typename Functor>
  void Mark(Functor&& functor)
  {
    std::size_t i = 0;
    for (int row = this->Tiles.Y0; row < this->Tiles.Y1; ++row)
    {
      for (int column = this->Tiles.X0; column < this->Tiles.X1; ++column, ++i)
      {
        this->Marks[i] = this->Marks[i] || functor(column, row);
      }
    }
  }

  /**
   * Returns boxes that hold all pixels of the rectangle in tiles of the set, and that share no
   * pixel. A box is cut in two, and its parts again, as long as the cut leaves out more than `cost`
   * pixels. The cut is where it leaves out most.
   */
  std::vector<vtkNBufferRectangle> GetBoxes(double cost) const;

private:
  void Divide(
    const vtkNBufferRectangle& tiles, double cost, std::vector<vtkNBufferRectangle>& boxes) const;

  vtkNBufferRectangle Pixels;       ///< The rectangle of pixels.
  vtkNBufferRectangle Tiles;        ///< The tiles that touch it.
  std::vector<unsigned char> Marks; ///< For each of Tiles, row by row, whether it is in the set.
};

VTK_ABI_NAMESPACE_END
#endif
