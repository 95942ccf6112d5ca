// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDeferredProxy.h"

#include "vtkNBufferForwardedKeys.h"
#include "vtkNBufferView.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferDeferredProxy);

int vtkNBufferDeferredProxy::Draw(vtkProp* prop, vtkRenderer* renderer, double time)
{
  const vtkNBufferForwardedKeys keys(this->GetPropertyKeys(), prop);
  prop->SetAllocatedRenderTime(time, renderer);
  return prop->RenderOpaqueGeometry(renderer);
}

bool vtkNBufferDeferredProxy::HasKeys(vtkInformation* requiredKeys)
{
  return !requiredKeys || (this->View && this->View->HasHeldPropWithKeys(requiredKeys));
}

int vtkNBufferDeferredProxy::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->View && renderer ? this->View->DrawHeldProps(renderer, nullptr) : 0;
}

bool vtkNBufferDeferredProxy::RenderFilteredOpaqueGeometry(
  vtkViewport* viewport, vtkInformation* requiredKeys)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->View && renderer && this->View->DrawHeldProps(renderer, requiredKeys) > 0;
}

void vtkNBufferDeferredProxy::RestoreEstimatedRenderTime()
{
  if (this->View)
  {
    this->View->ForEachDrawnHeldProp([](vtkProp* prop) { prop->RestoreEstimatedRenderTime(); });
  }
}

double vtkNBufferDeferredProxy::GetEstimatedRenderTime()
{
  double time = 0.0;
  if (this->View)
  {
    this->View->ForEachDrawnHeldProp(
      [&time](vtkProp* prop) { time += prop->GetEstimatedRenderTime(); });
  }
  return time;
}

double vtkNBufferDeferredProxy::GetEstimatedRenderTime(vtkViewport*)
{
  return this->GetEstimatedRenderTime();
}

void vtkNBufferDeferredProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View << "\n";
}
VTK_ABI_NAMESPACE_END
