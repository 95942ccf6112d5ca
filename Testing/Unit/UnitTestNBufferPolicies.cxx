// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// The order of equal depths against a simulated depth buffer, and when the culler rests.
#include "vtkNBufferBackOff.h"
#include "vtkNBufferProjection.h"
#include "vtkNBufferTieOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <vector>

namespace
{
constexpr int Side = 12; // of the simulated window

/// A parallel view in which world x and y are pixels and z is the depth.
vtkNBufferProjection MakeProjection()
{
  const double worldToClip[16] = { 2.0 / Side, 0.0, 0.0, -1.0, 0.0, 2.0 / Side, 0.0, -1.0, 0.0, 0.0,
    2.0, -1.0, 0.0, 0.0, 0.0, 1.0 };
  vtkNBufferProjection projection;
  projection.Set(worldToClip, Side, Side, 0x1p-24);
  return projection;
}

struct Prop
{
  int Rectangle[4]; // in pixels, half-open
  double Depth;
  vtkNBufferDrawnProp Drawn;
};

struct Pixel
{
  double Depth = 1.0;
  int Owner = -1;
};

void Draw(const Prop& prop, std::vector<Pixel>& window)
{
  for (int y = prop.Rectangle[2]; y < prop.Rectangle[3]; ++y)
  {
    for (int x = prop.Rectangle[0]; x < prop.Rectangle[1]; ++x)
    {
      Pixel& pixel = window[y * Side + x];
      if (prop.Depth <= pixel.Depth)
      {
        pixel.Depth = prop.Depth;
        pixel.Owner = prop.Drawn.Index;
      }
    }
  }
}

std::vector<int> GetOwners(const std::vector<Pixel>& window)
{
  std::vector<int> owners;
  for (const Pixel& pixel : window)
  {
    owners.push_back(pixel.Owner);
  }
  return owners;
}
}

// Hazard: with equal depths the picture depends on the order of drawing; drawn in rounds and then
// once more where said, it must be that of the renderer's order, for any rounds.
TEST(NBufferTieOrder, RedrawsRestoreTheOrder)
{
  const vtkNBufferProjection projection = MakeProjection();
  std::mt19937 random(41);
  int redrawn = 0;
  for (int n = 0; n < 3000; ++n)
  {
    const int count = 2 + static_cast<int>(random() % 12);
    const int rounds = 1 + static_cast<int>(random() % 4);
    std::vector<Prop> props(count);
    std::ostringstream text;
    for (int i = 0; i < count; ++i)
    {
      Prop& prop = props[i];
      for (int axis = 0; axis < 2; ++axis)
      {
        prop.Rectangle[2 * axis] = static_cast<int>(random() % (Side - 1));
        prop.Rectangle[2 * axis + 1] =
          std::min<int>(prop.Rectangle[2 * axis] + 1 + static_cast<int>(random() % 6), Side);
      }
      prop.Depth = 0.25 * static_cast<double>(1 + random() % 3);
      prop.Drawn.Index = i;
      prop.Drawn.Round = static_cast<int>(random() % rounds);
      prop.Drawn.Bounded = random() % 8 != 0;
      const double bounds[6] = { prop.Rectangle[0] + 0.3, prop.Rectangle[1] - 0.3,
        prop.Rectangle[2] + 0.3, prop.Rectangle[3] - 0.3, prop.Depth, prop.Depth };
      prop.Drawn.Box = vtkNBufferBox::FromBounds(bounds);
      ASSERT_EQ(projection.Project(prop.Drawn.Box, prop.Drawn.Screen), vtkNBufferPlacement::Inside);
      text << "(" << prop.Rectangle[0] << " " << prop.Rectangle[1] << " " << prop.Rectangle[2]
           << " " << prop.Rectangle[3] << " at " << prop.Depth << ", round " << prop.Drawn.Round
           << ") ";
    }
    SCOPED_TRACE(text.str());
    std::vector<Pixel> expected(Side * Side);
    std::vector<Pixel> window(Side * Side);
    for (const Prop& prop : props)
    {
      Draw(prop, expected);
    }
    std::vector<vtkNBufferDrawnProp> drawn;
    for (int round = 0; round < rounds; ++round)
    {
      for (const Prop& prop : props)
      {
        if (prop.Drawn.Round == round)
        {
          Draw(prop, window);
          drawn.push_back(prop.Drawn);
        }
      }
    }
    const std::vector<int> redraws = vtkNBufferTieOrder::GetRedraws(projection, drawn);
    for (int position : redraws)
    {
      Draw(props[drawn[position].Index], window);
    }
    redrawn += static_cast<int>(redraws.size());
    ASSERT_EQ(GetOwners(window), GetOwners(expected));
    if (rounds == 1)
    {
      ASSERT_TRUE(redraws.empty()) << "one round is the renderer's order";
    }
  }
  EXPECT_GT(redrawn, 1000);
}

// Hazard: props that cannot touch are drawn twice for nothing.
TEST(NBufferTieOrder, OnlyPropsThatTouchTie)
{
  const vtkNBufferProjection projection = MakeProjection();
  const auto make = [&projection](double x, double y, double z)
  {
    vtkNBufferDrawnProp prop;
    const double bounds[6] = { x, x + 2.0, y, y + 2.0, z, z + 0.05 };
    prop.Box = vtkNBufferBox::FromBounds(bounds);
    prop.Bounded = true;
    EXPECT_EQ(projection.Project(prop.Box, prop.Screen), vtkNBufferPlacement::Inside);
    return prop;
  };
  const vtkNBufferDrawnProp a = make(1.0, 1.0, 0.5);
  EXPECT_TRUE(vtkNBufferTieOrder::CanTie(projection, a, a));
  EXPECT_TRUE(vtkNBufferTieOrder::CanTie(projection, a, make(2.0, 2.0, 0.52)));
  EXPECT_TRUE(vtkNBufferTieOrder::CanTie(projection, a, make(1.0, 1.0, 0.55))) << "face to face";
  EXPECT_FALSE(vtkNBufferTieOrder::CanTie(projection, a, make(5.0, 1.0, 0.5))) << "beside";
  EXPECT_FALSE(vtkNBufferTieOrder::CanTie(projection, a, make(1.0, 1.0, 0.7))) << "behind";
  vtkNBufferDrawnProp unbounded = make(8.0, 8.0, 0.1);
  unbounded.Bounded = false;
  EXPECT_TRUE(vtkNBufferTieOrder::CanTie(projection, a, unbounded));
  EXPECT_TRUE(vtkNBufferTieOrder::CanTie(projection, unbounded, a));
}

// Hazard: a rest that never begins wastes tests, one that never ends hides nothing any more.
TEST(NBufferBackOff, RestsAndProbes)
{
  vtkNBufferBackOff backOff;
  EXPECT_FALSE(backOff.Rests());
  for (int i = 0; i < vtkNBufferBackOff::PoorTestsToRest; ++i)
  {
    EXPECT_FALSE(backOff.Rests()) << i;
    backOff.Learn(1, 100);
  }
  int expected = vtkNBufferBackOff::ShortestRest;
  for (int probe = 0; probe < 6; ++probe)
  {
    int rest = 0;
    while (backOff.Rests())
    {
      ASSERT_LE(++rest, vtkNBufferBackOff::LongestRest);
    }
    EXPECT_EQ(rest, expected) << probe;
    expected = std::min(2 * expected, vtkNBufferBackOff::LongestRest);
    backOff.Learn(0, 100);
  }
  while (backOff.Rests())
  {
  }
  backOff.Learn(50, 100);
  EXPECT_FALSE(backOff.Rests()) << "a probe that hides much ends it";
  backOff.Learn(0, 100);
  EXPECT_FALSE(backOff.Rests()) << "and all begins anew";
}

// Hazard: with nothing held back there is no test, and with no test nothing is held back.
TEST(NBufferBackOff, ProbesWhereNothingIsHeld)
{
  vtkNBufferBackOff backOff;
  int probes = 0;
  for (int frame = 0; frame < 8 * 10; ++frame)
  {
    probes += backOff.IsProbeDue();
  }
  EXPECT_EQ(probes, 10);
}

// Hazard: an empty frustum divides by nothing.
TEST(NBufferBackOff, EmptyFrustum)
{
  vtkNBufferBackOff backOff;
  for (int i = 0; i < 10; ++i)
  {
    backOff.Learn(0, 0);
  }
  EXPECT_FALSE(backOff.Rests());
}
