// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTieOrder.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// More rectangles leave out more pixels, but each costs a draw. More than four gained nothing.
constexpr std::size_t MaximumNumberOfRegions = 4;

/// The number of tiles along the longer side of the viewport.
constexpr int TilesPerSide = 32;

/// A draw with which props that follow in the renderer's order may tie. For a prop that is drawn
/// once more, Round is larger than the number of any round.
struct TieSource
{
  int Position = 0;
  int Round = 0;
  vtkNBufferRectangle Pixels;
};

/// The sources of ties, sorted into tiles of the viewport.
class TieSources
{
public:
  TieSources(int width, int height)
    : TileSize(std::max(1, (std::max(width, height) + TilesPerSide - 1) / TilesPerSide))
    , Columns((width + this->TileSize - 1) / this->TileSize)
    , Tiles(
        static_cast<std::size_t>(this->Columns) * ((height + this->TileSize - 1) / this->TileSize))
  {
  }

  void Add(const TieSource& draw)
  {
    this->ForEachTile(
      draw.Pixels, [&draw](int, int, std::vector<TieSource>& tile) { tile.push_back(draw); });
  }

  /// Call functor(draw, shared pixels) once for each draw whose pixels overlap the rectangle.
  template <typename Functor>
  void ForEachIn(const vtkNBufferRectangle& pixels, Functor&& functor)
  {
    this->ForEachTile(pixels,
      [&](int column, int row, const std::vector<TieSource>& tile)
      {
        for (const TieSource& draw : tile)
        {
          // The draw and the rectangle may share several tiles. The functor is called only in the
          // tile with the lower left corner of the shared pixels.
          const vtkNBufferRectangle shared = draw.Pixels.GetIntersection(pixels);
          if (!shared.IsEmpty() && shared.X0 / this->TileSize == column &&
            shared.Y0 / this->TileSize == row)
          {
            functor(draw, shared);
          }
        }
      });
  }

private:
  template <typename Functor>
  void ForEachTile(const vtkNBufferRectangle& pixels, Functor&& functor)
  {
    for (int row = pixels.Y0 / this->TileSize; row * this->TileSize < pixels.Y1; ++row)
    {
      for (int column = pixels.X0 / this->TileSize; column * this->TileSize < pixels.X1; ++column)
      {
        functor(column, row, this->Tiles[static_cast<std::size_t>(row) * this->Columns + column]);
      }
    }
  }

  int TileSize;
  int Columns;
  std::vector<std::vector<TieSource>> Tiles;
};

double GetArea(const vtkNBufferRectangle& pixels)
{
  return static_cast<double>(pixels.GetWidth()) * pixels.GetHeight();
}

vtkNBufferRectangle GetUnion(const vtkNBufferRectangle& a, const vtkNBufferRectangle& b)
{
  return { std::min(a.X0, b.X0), std::min(a.Y0, b.Y0), std::max(a.X1, b.X1), std::max(a.Y1, b.Y1) };
}

/// Add a rectangle. Then, while there are too many rectangles or the union of two has no more
/// pixels than both of them, replace the two whose union adds the fewest pixels by their union.
void AddRegion(std::vector<vtkNBufferRectangle>& regions, const vtkNBufferRectangle& pixels)
{
  regions.push_back(pixels);
  while (regions.size() > 1)
  {
    double least = std::numeric_limits<double>::infinity();
    std::size_t first = 0;
    std::size_t second = 0;
    for (std::size_t a = 0; a < regions.size(); ++a)
    {
      for (std::size_t b = a + 1; b < regions.size(); ++b)
      {
        const double growth =
          GetArea(GetUnion(regions[a], regions[b])) - GetArea(regions[a]) - GetArea(regions[b]);
        if (growth < least)
        {
          least = growth;
          first = a;
          second = b;
        }
      }
    }
    if (least > 0.0 && regions.size() <= MaximumNumberOfRegions)
    {
      return;
    }
    regions[first] = GetUnion(regions[first], regions[second]);
    regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(second));
  }
}

bool Covers(const std::vector<vtkNBufferRectangle>& regions, const vtkNBufferRectangle& pixels)
{
  return std::any_of(regions.begin(), regions.end(),
    [&pixels](const vtkNBufferRectangle& region)
    {
      return region.X0 <= pixels.X0 && region.Y0 <= pixels.Y0 && region.X1 >= pixels.X1 &&
        region.Y1 >= pixels.Y1;
    });
}
}

namespace vtkNBufferTieOrder
{
vtkNBufferContact GetTie(const vtkNBufferProjection& projection, const vtkNBufferDrawnProp& a,
  const vtkNBufferDrawnProp& b)
{
  if (!a.Bounded && !b.Bounded)
  {
    vtkNBufferContact anywhere;
    anywhere.Screen.Pixels = { 0, 0, projection.GetWidth(), projection.GetHeight() };
    return anywhere;
  }
  if (!a.Bounded || !b.Bounded)
  {
    return a.Bounded ? vtkNBufferContact{ a.Box, a.Screen } : vtkNBufferContact{ b.Box, b.Screen };
  }
  if (a.Screen.Nearest > b.Screen.Farthest || b.Screen.Nearest > a.Screen.Farthest)
  {
    return {};
  }
  return projection.GetContact(a.Box, a.Screen, b.Box, b.Screen);
}

std::vector<vtkNBufferRedraw> GetRedraws(const vtkNBufferProjection& projection,
  std::vector<vtkNBufferDrawnProp>& drawn, bool inRegions,
  const std::function<bool(const vtkNBufferContact&)>& isHidden)
{
  std::sort(drawn.begin(), drawn.end(),
    [](const vtkNBufferDrawnProp& a, const vtkNBufferDrawnProp& b)
    {
      // Among the parts of one prop, the one drawn last comes first: the prop must be drawn once
      // more where another part ties with it.
      return a.Index != b.Index ? a.Index < b.Index : a.Round > b.Round;
    });
  const vtkNBufferRectangle viewport = { 0, 0, projection.GetWidth(), projection.GetHeight() };
  const auto getPixels = [&](int i) -> const vtkNBufferRectangle&
  { return drawn[i].Bounded ? drawn[i].Screen.Pixels : viewport; };
  TieSources sources(projection.GetWidth(), projection.GetHeight());
  std::vector<vtkNBufferRedraw> redraws;
  const int count = static_cast<int>(drawn.size());
  for (int begin = 0, end = 0; begin < count; begin = end)
  {
    bool isWhole = !inRegions;
    for (end = begin; end < count && drawn[end].Index == drawn[begin].Index; ++end)
    {
      isWhole = isWhole || !drawn[end].KeepsScissor;
    }
    vtkNBufferRedraw redraw;
    redraw.Position = begin;
    for (int i = begin; i < end; ++i)
    {
      const vtkNBufferDrawnProp& part = drawn[i];
      const vtkNBufferRectangle& pixels = getPixels(i);
      sources.ForEachIn(pixels,
        [&](const TieSource& other, const vtkNBufferRectangle& shared)
        {
          if (other.Round <= part.Round || Covers(redraw.Regions, shared))
          {
            return;
          }
          const vtkNBufferDrawnProp& earlier = drawn[other.Position];
          vtkNBufferContact tie = GetTie(projection, earlier, part);
          vtkNBufferScreenBox& screen = tie.Screen;
          screen.Pixels = screen.Pixels.GetIntersection(shared);
          screen.Middles = screen.Middles.GetIntersection(shared);
          const bool canTest = isHidden && (earlier.Bounded || part.Bounded);
          if (!screen.Pixels.IsEmpty() && !(canTest && isHidden(tie)))
          {
            AddRegion(redraw.Regions, isWhole ? viewport : screen.Pixels);
          }
        });
      if (part.Round > 0 && part.MayTie)
      {
        sources.Add({ i, part.Round, pixels });
      }
    }
    // A prop that is drawn once more is drawn with all of its parts.
    for (const vtkNBufferRectangle& region : redraw.Regions)
    {
      for (int i = begin; i < end; ++i)
      {
        sources.Add({ i, std::numeric_limits<int>::max(), region.GetIntersection(getPixels(i)) });
      }
    }
    if (!redraw.Regions.empty())
    {
      if (isWhole)
      {
        redraw.Regions.clear();
      }
      redraws.push_back(std::move(redraw));
    }
  }
  return redraws;
}
}
VTK_ABI_NAMESPACE_END
