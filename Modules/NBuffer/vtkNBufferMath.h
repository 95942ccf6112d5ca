// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferMath.h
 * @brief What a texel of an N-buffer covers, and which texels give the extremum over a rectangle.
 * No OpenGL.
 *
 * An N-buffer (X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum
 * 24(3), 2005, section 2) is a stack of images of one size. Level 0 is the base image. Texel
 * (x, y) of level i holds the extremum of the base over the square of side 2^i whose lower left
 * corner is (x, y):
 *
 *     y ^   level 2                      base, 7 x 5 texels
 *       |   +--+--+--+--+                Texel (1, 0) of level 2 covers the square s:
 *     3 |   |s |s |s |s |                x in [1, 5), y in [0, 4).
 *     2 |   |s |s |s |s |                Texel (5, 3) of level 2 covers what is left of its
 *     1 |   |s |s |s |s |                square inside the base: x in [5, 7), y in [3, 5).
 *     0 |   |X |s |s |s |                The border adds nothing: a square counts only its
 *       +---+--+--+--+--+--> x           texels inside the base.
 *           1  2  3  4
 *
 * Level i + 1 is the extremum of four texels of level i, at x and x + 2^i, y and y + 2^i. A
 * neighbour outside the image is replaced by the last texel of its row or column, which lies
 * inside the square anyway, so that clamping never changes a result.
 *
 * The base may itself be a reduction of the depth image: texel (x, y) of a base of factor f
 * covers the depth pixels [f x, f x + f) x [f y, f y + f) that lie inside the image.
 *
 * The extremum over a rectangle of w x h texels takes
 *  - one lookup, in the finest level whose squares are at least as wide and as high;
 *  - or at most four lookups, in the finest level k of which at most four squares cover the
 *    rectangle: ceil(w / 2^k) * ceil(h / 2^k) <= 4. The five cases of the paper's figure 3 follow
 *    from this rule:
 *
 *        +--+--+   +-----+   +--+--+--+--+   +--+   and a single square.
 *        |  |  |   |     |   |  |  |  |  |   |  |
 *        +--+--+   +-----+   +--+--+--+--+   +--+
 *        |  |  |   |     |                   :  :
 *        +--+--+   +-----+                   +--+
 *         2 x 2     1 x 2      4 x 1, 3 x 1   1 x 4, 1 x 3
 *
 * Squares overlap where a side of the rectangle is not a multiple of 2^k; this does not change an
 * extremum. Where a square is wider or higher than the rectangle, it ends with the rectangle on the
 * right and at the top, and reaches beyond it on the left and below, unless the border of the base
 * is in the way. It reaches down (towards y = 0) because below the screen extent of a prop there is
 * mostly the ground or another prop in front of it, and above it mostly nothing (paper, section 2).
 */
#ifndef vtkNBufferMath_h
#define vtkNBufferMath_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <algorithm>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN

/**
 * A half-open rectangle of pixels or texels: X0 <= x < X1, Y0 <= y < Y1, with y upwards.
 */
struct vtkNBufferRectangle
{
  int X0 = 0;
  int Y0 = 0;
  int X1 = 0;
  int Y1 = 0;

  int GetWidth() const { return this->X1 - this->X0; }
  int GetHeight() const { return this->Y1 - this->Y0; }
  bool IsEmpty() const { return this->X1 <= this->X0 || this->Y1 <= this->Y0; }

  bool operator==(const vtkNBufferRectangle& other) const
  {
    return this->X0 == other.X0 && this->Y0 == other.Y0 && this->X1 == other.X1 &&
      this->Y1 == other.Y1;
  }

  /// The pixels that two rectangles share; empty if there are none.
  vtkNBufferRectangle GetIntersection(const vtkNBufferRectangle& other) const
  {
    return { std::max(this->X0, other.X0), std::max(this->Y0, other.Y0),
      std::min(this->X1, other.X1), std::min(this->Y1, other.Y1) };
  }
};

/**
 * At most four texels of one level whose squares cover a rectangle. They reach beyond the rectangle
 * only where a square is wider or higher than the rectangle.
 */
struct vtkNBufferCover
{
  int Level = 0; ///< The level of all the texels.
  int Count = 0; ///< The number of texels, 1 to 4 for a rectangle that is not empty.
  ///@{
  /// The texels, which are those at (X[i], Y[i]) for i < Count.
  int X[4] = { 0, 0, 0, 0 };
  int Y[4] = { 0, 0, 0, 0 };
  ///@}
};

/**
 * Which extremum the texels of a level hold. With VTK's depth, the maximum is the farthest depth of
 * a square, which decides whether something is hidden behind it; the minimum is the nearest depth.
 */
enum class vtkNBufferExtremum
{
  Maximum,
  Minimum
};

namespace vtkNBufferMath
{
/// The smallest i with 2^i >= n, for n >= 1; 0 for smaller n.
VTKNBUFFER_EXPORT int CeilLog2(int n);

/// The width (or height) in texels of the base of a depth image that is `size` pixels wide (or
/// high): ceil(size / factor).
VTKNBUFFER_EXPORT int GetBaseSize(int size, int factor);

/// The texels of the base that a rectangle of pixels touches (rounded outward). The coordinates of
/// the rectangle must not be negative.
VTKNBUFFER_EXPORT vtkNBufferRectangle GetBaseRectangle(
  const vtkNBufferRectangle& pixels, int factor);

/// The number of levels with which one lookup answers any rectangle of a width x height base: from
/// level 0 to the first whose square covers the whole base. It is 0 for an empty base.
VTKNBUFFER_EXPORT int GetNumberOfLevels(int width, int height);

/// The finest level whose square covers a width x height rectangle.
VTKNBUFFER_EXPORT int GetLevelForOneLookup(int width, int height);

/// The finest level whose squares cover a width x height rectangle with at most four.
VTKNBUFFER_EXPORT int GetLevelForFourLookups(int width, int height);

/// The texel that covers `rectangle`, which must not be empty and must lie inside the base.
VTKNBUFFER_EXPORT vtkNBufferCover GetCoverOfOne(const vtkNBufferRectangle& rectangle);

/// The texels, at most four, that cover `rectangle`, which must not be empty and must lie inside
/// the base.
VTKNBUFFER_EXPORT vtkNBufferCover GetCoverOfFour(const vtkNBufferRectangle& rectangle);

/**
 * Merge the texels of a cover that is not empty. `texels` holds all levels of a width x height base
 * one after the other, each row by row. `merge(a, b)` returns a merged texel; it has to be
 * commutative, associative and idempotent (maximum, minimum, union of boxes, bitwise or). It has to
 * be idempotent because squares overlap: a texel that two squares contain is merged twice.
 */
template <typename Texel, typename Merge>
Texel MergeCover(
  const Texel* texels, int width, int height, const vtkNBufferCover& cover, Merge merge)
{
  const Texel* level = texels + static_cast<std::size_t>(cover.Level) * width * height;
  Texel result = level[static_cast<std::size_t>(cover.Y[0]) * width + cover.X[0]];
  for (int i = 1; i < cover.Count; ++i)
  {
    result = merge(result, level[static_cast<std::size_t>(cover.Y[i]) * width + cover.X[i]]);
  }
  return result;
}
}

VTK_ABI_NAMESPACE_END
#endif
