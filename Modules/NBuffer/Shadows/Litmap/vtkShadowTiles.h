// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowTiles.h
 * @brief Receivers by tiles of the screen, and boxes of pixels around some of the tiles. No OpenGL.
 *
 * A litmap is asked from the light: what lies on these rays? Its answer is one box of pixels, in
 * which most may lie on other rays, or before the caster. Tiles of 4 x 4 pixels are asked from the
 * camera: where in light coordinates (vtkShadowLight.h) do your receivers lie? The tiles that a
 * caster can shadow (vtkShadowUmbra.h) are marked, and few boxes that share no pixel put around
 * them.
 *
 * Where the camera sees past an edge, a tile has receivers in two places: of what the edge belongs
 * to, and of what is seen behind it. One block around both would hold all that lies between them,
 * and of small things before a far ground that is most of what they throw shadows on. So a tile has
 * two layers, parted at a window depth of its own (SetSplit()), with a block for each.
 */
#ifndef vtkShadowTiles_h
#define vtkShadowTiles_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro

#include <array>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// A range of light coordinates p, q and s; empty as constructed.
struct vtkShadowBlock
{
  double Low[3] = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity() };
  double High[3] = { -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };

  bool IsEmpty() const { return !(this->Low[2] <= this->High[2]); }

  /// Widen coordinate i to hold [low, high].
  void Add(int i, double low, double high)
  {
    this->Low[i] = low < this->Low[i] ? low : this->Low[i];
    this->High[i] = high > this->High[i] ? high : this->High[i];
  }
};

class VTKNBUFFER_EXPORT vtkShadowTiles
{
public:
  static constexpr int Size = 4; ///< Pixels.

  /// Of a tile: before its split, and from there on.
  using Layers = std::array<vtkShadowBlock, 2>;

  /// Start anew, for an image of that many pixels, without splits; with 0 nothing is known. Memory
  /// is kept.
  void Begin(int width, int height);

  /// Window depth from which on receivers belong to the second layer of a tile. Any is right; good
  /// ones part what lies far apart. To be set before receivers are added.
  void SetSplit(int column, int row, float depth)
  {
    this->Splits[this->GetIndex(column, row)] = depth;
  }

  /**
   * Add a receiver of a window depth that covers pixel (x, y) of the image and lies somewhere on
   * the segment from a to b in light coordinates, or at most radius[i] beside it in p, q and s.
   * Infinite is anywhere.
   */
  void Add(const double a[3], const double b[3], const double radius[3], int x, int y, float depth)
  {
    const std::size_t tile = this->GetIndex(x / Size, y / Size);
    vtkShadowBlock& block = this->Tiles[tile][depth >= this->Splits[tile]];
    for (int i = 0; i < 3; ++i)
    {
      block.Add(
        i, (a[i] < b[i] ? a[i] : b[i]) - radius[i], (a[i] < b[i] ? b[i] : a[i]) + radius[i]);
    }
  }

  /// Start anew, for an image of the size of another, with its splits.
  void BeginAs(const vtkShadowTiles& other);

  /// Add the receivers of another image of that size and splits.
  void Merge(const vtkShadowTiles& other);

  /// Whether there is an image.
  bool IsKnown() const { return this->Columns > 0; }

  int GetNumberOfColumns() const { return this->Columns; }
  int GetNumberOfRows() const { return this->Rows; }

  const Layers& Get(int column, int row) const { return this->Tiles[this->GetIndex(column, row)]; }

private:
  std::size_t GetIndex(int column, int row) const
  {
    return static_cast<std::size_t>(row) * this->Columns + column;
  }

  int Columns = 0;
  int Rows = 0;
  std::vector<Layers> Tiles; ///< Row by row.
  std::vector<float> Splits;
};

/**
 * Some of the tiles in a rectangle of pixels.
 */
class VTKNBUFFER_EXPORT vtkShadowTileSet
{
public:
  /// None yet, of those that touch `pixels`, which must not be empty.
  explicit vtkShadowTileSet(const vtkNBufferRectangle& pixels);

  /// functor(column, row) -> bool for all tiles not in the set; those for which it is true are put
  /// into it.
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
   * Boxes of pixels that hold all pixels of the rectangle in tiles of the set, and have none in
   * common. A box is cut in two where that leaves out more than `cost` pixels, at the place where
   * it leaves out most, and so are the parts.
   */
  std::vector<vtkNBufferRectangle> GetBoxes(double cost) const;

private:
  void Divide(
    const vtkNBufferRectangle& tiles, double cost, std::vector<vtkNBufferRectangle>& boxes) const;

  vtkNBufferRectangle Pixels;
  vtkNBufferRectangle Tiles;
  std::vector<unsigned char> Marks; ///< Of Tiles, row by row.
};

VTK_ABI_NAMESPACE_END
#endif
