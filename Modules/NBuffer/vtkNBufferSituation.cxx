// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferSituation.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkOpenGLGL2PSHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkRendererDelegate.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Passes that draw the renderer's own props from its own camera. A pass that draws into another
/// size or with another camera is caught later, when the proxy is drawn.
bool IsKnownPass(vtkRenderPass* pass)
{
  if (!pass)
  {
    return true;
  }
  const std::string name = pass->GetClassName();
  if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    vtkCollectionSimpleIterator cookie;
    vtkRenderPass* part = nullptr;
    for (passes ? passes->InitTraversal(cookie) : void();
         passes && (part = passes->GetNextRenderPass(cookie));)
    {
      if (!IsKnownPass(part))
      {
        return false;
      }
    }
    return name == "vtkSequencePass";
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return name == "vtkCameraPass" && IsKnownPass(camera->GetDelegatePass());
  }
  if (auto* steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    return name == "vtkRenderStepsPass" && IsKnownPass(steps->GetCameraPass()) &&
      IsKnownPass(steps->GetLightsPass()) && IsKnownPass(steps->GetOpaquePass()) &&
      IsKnownPass(steps->GetTranslucentPass()) && IsKnownPass(steps->GetVolumetricPass()) &&
      IsKnownPass(steps->GetOverlayPass()) && IsKnownPass(steps->GetPostProcessPass());
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    static const std::array<const char*, 4> images = { "vtkSSAOPass", "vtkSSAAPass",
      "vtkOpenGLFXAAPass", "vtkToneMappingPass" };
    return std::find(images.begin(), images.end(), name) != images.end() &&
      IsKnownPass(image->GetDelegatePass());
  }
  static const std::array<const char*, 11> simple = { "vtkLightsPass", "vtkDefaultPass",
    "vtkOpaquePass", "vtkTranslucentPass", "vtkVolumetricPass", "vtkOverlayPass", "vtkClearZPass",
    "vtkClearRGBPass", "vtkDepthPeelingPass", "vtkDualDepthPeelingPass",
    "vtkOrderIndependentTranslucentPass" };
  return std::find(simple.begin(), simple.end(), name) != simple.end();
}

bool HasWireframes(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor && actor->GetVisibility() &&
      actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME)
    {
      return true;
    }
  }
  return false;
}
}

namespace vtkNBufferSituation
{
vtkNBufferDecision GetObstacle(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || window->IsA("vtkVRRenderWindow"))
  {
    return vtkNBufferDecision::UnsupportedWindow;
  }
#if VTKNBUFFER_HAS_INITIALIZE
  if (!window->GetInitialized())
  {
    return vtkNBufferDecision::UnsupportedWindow;
  }
#endif
  int size[2] = { 0, 0 };
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (size[0] < 1 || size[1] < 1)
  {
    return vtkNBufferDecision::UnsupportedWindow;
  }
  if (renderer->GetDelegate() && renderer->GetDelegate()->GetUsed())
  {
    return vtkNBufferDecision::Delegated;
  }
  if (renderer->GetSelector())
  {
    return vtkNBufferDecision::Selecting;
  }
  if (renderer->GetUseShadows())
  {
    return vtkNBufferDecision::Shadows;
  }
  if (!IsKnownPass(renderer->GetPass()))
  {
    return vtkNBufferDecision::RenderPass;
  }
  vtkOpenGLGL2PSHelper* gl2ps = vtkOpenGLGL2PSHelper::GetInstance();
  if (gl2ps && gl2ps->GetActiveState() != vtkOpenGLGL2PSHelper::Inactive)
  {
    return vtkNBufferDecision::Exporting;
  }
  if (renderer->GetUseHiddenLineRemoval() && HasWireframes(renderer))
  {
    return vtkNBufferDecision::HiddenLines;
  }
  // Only a part of the viewport is drawn; depth elsewhere is of another frame.
  if (!renderer->GetActiveCamera() || renderer->GetActiveCamera()->GetUseScissor())
  {
    return vtkNBufferDecision::OtherView;
  }
  return vtkNBufferDecision::None;
}
}
VTK_ABI_NAMESPACE_END
