// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTiles.h"

#include <algorithm>
#include <cstddef>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// The first and the last marked tile of a line, which is a row or a column.
struct Span
{
  int First = std::numeric_limits<int>::max();
  int Last = -1;

  void Add(const Span& other)
  {
    this->First = std::min(this->First, other.First);
    this->Last = std::max(this->Last, other.Last);
  }
};

/// Returns for i = 0, 1, ... the number of tiles in the box around the marks of the first i lines.
template <typename Iterator>
std::vector<int> GetAreas(Iterator line, Iterator end)
{
  std::vector<int> areas = { 0 };
  Span all;
  int lines = 0; // lines since the first one with a mark
  int used = 0;  // lines from the first to the last one with a mark
  for (; line != end; ++line)
  {
    lines += lines > 0 || line->Last >= 0;
    used = line->Last >= 0 ? lines : used;
    all.Add(*line);
    areas.push_back(used > 0 ? used * (all.Last - all.First + 1) : 0);
  }
  return areas;
}
}

void vtkShadowTiles::Begin(int width, int height)
{
  this->Columns = (width + Size - 1) / Size;
  this->Rows = (height + Size - 1) / Size;
  const std::size_t size = this->GetIndex(0, this->Rows);
  this->Tiles.assign(size, Layers());
  this->Splits.assign(size, std::numeric_limits<float>::infinity());
}

vtkShadowTileSet::vtkShadowTileSet(const vtkNBufferRectangle& pixels)
  : Pixels(pixels)
{
  constexpr int size = vtkShadowTiles::Size;
  this->Tiles = { pixels.X0 / size, pixels.Y0 / size, (pixels.X1 + size - 1) / size,
    (pixels.Y1 + size - 1) / size };
  this->Marks.assign(static_cast<std::size_t>(this->Tiles.GetWidth()) * this->Tiles.GetHeight(), 0);
}

std::vector<vtkNBufferRectangle> vtkShadowTileSet::GetBoxes(double cost) const
{
  constexpr int size = vtkShadowTiles::Size;
  std::vector<vtkNBufferRectangle> boxes;
  this->Divide(this->Tiles, cost / (size * size), boxes);
  for (vtkNBufferRectangle& box : boxes)
  {
    box =
      this->Pixels.GetIntersection({ box.X0 * size, box.Y0 * size, box.X1 * size, box.Y1 * size });
  }
  return boxes;
}

void vtkShadowTileSet::Divide(
  const vtkNBufferRectangle& tiles, double cost, std::vector<vtkNBufferRectangle>& boxes) const
{
  std::vector<Span> lines[2] = { std::vector<Span>(static_cast<std::size_t>(tiles.GetWidth())),
    std::vector<Span>(static_cast<std::size_t>(tiles.GetHeight())) };
  Span all[2];
  for (int y = tiles.Y0; y < tiles.Y1; ++y)
  {
    const unsigned char* row =
      this->Marks.data() + static_cast<std::size_t>(y - this->Tiles.Y0) * this->Tiles.GetWidth();
    for (int x = tiles.X0; x < tiles.X1; ++x)
    {
      if (row[x - this->Tiles.X0])
      {
        lines[0][static_cast<std::size_t>(x - tiles.X0)].Add({ y, y });
        lines[1][static_cast<std::size_t>(y - tiles.Y0)].Add({ x, x });
        all[0].Add({ x, x });
        all[1].Add({ y, y });
      }
    }
  }
  if (all[0].Last < 0)
  {
    return;
  }
  const vtkNBufferRectangle box = { all[0].First, all[1].First, all[0].Last + 1, all[1].Last + 1 };
  const int area = box.GetWidth() * box.GetHeight();
  int most = 0;
  vtkNBufferRectangle parts[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::vector<int> before = GetAreas(lines[axis].begin(), lines[axis].end());
    const std::vector<int> after = GetAreas(lines[axis].rbegin(), lines[axis].rend());
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      const int saved = area - before[i] - after[before.size() - 1 - i];
      if (saved > most)
      {
        most = saved;
        const int cut = (axis == 0 ? tiles.X0 : tiles.Y0) + static_cast<int>(i);
        parts[0] = parts[1] = tiles;
        (axis == 0 ? parts[0].X1 : parts[0].Y1) = cut;
        (axis == 0 ? parts[1].X0 : parts[1].Y0) = cut;
      }
    }
  }
  if (most > 0 && most > cost)
  {
    this->Divide(parts[0], cost, boxes);
    this->Divide(parts[1], cost, boxes);
  }
  else
  {
    boxes.push_back(box);
  }
}
VTK_ABI_NAMESPACE_END
