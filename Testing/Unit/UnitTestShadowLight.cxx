// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Facing signs and light coordinates.
#include "ShadowCaster.h"
#include "vtkShadowLight.h"
#include "vtkShadowTarget.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using Kind = vtkShadowLightKind;

constexpr Kind Kinds[] = { Kind::Directional, Kind::Spot, Kind::Point };

/// Small integers.
Point MakeGridPoint(std::mt19937& random)
{
  return glm::trunc(MakePoint(random, 4.0));
}

vtkShadowLight RandomLight(std::mt19937& random, Kind kind)
{
  vtkShadowLight light;
  light.Kind = kind;
  light.Position = MakePoint(random, 10.0);
  light.Direction = vtkNBufferGLM::Normalize(MakePoint(random, 1.0));
  return light;
}
}

// Hazard: edges sum the signs of their triangles, and a sign that depends on the order of the
// corners leaves cracks. Coordinates are small integers, so that every edge-on case is exactly 0.
TEST(ShadowLight, FacingIsCyclicAntisymmetricAndMirrored)
{
  std::mt19937 random(1);
  int edgeOn = 0;
  for (int n = 0; n < 20000; ++n)
  {
    vtkShadowLight light;
    light.Kind = Kinds[n % 3];
    light.Position = MakeGridPoint(random);
    light.Direction = MakeGridPoint(random);
    const Point a = MakeGridPoint(random);
    const Point b = MakeGridPoint(random);
    const Point c = MakeGridPoint(random);
    const int facing = light.GetFacing(a, b, c);
    edgeOn += facing == 0;
    ASSERT_EQ(light.GetFacing(b, c, a), facing) << "case " << n;
    ASSERT_EQ(light.GetFacing(c, a, b), facing) << "case " << n;
    ASSERT_EQ(light.GetFacing(a, c, b), -facing) << "case " << n;
    ASSERT_EQ(light.GetFacing(a, a, b), 0) << "case " << n;
    // Everything mirrored in x.
    vtkShadowLight mirrored = light;
    mirrored.Position[0] = -light.Position[0];
    mirrored.Direction[0] = -light.Direction[0];
    const Point mirror(-1, 1, 1);
    ASSERT_EQ(mirrored.GetFacing(mirror * a, mirror * b, mirror * c), -facing) << "case " << n;
  }
  EXPECT_GT(edgeOn, 500) << "the grid has to give many edge-on triangles";
}

// The convention: a triangle that is anticlockwise as seen from the light has the sign 1.
TEST(ShadowLight, FacingOfAFloor)
{
  const Point a = { 0, 0, 0 };
  const Point b = { 1, 0, 0 };
  const Point c = { 0, 1, 0 };
  vtkShadowLight light;
  EXPECT_EQ(light.GetFacing(a, b, c), 1) << "from above";
  light.Direction[2] = 1.0;
  EXPECT_EQ(light.GetFacing(a, b, c), -1) << "from below";
  light.Kind = Kind::Point;
  light.Position[2] = 5.0;
  EXPECT_EQ(light.GetFacing(a, b, c), 1);
  light.Position[2] = 0.0;
  EXPECT_EQ(light.GetFacing(a, b, c), 0) << "in its plane";
  const Point nan = { std::numeric_limits<double>::quiet_NaN(), 0, 0 };
  EXPECT_EQ(light.GetFacing(a, b, nan), 0);
}

// Hazard: planes and volumes are computed in light coordinates and drawn in the world, and the two
// conversions do not match.
TEST(ShadowLight, FramesGoThereAndBack)
{
  std::mt19937 random(2);
  for (int n = 0; n < 3000; ++n)
  {
    const vtkShadowLight light = RandomLight(random, Kinds[n % 3]);
    const Point axis = MakePoint(random, 3.0);
    const vtkShadowLightSpace space =
      light.IsPositional() ? vtkShadowLightSpace(light, axis) : vtkShadowLightSpace(light);
    const glm::dmat3 axes(space.GetU(), space.GetV(), space.GetAxis());
    const glm::dmat3 difference = glm::transpose(axes) * axes - glm::dmat3(1.0);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_LE(glm::length(difference[i]), 1e-14) << "case " << n;
    }
    const Point x = MakePoint(random, 20.0);
    const Point pqs = space.ToLight(x);
    ASSERT_EQ(pqs[2], space.GetDepth(x)) << "case " << n;
    if (light.IsPositional() && pqs[2] < 0.01)
    {
      continue;
    }
    const Point back = ToWorld(space, pqs);
    const Point moved = space.ToLight(space.Extrude(x, 2.5 * std::abs(pqs[2]) + 1.0));
    ASSERT_LE(glm::length(back - x), 1e-12) << "case " << n;
    ASSERT_NEAR(moved[0], pqs[0], 1e-13 * (30.0 + std::abs(pqs[0]))) << "case " << n;
    ASSERT_NEAR(moved[1], pqs[1], 1e-13 * (30.0 + std::abs(pqs[1]))) << "case " << n;
    ASSERT_NEAR(moved[2], 2.5 * std::abs(pqs[2]) + 1.0, 1e-12 * (1.0 + moved[2])) << "case " << n;
  }
}

// Hazard: a point that the shader lights is not a receiver. The margin must be on the safe side.
TEST(ShadowLight, ReachesItsCone)
{
  std::mt19937 random(3);
  for (int n = 0; n < 3000; ++n)
  {
    vtkShadowLight light = RandomLight(random, Kind::Spot);
    light.ConeAngle = MakeUniform(random, 0.5, 89.5);
    // Every other one close to the edge of the cone.
    const double angle =
      n % 2 ? MakeUniform(random, 0.0, 180.0) : light.ConeAngle + 0.01 * (n % 9 - 4) + 0.005;
    Point across;
    vtkMath::Perpendiculars(
      glm::value_ptr(light.Direction), glm::value_ptr(across), nullptr, 0.01 * n);
    const double distance = std::pow(10.0, n % 7 - 3);
    const double radians = vtkMath::RadiansFromDegrees(angle);
    const Point x = light.Position +
      distance * (std::cos(radians) * light.Direction + std::sin(radians) * across);
    ASSERT_EQ(IsReached(light, x), angle <= light.ConeAngle + 0.01)
      << "case " << n << ", angle " << angle << ", cone " << light.ConeAngle;
    light.Kind = n % 2 ? Kind::Point : Kind::Directional;
    ASSERT_TRUE(IsReached(light, x));
  }
}

// Four lights share the channels of a mask.
TEST(ShadowLightSlot, MasksAndChannels)
{
  EXPECT_EQ(vtkShadowTarget::CountMasks(0), 0);
  EXPECT_EQ(vtkShadowTarget::CountMasks(4), 1);
  EXPECT_EQ(vtkShadowTarget::CountMasks(5), 2);
  EXPECT_EQ(vtkShadowTarget::GetMaskIndex(3), 0);
  EXPECT_EQ(vtkShadowTarget::GetChannel(3), 3);
  EXPECT_EQ(vtkShadowTarget::GetMaskIndex(4), 1);
  EXPECT_EQ(vtkShadowTarget::GetChannel(4), 0);
}
