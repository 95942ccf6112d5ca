// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferOccluderChoice.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
constexpr int SquareSide = 8;   // The side of a square, in pixels.
constexpr int SharePerSide = 8; // 1/8 of a rectangle, on each of its sides, hides nothing.

/// The depths beyond which squares of the screen are hidden.
class CoarseDepth
{
public:
  CoarseDepth(int width, int height)
    : All(vtkNBufferMath::GetBaseRectangle({ 0, 0, width, height }, SquareSide))
    , Squares(static_cast<std::size_t>(this->All.X1) * this->All.Y1,
        std::numeric_limits<double>::infinity())
  {
  }

  /// Call function(depth) for each square of the screen that lies in a rectangle of squares. The
  /// rectangle of a box that is not Inside may be an old one, of a larger screen.
  template <typename Function>
  void ForEach(const vtkNBufferRectangle& rectangle, Function&& function)
  {
    const vtkNBufferRectangle squares = rectangle.GetIntersection(this->All);
    for (int y = squares.Y0; y < squares.Y1 && !squares.IsEmpty(); ++y)
    {
      double* row = this->Squares.data() + static_cast<std::size_t>(y) * this->All.X1;
      std::for_each(row + squares.X0, row + squares.X1, function);
    }
  }

  /// Whether a box is in front of the chosen boxes in more than half of its squares.
  bool IsOpen(const vtkNBufferScreenBox& box)
  {
    int open = 0;
    const vtkNBufferRectangle squares = vtkNBufferMath::GetBaseRectangle(box.Pixels, SquareSide);
    this->ForEach(squares, [&](double& depth) { open += box.Nearest < depth ? 1 : -1; });
    return open > 0;
  }

  /// Let a box hide what is behind it.
  void Add(const vtkNBufferScreenBox& box)
  {
    const vtkNBufferRectangle& pixels = box.Pixels;
    const int x = pixels.GetWidth() / SharePerSide;
    const int y = pixels.GetHeight() / SharePerSide;
    // Squares that lie wholly in the middle of the rectangle.
    const vtkNBufferRectangle squares = { (pixels.X0 + x + SquareSide - 1) / SquareSide,
      (pixels.Y0 + y + SquareSide - 1) / SquareSide, (pixels.X1 - x) / SquareSide,
      (pixels.Y1 - y) / SquareSide };
    this->ForEach(squares, [&](double& depth) { depth = std::min(depth, box.Farthest); });
  }

private:
  vtkNBufferRectangle All; ///< The rectangle of all squares of the screen.
  std::vector<double> Squares;
};
}

std::vector<std::size_t> vtkNBufferOccluderChoice::Choose(
  const std::vector<vtkNBufferScreenBox>& boxes, std::size_t limit, int width, int height)
{
  CoarseDepth depth(width, height);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < boxes.size() && chosen.size() < limit; ++i)
  {
    if (depth.IsOpen(boxes[i]))
    {
      depth.Add(boxes[i]);
      chosen.push_back(i);
    }
  }
  return chosen;
}
VTK_ABI_NAMESPACE_END
