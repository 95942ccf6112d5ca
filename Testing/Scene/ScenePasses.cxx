// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePasses.h"

#include "ReversedDepth.h"

#include "vtkShadowVolumeClampPass.h"

#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkFramebufferPass.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkSobelGradientMagnitudePass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

namespace TestScene
{
namespace
{
constexpr int Peels = 4;

vtkSmartPointer<vtkRenderPass> WithCamera(vtkRenderPass* inner)
{
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(inner);
  return camera;
}
}

vtkSmartPointer<vtkRenderPass> InSequence(std::initializer_list<vtkRenderPass*> passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* pass : passes)
  {
    collection->AddItem(pass);
  }
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(collection);
  return sequence;
}

vtkSmartPointer<vtkRenderPass> MakeSequence(std::initializer_list<vtkRenderPass*> passes)
{
  return WithCamera(InSequence(passes));
}

namespace
{
template <typename PassType>
vtkSmartPointer<vtkRenderPass> AroundSteps()
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<PassType> pass;
  pass->SetDelegatePass(steps);
  return pass;
}

template <typename PassType>
vtkSmartPointer<vtkRenderPass> WithPeeling()
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<PassType> peeling;
  peeling->SetTranslucentPass(translucent);
  peeling->SetMaximumNumberOfPeels(Peels);
  peeling->SetOcclusionRatio(0.0);
  return MakeSequence({ lights, opaque, peeling });
}
}

vtkSmartPointer<vtkRenderPass> MakePass(PassKind kind, vtkRenderPass* shadows)
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  switch (kind)
  {
    case PassKind::None:
      return nullptr;
    case PassKind::ShadowVolumes:
    {
      if (shadows)
      {
        return shadows;
      }
      vtkNew<vtkShadowVolumeClampPass> other;
      vtkNew<vtkRenderStepsPass> steps;
      steps->SetTranslucentPass(other->GetSteps()->GetTranslucentPass());
      steps->SetVolumetricPass(other->GetSteps()->GetVolumetricPass());
      return steps;
    }
    case PassKind::RenderSteps:
      return vtkSmartPointer<vtkRenderStepsPass>::New();
    case PassKind::ShadowVolumesInSequence:
    case PassKind::OpaqueTranslucent:
    {
      vtkNew<vtkVolumetricPass> volumetric;
      vtkNew<vtkOverlayPass> overlay;
      const bool cast = shadows && kind == PassKind::ShadowVolumesInSequence;
      return MakeSequence(
        { lights, cast ? shadows : opaque.Get(), translucent, volumetric, overlay });
    }
    case PassKind::OpaqueTwice:
    {
      vtkNew<vtkOpaquePass> again;
      return MakeSequence({ lights, opaque, again });
    }
    case PassKind::TranslucentFirst:
      return MakeSequence({ lights, translucent, opaque });
    case PassKind::Default:
    {
      vtkNew<vtkDefaultPass> steps;
      return MakeSequence({ lights, steps });
    }
    case PassKind::DepthPeeling:
      return WithPeeling<vtkDepthPeelingPass>();
    case PassKind::DualDepthPeeling:
      return WithPeeling<vtkDualDepthPeelingPass>();
    case PassKind::SSAO:
      return AroundSteps<vtkSSAOPass>();
    case PassKind::FXAA:
      return AroundSteps<vtkOpenGLFXAAPass>();
    case PassKind::Framebuffer:
      // The camera pass, which clears, has to be inside.
      return AroundSteps<vtkFramebufferPass>();
    case PassKind::Sobel:
      return AroundSteps<vtkSobelGradientMagnitudePass>();
    case PassKind::SSAA:
      return AroundSteps<vtkSSAAPass>();
    case PassKind::Reversed:
    {
      vtkNew<ReversedDepthPass> reversed;
      reversed->Delegate = InSequence({ lights, shadows ? shadows : opaque.Get(), translucent });
      return WithCamera(reversed);
    }
  }
  return nullptr;
}

void RenewPasses(vtkRenderer* renderer)
{
  if (auto* old = vtkOpenGLFXAAPass::SafeDownCast(renderer->GetPass()))
  {
    vtkNew<vtkOpenGLFXAAPass> pass;
    pass->SetDelegatePass(old->GetDelegatePass());
    renderer->SetPass(pass);
  }
  renderer->GetLights()->Modified();
}
}
