// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// Facing signs and light coordinates.
#include "vtkShadowLight.h"

#include "vtkMath.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using Kind = vtkShadowLightKind;
using Point = std::array<double, 3>;

constexpr Kind Kinds[] = { Kind::Directional, Kind::Spot, Kind::Point };

Point RandomPoint(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random);
  const double y = uniform(random);
  return { x, y, uniform(random) };
}

Point RandomGridPoint(std::mt19937& random)
{
  std::uniform_int_distribution<int> uniform(-3, 3);
  const int x = uniform(random);
  const int y = uniform(random);
  return { double(x), double(y), double(uniform(random)) };
}

vtkShadowLight RandomLight(std::mt19937& random, Kind kind)
{
  vtkShadowLight light;
  light.Kind = kind;
  const Point position = RandomPoint(random, 10.0);
  std::copy_n(position.data(), 3, light.Position);
  Point direction = RandomPoint(random, 1.0);
  vtkMath::Normalize(direction.data());
  std::copy_n(direction.data(), 3, light.Direction);
  return light;
}
}

// Hazard: edges sum the signs of their triangles; a sign that depends on the order of the corners
// leaves cracks. Small integers, so that every case that is edge-on is exactly 0.
TEST(ShadowLight, FacingIsCyclicAntisymmetricAndMirrored)
{
  std::mt19937 random(1);
  int edgeOn = 0;
  for (int n = 0; n < 20000; ++n)
  {
    vtkShadowLight light;
    light.Kind = Kinds[n % 3];
    const Point position = RandomGridPoint(random);
    const Point direction = RandomGridPoint(random);
    std::copy_n(position.data(), 3, light.Position);
    std::copy_n(direction.data(), 3, light.Direction);
    const Point a = RandomGridPoint(random);
    const Point b = RandomGridPoint(random);
    const Point c = RandomGridPoint(random);
    const int facing = light.GetFacing(a.data(), b.data(), c.data());
    edgeOn += facing == 0;
    ASSERT_EQ(light.GetFacing(b.data(), c.data(), a.data()), facing) << "case " << n;
    ASSERT_EQ(light.GetFacing(c.data(), a.data(), b.data()), facing) << "case " << n;
    ASSERT_EQ(light.GetFacing(a.data(), c.data(), b.data()), -facing) << "case " << n;
    ASSERT_EQ(light.GetFacing(a.data(), a.data(), b.data()), 0) << "case " << n;
    // Everything mirrored in x.
    vtkShadowLight mirrored = light;
    mirrored.Position[0] = -light.Position[0];
    mirrored.Direction[0] = -light.Direction[0];
    const Point ma = { -a[0], a[1], a[2] };
    const Point mb = { -b[0], b[1], b[2] };
    const Point mc = { -c[0], c[1], c[2] };
    ASSERT_EQ(mirrored.GetFacing(ma.data(), mb.data(), mc.data()), -facing) << "case " << n;
  }
  EXPECT_GT(edgeOn, 500) << "the grid has to give many edge-on triangles";
}

// The convention itself: anticlockwise as the light sees it is 1.
TEST(ShadowLight, FacingOfAFloor)
{
  const double a[3] = { 0, 0, 0 };
  const double b[3] = { 1, 0, 0 };
  const double c[3] = { 0, 1, 0 };
  vtkShadowLight light;
  EXPECT_EQ(light.GetFacing(a, b, c), 1) << "from above";
  light.Direction[2] = 1.0;
  EXPECT_EQ(light.GetFacing(a, b, c), -1) << "from below";
  light.Kind = Kind::Point;
  light.Position[2] = 5.0;
  EXPECT_EQ(light.GetFacing(a, b, c), 1);
  light.Position[2] = 0.0;
  EXPECT_EQ(light.GetFacing(a, b, c), 0) << "in its plane";
  const double nan[3] = { std::numeric_limits<double>::quiet_NaN(), 0, 0 };
  EXPECT_EQ(light.GetFacing(a, b, nan), 0);
}

// Hazard: planes and volumes are made in light coordinates and drawn in the world.
TEST(ShadowLight, FramesGoThereAndBack)
{
  std::mt19937 random(2);
  for (int n = 0; n < 3000; ++n)
  {
    const vtkShadowLight light = RandomLight(random, Kinds[n % 3]);
    const Point axis = RandomPoint(random, 3.0);
    const vtkShadowLightSpace frame =
      light.IsPositional() ? vtkShadowLightSpace(light, axis.data()) : vtkShadowLightSpace(light);
    const double* axes[3] = { frame.GetU(), frame.GetV(), frame.GetAxis() };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        ASSERT_NEAR(vtkMath::Dot(axes[i], axes[j]), i == j ? 1.0 : 0.0, 1e-14) << "case " << n;
      }
    }
    const Point x = RandomPoint(random, 20.0);
    double pqs[3];
    frame.ToLight(x.data(), pqs);
    ASSERT_EQ(pqs[2], frame.GetDepth(x.data())) << "case " << n;
    if (light.IsPositional() && pqs[2] < 0.01)
    {
      continue;
    }
    double back[3];
    frame.ToWorld(pqs, back);
    double extruded[3];
    frame.Extrude(x.data(), 2.5 * std::abs(pqs[2]) + 1.0, extruded);
    double moved[3];
    frame.ToLight(extruded, moved);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_NEAR(back[i], x[i], 1e-12) << "case " << n;
    }
    ASSERT_NEAR(moved[0], pqs[0], 1e-13 * (30.0 + std::abs(pqs[0]))) << "case " << n;
    ASSERT_NEAR(moved[1], pqs[1], 1e-13 * (30.0 + std::abs(pqs[1]))) << "case " << n;
    ASSERT_NEAR(moved[2], 2.5 * std::abs(pqs[2]) + 1.0, 1e-12 * (1.0 + moved[2])) << "case " << n;
  }
}

// Hazard: what the shader lights must be a receiver; the margin is on the safe side.
TEST(ShadowLight, ReachesItsCone)
{
  std::mt19937 random(3);
  for (int n = 0; n < 3000; ++n)
  {
    vtkShadowLight light = RandomLight(random, Kind::Spot);
    light.ConeAngle = std::uniform_real_distribution<double>(0.5, 89.5)(random);
    // Every other one close to the edge of the cone.
    const double angle = n % 2 ? std::uniform_real_distribution<double>(0.0, 180.0)(random)
                               : light.ConeAngle + 0.01 * (n % 9 - 4) + 0.005;
    double across[3];
    vtkMath::Perpendiculars(light.Direction, across, nullptr, 0.01 * n);
    const double distance = std::pow(10.0, n % 7 - 3);
    Point x;
    for (int i = 0; i < 3; ++i)
    {
      x[i] = light.Position[i] +
        distance *
          (std::cos(vtkMath::RadiansFromDegrees(angle)) * light.Direction[i] +
            std::sin(vtkMath::RadiansFromDegrees(angle)) * across[i]);
    }
    ASSERT_EQ(light.IsInCone(x.data()), angle <= light.ConeAngle + 0.01)
      << "case " << n << ", angle " << angle << ", cone " << light.ConeAngle;
    light.Kind = n % 2 ? Kind::Point : Kind::Directional;
    ASSERT_TRUE(light.IsInCone(x.data()));
  }
}
