// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferHeldProps.h"

#include "vtkNBufferForwardedKeys.h"
#include "vtkNBufferView.h"

#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferHeldProps);

int vtkNBufferHeldProps::Draw(vtkProp* prop, vtkRenderer* renderer, double time)
{
  const vtkNBufferForwardedKeys keys(this->GetPropertyKeys(), prop);
  prop->SetAllocatedRenderTime(time, renderer);
  return prop->RenderOpaqueGeometry(renderer);
}

bool vtkNBufferHeldProps::HasKeys(vtkInformation* requiredKeys)
{
  return !requiredKeys || (this->View && this->View->HasHeldPropWithKeys(requiredKeys));
}

int vtkNBufferHeldProps::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->View && renderer ? this->View->DrawHeldProps(renderer, nullptr) : 0;
}

bool vtkNBufferHeldProps::RenderFilteredOpaqueGeometry(
  vtkViewport* viewport, vtkInformation* requiredKeys)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return this->View && renderer && this->View->DrawHeldProps(renderer, requiredKeys) > 0;
}

void vtkNBufferHeldProps::RestoreEstimatedRenderTime()
{
  if (this->View)
  {
    this->View->ForEachDrawnHeldProp([](vtkProp* prop) { prop->RestoreEstimatedRenderTime(); });
  }
}

double vtkNBufferHeldProps::GetEstimatedRenderTime()
{
  double time = 0.0;
  if (this->View)
  {
    this->View->ForEachDrawnHeldProp(
      [&time](vtkProp* prop) { time += prop->GetEstimatedRenderTime(); });
  }
  return time;
}

double vtkNBufferHeldProps::GetEstimatedRenderTime(vtkViewport*)
{
  return this->GetEstimatedRenderTime();
}

void vtkNBufferHeldProps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View << "\n";
}
VTK_ABI_NAMESPACE_END
