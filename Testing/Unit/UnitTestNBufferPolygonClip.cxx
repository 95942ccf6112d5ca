// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Cutting polygons by a half space. Their corners are vectors or indices of points.
#include "vtkNBufferGLM.h"
#include "vtkNBufferPolygonClip.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace
{
using Polygon = std::vector<glm::dvec2>;

const Polygon Square = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };

double GetArea(const Polygon& polygon)
{
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return area;
}

/// What lies on the positive side of the line.
Polygon Clip(const Polygon& polygon, const glm::dvec3& line)
{
  Polygon result = { { 9.0, 9.0 } }; // What is in it already does not matter.
  vtkNBufferPolygonClip::Clip(
    polygon, [&line](const glm::dvec2& x) { return glm::dot(line, glm::dvec3(x, 1.0)); }, result);
  return result;
}
}

TEST(NBufferPolygonClip, CornersOfKnownCuts)
{
  EXPECT_EQ(Clip(Square, { 1.0, 0.0, 1.0 }), Square) << "all inside";
  EXPECT_TRUE(Clip(Square, { 1.0, 0.0, -2.0 }).empty()) << "all outside";
  EXPECT_EQ(Clip(Square, { 1.0, 0.0, 0.0 }), Square) << "a side on the line is inside";
  const Polygon right = { { 0.25, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.25, 1.0 } };
  EXPECT_EQ(Clip(Square, { 1.0, 0.0, -0.25 }), right);
  const Polygon cornerOff = { { 0.5, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 },
    { 0.0, 0.5 } };
  EXPECT_EQ(Clip(Square, { 1.0, 1.0, -0.5 }), cornerOff);
  EXPECT_TRUE(Clip({}, { 1.0, 0.0, 0.0 }).empty());
}

// Hazard: a part of a polygon is in both halves, or in neither.
TEST(NBufferPolygonClip, BothSidesAreTheWhole)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 1000; ++n)
  {
    const glm::dvec2 normal(uniform(random), uniform(random));
    const glm::dvec3 line(normal, -glm::dot(normal, glm::dvec2(0.5)) + 0.5 * uniform(random));
    EXPECT_NEAR(GetArea(Clip(Square, line)) + GetArea(Clip(Square, -line)), 1.0, 1e-14) << n;
  }
}

// Corners may be indices of points: the caller makes the new points, once for each edge that is
// cut.
TEST(NBufferPolygonClip, NumbersOfPoints)
{
  const std::vector<double> distances = { 1.0, -1.0, -3.0, 1.0 };
  std::vector<std::pair<int, int>> cuts;
  std::vector<double> places;
  std::vector<int> result;
  vtkNBufferPolygonClip::Clip(
    std::vector<int>{ 0, 1, 2, 3 },
    [&distances](int i) { return distances[static_cast<std::size_t>(i)]; },
    [&](int from, int to, double t)
    {
      cuts.emplace_back(from, to);
      places.push_back(t);
      return 3 + static_cast<int>(cuts.size());
    },
    result);
  EXPECT_EQ(result, (std::vector<int>{ 0, 4, 5, 3 }));
  EXPECT_EQ(cuts, (std::vector<std::pair<int, int>>{ { 0, 1 }, { 2, 3 } }));
  EXPECT_EQ(places, (std::vector<double>{ 0.5, 0.75 }));
}
