// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's render passes and settings of renderers together with ties, parts of the window, cities,
// numbers of samples and peels, and changes of passes between frames.
#include "CullerTest.h"
#include "ScenePasses.h"
#include "Scenes.h"

#include "vtkNBufferGL.h"
#include "vtkNBufferRenderPassTraits.h"

#include "vtkCameraPass.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSequencePass.h"

#include <vtksys/SystemTools.hxx>

using Scenes::Wall;

// Hazard: props that are drawn once more for the order of equal depths must be drawn under the same
// pass as the first time, with its keys and its shader code.
TEST(CullerPassesOnce, TiesUnderPasses)
{
  const std::function<void(Stage&)> ways[] = { [](Stage& s) { s.GetRenderer()->SetUseSSAO(true); },
    [](Stage& s) { s.GetRenderer()->SetUseFXAA(true); },
    [](Stage& s)
    {
      s.GetRenderer()->SetUseDepthPeeling(true);
      Scenes::AddTranslucentBoxes(s);
    },
    Scenes::AddTranslucentBoxes,
    [](Stage& s) { s.GetRenderer()->SetPass(TestScene::MakePass(TestScene::PassKind::SSAO)); } };
  int redrawn = 0;
  for (unsigned int n = 0; n < 10; ++n)
  {
    redrawn += Scenes::MoveTheDoorBeforeTies(n, 8, ways[n % 5]);
  }
  EXPECT_GT(redrawn, 0);
}

// Hazard: ambient occlusion in a part of the window draws into a framebuffer of the part's size.
// Older VTK draws to the part's place in the window even there, in part or wholly outside.
TEST(CullerPassesOnce, SSAOInPartsOfTheWindow)
{
  using Part = std::array<double, 4>;
  for (const Part& part : { Part{ 0.0, 0.6, 1.0, 1.0 }, Part{ 0.3, 0.0, 0.9, 0.7 },
         Part{ 0.0, 0.0, 0.5, 0.5 }, Part{ 0.55, 0.45, 1.0, 1.0 } })
  {
    SCOPED_TRACE(testing::PrintToString(part));
    const bool isShifted = part[0] + part[1] > 0.0 && !VTKNBUFFER_HAS_SSAO_IN_PARTS;
    ComparisonOptions options;
    options.MayBeOfOneColor = isShifted;
    Comparison comparison(
      [&part](Stage& stage)
      {
        Scenes::BuildWall(stage);
        stage.GetRenderer()->SetViewport(part.data());
        stage.GetRenderer()->SetUseSSAO(true);
        stage.GetRenderer()->SetSSAOKernelSize(16);
      },
      options);
    comparison.Frame();
    comparison.Frame();
    if (isShifted)
    {
      EXPECT_EQ(comparison.GetStatistics().Decision, Decision::OtherView);
    }
    else
    {
      EXPECT_GT(comparison.GetHidden(), 0);
    }
    EXPECT_EQ(comparison.GetStatistics().FailedFrames, 0);
  }
}

// Hazard: a walk through a city, so that rounds are drawn, under the passes that change the shaders
// most.
TEST(CullerPassesOnce, CityWithSSAOAndTranslucentPropsAndFXAA)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildCity(stage, 10);
      for (int i = 5; i < 100; i += 9)
      {
        stage.GetActor(i)->GetProperty()->SetOpacity(0.5);
      }
      stage.GetRenderer()->SetUseSSAO(true);
      stage.GetRenderer()->SetSSAORadius(2.0);
      stage.GetRenderer()->SetSSAOKernelSize(16);
      stage.GetRenderer()->SetUseFXAA(true);
    });
  for (int i = 0; i < 6; ++i)
  {
    Scenes::FrameOfCity(comparison, 0.05 * i);
    EXPECT_GT(comparison.GetHidden(), 10);
  }
}

// Hazard: one sample of a pixel sees past the silhouette that covers the others. The depth that is
// read back must be the farthest one of all samples, whatever their number is.
TEST(CullerPassesOnce, EveryNumberOfSamples)
{
  GLint maximum = 0;
  {
    Comparison probe(Scenes::BuildWall);
    probe.Frame();
    probe.Culled.Window->MakeCurrent();
    glGetIntegerv(GL_MAX_SAMPLES, &maximum);
  }
  if (maximum < 2)
  {
    GTEST_SKIP() << "the driver offers no multisampling";
  }
  for (int samples = 2; samples <= maximum; ++samples)
  {
    SCOPED_TRACE(samples);
    ComparisonOptions options;
    options.MultiSamples = samples;
    options.CompareDepth = false;
    Comparison comparison(Scenes::BuildWall, options);
    for (int i = 0; i < 4; ++i)
    {
      Scenes::FrameOfWall(comparison, i < 3 ? 0.2 * i : 12.0, "moved");
      EXPECT_EQ(comparison.Culled.Window->GetMultiSamples(), samples);
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
    }
  }
}

namespace
{
/// Draws the opaque props that have a key.
class KeyedPass
  : public vtkOpaquePass
  , public vtkNBufferRenderPassTraits
{
public:
  static KeyedPass* New();
  vtkTypeMacro(KeyedPass, vtkOpaquePass);

  static vtkInformation* GetKeys()
  {
    static vtkInformationIntegerKey* key = vtkInformationIntegerKey::MakeKey("Keyed", "KeyedPass");
    static vtkNew<vtkInformation> keys;
    keys->Set(key, 1);
    return keys;
  }

  std::vector<vtkRenderPass*> GetDelegatePasses() override { return {}; }

  void Render(const vtkRenderState* s) override
  {
    vtkRenderState filtered(s->GetRenderer());
    filtered.SetFrameBuffer(s->GetFrameBuffer());
    filtered.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
    filtered.SetRequiredKeys(GetKeys());
    this->Superclass::Render(&filtered);
  }
};
vtkStandardNewMacro(KeyedPass);
}

// Hazard: only the pass changes; the new one draws with more samples, and sees what is between the
// middles of pixels.
TEST(CullerPassesOnce, StillCameraUnderAnotherPass)
{
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (int i = 0; i < 60; ++i)
      {
        Scenes::AddBox(stage, -5.0 + 0.171 * i, -2.0 + 0.067 * i, 5.0, 0.02, 0.02, 0.02);
      }
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Frame("plain");
  }
  EXPECT_EQ(comparison.GetDecision(), Decision::Still);
  EXPECT_GT(comparison.GetHidden(), Wall::Hidden);
  comparison.Both([](Stage& stage)
    { stage.GetRenderer()->SetPass(TestScene::MakePass(TestScene::PassKind::SSAA)); });
  comparison.Frame("finer");
  EXPECT_EQ(comparison.GetDecision(), Decision::OtherView);
}

// Hazard: a pass draws only some of the props, and the culler draws others once more under this
// pass, for the order of equal depths.
TEST(CullerPassesOnce, PropsWithoutTheKeysOfAPassStayOut)
{
  ComparisonOptions options;
  options.CompareDraws = false;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      for (std::size_t i = 1; i < stage.Props.size(); i += 2)
      {
        stage.Props[i]->SetPropertyKeys(KeyedPass::GetKeys());
      }
      // It is no candidate, and so it is in the list and may have the depth of any other prop.
      const int box = Scenes::AddBox(stage, 0.0, 0.0, 4.0, 3.0, 3.0, 1.0);
      stage.GetActor(box)->GetProperty()->SetRepresentationToWireframe();
      vtkNew<vtkRenderPassCollection> passes;
      passes->AddItem(vtkNew<vtkLightsPass>());
      passes->AddItem(vtkNew<KeyedPass>());
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(passes);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(sequence);
      stage.GetRenderer()->SetPass(camera);
    },
    options);
  Scenes::ExpectStepsAside(comparison, { 0.0, 0.2, 0.4, 0.6 }, Decision::OtherView);
}

namespace
{
/// VTK reads this variable, when it draws, to decide whether to peel layer by layer.
class LegacyDepthPeeling
{
public:
  LegacyDepthPeeling() { vtksys::SystemTools::PutEnv("VTK_USE_LEGACY_DEPTH_PEELING=1"); }
  ~LegacyDepthPeeling() { vtksys::SystemTools::UnPutEnv("VTK_USE_LEGACY_DEPTH_PEELING"); }
};
}

// Hazard: where dual peeling is not supported, the renderer's own peeling is the single one.
TEST(CullerPassesOnce, SingleDepthPeelingOfTheRenderer)
{
  const LegacyDepthPeeling legacy;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::BuildWall(stage);
      Scenes::AddTranslucentBoxes(stage);
      Scenes::SetWallCamera(stage.GetRenderer());
      stage.GetRenderer()->SetUseDepthPeeling(true);
      stage.GetRenderer()->SetMaximumNumberOfPeels(6);
      stage.GetRenderer()->SetOcclusionRatio(0.0);
    });
  Scenes::ExpectFramesOfWall(comparison, { 0.0, 0.2, 0.4, 12.0 }, Wall::Behind / 3 + 1);
}

// Hazard: MSAA in a city: single samples of distant props at the silhouettes of near ones.
TEST(CullerPassesOnce, CityWithMultiSamples)
{
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    ComparisonOptions options;
    options.MultiSamples = 4;
    options.CompareDepth = false;
    options.Backend = backend;
    Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage, 10); }, options);
    for (int i = 0; i < 6; ++i)
    {
      Scenes::FrameOfCity(comparison, 0.05 * i);
      EXPECT_GT(comparison.GetHidden(), 10);
    }
  }
}

// Hazard: a setting that changes between two frames replaces the framebuffer whose depth the culler
// reads.
TEST(CullerPassesOnce, SettingsChangeBetweenFrames)
{
  Comparison comparison(Scenes::BuildWall);
  comparison.Frame("plain");
  comparison.Frame("SSAO on", [](Stage& stage) { stage.GetRenderer()->SetUseSSAO(true); });
  comparison.Frame("SSAO off", [](Stage& stage) { stage.GetRenderer()->SetUseSSAO(false); });
  comparison.Frame("FXAA on", [](Stage& stage) { stage.GetRenderer()->SetUseFXAA(true); });
  comparison.Frame("FXAA off", [](Stage& stage) { stage.GetRenderer()->SetUseFXAA(false); });
  comparison.Frame("MSAA on", [](Stage& stage) { stage.Window->SetMultiSamples(4); });
  comparison.Frame("MSAA off", [](Stage& stage) { stage.Window->SetMultiSamples(0); });
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Frame("shadows on",
    [](Stage& stage)
    {
      Scenes::SetSpotLight(stage);
      stage.GetRenderer()->SetUseShadows(true);
    });
  EXPECT_EQ(comparison.GetDecision(), Decision::Shadows);
  comparison.Frame("shadows off",
    [](Stage& stage)
    {
      stage.GetRenderer()->SetUseShadows(false);
      // VTK renews its light uniforms only after the camera has changed.
      Scenes::SetWallCamera(stage.GetRenderer(), 0.1);
    });
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}

// Hazard: ambient occlusion draws opaque props without multisampling. Translucent props between the
// middles of pixels are drawn afterwards with the samples of the window.
TEST(CullerPassesOnce, TranslucentPropsBetweenMiddlesAfterAmbientOcclusion)
{
  ComparisonOptions options = Scenes::MakeExactOptions(160, 120, 4);
  options.MultiSamples = 4;
  options.Backend = vtkNBufferCuller::CPU;
  options.CompareDepth = false;
  Comparison comparison(
    [](Stage& stage)
    {
      Scenes::SetPixelCamera(stage.GetRenderer(), 160, 120);
      stage.GetRenderer()->SetUseSSAO(true);
      SetUseOIT(stage.GetRenderer(), false); // That has no samples either.
      // The middle of pixel 80 is beside the wall and beside the translucent prop behind it.
      Scenes::AddBox(stage, 40.2, 60.0, 0.0, 80.4, 120.0, 1.0);
      const int behind = Scenes::AddBox(stage, 60.24, 60.0, -5.0, 40.48, 80.0, 1.0);
      stage.GetActor(behind)->GetProperty()->SetOpacity(0.5);
      Scenes::AddBox(stage, 120.0, 60.0, -50.0, 40.0, 80.0, 1.0);
    },
    options);
  for (int i = 0; i < 3; ++i)
  {
    comparison.Frame();
  }
}
