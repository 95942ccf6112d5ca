// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's ways of drawing a frame: with each the image is the same, and the culler culls or says
// why it does not.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkNBufferGL.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkFXAAOptions.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOverlayPass.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSobelGradientMagnitudePass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <vtksys/SystemTools.hxx>

using Verdict = vtkNBufferVerdict;
using Decision = vtkNBufferDecision;
using Scenes::Wall;

namespace
{
enum class Outcome
{
  Culls, ///< What is behind the wall is hidden.
  Aside  ///< Everything is drawn, for `Reason`.
};

struct Way
{
  const char* Name;
  std::function<void(Stage&)> Set;
  Outcome Expected = Outcome::Culls;
  Decision Reason = Decision::None;
  bool Translucent = false;
  int MultiSamples = 0;
  /// The pass draws more than the camera's frustum, where stock VTK culls as well.
  bool StockReference = false;
};

void PrintTo(const Way& way, std::ostream* os)
{
  *os << way.Name;
}

/// Translucent boxes on both sides of the wall.
void AddTranslucent(Stage& stage)
{
  for (int i = 0; i < 8; ++i)
  {
    const int index =
      Scenes::AddBox(stage, -5.0 + 1.4 * i, 0.3 * i - 1.0, i % 2 ? 3.0 : -4.0, 1.8, 1.6, 0.7);
    stage.GetActor(index)->GetProperty()->SetOpacity(0.4);
  }
}

void SetPass(Stage& stage, vtkRenderPass* pass)
{
  stage.GetRenderer()->SetPass(pass);
}

/// A camera pass around a sequence, as applications build their own pipelines.
vtkSmartPointer<vtkRenderPass> MakeSequence(const std::vector<vtkRenderPass*>& passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* pass : passes)
  {
    collection->AddItem(pass);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(collection);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

void AddSpotLight(Stage& stage)
{
  stage.GetRenderer()->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(60.0);
  light->SetPosition(8.0, 9.0, 14.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  stage.GetRenderer()->AddLight(light);
}

class CullerPasses : public testing::TestWithParam<Way>
{
};
}

// Hazard: passes set keys on props, inject shader code, ask props for what they hold, and draw
// into framebuffers of their own; a prop held back behind a proxy must not miss any of it.
TEST_P(CullerPasses, Wall)
{
  const Way& way = this->GetParam();
  ComparisonOptions options;
  options.MultiSamples = way.MultiSamples;
  options.StockReference = way.StockReference;
  options.CompareDepth = way.MultiSamples == 0;
  Comparison comparison(
    [&way](Stage& stage)
    {
      Scenes::BuildWall(stage);
      if (way.Translucent)
      {
        AddTranslucent(stage);
        Scenes::SetWallCamera(stage.GetRenderer());
      }
      way.Set(stage);
    },
    options);
  for (int i = 0; i < 5; ++i)
  {
    // Big steps: boxes come out from behind the wall, others go behind it.
    comparison.Both(
      [i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), i < 3 ? 0.2 * i : 4.0 * i); });
    comparison.Frame("moved");
    switch (way.Expected)
    {
      case Outcome::Culls:
        EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
        EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
        break;
      case Outcome::Aside:
        EXPECT_EQ(comparison.GetDecision(), way.Reason);
        EXPECT_EQ(comparison.GetHidden(), 0);
        // That the proxy is drawn for the second time is only found out after a test.
        EXPECT_TRUE(DidNoWork(comparison.GetStatistics()) || way.Reason == Decision::OtherView);
        break;
    }
  }
  comparison.Frame("still");
  comparison.Frame("still");
}

namespace
{
const Way Ways[] = {
  { "Plain", [](Stage&) {} },
  // Hazard: order-independent transparency tests against the depth of the opaque props.
  { "TranslucentOIT", [](Stage& s) { SetUseOIT(s.GetRenderer(), true); }, Outcome::Culls,
    Decision::None, true },
  { "TranslucentWithoutOIT", [](Stage& s) { SetUseOIT(s.GetRenderer(), false); }, Outcome::Culls,
    Decision::None, true },
  // Hazard: dual peeling draws the translucent props again and again, against a copy of the depth.
  { "DualDepthPeeling",
    [](Stage& s)
    {
      s.GetRenderer()->SetUseDepthPeeling(true);
      s.GetRenderer()->SetMaximumNumberOfPeels(6);
      s.GetRenderer()->SetOcclusionRatio(0.0);
    },
    Outcome::Culls, Decision::None, true },
  // Hazard: single peeling draws layer by layer, each against the depth of the one before.
  { "DepthPeelingPass",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkDepthPeelingPass> peeling;
      vtkNew<vtkTranslucentPass> translucent;
      vtkNew<vtkOverlayPass> overlay;
      peeling->SetTranslucentPass(translucent);
      peeling->SetMaximumNumberOfPeels(6);
      peeling->SetOcclusionRatio(0.0);
      SetPass(s, MakeSequence({ lights, opaque, peeling, overlay }));
    },
    Outcome::Culls, Decision::None, true },
  { "DualDepthPeelingPass",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkDualDepthPeelingPass> peeling;
      vtkNew<vtkTranslucentPass> translucent;
      peeling->SetTranslucentPass(translucent);
      SetPass(s, MakeSequence({ lights, opaque, peeling }));
    },
    Outcome::Culls, Decision::None, true },
  // Hazard: ambient occlusion draws positions and normals into a framebuffer of its own.
  { "SSAO",
    [](Stage& s)
    {
      s.GetRenderer()->SetUseSSAO(true);
      s.GetRenderer()->SetSSAORadius(1.0);
      s.GetRenderer()->SetSSAOKernelSize(16);
      s.GetRenderer()->SSAOBlurOn();
    } },
  { "SSAOTranslucent",
    [](Stage& s)
    {
      s.GetRenderer()->SetUseSSAO(true);
      s.GetRenderer()->SetSSAORadius(1.0);
      s.GetRenderer()->SetSSAOKernelSize(16);
    },
    Outcome::Culls, Decision::None, true },
  { "SSAOPass",
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAOPass> ssao;
      ssao->SetRadius(1.0);
      ssao->SetKernelSize(16);
      ssao->SetDelegatePass(steps);
      SetPass(s, ssao);
    },
    Outcome::Culls },
  // Hazard: FXAA blurs edges over their neighbours, those of hidden props if they were drawn.
  { "FXAA", [](Stage& s) { s.GetRenderer()->SetUseFXAA(true); } },
  { "FXAATranslucent", [](Stage& s) { s.GetRenderer()->SetUseFXAA(true); }, Outcome::Culls,
    Decision::None, true },
  { "FXAAPass",
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkOpenGLFXAAPass> fxaa;
      fxaa->SetDelegatePass(steps);
      SetPass(s, fxaa);
    },
    Outcome::Culls },
  // Hazard: hidden-line removal draws the surfaces as depth only and then the lines.
  { "HiddenLineRemoval",
    [](Stage& s)
    {
      s.GetRenderer()->SetUseHiddenLineRemoval(true);
      for (int i = 0; i < Wall::Count; i += 2)
      {
        s.GetActor(i)->GetProperty()->SetRepresentationToWireframe();
      }
    },
    Outcome::Aside, Decision::HiddenLines },
  // Hazard: a prop hidden from the camera throws a shadow that is not.
  { "Shadows",
    [](Stage& s)
    {
      AddSpotLight(s);
      s.GetRenderer()->SetUseShadows(true);
    },
    Outcome::Aside, Decision::Shadows },
  { "ShadowPasses",
    [](Stage& s)
    {
      AddSpotLight(s);
      vtkNew<vtkShadowMapPass> shadows;
      SetPass(s, MakeSequence({ shadows->GetShadowMapBakerPass(), shadows.Get() }));
    },
    Outcome::Aside, Decision::RenderPass },
  { "RenderStepsPass",
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      SetPass(s, steps);
    },
    Outcome::Culls, Decision::None, true },
  { "LightsOpaqueTranslucent",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkTranslucentPass> translucent;
      vtkNew<vtkVolumetricPass> volumetric;
      vtkNew<vtkOverlayPass> overlay;
      SetPass(s, MakeSequence({ lights, opaque, translucent, volumetric, overlay }));
    },
    Outcome::Culls, Decision::None, true },
  { "DefaultPass",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkDefaultPass> steps;
      SetPass(s, MakeSequence({ lights, steps }));
    },
    Outcome::Culls, Decision::None, true },
  { "OpaqueTwice",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkOpaquePass> again;
      SetPass(s, MakeSequence({ lights, opaque, again }));
    },
    Outcome::Aside, Decision::OtherView },
  { "TranslucentBeforeOpaque",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkTranslucentPass> translucent;
      vtkNew<vtkOpaquePass> opaque;
      SetPass(s, MakeSequence({ lights, translucent, opaque }));
    },
    Outcome::Culls, Decision::None, true },
  { "BlurPass",
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkGaussianBlurPass> blur;
      blur->SetDelegatePass(steps);
      SetPass(s, blur);
    },
    Outcome::Aside, Decision::RenderPass, false, 0, true },
  { "SobelPass",
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSobelGradientMagnitudePass> sobel;
      sobel->SetDelegatePass(steps);
      SetPass(s, sobel);
    },
    Outcome::Aside, Decision::RenderPass },
  { "FramebufferPass",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkRenderPassCollection> collection;
      collection->AddItem(lights);
      collection->AddItem(opaque);
      vtkNew<vtkSequencePass> sequence;
      sequence->SetPasses(collection);
      vtkNew<vtkFramebufferPass> framebuffer;
      framebuffer->SetDelegatePass(sequence);
      vtkNew<vtkCameraPass> camera;
      camera->SetDelegatePass(framebuffer);
      SetPass(s, camera);
    },
    Outcome::Aside, Decision::RenderPass },
  // Hazard: multisampled depth under translucent props, and under passes that resolve it.
  { "MultiSamples4TranslucentOIT", [](Stage&) {}, Outcome::Culls, Decision::None, true, 4 },
  { "MultiSamples4SSAO",
    [](Stage& s)
    {
      s.GetRenderer()->SetUseSSAO(true);
      s.GetRenderer()->SetSSAORadius(1.0);
      s.GetRenderer()->SetSSAOKernelSize(16);
    },
    Outcome::Culls, Decision::None, false, 4 },
  { "TwoSidedOff", [](Stage& s) { s.GetRenderer()->SetTwoSidedLighting(false); } },
  { "StencilCapable", [](Stage& s) { s.Window->SetStencilCapable(1); } },
  { "NoAlphaPlanes", [](Stage& s) { s.Window->SetAlphaBitPlanes(0); } },
  { "GradientBackground",
    [](Stage& s)
    {
      s.GetRenderer()->GradientBackgroundOn();
      s.GetRenderer()->SetBackground2(0.9, 0.8, 0.1);
    } },
};
}

INSTANTIATE_TEST_SUITE_P(Each, CullerPasses, testing::ValuesIn(Ways),
  [](const testing::TestParamInfo<Way>& info) { return std::string(info.param.Name); });

// Hazard: what is drawn once more for the order of equal depths is drawn under the same pass, with
// its keys and shader code, as the first time.
TEST(CullerPassesOnce, TiesUnderPasses)
{
  const std::function<void(Stage&)> ways[] = { [](Stage& s) { s.GetRenderer()->SetUseSSAO(true); },
    [](Stage& s) { s.GetRenderer()->SetUseFXAA(true); },
    [](Stage& s)
    {
      s.GetRenderer()->SetUseDepthPeeling(true);
      AddTranslucent(s);
    },
    [](Stage& s) { AddTranslucent(s); },
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkSSAOPass> ssao;
      ssao->SetDelegatePass(steps);
      SetPass(s, ssao);
    } };
  int redrawn = 0;
  for (int n = 0; n < 10; ++n)
  {
    const auto& way = ways[n % 5];
    const auto seed = static_cast<unsigned int>(n);
    SCOPED_TRACE(n);
    ComparisonOptions options;
    options.RoundSize = 5;
    Comparison comparison(
      [&way, seed](Stage& stage)
      {
        Scenes::BuildTies(stage, seed, true);
        way(stage);
      },
      options);
    const int door = Scenes::FindDoor(comparison.Reference);
    for (int i = 0; i < 8; ++i)
    {
      comparison.Both([i, door](Stage& stage)
        { stage.GetActor(door)->SetPosition(2.5 * (i % 4) - 4.0, 0.0, 0.0); });
      comparison.Frame();
      redrawn += comparison.GetStatistics().Redrawn;
    }
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
    Comparison comparison(
      [&part](Stage& stage)
      {
        Scenes::BuildWall(stage);
        stage.GetRenderer()->SetViewport(part.data());
        stage.GetRenderer()->SetUseSSAO(true);
        stage.GetRenderer()->SetSSAOKernelSize(16);
      });
    comparison.Frame();
    comparison.Frame();
    const bool shifted = part[0] + part[1] > 0.0;
    if (shifted && !VTKNBUFFER_HAS_SSAO_IN_PARTS)
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

// Hazard: a city under the passes that inject most, walked through, so that rounds are drawn.
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
    comparison.Both([i](Stage& stage) { Scenes::SetCityCamera(stage.GetRenderer(), 0.05 * i); });
    comparison.Frame();
    EXPECT_GT(comparison.GetHidden(), 10);
  }
}

// Hazard: a sample of a pixel sees past the silhouette that covers the others; what is read back
// must be the farthest of them, whatever their number.
TEST(CullerPassesOnce, EveryNumberOfSamples)
{
  GLint maximum = 0;
  {
    Comparison probe([](Stage& stage) { Scenes::BuildWall(stage); });
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
    Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); }, options);
    for (int i = 0; i < 4; ++i)
    {
      comparison.Both(
        [i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), i < 3 ? 0.2 * i : 12.0); });
      comparison.Frame("moved");
      EXPECT_EQ(comparison.Culled.Window->GetMultiSamples(), samples);
      EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
      EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
    }
  }
}

namespace
{
/// VTK asks this variable, when it draws, whether to peel layer by layer.
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
      AddTranslucent(stage);
      Scenes::SetWallCamera(stage.GetRenderer());
      stage.GetRenderer()->SetUseDepthPeeling(true);
      stage.GetRenderer()->SetMaximumNumberOfPeels(6);
      stage.GetRenderer()->SetOcclusionRatio(0.0);
    });
  for (int i = 0; i < 4; ++i)
  {
    comparison.Both(
      [i](Stage& stage) { Scenes::SetWallCamera(stage.GetRenderer(), i < 3 ? 0.2 * i : 12.0); });
    comparison.Frame("moved");
    EXPECT_EQ(comparison.GetDecision(), Decision::Culled);
    EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3);
  }
}

// Hazard: MSAA in a city: single samples of distant props at the silhouettes of near ones.
TEST(CullerPassesOnce, CityWithMultiSamples)
{
  for (int backend : { vtkNBufferCuller::CPU, vtkNBufferCuller::OpenGL })
  {
    ComparisonOptions options;
    options.MultiSamples = 4;
    options.CompareDepth = false;
    options.Configure = [backend](vtkNBufferCuller* culler) { culler->SetBackend(backend); };
    Comparison comparison([](Stage& stage) { Scenes::BuildCity(stage, 10); }, options);
    for (int i = 0; i < 6; ++i)
    {
      comparison.Both([i](Stage& stage) { Scenes::SetCityCamera(stage.GetRenderer(), 0.05 * i); });
      comparison.Frame();
      EXPECT_GT(comparison.GetHidden(), 10);
    }
  }
}

// Hazard: a setting changed between two frames changes the framebuffer under the culler.
TEST(CullerPassesOnce, SettingsChangeBetweenFrames)
{
  Comparison comparison([](Stage& stage) { Scenes::BuildWall(stage); });
  comparison.Frame("plain");
  comparison.Both([](Stage& stage) { stage.GetRenderer()->SetUseSSAO(true); });
  comparison.Frame("SSAO on");
  comparison.Both([](Stage& stage) { stage.GetRenderer()->SetUseSSAO(false); });
  comparison.Frame("SSAO off");
  comparison.Both([](Stage& stage) { stage.GetRenderer()->SetUseFXAA(true); });
  comparison.Frame("FXAA on");
  comparison.Both([](Stage& stage) { stage.GetRenderer()->SetUseFXAA(false); });
  comparison.Frame("FXAA off");
  comparison.Both([](Stage& stage) { stage.Window->SetMultiSamples(4); });
  comparison.Frame("MSAA on");
  comparison.Both([](Stage& stage) { stage.Window->SetMultiSamples(0); });
  comparison.Frame("MSAA off");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
  comparison.Both(
    [](Stage& stage)
    {
      AddSpotLight(stage);
      stage.GetRenderer()->SetUseShadows(true);
    });
  comparison.Frame("shadows on");
  EXPECT_EQ(comparison.GetDecision(), Decision::Shadows);
  comparison.Both(
    [](Stage& stage)
    {
      stage.GetRenderer()->SetUseShadows(false);
      // VTK renews its light uniforms only after the camera has changed.
      Scenes::SetWallCamera(stage.GetRenderer(), 0.1);
    });
  comparison.Frame("shadows off");
  EXPECT_GE(comparison.GetHidden(), Wall::Hidden);
}
