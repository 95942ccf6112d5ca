// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The culler with vtkShadowVolumeClampPass: hidden props are not drawn, and cast shadows.
#include "CullerTest.h"
#include "LargeProps.h"
#include "LightRig.h"
#include "ScenePasses.h"
#include "Scenes.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>

using Scenes::Wall;

namespace
{
/// With one light, there.
vtkShadowVolumeClampPass* AddShadows(Stage& stage, const glm::dvec3& position = { -8.0, 9.0, 14.0 })
{
  stage.GetRenderer()->RemoveAllLights();
  stage.GetRenderer()->SetAutomaticLightCreation(false);
  stage.GetRenderer()->AddLight(
    TestScene::MakeLight(TestScene::SceneBuilder().Directional(-position)));
  vtkNew<vtkShadowVolumeClampPass> pass;
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  stage.GetRenderer()->SetPass(pass);
  return pass;
}

vtkShadowVolumeClampPass* GetPass(const Stage& stage)
{
  return vtkShadowVolumeClampPass::SafeDownCast(stage.GetRenderer()->GetPass());
}

/// Shadowed samples of the first light; the masks of both stages have to be equal.
int CompareMasks(const Comparison& comparison)
{
  std::vector<unsigned char> masks[2];
  for (const Stage* stage : { &comparison.Reference, &comparison.Culled })
  {
    int width = 0;
    int height = 0;
    auto* light = vtkLight::SafeDownCast(stage->GetRenderer()->GetLights()->GetItemAsObject(0));
    stage->Window->MakeCurrent();
    masks[stage == &comparison.Culled] = GetPass(*stage)->GetMask(light, width, height);
  }
  EXPECT_TRUE(masks[0] == masks[1]);
  return static_cast<int>(std::count(masks[1].begin(), masks[1].end(), 255));
}
}

// Hazard: the pass draws all props twice. The culler tests them in the first draw, which is for the
// depth of the receivers; the second one, for colour, must have the same props in the same order.
TEST(CullerShadows, HiddenPropsCastAndAreNotDrawn)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      AddShadows(stage);
    });
  for (int i = 0; i < 6; ++i)
  {
    Scenes::FrameOfWall(comparison, i < 3 ? 0.2 * i : 4.0 * i, "moved");
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
    const vtkShadowStatistics& shadows = GetPass(comparison.Culled)->GetStatistics();
    EXPECT_EQ(shadows.Decision, vtkShadowDecision::Drawn);
    EXPECT_EQ(shadows.Casters, Wall::Count);
    EXPECT_GT(CompareMasks(comparison), 0);
  }
}

TEST(CullerShadows, MasksOfAStillFrameStand)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      AddShadows(stage);
    });
  // What the test found hidden is left out of the list in the second frame.
  comparison.Frame("first");
  comparison.Frame("second");
  comparison.Frame("third");
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  EXPECT_EQ(GetPass(comparison.Culled)->GetStatistics().Decision, vtkShadowDecision::Still);
  // A caster that the camera does not see moves.
  comparison.Frame("hidden caster moved",
    [](Stage& stage) { stage.GetActor(Wall::FirstBehind)->SetPosition(0, 0, -0.1); });
  EXPECT_EQ(comparison.GetVerdict(Wall::FirstBehind), Verdict::Hidden);
  EXPECT_EQ(GetPass(comparison.Culled)->GetStatistics().Decision, vtkShadowDecision::Drawn);
  EXPECT_EQ(GetPass(comparison.Culled)->GetStatistics().Updates, 1);
}

// Hazard: the shadow of a hidden caster is seen, and the caster must not be missing in the shadows.
TEST(CullerShadows, ShadowOfAHiddenPropIsSeen)
{
  Comparison comparison(
    [](Stage& stage)
    {
      // A wall before the camera, a tower behind it, and ground beside the wall.
      Scenes::AddBox(stage, 0.0, 0.0, 0.0, 8.0, 6.0, 0.2);
      Scenes::AddBox(stage, 0.0, -3.2, 0.0, 60.0, 0.2, 60.0);
      for (int i = 0; i < 40; ++i)
      {
        Scenes::AddBox(stage, 0.1 * (i % 8) - 0.4, -1.0, -3.0 - 0.3 * i, 0.3, 4.0, 0.2);
      }
      Scenes::SetWallCamera(stage.GetRenderer());
      AddShadows(stage, { -14.0, 3.0, -3.0 });
    });
  Scenes::FrameOfWall(comparison, 0.01);
  EXPECT_GE(comparison.GetHidden(), 28);
  const int shadowed = CompareMasks(comparison);
  // Without the hidden ones the ground beside the wall is lit.
  comparison.Frame("without casters",
    [](Stage& stage)
    {
      for (int i = 2; i < 42; ++i)
      {
        stage.Props[i]->VisibilityOff();
      }
    });
  EXPECT_LT(CompareMasks(comparison), shadowed);
}

TEST(CullerShadows, CityWalkInEveryMode)
{
  for (int mode : { vtkShadowVolumeClampPass::Unclamped, vtkShadowVolumeClampPass::Scissored,
         vtkShadowVolumeClampPass::Clamped })
  {
    SCOPED_TRACE(mode);
    Comparison comparison(
      [mode](Stage& stage)
      {
        Scenes::BuildCity(stage, 10);
        AddShadows(stage)->SetMode(mode);
        stage.GetRenderer()->AddLight(TestScene::MakeLight(
          TestScene::SceneBuilder().Spot({ 20.0, 30.0, 10.0 }, glm::dvec3(0.0), 60.0)));
        for (int i = 5; i < 100; i += 9)
        {
          stage.GetActor(i)->GetProperty()->SetOpacity(0.5);
        }
      });
    for (int i = 0; i < 5; ++i)
    {
      Scenes::FrameOfCity(comparison, 0.05 * i);
      EXPECT_GT(comparison.GetHidden(), 10);
      CompareMasks(comparison);
    }
  }
}

// Hazard: equal depths, whose order has to be that of the renderer in both drawings.
TEST(CullerShadows, Ties)
{
  ComparisonOptions options;
  options.CompareDraws = false;
  int redrawn = 0;
  for (unsigned int seed = 0; seed < 6; ++seed)
  {
    redrawn += Scenes::MoveTheDoorBeforeTies(
      seed, 6, [](Stage& stage) { AddShadows(stage); }, options);
  }
  EXPECT_GT(redrawn, 0);
}

// Hazard: the samples that are shown are not those that were tested, and see past the silhouettes
// that hide a prop.
TEST(CullerShadows, MultiSamples)
{
  ComparisonOptions options;
  options.MultiSamples = 4;
  options.CompareDepth = false;
  options.CompareDraws = false;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildCity(stage, 10);
      AddShadows(stage);
    },
    options);
  for (int i = 0; i < 5; ++i)
  {
    Scenes::FrameOfCity(comparison, 0.05 * i);
    EXPECT_EQ(comparison.GetStatistics().FailedFrames, 0);
  }
}

// Hazard: the opaque blocks of a translucent prop are drawn once more for the order of equal
// depths, and the shader for shadows is missing then.
TEST(CullerShadows, OpaqueBlocksOfTranslucentPropsAreRedrawnInShadow)
{
  ComparisonOptions options;
  options.Tuning.RoundSize = 1;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      AddShadows(stage);
      Scenes::AddBox(stage, -2.8, 3.1, 7.5, 2.0, 2.0, 0.2);
      vtkNew<vtkSphereSource> spheres[2];
      for (int i = 0; i < 2; ++i)
      {
        spheres[i]->SetCenter(3.0 * i - 1.5, 0.0, 4.0);
        spheres[i]->SetRadius(1.4);
        spheres[i]->Update();
      }
      stage.Add(Scenes::MakeTwoBlocks(spheres[0]->GetOutput(), spheres[1]->GetOutput(), 0.5));
      Scenes::SetWallCamera(stage.GetRenderer());
    },
    options);
  const int last = static_cast<int>(comparison.Culled.Props.size()) - 1;
  int redrawn = 0;
  for (int i = 0; i < 3; ++i)
  {
    Scenes::FrameOfWall(comparison, 0.2 * i);
    EXPECT_EQ(comparison.GetVerdict(last), Verdict::Translucent);
    EXPECT_GT(CompareMasks(comparison), 500);
    redrawn += comparison.GetStatistics().Redrawn;
  }
  EXPECT_GT(redrawn, 0);
}

TEST(CullerShadows, PassInASequenceAndInAPartOfTheWindow)
{
  Comparison comparison(
    [](Stage& stage)
    {
      stage.GetRenderer()->SetViewport(0.31, 0.17, 0.93, 0.99);
      Scenes::BuildWall(stage);
      stage.GetRenderer()->SetPass(
        TestScene::MakePass(TestScene::PassKind::ShadowVolumesInSequence, AddShadows(stage)));
    });
  Scenes::ExpectFramesOfWall(comparison, { 0.0, 0.2, 0.4, 0.6 }, Wall::Behind / 3 + 1);
}

namespace
{
constexpr double FarOffset = 3000.0; // Pushes the wall behind some of the boxes, but not all.

/// The same sphere, opaque and translucent, behind the wall.
void AddSpheresBehind(Stage& stage)
{
  for (const double x : { -2.0, 2.0 })
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(x, 0.0, -1.5);
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(24);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(x < 0.0 ? 1.0 : 0.5);
    stage.Add(actor);
  }
}
}

// Hazard: the first drawing leaves out polygon offsets, so that volumes begin in the surfaces. In
// the second one the wall is farther, and no longer hides what the first one has found hidden.
TEST(CullerShadows, OffsetsUncoverProps)
{
  for (const bool divides : { false, true })
  {
    SCOPED_TRACE(divides ? "divided" : "whole");
    ComparisonOptions options = divides ? LargeProps::MakeOptions() : ComparisonOptions();
    options.CompareDraws = false;
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    Comparison comparison(
      [](Stage& stage)
      {
        Scenes::BuildWall(stage);
        AddShadows(stage);
        stage.GetActor(Wall::Index)
          ->GetMapper()
          ->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, FarOffset);
        AddSpheresBehind(stage);
        Scenes::SetWallCamera(stage.GetRenderer());
      },
      options);
    for (int i = 0; i < 6; ++i)
    {
      Scenes::FrameOfWall(comparison, i < 3 ? 0.2 * i : 4.0 * i, "moved");
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      EXPECT_NE(comparison.GetVerdict(Wall::Count), Verdict::Hidden);
      EXPECT_EQ(comparison.GetVerdict(Wall::Count + 1), Verdict::Translucent);
      EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
    }
    vtkMapper::SetResolveCoincidentTopologyToDefault();
  }
}
