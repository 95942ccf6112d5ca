// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's render passes and settings of renderers: with each of them the image of the wall scene is
// the same with the culler, and the culler culls or its decision says why it does not.
#include "CullerTest.h"
#include "ScenePasses.h"
#include "Scenes.h"

#include "vtkNBufferGL.h"
#include "vtkNBufferRenderPassTraits.h"

#include "vtkDefaultPass.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSmartPointer.h"
#include "vtkTranslucentPass.h"

using Scenes::Wall;
using TestScene::InSequence;
using TestScene::MakeSequence;
using TestScene::PassKind;

namespace
{
struct PassWay : NamedCase
{
  std::function<void(Stage&)> Set;
  /// Culled: what is behind the wall is hidden. Any other one: everything is drawn.
  Decision Expected = Decision::Culled;
  bool Translucent = false;
  int MultiSamples = 0;
  /// The pass draws more than the camera's frustum, where stock VTK culls as well.
  bool StockReference = false;
};

void SetPass(Stage& stage, vtkRenderPass* pass)
{
  stage.GetRenderer()->SetPass(pass);
}

std::function<void(Stage&)> Use(PassKind kind)
{
  return [kind](Stage& stage) { SetPass(stage, TestScene::MakePass(kind, nullptr)); };
}

void ClearDepth(const vtkRenderState* s)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
  window->GetState()->vtkglDepthMask(GL_TRUE);
  window->GetState()->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

///@{
/// These do to the depth what VTK's passes of the same names do, which not every package of VTK
/// has. The culler knows passes by their names.
class vtkClearZPass : public vtkRenderPass
{
public:
  static vtkClearZPass* New();
  vtkTypeMacro(vtkClearZPass, vtkRenderPass);
  void Render(const vtkRenderState* s) override { ClearDepth(s); }
};
vtkStandardNewMacro(vtkClearZPass);

class vtkToneMappingPass : public vtkFramebufferPass
{
public:
  static vtkToneMappingPass* New();
  vtkTypeMacro(vtkToneMappingPass, vtkFramebufferPass);
  void Render(const vtkRenderState* s) override
  {
    this->Superclass::Render(s);
    ClearDepth(s);
  }
};
vtkStandardNewMacro(vtkToneMappingPass);
///@}

/// Makes a pass of a pass for the lights, the opaque stage and the translucent one.
using MakeStages = vtkSmartPointer<vtkRenderPass> (*)(
  vtkRenderPass* lights, vtkRenderPass* opaque, vtkRenderPass* translucent);

std::function<void(Stage&)> UseStages(MakeStages make)
{
  return [make](Stage& stage)
  {
    SetPass(
      stage, make(vtkNew<vtkLightsPass>(), vtkNew<vtkOpaquePass>(), vtkNew<vtkTranslucentPass>()));
  };
}

/// Draws the opaque stage alone in a framebuffer of the pass.
template <typename PassType>
vtkSmartPointer<vtkRenderPass> InFramebuffer(
  vtkRenderPass* lights, vtkRenderPass* opaque, vtkRenderPass* translucent)
{
  vtkNew<PassType> pass;
  pass->SetDelegatePass(MakeSequence({ lights, opaque }));
  return MakeSequence({ pass, translucent });
}

void UseSSAO(Stage& stage)
{
  stage.GetRenderer()->SetUseSSAO(true);
  stage.GetRenderer()->SetSSAORadius(1.0);
  stage.GetRenderer()->SetSSAOKernelSize(16);
}

void UseFXAA(Stage& stage)
{
  stage.GetRenderer()->SetUseFXAA(true);
}

/// A pass as an application writes it: it lets another pass draw, and the culler does not know it.
class UsersPass : public vtkRenderPass
{
public:
  static UsersPass* New();
  vtkTypeMacro(UsersPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    this->Delegate->Render(s);
    this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }

  vtkSmartPointer<vtkRenderPass> Delegate = vtkSmartPointer<vtkRenderStepsPass>::New();
};
vtkStandardNewMacro(UsersPass);

/// The same pass, which says what it does.
class UsersPassWithTraits
  : public UsersPass
  , public vtkNBufferRenderPassTraits
{
public:
  static UsersPassWithTraits* New();
  vtkTypeMacro(UsersPassWithTraits, UsersPass);

  std::vector<vtkRenderPass*> GetDelegatePasses() override { return { this->Delegate, nullptr }; }
  bool DrawsOpaquePropsTwice() const override { return this->DrawsTwice; }

  bool DrawsTwice = false;
};
vtkStandardNewMacro(UsersPassWithTraits);

using CullerPasses = testing::TestWithParam<PassWay>;
}

// Hazard: passes set keys on props, insert shader code, read what props contain, and draw into
// their own framebuffers. A prop that is held back must get all of that, too.
TEST_P(CullerPasses, Wall)
{
  const PassWay& way = this->GetParam();
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
        Scenes::AddTranslucentBoxes(stage);
        Scenes::SetWallCamera(stage.GetRenderer());
      }
      way.Set(stage);
    },
    options);
  for (int i = 0; i < 5; ++i)
  {
    // Big steps: boxes come out from behind the wall, others go behind it.
    Scenes::FrameOfWall(comparison, i < 3 ? 0.2 * i : 4.0 * i, "moved");
    EXPECT_EQ(comparison.GetDecision(), way.Expected);
    if (way.Expected == Decision::Culled)
    {
      EXPECT_GT(comparison.GetHidden(), Wall::Behind / 3)
        << comparison.GetCuller()->GetStatisticsAsJSON();
    }
    else
    {
      EXPECT_EQ(comparison.GetHidden(), 0);
      // That the proxy is drawn for the second time is only found out after a test.
      EXPECT_TRUE(DidNoWork(comparison.GetStatistics()) || way.Expected == Decision::OtherView);
    }
  }
  comparison.Frame("still");
  comparison.Frame("still");
}

namespace
{
const PassWay PassWays[] = {
  { "Plain", [](Stage&) {} },
  // Hazard: order-independent transparency tests against the depth of the opaque props.
  { "TranslucentOIT", [](Stage& s) { SetUseOIT(s.GetRenderer(), true); }, Decision::Culled, true },
  { "TranslucentWithoutOIT", [](Stage& s) { SetUseOIT(s.GetRenderer(), false); }, Decision::Culled,
    true },
  // Hazard: dual peeling draws the translucent props again and again, against a copy of the depth.
  { "DualDepthPeeling",
    [](Stage& s)
    {
      s.GetRenderer()->SetUseDepthPeeling(true);
      s.GetRenderer()->SetMaximumNumberOfPeels(6);
      s.GetRenderer()->SetOcclusionRatio(0.0);
    },
    Decision::Culled, true },
  // Hazard: single peeling draws layer by layer, each against the depth of the one before.
  { "DepthPeelingPass", Use(PassKind::DepthPeeling), Decision::Culled, true },
  { "DualDepthPeelingPass", Use(PassKind::DualDepthPeeling), Decision::Culled, true },
  // Hazard: ambient occlusion draws positions and normals into a framebuffer of its own.
  { "SSAO",
    [](Stage& s)
    {
      UseSSAO(s);
      s.GetRenderer()->SSAOBlurOn();
    } },
  { "SSAOTranslucent", UseSSAO, Decision::Culled, true },
  { "SSAOPass", Use(PassKind::SSAO) },
  // Hazard: FXAA blurs edges over their neighbours, those of hidden props if they were drawn.
  { "FXAA", UseFXAA },
  { "FXAATranslucent", UseFXAA, Decision::Culled, true },
  { "FXAAPass", Use(PassKind::FXAA) },
  // Hazard: SSAA draws into a framebuffer of its own, which is four times as wide and high.
  { "SSAAPass", Use(PassKind::SSAA), Decision::OtherView },
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
    Decision::HiddenLines },
  // Hazard: a prop hidden from the camera throws a shadow that is not.
  { "Shadows",
    [](Stage& s)
    {
      Scenes::SetSpotLight(s);
      s.GetRenderer()->SetUseShadows(true);
    },
    Decision::Shadows },
  { "ShadowPasses",
    [](Stage& s)
    {
      Scenes::SetSpotLight(s);
      vtkNew<vtkShadowMapPass> shadows;
      SetPass(s, MakeSequence({ shadows->GetShadowMapBakerPass(), shadows.Get() }));
    },
    Decision::RenderPass },
  { "RenderStepsPass", Use(PassKind::RenderSteps), Decision::Culled, true },
  { "LightsOpaqueTranslucent", Use(PassKind::OpaqueTranslucent), Decision::Culled, true },
  { "DefaultPass", Use(PassKind::Default), Decision::Culled, true },
  { "OpaqueTwice", Use(PassKind::OpaqueTwice), Decision::OtherView },
  { "TranslucentBeforeOpaque", Use(PassKind::TranslucentFirst), Decision::Culled, true },
  // Hazard: the depth by which translucent props were tested is gone when they are drawn.
  { "ClearZBeforeTranslucent",
    UseStages(
      [](vtkRenderPass* lights, vtkRenderPass* opaque, vtkRenderPass* translucent) {
        return MakeSequence({ lights, opaque, vtkNew<vtkClearZPass>(), translucent });
      }),
    Decision::Culled, true },
  { "CameraBeforeTranslucent",
    UseStages(
      [](vtkRenderPass* lights, vtkRenderPass* opaque, vtkRenderPass* translucent) {
        return InSequence({ MakeSequence({ lights, opaque }), MakeSequence({ translucent }) });
      }),
    Decision::Culled, true },
  { "ToneMappingBeforeTranslucent", UseStages(InFramebuffer<vtkToneMappingPass>), Decision::Culled,
    true },
  { "FramebufferBeforeTranslucent", UseStages(InFramebuffer<vtkFramebufferPass>), Decision::Culled,
    true },
  { "BlurPass",
    [](Stage& s)
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkGaussianBlurPass> blur;
      blur->SetDelegatePass(steps);
      SetPass(s, blur);
    },
    Decision::RenderPass, false, 0, true },
  { "SobelPass", Use(PassKind::Sobel), Decision::RenderPass },
  // Hazard: another framebuffer, with depth of another format, of which the colors are copied.
  { "FramebufferPass", Use(PassKind::Framebuffer) },
  { "FramebufferPassTranslucent", Use(PassKind::Framebuffer), Decision::Culled, true },
  // Hazard: a pass of the application may draw anything. The culler culls with it only if the pass
  // says what it does, and only if all the passes that it calls are known, too.
  { "UsersPass", [](Stage& s) { SetPass(s, vtkNew<UsersPass>()); }, Decision::RenderPass, true },
  { "UsersPassWithTraits", [](Stage& s) { SetPass(s, vtkNew<UsersPassWithTraits>()); },
    Decision::Culled, true },
  { "UsersPassWithTraitsInASequence",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<UsersPassWithTraits> pass;
      pass->Delegate = vtkSmartPointer<vtkDefaultPass>::New();
      SetPass(s, MakeSequence({ lights, pass }));
    },
    Decision::Culled, true },
  { "UsersPassWithTraitsAroundAnUnknownOne",
    [](Stage& s)
    {
      vtkNew<UsersPassWithTraits> pass;
      pass->Delegate = vtkSmartPointer<UsersPass>::New();
      SetPass(s, pass);
    },
    Decision::RenderPass, true },
  { "SSAAPassAroundAnUnknownOne",
    [](Stage& s)
    {
      vtkNew<vtkSSAAPass> samples;
      samples->SetDelegatePass(vtkNew<UsersPass>());
      SetPass(s, samples);
    },
    Decision::RenderPass, true },
  { "UsersPassWithTraitsThatDrawsTwice",
    [](Stage& s)
    {
      vtkNew<UsersPassWithTraits> pass;
      pass->Delegate = TestScene::MakePass(PassKind::OpaqueTwice, nullptr);
      pass->DrawsTwice = true;
      SetPass(s, pass);
    } },
  // Hazard: multisampled depth under translucent props, and under passes that resolve it.
  { "MultiSamples4TranslucentOIT", [](Stage&) {}, Decision::Culled, true, 4 },
  { "MultiSamples4SSAO", UseSSAO, Decision::Culled, false, 4 },
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

INSTANTIATE_TEST_SUITE_P(Each, CullerPasses, testing::ValuesIn(PassWays), GetCaseName);
