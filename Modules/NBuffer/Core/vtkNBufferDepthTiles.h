// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDepthTiles
 * @brief Which tiles of a depth image have been read back, and which ones still have to be. No
 * OpenGL.
 *
 * The pixel test looks at the pixels of few boxes. On a graphics device reading a pixel back takes
 * far longer than reducing it there, so that only the tiles of 64 x 64 pixels that these boxes
 * touch are read, each of them once:
 *
 *      +----+----+----+----+
 *      |    |    |    |    |     # tiles that the boxes touch
 *      +----+----+----+----+
 *      | ## | ## |    | ## |     Adjacent tiles are read as one rectangle: here as two,
 *      +----+----+----+----+     2 x 2 tiles and 1 x 1.
 *      | ## | ## |    |    |
 *      +----+----+----+----+
 */
#ifndef vtkNBufferDepthTiles_h
#define vtkNBufferDepthTiles_h

#include "vtkNBufferMath.h"
#include "vtkNBufferModule.h" // For export macro

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class VTKNBUFFER_EXPORT vtkNBufferDepthTiles
{
public:
  /// The width and height of a tile in pixels.
  static constexpr int Size = 64;

  /// Begin with an image of this size in pixels, of which no tile has been read.
  void Begin(int width, int height);

  /**
   * Get rectangles that share no pixel and consist of the tiles that touch any of `rectangles` and
   * were not in an earlier result since Begin(). The parts of `rectangles` outside of the image do
   * not count. It visits each tile of each rectangle once, and each tile of the image once.
   */
  std::vector<vtkNBufferRectangle> Add(const std::vector<vtkNBufferRectangle>& rectangles);

private:
  enum class Tile : unsigned char
  {
    Unread,
    Wanted,
    Read
  };

  /// Put the wanted tiles of a row into the result, and mark them as read.
  void TakeRow(int row, std::vector<vtkNBufferRectangle>& result);

  int Width = 0;
  int Height = 0;
  int Columns = 0;
  int Rows = 0;
  std::vector<Tile> Tiles; ///< Row by row, the lowest row first.
};

VTK_ABI_NAMESPACE_END
#endif
