// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDepthTiles.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
void vtkNBufferDepthTiles::Begin(int width, int height)
{
  this->Width = width;
  this->Height = height;
  this->Columns = vtkNBufferMath::GetBaseSize(width, Size);
  this->Rows = vtkNBufferMath::GetBaseSize(height, Size);
  this->Tiles.assign(static_cast<std::size_t>(this->Columns) * this->Rows, Tile::Unread);
}

std::vector<vtkNBufferRectangle> vtkNBufferDepthTiles::Add(
  const std::vector<vtkNBufferRectangle>& rectangles)
{
  for (const vtkNBufferRectangle& rectangle : rectangles)
  {
    const vtkNBufferRectangle inside =
      rectangle.GetIntersection({ 0, 0, this->Width, this->Height });
    if (inside.IsEmpty())
    {
      continue;
    }
    for (int row = inside.Y0 / Size; row <= (inside.Y1 - 1) / Size; ++row)
    {
      const auto first = this->Tiles.begin() + static_cast<std::ptrdiff_t>(row) * this->Columns;
      std::replace(
        first + inside.X0 / Size, first + (inside.X1 - 1) / Size + 1, Tile::Unread, Tile::Wanted);
    }
  }
  std::vector<vtkNBufferRectangle> result;
  for (int row = 0; row < this->Rows; ++row)
  {
    this->TakeRow(row, result);
  }
  return result;
}

void vtkNBufferDepthTiles::TakeRow(int row, std::vector<vtkNBufferRectangle>& result)
{
  const auto begin = this->Tiles.begin() + static_cast<std::ptrdiff_t>(row) * this->Columns;
  const auto end = begin + this->Columns;
  const int y0 = row * Size;
  const int y1 = std::min(y0 + Size, this->Height);
  const std::size_t below = result.size();
  for (auto first = std::find(begin, end, Tile::Wanted); first != end;)
  {
    const auto last = std::find_if(first, end, [](Tile tile) { return tile != Tile::Wanted; });
    std::fill(first, last, Tile::Read);
    const int x0 = static_cast<int>(first - begin) * Size;
    const int x1 = std::min(static_cast<int>(last - begin) * Size, this->Width);
    // A rectangle of the row below that is as wide grows by this row.
    const auto same = std::find_if(result.begin(), result.begin() + below,
      [=](const vtkNBufferRectangle& other)
      { return other.X0 == x0 && other.X1 == x1 && other.Y1 == y0; });
    if (same != result.begin() + below)
    {
      same->Y1 = y1;
    }
    else
    {
      result.push_back({ x0, y0, x1, y1 });
    }
    first = std::find(last, end, Tile::Wanted);
  }
}
VTK_ABI_NAMESPACE_END
