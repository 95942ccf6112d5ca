// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Windows, renderers and lifetimes.
#include "OffscreenFixture.h"
#include "PassTestTools.h"

#include "vtkNBufferCuller.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

class PassWindows : public OffscreenFixture
{
};

namespace
{
/// Another renderer of the window with a scene of the list.
Stage AddRenderer(const Stage& stage, const std::string& scene, const double viewport[4])
{
  Stage result = stage;
  result.Renderers.clear();
  result.AddRenderer(viewport[0], viewport[1], viewport[2], viewport[3])
    ->SetAutomaticLightCreation(0);
  GetScene(scene).Build(result.GetRenderer());
  result.Lights = { vtkLight::SafeDownCast(result.GetRenderer()->GetLights()->GetItemAsObject(0)) };
  return result;
}

Stage MakeStage(const std::string& scene = "ManyLights")
{
  return SetStage(GetScene(scene));
}
}

// Odd corners and sizes; one pass for each renderer.
TEST_F(PassWindows, TwoRenderers)
{
  Stage left = MakeStage("Directional");
  left.Window->SetSize(307, 211);
  left.GetRenderer()->SetViewport(0.05, 0.3, 0.45, 0.95);
  const double viewport[4] = { 0.5, 0.1, 0.97, 0.7 };
  const Stage right = AddRenderer(left, "Spot", viewport);
  for (int mode = vtkShadowVolumeClampPass::Unclamped; mode <= vtkShadowVolumeClampPass::Clamped;
       ++mode)
  {
    SCOPED_TRACE("mode " + std::to_string(mode));
    vtkSmartPointer<vtkShadowVolumeClampPass> leftPass = AddPass(left);
    vtkSmartPointer<vtkShadowVolumeClampPass> rightPass = AddPass(right);
    leftPass->SetMode(mode);
    rightPass->SetMode(mode);
    ExpectMatchesOracle(left, leftPass);
    ExpectMatchesOracle(right, rightPass);
    EXPECT_GT(ExpectComposedOfDimmed(left, leftPass), 100);
    EXPECT_GT(ExpectComposedOfDimmed(right, rightPass), 100);
  }
}

// VTK's own passes take no notice of stereo until a frame was drawn without a pass.
TEST_F(PassWindows, EyesOfStereo)
{
  const auto draw = [](int type, bool plainFrameBefore)
  {
    Stage stage = MakeStage();
    stage.Window->SetSize(301, 211);
    stage.GetRenderer()->SetViewport(0.1, 0.0, 0.9, 0.8);
    stage.Window->SetStereoType(type);
    stage.Window->SetStereoRender(1);
    if (plainFrameBefore)
    {
      stage.Window->Render();
    }
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    stage.Window->Render();
    const Picture image = TakePicture(stage.Window);
    EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::Drawn);
    for (vtkLight* light : stage.Lights)
    {
      const ShadowMask mask = GetMask(pass, light, CountPixels(stage.GetRenderer()));
      EXPECT_TRUE(MatchesOracle(mask, Oracle(stage.GetRenderer()).Cast(OracleLight(light))));
    }
    EXPECT_EQ(FindDifference(image, (stage.Window->Render(), TakePicture(stage.Window))), "");
    return image;
  };
  const Picture left = draw(VTK_STEREO_LEFT, false);
  const Picture right = draw(VTK_STEREO_RIGHT, false);
  EXPECT_NE(FindDifference(left, right), "");
  EXPECT_EQ(FindDifference(left, draw(VTK_STEREO_LEFT, true)), "");
  EXPECT_EQ(FindDifference(right, draw(VTK_STEREO_RIGHT, true)), "");
}

// Renderers of one window that share a pass see their own shadows.
TEST_F(PassWindows, OnePassForTwoRenderers)
{
  Stage left = MakeStage("Directional");
  left.Window->SetSize(307, 211);
  left.GetRenderer()->SetViewport(0.05, 0.3, 0.45, 0.95);
  const double viewport[4] = { 0.5, 0.1, 0.97, 0.7 };
  const Stage right = AddRenderer(left, "ManyLights", viewport);
  vtkSmartPointer<vtkShadowVolumeClampPass> leftPass = AddPass(left);
  vtkSmartPointer<vtkShadowVolumeClampPass> rightPass = AddPass(right);
  left.Window->Render();
  const Picture expected = TakePicture(left.Window);
  vtkSmartPointer<vtkShadowVolumeClampPass> shared = AddPass(left);
  right.GetRenderer()->SetPass(shared);
  for (int frame = 0; frame < 3; ++frame)
  {
    left.Window->Render();
    EXPECT_EQ(FindDifference(expected, TakePicture(left.Window)), "") << "frame " << frame;
  }
}

// A pass and actors that wander between windows.
TEST_F(PassWindows, OnePassForTwoWindows)
{
  std::array<Stage, 2> stages = { MakeStage("Directional"), MakeStage("Spot") };
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stages[0]);
  stages[1].GetRenderer()->SetPass(pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    for (const Stage& stage : stages)
    {
      ExpectMatchesOracle(stage, pass);
      EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    }
  }
  for (Stage& stage : stages)
  {
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
  }
  stages[0].Renderers.clear();
  stages[0].Window = nullptr;
  ExpectMatchesOracle(stages[1], pass);
}

TEST_F(PassWindows, Resizing)
{
  Stage stage = MakeStage("Directional");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (const auto& [width, height] : std::initializer_list<std::pair<int, int>>{
         { 200, 150 }, { 97, 203 }, { 333, 55 }, { 1, 1 }, { 201, 151 }, { 2, 120 }, { 64, 64 } })
  {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    stage.Window->SetSize(width, height);
    ExpectMatchesOracle(stage, pass);
    ExpectComposedOfDimmed(stage, pass);
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
  }
}

TEST_F(PassWindows, MultiSamplesOnAndOff)
{
  Stage stage = MakeStage("Spot");
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (int samples : { 4, 0, 2, 4 })
  {
    SCOPED_TRACE(std::to_string(samples) + " samples");
    stage.Window->SetMultiSamples(samples);
    ExpectMatchesOracle(stage, pass);
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
  }
}

// At the edges of surfaces a pixel may have samples in which nothing is seen: what volumes count
// there, where Scissored leaves out casters, is in no mask.
TEST_F(PassWindows, MultiSamplesBesideReceivers)
{
  const Stage stage = MakeStage("ManyLights");
  stage.GetRenderer()->GetActiveCamera()->Zoom(0.3);
  stage.Window->SetMultiSamples(4);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetMode(vtkShadowVolumeClampPass::Unclamped);
  stage.Window->Render();
  const Picture expected = TakePicture(stage.Window);
  std::vector<ShadowMask> masks;
  for (vtkLight* light : stage.Lights)
  {
    masks.push_back(GetMask(pass, light, CountPixels(stage.GetRenderer())));
  }
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  stage.Window->Render();
  EXPECT_EQ(FindDifference(expected, TakePicture(stage.Window)), "");
  for (std::size_t i = 0; i < masks.size(); ++i)
  {
    EXPECT_EQ(
      std::count(masks[i].begin(), masks[i].end(), 255) > 0, pass->GetLightCasts(stage.Lights[i]));
    EXPECT_TRUE(GetMask(pass, stage.Lights[i], masks[i].size()) == masks[i]) << "light " << i;
  }
}

// From inside a closed caster its own inside is seen, which is in shadow; and it may be seen
// through what the near plane cuts away.
TEST_F(PassWindows, CameraInsideAClosedCaster)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(3.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const Stage stage = MakeStage("Directional");
  stage.GetRenderer()->AddActor(actor);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  vtkCamera* camera = stage.GetRenderer()->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  for (const auto& [distance, nearest] :
    std::initializer_list<std::pair<double, double>>{ { 1.0, 0.1 }, { 5.0, 3.0 }, { 5.0, 0.1 } })
  {
    camera->SetPosition(distance, 0.1 * distance, 0.2 * distance);
    camera->SetClippingRange(nearest, 100.0);
    for (int mode = vtkShadowVolumeClampPass::Unclamped; mode <= vtkShadowVolumeClampPass::Clamped;
         ++mode)
    {
      SCOPED_TRACE("mode " + std::to_string(mode) + ", distance " + std::to_string(distance));
      pass->SetMode(mode);
      ExpectMatchesOracle(stage, pass);
    }
  }
}

// Edges (before VTK 9.2) and cell colours come out of buffer textures, whose samplers must not
// share a unit with those of the masks.
TEST_F(PassWindows, BufferTextures)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.8);
  sphere->Update();
  vtkPolyData* data = sphere->GetOutput();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    colors->InsertNextTuple3(255.0, static_cast<double>(i % 256), 0.0);
  }
  data->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const Stage stage = MakeStage("Directional");
  stage.GetRenderer()->AddActor(actor);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  for (int frame = 0; frame < 3; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame));
    stage.GetRenderer()->GetActiveCamera()->Azimuth(5.0);
    actor->GetProperty()->EdgeVisibilityOff();
    ExpectMatchesOracle(stage, pass);
    const long long receivers = pass->GetStatistics().Receivers;
    EXPECT_GT(receivers, 1000);
    // Older VTK draws edges as lines, which reach beyond the surface: rays do not know them.
    actor->GetProperty()->EdgeVisibilityOn();
    stage.Window->Render();
    EXPECT_GE(pass->GetStatistics().Receivers, receivers);
  }
}

// The culler and the pass: what is hidden from the camera casts all the same.
TEST_F(PassWindows, WithTheCuller)
{
  for (const char* name : { "CityDirectional", "ManyLights" })
  {
    SCOPED_TRACE(name);
    const Stage stage = MakeStage(name);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    stage.Window->Render();
    stage.Window->Render();
    const Picture expected = TakePicture(stage.Window);
    vtkNew<vtkNBufferCuller> culler;
    stage.GetRenderer()->AddCuller(culler);
    for (int frame = 0; frame < 3; ++frame)
    {
      SCOPED_TRACE("frame " + std::to_string(frame));
      stage.GetRenderer()->GetActiveCamera()->Modified();
      stage.Window->Render();
      EXPECT_EQ(FindDifference(expected, TakePicture(stage.Window)), "");
      ExpectMatchesOracle(stage, pass);
    }
  }
}

//------------------------------------------------------------------------------------------------
class PassLifetime : public OffscreenFixture
{
};

TEST_F(PassLifetime, PassBeforeWindow)
{
  const Stage stage = MakeStage();
  {
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    stage.Window->Render();
    stage.GetRenderer()->SetPass(nullptr);
  }
  stage.Window->Render();
}

TEST_F(PassLifetime, WindowBeforePass)
{
  vtkSmartPointer<vtkShadowVolumeClampPass> pass;
  std::array<ShadowMask, 2> masks;
  for (ShadowMask& mask : masks)
  {
    const Stage stage = MakeStage();
    pass = pass ? pass : AddPass(stage);
    stage.GetRenderer()->SetPass(pass);
    stage.Window->Render();
    mask = GetMask(pass, stage.Lights[0], CountPixels(stage.GetRenderer()));
  }
  EXPECT_TRUE(masks[0] == masks[1]);
  EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
}

TEST_F(PassLifetime, NeverRendered)
{
  vtkNew<vtkShadowVolumeClampPass> pass;
  pass->SetMode(vtkShadowVolumeClampPass::Scissored);
  EXPECT_EQ(pass->GetStatistics().Decision, vtkShadowDecision::None);
  int width = -1;
  int height = -1;
  EXPECT_TRUE(pass->GetMask(nullptr, width, height).empty());
  EXPECT_EQ(width, 0);
  EXPECT_EQ(height, 0);
  pass->ReleaseGraphicsResources(nullptr);
}

// Hazard: objects of a context that is gone.
TEST_F(PassLifetime, ReleasedAndDrawnAgain)
{
  const Stage stage = MakeStage();
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  stage.Window->Render();
  const Picture expected = TakePicture(stage.Window);
  const std::function<void()> releases[] = { [&] { pass->ReleaseGraphicsResources(stage.Window); },
    [&] { stage.GetRenderer()->ReleaseGraphicsResources(stage.Window); },
    [&] { stage.Window->Finalize(); },
    [&]
    {
      pass->ReleaseGraphicsResources(stage.Window);
      pass->ReleaseGraphicsResources(stage.Window);
      stage.Window->Finalize();
    } };
  for (const std::function<void()>& release : releases)
  {
    release();
    stage.Window->Render();
    EXPECT_EQ(FindDifference(expected, TakePicture(stage.Window)), "");
    EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    EXPECT_GT(ExpectComposedOfDimmed(stage, pass), 100);
  }
}
