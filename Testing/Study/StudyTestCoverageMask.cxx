// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Masks of several ranks bound what the ranks have drawn together, and no looser than their tiles.
#include "CoverageMask.h"
#include "StudyImage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{
using NBufferBench::CoverageMask;
using Depth = std::vector<float>;

constexpr int MaskWidth = 45; // The last tiles are not whole.
constexpr int MaskHeight = 30;
constexpr int TileSide = 4; // of a tile

/// Walls in front of nothing, each at one depth or sloping.
Depth DrawWalls(std::mt19937& random, int walls)
{
  Depth depth(static_cast<std::size_t>(MaskWidth) * MaskHeight, 1.0f);
  const auto choose = [&random](int count) { return static_cast<int>(random() % count); };
  for (int i = 0; i < walls; ++i)
  {
    const int x0 = choose(MaskWidth);
    const int y0 = choose(MaskHeight);
    const float near = static_cast<float>(1 + choose(60)) / 64.0f;
    const float slope = choose(3) == 0 ? 1.0f / 1024.0f : 0.0f;
    for (int y = y0; y < std::min(y0 + 1 + choose(20), MaskHeight); ++y)
    {
      for (int x = x0; x < std::min(x0 + 1 + choose(20), MaskWidth); ++x)
      {
        float& pixel = depth[static_cast<std::size_t>(y) * MaskWidth + x];
        pixel = std::min(pixel, near + slope * static_cast<float>(x - x0));
      }
    }
  }
  return depth;
}

/// Replaces each pixel by the farthest of its tile.
Depth GetTiles(const Depth& depth)
{
  Depth tiles = depth;
  for (const auto& [x, y] : Pixels(MaskWidth, MaskHeight))
  {
    float farthest = 0.0f;
    for (const auto& [dx, dy] : Pixels(TileSide, TileSide))
    {
      const int column = std::min(x / TileSide * TileSide + dx, MaskWidth - 1);
      const int row = std::min(y / TileSide * TileSide + dy, MaskHeight - 1);
      farthest = std::max(farthest, depth[static_cast<std::size_t>(row) * MaskWidth + column]);
    }
    tiles[static_cast<std::size_t>(y) * MaskWidth + x] = farthest;
  }
  return tiles;
}
}

TEST(StudyCoverageMask, BoundsWhatAllRanksHaveDrawn)
{
  std::mt19937 random(3);
  long long better = 0;
  for (int round = 0; round < 300; ++round)
  {
    const int ranks = 1 + static_cast<int>(random() % 4);
    std::vector<Depth> depths;
    CoverageMask all;
    Depth together(static_cast<std::size_t>(MaskWidth) * MaskHeight, 1.0f);
    Depth tiles = together;
    for (int rank = 0; rank < ranks; ++rank)
    {
      depths.push_back(DrawWalls(random, 1 + static_cast<int>(random() % 12)));
      all.Merge(CoverageMask(depths.back().data(), MaskWidth, MaskHeight));
      const Depth ofRank = GetTiles(depths.back());
      for (std::size_t i = 0; i < together.size(); ++i)
      {
        together[i] = std::min(together[i], depths.back()[i]);
        tiles[i] = std::min(tiles[i], ofRank[i]);
      }
    }
    for (const Depth& own : depths)
    {
      Depth found = own;
      all.Apply(found.data());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        ASSERT_GE(found[i], together[i]) << "something may be hidden that is visible";
        ASSERT_LE(found[i], std::min(own[i], tiles[i])) << "looser than the farthest of each tile";
        better += found[i] < std::min(own[i], tiles[i]) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(better, 0);
}

TEST(StudyCoverageMask, TwoWallsFillATileTogether)
{
  Depth left(static_cast<std::size_t>(TileSide) * TileSide, 1.0f);
  Depth right = left;
  for (const auto& [x, y] : Pixels(TileSide, TileSide))
  {
    (x < 2 ? left : right)[static_cast<std::size_t>(y) * TileSide + x] = x < 2 ? 0.25f : 0.5f;
  }
  CoverageMask both(left.data(), TileSide, TileSide);
  both.Merge(CoverageMask(right.data(), TileSide, TileSide));
  both.Apply(left.data());
  EXPECT_EQ(*std::max_element(left.begin(), left.end()), 0.5f);
  EXPECT_EQ(*std::min_element(left.begin(), left.end()), 0.25f);
}
