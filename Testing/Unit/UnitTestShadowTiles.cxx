// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Which tiles of the screen a caster can shadow, and the boxes around them.
#include "Pixels.h"
#include "ShadowCaster.h"

#include "vtkShadowPlan.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTiles.h"
#include "vtkShadowUmbra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{
constexpr int TileSize = vtkShadowTiles::Size;

using TilePlace = std::pair<int, int>;

vtkShadowTileSet MakeSet(const vtkNBufferRectangle& pixels, const std::set<TilePlace>& tiles)
{
  vtkShadowTileSet set(pixels);
  set.Mark([&](int column, int row) { return tiles.count({ column, row }) > 0; });
  return set;
}

int GetAreaOfBoxes(const std::vector<vtkNBufferRectangle>& boxes)
{
  int area = 0;
  for (const vtkNBufferRectangle& box : boxes)
  {
    area += box.GetWidth() * box.GetHeight();
  }
  return area;
}

vtkShadowBlock MakeBlock(const vtkShadowLightSpace& frame, const Point& x, double radius)
{
  const Point pqs = frame.ToLight(x);
  return { pqs - radius, pqs + radius };
}

/// A caster before a light, and what its shadow can reach.
struct TileCaster : ShadowCaster
{
  TileCaster(const ShadowMesh& mesh, const vtkShadowLight& light, const vtkShadowLightSpace& frame,
    vtkShadowCounting counting)
    : ShadowCaster(mesh, light, counting)
  {
    const auto footprint = vtkShadowFootprint::Make(this->Silhouette, this->GetPoints(), frame);
    if (frame.IsPositional() && !(footprint.Block.Low[2] > 0.0))
    {
      this->Rays = { Point(-HUGE_VAL), Point(HUGE_VAL) };
    }
    else
    {
      this->Rays = footprint.Block;
    }
    this->Rays.High[2] = HUGE_VAL;
  }

  vtkShadowUmbra GetUmbra(const vtkShadowLightSpace& frame) const
  {
    return { this->Silhouette, this->GetPoints(), frame, this->Rays };
  }

  vtkShadowBlock Rays;
};
}

TEST(ShadowTileSet, BoxesAreApartAndHoldAllMarks)
{
  std::mt19937 random(5);
  for (int n = 0; n < 200; ++n)
  {
    const auto pick = [&](int low, int high)
    { return low + static_cast<int>(random() % static_cast<unsigned int>(high - low + 1)); };
    vtkNBufferRectangle pixels;
    pixels.X0 = pick(0, 40);
    pixels.Y0 = pick(0, 40);
    pixels.X1 = pixels.X0 + pick(1, 90);
    pixels.Y1 = pixels.Y0 + pick(1, 90);
    std::set<TilePlace> marks;
    for (int i = pick(0, 30); i > 0; --i)
    {
      marks.insert({ pick(0, 17), pick(0, 17) });
    }
    const vtkShadowTileSet set = MakeSet(pixels, marks);
    for (const double cost : { 0.0, 100.0, 1e9 })
    {
      SCOPED_TRACE("case " + std::to_string(n) + ", cost " + std::to_string(cost));
      const std::vector<vtkNBufferRectangle> boxes = set.GetBoxes(cost);
      EXPECT_LE(boxes.size(), marks.size());
      EXPECT_LE(boxes.size(), cost < 1e9 ? 18u * 18u : 1u);
      int marked = 0;
      for (const auto& [x, y] : Pixels(pixels))
      {
        const vtkNBufferRectangle pixel = { x, y, x + 1, y + 1 };
        const auto count = std::count_if(boxes.begin(), boxes.end(),
          [&pixel](const vtkNBufferRectangle& box) { return IsIn(pixel, box); });
        const bool isMarked = marks.count({ x / TileSize, y / TileSize }) > 0;
        marked += isMarked;
        ASSERT_LE(count, 1);
        ASSERT_TRUE(count == 1 || !isMarked);
      }
      EXPECT_GE(GetAreaOfBoxes(boxes), marked) << "nothing outside of the rectangle";
    }
  }
}

// A box is cut where the cut leaves out more than it costs.
TEST(ShadowTileSet, CutsAreWorthTheirCost)
{
  const vtkNBufferRectangle pixels = { 0, 0, 10 * TileSize, 10 * TileSize };
  const vtkShadowTileSet corners = MakeSet(pixels, { { 0, 0 }, { 9, 9 } });
  const int saved = 98 * TileSize * TileSize;
  EXPECT_EQ(corners.GetBoxes(saved).size(), 1u);
  EXPECT_EQ(GetAreaOfBoxes(corners.GetBoxes(saved)), 100 * TileSize * TileSize);
  EXPECT_EQ(corners.GetBoxes(saved - 1).size(), 2u);
  EXPECT_EQ(GetAreaOfBoxes(corners.GetBoxes(saved - 1)), 2 * TileSize * TileSize);
  // A frame of tiles around nothing has no cut that leaves out anything at once but corners.
  const vtkShadowTileSet bar = MakeSet(pixels, { { 2, 5 }, { 3, 5 }, { 4, 5 } });
  EXPECT_EQ(bar.GetBoxes(0.0).size(), 1u);
  EXPECT_EQ(GetAreaOfBoxes(bar.GetBoxes(0.0)), 3 * TileSize * TileSize);
}

TEST(ShadowTiles, HoldTheirReceivers)
{
  vtkShadowTiles tiles;
  EXPECT_FALSE(tiles.IsKnown());
  tiles.Begin(2 * TileSize + 1, TileSize);
  EXPECT_TRUE(tiles.IsKnown());
  EXPECT_EQ(tiles.GetNumberOfColumns(), 3);
  EXPECT_EQ(tiles.GetNumberOfRows(), 1);
  tiles.SetSplit(2, 0, 0.5f);
  const Point a = { 1.0, 5.0, 3.0 };
  const Point b = { 2.0, 4.0, 3.5 };
  const Point radius = { 0.25, 0.5, 0.125 };
  const auto isBlock = [](const vtkShadowBlock& block)
  { return block.Low == Point(0.75, 3.5, 2.875) && block.High == Point(2.25, 5.5, 3.625); };
  tiles.Add(a, b, radius, 2 * TileSize, TileSize - 1, 0.5f); // from the split on
  EXPECT_TRUE(tiles.Get(2, 0)[0].IsEmpty());
  EXPECT_TRUE(isBlock(tiles.Get(2, 0)[1]));
  tiles.Add(a, b, radius, 2 * TileSize, 0, 0.25f);
  EXPECT_TRUE(isBlock(tiles.Get(2, 0)[0]));
  tiles.Add(a, b, radius, TileSize, 0, 0.99f); // no split there
  EXPECT_TRUE(isBlock(tiles.Get(1, 0)[0]));
  EXPECT_TRUE(tiles.Get(1, 0)[1].IsEmpty());
  EXPECT_TRUE(tiles.Get(0, 0)[0].IsEmpty());
  tiles.Begin(0, 0);
  EXPECT_FALSE(tiles.IsKnown());
}

// A tile has one layer where a surface is at a single depth or no receiver is seen.
TEST(ShadowTiles, OneDepthIsOneLayer)
{
  vtkShadowView view;
  view.Width = 5;
  view.Height = 3;
  std::vector<float> depth(5 * 3, 0.5f);
  std::fill_n(depth.begin(), 3, 1.0f);
  const vtkShadowLight light;
  vtkShadowLitmap litmap;
  vtkShadowReceivers::Scatter(depth.data(), view, light, vtkShadowLightSpace(light), 4, litmap);
  EXPECT_FALSE(litmap.GetTiles().Get(0, 0)[0].IsEmpty());
  EXPECT_TRUE(litmap.GetTiles().Get(0, 0)[1].IsEmpty());
  depth[7] = 0.75f;
  vtkShadowReceivers::Scatter(depth.data(), view, light, vtkShadowLightSpace(light), 4, litmap);
  EXPECT_FALSE(litmap.GetTiles().Get(0, 0)[1].IsEmpty());
  // What another frame has found is not kept.
  depth[7] = 1.0f;
  vtkShadowReceivers::Scatter(depth.data(), view, light, vtkShadowLightSpace(light), 4, litmap);
  EXPECT_FALSE(litmap.GetTiles().Get(0, 0)[0].IsEmpty());
  EXPECT_TRUE(litmap.GetTiles().Get(0, 0)[1].IsEmpty()) << "nothing is seen there";
}

// Whatever a volume counts is in the umbra of its caster, for all meshes, lights and ways of
// counting.
TEST(ShadowUmbra, HoldsAllThatIsInShadow)
{
  std::mt19937 random(17);
  int inShadow = 0;
  int left[2] = { 0, 0 }; // tested triangle by triangle, or all at once
  int beside[2] = { 0, 0 };
  for (const ShadowMesh& mesh : MakeShadowMeshes(4))
  {
    for (int n = 0; n < 12; ++n)
    {
      vtkShadowLight light;
      light.Kind = n % 2 ? vtkShadowLightKind::Spot : vtkShadowLightKind::Directional;
      for (int i = 0; i < 3; ++i)
      {
        light.Direction[i] += MakeUniform(random, -0.8, 0.8);
        light.Position[i] = (i == 2 ? 3.0 : 0.0) + MakeUniform(random, -1.0, 1.0);
      }
      light.Direction = vtkNBufferGLM::Normalize(light.Direction);
      const vtkShadowLightSpace frame(light);
      const TileCaster caster(
        mesh, light, frame, n % 3 ? vtkShadowCounting::Away : vtkShadowCounting::All);
      if (caster.Silhouette.GetTriangles().empty())
      {
        continue;
      }
      const vtkShadowUmbra umbra = caster.GetUmbra(frame);
      vtkShadowVolume volume;
      caster.AddWhole(volume);
      for (int i = 0; i < 40; ++i)
      {
        const Point x = MakePoint(random, 2.0);
        const vtkShadowBlock block = MakeBlock(frame, x, 1e-7);
        if (frame.IsPositional() && block.Low[2] <= 0.0)
        {
          continue; // has no p and q
        }
        if (CountInVolume(volume, x, random) != 0)
        {
          ++inShadow;
          EXPECT_TRUE(umbra.MayShadow(block)) << mesh.Name << ", case " << n;
          EXPECT_TRUE(umbra.MeetsRays(block)) << mesh.Name << ", case " << n;
        }
        else
        {
          const bool atOnce =
            caster.Silhouette.GetTriangles().size() > 3 * vtkShadowUmbra::MaximumFacets ||
            std::isinf(caster.Rays.Low[0]);
          left[atOnce] += umbra.MayShadow(block);
          ++beside[atOnce];
        }
      }
    }
  }
  EXPECT_GT(inShadow, 500);
  EXPECT_GT(beside[0], 500);
  EXPECT_EQ(left[0], 0) << "of " << beside[0] << " points";
  EXPECT_GT(left[1], 0) << "nothing but what is in shadow would be a surprise, of " << beside[1];
}

// Hazard: the equations of planes and sides are rounded, so that a point in a triangle, on its
// sides or behind them is said to be outside of the umbra. The blocks are points, since an extent
// would hide the error.
TEST(ShadowUmbra, RoundingLeavesNothingOutOfReach)
{
  std::mt19937 random(29);
  for (int n = 0; n < 500; ++n)
  {
    const bool positional = n % 2;
    const vtkShadowLight light =
      MakeLight(positional ? vtkShadowLightKind::Spot : vtkShadowLightKind::Directional,
        Point(0.0, 0.0, 9.0) + MakePoint(random, 2.0));
    const vtkShadowLightSpace frame(light);
    ShadowMesh mesh;
    mesh.Points = { MakePoint(random, 2.0), MakePoint(random, 2.0), MakePoint(random, 2.0) };
    mesh.Triangles = { 0, 1, 2 };
    const TileCaster caster(mesh, light, frame, vtkShadowCounting::All);
    const vtkShadowUmbra umbra = caster.GetUmbra(frame);
    const std::vector<Point>& corners = caster.GetPoints();
    for (int i = 0; i < 20; ++i)
    {
      const double share = MakeUniform(random, 0.0, 1.0);
      const double third = i % 2 ? MakeUniform(random, 0.0, 1.0 - share) : 0.0;
      const Point x = share * corners[0] + third * corners[1] + (1.0 - share - third) * corners[2];
      const Point ray = positional ? x - light.Position : light.Direction;
      for (const double beyond : { 0.0, 0.5 })
      {
        // What is computed of it is rounded otherwise than the caster is.
        const vtkShadowBlock block = MakeBlock(frame, x + beyond * ray, 0.0);
        EXPECT_TRUE(umbra.MeetsRays(block)) << n;
        EXPECT_TRUE(umbra.MayShadow(block)) << n;
      }
    }
  }
}

// All triangles of a flat mesh are in one plane, however many there are: what is above it is not in
// the umbra.
TEST(ShadowUmbra, SheetsOfManyTrianglesHaveOnePlane)
{
  std::mt19937 random(3);
  const vtkShadowLight light; // Straight down: s = -z.
  const vtkShadowLightSpace frame(light);
  ShadowMesh sheet;
  ShadowMesh bumps;
  for (int i = 0; i < 200; ++i)
  {
    const ShadowMesh quad =
      MakeOpenRectangle().Translate(2.0 * (i % 20) - 20.0, 2.0 * (i / 20) - 10.0, 0.0);
    sheet.Append(quad);
    bumps.Append(
      quad.Move([&](const Point& x) { return Point(x[0], x[1], MakeUniform(random, -0.1, 0.1)); }));
  }
  const TileCaster flat(sheet, light, frame, vtkShadowCounting::All);
  const TileCaster rough(bumps, light, frame, vtkShadowCounting::All);
  ASSERT_GT(flat.Silhouette.GetTriangles().size(), 3 * vtkShadowUmbra::MaximumFacets);
  EXPECT_FALSE(flat.GetUmbra(frame).MayShadow(MakeBlock(frame, { 0.1, 0.2, 0.5 }, 0.1)));
  EXPECT_TRUE(flat.GetUmbra(frame).MayShadow(MakeBlock(frame, { 0.1, 0.2, -0.5 }, 0.1)));
  EXPECT_TRUE(rough.GetUmbra(frame).MayShadow(MakeBlock(frame, { 0.1, 0.2, -0.5 }, 0.1)));
  // Slanted light: the sheet's nearest corner is far above most of it.
  const vtkShadowLight slanted = MakeLight(vtkShadowLightKind::Directional, { -0.8, 0.0, 0.6 });
  const vtkShadowLightSpace slant(slanted);
  const TileCaster both[2] = { { sheet, slanted, slant, vtkShadowCounting::All },
    { bumps, slanted, slant, vtkShadowCounting::All } };
  const vtkShadowBlock over = MakeBlock(slant, { 5.0, 0.0, 1.0 }, 0.1);
  EXPECT_FALSE(both[0].GetUmbra(slant).MayShadow(over));
  EXPECT_TRUE(both[1].GetUmbra(slant).MayShadow(over)) << "too many planes to be looked at";
}

// The umbra of a slab of ground does not contain what stands on it, although that is on the rays of
// the slab and farther from the light than the slab's nearest corner.
TEST(ShadowUmbra, GroundDoesNotReachWhatStandsOnIt)
{
  for (const bool positional : { false, true })
  {
    const vtkShadowLight light =
      MakeLight(positional ? vtkShadowLightKind::Spot : vtkShadowLightKind::Directional,
        { -20.0, 0.0, 20.0 }, { -12.0, 0.0, 14.0 });
    const vtkShadowLightSpace frame(light);
    const ShadowMesh ground =
      MakeCube().Move([](const Point& x) { return Point(20.0 * x[0], 20.0 * x[1], x[2] - 0.5); });
    const TileCaster caster(ground, light, frame, vtkShadowCounting::Away);
    const vtkShadowUmbra umbra = caster.GetUmbra(frame);
    const double top = std::max_element(ground.Points.begin(), ground.Points.end(),
      [](const Point& a, const Point& b) {
        return a[2] < b[2];
      })->z;
    for (const double height : { 0.0, 0.5, 2.0 })
    {
      EXPECT_TRUE(umbra.MeetsRays(MakeBlock(frame, { 0.0, 0.0, top + height }, 0.01)));
      EXPECT_FALSE(umbra.MayShadow(MakeBlock(frame, { 0.0, 0.0, top + height }, 0.01)));
    }
    EXPECT_TRUE(umbra.MayShadow(MakeBlock(frame, { 0.0, 0.0, top - 3.0 }, 0.01)));
    // Where it may be, in the light of what is not known.
    vtkShadowBlock anywhere = MakeBlock(frame, { 0.0, 0.0, top }, 0.01);
    anywhere.Low[0] = anywhere.Low[1] = -HUGE_VAL;
    anywhere.High[0] = anywhere.High[1] = HUGE_VAL;
    EXPECT_TRUE(umbra.MayShadow(anywhere));
    EXPECT_FALSE(umbra.MayShadow(vtkShadowBlock()));
  }
}
