// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's ways of drawing a frame: with each the image of the wall is the same, and the culler culls
// or says why it does not.
#include "CullerTest.h"
#include "Scenes.h"

#include "vtkNBufferRenderPassTraits.h"

#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
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
        Scenes::AddTranslucentBoxes(stage);
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
      Scenes::SetSpotLight(s);
      s.GetRenderer()->SetUseShadows(true);
    },
    Outcome::Aside, Decision::Shadows },
  { "ShadowPasses",
    [](Stage& s)
    {
      Scenes::SetSpotLight(s);
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
  // Hazard: a pass of the application may draw anything. The culler culls with it only if the pass
  // says what it does, and only if all the passes that it calls are known, too.
  { "UsersPass",
    [](Stage& s)
    {
      vtkNew<UsersPass> pass;
      SetPass(s, pass);
    },
    Outcome::Aside, Decision::RenderPass, true },
  { "UsersPassWithTraits",
    [](Stage& s)
    {
      vtkNew<UsersPassWithTraits> pass;
      SetPass(s, pass);
    },
    Outcome::Culls, Decision::None, true },
  { "UsersPassWithTraitsInASequence",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<UsersPassWithTraits> pass;
      pass->Delegate = vtkSmartPointer<vtkDefaultPass>::New();
      SetPass(s, MakeSequence({ lights, pass }));
    },
    Outcome::Culls, Decision::None, true },
  { "UsersPassWithTraitsAroundAnUnknownOne",
    [](Stage& s)
    {
      vtkNew<UsersPassWithTraits> pass;
      pass->Delegate = vtkSmartPointer<UsersPass>::New();
      SetPass(s, pass);
    },
    Outcome::Aside, Decision::RenderPass, true },
  { "UsersPassWithTraitsThatDrawsTwice",
    [](Stage& s)
    {
      vtkNew<vtkLightsPass> lights;
      vtkNew<vtkOpaquePass> opaque;
      vtkNew<vtkOpaquePass> again;
      vtkNew<UsersPassWithTraits> pass;
      pass->Delegate = MakeSequence({ lights, opaque, again });
      pass->DrawsTwice = true;
      SetPass(s, pass);
    },
    Outcome::Culls },
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
