// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferCompatibility.h"

#include "vtkNBufferCamera.h"
#include "vtkNBufferCandidateList.h"
#include "vtkNBufferDepthSource.h"
#include "vtkNBufferGL.h"
#include "vtkNBufferKnownClasses.h"
#include "vtkNBufferRenderPassTraits.h"
#include "vtkNBufferVTKVersion.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLGL2PSHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkProp.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkRendererDelegate.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
vtkNBufferRenderPassTraits* GetTraits(vtkRenderPass* pass)
{
  return dynamic_cast<vtkNBufferRenderPassTraits*>(pass);
}

/// Get the passes that a pass calls.
std::vector<vtkRenderPass*> GetParts(vtkRenderPass* pass)
{
  std::vector<vtkRenderPass*> parts;
  if (vtkNBufferRenderPassTraits* traits = GetTraits(pass))
  {
    parts = traits->GetDelegatePasses();
  }
  else if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
    {
      parts.push_back(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)));
    }
  }
  else if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    parts = { camera->GetDelegatePass() };
  }
  else if (auto* steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    parts = { steps->GetCameraPass(), steps->GetLightsPass(), steps->GetOpaquePass(),
      steps->GetTranslucentPass(), steps->GetVolumetricPass(), steps->GetOverlayPass(),
      steps->GetPostProcessPass() };
  }
  else if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    parts = { image->GetDelegatePass() };
  }
  else if (auto* samples = vtkSSAAPass::SafeDownCast(pass))
  {
    parts = { samples->GetDelegatePass() };
  }
  else if (auto* both = vtkDualDepthPeelingPass::SafeDownCast(pass))
  {
    parts = { both->GetTranslucentPass(), both->GetVolumetricPass() };
  }
  else if (auto* peeling = vtkDepthPeelingPass::SafeDownCast(pass))
  {
    parts = { peeling->GetTranslucentPass() };
  }
  else if (auto* blending = vtkOrderIndependentTranslucentPass::SafeDownCast(pass))
  {
    parts = { blending->GetTranslucentPass() };
  }
  return parts;
}

template <typename Predicate>
bool AnyPass(vtkRenderPass* pass, Predicate&& predicate)
{
  if (!pass)
  {
    return false;
  }
  const std::vector<vtkRenderPass*> parts = GetParts(pass);
  return predicate(pass) ||
    std::any_of(parts.begin(), parts.end(),
      [&predicate](vtkRenderPass* part) { return AnyPass(part, predicate); });
}

bool IsUnknownPass(vtkRenderPass* pass)
{
  return !GetTraits(pass) && !vtkNBufferKnownClasses::IsKnown(pass);
}

/// Whether a camera pass erases the framebuffer in which the first of the passes that call no other
/// ones draws. A camera pass around another framebuffer does not erase that one.
bool BeginsWithErasing(vtkRenderPass* root)
{
  bool erases = false;
  AnyPass(root,
    [&erases](vtkRenderPass* pass)
    {
      const bool hasFramebuffer = pass->IsA("vtkImageProcessingPass") || pass->IsA("vtkSSAAPass");
      erases = pass->IsA("vtkCameraPass") || (erases && !hasFramebuffer);
      return GetParts(pass).empty();
    });
  return erases;
}

/// Whether VTK draws any of the props in a way that is meant for its own depth alone. An offset
/// that pushes a surface away from the eye pulls it towards the eye in reversed depth. Depth
/// peeling and order-independent transparency compare translucent props with the depth in their
/// shaders.
bool NeedsOrdinaryDepth(vtkRenderer* renderer, const vtkNBufferCandidateList& props)
{
  const auto comparesDepth = [](vtkRenderPass* pass)
  { return pass->IsA("vtkDepthPeelingPass") || pass->IsA("vtkOrderIndependentTranslucentPass"); };
  return props.GetTraits().DepthOffset ||
    (props.GetTraits().Translucent &&
      (!renderer->GetPass() || AnyPass(renderer->GetPass(), comparesDepth)));
}

/// Whether the frustum test of vtkNBufferView does everything that `culler` would do.
bool IsDefaultFrustumCuller(vtkCuller* culler)
{
  if (typeid(*culler) != typeid(vtkFrustumCoverageCuller))
  {
    return false;
  }
  auto* frustum = static_cast<vtkFrustumCoverageCuller*>(culler);
  return frustum->GetMinimumCoverage() == 0.0 && frustum->GetMaximumCoverage() == 1.0 &&
    frustum->GetSortingStyle() == VTK_CULLER_SORT_NONE;
}

/// Whether a culler that may remove props comes after `self`. It would not see the props that are
/// held back.
bool IsOtherBehind(vtkCullerCollection* cullers, vtkCuller* self)
{
  bool behind = false;
  vtkCollectionSimpleIterator cookie;
  cullers->InitTraversal(cookie);
  while (vtkCuller* culler = cullers->GetNextCuller(cookie))
  {
    if (behind && !IsDefaultFrustumCuller(culler))
    {
      return true;
    }
    behind = behind || culler == self;
  }
  return false;
}

/// Whether this may be the ordinary frame that a hardware selector of points draws before it
/// becomes the renderer's selector. In that frame VTK makes the buffers of props that have changed.
/// A prop that is not drawn in it gets buffers of points, which vtkCompositePolyDataMapper draws by
/// from then on. The frame is known by the settings that the selector has changed for the sake of
/// its own frames.
bool PrecedesPointSelection(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const double* background = renderer->GetBackground();
  return !window->GetSwapBuffers() && window->GetMultiSamples() == 0 &&
    !renderer->GetGradientBackground() &&
    std::all_of(background, background + 3, [](double value) { return value == 0.0; });
}
}

namespace vtkNBufferCompatibility
{
void MoveFrustumCullersBehind(vtkCullerCollection* cullers, vtkCuller* self)
{
  std::vector<vtkSmartPointer<vtkCuller>> before;
  vtkCollectionSimpleIterator cookie;
  cullers->InitTraversal(cookie);
  for (vtkCuller* culler = cullers->GetNextCuller(cookie); culler && culler != self;
       culler = cullers->GetNextCuller(cookie))
  {
    if (IsDefaultFrustumCuller(culler))
    {
      before.emplace_back(culler);
    }
  }
  for (const vtkSmartPointer<vtkCuller>& culler : before)
  {
    cullers->RemoveItem(culler);
    cullers->AddItem(culler);
  }
}

bool ErasesDepth(vtkRenderer* renderer)
{
  return renderer->GetErase() && renderer->GetRenderWindow()->GetErase() &&
    !renderer->GetPreserveDepthBuffer() &&
    (!renderer->GetPass() || BeginsWithErasing(renderer->GetPass()));
}

bool KeepsOpaqueDepth(vtkRenderer* renderer)
{
  const auto keepsItForItself = [](vtkRenderPass* pass)
  { return pass->IsA("vtkToneMappingPass") || pass->IsA("vtkFramebufferPass"); };
  bool isAnyDrawn = false;
  return !AnyPass(renderer->GetPass(),
    [&](vtkRenderPass* pass)
    {
      const std::size_t parts = GetParts(pass).size();
      const bool erases = pass->IsA("vtkCameraPass") || pass->IsA("vtkClearZPass");
      const bool isLost = (erases && isAnyDrawn) || (parts > 1 && AnyPass(pass, keepsItForItself));
      isAnyDrawn = isAnyDrawn || (parts == 0 && !erases && !pass->IsA("vtkLightsPass"));
      return isLost;
    });
}

bool ProcessesImage(vtkRenderer* renderer)
{
  return renderer->GetUseFXAA() || renderer->GetUseSSAO();
}

bool CanShareDepth(vtkRenderer* renderer)
{
  return !ProcessesImage(renderer) && !renderer->GetPass();
}

bool DrawsOpaquePropsTwice(vtkRenderer* renderer)
{
  return AnyPass(renderer->GetPass(),
    [](vtkRenderPass* pass)
    {
      vtkNBufferRenderPassTraits* traits = GetTraits(pass);
      return traits && traits->DrawsOpaquePropsTwice();
    });
}

DrawingSettings GetDrawingSettings(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  DrawingSettings settings;
  settings.AmbientOcclusion = renderer->GetUseSSAO();
  settings.SmoothLines =
    window->GetLineSmoothing() || window->GetPointSmoothing() || window->GetPolygonSmoothing();
  AnyPass(renderer->GetPass(),
    [&settings](vtkRenderPass* pass)
    {
      settings.Passes.emplace_back(pass, &typeid(*pass));
      settings.AmbientOcclusion = settings.AmbientOcclusion || pass->IsA("vtkSSAOPass");
      return false;
    });
  return settings;
}

vtkNBufferDecision WhyNot(vtkRenderer* renderer, vtkCuller* self, vtkProp** props, int count)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || window->GetContextCreationTime() == 0)
  {
    return vtkNBufferDecision::NoContext;
  }
#if VTKNBUFFER_HAS_INITIALIZE
  if (!window->GetInitialized())
  {
    return vtkNBufferDecision::NoContext;
  }
#endif
  if (window->IsA("vtkVRRenderWindow"))
  {
    return vtkNBufferDecision::UnsupportedWindow;
  }
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
  if (renderer->GetSelector() || PrecedesPointSelection(renderer))
  {
    return vtkNBufferDecision::Selecting;
  }
  if (renderer->GetUseShadows())
  {
    return vtkNBufferDecision::Shadows;
  }
  if (AnyPass(renderer->GetPass(), IsUnknownPass))
  {
    return vtkNBufferDecision::RenderPass;
  }
  vtkOpenGLGL2PSHelper* gl2ps = vtkOpenGLGL2PSHelper::GetInstance();
  if (gl2ps && gl2ps->GetActiveState() != vtkOpenGLGL2PSHelper::Inactive)
  {
    return vtkNBufferDecision::Exporting;
  }
  if (renderer->GetUseHiddenLineRemoval() &&
    vtkHiddenLineRemovalPass::WireframePropsExist(props, count))
  {
    return vtkNBufferDecision::HiddenLines;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  // With a scissor only a part of the viewport is drawn, and the depth elsewhere is that of another
  // frame. VTK sets a camera's stereo flag only when it renders the camera. Until then the frustum
  // may be that of another eye.
  if (!camera || camera->GetUseScissor() ||
    (camera->GetStereo() != 0) != (window->GetStereoRender() != 0))
  {
    return vtkNBufferDecision::OtherView;
  }
#if !VTKNBUFFER_HAS_SSAO_IN_PARTS
  // In these versions of VTK the image depends on props outside the pass's framebuffer, and even on
  // whether there are any props to draw.
  if (GetDrawingSettings(renderer).AmbientOcclusion && (origin[0] > 0 || origin[1] > 0))
  {
    return vtkNBufferDecision::OtherView;
  }
#endif
  return IsOtherBehind(renderer->GetCullers(), self) ? vtkNBufferDecision::OtherCuller
                                                     : vtkNBufferDecision::None;
}

vtkNBufferDecision WhyNotHere(vtkRenderer* renderer, const vtkNBufferCandidateList& props,
  const vtkNBufferViewKey& key, vtkNBufferBackend::Kind wanted, vtkNBufferDepthSource& source,
  std::string& why)
{
  // Passes with framebuffers of their own draw from a copy of the camera.
  if (!vtkNBufferViewKey::Make(renderer).HasSameView(key))
  {
    return vtkNBufferDecision::OtherView;
  }
  if (!vtkNBufferGL::CheckVersion(why))
  {
    return vtkNBufferDecision::OldContext;
  }
  if (wanted == vtkNBufferBackend::Auto && !vtkNBufferGL::KeepsColorsWhenRead())
  {
    why =
      "This OpenGL renderer (softpipe) rounds colors when the depth is read, which would change "
      "the image where something is blended later. Use llvmpipe (GALLIUM_DRIVER=llvmpipe), or "
      "SetBackend(CPU) if nothing is blended.";
    return vtkNBufferDecision::NoDepth;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!source.Inspect(window, why))
  {
    return vtkNBufferDecision::NoDepth;
  }
  // A pass may draw opaque props into one sample, and the window then translucent ones into more.
  const bool hasOtherSamples = window->GetMultiSamples() > 1 &&
    source.Framebuffer != window->GetRenderFramebuffer()->GetFBOIndex();
  if (hasOtherSamples || vtkNBufferGL::CoversTouchedPixels(window))
  {
    source.Places = vtkNBufferSamples::Anywhere();
  }
  const bool isKnown = source.Viewport[2] == key.Viewport[2] &&
    source.Viewport[3] == key.Viewport[3] && source.HoldsViewport() &&
    vtkNBufferBackend::DrawsKnownDepth(source) &&
    (source.Stored == vtkNBufferStoredDepth::Ordinary || !NeedsOrdinaryDepth(renderer, props));
  return isKnown ? vtkNBufferDecision::None : vtkNBufferDecision::OtherView;
}
}
VTK_ABI_NAMESPACE_END
