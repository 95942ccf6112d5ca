// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Which triangles of hidden meshes may be drawn nearer than their box.
#include "ProjectedBox.h"
#include "vtkNBufferSliverTest.h"
#include "vtkNBufferSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace
{
constexpr int SliversWidth = 101;
constexpr int SliversHeight = 67;

class Slivers : public testing::Test
{
protected:
  Slivers() { this->SetWall(0.0f); }

  void SetWall(float depth)
  {
    this->Depth.assign(static_cast<std::size_t>(SliversWidth) * SliversHeight, depth);
    this->Levels.BuildBase(
      this->Depth.data(), SliversWidth, SliversHeight, 4, vtkNBufferExtremum::Maximum);
  }

  using Triangle = std::array<glm::dvec3, 3>;
  bool MayBeSeen(const Triangle& triangle, const vtkNBufferSamples& samples = {},
    const float* depth = nullptr) const
  {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 low = glm::min(glm::min(a, b), c);
    const glm::dvec3 high = glm::max(glm::max(a, b), c);
    const ProjectedBox box(this->Projection, { low.x, high.x, low.y, high.y, low.z, high.z });
    EXPECT_TRUE(box.IsInside());
    vtkNBufferMesh mesh;
    mesh.Points.assign(triangle.begin(), triangle.end());
    mesh.Triangles = { { 0, 1, 2 } };
    vtkNBufferSliverTest test(this->Projection, this->Levels, depth, samples);
    const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    return test.MayBeSeen(mesh, 0, 1, identity, box.Box, box.Screen);
  }

  vtkNBufferProjection Projection = MapWorldToPixels(SliversWidth, SliversHeight);
  vtkNBufferLevels Levels;
  std::vector<float> Depth;
};

/// From the left to the right, `height` over the line y, with the depths given.
std::array<glm::dvec3, 3> MakeLow(
  double y, double height, double z0 = 0.8, double z1 = 0.9, double z2 = 0.85)
{
  return { { { 10.2, y, z0 }, { 60.7, y, z1 }, { 35.0, y + height, z2 } } };
}
}

// A triangle whose errors the slack of its box covers is not a sliver, and is not tested.
TEST_F(Slivers, BoxCoversWhatIsNotLow)
{
  this->SetWall(1.0f);
  EXPECT_FALSE(this->MayBeSeen(MakeLow(20.5, 1.0)));
  EXPECT_FALSE(this->MayBeSeen(MakeLow(20.5, 0.08)));
}

// A triangle whose height is below 64 u of its length may have any depth: only a wall nearer than
// every depth hides it.
TEST_F(Slivers, WithoutAPlaneAnyDepth)
{
  this->SetWall(1e-6f);
  for (const double height : { 0.0, 1e-9, 1e-7, 1e-5 })
  {
    EXPECT_TRUE(this->MayBeSeen(MakeLow(20.5, height))) << height;
  }
}

// The vertices of a triangle may have larger errors than its height, so that its plane is unknown.
TEST_F(Slivers, LowerThanTheErrorsOfItsVertices)
{
  this->SetWall(0.5f);
  const auto make = [](double height) -> Triangle {
    return { { { 10.2, 20.5, 0.8 }, { 15.2, 20.5, 0.8 }, { 12.7, 20.5 + height, 0.80001 } } };
  };
  EXPECT_TRUE(this->MayBeSeen(make(5e-5)));
  EXPECT_FALSE(this->MayBeSeen(make(5e-3)));
}

// Two corners that coincide do so on every device, which therefore draws nothing.
TEST_F(Slivers, DegenerateOnesAreNotDrawn)
{
  this->SetWall(1.0f);
  EXPECT_FALSE(this->MayBeSeen({ { { 10, 20.5, 0.8 }, { 60, 20.5, 0.9 }, { 60, 20.5, 0.9 } } }));
  EXPECT_FALSE(
    this->MayBeSeen({ { { 10.5, 20.5, 0.8 }, { 10.5, 20.5, 0.8 }, { 10.5, 20.5, 0.8 } } }));
  EXPECT_TRUE(this->MayBeSeen({ { { 10, 20.5, 0.8 }, { 60, 20.5, 0.9 }, { 59, 20.5, 0.9 } } }));
}

// A triangle is not drawn if it owns no sample: no sample is within 2^-8.5 pixels of it.
TEST_F(Slivers, BesideAllSamples)
{
  this->SetWall(1.0f);
  for (const double y : { 20.51, 20.6, 21.0, 21.4, 21.49 })
  {
    EXPECT_FALSE(this->MayBeSeen(MakeLow(y, 1e-7))) << y;
  }
  EXPECT_TRUE(this->MayBeSeen(MakeLow(20.5019, 1e-7)));
  EXPECT_TRUE(this->MayBeSeen(MakeLow(20.4981, 1e-7)));
  // Samples may be anywhere in a pixel.
  EXPECT_TRUE(this->MayBeSeen(MakeLow(21.0, 1e-7), vtkNBufferSamples::Anywhere()));
  // Beyond its ends, and of another orientation.
  EXPECT_FALSE(
    this->MayBeSeen({ { { 10.51, 20.5, 0.8 }, { 11.49, 20.5, 0.9 }, { 11, 20.5, 0.8 } } }));
  EXPECT_TRUE(this->MayBeSeen({ { { 30.5, 10, 0.8 }, { 30.5, 40, 0.9 }, { 30.5, 20, 0.8 } } }));
  EXPECT_FALSE(this->MayBeSeen({ { { 30.6, 10, 0.8 }, { 30.6, 40, 0.9 }, { 30.6, 20, 0.8 } } }));
}

// With multisampling a triangle may own any of the samples of a pixel, but nothing between them.
TEST_F(Slivers, BesideAllOfFourSamples)
{
  this->SetWall(1.0f);
  vtkNBufferSamples samples;
  samples.Places = { { 0.375, 0.125 }, { 0.875, 0.375 }, { 0.125, 0.625 }, { 0.625, 0.875 } };
  EXPECT_EQ(samples.GetDistanceFromMiddle(), 0.375);
  for (const glm::dvec2& sample : samples.Places)
  {
    const double y = 20.0 + sample.y;
    EXPECT_TRUE(this->MayBeSeen(MakeLow(y, 1e-7), samples)) << y;
    EXPECT_TRUE(this->MayBeSeen(MakeLow(y + 0.0019, 1e-7), samples)) << y;
    EXPECT_FALSE(this->MayBeSeen(MakeLow(y + 0.01, 1e-7), samples)) << y;
    EXPECT_FALSE(this->MayBeSeen(MakeLow(y + 0.125, 1e-7), samples)) << y;
    // Between two samples of this row, and across one of them.
    const double x = 30.0 + sample.x;
    const auto make = [y](double begin, double end) -> Triangle {
      return { { { begin, y, 0.8 }, { end, y, 0.9 }, { 0.5 * (begin + end), y, 0.8 } } };
    };
    EXPECT_FALSE(this->MayBeSeen(make(x + 0.05, x + 0.95), samples)) << y;
    EXPECT_TRUE(this->MayBeSeen(make(x - 0.05, x + 0.95), samples)) << y;
  }
}

// A device that snaps to a grid of 2^-8 pixels snaps these corners to the same y, and draws
// nothing; or to two different ones, and the middles of pixels lie between them.
TEST_F(Slivers, SnappedToTheGrid)
{
  this->SetWall(1.0f);
  this->Projection = MapWorldToPixels(SliversWidth, SliversHeight, 8);
  const double step = 1.0 / 256;
  for (const double y : { 20.5, 20.5 + 0.4 * step, 20.5 - 0.4 * step, 20.5 - 0.6 * step })
  {
    EXPECT_FALSE(this->MayBeSeen(MakeLow(y, 1e-7))) << y;
  }
  const double below = 20.5 - 0.6 * step;
  const double on = 20.5 - 0.4 * step;
  EXPECT_TRUE(this->MayBeSeen({ { { 10.2, on, 0.8 }, { 60.7, on, 0.9 }, { 35, below, 0.85 } } }));
  EXPECT_TRUE(this->MayBeSeen(MakeLow(20.5 + 0.5 * step, 1e-7))) << "to one y or to another";
  EXPECT_FALSE(this->MayBeSeen(MakeLow(20.5 + 1.5 * step, 1e-7))) << "above the middles";
  // The ends of the longest side are snapped to different y, and the middles of pixels lie beyond.
  EXPECT_FALSE(this->MayBeSeen({ { { 10.2, 20.5 + 0.6 * step, 0.8 },
    { 60.7, 20.5 + 1.6 * step, 0.9 }, { 35.0, 21.0, 0.8 } } }));
}

// A sliver that has a plane is as near as the slope of this plane allows.
TEST_F(Slivers, AsNearAsTheSlopeAllows)
{
  // Exact depths begin at 0.8. The third corner is 0.05 behind the side below: a slope of 5 per
  // pixel, 0.01 nearer at the middles of pixels that are 0.002 pixels below that side.
  const auto steep = [](double y) { return MakeLow(y, 0.01, 0.8, 0.8, 0.85); };
  const auto gentle = MakeLow(20.5019, 0.01);
  this->SetWall(0.78f);
  EXPECT_FALSE(this->MayBeSeen(steep(20.5019)));
  this->SetWall(0.791f);
  EXPECT_TRUE(this->MayBeSeen(steep(20.5019)));
  // Middles in the triangle are farther than its nearest point.
  EXPECT_FALSE(this->MayBeSeen(steep(20.4981)));
  // As low, but of a slope for which the slack of its box is enough.
  this->SetWall(1.0f);
  EXPECT_FALSE(this->MayBeSeen(gentle));
}

// A triangle does not own samples on the other side of its longest side.
TEST_F(Slivers, OnlySamplesInIt)
{
  this->SetWall(1.0f);
  EXPECT_FALSE(this->MayBeSeen(MakeLow(20.52, 0.025, 0.8, 0.8, 0.85)));
  EXPECT_FALSE(this->MayBeSeen(MakeLow(20.48, -0.025, 0.8, 0.8, 0.85)));
  EXPECT_TRUE(this->MayBeSeen(MakeLow(20.501, 0.025, 0.8, 0.8, 0.85)));
}

// The wall is open next to the sliver: its texels are open, but its pixels are not.
TEST_F(Slivers, PixelsDecideWhereTheyAreAtHand)
{
  const auto sliver = MakeLow(20.5, 0.005, 0.8, 0.8, 0.85);
  this->SetWall(0.5f);
  std::fill_n(this->Depth.begin() + 21 * SliversWidth, SliversWidth, 1.0f);
  this->Levels.BuildBase(
    this->Depth.data(), SliversWidth, SliversHeight, 4, vtkNBufferExtremum::Maximum);
  EXPECT_TRUE(this->MayBeSeen(sliver));
  EXPECT_FALSE(this->MayBeSeen(sliver, {}, this->Depth.data()));
  this->Depth[20 * SliversWidth + 40] = 1.0f;
  EXPECT_TRUE(this->MayBeSeen(sliver, {}, this->Depth.data()));
}

// The wall is open in a single pixel.
TEST_F(Slivers, ThroughAHole)
{
  this->SetWall(0.0f);
  EXPECT_TRUE(this->MayBeSeen(MakeLow(20.5, 1e-7)));
  this->SetWall(-1.0f);
  this->Depth[20 * SliversWidth + 40] = 1.0f;
  this->Levels.BuildBase(
    this->Depth.data(), SliversWidth, SliversHeight, 4, vtkNBufferExtremum::Maximum);
  EXPECT_TRUE(this->MayBeSeen(MakeLow(20.5, 0.005, 0.8, 0.8, 0.85)));
  EXPECT_FALSE(this->MayBeSeen(MakeLow(30.5, 0.005, 0.8, 0.8, 0.85)));
}
