// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferCoarseDepth
 * @brief Guesses which of many boxes hide the others, by a depth image of 4 x 4 pixels per square.
 * No OpenGL.
 *
 * A box stands for the squares of the middle three quarters of the width and height of its
 * rectangle (those of which this part covers at least three pixels in x and in y), or for the
 * square of its middle. There it hides what lies beyond its farthest depth:
 *
 *     +---------------+
 *     |  +---------+  |   rectangle of the box
 *     |  | # # # # |  |   #  squares in which it hides what is behind it
 *     |  | # # # # |  |
 *     |  +---------+  |
 *     +---------------+
 *
 * What is in the box need not fill these squares, so that the answers are good only for choosing
 * what to draw before a test. The box of the least farthest depth is always open.
 */
#ifndef vtkNBufferCoarseDepth_h
#define vtkNBufferCoarseDepth_h

#include "vtkNBufferMath.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferCoarseDepth
{
public:
  /// For a viewport of `width` x `height` pixels.
  vtkNBufferCoarseDepth(int width, int height)
    : All(vtkNBufferMath::GetBaseRectangle({ 0, 0, width, height }, SquareSide))
    , Squares(static_cast<std::size_t>(this->All.X1) * this->All.Y1,
        std::numeric_limits<double>::infinity())
  {
  }

  /// Let a box hide what is behind it, by the members Pixels and Farthest of its
  /// vtkNBufferScreenBox.
  void Add(const vtkNBufferRectangle& pixels, double farthest)
  {
    ForEach(*this, GetMiddle(pixels), [&](double& depth) { depth = std::min(depth, farthest); });
  }

  /// Whether a box is in front of the boxes that were added in more than 1/`share` of these squares
  /// of its own, by the members Pixels and Nearest of its vtkNBufferScreenBox.
  bool IsOpen(const vtkNBufferRectangle& pixels, double nearest, int share) const
  {
    int difference = 0;
    ForEach(*this, GetMiddle(pixels),
      [&](const double& depth) { difference += nearest < depth ? share - 1 : -1; });
    return difference > 0;
  }

private:
  static constexpr int SquareSide = 4;   // in pixels
  static constexpr int SharePerSide = 8; // 1/8 of the width or height, on each side

  /// The squares that lie in the middle of a rectangle, or that of its middle.
  static vtkNBufferRectangle GetMiddle(const vtkNBufferRectangle& pixels)
  {
    vtkNBufferRectangle squares;
    FindMiddle(pixels.X0, pixels.X1, squares.X0, squares.X1);
    FindMiddle(pixels.Y0, pixels.Y1, squares.Y0, squares.Y1);
    return squares;
  }

  static void FindMiddle(int begin, int end, int& first, int& last)
  {
    const int border = (end - begin) / SharePerSide;
    first = (begin + border + SquareSide - 2) / SquareSide;
    last = (end - border + 1) / SquareSide;
    if (last <= first)
    {
      first = (begin + end) / 2 / SquareSide;
      last = first + 1;
    }
  }

  /// Call function(depth) for each square of the screen that lies in a rectangle of squares. The
  /// rectangle of a box that is not Inside may be an old one, of a larger screen.
  template <typename Depth, typename Function>
  static void ForEach(Depth& depth, const vtkNBufferRectangle& rectangle, Function&& function)
  {
    const vtkNBufferRectangle squares = rectangle.GetIntersection(depth.All);
    for (int y = squares.Y0; y < squares.Y1 && !squares.IsEmpty(); ++y)
    {
      const auto row = depth.Squares.begin() + static_cast<std::ptrdiff_t>(y) * depth.All.X1;
      std::for_each(row + squares.X0, row + squares.X1, function);
    }
  }

  vtkNBufferRectangle All; ///< The rectangle of all squares of the screen.
  std::vector<double> Squares;
};

VTK_ABI_NAMESPACE_END
#endif
