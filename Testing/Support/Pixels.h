// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pixels.h
 * @brief Printing and looping over rectangles of pixels.
 */
#ifndef Pixels_h
#define Pixels_h

#include "vtkNBufferMath.h"

#include <ostream>
#include <utility>

inline std::ostream& operator<<(std::ostream& os, const vtkNBufferRectangle& r)
{
  return os << "[" << r.X0 << ", " << r.X1 << ") x [" << r.Y0 << ", " << r.Y1 << ")";
}

///@{
/// Return whether a pixel, or the whole of a rectangle, lies in a rectangle.
inline bool IsIn(int x, int y, const vtkNBufferRectangle& r)
{
  return x >= r.X0 && x < r.X1 && y >= r.Y0 && y < r.Y1;
}
inline bool IsIn(const vtkNBufferRectangle& inner, const vtkNBufferRectangle& outer)
{
  return inner.X0 >= outer.X0 && inner.Y0 >= outer.Y0 && inner.X1 <= outer.X1 &&
    inner.Y1 <= outer.Y1;
}
///@}

/**
 * The pixels of a rectangle, row by row:
 *
 *     for (const auto& [x, y] : Pixels(width, height))
 */
class Pixels
{
public:
  Pixels(int width, int height)
    : Pixels(vtkNBufferRectangle{ 0, 0, width, height })
  {
  }
  explicit Pixels(const vtkNBufferRectangle& r)
    : All(r)
  {
  }

  struct Iterator
  {
    int X;
    int Y;
    const vtkNBufferRectangle& All;

    std::pair<int, int> operator*() const { return { this->X, this->Y }; }
    bool operator!=(const Iterator& other) const { return this->Y != other.Y; }
    void operator++()
    {
      if (++this->X == this->All.X1)
      {
        this->X = this->All.X0;
        ++this->Y;
      }
    }
  };
  Iterator begin() const { return { this->All.X0, this->All.Y0, this->All }; }
  Iterator end() const
  {
    return { 0, this->All.IsEmpty() ? this->All.Y0 : this->All.Y1, this->All };
  }

private:
  vtkNBufferRectangle All;
};

/// Calls function(rectangle) for every non-empty rectangle in an image of width x height pixels.
template <typename Function>
void ForEachRectangle(int width, int height, Function function)
{
  for (const auto& [x0, y0] : Pixels(width, height))
  {
    for (const auto& [x1, y1] : Pixels({ x0 + 1, y0 + 1, width + 1, height + 1 }))
    {
      function(vtkNBufferRectangle{ x0, y0, x1, y1 });
    }
  }
}

#endif
