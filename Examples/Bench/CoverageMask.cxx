// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoverageMask.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <iterator>

namespace NBufferBench
{
namespace
{
constexpr int Side = 4;
constexpr std::uint16_t Full = 0xffff;

template <typename Visit>
void ForEachPixel(int width, int height, Visit&& visit)
{
  const int tiles = (width + Side - 1) / Side;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      visit((y / Side) * tiles + x / Side, (y % Side) * Side + x % Side, y * width + x);
    }
  }
}

std::size_t CountTiles(int width, int height)
{
  return static_cast<std::size_t>((width + Side - 1) / Side) * ((height + Side - 1) / Side);
}
}

CoverageMask::CoverageMask(const float* depth, int width, int height)
  : Width(width)
  , Height(height)
{
  // Pixels beyond the image do not matter.
  std::vector<std::array<float, Side * Side>> depths(CountTiles(width, height));
  for (auto& tile : depths)
  {
    tile.fill(0.0F);
  }
  ForEachPixel(
    width, height, [&](int tile, int bit, int pixel) { depths[tile][bit] = depth[pixel]; });
  std::transform(depths.begin(), depths.end(), std::back_inserter(this->Tiles),
    [](const auto& tile) { return MakeTile(tile.data()); });
}

CoverageMask::Tile CoverageMask::MakeTile(const float* depths)
{
  // The mask is that of the pixels before the largest gap in depth.
  std::array<float, Side * Side> sorted;
  std::copy_n(depths, sorted.size(), sorted.begin());
  std::sort(sorted.begin(), sorted.end());
  Tile tile;
  tile.All = tile.Near = sorted.back();
  tile.Mask = Full;
  float gap = 0.0F;
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i] - sorted[i - 1] > gap)
    {
      gap = sorted[i] - sorted[i - 1];
      tile.Near = sorted[i - 1];
    }
  }
  if (gap > 0.0F)
  {
    tile.Mask = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
      tile.Mask |= static_cast<std::uint16_t>(depths[i] <= tile.Near ? 1U << i : 0U);
    }
  }
  return tile;
}

CoverageMask::Tile CoverageMask::MergeTiles(const Tile& a, const Tile& b)
{
  Tile both;
  both.Near = std::max(a.Near, b.Near);
  both.Mask = a.Mask | b.Mask;
  Tile result;
  result.All = std::min(a.All, b.All);
  if (both.Mask == Full)
  {
    result.All = std::min(result.All, both.Near);
  }
  double best = -1.0;
  for (const Tile* tile : { &a, &b, static_cast<const Tile*>(&both) })
  {
    const double worth =
      static_cast<double>(std::bitset<16>(tile->Mask).count()) * (result.All - tile->Near);
    if (worth > best)
    {
      best = worth;
      result.Near = tile->Near;
      result.Mask = tile->Mask;
    }
  }
  return result;
}

void CoverageMask::Merge(const CoverageMask& other)
{
  if (this->Tiles.empty())
  {
    *this = other;
    return;
  }
  std::transform(
    this->Tiles.begin(), this->Tiles.end(), other.Tiles.begin(), this->Tiles.begin(), &MergeTiles);
}

void CoverageMask::Apply(float* depth) const
{
  ForEachPixel(this->Width, this->Height,
    [&](int place, int bit, int pixel)
    {
      const Tile& tile = this->Tiles[place];
      const bool isNear = (tile.Mask >> bit) & 1U;
      depth[pixel] = std::min(depth[pixel], isNear ? std::min(tile.Near, tile.All) : tile.All);
    });
}

} // namespace NBufferBench
