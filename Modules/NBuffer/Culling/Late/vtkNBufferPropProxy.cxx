// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferPropProxy.h"

#include "vtkObjectFactory.h"

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferPropProxy);

void vtkNBufferPropProxy::SetProp(int place, vtkProp* prop, bool isTranslucent, Drawer drawer)
{
  this->Place = place;
  this->Prop = prop;
  this->DrawProp = std::move(drawer);
  this->IsTranslucent = isTranslucent;
  this->Open = true;
  this->Drawn = false;
}

int vtkNBufferPropProxy::RenderOpaqueGeometry(vtkViewport* viewport)
{
  const ForwardedKeys keys(this, this->Prop);
  return this->DrawProp([this, viewport]() { return this->Prop->RenderOpaqueGeometry(viewport); });
}

int vtkNBufferPropProxy::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  if (!this->IsTranslucent || !this->Open)
  {
    return 0;
  }
  this->Drawn = true;
  const ForwardedKeys keys(this, this->Prop);
  return this->DrawProp(
    [this, viewport]() { return this->Prop->RenderTranslucentPolygonalGeometry(viewport); });
}

void vtkNBufferPropProxy::SetAllocatedRenderTime(double time, vtkViewport* viewport)
{
  this->Prop->SetAllocatedRenderTime(time, viewport);
}
VTK_ABI_NAMESPACE_END
