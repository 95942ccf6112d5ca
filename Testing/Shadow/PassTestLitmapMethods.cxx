// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// The paper's litmap compared with the scattered one where both find all receivers.
#include "LightRig.h"
#include "PassTestTools.h"
#include "RerenderedLitmap.h"
#include "Tune.h"

#include "vtkActor.h"

#include <functional>
#include <string>
#include <utility>

namespace
{
/// A floor and a low box that receive, a box in the air; the receivers face light and camera.
void AddLargeReceivers(SceneBuilder& scene)
{
  scene.Floor(5.0);
  scene.Box({ 1.0, 0.0, 0.2 }, { 2.0, 2.0, 0.4 });
  scene.Box({ 0.0, 0.0, 1.5 }, { 0.8, 0.8, 0.8 });
  scene.Look({ 0.5, -3.0, 7.0 }, { 0.3, 0.0, 0.0 }, 30.0);
}

std::shared_ptr<vtkShadowLitmapSource> MakePaperLitmap()
{
  return std::make_shared<NBufferPeers::RerenderedLitmap>();
}

constexpr int Modes[] = { vtkShadowVolumeClampPass::Scissored, vtkShadowVolumeClampPass::Clamped };
}

using PassLitmapMethods = OffscreenFixture;

// Every receiver covers many lexels, and every pixel covers several.
TEST_F(PassLitmapMethods, AgreeOnLargeReceivers)
{
  const std::function<void(SceneBuilder&)> lights[] = {
    [](SceneBuilder& scene) {
      scene.Directional({ 0.3, 0.2, -1.0 });
    },
    [](SceneBuilder& scene) {
      scene.Spot({ -1.0, -1.0, 6.0 }, { 0.3, 0.0, 0.0 }, 30.0);
    },
    [](SceneBuilder& scene) {
      scene.PointLight({ -1.0, -1.0, 6.0 });
    },
  };
  for (const auto& addLight : lights)
  {
    const Stage stage = SetStage(
      [&addLight](SceneBuilder& scene)
      {
        AddLargeReceivers(scene);
        addLight(scene);
      },
      80, 60);
    SCOPED_TRACE(&addLight - lights);
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    Tune(pass, &vtkShadowTuning::LitmapResolution, 512);
    for (const int mode : Modes)
    {
      SCOPED_TRACE("mode " + std::to_string(mode));
      pass->SetMode(mode);
      Tune(pass, &vtkShadowTuning::LitmapSource, nullptr);
      ExpectMatchesOracle(stage, pass);
      const ShadowMask scattered = GetMask(stage, pass);
      EXPECT_GT(CountShadowed(scattered), 50);
      const vtkShadowStatistics before = pass->GetStatistics();
      Tune(pass, &vtkShadowTuning::LitmapSource, MakePaperLitmap());
      stage.Window->Render();
      // Litmaps that are drawn again from the light are not conservative
      // (GpuTestRerenderedLitmap.MissesWhatScatteringFinds). On an NVIDIA H100 one sample is lost
      // here.
      const ShadowMask drawn = GetMask(stage, pass);
      int differing = 0;
      for (std::size_t i = 0; i < drawn.size(); ++i)
      {
        differing += drawn[i] != scattered[i];
      }
      EXPECT_LE(differing, 2);
      EXPECT_EQ(pass->GetStatistics().Litmaps, before.Litmaps);
      EXPECT_EQ(pass->GetStatistics().Verdicts, before.Verdicts);
      EXPECT_EQ(pass->GetStatistics().FailedFrames, 0);
    }
  }
}

// Props that do not cast are drawn into litmaps, too.
TEST_F(PassLitmapMethods, ReceiversNeedNotCast)
{
  const Stage stage = SetStage(
    [](SceneBuilder& scene)
    {
      scene.Floor(5.0);
      scene.Box({ 0.0, 0.0, 1.5 }, { 0.8, 0.8, 0.8 });
      scene.Directional({ 0.3, 0.2, -1.0 });
      scene.Look({ 0.5, -3.0, 7.0 }, { 0.3, 0.0, 0.0 }, 30.0);
    },
    80, 60);
  TestScene::LightRig::SetCasts(GetActors(stage.GetRenderer()).back(), true);
  vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
  pass->SetCasterKeys(TestScene::LightRig::MakeCasterKeys());
  Tune(pass, &vtkShadowTuning::LitmapSource, MakePaperLitmap());
  Tune(pass, &vtkShadowTuning::LitmapResolution, 512);
  stage.Window->Render();
  const ShadowMask rerendered = GetMask(stage, pass);
  EXPECT_GT(CountShadowed(rerendered), 50);
  Tune(pass, &vtkShadowTuning::LitmapSource, nullptr);
  stage.Window->Render();
  EXPECT_EQ(GetMask(stage, pass), rerendered);
}

// The objects by which receivers are drawn are deleted with the litmap source. (Programs stay in
// the window's cache.)
TEST_F(PassLitmapMethods, RerenderedLeavesNoObjectsBehind)
{
  const Stage stage = SetNamedStage("ManyLights");
  const auto count = [&stage](vtkShadowVolumeClampPass* pass)
  {
    stage.GetRenderer()->SetPass(pass);
    stage.Window->Render();
    return CountObjectsWithoutPrograms(stage);
  };
  const auto countAfter = [&](const std::shared_ptr<vtkShadowLitmapSource>& source)
  {
    vtkSmartPointer<vtkShadowVolumeClampPass> pass = AddPass(stage);
    Tune(pass, &vtkShadowTuning::LitmapSource, source);
    const GLObjects::Counts during = count(pass);
    pass = nullptr;
    return std::make_pair(during, count(nullptr));
  };
  const auto scattered = countAfter(nullptr);
  const auto rerendered = countAfter(MakePaperLitmap());
  EXPECT_NE(rerendered.first, scattered.first) << "it has objects of its own";
  EXPECT_EQ(rerendered.second, scattered.second);
}
