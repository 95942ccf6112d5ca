// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Spots: what VTK's shader finds in their cones must have its shadow, wherever litmaps find it.
#include "PassTestTools.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkProperty.h"

using PassCones = OffscreenFixture;

namespace
{
void ExpectSame(const Stage& stage)
{
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (const double cone : { 10.0, 15.0, 20.0, 25.0, 30.0 })
  {
    SCOPED_TRACE(cone);
    stage.Lights[0]->SetConeAngle(cone);
    pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
    const Picture expected = RenderPicture(stage);
    EXPECT_NE(FindDifference(GetPlainImage(stage.Window, stage.GetRenderer()), expected), "");
    pass->SetMode(vtkShadowVolumeClampPass::Scissored);
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
  }
}
}

// Where large coordinates are not shifted, VTK's shader ends a cone at another place. What the
// shader finds in the cone must have its shadow.
TEST_F(PassCones, OfVerticesFarFromTheOrigin)
{
  constexpr double x = 5e6;
  constexpr double y = 4.5e6;
  ExpectSame(SetStage(
    [=](SceneBuilder& scene)
    {
      scene.Box({ x, y, -0.5 }, { 60.0, 60.0, 1.0 }).ShiftCoordinates = false;
      scene.Box({ x + 5.0, y, 7.0 }, { 10.0, 20.0, 2.0 }).ShiftCoordinates = false;
      scene.Spot({ x, y, 20.0 }, { x, y, 0.0 }, 15.0);
      scene.Look({ x + 3.0, y - 60.0, 40.0 }, { x, y, 0.0 });
    },
    400, 300));
}

// A floor with edges is drawn before a box that hides it, because its depth is offset. The depth of
// receivers has no offset, so the mask there is that of the box, which is outside of the cone.
TEST_F(PassCones, OnSurfacesWhoseDepthIsOffset)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Box({ 0.0, 0.0, -0.5 }, { 60.0, 60.0, 1.0 });
      scene.Box({ 1.0, 0.0, 15.0 }, { 2.0, 16.0, 1.0 });
      scene.Box({ 2.0, -12.0, 3.5 }, { 4.0, 0.5, 7.0 });
      scene.Spot({ 0.0, 0.0, 20.0 }, { 0.0, 0.0, 0.0 }, 15.0);
      scene.Look({ 3.0, -60.0, 40.0 }, { 0.0, 0.0, 0.0 });
    },
    400, 300);
  vtkActor* floor = GetActors(stage.GetRenderer())[0];
  floor->GetProperty()->EdgeVisibilityOn();
  floor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -3000.0);
  ExpectSame(stage);
}

// Hazard: VTK's shader compares the cosine of the cone's angle, which may be negative.
TEST_F(PassCones, NegativeOnesAreAsWideAsPositiveOnes)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(5.0);
      scene.Box({ 0.0, 0.0, 1.0 }, { 0.6, 0.6, 0.6 });
      scene.Spot({ 0.0, 0.0, 9.0 }, { 0.0, 0.0, 0.0 }, 20.0);
      scene.Look({ 0.0, -8.0, 6.0 }, { 0.0, 0.0, 0.0 });
    },
    200, 150);
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  const Picture expected = RenderPicture(stage);
  EXPECT_NE(FindDifference(GetPlainImage(stage.Window, stage.GetRenderer()), expected), "");
  stage.Lights[0]->SetConeAngle(-stage.Lights[0]->GetConeAngle());
  for (const int mode :
    { vtkShadowVolumeClampPass::Automatic, vtkShadowVolumeClampPass::Scissored })
  {
    AddPass(stage)->SetMode(mode);
    EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
  }
}

// Hazard: through a prop that blends, surfaces in the cone are seen behind a nearest one that is
// not in the cone, and thus is no receiver.
TEST_F(PassCones, BehindPropsThatBlend)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      TestScene::Prop& box = scene.Box({ 1.0, 1.0, 0.8 }, { 4.0, 0.5, 4.0 });
      box.ForceOpaque = true;
      box.Opacity = 0.5;
      scene.Spot({ -4.0, 1.1, -6.2 }, { 0.0, 0.0, 0.0 }, 10.0);
      scene.Look({ 7.8, 5.9, 3.9 }, { 0.0, 0.0, 0.0 });
    },
    120, 64);
  const vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
  const Picture expected = RenderPicture(stage);
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  EXPECT_EQ(FindDifference(expected, RenderPicture(stage)), "");
}
