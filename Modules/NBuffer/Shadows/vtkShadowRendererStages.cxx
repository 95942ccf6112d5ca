// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRendererStages.h"

#include "vtkNBufferDepthSource.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
bool HasTranslucentProps(const vtkRenderState* s)
{
  vtkProp** props = s->GetPropArray();
  return std::any_of(props, props + s->GetPropArrayCount(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
}

bool IsOrdinaryDepth()
{
  return vtkNBufferDepthSource::GetStoredDepth() == vtkNBufferStoredDepth::Ordinary;
}
}

vtkStandardNewMacro(vtkShadowTranslucentStage);
vtkStandardNewMacro(vtkShadowVolumetricStage);

void vtkShadowTranslucentStage::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->NumberOfRenderedProps = 0;
  if (HasTranslucentProps(s))
  {
    if (IsOrdinaryDepth())
    {
      renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer());
    }
    else
    {
      this->Superclass::Render(s);
    }
  }
  if (renderer->GetUseFXAA() && s->GetPropArrayCount() > 0)
  {
    // The filter does not notice that the window has another context, or is another one.
    this->ResourceCallback->RegisterGraphicsResources(
      static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
    if (vtkFXAAOptions* options = renderer->GetFXAAOptions())
    {
      this->Smoothing->UpdateConfiguration(options);
    }
    this->Smoothing->Execute(static_cast<vtkOpenGLRenderer*>(renderer));
  }
}

vtkShadowTranslucentStage::vtkShadowTranslucentStage()
  : ResourceCallback(new Callback(this, &vtkShadowTranslucentStage::ReleaseObjects))
{
}

vtkShadowTranslucentStage::~vtkShadowTranslucentStage()
{
  this->ResourceCallback->Release();
}

void vtkShadowTranslucentStage::ReleaseObjects(vtkWindow*)
{
  this->Smoothing->ReleaseGraphicsResources();
}

void vtkShadowTranslucentStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ResourceCallback->Release();
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkShadowVolumetricStage::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->NumberOfRenderedProps = 0;
  if (!renderer->GetUseDepthPeeling() || !renderer->GetUseDepthPeelingForVolumes() ||
    !IsOrdinaryDepth() || !HasTranslucentProps(s))
  {
    this->Superclass::Render(s);
  }
}
VTK_ABI_NAMESPACE_END
