// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The oracle where the answer is known without it.
#include "OffscreenFixture.h"
#include "ShadowShapes.h"
#include "ShadowTest.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

using namespace ShadowShapes;

namespace
{
class OracleTest : public OffscreenFixture
{
};

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
  const glm::dvec3 ray = vtkNBufferGLM::ToVector(direction);
  const glm::dvec3 toCentre = centre - vtkNBufferGLM::ToVector(origin);
  return glm::length(glm::cross(toCentre, ray)) / glm::length(ray);
}

/// A window in which a unit of x and y is a pixel and (0, 0) the lower left corner, seen from
/// above.
NamedScene MakePixelScene(int width, int height, const std::function<void(vtkRenderer*)>& build)
{
  NamedScene scene;
  scene.Name = "Pixels";
  scene.Width = width;
  scene.Height = height;
  scene.Build = [=](vtkRenderer* renderer)
  {
    build(renderer);
    LookParallel(renderer, { 0.5 * width, 0.5 * height, 100.0 }, { 0.5 * width, 0.5 * height, 0.0 },
      0.5 * height);
  };
  return scene;
}
}

TEST_F(OracleTest, BoxAboveFloor)
{
  const Point centre = { 0.1, -0.2, 1.3 };
  const Point size = { 1.1, 0.7, 0.9 };
  for (const bool positional : { false, true })
  {
    SCOPED_TRACE(positional);
    NamedScene scene;
    scene.Build = [&](vtkRenderer* renderer)
    {
      AddFloor(renderer, 5.0);
      AddShape(renderer, ShapeKind::Box, centre, size);
      positional ? AddPoint(renderer, { -1.5, -1.0, 3.0 })
                 : AddDirectional(renderer, { 0.6, 0.35, -0.7 });
      Look(renderer, { 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
    };
    Stage stage = SetStage(scene);
    const OracleLight light(stage.Lights[0]);
    const Oracle oracle(stage.GetRenderer());
    const OracleImage image = oracle.Cast(light);
    int shadowed = 0;
    int wrong = 0;
    for (int y = 0; y < image.Height; ++y)
    {
      for (int x = 0; x < image.Width; ++x)
      {
        const std::size_t i = static_cast<std::size_t>(y) * image.Width + x;
        Oracle::Receiver receiver;
        if (!oracle.GetReceiver(x, y, 0.0, 0.0, receiver) || receiver.Normal[2] < 0.99 ||
          std::abs(receiver.Position[2]) > 0.1)
        {
          continue;
        }
        double ray[3] = { -light.Direction[0], -light.Direction[1], -light.Direction[2] };
        if (positional)
        {
          vtkMath::Subtract(light.Position, receiver.Position, ray);
        }
        const bool expected = MeetsBox(receiver.Position, ray, centre, size);
        shadowed += expected;
        wrong += expected != (image.Samples[i] == OracleSample::Shadowed) && !image.Ambiguous[i];
      }
    }
    EXPECT_GT(shadowed, 500);
    EXPECT_EQ(wrong, 0);
  }
}

TEST_F(OracleTest, SphereAboveFloor)
{
  const Point centre = { 0.1, -0.2, 1.3 };
  NamedScene scene;
  scene.Build = [&](vtkRenderer* renderer)
  {
    AddFloor(renderer, 5.0);
    AddSphere(renderer, centre, 0.8, 64);
    AddDirectional(renderer, { 0.6, 0.35, -0.7 });
    AddSpot(renderer, { -1.5, -1.0, 4.0 }, { 0.0, 0.0, 1.0 }, 80.0);
    Look(renderer, { 3.0, -6.0, 4.0 }, { 0.4, 0.2, 0.5 });
  };
  Stage stage = SetStage(scene);
  const Oracle oracle(stage.GetRenderer());
  // Facets lie between this radius and the sphere's.
  const double inner = 0.8 * std::pow(std::cos(vtkMath::Pi() / 63.0), 2.0);
  for (vtkLight* vtklight : stage.Lights)
  {
    const OracleLight light(vtklight);
    int inside = 0;
    int outside = 0;
    for (int y = 0; y < oracle.GetHeight(); ++y)
    {
      for (int x = 0; x < oracle.GetWidth(); ++x)
      {
        Oracle::Receiver receiver;
        const OracleSample sample = oracle.Classify(x, y, 0.0, 0.0, light).Sample;
        if (!oracle.GetReceiver(x, y, 0.0, 0.0, receiver) || std::abs(receiver.Position[2]) > 0.1 ||
          sample == OracleSample::Unlit)
        {
          continue;
        }
        double ray[3] = { -light.Direction[0], -light.Direction[1], -light.Direction[2] };
        if (light.Positional)
        {
          vtkMath::Subtract(light.Position, receiver.Position, ray);
        }
        const double distance = GetDistanceToRay(receiver.Position, ray, centre);
        if (distance < inner)
        {
          ++inside;
          EXPECT_EQ(sample, OracleSample::Shadowed) << x << " " << y;
          EXPECT_EQ(oracle.CountCrossings(receiver, light) % 2, 0) << x << " " << y;
        }
        else if (distance > 0.8)
        {
          ++outside;
          EXPECT_EQ(sample, OracleSample::Lit) << x << " " << y;
        }
      }
    }
    EXPECT_GT(inside, 500);
    EXPECT_GT(outside, 5000);
  }
}

// The edge of a shadow on the floor, so many pixels beside the centres of a column.
TEST_F(OracleTest, NearAnEdgeIsAmbiguous)
{
  for (const double distance : { -0.02, -0.015, -0.001, 0.001, 0.015, 0.02 })
  {
    SCOPED_TRACE(distance);
    // Light from the upper left at 45 degrees: a quad 10 above the floor shifts its shadow by 10.
    const double edge = 20.5 + distance;
    Stage stage = SetStage(MakePixelScene(40, 30,
      [&](vtkRenderer* renderer)
      {
        AddFloor(renderer, 100.0);
        AddMesh(renderer,
          MakeMesh({ { -50.0, -50.0, 10.0 }, { edge - 10.0, -50.0, 10.0 },
                     { edge - 10.0, 50.0, 10.0 }, { -50.0, 50.0, 10.0 } },
            { { 0, 1, 2, 3 } }));
        AddDirectional(renderer, { 1.0, 0.0, -1.0 });
      }));
    const OracleImage image = Cast(stage.GetRenderer(), stage.Lights[0]);
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

// Two sheets, half a pixel above each other, seen at an angle of 1 : 40 and all in shadow, so many
// pixels beside the edge of the upper one: a rasteriser may see either.
TEST_F(OracleTest, StepBetweenSheetsSeenAlmostEdgeOnIsAmbiguous)
{
  for (const double distance : { -0.02, -0.015, -0.001, 0.001, 0.015, 0.02 })
  {
    SCOPED_TRACE(distance);
    const double edge = 15.5 + distance;
    Stage stage = SetStage(MakePixelScene(40, 30,
      [&](vtkRenderer* renderer)
      {
        const auto addSheet = [&](double low, double high, double z)
        {
          AddMesh(renderer,
            MakeMesh({ { -50.0, low, z }, { 90.0, low, z }, { 90.0, high, z - 40.0 * (high - low) },
                       { -50.0, high, z - 40.0 * (high - low) } },
              { { 0, 1, 2, 3 } }));
        };
        addSheet(edge, edge + 10.0, -1000.0);
        addSheet(edge - 10.0, edge + 10.0, -1020.0 + 400.0);
        AddMesh(renderer,
          MakeMesh({ { -50.0, 500.0, 0.0 }, { 90.0, 500.0, 0.0 }, { 90.0, 500.0, -2000.0 },
                     { -50.0, 500.0, -2000.0 } },
            { { 0, 1, 2, 3 } }));
        AddDirectional(renderer, { 0.0, -1.0, 0.0 });
      }));
    const OracleImage image = Cast(stage.GetRenderer(), stage.Lights[0]);
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
    Stage stage = SetStage(MakePixelScene(8, 6,
      [&](vtkRenderer* renderer)
      {
        AddFloor(renderer, 10.0);
        AddDirectional(renderer, { 1.0, 0.0, -slope });
      }));
    const OracleImage image = Cast(stage.GetRenderer(), stage.Lights[0]);
    EXPECT_EQ(image.Count(slope > 0.0 ? OracleSample::Lit : OracleSample::Unlit), 48);
    EXPECT_EQ(image.CountAmbiguous(), std::abs(slope) < 1e-4 ? 48 : 0);
  }
}

// A cone of 45 degrees, 10 above the floor: a circle of radius 10.
TEST_F(OracleTest, ConeEndsTheLight)
{
  Stage stage = SetStage(MakePixelScene(40, 30,
    [](vtkRenderer* renderer)
    {
      AddFloor(renderer, 100.0);
      AddSpot(renderer, { 20.0, 15.0, 10.0 }, { 20.0, 15.0, 0.0 }, 45.0);
    }));
  const OracleImage image = Cast(stage.GetRenderer(), stage.Lights[0]);
  for (int y = 0; y < 30; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      const bool lit = std::hypot(x + 0.5 - 20.0, y + 0.5 - 15.0) < 10.0;
      EXPECT_EQ(image.Samples[y * 40 + x], lit ? OracleSample::Lit : OracleSample::Unlit)
        << x << " " << y;
    }
  }
  // A cone of 90 degrees is none, as in VTK's shaders: what is behind the light is lit.
  stage.Lights[0]->SetFocalPoint(30.0, 15.0, 10.0);
  stage.Lights[0]->SetConeAngle(89.9);
  EXPECT_EQ(Cast(stage.GetRenderer(), stage.Lights[0]).Count(OracleSample::Lit), 20 * 30);
  stage.Lights[0]->SetConeAngle(90.0);
  EXPECT_EQ(Cast(stage.GetRenderer(), stage.Lights[0]).Count(OracleSample::Lit), 40 * 30);
}

// A sheet is lit on the side of the camera only if the light is there as well.
TEST_F(OracleTest, SheetsHaveTwoSides)
{
  for (const double z : { -1.0, 1.0 })
  {
    Stage stage = SetStage(MakePixelScene(8, 6,
      [&](vtkRenderer* renderer)
      {
        AddFloor(renderer, 10.0);
        AddDirectional(renderer, { 0.3, 0.2, z });
      }));
    const OracleImage image = Cast(stage.GetRenderer(), stage.Lights[0]);
    EXPECT_EQ(image.Count(z < 0.0 ? OracleSample::Lit : OracleSample::Unlit), 48);
  }
}

// A small floor on or above a large one, the light from above, the camera below: seen is the large
// one, and the small one is between it and the light only where it does not coincide.
TEST_F(OracleTest, CoincidentSurfacesDoNotShadow)
{
  for (const double z : { 0.0, 1e-4 })
  {
    Stage stage = SetStage(MakePixelScene(40, 30,
      [&](vtkRenderer* renderer)
      {
        AddFloor(renderer, 100.0);
        AddFloor(renderer, 10.0, z);
        AddDirectional(renderer, { 0.1, 0.2, -1.0 });
      }));
    EXPECT_EQ(Cast(stage.GetRenderer(), stage.Lights[0]).Count(OracleSample::Lit), 40 * 30);
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

// In shadow is what one or the other half of the casters shadows.
TEST_F(OracleTest, CastersCanBeChosen)
{
  Stage stage = SetStage(GetScene("CadDirectional"));
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
    Stage stage = SetStage(GetScene(name));
    EXPECT_EQ(CollectRenderedTriangles(stage.GetRenderer()).Actors.size(), 2u) << name;
  }
}

TEST_F(OracleTest, MasksAreCompared)
{
  Stage stage = SetStage(GetScene("Directional"));
  const OracleImage image = Cast(stage.GetRenderer(), stage.Lights[0]);
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
    const bool counts =
      image.Samples[i] == OracleSample::Lit || image.Samples[i] == OracleSample::Shadowed;
    compared[image.Ambiguous[i] ? 1 : 0] += counts;
  }
  comparison = CompareMask(mask, image);
  EXPECT_EQ(comparison.Wrong, compared[0]);
  EXPECT_EQ(comparison.AmbiguousDiffering, compared[1]);
  EXPECT_GT(compared[1], 0);
  EXPECT_FALSE(MatchesOracle(mask, image));
  mask.pop_back();
  EXPECT_FALSE(MatchesOracle(mask, image));
}
