// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkShadowRendererStages.h
 * @brief The stages that follow the opaque one, as a renderer without a render pass draws them.
 *
 * VTK's own passes for these stages do not draw what a renderer without a pass does
 * (vtkOpenGLRenderer::UpdateGeometry()), so that an image would change when shadows are switched
 * on:
 *
 *  - the translucent stage is left out if no prop says that it has something translucent (the 3D
 *    text of vtkCubeAxesActor does not, and is not drawn then);
 *  - translucent props are drawn by order-independent transparency (vtkRenderer::UseOIT) or by
 *    depth peeling (vtkRenderer::UseDepthPeeling);
 *  - the image is smoothed after that (vtkRenderer::UseFXAA), unless the list of props is empty;
 *  - volumes are drawn with the translucent props (vtkRenderer::UseDepthPeelingForVolumes).
 */
#ifndef vtkShadowRendererStages_h
#define vtkShadowRendererStages_h

#include "vtkNBufferRenderPassTraits.h"
#include "vtkNBufferResourceCallback.h"

#include "vtkNew.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/// Draws the translucent props, and smooths the image. In reversed depth vtkTranslucentPass draws
/// the props, because the shaders of the other ways take all depth for VTK's own.
class vtkShadowTranslucentStage
  : public vtkTranslucentPass
  , public vtkNBufferRenderPassTraits
{
public:
  static vtkShadowTranslucentStage* New();
  vtkTypeMacro(vtkShadowTranslucentStage, vtkTranslucentPass);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return {}; }

protected:
  vtkShadowTranslucentStage();
  ~vtkShadowTranslucentStage() override;

private:
  using Callback = vtkOpenGLResourceFreeCallback<vtkShadowTranslucentStage>;

  void ReleaseObjects(vtkWindow* window);

  vtkNew<vtkOpenGLFXAAFilter> Smoothing;
  std::unique_ptr<Callback> ResourceCallback;
};

/// Draws the volumes that the stage before has not drawn.
class vtkShadowVolumetricStage
  : public vtkVolumetricPass
  , public vtkNBufferRenderPassTraits
{
public:
  static vtkShadowVolumetricStage* New();
  vtkTypeMacro(vtkShadowVolumetricStage, vtkVolumetricPass);

  void Render(const vtkRenderState* s) override;
  std::vector<vtkRenderPass*> GetDelegatePasses() override { return {}; }
};

VTK_ABI_NAMESPACE_END
#endif
