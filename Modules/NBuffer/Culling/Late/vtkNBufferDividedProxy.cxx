// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDividedProxy.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferDividedProxy);

int vtkNBufferDividedProxy::RenderOpaqueGeometry(vtkViewport* viewport)
{
  const ForwardedKeys keys(this, this->Prop);
  return this->DrawProp([this, viewport]() { return this->Prop->RenderOpaqueGeometry(viewport); });
}

void vtkNBufferDividedProxy::SetAllocatedRenderTime(double time, vtkViewport* viewport)
{
  this->Prop->SetAllocatedRenderTime(time, viewport);
}

void vtkNBufferDividedProxy::AddEstimatedRenderTime(double time, vtkViewport* viewport)
{
  this->Prop->AddEstimatedRenderTime(time, viewport);
}
VTK_ABI_NAMESPACE_END
