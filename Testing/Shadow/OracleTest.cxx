// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The oracle in scenes whose shadows are known.
#include "ShadowTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace
{
using OracleTest = OffscreenFixture;

/// Whether the ray from `origin` along `direction` meets a box.
bool MeetsBox(
  const double origin[3], const double direction[3], const Point& centre, const Point& size)
{
  double enter = 0.0;
  double leave = VTK_DOUBLE_MAX;
  for (int i = 0; i < 3; ++i)
  {
    const double one = (centre[i] - 0.5 * size[i] - origin[i]) / direction[i];
    const double two = (centre[i] + 0.5 * size[i] - origin[i]) / direction[i];
    enter = std::max(enter, std::min(one, two));
    leave = std::min(leave, std::max(one, two));
  }
  return enter < leave;
}

double GetDistanceToRay(const double origin[3], const double direction[3], const Point& centre)
{
  const glm::dvec3 ray = glm::make_vec3(direction);
  const glm::dvec3 toCentre = centre - glm::make_vec3(origin);
  return glm::length(glm::cross(toCentre, ray)) / glm::length(ray);
}

using Build = std::function<void(SceneBuilder&)>;

/// A stage in which a unit of x and y is a pixel and (0, 0) the lower left corner, seen from above.
Stage SetPixelStage(int width, int height, const Build& build)
{
  return SetStage(
    [&](SceneBuilder& scene)
    {
      build(scene);
      const Point middle = { 0.5 * width, 0.5 * height, 0.0 };
      scene.LookParallel(middle + Point(0.0, 0.0, 100.0), middle, 0.5 * height);
    },
    width, height);
}

OracleImage Cast(const Stage& stage)
{
  return Cast(stage.GetRenderer(), stage.Lights[0]);
}

/// Calls function(x, y, receiver, direction to the light) for what is seen of the floor.
template <typename Function>
void ForEachOnFloor(const Oracle& oracle, const OracleLight& light, Function function)
{
  for (const auto& [x, y] : Pixels(oracle.GetWidth(), oracle.GetHeight()))
  {
    Oracle::Receiver receiver;
    if (oracle.GetReceiver(x, y, 0.0, 0.0, receiver) && receiver.Normal[2] > 0.99 &&
      std::abs(receiver.Position[2]) < 0.1)
    {
      double direction[3];
      light.GetDirectionTo(receiver.Position, direction);
      function(x, y, receiver, direction);
    }
  }
}

/// A floor of so many units around the origin, in a light from a direction.
Build MakeFloor(double halfSize, const Point& direction)
{
  return [=](SceneBuilder& scene)
  {
    scene.Floor(halfSize);
    scene.Directional(direction);
  };
}
}

TEST_F(OracleTest, BoxAboveFloor)
{
  const Point centre = { 0.1, -0.2, 1.3 };
  const Point size = { 1.1, 0.7, 0.9 };
  for (const bool positional : { false, true })
  {
    SCOPED_TRACE(positional);
    const Stage stage = SetStage(
      [&](SceneBuilder& scene)
      {
        scene.Floor(5.0);
        scene.Box(centre, size);
        positional ? scene.PointLight({ -1.5, -1.0, 3.0 }) : scene.Directional({ 0.6, 0.35, -0.7 });
        scene.Look({ 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
      });
    const OracleLight light(stage.Lights[0]);
    const Oracle oracle(stage.GetRenderer());
    const OracleImage image = oracle.Cast(light);
    int shadowed = 0;
    int wrong = 0;
    ForEachOnFloor(oracle, light,
      [&](int x, int y, const Oracle::Receiver& receiver, const double direction[3])
      {
        const std::size_t i = static_cast<std::size_t>(y) * image.Width + x;
        const bool expected = MeetsBox(receiver.Position, direction, centre, size);
        shadowed += expected;
        wrong += expected != (image.Samples[i] == OracleSample::Shadowed) && !image.Ambiguous[i];
      });
    EXPECT_GT(shadowed, 500);
    EXPECT_EQ(wrong, 0);
  }
}

TEST_F(OracleTest, SphereAboveFloor)
{
  const Point centre = { 0.1, -0.2, 1.3 };
  const Stage stage = SetStage(
    [&](SceneBuilder& scene)
    {
      scene.Floor(5.0);
      scene.Sphere(centre, 0.8, 64);
      scene.Directional({ 0.6, 0.35, -0.7 });
      scene.Spot({ -1.5, -1.0, 4.0 }, { 0.0, 0.0, 1.0 }, 80.0);
      scene.Look({ 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
    });
  const Oracle oracle(stage.GetRenderer());
  // Facets lie between this radius and the sphere's.
  const double inner = 0.8 * std::pow(std::cos(vtkMath::Pi() / 63.0), 2.0);
  for (vtkLight* vtklight : stage.Lights)
  {
    const OracleLight light(vtklight);
    int inside = 0;
    int outside = 0;
    ForEachOnFloor(oracle, light,
      [&](int x, int y, const Oracle::Receiver& receiver, const double direction[3])
      {
        const OracleSample sample = oracle.Classify(x, y, 0.0, 0.0, light).Sample;
        const double distance = GetDistanceToRay(receiver.Position, direction, centre);
        if (sample != OracleSample::Unlit && distance < inner)
        {
          ++inside;
          EXPECT_EQ(sample, OracleSample::Shadowed) << x << " " << y;
          EXPECT_EQ(oracle.CountCrossings(receiver, light) % 2, 0) << x << " " << y;
        }
        else if (sample != OracleSample::Unlit && distance > 0.8)
        {
          ++outside;
          EXPECT_EQ(sample, OracleSample::Lit) << x << " " << y;
        }
      });
    EXPECT_GT(inside, 500);
    EXPECT_GT(outside, 5000);
  }
}

// The edge of a shadow on the floor is `distance` pixels away from the centres of a column of
// pixels.
TEST_F(OracleTest, NearAnEdgeIsAmbiguous)
{
  for (const double distance : { -0.02, -0.015, -0.001, 0.001, 0.015, 0.02 })
  {
    SCOPED_TRACE(distance);
    // Light from the upper left at 45 degrees: a quad 10 above the floor shifts its shadow by 10.
    const double edge = 20.5 + distance;
    Stage stage = SetPixelStage(40, 30,
      [&](SceneBuilder& scene)
      {
        scene.Floor(100.0);
        scene.Sheet({ -50.0, -50.0, 10.0 }, { edge + 40.0, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
        scene.Directional({ 1.0, 0.0, -1.0 });
      });
    const OracleImage image = Cast(stage);
    for (int x = 0; x < 40; ++x)
    {
      const std::size_t i = 15 * 40 + x;
      // Seen from above the quad itself ends 10 pixels to the left.
      const bool lit = x + 0.5 < edge - 10.0 || x + 0.5 > edge;
      EXPECT_EQ(image.Samples[i], lit ? OracleSample::Lit : OracleSample::Shadowed) << x;
      EXPECT_EQ(image.Ambiguous[i] != 0, std::abs(distance) < 1.0 / 64.0 && (x == 20 || x == 10))
        << x;
    }
  }
}

// The floor is 100 below the eye, and `gap` before the far plane. A unit of depth is 5.9e-6.
TEST_F(OracleTest, WhatIsStoredAsBackgroundIsAmbiguous)
{
  for (const double gap : { 1e-6, 1e-5 })
  {
    Stage stage = SetPixelStage(20, 10, MakeFloor(100.0, { 1.0, 0.0, -1.0 }));
    stage.GetRenderer()->GetActiveCamera()->SetClippingRange(1.0, 100.0 + gap);
    const OracleImage image = Cast(stage);
    EXPECT_EQ(image.CountAmbiguous(), gap < 5.9e-6 ? 200 : 0) << gap;
  }
}

// Two sheets, one half a pixel above the other, are seen at an angle of 1 : 40, and everything is
// in shadow. The samples are some distance away from the edge of the upper sheet: near the edge a
// rasteriser may see either sheet.
TEST_F(OracleTest, StepBetweenSheetsSeenAlmostEdgeOnIsAmbiguous)
{
  for (const double distance : { -0.02, -0.015, -0.001, 0.001, 0.015, 0.02 })
  {
    SCOPED_TRACE(distance);
    const double edge = 15.5 + distance;
    Stage stage = SetPixelStage(40, 30,
      [&](SceneBuilder& scene)
      {
        const Point across = { 140.0, 0.0, 0.0 };
        scene.Sheet({ -50.0, edge, -1000.0 }, across, { 0.0, 10.0, -400.0 });
        scene.Sheet({ -50.0, edge - 10.0, -620.0 }, across, { 0.0, 20.0, -800.0 });
        scene.Sheet({ -50.0, 500.0, 0.0 }, across, { 0.0, 0.0, -2000.0 });
        scene.Directional({ 0.0, -1.0, 0.0 });
      });
    const OracleImage image = Cast(stage);
    for (int y = 8; y < 23; ++y)
    {
      const std::size_t i = 40 * y + 20;
      EXPECT_EQ(image.Samples[i], OracleSample::Shadowed) << y;
      EXPECT_EQ(image.Ambiguous[i] != 0, std::abs(distance) < 1.0 / 64.0 && y == 15) << y;
    }
  }
}

TEST_F(OracleTest, GrazingLightIsAmbiguous)
{
  for (const double slope : { -1e-3, -5e-5, 5e-5, 1e-3 })
  {
    SCOPED_TRACE(slope);
    const OracleImage image = Cast(SetPixelStage(8, 6, MakeFloor(10.0, { 1.0, 0.0, -slope })));
    EXPECT_EQ(image.Count(slope > 0.0 ? OracleSample::Lit : OracleSample::Unlit), 48);
    EXPECT_EQ(image.CountAmbiguous(), std::abs(slope) < 1e-4 ? 48 : 0);
  }
}

// A second sheet is just below a sheet that is seen from above, so that the cap of its volume is
// next to the first one. The view is 200 deep, so that a step of depth is 200 / 2^24.
TEST_F(OracleTest, CapsWithinStepsOfDepthAreAmbiguous)
{
  for (const double steps : { 2.0, 50.0 })
  {
    SCOPED_TRACE(steps);
    Stage stage = SetPixelStage(8, 6,
      [&](SceneBuilder& scene)
      {
        scene.Floor(10.0);
        scene.Floor(10.0, -200.0 * steps / (1 << 24));
        scene.Directional({ 0.1, 0.2, -1.0 });
      });
    stage.GetRenderer()->GetActiveCamera()->SetClippingRange(1.0, 201.0);
    const OracleImage image = Cast(stage);
    EXPECT_EQ(image.Count(OracleSample::Lit), 48);
    EXPECT_EQ(image.CountAmbiguous(), steps < 10.0 ? 48 : 0);
  }
}

// Light at 45 degrees passes a strip one step of depth wide, whose shadow is some steps away from
// the samples of a column. Depth that is rounded by as much moves the samples into the shadow.
TEST_F(OracleTest, ThinShadowsWithinStepsOfDepthAreAmbiguous)
{
  constexpr double step = 200.0 / (1 << 24);
  for (const double steps : { 0.5, 1.5, 20.0 })
  {
    SCOPED_TRACE(steps);
    Stage stage = SetPixelStage(8, 6,
      [&](SceneBuilder& scene)
      {
        scene.Floor(10.0);
        scene.Sheet(
          { 4.5 - 10.0 + steps * step, -50.0, 10.0 }, { step, 0.0, 0.0 }, { 0.0, 100.0, 0.0 });
        scene.Directional({ 1.0, 0.0, -1.0 });
      });
    stage.GetRenderer()->GetActiveCamera()->SetClippingRange(1.0, 201.0);
    const OracleImage image = Cast(stage);
    EXPECT_EQ(image.Count(OracleSample::Lit), 48);
    EXPECT_EQ(image.CountAmbiguous(), steps < 10.0 ? 6 : 0);
  }
}

// Hazard: the side of a volume in a surface that light grazes is as steep as the surface, and its
// push away from the eye is the sum of steps of depth and of what the slope makes of steps of the
// subpixel grid. The shadow of a wall's upper edge passes some steps of depth before the samples of
// a row. The floor, which the light meets at an angle of 1 : 1000, is 15 steps deeper after 1/128
// of a pixel.
TEST_F(OracleTest, SidesWithinTheirPushAreAmbiguous)
{
  constexpr double step = 200.0 / (1 << 24);
  constexpr double slope = 15.0 * 128.0 * step;
  for (const double steps : { -30.0, -17.0, 5.0, 14.0, 17.0, 22.0, 30.0 })
  {
    SCOPED_TRACE(steps);
    Stage stage = SetPixelStage(8, 30,
      [&](SceneBuilder& scene)
      {
        const Point across = { 100.0, 0.0, 0.0 };
        scene.Sheet({ -50.0, 0.0, -15.5 * slope }, across, { 0.0, 30.0, 30.0 * slope });
        const double top = 10.0 * (slope + 1e-3) + steps * step;
        scene.Sheet({ -50.0, 25.5, -1.0 }, across, { 0.0, 0.0, top + 1.0 });
        scene.Directional({ 0.0, -1.0, -slope - 1e-3 });
      });
    stage.GetRenderer()->GetActiveCamera()->SetClippingRange(1.0, 201.0);
    const OracleImage image = Cast(stage);
    for (int x = 0; x < 8; ++x)
    {
      const std::size_t i = 8 * 15 + x;
      EXPECT_EQ(image.Samples[i], steps > 0.0 ? OracleSample::Shadowed : OracleSample::Lit);
      EXPECT_EQ(image.Ambiguous[i] != 0, std::abs(steps) < 20.0);
    }
  }
}

// A cone of 45 degrees, 10 above the floor, lights a circle of radius 10.
TEST_F(OracleTest, ConeEndsTheLight)
{
  Stage stage = SetPixelStage(40, 30,
    [](SceneBuilder& scene)
    {
      scene.Floor(100.0);
      scene.Spot({ 20.0, 15.0, 10.0 }, { 20.0, 15.0, 0.0 }, 45.0);
    });
  const OracleImage image = Cast(stage);
  for (const auto& [x, y] : Pixels(40, 30))
  {
    const bool lit = std::hypot(x + 0.5 - 20.0, y + 0.5 - 15.0) < 10.0;
    EXPECT_EQ(image.Samples[y * 40 + x], lit ? OracleSample::Lit : OracleSample::Unlit)
      << x << " " << y;
  }
  // A cone of 90 degrees is none, as in VTK's shaders: what is behind the light is lit.
  stage.Lights[0]->SetFocalPoint(30.0, 15.0, 10.0);
  stage.Lights[0]->SetConeAngle(89.9);
  EXPECT_EQ(Cast(stage).Count(OracleSample::Lit), 20 * 30);
  stage.Lights[0]->SetConeAngle(90.0);
  EXPECT_EQ(Cast(stage).Count(OracleSample::Lit), 40 * 30);
}

// A sheet is lit on the side of the camera only if the light is there as well.
TEST_F(OracleTest, SheetsHaveTwoSides)
{
  for (const double z : { -1.0, 1.0 })
  {
    const OracleImage image = Cast(SetPixelStage(8, 6, MakeFloor(10.0, { 0.3, 0.2, z })));
    EXPECT_EQ(image.Count(z < 0.0 ? OracleSample::Lit : OracleSample::Unlit), 48);
  }
}

// A small floor is on a large one or above it, the light is above, and the camera is below. The
// large floor is seen; the small one is between it and the light only where the two do not
// coincide.
TEST_F(OracleTest, CoincidentSurfacesDoNotShadow)
{
  for (const double z : { 0.0, 1e-4 })
  {
    Stage stage = SetPixelStage(40, 30,
      [&](SceneBuilder& scene)
      {
        scene.Floor(100.0);
        scene.Floor(10.0, z);
        scene.Directional({ 0.1, 0.2, -1.0 });
      });
    EXPECT_EQ(Cast(stage).Count(OracleSample::Lit), 40 * 30);
    stage.GetRenderer()->GetActiveCamera()->SetPosition(20.0, 15.0, -100.0);
    const Oracle oracle(stage.GetRenderer());
    int crossed = 0;
    for (int x = 0; x < 40; ++x)
    {
      Oracle::Receiver receiver;
      ASSERT_TRUE(oracle.GetReceiver(x, 5, 0.0, 0.0, receiver));
      crossed += oracle.CountCrossings(receiver, OracleLight(stage.Lights[0]));
    }
    EXPECT_EQ(crossed, z > 0.0 ? 10 : 0);
  }
}

// A sample is in shadow if one half of the casters or the other half shadows it.
TEST_F(OracleTest, CastersCanBeChosen)
{
  Stage stage = SetNamedStage("CadDirectional");
  const OracleLight light(stage.Lights[0]);
  const OracleImage all = Oracle(stage.GetRenderer()).Cast(light);
  const std::vector<RenderedActor> actors = Oracle(stage.GetRenderer()).GetTriangles().Actors;
  std::set<vtkProp*> half;
  for (std::size_t i = 0; i < actors.size(); i += 2)
  {
    half.insert(actors[i].Prop);
  }
  const Oracle one(stage.GetRenderer(), [&](vtkProp* prop) { return half.count(prop) > 0; });
  const Oracle two(stage.GetRenderer(), [&](vtkProp* prop) { return half.count(prop) == 0; });
  const OracleImage images[2] = { one.Cast(light), two.Cast(light) };
  for (const OracleImage& image : images)
  {
    EXPECT_GT(image.Count(OracleSample::Shadowed), 100);
    EXPECT_LT(image.Count(OracleSample::Shadowed), all.Count(OracleSample::Shadowed));
  }
  int wrong = 0;
  for (std::size_t i = 0; i < all.Samples.size(); ++i)
  {
    wrong += (all.Samples[i] == OracleSample::Shadowed) !=
      (images[0].Samples[i] == OracleSample::Shadowed ||
        images[1].Samples[i] == OracleSample::Shadowed);
  }
  EXPECT_EQ(wrong, 0);
}

TEST_F(OracleTest, OnlyWhatIsDrawnAsSurfacesCounts)
{
  // Two of four actors, and two of four props.
  for (const char* name : { "NotSurfaces", "HiddenActor" })
  {
    Stage stage = SetNamedStage(name);
    EXPECT_EQ(CollectRenderedTriangles(stage.GetRenderer()).Actors.size(), 2u) << name;
  }
}

TEST_F(OracleTest, MasksAreCompared)
{
  Stage stage = SetNamedStage("Directional");
  const OracleImage image = Cast(stage);
  ShadowMask mask = MakeMask(image);
  MaskComparison comparison = CompareMask(mask, image);
  EXPECT_EQ(comparison.Shadowed, image.Count(OracleSample::Shadowed));
  EXPECT_EQ(
    comparison.Samples, image.Count(OracleSample::Lit) + image.Count(OracleSample::Shadowed));
  EXPECT_TRUE(MatchesOracle(mask, image));
  int compared[2] = { 0, 0 };
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = !mask[i];
    compared[image.Ambiguous[i] ? 1 : 0] += IsLitOrShadowed(image, i);
  }
  comparison = CompareMask(mask, image);
  EXPECT_EQ(comparison.Wrong, compared[0]);
  EXPECT_EQ(comparison.AmbiguousDiffering, compared[1]);
  EXPECT_GT(compared[1], 0);
  EXPECT_FALSE(MatchesOracle(mask, image));
  mask.pop_back();
  EXPECT_FALSE(MatchesOracle(mask, image));
}
