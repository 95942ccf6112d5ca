// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Queries of vtkShadowLitmap against a loop over the receivers that were added.
#include "SameLitmaps.h"

#include "vtkShadowLitmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

struct Receiver
{
  glm::dvec3 A;
  glm::dvec3 B;
  double Radius;
  int X;
  int Y;
};

struct Map
{
  Map() = default;
  Map(std::vector<Receiver> receivers, int resolution)
    : Receivers(std::move(receivers))
  {
    this->Build(resolution);
  }

  vtkShadowBlock Range = { { -2.0, 10.0, 4.0 }, { 3.0, 11.0, 36.0 } };
  std::vector<Receiver> Receivers;
  vtkShadowLitmap Litmap;

  void Build(int resolution)
  {
    this->Litmap.Begin(resolution, this->Range);
    for (const Receiver& r : this->Receivers)
    {
      EXPECT_TRUE(this->Litmap.Add(r.A, r.B, r.Radius, r.X, r.Y));
    }
    this->Litmap.Build();
  }
};

/// Points, some outside of the map, and a few segments of all lengths.
std::vector<Receiver> MakeReceivers(const Map& map, int count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.1, 1.1);
  std::vector<Receiver> receivers;
  for (int n = 0; n < count; ++n)
  {
    Receiver r;
    r.Radius = n % 3 ? 0.0 : 0.02 * uniform(random) + 0.002;
    const double length = n % 4 ? 0.0 : std::ldexp(1.0, -static_cast<int>(random() % 12));
    const glm::dvec3 width = map.Range.High - map.Range.Low;
    for (int i = 0; i < 3; ++i)
    {
      r.A[i] = map.Range.Low[i] + width[i] * uniform(random);
      r.B[i] = r.A[i] + width[i] * length * (uniform(random) - 0.5);
    }
    r.X = static_cast<int>(random() % 640);
    r.Y = static_cast<int>(random() % 480);
    receivers.push_back(r);
  }
  return receivers;
}

bool ContainsExtent(const vtkShadowExtent& extent, const vtkShadowExtent& part)
{
  return extent.Near <= part.Near && extent.Far >= part.Far && extent.X0 <= part.X0 &&
    extent.Y0 <= part.Y0 && extent.X1 >= part.X1 && extent.Y1 >= part.Y1 &&
    (extent.Bins & part.Bins) == part.Bins;
}

/// All receivers with a place in the rectangle (each segment by many of its points), without bins.
vtkShadowExtent Scan(const Map& map, double p0, double q0, double p1, double q1)
{
  vtkShadowExtent result;
  for (const Receiver& r : map.Receivers)
  {
    const bool point = r.A[0] == r.B[0] && r.A[1] == r.B[1];
    bool inside = false;
    for (int i = 0; i <= (point ? 0 : 200) && !inside; ++i)
    {
      const double p = r.A[0] + (r.B[0] - r.A[0]) * i / 200.0;
      const double q = r.A[1] + (r.B[1] - r.A[1]) * i / 200.0;
      inside = p >= p0 - r.Radius && p <= p1 + r.Radius && q >= q0 - r.Radius && q <= q1 + r.Radius;
    }
    if (inside)
    {
      const auto x = static_cast<std::uint16_t>(r.X);
      const auto y = static_cast<std::uint16_t>(r.Y);
      result.Merge({ std::min(r.A[2], r.B[2]), std::max(r.A[2], r.B[2]), x, y,
        static_cast<std::uint16_t>(x + 1), static_cast<std::uint16_t>(y + 1) });
    }
  }
  return result;
}

/// What the squares that answer the query hold, from level 0.
vtkShadowExtent ScanCover(const vtkShadowLitmap& map, const vtkNBufferRectangle& lexels)
{
  const vtkNBufferCover cover = vtkNBufferMath::GetCoverOfFour(lexels);
  const int side = 1 << cover.Level;
  vtkShadowExtent result;
  for (int i = 0; i < cover.Count; ++i)
  {
    for (const auto& [x, y] :
      Pixels({ cover.X[i], cover.Y[i], std::min(cover.X[i] + side, map.GetResolution()),
        std::min(cover.Y[i] + side, map.GetResolution()) }))
    {
      result.Merge(map.GetLevelData(0)[y * map.GetResolution() + x]);
    }
  }
  return result;
}

/// Slabs hold every receiver of the rectangle, lie in the extent, in order and apart.
void CheckSlabs(const Map& map, const vtkShadowExtent& extent, double p0, double q0, double p1,
  double q1, int gap)
{
  const auto slabs = map.Litmap.GetSlabs(extent, gap);
  ASSERT_EQ(slabs.empty(), extent.IsEmpty());
  const double bin = (map.Range.High[2] - map.Range.Low[2]) / vtkShadowLitmap::NumberOfBins;
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    ASSERT_LE(slabs[i].Near, slabs[i].Far);
    ASSERT_GE(slabs[i].Near, extent.Near);
    ASSERT_LE(slabs[i].Far, extent.Far);
    ASSERT_TRUE(i == 0 || slabs[i].Near - slabs[i - 1].Far > gap * bin * (1.0 - 1e-9));
  }
  for (const Receiver& r : map.Receivers)
  {
    if (r.A[0] >= p0 && r.A[0] <= p1 && r.A[1] >= q0 && r.A[1] <= q1)
    {
      const double nearS = std::min(r.A[2], r.B[2]);
      const double farS = std::max(r.A[2], r.B[2]);
      ASSERT_TRUE(std::any_of(slabs.begin(), slabs.end(),
        [=](const auto& slab) { return slab.Near <= nearS && farS <= slab.Far; }))
        << "depths [" << nearS << ", " << farS << "], gap " << gap;
    }
  }
}

/// One query in all respects.
void CheckLitmapQuery(const Map& map, double p0, double q0, double p1, double q1, int gap)
{
  SCOPED_TRACE(testing::Message() << std::setprecision(17) << "[" << p0 << ", " << p1 << "] x ["
                                  << q0 << ", " << q1 << "], resolution "
                                  << map.Litmap.GetResolution());
  const vtkShadowExtent extent = map.Litmap.Query(p0, q0, p1, q1);
  ASSERT_TRUE(ContainsExtent(extent, Scan(map, p0, q0, p1, q1))) << "a receiver was missed";
  const vtkNBufferRectangle lexels = map.Litmap.GetLexels(p0, q0, p1, q1);
  ASSERT_TRUE(
    IsSameExtent(extent, lexels.IsEmpty() ? vtkShadowExtent() : ScanCover(map.Litmap, lexels)));
  ASSERT_NO_FATAL_FAILURE(CheckSlabs(map, extent, p0, q0, p1, q1, gap));
}

using ShadowLitmap = testing::TestWithParam<int>;
}

// Hazard: a receiver is missed and loses its shadow. Rectangles are inside, partly outside, or
// wholly outside of the map.
TEST_P(ShadowLitmap, RandomRectangles)
{
  for (int count : { 0, 1, 40 })
  {
    Map map;
    map.Receivers = MakeReceivers(map, count, 5 + count);
    map.Build(this->GetParam());
    EXPECT_EQ(map.Litmap.GetNumberOfReceivers(), count);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(-0.5, 1.5);
    for (int n = 0; n < 300; ++n)
    {
      const double size = std::ldexp(1.0, -static_cast<int>(random() % 12));
      const double p0 = -2.0 + 5.0 * uniform(random);
      const double q0 = 10.0 + uniform(random);
      const double p1 = p0 + 5.0 * size * (uniform(random) + 0.5);
      const double q1 = q0 + size * (uniform(random) + 0.5);
      ASSERT_NO_FATAL_FAILURE(
        CheckLitmapQuery(map, p0, q0, p1, q1, 1 + static_cast<int>(random() % 5)));
    }
    // Each receiver by itself, as small as it is.
    for (const Receiver& r : map.Receivers)
    {
      ASSERT_NO_FATAL_FAILURE(CheckLitmapQuery(map, r.A[0], r.A[1], r.A[0], r.A[1], 1));
    }
    ASSERT_NO_FATAL_FAILURE(CheckLitmapQuery(map, -1e300, -1e300, 1e300, 1e300, 1));
    ASSERT_NO_FATAL_FAILURE(CheckLitmapQuery(map, -Infinity, -Infinity, Infinity, Infinity, 64));
  }
}

INSTANTIATE_TEST_SUITE_P(Resolutions, ShadowLitmap, testing::Values(1, 2, 3, 7, 64, 100),
  testing::PrintToStringParamName());

// Hazard: a caster at the light's own plane has no rectangle, and a query for it misses receivers.
TEST(ShadowLitmapOnce, NaNQueriesTheWholeMap)
{
  Map map;
  map.Receivers = MakeReceivers(map, 30, 9);
  map.Build(16);
  const vtkShadowExtent all = map.Litmap.Query(-Infinity, -Infinity, Infinity, Infinity);
  EXPECT_TRUE(ContainsExtent(all, Scan(map, -Infinity, -Infinity, Infinity, Infinity)));
  const double queries[][4] = { { NaN, 10.0, 0.0, 10.1 }, { 0.0, NaN, 0.0, 10.1 },
    { 0.0, 10.0, NaN, 10.1 }, { 0.0, 10.0, 0.1, NaN }, { 0.1, 10.0, 0.0, 10.1 } };
  for (const auto& [p0, q0, p1, q1] : queries)
  {
    EXPECT_TRUE(IsSameExtent(map.Litmap.Query(p0, q0, p1, q1), all))
      << "of no number, or the wrong way round: " << p0 << " " << q0 << " " << p1 << " " << q1;
  }
}

// Rectangles without a receiver near them are empty, so that casters there are culled.
TEST(ShadowLitmapOnce, NothingIsFoundWhereNothingIs)
{
  const Map map({ { { 0.0, 10.5, 8.0 }, { 0.0, 10.5, 8.0 }, 0.0, 3, 4 } }, 100);
  EXPECT_FALSE(map.Litmap.Query(0.0, 10.5, 0.0, 10.5).IsEmpty());
  EXPECT_TRUE(map.Litmap.Query(-1.0, 10.5, -0.5, 10.5).IsEmpty());
  EXPECT_TRUE(map.Litmap.Query(0.0, 10.6, 0.0, 10.7).IsEmpty());
  EXPECT_TRUE(map.Litmap.Query(4.0, 10.5, 5.0, 10.5).IsEmpty()) << "beside the map";
  EXPECT_TRUE(map.Litmap.Query(0.0, -Infinity, 0.0, 9.0).IsEmpty()) << "beside the map";
}

// A query is widened by one lexel on all sides, and cut to the map.
TEST(ShadowLitmapOnce, QueriesAreWidenedByALexel)
{
  vtkShadowLitmap litmap;
  litmap.Begin(8, { { 0.0, -8.0, 0.0 }, { 8.0, 8.0, 1.0 } });
  EXPECT_EQ(litmap.GetLexels(2.5, -2.5, 2.6, 1.5), (vtkNBufferRectangle{ 1, 1, 4, 6 }));
  EXPECT_EQ(litmap.GetLexels(-0.5, 7.0, 0.5, 9.5), (vtkNBufferRectangle{ 0, 6, 2, 8 }));
}

// A long segment is added to the lexels that it passes, and not to all lexels of its box.
TEST(ShadowLitmapOnce, SegmentsAreThin)
{
  const Map map({ { { -2.0, 10.0, 8.0 }, { 3.0, 11.0, 9.0 }, 1e-6, 3, 4 } }, 64);
  const vtkShadowExtent* lexels = map.Litmap.GetLevelData(0);
  const auto filled = std::count_if(
    lexels, lexels + 64 * 64, [](const vtkShadowExtent& extent) { return !extent.IsEmpty(); });
  EXPECT_GE(filled, 64);
  EXPECT_LE(filled, 3 * 64);
}

// Hazard: receivers whose coordinates are not finite are added anywhere.
TEST(ShadowLitmapOnce, RefusesWhatIsNotFinite)
{
  Map map;
  map.Litmap.Begin(8, map.Range);
  const glm::dvec3 good = { 0.0, 10.5, 8.0 };
  for (double value : { NaN, Infinity, -Infinity })
  {
    for (int i = 0; i < 3; ++i)
    {
      glm::dvec3 bad = good;
      bad[i] = value;
      EXPECT_FALSE(map.Litmap.Add(bad, good, 0.0, 0, 0));
      EXPECT_FALSE(map.Litmap.Add(good, bad, 0.0, 0, 0));
    }
  }
  EXPECT_EQ(map.Litmap.GetNumberOfReceivers(), 0);
  map.Litmap.Build();
  EXPECT_TRUE(map.Litmap.Query(NaN, NaN, NaN, NaN).IsEmpty());
}

// A receiver whose place is unknown is found everywhere.
TEST(ShadowLitmapOnce, AnInfiniteRadiusIsEverywhere)
{
  const Map map({ { { 0.0, 0.0, 8.0 }, { 0.0, 0.0, 9.0 }, Infinity, 3, 4 } }, 64);
  for (double p : { -100.0, -2.0, 0.5, 3.0, 1e9 })
  {
    for (double q : { -100.0, 10.0, 10.5, 11.0, 1e9 })
    {
      EXPECT_EQ(map.Litmap.Query(p, q, p, q).X0, 3);
    }
  }
}

// Hazard: all receivers have the same p (a wall along the light), or are in one place.
TEST(ShadowLitmapOnce, RangesWithoutAWidth)
{
  Map map;
  map.Range.High[0] = map.Range.Low[0];
  map.Range.High[2] = map.Range.Low[2];
  map.Receivers = { { { -2.0, 10.5, 4.0 }, { -2.0, 10.5, 4.0 }, 0.0, 1, 2 },
    { { -2.0, 10.9, 4.0 }, { -2.0, 10.9, 4.0 }, 0.0, 3, 4 } };
  map.Build(32);
  const vtkShadowExtent extent = map.Litmap.Query(-2.0, 10.5, -2.0, 10.5);
  EXPECT_EQ(extent.X0, 1);
  EXPECT_EQ(extent.X1, 2);
  const auto slabs = map.Litmap.GetSlabs(extent, 4);
  ASSERT_EQ(slabs.size(), 1u);
  EXPECT_EQ(slabs[0].Near, 4.0);
  EXPECT_EQ(slabs[0].Far, 4.0);
}

// Hazard: memory is kept, and receivers of an older, larger map are found.
TEST(ShadowLitmapOnce, BeginForgets)
{
  Map map;
  map.Receivers = MakeReceivers(map, 200, 3);
  map.Build(100);
  map.Receivers = MakeReceivers(map, 3, 4);
  map.Build(33);
  EXPECT_EQ(map.Litmap.GetNumberOfReceivers(), 3);
  EXPECT_EQ(map.Litmap.GetLevelData(map.Litmap.GetNumberOfLevels()), nullptr);
  ASSERT_NO_FATAL_FAILURE(CheckLitmapQuery(map, -2.0, 10.0, 3.0, 11.0, 1));
  ASSERT_NO_FATAL_FAILURE(CheckLitmapQuery(map, -1.0, 10.2, 1.0, 10.7, 1));
  map.Litmap.Begin(33, map.Range);
  EXPECT_TRUE(map.Litmap.Query(-2.0, 10.0, 3.0, 11.0).IsEmpty()) << "not built";
}

// Empty bins separate slabs exactly if there are as many as SlabGap says.
TEST(ShadowLitmapOnce, SlabsRespectTheGap)
{
  Map map; // 64 bins of half a unit.
  for (double s : { 4.1, 4.6, 7.1, 20.1, 35.9 })
  {
    map.Receivers.push_back({ { 0.0, 10.5, s }, { 0.0, 10.5, s }, 0.0, 3, 4 });
  }
  map.Build(4);
  const vtkShadowExtent extent = map.Litmap.Query(0.0, 10.5, 0.0, 10.5);
  // Bins 0 and 1, 6, 32, 63: 4, 25 and 30 empty ones between.
  const std::pair<int, std::size_t> gaps[] = { { 1, 4 }, { 4, 4 }, { 5, 3 }, { 26, 2 }, { 31, 1 } };
  for (const auto& [gap, count] : gaps)
  {
    EXPECT_EQ(map.Litmap.GetSlabs(extent, gap).size(), count) << gap;
  }
  EXPECT_EQ(map.Litmap.GetSlabs(vtkShadowExtent(), 4).size(), 0u);
  const auto slabs = map.Litmap.GetSlabs(extent, 4);
  EXPECT_EQ(slabs.front().Near, 4.1);
  EXPECT_NEAR(slabs.front().Far, 5.0, 1e-9);
  EXPECT_NEAR(slabs[1].Near, 7.0, 1e-9);
  EXPECT_NEAR(slabs[1].Far, 7.5, 1e-9);
  EXPECT_EQ(slabs.back().Far, 35.9);
}

// Hazard: a depth on the edge of a bin is rounded down in one place of the code and up in another.
TEST(ShadowLitmapOnce, SlabsHoldDepthsOnTheEdgesOfBins)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int n = 0; n < 100; ++n)
  {
    Map map;
    map.Range.Low[2] = (n % 3 - 1) * std::pow(10.0, n % 8) + uniform(random);
    map.Range.High[2] = map.Range.Low[2] + 10.0 * uniform(random);
    for (int bin = 0; bin <= 64; ++bin)
    {
      const double edge = map.Range.Low[2] + (map.Range.High[2] - map.Range.Low[2]) * bin / 64.0;
      for (double s : { std::nextafter(edge, -1e9), edge, std::nextafter(edge, 1e9) })
      {
        map.Receivers = { { { 0.0, 10.5, s }, { 0.0, 10.5, s }, 0.0, 3, 4 } };
        map.Build(1);
        const auto slabs = map.Litmap.GetSlabs(map.Litmap.Query(0.0, 10.5, 0.0, 10.5), 1);
        ASSERT_EQ(slabs.size(), 1u);
        ASSERT_EQ(slabs[0].Near, s) << "case " << n << ", bin " << bin;
        ASSERT_EQ(slabs[0].Far, s) << "case " << n << ", bin " << bin;
      }
    }
  }
}

// A litmap that is filled in parts, in any order, has the same lexels, tiles and widest angle, to
// the bit. Parts that were used before are empty at first.
TEST(ShadowLitmap, PartsJoin)
{
  Map whole;
  whole.Receivers = MakeReceivers(whole, 500, 7);
  whole.Receivers.push_back({ { 0, 0, 5.0 }, { 0, 0, 6.0 }, Infinity, 3, 4 });
  constexpr int width = 65535;
  constexpr int height = 9;
  const glm::dvec3 radius = { 0.1, 0.2, 0.3 };
  for (const int count : { 1, 3, 2 })
  {
    SCOPED_TRACE("parts: " + std::to_string(count));
    vtkShadowLitmap litmaps[2];
    for (int filled = 0; filled < 2; ++filled)
    {
      vtkShadowLitmap& litmap = litmaps[filled];
      litmap.Begin(37, whole.Range);
      litmap.GetTiles().Begin(width, height);
      litmap.GetTiles().SetSplit(whole.Receivers[1].X / vtkShadowTiles::Size,
        whole.Receivers[1].Y % height / vtkShadowTiles::Size, 0.5f);
      const int parts = filled == 0 ? 1 : count;
      litmap.Split(parts);
      std::vector<vtkShadowLitmap*> begun;
      for (int part = 0; part < parts; ++part)
      {
        begun.push_back(&litmap.BeginPart(part));
        EXPECT_EQ(begun.back() == &litmap, part == 0);
      }
      for (std::size_t i = 0; i < whole.Receivers.size(); ++i)
      {
        const Receiver& r = whole.Receivers[i];
        vtkShadowLitmap& part = *begun[i % begun.size()];
        ASSERT_TRUE(part.Add(r.A, r.B, r.Radius, r.X, r.Y));
        litmap.GetTiles().Add(r.A, r.B, radius, r.X, r.Y % height, i % 2 ? 0.75f : 0.25f);
        part.WidenAngle(0.001 * static_cast<double>(i));
      }
      litmap.Join();
      litmap.Build();
    }
    ExpectSameLitmaps(litmaps[0], litmaps[1]);
  }
}

// A litmap that is filled lexel by lexel equals one that is filled with receivers in these lexels.
TEST(ShadowLitmap, LexelsAreAddedAsReceivers)
{
  const vtkShadowBlock range = { { 0.0, 0.0, 0.0 }, { 4.0, 4.0, 64.0 } };
  vtkShadowLitmap added;
  added.Begin(4, range);
  const glm::dvec3 a = { 2.5, 1.5, 3.5 };
  const glm::dvec3 b = { 2.5, 1.5, 9.5 };
  ASSERT_TRUE(added.Add(a, b, 0.0, 7, 8));
  ASSERT_TRUE(added.Add(a, b, 0.0, 9, 12));
  added.Build();

  vtkShadowLitmap filled;
  filled.Begin(4, range);
  EXPECT_FALSE(filled.AddLexel(2, 1, vtkShadowExtent())) << "empty";
  const vtkShadowExtent extent = { 3.5, 9.5, 7, 8, 10, 13 };
  ASSERT_TRUE(filled.AddLexel(2, 1, extent));
  for (const int outside : { -1, 4 })
  {
    EXPECT_FALSE(filled.AddLexel(outside, 1, extent));
    EXPECT_FALSE(filled.AddLexel(2, outside, extent));
  }
  for (const double bad : { 3.0, NaN, Infinity })
  {
    vtkShadowExtent refused = extent;
    refused.Far = bad;
    EXPECT_FALSE(filled.AddLexel(2, 1, refused)) << bad;
  }
  EXPECT_EQ(filled.GetNumberOfReceivers(), 1);
  filled.Build();
  for (int i = 0; i < 16; ++i)
  {
    EXPECT_TRUE(IsSameExtent(added.GetLevelData(0)[i], filled.GetLevelData(0)[i])) << i;
  }
}
